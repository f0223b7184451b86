"""Quantities told without a number and its unit side by side: "a second or two", "chest height".

Also what follows a quantity and bounds it ("or more", "tops"), and numbers whose unit stands with
another one of the same sentence ("one at 3 and the other at 5 m/s").
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
import re
from typing import Literal

from esg.draft.text.numerals import NUMBER, parse_number
from esg.draft.text.units import LENGTH_UNIT, UNIT, Dimension, unit_of

Bound = Literal["min", "max"] | None


@dataclass(frozen=True)
class Worded:
    """A quantity in words.

    Args:
        dimension: What it measures.
        low, high: Document units (cm, kg, s, degrees, cm/s).
        start, end: Character span in the prompt.
        bound: "min" or "max" where one side is open.
        measure: "start" for a time on the scene's clock, "period" for what recurs.
    """

    dimension: Dimension
    low: float
    high: float
    start: int
    end: int
    bound: Bound = None
    measure: str = ""


_PACES = {
    "walking": (100.0, 180.0), "strolling": (70.0, 130.0), "jogging": (200.0, 330.0),
    "running": (250.0, 500.0), "sprinting": (500.0, 900.0), "crawling": (10.0, 50.0),
    "snail's": (5.0, 30.0),
}  # fmt: skip
"""Speeds [cm/s] that gaits stand for (preferred speeds of adults)."""
_LEVELS = {
    "ankle": 10.0, "knee": 50.0, "table": 75.0, "desk": 75.0, "waist": 100.0, "hip": 95.0,
    "chest": 130.0, "shoulder": 145.0, "eye": 160.0, "head": 170.0,
}  # fmt: skip
"""Heights [cm] on an adult's body and on furniture."""
_PACE = re.compile(
    rf"\b(?:a\s+)?(?P<gait>{'|'.join(_PACES)})[\s-]+(?:pace|speed|tempo)\b", re.IGNORECASE
)
_LEVEL = re.compile(rf"\b(?P<level>{'|'.join(_LEVELS)})[\s-](?:height|level)\b", re.IGNORECASE)
_ARM = re.compile(r"\b(?:an\s+)?arm's[\s-]length\b", re.IGNORECASE)
_OR_TWO = re.compile(
    r"\ban?\s+(?P<unit>second|minute|metre|meter|kilo|foot|yard|inch|tonne|ton|pound)"
    r"\s+or\s+(?P<more>two|three|so)\b",
    re.IGNORECASE,
)
_RIGHT_ANGLE = re.compile(r"\b(?:a\s+)?right[\s-]angles?\b", re.IGNORECASE)
_CLOSE = re.compile(r"(?<![\w.])(?P<m>\d)m(?P<cm>\d\d)(?!\w)")
_MIN_SEC = re.compile(
    r"(?<![\w.])(?P<min>\d)\s*min(?:utes?)?\s+(?P<sec>\d{1,2})(?=\s*[,.;]|\s+(?:in|into|later)\b|$)",
    re.IGNORECASE,
)
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth",
             "tenth")  # fmt: skip
_NTH_SECOND = re.compile(
    rf"\b(?P<prep>(?:not\s+)?(?:before|until)|in|during|within|after|by)\s+the\s+"
    rf"(?P<nth>{'|'.join(_ORDINALS)})\s+second\b(?=\s*(?:[,.;]|$|do\b|does\b|the\b|an?\b|it\b|of\b))",
    re.IGNORECASE,
)
_NTH = rf"(?:{'|'.join(_ORDINALS)}|\d+(?:st|nd|rd|th))"
_BETWEEN_NTH = re.compile(
    rf"\b(?:some(?:time|where)\s+)?between\s+the\s+(?P<lo>{_NTH})(?:\s+second)?\s+and\s+(?:the\s+)?"
    rf"(?P<hi>{_NTH})\s+seconds?\b",
    re.IGNORECASE,
)
_EVERY = re.compile(
    rf"\b(?:every|once\s+a|once\s+every|once\s+per)\s+(?:(?P<n>{NUMBER})\s*)?"
    r"(?P<unit>s|seconds?|minutes?)\b(?=\s*(?:[,.;]|$|an?\b|the\b|another\b|one\b|and\b))",
    re.IGNORECASE,
)
_LENGTH_BEFORE = re.compile(rf"(?:\d|\b){LENGTH_UNIT}\s+$", re.IGNORECASE)
_TRAILING = re.compile(
    r",?\s+(?:(?P<min>or\s+(?:more|faster|longer|heavier|above|later|higher|further)|and\s+up"
    r"|at\s+(?:the\s+(?:very\s+)?)?least|upwards|minimum)"
    r"|(?P<max>or\s+(?:less|under|slower|below|lower|shorter|fewer|sooner|earlier|lighter)"
    r"|at\s+(?:the\s+(?:very\s+)?)?most|tops|maximum|max)|(?P<near>or\s+so|or\s+thereabouts|-?ish|flat|sharp))"
    rf"(?![\w-])(?!\s+(?:{NUMBER})[\s-]*(?:{UNIT})(?![a-z0-9]))",
    re.IGNORECASE,
)
"""What stands behind a quantity and leaves a side open; not what bounds the next one."""
_BARE = re.compile(
    rf"\b(?P<lead>at|doing|does|weighs?|weighing|by)\s+(?:about\s+|only\s+)?(?P<lo>{NUMBER})"
    r"(?=\s*(?:[,.;:!?)]|$|and\b|but\b|while\b|until\b|when\b|or\b))(?!\.\d)",
    re.IGNORECASE,
)
"""A number that ends its phrase and has no unit."""
_LISTED = re.compile(
    rf"(?<![\w.])(?P<list>{NUMBER}(?:\s*,\s*{NUMBER})*)\s*,?\s*(?:and|&)\s*$", re.IGNORECASE
)
_LEADING = re.compile(
    r"(?:\b(?:at|of|with|weigh|weighs|weighing|mass|masses|speeds?|velocit(?:y|ies)|radi(?:us|i)"
    r"|diameters?|heights?|lengths?|widths?|are|is|about|from|after)|[:(=])\s*$",
    re.IGNORECASE,
)
_NAMED_BARE = re.compile(
    rf",\s+(?:and\s+)?(?:the|an?)\s+(?:\w+\s+){{1,2}}(?P<lo>{NUMBER})(?=\s*(?:[.;]|$))",
    re.IGNORECASE,
)
""" "ball A weighs 2 kg, the other 3."."""


def worded(text: str) -> Iterator[Worded]:
    """Quantities in words.

    Args:
        text: The prompt.

    Yields:
        Each with its span; they may overlap quantities with units, which they then include.
    """
    for m in _PACE.finditer(text):
        low, high = _PACES[m["gait"].lower()]
        yield Worded("speed", low, high, m.start(), m.end())
    for m in _LEVEL.finditer(text):
        at = _LEVELS[m["level"].lower()]
        yield Worded("length", at, at, m.start(), m.end())
    for m in _ARM.finditer(text):
        yield Worded("length", 70.0, 70.0, m.start(), m.end())
    for m in _OR_TWO.finditer(text):
        unit = unit_of(m["unit"])
        more = {"two": 2.0, "three": 3.0, "so": 1.0}[m["more"].lower()]
        if unit is not None:
            yield Worded(unit[0], unit[1], more * unit[1], m.start(), m.end())
    for m in _RIGHT_ANGLE.finditer(text):
        yield Worded("angle", 90.0, 90.0, m.start(), m.end())
    for m in _CLOSE.finditer(text):
        cm = 100.0 * float(m["m"]) + float(m["cm"])
        yield Worded("length", cm, cm, m.start(), m.end())
    for m in _MIN_SEC.finditer(text):
        at = 60.0 * float(m["min"]) + float(m["sec"])
        yield Worded("time", at, at, m.start(), m.end())
    yield from _between_nth(text)
    yield from _nth_second(text)
    for m in _EVERY.finditer(text):
        count = parse_number(m["n"]) if m["n"] else 1.0
        unit = unit_of(m["unit"])
        rate = _LENGTH_BEFORE.search(text, 0, m.start()) is not None  # "six metres every second"
        if unit is not None and isinstance(count, float) and not rate and m["unit"] != "s":
            period = count * unit[1]
            yield Worded("time", period, period, m.start(), m.end(), measure="period")


def _nth_second(text: str) -> Iterator[Worded]:
    """ "in the third second" lies between 2 and 3 s; "not before the third second" is later."""
    for m in _NTH_SECOND.finditer(text):
        n = _ORDINALS.index(m["nth"].lower()) + 1.0
        prep = " ".join(m["prep"].lower().split())
        at = m.start()
        if prep.startswith("not"):
            yield Worded("time", n, n, at, m.end(), "min", "start")
        elif prep in ("before", "until"):
            yield Worded("time", n, n, at, m.end(), "max", "start")
        elif prep == "after":
            yield Worded("time", n, n, at, m.end(), None, "start")
        elif prep == "by":
            yield Worded("time", n, n, at, m.end(), "max", "start")
        elif n > 1.0:
            yield Worded("time", n - 1.0, n, at, m.end(), None, "start")


def _between_nth(text: str) -> Iterator[Worded]:
    """ "between the second and the third second": from 2 to 3 s."""

    def number(word: str) -> float:
        return float(_ORDINALS.index(word) + 1 if word in _ORDINALS else word[:-2])

    for m in _BETWEEN_NTH.finditer(text):
        low, high = sorted((number(m["lo"].lower()), number(m["hi"].lower())))
        yield Worded("time", low, high, m.start(), m.end(), None, "start")


def bounded(text: str, at: int) -> tuple[int, Bound] | None:
    """What stands behind a quantity and bounds it.

    Args:
        text: The prompt.
        at: Where the quantity ends.

    Returns:
        Where its words end, and the bound ("or so" has none); None if nothing is there.
    """
    m = _TRAILING.match(text, at)
    if m is None:
        return None
    return m.end(), "min" if m["min"] else "max" if m["max"] else None


def without_unit(text: str, known: list[tuple[Dimension, int, int, float]]) -> Iterator[Worded]:
    """Numbers that share the unit of another quantity: "the first at 3, the second at 5 m/s".

    Args:
        text: The prompt.
        known: Dimension, span and unit (its size in document units) of the quantities found.
    """
    listed: list[tuple[Dimension, int, int, float]] = []
    for dimension, start, _, factor in known:
        for value, lo, hi in _before(text, start):
            if not any(s < hi and lo < e for _, s, e, _ in known):
                yield Worded(dimension, value * factor, value * factor, lo, hi)
                listed.append((dimension, lo, hi, factor))
    known = [*known, *listed]
    for m in _BARE.finditer(text):
        lead = m["lead"].lower()
        wanted = "mass" if lead.startswith("weigh") else "speed"
        if lead == "by":
            wanted = "angle"
        yield from _like(text, m, wanted, known)
    for m in _NAMED_BARE.finditer(text):
        sentence = text.rfind(".", 0, m.start()) + 1
        before = [k for k in known if sentence <= k[1] < m.start()]
        if len(before) == 1 and before[0][0] in ("mass", "speed"):
            yield from _like(text, m, before[0][0], known)


def _before(text: str, at: int) -> list[tuple[float, int, int]]:
    """The numbers of "1, 2 and 3 kg" in front of its last one, with their spans."""
    m = _LISTED.search(text, max(0, text.rfind(".", 0, max(at - 12, 0))), at)
    if m is None:
        return []
    several = m["list"].count(",") > 0 or m["list"].count(" and ") > 0
    if not several and not _LEADING.search(text, 0, m.start("list")):
        return []  # "car 1 and 2 m/s"
    numbers = [
        (parse_number(n.group()), n.start(), n.end())
        for n in re.compile(NUMBER, re.IGNORECASE).finditer(text, *m.span("list"))
    ]
    return [(x, s, e) for x, s, e in numbers if isinstance(x, float) and x > 0.0]


def _like(
    text: str, m: re.Match[str], wanted: str, known: list[tuple[Dimension, int, int, float]]
) -> Iterator[Worded]:
    value = parse_number(m["lo"])
    start, end = m.span("lo")
    if not isinstance(value, float) or value <= 0.0 or m["lo"].lower() in ("a", "an", "one"):
        return
    if any(s < end and start < e for _, s, e, _ in known):
        return
    fit = [k for k in known if k[0] == wanted]
    if not fit:
        return
    dimension, _, _, factor = min(fit, key=lambda k: abs(k[1] - start))
    yield Worded(dimension, value * factor, value * factor, start, end)
