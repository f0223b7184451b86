"""Several things that are let go over one place: where each starts, so that no two coincide."""

from __future__ import annotations

from collections.abc import Iterator
import math

from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.stagecraft import top_surface
from esg.graph.models import NamedRegion, Predicate, TimelineNode

SPARE, LEAST_GAP_M = 0.1, 0.01
"""Gap between two that fall side by side, over the larger one's size, and at least."""
OVERHANG = 0.4
"""Least distance of the middle of what falls onto a top from its edge, over its side."""
POURED_M = 0.3
"""Height over a vessel from which several things fall into it: from higher they jump out again."""
FLOOR_M = 2.0
"""Half of the floor that several things that bounce on it share, along both ways."""
IN_TURN_S = 0.18
"""From one's landing to the next one's, of what lands in turn."""


def share_out(
    stage: Stage, a: str, b: str, room: tuple[float, float], *, round_: bool
) -> tuple[float, float, float]:
    """Where one of several starts from where it would fall alone: the first one does there.

    Args:
        stage: The stage; takes note that `a` is let go over `b`.
        a, b: What falls, and over what.
        room: Half of what it may fall on along x and y of `b` [m].
        round_: Whether that is an ellipse.

    Returns:
        Shift along x and y of `b`, and upwards [m].
    """
    others = stage.let_go.setdefault(b, [])
    before = len(others)
    others.append(a)
    if not before:
        return (0.0, 0.0, 0.0)
    bodies = [stage.prop(k) for k in others]
    size = (max(p.length for p in bodies), max(p.width for p in bodies))
    spots = sorted(_grid(room, size, round_=round_), key=lambda p: (math.hypot(*p), p))
    layer, spot = divmod(before, len(spots))
    high = max(p.height for p in bodies)
    return (*spots[spot], layer * ((1.0 + SPARE) * high + LEAST_GAP_M))


def _grid(
    room: tuple[float, float], size: tuple[float, float], *, round_: bool
) -> Iterator[tuple[float, float]]:
    """Places of a grid about the middle with room for a body; the middle at least."""
    free = [max(half - OVERHANG * side, 0.0) for half, side in zip(room, size, strict=True)]
    if round_:
        free = [max(half - 0.5 * side, 0.0) for half, side in zip(room, size, strict=True)]
    pitch = [(1.0 + SPARE) * side + LEAST_GAP_M for side in size]
    m, n = (int(f / p) for f, p in zip(free, pitch, strict=True))
    for i in range(-m, m + 1):
        for j in range(-n, n + 1):
            x, y = i * pitch[0], j * pitch[1]
            if (
                round_
                and (i or j)
                and math.hypot(x / max(free[0], 1e-9), y / max(free[1], 1e-9)) > 1.0
            ):
                continue
            yield x, y


def room_of(stage: Stage, b: str, region: NamedRegion | None) -> tuple[float, float]:
    """Half of the opening of a region, or of the top of a thing, along its x and y [m]."""
    if region is not None:
        return (region.half_extents_cm[0] / 100.0, region.half_extents_cm[1] / 100.0)
    body = stage.prop(b)
    if body.config is None or not body.config.support_surfaces:
        return (body.half_length, body.half_width)
    x, y = top_surface(stage.doc, stage.member(b)).half_extents_cm
    return (x / 100.0, y / 100.0)


def several(stage: Stage, node: TimelineNode) -> bool:
    """Whether others are let go into the same region, too."""
    nodes = stage.story.nodes.values()
    return node.region is not None and sum(n.region == node.region for n in nodes) > 1


def due(stage: Stage, node: TimelineNode) -> float | None:
    """When one of several that land in turn does [s]: after the one before; None without one."""
    for s in stage.doc.statements or ():
        if s.predicate is Predicate.BEFORE and s.object[1:] == (node.id,):
            first = stage.time.get(s.object[0])
            if first is not None:
                return first + IN_TURN_S
    return None
