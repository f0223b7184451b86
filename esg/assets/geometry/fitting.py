"""Collision proxies and support surfaces of arbitrary meshes.

Concave meshes get parts (`esg.assets.geometry.boxes`, or CoACD in `esg.assets.geometry.convex`). Of
a convex one the primitive whose volume is closest to the hull's wins if it is close enough, else
the hull. Meshes stand on z = 0 of their local frame and may be open: nothing here needs a
watertight surface.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.graph.models import Proxy, ProxyKind, SupportSurface

_FIT = 1.18
"""Primitive volume over hull volume up to which the primitive is used."""
_CONCAVE = 0.006
"""Mean depth of the surface below the hull, over the bounding box's diagonal."""
_HULL_POINTS = 48

Floats = NDArray[np.float64]


def _round(v: Any, digits: int = 4) -> tuple[float, ...]:
    return tuple(round(float(c), digits) for c in v)


def hull_proxy(points: Floats) -> Proxy:
    """Convex hull of points as a proxy, thinned to a number of vertices engines like."""
    from scipy.spatial import ConvexHull

    corners = points[ConvexHull(points, qhull_options="QJ").vertices]
    if len(corners) > _HULL_POINTS:
        n = 400
        k = np.arange(n) + 0.5
        polar, turn = np.arccos(1 - 2 * k / n), math.pi * (1 + 5**0.5) * k
        d = np.stack([np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)], 1)
        d = np.concatenate([np.eye(3), -np.eye(3), d])
        reached = (corners @ d.T).argmax(0)
        order = list(dict.fromkeys(int(i) for i in reached))
        corners = corners[sorted(order[:_HULL_POINTS])]
    low, high = corners.min(0), corners.max(0)
    middle = (low + high) / 2
    return Proxy(
        kind=ProxyKind.CONVEX,
        size_cm=_round((high - low) / 2),  # type: ignore[arg-type]
        position_cm=_round(middle),  # type: ignore[arg-type]
        vertices_cm=tuple(_round(v - middle) for v in corners),  # type: ignore[misc]
    )


def flatten_base(points: Floats, height: float) -> Floats:
    """Lowers what is almost on the ground to it, so that a scanned base does not rock."""
    out = points.copy()
    out[out[:, 2] < 0.012 * height, 2] = 0.0
    return out


def depth_below_hull(points: Floats) -> float:
    """Mean distance of surface points from the convex hull, over the box's diagonal."""
    from scipy.spatial import ConvexHull

    hull = ConvexHull(points, qhull_options="QJ")
    slack = -(points @ hull.equations[:, :3].T + hull.equations[:, 3])
    return float(np.maximum(slack.min(1), 0).mean() / np.linalg.norm(np.ptp(points, axis=0)))


def fit_primitive(points: Floats, *, round_allowed: bool) -> Proxy | None:
    """The best of sphere, upright cylinder, lying capsule and box, or None if none is close.

    Args:
        points: Surface points, z >= 0 [cm], shape [n, 3].
        round_allowed: Whether shapes that roll may be used.
    """
    from scipy.spatial import ConvexHull

    volume = ConvexHull(points, qhull_options="QJ").volume
    low, high = points.min(0), points.max(0)
    half, middle = (high - low) / 2, (low + high) / 2
    candidates: list[tuple[float, Proxy]] = []

    def consider(value: float, kind: ProxyKind, size: Any, center: Any, quat: Any = None) -> None:
        more = {"orientation_xyzw": quat} if quat else {}
        proxy = Proxy(kind=kind, size_cm=_round(size), position_cm=_round(center), **more)  # type: ignore[arg-type]
        candidates.append((value, proxy))

    consider(8 * float(np.prod(half)), ProxyKind.BOX, half, middle)
    if max(half[:2]) < 1.08 * min(half[:2]):
        r = float(np.linalg.norm(points[:, :2] - middle[:2], axis=1).max())
        r = min(r, 1.02 * float(half[:2].max()))
        consider(2 * math.pi * r * r * half[2], ProxyKind.CYLINDER, (r, r, half[2]), middle)
    if round_allowed and max(half) < 1.06 * min(half):
        r = float(half.mean())
        consider(4 / 3 * math.pi * r**3, ProxyKind.SPHERE, (r, r, r), (middle[0], middle[1], r))
    best_ratio, best = min(
        ((max(v / volume, volume / v), p) for v, p in candidates), key=lambda c: c[0]
    )
    return best if best_ratio <= _FIT else None


def support_surfaces(vertices: Floats, faces: NDArray[np.int64], limit: int = 4
                     ) -> tuple[SupportSurface, ...]:  # fmt: skip
    """Level areas on which things can stand, largest first.

    Args:
        vertices: [cm], shape [n, 3].
        faces: Triangles, shape [m, 3].
        limit: At most so many.
    """
    tri = vertices[faces]
    cross = np.cross(tri[:, 1] - tri[:, 0], tri[:, 2] - tri[:, 0])
    area = np.linalg.norm(cross, axis=1) / 2
    # The signed volume tells outwards from inwards, even if the mesh has holes.
    outward = 1.0 if np.einsum("ni,ni->", tri.mean(1), cross) >= 0 else -1.0
    keep = (area > 0) & (outward * cross[:, 2] > 1.98 * area)
    if not keep.any():
        return ()
    height = float(np.ptp(vertices[:, 2])) or 1.0
    footprint = float(np.prod(np.ptp(vertices[:, :2], axis=0))) or 1.0
    level = np.round(tri[keep][:, :, 2].mean(1) / (0.01 * height)).astype(int)
    found: list[tuple[float, float, NDArray[np.float64], NDArray[np.float64]]] = []
    for z in np.unique(level):
        part = tri[keep][level == z]
        total = float(area[keep][level == z].sum())
        top = float(part[:, :, 2].max())
        if total < 0.12 * footprint or top < 0.05 * height:
            continue
        flat = part[:, :, :2].reshape(-1, 2)
        low, high = flat.min(0), flat.max(0)
        box = float(np.prod(high - low))
        if total < 0.5 * box:
            continue
        middle, half = (low + high) / 2, (high - low) / 2 * 0.95
        found.append((total, top, middle, half))
    found.sort(key=lambda f: (-round(f[0], 3), -f[1]))
    out = []
    for _, top, middle, half in found:
        if any(abs(top - s.center_cm[2]) < 0.03 * height for s in out):
            continue
        name = "top" if not out else f"level {len(out) + 1}"
        out.append(
            SupportSurface(
                name=name,
                center_cm=_round((*middle, top)),  # type: ignore[arg-type]
                half_extents_cm=_round(half),  # type: ignore[arg-type]
            )
        )
        if len(out) == limit:
            break
    return tuple(out)


def fit_proxies(points: Floats, *, round_allowed: bool = False) -> tuple[tuple[Proxy, ...], bool]:
    """Proxies of a mesh, and whether it is so concave that convex parts would be better.

    Args:
        points: Surface points with z >= 0 [cm], shape [n, 3].
        round_allowed: Whether the object may roll.
    """
    base = flatten_base(points, float(points[:, 2].max()))
    concave = depth_below_hull(base) > _CONCAVE
    primitive = None if concave else fit_primitive(base, round_allowed=round_allowed)
    return (primitive or hull_proxy(base),), concave
