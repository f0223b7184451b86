"""Units of measurement in English text: their names, and their sizes in cm, kg, s and degrees.

Each row of `data/units.csv` has a size in document units, what it measures, and names.
"""

from __future__ import annotations

from collections.abc import Container
import csv
import re
from typing import Literal, cast

from esg.draft import lexicon as lex
from esg.draft.text.alternatives import any_of

Dimension = Literal[
    "mass", "length", "time", "speed", "acceleration", "angle", "count", "volume", "other"
]


def _units() -> dict[str, tuple[Dimension, float]]:
    with open(lex.DATA / "units.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE))
    return {
        name: (cast(Dimension, row["dimension"]), float(row["size"]))
        for row in rows
        for name in row["names"].split("|")
    }


_UNITS = _units()
_NOT_PLAIN = frozenset({"in", '"', "”"})
"""Names of the inch that are words or marks, too."""


def _names(dimension: Dimension, *, without: Container[str] = ()) -> str:
    return any_of(u for u, (d, _) in _UNITS.items() if d == dimension and u not in without)


_LENGTH = _names("length", without=('"', "”"))
_SPEED_UNIT = (
    rf"(?:(?:{_LENGTH})\s*(?:/|per|a|an|each|every)\s*(?:{_names('time')})"
    r"|(?:m|cm|km|ft)(?:\s*[.·*]\s*|\s+)(?:s|h)\s*(?:\^\s*\(?-\s*1\)?|[-−]1|⁻¹)"
    rf"|{_names('speed')})"
)
_ACCEL_UNIT = (
    r"(?:(?:m|cm|ft|meters?|metres?|feet|foot)\s*(?:/|per)\s*(?:s|sec|second)"
    r"(?:\s*(?:\^\s*2|²|2\b|squared|(?:/|per)\s*(?:s\b|sec\b|second\b)))"
    r"|(?:m|cm|ft)(?:\s*[.·*]\s*|\s+)s\s*(?:\^\s*\(?-\s*2\)?|[-−]2|⁻²)"
    r"|m/s/s)"
)
_PLAIN_UNIT = any_of(u for u, (d, _) in _UNITS.items() if d != "speed" and u not in _NOT_PLAIN)
_INCHES = r"in(?=\s*(?:[.,;)]|$|tall|wide|long|high|deep|thick|in\s+diameter))"
UNIT = rf"(?:{_ACCEL_UNIT}|{_SPEED_UNIT}|{_PLAIN_UNIT}|{_INCHES}|\"|”)"
"""Any unit, as it may follow a number."""
LENGTH_UNIT = rf"(?:{_LENGTH})"


def unit_of(text: str) -> tuple[Dimension, float] | None:
    """Dimension of a unit and its size in document units; None for what is no unit."""
    t = re.sub(r"\s+", " ", text.lower().strip())
    power = re.fullmatch(r"(m|cm|km|ft)[\s.·*]+(s|h)[\s^(]*[-−⁻](1|¹|2|²)\)?", t)
    if power is not None:
        length, time = _UNITS[power[1]][1], _UNITS[power[2]][1]
        twice = power[3] in "2²"
        return ("acceleration", length / time**2) if twice else ("speed", length / time)
    if t in _UNITS:
        return _UNITS[t]
    ratio = re.fullmatch(
        r"(\D+?)\s*(?:/|\bper\b|\ban?\b|\beach\b|\bevery\b)\s*(\D+?)"
        r"(\s*(\^\s*2|²|2|squared|/.*|per .*))?",
        t,
    )
    if ratio is None:
        return None
    over, under = _UNITS.get(ratio[1].strip()), _UNITS.get(ratio[2].strip())
    if over is None or under is None or (over[0], under[0]) != ("length", "time"):
        return None
    if ratio[3]:
        return "acceleration", over[1] / under[1] ** 2
    return "speed", over[1] / under[1]
