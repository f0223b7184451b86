"""Simulation frame (m, right-handed) to Unreal's (cm, left-handed) and back, and number literals.

Both have Z up; Unreal mirrors y. A proper rotation R becomes S R S with S = diag(1, -1, 1), which
turns a quaternion (x, y, z, w) into (-x, y, -z, w) and an axial vector (angular velocity) into
(-x, y, -z). Every function here is its own inverse up to the scale.
"""

from __future__ import annotations

from collections.abc import Sequence
import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

CM_PER_M = 100.0
CM2_PER_M2 = 10000.0
DIGITS = 15
"""Significant digits of emitted numbers: what a double carries through a decimal."""

Floats = NDArray[np.float64]
Numbers = tuple[float, float, float]
_POLAR = np.array([1.0, -1.0, 1.0])
_AXIAL = np.array([-1.0, 1.0, -1.0])
_QUATERNION = np.array([-1.0, 1.0, -1.0, 1.0])


def vector_to_unreal(value: ArrayLike) -> Floats:
    """Position [m], velocity [m/s] or impulse [N s] to cm, cm/s or kg cm/s, shape [..., 3]."""
    return np.asarray(value, float) * _POLAR * CM_PER_M + 0.0


def vector_from_unreal(value: ArrayLike) -> Floats:
    """Inverse of vector_to_unreal, shape [..., 3]."""
    return np.asarray(value, float) * _POLAR / CM_PER_M + 0.0


def angular_to_unreal(value: ArrayLike) -> Floats:
    """Angular velocity [rad/s] to [deg/s], shape [..., 3]."""
    return np.degrees(np.asarray(value, float) * _AXIAL) + 0.0


def angular_from_unreal(value: ArrayLike) -> Floats:
    """Inverse of angular_to_unreal, shape [..., 3]."""
    return np.radians(np.asarray(value, float) * _AXIAL) + 0.0


def quaternion_to_unreal(value: ArrayLike) -> Floats:
    """Orientation (x, y, z, w), shape [..., 4]; its own inverse."""
    return np.asarray(value, float) * _QUATERNION + 0.0


def heading_to_unreal(radians: float) -> float:
    """Heading or turn rate [rad] to Unreal's yaw [deg]: clockwise seen from above is positive."""
    return -math.degrees(radians) + 0.0


# For what crosses to the class and back many times a step: the same numbers to the last bit, one by
# one, as an array of three costs ten times as much as the arithmetic in it.


def vector_numbers(value: Sequence[float]) -> Numbers:
    """`vector_to_unreal` of three numbers."""
    return (
        float(value[0]) * CM_PER_M + 0.0,
        -float(value[1]) * CM_PER_M + 0.0,
        float(value[2]) * CM_PER_M + 0.0,
    )


def angular_numbers(value: Sequence[float]) -> Numbers:
    """`angular_to_unreal` of three numbers."""
    return (
        math.degrees(-float(value[0])) + 0.0,
        math.degrees(float(value[1])) + 0.0,
        math.degrees(-float(value[2])) + 0.0,
    )


def quaternion_numbers(value: Sequence[float]) -> tuple[float, float, float, float]:
    """`quaternion_to_unreal` of four numbers."""
    return (
        -float(value[0]) + 0.0,
        float(value[1]) + 0.0,
        -float(value[2]) + 0.0,
        float(value[3]) + 0.0,
    )


def literal(value: float) -> str:
    """C++ double literal with 15 significant digits, e.g. `800.0`, `-1.5e-07`.

    Raises:
        ValueError: For NaN or infinity, which have no literal.
    """
    if not math.isfinite(value):
        raise ValueError(f"cannot emit {value!r} as a number")
    text = f"{value:.{DIGITS}g}"
    if float(text) == 0.0:
        return "0.0"
    return text if any(c in text for c in ".e") else text + ".0"


def float_literal(value: float) -> str:
    """C++ float literal, e.g. `0.5f`: the shortest that reads back as the same float32."""
    single = np.float32(value)
    if not np.isfinite(single):
        raise ValueError(f"cannot emit {value!r} as a float")
    text = np.format_float_positional(single, unique=True, trim="0")
    if len(text) > 16:
        text = np.format_float_scientific(single, unique=True, trim="0")
    return ("0.0" if float(text) == 0.0 else text) + "f"


def vector_literal(value: ArrayLike) -> str:
    """FVector literal, shape [3]."""
    return f"FVector({', '.join(literal(float(v)) for v in np.asarray(value, float))})"


def quaternion_literal(value: ArrayLike) -> str:
    """FQuat literal (x, y, z, w), shape [4]."""
    return f"FQuat({', '.join(literal(float(v)) for v in np.asarray(value, float))})"
