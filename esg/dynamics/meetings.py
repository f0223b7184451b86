"""How participants of the choreography meet: hits, chains of hits, drops and entered regions."""

from __future__ import annotations

import math

from esg.dynamics.falls import can_land, land, tip_onto
from esg.dynamics.impacts import chain, impact
from esg.dynamics.kinematics import (
    Frame,
    braking_distance,
    frame_mapping,
    lob_time,
)
from esg.dynamics.moves import plain
from esg.dynamics.placing import asked_distance, goes_on, join
from esg.dynamics.stage import FASTEST_MPS, Stage, speed_is_fixed
from esg.dynamics.stagecraft import (
    approach_distance,
    fall_speed,
    min_hit_speed,
    push_speed,
    slide,
    support_of,
    sure_topple_speed,
)
from esg.dynamics.story import Phase, bounds
from esg.dynamics.throws import drop, hand_height, slowest_passage
from esg.graph.models import EdgeEvent, NodeEvent, TimelineNode

MAX_APPROACH_M = 45.0
GAPPED = (NodeEvent.MISS, NodeEvent.REACH)
LOB_M = 1.0
"""Way of a throw into an open container."""
MEETING_HEIGHT_M = 1.2
"""Height at which bodies are thrown at each other."""
AFTER_BOUNCE_M, AFTER_BOUNCE_S = 0.5, 0.3
"""Longest way from a wall to what is hit after bouncing off it, unless it takes less than that."""
SLID = 0.55
"""Share of its speed with which something slid along the ground arrives."""
AFTER_HIT_S, BEHIND_M = 1.2, 0.5
"""From one's hit of an obstacle to its being run into, and the least gap behind it at the start."""
CHAINED = 0.6
"""Share of the usual impulse and run-up of a ball that starts a chain of balls."""
STAY_S = 0.28
"""What rolls through an opening is in it for at least this long."""
FLIGHT_S, LONGEST_THROW_M = 0.3, 12.0
"""Usual flight time of a throw at something, and its longest way."""


def collision(stage: Stage, node: TimelineNode) -> None:
    """Collision, Reach, Miss: who is on the way to whom decides how they come together."""
    if len(node.participants) < 2:
        plain(stage, node)
        return
    a, b = stage.key(node.participants[0]), stage.key(node.participants[1])
    incoming = dict(stage.incoming(node))
    if a not in incoming and b in incoming:
        a, b = b, a
    if a in incoming and _waits_at_obstacle(stage, b):
        _run_into(stage, node, a, incoming[a], b, incoming.get(b))
    elif b in incoming and _waits_at_obstacle(stage, a):
        a, b = b, a
        _run_into(stage, node, a, incoming[a], b, incoming.get(b))
    elif a in incoming and b in incoming:
        _meeting(stage, node, a, incoming[a], b, incoming[b])
    elif a in incoming:
        _approach(stage, node, a, incoming[a], b)
    else:
        chain(stage, node, a, b)
    impact(stage, node, a, b)
    stage.met[a] = b


def enters(stage: Stage, node: TimelineNode) -> None:
    """The target region's owner is put in the way, its opening towards the mover."""
    mover = stage.key(node.participants[0])
    owner = (node.region or "/").split("/")[0]
    incoming = dict(stage.incoming(node))
    if owner not in stage.doc.spatial_relation_graph.nodes:
        return
    if mover in incoming:
        _approach(stage, node, mover, incoming[mover], owner)
    elif mover in stage.moving:
        chain(stage, node, mover, owner)
    if owner in stage.places:
        x, y, _ = stage.places[owner]
        track = stage.moving.get(mover) or stage.tracks.get(mover)
        heading = (
            track.heading + (stage.frames[mover].angle if mover in stage.frames else 0.0)
            if track
            else 0.0
        )
        stage.places[owner] = (x, y, heading + math.pi)
        stage.time[node.id] = track.time if track else 1.0
    stage.time.setdefault(node.id, 1.0)


def _approach(stage: Stage, node: TimelineNode, a: str, phase: Phase, b: str) -> None:
    """An active body runs, rolls or flies at a target that waits."""
    if can_land(stage, a, b):
        land(stage, node, a, b)
        return
    if a in stage.tipped:
        tip_onto(stage, node, a, b)
        return
    track, pa, pb = stage.tracks[a], stage.prop(a), stage.prop(b)
    let_go = phase.edge.event is EdgeEvent.TOWARD and phase.edge.params.speed is not None
    if let_go and bounds(phase.edge.params.speed, (0.0, 0.0))[1] <= 1.0:
        drop(stage, node, a, b)
        return
    prescribed = stage.prescribed_time(node)
    least = min_hit_speed(pa, pb)
    chained = pa.rolls and pb.rolls and goes_on(stage, node, b)
    if chained:
        # Slow and close: the less way there is, the less an error of the aim grows.
        least *= CHAINED
    elif goes_on(stage, node, b):
        least = max(least, push_speed(pa, pb))
    topples = stage.story.topples(stage.member(b))
    needed = sure_topple_speed(pa, pb, flies=stage.story.flies(a)) if topples else 0.0
    if stage.story.falls(stage.member(b)) and phase.edge.event is EdgeEvent.TOWARD:
        needed = max(needed, fall_speed(pa, pb))
    speed = stage.speed(a, phase, max(least, needed), needed)
    asked = asked_distance(stage, node, a) if node.event not in GAPPED else None
    if asked is not None and not speed_is_fixed(phase):
        speed = asked / max(0.15, prescribed - track.time) if prescribed is not None else speed
    if phase.edge.event is EdgeEvent.BRAKE:
        speed = track.speed or speed
        distance, duration, left = _brake_into(stage, phase, speed, prescribed, track.time)
    elif _slides(stage, a, phase):
        wait = None if prescribed is None else max(0.15, prescribed - track.time)
        free = not speed_is_fixed(phase)
        if needed > 0.0 and not phase.edge.speed_is_prescribed:
            # What it is to arrive with is less than what it starts with.
            speed = max(speed, min(needed / SLID, FASTEST_MPS))
        speed, distance, duration, left = slide(pa, speed, wait, stage.rng, adjustable=free)
        distance = max(distance, descent(stage, b), _room_after(stage, a, b))
        stage.nominal[f"{phase.edge.id}/speed"] = speed
    else:
        run = approach_distance(pa, speed, stage.rng) * stage.tight
        if chained:
            run *= CHAINED
        if a in stage.thrown_back:
            run = min(run, max(AFTER_BOUNCE_M, AFTER_BOUNCE_S * track.speed))
        run = max(run, descent(stage, b))
        flies, inside = stage.story.flies(a), node.event is NodeEvent.ENTER_REGION
        if inside and not flies and not speed_is_fixed(phase):
            speed = min(speed, max(slowest_passage(stage, node) / STAY_S, 0.3))
        if flies and not inside and stage.anchor is None:
            run = max(run, min(FLIGHT_S * speed, LONGEST_THROW_M))
        if prescribed is not None:
            duration = max(0.15, prescribed - track.time)
            if inside and flies and not speed_is_fixed(phase):
                speed = min(speed, LOB_M / duration)
        elif inside and flies and not speed_is_fixed(phase):
            # Steep enough to come down through an opening that looks up.
            run = LOB_M
            way = (asked or run) + pb.half_length
            duration = lob_time(way, hand_height(stage, node, b, pa, pb) - pb.height)
            speed = (asked or run) / duration
        else:
            duration = (asked or run) / speed
        distance = asked or _covers(stage, a, phase, speed, duration)
        if prescribed is None:
            distance = max(distance, _room_after(stage, a, b))
            duration = distance / speed
        left = speed
        if distance > MAX_APPROACH_M and not speed_is_fixed(phase):
            speed = left = MAX_APPROACH_M / duration
            distance = MAX_APPROACH_M
        stage.nominal[f"{phase.edge.id}/speed"] = speed
    track.straight(distance, duration, left)
    if stage.story.flies(a):
        stage.heights[a] = hand_height(stage, node, b, pa, pb)
        stage.nominal[f"{phase.edge.id}/flight_time"] = duration
    join(stage, a, b, node)


def _covers(stage: Stage, actor: str, phase: Phase, speed: float, duration: float) -> float:
    """Way [m] of an actor in a given time: what was let go at a fixed speed slows down.

    Where the speed is open, it starts that much faster instead (`variables.damping_loss`).
    """
    let_go = phase.edge.event is EdgeEvent.TOWARD and not stage.story.flies(actor)
    if not let_go or not speed_is_fixed(phase):
        return speed * duration
    return braking_distance(speed, stage.prop(actor).damping, duration)


def _room_after(stage: Stage, a: str, b: str) -> float:
    """Least way [m] from one target to the next: past the first, which may lie there."""
    before = stage.met.get(a)
    if before is None or before == b:
        return 0.0
    first, second = stage.prop(before), stage.prop(b)
    if a in stage.thrown_back:
        # Its way leads away from what it bounced off.
        return max(AFTER_BOUNCE_M, AFTER_BOUNCE_S * stage.tracks[a].speed)
    fallen = first.height if stage.story.topples(stage.member(before)) else 0.0
    return max(first.length, first.width, 0.8 * fallen) + 0.5 * second.half_length + 0.3


def descent(stage: Stage, b: str) -> float:
    """Least run [m] on a support whose target waits on the ground: past the support's end."""
    if stage.anchor is None or support_of(stage.doc, stage.member(b)) == stage.anchor:
        return 0.0
    if stage.member(b) == stage.anchor:
        return 0.0
    return stage.prop(stage.anchor).length + 0.4


def _slides(stage: Stage, actor: str, phase: Phase) -> bool:
    """Pushed or slid along the ground, so that friction takes its speed."""
    body = stage.prop(actor)
    flat = not stage.story.flies(actor)
    return phase.edge.event is EdgeEvent.TOWARD and flat and not (body.rolls or body.wheeled)


def _brake_into(
    stage: Stage, phase: Phase, speed: float, prescribed: float | None, now: float
) -> tuple[float, float, float]:
    """Braking that still ends in a hit: at most half of the speed is left."""
    low, high, _ = bounds(phase.edge.params.damping, (0.3, 6.0))
    left = 0.38
    duration = (
        max(0.2, prescribed - now) if prescribed is not None else float(stage.rng.uniform(0.7, 1.0))
    )
    damping = min(max(-math.log(left) / duration, low), high)
    stage.nominal[f"{phase.edge.id}/damping"] = damping
    distance = braking_distance(speed, damping, duration)
    return distance, duration, speed * math.exp(-damping * duration)


def _meeting(stage: Stage, node: TimelineNode, a: str, pa: Phase, b: str, pb: Phase) -> None:
    """Two active bodies meet: one catches up with the other, or they run at each other."""
    braking = [p.edge.event is EdgeEvent.BRAKE for p in (pa, pb)]
    rear = braking[0] != braking[1] or _same_direction(stage, a, b)
    if rear:
        front, behind = (a, b) if braking[0] or _is_front(stage, a) else (b, a)
        phases = {a: pa, b: pb}
        _rear_end(stage, node, behind, phases[behind], front, phases[front])
        return
    time = stage.prescribed_time(node)
    start = max(stage.tracks[a].time, stage.tracks[b].time)
    for actor, phase in ((a, pa), (b, pb)):
        speed = stage.speed(actor, phase)
        stage.nominal[f"{phase.edge.id}/speed"] = speed
        if time is None:
            time = start + approach_distance(stage.prop(actor), speed, stage.rng) / speed
        track = stage.tracks[actor]
        duration = max(0.2, time - track.time)
        track.straight(_covers(stage, actor, phase, speed, duration), duration, speed)
        if stage.story.flies(actor):
            # Thrown at where the other one starts, it would be there in twice the time.
            stage.nominal[f"{phase.edge.id}/flight_time"] = 2.0 * duration
            stage.heights[actor] = MEETING_HEIGHT_M
    frame = stage.frames.setdefault(a, Frame())
    ta, tb = stage.tracks[a], stage.tracks[b]
    heading = ta.heading + frame.angle
    x, y = frame.apply(ta.x, ta.y)
    reach = stage.prop(a).half_length + stage.prop(b).half_length
    meet = (x + reach * math.cos(heading), y + reach * math.sin(heading))
    stage.frames[b] = frame_mapping((tb.x, tb.y), tb.heading, meet, heading + math.pi)
    for actor in (a, b):
        ox, oy = stage.frames[actor].apply(0.0, 0.0)
        stage.places[actor] = (ox, oy, stage.frames[actor].angle)


def _waits_at_obstacle(stage: Stage, name: str) -> bool:
    """Whether an actor has run into something and is there, or pushes it along."""
    if name not in stage.met or name not in stage.tracks or name not in stage.frames:
        return False
    return not (stage.story.flies(name) or name in stage.thrown_back or name in stage.airborne)


def _run_into(
    stage: Stage, node: TimelineNode, behind: str, chase: Phase, front: str, lead: Phase | None
) -> None:
    """One runs into another that met an obstacle before: from behind, the only way surely free.

    Args:
        stage: The stage.
        node: Their meeting.
        behind: Who comes, without a place so far.
        chase: Its phase that ends there.
        front: Who met the obstacle.
        lead: Its phase that ends there, None where it rests.
    """
    rear, ahead = stage.tracks[behind], stage.tracks[front]
    speed = stage.speed(behind, chase, min_hit_speed(stage.prop(behind), stage.prop(front)))
    time = stage.prescribed_time(node) or ahead.time + AFTER_HIT_S
    if lead is not None:
        wait = max(time - ahead.time, 0.2)
        left = stage.speed(front, lead)
        if lead.edge.event is EdgeEvent.BRAKE:
            way, _, left = _brake_into(stage, lead, ahead.speed, time, ahead.time)
        else:
            if not speed_is_fixed(lead):
                left = min(left, 0.6 * speed)
            stage.nominal[f"{lead.edge.id}/speed"] = left
            way = left * wait
        ahead.straight(way, wait, left)
    reach = stage.prop(behind).half_length + stage.prop(front).half_length
    first = ahead.points[-1]
    covered = max(math.dist(first, p) for p in ahead.points)
    least = covered + reach + BEHIND_M
    duration = max(0.2, time - rear.time)
    if speed * duration < least and not speed_is_fixed(chase):
        speed = min(least / duration, max(speed, FASTEST_MPS))
    if speed * duration < least and stage.prescribed_time(node) is None:
        duration = least / speed
    stage.nominal[f"{chase.edge.id}/speed"] = speed
    rear.straight(speed * duration, duration, speed)
    stage.time[node.id] = rear.time
    frame = stage.frames[front]
    heading = ahead.heading + frame.angle
    x, y = frame.apply(ahead.x, ahead.y)
    touch = (x - reach * math.cos(heading), y - reach * math.sin(heading))
    if behind not in stage.frames:
        stage.frames[behind] = frame_mapping((rear.x, rear.y), rear.heading, touch, heading)
    x, y = stage.frames[behind].apply(0.0, 0.0)
    turned = stage.frames[behind].angle + stage.reverse_yaw(behind)
    stage.places[behind] = (x, y, turned)


def _rear_end(
    stage: Stage, node: TimelineNode, behind: str, chase: Phase, front: str, lead: Phase
) -> None:
    """One runs into the back of another that brakes or is slower."""
    rear, ahead = stage.tracks[behind], stage.tracks[front]
    speed = stage.speed(behind, chase)
    began = ahead.time
    time = stage.prescribed_time(node) or began + float(stage.rng.uniform(1.0, 1.4))
    if lead.edge.event is EdgeEvent.BRAKE:
        distance, _, left = _brake_into(stage, lead, ahead.speed, time, began)
    else:
        left = stage.speed(front, lead)
        if left >= 0.85 * speed:
            if speed_is_fixed(chase):
                left = 0.6 * speed
            else:
                speed = left / 0.6
        stage.nominal[f"{lead.edge.id}/speed"] = left
        distance = left * (time - began)
    stage.nominal[f"{chase.edge.id}/speed"] = speed
    ahead.straight(distance, time - began, left)
    rear.straight(speed * (time - rear.time), time - rear.time, speed)
    gap = max(rear.x - ahead.x, 0.3)
    reach = stage.prop(behind).half_length + stage.prop(front).half_length
    stage.frames[behind] = Frame()
    stage.frames[front] = Frame(gap + reach, 0.0, 0.0)
    stage.places[behind] = (0.0, 0.0, 0.0)
    stage.places[front] = (gap + reach, 0.0, 0.0)


def _same_direction(stage: Stage, a: str, b: str) -> bool:
    words = " ".join(stage.doc.spatial_relation_graph.nodes[n].label.lower() for n in (a, b))
    return any(w in words.split() for w in ("front", "rear", "lead", "leading", "following"))


def _is_front(stage: Stage, a: str) -> bool:
    words = stage.doc.spatial_relation_graph.nodes[a].label.lower().split()
    return any(w in words for w in ("front", "lead", "leading"))
