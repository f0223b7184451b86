"""Wheels of a recording turn by the distance that their axles go along the heading."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.engines.scene import Body, ContactLog, Rollout, Shape, SimScene, Wheel
from esg.engines.wheels import RUNS_DOWN_S, about_axle, scene_angles, wheel_angles
from esg.units import quat_rotate

GRAVITY = (0.0, 0.0, -9.81)
WHEELS = (Wheel("wheel_left", (0.0, 0.8, -0.4), 0.3), Wheel("wheel_right", (0.0, -0.8, -0.4), 0.5))
CAR = Body(
    "car", False, 1000.0, ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
    (Shape("box", (2.0, 0.9, 0.7)),), (0.0, 0.0, 0.7), wheels=WHEELS,
)  # fmt: skip
TIME = np.arange(0.0, 2.0001, 1 / 240)


def turned(
    position: np.ndarray, yaw: float | np.ndarray = 0.0, roll: float = 0.0, body: Body = CAR
) -> np.ndarray:
    """Angles of the wheels for a path of the centre of mass [m] and a yaw or a roll [rad]."""
    half = 0.5 * np.broadcast_to(yaw, TIME.shape)
    zero = np.zeros_like(half)
    q = np.stack([zero, zero, np.sin(half), np.cos(half)], axis=-1)
    if roll:
        q = np.tile([math.sin(roll / 2), 0.0, 0.0, math.cos(roll / 2)], (len(TIME), 1))
    return wheel_angles(body, TIME, position, q, GRAVITY)


def straight(velocity: tuple[float, float, float]) -> np.ndarray:
    return np.array([0.0, 0.0, 0.7]) + TIME[:, None] * np.array(velocity)


@pytest.mark.parametrize("heading", [0.0, 0.7, -2.5])
@pytest.mark.parametrize("speed", [4.0, -1.5])
def test_angle_is_signed_distance_over_radius(heading: float, speed: float) -> None:
    way = straight((speed * math.cos(heading), speed * math.sin(heading), 0.0))
    assert turned(way, heading)[-1] == pytest.approx([2 * speed / 0.3, 2 * speed / 0.5])


def test_forward_turns_the_rim_backwards_where_it_touches() -> None:
    """No slip: the lowest point of the wheel stands still as the car moves along +X."""
    (q,) = about_axle(np.array([1e-4]))
    lowest = np.array([0.0, 0.0, -0.3])
    slip = quat_rotate(q, lowest) - lowest + np.array([0.3e-4, 0.0, 0.0])
    assert slip == pytest.approx([0.0, 0.0, 0.0], abs=1e-7)


def test_sideways_turns_nothing() -> None:
    assert np.abs(turned(straight((0.0, 3.0, 0.0)))).max() < 1e-9


def test_inner_wheel_of_a_bend_turns_less() -> None:
    """Left bend of 5 m: the axles go circles of 4.2 and 5.8 m."""
    rate = 0.6
    phase = rate * TIME
    way = np.stack([5 * np.sin(phase), 5 - 5 * np.cos(phase), np.full_like(phase, 0.7)], axis=-1)
    left, right = turned(way, phase)[-1] * [0.3, 0.5]
    assert (left, right) == pytest.approx((2 * rate * 4.2, 2 * rate * 5.8), rel=1e-5)


def test_in_the_air_wheels_run_down_from_the_rate_they_had() -> None:
    """Carried for 1 s, then off an edge while the body speeds up: the wheels do not follow it."""
    way = straight((3.0, 0.0, 0.0))
    air = np.maximum(TIME - 1.0, 0.0)
    way[:, 2] -= 0.5 * 9.81 * air**2
    way[:, 0] += 5.0 * air**2
    angles = turned(way)[:, 0]
    at = np.searchsorted(TIME, 1.0)
    ran = 10.0 * RUNS_DOWN_S * (1 - math.exp(-1.0 / RUNS_DOWN_S))
    assert angles[at] == pytest.approx(10.0, rel=0.01)
    assert angles[-1] - angles[at] == pytest.approx(ran, rel=0.02)


def test_lying_on_its_side_turns_nothing() -> None:
    assert np.abs(turned(straight((3.0, 0.0, 0.0)), roll=math.pi / 2)).max() == 0.0


def test_scene_angles_follow_the_order_of_the_bodies() -> None:
    crate = Body("crate", False, 1.0, CAR.inertia, CAR.shapes, (0.0, 5.0, 0.7))
    scene = SimScene("s", (crate, CAR))
    position = np.zeros((1, len(TIME), 2, 3), np.float32)
    position[0, :, 1] = straight((1.0, 0.0, 0.0))
    turns = np.zeros((1, len(TIME), 2, 4), np.float32)
    turns[..., 3] = 1.0
    still = np.zeros_like(position)
    rollout = Rollout(
        "physx", 1 / 240, TIME, position, turns, still, still, ContactLog.empty(), np.array([True])
    )
    angles = scene_angles(scene, rollout)
    assert angles.shape == (len(TIME), 2)
    assert angles[-1] == pytest.approx([2 / 0.3, 2 / 0.5], rel=1e-4)
    assert scene_angles(SimScene("s", (crate,)), rollout).shape == (len(TIME), 0)
