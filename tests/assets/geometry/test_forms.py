"""Lofts, tubes and inlays have the volumes that geometry gives them, and are closed."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely.geometry import box
import trimesh

from esg.assets.geometry import forms


def ring(radius: float, z: float, count: int = 96) -> np.ndarray:
    turn = 2 * math.pi * np.arange(count) / count
    return np.c_[radius * np.cos(turn), radius * np.sin(turn), np.full(count, z)]


def test_a_loft_of_two_circles_is_a_frustum() -> None:
    mesh = forms.loft(np.array([ring(3, 0), ring(1, 6)]))
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(math.pi * 6 / 3 * (9 + 3 + 1), rel=2e-3)


def test_a_loft_is_outside_out_whichever_way_it_is_given() -> None:
    for rings in ([ring(2, 0), ring(2, 5)], [ring(2, 5), ring(2, 0)]):
        assert forms.loft(np.array(rings)).volume > 0


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_turned_profiles_are_cylinders_and_rings(axis: str) -> None:
    rod = forms.turned([(2, -1), (2, 3)], (1, 2, 3), 96, axis)
    assert rod.is_watertight and rod.volume == pytest.approx(math.pi * 4 * 4, rel=2e-3)
    tyre = forms.turned([(3, -1), (4, -1), (4, 1), (3, 1), (3, -1)], (0, 0, 0), 96, axis)
    assert tyre.is_watertight and tyre.volume == pytest.approx(math.pi * 7 * 2, rel=2e-3)
    along = "xyz".index(axis)
    assert rod.bounds[:, along] == pytest.approx([(1, 2, 3)[along] - 1, (1, 2, 3)[along] + 3])


def test_a_tube_with_round_ends_is_a_capsule() -> None:
    mesh = forms.tube([(0, 0, 0), (0, 0, 10)], 2.0, 48)
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(math.pi * 4 * 10 + 4 / 3 * math.pi * 8, rel=0.03)


def test_needles_are_closed_prisms_of_their_lengths() -> None:
    ends = [((0, 0, 0), (0, 0, 5)), ((1, 0, 0), (1, 4, 0)), ((0, 2, 1), (3, 2, 5))]
    mesh = forms.needles(ends, 0.1, 6)
    area = 6 * 0.5 * 0.1**2 * math.sin(math.pi / 3)
    assert mesh.is_watertight and mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(area * (5 + 4 + 5))


def test_a_closed_tube_is_a_torus() -> None:
    mesh = forms.tube(ring(5, 0, 64), 1.0, 32, closed=True)
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(2 * math.pi**2 * 5, rel=0.02)


@pytest.mark.parametrize("plan", [2.0, 4.0, 20.0])
def test_cushions_have_their_extents(plan: float) -> None:
    mesh = forms.cushion((6, 4, 2), (1, 2, 3), plan=plan, sections=40)
    assert mesh.is_watertight and mesh.volume > 0
    np.testing.assert_allclose(np.ptp(mesh.bounds, axis=0), [6, 4, 2], rtol=0.02)


def test_inlays_and_carvings_share_a_solid_out() -> None:
    body = trimesh.creation.box((4, 4, 4))
    tools = forms.prism(box(-1, -1, 1, 1), (-3, 3), "xy")
    inside, outside = forms.inlay(body, tools), forms.carved(body, tools)
    assert inside.is_watertight and outside.is_watertight
    assert inside.volume == pytest.approx(16, rel=1e-5)
    assert inside.volume + outside.volume == pytest.approx(64, rel=1e-5)


@pytest.mark.parametrize("plane", ["xy", "xz", "yz"])
def test_prisms_stand_in_their_plane(plane: str) -> None:
    (mesh,) = forms.prism(box(0, 0, 2, 3), (4, 5), plane)
    low, high = {
        "xy": ((0, 0, 4), (2, 3, 5)),
        "xz": ((0, 4, 0), (2, 5, 3)),
        "yz": ((4, 0, 0), (5, 2, 3)),
    }[plane]
    assert mesh.volume == pytest.approx(6)
    np.testing.assert_allclose(mesh.bounds, [low, high])
