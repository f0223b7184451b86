"""What lies on what drives is under way with it from the first step."""

from __future__ import annotations

import math

import pytest

from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.engines.program import Program, SetVelocity
from esg.graph.models import Actor, EsgDocument, TimelineEdge, TimelineNode
from tests.dynamics.stage import asset, document, lay_out

TRUCK = asset("truck", (600, 220, 120), 4000, wheeled=True, surface=True)
CRATE = asset("crate", (60, 60, 60), 20, surface=True)
CUP = asset("cup", (8, 8, 10), 0.3)
LAMP = asset("lamp", (20, 20, 30), 2, movable=False)


def driving(on: dict[str, str], hit: str = "", **params: object) -> EsgDocument:
    """A truck drives at 5 m/s until it hits something, if it does."""
    end = TimelineNode(id="t", event="Trigger", participants=("truck_1",), window=(2, 3))
    if hit:
        end = TimelineNode(id="t", event="Collision", participants=("truck_1", hit), window=(2, 3))
    return document(
        "A truck drives.",
        dict(truck_1=TRUCK, crate_1=CRATE, cup_1=CUP, lamp_1=LAMP),
        {"truck_1": Actor(role="active", force_direction="ALONG_FORWARD_ONLY")},
        [TimelineNode(id="start", event="SceneStart", timestamp=0), end],
        [
            TimelineEdge(
                **{"id": "drive", "from": "start", "to": "t", "event": "UniformMotion"},
                actor="truck_1",
                target=hit or None,
                params={"speed": 500.0, **params},
            )
        ],
        on=on,
    )


def program(doc: EsgDocument) -> Program:
    doc = lay_out(doc)
    plan = make_plan(doc, build_scene(doc), seed=0)
    return plan.compile(plan.initial())


def set_going(doc: EsgDocument) -> dict[str, SetVelocity]:
    """What gets a velocity, by name."""
    return {p.body: p for p in program(doc).primitives if isinstance(p, SetVelocity)}


def test_a_load_has_the_speed_and_the_way_of_what_carries_it() -> None:
    doc = driving({"crate_1": "truck_1"})
    (held,) = [p for p in program(doc).primitives if p.kind == "HoldVelocity"]
    (load,) = set_going(doc).values()
    assert (load.body, load.time) == ("crate_1", held.start)
    vx, vy, vz = load.linear
    assert math.hypot(vx, vy) == pytest.approx(5.0) == pytest.approx(held.speed)
    assert math.atan2(vy, vx) == pytest.approx(held.heading)
    assert vz == 0.0


def test_what_lies_on_the_load_goes_along_too() -> None:
    assert set(set_going(driving({"crate_1": "truck_1", "cup_1": "crate_1"}))) == {
        "crate_1",
        "cup_1",
    }


def test_backward_the_load_goes_backward() -> None:
    (ahead,) = set_going(driving({"crate_1": "truck_1"})).values()
    doc = driving({"crate_1": "truck_1"}, backward=True)
    (load,) = set_going(doc).values()
    (held,) = [p for p in program(doc).primitives if p.kind == "HoldVelocity"]
    assert math.hypot(*load.linear[:2]) == pytest.approx(math.hypot(*ahead.linear[:2]))
    assert math.atan2(load.linear[1], load.linear[0]) == pytest.approx(held.heading)


@pytest.mark.parametrize(
    ("on", "hit"),
    [
        ({}, ""),
        ({"lamp_1": "truck_1"}, ""),
        ({"cup_1": "crate_1"}, ""),
        ({"crate_1": "truck_1"}, "crate_1"),
    ],
    ids=["beside it", "fixed", "on something else", "with a part of its own"],
)
def test_only_loads_are_set_going(on: dict[str, str], hit: str) -> None:
    assert set_going(driving(on, hit)) == {}
