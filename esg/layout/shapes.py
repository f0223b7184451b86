"""Footprints of collision proxies: circle or rectangle in plan, an interval in height.

Objects only turn about Z in a layout, so every proxy sweeps a prism; a sphere is bounded by its
cylinder during the search and treated exactly in the final check (`esg.layout.check`).
"""

from __future__ import annotations

from dataclasses import dataclass

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


def footprints(config: AssetConfiguration) -> tuple[Footprint, ...]:
    """Returns the prisms of an asset; empty for a decal."""
    return tuple(footprint(p) for p in config.proxies)


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
