"""Collision shapes from what files hold: extents, points of meshes."""

from __future__ import annotations

from collections.abc import Sequence
import itertools

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Shape, ShapeKind
from esg.judging.recording import Floats
from esg.units import quat_rotate

MOST_CORNERS = 64
"""Of a hull: more make the judge slow and nothing else."""
MOST_PIECES = 48
"""Hulls of one mesh; a mesh in more pieces gets one around all of them."""
ROUND = 0.01
"""Spread of the distances of a mesh's points from their middle, by their mean, of a ball."""
_BALL_POINTS = 30
KINDS = ("box", "sphere", "cylinder", "capsule", "none")
"""Shapes that tables name; `none` is a place that nothing collides with."""


def of_extents(kind: str, extents: Sequence[float]) -> tuple[Shape, ...]:
    """A shape about the origin.

    Args:
        kind: Of `KINDS`; the axis of cylinders and capsules is Z.
        extents: Of its bounding box [m], shape [3].

    Raises:
        ValueError: If the kind is unknown.
    """
    x, y, z = (0.5 * float(v) for v in extents)
    made: dict[str, tuple[ShapeKind, tuple[float, float, float]]] = {
        "box": ("box", (x, y, z)),
        "sphere": ("sphere", (x, x, x)),
        "cylinder": ("cylinder", (x, x, z)),
        "capsule": ("capsule", (x, x, max(z - x, 0.0))),
    }
    if kind == "none":
        return ()
    if kind not in made:
        raise ValueError(f"the shape {kind!r} is none of {', '.join(KINDS)}")
    return (Shape(*made[kind]),)


def of_points(points: Floats) -> tuple[Shape, ...]:
    """The hull of points, or the ball that they lie on.

    Args:
        points: In the body's frame [m], shape [n, 3].
    """
    if not len(points):
        return ()
    low, high = points.min(axis=0), points.max(axis=0)
    middle = 0.5 * (low + high)
    away = np.linalg.norm(points - middle, axis=1)
    mean = float(away.mean())
    if len(points) >= _BALL_POINTS and mean > 0.0 and float(np.ptp(away)) < 2 * ROUND * mean:
        return (Shape("sphere", (mean, mean, mean), _triple(middle)),)
    corners = _corners(points - middle)
    half = _triple(0.5 * (high - low))
    return (Shape("convex", half, _triple(middle), vertices=tuple(map(_triple, corners))),)


def of_mesh(points: Floats, faces: NDArray[np.int64]) -> tuple[Shape, ...]:
    """Hulls of the pieces of a mesh that hang together.

    Args:
        points: In the body's frame [m], shape [n, 3].
        faces: Indices of triangles, shape [m, 3].
    """
    pieces = _pieces(points, faces)
    if not 1 < len(pieces) <= MOST_PIECES:
        return of_points(points)
    return tuple(itertools.chain.from_iterable(of_points(points[piece]) for piece in pieces))


def _pieces(points: Floats, faces: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    """Points that edges join; those in one place are one point."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    if not len(faces):
        return []
    _, same = np.unique(np.round(points, 6), axis=0, return_inverse=True)
    same = same.ravel()
    a, b = same[faces[:, [0, 1]]].T, same[faces[:, [1, 2]]].T
    rows, columns = np.concatenate([a[0], b[0]]), np.concatenate([a[1], b[1]])
    size = int(same.max()) + 1
    graph = coo_matrix((np.ones(len(rows)), (rows, columns)), shape=(size, size))
    count, group = connected_components(graph, directed=False)
    used = np.zeros(len(points), bool)
    used[faces.ravel()] = True
    return [
        found for k in range(count) if len(found := np.flatnonzero((group[same] == k) & used)) > 3
    ]


def _corners(points: Floats) -> Floats:
    """Corners of the hull; of many those farthest along directions all around."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        corners = points[ConvexHull(points).vertices]
    except (QhullError, ValueError):
        corners = points
    if len(corners) <= MOST_CORNERS:
        return corners
    k = np.arange(MOST_CORNERS - 6) + 0.5
    high = 1.0 - 2.0 * k / len(k)
    turn = np.pi * (1.0 + 5.0**0.5) * k
    across = np.sqrt(1.0 - high**2)
    ways = np.stack([across * np.cos(turn), across * np.sin(turn), high], axis=1)
    ways = np.concatenate([ways, np.eye(3), -np.eye(3)])
    return corners[np.unique(np.argmax(corners @ ways.T, axis=0))]


def extent_of(shapes: Sequence[Shape]) -> tuple[Floats, Floats]:
    """Lower and upper corner of the box around shapes, in their body's frame [m]."""
    from esg.metrics.geometry import shape_core

    cores = [shape_core(s) for s in shapes]
    low = np.min([c.points.min(axis=0) - c.radius for c in cores], axis=0)
    return low, np.max([c.points.max(axis=0) + c.radius for c in cores], axis=0)


def volume_of(shape: Shape) -> tuple[float, Floats]:
    """Volume [m^3] of a shape, and its centroid in its body's frame [m], shape [3]."""
    x, y, z = shape.size
    at = np.array(shape.position, float)
    if shape.kind == "convex":
        return _hull_volume(shape, at)
    volumes = {
        "sphere": 4.0 / 3.0 * np.pi * x**3,
        "box": 8.0 * x * y * z,
        "cylinder": 2.0 * np.pi * x * x * z,
        "capsule": 2.0 * np.pi * x * x * z + 4.0 / 3.0 * np.pi * x**3,
    }
    return float(volumes[shape.kind]), at


def _hull_volume(shape: Shape, at: Floats) -> tuple[float, Floats]:
    from scipy.spatial import ConvexHull, QhullError

    points = np.array(shape.vertices, float)
    try:
        hull = ConvexHull(points)
    except (QhullError, ValueError):
        return 0.0, at
    inside = points.mean(axis=0)
    corners = points[hull.simplices] - inside
    volumes = np.abs(np.linalg.det(corners)) / 6.0
    centroid = inside + (volumes[:, None] * corners.sum(axis=1) / 4.0).sum(axis=0) / volumes.sum()
    return float(volumes.sum()), at + quat_rotate(np.array(shape.quaternion), centroid)


def _triple(values: Floats) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in values)
    return x, y, z
