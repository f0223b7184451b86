"""Measured quantities: dimensions, units, precision thresholds and the paper's PPA score."""

from __future__ import annotations

import math
from typing import Literal

Dimension = Literal["time", "speed", "mass", "length", "angle"]
ThresholdSet = Literal["standard", "strict", "lenient"]

DIMENSION_OF: dict[str, Dimension] = {
    "mass": "mass",
    "speed": "speed",
    "speed_after": "speed",
    "time": "time",
    "time_since": "time",
    "time_to_stop": "time",
    "distance": "length",
    "height": "length",
    "angle": "angle",
    "length": "length",
    "width": "length",
}
"""Dimension of every quantity a suite may constrain or state."""

BASE_UNIT: dict[Dimension, str] = {
    "time": "s",
    "speed": "m/s",
    "mass": "kg",
    "length": "m",
    "angle": "deg",
}

_UNITS: dict[Dimension, dict[str, float]] = {
    "time": {
        **dict.fromkeys(("s", "sec", "secs", "second", "seconds"), 1.0),
        **dict.fromkeys(("ms", "millisecond", "milliseconds"), 1e-3),
        **dict.fromkeys(("min", "minute", "minutes"), 60.0),
    },
    "speed": {
        **dict.fromkeys(("m/s", "mps", "m s^-1", "meters per second", "metres per second"), 1.0),
        **dict.fromkeys(("km/h", "kmh", "kph", "kilometers per hour"), 1.0 / 3.6),
        "cm/s": 0.01,
        **dict.fromkeys(("mph", "miles per hour"), 0.44704),
        "ft/s": 0.3048,
    },
    "mass": {
        **dict.fromkeys(("kg", "kilogram", "kilograms"), 1.0),
        **dict.fromkeys(("g", "gram", "grams"), 1e-3),
        **dict.fromkeys(("t", "ton", "tons", "tonne", "tonnes"), 1000.0),
        **dict.fromkeys(("lb", "lbs", "pound", "pounds"), 0.45359237),
    },
    "length": {
        **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), 1.0),
        **dict.fromkeys(("cm", "centimeter", "centimeters", "centimetre", "centimetres"), 0.01),
        "mm": 1e-3,
        "km": 1000.0,
        **dict.fromkeys(("ft", "feet", "foot"), 0.3048),
        **dict.fromkeys(("in", "inch", "inches"), 0.0254),
    },
    "angle": {
        **dict.fromkeys(("deg", "degree", "degrees", "°"), 1.0),
        **dict.fromkeys(("rad", "radian", "radians"), 180.0 / math.pi),
    },
}

THRESHOLDS: dict[ThresholdSet, dict[Dimension, float]] = {
    "standard": {"time": 0.3, "speed": 1.0, "mass": 0.5, "length": 0.1, "angle": 5.0},
    "strict": {"time": 0.2, "speed": 0.5, "mass": 0.3, "length": 0.1, "angle": 5.0},
    "lenient": {"time": 0.5, "speed": 2.0, "mass": 1.0, "length": 0.1, "angle": 5.0},
}
"""Precision thresholds epsilon in base units (paper, PPA sensitivity table)."""


def unit_factor(quantity: str, unit: str | None) -> float:
    """Factor from `unit` to the base unit of `quantity`; None means the base unit.

    Raises:
        ValueError: If the unit is unknown or of another dimension, with the accepted ones.
    """
    dimension = DIMENSION_OF[quantity]
    if unit is None:
        return 1.0
    known = _UNITS[dimension]
    key = " ".join(str(unit).strip().split())
    for candidate in (key, key.lower(), key.lower().replace(" ", "")):
        if candidate in known:
            return known[candidate]
    short = [u for u in known if len(u) <= 4]
    other = next((d for d, units in _UNITS.items() if key.lower() in units), None)
    what = f"is a unit of {other}" if other else "is not a known unit"
    raise ValueError(f"{unit!r} {what}; {quantity} takes {', '.join(short)}")


def score(
    measured: float | None,
    value: float | None,
    interval: tuple[float, float] | None,
    dimension: Dimension,
    thresholds: ThresholdSet = "standard",
) -> float:
    """PPA score of one measurement in [0, 1] (paper, Supp. Mat., PPA score definition).

    A point constraint scores 1 within epsilon and max(0, 1 - (|x - x*| - epsilon) / |x*|) outside;
    an interval scores 1 inside and max(0, 1 - 2 excess / (b - a)) outside. A target of zero has no
    magnitude to normalise by: outside epsilon it scores 0.

    Args:
        measured: The measurement in base units; None (nothing measured) scores 0.
        value: Target of a point constraint, base units.
        interval: Bounds of an interval constraint, base units.
        dimension: Chooses epsilon.
        thresholds: Which epsilons.
    """
    if measured is None or not math.isfinite(measured):
        return 0.0
    if interval is not None:
        low, high = interval
        excess = max(0.0, low - measured, measured - high)
        if excess == 0.0:
            return 1.0
        return max(0.0, 1.0 - 2.0 * excess / (high - low)) if high > low else 0.0
    if value is None:
        return 0.0
    # The epsilon is inclusive; binary rounding of decimal values must not decide the tie.
    excess = abs(measured - value) - THRESHOLDS[thresholds][dimension]
    if excess <= 1e-9:
        return 1.0
    return max(0.0, 1.0 - excess / abs(value)) if value else 0.0
