"""What turns about an upright axle as it opens or closes, and sweeps what stands in its way."""

from __future__ import annotations

import math

from esg.dynamics.choreography.hits.demands import demanded, felt_speed
from esg.dynamics.choreography.placing import bring_support, yaw_met
from esg.dynamics.choreography.stage import Encounter, Stage
from esg.dynamics.story.driving import OPENS_RAD, Leaf, goal_of, leaf_of
from esg.dynamics.story.kinematics import Frame, half_along
from esg.dynamics.story.stagecraft import fall_speed
from esg.dynamics.story.story import Phase
from esg.dynamics.story.tipping import topple_speed, topples_by_push
from esg.graph.models import EdgeEvent, NodeEvent

OPENS_S = 1.5
"""How long something is opened or closed, where nobody says."""
FASTEST_MPS = 3.0
"""A slammed door, where it meets something (EN 1154 has closers stay below 0.5 m/s)."""
HARDER = 2.0
"""Over the speed at which what slides trips in the closed form: it first bounces off the leaf."""
SHARES = (0.6, 0.5, 0.7, 0.4, 0.8, 0.3, 0.9)
"""Shares of its way at which a leaf may meet something, the best one first."""
AT_REACH = (0.7, 0.85, 0.5)
"""Shares of its reach at which the first thing stands in its way, the second one, the third."""
CLEAR_M = 0.12
"""Between what it is to meet and the leaf as it starts, or the frame that it closes in."""
BEHIND = 0.15
"""By what share of its way what is met later stands behind, where its reach has no more room."""
LEAST_WAY_RAD = math.radians(8.0)
"""What is not turned further than that meets nothing new."""


def sweeps_in(stage: Stage, e: Encounter) -> bool:
    """Whether a is turned about an upright axle to meet b."""
    driven = e.phase is not None and e.phase.edge.event is EdgeEvent.DRIVE
    if not driven or e.node.event is not NodeEvent.COLLISION or e.b in stage.places:
        return False
    leaf = leaf_of(stage.doc, stage.member(e.a))
    return leaf is not None and abs(_way(stage, e, leaf)[1]) > LEAST_WAY_RAD


def sweep_in(stage: Stage, e: Encounter) -> None:
    """Puts b in the sweep of a, clear of where it starts and of what it closes in."""
    a, b, leaf = e.a, e.b, leaf_of(stage.doc, stage.member(e.a))
    assert leaf is not None and e.phase is not None
    here, way = _way(stage, e, leaf)
    pb = stage.prop(b)
    turned = yaw_met(stage, e.node, a, b, 0.0, stage.stated_turn(e.node, b, a))
    half = half_along(pb.length, pb.width, turned)
    met = _met(stage, a)
    arm = AT_REACH[met % len(AT_REACH)] * leaf.reach
    share = _share(leaf, here, way, arm, half) + BEHIND * (met // len(AT_REACH))
    frame = stage.frames.setdefault(a, Frame() if not stage.places else stage.free_frame(a))
    stage.places[a] = (*frame.apply(0.0, 0.0), frame.angle)

    at = leaf.arm + leaf.sense * (here + share * way - leaf.here)
    heading = at + math.copysign(0.5 * math.pi, way * leaf.sense)
    ahead = leaf.thick + half
    cx = leaf.axle[0] + arm * math.cos(at) + ahead * math.cos(heading)
    cy = leaf.axle[1] + arm * math.sin(at) + ahead * math.sin(heading)
    bx, by = frame.apply(cx, cy)
    stage.places[b] = (bx, by, heading + frame.angle + turned)
    bring_support(stage, b, bx, by, heading + frame.angle)

    rate = min(max(OPENS_RAD / OPENS_S, needed_speed(stage, e) / arm), FASTEST_MPS / arm)
    track, before = stage.tracks[a], _before(stage, e)
    turns = [(p, _goal(stage, leaf, p) - _start(stage, leaf, p)) for p in before]
    for phase, turn in (*turns, (e.phase, way)):
        stage.nominal[f"{phase.edge.id}/duration"] = max(abs(turn), LEAST_WAY_RAD) / rate
    track.time = (sum(abs(turn) for _, turn in turns) + share * abs(way)) / rate
    clock = 0.0
    for phase, turn in turns:
        clock += abs(turn) / rate
        stage.time[phase.end.id] = clock
    track.x, track.y, track.heading, track.speed = cx, cy, heading, rate * arm


def needed_speed(stage: Stage, e: Encounter) -> float:
    """Least speed of a at b for what is told of that [m/s].

    What is pushed over needs none: it is pushed on.
    """
    pa, pb, met = stage.prop(e.a), stage.prop(e.b), stage.member(e.b)
    needed = max(felt_speed(pa, pb), demanded(stage, e.node, e.a, e.b))
    if stage.story.topples(met) and not topples_by_push(pa, pb):
        needed = max(needed, HARDER * topple_speed(pa, pb, flies=False))
    return max(needed, fall_speed(pa, pb)) if stage.story.falls(met) else needed


def _share(leaf: Leaf, here: float, way: float, arm: float, half: float) -> float:
    """Share of its way at which a leaf meets what reaches so far before it and behind [m].

    The first one at which that stands clear of the leaf at the start, and of the plane in which it
    is shut; else the one that comes nearest to it.
    """

    def room(share: float) -> float:
        at = here + share * way
        ahead = leaf.thick + half
        gaps: list[float] = []
        for plane in (leaf.here, here, 0.0):
            off = abs(at - plane)
            side = 1.0 if (at - plane) * way > 0.0 else -1.0
            if off > 1e-9:
                gaps.append(arm * math.sin(min(off, 0.5 * math.pi)) + side * ahead * math.cos(off))
        return min(gaps) - half - CLEAR_M

    rooms = {s: room(s) for s in SHARES}
    clear = [s for s in SHARES if rooms[s] >= 0.0]
    return clear[0] if clear else max(SHARES, key=lambda s: rooms[s])


def _met(stage: Stage, a: str) -> int:
    """How many things a has met before."""
    hits = (n for n in stage.story.nodes.values() if n.event is NodeEvent.COLLISION)
    return sum(n.id in stage.time and a in map(stage.key, n.participants) for n in hits)


def _before(stage: Stage, e: Encounter) -> list[Phase]:
    """What a has been driven along before, without a break."""
    phases = stage.story.phases[e.a]
    earlier = phases[: phases.index(e.coming)]
    return [p for p in earlier if p.edge.event is EdgeEvent.DRIVE]


def _start(stage: Stage, leaf: Leaf, phase: Phase) -> float:
    """Position of the joint as a phase begins [rad]."""
    phases = stage.story.phases[phase.edge.actor]
    here = leaf.here
    for k, p in enumerate(phases[: phases.index(phase)]):
        if p.edge.event is EdgeEvent.DRIVE:
            here = goal_of(leaf.limits, p, here, phases[k + 1])
    return here


def _goal(stage: Stage, leaf: Leaf, phase: Phase) -> float:
    """Position of the joint to which a phase drives it [rad]."""
    phases = stage.story.phases[phase.edge.actor]
    following = next(iter(phases[phases.index(phase) + 1 :]), None)
    return goal_of(leaf.limits, phase, _start(stage, leaf, phase), following)


def _way(stage: Stage, e: Encounter, leaf: Leaf) -> tuple[float, float]:
    """Where a is as it sets out for b, and how far it is driven on from there [rad]."""
    here = _start(stage, leaf, e.coming)
    return here, _goal(stage, leaf, e.coming) - here
