"""Joints between bodies: one record for every engine, the emitted class and the manifest (SI).

A joint has a frame in each of its two bodies (`Joint.parent_*`, `Joint.child_*`). The X axis of
both is the joint's: a hinge turns about it, a slider moves along it, a ball joint limits the angle
between the two. The joint's position is 0 where the frames coincide, and positive for a turn of the
child by the right hand about the parent's X axis, or a shift along it. A rope and a spring join the
two anchors and know no axes. The pair does not collide unless `collide` says so.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
import math
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from esg.thresholds import OPEN_SHARE
from esg.units import quat_inverse, quat_multiply, quat_rotate

if TYPE_CHECKING:
    from esg.engines.scene import Body, SimScene

Floats = NDArray[np.float64]
Path = NDArray[np.float32] | Floats
"""As recordings keep positions and quaternions, or as computed."""
Pose = tuple[Floats, Floats]
"""Positions [m], shape [..., 3], and quaternions (x, y, z, w), shape [..., 4]."""
Vec = tuple[float, float, float]
Quat = tuple[float, float, float, float]
JointKind = Literal["hinge", "slider", "ball", "fixed", "rope", "spring"]

WORLD = ""
"""Parent of what is joined to the world itself."""
GAP_M = 1e-3
"""A scene may start with joints that are so far off."""


@dataclass(frozen=True)
class Motor:
    """What drives a hinge or slider: towards a speed, or, if `position` is given, a position.

    Args:
        speed: [rad/s or m/s]; with a position, the greatest on the way there, 0 for any.
        position: [rad or m].
        limit: Greatest torque or force [N m or N].
    """

    speed: float = 0.0
    position: float | None = None
    limit: float = math.inf


@dataclass(frozen=True)
class Joint:
    """One joint (module docstring).

    Args:
        name: Unique in the scene.
        kind: What it leaves free.
        child: Name of a body that moves.
        parent: Name of the other body, which may be static; `WORLD` for the world.
        parent_anchor: Where it is in the parent's body frame, or in the world [m], shape [3].
        child_anchor: Where it is in the child's body frame [m], shape [3].
        parent_rotation, child_rotation: Orientation (x, y, z, w) of its frame there, shape [4].
        lower, upper: Limits of its position: hinge [rad], slider [m], None where there is none. Of
            a ball joint `upper` is the largest angle between the axes [rad], of a rope its greatest
            length [m], of a spring its rest length [m]; those have no `lower`.
        stiffness: Of a spring [N/m]; of a hinge or slider that is drawn back to 0 [N m/rad, N/m].
        damping: Against its speed: hinge and ball [N m s/rad], slider and spring [N s/m].
        friction: Torque or force that holds it at rest and brakes it [N m or N].
        motor: What drives it; None: nothing.
        break_impulse: It is gone once it took more within `BREAK_WINDOW_S`
            (`esg.engines.joint_rules`) [N s]; None: never.
        collide: Whether the two bodies touch each other; of two that move, only the ends of a rope
            or spring can.
    """

    name: str
    kind: JointKind
    child: str
    parent: str = WORLD
    parent_anchor: Vec = (0.0, 0.0, 0.0)
    child_anchor: Vec = (0.0, 0.0, 0.0)
    parent_rotation: Quat = (0.0, 0.0, 0.0, 1.0)
    child_rotation: Quat = (0.0, 0.0, 0.0, 1.0)
    lower: float | None = None
    upper: float | None = None
    stiffness: float = 0.0
    damping: float = 0.0
    friction: float = 0.0
    motor: Motor | None = None
    break_impulse: float | None = None
    collide: bool = False

    @property
    def flexible(self) -> bool:
        """Whether it only joins two points: a rope, a spring."""
        return self.kind in ("rope", "spring")


@dataclass(frozen=True)
class JointState:
    """Where a joint is.

    Args:
        position: Hinge [rad], slider [m], ball joint: angle between the axes [rad], rope and
            spring: distance of the anchors [m], 0 for what is fixed.
        gap: How far its anchors are apart that should not be [m].
    """

    position: Floats
    gap: Floats


def joint_between(
    name: str,
    kind: JointKind,
    child: Body,
    parent: Body | None,
    *,
    at: Vec,
    axis: Vec = (1.0, 0.0, 0.0),
    parent_at: Vec | None = None,
    position: float = 0.0,
) -> Joint:
    """A joint of two bodies as they stand, told in the world's frame.

    Args:
        name, kind: Of the joint.
        child, parent: The bodies; no parent is the world.
        at: Anchor of the child, and of the parent unless it has its own [m], shape [3].
        axis: Its X axis, of any length but 0, shape [3].
        parent_at: Anchor of the parent, for ropes and springs [m], shape [3].
        position: That it has as the bodies stand [rad or m].
    """
    x = np.asarray(axis, float)
    x = x / np.linalg.norm(x)
    frame = _turn_x_to(x)
    start = np.asarray(at, float)
    q_child = np.asarray(child.quaternion, float)
    back = quat_inverse(q_child)
    there = np.asarray(at if parent_at is None else parent_at, float)
    zero = frame
    if kind == "hinge":
        half = -0.5 * position
        zero = quat_multiply(np.array([*(math.sin(half) * x), math.cos(half)]), frame)
    elif kind == "slider":
        there = there - position * x
    base = Joint(
        name,
        kind,
        child.name,
        child_anchor=_vec(quat_rotate(back, start - np.asarray(child.position, float))),
        child_rotation=_quat(quat_multiply(back, frame)),
    )
    if parent is None:
        return replace(base, parent_anchor=_vec(there), parent_rotation=_quat(zero))
    inverse = quat_inverse(np.asarray(parent.quaternion, float))
    return replace(
        base,
        parent=parent.name,
        parent_anchor=_vec(quat_rotate(inverse, there - np.asarray(parent.position, float))),
        parent_rotation=_quat(quat_multiply(inverse, zero)),
    )


def joint_poses(
    scene: SimScene, joint: Joint, position: Path | None = None, quaternion: Path | None = None
) -> tuple[Pose, Pose | None]:
    """Poses of the bodies of a joint, child and parent; no parent is the world.

    Args:
        scene: That has the joint.
        joint: Of it.
        position: Of all bodies [m], shape [..., B, 3]; None: as the scene starts.
        quaternion: Of all bodies (x, y, z, w), shape [..., B, 4]; None likewise.
    """

    def pose(name: str) -> Pose:
        if position is None or quaternion is None:
            body = scene.body(name)
            return np.asarray(body.position, float), np.asarray(body.quaternion, float)
        i = scene.index(name)
        return np.asarray(position[..., i, :], float), np.asarray(quaternion[..., i, :], float)

    return pose(joint.child), None if joint.parent == WORLD else pose(joint.parent)


def joint_ends(joint: Joint, child: Pose, parent: Pose | None) -> tuple[Floats, Floats]:
    """Where a joint takes hold of its parent and of its child, in the world [m], each [..., 3].

    Args:
        joint: Of the scene.
        child, parent: As those of `joint_state`.
    """
    end = child[0] + quat_rotate(child[1], np.asarray(joint.child_anchor))
    start = np.asarray(joint.parent_anchor, float)
    if parent is not None:
        start = parent[0] + quat_rotate(parent[1], start)
    return np.broadcast_to(start, end.shape), end


def start_position(scene: SimScene, joint: Joint) -> float:
    """Position of a joint as the scene starts [rad or m]."""
    return float(joint_state(joint, *joint_poses(scene, joint)).position)


def joint_state(joint: Joint, child: Pose, parent: Pose | None) -> JointState:
    """Where a joint is, from the poses of its bodies.

    Args:
        joint: Of the scene.
        child, parent: Positions [m], shape [..., 3], and quaternions (x, y, z, w), shape [..., 4];
            no parent is the world.
    """
    start, end = joint_ends(joint, child, parent)
    turned = quat_multiply(np.asarray(child[1], float), np.asarray(joint.child_rotation))
    frame = np.asarray(joint.parent_rotation, float)
    if parent is not None:
        frame = quat_multiply(np.asarray(parent[1], float), frame)
    frame = np.broadcast_to(frame, turned.shape)
    off = quat_rotate(quat_inverse(frame), end - start)
    length = np.linalg.norm(off, axis=-1)
    if joint.flexible:
        over = length - (joint.upper or 0.0) if joint.kind == "rope" else np.zeros_like(length)
        return JointState(length, np.maximum(over, 0.0))
    if joint.kind == "slider":
        return JointState(off[..., 0], np.linalg.norm(off[..., 1:], axis=-1))
    relative = quat_multiply(quat_inverse(frame), turned)
    if joint.kind == "hinge":
        angle = 2.0 * np.arctan2(relative[..., 0], relative[..., 3])
        return JointState((angle + np.pi) % (2.0 * np.pi) - np.pi, length)
    if joint.kind == "ball":
        x = quat_rotate(relative, np.array([1.0, 0.0, 0.0]))[..., 0]
        return JointState(np.arccos(np.clip(x, -1.0, 1.0)), length)
    return JointState(np.zeros_like(length), length)


def opening_asked(joint: Joint, half_extents: Vec, degrees: float) -> float:
    """How far a hinge or slider has to go for its child to count as open [rad or m].

    Args:
        joint: Of the scene.
        half_extents: Of its child [m], shape [3].
        degrees: That a hinge is asked for; a slider goes a share of its way, or of its length.
    """
    if joint.kind == "hinge":
        return math.radians(degrees)
    if joint.lower is not None and joint.upper is not None:
        return OPEN_SHARE * (joint.upper - joint.lower)
    return OPEN_SHARE * 2.0 * max(half_extents)


def joint_problems(scene: SimScene) -> list[str]:
    """Everything that is wrong with a scene's joints, each with its place, value and remedy."""
    bodies = {b.name: b for b in scene.bodies}
    pieces = {name for b in scene.bodies for name in b.fragments}
    whole = sorted(bodies.keys() - pieces)
    out: list[str] = []
    for i, joint in enumerate(scene.joints):
        place = f"/joints/{i}"
        if joint.name in [j.name for j in scene.joints[:i]]:
            out.append(f"{place}/name: {joint.name!r} is used twice; give each joint its own")
        missing = [
            f"{place}/{end}: no body {name!r}; bodies are {whole}"
            for end, name in (("child", joint.child), ("parent", joint.parent))
            if name not in bodies and (end, name) != ("parent", WORLD)
        ]
        out += missing or _problems(place, joint, scene)
    return out


def _problems(place: str, joint: Joint, scene: SimScene) -> list[str]:
    out: list[str] = []
    child = scene.body(joint.child)
    if joint.child == joint.parent:
        out.append(f"{place}/parent: {joint.child!r} is joined to itself; name another body")
        return out
    if child.static or not child.collides:
        out.append(f"{place}/child: {joint.child!r} cannot move; swap child and parent")
    lower, upper = joint.lower, joint.upper
    if joint.kind in ("rope", "spring", "ball"):
        if lower is not None:
            out.append(f"{place}/lower: a {joint.kind} has none, got {lower!r}; leave it out")
        if joint.kind != "ball" and not (upper is not None and upper >= 0.0):
            out.append(f"{place}/upper: a {joint.kind} needs its length [m], got {upper!r}")
    elif lower is not None and upper is not None and lower > upper:
        out.append(f"{place}/lower: {lower:g} is above upper, {upper:g}; swap them")
    if joint.motor is not None and joint.kind not in ("hinge", "slider"):
        out.append(f"{place}/motor: a {joint.kind} has none; leave it out")
    for end, limit in (("lower", lower), ("upper", upper)):
        if joint.kind == "hinge" and limit is not None and abs(limit) > math.pi:
            out.append(f"{place}/{end}: a hinge turns by pi at most either way, got {limit:g} rad")
    moves = joint.parent != WORLD and not scene.body(joint.parent).static
    if joint.collide and moves and not joint.flexible:
        out.append(f"{place}/collide: two moving bodies cannot, joined so; leave it out")
    state = joint_state(joint, *joint_poses(scene, joint))
    gap, position = float(state.gap), float(state.position)
    if gap > GAP_M:
        if joint.kind == "rope":
            out.append(
                f"{place}/upper: a rope of {upper:g} m between points {position:.3f} m apart; "
                "make it longer or move the bodies together"
            )
        else:
            out.append(
                f"{place}: its anchors are {gap:.3f} m apart at the start; move the bodies together"
            )
    return out


def _turn_x_to(x: Floats) -> Floats:
    """The smallest rotation (x, y, z, w) that takes X to a unit vector, shape [4]."""
    if x[0] < -1.0 + 1e-12:
        return np.array([0.0, 0.0, 1.0, 0.0])
    q = np.array([0.0, -x[2], x[1], 1.0 + x[0]])
    return q / np.linalg.norm(q)


def _vec(v: Floats) -> Vec:
    return float(v[0]), float(v[1]), float(v[2])


def _quat(q: Floats) -> Quat:
    return float(q[0]), float(q[1]), float(q[2]), float(q[3])
