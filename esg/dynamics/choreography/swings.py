"""What hangs or turns on a joint: let go, it swings down into what waits; driven, it opens."""

from __future__ import annotations

import math

from esg.dynamics.choreography.moves import plain
from esg.dynamics.choreography.placing import join
from esg.dynamics.choreography.stage import Encounter, Stage
from esg.dynamics.choreography.sweeps import FASTEST_MPS, OPENS_S, needed_speed
from esg.dynamics.story.driving import QUICKLY_S
from esg.dynamics.story.kinematics import Frame
from esg.dynamics.story.story import bounds
from esg.dynamics.story.suspension import Suspension, joint_of, suspension
from esg.graph.models import EdgeEvent, NodeEvent, TimelineNode

MEETS_AT = 0.75
"""What a drawer is to hit stands in its way at this share of it."""
PUSHES_AT = 0.55
"""The same of what it is to knock over: it is pushed on for the rest of the way."""
RISES_M, PASSED_S = 0.01, 0.12
"""By how much, and how long ago, what swings has passed its lowest point before it meets something;
the judge asks for 5 mm and `MIN_EVENT_GAP_S`."""
RISES_BY = 0.1
"""Share of the height of what it meets by which it may have risen by then."""
DROPS_S = 0.5
"""What comes down from where it hangs takes so long, about."""


def swings_in(stage: Stage, e: Encounter) -> bool:
    """Whether a hangs drawn back, and is let go to meet b."""
    return e.phase is not None and e.phase.edge.event is EdgeEvent.RELEASE


def swing_in(stage: Stage, e: Encounter) -> None:
    """Puts b just beyond the lowest point of a, or below a, whose joint gives way."""
    hangs = suspension(stage.doc, e.a)
    joint = joint_of(stage.doc, e.a)
    if hangs is None and joint is not None and joint.break_impulse is not None:
        _come_down(stage, e)
        return
    if hangs is not None:
        past = _past(stage, e, hangs)
        time = hangs.time + past / hangs.speed
        stage.tracks[e.a].straight(hangs.way + past, time, hangs.speed)
    join(stage, e.a, e.b, e.node)
    if hangs is not None:
        x, y, _ = stage.places[e.a]
        stage.places[e.a] = (x, y, stage.frames[e.a].angle - hangs.along)


def _past(stage: Stage, e: Encounter, hangs: Suspension) -> float:
    """How far beyond its lowest point a meets b, so that it is seen to pass it [m].

    Nothing where it would come too high by then: a small pendulum that meets dominoes.
    """
    node = stage.doc.spatial_relation_graph.nodes[stage.member(e.b)]
    past = max(math.sqrt(2.0 * hangs.length * RISES_M), PASSED_S * hangs.speed)
    rises = past * past / (2.0 * hangs.length)
    height = stage.doc.asset_configurations[node.asset_id].dimensions_cm[2] / 100.0
    return past if rises <= RISES_BY * height and past <= 0.5 * hangs.way else 0.0


def _come_down(stage: Stage, e: Encounter) -> None:
    """What hangs and is held no more falls straight on b."""
    frame = stage.frames.setdefault(e.a, Frame() if not stage.places else stage.free_frame(e.a))
    x, y = frame.apply(0.0, 0.0)
    stage.places[e.a] = (x, y, frame.angle)
    stage.places.setdefault(e.b, (x, y, frame.angle + math.pi))
    stage.tracks[e.a].straight(0.0, DROPS_S, 0.0)


def slides_in(stage: Stage, e: Encounter) -> bool:
    """Whether a is driven along its slide to meet b."""
    joint = joint_of(stage.doc, e.a)
    driven = e.phase is not None and e.phase.edge.event is EdgeEvent.DRIVE
    return driven and joint is not None and joint.kind == "slider"


def slide_in(stage: Stage, e: Encounter) -> None:
    """Puts b in the way of a, short of where its slide ends; sooner, and harder, if it topples."""
    joint = joint_of(stage.doc, e.a)
    assert joint is not None and e.phase is not None
    topples = stage.story.topples(stage.member(e.b))
    longest = max(abs(joint.upper or 0.0), abs(joint.lower or 0.0)) / 100.0
    way = (PUSHES_AT if topples else MEETS_AT) * longest
    usual = longest / OPENS_S
    rate = min(max(usual, needed_speed(stage, e)), FASTEST_MPS)
    track, phases = stage.tracks[e.a], stage.story.phases[e.a]
    track.time, lasts = 0.0, OPENS_S
    for phase in phases[: phases.index(e.phase) + 1]:
        low, high, stated = bounds(phase.edge.params.duration, (OPENS_S, OPENS_S))
        lasts = 0.5 * (low + high) if stated else OPENS_S * usual / rate
        stage.nominal[f"{phase.edge.id}/duration"] = lasts
        if phase is not e.phase:
            track.time += lasts
            stage.time[phase.end.id] = track.time
    track.straight(way, lasts, way / lasts)
    join(stage, e.a, e.b, e.node)


def swung(stage: Stage, node: TimelineNode) -> None:
    """Swing: it passes its lowest point after a quarter of its period, then after every half."""
    for actor, phase in stage.incoming(node):
        hangs = suspension(stage.doc, actor)
        if phase.edge.event is EdgeEvent.RELEASE and hangs is not None:
            wait = hangs.time * (2 * (node.times or 1) - 1)
            stage.tracks[actor].straight(0.0, wait, 0.0)
            stage.time[node.id] = stage.tracks[actor].time
    if node.id not in stage.time:
        plain(stage, node)


def _lets_in(stage: Stage, node: TimelineNode, actor: str) -> bool:
    """Whether something enters what a lid has opened by then."""
    joint = joint_of(stage.doc, actor)
    owner = joint.parent if joint is not None else None
    told = [*stage.story.nodes.values()]
    later = (n.region or "" for n in told[told.index(node) + 1 :])
    return node.event is NodeEvent.OPEN and any(r.partition("/")[0] == owner for r in later)


def moved_by_joint(stage: Stage, node: TimelineNode) -> None:
    """Open, Close: a motor moves it along its joint, gravity does, or what hit it."""
    for actor, phase in stage.incoming(node):
        track, hangs = stage.tracks[actor], suspension(stage.doc, actor)
        if phase.edge.event is EdgeEvent.DRIVE and joint_of(stage.doc, actor) is not None:
            usual = QUICKLY_S if _lets_in(stage, node, actor) else OPENS_S
            low, high, _ = bounds(phase.edge.params.duration, (usual, usual))
            stage.nominal[f"{phase.edge.id}/duration"] = 0.5 * (low + high)
            track.straight(0.0, 0.5 * (low + high), 0.0)
            stage.time[node.id] = track.time
        elif phase.edge.event is EdgeEvent.RELEASE and hangs is not None:
            track.straight(0.0, hangs.time, 0.0)
            stage.time[node.id] = track.time
    if node.id not in stage.time:
        plain(stage, node)
