"""Smooth residuals of the events: what each pulls on in a taped rollout (`smooth`).

An event with a derivative depends on a `Signal`: the distance of two bodies, the speed of one, the
way of one into a region. It happens when that falls below a limit, or at the touch of two bodies.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses.gap import surface_gap
from esg.dynamics.losses.measures import DISTANCE_SCALE_M
from esg.dynamics.losses.shapes import MISSED, squared
from esg.dynamics.plan import Plan
from esg.graph.models import TimelineNode
from esg.thresholds import NEAR_M, STOPPED_MPS
from esg.units import quat_rotate

if TYPE_CHECKING:
    from esg.dynamics.losses.smooth import EventLosses
    from esg.engines.surrogate.tape import Touch

Floats = NDArray[np.float64]
States = tuple[Floats, Floats, Floats]
"""Positions, orientations and velocities of all bodies, each of shape [K, B, 3 or 4]."""


@dataclass(frozen=True)
class Signal:
    """A number that depends on the state of some bodies at one moment.

    Args:
        bodies: Their indices.
        value: States [K] -> [K].
        moving: Whether it depends on velocities too.
    """

    bodies: tuple[int, ...]
    value: Callable[[States], Floats]
    moving: bool = False


@dataclass(frozen=True)
class Threshold:
    """An event begins when a signal falls below a limit; an error of `scale` costs 1."""

    signal: Signal
    limit: float
    scale: float


ThresholdOf = Callable[[Plan, TimelineNode], Threshold]

# -- signals -------------------------------------------------------------------------------------


def members(plan: Plan, node: TimelineNode) -> tuple[list[int], list[int]]:
    """Body indices of an event's first and last participant, plurals expanded."""
    names, expand = plan.scene.names, plan.story.expand
    one, two = (
        [names.index(m) for m in expand(p) if m in names]
        for p in (node.participants[0], node.participants[-1])
    )
    return one, two


def gap(plan: Plan, one: list[int], two: list[int]) -> Signal:
    """Surface distance of the nearest of two sets of bodies [m]."""
    bodies = plan.scene.bodies
    pairs = [(i, j) for i in one for j in two if bodies[i].shapes and bodies[j].shapes]

    def value(s: States) -> Floats:
        gaps = [
            surface_gap(bodies[i], bodies[j], s[0][:, i], s[1][:, i], s[0][:, j], s[1][:, j])
            for i, j in pairs
        ]
        return np.min(gaps, axis=0) if gaps else np.full(len(s[0]), 100.0)

    return Signal(tuple(sorted({*one, *two})), value)


def speed(body: int) -> Signal:
    """Speed of a body [m/s]."""
    return Signal((body,), lambda s: np.linalg.norm(s[2][:, body], axis=-1), moving=True)


def away(body: int, goal: Floats) -> Signal:
    """Distance of a body's centre from a place [3] [m]."""
    return Signal((body,), lambda s: np.linalg.norm(s[0][:, body] - goal, axis=-1))


# -- when an event begins ------------------------------------------------------------------------


def nearness(plan: Plan, node: TimelineNode) -> Threshold:
    """One comes close to another."""
    return Threshold(gap(plan, *members(plan, node)), NEAR_M, DISTANCE_SCALE_M)


def speed_of(plan: Plan, node: TimelineNode) -> Threshold:
    """One comes to rest."""
    return Threshold(speed(plan.scene.index(node.participants[0])), STOPPED_MPS, 1.0)


def way_to(plan: Plan, node: TimelineNode) -> Threshold:
    """One comes to a place."""
    body = plan.scene.index(node.participants[0])
    if node.position_cm is None:
        return _at_once(body)
    goal = np.array(node.position_cm) / 100.0
    return Threshold(away(body, goal), DISTANCE_SCALE_M, DISTANCE_SCALE_M)


def way_into(plan: Plan, node: TimelineNode) -> Threshold:
    """One comes into a region."""
    scene = plan.scene
    body = scene.index(node.participants[0])
    region = next((r for r in scene.regions if r.name == node.region), None)
    if region is None:
        return _at_once(body)
    parent = scene.index(region.parent)
    center, half = np.array(region.center), np.array(region.half_extents)

    def beyond(s: States) -> Floats:
        inverse = s[1][:, parent] * np.array([-1.0, -1.0, -1.0, 1.0])
        local = quat_rotate(inverse, s[0][:, body] - s[0][:, parent]) - center
        return np.linalg.norm(np.maximum(np.abs(local) - 0.9 * half, 0.0), axis=-1)

    scale = max(0.3 * DISTANCE_SCALE_M, float(half.max()))
    return Threshold(Signal((body, parent), beyond), 1e-3, scale)


def _at_once(body: int) -> Threshold:
    return Threshold(Signal((body,), lambda s: np.zeros(len(s[0]))), 1.0, 1.0)


# -- events --------------------------------------------------------------------------------------


def collision(losses: EventLosses, node: TimelineNode, worlds: list[int], since: Floats) -> None:
    """At the touch of the two; where there is none, by their least distance."""
    touches = losses.touches(node, since)
    for w in worlds:
        touch = touches[w]
        if touch is not None:
            losses.happened(node, w, touch.time, touch.step, _moves_touch(losses, node, w, touch))
            continue
        signal = gap(losses.plan, *members(losses.plan, node))
        step, least = losses.lowest(w, signal, float(since[w]))
        losses.missed(node, w, step, signal, max(least, 0.0), DISTANCE_SCALE_M)


def _moves_touch(
    losses: EventLosses, node: TimelineNode, w: int, touch: Touch
) -> Callable[[float], None]:
    def move_time(slope: float) -> None:
        if touch.contact >= 0:
            losses.delay(w, touch, slope)
        else:
            signal = gap(losses.plan, *members(losses.plan, node))
            losses.crossing(w, touch.step, signal, slope)

    return move_time


def miss(losses: EventLosses, node: TimelineNode, worlds: list[int], since: Floats) -> None:
    """Where the two do not touch, when they are nearest."""
    touches = losses.touches(node, since)
    for w in worlds:
        signal = gap(losses.plan, *members(losses.plan, node))
        step, least = losses.lowest(w, signal, 0.0)
        if touches[w] is not None and not losses.plan.story.meet_again(node):
            losses.loss[w] += MISSED
            continue
        losses.begins(node, w, step * losses.dt)
        slope = losses.term(f"{node.id}/near", w, max(least - 0.5, 0.0), squared(1.0))
        losses.pull(w, step, signal, slope)


def crossing(
    threshold_of: ThresholdOf, *, after_above: float | None = None
) -> Callable[[EventLosses, TimelineNode, list[int], Floats], None]:
    """Residuals of an event that happens when a signal falls below its limit.

    Args:
        threshold_of: The signal and its limit.
        after_above: The signal must have been above that before.
    """

    def residual(losses: EventLosses, node: TimelineNode, worlds: list[int], since: Floats) -> None:
        threshold = threshold_of(losses.plan, node)
        for w in worlds:
            _cross(losses, node, w, threshold, float(since[w]), after_above)

    return residual


def _cross(
    losses: EventLosses,
    node: TimelineNode,
    w: int,
    threshold: Threshold,
    since: float,
    after_above: float | None,
) -> None:
    signal, limit = threshold.signal, threshold.limit
    series = signal.value(losses.at(w, slice(None)))
    late = np.arange(losses.n_steps + 1) * losses.dt >= since - 1e-9
    if after_above is not None:
        late &= np.maximum.accumulate(series > after_above)
    below = np.flatnonzero((series <= limit) & late)
    if not len(below):
        step = int(np.argmin(np.where(late, series, np.inf)))
        losses.missed(node, w, step, signal, float(series[step]) - limit, threshold.scale)
        return
    step = max(int(below[0]), 1)
    before, after = float(series[step - 1]), float(series[step])
    share = np.clip((before - limit) / (before - after), 0.0, 1.0) if before > after else 1.0
    time = (step - 1 + share) * losses.dt
    losses.happened(node, w, time, step, lambda slope: losses.crossing(w, step, signal, slope))


def position(losses: EventLosses, node: TimelineNode, worlds: list[int], since: Floats) -> None:
    """At its time, by the distance from the place; without one, when it comes there."""
    if node.timestamp is None:
        crossing(way_to)(losses, node, worlds, since)
        return
    threshold = way_to(losses.plan, node)
    signal = threshold.signal
    for w in worlds:
        step = min(round(node.timestamp / losses.dt), losses.n_steps)
        value = float(signal.value(losses.at(w, slice(step, step + 1)))[0])
        losses.begins(node, w, step * losses.dt, happens=value < threshold.limit)
        slope = losses.term(f"{node.id}/distance", w, value, squared(threshold.scale))
        losses.pull(w, step, signal, slope)
