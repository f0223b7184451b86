"""Joints of a scene as Newton takes them: trees of links, ties and springs.

A hinge, slider, ball or fixed joint is a branch of a tree, which keeps it exactly. What is static
is part of the world. A rope is a tie: two points that stay within a length. So is the limit of a
ball joint, which keeps the tips of two unit vectors together. What closes a ring, or may break,
cannot be a branch: it is made of pairs of ties that keep two points together along a direction. A
spring is a force on two points.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.joints import GAP_M, Joint
from esg.outcomes import UserError
from esg.units import quat_inverse, quat_multiply, quat_rotate

Floats = NDArray[np.float64]
Poses = tuple[Floats, Floats]
"""Positions [m], shape [W, B, 3], and orientations (x, y, z, w), shape [W, B, 4], of all bodies."""

AXES = ("hinge", "slider")
"""Joints with one coordinate, which motors drive and what rubs holds."""


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
    """Two points of two bodies that stay together or within a length, or are drawn together.

    Args:
        joint: Number of the scene's joint.
        a, b: Parent and child; -1 for the world.
        point_a, point_b: In their body frames, or in the world [m].
        length: Greatest distance, or rest length of a spring [m].
        direction: Along which b's point may not be behind a's, in b's body frame; None for ropes.
    """

    joint: int
    a: int
    b: int
    point_a: Floats
    point_b: Floats
    length: float = 0.0
    direction: Floats | None = None


@dataclass(frozen=True)
class Trees:
    """All joints of a scene.

    Args:
        joints: All of them.
        trees: Links of each tree, parents first.
        ties: Ropes, cones, and what is in no tree, those of a joint one after the other.
        springs: Joints that pull.
        loose: Joints whose bodies turn against each other outside of trees.
        apart: Pairs of bodies that never touch each other.
        brittle: Joints that may break; till then their bodies do not touch unless they may.
    """

    joints: tuple[Joint, ...]
    trees: tuple[tuple[Link, ...], ...]
    ties: tuple[Tie, ...]
    springs: tuple[Tie, ...]
    loose: tuple[int, ...]
    apart: tuple[tuple[int, int], ...]
    brittle: tuple[int, ...]

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
        UserError: For what can neither be a branch of a tree nor be made of ties.
    """
    trees, rings = _grow(joints, ends, dynamic)
    brittle = [k for k, j in enumerate(joints) if j.break_impulse is not None]
    loose = sorted({*rings, *(k for k in brittle if not joints[k].flexible)})
    many = [joints[k] for k in loose if _more_than_ties(joints[k])]
    _refuse(many, "which closes a ring or may break, with a motor, limits or stiffness, or with "
            "what slows a slider down")  # fmt: skip
    _refuse([joints[k] for k in brittle if joints[k].kind == "spring"], "a spring that may break")
    named = list(zip(joints, ends, strict=True))
    return Trees(
        joints=joints,
        trees=trees,
        ties=tuple(t for k, (j, e) in enumerate(named) for t in _ties(k, j, e, k in loose)),
        springs=tuple(
            Tie(k, *e, np.array(j.parent_anchor), np.array(j.child_anchor), j.upper or 0.0)
            for k, (j, e) in enumerate(named)
            if j.kind == "spring"
        ),
        loose=tuple(loose),
        apart=tuple(
            e for k, (j, e) in enumerate(named) if not j.collide and e[0] >= 0 and k not in brittle
        ),
        brittle=tuple(brittle),
    )


def _refuse(joints: list[Joint], what: str) -> None:
    if joints:
        names = ", ".join(repr(j.name) for j in joints)
        raise UserError(f"/joints: Newton cannot simulate {names}, {what}; simulate in physx")


def _more_than_ties(joint: Joint) -> bool:
    """Whether it does what needs a coordinate."""
    if joint.motor is not None or joint.stiffness > 0.0 or joint.lower is not None:
        return True
    slows = joint.damping > 0.0 or joint.friction > 0.0
    return (joint.kind != "ball" and joint.upper is not None) or (joint.kind == "slider" and slows)


def _stiff_around(joints: tuple[Joint, ...], nodes: list[tuple[int, ...]]) -> dict[int, list[int]]:
    """The stiff joints of each body and of the world (-1); what needs a coordinate first."""
    around: dict[int, list[int]] = {}
    for k in sorted(range(len(joints)), key=lambda k: (not _more_than_ties(joints[k]), k)):
        stiff = not joints[k].flexible and joints[k].break_impulse is None
        if stiff and nodes[k] != (-1, -1):
            for end in nodes[k]:
                around.setdefault(end, []).append(k)
    return around


def _grow(
    joints: tuple[Joint, ...], ends: tuple[tuple[int, int], ...], dynamic: NDArray[np.bool_]
) -> tuple[tuple[tuple[Link, ...], ...], set[int]]:
    """Trees of stiff joints, on what does not move and floating ones, and what would close rings.

    What needs a coordinate comes before what does not, so that the latter closes a ring.
    """
    nodes = [tuple(b if b >= 0 and dynamic[b] else -1 for b in pair) for pair in ends]
    around = _stiff_around(joints, nodes)
    used: set[int] = set()
    rings: set[int] = set()
    seen = {-1}

    def grown(start: int, root: Link | None) -> tuple[Link, ...]:
        """What hangs on a body; on the world one tree only, the others are asked for again."""
        links, reached = [] if root is None else [root], [start]
        for at in reached:
            for k in around[at]:
                if k in used or (at == -1 and links):
                    continue
                used.add(k)
                along = at == nodes[k][0]
                there = nodes[k][1 if along else 0]
                if there in seen:
                    same = (joints[m] for m in used - {k} if ends[m] == ends[k])
                    more = _more_than_ties(joints[k])
                    if more or not any(_on_one_axis(joints[k], other) for other in same):
                        rings.add(k)
                    continue
                seen.add(there)
                record = joints[k] if along else turned_around(joints[k])
                links.append(Link(there, at, ends[k][0 if along else 1], k, record))
                reached.append(there)
        return tuple(links)

    trees: list[tuple[Link, ...]] = []
    while tree := grown(-1, None) if -1 in around else ():
        trees.append(tree)
    children = {nodes[k][1] for ks in around.values() for k in ks}
    for body in sorted(around, key=lambda b: (b in children, b)):
        if body not in seen:
            seen.add(body)
            trees.append(grown(body, Link(body, -1, -1, -1, None)))
    return tuple(trees), rings


def _on_one_axis(one: Joint, two: Joint) -> bool:
    """Whether two joints are hinges of the same bodies about one axis: either is enough."""
    if one.kind != "hinge" or two.kind != "hinge":
        return False
    axis, other = (quat_rotate(np.array(j.parent_rotation), np.eye(3)[0]) for j in (one, two))
    between = np.array(two.parent_anchor) - np.array(one.parent_anchor)
    off = max(float(np.abs(np.cross(axis, v)).max()) for v in (other, between))
    return off < GAP_M


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


def _ties(k: int, joint: Joint, ends: tuple[int, int], loose: bool) -> list[Tie]:
    start, end = np.array(joint.parent_anchor), np.array(joint.child_anchor)
    if joint.kind == "rope":
        return [Tie(k, *ends, start, end, joint.upper or 0.0)]
    given, own = (
        quat_rotate(np.tile(np.array(r), (3, 1)), np.eye(3))
        for r in (joint.parent_rotation, joint.child_rotation)
    )
    out: list[Tie] = []
    if loose:
        # Points further along X and Y keep it from turning; of a slider none is kept along X.
        kept = {"ball": ("xyz",), "hinge": ("xyz", "yz"), "slider": ("yz", "yz", "z"),
                "fixed": ("xyz", "yz", "z")}[joint.kind]  # fmt: skip
        for n, (shift, axes) in enumerate(zip((None, 0, 1), kept, strict=False)):
            there, here = (
                (start, end) if shift is None else (start + given[shift], end + own[shift])
            )
            basis = _basis(end, own[0]) if joint.kind == "ball" and n == 0 else own
            for axis in axes:
                along = basis["xyz".index(axis)]
                out += [Tie(k, *ends, there, here, direction=d) for d in (along, -along)]
    if joint.kind == "ball" and joint.upper is not None and joint.upper < math.pi:
        length = 2.0 * math.sin(0.5 * joint.upper)
        out.append(Tie(k, *ends, start + given[0], end + own[0], length))
    return out


def _basis(arm: Floats, other: Floats) -> Floats:
    """Three orthogonal directions, the first along an arm, so that they hardly disturb each other.

    Args:
        arm: From the centre of mass [m]; `other` serves where it is none.
        other: Unit vector.
    """
    first = arm if float(arm @ arm) > 1e-12 else other
    first = first / np.linalg.norm(first)
    second = np.cross(first, np.eye(3)[int(np.argmin(np.abs(first)))])
    second = second / np.linalg.norm(second)
    return np.array([first, second, np.cross(first, second)], float)


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
