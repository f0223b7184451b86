"""What lies on what drives is under way with it from the first step."""

from __future__ import annotations

from itertools import pairwise
import math

import numpy as np
import pytest

from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.engines.program import Program, SetVelocity
from esg.graph.joints import FOOT, FRONT, REAR, SEAT
from esg.graph.models import Actor, EsgDocument, Joint, TimelineEdge, TimelineNode
from esg.units import quat_inverse, quat_rotate, yaw_from_quat
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


def towing(*behind: str) -> EsgDocument:
    """A truck that draws things along, one behind the other."""
    doc = driving({})
    ahead = ("truck_1", *behind)
    tows = tuple(
        Joint(id=f"{b}_rope", kind="rope", child=b, child_mount=FRONT, parent=a,
              parent_mount=REAR, upper=100.0)
        for a, b in pairwise(ahead)
    )  # fmt: skip
    graph = doc.spatial_relation_graph.model_copy(update={"joints": tows})
    return doc.model_copy(update={"spatial_relation_graph": graph})


def test_what_is_drawn_along_is_under_way_behind() -> None:
    doc = towing("crate_1", "cup_1")
    assert set(set_going(doc)) == {"crate_1", "cup_1"}
    doc = lay_out(doc)
    scene = build_scene(doc)
    plan = make_plan(doc, scene, seed=0)
    theta = plan.initial()
    theta[[v.name for v in plan.variables].index("truck_1/aim")] += 0.2
    starts = plan.starts(theta)
    truck, crate = starts["truck_1"], starts["crate_1"]
    was = [scene.body(n) for n in ("truck_1", "crate_1")]
    ahead = np.array(was[1].position) - np.array(was[0].position)
    ahead = quat_rotate(quat_inverse(np.array(was[0].quaternion)), ahead)
    assert crate[0] - truck[0] == pytest.approx(quat_rotate(truck[1], ahead))
    assert float(yaw_from_quat(crate[1])) == pytest.approx(float(yaw_from_quat(truck[1])))


def test_who_is_fixed_to_what_is_re_aimed_starts_where_it_does() -> None:
    """A rider keeps his place on a truck that is turned and moved aside."""
    doc = driving({"crate_1": "truck_1"})
    graph = doc.spatial_relation_graph.model_copy(update={"joints": (
        Joint(id="seat", kind="fixed", child="crate_1", child_mount=FOOT, parent="truck_1",
              parent_mount=SEAT),)})  # fmt: skip
    doc = lay_out(doc.model_copy(update={"spatial_relation_graph": graph}))
    scene = build_scene(doc)
    plan = make_plan(doc, scene, seed=0)
    names = [v.name for v in plan.variables]
    theta = plan.initial()
    theta[names.index("truck_1/aim")] += 0.2
    theta[names.index("truck_1/lateral")] += 0.3
    moved = plan.starts(theta)
    assert set(moved) == {"truck_1", "crate_1"}
    for name in ("truck_1", "crate_1"):
        assert not np.allclose(moved[name][0], scene.body(name).position)
    truck, crate = scene.body("truck_1"), scene.body("crate_1")
    was = quat_rotate(
        quat_inverse(np.array(truck.quaternion)), np.subtract(crate.position, truck.position)
    )
    (at, turned), (there, facing) = moved["truck_1"], moved["crate_1"]
    np.testing.assert_allclose(quat_rotate(quat_inverse(turned), there - at), was, atol=1e-9)
    np.testing.assert_allclose(yaw_from_quat(facing), yaw_from_quat(turned), atol=1e-9)


def test_a_load_is_re_aimed_with_what_carries_it() -> None:
    doc = lay_out(driving({"crate_1": "truck_1", "cup_1": "crate_1"}))
    plan = make_plan(doc, build_scene(doc), seed=0)
    names, usual = [v.name for v in plan.variables], plan.initial()
    aside = usual.copy()
    aside[names.index("truck_1/lateral")] += 0.1
    before, after = plan.starts(usual), plan.starts(aside)
    way = after["truck_1"][0] - before["truck_1"][0]
    assert np.linalg.norm(way) == pytest.approx(0.1)
    for load in ("crate_1", "cup_1"):
        np.testing.assert_allclose(after[load][0] - before[load][0], way, atol=1e-9)
