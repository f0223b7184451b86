"""How participants of the choreography meet: hits, chains of hits, drops and entered regions."""

from __future__ import annotations

import math

from esg.dynamics.falls import can_land, land, tip_onto
from esg.dynamics.kinematics import (
    Frame,
    Track,
    braking_distance,
    frame_mapping,
    half_along,
    impact_speed,
    sliding_distance,
)
from esg.dynamics.moves import plain
from esg.dynamics.stage import Stage, speed_is_fixed
from esg.dynamics.stagecraft import (
    Prop,
    approach_distance,
    fall_speed,
    min_hit_speed,
    push_speed,
    release_height,
    slide,
    support_of,
    target_yaw,
    topple_speed,
)
from esg.dynamics.story import REACH_BRAKE_DAMPING, Phase, bounds
from esg.graph.models import EdgeEvent, NodeEvent, TimelineNode

MAX_APPROACH_M = 45.0
GAPPED = (NodeEvent.MISS, NodeEvent.REACH)
LOB_S, LOB_SPEED_MPS = 1.15, 1.6
"""Flight time and horizontal speed of a throw into an open container."""


def collision(stage: Stage, node: TimelineNode) -> None:
    """Collision, Reach, Miss: who is on the way to whom decides how they come together."""
    if len(node.participants) < 2:
        plain(stage, node)
        return
    a, b = stage.key(node.participants[0]), stage.key(node.participants[1])
    incoming = dict(stage.incoming(node))
    if a not in incoming and b in incoming:
        a, b = b, a
    if a in incoming and b in incoming:
        _meeting(stage, node, a, incoming[a], b, incoming[b])
    elif a in incoming:
        _approach(stage, node, a, incoming[a], b)
    else:
        _chain(stage, node, a, b)
    _impact(stage, node, a, b)
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
        _chain(stage, node, mover, owner)
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


def _impact(stage: Stage, node: TimelineNode, a: str, b: str) -> None:
    """After the hit, b runs on along a's heading and a keeps the rest of the momentum."""
    if a in stage.tracks and a in stage.frames:
        source, frame = stage.tracks[a], stage.frames[a]
    else:
        source, frame = stage.moving.get(a, Track()), Frame()
    stage.time[node.id] = source.time
    if node.event is not NodeEvent.COLLISION or b in stage.tracks:
        return
    pa, pb = stage.prop(a), stage.prop(b)
    if pb.fixed or b not in stage.places:
        return
    speed = impact_speed(pa.mass, pb.mass, source.speed, 0.5 * (pa.restitution + pb.restitution))
    x, y, _ = stage.places[b]
    heading = source.heading + frame.angle
    stage.moving[b] = Track(x, y, heading, speed, source.time, [(x, y)])
    source.speed = max(0.05, source.speed - pb.mass / pa.mass * speed)


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
        _drop(stage, node, a, b)
        return
    prescribed = stage.prescribed_time(node)
    least = min_hit_speed(pa, pb)
    if _goes_on(stage, node, b):
        least = max(least, push_speed(pa, pb))
    topples = stage.story.topples(stage.member(b))
    needed = topple_speed(pa, pb, flies=stage.story.flies(a)) if topples else 0.0
    if stage.story.falls(stage.member(b)) and phase.edge.event is EdgeEvent.TOWARD:
        needed = max(needed, fall_speed(pa, pb))
    speed = stage.speed(a, phase, max(least, needed), needed)
    asked = _asked_distance(stage, node, a) if node.event not in GAPPED else None
    if asked is not None and not speed_is_fixed(phase):
        speed = asked / max(0.15, prescribed - track.time) if prescribed is not None else speed
    if phase.edge.event is EdgeEvent.BRAKE:
        speed = track.speed or speed
        distance, duration, left = _brake_into(stage, phase, speed, prescribed, track.time)
    elif _slides(stage, a, phase):
        wait = None if prescribed is None else max(0.15, prescribed - track.time)
        free = not speed_is_fixed(phase)
        speed, distance, duration, left = slide(pa, speed, wait, stage.rng, adjustable=free)
        distance = max(distance, descent(stage, b), _room_after(stage, a, b))
        stage.nominal[f"{phase.edge.id}/speed"] = speed
    else:
        run = approach_distance(pa, speed, stage.rng) * stage.tight
        run = max(run, descent(stage, b))
        lob = node.event is NodeEvent.ENTER_REGION and stage.story.flies(a)
        if prescribed is not None:
            duration = max(0.15, prescribed - track.time)
        elif lob:
            # Steep enough to come down through an opening that looks up.
            duration = LOB_S
            speed = min(speed, LOB_SPEED_MPS)
        else:
            duration = (asked or run) / speed
        distance = asked or speed * duration
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
        stage.heights[a] = release_height(pa, pb)
        stage.nominal[f"{phase.edge.id}/flight_time"] = duration
    _join(stage, a, b, node)


def _room_after(stage: Stage, a: str, b: str) -> float:
    """Least way [m] from one target to the next: past the first, which may lie there."""
    before = stage.met.get(a)
    if before is None or before == b:
        return 0.0
    first, second = stage.prop(before), stage.prop(b)
    fallen = first.height if stage.story.topples(stage.member(before)) else 0.0
    return max(first.length, first.width, 0.8 * fallen) + 0.5 * second.half_length + 0.3


def _asked_distance(stage: Stage, node: TimelineNode, a: str) -> float | None:
    """Distance [m] the prompt has `a` cover until the event, or None.

    At an event without a hit it is the gap that is left between the two.
    """
    for c in node.constraints:
        if c.quantity == "distance" and c.object == stage.member(a):
            low, high, _ = bounds(c.value, (100.0, 100.0))
            return max(0.005 * (low + high), 0.1)
    return None


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


def _goes_on(stage: Stage, node: TimelineNode, b: str) -> bool:
    """Whether more is said of the target after this hit."""
    later = stage.story.after(node.id)
    return any(b in map(stage.key, n.participants) for n in later)


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


def _join(stage: Stage, a: str, b: str, node: TimelineNode) -> None:
    """Puts the end of a's track at b's surface, by placing whichever is still free."""
    track, pa = stage.tracks[a], stage.prop(a)
    if b not in stage.places:
        frame = stage.frames.setdefault(a, Frame() if not stage.places else stage.free_frame())
        x, y = frame.apply(track.x, track.y)
        _place_target(stage, a, b, x, y, track.heading + frame.angle, pa, node)
    elif a not in stage.frames:
        bx, by, byaw = stage.places[b]
        heading = stage.free_heading(bx, by)
        pb = stage.prop(b)
        reach = pa.half_length + half_along(pb.length, pb.width, heading - (byaw or 0.0))
        end = (bx - reach * math.cos(heading), by - reach * math.sin(heading))
        stage.frames[a] = frame_mapping((track.x, track.y), track.heading, end, heading)
    x, y = stage.frames[a].apply(0.0, 0.0)
    stage.places[a] = (x, y, stage.frames[a].angle + stage.reverse_yaw(a))


def _place_target(
    stage: Stage, a: str, b: str, x: float, y: float, heading: float, pa: Prop, node: TimelineNode
) -> None:
    """Puts b where a arrives: ahead of it, past it for a Miss, short of it for a Reach."""
    pb = stage.prop(b)
    yaw = target_yaw(pb, heading, stage.rng)
    lateral = float(stage.rng.uniform(-0.12, 0.12)) * min(
        pb.half_lateral(yaw - heading), pa.half_width
    )
    front = pa.half_length + half_along(pb.length, pb.width, yaw - heading)
    if node.event is NodeEvent.MISS:
        gap = _asked_distance(stage, node, a) or 0.25
        lateral = pa.half_width + pb.half_lateral(yaw - heading) + gap
        front = 0.0
    if node.event is NodeEvent.REACH:
        # Room to come to rest after the hold ends.
        front += 0.15 + stage.tracks[a].speed / REACH_BRAKE_DAMPING
        stage.nominal[f"{node.id}/time"] = stage.tracks[a].time
    cx = x + front * math.cos(heading) - lateral * math.sin(heading)
    cy = y + front * math.sin(heading) + lateral * math.cos(heading)
    stage.places[b] = (cx, cy, yaw)
    _bring_support(stage, b, cx, cy, heading)


def _bring_support(stage: Stage, b: str, x: float, y: float, heading: float) -> None:
    """A target that stands on a table is met near the table's edge: the table comes along."""
    support = support_of(stage.doc, stage.member(b))
    if support is None or support == stage.anchor or support in stage.places:
        return
    ps = stage.prop(support)
    yaw = target_yaw(ps, heading, stage.rng)
    inset = max(
        0.0, half_along(ps.length, ps.width, yaw - heading) - stage.prop(b).half_length - 0.08
    )
    if stage.story.falls(b):
        # What shall be knocked off stands at the far edge.
        inset = -inset
    stage.places[support] = (x + inset * math.cos(heading), y + inset * math.sin(heading), yaw)


def _chain(stage: Stage, node: TimelineNode, a: str, b: str) -> None:
    """A passive body set in motion by an earlier hit runs on into the next one."""
    if a not in stage.moving and b in stage.moving:
        a, b = b, a
    track = stage.moving.get(a)
    if track is None or b in stage.places:
        return
    pa, pb = stage.prop(a), stage.prop(b)
    gap = _coasting_gap(stage, pa, track.speed) * stage.tight
    if pa.height > 2.5 * pa.length and not pa.rolls:
        # Tall and thin: it topples onto the next one, which stands within its reach.
        gap = min(gap, 0.5 * pa.height)
    prescribed = stage.prescribed_time(node)
    if prescribed is not None:
        gap = max(0.1, track.speed * (prescribed - track.time))
    yaw = target_yaw(pb, track.heading, stage.rng)
    jitter = float(stage.rng.uniform(-0.3, 0.3)) * pb.half_lateral(yaw - track.heading)
    reach = gap + pa.half_length + half_along(pb.length, pb.width, yaw - track.heading)
    c, s = math.cos(track.heading), math.sin(track.heading)
    stage.places[b] = (track.x + reach * c - jitter * s, track.y + reach * s + jitter * c, yaw)
    _bring_support(stage, b, stage.places[b][0], stage.places[b][1], track.heading)
    track.straight(gap, gap / max(track.speed, 0.1), track.speed)


def _coasting_gap(stage: Stage, body: Prop, speed: float) -> float:
    """Free run [m] to the next target that a body set in motion surely covers."""
    reach = 50.0 if body.rolls else sliding_distance(speed, 0.5 * (body.friction + 0.7))
    preferred = float(stage.rng.uniform(0.28, 0.36)) * speed
    return max(0.05, min(preferred, 0.4 * reach, 2.5))


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
        track.straight(speed * duration, duration, speed)
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


def _drop(stage: Stage, node: TimelineNode, a: str, b: str) -> None:
    """A body let go above its target, at the prescribed height or a metre up."""
    pb = stage.prop(b)
    stage.places.setdefault(b, (0.0, 0.0, 0.0))
    x, y, _ = stage.places[b]
    stated = [c for n in (node, *stage.story.nodes.values()) for c in n.constraints]
    height = next(
        (
            sum(bounds(c.value, (1, 1))[:2]) / 200.0
            for c in stated
            if c.quantity == "height" and c.object == stage.member(a)
        ),
        1.0,
    )
    stage.places[a] = (x, y, 0.0)
    stage.frames[a] = Frame(x, y, 0.0)
    stage.heights[a] = pb.height + height
    stage.tracks[a].time += math.sqrt(2.0 * height / 9.81)
