"""Wheels and barrels on their rims roll as they would without facets, and lie on their sides."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.engines.physx_engine import rolled_on
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Body, Rollout, Shape, SimScene
from esg.engines.worlds import world_values

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


def on_top(radius: float, half: float, tilt: float, block: Shape) -> tuple[Body, Body, np.ndarray]:
    """A roller on the upper face of a static block tilted about Y [rad], and the way down."""
    turn = (0.0, math.sin(tilt / 2), 0.0, math.cos(tilt / 2))
    up = np.array([math.sin(tilt), 0.0, math.cos(tilt)])
    down = np.array([math.cos(tilt), 0.0, -math.sin(tilt)])
    inertia = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    top = Body("top", True, 50.0, inertia, (block,), (0.0, 0.0, 2.0), turn, friction=0.5)
    at = np.array([0.0, 0.0, 2.0]) + (0.1 + radius) * up - 4.0 * down
    return replace(roller(radius, half, 1.0), position=tuple(at.tolist())), top, down


CORNERS = tuple((x, y, z) for x in (-5.0, 5.0) for y in (-1.0, 1.0) for z in (-0.1, 0.1))
BLOCKS = (Shape("box", (5.0, 1.0, 0.1)), Shape("convex", (5.0, 1.0, 0.1), vertices=CORNERS))


@pytest.mark.parametrize("block", BLOCKS, ids=["box", "convex"])
@pytest.mark.parametrize("tilt_deg", [0.0, 12.0])
@pytest.mark.parametrize(("radius", "half"), [(0.018, 0.23), (0.033, 0.06), (0.3, 0.44)])
def test_it_rolls_on_tables_and_slopes_as_on_the_ground(
    radius: float, half: float, tilt_deg: float, block: Shape
) -> None:
    """The hull alone hopped on a table: a rolling pin lost nine tenths of its speed in 1.5 s."""
    tilt = math.radians(tilt_deg)
    body, top, down = on_top(radius, half, tilt, block)
    scene = SimScene("s", (body, top))
    start = 2.0
    push = SetVelocity("wheel", 0.0, tuple((start * down).tolist()), (0.0, start / radius, 0.0))  # type: ignore[arg-type]
    program = Program((push,), 1.5)
    out = get_engine("physx").rollout(scene, batch_programs([program], scene.names))
    speed = out.linear_velocity[0, :, 0] @ down
    # A solid cylinder that rolls gains two thirds of what slides without friction.
    wanted = start + 2.0 / 3.0 * 9.81 * math.sin(tilt) * out.time
    assert speed[1:] == pytest.approx(wanted[1:], rel=0.02)
    ratio = out.angular_velocity[0, :, 0, 1] * radius / speed
    assert np.abs(ratio[1:] - 1.0).max() < 0.02


def test_it_rolls_on_a_table_that_could_move() -> None:
    """The table stands on the ground as before, and goes on bearing what else comes."""
    body, top, _ = on_top(0.02, 0.1, 0.0, Shape("box", (5.0, 1.0, 0.5)))
    inertia = ((20.0, 0.0, 0.0), (0.0, 400.0, 0.0), (0.0, 0.0, 400.0))
    table = replace(top, static=False, inertia=inertia, position=(0.0, 0.0, 0.5))
    cube = Body("cube", False, 1.0, ((0.01, 0, 0), (0, 0.01, 0), (0, 0, 0.01)),
                (Shape("box", (0.1, 0.1, 0.1)),), (3.0, 0.5, 1.1))  # fmt: skip
    scene = SimScene("s", (replace(body, position=(-4.0, 0.0, 1.02)), table, cube))
    push = SetVelocity("wheel", 0.0, (2.0, 0.0, 0.0), (0.0, 100.0, 0.0))
    program = Program((push,), 1.5)
    out = get_engine("physx").rollout(scene, batch_programs([program], scene.names))
    assert out.linear_velocity[0, -1, 0, 0] == pytest.approx(2.0, rel=0.02)
    assert out.angular_velocity[0, -1, 0, 1] == pytest.approx(100.0, rel=0.02)
    assert out.position[0, -1, 1:, 2] == pytest.approx([0.5, 1.1], abs=2e-3)


def test_what_rolls_off_a_table_falls_and_rolls_on() -> None:
    body, top, down = on_top(0.05, 0.1, 0.0, BLOCKS[0])
    scene = SimScene("s", (replace(body, position=(4.0, 0.0, 2.15)), top))
    push = SetVelocity("wheel", 0.0, tuple((2.0 * down).tolist()), (0.0, 40.0, 0.0))  # type: ignore[arg-type]
    program = Program((push,), 3.0)
    out = get_engine("physx").rollout(scene, batch_programs([program], scene.names))
    assert out.position[0, -1, 0, 0] > 7.0
    assert out.position[0, -1, 0, 2] < 0.3


def test_a_shape_beside_its_start_is_none_that_it_rolls_on() -> None:
    """Only what lies under it bears its tread: a wall would stop the tread's round ends early."""
    body, top, _ = on_top(0.05, 0.1, 0.0, BLOCKS[0])
    wall = replace(
        top, name="wall", shapes=(Shape("box", (0.1, 0.1, 0.3)),), position=(1.0, 0.3, 2.4)
    )
    scene = SimScene("s", (body, top, wall))
    assert rolled_on(scene, world_values(scene, None, 1), 0) == {(1, 0)}
    lifted = scene.with_bodies((replace(body, position=(0.0, 0.0, 2.4)), top, wall))
    assert rolled_on(lifted, world_values(lifted, None, 1), 0) == set()
