"""When was an event completed? One detector per event type of the suite format.

A detector looks for the first completion later than `since` (the latest time of the events that
must come before; None from scene start) and returns what it found, or why nothing counts.
docs/metrics.md states every rule and what the time of each event is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import GROUND
from esg.metrics.binding import Binding
from esg.metrics.detection import (
    Found,
    Query,
)
from esg.metrics.events.handling import bounces, jumps, picked_up, placed, spins
from esg.metrics.events.joints import breaks, closes, opens, separates, swings
from esg.metrics.events.motion import brakes, moves, stops, turns
from esg.metrics.events.space import (
    enters,
    falls,
    inside_volume,
    reaches,
    surface_distance,
    topples,
)
from esg.metrics.geometry import APPROACH_M, first_pass, gets_ahead
from esg.metrics.replay import GROUND_INDEX, Hit, Replay
from esg.metrics.support import local_position
from esg.thresholds import (
    MAX_CONTACT_DEPTH_M,
    MAX_RECHECK_DEPTH_M,
    MIN_EVENT_GAP_S,
    MIN_IMPULSE_NS,
    MOVING_MPS,
    PASS_M,
    PASS_SIZES,
    RECHECK_AFTER_S,
    T_MAX_S,
)


def detect(replay: Replay, query: Query) -> Found:
    """The first completion of an event later than `query.since`, over all bound bodies."""
    if not replay.valid:
        return Found(None, reason="the simulation diverged")
    detector = _DETECTORS[query.event.type]
    best: Found | None = None
    failed: Found | None = None
    for found in detector(replay, query):
        if found.time is not None and (best is None or found.time < (best.time or 0.0)):
            best = found
        elif found.time is None and failed is None:
            failed = found
    return best or failed or Found(None, reason="nothing to observe")


def names(replay: Replay, bodies: tuple[int, ...]) -> tuple[str, ...]:
    """Names of body indices, "ground" for the ground."""
    return tuple(GROUND if i == GROUND_INDEX else replay.scene.bodies[i].name for i in bodies)


def pairs(a: Binding, b: Binding) -> list[tuple[int, int]]:
    """All pairs of distinct bodies between two bindings, each once, ground last."""
    out: list[tuple[int, int]] = []
    for i in a.bodies:
        for j in b.bodies:
            if i != j and (i, j) not in out and (j, i) not in out:
                out.append((i, j))
    out += [(i, GROUND_INDEX) for i in a.bodies if b.ground]
    out += [(j, GROUND_INDEX) for j in b.bodies if a.ground]
    return out


def qualify(replay: Replay, hit: Hit) -> tuple[str, dict[str, float]]:
    """Why a hit does not count as a collision ("" if it does), and its numbers."""
    measured = {"time_s": hit.time, "depth_m": hit.depth, "impulse_ns": hit.impulse}
    if hit.time > T_MAX_S:
        return f"hit at {hit.time:.2f} s, later than {T_MAX_S:g} s", measured
    if hit.depth >= MAX_CONTACT_DEPTH_M:
        return f"{hit.depth * 100:.1f} cm deep at contact (limit 5 cm)", measured
    if hit.impulse <= MIN_IMPULSE_NS:
        return f"impulse {hit.impulse:.3f} N s (needs more than 0.1)", measured
    check = hit.time + RECHECK_AFTER_S
    if check > replay.end + 1.5 * replay.frame_s:
        return (
            f"replay ends {replay.end - hit.time:.2f} s after the hit, before the re-check",
            measured,
        )
    frame = int(np.argmin(np.abs(replay.time - check)))
    depth = replay.penetration(hit.a, hit.b, frame)
    measured["depth_after_m"] = depth
    if depth > MAX_RECHECK_DEPTH_M:
        return f"still {depth * 100:.1f} cm deep 0.2 s after the hit (limit 2 cm)", measured
    return "", measured


def _collision(replay: Replay, q: Query) -> Iterator[Found]:
    best: Found | None = None
    reason = "the pair never touches"
    earliest = -math.inf if q.since is None else q.since + MIN_EVENT_GAP_S
    for a, b in pairs(q.bound["a"], q.bound["b"]):
        for hit in replay.hits(a, b):
            why, measured = qualify(replay, hit)
            if not why and hit.time < earliest - 1e-9:
                why = (
                    f"hit at {hit.time:.2f} s, but only hits from {earliest:.2f} s on follow the "
                    "event before"
                )
            if why:
                reason = why
            elif best is None or hit.time < (best.time or 0.0):
                best = Found(hit.time, (a, b), measured=measured, hit=hit)
                break
    yield best or Found(None, reason=reason)


def _two(q: Query) -> tuple[Binding, Binding]:
    """Who misses whom."""
    return q.bound.get("a") or q.bound["object"], q.bound.get("b") or q.bound["target"]


def _misses(replay: Replay, q: Query) -> Iterator[Found]:
    if q.meet_again:
        yield _passes(replay, q)
        return
    if _two(q)[1].regions:
        yield from _misses_region(replay, q)
        return
    for a, b in pairs(*_two(q)):
        if any(h.impulse > 0 for h in replay.hits(a, b)):
            name_a, name_b = names(replay, (a, b))
            yield Found(None, (a, b), f"{name_a} touches {name_b}")
            return
    gap = math.inf
    at, who = 0, (0, 0)
    for a, b in pairs(*_two(q)):
        distance = _distances(replay, a, b)
        k = first_pass(distance)
        if distance[k] < gap:
            gap, at, who = float(distance[k]), k, (a, b)
    found = Found(float(replay.time[at]), who, measured={"center_distance_m": gap})
    yield found if "a" in q.bound else _near_miss(replay, q, found, at)


def _near_miss(replay: Replay, q: Query, found: Found, at: int) -> Found:
    """The pass, if what misses came nearer, and so near that one may speak of a miss."""
    body, target = found.bodies
    apart = _distances(replay, body, target)
    if float(np.maximum.accumulate(apart)[at] - apart[at]) < APPROACH_M:
        return Found(None, found.bodies, f"never comes nearer to {q.bound['target'].phrase!r}")
    return _within_reach(replay, q, found, at, _size(replay, target))


def _size(replay: Replay, body: int) -> float:
    """Largest extent of a body [m], 0 for the ground."""
    return 0.0 if body == GROUND_INDEX else 2.0 * max(replay.scene.bodies[body].half_extents)


def _within_reach(replay: Replay, q: Query, found: Found, at: int, size: float) -> Found:
    gap = surface_distance(replay, found.bodies[0], q.bound["target"], at)
    limit = max(PASS_M, PASS_SIZES * size)
    if gap > limit:
        return Found(None, found.bodies, f"passes {gap:.1f} m away (limit {limit:.1f} m)")
    return Found(found.time, found.bodies, measured={**found.measured, "distance_m": gap})


def _misses_region(replay: Replay, q: Query) -> Iterator[Found]:
    """Passing a goal or a pocket without going in."""
    for i in q.bound["object"].bodies:
        for region in q.bound["target"].regions:
            r = replay.scene.regions[region]
            name = replay.scene.bodies[i].name
            if inside_volume(replay, i, region, None)[0].any():
                yield Found(None, (i,), f"{name} goes into {r.name}")
                return
            parent = replay.scene.index(r.parent)
            apart = np.linalg.norm(local_position(replay, i, parent) - np.array(r.center), axis=1)
            at = first_pass(apart)
            if float(np.maximum.accumulate(apart)[at] - apart[at]) < APPROACH_M:
                yield Found(None, (i,), f"{name} never comes nearer to {r.name}")
                continue
            found = Found(float(replay.time[at]), (i,))
            yield _within_reach(replay, q, found, at, 2.0 * max(r.half_extents))


def _passes(replay: Replay, q: Query) -> Found:
    """One gets ahead of the other before they touch: who overtakes may be run into later."""
    reason = ""
    for a, b in pairs(*_two(q)):
        first = min((h.time for h in replay.hits(a, b) if h.impulse > 0), default=math.inf)
        offset = (replay.position[:, a] - replay.position[:, b])[:, :2]
        velocity = replay.velocity[:, a, :2]
        ahead = (offset * velocity).sum(axis=-1)
        free = (replay.time < first) & (replay.speed[:, a] > MOVING_MPS)
        frames = np.flatnonzero(gets_ahead(ahead, free))
        if len(frames):
            return Found(float(replay.time[frames[0]]), (a, b))
        name_a, name_b = names(replay, (a, b))
        reason = f"{name_a} does not get ahead of {name_b} before they touch"
    return Found(None, reason=reason)


def _distances(replay: Replay, a: int, b: int) -> NDArray[np.float64]:
    if b == GROUND_INDEX:
        return replay.position[:, a, 2]
    return np.linalg.norm(replay.position[:, a] - replay.position[:, b], axis=1)


_DETECTORS: dict[str, Callable[[Replay, Query], Iterator[Found]]] = {
    "collision": _collision,
    "misses": _misses,
    "moves": moves,
    "brakes": brakes,
    "stops": stops,
    "turns": turns,
    "enters": enters,
    "falls": falls,
    "topples": topples,
    "reaches": reaches,
    "bounces": bounces,
    "picked_up": picked_up,
    "placed": placed,
    "jumps": jumps,
    "spins": spins,
    "opens": opens,
    "closes": closes,
    "swings": swings,
    "breaks": breaks,
    "separates": separates,
}
