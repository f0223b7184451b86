"""Per type of event: when it happened in each world, and how far from happening it was.

A measure takes a recording, the event, the earliest time at which it counts (inf where it cannot
yet) and returns what it `Detected`; terms that shape the search further go through
`add(name, value [W])`. Which measure belongs to which type of event says `kinds`.
"""

from __future__ import annotations

from collections.abc import Callable
import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.choreography.moves import TURNED_RAD
from esg.dynamics.losses.gap import bounding_radius, surface_gap
from esg.dynamics.losses.hits import first_hit
from esg.dynamics.losses.recording import Bools, Floats, Recording
from esg.dynamics.story.story import climbed_before
from esg.engines.scene import Body
from esg.graph.models import NodeEvent, TimelineNode
from esg.metrics.geometry import first_pass, gets_ahead
from esg.thresholds import (
    ENTERED_FOR_S,
    MAX_CONTACT_DEPTH_M,
    MAX_RECHECK_DEPTH_M,
    MIN_IMPULSE_NS,
    MOVING_MPS,
    NEAR_M,
    RECHECK_AFTER_S,
    SAFE_DEPTH_M,
    SAFE_FALLEN_BY,
    SAFE_IMPULSE_NS,
    SAFE_TOPPLED_DEG,
    SAFE_TURN_DEG,
    STOPPED_FOR_S,
    STOPPED_MPS,
    T_MAX_S,
)
from esg.units import GRAVITY_MPS2, quat_rotate, yaw_from_quat

AddTerm = Callable[[str, Floats], None]


class Detected(NamedTuple):
    """When an event happened, and how far from happening it was.

    Args:
        time: [s], inf where it did not happen, shape [W].
        far: Margin to its happening, squared, in scales of its type; counts where it did not
            happen, shape [W].
    """

    time: Floats
    far: Floats


EARLY_SCALE_S, MOST_EARLY = 0.1, 3.0
"""Scale of how much too early the last hit (or topple) came, and the most that it costs."""
SPARE_S = 0.15
"""A recording goes on for so much longer: in another engine the hit may come later."""
DISTANCE_SCALE_M = 0.3
TILT_SCALE_DEG = 15.0
BRISK = 2.5
"""Usual time from a hit to its topple, over the root of height by gravity."""


def collision(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    a, b = rec.members(node.participants[0]), rec.members(node.participants[-1])
    found = first_hit(rec, a, b, earliest)
    end = float(rec.t[-1])
    hit, good = np.isfinite(found.time) & (found.time <= T_MAX_S), found.sound(end)
    # A hit is looked at again after a while: the recording has to go on for as long.
    short = found.short(end)
    unsound = 0.5 + np.maximum(found.depth - MAX_CONTACT_DEPTH_M, 0.0) / 0.02
    unsound += np.maximum(found.recheck - MAX_RECHECK_DEPTH_M, 0.0) / 0.02
    unsound += np.maximum(MIN_IMPULSE_NS - found.impulse, 0.0) / MIN_IMPULSE_NS
    unsound += np.maximum(short, 0.0) / RECHECK_AFTER_S
    missed = (_miss_distance(rec, a, b, hit, earliest) / DISTANCE_SCALE_M) ** 2
    early = 0.5 + np.minimum(found.early / EARLY_SCALE_S, MOST_EARLY)
    missed = missed + np.where(np.isfinite(found.early), early, 0.0)
    far = np.where(hit, np.minimum(unsound, 8.0), missed)
    soft = np.maximum(SAFE_IMPULSE_NS - found.impulse, 0.0) / SAFE_IMPULSE_NS
    soft = soft + np.maximum(found.depth - SAFE_DEPTH_M, 0.0) / 0.02
    soft = soft + np.maximum(short + SPARE_S, 0.0) / SPARE_S
    add(f"{node.id}/weak", np.where(good, soft, 0.0))
    add(f"{node.id}/glance", np.where(good, 0.3 * found.glance, 0.0))
    return Detected(np.where(good, found.time, np.inf), far)


def _miss_distance(
    rec: Recording, a: list[int], b: list[int], hit: Bools, earliest: Floats
) -> Floats:
    """Smallest surface distance of worlds without a hit [m], shape [W]."""
    out = np.zeros(rec.n)
    worlds = np.flatnonzero(~hit & np.isfinite(earliest))
    if not len(worlds):
        return out
    best = np.full(len(worlds), np.inf)
    for i in a:
        for j in b:
            best = np.minimum(best, _closest(rec, i, j, worlds, earliest[worlds]))
    out[worlds] = np.maximum(best, 0.0)
    return out


def _closest(rec: Recording, i: int, j: int, worlds: NDArray[np.int64], earliest: Floats) -> Floats:
    """Surface distance around the closest approach of the centres [m], shape [len(worlds)]."""
    p, q = rec.r.position.astype(float), rec.r.quaternion.astype(float)
    centres = np.linalg.norm(p[worlds, :, i] - p[worlds, :, j], axis=-1)
    centres = np.where(rec.late(earliest), centres, np.inf)
    nearest = np.argmin(centres, axis=1)
    frames = np.clip(nearest[:, None] + np.arange(-6, 7), 0, len(rec.t) - 1)
    w = worlds[:, None]
    bodies = rec.scene.bodies
    if not bodies[i].shapes or not bodies[j].shapes:
        return centres[np.arange(len(worlds)), nearest]
    gap = surface_gap(
        bodies[i], bodies[j], p[w, frames, i], q[w, frames, i], p[w, frames, j], q[w, frames, j]
    )
    return np.nan_to_num(gap, nan=100.0).min(axis=1)


def reach(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    a, b = rec.members(node.participants[0]), rec.members(node.participants[-1])
    near = gap_over_time(rec, a, b, near_only=True) <= NEAR_M
    near &= rec.late(earliest)
    time = rec.first(near)
    none = ~np.isfinite(time)
    far = (_miss_distance(rec, a, b, ~none, earliest) / DISTANCE_SCALE_M) ** 2
    hit = np.isfinite(first_hit(rec, a, b, earliest).time)
    add(f"{node.id}/touch", np.where(hit, 0.5, 0.0))
    return Detected(time, far)


def miss(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    a, b = rec.members(node.participants[0]), rec.members(node.participants[-1])
    first = first_hit(rec, a, b, np.zeros(rec.n)).time
    if rec.story.meet_again(node) and a and b:
        return _passing(rec, a[0], b[0], first)
    hit = np.isfinite(first)
    gap = gap_over_time(rec, a, b, near_only=True)
    time = rec.t[[first_pass(world) for world in gap]]
    add(f"{node.id}/near", np.minimum((np.maximum(gap.min(axis=1) - 0.5, 0) / 1.0) ** 2, 4))
    ok = ~hit & np.isfinite(earliest)
    return Detected(np.where(ok, time, np.inf), np.full(rec.n, 1.0))


def _passing(rec: Recording, a: int, b: int, hit: Floats) -> Detected:
    """When a gets ahead of b, inf if not before they touch, and what is missing of that [m]."""
    p = rec.r.position[:, :, [a, b], :2].astype(float)
    v = rec.r.linear_velocity[:, :, a, :2].astype(float)
    speed = np.linalg.norm(v, axis=-1)
    way = v / np.maximum(speed, MOVING_MPS)[..., None]
    ahead = ((p[:, :, 0] - p[:, :, 1]) * way).sum(axis=-1)
    untouched = (rec.t[None, :] < hit[:, None]) & (speed > MOVING_MPS)
    time = rec.first(gets_ahead(ahead, untouched))
    nearest = np.where(untouched, ahead, -100.0).max(axis=1)
    return Detected(time, np.clip(-nearest, 0.3, 100.0))


def gap_over_time(rec: Recording, a: list[int], b: list[int], *, near_only: bool = False) -> Floats:
    """Surface distance [m], shape [W, T].

    Args:
        rec: W worlds, T frames.
        a, b: Body indices.
        near_only: Be exact only where it is a world's smallest or at most `NEAR_M`. Elsewhere it
            may be what spheres around the bodies give: less than the distance, more than either.
    """
    key = (tuple(a), tuple(b), near_only)
    if key not in rec.gaps:
        rec.gaps[key] = _gaps(rec, a, b, _least_gap if near_only else surface_gap)
    return rec.gaps[key]


def _gaps(rec: Recording, a: list[int], b: list[int], gap: Callable[..., Floats]) -> Floats:
    p, q = rec.r.position.astype(float), rec.r.quaternion.astype(float)
    out = np.full(p.shape[:2], np.inf)
    for i in a:
        for j in b:
            x, y = rec.scene.bodies[i], rec.scene.bodies[j]
            out = np.minimum(out, gap(x, y, p[:, :, i], q[:, :, i], p[:, :, j], q[:, :, j]))
    return out


def _least_gap(x: Body, y: Body, px: Floats, qx: Floats, py: Floats, qy: Floats) -> Floats:
    least = np.linalg.norm(px - py, axis=-1) - bounding_radius(x) - bounding_radius(y)
    least = np.nan_to_num(least, nan=np.inf)
    world, nearest = np.arange(len(least)), least.argmin(axis=1)
    known = surface_gap(x, y, px[world, nearest], qx[world, nearest], py[world, nearest],
                        qy[world, nearest])  # fmt: skip
    limit = np.maximum(np.nan_to_num(known, nan=np.inf), NEAR_M)
    w, t = np.nonzero(least <= limit[:, None])
    least[w, t] = surface_gap(x, y, px[w, t], qx[w, t], py[w, t], qy[w, t])
    return least


def enter(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    region = next((r for r in rec.scene.regions if r.name == node.region), None)
    if region is None:
        return Detected(np.full(rec.n, np.inf), np.full(rec.n, 25.0))
    body, parent = rec.scene.index(node.participants[0]), rec.scene.index(region.parent)
    p, q = rec.r.position.astype(float), rec.r.quaternion.astype(float)
    inverse = q[:, :, parent] * np.array([-1.0, -1.0, -1.0, 1.0])
    local = quat_rotate(inverse, p[:, :, body] - p[:, :, parent]) - np.array(region.center)
    half = np.array(region.half_extents)
    outside = np.linalg.norm(np.maximum(np.abs(local) - half, 0.0), axis=-1)
    late = rec.late(earliest)
    inside = outside <= 0.0
    # What is inside already does not enter.
    new = np.concatenate([np.zeros((rec.n, 1), bool), inside[:, 1:] & ~inside[:, :-1]], axis=1)
    inside &= np.maximum.accumulate(new & late, axis=1)
    hold = max(1, round(ENTERED_FOR_S * rec.fps))
    stays = inside.copy()
    longest = inside.any(axis=1).astype(float)
    for k in range(1, hold + 1):
        stays[:, :-k] &= inside[:, k:]
        stays[:, -k:] &= inside[:, -1:]
        longest += stays.any(axis=1)
    below = (local[..., 2] < -half[2]) & (np.abs(local[..., :2]) < 1.5 * half[:2]).all(-1)
    time = rec.first(
        stays | (inside & np.flip(np.maximum.accumulate(np.flip(below & late, 1), 1), 1))
    )
    planar = np.linalg.norm(local[..., :2], axis=-1)
    planar = np.where(late, planar, np.inf).min(axis=1)
    scale = max(DISTANCE_SCALE_M * 0.3, float(half[:2].max()))
    add(
        f"{node.id}/centre",
        np.where(
            np.isfinite(time), 0.5 * np.minimum(planar / float(half[:2].min()), 2.0) ** 2, 0.0
        ),
    )
    nearest = np.where(late, outside, np.inf).min(axis=1)
    miss = np.nan_to_num(np.minimum(nearest + planar, 50.0), posinf=50.0) / scale
    # What is inside for too short a time has come closer than what never gets there.
    return Detected(time, 0.25 * miss**2 + 1.0 - longest / (hold + 1))


def stop(rec: Recording, node: TimelineNode, earliest: Floats, _: AddTerm) -> Detected:
    body = rec.scene.index(node.participants[0])
    speed = rec.speed[:, :, body]
    moved = np.maximum.accumulate(speed > MOVING_MPS, axis=1)
    slow = (speed < STOPPED_MPS) & moved & rec.late(earliest)
    still = slow.copy()
    for k in range(1, max(1, round(STOPPED_FOR_S * rec.fps)) + 1):
        still[:, :-k] &= slow[:, k:]
        still[:, -k:] = False
    return Detected(rec.first(still), speed[:, -1])


def _since(rec: Recording, earliest: Floats) -> NDArray[np.int64]:
    """The last frame at or before a time, from which on changes count, shape [W]."""
    frame = np.floor(np.nan_to_num(earliest, posinf=0.0) * rec.fps + 0.25).astype(np.int64)
    return np.clip(frame, 0, len(rec.t) - 1)


def _tilt(rec: Recording, body: int) -> Floats:
    """Angle between a body's upright direction at the start and at present [deg], shape [W, T]."""
    q = rec.r.quaternion[:, :, body].astype(float)
    up = quat_rotate(q, np.array([0.0, 0.0, 1.0]))
    return np.degrees(np.arccos(np.clip((up * up[:, :1]).sum(axis=-1), -1.0, 1.0)))


def topple(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    tilts = np.stack([_tilt(rec, body) for body in rec.members(node.participants[0])])
    late = rec.late(earliest)
    over = tilts > SAFE_TOPPLED_DEG
    # Who lies already does not topple again.
    passes = np.zeros_like(over)
    passes[..., 1:] = over[..., 1:] & ~over[..., :-1]
    time = rec.first(np.asarray((passes & late).any(axis=0), np.bool_))
    most = np.where(late, tilts.max(axis=0), 0.0).max(axis=1)
    add(f"{node.id}/weak", np.maximum(70.0 - most, 0.0) / 70.0 * 0.3)
    short = (SAFE_TOPPLED_DEG - np.minimum(most, SAFE_TOPPLED_DEG)) / TILT_SCALE_DEG
    known = (most > SAFE_TOPPLED_DEG) & np.isfinite(earliest)
    lead = np.where(known, earliest, 0.0) - np.where(
        known, rec.first(np.asarray(passes.any(axis=0), np.bool_)), 0.0
    )
    early = np.where(known, 0.5 + np.clip(lead / EARLY_SCALE_S, 0.0, MOST_EARLY), 0.0)
    before = rec.story.previous_outcome(node.id)
    if before is not None and rec.story.nodes[before].event is NodeEvent.COLLISION:
        # What hangs over its edge after a hit falls back in another engine.
        height = 2.0 * rec.scene.bodies[rec.members(node.participants[0])[0]].half_extents[2]
        struck = np.isfinite(time) & np.isfinite(earliest) & (earliest > 0.0)
        wait = np.where(struck, time, 0.0) - np.where(struck, earliest, 0.0)
        fall = math.sqrt(height / GRAVITY_MPS2)
        add(f"{node.id}/slow", 0.15 * np.clip(wait / fall - BRISK, 0.0, 4.0))
    return Detected(time, short**2 + early)


def tilt_of(loss: float) -> float:
    """The largest tilt [deg] behind a loss of `topple`."""
    return SAFE_TOPPLED_DEG - TILT_SCALE_DEG * math.sqrt(max(loss, 0.0))


def fall(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    body = rec.scene.index(node.participants[0])
    z = rec.r.position[:, :, body, 2].astype(float)
    need = 2.0 * SAFE_FALLEN_BY * rec.scene.bodies[body].half_extents[2]
    climbed = climbed_before(rec.story, node)
    if climbed is not None:
        earliest = np.fmax(earliest, rec.program_time(climbed))
    # What has come down before the event that it follows does not count.
    drop = z[np.arange(rec.n), _since(rec, earliest)][:, None] - z
    late = rec.late(earliest)
    most = np.where(late, drop, 0.0).max(axis=1)
    # Without a drop the way to the edge of the support still tells good from bad.
    moved = np.linalg.norm(
        rec.r.position[:, -1, body, :2] - rec.r.position[:, 0, body, :2], axis=-1
    )
    time = rec.first((drop > need) & late)
    # What crawls over the edge long after it was struck stays on top in another engine.
    struck = np.isfinite(time) & np.isfinite(earliest) & (earliest > 0.0)
    wait = np.where(struck, time, 1.0) - np.where(struck, earliest, 0.0) - 1.0
    add(f"{node.id}/slow", 0.2 * np.clip(wait, 0.0, 3.0))
    return Detected(time, 4.0 * np.maximum(need - most, 0) / need + 1 / (1 + moved))


def heading(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    name = node.participants[0]
    body = rec.scene.index(name)
    planned = rec.program_time(node)
    v = rec.r.linear_velocity[:, :, body].astype(float)
    yaw = np.unwrap(yaw_from_quat(rec.r.quaternion[:, :, body]), axis=1)
    if rec.scene.bodies[body].roll_radius > 0.0:
        yaw = np.unwrap(np.arctan2(v[..., 1], v[..., 0]), axis=1)
    begin = np.array([t.get(f"{node.id}/begin", 0.0) for t in rec.times])
    sign = 1.0 if (node.turn_direction or "left") == "left" else -1.0
    asked = math.radians(node.turn_degrees or 90.0)
    turned = sign * (rec.at(yaw, planned + 0.05) - rec.at(yaw, begin))
    error = np.abs(turned - asked)
    ok = (error < math.radians(SAFE_TURN_DEG)) & np.isfinite(earliest)
    add(f"{node.id}/heading", np.minimum((error / math.radians(10.0)) ** 2, 9.0) * 0.1)
    # It is judged from 20 degrees short of it on, and told as over at its end: half way between.
    made = planned - (planned - begin) * TURNED_RAD / max(asked, TURNED_RAD)
    return Detected(np.where(ok, made, np.inf), (error / 0.3) ** 2)


def position(rec: Recording, node: TimelineNode, earliest: Floats, _: AddTerm) -> Detected:
    body = rec.scene.index(node.participants[0])
    if node.position_cm is None:
        return Detected(np.where(np.isfinite(earliest), earliest, np.inf), np.zeros(rec.n))
    goal = np.array(node.position_cm) / 100.0
    away = np.linalg.norm(rec.r.position[:, :, body].astype(float) - goal, axis=-1)
    time = node.timestamp if node.timestamp is not None else None
    if time is not None:
        d = rec.at(away, np.full(rec.n, time))
        return Detected(np.where(d < DISTANCE_SCALE_M, time, np.inf), (d / DISTANCE_SCALE_M) ** 2)
    near = (away < DISTANCE_SCALE_M) & rec.late(earliest)
    return Detected(rec.first(near), (away.min(axis=1) / DISTANCE_SCALE_M) ** 2)
