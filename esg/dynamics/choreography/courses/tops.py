"""What moves about on a table and stays there: how far it gets after all that is told of it."""

from __future__ import annotations

import math

from esg.dynamics.choreography.placing import comes_to_rest
from esg.dynamics.choreography.stage import Encounter, Stage
from esg.dynamics.story.kinematics import half_along
from esg.dynamics.story.stagecraft import ON_TABLE, TABLE_S, broadest_surface, coasting_drag
from esg.dynamics.story.story import Phase
from esg.graph.models import EdgeEvent, NodeEvent

BEYOND_M = 0.04
"""Gap behind what has been passed, measured along the way."""
ALONG = 0.75
"""Share of a table's length along which something goes about on it that goes nowhere."""
FASTER = 1.06
"""Most that the search may have it go faster than was planned for."""
STILL_M = 1e-4
"""A way of less has no heading."""
Point = tuple[float, float, float]


def length_of_top(stage: Stage, actor: str) -> float:
    """How far [m] something may go along the table that it stays on, its own length left out."""
    if not stage.keeps_to_its_top(actor) or stage.anchor is None:
        return 0.0
    half = max(broadest_surface(stage.doc, stage.anchor).half_extents_cm) / 100.0
    return max(ALONG * 2.0 * half - stage.prop(actor).length, 0.0)


def hold_to(stage: Stage, actor: str, phase: Phase, speed: float) -> None:
    """Keeps the search to a speed [m/s] with whose way something stays on its table."""
    if stage.keeps_to_its_top(actor) and not stage.story.flies(actor):
        stage.nominal[f"{phase.edge.id}/at_most"] = FASTER * speed


def go_past(stage: Stage, e: Encounter) -> None:
    """Leads a way past a thing on, until that is behind, where it ends with that."""
    phase = e.phase
    passes = e.node.event is NodeEvent.MISS and phase is not None and e.b in stage.places
    if not passes or phase is None or not stage.keeps_to_its_top(e.a):
        return
    name, track = phase.edge.id, stage.tracks[e.a]
    hold_to(stage, e.a, phase, stage.nominal.get(f"{name}/speed", track.speed))
    if phase is not stage.story.phases[e.a][-1] or track.speed <= 0.0:
        return
    body, its, frame = stage.prop(e.a), stage.prop(e.b), stage.frames[e.a]
    turned = (stage.places[e.b][2] or 0.0) - track.heading - frame.angle
    more = body.half_length + half_along(its.length, its.width, turned) + BEYOND_M
    if phase.edge.event is EdgeEvent.TOWARD and not body.rolls:
        return  # friction alone ends it
    track.straight(more, more / track.speed, track.speed)
    stage.nominal[f"{name}/beyond"] = more


def reaches(stage: Stage, actor: str) -> list[Point]:
    """Where something gets that stays on its table: all corners of its way, and where it rests.

    Who walks about and stops by himself rests so, too, whatever is said of his table.

    Returns:
        x, y [m] and heading [rad].
    """
    track, last = stage.tracks[actor], stage.story.phases[actor][-1]
    frame = stage.frames.get(actor)
    stays = stage.keeps_to_its_top(actor)
    walks = stage.held(actor) and last.edge.event is EdgeEvent.UNIFORM_MOTION
    walks = walks and last.end.event is NodeEvent.TRIGGER
    if frame is None or not (stays or walks):
        return []
    way = _runs_out(stage, actor)
    end = (track.x + way * math.cos(track.heading), track.y + way * math.sin(track.heading))
    way = [frame.apply(*p) for p in ([*track.points, end] if stays else [end])]
    last = track.heading + frame.angle
    around = [way[0], *way, way[-1]]
    yaws = [math.atan2(q[1] - p[1], q[0] - p[0]) if math.dist(p, q) > STILL_M else last
            for p, q in zip(around[:-2], around[2:], strict=True)]  # fmt: skip
    return [(*p, yaw) for p, yaw in zip(way, yaws, strict=True)]


def _runs_out(stage: Stage, actor: str) -> float:
    """How far [m] something gets behind the end of its way."""
    last, track, body = stage.story.phases[actor][-1], stage.tracks[actor], stage.prop(actor)
    if last.edge.event is not EdgeEvent.TOWARD:
        return comes_to_rest(stage, actor)[0]
    if body.rolls:
        return FASTER * track.speed * (TABLE_S + 1.0 / ON_TABLE)
    return track.speed**2 / (2.0 * max(coasting_drag(body), 0.1))
