"""Powered flight (`Story.soars`): the height of a flight and the way down onto its target."""

from __future__ import annotations

import math

from esg.dynamics.choreography.courses.rounds import ways_of
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.stagecraft import Prop, support_of, top_surface
from esg.dynamics.story.story import Phase, bounds
from esg.graph.models import EdgeEvent, NodeEvent, Predicate, TimelineEdge, TimelineNode

LEAST_M = 1.0
"""Clearance over the ground where the target is tall enough."""
USUAL_M = 4.0
"""Height up to which it flies at what is taller."""
SINKS_TO_M = 0.5
"""Gap to the ground that is left under what comes down."""
CLEARS_M = 0.5
"""Gap to the top of what is flown over."""
UNDERSIDE = 0.6
"""Share of its height below which there is room under something."""
SHARE = 0.6
"""Share of the height of a target's broadest part at which it is met."""


def cruise(stage: Stage, actor: str) -> float:
    """Height [m] of the bottom of an actor in level flight: within all of its targets.

    A height that the prompt states for the start wins.
    """
    body = stage.prop(actor)
    stated = stated_height(stage, actor)
    if stated is not None:
        return stated
    steep = climbs_at(stage.story.phases[actor][0].edge)
    if steep:
        return 0.0 if steep > 0.0 else SINKS_TO_M + _sinks_by(stage, actor, steep)
    found: list[float] = []
    for phase in stage.story.phases[actor]:
        node = phase.end
        if node.event not in (NodeEvent.COLLISION, NodeEvent.MISS, NodeEvent.REACH):
            continue
        for name in node.participants:
            if stage.key(name) == actor or name in stage.story.phases:
                continue
            if not lands_on(stage, actor, name):
                found.append(_level_with(stage, body, name))
    height = min(found, default=max(LEAST_M, min(2.0, USUAL_M - body.height)))
    over, below = _flown_over(stage, actor), _flown_under(stage, actor)
    return max(min(height, max(below - body.height, SINKS_TO_M)), over)


def _flown_over(stage: Stage, actor: str) -> float:
    """Least height [m] at which all is cleared that the prompt has an actor fly over."""
    ways = [s.target[0] for s in ways_of(stage, actor) if s.direction == "across"]
    return max((top_of(stage, name) + CLEARS_M for name in ways), default=0.0)


def _flown_under(stage: Stage, actor: str) -> float:
    """Greatest height [m] of what flies under something."""
    tops = [
        top_of(stage, s.target[0])
        for s in stage.doc.statements or ()
        if s.predicate is Predicate.UNDER and actor in s.object and len(s.target) == 1
    ]
    return min((UNDERSIDE * top for top in tops), default=math.inf)


def fly_in(stage: Stage, node: TimelineNode, actor: str, phase: Phase, way: float) -> None:
    """Gives an actor its height, and the slope of its way down where it comes down on its target.

    Args:
        stage: What is placed so far.
        node: Where the flight leads.
        actor: Who flies.
        phase: The flight.
        way: Its length [m].
    """
    height = stage.heights.setdefault(actor, cruise(stage, actor))
    names = [n for n in node.participants if stage.key(n) != actor]
    perch = _perch(stage, actor)
    if perch is not None and phase is stage.story.phases[actor][0] and not climbs_at(phase.edge):
        stage.nominal[f"{phase.edge.id}/slope"] = (height - perch) / max(way, 0.5)
        return
    if node.event is NodeEvent.COLLISION and names and lands_on(stage, actor, names[0]):
        drop = max(height - top_of(stage, names[0]), 0.0)
        stage.nominal[f"{phase.edge.id}/slope"] = -drop / max(way, 0.5)


def _perch(stage: Stage, actor: str) -> float | None:
    """Height [m] of what an actor is said to sit on at the start, None if nobody says so."""
    name = stage.member(actor)
    host = support_of(stage.doc, name)
    said = (s for s in stage.doc.statements or () if s.predicate is Predicate.SUPPORTED_BY)
    sits = any(name in s.object and host in s.target and s.when == "start" for s in said)
    return top_surface(stage.doc, host).center_cm[2] / 100.0 if host and sits else None


def climbs_at(edge: TimelineEdge) -> float:
    """How steeply a powered flight climbs [rad], below zero where it sinks."""
    low, high, _ = bounds(edge.params.elevation_deg, (0.0, 0.0))
    return math.radians(0.5 * (low + high)) if edge.event is EdgeEvent.UNIFORM_MOTION else 0.0


def _sinks_by(stage: Stage, actor: str, steep: float) -> float:
    """How far [m] an actor comes down at the middle of its speed until its end is told."""
    phase = stage.story.phases[actor][0]
    begin, stop = phase.end.window or (1.0, 1.0)
    return abs(math.sin(steep)) * stage.speed(actor, phase) * 0.5 * (begin + stop)


def lands_on(stage: Stage, actor: str, name: str) -> bool:
    """Whether a target is so low that an actor comes down onto it instead of running into it."""
    if name in stage.story.phases:
        return False
    target, flyer = stage.prop(stage.key(name)), stage.prop(actor)
    return target.height < min(0.5, flyer.height) and support_of(stage.doc, name) is None


def top_of(stage: Stage, name: str) -> float:
    """Height [m] of a target's upper end."""
    return _base(stage, name) + stage.prop(stage.key(name)).height


def stated_height(stage: Stage, actor: str) -> float | None:
    """Height [m] of the bottom of an actor at the start, as the prompt has it, or None."""
    for node in stage.story.nodes.values():
        for c in node.constraints:
            if c.quantity == "height" and c.object == stage.member(actor):
                low, high, _ = bounds(c.value, (100.0, 100.0))
                return 0.005 * (low + high)
    return None


def _base(stage: Stage, name: str) -> float:
    support = support_of(stage.doc, name)
    return 0.0 if support is None else top_surface(stage.doc, support).center_cm[2] / 100.0


def _level_with(stage: Stage, flyer: Prop, name: str) -> float:
    """Height [m] of a flyer's bottom at which it meets a target that waits."""
    target, base = stage.prop(stage.key(name)), _base(stage, name)
    low, high = _broadest(target)
    low, high = base + low, base + high
    middle = min(low + SHARE * (high - low), max(low + flyer.height, USUAL_M))
    least = max(LEAST_M, flyer.height)
    bottom = max(middle - 0.5 * flyer.height, least)
    # It must still touch the target, however low that is.
    return max(min(bottom, high - 0.3 * min(flyer.height, high - low)), 0.05)


def _broadest(target: Prop) -> tuple[float, float]:
    """Lower and upper end [m] of the collision shape that is the easiest to meet."""
    best, ends = 0.0, (0.0, target.height)
    for p in target.config.proxies if target.config is not None else ():
        half = p.size_cm[2]
        if p.kind.value == "sphere":
            half = p.size_cm[0]
        elif p.kind.value == "capsule":
            half += p.size_cm[0]
        face = max(p.size_cm[:2]) * half
        if face > best:
            best = face
            ends = (max(0.0, p.position_cm[2] - half) / 100.0, (p.position_cm[2] + half) / 100.0)
    return ends
