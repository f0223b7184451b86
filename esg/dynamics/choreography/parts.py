"""Moving what takes place on a table to where something of it is said to stand."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.kinematics import Frame, half_along
from esg.dynamics.story.stagecraft import broadest_surface
from esg.graph.models import Predicate, RelationType
from esg.lexicon.parts import CORNER, EDGE, sides_of

MARGIN_M = 0.02
"""From what is put at an edge to that edge."""

Floats = NDArray[np.float64]
Point = tuple[str, float, float, float]
Place = tuple[float, float, float | None]


def to_its_part(stage: Stage, reached: Sequence[Point]) -> None:
    """Shifts all places on the anchor together, if all of them stay on it.

    Args:
        stage: The stage, its places in the frame of its anchor.
        reached: Where those get that stay on it: key, x, y [m], heading [rad].
    """
    assert stage.anchor is not None
    surface = broadest_surface(stage.doc, stage.anchor)
    center, half = (
        np.array(surface.center_cm[:2]) / 100.0,
        np.array(surface.half_extents_cm) / 100.0,
    )
    for key, part in _told(stage):
        x, y, yaw = stage.places[key]
        at = np.array([x, y]) - center
        free = half - _reach(stage, key, yaw or 0.0) - MARGIN_M
        low, high = _bounds(stage, reached)
        for goal in _goals(part, at, free, half):
            shift = goal - at
            fits = np.all(low + shift >= center - half) and np.all(high + shift <= center + half)
            if fits and np.all(free > 0.0):
                dx, dy = (float(v) for v in shift)
                stage.places = {k: (px + dx, py + dy, a) for k, (px, py, a) in stage.places.items()}
                return


def _told(stage: Stage) -> Iterator[tuple[str, str]]:
    """What of the stage is said to stand at which part of the anchor; "" for its middle."""
    for s in stage.doc.statements or ():
        if s.predicate is Predicate.AT_PART and s.target[:1] == (stage.anchor,):
            keys = (k for k in map(stage.key, s.object) if k in stage.places)
            yield from ((k, s.noun or "") for k in keys)
    for e in stage.doc.spatial_relation_graph.edges.binary_relations:
        key = stage.key(e.from_)
        middle = e.relation_type is RelationType.CENTER_OF and e.to == stage.anchor
        if middle and key in stage.places:
            yield key, ""


def carried_along(
    reached: Sequence[Point], before: Mapping[str, Place], after: Mapping[str, Place]
) -> list[Point]:
    """Points of ways, where the things whose ways they are have been moved and turned.

    Args:
        reached: Key, x, y [m], heading [rad].
        before, after: Position [m] and yaw [rad] by key.
    """
    out: list[Point] = []
    for key, x, y, heading in reached:
        (bx, by, b), (ax, ay, a) = before[key], after[key]
        turn = Frame(ax, ay, (a or 0.0) - (b or 0.0))
        out.append((key, *turn.apply(x - bx, y - by), heading + turn.angle))
    return out


def _goals(part: str, at: Floats, free: Floats, half: Floats) -> Iterator[Floats]:
    """Where it may stand to be at a part, from the middle [m]; the nearest first."""
    if not part:
        return iter([np.zeros(2)])
    if sides_of(part):
        return iter(())  # which way the table will be turned is not known here
    long = int(np.argmax(half))
    axes = (0, 1) if part == CORNER else (1 - long,) if part == EDGE else (long,)
    found: list[Floats] = []
    for signs in product((1.0, -1.0), repeat=len(axes)):
        goal = at.copy()
        goal[list(axes)] = np.array(signs) * free[list(axes)]
        found.append(goal)
    return iter(sorted(found, key=lambda g: float(np.linalg.norm(g - at))))


def _reach(stage: Stage, key: str, yaw: float) -> Floats:
    body = stage.prop(key)
    return np.array([half_along(body.length, body.width, yaw), body.half_lateral(yaw)])


def _bounds(stage: Stage, reached: Sequence[Point]) -> tuple[Floats, Floats]:
    """Lowest and highest corner of all that is and gets somewhere [m]."""
    places = [*((k, x, y, yaw or 0.0) for k, (x, y, yaw) in stage.places.items()), *reached]
    middles = np.array([(x, y) for _, x, y, _ in places])
    reaches = np.array([_reach(stage, k, yaw) for k, _, _, yaw in places])
    return (middles - reaches).min(axis=0), (middles + reaches).max(axis=0)
