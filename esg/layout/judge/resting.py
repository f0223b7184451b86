"""Whether everything is carried: its centre of mass over its support, something solid below it."""

from __future__ import annotations

import math

from esg.layout.judge.check import World, plan_separation
from esg.layout.problem.poses import Pose2, compose, inverse
from esg.layout.problem.record import LayoutProblem
from esg.layout.problem.shapes import CIRCLE
from esg.layout.problem.supports import Shape, Support
from esg.thresholds import HANGS_M, MEETS_M

STANDING = ("on", "inside")
"""Kinds of supports that carry from below."""
DROP_CM = 100.0 * HANGS_M
"""What may sink so far without touching anything hangs in the air."""
MEETS_CM = 100.0 * MEETS_M


def centre_offset(problem: LayoutProblem, name: str) -> tuple[float, float]:
    """Centre of mass in the plan of the object's own frame [cm]; what is inside has 0."""
    return _centre(problem.supports.of[name], problem.shape[name])


def carried(problem: LayoutProblem) -> list[str]:
    """Nodes that stand on or in another one, unless their planned start is in the air."""
    airborne = {n for u in problem.units for n in u.z_cm}
    return [
        n
        for n in problem.names
        if (s := problem.supports.of[n]).parent is not None
        and s.kind in STANDING
        and s.rect is not None
        and not s.afloat
        and n not in airborne
        and not problem.shape[n].is_decal
    ]


def beyond_edge(support: Support, parent: Shape, child: Shape, at: Pose2) -> float:
    """How far a centre of mass lies beyond the edge of what carries it [cm], 0 within.

    The edge is that of the declared surface or of the solid under it, whichever is wider.

    Args:
        support: What carries the object; its rectangle must be known.
        parent: Geometry of what carries it.
        child: Geometry of the object.
        at: Its pose in the frame of what carries it.
    """
    assert support.rect is not None
    cx, cy = _centre(support, child)
    x, y, _ = compose(at, (cx, cy, 0.0))
    x0, y0, x1, y1 = support.rect
    out = max(x0 - x, x - x1, y0 - y, y - y1, 0.0)
    bottom = support.z_cm + child.bottom
    for p in parent.prims:
        if out > 0 and not p.is_sphere and bottom - DROP_CM <= p.z1 <= bottom + MEETS_CM:
            gap = plan_separation(
                p.kind, (p.x, p.y, p.yaw), (p.hx, p.hy), CIRCLE, (x, y, 0.0), (0.0, 0.0)
            )
            out = min(out, max(gap, 0.0))
    return out


def _centre(support: Support, child: Shape) -> tuple[float, float]:
    if support.kind != "on":
        return 0.0, 0.0
    x, y, _ = child.config.center_of_mass_cm
    return x, y


def unsupported(problem: LayoutProblem, world: World) -> list[tuple[float, str, str]]:
    """Objects that nothing carries: (distance beyond the edge [cm], object, support).

    The distance is infinite where the support's outline is met but nothing solid is below.
    """
    out: list[tuple[float, str, str]] = []
    for name in carried(problem):
        parent = problem.supports.of[name].parent
        assert parent is not None
        at = compose(inverse(world.pose[parent]), world.pose[name])
        shapes = problem.shape[parent], problem.shape[name]
        off = beyond_edge(problem.supports.of[name], *shapes, at)
        if off > MEETS_CM and name not in problem.falling:
            out.append((off, name, parent))
        elif hangs(problem, world, name):
            out.append((math.inf, name, parent))
    return sorted(out, key=lambda t: (-t[0], t[1]))


def is_solid(problem: LayoutProblem, name: str) -> bool:
    """Whether one shape of what carries an object lies under the whole surface it stands on."""
    s = problem.supports.of[name]
    if s.parent is None or s.rect is None:
        return False
    x0, y0, x1, y1 = s.rect
    bottom = s.z_cm + problem.shape[name].bottom
    for p in problem.shape[s.parent].prims:
        if not bottom - DROP_CM <= p.z1 <= bottom + 1e-6 or p.is_sphere or p.yaw != 0.0:
            continue
        if p.kind == CIRCLE:
            if all(math.hypot(x - p.x, y - p.y) <= p.hx for x in (x0, x1) for y in (y0, y1)):
                return True
        elif (
            p.x - p.hx - MEETS_CM <= x0
            and x1 <= p.x + p.hx + MEETS_CM
            and p.y - p.hy - MEETS_CM <= y0
            and y1 <= p.y + p.hy + MEETS_CM
        ):
            return True
    return False


def hangs(problem: LayoutProblem, world: World, name: str) -> bool:
    """Whether an object could sink by `DROP_CM` without meeting anything."""
    mine = problem.shape[name]
    if not mine.prims or world.z[name] + mine.bottom < DROP_CM:
        return False
    x, y, _ = world.pose[name]
    for other in problem.names:
        theirs = problem.shape[other]
        if other == name or not theirs.prims:
            continue
        u, v, _ = world.pose[other]
        if math.hypot(x - u, y - v) > _reach(mine) + _reach(theirs):
            continue
        for p in mine.prims:
            bottom = p.z0 + world.z[name]
            for q in theirs.prims:
                top, low = q.z1 + world.z[other], q.z0 + world.z[other]
                if top < bottom - DROP_CM or low > bottom:
                    continue
                gap = plan_separation(
                    p.kind, compose(world.pose[name], (p.x, p.y, p.yaw)), (p.hx, p.hy),
                    q.kind, compose(world.pose[other], (q.x, q.y, q.yaw)), (q.hx, q.hy),
                )  # fmt: skip
                if gap < -MEETS_CM:
                    return False
    return True


def _reach(shape: Shape) -> float:
    return max(math.hypot(p.x, p.y) + math.hypot(p.hx, p.hy) for p in shape.prims)
