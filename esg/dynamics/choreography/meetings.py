"""How participants of the choreography meet: hits, chains of hits, drops and entered regions."""

from __future__ import annotations

import math

from esg.dynamics.choreography.bounces import bounce_on
from esg.dynamics.choreography.caroms import carom, is_carom
from esg.dynamics.choreography.demands import demanded, felt_speed, gentlest, passed_on
from esg.dynamics.choreography.encounters import (
    brake_into,
    covers,
    meeting,
    run_into,
    waits_at_obstacle,
)
from esg.dynamics.choreography.falls import can_land, land, tip_onto
from esg.dynamics.choreography.flights import bank, banked_into, flies_on, leaves, took_off
from esg.dynamics.choreography.hovering import fly_in
from esg.dynamics.choreography.impacts import chain, impact, returns
from esg.dynamics.choreography.moves import plain
from esg.dynamics.choreography.overtaking import overtake
from esg.dynamics.choreography.placing import (
    asked_distance,
    gap_at_start,
    goes_on,
    hits_on,
    join,
    struck_again,
)
from esg.dynamics.choreography.slopes import descend, goes_down
from esg.dynamics.choreography.stage import FASTEST_MPS, Stage, speed_is_fixed
from esg.dynamics.choreography.throws import (
    drop,
    hand_height,
    is_dropped,
    is_lobbed,
    level_height,
    putts,
    sends_on,
    slowest_passage,
)
from esg.dynamics.story.kinematics import lob_time
from esg.dynamics.story.stagecraft import (
    Prop,
    approach_distance,
    coasting_drag,
    fall_speed,
    min_hit_speed,
    push_speed,
    slide,
    support_of,
)
from esg.dynamics.story.story import Phase, bounds
from esg.dynamics.story.tipping import topple_speed
from esg.graph.models import EdgeEvent, NodeEvent, TimelineNode
from esg.units import GRAVITY_MPS2

MAX_APPROACH_M = 45.0
GAPPED = (NodeEvent.MISS, NodeEvent.REACH)
LOB_M = 1.0
"""Way of a throw into an open container."""
AFTER_BOUNCE_M, AFTER_BOUNCE_S = 0.5, 0.3
"""Longest way from a wall to what is hit after bouncing off it, unless it takes less than that."""
RETURN_M, RETURN_S = 1.0, 0.2
"""Longest way to a wall that sends something straight back, unless it takes less than that."""
SLID = 0.55
"""Share of its speed with which something slid along the ground arrives."""
CHAINED = 0.6
"""Share of the usual impulse and run-up of a ball that starts a chain of balls."""
PUTT_MPS, PUTT_NS = 2.0, 0.15
"""Speed that a swing gives to a ball that shall roll into something, and the least impulse."""
LONG_CHAIN = 4
"""Number of hits of a chain of balls from which on it goes as gently as its last hit allows."""
STANDSTILL_MPS, CRAWL_MPS = 0.5, 0.05
"""Speed with which something that accelerates sets off at most, and that of what stands still."""
CALM_MPS = 4.0
"""Speed at which something that is no wheel and no ball slides on and stays on the ground."""
GENTLE = 0.4
"""Share of the usual speed of a hit after which another one hits the same thing."""
STAY_S = 0.28
"""What rolls through an opening is in it for at least this long."""
FRESH = 0.8
"""Least share of its speed with which what was pushed and let go arrives."""
FLIGHT_S, LONGEST_THROW_M = 0.3, 12.0
"""Usual flight time of a throw at something, and its longest way."""
LEVEL_S, LEAST_LEVEL_M = 0.2, 0.15
"""Flight time and least way of a throw of stated speed that shall knock something over, and of one
that shall send something on."""
MIDDLE = 0.5
"""Share of its height at which something is hit that is sent on."""
TAKE_OFF = math.tan(math.radians(30.0))
"""Slope at which what drives takes off."""


def collision(stage: Stage, node: TimelineNode) -> None:
    """Collision, Reach, Miss: who is on the way to whom decides how they come together."""
    if len(node.participants) < 2:
        plain(stage, node)
        return
    if node.id in stage.time:
        return  # planned with what led there
    a, b = stage.key(node.participants[0]), stage.key(node.participants[1])
    incoming = dict(stage.incoming(node))
    if a not in incoming and b in incoming:
        a, b = b, a
    fresh = a in incoming and b not in stage.places
    if a in incoming and node.event is NodeEvent.MISS and overtake(stage, node, a, incoming[a], b):
        return
    if a in incoming and waits_at_obstacle(stage, b):
        run_into(stage, node, a, incoming[a], b, incoming.get(b))
    elif b in incoming and waits_at_obstacle(stage, a):
        a, b = b, a
        run_into(stage, node, a, incoming[a], b, incoming.get(b))
    elif a in incoming and b in incoming:
        meeting(stage, node, a, incoming[a], b, incoming[b])
    elif a in incoming:
        _approach(stage, node, a, incoming[a], b)
    else:
        chain(stage, node, a, b)
    if stage.met.get(a, b) != b and node.id in stage.time:
        return  # it goes on from there already
    if a in incoming and stage.story.flies(a) and node.event is NodeEvent.COLLISION:
        leaves(stage, node, a, b)
    if banked_into(stage, node, a, b) is not None:
        stage.met[a] = b
        return
    if fresh and is_carom(stage, node, a, b):
        carom(stage, node, a, b)
    else:
        impact(stage, node, a, b)
    stage.met[a] = b


def enters(stage: Stage, node: TimelineNode) -> None:
    """The target region's owner is put in the way, its opening towards the mover."""
    mover = stage.key(node.participants[0])
    owner = (node.region or "/").split("/")[0]
    incoming = dict(stage.incoming(node))
    if owner not in stage.doc.spatial_relation_graph.nodes:
        return
    if mover in incoming and node.id in stage.time and owner in stage.places:
        return
    if mover in incoming:
        if mover in stage.arcs and owner not in stage.places:
            flies_on(stage, node, mover, owner)
            return
        if node.id in stage.time:
            return
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
        if mover in incoming and stage.story.flies(mover) and is_lobbed(stage, node):
            leaves(stage, node, mover, owner)
            stage.met[mover] = owner
    stage.time.setdefault(node.id, 1.0)


def _approach(stage: Stage, node: TimelineNode, a: str, phase: Phase, b: str) -> None:
    """An active body runs, rolls or flies at a target that waits."""
    if can_land(stage, a, b):
        land(stage, node, a, b)
        return
    if a in stage.tipped:
        tip_onto(stage, node, a, b)
        return
    if a in stage.arcs and b not in stage.places:
        flies_on(stage, node, a, b)
        return
    track, pa, pb = stage.tracks[a], stage.prop(a), stage.prop(b)
    first = stage.story.phases[a][0]
    if b not in stage.places and bank(stage, node, a, phase, b):
        return
    if bounce_on(stage, node, a, phase, b):
        return
    if is_dropped(phase) or (phase.edge.params.speed is None and is_dropped(first)):
        drop(stage, node, a, b)
        return
    prescribed = stage.prescribed_time(node)
    least = min_hit_speed(pa, pb)
    again = struck_again(stage, node, a, b)
    chained = pa.rolls and pb.rolls and goes_on(stage, node, b)
    chained = chained or is_carom(stage, node, a, b)
    if chained:
        # Slow and close: the less way there is, the less an error of the aim grows.
        least *= CHAINED
    elif goes_on(stage, node, b) and not again:
        least = max(least, push_speed(pa, pb), timed_push(stage, node, pa, b))
    topples = stage.story.topples(stage.member(b))
    needed = topple_speed(pa, pb, flies=stage.story.flies(a)) if topples else 0.0
    if stage.story.falls(stage.member(b)) and phase.edge.event is EdgeEvent.TOWARD:
        needed = max(needed, fall_speed(pa, pb))
    needed = max(needed, demanded(stage, node, a, b))
    if not chained:
        needed = max(needed, felt_speed(pa, pb))
    speed = stage.speed(a, phase, max(least, needed), needed)
    if chained and not phase.edge.speed_is_prescribed:
        gently, hits = gentlest(stage, node, a, b)
        speed = speed if hits < LONG_CHAIN else min(speed, max(gently, least, needed))
    if prescribed is None and not phase.edge.speed_is_prescribed and sends_sliding(stage, node, b):
        # Faster, it would tumble, and pass over the next one in another engine.
        low, high, _ = bounds(phase.edge.params.speed, (0.0, 0.0))
        calm = max(CALM_MPS / passed_on(pa, pb), least, needed, (0.9 * low + 0.1 * high) / 100.0)
        speed = min(speed, calm)
    if again and not phase.edge.speed_is_prescribed:
        # Gently: the next one is to find it.
        speed = max(least, needed, GENTLE * speed)
    if putts(stage, node, a, b) and not phase.edge.speed_is_prescribed:
        speed = min(speed, max(PUTT_MPS, PUTT_NS / pb.mass) / passed_on(pa, pb))
    asked = asked_distance(stage, node, a) if node.event not in GAPPED else None
    if asked is None and node.event is NodeEvent.COLLISION and track.time <= 0.0:
        asked = gap_at_start(stage, a, b) if b not in stage.places else None
    if asked is not None and not speed_is_fixed(phase):
        speed = asked / max(0.15, prescribed - track.time) if prescribed is not None else speed
    if goes_down(stage, a, b) is not None:
        needed = max(needed, least)
        distance, duration, left = descend(stage, node, a, phase, b, needed)
    elif phase.edge.event is EdgeEvent.BRAKE:
        speed = track.speed or speed
        distance, duration, left = brake_into(stage, phase, speed, prescribed, track.time)
    elif _slides(stage, a, phase):
        wait = None if prescribed is None else max(0.15, prescribed - track.time)
        free = not speed_is_fixed(phase)
        if needed > 0.0 and not phase.edge.speed_is_prescribed:
            # What it is to arrive with is less than what it starts with.
            speed = max(speed, min(needed / SLID, FASTEST_MPS))
        speed, distance, duration, left = slide(pa, speed, wait, stage.rng, adjustable=free)
        distance = max(distance, descent(stage, a, b), _room_after(stage, a, b))
        stage.nominal[f"{phase.edge.id}/speed"] = speed
    else:
        rate, first = _gains(stage, a, phase, speed)
        run = approach_distance(pa, max(speed, 1.0), stage.rng) * stage.tight
        if chained:
            run *= CHAINED
        if a in stage.thrown_back:
            run = min(run, max(AFTER_BOUNCE_M, AFTER_BOUNCE_S * track.speed))
            run = max(run, stage.way_back.get(a, 0.0))
        if returns(stage, node, a, b):
            run = min(run, max(RETURN_M, RETURN_S * speed))
        run = min(run, _fresh_run(stage, a, phase, speed))
        run = max(run, descent(stage, a, b))
        flies = stage.story.flies(a) and not stage.story.soars(a)
        inside = node.event is NodeEvent.ENTER_REGION
        lobbed = flies and is_lobbed(stage, node)
        if inside and not stage.story.flies(a) and not speed_is_fixed(phase):
            speed = min(speed, max(slowest_passage(stage, node) / STAY_S, 0.3))
        if flies and not lobbed and stage.anchor is None:
            run = max(run, min(FLIGHT_S * speed, LONGEST_THROW_M))
            if (topples and speed_is_fixed(phase)) or sends_on(stage, node, b):
                run = max(LEVEL_S * speed, LEAST_LEVEL_M)
        if prescribed is not None:
            duration = max(0.15, prescribed - track.time)
            if not (flies or phase.edge.speed_is_prescribed):
                speed = max(speed * stage.tight, min(speed, least))
            if lobbed and not speed_is_fixed(phase):
                speed = min(speed, LOB_M / duration)
        elif lobbed and not speed_is_fixed(phase):
            # Steep enough to come down through an opening that looks up.
            run = LOB_M
            way = (asked or run) + pb.half_length
            duration = lob_time(way, hand_height(stage, node, b, pa, pb) - pb.height)
            speed = (asked or run) / duration
        else:
            duration = (asked or run) / max(speed, CRAWL_MPS)
            if rate is not None:
                duration = _gaining(first, rate, asked or run)
        distance = asked or covers(stage, a, phase, speed, duration)
        if prescribed is None and rate is None:
            distance = max(distance, _room_after(stage, a, b))
            duration = distance / max(speed, CRAWL_MPS)
        left = speed
        if rate is not None:
            speed = first
            left = speed + rate * duration
            distance = 0.5 * (speed + left) * duration
            stage.nominal[f"{phase.edge.id}/acceleration"] = rate
        elif distance > MAX_APPROACH_M and not speed_is_fixed(phase):
            speed = left = MAX_APPROACH_M / duration
            distance = MAX_APPROACH_M
        stage.nominal[f"{phase.edge.id}/speed"] = speed
    track.straight(distance, duration, left)
    if stage.story.soars(a):
        fly_in(stage, node, a, phase, distance)
    elif stage.story.takes_off(a):
        # Steeper than a ramp.
        stage.nominal[f"{phase.edge.id}/flight_time"] = math.sqrt(
            2.0 * distance * TAKE_OFF / GRAVITY_MPS2
        )
    elif stage.story.flies(a):
        stage.heights[a] = hand_height(stage, node, b, pa, pb)
        if topples and speed_is_fixed(phase) and support_of(stage.doc, stage.member(b)) is None:
            stage.heights[a] = level_height(pb, pa, duration)
        elif sends_on(stage, node, b):
            stage.heights[a] = level_height(pb, pa, duration, MIDDLE)
        stage.nominal[f"{phase.edge.id}/flight_time"] = duration
        took_off(stage, a, phase, track.time)
    join(stage, a, b, node)


def sends_sliding(stage: Stage, node: TimelineNode, b: str) -> bool:
    """Whether something without wheels that is hit here shall slide into what goes on, too."""
    body = stage.prop(b)
    if body.rolls or body.wheeled or body.fixed:
        return False
    if stage.story.topples(stage.member(b)) or stage.story.falls(stage.member(b)):
        return False
    for later in stage.story.after(node.id):
        keys = list(map(stage.key, later.participants))
        others = [k for k in keys if k != b]
        if later.event is NodeEvent.COLLISION and b in keys and others:
            return others[0] not in stage.tracks and hits_on(stage, later, others[0])
    return False


def timed_push(stage: Stage, node: TimelineNode, mover: Prop, b: str) -> float:
    """Speed [m/s] of a hit after which b is still on its way when it is to meet the next one.

    0 where the prompt gives no time for that. It is to keep a third of its speed until then.
    """
    target = stage.prop(b)
    if target.rolls or target.fixed:
        return 0.0
    for later in stage.story.after(node.id):
        keys = [stage.key(p) for p in later.participants]
        if later.event is not NodeEvent.COLLISION or b not in keys:
            continue
        if any(k in stage.tracks for k in keys):
            continue
        since = [c for c in later.constraints if c.quantity == "time_since" and c.since == node.id]
        waits = [c.value for c in since]
        now = stage.prescribed_time(node)
        if not waits and now is not None and later.time_is_prescribed and later.timestamp:
            waits = [later.timestamp - now]
        if waits:
            low, high, _ = bounds(waits[0], (0.0, 0.0))
            needed = 1.5 * coasting_drag(target) * 0.5 * (low + high)
            gain = (1.0 + 0.5 * (mover.restitution + target.restitution)) * mover.mass
            return max(0.0, needed * (mover.mass + target.mass) / gain)
        break
    return 0.0


def _gains(stage: Stage, actor: str, phase: Phase, speed: float) -> tuple[float | None, float]:
    """How an accelerated approach sets off: acceleration [m/s^2] and first speed [m/s].

    None where the prompt states neither the acceleration nor that it starts at rest.
    """
    edge, track = phase.edge, stage.tracks[actor]
    if edge.event is not EdgeEvent.ACCELERATED_MOTION:
        return None, speed
    low, high, fixed = bounds(edge.params.acceleration, (100.0, 400.0))
    if not fixed and speed > CRAWL_MPS:
        return None, speed
    if not (speed_is_fixed(phase) and edge.params.speed is not None):
        speed = track.speed if track.time > 0.0 else min(speed, STANDSTILL_MPS)
    return max(0.005 * (low + high), 0.1), speed


def _gaining(speed: float, rate: float, way: float) -> float:
    """Time [s] in which something that gains speed covers a way [m]."""
    return (math.sqrt(speed * speed + 2.0 * rate * way) - speed) / rate


def _fresh_run(stage: Stage, a: str, phase: Phase, speed: float) -> float:
    """Longest run [m] on which what was pushed and let go keeps `FRESH` of its speed."""
    drag = coasting_drag(stage.prop(a))
    if phase.edge.event is not EdgeEvent.TOWARD or stage.story.flies(a) or drag <= 0.0:
        return math.inf
    return (1.0 - FRESH * FRESH) * speed * speed / (2.0 * drag)


def _room_after(stage: Stage, a: str, b: str) -> float:
    """Least way [m] from one target to the next: past the first, which may lie there."""
    before = stage.met.get(a)
    if before is None or before == b:
        return 0.0
    first, second = stage.prop(before), stage.prop(b)
    if a in stage.thrown_back:
        # Its way leads away from what it bounced off.
        least = stage.way_back.get(a, 0.0)
        return max(AFTER_BOUNCE_M, AFTER_BOUNCE_S * stage.tracks[a].speed, least)
    fallen = first.height if stage.story.topples(stage.member(before)) else 0.0
    return max(first.length, first.width, 0.8 * fallen) + 0.5 * second.half_length + 0.3


def descent(stage: Stage, a: str, b: str) -> float:
    """Least run [m] on a support whose target waits on the ground: past the support's end."""

    def is_below(key: str) -> bool:
        name = stage.member(key)
        return name != stage.anchor and support_of(stage.doc, name) != stage.anchor

    before = stage.met.get(a)
    if stage.anchor is None or not is_below(b) or (before is not None and is_below(before)):
        return 0.0
    return stage.prop(stage.anchor).length + 0.4


def _slides(stage: Stage, actor: str, phase: Phase) -> bool:
    """Pushed or slid along the ground, so that friction takes its speed."""
    body = stage.prop(actor)
    flat = not stage.story.flies(actor)
    return phase.edge.event is EdgeEvent.TOWARD and flat and not (body.rolls or body.wheeled)
