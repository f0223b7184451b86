"""Joints of a Rapier world: its impulse joints, and the rules between steps."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from esg.engines.executor import Touch
from esg.engines.joint_rules import (
    LARGEST,
    RIGID_DRIVE,
    Bodies,
    JointRules,
    Masses,
    in_world,
    stop_range,
)
from esg.engines.joints import Joint
from esg.engines.scene import SimScene

Pose = Callable[[Any, Any, Any], Any]


class RapierJoints:
    """The joints of one world.

    Args:
        r: The module rapier3d.
        pose: Makes an isometry of the module, a position and a quaternion (x, y, z, w).
        world: Rapier's world.
        scene: Whose joints they are.
        handles: Of its bodies, None for decals, shape [B].
        masses: Of its bodies.
        dt: The step [s].
    """

    def __init__(
        self,
        r: Any,
        pose: Pose,
        world: Any,
        scene: SimScene,
        handles: list[Any],
        masses: Masses,
        dt: float,
    ) -> None:
        self._r, self._world = r, world
        self._rules = JointRules(scene, masses, dt)
        still = world.add_body(r.RigidBody.fixed())
        self.motors = self._rules.motors
        self._made: list[Any] = []
        for joint, (child, parent) in zip(scene.joints, self._rules.ends, strict=True):
            base = still if parent < 0 else handles[parent]
            if base is None:
                # A decal has no body.
                joint, base = in_world(joint, masses, parent), still
            made = _make(r, pose, joint)
            self._made.append(world.impulse_joints.insert(base, handles[child], made))

    def before_step(self, world: Bodies) -> None:
        """Acts on the bodies before a step and sets the drives."""
        for k, (speed, force) in self._rules.before_step(world).items():
            made = self._world.impulse_joints[self._made[k]]
            data = made.data
            for axis in _driven(self._r, self._rules.joints[k].kind):
                data.set_motor_velocity(axis, speed, RIGID_DRIVE if force > 0.0 else 0.0)
                data.set_motor_max_force(axis, min(force, LARGEST))
            made.data = data

    def after_step(self, world: Bodies, touches: Iterable[Touch]) -> None:
        """Takes away what has broken in the step; `touches` are the ground's as well."""
        for k in self._rules.after_step(world, touches):
            self._world.impulse_joints.remove(self._made[k])


def _make(r: Any, pose: Pose, joint: Joint) -> Any:
    mask, axis = r.JointAxesMask, r.JointAxis
    locked = {
        "hinge": mask.LOCKED_REVOLUTE_AXES,
        "slider": mask.LOCKED_PRISMATIC_AXES,
        "ball": mask.LOCKED_SPHERICAL_AXES,
        "fixed": mask.LOCKED_FIXED_AXES,
    }.get(joint.kind)
    made = r.GenericJointBuilder() if locked is None else r.GenericJointBuilder(locked)
    made = made.local_frame1(pose(r, joint.parent_anchor, joint.parent_rotation))
    made = made.local_frame2(pose(r, joint.child_anchor, joint.child_rotation))
    made = made.contacts_enabled(joint.collide)
    if joint.kind in ("hinge", "slider") and (reach := stop_range(joint)) is not None:
        made = made.limits(axis.ANG_X if joint.kind == "hinge" else axis.LIN_X, *reach)
    for driven in _driven(r, joint.kind):
        made = made.motor_model(driven, r.MotorModel.FORCE_BASED)
    return made.build()


def _driven(r: Any, kind: str) -> tuple[Any, ...]:
    axis = r.JointAxis
    return {
        "hinge": (axis.ANG_X,),
        "slider": (axis.LIN_X,),
        "ball": (axis.ANG_X, axis.ANG_Y, axis.ANG_Z),
    }.get(kind, ())
