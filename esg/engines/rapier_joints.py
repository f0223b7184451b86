"""Joints of a Rapier world: its impulse joints, and the rules between steps.

Rapier moves bodies along the chord of their way in each of its parts of a step and then takes away
the velocity that its joints do not allow, and so a share of (w dt)^2 / 2 of the energy of what
swings at w. `Turning` gives that back.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
import math
from typing import Any

from esg.engines.executor import Touch
from esg.engines.joint_rules import (
    LARGEST,
    RIGID_DRIVE,
    Bodies,
    JointForces,
    JointRules,
    Masses,
    in_world,
    stop_range,
)
from esg.engines.joints import Joint
from esg.engines.scene import SimScene

Pose = Callable[[Any, Any, Any], Any]
PARTS = 16
"""Into which Rapier takes a step in scenes with joints (its solver iterations). What is left of the
loss is given back by `Turning`; of what joints hold up, more parts creep less."""
ROUNDS = 16
"""Of its solver within a part: an arm of 1 m that friction holds creeps by 1.5 degrees in 3 s with
1 and by 0.03 with 16."""
SLOW_RADPS = 0.3
"""What turns no faster loses too little to be counted: 1e-4 of its energy in 10 s."""
EVERY = 4
"""Steps for which it is given back at once."""
MOST_GAIN = 0.02
"""Share of its energy that anything is given back in a step, at most."""


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
        self._turning = Turning(scene, masses, self._rules.ends, dt / PARTS)
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
        self._turning.give_back(world, self._rules.gone)

    def after_step(self, world: Bodies, touches: Iterable[Touch]) -> None:
        """Takes away what has broken in the step; `touches` are the ground's as well."""
        for k in self._rules.after_step(world, touches):
            self._world.impulse_joints.remove(self._made[k])


class Turning:
    """Gives what turns about the world the energy that the parts of a step take away.

    With J the rows of velocities that the joints lock, taken where bodies of velocity v are after
    a part, J v is what the joints take from them there, and J v (J M^-1 J^T)^-1 J v / 2 the energy
    that goes with it. What is joined to nothing that stays where it is keeps its momentum.

    Args:
        scene: Its joints.
        masses: Of its bodies.
        ends: Child and parent of each joint, by index; -1 is the world.
        part: Of a step [s].
    """

    def __init__(
        self, scene: SimScene, masses: Masses, ends: list[tuple[int, int]], part: float
    ) -> None:
        self._forces, self._part = JointForces(scene, masses), part
        self._ends = {k: e for k, e in enumerate(ends) if not scene.joints[k].flexible}
        self._moves = {i for pair in ends for i in pair if i >= 0 and masses.inverse[i] > 0.0}
        self._gone: set[int] = set()
        self._steps = 0
        self._groups = self._grouped()

    def give_back(self, world: Bodies, gone: Iterable[int]) -> None:
        """Speeds up, before a step, what will lose energy in it; `gone` has broken."""
        if self._gone != set(gone):
            self._gone = set(gone)
            self._groups = self._grouped()
        self._steps += 1
        for joints, bodies in self._groups if self._steps % EVERY == 0 else ():
            speeds = {i: world.read(i)[2:] for i in bodies}
            if all(math.hypot(*w) < SLOW_RADPS for _, w in speeds.values()):
                continue
            lost, energy = self._forces.bent(joints, world, self._part)
            gain = min(EVERY * PARTS * lost, MOST_GAIN * energy)
            if not gain > 0.0:
                continue
            factor = math.sqrt(1.0 + gain / energy)
            for i, (v, w) in speeds.items():
                world.set_linear(i, (v[0] * factor, v[1] * factor, v[2] * factor))
                world.set_angular(i, (w[0] * factor, w[1] * factor, w[2] * factor))

    def _grouped(self) -> list[tuple[list[int], list[int]]]:
        """Joints and bodies of all that hangs together and is held by what does not move."""
        left = {k: ends for k, ends in self._ends.items() if k not in self._gone}
        out: list[tuple[list[int], list[int]]] = []
        while left:
            first = min(left)
            joints, bodies = {first}, set(left.pop(first)) & self._moves
            while more := [k for k, ends in left.items() if bodies & set(ends)]:
                for k in more:
                    joints.add(k)
                    bodies |= set(left.pop(k)) & self._moves
            if any(not self._moves >= set(self._ends[k]) for k in joints):
                out.append((sorted(joints), sorted(bodies)))
        return out


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
