"""Sets back on their supports what a planned start has put beside them, or into them.

Motion is planned in the open: what is met second on a table may be planned metres behind its edge.
It stands on the table in every case, so it starts at the nearest free place there.
"""

from __future__ import annotations

import math

from esg.layout.judge.check import plan_separation, prim_penetration
from esg.layout.judge.resting import beyond_edge
from esg.layout.problem.poses import Pose2, compose, inverse
from esg.layout.problem.supports import Shape, Support, SupportMap
from esg.layout.problem.units import Unit

SPACING_CM = 0.5
MAX_DEPTH_CM = 1.0
"""What stands deeper in what carries it is moved."""
STEPS = 12
"""Places tried along each side of a surface."""
ASIDE_CM, ASIDE_STEPS = 1.0, 6
"""Of what is stacked, the steps off the middle that are tried, and how many of them each way."""


def set_on_supports(
    unit: Unit, supports: SupportMap, shape: dict[str, Shape], falling: frozenset[str]
) -> list[str]:
    """Moves members of a planned unit onto the members that carry them, where they miss them.

    Args:
        unit: Its members are changed in place.
        supports: What carries every node.
        shape: Geometry of every node.
        falling: Nodes that may start over an edge, by their half width at most.

    Returns:
        The members that were moved.
    """
    moved: list[str] = []
    for name in unit.members:
        s = supports.of[name]
        if s.parent not in unit.members or s.rect is None or name in unit.z_cm:
            continue
        if s.kind not in ("on", "inside") or shape[name].is_decal:
            continue
        assert s.parent is not None
        base = unit.members[s.parent]
        here = compose(inverse(base), unit.members[name])
        mine = shape[name]
        over = min(mine.hx, mine.hy) if name in falling else 0.0
        below = shape[s.parent]
        beyond = beyond_edge(s, below, mine, here)
        if beyond <= over and (beyond > 0 or _depth(s, below, mine, here) < MAX_DEPTH_CM):
            continue
        there = [
            (compose(inverse(base), unit.members[n]), shape[n])
            for n in unit.members
            if n != name and supports.of[n].parent == s.parent and not shape[n].is_decal
        ]
        place = _nearest(s, here, below, mine, there)
        if place is not None:
            unit.members[name] = compose(base, place)
            moved.append(name)
    return moved


def _half(shape: Shape, yaw: float) -> tuple[float, float]:
    """Half extents along the axes of a surface on which an object is turned by `yaw` [rad]."""
    if shape.is_round:
        return shape.hx, shape.hy
    c, s = abs(math.cos(yaw)), abs(math.sin(yaw))
    return shape.hx * c + shape.hy * s, shape.hx * s + shape.hy * c


def _depth(support: Support, parent: Shape, child: Shape, at: Pose2) -> float:
    """How deep an object would stand in what carries it [cm]: in a backrest, under a low roof."""
    return max(
        (
            prim_penetration(p, at, support.z_cm, q, (0.0, 0.0, 0.0), 0.0)
            for p in child.prims
            for q in parent.prims
        ),
        default=0.0,
    )


def step_aside(support: Support, below: Shape, above: Shape) -> Pose2:
    """Where, seen from the one below, something stands that is stacked on it.

    In its middle, or the shortest way off it where it clears what stands up there: of stacked
    chairs the upper one's legs stand before the lower one's backrest.
    """
    steps = [s * k * ASIDE_CM for k in range(ASIDE_STEPS + 1) for s in (1.0, -1.0)]
    places = [(x, 0.0, 0.0) for x in steps] + [(0.0, y, 0.0) for y in steps]
    free = (p for p in places if _depth(support, below, above, p) < MAX_DEPTH_CM)
    return min(free, key=lambda p: abs(p[0]) + abs(p[1]), default=(0.0, 0.0, 0.0))


def _nearest(
    support: Support, at: Pose2, parent: Shape, shape: Shape, there: list[tuple[Pose2, Shape]]
) -> Pose2 | None:
    """The place on a surface nearest to `at` that nothing takes, else the nearest on it.

    None where it is on the surface already and no place is free.
    """
    assert support.rect is not None
    x0, y0, x1, y1 = support.rect
    hx, hy = _half(shape, at[2])
    # What is larger than the surface stands with its middle on the surface's middle.
    low_x, high_x = (x0 + hx, x1 - hx) if x1 - x0 >= 2 * hx else (0.5 * (x0 + x1),) * 2
    low_y, high_y = (y0 + hy, y1 - hy) if y1 - y0 >= 2 * hy else (0.5 * (y0 + y1),) * 2
    clamped = (min(max(at[0], low_x), high_x), min(max(at[1], low_y), high_y))
    grid = {
        (low_x + (high_x - low_x) * i / STEPS, low_y + (high_y - low_y) * j / STEPS)
        for i in range(STEPS + 1)
        for j in range(STEPS + 1)
    }
    for x, y in (clamped, *sorted(grid, key=lambda p: (math.dist(p, at[:2]), p))):
        pose = (x, y, at[2])
        free = all(_gap(pose, shape, other, its) >= SPACING_CM for other, its in there)
        if free and _depth(support, parent, shape, pose) < MAX_DEPTH_CM:
            return pose
    return (*clamped, at[2]) if beyond_edge(support, parent, shape, at) > 0 else None


def _gap(a: Pose2, mine: Shape, b: Pose2, theirs: Shape) -> float:
    return plan_separation(
        0 if mine.is_round else 1, a, (mine.hx, mine.hy),
        0 if theirs.is_round else 1, b, (theirs.hx, theirs.hy),
    )  # fmt: skip
