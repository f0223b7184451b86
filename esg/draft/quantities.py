"""Numbers and physical quantities in English text, in document units (cm, kg, s, degrees).

Quantities are found before anything else: their words ("in", "second", "m") would otherwise be read
as prepositions, ordinals and nouns.
"""

from __future__ import annotations

from dataclasses import dataclass
import re
from typing import Literal

Dimension = Literal["mass", "length", "time", "speed", "acceleration", "angle", "count"]

_ONES = [
    "zero",
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
    "thirteen",
    "fourteen",
    "fifteen",
    "sixteen",
    "seventeen",
    "eighteen",
    "nineteen",
]
_TENS = ["twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"]
NUMBER_WORDS: dict[str, float] = {
    **{w: float(i) for i, w in enumerate(_ONES)},
    **{w: 10.0 * (i + 2) for i, w in enumerate(_TENS)},
    **{"half": 0.5, "hundred": 100.0, "thousand": 1000.0, "dozen": 12.0},
}

_UNITS: dict[str, tuple[Dimension, float]] = {}


def _unit(dimension: Dimension, factor: float, *names: str) -> None:
    for name in names:
        _UNITS[name] = (dimension, factor)


_unit(
    "mass", 1.0, "kg", "kgs", "kilo", "kilos", "kilogram", "kilograms", "kilogramme", "kilogrammes"
)
_unit("mass", 1e-3, "g", "gram", "grams", "gr", "gramme", "grammes")
_unit("mass", 0.45359237, "lb", "lbs", "pound", "pounds")
_unit("mass", 0.028349523, "oz", "ounce", "ounces")
_unit("mass", 1000.0, "ton", "tons", "tonne", "tonnes", "metric ton", "metric tons", "t")
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
_unit("speed", 100.0, "mps", "m.s-1", "ms-1")
_unit("speed", 44.704, "mph")
_unit("speed", 100.0 / 3.6, "kph", "kmh", "kmph")
_unit("speed", 51.4444444, "knot", "knots", "kn")
_unit("speed", 30.48, "fps")

_LENGTHS = [u for u, (d, _) in _UNITS.items() if d == "length" and u != "in"] + ["in"]
_TIMES = [u for u, (d, _) in _UNITS.items() if d == "time"]


def _alternatives(words: list[str]) -> str:
    return "|".join(re.escape(w) for w in sorted(words, key=len, reverse=True))


_WORD_NUMBER = (
    r"(?:(?:twenty|thirty|forty|fifty|sixty|seventy|eighty|ninety)[- ]?"
    r"(?:one|two|three|four|five|six|seven|eight|nine)?"
    r"|(?:(?:a|one|two|three|four|five|six|seven|eight|nine)[- ])?hundred"
    r"(?:\s+and\s+[a-z]+)?"
    r"|zero|one and a half|two and a half|three and a half|one|two|three|four|five|six|seven|eight"
    r"|nine|ten|eleven|twelve|thirteen|fourteen|fifteen|sixteen|seventeen|eighteen|nineteen"
    r"|half an?|an? half|half|a quarter of an?|three quarters of an?"
    r"|a couple of|a few|several|an?)"
)
_DIGITS = r"(?:\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d+/\d+|\d*\.?\d+(?:e[+-]?\d+)?)"
_SIGN = r"(?:minus\s+|negative\s+|(?<![\w.])[-−](?=\d|\.\d))"
_NUMBER = rf"(?:{_SIGN}?{_DIGITS}|{_SIGN}?\b{_WORD_NUMBER}(?![a-z]))"
_SPEED_UNIT = (
    rf"(?:(?:{_alternatives(_LENGTHS)})\s*(?:/|per|a|an|each)\s*(?:{_alternatives(_TIMES)})"
    rf"|m\.s-1|ms-1|mps|mph|kph|kmph|kmh|fps|knots?|kn)"
)
_ACCEL_UNIT = (
    r"(?:(?:m|cm|ft|meters?|metres?|feet|foot)\s*(?:/|per)\s*(?:s|sec|second)"
    r"(?:\s*(?:\^\s*2|²|2\b|squared|(?:/|per)\s*(?:s\b|sec\b|second\b)))"
    r"|m/s/s)"
)
_PLAIN_UNIT = _alternatives([u for u, (d, _) in _UNITS.items() if d != "speed" and u != "in"])
_INCHES = r"in(?=\s*(?:[.,;)]|$|tall|wide|long|high|deep|thick|in\s+diameter))"
_UNIT = rf"(?:{_ACCEL_UNIT}|{_SPEED_UNIT}|{_PLAIN_UNIT}|{_INCHES}|\"|”)"
_GAP = r"[\s-]*"
_TO = r"\s*(?:~|–|—|-|to\b|or\b)\s*"
_APPROX = (
    r"(?:(?P<approx>about|around|roughly|approximately|approx\.?|nearly|almost|some|circa|~|≈"
    r"|exactly|precisely|just|only)\s*)?"
)
_BOUND = (
    r"(?:(?P<bound>at least|no less than|not less than|more than|greater than|faster than|over"
    r"|above|no faster than|not faster than"
    r"|no slower than|not slower than|a maximum of|a minimum of|at most"
    r"|no more than|not more than|less than|fewer than|slower than|under|below|up to"
    r"|within|in under|in less than|exceeding)\s+)?"
)
_PATTERN = re.compile(
    rf"(?:\bt(?:ime)?\s*=\s*)?{_BOUND}{_APPROX}(?P<between>between\s+|from\s+)?"
    rf"(?P<lo>{_NUMBER})"
    rf"(?:{_GAP}(?P<unit1>{_UNIT})?(?:{_TO}|(?(between)\s*and\s*|(?!)))(?P<hi>{_NUMBER}))?"
    rf"(?:{_GAP}(?P<unit>{_UNIT}))(?![a-z0-9])"
    rf"(?:\s*(?:±|\+/-|\+-)\s*(?P<tol>{_DIGITS})\s*(?:{_UNIT})?(?![a-z0-9]))?",
    re.IGNORECASE,
)
_TOLERANCE_FIRST = re.compile(
    rf"(?P<lo>{_DIGITS})\s*(?:±|\+/-|\+-)\s*(?P<tol>{_DIGITS})\s*(?P<unit>{_UNIT})(?![a-z0-9])",
    re.IGNORECASE,
)
_SPEEDING = re.compile(r"\b(?:speed|speeds|sped|speeding|goes|going|accelerat\w+)\s+$", re.I)
_LOW_BOUNDS = (
    "at least", "no less", "not less", "no slower", "not slower", "a minimum",
    "more than", "greater", "faster", "over", "above",
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
        signed_negative: A minus sign was written.
    """

    dimension: Dimension
    low: float
    high: float
    start: int
    end: int
    text: str
    bound: Literal["min", "max"] | None = None

    @property
    def value(self) -> float | tuple[float, float]:
        """A number, or the interval (low, high)."""
        return self.low if self.low == self.high else (self.low, self.high)

    @property
    def middle(self) -> float:
        return 0.5 * (self.low + self.high)


def parse_number(text: str) -> float | tuple[float, float] | None:
    """Value of a number in digits or words; "a few" and "several" give an interval.

    Returns:
        The number, an interval for vague words, or None if the text is no number.
    """
    t = " ".join(text.lower().replace("−", "-").split())
    sign = 1.0
    for minus in ("minus ", "negative ", "-"):
        if t.startswith(minus):
            sign, t = -1.0, t[len(minus) :].strip()
    vague = {
        "a couple of": 2.0,
        "a few": (2.0, 5.0),
        "several": (3.0, 7.0),
        "a": 1.0,
        "an": 1.0,
        "half a": 0.5,
        "half an": 0.5,
        "a half": 0.5,
        "an half": 0.5,
        "a quarter of a": 0.25,
        "a quarter of an": 0.25,
        "three quarters of a": 0.75,
        "three quarters of an": 0.75,
    }
    if t in vague:
        found = vague[t]
        return found if isinstance(found, tuple) else sign * found
    if re.fullmatch(_DIGITS, t):
        if "/" in t:
            a, b = t.split("/")
            return sign * float(a) / float(b) if float(b) else None
        return sign * float(t.replace(",", ""))
    total = current = 0.0
    seen = False
    for word in re.split(r"[\s-]+", t):
        if word in ("and", "a", "an", ""):
            continue
        if word not in NUMBER_WORDS:
            return None
        seen = True
        value = NUMBER_WORDS[word]
        if value in (100.0, 1000.0):
            current = (current or 1.0) * value
        else:
            current += value
    total += current
    return sign * total if seen else None


def _unit_of(text: str) -> tuple[Dimension, float] | None:
    t = re.sub(r"\s+", " ", text.lower().strip())
    if t in ('"', "”"):
        return "length", 2.54
    if t in _UNITS:
        return _UNITS[t]
    m = re.fullmatch(
        r"(\D+?)\s*(?:/|\bper\b|\ban?\b|\beach\b)\s*(\D+?)(\s*(\^\s*2|²|2|squared|/.*|per .*))?", t
    )
    if not m:
        return None
    length, time = _UNITS.get(m.group(1).strip()), _UNITS.get(m.group(2).strip())
    if length is None or time is None or length[0] != "length" or time[0] != "time":
        return None
    if m.group(3):
        return "acceleration", length[1] / time[1] ** 2
    return "speed", length[1] / time[1]


def find_amounts(text: str) -> list[Amount]:
    """All quantities with units in `text`, left to right, not overlapping."""
    taken: list[tuple[int, int]] = []
    out: list[Amount] = []
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
    return sorted(out, key=lambda a: a.start)


def _amount(m: re.Match[str]) -> Amount | None:
    groups = m.groupdict()
    unit = _unit_of(groups["unit"])
    low = parse_number(groups["lo"])
    if unit is None or low is None:
        return None
    dimension, factor = unit
    if groups["unit"].lower() == "t" and re.match(r"T|t[-']", m.string[m.start("unit") :]):
        return None  # "2 T-shirts"
    start = m.start()
    lo_word = groups["lo"].strip().lower()
    if lo_word in ("a", "an") and not _article_counts(m, groups["unit"], dimension):
        return None
    low_a, low_b = low if isinstance(low, tuple) else (low, low)
    if groups.get("hi"):
        high = parse_number(groups["hi"])
        if high is None:
            return None
        unit1 = _unit_of(groups["unit1"]) if groups.get("unit1") else unit
        if unit1 is None or unit1[0] != dimension:
            return None
        a = low_a * unit1[1]
        b = (high[1] if isinstance(high, tuple) else high) * factor
        low_a, low_b = min(a, b), max(a, b)
    else:
        low_a, low_b = low_a * factor, low_b * factor
    if groups.get("tol"):
        tolerance = float(str(groups["tol"]).replace(",", "")) * factor
        low_a, low_b = low_a - tolerance, low_b + tolerance
    if groups.get("between") and not groups.get("hi"):
        start = m.start("lo")  # a lone "from" is a preposition
    bound: Literal["min", "max"] | None = None
    word = (groups.get("bound") or "").lower()
    if word == "up to" and _SPEEDING.search(m.string[: m.start()]):
        start, word = m.start("lo"), ""  # "speeds up to 14 m/s": reaches it
    if word and not groups.get("hi"):
        bound = "min" if word.startswith(_LOW_BOUNDS) or word == "exceeding" else "max"
    return Amount(dimension, low_a, low_b, start, m.end(), m.string[start : m.end()].strip(), bound)


def _article_counts(m: re.Match[str], unit: str, dimension: Dimension) -> bool:
    """Whether "a <unit>" is a quantity ("after a second") and not a noun ("a second car")."""
    if dimension not in ("time", "length"):
        return False
    if len(unit.strip()) < 3:
        return False
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
