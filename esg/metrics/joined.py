"""What joints hold together in a replay, for how long, and where (`esg.engines.joints`)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from esg.engines.joints import WORLD, Joint, joint_ends, joint_poses, joint_state
from esg.metrics.replay import Floats, Replay
from esg.metrics.support import Bools
from esg.thresholds import PIECE_GAP_M


@dataclass(frozen=True)
class Joined:
    """A joint of a replay.

    Args:
        joint: Of the scene.
        child, parent: Indices of its bodies; a parent of -1 is the world.
        position: Over time: hinge [rad], turning on past half a turn; slider [m]; shape [T].
        intact: Whether it holds: its anchors have never been `PIECE_GAP_M` apart, shape [T].
    """

    joint: Joint
    child: int
    parent: int
    position: Floats
    intact: Bools

    @property
    def bodies(self) -> tuple[int, ...]:
        """Indices of the bodies that it holds, without the world."""
        return (self.child,) if self.parent < 0 else (self.child, self.parent)


def joined(replay: Replay) -> tuple[Joined, ...]:
    """All joints of a replay, in the order of the scene."""
    return tuple(_track(replay, joint) for joint in replay.scene.joints)


def _track(replay: Replay, joint: Joint) -> Joined:
    child = replay.scene.index(joint.child)
    parent = -1 if joint.parent == WORLD else replay.scene.index(joint.parent)
    poses = joint_poses(replay.scene, joint, replay.position, replay.quaternion)
    state = joint_state(joint, *poses)
    turned = np.unwrap(state.position) if joint.kind == "hinge" else state.position
    return Joined(joint, child, parent, turned, np.logical_and.accumulate(state.gap < PIECE_GAP_M))


def parts_of(joints: tuple[Joined, ...], body: int) -> list[Joined]:
    """What moves in a body: the joints that it hangs on, else those that hang on it."""
    return [j for j in joints if j.child == body] or [j for j in joints if j.parent == body]


def held(joints: tuple[Joined, ...], body: int, frames: int) -> Bools:
    """Frames at which any joint holds a body, shape [T] of `frames`."""
    out = np.zeros(frames, bool)
    for j in joints:
        if body in j.bodies:
            out |= j.intact
    return out


def chains(
    replay: Replay, joints: tuple[Joined, ...], a: int, b: int
) -> Iterator[tuple[Joined, ...]]:
    """The ways from one body to another over joints and bodies that can move, short ones first."""
    ways: list[tuple[tuple[int, ...], tuple[Joined, ...]]] = [((a,), ())]
    while ways:
        passed, way = ways.pop(0)
        at = passed[-1]
        if at == b and way:
            yield way
            continue
        if way and replay.scene.bodies[at].static:
            continue
        for j in joints:
            other = j.parent if at == j.child else j.child
            if at in j.bodies and other >= 0 and other not in passed:
                ways.append(((*passed, other), (*way, j)))


def hook(replay: Replay, j: Joined) -> Floats:
    """Where a joint takes hold of its parent, over time [m], shape [T, 3]."""
    poses = joint_poses(replay.scene, j.joint, replay.position, replay.quaternion)
    return joint_ends(j.joint, *poses)[0]


def together(replay: Replay, a: int, b: int) -> Bools:
    """Frames at which joints hold two bodies together, directly or over others, shape [T]."""
    out = np.zeros(len(replay.time), bool)
    for way in chains(replay, joined(replay), a, b):
        out |= np.logical_and.reduce([j.intact for j in way])
    return out


def apart_by_design(replay: Replay) -> frozenset[tuple[int, int]]:
    """Pairs (i < j) that do not touch because a joint holds them."""
    index = replay.scene.index
    pairs = [(index(j.child), index(j.parent)) for j in replay.scene.joints if _bars(j)]
    return frozenset((min(p), max(p)) for p in pairs)


def _bars(joint: Joint) -> bool:
    return joint.parent != WORLD and not joint.collide
