"""Where joints put nodes, on poses that are known in closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.graph import canonical_json, verify
from esg.graph.joints import (
    FRONT,
    REAR,
    Frame,
    child_frame,
    own_frame,
    placing_joints,
    pose_of,
    start_frames,
    trails,
)
from esg.graph.models import AssetConfiguration, EsgDocument, Joint, Mount
from esg.units import euler_deg_from_quat, quat_from_euler_deg, quat_rotate
from tests.graph.builders import Json, finished

UP, ACROSS = (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)


def asset(*mounts: Mount) -> AssetConfiguration:
    return AssetConfiguration(
        asset_name="thing", source="parametric", category="thing", mesh_path="meshes/thing.glb",
        dimensions_cm=(10, 10, 10), mass_kg=1, is_movable=True, friction=0.5, restitution=0.2,
        mounts=mounts,
    )  # fmt: skip


def mount(x: float, y: float, z: float, axis: tuple[float, float, float] = UP) -> Mount:
    return Mount(name="m", position_cm=(x, y, z), axis=axis)


def joint(kind: str, **more: object) -> Joint:
    ends = {"child": "c", "child_mount": "m", "parent": "p", "parent_mount": "m"}
    return Joint.model_validate({"id": "j", "kind": kind, **ends, **more})


@pytest.mark.parametrize("degrees", [-90.0, 0.0, 30.0, 110.0])
def test_hinge_turns_its_child_about_the_mounts(degrees: float) -> None:
    frame = asset(mount(-5, -40, 1))
    leaf = asset(mount(-2, -40, 0))
    at = child_frame(joint("hinge", position=degrees), frame, leaf)
    turned = math.radians(degrees)
    # the leaf's origin is (2, 40, 0) from its mount
    x, y = (
        2 * math.cos(turned) - 40 * math.sin(turned),
        2 * math.sin(turned) + 40 * math.cos(turned),
    )
    assert at.position == pytest.approx([-5 + x, -40 + y, 1])
    assert euler_deg_from_quat(at.quaternion) == pytest.approx((degrees, 0, 0), abs=1e-9)


def test_slider_moves_along_the_axis_of_any_length() -> None:
    at = child_frame(
        joint("slider", position=12.0), asset(mount(1, 2, 3, (0, 5, 0))), asset(mount(0, 0, 1, (0, 2, 0)))
    )  # fmt: skip
    assert at.position == pytest.approx([1, 14, 2])
    assert at.quaternion == pytest.approx([0, 0, 0, 1])


@pytest.mark.parametrize("kind", ["rope", "spring"])
def test_rope_hangs_straight_down_and_is_drawn_back(kind: str) -> None:
    hook, ball = asset(mount(0, 0, 200, ACROSS)), asset(mount(0, 0, 10, ACROSS))
    rope = {"upper": 100.0, "stiffness": 50.0 if kind == "spring" else None}
    assert child_frame(joint(kind, **rope), hook, ball).position == pytest.approx([0, 0, 90])
    back = child_frame(joint(kind, position=30.0, **rope), hook, ball)
    assert back.position == pytest.approx([-110 * 0.5, 0, 200 - 110 * math.cos(math.pi / 6)])


def test_child_is_turned_so_that_the_axes_agree() -> None:
    at = child_frame(joint("hinge"), asset(mount(0, 0, 0, ACROSS)), asset(mount(0, 0, 0, UP)))
    assert quat_rotate(at.quaternion, np.array(UP)) == pytest.approx(ACROSS)


def test_ball_joint_is_drawn_back_across_its_axis() -> None:
    down = (0.0, 0.0, -1.0)
    at = child_frame(
        joint("ball", upper=75.0, position=40.0), asset(mount(0, 0, 9, down)), asset(mount(0, 0, 4, down))
    )  # fmt: skip
    tilt = math.radians(40.0)
    assert at.position == pytest.approx([-4 * math.sin(tilt), 0, 9 - 4 * math.cos(tilt)])


def test_without_a_mount_of_the_parent_a_child_turns_where_it_is() -> None:
    lamp = asset(mount(0, 0, 50, ACROSS))
    at = own_frame(joint("hinge", parent_mount=None, position=90.0), lamp)
    assert at.position == pytest.approx([-50, 0, 50])
    still = own_frame(joint("hinge", parent_mount=None), lamp)
    assert still.position == pytest.approx([0, 0, 0])


@pytest.mark.parametrize("angles", [(10, 20, 30), (-170, 80, 5), (40, 90, 0), (40, -90, 0)])
def test_angles_come_back(angles: tuple[float, float, float]) -> None:
    assert euler_deg_from_quat(quat_from_euler_deg(*angles)) == pytest.approx(angles, abs=1e-5)
    pose = pose_of(Frame(np.zeros(3), quat_from_euler_deg(*angles)))
    assert (pose.yaw_deg, pose.pitch_deg, pose.roll_deg) == pytest.approx(angles, abs=1e-4)


def jointed() -> Json:
    """A bin that hangs on a table that hangs on a car."""
    out = finished()
    for key in out["asset_configurations"]:
        mounts = [{"name": "m", "position_cm": [10, 0, 5], "axis": [0, 1, 0]}]
        out["asset_configurations"][key]["mounts"] = mounts
    ends = {"child_mount": "m", "parent_mount": "m", "kind": "hinge"}
    out["spatial_relation_graph"]["joints"] = [
        {"id": "b", "child": "trashbin_1", "parent": "picnic_table_1", "position": 20, **ends},
        {"id": "a", "child": "picnic_table_1", "parent": "car_1", **ends},
    ]
    return out


def sized(length: float, height: float) -> AssetConfiguration:
    return asset().model_copy(update={"dimensions_cm": (length, 100.0, height)})


@pytest.mark.parametrize("height", [30.0, 60.0, 200.0])
def test_what_a_rope_draws_stands_behind_on_the_same_level(height: float) -> None:
    tow = joint("rope", upper=200.0, parent_mount=REAR, child_mount=FRONT)
    at = child_frame(tow, sized(400.0, 150.0), sized(120.0, height))
    lift = min(40.0, 0.5 * height) - 40.0
    assert at.position == pytest.approx([-200 - math.sqrt(200.0**2 - lift**2) - 60, 0, 0])
    assert at.quaternion == pytest.approx([0, 0, 0, 1])
    assert trails(tow)


def test_a_hitch_keeps_its_mounts_together() -> None:
    hitch = joint("hinge", parent_mount=REAR, child_mount=FRONT, lower=-60, upper=60, position=30)
    at = child_frame(hitch, sized(400.0, 150.0), sized(120.0, 200.0))
    end = at.position + quat_rotate(at.quaternion, np.array([60.0, 0.0, 40.0]))
    assert end == pytest.approx([-200, 0, 40])
    assert not trails(hitch)


def test_children_of_children_follow() -> None:
    doc = EsgDocument.model_validate(jointed())
    assert verify(doc) == ()
    frames = start_frames(doc)
    assert {n: root for n, (root, _) in frames.items()} == {
        "picnic_table_1": "car_1", "trashbin_1": "car_1",
    }  # fmt: skip
    _, pitch, _ = euler_deg_from_quat(frames["trashbin_1"][1].quaternion)
    assert pitch == pytest.approx(20.0)


def test_a_circle_of_joints_places_nothing_twice() -> None:
    raw = jointed()
    joints = raw["spatial_relation_graph"]["joints"]
    joints.append({**joints[0], "id": "c", "child": "car_1", "parent": "trashbin_1"})
    doc = EsgDocument.model_validate(raw)
    assert set(placing_joints(doc)) == {"trashbin_1", "picnic_table_1"}
    assert {v.code for v in verify(doc)} == {"JOINT_CIRCLE"}


def test_documents_without_joints_keep_their_bytes() -> None:
    text = canonical_json(EsgDocument.model_validate(finished()))
    assert b"joints" not in text and b"mounts" not in text
