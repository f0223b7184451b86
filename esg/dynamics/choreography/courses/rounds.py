"""Ways around, over and under things: how long they must be, and where the thing stands."""

from __future__ import annotations

from collections.abc import Iterator
import math

from esg.dynamics.choreography.courses.passages import passage_of
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.kinematics import wrap_angle
from esg.graph.models import Predicate, Statement

BENDS_RAD = 0.02
"""A path bends where its heading changes by more."""
_STEEP = ("up", "down")
ROOM_M = 0.4
"""Way that is left before and behind what is gone through or over."""


def ways_of(stage: Stage, actor: str) -> Iterator[Statement]:
    """The stated ways of an actor that have one other thing, which waits."""
    nodes = stage.doc.spatial_relation_graph.nodes
    for s in stage.doc.statements or ():
        if s.predicate is not Predicate.MOVES or len(s.target) != 1 or actor not in s.object:
            continue
        if not nodes[s.target[0]].is_structural and s.target[0] not in stage.story.phases:
            yield s


def goes_somewhere(stage: Stage, actor: str) -> bool:
    """Whether the prompt states a way of an actor over the ground."""
    stated = (s for s in stage.doc.statements or () if actor in s.object)
    return any(s.predicate is Predicate.MOVES and s.direction not in _STEEP for s in stated)


def way_needed(stage: Stage, actor: str) -> float:
    """Least way [m] on which an actor gets wholly through or over what the prompt has it pass."""
    mine, most = stage.prop(actor), 0.0
    for s in ways_of(stage, actor):
        its = stage.prop(stage.key(s.target[0]))
        passes = s.direction == "through" and passage_of(stage.doc, s.target[0]) is not None
        if passes or (s.direction == "across" and stage.story.soars(actor)):
            most = max(most, its.length + mine.length + 2.0 * ROOM_M)
    return most


def under(
    stage: Stage, end: tuple[float, float], heading: float, other: str
) -> tuple[float, float, float | None]:
    """Where something stands under which a way ends: x, y [m], yaw [rad].

    Its legs leave the most room between them on its longer side; a chair is open to its front.
    """
    its = stage.prop(stage.key(other))
    turned = math.pi if its.length <= its.width else math.pi / 2
    return (*end, heading + turned)


def middle_of(points: list[tuple[float, float]]) -> tuple[float, float] | None:
    """Centre of the bend of a path [m]; None for a straight one.

    Args:
        points: Corners of the path [m], in order.
    """
    bends = [
        q
        for p, q, r in zip(points, points[1:], points[2:], strict=False)
        if abs(_turn(p, q, r)) > BENDS_RAD
    ]
    if len(bends) < 3:
        return None
    (ax, ay), (bx, by), (cx, cy) = bends[0], bends[len(bends) // 2], bends[-1]
    twice = 2.0 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by))
    if abs(twice) < 1e-9:
        return None
    a, b, c = ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy
    return (
        (a * (by - cy) + b * (cy - ay) + c * (ay - by)) / twice,
        (a * (cx - bx) + b * (ax - cx) + c * (bx - ax)) / twice,
    )


def _turn(p: tuple[float, float], q: tuple[float, float], r: tuple[float, float]) -> float:
    """Change of heading [rad] at the second of three corners; 0 where two of them coincide."""
    if math.dist(p, q) < 1e-6 or math.dist(q, r) < 1e-6:
        return 0.0
    return wrap_angle(math.atan2(r[1] - q[1], r[0] - q[0]) - math.atan2(q[1] - p[1], q[0] - p[0]))


def widest_turn(stage: Stage, actor: str) -> float:
    """Radius [m] of a bend that leads clear of all that the prompt has an actor go around."""
    mine, most = stage.prop(actor), 0.0
    for s in ways_of(stage, actor):
        if s.direction == "around":
            its = stage.prop(stage.key(s.target[0]))
            reach = 0.5 * math.hypot(its.length, its.width)
            most = max(most, reach + mine.half_width + stage.gap(actor, ROOM_M))
    return most
