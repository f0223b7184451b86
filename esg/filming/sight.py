"""Whether other bodies stand between a camera and what it films, by their collision shapes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.filming.subjects import Poses, Subject
from esg.units import quat_inverse, quat_multiply, quat_rotate

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

LOOKS = 9
"""So many instants are looked at."""
SHORT = 0.97
"""A line of sight ends so far of the way to what is filmed: it may lie on something."""
SLIM = 0.95
"""Boxes around shapes are larger than what is in them."""


def clear_share(poses: Poses, subject: Subject, eye: Floats) -> float:
    """Share of lines of sight to it that no shape of another body crosses; less from inside of one.

    Lines end at its middle and near its top. What it is in hides nothing of it.

    Args:
        poses: Of all bodies.
        subject: What is filmed.
        eye: Of the camera [m], shape [K, 3].
    """
    bodies = poses.scene.bodies
    others = [(i, s) for i, b in enumerate(bodies) if i not in subject.bodies for s in b.shapes]
    if not others:
        return 1.0
    looks = np.unique(np.linspace(0, len(eye) - 1, LOOKS).round().astype(int))
    owner = [i for i, _ in others]
    half = SLIM * np.array([_half(s.kind, s.size) for _, s in others])
    q, p = poses.quaternion[looks][:, owner], poses.position[looks][:, owner]
    own = np.broadcast_to(np.array([s.position for _, s in others], float), p.shape)
    center = p + quat_rotate(q, own)
    turn = quat_inverse(quat_multiply(q, np.array([s.quaternion for _, s in others], float)[None]))
    middle, top = subject.middle[looks], subject.high[looks]
    high = np.concatenate([middle[:, :2], 0.8 * top[:, 2:] + 0.2 * middle[:, 2:]], axis=1)
    ends = np.stack([middle, high], axis=1)

    def local(points: Floats) -> Floats:
        """Points [L, P, 3] in the axes of every shape, shape [L, P, n, 3]."""
        away = points[:, :, None] - center[:, None]
        return quat_rotate(np.broadcast_to(turn[:, None], (*away.shape[:3], 4)), away)

    start, end = local(eye[looks][:, None]), local(ends)
    held = np.all(np.abs(end) <= half, axis=-1)
    hidden = (_crossed(start, end, half) & ~held).any(axis=2)
    within = np.all(np.abs(start) <= half, axis=-1).any(axis=(1, 2))
    return float(1.0 - hidden.mean() - within.mean())


def _half(kind: str, size: tuple[float, float, float]) -> tuple[float, float, float]:
    x, y, z = size
    return (x, y, z + x) if kind == "capsule" else (x, y, z)


def _crossed(start: Floats, end: Floats, half: Floats) -> Bools:
    """Whether lines go through boxes about the origin, shape [L, P, n] (slabs)."""
    way = SHORT * (end - start)
    way = np.where(np.abs(way) < 1e-9, 1e-9, way)
    a, b = (-half - start) / way, (half - start) / way
    near, far = np.minimum(a, b).max(axis=-1), np.maximum(a, b).min(axis=-1)
    return (near <= far) & (far >= 0.0) & (near <= 1.0)
