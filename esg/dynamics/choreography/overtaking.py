"""One driver passes another, and may cut in before it and be run into from behind."""

from __future__ import annotations

import math

from esg.dynamics.choreography.braking import INTO_HIT, shortest, slow_down
from esg.dynamics.choreography.placing import asked_distance
from esg.dynamics.choreography.setting_off import ride_of
from esg.dynamics.choreography.stage import FASTEST_MPS, Encounter, Stage, speed_is_fixed
from esg.dynamics.story.kinematics import Frame
from esg.dynamics.story.story import Phase
from esg.graph.models import EdgeEvent, NodeEvent, TimelineNode

BESIDE_M = 0.6
"""Gap between two that drive side by side."""
CLEAR_M = 1.5
"""How far one is ahead of the other when it cuts in."""
CUT_IN_S = 1.2
"""Time it is given for that after they were side by side, beside what the story leaves."""
OVERLAP = 0.3
"""Offset of the two at the hit, as a share of the other's half width."""
LONGEST_S = 6.0
SLOWER = 0.9
"""Speed of who was overtaken, at most, over the other's."""


def overtakes(stage: Stage, e: Encounter) -> bool:
    """Whether a can pass b, which drives from the start on, at the speeds that are given."""
    return e.phase is not None and e.node.event is NodeEvent.MISS and _speeds(stage, e) is not None


def _speeds(stage: Stage, e: Encounter) -> tuple[float, float] | None:
    """Speeds [m/s] of a and of b, None where b does not drive or a cannot pass it."""
    a, b, phase = e.a, e.b, e.coming
    if b not in stage.tracks or b in stage.frames or stage.story.flies(a):
        return None
    slow_phase = stage.story.phases[b][0]
    if slow_phase.start.event is not NodeEvent.SCENE_START:
        return None
    if slow_phase.edge.event not in (EdgeEvent.UNIFORM_MOTION, EdgeEvent.ACCELERATED_MOTION):
        return None
    fast, slow = stage.speed(a, phase), stage.speed(b, slow_phase)
    gain = (_reach(stage, a, b) + CLEAR_M) / CUT_IN_S
    if not speed_is_fixed(phase):
        low = slow if speed_is_fixed(slow_phase) else 0.6 * gain
        fast = min(max(fast, low + gain), max(FASTEST_MPS, 1.3 * low))
    if not speed_is_fixed(slow_phase):
        slow = max(min(slow, fast - gain), 0.35 * fast)
    return None if fast < 1.1 * slow else (fast, slow)


def _reach(stage: Stage, a: str, b: str) -> float:
    """Distance of two centres [m] that touch end to end."""
    return stage.prop(a).half_length + stage.prop(b).half_length


def overtake(stage: Stage, e: Encounter) -> None:
    """Lets a pass b, which drives the same way at a lower speed from the start on."""
    node, a, b, phase = e.node, e.a, e.b, e.coming
    speeds = _speeds(stage, e)
    assert speeds is not None
    fast, slow = speeds
    track, pa, pb = stage.tracks[a], stage.prop(a), stage.prop(b)
    prescribed = stage.prescribed_time(node)
    duration = (_reach(stage, a, b) + CLEAR_M) / (fast - slow)
    if prescribed is not None:
        duration = max(prescribed - track.time, 0.2)
    ride = ride_of(stage, a, phase, fast)
    if prescribed is None and not math.isinf(ride.rate):
        duration += ride.gaining
    stage.nominal[f"{phase.edge.id}/speed"] = fast
    stage.nominal[f"{stage.story.phases[b][0].edge.id}/speed"] = slow
    track.straight(ride.way(duration), duration, ride.left(duration))
    stage.time[node.id] = stage.nominal[f"{node.id}/time"] = track.time
    frame = stage.frames.setdefault(a, Frame())
    stage.places[a] = (*frame.apply(0.0, 0.0), frame.angle)
    beside = pa.half_width + pb.half_width + (asked_distance(stage, node, a) or BESIDE_M)
    _put_beside(stage, a, b, (track.x, track.y), track.heading, beside, slow * track.time)
    stage.overtaken[b] = (a, track.time, (track.x, track.y))


def cut_in(stage: Stage, e: Encounter) -> None:
    """Who has overtaken, b, comes before a, at a small angle, slows down and is run into."""
    node, behind, front, chase, lead = e.node, e.a, e.b, e.coming, e.turned().coming
    rear, ahead = stage.tracks[behind], stage.tracks[front]
    side, back = stage.prop(front), stage.prop(behind)
    _, passed, place = stage.overtaken[behind]
    fast, key = ahead.speed, f"{chase.edge.id}/speed"
    # What goes on after it was overtaken is still the slower one.
    slow = stage.nominal.setdefault(key, min(stage.speed(behind, chase), SLOWER * fast))
    reach = side.half_length + back.half_length
    gained = (fast - slow) * (ahead.time - passed)
    wait = 0.0
    ahead_by = reach + max(CLEAR_M, _lost(stage, lead, fast, slow))
    if gained < ahead_by and not lead.start.time_is_prescribed:
        wait = (ahead_by - gained) / (fast - slow)
        gained = ahead_by
        ahead.straight(fast * wait, wait, fast)
        stage.time[lead.start.id] = stage.nominal[f"{lead.start.id}/time"] = ahead.time
    way, duration, left = _slowing(stage, node, lead, ahead.time, fast, slow, gained - reach)
    began = ahead.time
    ahead.straight(way, duration, left)
    rear.straight(slow * (ahead.time - rear.time), ahead.time - rear.time, slow)
    stage.time[node.id] = ahead.time
    # Beside each other until it is clear, and before the other when they touch.
    total = fast * (began - passed) + way
    clear = fast * reach / (fast - slow)
    across = side.half_width + back.half_width + BESIDE_M
    shift = across - OVERLAP * back.half_width
    angle = math.asin(min(0.3, shift / max(total - 0.8 * clear, 1.0)))
    beside = across + 0.8 * clear * math.sin(angle)
    _put_beside(stage, front, behind, place, ahead.heading + angle, beside, slow * passed)


def _slowing(
    stage: Stage,
    node: TimelineNode,
    lead: Phase,
    now: float,
    fast: float,
    slow: float,
    gap: float,
) -> tuple[float, float, float]:
    """Way [m], time [s] and last speed of who slows down until the one behind has caught up."""
    if lead.edge.event is not EdgeEvent.BRAKE:
        left = fast if speed_is_fixed(lead) else min(fast, 0.4 * slow)
        stage.nominal[f"{lead.edge.id}/speed"] = left
        duration = gap / max(slow - left, 0.2)
        return left * duration, duration, left
    prescribed = stage.prescribed_time(node)
    if prescribed is not None:
        duration = max(prescribed - now, 0.2)
        # It has lost on the other what that was behind.
        left = max(fast - 2.0 * max(fast - slow + gap / duration, 0.0), 0.0)
        return slow_down(stage, lead, fast, left, duration)
    rate = stage.halt(lead.edge.actor, fast)
    duration = _caught_up(fast, slow, gap, rate)
    return slow_down(stage, lead, fast, max(fast - rate * duration, 0.0), duration)


def _lost(stage: Stage, lead: Phase, fast: float, slow: float) -> float:
    """Way [m] that one who brakes loses on another until it counts as braking."""
    if lead.edge.event is not EdgeEvent.BRAKE:
        return 0.0
    duration = shortest(stage, lead.edge.actor, fast)
    return (slow - 0.5 * (1.0 + INTO_HIT) * fast) * duration


def _caught_up(fast: float, slow: float, gap: float, rate: float) -> float:
    """Time [s] in which one at a constant speed catches up with another that brakes."""
    gains = fast - slow
    duration = (gains + math.sqrt(gains * gains + 2.0 * rate * gap)) / rate
    stands = fast / rate
    if duration > stands:
        duration = (gap + 0.5 * fast * stands) / slow
    return min(duration, LONGEST_S)


def _put_beside(
    stage: Stage,
    a: str,
    b: str,
    at: tuple[float, float],
    heading: float,
    beside: float,
    before: float,
) -> None:
    """Lets b be to the right of a when that is at a point of its way, coming from behind it.

    Args:
        stage: The stage.
        a: Who overtakes.
        b: Who is overtaken.
        at: The point, in a's own frame [m].
        heading: Of b, in a's own frame [rad].
        beside: Distance of their centres then [m].
        before: Way of b until then [m].
    """
    frame = stage.frames[a]
    x, y = frame.apply(*at)
    heading += frame.angle
    c, s = math.cos(heading), math.sin(heading)
    x, y = x + beside * s - before * c, y - beside * c - before * s
    stage.frames[b] = Frame(x, y, heading)
    stage.places[b] = (x, y, heading)
