"""Off the lip of a chute: what comes down it falls into what stands below."""

from __future__ import annotations

from dataclasses import dataclass
import math

from esg.dynamics.choreography.falling.throws import is_lobbed, region_of
from esg.dynamics.choreography.slopes import (
    OVER_CREST_MPS,
    SAMPLE_M,
    Ride,
    Slope,
    chute_of,
    come_down,
    ride_of,
)
from esg.dynamics.choreography.stage import Encounter, Stage, speed_is_fixed
from esg.dynamics.story.kinematics import Frame
from esg.dynamics.story.stagecraft import support_of
from esg.dynamics.story.story import bounds
from esg.units import GRAVITY_MPS2

SETS_OFF_MPS = 0.3
"""Speed at the top of what rolls: let go, with a nudge."""
HARDEST = 1.6
"""Most that the search may send it off with, over that: faster, it would fly off the crest."""
SHORT_OF = 0.25
"""How far before the middle of an opening something comes over its rim, over half the opening: it
goes on forward while it falls in."""


@dataclass(frozen=True)
class Leap:
    """The way through the air from a lip to the height of a rim.

    Args:
        way: Along the ground [m].
        lasts: How long it takes [s].
        left: Speed along the ground [m/s].
    """

    way: float
    lasts: float
    left: float


def leap(speed: float, fall: float, drop: float) -> Leap:
    """The way of what leaves a lip, until it has come down by so much.

    Args:
        speed: Along the chute [m/s].
        fall: Of the chute per way.
        drop: From the lip to the rim [m].
    """
    along = max(speed, 0.05) / math.hypot(1.0, fall)
    down = fall * along
    lasts = (math.sqrt(down * down + 2.0 * GRAVITY_MPS2 * max(drop, 0.0)) - down) / GRAVITY_MPS2
    return Leap(along * lasts, lasts, along)


def drop_needed(speed: float, fall: float, way: float) -> float:
    """How far [m] what leaves a lip comes down on a way [m] along the ground; see `leap`."""
    along = max(speed, 0.05) / math.hypot(1.0, fall)
    return fall * way + 0.5 * GRAVITY_MPS2 * (way / along) ** 2


def falls_in(stage: Stage, e: Encounter) -> bool:
    """Whether a chute ends over the rim of what a shall end up in, which waits on the ground."""
    if stage.anchor is None or e.a != stage.lead or stage.lifted or stage.story.flies(e.a):
        return False
    if e.b in stage.places or e.a in stage.frames or stage.tracks[e.a].time > 0.0:
        return False
    name = stage.member(e.b)
    if name == stage.anchor or support_of(stage.doc, name) is not None:
        return False
    chute = chute_of(stage.doc, stage.anchor)
    return chute is not None and is_lobbed(stage, e.node) and chute.lip > stage.prop(e.b).height


def fall_in(stage: Stage, e: Encounter) -> None:
    """It is let go at the top; what it falls into stands where it comes down to the rim."""
    assert stage.anchor is not None
    slope = chute_of(stage.doc, stage.anchor)
    assert slope is not None
    ride, track = ride_of(stage.prop(e.a), stage.prop(stage.anchor)), stage.tracks[e.a]
    start = slope.crest - stage.inset(e.a)
    low, _, _ = bounds(e.coming.edge.params.speed, (0.0, 0.0))
    speed = 0.01 * low if speed_is_fixed(e.coming) else first_speed(slope, ride, start)
    time, left = come_down(slope, ride, start, speed).at(slope.foot - SAMPLE_M)
    if not math.isfinite(time):
        time, left = 1.0, speed
    flight = leap(left, fall_per_way(slope), slope.lip - stage.prop(e.b).height)
    region = region_of(stage, e.node)
    mouth = 0.0 if region is None else min(region.half_extents_cm[:2]) / 100.0
    way = slope.foot - start + flight.way + SHORT_OF * mouth
    track.straight(way, time + flight.lasts, flight.left)
    stage.nominal[f"{e.coming.edge.id}/speed"] = speed
    stage.nominal[f"{e.coming.edge.id}/at_most"] = HARDEST * speed
    frame = stage.frames.setdefault(e.a, Frame())
    stage.places[e.a] = (*frame.apply(0.0, 0.0), frame.angle)
    heading = track.heading + frame.angle
    stage.places[e.b] = (*frame.apply(track.x, track.y), heading + math.pi)
    stage.time[e.node.id] = track.time


def first_speed(slope: Slope, ride: Ride, start: float) -> float:
    """Speed [m/s] at the top with which something gets over the crest, and not off it."""
    over_top = math.sqrt(2.0 * ride.on_slope * GRAVITY_MPS2 * max(slope.crest - start, 0.0))
    return over_top + (OVER_CREST_MPS if ride.roll == 0.0 else SETS_OFF_MPS)


def fall_per_way(slope: Slope) -> float:
    """How steep a chute is between its crest and its lip."""
    return (slope.height - slope.lip) / max(slope.foot - slope.crest, 1e-6)
