"""What is to stay where it lands comes from above and is soon still; what slides stays on its table."""

from __future__ import annotations

import math

import pytest

from esg.dynamics import start_hints
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import Plan, make_plan
from esg.dynamics.story.stagecraft import top_surface
from esg.engines.program import AdjustProperties, HoldVelocity, SetVelocity
from esg.graph.models import EsgDocument
from esg.layout import solve
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast


def _planned(prompt: str) -> tuple[EsgDocument, Plan]:
    doc = cast(prompt)
    doc = solve(doc, seed=0, hints=start_hints(doc, seed=0))
    return doc, make_plan(doc, build_scene(doc), seed=0)


def test_what_is_to_lie_somewhere_hardly_bounces() -> None:
    lands, hits = cast("A ball is thrown and lands on a crate."), cast("A ball hits a crate.")
    assert lands.asset_configurations["ball_01"].restitution <= 0.1
    assert lands.asset_configurations["crate_01"].restitution == 0.0
    assert hits.asset_configurations["ball_01"].restitution > 0.3


def test_a_throw_comes_down_on_the_middle_of_the_top() -> None:
    _, plan = _planned("A stone thrown by a boy lands on a crate.")
    thrown = next(p for p in plan.compile(plan.initial()).primitives if isinstance(p, SetVelocity))
    stone, crate = plan.scene.body("stone_1"), plan.scene.body("crate_1")
    way = math.dist(stone.position[:2], crate.position[:2])
    lasts = way / math.hypot(*thrown.linear[:2])
    height = stone.position[2] + thrown.linear[2] * lasts - 0.5 * GRAVITY_MPS2 * lasts * lasts
    top = crate.position[2] + crate.half_extents[2]
    # A little above: the air takes of its speed.
    assert height == pytest.approx(top + stone.half_extents[2], abs=0.15)
    falls = GRAVITY_MPS2 * lasts - thrown.linear[2]
    assert falls > math.hypot(*thrown.linear[:2])  # steeper than 45 degrees


@pytest.mark.parametrize(
    ("prompt", "who"),
    [
        ("A stone thrown by a boy lands on a crate.", "stone_1"),
        ("A ball falls off a shelf and lands on a crate.", "ball_1"),
    ],
)
def test_it_is_held_back_once_it_has_landed(prompt: str, who: str) -> None:
    _, plan = _planned(prompt)
    held = [p for p in plan.compile(plan.initial()).primitives if isinstance(p, AdjustProperties)]
    assert [p.body for p in held if p.linear_damping and p.linear_damping > 5.0] == [who]


@pytest.mark.parametrize(
    ("prompt", "who"),
    [
        ("A puck slides across the table.", "puck_1"),
        ("A coin slides across the bar.", "coin_1"),
        ("A mug slides along the counter and stops.", "mug_1"),
    ],
)
def test_what_slides_along_a_table_stays_on_it_and_is_seen_to_move(prompt: str, who: str) -> None:
    doc, plan = _planned(prompt)
    (speed,) = [v for v in plan.variables if v.name.endswith("/speed")]
    body = plan.scene.body(who)
    node = doc.spatial_relation_graph.nodes[who]
    assert node.semantic_region is not None
    host = doc.spatial_relation_graph.semantic_regions[node.semantic_region].parent_object
    mu = 0.5 * (body.friction + plan.scene.body(host).friction)
    room = 0.02 * max(top_surface(doc, host).half_extents_cm)
    assert speed.upper**2 / (2.0 * mu * GRAVITY_MPS2) < 0.65 * room
    assert speed.lower**2 / (2.0 * mu * GRAVITY_MPS2) > 0.3 * room


def test_what_rolls_along_a_table_is_slowed_before_its_edge() -> None:
    doc, plan = _planned("A marble rolls across the desk.")
    (held,) = [
        p for p in plan.compile(plan.initial()).primitives if isinstance(p, AdjustProperties)
    ]
    (speed,) = [v for v in plan.variables if v.name.endswith("/speed")]
    assert held.linear_damping is not None
    way = speed.upper * (held.time + 1.0 / held.linear_damping)
    assert way < 0.013 * max(top_surface(doc, "desk_1").half_extents_cm)


@pytest.mark.parametrize(
    ("prompt", "stands"),
    [
        ("A man runs into a barrel.", True),
        ("A dog runs into a box and knocks it over.", True),
        ("A man runs into a barrel and falls over.", False),
        ("A cat leaps from a chair onto a table and bumps a jar, which topples over.", False),
        ("A car drives into a barrel.", False),
    ],
)
def test_who_runs_into_something_stays_on_his_feet(prompt: str, stands: bool) -> None:
    _, plan = _planned(prompt)
    program = plan.compile(plan.initial())
    holds = [p for p in program.primitives if isinstance(p, HoldVelocity)]
    under = [p for p in holds if p.gains is not None and p.speed == 0.0 and math.isinf(p.end)]
    assert bool(under) is stands
    if stands:  # the drive comes later in the list, and so overrides it until it has hit
        assert program.primitives.index(under[0]) < program.primitives.index(holds[-1])
        assert holds[-1].until_contact
