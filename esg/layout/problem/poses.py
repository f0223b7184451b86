"""Planar poses: (x, y [cm], yaw [rad]) of a frame in its parent's frame."""

from __future__ import annotations

import math

Pose2 = tuple[float, float, float]


def compose(p: Pose2, q: Pose2) -> Pose2:
    """Returns the pose q, given in frame p, in p's parent frame (x, y [cm], yaw [rad])."""
    c, s = math.cos(p[2]), math.sin(p[2])
    return (p[0] + c * q[0] - s * q[1], p[1] + s * q[0] + c * q[1], p[2] + q[2])


def inverse(p: Pose2) -> Pose2:
    """Returns the inverse of a planar pose."""
    c, s = math.cos(p[2]), math.sin(p[2])
    return (-c * p[0] - s * p[1], s * p[0] - c * p[1], -p[2])
