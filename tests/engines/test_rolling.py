"""Wheels and barrels on their rims roll as they would without facets, and lie on their sides."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Body, Rollout, Shape, SimScene

ON_RIM = (math.sin(math.pi / 4), 0.0, 0.0, math.cos(math.pi / 4))


def roller(radius: float, half: float, mass: float = 10.0) -> Body:
    across = mass * (3.0 * radius**2 + (2.0 * half) ** 2) / 12.0
    moments = (across, 0.5 * mass * radius**2, across)
    inertia = tuple(tuple(m if i == j else 0.0 for j in range(3)) for i, m in enumerate(moments))
    shape = Shape("cylinder", (radius, radius, half), (0.0, 0.0, 0.0), ON_RIM)
    return Body(
        "wheel", False, mass, inertia, (shape,), (0.0, 0.0, radius), friction=0.7,
        restitution=0.4, roll_radius=radius, half_extents=(radius, half, radius),
    )  # fmt: skip


def play(
    body: Body, speed: float, tilting: float = 0.0, duration: float = 2.0, *others: Body
) -> Rollout:
    scene = SimScene("s", (body, *others))
    roll = speed / body.roll_radius
    push = SetVelocity("wheel", 0.0, (speed, 0.0, 0.0), (tilting, roll, 0.0))
    program = Program((push,), duration)
    return get_engine("physx").rollout(scene, batch_programs([program], scene.names))


@pytest.mark.parametrize(
    ("radius", "half", "speed"),
    [(0.31, 0.11, 3.0), (0.31, 0.11, 24.0), (0.29, 0.44, 6.0), (0.033, 0.06, 4.0)],
)
def test_it_keeps_its_speed_and_stays_on_the_ground(
    radius: float, half: float, speed: float
) -> None:
    out = play(roller(radius, half), speed)
    assert out.linear_velocity[0, -1, 0, 0] == pytest.approx(speed, rel=0.01)
    assert out.position[0, -1, 0, 0] == pytest.approx(2.0 * speed, rel=0.01)
    assert np.abs(out.position[0, :, 0, 2] - radius).max() < 2e-3


def test_what_tips_over_lies_on_its_side_on_the_ground() -> None:
    out = play(roller(0.31, 0.11), 0.3, tilting=16.0, duration=6.0)
    assert out.position[0, -1, 0, 2] == pytest.approx(0.11, abs=5e-3)
    assert out.position[0, :, 0, 2].min() > 0.1


def test_its_ends_do_not_reach_further_than_the_cylinder() -> None:
    inertia = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    # Half a radius beside its end: the capsule it rolls on would touch it, the wheel does not.
    beside = Body(
        "block", False, 5.0, inertia, (Shape("box", (0.1, 0.1, 0.2)),), (2.0, 0.31, 0.2)
    )  # fmt: skip
    before = Body(
        "wall", False, 5.0, inertia, (Shape("box", (0.1, 0.3, 0.2)),), (6.0, 0.0, 0.2)
    )  # fmt: skip
    out = play(roller(0.31, 0.11), 4.0, 0.0, 2.0, beside, before)
    assert np.linalg.norm(out.position[0, -1, 1] - [2.0, 0.31, 0.2]) < 2e-3
    assert out.position[0, -1, 2, 0] > 6.1
