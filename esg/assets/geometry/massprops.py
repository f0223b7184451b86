"""Mass, centre of mass and inertia of a compound of collision proxies.

Validated on analytic bodies (sphere, box, cylinder, capsule, tetrahedron) and the parallel axis
theorem in the tests.
"""

from __future__ import annotations

from collections.abc import Sequence
import math

import numpy as np
from numpy.typing import NDArray

from esg.graph.models import Proxy, ProxyKind, Vec3
from esg.units import quat_rotate

Floats = NDArray[np.float64]


def _hull(points: Floats) -> tuple[float, Floats, Floats]:
    """Volume, centroid and inertia (unit density, about the centroid) of a convex hull."""
    from scipy.spatial import ConvexHull

    hull = ConvexHull(points)
    inside = points[hull.vertices].mean(0)
    tri = points[hull.simplices] - inside
    volumes = np.abs(np.linalg.det(tri)) / 6.0
    volume = float(volumes.sum())
    centroid = (volumes[:, None] * tri.sum(1) / 4.0).sum(0) / volume
    # Second moments of a tetrahedron with one corner at the origin: V/20 (S S^T + sum v v^T).
    total = tri.sum(1)
    second = np.einsum("n,ni,nj->ij", volumes, total, total)
    second += np.einsum("n,nki,nkj->ij", volumes, tri, tri)
    second = second / 20.0 - volume * np.outer(centroid, centroid)
    return volume, inside + centroid, np.trace(second) * np.eye(3) - second


def proxy_moments(proxy: Proxy) -> tuple[float, Floats, Floats]:
    """Volume [cm^3], centroid [cm], and inertia for unit density about the centroid [cm^5].

    Everything is in the asset's local frame; shapes: scalar, [3], [3, 3].
    """
    a, b, c = proxy.size_cm
    offset = np.zeros(3)
    if proxy.kind is ProxyKind.SPHERE:
        volume = 4.0 / 3.0 * math.pi * a**3
        inertia = np.eye(3) * (0.4 * volume * a * a)
    elif proxy.kind is ProxyKind.BOX:
        volume = 8.0 * a * b * c
        inertia = np.diag([b * b + c * c, a * a + c * c, a * a + b * b]) * (volume / 3.0)
    elif proxy.kind is ProxyKind.CYLINDER:
        volume = 2.0 * math.pi * a * a * c
        side = volume * (3 * a * a + 4 * c * c) / 12.0
        inertia = np.diag([side, side, 0.5 * volume * a * a])
    elif proxy.kind is ProxyKind.CAPSULE:
        tube, ball = 2.0 * math.pi * a * a * c, 4.0 / 3.0 * math.pi * a**3
        volume = tube + ball
        side = tube * (3 * a * a + 4 * c * c) / 12.0
        side += ball * (0.4 * a * a + c * c + 0.75 * a * c)
        inertia = np.diag([side, side, 0.5 * tube * a * a + 0.4 * ball * a * a])
    else:
        volume, offset, inertia = _hull(np.asarray(proxy.vertices_cm, float))
    axes = quat_rotate(proxy.orientation_xyzw, np.eye(3)).T
    center = np.asarray(proxy.position_cm) + axes @ offset
    return volume, center, axes @ inertia @ axes.T


def mass_properties(
    proxies: Sequence[Proxy], mass_kg: float, densities: Sequence[float] | None = None
) -> tuple[Vec3, tuple[float, float, float, float, float, float]]:
    """Centre of mass and inertia of a compound, scaled to a total mass.

    Args:
        proxies: Shapes in the asset's local frame.
        mass_kg: Total mass.
        densities: Relative densities, one a proxy; uniform by default.

    Returns:
        Centre of mass [cm], and (Ixx, Iyy, Izz, Ixy, Ixz, Iyz) about it [kg cm^2].
    """
    if not proxies:
        return (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    weights = densities if densities is not None else [1.0] * len(proxies)
    parts = [proxy_moments(p) for p in proxies]
    raw = np.array([w * v for w, (v, _, _) in zip(weights, parts, strict=True)])
    masses = raw * (mass_kg / raw.sum())
    centers = np.array([c for _, c, _ in parts])
    com = (masses[:, None] * centers).sum(0) / mass_kg
    inertia = np.zeros((3, 3))
    for mass, (volume, center, unit) in zip(masses, parts, strict=True):
        d = center - com
        inertia += unit * (mass / volume) + mass * (d @ d * np.eye(3) - np.outer(d, d))
    tensor = tuple(
        float(inertia[i, j]) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    )
    return tuple(float(v) for v in com), tensor  # type: ignore[return-value]
