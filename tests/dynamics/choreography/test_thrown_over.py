"""Throws over something, pairs that a way leads between, and what comes to lie."""

from __future__ import annotations

import math

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import build_scene, start_hints
from esg.dynamics.plan.planner import make_plan
from esg.engines.program import AdjustProperties, SetVelocity
from esg.graph.models import EsgDocument
from esg.layout import solve
from esg.units import GRAVITY_MPS2


def _laid(prompt: str) -> EsgDocument:
    doc = resolve(draft(prompt))
    return solve(doc, seed=0, hints=start_hints(doc, seed=0))


def _program(doc: EsgDocument):
    plan = make_plan(doc, build_scene(doc), seed=0)
    return plan.compile(plan.initial()).primitives


@pytest.mark.parametrize(
    "prompt",
    ["A ball is thrown over a wall.", "A stone is thrown over a car.",
     "A stone is thrown at 9 m/s over a fence."],
)  # fmt: skip
def test_a_throw_is_above_what_it_clears(prompt: str) -> None:
    """At the middle of the thing the throw is over its top, by closed form."""
    doc = _laid(prompt)
    scene = build_scene(doc)
    (let_go,) = [p for p in _program(doc) if isinstance(p, SetVelocity)]
    thrown = scene.body(let_go.body)
    other = next(b for b in scene.bodies if b.name.startswith(("car", "wall", "fence")))
    along = math.hypot(*let_go.linear[:2])
    apart = math.dist(thrown.position[:2], other.position[:2])
    t = apart / along
    height = thrown.position[2] + let_go.linear[2] * t - 0.5 * GRAVITY_MPS2 * t**2
    assert height - thrown.half_extents[2] > 2.0 * other.half_extents[2]


def test_two_things_stand_on_either_side_of_a_way_between_them() -> None:
    doc = resolve(draft("A cyclist rides between a tree and a bench."))
    (only,) = start_hints(doc, seed=0).constellations
    at = {p.node: (p.x_cm, p.y_cm) for p in only.placements}
    assert at["tree_1"][1] * at["bench_1"][1] < 0.0
    assert at["tree_1"][0] == pytest.approx(at["bench_1"][0])
    assert at["tree_1"][0] > at["cyclist_1"][0]


def test_what_lands_and_rolls_is_slowed_down_there() -> None:
    """An apple comes to lie after it has fallen; one that only rolls is left to roll."""
    lies = _program(_laid("An apple rolls off the counter and lands on the floor."))
    rolls = _program(_laid("An apple rolls off the counter."))
    (slowed,) = [p for p in lies if isinstance(p, AdjustProperties)]
    assert slowed.time > math.sqrt(2.0 * 0.8 / GRAVITY_MPS2)
    assert slowed.linear_damping == slowed.angular_damping
    assert not any(isinstance(p, AdjustProperties) for p in rolls)
