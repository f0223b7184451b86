"""Signed distances between compounds of convex shapes, exact for their hulls.

Every shape is a convex core plus a radius: a sphere is a point, a capsule a segment, a box,
cylinder (a prism of 48 sides, < 0.3% of the radius off) or convex hull its vertices. Separated
cores are measured with GJK, overlapping ones on the facets of their Minkowski difference (the
exact EPA answer). Validated on analytic pairs in tests/metrics/test_geometry.py.
"""

from __future__ import annotations

from dataclasses import dataclass
import itertools
import math
from typing import cast

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Body, Region, Shape
from esg.units import quat_rotate

Floats = NDArray[np.float64]
_SIDES = 48
_EPS = 1e-9


@dataclass(frozen=True)
class Core:
    """A convex core in some frame.

    Args:
        points: Vertices [m], shape [n, 3].
        radius: Rounding radius [m].
    """

    points: Floats
    radius: float


def shape_core(shape: Shape) -> Core:
    """The core of a shape in its body's frame."""
    r, _, h = shape.size
    radius = 0.0
    if shape.kind == "sphere":
        local, radius = np.zeros((1, 3)), shape.size[0]
    elif shape.kind == "capsule":
        local, radius = np.array([[0, 0, -h], [0, 0, h]], float), r
    elif shape.kind == "box":
        local = np.array(list(itertools.product((-1, 1), repeat=3)), float) * np.array(shape.size)
    elif shape.kind == "cylinder":
        angle = np.arange(_SIDES) * 2 * math.pi / _SIDES
        # The prism of equal mean radius, between the inscribed and the circumscribed one.
        ring = 2 * r / (1 + math.cos(math.pi / _SIDES))
        circle = np.stack([ring * np.cos(angle), ring * np.sin(angle)], axis=1)
        local = np.concatenate(
            [np.column_stack([circle, np.full(_SIDES, z)]) for z in (-h, h)], axis=0
        )
    else:
        local = np.array(shape.vertices, float).reshape(-1, 3)
    points = quat_rotate(np.array(shape.quaternion), local) + np.array(shape.position)
    return Core(points, radius)


def body_cores(body: Body) -> tuple[Core, ...]:
    """Cores of all shapes of a body, in its frame."""
    return tuple(shape_core(s) for s in body.shapes)


def place(core: Core, position: Floats, quaternion: Floats) -> Core:
    """The core moved by a pose (position [m] shape [3], quaternion xyzw shape [4])."""
    return Core(quat_rotate(np.asarray(quaternion, float), core.points) + position, core.radius)


def signed_distance(a: Core, b: Core) -> float:
    """Distance between two cores [m]; negative is minus the penetration depth."""
    distance = gjk_distance(a.points, b.points)
    if distance <= _EPS:
        distance = -core_depth(a.points, b.points)
    return distance - a.radius - b.radius


def compound_distance(
    a: tuple[Core, ...], b: tuple[Core, ...], *, cutoff: float = math.inf
) -> float:
    """Smallest signed distance over all pairs of two compounds (both placed) [m].

    Args:
        a, b: Placed cores.
        cutoff: Pairs whose bounding boxes are farther apart than this are skipped.

    Returns:
        The distance, or infinity if every pair was skipped.
    """
    best = math.inf
    for x in a:
        low_x, high_x = x.points.min(0) - x.radius, x.points.max(0) + x.radius
        for y in b:
            gap = np.maximum(
                low_x - (y.points.max(0) + y.radius), (y.points.min(0) - y.radius) - high_x
            )
            lower = float(np.linalg.norm(np.maximum(gap, 0.0)))
            # An overlap of boxes bounds the depth too: nothing shallower can improve the minimum.
            if lower > min(cutoff, max(best, 0.0)):
                continue
            best = min(best, signed_distance(x, y))
    return best


def core_depth(a: Floats, b: Floats) -> float:
    """Penetration depth of two overlapping convex point sets [m], 0 for flat or touching ones."""
    from scipy.spatial import ConvexHull, QhullError

    difference = (a[:, None, :] - b[None, :, :]).reshape(-1, 3)
    try:
        hull = ConvexHull(difference)
    except QhullError:
        return 0.0
    # Facet equations n.x + d <= 0 inside: the origin's distance to each facet is -d.
    return max(0.0, float(np.min(-hull.equations[:, 3])))


def gjk_distance(a: Floats, b: Floats) -> float:
    """Distance between the hulls of two point sets [m], 0 if they overlap (GJK)."""
    return float(np.linalg.norm(gjk_vector(a, b)))


def gjk_vector(a: Floats, b: Floats, *, beyond: float = math.inf, iterations: int = 64) -> Floats:
    """The shortest way from the hull of `b` to that of `a` [m], shape [3]; 0 if they overlap.

    Args:
        a, b: Point sets, shapes [n, 3] and [m, 3].
        beyond: Once the two are known to be farther apart, a way that is at least this long and no
            longer than the gap will do [m].
        iterations: At most.
    """
    simplex = np.empty((0, 3))
    v = a[0] - b[0]
    for _ in range(iterations):
        norm2 = float(v @ v)
        if norm2 < _EPS * _EPS:
            return np.zeros(3)
        w = a[np.argmin(a @ v)] - b[np.argmax(b @ v)]
        along = float(v @ w)
        # No point of the difference is closer in this direction: v is the closest one.
        if norm2 - along <= 1e-10 * norm2 + 1e-14 or _has_row(simplex, w):
            return v
        if along > beyond * math.sqrt(norm2):
            return v * (along / norm2)
        simplex, v = _closest(np.vstack([simplex, w]))
        if len(simplex) == 4:
            return np.zeros(3)
    return v


def _has_row(simplex: Floats, w: Floats) -> bool:
    return bool(len(simplex)) and bool(np.any(np.all(np.abs(simplex - w) < 1e-14, axis=1)))


def _closest(simplex: Floats) -> tuple[Floats, Floats]:
    """The face of a simplex nearest to the origin, and the nearest point (brute force, n <= 4)."""
    best: tuple[float, Floats, Floats] | None = None
    n = len(simplex)
    for size in range(1, n + 1):
        for subset in itertools.combinations(range(n), size):
            points = simplex[list(subset)]
            weights = _affine_weights(points)
            if weights is None or np.any(weights < -1e-12):
                continue
            v = weights @ points
            d = float(v @ v)
            if best is None or d < best[0] - 1e-18:
                best = (d, points, v)
    assert best is not None
    return best[1], best[2]


def _affine_weights(points: Floats) -> Floats | None:
    """Barycentric weights of the point of an affine hull that is nearest to the origin."""
    if len(points) == 1:
        return np.ones(1)
    edges = points[1:] - points[0]
    gram = edges @ edges.T
    if len(points) > 1 and np.linalg.det(gram) <= 1e-18 * max(np.trace(gram), 1e-30) ** len(edges):
        return None
    t = cast("Floats", np.linalg.solve(gram, -edges @ points[0]))
    return np.concatenate([[1.0 - t.sum()], t])


def region_core(region: Region) -> Core:
    """The box of a region in its parent's frame."""
    corners = np.array(list(itertools.product((-1, 1), repeat=3)), float)
    return Core(corners * np.array(region.half_extents) + np.array(region.center), 0.0)


def box_core(body: Body) -> Core:
    """The bounding box of a body's asset in its frame, for bodies without collision shapes."""
    hx, hy, hz = body.half_extents
    corners = np.array(list(itertools.product((-1, 1), repeat=3)), float) * (hx, hy, hz)
    return Core(corners + np.array(body.origin_offset) + np.array([0.0, 0.0, hz]), 0.0)


def lowest_point(cores: tuple[Core, ...], position: Floats, quaternion: Floats) -> float:
    """Height of the lowest point of a placed compound [m]."""
    if not cores:
        return float(position[2])
    q = np.asarray(quaternion, float)
    return min(float((quat_rotate(q, c.points)[:, 2]).min()) - c.radius for c in cores) + float(
        position[2]
    )


NEAR_PASS, NEAR_PASS_M = 1.25, 0.25
"""A pass counts if it comes within so much of the closest one: factor and margin [m]."""
NEARER = 0.35
"""So does one that leaves this share of the first distance."""
APPROACH_M = 0.05
"""Least way by which a body has come nearer before it passes."""


def first_pass(distance: NDArray[np.float64]) -> int:
    """Frame at which something passes by: the first of its approaches that is about the closest.

    What hits something behind and is thrown back comes by a second time, perhaps closer.

    Args:
        distance: Between the two [m], shape [T].
    """
    closest = int(np.argmin(distance))
    enough = max(NEAR_PASS * distance[closest] + NEAR_PASS_M, NEARER * distance[0])
    near = distance <= enough
    lowest = np.zeros(len(distance), bool)
    lowest[1:-1] = (distance[1:-1] <= distance[:-2]) & (distance[1:-1] < distance[2:])
    came = np.maximum.accumulate(distance) - distance >= APPROACH_M
    passes = np.flatnonzero(near & lowest & came)
    return min(int(passes[0]), closest) if len(passes) else closest


def gets_ahead(ahead: NDArray[np.float64], free: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Frames at which one that was behind another is no longer.

    Args:
        ahead: How far it is ahead along its own way; only the sign counts, shape [..., T].
        free: Frames that count, shape [..., T].
    """
    behind = np.logical_or.accumulate((ahead < 0.0) & free, axis=-1)
    return behind & (ahead >= 0.0) & free
