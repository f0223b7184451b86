"""From one side of a thing to another: "is on the left of an apple, then jumps behind it"."""

from __future__ import annotations

from collections.abc import Iterator
import math

from esg.dynamics.choreography.courses.passages import lengthen
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.story import Phase
from esg.graph.models import NodeEvent, Predicate, Statement
from esg.units import GRAVITY_MPS2

Vector = tuple[float, float]
SIDES: dict[Predicate, Vector] = {
    Predicate.LEFT_OF: (1.0, 0.0),
    Predicate.RIGHT_OF: (-1.0, 0.0),
    Predicate.IN_FRONT_OF: (0.0, 1.0),
    Predicate.BEHIND: (0.0, -1.0),
}
"""The side of the other thing on which something is: left is +X, front +Y."""
GAP_M = 0.3
"""Gap that a way past a thing leaves to it."""
ASLANT = 1.4
"""How much farther on a side than across it both ends of a way past a thing are."""


def go_from_side_to_side(stage: Stage) -> None:
    """Puts what the lead starts and ends beside where a straight way has it on both sides."""
    for s, start, phase in _told(stage):
        other = stage.key(s.target[0])
        if other in stage.places or other == stage.anchor or stage.yaw is not None:
            continue
        begin, end = _ends(_room(stage, s.object[0], other), start, SIDES[s.predicate])
        way = math.dist(begin, end)
        if not _goes(stage, s.object[0], phase, way):
            continue
        track, frame = stage.tracks[s.object[0]], stage.frames[s.object[0]]
        # Where its time is prescribed it goes as far as it goes.
        longer = max(math.dist(track.points[-2], track.points[-1]) / way, 1.0)
        heading = math.atan2(end[1] - begin[1], end[0] - begin[0])
        stage.yaw = heading - (frame.angle + track.heading)
        c, d = math.cos(-stage.yaw), math.sin(-stage.yaw)
        x, y = -longer * begin[0], -longer * begin[1]
        x0, y0 = frame.apply(*track.points[-2])
        stage.places[other] = (x0 + c * x - d * y, y0 + d * x + c * y, -stage.yaw)


def _told(stage: Stage) -> Iterator[tuple[Statement, Vector, Phase]]:
    """Statements of a side where the lead ends its only motion, with the side that it starts on."""
    statements = stage.doc.statements or ()
    phases = stage.story.phases[stage.lead]
    nodes = stage.doc.spatial_relation_graph.nodes
    for s in statements:
        if s.predicate not in SIDES or s.when != "end" or s.object[:1] != (stage.lead,):
            continue
        if len(s.target) != 1 or s.target[0] in stage.story.phases or len(phases) != 1:
            continue
        begins = [
            SIDES[x.predicate]
            for x in statements
            if x.predicate in SIDES and x.when == "start"
            and x.object[:1] == s.object[:1] and x.target == s.target
        ]  # fmt: skip
        waits = not nodes[s.target[0]].is_structural and stage.anchor is None
        if begins and waits and begins[0] != SIDES[s.predicate]:
            yield s, begins[0], phases[0]


def _room(stage: Stage, mover: str, other: str) -> float:
    """Least distance [m] between the middles of a straight way past a thing and of the thing."""
    body, its = stage.prop(mover), stage.prop(other)
    return body.half_width + math.hypot(its.half_length, its.half_width) + GAP_M


def _ends(room: float, start: Vector, end: Vector) -> tuple[Vector, Vector]:
    """Both ends of a straight way [m] from one side of a thing to another, seen from the thing."""
    if start[0] == -end[0] and start[1] == -end[1]:
        # Past it, not through it: on the viewer's side, or on the left.
        across = (room * abs(start[1]), room * abs(start[0]))
        far = ASLANT * room
        return (
            (far * start[0] + across[0], far * start[1] + across[1]),
            (far * end[0] + across[0], far * end[1] + across[1]),
        )
    far = math.sqrt(2.0) * room
    return (far * start[0], far * start[1]), (far * end[0], far * end[1])


def _goes(stage: Stage, mover: str, phase: Phase, way: float) -> bool:
    """Makes a mover's only motion so long [m]; whether it can be."""
    track = stage.tracks[mover]
    if mover not in stage.frames or stage.story.falls(mover) or len(track.points) < 2:
        return False
    if phase.end.event is NodeEvent.JUMP:
        count, rise = phase.end.times or 1, stage.nominal.get(f"{phase.edge.id}/rise")
        if rise is None or phase.edge.speed_is_prescribed or len(phase.end.participants) > 1:
            return False
        speed = way / (2.0 * rise / GRAVITY_MPS2 * count)
        stage.nominal[f"{phase.edge.id}/speed"] = speed
        track.points[-1] = (way, 0.0)
        track.x, track.y = way, 0.0
        return True
    if phase.end.event not in (NodeEvent.TRIGGER, NodeEvent.STOP):
        return False
    lengthen(stage, mover, way)
    return math.dist(track.points[-2], track.points[-1]) >= 0.99 * way
