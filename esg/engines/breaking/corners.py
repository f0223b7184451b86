"""Shapes as convex polyhedra, for cutting them up."""

from __future__ import annotations

import math

import numpy as np

from esg.engines.joints import Floats
from esg.engines.scene import Shape
from esg.units import quat_rotate

_SIDES, _RINGS = 24, 8


def corners(shape: Shape) -> Floats:
    """Corners of a shape in its body's frame [m], shape [n, 3]; round ones are cut inside of it."""
    x, y, z = shape.size
    if shape.kind == "box":
        signs = np.array([(i, j, k) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)], float)
        points = signs * [x, y, z]
    elif shape.kind == "cylinder":
        angle = 2.0 * math.pi * np.arange(_SIDES) / _SIDES
        ring = x * np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=1)
        up = np.array([0.0, 0.0, z])
        points = np.concatenate([ring - up, ring + up])
    elif shape.kind in ("sphere", "capsule"):
        ball = x * _ball()
        half = z if shape.kind == "capsule" else 0.0
        points = ball + np.where(ball[:, 2:] > 0.0, half, -half) * [0.0, 0.0, 1.0]
        points = np.concatenate([points, ball[np.abs(ball[:, 2]) < 1e-9] + [0.0, 0.0, half]])
    else:
        points = np.array(shape.vertices, float)
    return quat_rotate(np.asarray(shape.quaternion, float), points) + np.asarray(shape.position)


def _ball() -> Floats:
    """Points of the unit sphere in rings, shape [n, 3]."""
    rows: list[tuple[float, float, float]] = [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0)]
    for k in range(1, _RINGS):
        tilt = math.pi * k / _RINGS
        n = max(4, round(2 * _RINGS * math.sin(tilt)))
        angle = 2.0 * math.pi * np.arange(n) / n
        rows += [(math.sin(tilt) * c, math.sin(tilt) * s, math.cos(tilt))
                 for c, s in zip(np.cos(angle), np.sin(angle), strict=True)]  # fmt: skip
    return np.array(rows)
