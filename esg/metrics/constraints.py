"""Measures the prompt-specified parameters of a suite on one replay (PPA)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
import math

import numpy as np

from esg.metrics.binding import Binding
from esg.metrics.detection import (
    Found,
)
from esg.metrics.events.space import surface_distance
from esg.metrics.models import ConstraintVerdict, SuiteConstraint, SuiteEvent
from esg.metrics.quantities import BASE_UNIT, DIMENSION_OF, score
from esg.metrics.replay import Replay
from esg.thresholds import MOVING_MPS, STOPPED_MPS
from esg.units import quat_rotate

START = "start"
_AFTER_S = 0.1
"""Window after an event's last contact in which speed_after is taken [s]."""
_GROUNDED_M = 0.02
"""What is no higher than this above the ground stands on it."""
_TERMINAL = {"stops", "falls", "topples", "enters", "reaches"}
"""Events that end a motion: a distance `event` to them is travelled up to them."""


@dataclass(frozen=True)
class Scored:
    """Everything a constraint may refer to.

    Args:
        replay: The replay.
        events: The suite's events by id.
        found: What the detectors found, by event id.
        bindings: Bindings by phrase.
    """

    replay: Replay
    events: Mapping[str, SuiteEvent]
    found: Mapping[str, Found]
    bindings: Mapping[str, Binding]


def measure(constraint: SuiteConstraint, world: Scored) -> ConstraintVerdict:
    """Measures and scores one constraint.

    An outcome constraint scores 0 if an event it refers to was not completed. Where its object is a
    set, the member that took part in the event counts; with an initial constraint every member must
    hold, so the worst one counts (suite format, "Constraints"; paper, PPA aggregation).
    """
    value, reason = _value(constraint, world)
    return _verdict(constraint, value, reason)


def unmeasured(constraint: SuiteConstraint, reason: str) -> ConstraintVerdict:
    """The verdict of a constraint in a run without a replay: score 0."""
    return _verdict(constraint, None, reason)


def _verdict(constraint: SuiteConstraint, value: float | None, reason: str) -> ConstraintVerdict:
    dimension = DIMENSION_OF[constraint.quantity]
    scores = [
        score(value, constraint.value, constraint.range, dimension, t)
        for t in ("standard", "strict", "lenient")
    ]
    target = constraint.range if constraint.range is not None else constraint.value
    return ConstraintVerdict(
        constraint=constraint.label,
        kind=constraint.kind,
        quantity=constraint.quantity,
        unit=BASE_UNIT[dimension],
        measured=value,
        score=scores[0],
        score_strict=scores[1],
        score_lenient=scores[2],
        target=0.0 if target is None else target,
        reason=reason,
    )


def _value(c: SuiteConstraint, world: Scored) -> tuple[float | None, str]:
    if not world.replay.valid:
        return None, "the simulation diverged"
    for name in (c.event, c.since, c.at):
        if name is None or name == START:
            continue
        if not world.found[name].completed:
            return None, f"event {name} was not completed"
    if c.quantity in ("time", "time_since"):
        time = _event_time(c.event, world)
        since = 0.0 if c.quantity == "time" else _event_time(c.since, world)
        return time - since, ""
    bodies, reason = _bodies(c, world)
    if not bodies:
        return None, reason
    values: list[float] = []
    for body in bodies:
        value, why = _of_body(c, body, world)
        if value is None:
            return None, why
        values.append(value)
    return max(values, key=lambda v: _violation(c, v)), ""


def _violation(c: SuiteConstraint, value: float) -> float:
    if c.range is not None:
        return max(0.0, c.range[0] - value, value - c.range[1])
    return abs(value - (c.value or 0.0))


def _event_time(name: str | None, world: Scored) -> float:
    if name is None or name == START:
        return 0.0
    return world.found[name].time or 0.0


def _bodies(c: SuiteConstraint, world: Scored) -> tuple[tuple[int, ...], str]:
    named = c.event or (c.at if c.at != START else None)
    took_part = world.found[named].bodies if named else ()
    took_part = tuple(i for i in took_part if i >= 0)
    if c.object is None:
        return took_part[:1], "no object"
    binding = world.bindings[c.object]
    if not binding.bodies:
        return (), binding.problem or f"{c.object!r} binds to no body"
    decided = tuple(i for i in binding.bodies if i in took_part)
    if not decided and not binding.plural:
        # "A skater" beside two others who only stand there: the one that the events are about.
        acting = {i for found in world.found.values() for i in found.bodies}
        decided = tuple(i for i in binding.bodies if i in acting)
    return decided or binding.bodies, ""


def _of_body(c: SuiteConstraint, body: int, world: Scored) -> tuple[float | None, str]:
    r = world.replay
    if c.quantity == "mass":
        return float(r.scene.bodies[body].mass), ""
    if c.quantity == "speed":
        return _speed(c, body, world), ""
    if c.quantity == "speed_after":
        return _speed_after(c, body, world), ""
    if c.quantity == "time_to_stop":
        return _time_to_stop(c, body, world)
    if c.quantity == "distance":
        return _distance(c, body, world)
    if c.quantity == "height":
        return _height(c, body, world), ""
    return _angle(c, body, world), ""


def start_frame(r: Replay, body: int) -> int:
    """First frame that shows the state the program starts a body with: frame 0, or the frame after
    its first motion primitive has fired (recordings of others may show frame 0 at rest).
    """
    motions = r.motions(body)
    if not motions:
        return 0
    fired = int(np.searchsorted(r.time, motions[0].time + 0.25 * r.frame_s, side="right"))
    return min(fired, len(r.time) - 1)


def _speed(c: SuiteConstraint, body: int, world: Scored) -> float:
    r = world.replay
    at = c.at or c.event or START
    if at == START:
        return float(max(r.speed[0, body], r.speed[start_frame(r, body), body]))
    return float(r.speed[r.frame_before(_event_time(at, world)), body])


def _last_contact(found: Found) -> float:
    return found.hit.end if found.hit is not None else (found.time or 0.0)


def _speed_after(c: SuiteConstraint, body: int, world: Scored) -> float:
    r = world.replay
    end = _last_contact(world.found[c.event or ""])
    first, last = r.frame_at(end), r.frame_at(end + _AFTER_S)
    return float(r.speed[first : last + 1, body].max())


def braking_start(r: Replay, body: int, stop: float) -> float:
    """When the braking that leads to a stop began [s]: the program's last braking before it, or,
    for a body that physics alone slows down, the last moment of its largest speed.
    """
    brakings = [t for t in r.brakings(body) if t < stop]
    if brakings:
        # Several brakings in a row are one manoeuvre as long as the body does not speed up between.
        begin = brakings[-1]
        for t in reversed(brakings[:-1]):
            part = r.speed[r.frame_at(t) : r.frame_at(begin) + 1, body]
            if np.any(np.diff(part) > 0.05):
                break
            begin = t
        return begin
    last = r.frame_at(stop)
    speed = r.speed[: last + 1, body]
    return float(r.time[last - int(np.argmax(speed[::-1]))])


def _time_to_stop(c: SuiteConstraint, body: int, world: Scored) -> tuple[float | None, str]:
    r = world.replay
    event = world.events.get(c.event or "")
    if event is not None and event.type == "stops":
        stop = world.found[event.id].time or 0.0
        return stop - braking_start(r, body, stop), ""
    # Given another event (its braking), the stop is looked for after it.
    since = _event_time(c.event, world)
    slow = np.flatnonzero((r.time > since) & (r.speed[:, body] < STOPPED_MPS))
    if not len(slow):
        return None, "never slower than 0.1 m/s"
    return float(r.time[slow[0]]) - since, ""


def _partner(c: SuiteConstraint, body: int, world: Scored) -> Binding | None:
    """The other end of a distance: `target`, else the other participant of the first event."""
    if c.target:
        return world.bindings[c.target]
    for event in world.events.values():
        phrases = [p for p in (event.a, event.b, event.object, event.target) if p]
        mine = [p for p in phrases if body in world.bindings[p].bodies]
        other = [p for p in phrases if body not in world.bindings[p].bodies]
        if mine and other:
            return world.bindings[other[0]]
    return None


def _distance(c: SuiteConstraint, body: int, world: Scored) -> tuple[float | None, str]:
    r = world.replay
    if c.target or (c.at == START and c.event is None):
        partner = _partner(c, body, world)
        if partner is None or not partner.bound:
            return None, "nothing to measure the distance to"
        at = c.at or c.event or START
        frame = 0 if at == START else r.frame_at(_event_time(at, world))
        return max(0.0, surface_distance(r, body, partner, frame)), ""
    begin, end = _travel(c, body, world)
    path = r.position[r.frame_at(begin) : r.frame_at(end) + 1, body, :2]
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum()), ""


def _travel(c: SuiteConstraint, body: int, world: Scored) -> tuple[float, float]:
    """Begin and end of the travelled distance [s]."""
    r = world.replay
    if c.at is not None:
        return _event_time(c.since, world), _event_time(c.at, world)
    event = world.events.get(c.event or "")
    time = _event_time(c.event, world)
    if event is None:
        return _event_time(c.since, world), r.end
    if event.type == "stops" and c.since is None:
        return (braking_start(r, body, time) if r.brakings(body) else 0.0), time
    if event.type in _TERMINAL:
        return _event_time(c.since, world), time
    slow = np.flatnonzero((r.time > time + _AFTER_S) & (r.speed[:, body] < STOPPED_MPS))
    return time, float(r.time[slow[0]]) if len(slow) else r.end


def _height(c: SuiteConstraint, body: int, world: Scored) -> float:
    """Height of the lowest point: at an instant (`at`), or the highest after an event (`event`).

    What stands on the ground at the start has no height above it but its own: "a counter 90 cm
    high".
    """
    r = world.replay
    if c.event is None:
        at = c.at or START
        asked = c.range[0] if c.range is not None else c.value or 0.0
        if at == START and asked > _GROUNDED_M and r.lowest(body, 0) < _GROUNDED_M:
            return 2.0 * float(r.scene.bodies[body].half_extents[2])
        return r.lowest(body, 0 if at == START else r.frame_before(_event_time(at, world)))
    first = r.frame_at(_last_contact(world.found[c.event]))
    top = first + int(np.argmax(r.position[first:, body, 2]))
    return r.lowest(body, top)


def _angle(c: SuiteConstraint, body: int, world: Scored) -> float:
    """By event type: turns the change of heading, topples the tilt, a contact the deflection of the
    velocity; at start the launch elevation, or the tilt of a body at rest. [deg]
    """
    r = world.replay
    name = c.event or c.at or START
    if name == START:
        frame = start_frame(r, body)
        v = r.velocity[frame, body]
        if np.linalg.norm(v) > MOVING_MPS:
            return math.degrees(math.atan2(float(v[2]), float(np.hypot(v[0], v[1]))))
        return _tilt(r, body, 0)
    found, event = world.found[name], world.events[name]
    if event.type == "turns":
        return float(found.measured.get("turned_deg", 0.0))
    if event.type in ("topples", "falls"):
        first = r.frame_at(found.time or 0.0)
        return max(_tilt(r, body, k) for k in range(first, len(r.time)))
    before = r.velocity[r.frame_before(found.time or 0.0), body]
    # One frame later: an engine may spread a bounce over the last step of the contact.
    after = r.velocity[min(r.frame_at(_last_contact(found)) + 1, len(r.time) - 1), body]
    norm = float(np.linalg.norm(before) * np.linalg.norm(after))
    if norm < 1e-9:
        return 0.0
    return math.degrees(math.acos(max(-1.0, min(1.0, float(before @ after) / norm))))


def _tilt(r: Replay, body: int, frame: int) -> float:
    up = quat_rotate(r.quaternion[frame, body], np.array([0.0, 0.0, 1.0]))
    return math.degrees(math.acos(max(-1.0, min(1.0, float(up[2])))))
