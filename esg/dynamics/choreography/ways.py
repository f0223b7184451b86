"""Ways that the prompt states: things beside them, and the course in the viewer's directions.

What a statement says of a motion ("runs away from a tree", "past a bench", "to the left of a
chair") leaves open where the other thing stands; it is put where the statement holds.
"""

from __future__ import annotations

from collections.abc import Iterator
import math

from esg.dynamics.choreography.clearing import thrown_over
from esg.dynamics.choreography.courses.from_sides import SIDES
from esg.dynamics.choreography.courses.passages import lead_up, passage_of
from esg.dynamics.choreography.courses.rounds import middle_of, under
from esg.dynamics.choreography.hovering import top_of
from esg.dynamics.choreography.kerbs import kerb_passed
from esg.dynamics.choreography.placing import comes_to_rest
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.kinematics import Frame, half_along
from esg.dynamics.story.story import Story
from esg.graph.models import EdgeEvent, EsgDocument, Predicate, RelationType, Statement

_AHEAD_M = 1.0
"""Gap that is left to what something moves toward."""
_BEHIND_M = 1.0
"""Gap to what something moves away from."""
_BESIDE_M = 0.6
"""Gap to what something moves past or along, or gets beside."""
_BETWEEN_M = 0.5
"""Gap on either side of what passes between two things."""
_OVER_M = 0.5
"""Gap under what flies to a place over something."""
RESTING_M = 0.002
"""Gap under what rests on something at the start: less than what is measured as touching."""
_BESIDE = frozenset(
    {RelationType.LEFT_OF, RelationType.RIGHT_OF, RelationType.IN_FRONT_OF, RelationType.BEHIND}
)
_DRIVEN = (EdgeEvent.UNIFORM_MOTION, EdgeEvent.ACCELERATED_MOTION, EdgeEvent.TOWARD)
Way = tuple[tuple[float, float], tuple[float, float], float]
"""Start and end [m] and heading [rad] of a motion, in the constellation's frame."""


def state_course(stage: Stage) -> None:
    """Finds the yaw of the constellation in which the lead goes the way that the prompt states."""
    lead = stage.lead
    edge = stage.story.phases[lead][0].edge
    heading = edge.params.heading_deg
    angle = stage.frames.get(lead, Frame()).angle
    if stage.anchor is not None or stage.yaw is not None:
        return
    if isinstance(heading, int | float) and edge.event in _DRIVEN:
        stage.yaw = math.radians(heading) - angle
        return
    for s in _stated(stage):
        if s.predicate in SIDES and s.object[:1] == (lead,):
            stage.yaw = _approach(stage, s) - angle
            return
    begins = _begins(stage, lead)
    if begins is not None:
        stage.yaw = begins - angle


def _begins(stage: Stage, lead: str) -> float | None:
    """Heading [rad] from the side on which a mover is told to start of what it goes to, if any."""
    met = {n for phase in stage.story.phases[lead] for n in phase.end.participants if n != lead}
    for r in stage.doc.spatial_relation_graph.edges.binary_relations:
        side = SIDES.get(Predicate(r.relation_type.value)) if r.relation_type in _BESIDE else None
        if side is None or {r.from_, r.to} - {lead} - met or lead not in (r.from_, r.to):
            continue
        x, y = side if r.from_ == lead else (-side[0], -side[1])
        return math.atan2(-y, -x)
    return None


def _approach(stage: Stage, s: Statement) -> float:
    """Heading [rad] that leads to a side of a thing without leading through it.

    Beside it is reached along Y, in front and behind along X; from where it is said to start.
    """
    x, _ = SIDES[s.predicate]
    begins = {
        r.relation_type.value
        for r in stage.doc.spatial_relation_graph.edges.binary_relations
        if r.from_ in s.object and r.to in s.target
    }
    if x:
        return math.radians(270.0 if "in_front_of" in begins else 90.0)
    return math.radians(180.0 if "left_of" in begins else 0.0)


def place_by_the_way(stage: Stage) -> None:
    """Puts what statements name beside the ways, unless its place is known already."""
    _gates_and_pairs(stage)
    for s in _stated(stage):
        mover, other = s.object[0], s.target[0]
        if stage.key(other) in stage.places or stage.key(other) == stage.anchor:
            continue
        way = _way(stage, mover)
        spot = _spot(stage, s, way, mover, other) if way is not None else None
        if spot is not None:
            stage.places[stage.key(other)] = spot
            if s.predicate is Predicate.SUPPORTED_BY:
                stage.heights[mover] = top_of(stage, other) + RESTING_M


def _gates_and_pairs(stage: Stage) -> None:
    """Puts two things on either side of a way that leads between them."""
    for s in pairs_passed(stage.doc, stage.story):
        keys = [stage.key(other) for other in s.target[:2]]
        placed = {*keys} & {*stage.places, stage.anchor}
        if keys[0] == keys[1]:
            keys = [*s.target[:2]]  # two of a kind: each has its place
        way = _way(stage, s.object[0]) if s.object[0] in stage.tracks else None
        if way is None or placed:
            continue
        start, end, heading = way
        middle = (0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1]))
        room = stage.prop(s.object[0]).half_width + stage.gap(s.object[0], _BETWEEN_M)
        for key, side in zip(keys, (1.0, -1.0), strict=True):
            its = stage.prop(key)
            reach = room + 0.5 * min(its.length, its.width)
            turned = 0.0 if its.length >= its.width else math.pi / 2
            stage.places[key] = _beside(middle, heading + side * math.pi / 2, reach,
                                        heading + turned)  # fmt: skip


def pairs_passed(doc: EsgDocument, story: Story) -> Iterator[Statement]:
    """The statements of a way of one mover between two or more things that wait."""
    nodes = doc.spatial_relation_graph.nodes
    for s in doc.statements or ():
        waiting = all(i not in story.phases and not nodes[i].is_structural for i in s.target)
        if s.direction == "between" and len(s.object) == 1 and len(s.target) > 1 and waiting:
            yield s


def arrives(doc: EsgDocument, actor: str) -> bool:
    """Whether a side of something is where an actor's way ends."""
    return any(
        (s.predicate in SIDES or s.predicate is Predicate.ABOVE)
        and s.when == "end"
        and actor in s.object
        for s in doc.statements or ()
    )


def _ends_over(s: Statement) -> bool:
    """Whether a statement tells of a place over something at the end."""
    return s.predicate is Predicate.ABOVE and s.when == "end" and bool(s.object)


def ways_stated(doc: EsgDocument, story: Story) -> Iterator[Statement]:
    """The statements of ways that have one mover and one other thing, which waits."""
    nodes = doc.spatial_relation_graph.nodes
    for s in doc.statements or ():
        ways = s.predicate is Predicate.MOVES or (s.predicate in SIDES and s.when == "end")
        ways |= s.predicate is Predicate.UNDER and s.when == "end"
        ways |= _ends_over(s) and s.object[0] in story.phases and story.soars(s.object[0])
        perched = s.predicate is Predicate.SUPPORTED_BY and s.when == "start"
        ways |= perched and s.object[0] in story.phases and story.soars(s.object[0])
        if not ways or len(s.object) != 1 or len(s.target) != 1:
            continue
        free = not nodes[s.target[0]].is_structural and s.target[0] not in story.phases
        if s.object[0] in story.phases and free:
            yield s


def crossing_together(doc: EsgDocument) -> list[set[str]]:
    """Those of one plural who cross the same street: they go the same way."""
    nodes, out = doc.spatial_relation_graph.nodes, dict[tuple[str, str], set[str]]()
    for s in doc.statements or ():
        if s.predicate is not Predicate.MOVES or s.direction != "across":
            continue
        for road in (i for i in s.target if nodes[i].is_structural):
            for who in s.object:
                out.setdefault((road, nodes[who].group or who), set()).add(who)
    return list(out.values())


def _stated(stage: Stage) -> Iterator[Statement]:
    """Those of a mover of this stage."""
    return (s for s in ways_stated(stage.doc, stage.story) if s.object[0] in stage.tracks)


def _way(stage: Stage, mover: str) -> Way | None:
    frame, points = stage.frames.get(mover), stage.tracks[mover].points
    if frame is None or len(points) < 2:
        return None
    start, end = frame.apply(*points[0]), frame.apply(*points[-1])
    return start, end, math.atan2(end[1] - start[1], end[0] - start[0])


def _spot(
    stage: Stage, s: Statement, way: Way, mover: str, other: str
) -> tuple[float, float, float | None] | None:
    """Where the other thing stands: x, y [m], yaw [rad] (None: any)."""
    start, end, heading = way
    middle = (0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1]))
    mine, its = stage.prop(mover), stage.prop(other)
    if s.predicate is Predicate.SUPPORTED_BY:
        return (*start, heading + math.pi / 2)  # it leaves across what it sat on
    if _ends_over(s):
        stage.heights[mover] = top_of(stage, other) + _OVER_M
        return (*_rest(stage, mover, way), None)
    if s.predicate in SIDES:
        yaw = stage.yaw or 0.0
        x, y = SIDES[s.predicate]
        side = math.atan2(y, x) - yaw
        reach = half_along(its.length, its.width, -yaw - side) + stage.gap(mover, _BESIDE_M)
        reach += half_along(mine.length, mine.width, heading - side)
        return _beside(_rest(stage, mover, way), side + math.pi, reach, -yaw)
    if s.predicate is Predicate.UNDER:
        return under(stage, _rest(stage, mover, way), heading, other)
    if s.direction == "through" and passage_of(stage.doc, other) is not None:
        return (*middle, heading)
    if s.direction == "around":
        bend = middle_of(stage.tracks[mover].points)
        return None if bend is None else (*stage.frames[mover].apply(*bend), None)
    if s.direction == "up":
        return lead_up(stage, mover, other)
    if s.direction == "toward":
        reach = (
            mine.half_length + half_along(its.length, its.width, 0.0) + stage.gap(mover, _AHEAD_M)
        )
        return _beside(end, heading, reach, None)
    if s.direction == "away_from":
        reach = (
            mine.half_length + half_along(its.length, its.width, 0.0) + stage.gap(mover, _BEHIND_M)
        )
        return _beside(start, heading + math.pi, reach, None)
    if s.direction == "across" and (over := thrown_over(stage, mover, other)) is not None:
        return over
    if s.direction == "across" and stage.story.flies(mover):
        return (*middle, None)
    if s.direction in ("past", "along"):
        lengthwise = 0.0 if its.length >= its.width else math.pi / 2
        reach = mine.half_width + 0.5 * min(its.length, its.width) + stage.gap(mover, _BESIDE_M)
        kerb = kerb_passed(stage, mover, other)
        if kerb is not None:
            reach = mine.half_width + its.half_lateral(kerb.turned) + kerb.gap_m(mine)
            return _beside(middle, heading + kerb.side * math.pi / 2, reach, heading + kerb.turned)
        return _beside(middle, heading + math.pi / 2, reach, heading + lengthwise)
    return None


def _rest(stage: Stage, mover: str, way: Way) -> tuple[float, float]:
    """Where a mover has come to rest behind the end of its way [m]."""
    _, (x, y), heading = way
    brakes = comes_to_rest(stage, mover)[0]
    return x + brakes * math.cos(heading), y + brakes * math.sin(heading)


def _beside(
    point: tuple[float, float], heading: float, reach: float, yaw: float | None
) -> tuple[float, float, float | None]:
    x, y = point[0] + reach * math.cos(heading), point[1] + reach * math.sin(heading)
    return (x, y, yaw)
