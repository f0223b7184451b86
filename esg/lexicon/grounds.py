"""What a prompt may say of the ground, and how well things hold on it: `grounds.csv`."""

from __future__ import annotations

from collections.abc import Callable
import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
import re

from esg.lexicon.cells import words
from esg.lexicon.kinds import kinds
from esg.lexicon.morphology import singular
from esg.lexicon.places import surfaces

TABLE = Path(__file__).parent / "grounds.csv"
_OTHERWISE = ("ground", "surface", "slope", "hill", "asphalt", "pitch")
"""What ground is called beside the kinds of it and what it is made of."""
_ON = r"\b(?:on|onto|over|across|along|through|in)\s+(?:(?:the|an?|some)\s+)?(?:[\w-]+\s+)?"
_DURING = r"\b(?:in|during|after|through|despite)\s+(?:(?:the|an?)\s+)?(?:[\w-]+\s+)?"

_BY_ITSELF = ("ing", "y")
"""Endings of words of weather that are no nouns: "raining", "a rainy day"."""


@dataclass(frozen=True)
class Ground:
    """One row.

    Args:
        name: Unique.
        said_as: Words before a noun of the ground ("a muddy track", "the gravel road").
        lies_as: What covers it ("on sand").
        weather: After which it is so outdoors; nouns after "in the" and the like.
        friction: Of the ground, for what slides on it; a pair has the mean of both.
        grip: Most friction that tyres, soles and hooves find.
        source: Where both are from.
    """

    name: str
    said_as: tuple[str, ...]
    lies_as: tuple[str, ...]
    weather: tuple[str, ...]
    friction: float
    grip: float
    source: str


@cache
def grounds() -> dict[str, Ground]:
    """The rows by name."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        return {
            row["name"]: Ground(
                name=row["name"],
                said_as=words(row["said_as"]),
                lies_as=words(row["lies_as"]),
                weather=words(row["weather"]),
                friction=float(row["friction"]),
                grip=float(row["grip"]),
                source=row["source"],
            )
            for row in csv.DictReader(file)
        }


def ground_said(text: str) -> list[tuple[str, int, int]]:
    """What a prompt says of its ground: names of rows, and where the words stand.

    "A wet floor sign" says nothing of a floor, and "a wet dog" nothing of the ground.
    """
    rows = _named(text, lambda row: (*row.said_as, *row.lies_as))
    return _found(text, {row.name: _of_ground(row) for row in rows})


def weather_said(text: str) -> list[tuple[str, int, int]]:
    """What a prompt says of the weather that its ground is under; see `ground_said`."""
    return _found(text, {r.name: _of_weather(r) for r in _named(text, lambda r: r.weather)})


def _named(text: str, said: Callable[[Ground], tuple[str, ...]]) -> list[Ground]:
    """The rows of which a word stands in the text: the patterns of all take 0.1 s to compile."""
    low = text.casefold()
    return [row for row in grounds().values() if any(w.casefold() in low for w in said(row))]


def _found(text: str, patterns: dict[str, re.Pattern[str]]) -> list[tuple[str, int, int]]:
    return [
        (name, m.start(), m.end())
        for name, pattern in patterns.items()
        for m in pattern.finditer(text)
        if not _of_a_thing(text[m.end() :])
    ]


@cache
def _of_ground(row: Ground) -> re.Pattern[str]:
    said, nouns = _any(row.said_as), _any(_nouns())
    ways = [rf"\b{said}\b(?:\s+and\s+[\w-]+|,?\s+[\w-]+)?\s+{nouns}\b"]
    ways += [rf"{_ON}{_any(row.lies_as)}\b"] if row.lies_as else []
    return re.compile("|".join(ways), re.IGNORECASE)


@cache
def _of_weather(row: Ground) -> re.Pattern[str]:
    alone = _any(tuple(w for w in row.weather if w.endswith(_BY_ITSELF)))
    named = _any(tuple(w for w in row.weather if not w.endswith(_BY_ITSELF)))
    return re.compile(rf"\b{alone}\b|{_DURING}{named}\b", re.IGNORECASE)


@cache
def _nouns() -> tuple[str, ...]:
    """What ground is called, in both numbers."""
    told = [w for k in kinds() if k.kind in ("ground", "water") for w in (k.name, *k.said_as)]
    made_of = [w for s in surfaces().values() for w in s.said_as]
    return tuple(sorted({f"{w}{s}" for w in (*told, *made_of, *_OTHERWISE) for s in ("", "s")}))


def _any(words: tuple[str, ...]) -> str:
    return f"(?:{'|'.join(map(re.escape, sorted(words, key=lambda w: (-len(w), w))))})"


@cache
def _things() -> frozenset[str]:
    """Last words of what is no ground: the "sign" of a warning sign."""
    told = ((k.name, *k.said_as) for k in kinds() if k.kind not in ("ground", "water", ""))
    return frozenset(name.rpartition(" ")[2] for names in told for name in names)


def _of_a_thing(rest: str) -> bool:
    """Whether a word is followed by the name of a thing: a sand castle, a road sign."""
    following = re.match(r"[\s-]+([a-z]+)", rest, re.IGNORECASE)
    return following is not None and singular(following[1].lower()) in _things()
