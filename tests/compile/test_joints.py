"""Joints in the emitted class: it does what the program does, and says everything it does."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from helpers import assert_same, both, written
import numpy as np
import pytest
import scenes

from esg.compile import ReplayError, emit_class, replay_class
from esg.engines.joints import Joint, Motor, joint_between
from esg.engines.program import DriveJoint, Primitive, Program, SetVelocity
from esg.engines.scene import Body, SimScene

_Y, _Z = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
Case = tuple[tuple[Body, ...], tuple[Joint, ...], tuple[Primitive, ...]]


def door() -> Case:
    """A door with limits, friction and a closer; a ball hits it."""
    frame = scenes.box("frame", (0.0, 0.0, 1.0), (0.05, 0.05, 1.0), 1.0, static=True, yaw=0.3)
    leaf = scenes.box("leaf", (0.5, 0.0, 1.05), (0.45, 0.02, 1.0), 20.0)
    ball = scenes.ball("ball", (0.8, -0.5, 1.0), 0.1, 2.0)
    hinge = joint_between("hinge", "hinge", leaf, frame, at=(0.05, 0.0, 1.05), axis=_Z)
    hinge = replace(hinge, lower=-0.2, upper=1.5, friction=0.8, stiffness=6.0, damping=2.0)
    return (frame, leaf, ball), (hinge,), (SetVelocity("ball", 0.0, (0.0, 5.0, 0.0)),)


def swing() -> Case:
    """A rod that swings on a post and is driven, to a speed, to a place, and let go."""
    post = scenes.box("post", (0.0, 0.4, 1.5), (0.1, 0.1, 1.5), 1.0, static=True)
    rod = scenes.box("rod", (0.0, 0.0, 2.5), (0.05, 0.05, 0.5), 2.0)
    hinge = joint_between("pivot", "hinge", rod, post, at=(0.0, 0.0, 2.95), axis=_Y, position=0.1)
    commands = (
        DriveJoint("pivot", 0.3, speed=2.0, limit=12.0),
        DriveJoint("pivot", 0.8, speed=1.5, position=-0.4),
        DriveJoint("pivot", 2.0),
    )
    return (post, rod), (hinge,), commands


def slide() -> Case:
    """A drawer with a limit on one side and a motor, and one that is drawn back."""
    drawers = [scenes.box(n, (0.0, y, 1.0), (0.2, 0.2, 0.1), 3.0) for n, y in (("a", 0), ("b", 1))]
    one, two = (
        joint_between(f"rail {b.name}", "slider", b, None, at=b.position, position=p)
        for b, p in zip(drawers, (0.0, 0.2), strict=True)
    )
    joints = (
        replace(one, lower=-0.1, upper=0.35, motor=Motor(0.3, limit=40.0)),
        replace(two, stiffness=80.0, damping=1.0),
    )
    return tuple(drawers), joints, ()


def hung() -> Case:
    """A lamp on a rope, a basket on a spring between two bodies, a cone, a weld that breaks."""
    beam = scenes.box("beam", (0.0, 0.0, 4.0), (2.0, 0.1, 0.1), 1.0, static=True)
    lamp = scenes.ball("lamp", (-1.0, 0.6, 3.0), 0.1, 1.0)
    cart = scenes.box("cart", (1.2, 0.0, 3.3), (0.1, 0.1, 0.1), 2.0)
    basket = scenes.box("basket", (1.3, 0.2, 2.6), (0.1, 0.1, 0.1), 1.0)
    arm = scenes.box("arm", (0.3, 0.0, 3.8), (0.3, 0.03, 0.03), 1.0)
    sign = scenes.box("sign", (-0.3, 0.0, 3.6), (0.1, 0.02, 0.2), 1.5)
    hook = joint_between("hook", "ball", arm, beam, at=(0.0, 0.0, 3.8))
    joints = (
        replace(
            joint_between("cord", "rope", lamp, beam, at=lamp.position, parent_at=(-1, 0, 3.9)),
            upper=1.2,
        ),
        replace(
            joint_between("coil", "spring", basket, cart, at=(1.3, 0.2, 2.7), parent_at=(1.2, 0, 3.2)),
            upper=0.4, stiffness=60.0, damping=0.5,
        ),
        replace(joint_between("rail", "slider", cart, beam, at=cart.position), friction=2.0),
        replace(hook, upper=0.7, damping=0.05),
        replace(joint_between("weld", "fixed", sign, beam, at=(-0.3, 0, 3.8)), break_impulse=2.5),
    )  # fmt: skip
    blow = SetVelocity("sign", 0.5, (0.0, 3.0, 0.0))
    return (beam, lamp, cart, basket, arm, sign), joints, (blow,)


CASES = {"door": door, "swing": swing, "slide": slide, "hung": hung}


def built(name: str) -> tuple[SimScene, Program]:
    bodies, joints, commands = CASES[name]()
    return SimScene(name, bodies, joints=joints), Program(commands, 3.0)


@pytest.mark.parametrize("engine", ["physx", "rapier"])
@pytest.mark.parametrize("name", CASES)
def test_class_and_program_do_the_same(tmp_path: Path, name: str, engine: str) -> None:
    scene, program = built(name)
    replayed, rollout = both(tmp_path, scene, program, engine=engine)
    assert replayed.rollout.valid.all()
    moved = np.abs(rollout.position[0, -1] - rollout.position[0, 0]).max()
    assert moved > 0.1
    assert_same(replayed.rollout, rollout, tolerance_m=2e-5)


def test_the_class_describes_the_joints(tmp_path: Path) -> None:
    for name in CASES:
        scene, program = built(name)
        written(tmp_path / name, scene, program)
        told = replay_class(tmp_path / name, duration=0.1).scene.joints
        assert [j.kind for j in told] == [j.kind for j in scene.joints]
        for one, two in zip(told, scene.joints, strict=True):
            assert (one.child, one.parent, one.collide) == (two.child, two.parent, two.collide)
            np.testing.assert_allclose(one.child_anchor, two.child_anchor, atol=1e-9)
            if two.kind != "spring":
                np.testing.assert_allclose(one.stiffness, two.stiffness, rtol=1e-6)
                np.testing.assert_allclose(one.damping, two.damping, rtol=1e-6)
            if two.stiffness > 0.0 and two.kind == "hinge":
                np.testing.assert_allclose(
                    (one.lower, one.upper), (two.lower, two.upper), rtol=1e-6
                )
                np.testing.assert_allclose(one.parent_rotation, two.parent_rotation, atol=1e-9)
            assert (one.break_impulse is None) == (two.break_impulse is None)


def test_every_value_of_a_joint_is_a_property_that_the_constructor_sets() -> None:
    scene, program = built("door")
    made = emit_class(scene, program)
    for line in (
        "HingeJointSettings.Lower = -85.9436692696235;",
        "HingeJointSettings.Upper = 11.4591559026165;",
        "HingeJointSettings.Friction = 8000.0;",
        "HingeJointSettings.Stiffness = 60000.0;",
        "HingeJointSettings.bMotor = false;",
        "HingeJointSettings.bBreaks = false;",
        'HingeJointConstraint = CreateConstraint(TEXT("HingeJoint"));',
    ):
        assert line in made.source
    assert "TObjectPtr<UPhysicsConstraintComponent> HingeJointConstraint;" in made.header
    assert "F" + made.name + "Joint HingeJointSettings;" in made.header


def test_a_command_to_a_joint_is_logged_and_unknown_joints_are_refused(tmp_path: Path) -> None:
    scene, program = built("swing")
    written(tmp_path, scene, program)
    log = replay_class(tmp_path, duration=1.0).log
    assert sum("COMMAND DriveJoint joint=PivotJoint" in line for line in log) == 2
    with pytest.raises(ValueError, match="DriveJoint names unknown joint 'lid'"):
        emit_class(scene, Program((DriveJoint("lid", 0.0),), 1.0))


def test_joined_bodies_do_not_count_as_overlapping(tmp_path: Path) -> None:
    scene, program = built("door")
    (hinge,) = scene.joints
    leaf = replace(scene.bodies[1], position=(0.4, 0.0, 1.05))
    bodies = (scene.bodies[0], leaf, scene.bodies[2])
    for joints, overlaps in (((hinge,), 0), ((), 1)):
        folder = tmp_path / str(overlaps)
        moved = tuple(
            replace(j, child_anchor=tuple(np.add(j.child_anchor, (0.1, 0.0, 0.0)).tolist()))
            for j in joints
        )
        written(folder, replace(scene, bodies=bodies, joints=moved), program)
        log = replay_class(folder, duration=0.05).log
        assert any(f"LAYOUT overlaps={overlaps}" in line for line in log)


def test_classes_without_joints_say_nothing_of_them() -> None:
    bodies, _, _ = door()
    made = emit_class(SimScene("door", bodies), Program((), 1.0))
    assert "Joint" not in made.source + made.header and "Constraint" not in made.source


def test_a_constraint_that_is_no_joint_is_refused(tmp_path: Path) -> None:
    scene, program = built("swing")
    written(tmp_path, scene, program)
    (source,) = tmp_path.glob("unreal/*.cpp")
    text = source.read_text()
    assert "Held->SetLinearYLimit(Across, Reach);" in text
    source.write_text(text.replace("SetLinearYLimit(Across,", "SetLinearYLimit(LCM_Free,"))
    with pytest.raises(ReplayError, match="PivotJoint leaves free what no joint does"):
        replay_class(tmp_path, duration=0.1, trust=True)
