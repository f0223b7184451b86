"""What something thrown does after its first event: it flies on, is thrown back, or falls on."""

from __future__ import annotations

from dataclasses import dataclass, replace
import math

from esg.dynamics.choreography.falling.throws import is_lobbed, region_of
from esg.dynamics.choreography.stage import Encounter, Stage, speed_is_fixed
from esg.dynamics.story.kinematics import Frame, half_along, rubbed
from esg.dynamics.story.story import Phase, Story
from esg.graph.models import NamedRegion, NodeEvent, ProxyKind, TimelineNode
from esg.units import GRAVITY_MPS2

PASSES = (NodeEvent.MISS, NodeEvent.REACH)
BANK_S, BANK_FALL_MPS = 0.125, 1.5
"""A bank shot: time from the board to the hoop, and how fast the ball falls at the board."""
LOW_M = 0.6
"""What is lower is landed on, what is higher is hit in its side."""
HIGHEST_HIT_M = 1.4
"""Height at which a wall is hit that something bounces off."""
LEAST_HAND_M = 0.4
"""Least height from which something is thrown at a wall."""
CLEAR_M = 0.05
LEAST_FLIGHT_S = 0.3
FLAT = 0.25
"""Longest flight [s] past something, over the root of its way [m]: no high lob."""


@dataclass(frozen=True)
class Arc:
    """A body in free flight after an event.

    Args:
        x, y: Where its centre is [m].
        z: Height of its centre [m].
        heading: Of its flight [rad].
        speed: Along the heading [m/s].
        rise: Upwards [m/s].
    """

    x: float
    y: float
    z: float
    heading: float
    speed: float
    rise: float

    def time_to(self, height: float) -> float:
        """When it comes down to a height [s]; at its highest point if that is lower."""
        under = self.rise**2 + 2.0 * GRAVITY_MPS2 * (self.z - height)
        return max((self.rise + math.sqrt(max(under, 0.0))) / GRAVITY_MPS2, 0.0)


def flown_to(story: Story, phase: Phase) -> Phase:
    """The phase at whose end a throw comes to what it is meant for: what it passes by is not.

    Args:
        story: The story.
        phase: A phase of something thrown.
    """
    phases = story.phases[phase.edge.actor]
    k = next(i for i, p in enumerate(phases) if p.edge.id == phase.edge.id)
    while phases[k].end.event in PASSES and k + 1 < len(phases):
        follows = phases[k + 1]
        if follows.start.id != phases[k].end.id or follows.edge.params.speed is not None:
            break
        k += 1
    return phases[k]


def took_off(stage: Stage, a: str, phase: Phase, duration: float) -> None:
    """Keeps the time of a whole throw where its first part passed by something."""
    for first in stage.story.phases[a]:
        if first.edge.id == phase.edge.id:
            return
        if flown_to(stage.story, first).edge.id == phase.edge.id:
            if not phase.end.time_is_prescribed:
                way = math.hypot(stage.tracks[a].x, stage.tracks[a].y)
                duration = min(duration, max(FLAT * math.sqrt(way), LEAST_FLIGHT_S))
            stage.nominal[f"{first.edge.id}/flight_time"] = duration
            return


def leaves(stage: Stage, node: TimelineNode, a: str, b: str) -> None:
    """Notes how a thrown body goes on from the event it was thrown at: the way it came.

    Args:
        stage: The stage, with a and b in their places.
        node: The event: a hit, or a region entered from above.
        a: The thrown body.
        b: What it met.
    """
    arc = _arrival(stage, node, a, b)
    if arc is not None:
        stage.arcs[a] = arc


def _arrival(stage: Stage, node: TimelineNode, a: str, b: str) -> Arc | None:
    """The flight of a as it comes to b."""
    phase = next((p for p in stage.story.phases[a] if p.end.id == node.id), None)
    duration = stage.nominal.get(f"{phase.edge.id}/flight_time") if phase else None
    if not duration or a not in stage.heights or a not in stage.places or b not in stage.places:
        return None
    pa, pb = stage.prop(a), stage.prop(b)
    x, y, yaw = stage.places[b]
    start = stage.places[a]
    region = region_of(stage, node)
    height = 0.5 * pb.height
    if region is not None:
        cx, cy, cz = (v / 100.0 for v in region.center_cm)
        x, y = Frame(x, y, yaw or 0.0).apply(cx, cy)
        height = cz
    heading = math.atan2(y - start[1], x - start[0])
    if region is None:
        reach = pa.half_length + half_along(pb.length, pb.width, (yaw or 0.0) - heading)
        x, y = x - reach * math.cos(heading), y - reach * math.sin(heading)
    way = math.hypot(x - start[0], y - start[1])
    drop = stage.heights[a] + 0.5 * pa.height - height
    rise = -drop / duration - 0.5 * GRAVITY_MPS2 * duration
    return Arc(x, y, height, heading, way / duration, rise)


def slowed(stage: Stage, a: str, share: float) -> None:
    """Leaves a flight a share of its speed, after a hit of something that gives way."""
    arc = stage.arcs[a]
    stage.arcs[a] = replace(arc, speed=share * arc.speed)


def hits_level(stage: Stage, node: TimelineNode, a: str, b: str) -> bool:
    """Has a flight meet a wall at its highest point: what falls by then is down soon after.

    Args:
        stage: The stage.
        node: The hit.
        a: The body in flight.
        b: The wall.

    Returns:
        Whether the flight could be changed to that: from its own start, at a free speed.
    """
    phase = next((p for p in stage.story.phases.get(a, ()) if p.end.id == node.id), None)
    if phase is None or a not in stage.arcs or phase is not stage.story.phases[a][0]:
        return False
    name = f"{phase.edge.id}/"
    duration = stage.nominal.get(f"{name}flight_time")
    if duration is None or speed_is_fixed(phase):
        return False
    pa, pb, arc = stage.prop(a), stage.prop(b), stage.arcs[a]
    height = min(max(0.5 * pb.height, 0.6), HIGHEST_HIT_M)
    rise = height - 0.5 * pa.height - LEAST_HAND_M
    if rise < CLEAR_M or height > pb.height - 0.5 * pa.height:
        return False
    if not phase.end.time_is_prescribed:
        faster = min(duration, math.sqrt(2.0 * rise / GRAVITY_MPS2))
        stage.tracks[a].time -= duration - faster
        arc = replace(arc, speed=arc.speed * duration / faster)
        duration = stage.nominal[f"{name}flight_time"] = faster
    bottom = height - 0.5 * GRAVITY_MPS2 * duration**2 - 0.5 * pa.height
    if bottom < CLEAR_M:
        return False
    stage.heights[a] = bottom
    stage.arcs[a] = replace(arc, z=height, rise=0.0)
    stage.nominal[f"{name}goal_beyond"] = -pa.half_width
    stage.nominal[f"{name}goal_above"] = height
    return True


def thrown_back(
    stage: Stage, a: str, heading: float, restitution: float, friction: float, tilt: float
) -> None:
    """Turns a flight round at a wall.

    Args:
        stage: The stage.
        a: The body in flight.
        heading: Of its way back [rad].
        restitution: Of the hit.
        friction: Between the two.
        tilt: Angle between its way to the wall and the wall's normal [rad].
    """
    arc = stage.arcs[a]
    hit, along = arc.speed * math.cos(tilt), arc.speed * math.sin(tilt)
    kept = 1.0 - rubbed(friction, restitution, hit, math.hypot(along, arc.rise))
    speed = math.hypot(restitution * hit, kept * along)
    stage.arcs[a] = Arc(arc.x, arc.y, arc.z, heading, speed, kept * arc.rise)


def flies_on(stage: Stage, e: Encounter) -> bool:
    """Whether a is in free flight after its last event, and b has no place so far."""
    return e.a in stage.arcs and e.b not in stage.places


def fly_on(stage: Stage, e: Encounter) -> None:
    """Puts b where a's flight after its last event comes down."""
    node, a, b = e.node, e.a, e.b
    arc, track = stage.arcs.pop(a), stage.tracks[a]
    pa, pb = stage.prop(a), stage.prop(b)
    region = region_of(stage, node) if node.event is NodeEvent.ENTER_REGION else None
    yaw, back = arc.heading + math.pi, 0.0
    if region is not None:
        height = mouth_height(stage, node, region)
        back = region.center_cm[0] / 100.0
    elif pb.height < LOW_M:
        height = pb.height + 0.5 * pa.height
    else:
        height = 0.6 * pb.height
        back = pa.half_length + half_along(pb.length, pb.width, yaw - arc.heading)
    lasts = arc.time_to(height)
    way = arc.speed * lasts
    before = stage.met.get(a)
    if before is not None and before in stage.places:
        # Clear of what it comes from, so that the two do not stand in each other.
        px, py, turned = stage.places[before]
        c, s = math.cos(arc.heading), math.sin(arc.heading)
        first = stage.prop(before)
        if region is None or first.height > height:
            beside = (px - arc.x) * c + (py - arc.y) * s
            beside += half_along(first.length, first.width, (turned or 0.0) - arc.heading)
            way = max(way, beside + 0.5 * math.hypot(pb.length, pb.width) + CLEAR_M)
    x = arc.x + (way + back) * math.cos(arc.heading)
    y = arc.y + (way + back) * math.sin(arc.heading)
    stage.places[b] = (x, y, yaw)
    track.time += max(lasts, 0.05)
    stage.time[node.id] = track.time
    stage.met[a] = b


def mouth_height(stage: Stage, node: TimelineNode, region: NamedRegion) -> float:
    """Height [m] at which something comes into the region of an event."""
    lift = 0.5 if is_lobbed(stage, node) else 0.0
    return (region.center_cm[2] + lift * region.half_extents_cm[2]) / 100.0


def banked_into(stage: Stage, node: TimelineNode, a: str, b: str) -> TimelineNode | None:
    """The event that a thrown body enters a region of the very thing it bounces off, or None."""
    actor = node.event is NodeEvent.COLLISION and stage.story.is_active(a)
    if not actor or not stage.story.flies(a):
        return None
    for phase in stage.story.phases[a]:
        end = phase.end
        into = end.event is NodeEvent.ENTER_REGION and phase.start.id == node.id
        if into and (end.region or "").split("/")[0] == stage.member(b):
            return end
    return None


def banks(stage: Stage, e: Encounter) -> bool:
    """Whether a is thrown into a region of b by way of the board behind it."""
    return e.b not in stage.places and _board_shot(stage, e) is not None


def bank(stage: Stage, e: Encounter) -> None:
    """A bank shot: over the hoop's rim at the board behind it and back into the hoop."""
    shot = _board_shot(stage, e)
    assert shot is not None
    enters, region, face = shot
    node, a, phase, b = e.node, e.a, e.coming, e.b
    pa, pb = stage.prop(a), stage.prop(b)
    cx, _, cz = (v / 100.0 for v in region.center_cm)
    top = cz + region.half_extents_cm[2] / 100.0
    restitution = max(0.5 * (pa.restitution + pb.restitution), 0.1)
    speed = max(cx - face - pa.half_width, 0.02) / (restitution * BANK_S)
    fall = BANK_FALL_MPS
    kept = 1.0 - rubbed(0.5 * (pa.friction + pb.friction), restitution, speed, fall)
    height = top + kept * fall * BANK_S + 0.5 * GRAVITY_MPS2 * BANK_S**2
    start = 1.3
    gain = max(height - start, 0.0)
    lasts = (fall + math.sqrt(fall * fall + 2.0 * GRAVITY_MPS2 * gain)) / GRAVITY_MPS2
    way = face + pa.half_width + speed * lasts
    stage.places[b] = (0.0, 0.0, 0.0)
    stage.places[a] = (way, 0.0, math.pi)
    stage.frames[a] = Frame(way, 0.0, math.pi)
    stage.heights[a] = start - 0.5 * pa.height
    stage.nominal[f"{phase.edge.id}/speed"] = speed
    stage.nominal[f"{phase.edge.id}/flight_time"] = lasts
    stage.nominal[f"{phase.edge.id}/goal_beyond"] = cx - face - pa.half_width
    stage.nominal[f"{phase.edge.id}/goal_above"] = height - cz
    stage.tracks[a].straight(speed * lasts, lasts, speed)
    stage.time[node.id] = stage.tracks[a].time
    stage.time[enters.id] = stage.tracks[a].time + BANK_S


def _board_shot(stage: Stage, e: Encounter) -> tuple[TimelineNode, NamedRegion, float] | None:
    """The event that a enters a region of b after its hit, that region, and X of the board [m]."""
    enters = banked_into(stage, e.node, e.a, e.b)
    region = region_of(stage, enters) if enters is not None else None
    if enters is None or region is None:
        return None
    face = _board(stage, e.b, region)
    return None if face is None else (enters, region, face)


def _board(stage: Stage, b: str, region: NamedRegion) -> float | None:
    """X of the front face [m] of what stands behind and above a region, None if nothing does."""
    config = stage.prop(b).config
    faces: list[float] = []
    for proxy in config.proxies if config is not None else ():
        if proxy.kind is not ProxyKind.BOX:
            continue
        (x, y, z), (a, w, h) = proxy.position_cm, proxy.size_cm
        behind = x + a < region.center_cm[0] - 0.5 * region.half_extents_cm[0]
        above = z + h > region.center_cm[2] + 2.0 * region.half_extents_cm[2]
        if behind and above and abs(y - region.center_cm[1]) < w and w > a:
            faces.append((x + a) / 100.0)
    return max(faces, default=None)
