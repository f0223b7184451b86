"""When was an event completed? One detector per event type of the suite format.

A detector looks for the first completion later than `since` (the latest time of the events that
must come before; None from scene start) and returns what it found, or why nothing counts.
docs/metrics.md states every rule and what the time of each event is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import GROUND
from esg.metrics.binding import Binding, container_regions
from esg.metrics.geometry import Core, compound_distance
from esg.metrics.models import SuiteEvent
from esg.metrics.replay import GROUND_INDEX, Hit, Replay
from esg.units import quat_rotate

T_MAX_S = 15.0
MAX_CONTACT_DEPTH_M = 0.05
MIN_IMPULSE_NS = 0.1
RECHECK_AFTER_S = 0.2
MAX_RECHECK_DEPTH_M = 0.02
MIN_EVENT_GAP_S = 0.1
MOVING_MPS = 0.2
MOVING_FOR_S = 0.5
STOPPED_MPS = 0.1
STOPPED_FOR_S = 0.2
TURN_TOLERANCE_DEG = 20.0
ENTERED_FOR_S = 0.2
TOPPLED_DEG = 45.0
REACH_M = 0.3


@dataclass(frozen=True)
class Found:
    """Result of a detector.

    Args:
        time: Of the event [s]; None if it was not completed.
        bodies: Indices of the bodies that decided, GROUND_INDEX for the ground.
        reason: Why not completed.
        measured: Numbers worth recording, names carry the unit.
        hit: The hit of a collision.
    """

    time: float | None
    bodies: tuple[int, ...] = ()
    reason: str = ""
    measured: dict[str, float] = field(default_factory=dict)
    hit: Hit | None = None

    @property
    def completed(self) -> bool:
        return self.time is not None


@dataclass(frozen=True)
class Query:
    """One event to detect.

    Args:
        event: The suite's event.
        bound: Bindings of its participants by field name.
        since: Only completions later than this count [s]; None: from scene start.
        until: Gives the time of the earliest later event of a body after a time (for brakes).
    """

    event: SuiteEvent
    bound: dict[str, Binding]
    since: float | None = None
    until: Callable[[int, float], float] | None = None


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


def _misses(replay: Replay, q: Query) -> Iterator[Found]:
    for a, b in pairs(q.bound["a"], q.bound["b"]):
        if any(h.impulse > 0 for h in replay.hits(a, b)):
            name_a, name_b = names(replay, (a, b))
            yield Found(None, (a, b), f"{name_a} touches {name_b}")
            return
    gap = math.inf
    at, who = 0, (0, 0)
    for a, b in pairs(q.bound["a"], q.bound["b"]):
        distance = _distances(replay, a, b)
        k = int(np.argmin(distance))
        if distance[k] < gap:
            gap, at, who = float(distance[k]), k, (a, b)
    yield Found(float(replay.time[at]), who, measured={"center_distance_m": gap})


def _distances(replay: Replay, a: int, b: int) -> NDArray[np.float64]:
    if b == GROUND_INDEX:
        return replay.position[:, a, 2]
    return np.linalg.norm(replay.position[:, a] - replay.position[:, b], axis=1)


def _runs(mask: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    """Start and end (exclusive) of every run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)


def _span(replay: Replay, start: int, stop: int) -> float:
    return float(replay.time[stop - 1] - replay.time[start])


def _moves(replay: Replay, q: Query) -> Iterator[Found]:
    for i in q.bound["object"].bodies:
        controls = replay.motions(i)
        if not controls:
            yield Found(None, (i,), f"nothing drives {replay.scene.bodies[i].name}")
            continue
        begin = max(replay.after(q.since), replay.frame_at(controls[0].time))
        mask = replay.speed[:, i] > MOVING_MPS
        mask[:begin] = False
        longest = 0.0
        for start, stop in _runs(mask):
            span = _span(replay, start, stop)
            longest = max(longest, span)
            if span >= MOVING_FOR_S - 0.5 * replay.frame_s:
                top = float(replay.speed[start:stop, i].max())
                yield Found(
                    float(replay.time[start]), (i,), measured={"for_s": span, "speed_mps": top}
                )
                break
        else:
            yield Found(None, (i,), f"moves for {longest:.2f} s at most (needs 0.5 s)")


def _brakes(replay: Replay, q: Query) -> Iterator[Found]:
    for i in q.bound["object"].bodies:
        name = replay.scene.bodies[i].name
        reason = f"the program never brakes {name}"
        for t in replay.brakings(i):
            if q.since is not None and t <= q.since:
                reason = f"{name} brakes at {t:.2f} s, not after the event before"
                continue
            begin = replay.frame_before(t) if t > 0 else 0
            before = float(replay.speed[begin, i])
            if before < MOVING_MPS:
                reason = f"{name} is at rest when its braking starts"
                continue
            limit = q.until(i, t) if q.until else math.inf
            stop = max(replay.frame_before(limit) + 1, begin + 1) if limit < math.inf else None
            later = replay.speed[begin:stop, i]
            slowest = float(later.min())
            measured = {"speed_before_mps": before, "speed_min_mps": slowest}
            if slowest <= 0.5 * before:
                halved = begin + int(np.argmax(later <= 0.5 * before))
                measured["halved_at_s"] = float(replay.time[halved])
                yield Found(t, (i,), measured=measured)
                break
            reason = f"{name} slows from {before:.2f} to {slowest:.2f} m/s only"
        else:
            yield Found(None, (i,), reason)


def _stops(replay: Replay, q: Query) -> Iterator[Found]:
    for i in q.bound["object"].bodies:
        speed = replay.speed[:, i]
        moved = np.maximum.accumulate(speed) > MOVING_MPS
        mask = (speed < STOPPED_MPS) & moved
        mask[: replay.after(q.since)] = False
        for start, stop in _runs(mask):
            if _span(replay, start, stop) >= STOPPED_FOR_S - 0.5 * replay.frame_s:
                yield Found(float(replay.time[start]), (i,))
                break
        else:
            name = replay.scene.bodies[i].name
            if not moved.any():
                yield Found(None, (i,), f"{name} never moves")
            else:
                yield Found(None, (i,), f"{name} still moves at {speed[-1]:.2f} m/s at the end")


def _turns(replay: Replay, q: Query) -> Iterator[Found]:
    wanted = q.event.degrees
    sign = 1.0 if q.event.direction == "left" else -1.0
    for i in q.bound["object"].bodies:
        begin = max(replay.after(q.since) - 1, 0)
        heading = sign * np.degrees(replay.heading(i))[begin:]
        # Measured from the last turning back: the angle since the running opposite extreme.
        turned = heading - np.minimum.accumulate(heading)
        enough = np.flatnonzero(turned >= wanted - TURN_TOLERANCE_DEG)
        if not len(enough):
            yield Found(None, (i,), f"turns {q.event.direction} by {turned.max():.0f} degrees only")
            continue
        first = int(enough[0])
        total = _settled(turned, first, replay.frame_s)
        if total > wanted + TURN_TOLERANCE_DEG:
            yield Found(None, (i,), f"turns by {total:.0f} degrees, {wanted:.0f} asked")
            continue
        yield Found(float(replay.time[begin + first]), (i,), measured={"turned_deg": total})


def _settled(turned: NDArray[np.float64], first: int, frame_s: float) -> float:
    """Angle when the turning ends after `first`: the rate falls under 5 degrees/s for 0.1 s."""
    quiet = max(1, round(0.1 / frame_s))
    k = first
    while k + quiet < len(turned) and turned[k + quiet] - turned[k] > 5.0 * quiet * frame_s:
        k += 1
    return float(turned[k])


def _inside(
    replay: Replay, body: int, region: int | None, container: int | None
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Per frame: the centre is inside the volume; it is below the volume, within its outline."""
    if region is not None:
        r = replay.scene.regions[region]
        parent = replay.scene.index(r.parent)
        center, half = np.array(r.center), np.array(r.half_extents)
    else:
        assert container is not None
        parent = container
        b = replay.scene.bodies[container]
        half = np.array(b.half_extents)
        center = np.array(b.origin_offset) + np.array([0.0, 0.0, half[2]])
        if not b.collides:
            # A painted area has no height: whatever is over its outline is in it.
            center = center + np.array([0.0, 0.0, 500.0])
            half = np.array([half[0], half[1], 501.0])
    q = replay.quaternion[:, parent]
    inverse = q * np.array([-1.0, -1.0, -1.0, 1.0])
    local = quat_rotate(inverse, replay.position[:, body] - replay.position[:, parent]) - center
    outline = np.all(np.abs(local[:, :2]) <= half[:2], axis=1)
    return outline & (np.abs(local[:, 2]) <= half[2]), outline & (local[:, 2] < -half[2])


def _volumes(replay: Replay, target: Binding) -> list[tuple[int | None, int | None]]:
    out: list[tuple[int | None, int | None]] = [(r, None) for r in target.regions]
    for b in target.bodies:
        regions = container_regions(replay.scene, b)
        out += [(r, None) for r in regions] or [(None, b)]
    return out


def _enters(replay: Replay, q: Query) -> Iterator[Found]:
    begin = replay.after(q.since)
    for i in q.bound["object"].bodies:
        reason = f"the centre of {replay.scene.bodies[i].name} never enters the target"
        for region, container in _volumes(replay, q.bound["target"]):
            if container == i:
                continue
            inside, below = _inside(replay, i, region, container)
            done = False
            for start, stop in _runs(inside):
                if start == 0 or start < begin:
                    reason = "inside the target before the event could happen"
                    continue
                span = _span(replay, start, stop)
                dropped = stop < len(below) and bool(below[stop])
                if span >= ENTERED_FOR_S - 0.5 * replay.frame_s or dropped:
                    name = {"region": float(region)} if region is not None else {}
                    yield Found(float(replay.time[start]), (i,), measured={"for_s": span, **name})
                    done = True
                    break
                reason = f"stays in the target for {span:.2f} s only"
            if done:
                break
        else:
            yield Found(None, (i,), reason)


def _falls(replay: Replay, q: Query) -> Iterator[Found]:
    begin = max(replay.after(q.since) - 1, 0)
    g = abs(replay.scene.gravity[2])
    for i in q.bound["object"].bodies:
        z = replay.position[:, i, 2]
        vz = replay.velocity[:, i, 2]
        acceleration = np.gradient(vz, replay.time) if len(vz) > 1 else np.zeros(1)
        supported = (np.abs(vz) < MOVING_MPS) & (acceleration > -0.5 * g)
        supported[begin] = True
        if (support := q.bound.get("from")) is not None and support.bodies:
            over = np.any([_over(replay, i, s) for s in support.bodies], axis=0)
            supported &= over
            if not supported[begin:].any():
                yield Found(None, (i,), f"was never on {support.phrase!r}")
                continue
        level = np.maximum.accumulate(np.where(supported, z, -math.inf)[begin:])
        drop = level - z[begin:]
        height = 2.0 * replay.scene.bodies[i].half_extents[2]
        far = np.flatnonzero(np.isfinite(drop) & (drop > 0.5 * height))
        far = far[begin + far >= replay.after(q.since)]
        if len(far):
            k = begin + int(far[0])
            yield Found(float(replay.time[k]), (i,), measured={"drop_m": float(drop.max())})
        else:
            most = float(np.max(drop, initial=0.0, where=np.isfinite(drop)))
            yield Found(None, (i,), f"drops by {most:.2f} m (needs {0.5 * height:.2f} m)")


def _over(replay: Replay, body: int, support: int) -> NDArray[np.bool_]:
    """Frames at which a body's centre is above the outline of its support (with its own width)."""
    s = replay.scene.bodies[support]
    inverse = replay.quaternion[:, support] * np.array([-1.0, -1.0, -1.0, 1.0])
    offset = replay.position[:, body] - replay.position[:, support]
    local = quat_rotate(inverse, offset) - np.array(s.origin_offset)
    slack = max(replay.scene.bodies[body].half_extents[:2])
    half = np.array(s.half_extents[:2]) + slack
    return np.all(np.abs(local[:, :2]) <= half, axis=1) & (local[:, 2] > 0.0)


def _topples(replay: Replay, q: Query) -> Iterator[Found]:
    begin = replay.after(q.since)
    for i in q.bound["object"].bodies:
        up = replay.up(i)
        rest = up[max(begin - 1, 0)]
        tilt = np.degrees(np.arccos(np.clip(up @ rest, -1.0, 1.0)))
        far = np.flatnonzero(tilt[begin:] > TOPPLED_DEG)
        if len(far):
            k = begin + int(far[0])
            yield Found(float(replay.time[k]), (i,), measured={"tilt_deg": float(tilt.max())})
        else:
            most = float(tilt[begin:].max(initial=0.0))
            yield Found(None, (i,), f"tilts by {most:.0f} degrees (needs more than 45)")


def surface_distance(replay: Replay, body: int, target: Binding, frame: int) -> float:
    """Smallest distance from a body's surface to a target [m], negative when overlapping."""
    cores = replay.placed_solid(body, frame)
    best = math.inf
    if target.point is not None:
        best = compound_distance(cores, (Core(np.array([target.point]), 0.0),))
    for r in target.regions:
        best = min(best, compound_distance(cores, replay.placed_region(r, frame)))
    for other in target.bodies:
        if other != body:
            best = min(best, compound_distance(cores, replay.placed_solid(other, frame)))
    if target.ground:
        best = min(best, replay.lowest(body, frame))
    return best


def _center_gap(replay: Replay, body: int, target: Binding) -> NDArray[np.float64]:
    """Lower bound of the surface distance per frame [m], shape [T]."""
    p = replay.position[:, body]
    gaps = [np.full(len(replay.time), math.inf)]
    if target.point is not None:
        gaps.append(np.linalg.norm(p - np.array(target.point), axis=1) - replay.radii[body])
    for other in target.bodies:
        if other != body:
            reach = replay.radii[body] + replay.radii[other]
            gaps.append(np.linalg.norm(p - replay.position[:, other], axis=1) - reach)
    for r in target.regions:
        gaps.append(_outside(replay, body, r) - replay.radii[body])
    if target.ground:
        gaps.append(p[:, 2] - replay.radii[body])
    return np.min(gaps, axis=0)


def _outside(replay: Replay, body: int, region: int) -> NDArray[np.float64]:
    """Distance of a body's centre from a region's box per frame [m], 0 inside."""
    r = replay.scene.regions[region]
    parent = replay.scene.index(r.parent)
    inverse = replay.quaternion[:, parent] * np.array([-1.0, -1.0, -1.0, 1.0])
    offset = replay.position[:, body] - replay.position[:, parent]
    local = np.abs(quat_rotate(inverse, offset) - np.array(r.center)) - np.array(r.half_extents)
    return np.linalg.norm(np.maximum(local, 0.0), axis=1)


def _reaches(replay: Replay, q: Query) -> Iterator[Found]:
    begin = replay.after(q.since)
    target = q.bound["target"]
    for i in q.bound["object"].bodies:
        bound = _center_gap(replay, i, target)
        if surface_distance(replay, i, target, 0) <= REACH_M:
            yield Found(None, (i,), "within 0.3 m of the target from the start")
            continue
        moving = replay.speed[:, i] > 1e-3
        nearest = math.inf
        for k in np.flatnonzero(bound <= REACH_M):
            if k < begin or (k > begin and not moving[k] and not target.bodies):
                continue
            distance = surface_distance(replay, i, target, int(k))
            nearest = min(nearest, distance)
            if distance <= REACH_M:
                yield Found(
                    float(replay.time[k]), (i,), measured={"distance_m": max(distance, 0.0)}
                )
                break
        else:
            near = nearest if math.isfinite(nearest) else float(bound[begin:].min(initial=math.inf))
            yield Found(None, (i,), f"comes within {near:.2f} m only (needs 0.3 m)")


_DETECTORS: dict[str, Callable[[Replay, Query], Iterator[Found]]] = {
    "collision": _collision,
    "misses": _misses,
    "moves": _moves,
    "brakes": _brakes,
    "stops": _stops,
    "turns": _turns,
    "enters": _enters,
    "falls": _falls,
    "topples": _topples,
    "reaches": _reaches,
}
