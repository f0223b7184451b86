"""What a body touches and what carries it, over time.

Contacts come from the log, which may lack the ground; support is measured on the collision shapes.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.metrics.binding import Binding
from esg.metrics.detection import runs
from esg.metrics.events.space import is_over
from esg.metrics.geometry import Core, box_core, compound_distance
from esg.metrics.replay import Floats, Replay
from esg.thresholds import (
    AT_REST_MPS,
    CARRIED_M,
    FROM_BELOW,
    HIT_GAP_S,
    STOPPED_FOR_S,
)
from esg.units import quat_rotate

Bools = NDArray[np.bool_]
Frames = NDArray[np.int64]


def lowest_curve(replay: Replay, body: int) -> Floats:
    """Height of a body's lowest point over time, in the posture it has then [m], shape [T]."""
    inverse = replay.quaternion[:, body] * np.array([-1.0, -1.0, -1.0, 1.0])
    down = quat_rotate(inverse, np.array([0.0, 0.0, 1.0]))
    cores = replay.cores[body] or (box_core(replay.scene.bodies[body]),)
    low = [(down @ c.points.T).min(axis=1) - c.radius for c in cores]
    out = np.min(low, axis=0) + replay.position[:, body, 2]
    for name in replay.scene.bodies[body].postures:
        other = replay.scene.index(name)
        out = np.where(replay.absent[:, other], out, lowest_curve(replay, other))
    return out


def contact_times(replay: Replay, a: int, b: int | None = None) -> Floats:
    """Times at which the log has a body touch another one, or anything [s], sorted."""
    c = replay.contacts
    mine = (c.a == a) | (c.b == a)
    if b is not None:
        mine &= (c.a == b) | (c.b == b)
    return np.sort(c.time[mine & (c.impulse > 0)])


def in_contact(replay: Replay, a: int, b: int | None = None) -> Bools:
    """Frames within `HIT_GAP_S` of a contact in the log, shape [T]."""
    times = contact_times(replay, a, b)
    change = np.zeros(len(replay.time) + 1, int)
    np.add.at(change, np.searchsorted(replay.time, times - HIT_GAP_S), 1)
    np.add.at(change, np.searchsorted(replay.time, times + HIT_GAP_S, side="right"), -1)
    return np.cumsum(change)[:-1] > 0


def on_ground(replay: Replay, body: int) -> Bools:
    """Frames at which a body's lowest point is at the ground, shape [T]."""
    return lowest_curve(replay, body) <= CARRIED_M


def touching(replay: Replay, body: int) -> Bools:
    """Frames at which anything touches a body, shape [T].

    An engine may drop what rests from its log: who touched when he came to rest still does.
    """
    out = in_contact(replay, body) | on_ground(replay, body)
    rests = max(1, round(STOPPED_FOR_S / replay.frame_s))
    for start, stop in runs(replay.speed[:, body] < AT_REST_MPS):
        if stop - start >= rests and out[start : start + rests].any():
            out[start:stop] = True
    return out


def carried(replay: Replay, body: int, target: Binding, frames: Frames) -> Bools:
    """Whether any of a target carries a body, at some frames, shape [n].

    It carries what it touches, or nearly (`CARRIED_M`), from below.
    """
    out = np.zeros(len(frames), bool)
    ground = on_ground(replay, body)[frames]
    if target.ground:
        out |= ground
    for other in target.bodies:
        if other == body:
            continue
        if replay.cores[other]:
            out |= carried_by(replay, body, other, frames)
        else:
            # A marking lies on the ground: what stands on it stands on the ground within it.
            out |= ground & is_over(replay, body, other)[frames]
    for k in target.regions:
        parent = replay.scene.index(replay.scene.regions[k].parent)
        own = Binding(target.phrase, bodies=(parent,))
        out |= carried(replay, body, own, frames) & over_region(replay, body, k)[frames]
    return out


def carried_by(replay: Replay, body: int, other: int, frames: Frames) -> Bools:
    """Whether another body carries a body, at some frames, shape [n]."""
    near = _may_touch(replay, body, other, frames)
    out = np.zeros(len(frames), bool)
    before: bytes = b""
    for k in np.flatnonzero(near):
        pose = (
            replay.position[frames[k]][[body, other]],
            replay.quaternion[frames[k]][[body, other]],
        )
        now = np.round(np.concatenate([p.ravel() for p in pose]), 4).tobytes()
        # What rests is measured once.
        out[k] = out[k - 1] if now == before and k else _carries(replay, body, other, frames[k])
        before = now
    return out


def _may_touch(replay: Replay, a: int, b: int, frames: Frames) -> Bools:
    apart = np.linalg.norm(replay.position[frames, a] - replay.position[frames, b], axis=1)
    return apart <= replay.radii[a] + replay.radii[b] + CARRIED_M


def _carries(replay: Replay, body: int, other: int, frame: int) -> bool:
    mine, below = replay.placed_solid(body, frame), replay.placed(other, frame)
    gap = compound_distance(mine, below, cutoff=CARRIED_M)
    if gap > CARRIED_M:
        return False
    lower = tuple(Core(c.points - (0.0, 0.0, CARRIED_M), c.radius) for c in mine)
    sunk = compound_distance(lower, below, cutoff=CARRIED_M)
    return bool(gap - sunk >= FROM_BELOW * CARRIED_M)


def over_region(replay: Replay, body: int, region: int) -> Bools:
    """Frames at which a body's centre is within the outline of a region, shape [T]."""
    r = replay.scene.regions[region]
    local = local_position(replay, body, replay.scene.index(r.parent)) - np.array(r.center)
    return np.all(np.abs(local[:, :2]) <= np.array(r.half_extents[:2]), axis=1)


def local_position(replay: Replay, body: int, frame_of: int) -> Floats:
    """A body's centre in the axes of another one over time [m], shape [T, 3]."""
    inverse = replay.quaternion[:, frame_of] * np.array([-1.0, -1.0, -1.0, 1.0])
    return quat_rotate(inverse, replay.position[:, body] - replay.position[:, frame_of])


def bounds(replay: Replay, body: int, frame: int) -> tuple[Floats, Floats]:
    """Lowest and highest corner of a body in world axes [m], two [3]."""
    cores = replay.placed_solid(body, frame)
    low = np.min([c.points.min(axis=0) - c.radius for c in cores], axis=0)
    return low, np.max([c.points.max(axis=0) + c.radius for c in cores], axis=0)
