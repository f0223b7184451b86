"""Footprints of collision proxies: circle or rectangle in plan, an interval in height.

Objects only turn about Z in a layout, so every proxy sweeps a prism; a sphere is bounded by its
cylinder during the search and treated exactly in the final check (`esg.layout.judge.check`). A
slope (tilted box, wedge) is sliced into several prisms.
"""

from __future__ import annotations

from dataclasses import dataclass
import itertools

import numpy as np

from esg.graph.models import AssetConfiguration, Proxy, ProxyKind

CIRCLE, RECTANGLE = 0, 1
UPRIGHT = (0.0, 0.0, 0.0, 1.0)


@dataclass(frozen=True)
class Footprint:
    """One prism in the asset's local frame [cm, rad]."""

    kind: int
    x: float
    y: float
    yaw: float
    hx: float
    hy: float
    z0: float
    z1: float
    is_sphere: bool = False


def rotation(quat: tuple[float, float, float, float]) -> np.ndarray:
    """Returns the 3x3 matrix of a quaternion (x, y, z, w)."""
    x, y, z, w = quat
    n = x * x + y * y + z * z + w * w
    s = 2.0 / n if n > 0 else 0.0
    return np.array(
        [
            [1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)],
            [s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)],
            [s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)],
        ]
    )


def footprint(proxy: Proxy) -> Footprint:
    """Returns the tightest upright prism around one proxy."""
    px, py, pz = proxy.position_cm
    sx, sy, sz = proxy.size_cm
    if proxy.kind is ProxyKind.SPHERE:
        return Footprint(CIRCLE, px, py, 0.0, sx, sx, pz - sx, pz + sx, True)
    if proxy.kind is ProxyKind.BOX and proxy.orientation_xyzw == UPRIGHT:
        return Footprint(RECTANGLE, px, py, 0.0, sx, sy, pz - sz, pz + sz)
    rot = rotation(proxy.orientation_xyzw)
    upright = abs(rot[2, 2]) > 0.9999
    if proxy.kind in (ProxyKind.CYLINDER, ProxyKind.CAPSULE):
        cap = sx if proxy.kind is ProxyKind.CAPSULE else 0.0
        if upright:
            return Footprint(CIRCLE, px, py, 0.0, sx, sx, pz - sz - cap, pz + sz + cap)
        axis = rot[:, 2]
        if cap:
            half = np.abs(axis) * sz + sx
        else:
            half = np.abs(axis) * sz + sx * np.sqrt(np.maximum(0.0, 1.0 - axis**2))
        if abs(axis[2]) < 1e-3:  # lying: keep the rectangle along its axis
            yaw = float(np.arctan2(axis[1], axis[0]))
            return Footprint(RECTANGLE, px, py, yaw, sz + cap, sx, pz - sx, pz + sx)
        return _box(px, py, pz, half)
    if proxy.kind is ProxyKind.BOX:
        if upright:
            yaw = float(np.arctan2(rot[1, 0], rot[0, 0]))
            return Footprint(RECTANGLE, px, py, yaw, sx, sy, pz - sz, pz + sz)
        return _box(px, py, pz, np.abs(rot) @ np.array([sx, sy, sz]))
    if proxy.vertices_cm:
        points = np.asarray(proxy.vertices_cm) @ rot.T + np.asarray(proxy.position_cm)
        low, high = points.min(0), points.max(0)
        mid = 0.5 * (low + high)
        return _box(mid[0], mid[1], mid[2], 0.5 * (high - low))
    return _box(px, py, pz, np.abs(rot) @ np.array([sx, sy, sz]))


def _box(x: float, y: float, z: float, half: np.ndarray) -> Footprint:
    return Footprint(
        RECTANGLE,
        float(x),
        float(y),
        0.0,
        float(half[0]),
        float(half[1]),
        float(z - half[2]),
        float(z + half[2]),
    )


SLICES = 6
"""Prisms that stand for one slope."""
SLOPE_CM = 8.0
"""Lower slopes are bounded by one box."""
SLOPE_VERTICES = 12
"""Rounder hulls are bounded by one box: they have a slope on every side."""


def slope_vertices(proxy: Proxy) -> np.ndarray | None:
    """Corners of a tilted box or of a simple hull (a wedge), shape [n, 3] [cm]; else None."""
    if proxy.kind is ProxyKind.BOX:
        rot = rotation(proxy.orientation_xyzw)
        if abs(rot[2, 2]) > 0.9999:
            return None
        signs = np.array([(i, j, k) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)])
        points = signs * np.asarray(proxy.size_cm)
    elif proxy.vertices_cm and len(proxy.vertices_cm) <= SLOPE_VERTICES:
        rot = rotation(proxy.orientation_xyzw)
        points = np.asarray(proxy.vertices_cm)
    else:
        return None
    points = points @ rot.T + np.asarray(proxy.position_cm)
    return points if np.ptp(points[:, 2]) > SLOPE_CM else None


def slope(points: np.ndarray) -> tuple[Footprint, ...]:
    """Slices a convex solid across its slope; every slice is bounded by an upright prism.

    So a ball may lie at the foot of a ramp, and something low may stand under its upper end.

    Args:
        points: Corners, shape [n, 3] [cm].
    """
    flat = points[:, :2] - points[:, :2].mean(0)
    # the direction in plan along which the solid is longest
    _, _, axes = np.linalg.svd(flat, full_matrices=False)
    yaw = float(np.arctan2(axes[0, 1], axes[0, 0]))
    c, s = np.cos(yaw), np.sin(yaw)
    turned = np.column_stack(
        [c * points[:, 0] + s * points[:, 1], -s * points[:, 0] + c * points[:, 1], points[:, 2]]
    )
    i, j = np.triu_indices(len(turned), 1)
    a, b = turned[i], turned[j]
    cuts = np.linspace(turned[:, 0].min(), turned[:, 0].max(), SLICES + 1)
    out: list[Footprint] = []
    for x0, x1 in itertools.pairwise(cuts):
        inside = [turned[(turned[:, 0] >= x0) & (turned[:, 0] <= x1)]]
        for x in (x0, x1):
            cross = (a[:, 0] - x) * (b[:, 0] - x) < 0
            t = (x - a[cross, 0]) / (b[cross, 0] - a[cross, 0])
            inside.append(a[cross] + t[:, None] * (b[cross] - a[cross]))
        part = np.concatenate(inside)
        low, high = part.min(0), part.max(0)
        mx, my = 0.5 * (x0 + x1), 0.5 * (low[1] + high[1])
        out.append(
            Footprint(
                RECTANGLE,
                float(c * mx - s * my),
                float(s * mx + c * my),
                yaw,
                float(0.5 * (x1 - x0)),
                float(0.5 * (high[1] - low[1])),
                float(low[2]),
                float(high[2]),
            )
        )
    return tuple(out)


def footprints(config: AssetConfiguration) -> tuple[Footprint, ...]:
    """Returns the prisms of an asset; empty for a decal."""
    out: list[Footprint] = []
    for proxy in config.proxies:
        points = slope_vertices(proxy)
        if points is None:
            out.append(footprint(proxy))
        else:
            out += slope(points)
    return tuple(out)


def bounds(
    config: AssetConfiguration, shapes: tuple[Footprint, ...]
) -> tuple[float, float, float, bool]:
    """Returns (half x, half y, height, is round) of an asset's footprint about its origin [cm]."""
    hx, hy, height = (
        max(0.05, 0.5 * config.dimensions_cm[0]),
        max(0.05, 0.5 * config.dimensions_cm[1]),
        max(0.0, config.dimensions_cm[2]),
    )
    for s in shapes:
        c, n = (abs(np.cos(s.yaw)), abs(np.sin(s.yaw))) if s.yaw else (1.0, 0.0)
        ex, ey = (s.hx, s.hx) if s.kind == CIRCLE else (s.hx * c + s.hy * n, s.hx * n + s.hy * c)
        hx, hy = max(hx, abs(s.x) + ex), max(hy, abs(s.y) + ey)
    is_round = (
        bool(shapes)
        and all(s.kind == CIRCLE and abs(s.x) + abs(s.y) < 1e-6 for s in shapes)
        and abs(hx - hy) < 0.05 * max(hx, hy)
    )
    return float(hx), float(hy), float(height), is_round
