"""Bounces off tops and walls that go on to something else."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.dynamics import build_scene, start_hints
from esg.dynamics.plan.planner import make_plan
from esg.dynamics.story.kinematics import off_a_wall
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene
from esg.graph.models import EsgDocument
from esg.layout import solve
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast
from tests.engines.lab import ball, box


def _launch(doc: EsgDocument) -> tuple[SetVelocity, np.ndarray, np.ndarray, float]:
    """The first launch, where its body and its target are [m], and the body's radius [m]."""
    laid = solve(doc, hints=start_hints(doc))
    scene = build_scene(laid)
    plan = make_plan(laid, scene)
    launch = next(p for p in plan.compile(plan.initial()).primitives if isinstance(p, SetVelocity))
    assert doc.timeline_system is not None
    first = doc.timeline_system.sequence_graph.edges[0]
    body, target = scene.body(first.actor), scene.body(first.target or "")
    return launch, np.array(body.position), np.array(target.position), body.half_extents[2]


def test_what_is_dropped_to_bounce_on_drifts_over_the_edge() -> None:
    """Slowly, from the stated height above the ground, without spin."""
    doc = cast("A ball is dropped from 3 m onto a table, bounces off and lands in a basket.")
    launch, start, _, radius = _launch(doc)
    assert start[2] - radius == pytest.approx(3.0, abs=0.02)
    across = math.hypot(*launch.linear[:2])
    assert 0.1 < across < 1.5
    assert abs(launch.linear[2]) < 0.3
    assert launch.angular == (0.0, 0.0, 0.0)


def test_it_comes_down_in_what_waits_beside_the_top() -> None:
    """The ball enters the basket in every engine: the bounce takes two sevenths of its speed."""
    doc = cast("A ball is dropped from 2 m onto a crate, bounces off and lands in a basket.")
    laid = solve(doc, hints=start_hints(doc))
    scene = build_scene(laid)
    plan = make_plan(laid, scene)
    program = plan.compile(plan.initial())
    region = next(r for r in scene.regions if r.name.startswith("basket"))
    for engine in ("newton", "physx", "rapier"):
        rollout = get_engine(engine).rollout(scene, batch_programs([program], scene.names))
        ball = rollout.position[0, :, scene.index("ball_1")]
        basket = rollout.position[0, 0, scene.index("basket_1")]
        near = np.linalg.norm((ball - basket)[:, :2], axis=1) < max(region.half_extents[:2])
        assert (near & (ball[:, 2] < basket[2] + 2.0 * region.half_extents[2])).any(), engine


def test_what_is_only_dropped_falls_straight_down() -> None:
    """Without a second target nothing drifts."""
    launch, _, _, _ = _launch(cast("A ball is dropped from 2 m onto a crate."))
    assert launch.linear[:2] == pytest.approx((0.0, 0.0))


def test_a_wall_is_met_squarely_at_the_top_of_the_flight() -> None:
    """What falls when it meets the wall is on the ground soon after."""
    doc = cast("A ball is thrown at a wall and bounces off it into a box.")
    launch, start, wall, radius = _launch(doc)
    speed = math.hypot(*launch.linear[:2])
    way = float(np.linalg.norm((wall - start)[:2])) - 0.1 - radius
    assert launch.linear[2] - GRAVITY_MPS2 * way / speed == pytest.approx(0.0, abs=0.4)
    assert launch.linear[2] > 1.0


@pytest.mark.parametrize(
    ("rolling", "friction", "tilt_deg"),
    [
        (True, 0.05, 0.0), (True, 0.5, 0.0), (True, 0.5, 25.0),
        (False, 0.1, 0.0), (False, 0.1, 25.0), (False, 0.5, 25.0),
    ],
)  # fmt: skip
def test_a_ball_goes_on_from_a_wall_as_told(
    rolling: bool, friction: float, tilt_deg: float
) -> None:
    """Away from it and along it, with and without spin, in an engine."""
    speed, restitution, tilt = 4.0, 0.6, math.radians(tilt_deg)
    rolled = ball(
        "ball", 0.1, 1.0, (0.0, 0.0, 0.1 if rolling else 5.0), friction=friction,
        restitution=restitution,
    )  # fmt: skip
    wall = replace(
        box("wall", (0.2, 6.0, 6.0), 1.0, (1.5, 0.0, 6.0)), static=True, friction=friction,
        restitution=restitution, quaternion=(0.0, 0.0, math.sin(tilt / 2), math.cos(tilt / 2)),
    )  # fmt: skip
    # Without gravity in the air; it rolls on ground that has the same friction in every engine.
    scene = SimScene(
        "s", (rolled, wall), gravity=(0.0, 0.0, -GRAVITY_MPS2 if rolling else 0.0),
        ground_friction=1.0, ground_restitution=0.0,
    )  # fmt: skip
    spin = (0.0, speed / 0.1, 0.0) if rolling else (0.0, 0.0, 0.0)
    push = SetVelocity("ball", 0.0, (speed, 0.0, 0.0), spin)
    batch = batch_programs([Program((push,), 2.5)], scene.names)
    v = get_engine("physx").rollout(scene, batch).linear_velocity[0, -1, 0].astype(float)
    away, along = off_a_wall(restitution, friction, tilt, rolling=rolling)
    normal = np.array([-math.cos(tilt), -math.sin(tilt)])
    across = np.array([math.sin(tilt), -math.cos(tilt)])
    assert v[:2] @ normal == pytest.approx(speed * away, abs=0.03 * speed)
    assert abs(v[:2] @ across) == pytest.approx(speed * along, abs=0.03 * speed)
