"""Jointed things are laid out as one, as they start, with room to move."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from esg.graph.joints import frame_of
from esg.graph.models import EsgDocument, Joint, LayoutResult, Mount
from esg.layout import solve
from esg.layout.problem.hints import Constellation, Corridor, Placement, StartHints
from esg.units import quat_rotate
from tests.layout import builders as b

UP, ACROSS = (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)


def mount(x: float, y: float, z: float, axis: tuple[float, float, float] = UP) -> Mount:
    return Mount(name="m", position_cm=(x, y, z), axis=axis)


ASSETS = {
    "post": b.box("post", 10, 10, 200, is_movable=False, mounts=(mount(0, 5, 1),)),
    "leaf": b.box("leaf", 4, 80, 195, mounts=(mount(0, -40, 0),)),
    "arm": b.box("arm", 6, 6, 150, is_movable=False, mounts=(mount(0, 20, 140, ACROSS),)),
    "bob": b.cylinder("bob", 5, 100, mounts=(mount(0, 0, 100, ACROSS),)),
    "chair": b.box("chair", 45, 45, 90),
    "ball": b.ball("ball", 11),
    "table": b.table("table", 160, 160, 75),
}
THINGS = {"post": "post", "leaf": "leaf", "arm": "arm", "bob": "bob"}


def joint(child: str, parent: str, **more: Any) -> Joint:
    ends = {"child": child, "child_mount": "m", "parent": parent, "parent_mount": "m"}
    return Joint.model_validate({"id": child, "kind": "hinge", **ends, **more})


def document(nodes: Any, edges: Any, *joints: Joint) -> EsgDocument:
    doc = b.document(ASSETS, nodes, edges)
    graph = doc.spatial_relation_graph.model_copy(update={"joints": joints})
    return doc.model_copy(update={"spatial_relation_graph": graph})


def laid_out(doc: EsgDocument, **more: Any) -> LayoutResult:
    out = solve(doc, seed=1, **more).layout_result
    assert out is not None and out.feasible, out and out.reason
    return out


def meets(doc: EsgDocument, out: LayoutResult, joint: Joint) -> float:
    """Distance of the two mounts of a joint [cm]."""
    ends = []
    for node in (joint.child, joint.parent or ""):
        asset = doc.asset_configurations[doc.spatial_relation_graph.nodes[node].asset_id]
        frame = frame_of(out.poses[node])
        local = np.asarray((asset.mounts or ())[0].position_cm)
        ends.append(frame.position + quat_rotate(frame.quaternion, local))
    return float(np.linalg.norm(ends[0] - ends[1]))


@pytest.mark.parametrize("degrees", [0.0, 70.0])
def test_a_door_stands_where_its_post_does(degrees: float) -> None:
    hinge = joint("leaf", "post", lower=0, upper=110, position=degrees)
    doc = document({"leaf": "leaf", "post": "post", "chair": "chair"}, [], hinge)
    out = laid_out(doc)
    assert meets(doc, out, hinge) < 1e-3
    turned = out.poses["leaf"].yaw_deg - out.poses["post"].yaw_deg
    assert math.remainder(turned - degrees, 360) == pytest.approx(0, abs=1e-3)
    assert out.poses["leaf"].position_cm[2] == pytest.approx(1.01, abs=0.01)


def test_an_open_door_faces_as_its_post_does() -> None:
    hinge = joint("leaf", "post", position=80.0)
    face = ("leaf", "face", "ground_1", {"cardinal": "+Y"})
    out = laid_out(document({"leaf": "leaf", "post": "post"}, [face], hinge))
    assert out.poses["post"].yaw_deg == pytest.approx(90, abs=1)
    assert out.poses["leaf"].yaw_deg == pytest.approx(170, abs=1)


def test_a_pendulum_starts_drawn_back() -> None:
    hinge = joint("bob", "arm", position=30.0)
    doc = document({"bob": "bob", "arm": "arm"}, [], hinge)
    out = laid_out(doc)
    assert meets(doc, out, hinge) < 1e-3
    assert out.poses["bob"].pitch_deg == pytest.approx(30.0, abs=1e-3)
    assert out.poses["bob"].position_cm[2] == pytest.approx(140.01 - 100 * math.cos(math.pi / 6))


def test_what_hangs_on_a_thing_on_a_table_is_there_too() -> None:
    hinge = joint("bob", "arm")
    doc = document({"bob": "bob", "arm": "arm", "table": "table"}, [("arm", "on", "table")], hinge)
    out = laid_out(doc)
    assert meets(doc, out, hinge) < 1e-3
    assert out.poses["bob"].position_cm[2] == pytest.approx(75.02 + 40.0, abs=0.01)


def test_what_is_joined_may_overlap_and_nothing_else_may() -> None:
    inside = Mount(name="m", position_cm=(0.0, 0.0, 10.0), axis=UP)
    assets = {**ASSETS, "post": ASSETS["post"].model_copy(update={"mounts": (inside,)})}
    hinge = joint("leaf", "post")
    doc = document({"leaf": "leaf", "post": "post"}, [], hinge)
    out = laid_out(doc.model_copy(update={"asset_configurations": assets | {"ground": b.GROUND}}))
    assert out.max_penetration_cm == 0.0


@pytest.mark.parametrize("seed", range(4))
def test_the_way_of_a_door_stays_clear(seed: int) -> None:
    """A chair that is to stand near a door stands beside the quarter circle that it sweeps."""
    hinge = joint("leaf", "post", lower=0, upper=90)
    near = [("chair", "near", "post"), ("leaf", "face", "ground_1", {"cardinal": "+Y"})]
    doc = document({"leaf": "leaf", "post": "post", "chair": "chair"}, near, hinge)
    out = solve(doc, seed=seed).layout_result
    assert out is not None and out.feasible
    frame, chair = frame_of(out.poses["post"]), frame_of(out.poses["chair"])
    x, y, _ = frame.inverse().then(chair).position
    # the leaf sweeps -80 to 0 along the post's X, 5 to 85 along its Y
    off = max(-80 - 22.5 - x, x - 22.5, 5 - 22.5 - y, y - 85 - 22.5)
    assert off > -2.0


def test_a_planned_start_of_the_leaf_takes_the_post_along() -> None:
    hinge = joint("leaf", "post")
    doc = document({"leaf": "leaf", "post": "post", "ball": "ball"}, [], hinge)
    told = Constellation(
        (Placement("ball", 0, 0), Placement("leaf", 300, 0, 180.0)),
        (Corridor(((0, 0), (300, 0)), 15, ("ball", "leaf")),),
    )
    out = laid_out(doc, hints=StartHints((told,)))
    assert meets(doc, out, hinge) < 1e-3
    ball, leaf = (out.poses[n].position_cm for n in ("ball", "leaf"))
    assert math.dist(ball[:2], leaf[:2]) == pytest.approx(300.0, abs=0.01)


def test_a_hanging_thing_without_a_mount_to_hang_on_is_turned_where_it_is() -> None:
    free = joint("bob", "arm", position=20.0).model_copy(update={"parent_mount": None})
    doc = document({"bob": "bob", "arm": "arm"}, [], free)
    out = laid_out(doc)
    assert out.poses["bob"].pitch_deg == pytest.approx(20.0, abs=1e-3)
    # its lower rim stands on the ground: 5 cm from the axis, a cylinder's corner
    frame = frame_of(out.poses["bob"])
    rim = frame.position + quat_rotate(frame.quaternion, np.array([5.0, 0.0, 0.0]))
    assert rim[2] == pytest.approx(0.0, abs=0.1)
