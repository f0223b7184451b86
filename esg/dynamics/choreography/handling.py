"""What is carried, let go, spun, bounced and jumped, told in closed form."""

from __future__ import annotations

import math

from esg.dynamics.choreography.courses.rounds import goes_somewhere, way_needed
from esg.dynamics.choreography.falling.drops import FLOOR_M, room_of, share_out
from esg.dynamics.choreography.falling.throws import asked_height, is_dropped
from esg.dynamics.choreography.leaps import crouch, landing, leap_to
from esg.dynamics.choreography.meetings import collision
from esg.dynamics.choreography.moves import plain
from esg.dynamics.choreography.placing import join
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.driving import SURELY
from esg.dynamics.story.kinematics import Frame
from esg.dynamics.story.riding import carried_rate, standing_on
from esg.dynamics.story.stagecraft import Prop, ground_restitution, support_of, top_surface
from esg.dynamics.story.story import Phase, Story, bounds
from esg.graph.models import EdgeEvent, NodeEvent, TimelineNode
from esg.units import GRAVITY_MPS2

LIFTED_S, CARRIED_S = 0.8, 2.5
"""How long something is lifted and carried, until the layout says how far."""
SETTLES_S = 0.2
"""From the end of a way until what was put down has come to rest."""
HOP_SHARE, LEAST_HOP_M, HIGHEST_HOP_M = 0.4, 0.12, 0.5
"""How high something jumps: a share of its height within bounds."""
OVER_SHARE, OVER_M = 0.25, 0.15
"""How far above an obstacle a jump leads: a share of the jumper's height, at least so much."""
STRIDE = 1.25
"""A jump's speed over what takes the jumper past the obstacle while it is above it."""
BETWEEN_JUMPS_S = 0.25
TURN_RATE_DEG_S = (180.0, 540.0)
"""Of a spin that says nothing of its speed."""
LEAST_DROP_M, HIGHEST_DROP_M, REBOUND_MPS = 1.0, 6.0, 0.6
"""Height of a drop from which something leaves its last bounce at a speed that counts."""
HAND_M = 1.0
"""Height of a hand that throws something straight up."""
LEAP_LENGTHS = 4.0
"""Lengths of its own that somebody covers who jumps across, past or toward something."""
STEEP_DEG = 80.0


def tell_guided(story: Story, told: dict[str, float]) -> dict[str, float]:
    """Times [s] of the events to which things are carried, by node id.

    Args:
        story: The story.
        told: Times of other events.
    """
    out: dict[str, float] = {}
    for actor, phases in story.phases.items():
        if not story.guided(actor):
            continue
        clock = 0.0
        for phase in phases:
            clock = max(clock, {**told, **out}.get(phase.start.id, 0.0))
            if phase.end.event is NodeEvent.TRIGGER and phase.end.timestamp is not None:
                clock = max(clock, phase.end.timestamp)
            elif phase.end.event is NodeEvent.PICKED_UP:
                clock += LIFTED_S
            else:
                clock += CARRIED_S
            out[phase.end.id] = clock
    return out


def taken(stage: Stage, node: TimelineNode) -> None:
    """PickedUp, Placed: told already, as nothing has to be put anywhere for them."""
    told = stage.elsewhere.get(node.id)
    if told is None:
        plain(stage, node)
    else:
        stage.time[node.id] = told


def spun(stage: Stage, node: TimelineNode) -> None:
    """Spin: so many degrees at a plausible rate, where it is."""
    times: list[float] = []
    for actor, phase in stage.incoming(node):
        track = stage.tracks[actor]
        if phase.edge.event is EdgeEvent.DRIVE and standing_on(stage.doc, actor):
            times.append(_turn_gently(stage, actor, phase))
            continue
        low, high, fixed = bounds(phase.edge.params.turn_rate_deg_s, TURN_RATE_DEG_S)
        rate = math.radians(low if fixed else 0.5 * (low + high))
        stage.nominal[f"{phase.edge.id}/turn_rate"] = rate
        track.straight(0.0, math.radians(node.turn_degrees or 360.0) / rate, 0.0)
        times.append(track.time)
    if times:
        stage.time[node.id] = max(times)
    else:
        plain(stage, node)


def _turn_gently(stage: Stage, actor: str, phase: Phase) -> float:
    """Turns an actor so that what stands on it stays there; returns when it has turned [s]."""
    bodies = [stage.prop(n) for n in standing_on(stage.doc, actor)]
    reach = math.hypot(*top_surface(stage.doc, actor).half_extents_cm) / 100.0
    rate, gain = carried_rate(bodies, reach)
    asked = math.radians(phase.end.turn_degrees or 360.0)
    stage.nominal[f"{phase.edge.id}/duration"] = SURELY * asked / rate
    stage.nominal[f"{phase.edge.id}/ramp"] = rate / gain
    stage.tracks[actor].straight(0.0, asked / rate + 0.5 * rate / gain, 0.0)
    return stage.tracks[actor].time


def jumped(stage: Stage, node: TimelineNode) -> None:
    """Jump: up and on so far that its body clears what it jumps over, or to where it ends."""
    for actor, phase in stage.incoming(node):
        track, body, count = stage.tracks[actor], stage.prop(actor), node.times or 1
        names = [p for p in (*node.participants[1:], phase.edge.target) if p]
        over = stage.prop(stage.key(names[0])) if names else None
        rise, speed = leap(body, over, phase)
        goal = landing(stage, actor, phase) if over is None and count == 1 else None
        if goal is not None:
            leap_to(stage, actor, phase, node, goal, 0.5 * rise * rise / GRAVITY_MPS2)
            continue
        if support_of(stage.doc, stage.member(actor)):
            crouch(stage, actor, phase)
        duration = 2.0 * rise / GRAVITY_MPS2
        if over is None and phase.edge.params.speed is None:
            onward = LEAP_LENGTHS * body.length if goes_somewhere(stage, actor) else 0.0
            speed = max(speed, max(onward, way_needed(stage, actor)) / (count * duration))
        stage.nominal[f"{phase.edge.id}/rise"] = rise
        stage.nominal[f"{phase.edge.id}/speed"] = speed
        begin = track.time
        if over is not None:
            # The obstacle stands under the middle of the leap.
            track.straight(0.5 * speed * duration, 0.5 * duration, speed)
            gap = -body.half_length - over.half_length
            join(stage, actor, stage.key(names[0]), node, gap)
            x, y = stage.frames[actor].apply(track.x, track.y)
            yaw = track.heading + stage.frames[actor].angle
            if over.width > over.length:
                stage.places[stage.key(names[0])] = (x, y, yaw)
            else:
                stage.places[stage.key(names[0])] = (x, y, yaw + 0.5 * math.pi)
            track.straight(0.5 * speed * duration, 0.5 * duration, 0.0)
        else:
            track.straight(count * speed * duration, count * duration, 0.0)
        track.time = begin + count * duration + (count - 1) * BETWEEN_JUMPS_S
        stage.time[node.id] = track.time
    if node.id not in stage.time:
        plain(stage, node)


def leap(body: Prop, over: Prop | None, phase: Phase) -> tuple[float, float]:
    """Vertical and horizontal speed of a jump [m/s].

    Args:
        body: Who jumps.
        over: What it jumps over.
        phase: The jump.
    """
    height = min(max(HOP_SHARE * body.height, LEAST_HOP_M), HIGHEST_HOP_M)
    if over is not None:
        height = max(height, over.height + max(OVER_SHARE * body.height, OVER_M))
    low, high, _ = bounds(phase.edge.params.height_cm, (100.0 * height, 100.0 * height))
    height = min(max(height, low / 100.0), high / 100.0)
    speed = 0.0
    if over is not None:
        above = 2.0 * math.sqrt(2.0 * max(height - over.height, 0.02) / GRAVITY_MPS2)
        speed = STRIDE * (body.length + min(over.length, over.width)) / above
    if phase.edge.params.speed is not None:
        low, high, _ = bounds(phase.edge.params.speed, (0.0, 0.0))
        speed = min(max(speed, low / 100.0), high / 100.0)
    return math.sqrt(2.0 * GRAVITY_MPS2 * height), speed


def goes_straight_up(phase: Phase) -> bool:
    """Whether a phase throws its actor so steeply that it comes down where it was."""
    elevation = phase.edge.params.elevation_deg
    return elevation is not None and bounds(elevation, (0.0, 0.0))[0] >= STEEP_DEG


def falls_down(story: Story, phase: Phase) -> bool:
    """Whether a phase lets its actor fall where it is: dropped, let go, thrown straight up."""
    first = story.phases[phase.edge.actor][0]
    held = first.edge.event is EdgeEvent.GUIDE and phase.edge.params.speed is None
    return held or is_dropped(phase) or goes_straight_up(phase)


def bounced(stage: Stage, node: TimelineNode) -> None:
    """Bounce: from such a height above its target that it leaves the last bounce fast enough."""
    a, b = stage.key(node.participants[0]), stage.key(node.participants[1])
    incoming = dict(stage.incoming(node))
    phase = incoming.get(a)
    if phase is None or not (stage.story.flies(a) and falls_down(stage.story, phase)):
        if phase is None:
            plain(stage, node)
        else:
            collision(stage, node)
        return
    body, target, count = stage.prop(a), stage.prop(b), node.times or 1
    on_ground = target.config is None or not target.config.proxies
    theirs = ground_restitution(stage.doc) if on_ground else target.restitution
    share = max(0.5 * (body.restitution + theirs), 0.05)
    needed = (REBOUND_MPS / share**count) ** 2 / (2.0 * GRAVITY_MPS2)
    up = 0.0
    if goes_straight_up(phase):
        up = stage.speed(a, phase)
        stage.nominal[f"{phase.edge.id}/speed"] = up
    least = HAND_M if up else LEAST_DROP_M
    height = asked_height(stage, node, a) or min(max(needed, least), HIGHEST_DROP_M)
    x, y = 0.0, 0.0
    if not on_ground:
        stage.places.setdefault(b, (0.0, 0.0, 0.0))
        x, y, _ = stage.places[b]
    room = (FLOOR_M, FLOOR_M) if on_ground else room_of(stage, b, None)
    dx, dy, higher = share_out(stage, a, b, room, round_=False)
    x, y, height = x + dx, y + dy, height + higher
    stage.frames[a], stage.places[a] = Frame(x, y, 0.0), (x, y, 0.0)
    stage.heights[a] = (0.0 if on_ground else target.height) + height
    landing = math.sqrt(up * up + 2.0 * GRAVITY_MPS2 * height)
    aloft = sum(2.0 * landing * share**k for k in range(1, count))
    stage.tracks[a].time += (up + landing + aloft) / GRAVITY_MPS2
    stage.time[node.id] = stage.tracks[a].time
