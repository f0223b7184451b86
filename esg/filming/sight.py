"""Whether boxes of other bodies stand between a camera and what it films."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.filming.subjects import Poses, Subject

Floats = NDArray[np.float64]

LOOKS = 9
"""So many instants are looked at."""
SHORT = 0.97
"""A line of sight ends so far of the way to what is filmed: it may lie on something."""
SLIM = 0.9
"""Boxes are larger than what is in them."""


def clear_share(poses: Poses, subject: Subject, eye: Floats) -> float:
    """Share of lines of sight to it that no box of another body crosses; less from inside of one.

    Args:
        poses: Of all bodies.
        subject: What is filmed.
        eye: Of the camera [m], shape [K, 3].
    """
    others = [i for i, b in enumerate(poses.scene.bodies) if b.shapes and i not in subject.bodies]
    if not others:
        return 1.0
    looks = np.unique(np.linspace(0, len(eye) - 1, LOOKS).round().astype(int))
    corners = poses.corners(others)[looks]
    low, high = corners.min(axis=2), corners.max(axis=2)
    shrink = 0.5 * (1.0 - SLIM) * (high - low)
    low, high = low + shrink, high - shrink
    middle, top = subject.middle[looks], subject.high[looks]
    points = np.stack([middle, np.concatenate([middle[:, :2], 0.9 * top[:, 2:]
                       + 0.1 * middle[:, 2:]], axis=1)], axis=1)  # fmt: skip
    start = eye[looks]
    crossed = _crossed(start[:, None], points, low, high)
    held = np.all((points[:, :, None] >= low[:, None]) & (points[:, :, None] <= high[:, None]), -1)
    hidden = (crossed & ~held).any(axis=2)
    within = np.all((start[:, None] >= low) & (start[:, None] <= high), axis=-1).any(axis=1)
    return float(1.0 - hidden.mean() - within.mean())


def _crossed(start: Floats, end: Floats, low: Floats, high: Floats) -> NDArray[np.bool_]:
    """Whether lines [L, P] go through boxes [L, n], shape [L, P, n] (slabs)."""
    way = SHORT * (end - start)
    way = np.where(np.abs(way) < 1e-9, 1e-9, way)
    a = (low[:, None] - start[:, :, None]) / way[:, :, None]
    b = (high[:, None] - start[:, :, None]) / way[:, :, None]
    near = np.minimum(a, b).max(axis=-1)
    far = np.maximum(a, b).min(axis=-1)
    return (near <= far) & (far >= 0.0) & (near <= 1.0)
