"""Ways through something: a tunnel, a gate, an open door stands around the last leg of a way."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
import math

from esg.dynamics.choreography.courses.chutes import first_speed
from esg.dynamics.choreography.setting_off import ride_of as gains
from esg.dynamics.choreography.slopes import AT_FOOT_M, SAMPLE_M, come_down, ride_of, slope_of
from esg.dynamics.choreography.stage import Stage, speed_is_fixed
from esg.dynamics.story.kinematics import Frame, Ride
from esg.dynamics.story.stagecraft import coasting_drag
from esg.dynamics.story.story import Phase, Story
from esg.graph.models import EdgeEvent, EsgDocument, NamedRegion, NodeEvent, Predicate, Statement

SPANS = 0.95
"""Share of a thing's length that a way through it spans at least."""
BEFORE_M, BEHIND_M = 0.6, 0.4
"""Free way before and behind it, from the mover's ends."""
LONGEST_S = 15.0
"""Longest time that a way is made longer for."""
GOES_ON_S, CLIMBS = 0.8, 0.6
"""How long what goes up a ramp goes on up there, and the least share of the ramp that it climbs."""
FILE_M = 0.8
"""Gap between those that go through one behind the other."""
HARDEST = 1.6
"""Most that the search may send off what goes down a slope and on through something, over the usual
speed at the top."""
ROLLS_MPS = 0.5
"""Speed that what rolls or slides through something has left when it is out of it."""


@dataclass(frozen=True)
class Passage:
    """What leads through a thing along its own X axis.

    Args:
        owner: The thing that stands.
        long: Its length [m].
        wide: Free width [m].
        high: Free height [m].
    """

    owner: str
    long: float
    wide: float
    high: float


def passage_of(doc: EsgDocument, name: str) -> Passage | None:
    """The way through a thing, or of a leaf, through the frame that it hangs in; else None."""
    joints = doc.spatial_relation_graph.joints or ()
    frame = next((j.parent for j in joints if j.child == name and j.kind == "hinge"), None)
    for owner in (name, frame):
        if owner is None or owner not in doc.spatial_relation_graph.nodes:
            continue
        config = doc.asset_configurations[doc.spatial_relation_graph.nodes[owner].asset_id]
        for region in config.regions:
            if _leads_through(region, config.dimensions_cm[0]):
                return Passage(owner, *(0.02 * half for half in region.half_extents_cm))
    return None


def _leads_through(region: NamedRegion, length: float) -> bool:
    low = region.center_cm[2] - region.half_extents_cm[2] < 1.0
    return region.name == "inside" and low and 2.0 * region.half_extents_cm[0] >= SPANS * length


def ways_through(doc: EsgDocument, story: Story) -> Iterator[tuple[Statement, Passage]]:
    """The statements of a way of one mover through one thing that lets it through."""
    for s in doc.statements or ():
        if s.predicate is not Predicate.MOVES or s.direction != "through":
            continue
        if len(s.object) != 1 or len(s.target) != 1:
            continue
        found = passage_of(doc, s.target[0])
        moves = s.object[0] in story.phases
        if moves and found is not None and found.owner not in story.phases:
            yield s, found


def let_go_down(stage: Stage) -> None:
    """What is let go at the top of a ramp and meets nothing: down to the foot, and off the ramp."""
    slope = slope_of(stage.doc, stage.anchor) if stage.anchor is not None else None
    first, *more = stage.story.phases[stage.lead]
    lets_go = first.edge.event is EdgeEvent.TOWARD and not stage.story.flies(stage.lead)
    if slope is None or not lets_go or more:
        return
    if first.end.event is NodeEvent.TRIGGER and not first.end.time_is_prescribed:
        start = slope.crest - stage.inset(stage.lead)
        off = stage.prop(stage.lead).half_length + AT_FOOT_M + SAMPLE_M
        _let_go(stage, stage.lead, start, slope.foot - start + off)


def lead_through(stage: Stage) -> None:
    """Puts what is gone through around the ways, and makes these long enough."""
    first: dict[str, str] = {}
    for s, passage in ways_through(stage.doc, stage.story):
        mover = s.object[0]
        if mover not in stage.tracks or not _goes_on_the_ground(stage, mover, passage):
            continue
        key = stage.key(passage.owner)
        if passage.owner in first:
            _follow(stage, mover, first[passage.owner], passage)
        elif key not in stage.places and key != stage.anchor:
            _place(stage, mover, passage)
            first[passage.owner] = mover


def lead_up(stage: Stage, mover: str, other: str) -> tuple[float, float, float] | None:
    """Where a ramp stands that a way leads up: x, y [m], yaw [rad]; None where none can.

    The way ends where what goes on for a moment is still on the ramp's top.
    """
    slope, frame = slope_of(stage.doc, stage.member(other)), stage.frames.get(mover)
    track, phases = stage.tracks[mover], stage.story.phases[mover]
    free = len(phases) == 1 and phases[0].end.event is NodeEvent.TRIGGER
    if slope is None or frame is None or not free or stage.anchor is not None:
        return None
    if stage.story.flies(mover) or phases[0].edge.event is EdgeEvent.TOWARD:
        return None
    before = BEFORE_M + stage.prop(mover).half_length
    up = before + slope.foot - slope.crest
    lengthen(stage, mover, max(up - GOES_ON_S * track.speed, before + CLIMBS * (up - before)))
    heading = frame.angle + track.heading
    x, y = frame.apply(0.0, 0.0)
    at = before + slope.foot
    return x + at * math.cos(heading), y + at * math.sin(heading), heading + math.pi


def _goes_on_the_ground(stage: Stage, mover: str, passage: Passage) -> bool:
    """Whether a mover has room in a passage, and a way that an event does not end."""
    body, last = stage.prop(mover), stage.story.phases[mover][-1]
    free = last.end.event in (NodeEvent.TRIGGER, NodeEvent.STOP)
    straight = last.edge.event is not EdgeEvent.TURN and len(stage.tracks[mover].points) >= 2
    return free and straight and not stage.story.flies(mover) and body.width < passage.wide


def _place(stage: Stage, mover: str, passage: Passage) -> None:
    """The passage around the last leg of a way: behind the foot of a slope, if it is on one."""
    body, frame = stage.prop(mover), stage.frames.get(mover)
    if frame is None:
        return
    before = BEFORE_M + body.half_length
    needed = before + passage.long + body.half_length + BEHIND_M
    slope = slope_of(stage.doc, stage.anchor) if stage.anchor is not None else None
    if slope is not None and mover == stage.lead and stage.anchor is not None:
        start = slope.crest - stage.inset(mover)
        before += slope.foot - start
        needed += slope.foot - start
        _let_go(stage, mover, start, needed)
    elif stage.anchor is None:
        lengthen(stage, mover, needed)
    else:
        return
    (x0, y0), (x1, y1) = (frame.apply(*p) for p in stage.tracks[mover].points[-2:])
    heading, way = math.atan2(y1 - y0, x1 - x0), math.hypot(x1 - x0, y1 - y0)
    at = max(before + 0.5 * passage.long, 0.0 if slope is not None else 0.5 * way)
    stage.places[stage.key(passage.owner)] = (
        x0 + at * math.cos(heading), y0 + at * math.sin(heading), heading,
    )  # fmt: skip


def _follow(stage: Stage, mover: str, ahead: str, passage: Passage) -> None:
    """Who goes through the same thing comes behind who was there first, on the same line."""
    frame, behind = stage.frames[ahead], 0.0
    for other in stage.tracks:
        its = stage.frames.get(other)
        if other != mover and its is not None and its.angle == frame.angle:
            dx, dy = frame.x - its.x, frame.y - its.y
            along = dx * math.cos(frame.angle) + dy * math.sin(frame.angle)
            if abs(-dx * math.sin(frame.angle) + dy * math.cos(frame.angle)) < 0.1:
                behind = max(behind, along + stage.prop(other).half_length)
    back = behind + FILE_M + stage.prop(mover).half_length
    x, y = frame.apply(-back, 0.0)
    stage.frames[mover] = Frame(x, y, frame.angle)
    turned = stage.reverse_yaw(mover)
    stage.places[mover] = (x, y, frame.angle + turned)
    px, py, _ = stage.places[stage.key(passage.owner)]
    to_middle = (px - x) * math.cos(frame.angle) + (py - y) * math.sin(frame.angle)
    out = to_middle + 0.5 * passage.long + stage.prop(mover).half_length + BEHIND_M
    lengthen(stage, mover, out)


def lengthen(stage: Stage, mover: str, way: float) -> None:
    """Makes the last leg of a mover's way so long [m] at least, if its time is open."""
    track, phase = stage.tracks[mover], stage.story.phases[mover][-1]
    (x0, y0), (x1, y1) = track.points[-2:]
    told = math.hypot(x1 - x0, y1 - y0)
    node = phase.end
    if told >= way or stage.prescribed_time(node) is not None or told <= 0.0:
        return
    more = _time_for(stage, mover, phase, way, told)
    if more is None or more > LONGEST_S:
        return
    track.x, track.y = x0 + (x1 - x0) * way / told, y0 + (y1 - y0) * way / told
    track.points[-1] = (track.x, track.y)
    track.time += more
    stage.time[node.id] = stage.time.get(node.id, 0.0) + more
    stage.nominal[f"{node.id}/time"] = stage.time[node.id]


def _time_for(stage: Stage, mover: str, phase: Phase, way: float, told: float) -> float | None:
    """How much longer [s] a way takes than the one that was told, None where nothing gets so far.

    What was let go starts fast enough to be under way when it is out.
    """
    name = f"{phase.edge.id}/speed"
    speed = stage.nominal.get(name, stage.tracks[mover].speed)
    drag = coasting_drag(stage.prop(mover))
    if phase.edge.event is not EdgeEvent.TOWARD or drag <= 0.0:
        ride = gains(stage, mover, phase, speed) if speed else Ride.under_way(0.1)
        return ride.lasts(way) - ride.lasts(told)
    fast = math.sqrt(ROLLS_MPS**2 + 2.0 * drag * way)
    if fast > speed and speed_is_fixed(phase):
        return None
    if fast > speed:
        stage.nominal[name] = speed = fast
    left = math.sqrt(max(speed * speed - 2.0 * drag * way, 0.0))
    return (speed - left) / drag - stage.time.get(phase.end.id, 0.0)


def _let_go(stage: Stage, mover: str, start: float, way: float) -> None:
    """What stands at the top of a slope is let go, and its way leads on behind the foot."""
    assert stage.anchor is not None
    slope, phase, track = (
        slope_of(stage.doc, stage.anchor), stage.story.phases[mover][-1], stage.tracks[mover],
    )  # fmt: skip
    if slope is None or len(stage.story.phases[mover]) > 1:
        return
    ride = ride_of(stage.prop(mover), stage.prop(stage.anchor))
    name = f"{phase.edge.id}/speed"
    speed = stage.nominal.get(name, 0.0)
    if not (speed_is_fixed(phase) or phase.edge.speed_is_prescribed):
        speed = first_speed(slope, ride, start)
        stage.nominal[name] = speed
        stage.nominal[f"{phase.edge.id}/at_most"] = HARDEST * speed
    time, left = come_down(slope, ride, start, speed).at(start + way - SAMPLE_M)
    if not math.isfinite(time):
        return
    stage.goes_down = True
    track.points[-1] = (way, 0.0)
    track.x, track.y, track.time, track.speed = way, 0.0, time, left
    stage.time[phase.end.id] = time
    stage.nominal[f"{phase.end.id}/time"] = time
