"""Events of things handled and springing: bounces, picked_up, placed, jumps, spins."""

from __future__ import annotations

from collections.abc import Iterator
import math

import numpy as np

from esg.engines.program import Moving
from esg.metrics.binding import Binding
from esg.metrics.detection import Found, Query, duration_of, runs
from esg.metrics.events.space import inside_volume, is_over, volumes
from esg.metrics.joined import Joined, joined, parts_of
from esg.metrics.replay import Floats, Hit, Replay
from esg.metrics.support import Bools, carried, lowest_curve, touching
from esg.thresholds import (
    AT_REST_MPS,
    BALLISTIC,
    BOUNCE_MPS,
    IMPULSE_WINDOW_S,
    JUMP_OWN_S,
    JUMP_SHARE,
    MOMENT_S,
    MOST,
    PICKED_M,
    PICKED_SHARE,
    SAMPLE_S,
    STILL_M,
    STOPPED_FOR_S,
    STOPPED_MPS,
)

_REACH_M = 0.02
"""How far above the ground a recorded bounce may turn, besides the way of one frame."""


def bounces(replay: Replay, q: Query) -> Iterator[Found]:
    """Hitting the target and leaving it at over `BOUNCE_MPS`, as often as asked."""
    target = q.bound["target"]
    for i in q.bound["object"].bodies:
        times = [t for j in target.bodies if j != i for t in _off_body(replay, i, j)]
        if target.ground:
            times += _off_ground(replay, i)
        since = -math.inf if q.since is None else q.since
        # A phrase may mean the ground and what is painted on it.
        times = sorted({t for t in times if t > since})
        if len(times) >= q.event.times:
            yield Found(times[q.event.times - 1], (i,), measured={"times": float(len(times))})
        else:
            asked = f"{q.event.times} asked"
            yield Found(None, (i,), f"bounces off {target.phrase!r} {len(times)} times, {asked}")


def _off_ground(replay: Replay, body: int, within: Bools | None = None) -> list[float]:
    """Times at which a body leaves the ground after coming down on it [s]."""
    low = lowest_curve(replay, body)
    vz = replay.velocity[:, body, 2]
    out: list[float] = []
    for start, _ in runs(vz > BOUNCE_MPS):
        back = slice(replay.frame_at(float(replay.time[start]) - MOMENT_S), start + 1)
        fall = -float(vz[back].min())
        met = float(low[back].min()) <= _REACH_M + fall * replay.frame_s
        if fall > 0 and met and (within is None or within[start]):
            out.append(float(replay.time[start]))
    return out


def _off_body(replay: Replay, body: int, other: int) -> list[float]:
    """Times at which a body leaves another one after hitting it [s]."""
    if not replay.cores[other]:
        return _off_ground(replay, body, is_over(replay, body, other))
    out: list[float] = []
    relative = replay.velocity[:, body] - replay.velocity[:, other]
    for hit in replay.hits(body, other):
        before = replay.frame_before(hit.time)
        after = slice(replay.after(hit.time), replay.frame_at(hit.time + MOMENT_S) + 1)
        away = relative @ _normal(replay, hit, relative)
        fast = np.flatnonzero(away[after] > BOUNCE_MPS)
        if away[before] < 0 and len(fast):
            out.append(float(replay.time[after][fast[0]]))
    return out


def _normal(replay: Replay, hit: Hit, relative: Floats) -> Floats:
    """Which way a hit pushes its first body: by the log, else by what it did to its velocity."""
    c = replay.contacts
    rows = ((c.a == hit.a) & (c.b == hit.b)) | ((c.a == hit.b) & (c.b == hit.a))
    rows &= (c.time >= hit.time) & (c.time <= hit.time + IMPULSE_WINDOW_S)
    # The log's normals lead from b to a.
    sign = np.where(c.a[rows] == hit.a, 1.0, -1.0)
    normal = (c.normal[rows] * (sign * c.impulse[rows])[:, None]).sum(axis=0)
    if not np.linalg.norm(normal):
        end = replay.frame_at(hit.time + MOMENT_S)
        normal = relative[end] - relative[replay.frame_before(hit.time)]
    return normal / max(float(np.linalg.norm(normal)), 1e-12)


def picked_up(replay: Replay, q: Query) -> Iterator[Found]:
    """Rising off what carries it, held."""
    begin = replay.after(q.since)
    g = abs(replay.scene.gravity[2])
    step = max(1, round(MOMENT_S / replay.frame_s))
    fixed = tuple(j for j, b in enumerate(replay.scene.bodies) if b.static and b.collides)
    for i in q.bound["object"].bodies:
        z = replay.position[:, i, 2]
        gained = np.diff(replay.velocity[:, i, 2]) / np.diff(replay.time)
        rise = z[begin:] - np.minimum.accumulate(z[begin:])
        need = min(PICKED_M, PICKED_SHARE * 2.0 * replay.scene.bodies[i].half_extents[2])
        high = begin + np.flatnonzero(rise >= need)
        below = Binding("", bodies=fixed + _carriers(replay, i, begin), ground=True)
        reason = f"rises by {100 * float(rise.max(initial=0.0)):.0f} cm (needs {100 * need:.0f} cm)"
        for k in high[::step]:
            held = gained[k : k + step] > -BALLISTIC * g
            if not held.any() or held.mean() < MOST:
                reason = "flies up, and is not held"
            elif carried(replay, i, below, np.array([k]))[0]:
                reason = "rises with what carries it"
            else:
                yield Found(float(replay.time[k]), (i,), measured={"rise_m": float(rise.max())})
                break
        else:
            yield Found(None, (i,), reason)


def _carriers(replay: Replay, body: int, frame: int) -> tuple[int, ...]:
    """Bodies that carry a body at a frame."""
    others = (j for j, b in enumerate(replay.scene.bodies) if j != body and b.collides)
    at = np.array([min(frame, len(replay.time) - 1)])
    return tuple(j for j in others if carried(replay, body, Binding("", bodies=(j,)), at)[0])


def placed(replay: Replay, q: Query) -> Iterator[Found]:
    """Coming to rest on or in the target, held no more."""
    target = q.bound["target"]
    begin = max(replay.after(q.since), 1)
    for i in q.bound["object"].bodies:
        rest = (replay.speed[:, i] < STOPPED_MPS) & ~_held(replay, i)
        moved = np.linalg.norm(replay.position[:, i] - replay.position[0, i], axis=1) >= STILL_M
        moved = np.maximum.accumulate(moved)
        name = replay.scene.bodies[i].name
        reason = f"{name} never comes to rest, released"
        for start, stop in runs(rest):
            if start < begin or not moved[start]:
                continue
            if duration_of(replay, start, stop) < STOPPED_FOR_S - 0.5 * replay.frame_s:
                continue
            if _is_there(replay, i, target, stop - 1):
                yield Found(float(replay.time[start]), (i,))
                break
            reason = f"{name} comes to rest, but neither on nor in {target.phrase!r}"
        else:
            yield Found(None, (i,), reason)


def _is_there(replay: Replay, body: int, target: Binding, frame: int) -> bool:
    if carried(replay, body, target, np.array([frame]))[0]:
        return True
    return any(
        bool(inside_volume(replay, body, region, container)[0][frame])
        for region, container in volumes(replay, target)
        if container != body
    )


def _held(replay: Replay, body: int) -> Bools:
    """Frames at which the program holds a body, shape [T]."""
    out = np.zeros(len(replay.time), bool)
    for control in replay.controls(body):
        p = control.primitive
        if not isinstance(p, Moving):
            continue
        ends = [p.end]
        for name in p.until_contact:
            hits = replay.hits(body, replay.scene.index(name))
            ends += [h.time for h in hits if h.time >= p.start]
        out |= (replay.time >= p.start) & (replay.time < min(ends))
    return out


def _asleep(replay: Replay, body: int) -> Bools:
    """Frames up to the first motion of a body: what rests from the start is in no engine's log."""
    return np.logical_and.accumulate(replay.speed[:, body] < AT_REST_MPS)


def jumps(replay: Replay, q: Query) -> Iterator[Found]:
    """Leaving what carries it by its own motion and coming down again, as often as asked."""
    begin = max(replay.after(q.since), 1)
    back = max(1, round(MOMENT_S / replay.frame_s))
    for i in q.bound["object"].bodies:
        z = replay.position[:, i, 2]
        need = JUMP_SHARE * 2.0 * replay.scene.bodies[i].half_extents[2]
        reason = f"{replay.scene.bodies[i].name} never leaves what carries it"
        starts = [c.time for c in replay.motions(i)]
        done = 0
        for start, stop in runs(~(touching(replay, i) | _asleep(replay, i))):
            if start < begin:
                continue
            top = start + int(np.argmax(z[start:stop]))
            rise = float(z[top] - z[max(start - back, 0) : start].min())
            off = float(replay.time[start])
            if rise < need:
                reason = f"rises by {100 * rise:.0f} cm (needs {100 * need:.0f} cm)"
            elif not any(off - JUMP_OWN_S <= t <= off for t in starts):
                reason = "leaves the ground, but not by its own motion"
            elif z[top] - z[top : stop + 1].min() < 0.5 * need:
                reason = "does not come down again"
            elif (done := done + 1) == q.event.times:
                yield Found(off, (i,), measured={"rise_m": rise})
                break
            else:
                reason = f"jumps {done} times, {q.event.times} asked"
        else:
            yield Found(None, (i,), reason)


def spins(replay: Replay, q: Query) -> Iterator[Found]:
    """Turning about its vertical without leaving its place, or about the axle that it hangs on."""
    begin = min(replay.after(q.since), len(replay.time) - 1)
    step = max(1, round(SAMPLE_S / replay.frame_s))
    joints = joined(replay)
    for i in q.bound["object"].bodies:
        axles = [j for j in parts_of(joints, i) if j.joint.kind == "hinge"]
        if axles:
            yield from (_about_axle(replay, q, j, begin) for j in axles)
            continue
        turned = np.degrees(np.cumsum(replay.spin[:, i, 2])) * replay.frame_s
        radius = max(replay.scene.bodies[i].half_extents[:2])
        place = replay.position[:, i, :2]
        most = 0.0
        for first in range(begin, len(place), step):
            away = np.linalg.norm(place[first:] - place[first], axis=1) > radius
            stop = first + (int(np.argmax(away)) if away.any() else len(away))
            angle = np.abs(turned[first:stop] - turned[first])
            most = max(most, float(angle.max()))
            # Rounding of a recorded spin must not decide the tie.
            enough = np.flatnonzero(angle >= q.event.degrees - 1e-3)
            if len(enough):
                time = float(replay.time[first + int(enough[0])])
                yield Found(time, (i,), measured={"turned_deg": most})
                break
        else:
            asked = f"{q.event.degrees:.0f} asked"
            yield Found(None, (i,), f"turns by {most:.0f} degrees in its place, {asked}")


def _about_axle(replay: Replay, q: Query, j: Joined, begin: int) -> Found:
    angle = np.degrees(np.abs(j.position - j.position[begin]))[begin:]
    frames = np.flatnonzero((angle >= q.event.degrees - 1e-3) & j.intact[begin:])
    most = float(angle.max())
    if len(frames):
        time = float(replay.time[begin + int(frames[0])])
        return Found(time, (j.child,), measured={"turned_deg": most})
    asked = f"{q.event.degrees:.0f} asked"
    return Found(None, (j.child,), f"turns by {most:.0f} degrees about its axle, {asked}")
