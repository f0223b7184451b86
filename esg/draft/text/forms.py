"""Quantities told otherwise than by a number and its unit: "knee height", "2 m by 1 m", "0:05"."""

from __future__ import annotations

from collections.abc import Callable, Iterator
import re

from esg.draft.text.amounts import Amount
from esg.draft.text.numerals import DIGITS, NUMBER, parse_number
from esg.draft.text.units import LENGTH_UNIT, Dimension, unit_of

_NAMED: tuple[tuple[Dimension, str, dict[str, tuple[float, float]], str], ...] = (
    ("speed", r"(?:a\s+)?", {
        "walking": (100.0, 180.0), "strolling": (70.0, 130.0), "jogging": (200.0, 330.0),
        "running": (250.0, 500.0), "sprinting": (500.0, 900.0), "crawling": (10.0, 50.0),
        "snail's": (5.0, 30.0),
    }, r"[\s-]+(?:pace|speed|tempo)"),
    ("length", "", {
        "ankle": (10.0, 10.0), "knee": (50.0, 50.0), "table": (75.0, 75.0), "desk": (75.0, 75.0),
        "waist": (100.0, 100.0), "hip": (95.0, 95.0), "chest": (130.0, 130.0),
        "shoulder": (145.0, 145.0), "eye": (160.0, 160.0), "head": (170.0, 170.0),
    }, r"[\s-](?:height|level)"),
    ("length", r"(?:an\s+)?", {"arm's": (70.0, 70.0)}, r"[\s-]length"),
    ("angle", r"(?:a\s+)?", {"right": (90.0, 90.0)}, r"[\s-]angles?"),
    ("angle", r"(?:(?:an?|one)\s+)?", {
        "quarter": (90.0, 90.0), "half": (180.0, 180.0), "three-quarter": (270.0, 270.0),
        "three quarters": (270.0, 270.0), "full": (360.0, 360.0), "complete": (360.0, 360.0),
    }, r"(?:\s+of)?(?:\s+an?)?[\s-]+turn"),
)  # fmt: skip
"""Words before, the word and what it stands for, words after. Speeds of gaits are those that adults
prefer [cm/s], heights those on their bodies and on furniture [cm].
"""
_TIMES = r"\s*(?:x|×|\*|by)\s*"
_SIDE = rf"{DIGITS}(?:[\s-]*{LENGTH_UNIT})?"
_SIDES = (
    rf"(?P<sides>{_SIDE}(?:{_TIMES}{_SIDE})?{_TIMES}{DIGITS}[\s-]*(?P<unit>{LENGTH_UNIT}))"
    r"(?![a-z0-9])"
)
_SECONDS = r"(?:\s*s(?:ec(?:onds?)?)?)?"
_CLOCK = (
    rf"\b(?:between\s+)?t\s*[=+]\s*(?P<low>{DIGITS}){_SECONDS}"
    rf"(?:\s+and\s+t\s*=\s*(?P<high>{DIGITS}){_SECONDS})?(?!\w|\.\d)"
)
_MINUTES = (
    r"(?<![\d:.])(?:at\s+)?(?P<big>0?\d):(?P<small>[0-5]\d(?:\.\d+)?)(?![\d:])"
    r"(?!\s*(?:scale|aspect|ratio|am\b|pm\b|a\.m|p\.m|o'clock))"
)
_TIME_OF_DAY = (
    r"(?<![\d:.])(?:(?:at|around|by|since|until)\s+(?:[01]?\d|2[0-3]):[0-5]\d(?![\d:])"
    r"(?:\s*(?:[ap]\.?m\b\.?|hours|hrs|h\b|o'clock))?"
    r"|(?:at\s+)?\d{1,2}(?:[:.][0-5]\d)?\s*(?:[ap]m\b|[ap]\.m\.|o'clock))"
)
_LONGEST_S = 300.0
"""Minutes and seconds after this are hours and minutes: no scene lasts that long."""
_FEET = (
    r"(?<![\w.])(?P<big>\d+)\s*['’′](?!\d{3})\s*(?P<small>(?:\d|1[01])(?:\.\d+)?)"
    r"\s*(?:\"|”|″|''|(?!\w))"
)
_PERIOD = (
    rf"\b(?:every|once\s+a|once\s+every|once\s+per)\s+(?:(?P<count>{NUMBER})\s*)?"
    r"(?P<unit>seconds?|minutes?)\b(?=\s*(?:[,.;]|$|an?\b|the\b|another\b|one\b|and\b))"
)
_LENGTH_BEFORE = re.compile(rf"(?:\d|\b){LENGTH_UNIT}\s+$", re.IGNORECASE)


def told_in_forms(text: str) -> Iterator[Amount]:
    """The quantities told in one of the forms, most particular forms first; they may overlap."""
    for pattern, read in _FORMS:
        for m in pattern.finditer(text):
            amount = read(m)
            if amount is not None:
                yield amount


def amount_of(
    m: re.Match[str], dimension: Dimension, low: float, high: float, measure: str = ""
) -> Amount:
    """A quantity that is all of a match."""
    return Amount(dimension, low, high, m.start(), m.end(), m.group().strip(), measure=measure)


def _named(
    dimension: Dimension, before: str, words: dict[str, tuple[float, float]], after: str
) -> tuple[re.Pattern[str], Callable[[re.Match[str]], Amount | None]]:
    pattern = rf"\b{before}(?P<word>{'|'.join(words)}){after}\b"
    return re.compile(pattern, re.I), lambda m: amount_of(m, dimension, *words[m["word"].lower()])


def _sides(m: re.Match[str]) -> Amount | None:
    """The lengths of the sides, in the order given."""
    found: list[float] = []
    for side in re.split(_TIMES, m["sides"], flags=re.IGNORECASE):
        part = re.fullmatch(rf"({DIGITS})[\s-]*(.*)", side.strip(), re.IGNORECASE)
        unit = unit_of((part[2] if part is not None else "") or m["unit"])
        value = parse_number(part[1]) if part is not None else None
        if unit is None or not isinstance(value, float):
            return None
        found.append(value * unit[1])
    largest = max(found)
    text = m.group().strip()
    return Amount("length", largest, largest, m.start(), m.end(), text, sides=tuple(found))


def _clock(m: re.Match[str]) -> Amount:
    """An instant, or two, on the scene's clock."""
    low, high = (float(x.replace(",", "")) for x in (m["low"], m["high"] or m["low"]))
    return amount_of(m, "time", low, high, "start")


def _minutes(m: re.Match[str]) -> Amount | None:
    """An instant as minutes and seconds; nothing where it is a time of day."""
    at = 60.0 * float(m["big"]) + float(m["small"])
    return amount_of(m, "time", at, at, "start") if at <= _LONGEST_S else None


def _time_of_day(m: re.Match[str]) -> Amount:
    """ "At 09:15": no event of a scene has it."""
    return amount_of(m, "other", 0.0, 0.0)


def _feet(m: re.Match[str]) -> Amount:
    """Feet and inches."""
    cm = 30.48 * float(m["big"]) + 2.54 * float(m["small"])
    return amount_of(m, "length", cm, cm)


def _period(m: re.Match[str]) -> Amount | None:
    """The time after which something recurs; "six metres every second" is a speed."""
    count, unit = parse_number(m["count"] or "a"), unit_of(m["unit"])
    if unit is None or not isinstance(count, float) or _LENGTH_BEFORE.search(m.string[: m.start()]):
        return None
    return amount_of(m, "time", count * unit[1], count * unit[1], "period")


_FORMS = (
    (re.compile(_SIDES, re.I), _sides),
    (re.compile(_CLOCK, re.I), _clock),
    (re.compile(_MINUTES, re.I), _minutes),
    (re.compile(_TIME_OF_DAY, re.I), _time_of_day),
    (re.compile(_FEET, re.I), _feet),
    *(_named(*row) for row in _NAMED),
    (re.compile(_PERIOD, re.I), _period),
)
