"""Joints of a scene as Newton takes them: trees of links, and ties that only keep a length.

A hinge, slider, ball or fixed joint is a branch of a tree, which keeps it exactly. What is static
is part of the world. A rope is a tie: two points that stay within a length. So is the limit of a
ball joint, which keeps the tips of two unit vectors together. A spring is a force on two points.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.joints import Joint
from esg.units import quat_inverse, quat_multiply, quat_rotate

Floats = NDArray[np.float64]
Poses = tuple[Floats, Floats]
"""Positions [m], shape [W, B, 3], and orientations (x, y, z, w), shape [W, B, 4], of all bodies."""

AXES = ("hinge", "slider")
"""Joints with one coordinate, which motors drive and what rubs holds."""
_X = (1.0, 0.0, 0.0)


@dataclass(frozen=True)
class Link:
    """A body of a tree and how it hangs on its parent.

    Args:
        child: Body.
        parent: Body that moves, -1 for the world and what is static.
        base: Body whose frame its parent anchor is in, -1 for the world.
        joint: Number of the scene's joint, -1 for the root of a tree that floats.
        record: The joint, turned around where the tree comes from its child; None for such a root.
    """

    child: int
    parent: int
    base: int
    joint: int
    record: Joint | None


@dataclass(frozen=True)
class Tie:
    """Two points of two bodies that stay within a length, or are drawn together.

    Args:
        joint: Number of the scene's joint.
        a, b: Parent and child; -1 for the world.
        point_a, point_b: In their body frames, or in the world [m].
        length: Greatest distance, or rest length of a spring [m].
        stiffness, damping: Of a spring [N/m, N s/m]; 0 and 0 for what only holds.
        break_impulse: [N s]; infinite if it never breaks.
    """

    joint: int
    a: int
    b: int
    point_a: Floats
    point_b: Floats
    length: float
    stiffness: float = 0.0
    damping: float = 0.0
    break_impulse: float = math.inf


@dataclass(frozen=True)
class Trees:
    """All joints of a scene.

    Args:
        trees: Links of each tree, parents first.
        ties: What keeps a length.
        springs: What pulls.
        apart: Pairs of bodies that do not touch each other, -1 for none.
    """

    trees: tuple[tuple[Link, ...], ...]
    ties: tuple[Tie, ...]
    springs: tuple[Tie, ...]
    apart: tuple[tuple[int, int], ...]

    @property
    def links(self) -> list[Link]:
        return [link for tree in self.trees for link in tree]

    @property
    def tied(self) -> list[int]:
        """Bodies with ties, sorted."""
        return sorted({b for t in self.ties for b in (t.a, t.b) if b >= 0})


def plan_trees(
    joints: tuple[Joint, ...], ends: tuple[tuple[int, int], ...], dynamic: NDArray[np.bool_]
) -> Trees:
    """What Newton makes of joints.

    Args:
        joints: Of the scene.
        ends: Body of each one's parent, -1 for the world, and of its child.
        dynamic: Bodies that move, shape [B].

    Raises:
        ValueError: For a ring of joints, and for a joint other than a rope that may break.
    """
    brittle = [j.name for j in joints if j.kind != "rope" and j.break_impulse is not None]
    if brittle:
        raise ValueError(
            f"Newton cannot break {', '.join(map(repr, brittle))}: a joint of its trees stays; "
            "leave out break_impulse, use a rope, or simulate in physx"
        )
    return Trees(
        trees=_grow(joints, ends, dynamic),
        ties=tuple(
            tie for k, (j, pair) in enumerate(zip(joints, ends, strict=True))
            for tie in _ties(k, j, pair)
        ),
        springs=tuple(
            Tie(k, *pair, np.array(j.parent_anchor), np.array(j.child_anchor), j.upper or 0.0,
                j.stiffness, j.damping)
            for k, (j, pair) in enumerate(zip(joints, ends, strict=True))
            if j.kind == "spring"
        ),
        apart=tuple(
            pair for pair, j in zip(ends, joints, strict=True) if not j.collide and pair[0] >= 0
        ),
    )  # fmt: skip


def _grow(
    joints: tuple[Joint, ...], ends: tuple[tuple[int, int], ...], dynamic: NDArray[np.bool_]
) -> tuple[tuple[Link, ...], ...]:
    """Trees of stiff joints: those that hang on what does not move, then those that float."""
    around: dict[int, list[int]] = {}
    nodes = [tuple(b if b >= 0 and dynamic[b] else -1 for b in pair) for pair in ends]
    for k, pair in enumerate(nodes):
        if not joints[k].flexible and pair != (-1, -1):
            for end in pair:
                around.setdefault(end, []).append(k)
    used: set[int] = set()
    seen = {-1}

    def link(k: int, at: int) -> Link:
        used.add(k)
        parent, child = nodes[k]
        along = at == parent
        there = child if along else parent
        if there in seen:
            raise ValueError(
                f"Newton cannot close the ring that {joints[k].name!r} makes with other joints of "
                f"{joints[k].child!r}; leave one of them out, or simulate in physx"
            )
        seen.add(there)
        record = joints[k] if along else turned_around(joints[k])
        return Link(there, at, ends[k][0 if along else 1], k, record)

    def grown(root: Link) -> tuple[Link, ...]:
        links = [root]
        for last in links:
            links += [link(k, last.child) for k in around[last.child] if k not in used]
        return tuple(links)

    trees: list[tuple[Link, ...]] = []
    for k in around.get(-1, ()):
        if k not in used:
            trees.append(grown(link(k, -1)))
    children = {nodes[k][1] for ks in around.values() for k in ks}
    for body in sorted(around, key=lambda b: (b in children, b)):
        if body not in seen:
            seen.add(body)
            trees.append(grown(Link(body, -1, -1, -1, None)))
    return tuple(trees)


def drives(joint: Joint) -> bool:
    """Whether the solver has to keep an axis at a speed: a motor's, or none where it rubs."""
    return joint.kind in AXES and (joint.motor is not None or joint.friction > 0.0)


def turned_around(joint: Joint) -> Joint:
    """The same joint seen from its child: positions of hinges and sliders change their sign."""
    motor = joint.motor
    if motor is not None:
        motor = replace(
            motor,
            speed=-motor.speed if motor.position is None else motor.speed,
            position=None if motor.position is None else -motor.position,
        )
    lower, upper = joint.lower, joint.upper
    if joint.kind in AXES:
        lower, upper = (None if v is None else -v for v in (upper, lower))
    return replace(
        joint,
        child=joint.parent,
        parent=joint.child,
        parent_anchor=joint.child_anchor,
        child_anchor=joint.parent_anchor,
        parent_rotation=joint.child_rotation,
        child_rotation=joint.parent_rotation,
        lower=lower,
        upper=upper,
        motor=motor,
    )


def _ties(k: int, joint: Joint, ends: tuple[int, int]) -> list[Tie]:
    start, end = np.array(joint.parent_anchor), np.array(joint.child_anchor)
    broken = math.inf if joint.break_impulse is None else joint.break_impulse
    if joint.kind == "rope":
        return [Tie(k, *ends, start, end, joint.upper or 0.0, break_impulse=broken)]
    if joint.kind == "ball" and joint.upper is not None and joint.upper < math.pi:
        tip = quat_rotate(np.array(joint.parent_rotation), np.array(_X))
        other = quat_rotate(np.array(joint.child_rotation), np.array(_X))
        return [Tie(k, *ends, start + tip, end + other, 2.0 * math.sin(0.5 * joint.upper))]
    return []


# -- coordinates -----------------------------------------------------------------------------------


def in_world(poses: Poses, body: int, point: Floats) -> Floats:
    """Where a point of a body is in every world [m], shape [W, 3]; of body -1 the point itself."""
    position, quaternion = poses
    if body < 0:
        return np.broadcast_to(point, (len(position), 3))
    arm = np.broadcast_to(point, (len(position), 3))
    return position[:, body] + quat_rotate(quaternion[:, body], arm)


def turned(poses: Poses, body: int, rotation: Floats) -> Floats:
    """Orientation of a frame of a body in every world, shape [W, 4]."""
    n = len(poses[1])
    if body < 0:
        return np.broadcast_to(rotation, (n, 4))
    return quat_multiply(poses[1][:, body], np.broadcast_to(rotation, (n, 4)))


def anchored(link: Link, poses: Poses) -> Floats:
    """The frame that a link's coordinates are told in, in every world, shape [W, 7]."""
    record, n = link.record, len(poses[0])
    if record is None:
        return np.broadcast_to(np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]), (n, 7))
    at = in_world(poses, link.base, np.array(record.parent_anchor))
    frame = turned(poses, link.base, np.array(record.parent_rotation))
    return np.concatenate([at, frame], axis=1)


def coordinates(link: Link, poses: Poses) -> Floats:
    """Newton's coordinates of a link in every world, shape [W, C]."""
    record = link.record
    if record is None:
        return np.concatenate([poses[0][:, link.child], poses[1][:, link.child]], axis=1)
    frame = anchored(link, poses)
    end = in_world(poses, link.child, np.array(record.child_anchor))
    rotation = turned(poses, link.child, np.array(record.child_rotation))
    back = quat_inverse(frame[:, 3:])
    off = quat_rotate(back, end - frame[:, :3])
    return _COORDINATES[record.kind](off, quat_multiply(back, rotation))


def _angle(q: Floats) -> Floats:
    angle = 2.0 * np.arctan2(q[:, :1], q[:, 3:])
    return (angle + np.pi) % (2.0 * np.pi) - np.pi


_COORDINATES: dict[str, Callable[[Floats, Floats], Floats]] = {
    "hinge": lambda _, q: _angle(q),
    "slider": lambda off, _: off[:, :1],
    "ball": lambda _, q: q,
    "fixed": lambda _, q: q[:, :0],
}
