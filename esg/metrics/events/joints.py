"""Events of jointed and breakable things: opens, closes, swings, breaks, separates.

Where a scene has joints they say what opens and what is attached. Of things without any, what turns
or slides in its place is taken for jointed, what touches at first for attached.
"""

from __future__ import annotations

from collections.abc import Iterator
import itertools

import numpy as np

from esg.engines.joints import opening_asked
from esg.metrics.binding import Binding
from esg.metrics.detection import Found, Query
from esg.metrics.events.space import surface_distance
from esg.metrics.geometry import compound_distance
from esg.metrics.joined import Joined, held, joined, parts_of, together
from esg.metrics.replay import GROUND_INDEX, Floats, Replay
from esg.metrics.support import Bools, Frames, touching
from esg.thresholds import (
    AT_REST_MPS,
    CARRIED_M,
    OPEN_SHARE,
    PIECE_GAP_M,
    PIECES,
    SAMPLE_S,
    SHUT_SHARE,
    STOPPED_MPS,
)
from esg.units import quat_rotate

_STRAIGHT_DEG = 10.0
"""What slides turns by less."""
_DIP_M = 0.005
"""A lowest point is passed by at least so much on either side."""


def opens(replay: Replay, q: Query) -> Iterator[Found]:
    """Turning or sliding away from where it was."""
    yield from _turns_open(replay, q, settled=False)


def closes(replay: Replay, q: Query) -> Iterator[Found]:
    """Turning or sliding to where it stays."""
    yield from _turns_open(replay, q, settled=True)


def _turns_open(replay: Replay, q: Query, *, settled: bool) -> Iterator[Found]:
    begin = min(replay.after(q.since), len(replay.time) - 1)
    joints = joined(replay)
    for i in q.bound["object"].bodies:
        moving = [j for j in parts_of(joints, i) if j.joint.kind in ("hinge", "slider")]
        if moving:
            yield from (_jointed(replay, q, j, begin, settled=settled) for j in moving)
            continue
        angle, slid, stays = _opening(replay, i, begin)
        enough = (
            (angle >= q.event.degrees) | (slid >= OPEN_SHARE) & (angle < _STRAIGHT_DEG)
        ) & stays
        if settled:
            enough &= np.abs(np.gradient(angle, replay.time)) < 5.0
            enough &= replay.speed[:, i] < AT_REST_MPS
        frames = np.flatnonzero(enough[begin:])
        if len(frames):
            k = begin + int(frames[0])
            measured = {"turned_deg": float(angle[k]), "slid_share": float(slid[k])}
            yield Found(float(replay.time[k]), (i,), measured=measured)
            continue
        most = float(angle[begin:].max(initial=0.0))
        name = replay.scene.bodies[i].name
        reason = f"{name} turns by {most:.0f} degrees, {q.event.degrees:.0f} asked"
        if replay.scene.bodies[i].static:
            reason = f"{name} is fixed"
        elif not stays[begin:].all():
            reason = f"{name} leaves its place, and is no jointed part"
        elif settled and most >= q.event.degrees:
            reason = f"{name} never comes to rest"
        yield Found(None, (i,), reason)


def _jointed(replay: Replay, q: Query, j: Joined, begin: int, *, settled: bool) -> Found:
    """Opening or closing of a jointed part: its joint's position is 0 where it is closed."""
    joint, name = j.joint, j.joint.child
    hinge = joint.kind == "hinge"
    asked = opening_asked(joint, replay.scene.bodies[j.child].half_extents, q.event.degrees)
    open_by = np.where(j.intact, np.abs(j.position), 0.0)[begin:]
    unit, factor = ("degrees", np.degrees(1.0)) if hinge else ("cm", 100.0)
    if settled:
        shut = (open_by <= SHUT_SHARE * asked) & (replay.speed[begin:, j.child] < AT_REST_MPS)
        done = shut & (np.maximum.accumulate(open_by) - open_by >= asked - SHUT_SHARE * asked)
    else:
        done = open_by >= asked if open_by[0] < asked else open_by >= open_by[0] + asked
    most, least = factor * float(open_by.max()), factor * float(open_by.min())
    measured = {"opened_deg": most} if hinge else {"opened_m": float(open_by.max())}
    frames = np.flatnonzero(done)
    if len(frames):
        return Found(float(replay.time[begin + int(frames[0])]), (j.child,), measured=measured)
    reason = f"{name} opens to {most:.0f} {unit}, {factor * asked:.0f} asked"
    if settled and most >= factor * asked:
        reason = f"{name} closes to {least:.0f} {unit}, and does not rest closed"
    elif settled:
        reason = f"{name} was open by {most:.0f} {unit} at most, {factor * asked:.0f} asked"
    return Found(None, (j.child,), reason, measured)


def _opening(replay: Replay, body: int, begin: int) -> tuple[Floats, Floats, Bools]:
    """From a frame on: angle turned [degrees], share of its own length slid, and whether it is
    still in its place, each [T].
    """
    begin = min(begin, len(replay.time) - 1)
    q, p = replay.quaternion[:, body], replay.position[:, body]
    angle = np.degrees(2.0 * np.arccos(np.clip(np.abs(q @ q[begin]), 0.0, 1.0)))
    half = np.array(replay.scene.bodies[body].half_extents)
    shift = quat_rotate(q[begin] * np.array([-1.0, -1.0, -1.0, 1.0]), p - p[begin])
    slid = (np.abs(shift) / (2.0 * half)).max(axis=1)
    stays = np.linalg.norm(p - p[begin], axis=1) <= 2.0 * float(half.max())
    return angle, slid, stays


def swings(replay: Replay, q: Query) -> Iterator[Found]:
    """Passing the lowest point of its suspension, or of its way in the air, as often as asked."""
    begin = replay.after(q.since)
    joints = joined(replay)
    for i in q.bound["object"].bodies:
        free = ~touching(replay, i) | held(joints, i, len(replay.time))
        low = _dips(replay.position[:, i, 2])
        # What bobs on a spring turns round where it is lowest.
        bobs = any(j.joint.kind == "spring" and i in j.bodies for j in joints)
        moves = bobs | (replay.speed[:, i] > STOPPED_MPS)
        passes = [k for k in low if k >= begin and free[k] and moves[k]]
        if len(passes) >= q.event.times:
            k = passes[q.event.times - 1]
            yield Found(float(replay.time[k]), (i,), measured={"times": float(len(passes))})
        else:
            reason = f"passes its lowest point {len(passes)} times, {q.event.times} asked"
            yield Found(None, (i,), reason)


def _dips(height: Floats) -> list[int]:
    """Frames at which a height [T] is lowest between two that are higher by `_DIP_M`."""
    out: list[int] = []
    lowest, top, armed = 0, float(height[0]), False
    for k, z in enumerate(height.tolist()):
        if armed and z >= height[lowest] + _DIP_M:
            out.append(lowest)
            top, armed = z, False
        top = max(top, z)
        if z <= top - _DIP_M and (not armed or z < height[lowest]):
            lowest, armed = k, True
    return out


def _sampled(replay: Replay, begin: int) -> Frames:
    step = max(1, round(SAMPLE_S / replay.frame_s))
    return np.unique(np.append(np.arange(begin, len(replay.time), step), len(replay.time) - 1))


def breaks(replay: Replay, q: Query) -> Iterator[Found]:
    """Coming apart into pieces: fragments of what the phrase means, or bodies of its group."""
    begin = replay.after(q.since)
    scene, phrase = replay.scene, q.bound["object"].phrase
    wholes = [i for i in q.bound["object"].bodies if scene.bodies[i].fragments]
    for i in wholes:
        parts = tuple(scene.index(name) for name in scene.bodies[i].fragments)
        yield _apart(replay, parts, begin, (i,))
    if wholes:
        return
    groups = {scene.bodies[i].group for i in q.bound["object"].bodies} - {""}
    own = {i for i, b in enumerate(scene.bodies) if b.group in groups}
    parts = tuple(sorted(own | set(q.bound["object"].bodies)))
    if len(parts) < PIECES:
        yield Found(None, parts, f"{phrase!r} is in one piece that cannot break")
    elif _pieces(replay, parts, 0) >= PIECES:
        yield Found(None, parts, "is in pieces from the start")
    else:
        yield _apart(replay, parts, begin, parts)


def _apart(replay: Replay, parts: tuple[int, ...], begin: int, who: tuple[int, ...]) -> Found:
    """When parts that are there are first in enough pieces."""
    most = 0
    for k in _sampled(replay, begin):
        here = () if replay.absent[k, list(parts)].any() else parts
        most = max(most, n := _pieces(replay, here, int(k)))
        if n >= PIECES:
            return Found(float(replay.time[k]), who, measured={"pieces": float(n)})
    reason = f"is in {most} pieces at most (needs {PIECES})"
    if most == 0 and replay.absent[-1, list(parts)].any():
        reason = f"stays whole: no blow exceeds {_bears(replay, who[0]):.3g} N s"
    return Found(None, who, reason)


def _bears(replay: Replay, body: int) -> float:
    return replay.scene.bodies[body].break_impulse or 0.0


def _pieces(replay: Replay, parts: tuple[int, ...], frame: int) -> int:
    """Number of groups of bodies that are `PIECE_GAP_M` apart from all others."""
    label = {i: i for i in parts}
    placed = {i: replay.placed_solid(i, frame) for i in parts}
    for i, j in itertools.combinations(parts, 2):
        if compound_distance(placed[i], placed[j], cutoff=PIECE_GAP_M) < PIECE_GAP_M:
            old = label[j]
            for k in parts:
                label[k] = label[i] if label[k] == old else label[k]
    return len(set(label.values()))


def separates(replay: Replay, q: Query) -> Iterator[Found]:
    """Two that a joint held together, or that touched, are apart."""
    begin = min(replay.after(q.since), len(replay.time) - 1)
    for i in q.bound["a"].bodies:
        for j in (j for j in q.bound["b"].bodies if j != i):
            attached = together(replay, i, j)
            if attached[max(begin - 1, 0)]:
                loose = np.flatnonzero(~attached[begin:])
                when = float(replay.time[begin + int(loose[0])]) if len(loose) else None
                yield Found(when, (i, j), "" if len(loose) else "stay together")
                continue
            other = Binding("", bodies=(j,))
            gap = surface_distance(replay, i, other, max(begin - 1, 0))
            if gap > CARRIED_M:
                yield Found(None, (i, j), f"are {100 * gap:.0f} cm apart before")
                continue
            for k in _sampled(replay, begin):
                gap = surface_distance(replay, i, other, int(k))
                if gap > PIECE_GAP_M:
                    yield Found(float(replay.time[k]), (i, j), measured={"gap_m": gap})
                    break
            else:
                yield Found(None, (i, j), "stay together")
        if q.bound["b"].ground:
            yield Found(None, (i, GROUND_INDEX), "nothing is attached to the ground")
