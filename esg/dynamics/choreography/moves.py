"""What the actors do on their own: timed segments, turns, stops and falls."""

from __future__ import annotations

import math

from esg.dynamics.choreography.braking import brake
from esg.dynamics.choreography.courses.climbs import climbed
from esg.dynamics.choreography.courses.rounds import way_needed, widest_turn
from esg.dynamics.choreography.courses.tops import hold_to, length_of_top
from esg.dynamics.choreography.falling.falls import goes_over_edge, over_edge, tip_over
from esg.dynamics.choreography.placing import comes_to_rest, gap_left, join
from esg.dynamics.choreography.setting_off import gain_of, ride_of
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.kinematics import Frame, sliding_travel
from esg.dynamics.story.paces import LASTS_S, turns_at
from esg.dynamics.story.stagecraft import (
    ON_TABLE,
    TABLE_S,
    coasting_drag,
    prop,
    stays_on,
    top_surface,
)
from esg.dynamics.story.story import (
    CRUISES,
    ON_THE_SPOT,
    Phase,
    bounds,
    is_climb,
    is_posture,
    rebounds,
    turn_of,
    turns_back,
)
from esg.graph.models import EdgeEvent, NodeEvent, TimelineNode
from esg.units import GRAVITY_MPS2

TURNED_RAD = math.radians(10.0)
"""A turn counts as made this far before its end: between the end of its tolerance and of itself."""
AT_ONCE_S, USUAL_DROP_M = 0.02, 0.8
"""What is hit breaks so soon; what comes down breaks where a fall of that height ends."""
SHORT_S = (1.2, 1.8)
"""Time of a run to nowhere [s]."""
LEAST_MPS = 0.2
"""Speed below which nothing is waited for until it has passed something."""
LONGEST_RUN_S, SHORTEST_RUN_S = 4.0, 0.8
"""Longest and shortest time of a run along a table."""
USUAL_S = 2.0
"""Time of a segment where nothing says how long it lasts."""
SLIDES_ON = 0.4
"""Share of the time to rest after which something that slides is acted upon at the latest."""
ROOM_ON_TOP = 0.6
"""Share of the length of a table that the way of what stays on it may have."""
MOST_ON_TOP_MPS = 4.0
ROLLS_ON_TOP = 2.0
"""Speed [m/s] over the way [m] of what rolls along a table, where it is soon slowed."""
REBOUND_S = 0.15
"""Time from a hit of something fixed to the brake that follows it."""


def controlled(stage: Stage, node: TimelineNode) -> None:
    """Trigger: its time is the prescribed one, or that of a short run."""
    if node.id in stage.time:
        stage.nominal[f"{node.id}/time"] = stage.time[node.id]
        return  # planned with what led there
    prescribed = stage.prescribed_time(node)
    arrived: list[float] = []
    for actor, phase in stage.incoming(node):
        track = stage.tracks[actor]
        if is_posture(phase):
            track.straight(0.0, LASTS_S, 0.0)
            arrived.append(track.time)
            continue
        if is_climb(phase):
            climbed(stage, node, actor, phase)
            arrived.append(track.time)
            continue
        if phase.edge.event is EdgeEvent.TURN and stage.keeps_to_its_top(actor):
            _turn(stage, actor, phase)  # "in circles"
            arrived.append(track.time)
            continue
        if prescribed is not None:
            duration = max(0.2, prescribed - track.time)
        elif phase.edge.event is EdgeEvent.BRAKE:
            duration = None
        elif rebounds(stage.story, phase, lambda name: stage.prop(name).fixed):
            track.straight(0.0, REBOUND_S, 0.25 * track.speed)
            arrived.append(track.time)
            continue
        else:
            least, most, _ = bounds(phase.edge.params.duration, SHORT_S)
            duration = float(stage.rng.uniform(least, most)) * stage.tight
            if phase.edge.params.duration is None:
                duration = max(duration, _passes_in(stage, actor, phase))
                duration = _along_its_top(stage, actor, phase, duration)
            if stage.keeps_to_its_top(actor):
                duration = max(duration, SHORTEST_RUN_S)
        if turns_back(stage.story, phase, lambda name: stage.prop(name).fixed):
            track.heading += math.pi
        _advance(stage, actor, phase, duration)
        arrived.append(track.time)
    if not arrived:
        low, high = node.window or (1.0, 1.0)
        arrived = [prescribed if prescribed is not None else max(low, min(high, low + 0.5))]
    stage.time[node.id] = max(arrived)
    stage.nominal[f"{node.id}/time"] = stage.time[node.id]


def _along_its_top(stage: Stage, actor: str, phase: Phase, otherwise: float) -> float:
    """How long [s] what moves by itself goes along its table, if it does nothing else there."""
    alone = len(stage.story.phases[actor]) == 1 and phase.edge.event is EdgeEvent.UNIFORM_MOTION
    way = length_of_top(stage, actor) if alone else 0.0
    if way <= 0.0:
        return otherwise
    return min(way / stage.speed(actor, phase), LONGEST_RUN_S) * stage.tight


def _passes_in(stage: Stage, actor: str, phase: Phase) -> float:
    """How long [s] a run takes that leads through or over something; 0 if it leads nowhere."""
    way = way_needed(stage, actor) if phase is stage.story.phases[actor][0] else 0.0
    return way / max(stage.speed(actor, phase), LEAST_MPS) if way else 0.0


def turned(stage: Stage, node: TimelineNode) -> None:
    """HeadingReached: an arc at a plausible turn rate."""
    lead = 0.0
    for actor, phase in stage.incoming(node):
        lead = TURNED_RAD / _turn(stage, actor, phase)
    times = [stage.tracks[a].time for a in stage.tracks if a in node.participants]
    stage.time[node.id] = max(times, default=1.0) - lead


def _turn(stage: Stage, actor: str, phase: Phase) -> float:
    """Leads an actor through an arc; how fast that turns [rad/s]."""
    track = stage.tracks[actor]
    speed = stage.speed(actor, phase) if phase.edge.params.speed else track.speed
    ride = ride_of(stage, actor, phase, speed or stage.speed(actor, phase))
    stage.nominal[f"{phase.edge.id}/speed"] = ride.speed
    hold_to(stage, actor, phase, ride.speed)
    low, high, fixed = bounds(phase.edge.params.turn_rate_deg_s, (25.0, 70.0))
    steady = math.degrees(turns_at(stage.doc, stage.member(actor)) / max(ride.speed, 0.1))
    usual = min(max(45.0, low), high, steady)
    wide = widest_turn(stage, actor)
    if wide and not fixed:
        steady = min(high, steady) if stage.keeps_to_its_top(actor) else usual
        usual = max(low, min(steady, math.degrees(ride.speed / wide)))
    rate = math.radians(low if fixed else usual)
    degrees, sign = turn_of(phase)
    stage.nominal[f"{phase.edge.id}/turn_rate"] = rate
    track.arc(sign * math.radians(degrees), rate, ride)
    return rate


def plain(stage: Stage, node: TimelineNode) -> None:
    """Stop, Topple, Fall, PositionAt: what remains of the actors' motion, nothing to place."""
    if node.id in stage.time:
        return  # planned with what led there
    prescribed = stage.prescribed_time(node)
    told = False
    for actor, phase in stage.incoming(node):
        if goes_over_edge(stage, actor, node):
            over_edge(stage, actor, phase, node)
            told = True
            continue
        if stage.story.tips(phase):
            tip_over(stage, actor, phase, node)
            told = True
            continue
        track = stage.tracks[actor]
        duration = _stop_time(node)
        if prescribed is not None:
            duration = max(0.3, prescribed - track.time)
        _advance(stage, actor, phase, duration)
    apart = gap_left(stage, node)
    if apart is not None and apart[0] in stage.tracks and apart[1] not in stage.tracks:
        join(stage, apart[0], apart[1], node, apart[2])
    if told:
        return
    times = [stage.tracks[p].time for p in node.participants if p in stage.tracks]
    before = [stage.time.get(b, 0.0) for b in stage.story.before.get(node.id, ())]
    stage.time[node.id] = prescribed or max([*times, *(t + 0.5 for t in before)], default=1.0)
    if node.event is NodeEvent.FALL:
        _place_for_fall(stage, node)


def _advance(stage: Stage, actor: str, phase: Phase, duration: float | None) -> None:
    """Moves an actor through a phase whose end is set by time [s], None where that is open."""
    track, edge = stage.tracks[actor], phase.edge
    if edge.event is EdgeEvent.BRAKE:
        brake(stage, actor, phase, duration)
        return
    duration = USUAL_S if duration is None else duration
    if edge.event in ON_THE_SPOT:
        track.straight(0.0, duration, 0.0)
        return
    speed = stage.speed(actor, phase)
    if edge.event is EdgeEvent.ACCELERATED_MOTION:
        rate = gain_of(stage, actor, phase)
        start = track.speed if track.time > 0 else (speed if edge.params.speed is not None else 0.5)
        stage.nominal[f"{edge.id}/acceleration"] = rate
        stage.nominal[f"{edge.id}/speed"] = start
        end = max(0.0, start + rate * duration)
        track.straight(0.5 * (start + end) * duration, duration, end)
        return
    body = stage.prop(actor)
    drag = coasting_drag(body)
    most = _fastest_on_top(stage, actor, phase)
    if most is not None:
        # Slower it would be seen to go nowhere.
        speed = min(most, MOST_ON_TOP_MPS)
        speed = stage.nominal[f"{edge.id}/most"] = max(speed * stage.tight, LEAST_MPS)
    stage.nominal[f"{edge.id}/speed"] = speed
    hold_to(stage, actor, phase, speed)
    if edge.event is EdgeEvent.TOWARD and drag > 0.0 and not stage.story.flies(actor):
        if not phase.end.time_is_prescribed:
            # What shall stop slides to rest; what is acted upon later is not at rest by then.
            halts = phase.end.event is NodeEvent.STOP
            duration = speed / drag if halts else min(duration, SLIDES_ON * speed / drag)
        left = max(0.0, speed - drag * duration)
        track.straight(sliding_travel(speed, drag, duration), duration, left)
        return
    if most is not None and body.rolls:
        track.straight(
            speed * (TABLE_S + (1.0 - math.exp(-ON_TABLE * duration)) / ON_TABLE), duration, 0.0
        )
        return
    ride = ride_of(stage, actor, phase, speed)
    node = phase.end
    halts = node.event is NodeEvent.STOP and edge.event in CRUISES
    if halts:
        # Its brakes set in before it stands.
        duration = max(duration - speed / stage.halt(actor, speed), 0.1)
        stage.nominal[f"{node.id}/time"] = track.time + duration
    track.straight(ride.way(duration), duration, ride.left(duration))
    if halts:
        track.straight(*comes_to_rest(stage, actor), 0.0)


def _fastest_on_top(stage: Stage, actor: str, phase: Phase) -> float | None:
    """Speed [m/s] at which what is sent along a table comes to rest before its edge.

    Args:
        stage: The stage.
        actor: What slides or rolls.
        phase: How; what rolls is damped (`plan.settling`).

    Returns:
        None where it may leave the table, goes on, or the speed is told.
    """
    host, edge = stays_on(stage.doc, stage.member(actor)), phase.edge
    alone = len(stage.story.phases[actor]) == 1 and phase.end.event in (
        NodeEvent.STOP, NodeEvent.TRIGGER
    )  # fmt: skip
    sent = edge.event is EdgeEvent.TOWARD and not stage.story.flies(actor)
    if host is None or not (alone and sent) or edge.speed_is_prescribed:
        return None
    x, y = top_surface(stage.doc, host).half_extents_cm
    body = stage.prop(actor)
    room = ROOM_ON_TOP * (max(x, y) / 50.0 - body.length)
    if room <= 0.0 or body.wheeled:
        return None
    rubs = 0.5 * (body.friction + prop(stage.doc, host).friction) * GRAVITY_MPS2
    return room * ROLLS_ON_TOP if body.rolls else math.sqrt(2.0 * rubs * room)


def _stop_time(node: TimelineNode) -> float | None:
    """Prescribed duration of a stop [s], None where that is open."""
    for c in node.constraints:
        if c.quantity == "time_to_stop":
            low, high, _ = bounds(c.value, (USUAL_S, USUAL_S))
            return 0.5 * (low + high)
    return None


def _place_for_fall(stage: Stage, node: TimelineNode) -> None:
    """What shall fall off its support starts near the edge that its motion leads to."""
    if stage.anchor is None or stage.lifted or not node.participants:
        return
    name = stage.key(node.participants[0])
    if name not in stage.places:
        return
    surface = top_surface(stage.doc, stage.anchor)
    across = surface.half_extents_cm[1] < surface.half_extents_cm[0]
    edge = surface.half_extents_cm[1 if across else 0] / 100.0
    x, y, _ = stage.places[name]
    angle = math.pi / 2 if across else 0.0
    shift = edge - 0.6 * stage.prop(name).half_length - 0.05 - x
    moved = {k: (px + shift, py - y, yaw) for k, (px, py, yaw) in stage.places.items()}
    turn = Frame(angle=angle)
    for key, (px, py, yaw) in moved.items():
        cx, cy = surface.center_cm[0] / 100.0, surface.center_cm[1] / 100.0
        tx, ty = turn.apply(px, py)
        stage.places[key] = (cx + tx, cy + ty, None if yaw is None else yaw + angle)
    stage.frames = {a: Frame(*stage.places[a][:2], stage.places[a][2] or 0.0) for a in stage.frames}


def shattered(stage: Stage, node: TimelineNode) -> None:
    """Break: at once after a hit, and after a fall or a topple when the ground is reached."""
    before = stage.story.before.get(node.id, ())
    last = max((stage.time.get(b, 0.0) for b in before), default=0.0)
    drops = (NodeEvent.FALL, NodeEvent.TOPPLE)
    down = any(stage.story.nodes[b].event in drops for b in before)
    wait = math.sqrt(2.0 * USUAL_DROP_M / GRAVITY_MPS2) if down else AT_ONCE_S
    for actor, _ in stage.incoming(node):
        stage.tracks[actor].straight(0.0, wait, 0.0)
    stage.time[node.id] = stage.prescribed_time(node) or last + wait
