"""The record of a joint: its frames, its checks, its way through the manifest."""

from dataclasses import replace
import json
import math

import numpy as np
import pytest

from esg.engines.joints import Joint, Motor, joint_between, joint_problems, joint_state
from esg.engines.manifest import manifest_bytes, manifest_from_json, manifest_to_json
from esg.engines.program import Program
from esg.engines.scene import Body, Shape, SimScene
from esg.outcomes import UserError
from esg.units import quat_from_euler_deg, quat_multiply, quat_rotate

POST = Body("post", True, 10.0, ((1, 0, 0), (0, 1, 0), (0, 0, 1)), (), (0.0, 0.0, 1.0))
LEAF = Body(
    "leaf",
    False,
    20.0,
    ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    (Shape("box", (0.4, 0.02, 1.0)),),
    (0.5, 0.0, 1.0),
    tuple(quat_from_euler_deg(0.0)),
)
HINGE = joint_between("hinge", "hinge", LEAF, POST, at=(0.1, 0.0, 1.0), axis=(0.0, 0.0, 1.0))
SCENE = SimScene("s", (POST, LEAF), joints=(HINGE,))


def pose(body):
    return np.array(body.position), np.array(body.quaternion)


@pytest.mark.parametrize("degrees", [-120.0, -30.0, 0.0, 75.0, 170.0])
def test_hinge_tells_the_angle_that_its_child_has_turned(degrees):
    turn = quat_from_euler_deg(degrees)
    anchor = np.array([0.1, 0.0, 1.0])
    at = anchor + quat_rotate(turn, np.array(LEAF.position) - anchor)
    moved = (at, quat_multiply(turn, np.array(LEAF.quaternion)))
    state = joint_state(HINGE, moved, pose(POST))
    assert math.degrees(state.position) == pytest.approx(degrees, abs=1e-9)
    assert state.gap == pytest.approx(0.0, abs=1e-12)


def test_joint_may_start_away_from_zero():
    ajar = joint_between(
        "h", "hinge", LEAF, POST, at=(0.1, 0, 1), axis=(0, 0, 1), position=math.radians(25)
    )
    assert math.degrees(joint_state(ajar, pose(LEAF), pose(POST)).position) == pytest.approx(25)
    drawn = joint_between("s", "slider", LEAF, None, at=(0.5, 0, 1), axis=(0, 1, 0), position=0.2)
    state = joint_state(drawn, pose(LEAF), None)
    assert (state.position, state.gap) == pytest.approx((0.2, 0.0))


def test_rope_tells_its_length_and_how_far_it_is_overstretched():
    rope = joint_between("r", "rope", LEAF, None, at=(0.5, 0, 2), parent_at=(0.5, 0, 3.5))
    state = joint_state(replace(rope, upper=1.2), pose(LEAF), None)
    assert (state.position, state.gap) == pytest.approx((1.5, 0.3))


def test_manifest_keeps_joints_and_says_what_they_mean():
    driven = replace(HINGE, lower=0.0, upper=1.5, damping=0.2, motor=Motor(0.5), break_impulse=40.0)
    data = manifest_to_json(replace(SCENE, joints=(driven,)), Program((), 1.0), dt=0.01)
    assert "joints" in data["conventions"]
    again = manifest_from_json(json.loads(manifest_bytes(data)))
    assert again.scene.joints == (driven,)


def test_manifest_without_joints_says_nothing_of_them():
    data = manifest_to_json(replace(SCENE, joints=()), Program((), 1.0), dt=0.01)
    assert "joints" not in data
    assert "joints" not in data["conventions"]


def test_every_mistake_is_told_with_its_place():
    bad = (
        replace(HINGE, child="nobody"),
        replace(HINGE, lower=1.0, upper=0.5),
        Joint("rope", "rope", "leaf", parent_anchor=(0.5, 0.0, 4.0), upper=1.0),
        replace(HINGE, name="self", parent="leaf"),
        Joint("b", "ball", "post", motor=Motor(1.0)),
    )
    told = "\n".join(joint_problems(replace(SCENE, joints=bad)))
    for words in (
        "/joints/0/child: no body 'nobody'",
        "/joints/1/name: 'hinge' is used twice",
        "/joints/1/lower: 1 is above upper, 0.5",
        "/joints/2/upper: a rope of 1 m between points 3.000 m apart",
        "/joints/3/parent: 'leaf' is joined to itself",
        "/joints/4/child: 'post' cannot move",
        "/joints/4/motor: a ball has none",
    ):
        assert words in told
    data = manifest_to_json(SCENE, Program((), 1.0), dt=0.01)
    data["joints"][0]["child"] = "nobody"
    with pytest.raises(UserError, match="/joints/0/child: no body 'nobody'"):
        manifest_from_json(data)
