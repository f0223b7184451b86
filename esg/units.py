"""Unit and frame conversions: the only place where the document meets the simulator.

The ESG document is in cm, kg, s, degrees (paper, Unreal); simulation is SI with radians. Both are
right-handed, Z up, left = +X, front = +Y. Unreal is left-handed: ``y`` is mirrored when emitting.
"""

from __future__ import annotations

from collections.abc import Iterable
import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

CM_PER_M = 100.0
GRAVITY_MPS2 = 9.81


def m_from_cm(value: float) -> float:
    """Converts a length, speed or acceleration from centimetres to metres."""
    return value / CM_PER_M


def quat_from_euler_deg(yaw: float, pitch: float = 0.0, roll: float = 0.0) -> NDArray[np.float64]:
    """Quaternion (x, y, z, w) of R = Rz(yaw) Ry(pitch) Rx(roll), angles in degrees, shape [4]."""
    cy, sy = math.cos(math.radians(yaw) / 2), math.sin(math.radians(yaw) / 2)
    cp, sp = math.cos(math.radians(pitch) / 2), math.sin(math.radians(pitch) / 2)
    cr, sr = math.cos(math.radians(roll) / 2), math.sin(math.radians(roll) / 2)
    return np.array(
        [
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
            cr * cp * cy + sr * sp * sy,
        ]
    )


def euler_deg_from_quat(q: ArrayLike) -> tuple[float, float, float]:
    """Yaw, pitch and roll [deg] of R = Rz(yaw) Ry(pitch) Rx(roll); no roll at a pitch of 90.

    Args:
        q: Unit quaternion (x, y, z, w), shape [4].
    """
    x, y, z, w = (float(v) for v in np.asarray(q, float))
    sine = min(max(2.0 * (w * y - z * x), -1.0), 1.0)
    if abs(sine) > 1.0 - 1e-12:
        yaw = math.copysign(2.0, sine) * math.atan2(-x, w)
        return math.degrees(math.remainder(yaw, 2.0 * math.pi)), math.copysign(90.0, sine), 0.0
    yaw = math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
    roll = math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
    return math.degrees(yaw), math.degrees(math.asin(sine)), math.degrees(roll)


def quat_multiply(a: ArrayLike, b: ArrayLike) -> NDArray[np.float64]:
    """Hamilton product of quaternions (x, y, z, w), shapes broadcast over [..., 4]."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    ax, ay, az, aw = np.moveaxis(a, -1, 0)
    bx, by, bz, bw = np.moveaxis(b, -1, 0)
    return np.stack(
        [
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz,
        ],
        axis=-1,
    )


def quat_rotate(q: ArrayLike, v: ArrayLike) -> NDArray[np.float64]:
    """Rotates vectors [..., 3] by quaternions (x, y, z, w) [..., 4]."""
    q, v = np.asarray(q, float), np.asarray(v, float)
    u, w = q[..., :3], q[..., 3:]
    t = 2.0 * cross(u, v)
    return v + w * t + cross(u, t)


def cross(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """`numpy.cross` of vectors [..., 3], to the last bit: it handles axes longer than it works."""
    ax, ay, az = a[..., 0], a[..., 1], a[..., 2]
    bx, by, bz = b[..., 0], b[..., 1], b[..., 2]
    parts = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    if a.ndim == b.ndim == 1:
        return np.array(parts)
    out = np.empty((*parts[0].shape, 3))  # `numpy.stack` takes as long as the arithmetic
    out[..., 0], out[..., 1], out[..., 2] = parts
    return out


def quat_rotated(q: Iterable[float], v: Iterable[float]) -> tuple[float, float, float]:
    """`quat_rotate` of one vector [3] by one quaternion [4], to the last bit, without arrays."""
    x, y, z, w = map(float, q)
    a, b, c = map(float, v)
    tx, ty, tz = 2.0 * (y * c - z * b), 2.0 * (z * a - x * c), 2.0 * (x * b - y * a)
    return (
        a + w * tx + (y * tz - z * ty),
        b + w * ty + (z * tx - x * tz),
        c + w * tz + (x * ty - y * tx),
    )


def quat_from_down(direction: ArrayLike) -> NDArray[np.float64]:
    """Quaternions (x, y, z, w) [..., 4] of the shortest turn from -Z to unit vectors [..., 3]."""
    x, y, z = np.moveaxis(np.asarray(direction, float), -1, 0)
    turn = np.stack([y, -x, np.zeros_like(x), 1.0 - z], axis=-1)
    size = np.linalg.norm(turn, axis=-1, keepdims=True)
    return np.where(size > 1e-9, turn / np.where(size > 1e-9, size, 1.0), (1.0, 0.0, 0.0, 0.0))


def quat_inverse(q: ArrayLike) -> NDArray[np.float64]:
    """Inverse of unit quaternions (x, y, z, w), shape [..., 4]."""
    return np.asarray(q, float) * np.array([-1.0, -1.0, -1.0, 1.0])


def yaw_from_quat(q: ArrayLike) -> NDArray[np.float64]:
    """Heading [rad] of the rotated +X axis projected on the ground, shape [...]."""
    x, y, z, w = np.moveaxis(np.asarray(q, float), -1, 0)
    return np.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
