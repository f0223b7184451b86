"""Few boxes that fill a concave mesh: a deterministic stand-in for convex parts, in milliseconds.

The mesh is sampled on a grid fitted to its bounds; cells are full where the signed distance says so
or a thin sheet passes; full cells are merged greedily, largest box first.
"""

from __future__ import annotations

from collections.abc import Sequence
import math

import numpy as np
from numpy.typing import NDArray

from esg.assets.geometry.sdf import VoxelSdf, voxel_sdf
from esg.graph.models import Proxy, ProxyKind

_GRIDS = (12, 8)
_FIELD = 20
"""Resolution of the distance field behind the grids."""
MAX_BOXES = 28
_SHEET = 0.3
"""Cells within this share of a cell of the surface count as full: chair backs are thin."""


def occupancy(
    field: VoxelSdf, low: NDArray[np.float64], high: NDArray[np.float64], shape: tuple[int, ...]
) -> NDArray[np.bool_]:
    """Which cells of a grid over the mesh's bounds are full."""
    cell = (high - low) / shape
    grid = np.stack(np.meshgrid(*[np.arange(n) for n in shape], indexing="ij"), -1)
    full = np.zeros(shape)
    for corner in range(8):
        offset = np.array([0.25 + 0.5 * ((corner >> k) & 1) for k in range(3)])
        points = (low + (grid + offset) * cell).reshape(-1, 3)
        full += (field.sample(points) < _SHEET * field.cell_cm).reshape(shape)
    return full >= 4


def _grow(
    free: NDArray[np.bool_], seed: tuple[int, ...], order: tuple[int, ...]
) -> tuple[slice, ...]:
    low, high = list(seed), [s + 1 for s in seed]
    for axis in order:
        while high[axis] < free.shape[axis]:
            probe = [slice(a, b) for a, b in zip(low, high, strict=True)]
            probe[axis] = slice(high[axis], high[axis] + 1)
            if not free[tuple(probe)].all():
                break
            high[axis] += 1
    return tuple(slice(a, b) for a, b in zip(low, high, strict=True))


_ORDERS = ((0, 1, 2), (1, 2, 0), (2, 0, 1))


def merge(full: NDArray[np.bool_]) -> list[tuple[slice, ...]]:
    """Disjoint boxes of cells that cover all full ones, each grown as large as it gets."""
    left = full.copy()
    boxes = []
    while left.any():
        best: tuple[int, tuple[slice, ...]] | None = None
        corners = np.argwhere(left & ~_shifted(left))
        for seed in corners:
            for order in _ORDERS:
                box = _grow(left, tuple(int(v) for v in seed), order)
                size = int(np.prod([b.stop - b.start for b in box]))
                if best is None or size > best[0]:
                    best = (size, box)
        assert best is not None
        left[best[1]] = False
        boxes.append(best[1])
        if len(boxes) > MAX_BOXES:
            break
    return boxes


def _shifted(full: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Cells with a full neighbour before them on every axis: they start no maximal box."""
    out = np.ones_like(full)
    for axis in range(3):
        before = np.zeros_like(full)
        head = [slice(None)] * 3
        tail = [slice(None)] * 3
        head[axis], tail[axis] = slice(1, None), slice(None, -1)
        before[tuple(head)] = full[tuple(tail)]
        out &= before
    return out


def box_parts(vertices: NDArray[np.float64], faces: NDArray[np.int64]) -> tuple[Proxy, ...] | None:
    """Boxes that follow a concave mesh standing on z = 0, None if it has no inside.

    Args:
        vertices: Local frame [cm], shape [n, 3].
        faces: Shape [m, 3].
    """
    low, high = vertices.min(0), vertices.max(0)
    extents = high - low
    field = voxel_sdf(vertices, faces, _FIELD)
    for cells in _GRIDS:
        shape = tuple(int(np.clip(round(cells * e / extents.max()), 3, cells)) for e in extents)
        full = occupancy(field, low, high, shape)
        if not full.any():
            return None
        boxes = merge(full)
        if len(boxes) <= MAX_BOXES:
            break
    else:
        return None
    cell = extents / shape
    proxies = []
    for box in boxes:
        a = low + np.array([b.start for b in box]) * cell
        b = low + np.array([b.stop for b in box]) * cell
        proxies.append(
            Proxy(
                kind=ProxyKind.BOX,
                size_cm=tuple(round(float(v), 4) for v in (b - a) / 2),  # type: ignore[arg-type]
                position_cm=tuple(round(float(v), 4) for v in (a + b) / 2),  # type: ignore[arg-type]
            )
        )
    if min(p.position_cm[2] - p.size_cm[2] for p in proxies) > 0.03 * extents[2]:
        return None
    return tuple(proxies)


def _footprint(proxies: Sequence[Proxy]) -> NDArray[np.float64]:
    """Plan of everything that touches the ground [cm], shape [n, 2]."""
    points: list[tuple[float, float]] = []
    for p in proxies:
        x, y, z = p.position_cm
        a, b, c = p.size_cm
        if p.kind is ProxyKind.CONVEX:
            points += [(x + v[0], y + v[1]) for v in p.vertices_cm if z + v[2] < 0.05]
        elif z - c < 0.05 and p.kind is ProxyKind.CYLINDER:
            turns = [2 * math.pi * k / 16 for k in range(16)]
            points += [(x + a * math.cos(t), y + a * math.sin(t)) for t in turns]
        elif z - c < 0.05:
            points += [(x + i * a, y + j * b) for i in (-1, 1) for j in (-1, 1)]
    return np.array(points).reshape(-1, 2)


def margin(proxies: Sequence[Proxy]) -> float:
    """How far inside its footprint the centre of mass lies [cm]; negative if it would tip."""
    from shapely.geometry import MultiPoint, Point, Polygon

    from esg.assets.geometry.massprops import mass_properties

    foot = MultiPoint(_footprint(proxies)).convex_hull
    com = Point(mass_properties(proxies, 1.0)[0][:2])
    if not isinstance(foot, Polygon):
        return -1.0
    inside = foot.contains(com)
    return (1.0 if inside else -1.0) * foot.exterior.distance(com)


def steadied(proxies: tuple[Proxy, ...], vertices: NDArray[np.float64]) -> tuple[Proxy, ...]:
    """The proxies, on a thin foot plate if they would not stand by themselves.

    The plate spans what of the mesh is near the ground, and at least a patch under the centre of
    mass: chair legs that a coarse grid lost, and things meant to hang on a wall.

    Args:
        proxies: Fitted shapes.
        vertices: Local frame [cm], shape [n, 3].
    """
    from esg.assets.geometry.massprops import mass_properties

    extents = np.ptp(vertices, axis=0)
    enough = max(0.1, 0.06 * float(extents[:2].min()))
    if proxies[0].kind is ProxyKind.SPHERE or margin(proxies) >= enough:
        return proxies
    com = np.array(mass_properties(proxies, 1.0)[0][:2])
    near = vertices[vertices[:, 2] < 0.03 * extents[2]][:, :2]
    patch = 0.2 * np.maximum(extents[:2], 0.12 * extents[2])
    low = np.minimum(near.min(0), com - patch)
    high = np.maximum(near.max(0), com + patch)
    thick = max(0.1, 0.012 * float(extents[2]))
    x, y = (low + high) / 2
    plate = Proxy(
        kind=ProxyKind.BOX,
        size_cm=(
            round(float(high[0] - low[0]) / 2, 4),
            round(float(high[1] - low[1]) / 2, 4),
            round(thick / 2, 4),
        ),
        position_cm=(round(float(x), 4), round(float(y), 4), round(thick / 2, 4)),
    )
    return (plate, *proxies)
