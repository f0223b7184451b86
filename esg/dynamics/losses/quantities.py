"""The quantities that a prompt prescribes for an event: how each is measured, and how well met."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from esg.dynamics.losses.measures import DISTANCE_SCALE_M, gap_over_time
from esg.dynamics.losses.recording import Floats, Recording
from esg.graph.models import EdgeEvent, EventConstraint, TimelineNode
from esg.units import yaw_from_quat

TIME_SCALE_S = 0.1
SPEED_SCALE_MPS = 0.25
ANGLE_SCALE_DEG = 5.0

Times = dict[str, Floats]
"""Time of every event so far [s], NaN where it did not happen, each of shape [W]."""
Distance = Callable[[Recording, Times, TimelineNode, EventConstraint], Floats]
"""Recording, times, event, constraint -> the distance [m] that a prompt means there, shape [W]."""
Measured = Callable[[Recording, Times, TimelineNode, EventConstraint, Distance], Floats]
"""Recording, times, event, constraint, the event's `Distance` -> SI value, shape [W]."""


@dataclass(frozen=True)
class Quantity:
    """One quantity of a constraint.

    Args:
        measure: Its value in SI units (angles: degrees).
        scale: An error of this size costs 1.
        tolerance: Largest error that still counts as met.
        unit: Of the document.
        si: Document's unit in units of `measure`.
        drift: Share of its value by which restitution + 0.1 or friction - 20% alone moves it.
    """

    measure: Measured
    scale: float
    tolerance: float
    unit: str
    si: float = 1.0
    drift: float = 0.0


def _time_since(
    rec: Recording, times: Times, node: TimelineNode, c: EventConstraint, _: Distance
) -> Floats:
    return times[node.id] - times.get(c.since or "", np.zeros(rec.n))


def _time_to_stop(
    rec: Recording, times: Times, node: TimelineNode, c: EventConstraint, _: Distance
) -> Floats:
    return times[node.id] - brake_start(rec, times, c.object)


def _speed_after(
    rec: Recording, times: Times, node: TimelineNode, c: EventConstraint, _: Distance
) -> Floats:
    return rec.extreme(rec.speed[:, :, _body(rec, c)], times[node.id], 0.0, 0.12)


def _speed_before(
    rec: Recording, times: Times, node: TimelineNode, c: EventConstraint, _: Distance
) -> Floats:
    return rec.at(rec.speed[:, :, _body(rec, c)], times[node.id] - 1.5 / rec.fps)


def _height(
    rec: Recording, times: Times, node: TimelineNode, c: EventConstraint, _: Distance
) -> Floats:
    return rec.at(rec.r.position[:, :, _body(rec, c), 2].astype(float), times[node.id])


def _angle(
    rec: Recording, times: Times, node: TimelineNode, c: EventConstraint, _: Distance
) -> Floats:
    yaw = np.unwrap(yaw_from_quat(rec.r.quaternion[:, :, _body(rec, c)]), axis=1)
    return np.degrees(np.abs(rec.at(yaw, times[node.id]) - yaw[:, 0]))


def _distance(
    rec: Recording, times: Times, node: TimelineNode, c: EventConstraint, distance: Distance
) -> Floats:
    if c.to is not None:
        gap = gap_over_time(rec, [_body(rec, c)], rec.members(c.to))
        return rec.at(gap, times[node.id])
    return distance(rec, times, node, c)


QUANTITIES = {
    "time": Quantity(_time_since, TIME_SCALE_S, 0.15, "s"),
    "time_since": Quantity(_time_since, TIME_SCALE_S, 0.15, "s"),
    "time_to_stop": Quantity(_time_to_stop, TIME_SCALE_S, 0.15, "s", drift=0.05),
    "speed_after": Quantity(_speed_after, SPEED_SCALE_MPS, 0.4, "cm/s", 0.01, drift=0.08),
    "speed_before": Quantity(_speed_before, SPEED_SCALE_MPS, 0.4, "cm/s", 0.01),
    "distance": Quantity(_distance, DISTANCE_SCALE_M, 0.1, "cm", 0.01),
    "height": Quantity(_height, DISTANCE_SCALE_M, 0.1, "cm", 0.01),
    "angle": Quantity(_angle, ANGLE_SCALE_DEG, 5.0, "deg"),
}
"""By name; `time` is that of an event itself, which no constraint but its window prescribes."""


def quantity_of(name: str) -> Quantity:
    """The quantity of a constraint called "event id/quantity/object"."""
    return QUANTITIES[name.split("/")[1]]


# -- what a distance is -------------------------------------------------------------------------


def covered(rec: Recording, times: Times, node: TimelineNode, c: EventConstraint) -> Floats:
    """From a body's start to where it is when the event happens."""
    body = _body(rec, c)
    return _moved(rec, times[node.id], body, rec.r.position[:, :1, body].astype(float))


def braked(rec: Recording, times: Times, node: TimelineNode, c: EventConstraint) -> Floats:
    """The way in which a body stops, which begins with its braking."""
    body = _body(rec, c)
    position = rec.r.position[:, :, body].astype(float)
    begin = brake_start(rec, times, c.object)
    start = np.stack([rec.at(position[..., k], begin) for k in range(3)], axis=-1)
    return _moved(rec, times[node.id], body, start[:, None])


def nearest(rec: Recording, times: Times, node: TimelineNode, c: EventConstraint) -> Floats:
    """The least distance of the event's two participants."""
    a, b = (rec.members(p) for p in (node.participants[0], node.participants[-1]))
    return gap_over_time(rec, a, b, near_only=True).min(axis=1)


def brake_start(rec: Recording, times: Times, actor: str) -> Floats:
    """When an actor begins to brake [s], shape [W]; 0 where it never does."""
    for phase in rec.story.phases.get(actor, ()):
        if phase.edge.event is EdgeEvent.BRAKE:
            return times[phase.start.id]
    return np.zeros(rec.n)


def _moved(rec: Recording, time: Floats, body: int, start: Floats) -> Floats:
    """Distance of a body from a place [W, 1, 3] at a time [m], shape [W]."""
    position = rec.r.position[:, :, body].astype(float)
    return rec.at(np.linalg.norm(position - start, axis=-1), time)


def _body(rec: Recording, c: EventConstraint) -> int:
    return rec.scene.index(c.object) if c.object in rec.scene.names else 0
