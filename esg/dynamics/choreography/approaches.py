"""Straight at what waits: down a ramp, braking, sliding, driving, rolling, flying or thrown."""

from __future__ import annotations

from dataclasses import dataclass, replace
import math

from esg.dynamics.choreography.braking import brake_into
from esg.dynamics.choreography.courses.rounds import way_needed
from esg.dynamics.choreography.encounters import covers
from esg.dynamics.choreography.falling.throws import (
    asked_height,
    comes_to_lie,
    hand_height,
    is_lobbed,
    level_height,
    putts,
    sends_on,
    slowest_passage,
    within_reach,
)
from esg.dynamics.choreography.flights import took_off
from esg.dynamics.choreography.hits.caroms import is_carom
from esg.dynamics.choreography.hits.demands import (
    FELT_SURELY,
    demanded,
    felt_speed,
    passed_on,
    sends_sliding,
    thrown_off_speed,
    timed_push,
)
from esg.dynamics.choreography.hits.impacts import returns
from esg.dynamics.choreography.hits.rows import row_after
from esg.dynamics.choreography.hovering import fly_in
from esg.dynamics.choreography.placing import (
    asked_distance,
    gap_at_start,
    goes_on,
    join,
    stays_there,
    struck_again,
)
from esg.dynamics.choreography.setting_off import gain_of, ride_of
from esg.dynamics.choreography.slopes import descend, goes_down
from esg.dynamics.choreography.stage import FASTEST_MPS, Encounter, Stage, speed_is_fixed
from esg.dynamics.story.kinematics import Ride, lob_time
from esg.dynamics.story.stagecraft import (
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
from esg.graph.models import EdgeEvent, NodeEvent
from esg.units import GRAVITY_MPS2

MAX_APPROACH_M = 45.0
AT_THE_FOOT_M = 0.1
"""What starts no higher than this is kicked, whatever a hand reaches."""
SHORTEST_S = 0.15
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
ROW_RUN_S, ROW_RUN_LENGTHS = 0.25, 2.0
"""Run-up of what rolls into a long row, in time or in its lengths: every hit multiplies its aim."""
ROW_RUN = 0.2
"""Share of its speed that what slides loses on its way into a long row."""
STANDSTILL_MPS, CRAWL_MPS = 0.5, 0.05
"""Speed with which something that accelerates sets off at most, and that of what stands still."""
GAINS_TO_MPS = 100.0
"""Speed beyond which nothing that gains speed is followed."""
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


@dataclass(frozen=True)
class Demand:
    """What an approach is to achieve.

    Args:
        speed: At which the mover comes [m/s].
        least: Of a hit that counts and sends its target on [m/s].
        needed: Without which something of the story cannot happen [m/s].
        prescribed: When the prompt has the event take place [s], None where that is open.
        asked: Way that the prompt has the mover cover [m], None where that is open.
        chained: Balls hit each other: the less way there is, the less an error of the aim grows.
        topples: The target shall topple.
    """

    speed: float
    least: float
    needed: float
    prescribed: float | None
    asked: float | None
    chained: bool
    topples: bool

    def time_left(self, now: float) -> float | None:
        """Time [s] until the event, None where that is open."""
        return None if self.prescribed is None else max(SHORTEST_S, self.prescribed - now)


@dataclass(frozen=True)
class Run:
    """A straight way [m], the time it takes [s], and the speed it ends with [m/s]."""

    way: float
    lasts: float
    left: float


# -- rows of `meetings.MEETINGS` -----------------------------------------------------------------


def comes_down(stage: Stage, e: Encounter) -> bool:
    """Whether a ramp leads from the mover to what waits."""
    return goes_down(stage, e.a, e.b) is not None


def come_down(stage: Stage, e: Encounter) -> None:
    """It is let go at the top of the ramp; what waits stands at its foot."""
    demand = _demand(stage, e)
    needed = max(demand.needed, demand.least)
    run = Run(*descend(stage, e.node, e.a, e.coming, e.b, needed))
    _arrive(stage, e, demand, run)


def brakes(stage: Stage, e: Encounter) -> bool:
    """Whether the mover brakes on its way."""
    return e.coming.edge.event is EdgeEvent.BRAKE


def brake(stage: Stage, e: Encounter) -> None:
    """It brakes, and still gets there."""
    demand, track = _demand(stage, e), stage.tracks[e.a]
    speed = track.speed or demand.speed
    run = Run(*brake_into(stage, e.coming, speed, demand.prescribed, track.time))
    _arrive(stage, e, demand, run)


def slides(stage: Stage, e: Encounter) -> bool:
    """Whether the mover was pushed or slid along the ground, so that friction takes its speed."""
    body = stage.prop(e.a)
    flat = not stage.story.flies(e.a)
    return e.coming.edge.event is EdgeEvent.TOWARD and flat and not (body.rolls or body.wheeled)


def slide_in(stage: Stage, e: Encounter) -> None:
    """It slides, and is still fast enough when it gets there."""
    demand, phase, body = _demand(stage, e), e.coming, stage.prop(e.a)
    speed, row = demand.speed, row_after(stage, e.a, e.b)
    if demand.needed > 0.0 and not phase.edge.speed_is_prescribed:
        # What it is to arrive with is less than what it starts with.
        slid = 1.0 - ROW_RUN if row else SLID
        speed = max(speed, min(demand.needed / slid, FASTEST_MPS))
    lasts = demand.time_left(stage.tracks[e.a].time)
    if row and lasts is None:
        lasts = ROW_RUN * speed / max(coasting_drag(body), 0.1)
    speed, way, lasts, left = slide(
        body,
        speed,
        lasts,
        stage.rng,
        adjustable=not speed_is_fixed(phase),
    )
    way = max(way, _past_the_end(stage, e.a, e.b), _room_after(stage, e.a, e.b), _passing(stage, e))
    stage.nominal[f"{phase.edge.id}/speed"] = speed
    _arrive(stage, e, demand, Run(way, lasts, left))


def come(stage: Stage, e: Encounter) -> None:
    """It drives, walks, rolls, flies or is thrown there."""
    demand = _demand(stage, e)
    gaining = _gains(stage, e.a, e.coming, demand.speed)
    run = _run_up(stage, e, demand)
    demand = _slow_enough(stage, e, demand)
    if _thrown(stage, e.a) and not _comes_down(stage, e) and stage.anchor is None:
        run = _throwing_distance(stage, e, demand, run)
    speed, lasts = _pace(stage, e, demand, run)
    ride = gaining or ride_of(stage, e.a, e.coming, speed)
    if math.isinf(ride.rate):
        _come_at_speed(stage, e, demand, speed, lasts)
    else:
        _come_faster(stage, e, demand, ride, run)


def _come_at_speed(stage: Stage, e: Encounter, demand: Demand, speed: float, lasts: float) -> None:
    """It is under way at its speed [m/s], for a time [s] that the room may lengthen."""
    phase = e.coming
    way = demand.asked or covers(stage, e.a, phase, speed, lasts)[0]
    if demand.prescribed is None:
        way = max(way, _room_after(stage, e.a, e.b))
        lasts = way / max(speed, CRAWL_MPS)
    if way > MAX_APPROACH_M and not speed_is_fixed(phase):
        speed, way = MAX_APPROACH_M / lasts, MAX_APPROACH_M
    stage.nominal[f"{phase.edge.id}/speed"] = speed
    _arrive(stage, e, demand, Run(way, lasts, speed))


def _come_faster(stage: Stage, e: Encounter, demand: Demand, ride: Ride, run: float) -> None:
    """It gains speed on its way, at least as much as its hit needs where the time is open."""
    lasts = demand.time_left(stage.tracks[e.a].time)
    if lasts is not None and e.node.event is NodeEvent.REACH and stays_there(stage, e.node, e.a):
        lasts -= ride.left(lasts) / stage.halt(e.a, ride.speed)
    if lasts is None:
        needed = ride.until(max(demand.needed, demand.least))
        lasts = ride.lasts(demand.asked or max(run, needed, _room_after(stage, e.a, e.b)))
    gains = f"{e.coming.edge.id}/acceleration" in stage.nominal
    stage.nominal[f"{e.coming.edge.id}/speed"] = ride.first if gains else ride.speed
    _arrive(stage, e, demand, Run(ride.way(lasts), lasts, ride.left(lasts)))


# -- how hard, when, how far ---------------------------------------------------------------------


def _demand(stage: Stage, e: Encounter) -> Demand:
    """How fast a shall come to b, and by when."""
    node, a, b, phase = e.node, e.a, e.b, e.coming
    pa, pb = stage.prop(a), stage.prop(b)
    again = struck_again(stage, node, a, b)
    chained = (pa.rolls and pb.rolls and goes_on(stage, node, b)) or is_carom(stage, node, a, b)
    slow = stage.slowly(a, phase)
    # Who only comes near, or passes, has no hit to be felt, however light he is.
    touches = node.event not in GAPPED
    felt_at = min_hit_speed(pa, pb) if touches else 0.0
    least = felt_at if slow is None else min(felt_at, slow)
    if chained:
        least *= CHAINED
    elif goes_on(stage, node, b) and not (again or row_after(stage, a, b)):
        least = max(least, push_speed(pa, pb), timed_push(stage, node, pa, b))
    topples = stage.story.topples(stage.member(b))
    needed = topple_speed(pa, pb, flies=stage.story.flies(a)) if topples else 0.0
    if stage.story.falls(stage.member(b)) and phase.edge.event is EdgeEvent.TOWARD:
        needed = max(needed, fall_speed(pa, pb))
    needed = max(needed, demanded(stage, node, a, b), thrown_off_speed(stage, node, a))
    if not chained and touches:
        felt = felt_speed(pa, pb)
        needed = max(needed, felt if slow is None else min(felt, max(slow, felt / FELT_SURELY)))
    speed = stage.speed(a, phase, max(least, needed), needed)
    prescribed, asked = stage.prescribed_time(node), _asked(stage, e)
    demand = Demand(speed, least, needed, prescribed, asked, chained, topples)
    if not phase.edge.speed_is_prescribed:
        demand = replace(demand, speed=_fitting_speed(stage, e, demand, again=again))
    left = demand.time_left(stage.tracks[a].time)
    if asked is None or left is None or speed_is_fixed(phase):
        return demand
    return replace(demand, speed=asked / left)


def _asked(stage: Stage, e: Encounter) -> float | None:
    """Way [m] that the prompt has a cover until it gets to b, or None."""
    asked = asked_distance(stage, e.node, e.a) if e.node.event not in GAPPED else None
    if asked is not None or e.node.event is not NodeEvent.COLLISION:
        return asked
    begins = stage.tracks[e.a].time <= 0.0 and e.b not in stage.places
    return gap_at_start(stage, e.a, e.b) if begins else None


def _fitting_speed(stage: Stage, e: Encounter, demand: Demand, *, again: bool) -> float:
    """The speed [m/s] of an approach, where that is open, as what comes after it wants it."""
    node, a, b = e.node, e.a, e.b
    pa, pb = stage.prop(a), stage.prop(b)
    speed, least, needed = demand.speed, demand.least, demand.needed
    if row_after(stage, a, b):
        # As gently as its last hit still counts with: faster, it would have to be longer.
        return min(speed, max(least, needed))
    if demand.prescribed is None and sends_sliding(stage, node, b):
        # Faster, it would tumble, and pass over the next one in another engine.
        low, high, _ = bounds(e.coming.edge.params.speed, (0.0, 0.0))
        calm = max(CALM_MPS / passed_on(pa, pb), least, needed, (0.9 * low + 0.1 * high) / 100.0)
        speed = min(speed, calm)
    if again:
        # Gently: the next one is to find it.
        speed = max(least, needed, GENTLE * speed)
    if putts(stage, node, a, b):
        speed = min(speed, max(PUTT_MPS, PUTT_NS / pb.mass) / passed_on(pa, pb))
    return speed


def _slow_enough(stage: Stage, e: Encounter, demand: Demand) -> Demand:
    """The demand with a speed at which what rolls through an opening is in it for a while."""
    inside = e.node.event is NodeEvent.ENTER_REGION
    if not inside or stage.story.flies(e.a) or speed_is_fixed(e.coming):
        return demand
    slow = max(slowest_passage(stage, e.node) / STAY_S, 0.3)
    return replace(demand, speed=min(demand.speed, slow))


def _run_up(stage: Stage, e: Encounter, demand: Demand) -> float:
    """Free way [m] from a to b, where the prompt gives none."""
    a, speed = e.a, demand.speed
    run = approach_distance(stage.prop(a), max(speed, 1.0), stage.rng) * stage.tight
    if demand.chained:
        run *= CHAINED
    if row_after(stage, a, e.b):
        run = min(run, max(ROW_RUN_S * speed, ROW_RUN_LENGTHS * stage.prop(a).length))
    if a in stage.thrown_back:
        run = min(run, max(AFTER_BOUNCE_M, AFTER_BOUNCE_S * stage.tracks[a].speed))
        run = max(run, stage.way_back.get(a, 0.0))
    if returns(stage, e.node, a, e.b):
        run = min(run, max(RETURN_M, RETURN_S * speed))
    run = min(run, _fresh_run(stage, a, e.coming, speed))
    return max(run, _past_the_end(stage, a, e.b), _passing(stage, e))


def _throwing_distance(stage: Stage, e: Encounter, demand: Demand, run: float) -> float:
    """Way [m] of a throw at something on the ground: farther off than a run-up, or level."""
    if (demand.topples and speed_is_fixed(e.coming)) or sends_on(stage, e.node, e.b):
        return max(LEVEL_S * demand.speed, LEAST_LEVEL_M)
    return max(run, min(FLIGHT_S * demand.speed, LONGEST_THROW_M))


def _thrown(stage: Stage, a: str) -> bool:
    """Whether a is in the air without power of its own."""
    return stage.story.flies(a) and not stage.story.soars(a)


def _tossed(stage: Stage, e: Encounter) -> bool:
    """Whether a comes down into what opens upwards or on a top, at a speed that is open."""
    return _thrown(stage, e.a) and _comes_down(stage, e) and not speed_is_fixed(e.coming)


def _comes_down(stage: Stage, e: Encounter) -> bool:
    """Whether a throw ends from above: in an opening, or where it is to lie."""
    return is_lobbed(stage, e.node) or comes_to_lie(stage, e.node, e.a, e.b)


def _pace(stage: Stage, e: Encounter, demand: Demand, run: float) -> tuple[float, float]:
    """Speed [m/s] and time [s] of an approach over a free way [m]."""
    phase, speed, tossed = e.coming, demand.speed, _tossed(stage, e)
    wait = demand.time_left(stage.tracks[e.a].time)
    if wait is not None:
        if e.node.event is NodeEvent.REACH and stays_there(stage, e.node, e.a):
            # Its way ends at rest.
            rate = stage.halt(e.a, speed)
            speed = min(speed, 0.5 * rate * wait)
            wait -= speed / rate
        if not (_thrown(stage, e.a) or phase.edge.speed_is_prescribed):
            speed = max(speed * stage.tight, min(speed, demand.least))
        return min(speed, LOB_M / wait) if tossed else speed, wait
    if not tossed:
        return speed, (demand.asked or run) / max(speed, CRAWL_MPS)
    # Steep enough to come down through an opening that looks up.
    pa, pb = stage.prop(e.a), stage.prop(e.b)
    way = demand.asked or LOB_M
    hand = within_reach(stage, e.node, e.a, hand_height(stage, e.node, e.b, pa, pb))
    lasts = lob_time(way + pb.half_length, hand - pb.height)
    return way / lasts, lasts


def _gains(stage: Stage, actor: str, phase: Phase, speed: float) -> Ride | None:
    """How an approach of which the prompt says that it gains speed does so; None for others."""
    edge, track = phase.edge, stage.tracks[actor]
    if edge.event is not EdgeEvent.ACCELERATED_MOTION:
        return None
    rate = gain_of(stage, actor, phase)
    if not (speed_is_fixed(phase) and edge.params.speed is not None):
        speed = track.speed if track.time > 0.0 else min(speed, STANDSTILL_MPS)
    stage.nominal[f"{edge.id}/acceleration"] = rate
    return Ride(speed, rate, GAINS_TO_MPS)


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


def _passing(stage: Stage, e: Encounter) -> float:
    """Least way [m] of a first run that leads through or over something."""
    return way_needed(stage, e.a) if e.coming is stage.story.phases[e.a][0] else 0.0


def _past_the_end(stage: Stage, a: str, b: str) -> float:
    """Least run [m] on a support whose target waits on the ground: past the support's end."""

    def is_below(key: str) -> bool:
        name = stage.member(key)
        return name != stage.anchor and support_of(stage.doc, name) != stage.anchor

    before = stage.met.get(a)
    if stage.anchor is None or not is_below(b) or (before is not None and is_below(before)):
        return 0.0
    return stage.prop(stage.anchor).length + 0.4


# -- there ---------------------------------------------------------------------------------------


def _arrive(stage: Stage, e: Encounter, demand: Demand, run: Run) -> None:
    """Moves a along, gives what flies its height, and puts the end of the way at b's surface."""
    track = stage.tracks[e.a]
    track.straight(run.way, run.lasts, run.left)
    if stage.story.soars(e.a):
        fly_in(stage, e.node, e.a, e.coming, run.way)
    elif stage.story.takes_off(e.a):
        # Steeper than a ramp.
        stage.nominal[f"{e.coming.edge.id}/flight_time"] = math.sqrt(
            2.0 * run.way * TAKE_OFF / GRAVITY_MPS2
        )
    elif stage.story.flies(e.a):
        stage.heights[e.a] = _release_height(stage, e, demand, run.lasts)
        stage.nominal[f"{e.coming.edge.id}/flight_time"] = run.lasts
        took_off(stage, e.a, e.coming, track.time)
    join(stage, e.a, e.b, e.node)


def _release_height(stage: Stage, e: Encounter, demand: Demand, lasts: float) -> float:
    """Height [m] of the bottom of what is thrown, where it is let go."""
    pa, pb = stage.prop(e.a), stage.prop(e.b)
    asked = asked_height(stage, e.node, e.a)
    if asked is not None and asked <= AT_THE_FOOT_M:
        return asked  # kicked
    stands = support_of(stage.doc, stage.member(e.b)) is None
    if demand.topples and speed_is_fixed(e.coming) and stands:
        return level_height(pb, pa, lasts)
    if sends_on(stage, e.node, e.b):
        return level_height(pb, pa, lasts, MIDDLE)
    return within_reach(stage, e.node, e.a, hand_height(stage, e.node, e.b, pa, pb))
