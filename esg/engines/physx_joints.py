"""Joints of a PhysX world: D6 joints of SAPIEN, and the rules between steps."""

from __future__ import annotations

from collections.abc import Callable, Iterable
import math
from typing import Any

import numpy as np

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
from esg.units import quat_rotate

LEVER_M = 1.0
"""How far beside the anchor are the points that keep a joint from turning."""

Pose = Callable[[Any, Any], Any]


class PhysxJoints:
    """The joints of one world.

    Args:
        px: sapien.physx.
        pose: Makes a SAPIEN pose of a position and a quaternion (x, y, z, w).
        scene: Whose joints they are.
        components: PhysX components of its bodies, None for decals, shape [B].
        masses: Of its bodies.
        dt: The step [s].
    """

    def __init__(
        self,
        px: Any,
        pose: Pose,
        scene: SimScene,
        components: list[Any],
        masses: Masses,
        dt: float,
    ) -> None:
        self._rules, self._components = JointRules(scene, masses, dt), components
        self.motors = self._rules.motors
        self._made: list[list[Any]] = []
        for joint, (child, parent) in zip(scene.joints, self._rules.ends, strict=True):
            base = None if parent < 0 else components[parent]
            # A decal has no component; a pair that collides must not share a joint.
            if parent >= 0 and (base is None or (joint.collide and not joint.flexible)):
                joint, base = in_world(joint, masses, parent), None
            self._made.append(_make(px, pose, joint, components[child], base))

    def before_step(self, world: Bodies, parts: int) -> None:
        """Acts on the bodies before a step that is taken in parts, and sets the drives."""
        for k, (speed, force) in self._rules.before_step(world).items():
            kind = self._rules.joints[k].kind
            _drive(self._made[k][0], kind, speed, force * self._rules.dt / parts)

    def after_step(self, world: Bodies, touches: Iterable[Touch]) -> None:
        """Takes away what has broken in the step; `touches` are the ground's as well."""
        for k in self._rules.after_step(world, touches):
            child = self._components[self._rules.ends[k][0]]
            while self._made[k]:
                # PhysX forgets a joint, and lets its pair collide, when nothing holds it any more.
                child.entity.remove_component(self._made[k].pop())
            # Pairs that were filtered out are looked at again for what comes in anew.
            child.disable()
            child.enable()


def _make(px: Any, pose: Pose, joint: Joint, child: Any, parent: Any) -> list[Any]:
    """The D6 joints that make up a joint, the first of which it is driven by.

    SAPIEN's limits of the swing do nothing (3.0.3), so that a turn is locked by points apart: one
    that is further along X keeps Y and Z, one further along Y keeps Z. Bodies that share a D6 joint
    do not collide, so that one that holds nothing keeps the ends of a rope or spring from it.
    """
    if joint.flexible:
        return [] if joint.collide or parent is None else [_d6(px, child, parent)]
    kind = joint.kind
    at, turn = joint.parent_anchor, joint.parent_rotation
    points = [(0.0, 0.0, 0.0)]
    points += [] if kind == "ball" else [(LEVER_M, 0.0, 0.0)]
    points += [(0.0, LEVER_M, 0.0)] if kind in ("slider", "fixed") else []
    out: list[Any] = []
    for n, point in enumerate(points):
        made = _d6(px, child, parent)
        made.pose_in_parent = pose(_beside(at, turn, point), turn)
        made.pose_in_child = pose(
            _beside(joint.child_anchor, joint.child_rotation, point), joint.child_rotation
        )
        free = n > 0 or kind == "slider"
        made.set_limit_x(*(_FREE if free else _LOCKED))
        made.set_limit_y(*(_FREE if n == 2 else _LOCKED))
        made.set_limit_z(*_LOCKED)
        out.append(made)
    reach = stop_range(joint)
    if kind == "slider":
        out[0].set_limit_x(*(reach or _FREE))
    elif kind == "hinge" and reach is not None:
        out[0].set_limit_twist(*reach)
    return out


def _d6(px: Any, child: Any, parent: Any) -> Any:
    """A joint of two bodies that holds nothing; no parent is the world."""
    made = px.PhysxDriveComponent(child)
    if parent is not None:
        made.parent = parent
    for limit in (made.set_limit_x, made.set_limit_y, made.set_limit_z, made.set_limit_twist):
        limit(*_FREE)
    made.set_limit_cone(math.inf, math.inf)
    child.entity.add_component(made)
    return made


def _beside(anchor: Any, rotation: Any, point: Any) -> Any:
    return np.array(anchor) + quat_rotate(np.array(rotation), np.array(point))


_FREE, _LOCKED = (-math.inf, math.inf), (0.0, 0.0)


def _drive(made: Any, kind: str, speed: float, impulse: float) -> None:
    """Drives a joint to a speed; PhysX limits the impulse of a step."""
    most = min(impulse, LARGEST)
    stiff = RIGID_DRIVE if most > 0.0 else 0.0
    if kind == "slider":
        made.set_drive_property_x(0.0, stiff, most, "force")
        made.set_drive_velocity_target([speed, 0.0, 0.0], [0.0, 0.0, 0.0])
        return
    # Its sign is the parent's turn against the child.
    made.set_drive_velocity_target([0.0, 0.0, 0.0], [-speed, 0.0, 0.0])
    if kind == "ball":
        made.set_drive_property_slerp(0.0, stiff, most, "force")
    else:
        made.set_drive_property_twist(0.0, stiff, most, "force")
