"""Two actors that meet: head-on, one behind the other, or one that waits at what it ran into."""

from __future__ import annotations

import math

from esg.dynamics.choreography import overtaking
from esg.dynamics.choreography.braking import brake_into, shortest
from esg.dynamics.choreography.falling.throws import asked_height, drop_height, fallen, is_dropped
from esg.dynamics.choreography.placing import gap_at_start
from esg.dynamics.choreography.setting_off import ride_of
from esg.dynamics.choreography.stage import FASTEST_MPS, Encounter, Stage, speed_is_fixed
from esg.dynamics.story.kinematics import (
    Frame,
    braking_distance,
    frame_mapping,
    half_along,
)
from esg.dynamics.story.sides import stated_side
from esg.dynamics.story.stagecraft import (
    approach_distance,
    ground_restitution,
    min_hit_speed,
)
from esg.dynamics.story.story import Phase
from esg.graph.models import EdgeEvent, NodeEvent, Side, TimelineNode
from esg.units import GRAVITY_MPS2

SLOWEST_MPS = 0.3
"""Least guessed speed of what meets in time where there is little room."""
LANDS_AFTER_S = 0.4
"""From what the target of a drop does before to the drop's end, where its height is open."""
LANDS_S, MEETS_AFTER_S = 0.55, 0.12
"""Fall of the lower one of two that are let go one above the other, and from its landing to their
meeting."""
MEETING_HEIGHT_M = 1.2
"""Height at which bodies are thrown at each other."""
FLANKS = ("left", "right", "side")
AFTER_HIT_S, BEHIND_M = 1.2, 0.5
"""From one's hit of an obstacle to its being run into, and the least gap behind it at the start."""


def waits_at_obstacle(stage: Stage, name: str) -> bool:
    """Whether an actor has run into something and is there, or pushes it along."""
    if name not in stage.met or name not in stage.tracks or name not in stage.frames:
        return False
    return not (stage.story.flies(name) or name in stage.thrown_back or name in stage.airborne)


def who_comes_to_whom(stage: Stage, e: Encounter) -> Encounter:
    """The encounter with who waits at an obstacle as the one that is run into."""
    comes = e.phase is not None and waits_at_obstacle(stage, e.b)
    if not comes and e.other is not None and waits_at_obstacle(stage, e.a):
        return e.turned()
    return e


# -- rows of `meetings.MEETINGS` -----------------------------------------------------------------


def drops_onto_waiting(stage: Stage, e: Encounter) -> bool:
    """Whether a is let go over who waits at an obstacle."""
    return runs_into_waiting(stage, e) and is_dropped(e.coming)


def drop_onto_waiting(stage: Stage, e: Encounter) -> None:
    """It is let go over the place where the other one is by then."""
    _dropped_onto(stage, e.node, e.a, e.b, e.other)


def runs_into_waiting(stage: Stage, e: Encounter) -> bool:
    """Whether a comes to who ran into an obstacle and is there."""
    return e.phase is not None and waits_at_obstacle(stage, e.b)


def both_are_dropped(stage: Stage, e: Encounter) -> bool:
    """Whether both are let go."""
    return _both_come(e) and is_dropped(e.coming) and is_dropped(e.turned().coming)


def one_is_dropped(stage: Stage, e: Encounter) -> bool:
    """Whether one of the two is let go, and the other one moves by itself."""
    return _both_come(e) and is_dropped(e.coming) != is_dropped(e.turned().coming)


def drop_onto_moving(stage: Stage, e: Encounter) -> None:
    """What is dropped is let go over the place that the other one has come to by then."""
    falls = e if is_dropped(e.coming) else e.turned()
    _dropped_onto(stage, e.node, falls.a, falls.b, falls.other)


def cuts_in(stage: Stage, e: Encounter) -> bool:
    """Whether who is run into from behind has overtaken the other one before."""
    row = _in_line(stage, e)
    return row is not None and stage.overtaken.get(row.a, ("",))[0] == row.b


def cut_in(stage: Stage, e: Encounter) -> None:
    """Who has overtaken comes before the other, slows down and is run into."""
    row = _in_line(stage, e)
    assert row is not None
    overtaking.cut_in(stage, row)


def runs_into_rear(stage: Stage, e: Encounter) -> bool:
    """Whether the two go the same way, one behind the other."""
    return _in_line(stage, e) is not None


def run_into_rear(stage: Stage, e: Encounter) -> None:
    """One runs into the back of another that brakes or is slower."""
    row = _in_line(stage, e)
    assert row is not None
    _rear_end(stage, row)


def head_on(stage: Stage, e: Encounter) -> bool:
    """Whether both move by themselves."""
    return _both_come(e)


def drives_across(stage: Stage, e: Encounter) -> bool:
    """Whether both move by themselves, and one of them is hit on its side."""
    return _both_come(e) and _across(stage, e) is not None


def meet_across(stage: Stage, e: Encounter) -> None:
    """One runs into the side of the other, which is on its way across."""
    met = _across(stage, e)
    assert met is not None
    turn = stage.stated_turn(met.node, met.b, met.a)
    assert turn is not None
    _meet(stage, met, turn)


def _across(stage: Stage, e: Encounter) -> Encounter | None:
    """The encounter with who is hit on its side as b, None if nobody is."""
    found = (x for x in (e, e.turned()) if _side(stage, x) in FLANKS)
    return next(found, None)


def _side(stage: Stage, e: Encounter) -> Side | None:
    """On which side the prompt has b hit by a."""
    return stated_side(stage.doc, e.node.id, stage.member(e.b), stage.member(e.a))


def _both_come(e: Encounter) -> bool:
    return e.phase is not None and e.other is not None


def _in_line(stage: Stage, e: Encounter) -> Encounter | None:
    """The two with the rear one as a, None where they do not go the same way."""
    if e.phase is None or e.other is None:
        return None
    struck = [_side(stage, e), _side(stage, e.turned())]
    if "rear" in struck:
        return e if struck[0] == "rear" else e.turned()
    if any(side not in (None, "any_side") for side in struck):
        return None
    braking = [p.edge.event is EdgeEvent.BRAKE for p in (e.phase, e.other)]
    leader = None if braking[0] != braking[1] else _goes_ahead(stage, e.node, e.a, e.b)
    if braking[0] == braking[1] and leader is None and not _same_direction(stage, e.a, e.b):
        return None
    first = leader == e.a or (leader is None and _is_front(stage, e.a))
    return e.turned() if braking[0] or first else e


def meet_head_on(stage: Stage, e: Encounter) -> None:
    """They run, or are thrown, at each other."""
    _meet(stage, e, math.pi)


def _meet(stage: Stage, e: Encounter, turn: float) -> None:
    """Both come, b at a heading turned from that of a by so much [rad]."""
    node, a, b, pa, pb = e.node, e.a, e.b, e.coming, e.turned().coming
    time = stage.prescribed_time(node)
    start = max(stage.tracks[a].time, stage.tracks[b].time)
    speeds = {n: max(stage.speed(n, p), SLOWEST_MPS) for n, p in ((a, pa), (b, pb))}
    apart = gap_at_start(stage, a, b) if start <= 0.0 else None
    if apart is not None and time is None:
        time = apart / sum(speeds.values())
    elif apart is not None and not any(speed_is_fixed(p) for p in (pa, pb)):
        closing = apart / (time or 1.0)
        speeds = {n: v * closing / sum(speeds.values()) for n, v in speeds.items()}
    for actor, phase in ((a, pa), (b, pb)):
        speed = speeds[actor]
        if time is not None and apart is None and not phase.edge.speed_is_prescribed:
            # Where there is no room for the way of the whole time, it is slower.
            speed = max(speed * stage.tight, min(speed, SLOWEST_MPS))
        stage.nominal[f"{phase.edge.id}/speed"] = speed
        if time is None:
            time = start + approach_distance(stage.prop(actor), speed, stage.rng) / speed
        track = stage.tracks[actor]
        duration = max(0.2, time - track.time)
        way, left = covers(stage, actor, phase, speed, duration)
        track.straight(way, duration, left)
        if stage.story.soars(actor):
            stage.heights.setdefault(actor, MEETING_HEIGHT_M)
        elif stage.story.flies(actor):
            # Thrown at where the other one starts, it would be there in twice the time.
            stage.nominal[f"{phase.edge.id}/flight_time"] = 2.0 * duration
            stage.heights[actor] = MEETING_HEIGHT_M
    frame = stage.frames.setdefault(a, Frame())
    ta, tb = stage.tracks[a], stage.tracks[b]
    heading = ta.heading + frame.angle
    x, y = frame.apply(ta.x, ta.y)
    other = stage.prop(b)
    reach = stage.prop(a).half_length + half_along(other.length, other.width, turn)
    meet = (x + reach * math.cos(heading), y + reach * math.sin(heading))
    stage.frames[b] = frame_mapping((tb.x, tb.y), tb.heading, meet, heading + turn)
    for actor in (a, b):
        ox, oy = stage.frames[actor].apply(0.0, 0.0)
        stage.places[actor] = (ox, oy, stage.frames[actor].angle)


def drop_together(stage: Stage, e: Encounter) -> None:
    """Two that are let go at once: one above the other, which meets it as it bounces back.

    Until the lower one lands their gap stays; from then on it closes at (1 + e) g t.
    """
    node, a, b = e.node, e.a, e.b
    goes_on_falling = [n for n in stage.story.after(node.id) if n.event is NodeEvent.FALL]
    stated = {n: asked_height(stage, node, n) for n in (a, b)}
    falls_on = any(b in map(stage.key, n.participants) for n in goes_on_falling)
    if (stated[b] or 0.0, falls_on) > (stated[a] or 0.0, not falls_on):
        a, b = b, a
    lower = stage.prop(b)
    time = stage.prescribed_time(node)
    begun = max(stage.tracks[a].time, stage.tracks[b].time)
    height = stated[b] or fallen(LANDS_S if time is None else time - begun - MEETS_AFTER_S)
    lands = math.sqrt(2.0 * height / GRAVITY_MPS2)
    restitution = 0.5 * (lower.restitution + ground_restitution(stage.doc))
    gap = (1.0 + restitution) * GRAVITY_MPS2 * lands * MEETS_AFTER_S
    above = stated[a]
    if above is not None and above > height + lower.height + 0.05:
        gap = above - height - lower.height
    for actor, bottom in ((b, height), (a, height + lower.height + gap)):
        stage.tracks[actor].time = begun + lands + MEETS_AFTER_S
        stage.places[actor] = (0.0, 0.0, 0.0)
        stage.frames[actor] = Frame()
        stage.heights[actor] = bottom
    stage.time[node.id] = stage.tracks[a].time


def _dropped_onto(stage: Stage, node: TimelineNode, a: str, b: str, phase: Phase | None) -> None:
    """A body falls onto another one that is on its way in `phase`, or rests where that is None."""
    pb, fall, track = stage.prop(b), stage.tracks[a], stage.tracks[b]
    height, time = drop_height(stage, node, a, pb), stage.prescribed_time(node)
    if asked_height(stage, node, a) is None:
        # It is let go at the start: the height is what takes so long.
        usual = max(math.sqrt(2.0 * height / GRAVITY_MPS2), track.time - fall.time + LANDS_AFTER_S)
        height = fallen(usual if time is None else time - fall.time)
    fall.time += math.sqrt(2.0 * height / GRAVITY_MPS2)
    if phase is not None:
        speed = stage.speed(b, phase)
        duration = max(0.2, fall.time - track.time)
        if phase.edge.event is EdgeEvent.BRAKE:
            before = track.speed or speed
            way, duration, left = brake_into(stage, phase, before, fall.time, track.time)
        else:
            stage.nominal[f"{phase.edge.id}/speed"] = speed
            way, left = covers(stage, b, phase, speed, duration)
        track.straight(way, duration, left)
    stage.time[node.id] = max(fall.time, track.time)
    if stage.story.flies(b):
        stage.heights.setdefault(b, MEETING_HEIGHT_M)
    frame = stage.frames.setdefault(b, Frame())
    stage.places.setdefault(b, (*frame.apply(0.0, 0.0), frame.angle + stage.reverse_yaw(b)))
    x, y = frame.apply(track.x, track.y)
    stage.places[a] = (x, y, 0.0)
    stage.frames[a] = Frame(x, y, 0.0)
    stage.heights[a] = stage.heights.get(b, 0.0) + pb.height + height


def run_into_waiting(stage: Stage, e: Encounter) -> None:
    """One runs into another that met an obstacle before: from behind, the only way surely free."""
    node, behind, front, chase, lead = e.node, e.a, e.b, e.coming, e.other
    rear, ahead = stage.tracks[behind], stage.tracks[front]
    speed = stage.speed(behind, chase, min_hit_speed(stage.prop(behind), stage.prop(front)))
    time = stage.prescribed_time(node) or ahead.time + AFTER_HIT_S
    if lead is not None:
        wait = max(time - ahead.time, 0.2)
        left = stage.speed(front, lead)
        if lead.edge.event is EdgeEvent.BRAKE:
            way, _, left = brake_into(stage, lead, ahead.speed, time, ahead.time)
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
    ride = ride_of(stage, behind, chase, speed)
    if ride.way(duration) < least and not speed_is_fixed(chase):
        speed = min(least / duration, max(speed, FASTEST_MPS))
        ride = ride_of(stage, behind, chase, speed)
    if ride.way(duration) < least and stage.prescribed_time(node) is None:
        duration = ride.lasts(least)
    stage.nominal[f"{chase.edge.id}/speed"] = speed
    rear.straight(ride.way(duration), duration, ride.left(duration))
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


def _rear_end(stage: Stage, e: Encounter) -> None:
    """Puts b so far before a that a catches up with it."""
    node, behind, front, chase, lead = e.node, e.a, e.b, e.coming, e.turned().coming
    rear, ahead = stage.tracks[behind], stage.tracks[front]
    speed = stage.speed(behind, chase)
    began = ahead.time
    usual = float(stage.rng.uniform(1.0, 1.4))
    if lead.edge.event is EdgeEvent.BRAKE:
        usual = max(usual, shortest(stage, front, ahead.speed))
    time = stage.prescribed_time(node) or began + usual
    if lead.edge.event is EdgeEvent.BRAKE:
        distance, _, left = brake_into(stage, lead, ahead.speed, time, began)
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
    ride = ride_of(stage, behind, chase, speed)
    rear.straight(ride.way(time - rear.time), time - rear.time, ride.left(time - rear.time))
    gap = max(rear.x - ahead.x, 0.3)
    reach = stage.prop(behind).half_length + stage.prop(front).half_length
    stage.frames[behind] = Frame()
    stage.frames[front] = Frame(gap + reach, 0.0, 0.0)
    stage.places[behind] = (0.0, 0.0, 0.0)
    stage.places[front] = (gap + reach, 0.0, 0.0)


def _goes_ahead(stage: Stage, node: TimelineNode, a: str, b: str) -> str | None:
    """Which of two drivers runs into something else after their meeting, if only one of them does.

    Head-on the other would be in its way: in a pile-up it is hit from behind.
    """
    on = [
        n
        for n in (a, b)
        if not stage.story.flies(n)
        and stage.prop(n).wheeled
        and any(
            p.start.id == node.id
            and p.end.event in (NodeEvent.COLLISION, NodeEvent.REACH)
            and not {a, b} >= set(map(stage.key, p.end.participants))
            for p in stage.story.phases[n]
        )
    ]
    return on[0] if len(on) == 1 and on[0] not in stage.places else None


def _same_direction(stage: Stage, a: str, b: str) -> bool:
    words = " ".join(stage.doc.spatial_relation_graph.nodes[n].label.lower() for n in (a, b))
    return any(w in words.split() for w in ("front", "rear", "lead", "leading", "following"))


def _is_front(stage: Stage, a: str) -> bool:
    words = stage.doc.spatial_relation_graph.nodes[a].label.lower().split()
    return any(w in words for w in ("front", "lead", "leading"))


def covers(
    stage: Stage, actor: str, phase: Phase, speed: float, duration: float
) -> tuple[float, float]:
    """Way [m] of an actor in a given time, and its speed then: what was let go slows down.

    Where the speed is open, it starts that much faster instead (`variables.damping_loss`).
    """
    let_go = phase.edge.event is EdgeEvent.TOWARD and not stage.story.flies(actor)
    if let_go and speed_is_fixed(phase):
        return braking_distance(speed, stage.prop(actor).damping, duration), speed
    ride = ride_of(stage, actor, phase, speed)
    return ride.way(duration), ride.left(duration)
