"""Down a slope under one's own power: along it, not off its side, and upright if one stands up."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import cast
from esg.dynamics.choreography.slopes import FASTEST_MPS
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.engines.program import HoldVelocity, Program, SetVelocity
from esg.engines.scene import SimScene
from esg.graph import effective
from esg.layout import solve, stored_hints
from esg.units import yaw_from_quat


def planned(prompt: str) -> tuple[SimScene, Program, dict[str, float]]:
    doc = cast(resolve(draft(prompt)))
    hints = stored_hints(doc.choreography) if doc.choreography is not None else None
    doc = effective(solve(doc, hints=hints))
    scene = build_scene(doc)
    plan = make_plan(doc, scene, seed=0)
    yaws = {n: float(yaw_from_quat(q)) for n, (_, q) in plan.starts(plan.initial()).items()}
    return scene, plan.compile(plan.initial()), yaws


@pytest.mark.parametrize(
    ("prompt", "actor"),
    [
        ("A skateboarder rolls down a ramp.", "skateboarder_1"),
        ("A man rides a skateboard down the ramp.", "skateboard_1"),
    ],
)
def test_who_stands_up_is_held_along_the_slope(prompt: str, actor: str) -> None:
    scene, program, yaws = planned(prompt)
    slope = float(yaw_from_quat(np.array(scene.body("ramp_1").quaternion)))
    (held,) = (p for p in program.primitives if isinstance(p, HoldVelocity) and p.body == actor)
    assert held.end == math.inf and held.speed <= FASTEST_MPS
    for yaw in (held.heading, yaws[actor]):
        assert abs(math.remainder(yaw - slope, 2.0 * math.pi)) < 0.2


def test_what_is_low_and_long_tilts_with_it() -> None:
    scene, program, _ = planned("A skateboard rolls down a ramp.")
    slope = float(yaw_from_quat(np.array(scene.body("ramp_1").quaternion)))
    assert not [p for p in program.primitives if isinstance(p, HoldVelocity)]
    pushed = [p for p in program.primitives if isinstance(p, SetVelocity)]
    assert [p.body for p in pushed][:1] == ["skateboard_1"]
    vx, vy, _ = pushed[0].linear
    assert abs(math.remainder(math.atan2(vy, vx) - slope, 2.0 * math.pi)) < 0.2


@pytest.mark.parametrize(
    ("prompt", "actor", "landing"),
    [
        ("A toy car rolls off a table and lands in a basket.", "toy_car_1", "basket_1"),
        ("A toy truck rolls off a shelf into a box.", "toy_truck_1", "box_1"),
        ("A skateboard rolls off a bench and lands in a cart.", "skateboard_1", "cart_1"),
    ],
)
def test_nothing_drives_what_has_gone_over_an_edge(prompt: str, actor: str, landing: str) -> None:
    """It would push what it landed in across the floor."""
    _, program, _ = planned(prompt)
    (held,) = (p for p in program.primitives if isinstance(p, HoldVelocity) and p.body == actor)
    assert held.until_contact == (landing,)
