"""Checks of any body: spin, energy, support, overlap, and what moves before anything happens."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from esg.engines.scene import GROUND
from esg.metrics.detection import runs
from esg.metrics.geometry import compound_distance
from esg.metrics.judging import initial_overlaps
from esg.metrics.liquids import in_liquid
from esg.metrics.plausibility.facts import Bools, Facts
from esg.metrics.plausibility.limits import limit
from esg.metrics.plausibility.record import Check, Worst
from esg.metrics.replay import Floats
from esg.metrics.statements.manner import spin_ratio
from esg.thresholds import BALLISTIC, CARRIED_M, MOVING_MPS
from esg.units import quat_rotate

_LYING = 0.5
"""Sine of the tilt of a round body's axis up to which it may roll: 30 degrees."""
_ALONG = 0.7
"""Share of its way along its axis beyond which it need not roll."""
_JOINED_S = 0.02
_SAMPLE_S = 0.1


def rolling(f: Facts) -> Check:
    """A round body moves on its support without the spin that friction gives it by then.

    A ball whose foot slips at u rolls after 2 u / (7 mu g), a cylinder after u / (3 mu g).
    """
    worst = Worst()
    for i in f.dynamic:
        body = f.replay.scene.bodies[i]
        if body.roll_radius <= 0.0 or body.wheeled or body.name in f.told.slides:
            continue
        v = f.replay.velocity[:, i]
        level = np.hypot(v[:, 0], v[:, 1])
        moves = (level > limit("rolling speed")) & f.level(i) & ~f.struck(i) & ~f.guided(i)
        share = 2.0 / 7.0
        if (axis := _axis(f, i)) is not None:
            along = np.abs((axis * v).sum(axis=1)) / np.maximum(level, 1e-9)
            moves &= (np.abs(axis[:, 2]) < _LYING) & (along < _ALONG)
            share = 1.0 / 3.0
        spin = spin_ratio(f.replay, i)
        for start, stop in runs(moves & (spin < limit("rolling spin"))):
            slip = float(level[start] * (1.0 - spin[start]))
            most = share * slip / max(f.friction(i) * f.g, 1e-9)
            time = float(f.replay.time[start])
            lasts = (stop - start) * f.replay.frame_s
            worst.look(lasts, most + limit("rolling tolerance"), body.name, time)
    return worst.check("rolling", "s")


def _axis(f: Facts, i: int) -> Floats | None:
    """World direction of a round body's axis over time, shape [T, 3]; None for a ball."""
    for shape in f.replay.scene.bodies[i].shapes:
        if shape.kind in ("cylinder", "capsule"):
            own = quat_rotate(np.array(shape.quaternion), np.array([0.0, 0.0, 1.0]))
            return quat_rotate(f.replay.quaternion[:, i], own)
    return None


@dataclass(frozen=True)
class _Group:
    """Bodies that hand energy to each other in a span of frames."""

    bodies: frozenset[int]
    start: int
    stop: int


def energy(f: Facts) -> Check:
    """Bodies that nothing drives gain energy, alone or from each other.

    Bodies in touch are taken together. Where the program acts on one of them it starts anew. What
    is back after a moment was stored in a contact, be it the one that ended a drive.
    """
    worst = Worst()
    kinetic, total = _energies(f)
    fed = {
        i: f.powered(i) | f.launched(i) | _motored(f, i) | _widened(f.absent(i)) for i in f.dynamic
    }
    mass = np.array([b.mass for b in f.replay.scene.bodies])
    for group in _groups(f):
        members = sorted(group.bodies)
        span = slice(group.start, group.stop)
        acted = np.logical_or.reduce([fed[i][span] for i in members])
        own, moving = (x[span][:, members].sum(axis=1) for x in (total, kinetic))
        spare = limit("energy height") * f.g * float(mass[members].sum())
        for a, b in runs(~acted):
            # The step after the program let go begins with what it left.
            part = slice(max(a - 1, 0), b)
            gain = own[part] - np.minimum.accumulate(_lasting(f, own)[part])
            k = int(np.argmax(gain))
            most = limit("energy share") * float(moving[part].max()) + spare
            names = ", ".join(f.name(i) for i in members[:2])
            time = float(f.replay.time[group.start + part.start + k])
            worst.look(float(gain[k]), most, names, time)
    return worst.check("energy", "J")


def _widened(frames: Bools) -> Bools:
    """Frames and the ones beside them."""
    out = frames.copy()
    out[1:] |= frames[:-1]
    out[:-1] |= frames[1:]
    return out


def _motored(f: Facts, i: int) -> Bools:
    """Frames at which a motor, of the joint or of the program, may feed a body."""
    driven = any(i in j.bodies and j.joint.motor is not None for j in f.joints)
    return np.full(len(f.replay.time), driven)


def _stored(f: Facts, body: int) -> Floats:
    """Energy in the springs of a body's joints [J], shape [T]."""
    out = np.zeros(len(f.replay.time))
    for j in f.joints:
        if j.child == body and j.joint.stiffness:
            rest = (j.joint.upper or 0.0) if j.joint.kind == "spring" else 0.0
            out += 0.5 * j.joint.stiffness * np.where(j.intact, j.position - rest, 0.0) ** 2
    return out


def _lasting(f: Facts, energy: Floats) -> Floats:
    """The most of an energy within the last moment: what a contact stores it may give back."""
    n = max(1, round(limit("energy stored") / f.replay.frame_s))
    padded = np.concatenate([np.full(n - 1, energy[0]), energy])
    return np.lib.stride_tricks.sliding_window_view(padded, n).max(axis=1)


def _energies(f: Facts) -> tuple[Floats, Floats]:
    """Kinetic energy, and with that of height, of all bodies over time [J], shape [T, B]."""
    r = f.replay
    kinetic, total = np.zeros(r.speed.shape), np.zeros(r.speed.shape)
    for i in f.dynamic:
        b = r.scene.bodies[i]
        inverse = r.quaternion[:, i] * np.array([-1.0, -1.0, -1.0, 1.0])
        spin = quat_rotate(inverse, r.spin[:, i])
        turning = np.einsum("ti,ij,tj->t", spin, np.array(b.inertia), spin)
        kinetic[:, i] = 0.5 * (b.mass * r.speed[:, i] ** 2 + turning)
        total[:, i] = kinetic[:, i] + b.mass * f.g * r.position[:, i, 2] + _stored(f, i)
    return kinetic, total


def _groups(f: Facts) -> list[_Group]:
    """Bodies that touch in overlapping spans, together; between them every body alone."""
    touches = _touches(f)
    groups: list[_Group] = []
    for touch in sorted(touches, key=lambda g: g.start):
        joined = [g for g in groups if g.stop >= touch.start and g.bodies & touch.bodies]
        groups = [g for g in groups if g not in joined]
        every = [touch, *joined]
        groups.append(
            _Group(
                frozenset[int]().union(*(g.bodies for g in every)),
                min(g.start for g in every),
                max(g.stop for g in every),
            )
        )
    end = len(f.replay.time)
    for i in f.dynamic:
        alone = np.ones(end, bool)
        for g in groups:
            if i in g.bodies and len(g.bodies) > 1:
                alone[g.start : g.stop] = False
        groups += [_Group(frozenset([i]), a, b) for a, b in runs(alone)]
    return groups


def _touches(f: Facts) -> list[_Group]:
    """Spans in which two bodies that can move touch each other, or a joint holds them."""
    c, r = f.replay.contacts, f.replay
    moving = np.zeros(len(r.scene.bodies) + 1, bool)
    moving[f.dynamic] = True
    rows = np.flatnonzero((c.impulse > 0) & (c.a >= 0) & (c.b >= 0) & moving[c.a] & moving[c.b])
    pairs: dict[tuple[int, int], list[float]] = {}
    for k in rows:
        pairs.setdefault((int(c.a[k]), int(c.b[k])), []).append(float(c.time[k]))
    out = [
        _Group(frozenset(j.bodies), a, b)
        for j in f.joints
        if moving[list(j.bodies)].all() and len(j.bodies) == 2
        for a, b in runs(j.intact)
    ]
    for pair, times in pairs.items():
        times.sort()
        cuts = [k for k in range(1, len(times)) if times[k] - times[k - 1] > 2.0 * _JOINED_S]
        for a, b in pairwise([0, *cuts, len(times)]):
            start = int(np.searchsorted(r.time, times[a] - _JOINED_S))
            stop = int(np.searchsorted(r.time, times[b - 1] + _JOINED_S)) + 1
            out.append(_Group(frozenset(pair), start, min(stop, len(r.time))))
    return out


def hovering(f: Facts) -> Check:
    """Stays up without support, flight or a hand that holds it."""
    worst = Worst()
    for i in f.dynamic:
        v = f.replay.velocity[:, i, 2]
        falls = np.gradient(v, f.replay.time) < -BALLISTIC * f.g
        held = f.guided(i) | f.flown(i) | f.held(i) | f.absent(i) | in_liquid(f.replay, i)
        up = ~f.touching(i) & ~falls & ~held & (np.abs(v) < MOVING_MPS)
        if f.motion(i).moves in ("air", "water"):
            up &= ~f.powered(i)
        for start, stop in runs(up):
            lasts = (stop - start) * f.replay.frame_s
            if lasts > limit("hovering") and _carried_after_all(f, i, start, stop):
                continue
            worst.look(lasts, limit("hovering"), f.name(i), float(f.replay.time[start]))
    return worst.check("hovering", "s")


def _carried_after_all(f: Facts, i: int, start: int, stop: int) -> bool:
    """Whether its shapes touch something although no log says so."""
    step = max(1, round(_SAMPLE_S / f.replay.frame_s))
    others = [k for k in range(len(f.replay.scene.bodies)) if k != i and f.replay.cores[k]]
    for frame in range(start, stop, step):
        mine = f.replay.placed(i, frame)
        if not any(
            compound_distance(mine, f.replay.placed(k, frame), cutoff=CARRIED_M) <= CARRIED_M
            for k in others
        ):
            return False
    return True


def penetration(f: Facts) -> Check:
    """Two bodies are sunk in each other at the start, or for longer than a hit lasts."""
    worst, r = Worst(), f.replay
    overlaps, deepest = initial_overlaps(r)
    names = max(overlaps, key=lambda o: o.depth_m, default=None)
    pair = "" if names is None else f"{names.a}, {names.b}"
    worst.look(deepest, limit("penetration"), pair, 0.0, "at the start")
    n = max(1, round(limit("sustained") / r.frame_s))
    for pair, depth in _depths(f):
        if len(depth) < n:
            continue
        lasting = np.lib.stride_tricks.sliding_window_view(depth, n).min(axis=1)
        k = int(np.argmax(lasting))
        worst.look(float(lasting[k]), limit("penetration"), pair, float(r.time[k]))
    return worst.check("penetration", "m")


def _depths(f: Facts) -> Iterable[tuple[str, Floats]]:
    """Depth of every pair over time [m], that with the ground from shapes."""
    c, r = f.replay.contacts, f.replay
    rows = np.flatnonzero((c.a >= 0) & (c.b >= 0))
    frames = np.clip(np.searchsorted(r.time, c.time[rows] - 0.5 * r.frame_s), 0, len(r.time) - 1)
    keys = c.a[rows].astype(np.int64) * len(r.scene.bodies) + c.b[rows]
    for key in np.unique(keys):
        mine = keys == key
        depth = np.zeros(len(r.time))
        depth[frames[mine]] = c.depth[rows][mine]
        a, b = divmod(int(key), len(r.scene.bodies))
        yield f"{f.name(a)}, {f.name(b)}", depth
    for i in f.dynamic:
        deep = np.where(f.absent(i), 0.0, -f.lowest(i))
        yield f"{f.name(i)}, {GROUND}", np.maximum(deep, 0.0)


def motion_before(f: Facts) -> Check:
    """Drifts or falls over before anything that moves has touched it."""
    worst, r = Worst(), f.replay
    away = np.linalg.norm(r.position - r.position[:1], axis=-1)
    disturbed = away > limit("disturbed")
    for i in range(len(r.scene.bodies)):
        if r.controls(i) or f.name(i) in f.told.movers:
            disturbed[:, i] = True
    _pass_on(f, disturbed)
    for i in f.dynamic:
        if f.name(i) in f.told.movers or r.scene.bodies[i].active or f.absent(i)[0]:
            continue
        last = _first_touch(f, i, disturbed)
        start = min((c.time for c in r.motions(i)), default=np.inf)
        last = min(last, r.frame_before(start) + 1 if np.isfinite(start) else len(r.time))
        if last > 0:
            k = int(np.argmax(away[:last, i]))
            worst.look(float(away[k, i]), limit("drift"), f.name(i), float(r.time[k]))
    return worst.check("motion_before", "m")


def _pass_on(f: Facts, disturbed: Bools) -> None:
    """Marks what moves since something disturbed has touched it, however short its way yet.

    A domino that a marble hits strikes the next one before it has gone a centimetre, and a ball of
    a cradle stops as it does.
    """
    c, r = f.replay.contacts, f.replay
    reach = np.array([float(np.linalg.norm(b.half_extents)) for b in r.scene.bodies])
    # a seesaw turns about its middle, which stays where it is
    moves = np.maximum(r.speed, np.linalg.norm(r.spin, axis=-1) * reach) > MOVING_MPS
    rows = np.flatnonzero((c.impulse > 0) & (c.a >= 0) & (c.b >= 0))
    frames = np.clip(np.searchsorted(r.time, c.time[rows] - 0.5 * r.frame_s), 0, len(r.time) - 1)
    met: set[int] = set()
    for k, row in zip(frames, rows, strict=True):
        for mine, other in ((int(c.a[row]), int(c.b[row])), (int(c.b[row]), int(c.a[row]))):
            if mine not in met and disturbed[max(k - 1, 0) : k + 1, other].any():
                met.add(mine)
                disturbed[k:, mine] |= moves[k:, mine]


def _first_touch(f: Facts, i: int, disturbed: Bools) -> int:
    """The frame at which something disturbed first touches a body; all frames without.

    What a joint holds to it, or what it stands on at the start, is moved as by a touch: a tray that
    is let go falls away from the cup on it without a blow.
    """
    c, r = f.replay.contacts, f.replay
    mine = np.flatnonzero(((c.a == i) | (c.b == i)) & (c.impulse > 0) & (c.a >= 0) & (c.b >= 0))
    other = np.where(c.a[mine] == i, c.b[mine], c.a[mine])
    frames = np.clip(np.searchsorted(r.time, c.time[mine] - 0.5 * r.frame_s), 0, len(r.time) - 1)
    before = np.maximum(frames - 1, 0)
    found = [int(k) for k in frames[disturbed[frames, other] | disturbed[before, other]]]
    for j in f.joints:
        if i in j.bodies and len(j.bodies) == 2:
            there = sum(j.bodies) - i
            found += [int(k) for k in np.flatnonzero(disturbed[:, there] & j.intact)[:1]]
    names = {f.name(k): k for k in range(len(r.scene.bodies))}
    below = names.get(f.told.stands_on.get(f.name(i), ""))
    if below is not None:
        found += [int(k) for k in np.flatnonzero(disturbed[:, below] & _moving(f, below))[:1]]
    return min(found, default=len(r.time))


def _moving(f: Facts, body: int) -> Bools:
    return f.replay.speed[:, body] > MOVING_MPS
