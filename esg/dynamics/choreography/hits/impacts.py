"""What a hit leads to: the struck body runs on into the next one, or the mover is thrown back."""

from __future__ import annotations

import math

from esg.dynamics.choreography.flights import hits_level, slowed, thrown_back
from esg.dynamics.choreography.hits.demands import KEPT
from esg.dynamics.choreography.hits.rows import ROUGHER, ROW_S, row_after
from esg.dynamics.choreography.placing import bring_support, goes_on, hits_on, yaw_met
from esg.dynamics.choreography.stage import Encounter, Stage
from esg.dynamics.story.kinematics import (
    Frame,
    Track,
    back_spin,
    braked,
    braking_distance,
    half_along,
    impact_speed,
    off_a_wall,
    rolling_travel,
    sliding_distance,
    sliding_travel,
)
from esg.dynamics.story.paces import usual_stop
from esg.dynamics.story.slabs import REACH, are_slabs, down_first
from esg.dynamics.story.solid import beside_the_middle
from esg.dynamics.story.stagecraft import (
    TO_EDGE_M,
    Prop,
    coasting_drag,
    support_of,
    top_surface,
)
from esg.dynamics.story.tipping import first_touch, stand_of
from esg.graph.models import NodeEvent, TimelineNode
from esg.thresholds import MIN_EVENT_GAP_S, RECHECK_AFTER_S
from esg.units import GRAVITY_MPS2

THROWN_BACK = 0.3
"""Share of its speed from which something that hits a heavier body counts as thrown back."""
APART_S, IN_ROW_S = 0.16, 0.22
"""Least time between two hits of a chain, and between those of a row of three or more."""
SEEN_TWICE_S = RECHECK_AFTER_S + 0.05
"""By how much later a driver comes to what stands fast than what it sent there."""
DULLER, SURE_REACH, STEP_M = 0.95, 0.9, 0.1
"""Share of its speed after a hit that is reckoned with then, share of the way that it slides on
which it surely gets there, and by how much a gap is widened at a time."""
CLEAR_M = 0.03
"""From what was met last to what is met next behind it, at least."""
DOWN_S, FALLEN, THIN_FALLEN = 0.3, 0.85, 0.7
"""Time in which a struck body falls over, and the shares of its height that are out of its reach
until it is down: of a broad body, and of one thin as a pin, which slides less."""
DOMINO_GAP = 0.7
"""Gap of dominoes over their height: nearer ones hit each other within a tenth of a second."""
FARTHEST_AHEAD = 1.2
"""Longest way, over its height, that the base of a body runs ahead while it tips back."""
LEAST_LEFT = 0.3
"""Least share of its speed that is reckoned with where something has slid to what it hits."""
NEXT_BALL_S = (0.15, 0.19)
"""Time between the hits of a chain of balls."""
BALL_GAP_M, ROW_GAP_M = 0.05, 0.01
"""Least gap between balls of a chain, and in a long row."""
BALL_GAP, NARROW = 0.45, 1.5
"""Share of the usual gap between balls of a chain; narrow things, in ball's widths, are as near."""
BOUNCE_RAD = math.radians(25.0)
"""Angle at which a ball meets a wall it bounces off, where it does not come straight back."""

BEHIND_M, LONGEST_BACK_S = 0.25, 2.5
"""From what bounced straight back, where it started, to what it meets; longest time of that way."""


def impact(stage: Stage, node: TimelineNode, a: str, b: str) -> None:
    """After the hit, b runs on along a's heading and a keeps the rest of the momentum."""
    if a in stage.tracks and a in stage.frames:
        source, frame = stage.tracks[a], stage.frames[a]
    else:
        source, frame = stage.moving.get(a, Track()), Frame()
    stage.time[node.id] = source.time
    if node.event is not NodeEvent.COLLISION:
        return
    pa, pb = stage.prop(a), stage.prop(b)
    restitution = 0.5 * (pa.restitution + pb.restitution)
    if b in stage.tracks:
        stage.struck[b] = impact_speed(pa.mass, pb.mass, source.speed, restitution)
        return
    if b not in stage.places:
        return
    if pb.fixed:
        _bounce(stage, node, a, b, restitution)
        return
    back = (restitution * pb.mass - pa.mass) / (pa.mass + pb.mass)
    if back > THROWN_BACK and not goes_on(stage, node, b):
        _bounce(stage, node, a, b, back)
        return
    speed = impact_speed(pa.mass, pb.mass, source.speed, restitution)
    x, y, _ = stage.places[b]
    heading = source.heading + frame.angle
    spin = 0.0
    if pa.rolls and pb.rolls:
        rubs = 0.5 * (pa.friction + pb.friction)
        spin = back_spin(pa.mass, pb.mass, source.speed, rubs, speed)
    stage.moving[b] = Track(x, y, heading, speed, source.time, spin, [(x, y)])
    left = max(0.05, source.speed - pb.mass / pa.mass * speed)
    if a in stage.arcs:
        slowed(stage, a, min(left / max(source.speed, 0.05), 1.0))
    source.speed = left


def _bounce(stage: Stage, node: TimelineNode, a: str, b: str, restitution: float) -> None:
    """A ball or puck that goes on to something else after a hit of a wall comes straight back.

    What waits for it lies behind its start: what meets a wall squarely is not turned aside by
    more or less friction or restitution. What is thrown meets the wall at the top of its flight.
    Where the time is too short for that, or the speed of a throw is stated, the wall is turned by
    `BOUNCE_RAD`, so that the way back does not lead over the start.
    """
    pa, pb = stage.prop(a), stage.prop(b)
    if a in stage.tracks and a in stage.frames:
        track, frame = stage.tracks[a], stage.frames[a]
    elif a in stage.moving:
        track, frame = stage.moving[a], Frame()
    else:
        return
    if pa.wheeled or not goes_on(stage, node, a) or b == stage.anchor:
        return
    if any(p.start.id == node.id and stage.strands(p) for p in stage.story.phases.get(a, ())):
        return
    heading = track.heading + frame.angle
    side = float(stage.rng.choice([-1.0, 1.0]))
    rolling = pa.rolls and not (a in stage.tracks and stage.story.flies(a))
    friction = 0.5 * (pa.friction + pb.friction)
    back, _ = off_a_wall(restitution, friction, rolling=rolling)
    level = hits_level(stage, node, a, b)
    least = None if level else _way_back(stage, node, a, b, max(back, 0.1) * track.speed)
    tilt = BOUNCE_RAD if least is None and not level else 0.0
    if least is not None:
        stage.way_back[a] = least
    normal, along = off_a_wall(restitution, friction, tilt, rolling=rolling)
    normal = max(normal, 0.1 * math.cos(tilt))
    x, y = frame.apply(track.x, track.y)
    # Its centre, where it touches, to the middle of the wall, which faces the ball obliquely.
    facing = heading + math.pi + side * tilt
    yaw = facing + (math.pi / 2 if pb.length > 1.15 * pb.width else 0.0)
    reach = pa.half_width + half_along(pb.length, pb.width, yaw - facing)
    contact = (
        x + (pa.half_length - pa.half_width) * math.cos(heading),
        y + (pa.half_length - pa.half_width) * math.sin(heading),
    )
    stage.places[b] = (
        contact[0] - reach * math.cos(facing),
        contact[1] - reach * math.sin(facing),
        yaw,
    )
    track.heading = facing + side * math.atan2(along, normal) - frame.angle
    track.speed *= math.hypot(normal, along)
    if a in stage.arcs:
        back = track.heading + frame.angle
        thrown_back(stage, a, back, restitution, friction, tilt)
    stage.thrown_back.add(a)


def returns(stage: Stage, node: TimelineNode, a: str, b: str) -> bool:
    """Whether a may come straight back over its start from b, which it meets first, on the ground.

    Args:
        stage: The stage.
        node: Their meeting.
        a: Who bounces off.
        b: What it bounces off.
    """
    if node.event is not NodeEvent.COLLISION or not stage.story.is_active(a):
        return False
    if stage.anchor is not None or stage.story.flies(a) or not stage.prop(b).fixed:
        return False
    return not (stage.prop(a).wheeled or a in stage.met) and goes_on(stage, node, a)


def _way_back(stage: Stage, node: TimelineNode, a: str, b: str, speed: float) -> float | None:
    """Least way [m] from b back past a's start to what it meets next; None if it takes too long."""
    if not returns(stage, node, a, b) or len(stage.tracks[a].points) > 2:
        return None
    track = stage.tracks[a]
    way = math.dist(track.points[0], (track.x, track.y)) + stage.prop(a).length + BEHIND_M
    lasts = LONGEST_BACK_S
    for later in stage.story.after(node.id):
        if a in map(stage.key, later.participants):
            asked = stage.prescribed_time(later)
            lasts = lasts if asked is None else asked - track.time
            break
    return way if way < lasts * speed else None


def chain(stage: Stage, e: Encounter) -> None:
    """A passive body set in motion by an earlier hit runs on into the next one."""
    a, b = e.a, e.b
    if a not in stage.moving and b in stage.moving:
        a, b = b, a
    track = stage.moving.get(a)
    if track is None or b in stage.places:
        return
    node, pa, pb = e.node, stage.prop(a), stage.prop(b)
    gap, rolled = _gap_to_next(stage, node, a, b, track)
    turn = stage.stated_turn(node, b, a)
    yaw = yaw_met(stage, node, a, b, track.heading, turn)
    if node.event is NodeEvent.ENTER_REGION:
        yaw = track.heading + math.pi
    aside = _aside(stage, node, a, b, track.heading, yaw)
    # What was met broadside goes on broadside.
    ahead = pa.half_length
    if a in stage.places:
        ahead = half_along(pa.length, pa.width, (stage.places[a][2] or 0.0) - track.heading)
    reach = gap + ahead + half_along(pb.length, pb.width, yaw - track.heading)
    reach = max(
        reach,
        _past(stage, a, b, track.heading) + half_along(pb.length, pb.width, yaw - track.heading),
    )
    reach = _landing(stage, node, a, b, track.speed) or reach
    c, s = math.cos(track.heading), math.sin(track.heading)
    stage.places[b] = (track.x + reach * c - aside * s, track.y + reach * s + aside * c, yaw)
    bring_support(stage, b, stage.places[b][0], stage.places[b][1], track.heading)
    left = track.speed if rolled is None else rolled
    if rolled is None and not (pa.rolls or stage.airborne or _falls_before(stage, node, a)):
        # It slides there, and arrives turned or tilted.
        slower = math.sqrt(max(left**2 - 2.0 * _drag(stage, pa) * gap, (LEAST_LEFT * left) ** 2))
        left = slower if pa.wheeled else min(KEPT * left, slower)
    track.straight(gap, gap / max(0.5 * (track.speed + left), 0.1), left)


def _past(stage: Stage, a: str, b: str, heading: float) -> float:
    """Way [m] from a to the far side of what it met last and pushes on, where that still stands."""
    before = stage.met.get(a)
    if before is None or before == b or before not in stage.places or a in stage.thrown_back:
        return 0.0
    first, pa = stage.prop(before), stage.prop(a)
    yaw = stage.places[before][2] or 0.0
    return pa.half_length + 2.0 * half_along(first.length, first.width, yaw - heading) + CLEAR_M


def _gap_to_next(
    stage: Stage, node: TimelineNode, a: str, b: str, track: Track
) -> tuple[float, float | None]:
    """Free way [m] of what was set in motion to the next body.

    And the speed [m/s] there of a ball, or of what slides in a long row.
    """
    pa, pb = stage.prop(a), stage.prop(b)
    gap = _coasting_gap(
        stage, pa, pb, track.speed, IN_ROW_S if _in_row(stage, node, a, b) else APART_S
    )
    if not pa.rolls and not pb.fixed and hits_on(stage, node, b):
        # Sliding on costs speed that the next ones need.
        gap = min(gap, sliding_travel(track.speed, coasting_drag(pa), IN_ROW_S))
    gap *= stage.tight
    if _is_thin(pa):
        # Tall and thin: it topples onto the next one, which stands within its reach.
        gap = DOMINO_GAP * pa.height if are_slabs(pa, pb) else min(gap, 0.5 * pa.height)
    if _falls_before(stage, node, a):
        gap = _gap_for_falling(stage, node, a, pb, track.speed, gap)
    rubs = 0.5 * (pa.friction + stage.ground_friction())
    rolled: float | None = None
    row = bool(row_after(stage, a, b))
    if (row or (pa.rolls and pb.rolls)) and node.event is NodeEvent.COLLISION:
        lasts = float(stage.rng.uniform(*(ROW_S if row else NEXT_BALL_S))) * stage.tight
        if pa.rolls:
            # It slides at first, against its back spin: later balls of a chain are much slower.
            gap, rolled = rolling_travel(track.speed, rubs, lasts, track.spin)
        else:
            gap, rolled = braked(track.speed, _drag(stage, pa), lasts)
        gap = max(gap, ROW_GAP_M if row else BALL_GAP_M)
    if pb.fixed and pb.height >= pa.height and stage.tight >= 1.0:  # a long way leads over low ones
        gap = _out_of_reach(stage, a, track.speed, gap)
    prescribed = stage.prescribed_time(node)
    if prescribed is not None:
        wait = max(prescribed - track.time, 0.05)
        slows = braking_distance(1.0, pa.damping, wait) / wait
        gap = max(0.1, sliding_travel(track.speed, _drag(stage, pa), wait) * slows)
        if pa.rolls:
            gap = max(0.05, rolling_travel(track.speed, rubs, wait, track.spin)[0] * slows)
    return gap, rolled


def _out_of_reach(stage: Stage, a: str, speed: float, gap: float) -> float:
    """The gap [m] to what stands fast, widened so that a is not crushed against it.

    Who drove into a brakes (`plan.cast.brakes_after`) and falls behind on the way: it is to come
    when the hit has been looked at for the second time.

    Args:
        stage: The stage.
        a: What was sent on its way.
        speed: Its speed after that hit [m/s].
        gap: Free way that it has otherwise [m].
    """
    body = stage.prop(a)
    driver = next((k for k in stage.tracks if stage.met.get(k) == a), None)
    if driver is None or body.rolls or not stage.prop(driver).wheeled:
        return gap
    follows = stage.tracks[driver].speed
    brakes = usual_stop(stage.doc, stage.member(driver), follows)
    speed, drag = DULLER * speed, ROUGHER * _drag(stage, body)
    longest = SURE_REACH * sliding_distance(speed, drag / GRAVITY_MPS2)
    while gap < longest:
        lead = _covered_after(follows, brakes, gap) - _covered_after(speed, drag, gap)
        if lead >= SEEN_TWICE_S:
            break
        gap = min(gap + STEP_M, longest)
    return gap


def _covered_after(speed: float, slows: float, way: float) -> float:
    """When what slows down [m/s^2] has covered a way [m], inf if it stops before [s]."""
    left = speed**2 - 2.0 * slows * way
    return (speed - math.sqrt(left)) / slows if left > 0.0 else math.inf


def _is_thin(body: Prop) -> bool:
    return body.height > 2.5 * body.length and not body.rolls


def _gap_for_falling(
    stage: Stage, node: TimelineNode, a: str, pb: Prop, speed: float, gap: float
) -> float:
    """The gap [m], widened so that a is down before it gets to the next body."""
    pa = stage.prop(a)
    slides = sliding_distance(speed, 0.5 * (pa.friction + pa.rough))
    falls = max(DOWN_S, math.sqrt(pa.height / GRAVITY_MPS2) + MIN_EVENT_GAP_S)
    gap = max(gap, min(falls * speed, 0.5 * slides))
    if pa.rolls or stage.airborne:
        return gap
    # It reaches as far as it is high, and touches what is nearer while it still stands.
    gap = max(gap, (THIN_FALLEN if _is_thin(pa) else FALLEN) * pa.height)
    if are_slabs(pa, pb) and down_first(pa.height, knocked=True):
        gap = REACH * pa.height
    if _kicked(stage, node, a):
        ahead = (math.sqrt(pa.height / GRAVITY_MPS2) + MIN_EVENT_GAP_S) * speed
        gap = max(gap, min(ahead, FARTHEST_AHEAD * pa.height))
    return gap


def _aside(stage: Stage, node: TimelineNode, a: str, b: str, heading: float, yaw: float) -> float:
    """How far [m] to the left of a's way the next body stands."""
    pb = stage.prop(b)
    jitter = float(stage.rng.uniform(-0.3, 0.3)) * pb.half_lateral(yaw - heading)
    if (pb.rolls and goes_on(stage, node, b)) or row_after(stage, a, b):
        # Off its middle it would leave the line on which the next one lies.
        jitter = 0.0
    if stage.story.topples(stage.member(b)):
        # A hit past its middle turns it instead.
        jitter = 0.0
    off = beside_the_middle(stage.prop(a), pb, heading - yaw)
    return -off if off else jitter


def _drag(stage: Stage, body: Prop) -> float:
    """Deceleration [m/s^2] of a body that slides on, or coasts, where it all takes place."""
    ground = 0.0 if body.wheeled else stage.ground_friction()
    return 0.5 * (body.friction + ground) * GRAVITY_MPS2


def _landing(stage: Stage, node: TimelineNode, a: str, b: str, speed: float) -> float | None:
    """Way [m] from where a body is knocked off its support to what it comes down in, or None."""
    if node.event is not NodeEvent.ENTER_REGION:
        return None
    support = support_of(stage.doc, stage.member(a))
    before = stage.story.ancestors(node.id)
    falls = any(
        n.id in before and n.event is NodeEvent.FALL and a in map(stage.key, n.participants)
        for n in stage.story.nodes.values()
    )
    if not falls or support is None or support_of(stage.doc, stage.member(b)) is not None:
        return None
    height = top_surface(stage.doc, support).center_cm[2] / 100.0 - stage.prop(b).height
    if height < 0.05:
        return None
    over_edge = math.sqrt(max(speed**2 - 2.0 * coasting_drag(stage.prop(a)) * TO_EDGE_M, 0.04))
    return TO_EDGE_M + over_edge * math.sqrt(2.0 * height / GRAVITY_MPS2)


def _falls_before(stage: Stage, node: TimelineNode, a: str) -> bool:
    """Whether a body has toppled by the time of an event."""
    before = stage.story.ancestors(node.id)
    return any(
        n.id in before and n.event is NodeEvent.TOPPLE and a in map(stage.key, n.participants)
        for n in stage.story.nodes.values()
    )


def _kicked(stage: Stage, node: TimelineNode, a: str) -> bool:
    """Whether a body was hit below its centre: its base runs ahead while it tips back."""
    body = stage.prop(a)
    stand = stand_of(body)
    before = stage.story.ancestors(node.id)
    for hit in stage.story.nodes.values():
        keys = list(map(stage.key, hit.participants))
        if hit.id not in before or hit.event is not NodeEvent.COLLISION or a not in keys:
            continue
        for mover in keys:
            flies = mover in stage.tracks and stage.story.flies(mover)
            if mover != a and not flies:
                touch = first_touch(stage.prop(mover), body, stand, flies=False)
                return touch is not None and touch.height < stand.height
    return False


def _in_row(stage: Stage, node: TimelineNode, a: str, b: str) -> bool:
    """Whether a hit of something carried leads to another one, or follows from one."""
    if hits_on(stage, node, b):
        return True
    before = stage.story.ancestors(node.id)
    return any(
        n.id in before
        and n.event is NodeEvent.COLLISION
        and a in (keys := list(map(stage.key, n.participants)))
        and not any(k in stage.tracks for k in keys)
        for n in stage.story.nodes.values()
    )


def _coasting_gap(stage: Stage, body: Prop, target: Prop, speed: float, apart_s: float) -> float:
    """Free run [m] to the next target that a body set in motion surely covers.

    A ball that hits a ball off its centre by x sends it off by x over their radii, so that each
    further ball of a chain multiplies an error by the gap in diameters: balls lie close.
    """
    rubs = body.friction if body.wheeled else body.friction + body.rough
    reach = 50.0 if body.rolls else sliding_distance(speed, 0.5 * rubs)
    preferred = float(stage.rng.uniform(0.28, 0.36)) * speed
    if body.rolls and (target.rolls or max(target.length, target.width) < NARROW * body.width):
        preferred *= BALL_GAP
    far = 0.4 * reach
    if not body.rolls:
        # What follows within a tenth of a second counts as the same hit.
        far = max(far, min(sliding_travel(speed, coasting_drag(body), apart_s), 0.75 * reach))
    return max(0.05, min(preferred, far, 2.5))
