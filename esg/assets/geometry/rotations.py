"""Rotations as quaternions (x, y, z, w): about an axis, from local Z; and the frame of glTF."""

from __future__ import annotations

from collections.abc import Sequence
import math

import numpy as np

from esg.graph.models import Quat

IDENTITY: Quat = (0.0, 0.0, 0.0, 1.0)
GLTF_FROM_LOCAL = np.array(
    [[0.01, 0, 0, 0], [0, 0, 0.01, 0], [0, -0.01, 0, 0], [0, 0, 0, 1]], float
)
"""From local cm, Z up, to glTF metres, Y up."""


def turn(axis: str, degrees: float) -> Quat:
    """Quaternion (x, y, z, w) of a rotation about a coordinate axis."""
    half = math.radians(degrees) / 2
    return tuple(  # type: ignore[return-value]  # always four entries
        [math.sin(half) if axis == name else 0.0 for name in "xyz"] + [math.cos(half)]
    )


ALONG = {"x": turn("y", 90.0), "y": turn("x", -90.0), "z": IDENTITY}
"""Rotations that lead local Z to an axis."""


def direction(start: Sequence[float], end: Sequence[float]) -> tuple[Quat, float]:
    """Rotation that leads local Z along a segment, and the length of the segment."""
    d = np.asarray(end, float) - np.asarray(start, float)
    length = float(np.linalg.norm(d))
    d = d / length
    w = 1.0 + d[2]
    if w < 1e-9:
        return (1.0, 0.0, 0.0, 0.0), length
    q = np.array([-d[1], d[0], 0.0, w])
    q /= np.linalg.norm(q)
    return (float(q[0]), float(q[1]), float(q[2]), float(q[3])), length
