"""The joints of the physical scene are those of the document, as its bodies stand."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import cast
from esg.dynamics.plan.build import build_scene
from esg.engines.joints import joint_problems, joint_state
from esg.engines.scene import SimScene
from esg.graph.models import JointMotor
from esg.layout import solve
from esg.outcomes import UserError
from tests.layout.test_joined import document, joint


def scene(child: str, parent: str, **more: Any) -> SimScene:
    doc = document({child: child, parent: parent}, [], joint(child, parent, **more))
    return build_scene(solve(doc, seed=1))


def state(scene: SimScene) -> Any:
    j = scene.joints[0]
    poses = [
        (np.array(scene.body(n).position), np.array(scene.body(n).quaternion))
        for n in (j.child, j.parent)
    ]
    return joint_state(j, poses[0], poses[1])


@pytest.mark.parametrize("degrees", [-40.0, 0.0, 30.0])
@pytest.mark.parametrize("pair", [("leaf", "post"), ("bob", "arm")])
def test_a_hinge_starts_at_its_position(pair: tuple[str, str], degrees: float) -> None:
    told = scene(*pair, position=degrees, lower=-90, upper=90)
    assert joint_problems(told) == []
    assert float(state(told).position) == pytest.approx(math.radians(degrees), abs=1e-5)
    assert told.joints[0].upper == pytest.approx(math.pi / 2)


def test_a_slider_starts_at_its_position() -> None:
    told = scene("leaf", "post", kind="slider", position=12.0, upper=30.0)
    assert joint_problems(told) == []
    assert float(state(told).position) == pytest.approx(0.12, abs=1e-5)
    assert told.joints[0].upper == pytest.approx(0.3)


@pytest.mark.parametrize("degrees", [0.0, 35.0])
def test_a_rope_is_as_long_as_it_is_told(degrees: float) -> None:
    told = scene("bob", "arm", kind="rope", upper=20.0, position=degrees)
    assert joint_problems(told) == []
    assert float(state(told).position) == pytest.approx(0.2, abs=1e-5)


@pytest.mark.parametrize("degrees", [0.0, 50.0])
def test_a_ball_joint_knows_how_far_it_is_drawn_back(degrees: float) -> None:
    """Its mounts' axes are vertical: the leaf leans as far as it is drawn back."""
    told = scene("leaf", "post", kind="ball", upper=75.0, position=degrees)
    assert joint_problems(told) == []
    assert float(state(told).position) == pytest.approx(math.radians(degrees), abs=1e-5)


def test_a_joint_to_the_world_holds_a_thing_where_it_is() -> None:
    told = joint("bob", "arm", position=25.0)
    told = told.model_copy(update={"parent": None, "parent_mount": None})
    scene = build_scene(solve(document({"bob": "bob"}, [], told), seed=1))
    j, body = scene.joints[0], scene.body("bob")
    assert joint_problems(scene) == []
    here = joint_state(j, (np.array(body.position), np.array(body.quaternion)), None)
    assert float(here.position) == pytest.approx(math.radians(25.0), abs=1e-5)


def test_numbers_are_in_si() -> None:
    motor = JointMotor(speed=90.0, position=45.0)
    j = scene("leaf", "post", motor=motor, damping=0.5, friction=0.4, break_impulse=9.0).joints[0]
    assert (j.damping, j.friction, j.break_impulse, j.collide) == (0.5, 0.4, 9.0, False)
    assert j.motor is not None and j.motor.limit == math.inf
    assert (j.motor.speed, j.motor.position) == pytest.approx((math.pi / 2, math.pi / 4))
    slid = scene("leaf", "post", kind="slider", motor={"speed": 20.0, "limit": 3.0}).joints[0]
    assert slid.motor is not None and (slid.motor.speed, slid.motor.limit) == (0.2, 3.0)


def test_a_missing_mount_is_named() -> None:
    told = joint("leaf", "post").model_copy(update={"child_mount": "knob"})
    with pytest.raises(UserError, match=r"leaf.*knob.*\['m'\]"):
        build_scene(solve(document({"leaf": "leaf", "post": "post"}, [], told), seed=1))


def test_the_board_of_a_seesaw_is_not_stood_on_its_end() -> None:
    """Casting leaves what a joint holds as its mounts have it, whatever is told of it."""
    doc = cast(resolve(draft("A stone topples a seesaw.")))
    assert doc.spatial_relation_graph.joints
    assert joint_problems(build_scene(solve(doc, seed=1))) == []
