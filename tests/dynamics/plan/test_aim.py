"""Where throws are aimed: beside what stands on the target, unless the story speaks of it."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.dynamics import build_scene, start_hints
from esg.dynamics.plan.cast import Cast
from esg.dynamics.plan.planner import Plan, make_plan
from esg.engines.program import batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Body, Shape, SimScene
from esg.layout import solve
from esg.units import quat_multiply, quat_rotate
from tests.dynamics import stories
from tests.dynamics.stage import lay_out

RADIUS_M = 0.04


def crowded(*across: float, height: float = 0.15, turn_deg: float = 0.0) -> tuple[Plan, np.ndarray]:
    """A throw at a table with bottles that far across its middle; the way the throw leads."""
    doc = lay_out(stories.throw_hits_table_at_1s(), 1)
    scene = turned(build_scene(doc), math.radians(turn_deg))
    ball, table = scene.body("b_1"), scene.body("table_1")
    way = np.array(table.position)[:2] - np.array(ball.position)[:2]
    way = way / np.linalg.norm(way)
    top = table.position[2] + table.half_extents[2]
    size = (RADIUS_M, RADIUS_M, height)
    bottles = tuple(
        Body(
            f"bottle_{k}",
            False,
            0.5,
            tuple(tuple(float(v) for v in row) for row in 0.01 * np.eye(3)),
            (Shape("cylinder", size),),
            (*(np.array(table.position)[:2] + at * np.array([-way[1], way[0]])), top + height),
            half_extents=size,
        )
        for k, at in enumerate(across)
    )
    return make_plan(doc, scene.with_bodies((*scene.bodies, *bottles)), seed=0), way


def turned(scene: SimScene, angle: float) -> SimScene:
    """All of a scene turned about the world's vertical axis."""
    q = np.array([0.0, 0.0, math.sin(angle / 2), math.cos(angle / 2)])
    return scene.with_bodies(
        tuple(
            replace(
                b,
                position=tuple(quat_rotate(q, np.array(b.position)).tolist()),
                quaternion=tuple(quat_multiply(q, np.array(b.quaternion)).tolist()),
            )
            for b in scene.bodies
        )
    )


def touched_first(plan: Plan) -> str:
    """What the ball meets first at the choreographed theta."""
    scene = plan.scene
    batch = batch_programs([plan.compile(plan.initial())], scene.names)
    log = get_engine("newton").rollout(scene, batch).contacts
    ball = scene.index("b_1")
    rows = np.flatnonzero(((log.a == ball) | (log.b == ball)) & (log.b >= 0))
    row = rows[np.argmin(log.time[rows])]
    return scene.names[log.a[row] + log.b[row] - ball]


def across(plan: Plan, way: np.ndarray) -> float:
    """How far beside the table's middle the choreographed throw passes [m]."""
    velocity = np.array(plan.compile(plan.initial()).primitives[0].linear)[:2]
    ball, table = (np.array(plan.scene.body(n).position)[:2] for n in ("b_1", "table_1"))
    side = np.array([-way[1], way[0]])
    flat = velocity / np.linalg.norm(velocity)
    return float(side @ flat * np.linalg.norm(table - ball))


@pytest.mark.parametrize("bottles", [(0.0,), (-0.05, 0.1), (0.02, 0.1, 0.2)])
def test_a_throw_passes_beside_what_stands_on_its_target(bottles: tuple[float, ...]) -> None:
    straight, way = crowded()
    assert across(straight, way) == pytest.approx(0.0, abs=0.02)
    plan, way = crowded(*bottles)
    at = across(plan, way)
    radius = plan.scene.body("b_1").half_extents[0]
    assert min(abs(at - b) for b in bottles) > radius + RADIUS_M
    assert touched_first(plan) == "table_1"


@pytest.mark.parametrize("turn_deg", [0.0, 30.0, 45.0, 90.0, 135.0])
def test_a_throw_passes_beside_it_in_every_direction(turn_deg: float) -> None:
    plan, way = crowded(0.0, turn_deg=turn_deg)
    level, its = crowded(0.0)
    assert across(plan, way) == pytest.approx(across(level, its), abs=1e-3)


def test_a_target_without_a_clear_place_is_aimed_at_straight() -> None:
    plan, way = crowded(*np.arange(-1.0, 1.01, 0.1))
    assert across(plan, way) == pytest.approx(0.0, abs=0.02)


def test_what_the_story_speaks_of_is_not_avoided() -> None:
    """Whoever throws at a bottle's table to have the bottle fall may hit the bottle."""
    plan, _way = crowded(0.0)
    nodes = dict(plan.story.nodes)
    last = list(nodes)[-1]
    nodes[last] = nodes[last].model_copy(
        update={"participants": (*nodes[last].participants, "bottle_0")}
    )
    from esg.dynamics.plan.aim import aim_heading

    phase = plan.story.phases["b_1"][0]
    ball, table = plan.scene.body("b_1"), plan.scene.body("table_1")
    story = replace(plan.story, nodes=nodes)
    heading = aim_heading(plan.scene, story, ball, phase, "table_1")
    wide = aim_heading(plan.scene, plan.story, ball, phase, "table_1")
    offset = np.array(table.position) - np.array(ball.position)
    assert heading == pytest.approx(np.arctan2(offset[1], offset[0]), abs=1e-6)
    assert abs(wide - heading) > 0.01


def test_what_is_thrown_at_a_hoop_is_thrown_at_its_rim_from_its_front() -> None:
    """Not at the post behind it, which is broader at the height of a hand."""
    doc = stories.cast("A basketball is thrown at a hoop and bounces off the rim.")
    laid = solve(doc, hints=start_hints(doc))
    scene = build_scene(laid)
    ball, hoop = scene.body("basketball_1"), scene.body("hoop_1")
    way = np.array(ball.position)[:2] - np.array(hoop.position)[:2]
    front = quat_rotate(np.array(hoop.quaternion), np.array([1.0, 0.0, 0.0]))[:2]
    assert way @ front > 0.9 * np.linalg.norm(way)
    cast = Cast(laid, scene, {}, True)
    goal = cast.throw_goal("basketball_1", cast.story.phases["basketball_1"][0])
    assert goal is not None
    assert goal[2] == pytest.approx(3.0, abs=0.06)
