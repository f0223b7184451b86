"""Events of place and attitude: enters, falls, topples, reaches."""

from __future__ import annotations

from collections.abc import Iterator
import math

import numpy as np
from numpy.typing import NDArray

from esg.metrics.binding import Binding
from esg.metrics.detection import (
    Found,
    Query,
    duration_of,
    runs,
)
from esg.metrics.geometry import Core, compound_distance
from esg.metrics.regions import container_regions
from esg.metrics.replay import Replay
from esg.thresholds import ENTERED_FOR_S, FALLEN_BY, MOVING_MPS, REACH_M, TOPPLED_DEG
from esg.units import quat_rotate

_LOWER_M = 0.01
"""Lower than this below its support, a body that rests has come down."""


def inside_volume(
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


def volumes(replay: Replay, target: Binding) -> list[tuple[int | None, int | None]]:
    """What things can be in: regions and, of bodies that have none, the bodies themselves."""
    out: list[tuple[int | None, int | None]] = [(r, None) for r in target.regions]
    for b in target.bodies:
        regions = container_regions(replay.scene, b)
        out += [(r, None) for r in regions] or [(None, b)]
    return out


def enters(replay: Replay, q: Query) -> Iterator[Found]:
    """The centre of the object comes into the target and stays, or drops through its floor."""
    begin = replay.after(q.since)
    for i in q.bound["object"].bodies:
        reason = f"the centre of {replay.scene.bodies[i].name} never enters the target"
        for region, container in volumes(replay, q.bound["target"]):
            if container == i:
                continue
            inside, below = inside_volume(replay, i, region, container)
            done = False
            for start, stop in runs(inside):
                if start == 0 or start < begin:
                    reason = "inside the target before the event could happen"
                    continue
                span = duration_of(replay, start, stop)
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


def falls(replay: Replay, q: Query) -> Iterator[Found]:
    """Losing support and coming down, from what it stood on if that is named."""
    begin = max(replay.after(q.since) - 1, 0)
    g = abs(replay.scene.gravity[2])
    for i in q.bound["object"].bodies:
        z = replay.position[:, i, 2]
        vz = replay.velocity[:, i, 2]
        acceleration = np.gradient(vz, replay.time) if len(vz) > 1 else np.zeros(1)
        supported = (np.abs(vz) < MOVING_MPS) & (acceleration > -0.5 * g)
        supported[begin] = True
        if (support := q.bound.get("from")) is not None and support.bodies:
            over = np.any([is_over(replay, i, s) for s in support.bodies], axis=0)
            if not (supported & over)[begin:].any():
                # What stood on something that topples is on its way when that counts as toppled.
                if not _slid_off(z, supported, over, begin):
                    yield Found(None, (i,), f"was never on {support.phrase!r}")
                    continue
            else:
                supported &= over
        level = np.maximum.accumulate(np.where(supported, z, -math.inf)[begin:])
        drop = level - z[begin:]
        height = 2.0 * replay.scene.bodies[i].half_extents[2]
        far = np.flatnonzero(np.isfinite(drop) & (drop > FALLEN_BY * height))
        far = far[begin + far >= replay.after(q.since)]
        if len(far):
            k = begin + int(far[0])
            yield Found(float(replay.time[k]), (i,), measured={"drop_m": float(drop.max())})
        else:
            most = float(np.max(drop, initial=0.0, where=np.isfinite(drop)))
            yield Found(None, (i,), f"drops by {most:.2f} m (needs {FALLEN_BY * height:.2f} m)")


def _slid_off(
    z: NDArray[np.float64], supported: NDArray[np.bool_], over: NDArray[np.bool_], begin: int
) -> bool:
    """Whether what stood on its support before frame `begin` is still coming down then."""
    on_it = np.flatnonzero((supported & over)[:begin])
    if not len(on_it):
        return False
    last = int(on_it[-1])
    rested = supported[last:begin] & (z[last:begin] < z[last] - _LOWER_M)
    return not rested.any()


def is_over(replay: Replay, body: int, support: int) -> NDArray[np.bool_]:
    """Frames at which a body's centre is above the outline of its support (with its own width)."""
    s = replay.scene.bodies[support]
    inverse = replay.quaternion[:, support] * np.array([-1.0, -1.0, -1.0, 1.0])
    offset = replay.position[:, body] - replay.position[:, support]
    local = quat_rotate(inverse, offset) - np.array(s.origin_offset)
    slack = max(replay.scene.bodies[body].half_extents[:2])
    half = np.array(s.half_extents[:2]) + slack
    return np.all(np.abs(local[:, :2]) <= half, axis=1) & (local[:, 2] > 0.0)


def topples(replay: Replay, q: Query) -> Iterator[Found]:
    """Tilting by more than `TOPPLED_DEG` from the initial pose; who lies does not topple again."""
    begin = replay.after(q.since)
    for i in q.bound["object"].bodies:
        up = replay.up(i)
        tilt = np.degrees(np.arccos(np.clip(up @ up[0], -1.0, 1.0)))
        over = tilt > TOPPLED_DEG
        passes = 1 + np.flatnonzero(over[1:] & ~over[:-1])
        later = passes[passes >= begin]
        if len(later):
            k = int(later[0])
            yield Found(float(replay.time[k]), (i,), measured={"tilt_deg": float(tilt.max())})
        elif over[begin:].any():
            before = float(tilt[begin])
            yield Found(None, (i,), f"tilts by {before:.0f} degrees before the event could happen")
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


def reaches(replay: Replay, q: Query) -> Iterator[Found]:
    """Coming within `REACH_M` of the target's surface from farther away."""
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
