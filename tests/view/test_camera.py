"""Cameras: framing contains what it must, projection agrees with geometry."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.units import quat_rotate
from esg.view.camera import Camera, box_corners, frame_points


def test_target_is_in_the_middle_and_up_is_up() -> None:
    camera = Camera((3.0, -4.0, 2.0), (0.0, 0.0, 0.5))
    pixels, ahead = camera.project(np.array([[0, 0, 0.5], [0, 0, 1.0]]), 480, 320)
    assert ahead.all()
    np.testing.assert_allclose(pixels[0], (240, 160), atol=1e-6)
    assert pixels[1, 0] == pytest.approx(240)
    assert pixels[1, 1] < 160


def test_points_behind_are_reported() -> None:
    camera = Camera((1.0, 0.0, 1.0), (0.0, 0.0, 1.0))
    _, ahead = camera.project(np.array([[2.0, 0.0, 1.0], [-2.0, 0.0, 1.0]]), 100, 100)
    assert ahead.tolist() == [False, True]


def test_quaternion_turns_camera_axes_into_the_world() -> None:
    camera = Camera((2.0, 1.0, 3.0), (-1.0, 0.5, 0.0))
    for k in range(3):
        np.testing.assert_allclose(
            quat_rotate(camera.quaternion(), np.eye(3)[k]), camera.axes[:, k], atol=1e-12
        )


@pytest.mark.parametrize("azimuth", np.linspace(-3, 3, 7))
@pytest.mark.parametrize("size", [0.05, 1.0, 40.0])
def test_framed_points_are_inside_and_fill_the_picture(azimuth: float, size: float) -> None:
    points = np.random.default_rng(3).uniform(-size, size, (30, 3)) * (4.0, 1.0, 0.3)
    camera = frame_points(points, azimuth, math.radians(24), 1.5)
    pixels, ahead = camera.project(points, 480, 320)
    assert ahead.all()
    assert (pixels >= 0).all()
    assert (pixels <= (480, 320)).all()
    used = np.ptp(pixels, axis=0) / (480, 320)
    assert used.max() > 0.6


def test_box_corners_of_a_turned_box() -> None:
    quarter = (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
    corners = box_corners(
        np.array([1.0, 2.0, 0.5]), np.array(quarter), (2.0, 1.0, 0.5), np.array([0.0, 0.0, -0.5])
    )
    np.testing.assert_allclose(corners.min(axis=0), (0.0, 0.0, 0.0), atol=1e-12)
    np.testing.assert_allclose(corners.max(axis=0), (2.0, 4.0, 1.0), atol=1e-12)
