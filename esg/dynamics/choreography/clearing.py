"""Throws over something: a flight that is high enough, and whose top is over what it clears."""

from __future__ import annotations

import math

from esg.dynamics.choreography.hovering import stated_height, top_of
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.stagecraft import Prop
from esg.dynamics.story.story import Phase, bounds
from esg.graph.models import EdgeEvent, NodeEvent
from esg.units import GRAVITY_MPS2

ROOM_M = 0.3
"""Least height by which something thrown clears what it goes over."""
LEAST_RISE_M = 0.3
"""It rises by so much, however low that is."""
SAGS = 0.5
"""Share of that room which the flight may lose on its way over it."""
ROLLS_ON_S = 2.5
"""How long it rolls on behind it, where it is to stop."""
USUAL_MPS = 5.0
"""Its speed over the ground, where nothing asks for more."""


def thrown_over(stage: Stage, mover: str, other: str) -> tuple[float, float, float | None] | None:
    """Where something stands that a free throw clears: x, y [m], yaw [rad], broadside to its way.

    Args:
        stage: What is placed so far; the throw's nominal speed and elevation are written there.
        mover: What is thrown.
        other: What it goes over.

    Returns:
        None if the mover is on no free throw: it flies by itself, or an event ends its flight.
    """
    frame, phase = stage.frames.get(mover), stage.story.phases[mover][0]
    free = phase.end.event in (NodeEvent.TRIGGER, NodeEvent.STOP)
    thrown = phase.edge.event is EdgeEvent.TOWARD and stage.story.flies(mover)
    if frame is None or not (free and thrown) or stage.story.soars(mover):
        return None
    body, its = stage.prop(mover), stage.prop(other)
    lengthwise = its.length > its.width
    deep = 0.5 * (min(its.length, its.width)) + body.half_length
    begins = stated_height(stage, mover)
    if begins is not None:
        stage.heights[mover] = begins
    rise = max(top_of(stage, other) + ROOM_M - stage.heights.get(mover, 0.0), LEAST_RISE_M)
    up = math.sqrt(2.0 * GRAVITY_MPS2 * rise)
    along = max(USUAL_MPS, deep * math.sqrt(0.5 * GRAVITY_MPS2 / (SAGS * ROOM_M)))
    along = _within(phase, up, along)
    stage.nominal[f"{phase.edge.id}/speed"] = math.hypot(along, up)
    stage.nominal[f"{phase.edge.id}/elevation"] = math.atan2(up, along)
    top = along * up / GRAVITY_MPS2
    _flies_on(stage, mover, body, top)
    if phase.end.event is NodeEvent.STOP and not phase.end.time_is_prescribed:
        stage.time[phase.end.id] = 2.0 * up / GRAVITY_MPS2 + ROLLS_ON_S
    x, y = frame.apply(top, 0.0)
    return x, y, frame.angle + (math.pi / 2 if lengthwise else 0.0)


def _within(phase: Phase, up: float, along: float) -> float:
    """A speed over the ground [m/s] with which the whole stays within what the prompt states."""
    low, high, stated = bounds(phase.edge.params.speed, (0.0, 1e6))
    if not (stated or phase.edge.speed_is_prescribed):
        return along
    least, most = (math.sqrt(max((0.01 * v) ** 2 - up**2, 0.25)) for v in (low, high))
    return min(max(along, least), most)


def _flies_on(stage: Stage, mover: str, body: Prop, top: float) -> None:
    """Its way is told as far as the ground behind what it clears."""
    track = stage.tracks[mover]
    if len(track.points) >= 2:
        track.points[-1] = (2.0 * top + body.half_length, 0.0)
