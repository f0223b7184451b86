"""Numbers and physical quantities in English text, in document units (cm, kg, s, degrees).

Quantities are found before anything else: their words ("in", "second", "m") would otherwise be read
as prepositions, ordinals and nouns.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
import re
from typing import Literal

from esg.draft.text.measures import product, suffix
from esg.draft.text.numerals import DIGITS, NUMBER, WORD_NUMBER, parse_number
from esg.draft.text.quantity_words import Worded, bounded, without_unit, worded
from esg.draft.text.units import LENGTH_UNIT, UNIT, Dimension, unit_of

_GAP = r"[\s-]*"
_TO = r"\s*(?:~|–|—|-|\.\.+|…|to\b|or\b)\s*"
_VAGUELY = r"(?:\s*-?ish\b|\s+or\s+so\b|[\s-]+odd\b|(?<=\d)\s+of\s+an?\b)?"
"""Between a number and its unit: "3ish seconds", "2/3 of a second"."""
_JUST = r"(?:just|slightly|a (?:little|bit|shade|touch|tad))"
_APPROX = (
    rf"(?:(?<![A-Za-z])(?P<approx>{_JUST} (?:under|over|below|above|more than|less than)"
    r"|over the (?:course|space) of|(?:in|within) the (?:course|space) of|as (?:much|little|fast"
    r"|slow|high|heavy|far) as|close on|c\.|ca\.|about|around"
    r"|roughly|approximately|approx\.?|nearly|almost|some"
    r"|circa|~|≈|exactly|precisely|just|only|all of|a mere|a full|a good|a whole|no fewer than"
    r"|close to|more or less|barely)\s*)?"
)
_BOUND = (
    r"(?:(?P<bound>not over|not above|no higher than|not under|not below|upwards? of|inside(?: of)?"
    r"|in excess of"
    r"|north of|at least|no less than|not less than|more than|greater than|faster than|over"
    r"|above|no faster than|not faster than|no earlier than|not earlier than|no sooner than"
    r"|not before|no slower than|not slower than|a maximum of|a minimum of|at most"
    r"|no more than|not more than|less than|fewer than|slower than|under|below|up to"
    r"|no later than|not later than|not after"
    r"|(?:(?:with)?in|during|for) the (?:very )?first|not exceeding"
    r"|within|in under|in less than|exceeding|max\.?|min\.?|maximum|minimum|[<>≤≥]=?)\s*\b)?"
)
_PLUS_MINUS = r"(?:±|\+/-|\+-|plus or minus|plus/minus|,?\s*give or take)"
_PATTERN = re.compile(
    rf"(?:\b(?:time|speed|mass|[a-zA-Z](?:_?[0-9a-zA-Z])?)\s*=\s*)?{_BOUND}{_APPROX}"
    rf"(?P<between>between\s+|from\s+)?"
    rf"(?P<lo>{NUMBER})"
    rf"(?:{_GAP}(?P<unit1>{UNIT})?(?:{_TO}|(?(between)\s*and\s*|(?!)))(?P<hi>{NUMBER}))?"
    rf"(?P<plus>\+)?{_VAGUELY}(?:{_GAP}(?P<unit>{UNIT}))(?![a-z0-9])"
    rf"(?:\s*\(?\s*{_PLUS_MINUS}\s*(?P<tol>{DIGITS})\s*(?:(?P<percent>%|percent\b)|{UNIT})?"
    rf"(?![a-z0-9])\)?)?",
    re.IGNORECASE,
)
_TOLERANCE_FIRST = re.compile(
    rf"(?P<lo>{DIGITS})\s*{_PLUS_MINUS}\s*(?P<tol>{DIGITS})\s*(?P<unit>{UNIT})(?![a-z0-9])",
    re.IGNORECASE,
)
_TURNED = re.compile(
    r"\b(?:an?\s+)?(?P<share>quarter|half|full|three[- ]quarters?|complete)"
    r"(?:\s+of)?(?:\s+an?)?[\s-]+turn\b",
    re.IGNORECASE,
)
"""A turn by a share of the circle."""
_TURNS = {"quarter": 90.0, "half": 180.0, "full": 360.0, "complete": 360.0}
_CLOCK = re.compile(
    rf"\b(?:between\s+)?t\s*[=+]\s*(?P<lo>{DIGITS})(?:\s*s(?:ec(?:onds?)?)?)?"
    rf"(?:\s+and\s+t\s*=\s*(?P<hi>{DIGITS})(?:\s*s(?:ec(?:onds?)?)?)?)?(?!\w|\.\d)",
    re.IGNORECASE,
)
"""An instant, or two, on the scene's clock."""
_MINUTES = re.compile(
    r"(?<![\d:.])(?:at\s+)?(?P<min>\d{1,2}):(?P<sec>[0-5]\d(?:\.\d+)?)(?![\d:])"
    r"(?!\s*(?:scale|aspect|ratio|am\b|pm\b|a\.m|p\.m|o'clock))",
    re.IGNORECASE,
)
"""An instant as minutes and seconds ("00:03")."""
_FEET = re.compile(
    rf"(?<![\w.])(?P<ft>\d+)\s*(?:['’′](?!\d{{3}})\s*(?P<in>\d+(?:\.\d+)?)\s*(?:\"|”|″|''|(?!\w))"
    rf"|(?:ft|foot|feet)\.?\s+(?P<in2>\d+)(?=\s+(?:tall|high|long|wide|in\b)|\s*[.,;]|$)(?:\s+in\b)?)"
    rf"|\b(?P<wft>{WORD_NUMBER})[\s-]foot[\s-](?P<win>one|two|three|four|five|six|seven|eight|nine|ten"
    rf"|eleven)\b(?![\s-]*(?:{UNIT}))",
    re.IGNORECASE,
)
"""Feet and inches: 6'2", 6 ft 2, five foot six."""
_STONE = re.compile(
    rf"(?:\b(?P<weighs>weigh\w*\s+(?:about\s+)?))(?P<lo>{NUMBER})\s+stones?\b"
    rf"|\b(?P<lo2>{NUMBER})-stone\b(?!-)",
    re.IGNORECASE,
)
_METRE_AND = re.compile(
    rf"\b(?P<m>{NUMBER})\s*(?:m|metres?|meters?)\s+(?P<cm>[1-9]\d|(?:twenty|thirty|forty|fifty|sixty"
    rf"|seventy|eighty|ninety)(?:[- ]five)?)\b(?!\s*(?:{UNIT})|\s+\w+s\b)",
    re.IGNORECASE,
)
""" "one metre twenty"."""
_BOTH_BOUNDS = re.compile(
    r"\b(?:at least|no less than|more than|over|above|after|not before"
    rf"|(?:no|not) (?:earlier|sooner) than)\s+(?P<lo>{NUMBER})[\s-]*(?:{UNIT})?"
    r",?\s*(?:but|and|yet)\s+(?:at most|no more than|not more than|less than|under|below|up to"
    r"|not over|not above|not after|before|(?:no|not) later than)"
    rf"\s+(?P<hi>{NUMBER})[\s-]*(?P<unit>{UNIT})?(?![a-z0-9])",
    re.IGNORECASE,
)
_AND_A_HALF = re.compile(
    r"\s+and\s+a\s+(half|quarter)\b(?!-)(?!\s+(?:of\s+an?\b|full|empty|eaten|open))", re.IGNORECASE
)
_SMALLER = re.compile(
    rf"\s+(?:and\s+)?(?P<more>{NUMBER})[\s-]*(?P<unit>{UNIT})(?![a-z0-9])", re.IGNORECASE
)
"""The rest of "6 feet 2 inches", "1 min 30 s"."""
_PRODUCT = product(DIGITS, LENGTH_UNIT)
_DELAY = re.compile(
    r"(?:\b(?:(?P<with>with)|(?P<over>over|through(?:out)?))\s+)?\b(?:an?|the)\s+(?:(?:further|total|short|brief|additional)\s+)?"
    r"(?:delay|pause|gap|interval|lag|wait|period|duration|stretch|span)\s+of\s+$",
    re.IGNORECASE,
)
""" "after a delay of", "over a period of": words that only say that a time follows."""
_SPEEDING = re.compile(r"\b(?:speed|speeds|sped|speeding|goes|going|accelerat\w+)\s+$", re.I)
_LOW_BOUNDS = (
    "at least", "no less", "not less", "no slower", "not slower", "a minimum", "min", ">", "≥",
    "more than", "greater", "faster", "over", "above", "no earlier", "not earlier", "no sooner",
    "not before", "exceeding", "not under", "not below", "upward", "in excess", "north",
)  # fmt: skip


@dataclass(frozen=True)
class Amount:
    """A physical quantity of the prompt.

    Args:
        dimension: What it measures.
        low, high: Document units (cm, kg, s, degrees, cm/s, cm/s^2); equal for a point value.
        start, end: Character span in the prompt.
        text: The span's text.
        bound: "min" or "max" for one-sided statements ("at least 3 s"), else None.
        measure: What its words say it measures: diameter, side, start ("2 s after the start").
        sides: Lengths of the sides where several are given ("20 x 30 x 40 cm").
        shares: The values of a list that is one quantity ("1 kg, 2 kg and 3 kg").
    """

    dimension: Dimension
    low: float
    high: float
    start: int
    end: int
    text: str
    bound: Literal["min", "max"] | None = None
    measure: str = ""
    sides: tuple[float, ...] = ()
    shares: tuple[Amount, ...] = ()

    @property
    def value(self) -> float | tuple[float, float]:
        """A number, or the interval (low, high)."""
        return self.low if self.low == self.high else (self.low, self.high)

    @property
    def middle(self) -> float:
        return 0.5 * (self.low + self.high)


def find_amounts(text: str) -> list[Amount]:
    """All quantities with units in `text`, left to right, not overlapping."""
    return list(_found(text))


@lru_cache(maxsize=4)
def _found(text: str) -> tuple[Amount, ...]:
    """The quantities of the last few texts, which several steps of a draft ask for."""
    taken: list[tuple[int, int]] = []
    out: list[Amount] = []
    special = [(m, _sides(m)) for m in _PRODUCT.finditer(text)]
    special += [(m, _share_of_turn(m)) for m in _TURNED.finditer(text)]
    special += [(m, _on_the_clock(m)) for m in _CLOCK.finditer(text)]
    special += [(m, _between_bounds(m)) for m in _BOTH_BOUNDS.finditer(text)]
    special += [(m, _minutes(m)) for m in _MINUTES.finditer(text)]
    special += [(m, _feet(m)) for m in _FEET.finditer(text)]
    special += [(m, _stone(m)) for m in _STONE.finditer(text)]
    special += [(m, _metre_and(m)) for m in _METRE_AND.finditer(text)]
    for m, amount in special:
        if amount is not None and not any(m.start() < e and s < m.end() for s, e in taken):
            out.append(amount)
            taken.append((amount.start, amount.end))
    for w in worded(text):
        if not any(w.start < e and s < w.end for s, e in taken):
            out.append(_of_words(w, text))
            taken.append((w.start, w.end))
    for pattern in (_TOLERANCE_FIRST, _PATTERN):
        position = 0
        while (m := pattern.search(text, position)) is not None:
            amount = None
            if not any(m.start() < e and s < m.end() for s, e in taken):
                amount = _amount(m)
            if amount is None:
                position = m.start("lo") + 1
                if text[position - 1].isalnum():
                    while position < len(text) and text[position].isalnum():
                        position += 1
                continue
            out.append(amount)
            taken.append((amount.start, amount.end))
            position = m.end()
    known: list[tuple[Dimension, int, int, float]] = [
        (a.dimension, a.start, a.end, _unit_size(a)) for a in out
    ]
    out += [_of_words(w, text) for w in without_unit(text, known)]
    return tuple(sorted(out, key=lambda a: a.start))


def _of_words(w: Worded, text: str) -> Amount:
    return Amount(
        w.dimension, w.low, w.high, w.start, w.end, text[w.start : w.end], w.bound, w.measure
    )


def _unit_size(a: Amount) -> float:
    """Size of the unit that a quantity is told in, in document units."""
    told = re.findall(rf"(?:\d|\s|-)({UNIT})(?![a-z0-9])", a.text, re.IGNORECASE)
    units = [u for u in map(unit_of, told) if u is not None and u[0] == a.dimension]
    return units[-1][1] if units else 1.0


def _amount(m: re.Match[str]) -> Amount | None:
    groups = m.groupdict()
    unit = unit_of(groups["unit"])
    low = parse_number(groups["lo"])
    if unit is None or low is None:
        return None
    dimension, factor = unit
    if groups["unit"].lower() == "t" and re.match(r"T|t[-']", m.string[m.start("unit") :]):
        return None  # "2 T-shirts"
    start = m.start()
    delay = _DELAY.search(m.string, max(0, start - 40), start) if dimension == "time" else None
    lo_word = groups["lo"].strip().lower()
    if lo_word in ("a", "an") and not _article_counts(m, groups["unit"], dimension):
        return None
    low_a, low_b = low if isinstance(low, tuple) else (low, low)
    if groups.get("hi"):
        high = parse_number(groups["hi"])
        if high is None:
            return None
        unit1 = unit_of(groups["unit1"]) if groups.get("unit1") else unit
        if unit1 is None or unit1[0] != dimension:
            return None
        a = low_a * unit1[1]
        b = (high[1] if isinstance(high, tuple) else high) * factor
        low_a, low_b = min(a, b), max(a, b)
    else:
        low_a, low_b = low_a * factor, low_b * factor
    if groups.get("tol"):
        told = parse_number(str(groups["tol"]))
        share = 0.01 * low_b if groups.get("percent") else factor
        tolerance = told * share if isinstance(told, float) else 0.0
        low_a, low_b = low_a - tolerance, low_b + tolerance
    if groups.get("between") and not groups.get("hi"):
        start = m.start("lo")  # a lone "from" is a preposition
    bound: Literal["min", "max"] | None = None
    word = (groups.get("bound") or "").lower()
    half = _AND_A_HALF.match(m.string, m.end())
    if half is not None and low_a == low_b:  # "a second and a half"
        low_a = low_b = low_a + (0.5 if half[1].lower() == "half" else 0.25) * factor
    end = half.end() if half is not None else m.end()
    more = _SMALLER.match(m.string, end) if half is None and low_a == low_b else None
    part = unit_of(more["unit"]) if more is not None else None
    if more is not None and part is not None and part[0] == dimension and part[1] < factor:
        extra = parse_number(more["more"])
        low_a = low_b = low_a + (extra if isinstance(extra, float) else 0.0) * part[1]
        end = more.end()
    end, measure = suffix(m.string, end, dimension)
    if word == "over" and measure == "start":
        start, word = m.start("lo"), ""  # "is bowled over 2.5 s in"
    if word == "up to" and _SPEEDING.search(m.string[: m.start()]):
        start, word = m.start("lo"), ""  # "speeds up to 14 m/s": reaches it
    if word and not groups.get("hi"):
        bound = "min" if word.startswith(_LOW_BOUNDS) else "max"
    if word.endswith("the first"):
        measure = "start"
    if delay is not None and not word:
        start, measure = delay.start(), "later" if delay["with"] else measure
    if groups.get("plus") and bound is None:
        bound = "min"
    open_side = bounded(m.string, end)
    if open_side is not None and low_a == low_b:
        end, bound = open_side[0], bound or open_side[1]
    return Amount(dimension, low_a, low_b, start, end, m.string[start:end].strip(), bound, measure)


def _share_of_turn(m: re.Match[str]) -> Amount:
    word = m["share"].lower()
    degrees = 270.0 if word.startswith("three") else _TURNS[word]
    return Amount("angle", degrees, degrees, m.start(), m.end(), m.group())


def _on_the_clock(m: re.Match[str]) -> Amount:
    low = float(m["lo"].replace(",", ""))
    high = float(m["hi"].replace(",", "")) if m["hi"] else low
    return Amount("time", low, high, m.start(), m.end(), m.group(), measure="start")


def _minutes(m: re.Match[str]) -> Amount | None:
    at = 60.0 * float(m["min"]) + float(m["sec"])
    if int(m["min"]) > 9:
        return None  # a time of day, a ratio
    return Amount("time", at, at, m.start(), m.end(), m.group(), measure="start")


def _feet(m: re.Match[str]) -> Amount | None:
    feet = parse_number(m["ft"] or m["wft"])
    inches = parse_number(m["in"] or m["in2"] or m["win"])
    if not isinstance(feet, float) or not isinstance(inches, float) or inches >= 12.0:
        return None
    cm = 30.48 * feet + 2.54 * inches
    return Amount("length", cm, cm, m.start(), m.end(), m.group().strip())


def _stone(m: re.Match[str]) -> Amount | None:
    count = parse_number(m["lo"] or m["lo2"])
    if not isinstance(count, float):
        return None
    start = m.start("lo") if m["lo"] else m.start("lo2")
    kg = 6.35029318 * count
    return Amount("mass", kg, kg, start, m.end(), m.string[start : m.end()])


def _metre_and(m: re.Match[str]) -> Amount | None:
    metres, rest = parse_number(m["m"]), parse_number(m["cm"])
    if not isinstance(metres, float) or not isinstance(rest, float):
        return None
    cm = 100.0 * metres + rest
    return Amount("length", cm, cm, m.start(), m.end(), m.group().strip())


def _between_bounds(m: re.Match[str]) -> Amount | None:
    """ "at least 6 m/s but not more than 8": an interval."""
    inner = re.search(rf"({NUMBER})[\s-]*({UNIT})", m.group(), re.IGNORECASE)
    unit = unit_of(m["unit"] or (inner[2] if inner is not None else ""))
    low, high = parse_number(m["lo"]), parse_number(m["hi"])
    if unit is None or not isinstance(low, float) or not isinstance(high, float):
        return None
    a, b = sorted((low * unit[1], high * unit[1]))
    return Amount(unit[0], a, b, m.start(), m.end(), m.group().strip())


def _sides(m: re.Match[str]) -> Amount | None:
    """ "20 x 30 x 40 cm": the lengths of the sides, in the order given."""
    unit = unit_of(m["unit"])
    if unit is None:
        return None
    found: list[float] = []
    for one in re.split(r"\s*(?:x|×|\*|by)\s*", m["sides"], flags=re.IGNORECASE):
        part = re.fullmatch(rf"({DIGITS})[\s-]*(.*)", one.strip(), re.IGNORECASE)
        own = unit_of(part[2]) if part is not None and part[2] else unit
        if part is None or own is None:
            return None
        value = parse_number(part[1])
        found.append((value if isinstance(value, float) else 0.0) * own[1])
    largest = max(found)
    return Amount(
        "length", largest, largest, m.start(), m.end(), m.group().strip(), sides=tuple(found)
    )


def _article_counts(m: re.Match[str], unit: str, dimension: Dimension) -> bool:
    """Whether "a <unit>" is a quantity ("after a second") and not a noun ("a second car")."""
    if dimension == "time" and re.match(r"\s+of\s+\w+ing\b", m.string[m.end() :]):
        return True  # "within a second of leaving the hand"
    if dimension == "mass" and _AND_A_HALF.match(m.string, m.end()):
        return True
    if dimension not in ("time", "length"):
        return False
    if len(unit.strip()) < 3:
        return False
    if _AND_A_HALF.match(m.string, m.end()):
        return True  # "a metre and a half"
    if unit.strip().lower() != "second":
        return dimension == "time" or bool(
            re.match(
                r"\s+(?:away|apart|ahead|tall|high|wide|long|behind|in front|from)",
                m.string[m.end() :],
            )
        )
    after = m.string[m.end() :]
    return bool(
        re.match(r"\s*(?:$|[.,;:!?]|later|after|before|and|the|then)", after, re.IGNORECASE)
    )
