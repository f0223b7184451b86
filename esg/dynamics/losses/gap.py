"""Surface distance between two bodies over many worlds and frames, from their analytic proxies.

Points on each body's surface are measured against the other body's exact signed distances (sphere,
box, capsule, cylinder; a convex hull by its bounding box). Exact where a face, edge or round
surface faces a sampled corner, edge point or centre. Used to steer the search towards a missed
target, not to decide whether it was hit.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from esg.engines.scene import Body, Shape
from esg.units import quat_rotate

Floats = NDArray[np.float64]


@lru_cache(maxsize=4096)
def _samples(shape: Shape) -> tuple[Floats, float]:
    """Sample points in the shape's frame [m], shape [n, 3], and the radius around each of them."""
    sx, sy, sz = shape.size
    if shape.kind == "sphere":
        return np.zeros((1, 3)), sx
    if shape.kind == "capsule":
        return np.array([[0.0, 0.0, z] for z in (-sz, 0.0, sz)]), sx
    if shape.kind == "cylinder":
        angles = np.arange(12) * (2.0 * np.pi / 12)
        ring = np.stack([sx * np.cos(angles), sx * np.sin(angles)], axis=1)
        return np.concatenate([np.c_[ring, np.full(12, z)] for z in (-sz, 0.0, sz)]), 0.0
    if shape.kind == "convex" and shape.vertices:
        return np.array(shape.vertices), 0.0
    grid = np.array([[i, j, k] for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)], float)
    grid = grid[np.any(grid != 0.0, axis=1)]
    return grid * np.array([sx, sy, sz]), 0.0


def signed_distance(shape: Shape, p: Floats) -> Floats:
    """Signed distance [m] of points in the shape's frame, shape [3, ...] -> [...]."""
    sx, sy, sz = shape.size
    x, y, z = p
    if shape.kind == "sphere":
        return np.sqrt(x * x + y * y + z * z) - sx
    if shape.kind == "capsule":
        z = z - np.clip(z, -sz, sz)
        return np.sqrt(x * x + y * y + z * z) - sx
    if shape.kind == "cylinder":
        q = [np.sqrt(x * x + y * y) - sx, np.abs(z) - sz]
    else:
        q = [np.abs(x) - sx, np.abs(y) - sy, np.abs(z) - sz]
    inside, square = q[0], np.square(np.maximum(q[0], 0.0))
    for more in q[1:]:
        inside = np.maximum(inside, more)
        square += np.square(np.maximum(more, 0.0))
    return np.sqrt(square) + np.minimum(inside, 0.0)


@lru_cache(maxsize=1024)
def _surfaces(body: Body) -> tuple[Shape, ...]:
    """What a body is measured by: its shapes, or its bounds where it has none (a painted line)."""
    return body.shapes or (Shape("box", body.half_extents),)


@lru_cache(maxsize=1024)
def bounding_radius(body: Body) -> float:
    """Radius [m] of a sphere around the centre of mass that holds all `surface_gap` measures."""
    far = 0.0
    for shape in _surfaces(body):
        # A hull's distances are those of its bounding box; half the diagonal holds either.
        points = np.abs(_samples(shape)[0]).max(axis=0)
        half = np.maximum(np.array(shape.size), points)
        if shape.kind == "capsule":
            half[2] += shape.size[0]
        far = max(far, float(np.linalg.norm(shape.position) + np.linalg.norm(half)))
    return far


def surface_gap(
    a: Body, b: Body, pos_a: Floats, quat_a: Floats, pos_b: Floats, quat_b: Floats
) -> Floats:
    """Distance between the surfaces of two bodies [m], negative inside.

    Args:
        a, b: Bodies; one without shapes is measured by its bounds.
        pos_a, pos_b: Centres of mass [m], shape [..., 3].
        quat_a, quat_b: Orientations (x, y, z, w), shape [..., 4].

    Returns:
        Shape [...].
    """
    forward = _one_way(a, b, pos_a, quat_a, pos_b, quat_b)
    return np.minimum(forward, _one_way(b, a, pos_b, quat_b, pos_a, quat_a))


def _one_way(
    a: Body, b: Body, pos_a: Floats, quat_a: Floats, pos_b: Floats, quat_b: Floats
) -> Floats:
    to_b = np.swapaxes(_matrix(quat_b), -1, -2)
    turn = to_b @ _matrix(quat_a)
    offset = to_b @ (np.asarray(pos_a) - np.asarray(pos_b))[..., None]
    best = np.full(np.shape(pos_a)[:-1], np.inf)
    for target in _surfaces(b):
        frame = _matrix(target.quaternion).T
        # Points of a's frame [3, n] in the target's, shape [3, ..., n].
        into, shift = frame @ turn, frame @ (offset - np.array(target.position)[:, None])
        for source in _surfaces(a):
            local, radius = _samples(source)
            points = quat_rotate(np.array(source.quaternion), local) + np.array(source.position)
            p = np.moveaxis(into @ points.T + shift, -2, 0)
            best = np.minimum(best, signed_distance(target, p).min(axis=-1) - radius)
    return best


def _matrix(q: ArrayLike) -> Floats:
    """Rotation matrices of quaternions, shape [..., 4] -> [..., 3, 3]."""
    return np.swapaxes(quat_rotate(np.asarray(q, float)[..., None, :], np.eye(3)), -1, -2)
