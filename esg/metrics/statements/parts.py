"""Whether something is at an end, an edge or a corner of what it stands on."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.lexicon.parts import CORNER, EDGE, OTHER_END, SIDE, TOWARDS, kind_of, sides_of
from esg.metrics.replay import Floats, Replay
from esg.metrics.statements.place import mostly
from esg.metrics.statements.query import Kept, StatementQuery
from esg.metrics.support import bounds, local_position
from esg.thresholds import AT_PART_M, AT_PART_SHARE, OFF_MIDDLE_SHARE
from esg.units import quat_rotate


def at_part(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It is by the named part of the first target's top; "other end": not by that of the second."""
    hosts, part = q.target.bodies, q.statement.noun or ""
    if not hosts or hosts[0] == body:
        return Kept(False, reason=f"{q.goal} is no body with ends")
    samples = q.window.samples(replay)
    at, gap = _by_the_sides(replay, body, hosts[0], samples)
    half = np.array(replay.scene.bodies[hosts[0]].half_extents[:2])
    if sides_of(part):
        return _on_its_side(replay, q, body, samples)
    near = gap <= np.maximum(2.0 * AT_PART_SHARE * half, AT_PART_M)
    long = int(np.argmax(half))
    held: NDArray[np.bool_] = near[:, long]
    if part == CORNER:
        held = np.asarray(near.all(axis=1))
    elif part == EDGE:
        held = np.asarray(near.any(axis=1))
    elif part == OTHER_END:
        for other in hosts[1:]:
            there, _ = _by_the_sides(replay, other, hosts[0], samples)
            held = np.asarray(held & (at[:, long] * there[:, long] < 0.0))
    shown = gap[:, long]
    if part in (EDGE, CORNER):
        shown = gap.min(axis=1) if part == EDGE else gap.max(axis=1)
    return mostly(held, f"stay at the {part} of {q.goal}", gap_m=float(np.median(shown)))


def _on_its_side(replay: Replay, q: StatementQuery, body: int, samples: NDArray[np.int64]) -> Kept:
    """It is towards the viewer's left, right, front or back of the target, or by that edge."""
    part, host = q.statement.noun or "", q.target.bodies[0]
    held, gaps = np.ones(len(samples), bool), [0.0]
    for n, k in enumerate(samples):
        (low, high), (mine, end) = bounds(replay, host, int(k)), bounds(replay, body, int(k))
        for side in sides_of(part):
            way = np.array(TOWARDS[side])
            axis, half = int(np.argmax(np.abs(way))), 0.5 * (high - low)
            sign = way[axis]
            off = sign * (0.5 * (mine + end) - 0.5 * (low + high))[axis]
            gap = half[axis] - off - 0.5 * (end - mine)[axis]
            gaps.append(float(gap))
            limit = max(2.0 * AT_PART_SHARE * half[axis], AT_PART_M)
            there = gap <= limit if kind_of(part) != SIDE else off >= OFF_MIDDLE_SHARE * half[axis]
            held[n] &= bool(there)
    return mostly(held, f"stay at the {part} of {q.goal}", gap_m=max(gaps))


def _by_the_sides(
    replay: Replay, body: int, host: int, samples: NDArray[np.int64]
) -> tuple[Floats, Floats]:
    """Where a body is in the axes of another one, and how far its side is from that one's side.

    Returns:
        Both along x and y [m], shape [n, 2].
    """
    below, own = replay.scene.bodies[host], replay.scene.bodies[body]
    middle = np.array(below.origin_offset)
    at = (local_position(replay, body, host) - middle)[samples, :2]
    back = replay.quaternion[samples, host] * np.array([-1.0, -1.0, -1.0, 1.0])
    reach = np.zeros_like(at)
    for axis in range(3):
        side = np.zeros(3)
        side[axis] = own.half_extents[axis]
        turned = quat_rotate(back, quat_rotate(replay.quaternion[samples, body], side))
        reach += np.abs(turned[:, :2])
    return at, np.array(below.half_extents[:2]) - np.abs(at) - reach
