"""Units of measurement in English text: their names, and their sizes in cm, kg, s and degrees."""

from __future__ import annotations

import re
from typing import Literal

Dimension = Literal[
    "mass", "length", "time", "speed", "acceleration", "angle", "count", "volume", "other"
]

_UNITS: dict[str, tuple[Dimension, float]] = {}


def _unit(dimension: Dimension, factor: float, *names: str) -> None:
    for name in names:
        _UNITS[name] = (dimension, factor)


_unit(
    "mass", 1.0, "kg", "kgs", "kilo", "kilos", "kilogram", "kilograms", "kilogramme", "kilogrammes"
)
_unit("mass", 1e-6, "mg", "milligram", "milligrams")
_unit("mass", 1e-3, "g", "gram", "grams", "gr", "gramme", "grammes")
_unit("mass", 0.45359237, "lb", "lbs", "pound", "pounds")
_unit("mass", 0.028349523, "oz", "ounce", "ounces")
_unit("mass", 1000.0, "ton", "tons", "tonne", "tonnes", "metric ton", "metric tons", "t")
_unit("mass", 50.80234544, "hundredweight", "cwt")
_unit("length", 10.0, "dm", "decimeter", "decimeters", "decimetre", "decimetres")
_unit("volume", 0.0284130625, "fl oz", "fluid ounce", "fluid ounces")
_unit("length", 0.1, "mm", "millimeter", "millimeters", "millimetre", "millimetres")
_unit("length", 1.0, "cm", "cms", "centimeter", "centimeters", "centimetre", "centimetres")
_unit("length", 100.0, "m", "meter", "meters", "metre", "metres")
_unit("length", 1e5, "km", "kilometer", "kilometers", "kilometre", "kilometres")
_unit("length", 30.48, "ft", "foot", "feet")
_unit("length", 2.54, "in", "inch", "inches")
_unit("length", 91.44, "yd", "yds", "yard", "yards")
_unit("length", 160934.4, "mile", "miles")
_unit("time", 1.0, "s", "sec", "secs", "second", "seconds")
_unit("time", 1e-3, "ms", "msec", "millisecond", "milliseconds")
_unit("time", 60.0, "min", "mins", "minute", "minutes")
_unit("time", 3600.0, "h", "hr", "hrs", "hour", "hours")
_unit("angle", 1.0, "deg", "degs", "degree", "degrees", "°")
_unit("angle", 57.29577951308232, "rad", "radian", "radians")
_unit("angle", 360.0, "revolution", "revolutions")
_unit("volume", 1.0, "l", "liter", "liters", "litre", "litres")
_unit("volume", 1e-3, "ml", "milliliter", "milliliters", "millilitre", "millilitres")
_unit("volume", 1e-2, "cl", "centiliter", "centiliters", "centilitre", "centilitres")
_unit("volume", 3.785411784, "gallon", "gallons")
_unit("volume", 0.473176473, "pint", "pints")
_unit("speed", 100.0, "mps", "m.s-1", "ms-1")
_unit("speed", 44.704, "mph")
_unit("speed", 100.0 / 3.6, "kph", "kmh", "kmph")
_unit("speed", 51.4444444, "knot", "knots", "kn", "kt", "kts")
_unit("speed", 30.48, "fps")
_unit("length", 75.0, "pace", "paces", "stride", "strides")
_unit("length", 450.0, "car length", "car lengths", "car's length")
_unit("length", 300.0, "storeys up", "floors up", "stories up")
_unit("mass", 100.0, "quintal", "quintals")
_unit("length", 20116.8, "furlong", "furlongs")
_unit(
    "other", 1.0, "rpm", "revs per minute", "revolutions per minute", "revs per second", "rev/s",
    "revolutions per second", "hz", "hertz", "newton", "newtons", "joule", "joules", "watt",
    "watts", "°c", "degrees celsius", "degrees fahrenheit", "bar of pressure", "psi", "rad/s",
    "degrees per second", "degrees a second", "deg/s", "°/s", "newton seconds",
)  # fmt: skip

_LENGTHS = [u for u, (d, _) in _UNITS.items() if d == "length" and u != "in"] + ["in"]
_TIMES = [u for u, (d, _) in _UNITS.items() if d == "time"]


def _alternatives(words: list[str]) -> str:
    return "|".join(re.escape(w) for w in sorted(words, key=len, reverse=True))


_SPEED_UNIT = (
    rf"(?:(?:{_alternatives(_LENGTHS)})\s*(?:/|per|a|an|each|every)\s*(?:{_alternatives(_TIMES)})"
    r"|(?:m|cm|km|ft)(?:\s*[.·*]\s*|\s+)(?:s|h)\s*(?:\^\s*\(?-\s*1\)?|[-−]1|⁻¹)"
    rf"|m\.s-1|ms-1|mps|mph|kph|kmph|kmh|fps|knots?|kts?|kn)"
)
_ACCEL_UNIT = (
    r"(?:(?:m|cm|ft|meters?|metres?|feet|foot)\s*(?:/|per)\s*(?:s|sec|second)"
    r"(?:\s*(?:\^\s*2|²|2\b|squared|(?:/|per)\s*(?:s\b|sec\b|second\b)))"
    r"|(?:m|cm|ft)(?:\s*[.·*]\s*|\s+)s\s*(?:\^\s*\(?-\s*2\)?|[-−]2|⁻²)"
    r"|m/s/s)"
)
_PLAIN_UNIT = _alternatives([u for u, (d, _) in _UNITS.items() if d != "speed" and u != "in"])
_INCHES = r"in(?=\s*(?:[.,;)]|$|tall|wide|long|high|deep|thick|in\s+diameter))"
UNIT = rf"(?:{_ACCEL_UNIT}|{_SPEED_UNIT}|{_PLAIN_UNIT}|{_INCHES}|\"|”)"
"""Any unit, as it may follow a number."""
LENGTH_UNIT = rf"(?:{_alternatives(_LENGTHS)})"


def unit_of(text: str) -> tuple[Dimension, float] | None:
    """Dimension of a unit and its size in document units; None for what is no unit."""
    t = re.sub(r"\s+", " ", text.lower().strip())
    if t in ('"', "”"):
        return "length", 2.54
    power = re.fullmatch(r"(m|cm|km|ft)[\s.·*]+(s|h)[\s^(]*[-−⁻](1|¹|2|²)\)?", t)
    if power is not None:
        length, time = _UNITS[power[1]][1], _UNITS[power[2]][1]
        twice = power[3] in "2²"
        return ("acceleration", length / time**2) if twice else ("speed", length / time)
    if t in _UNITS:
        return _UNITS[t]
    m = re.fullmatch(
        r"(\D+?)\s*(?:/|\bper\b|\ban?\b|\beach\b|\bevery\b)\s*(\D+?)"
        r"(\s*(\^\s*2|²|2|squared|/.*|per .*))?",
        t,
    )
    if not m:
        return None
    length, time = _UNITS.get(m.group(1).strip()), _UNITS.get(m.group(2).strip())
    if length is None or time is None or length[0] != "length" or time[0] != "time":
        return None
    if m.group(3):
        return "acceleration", length[1] / time[1] ** 2
    return "speed", length[1] / time[1]
