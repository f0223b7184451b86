"""Finds the physical quantities of English text.

Quantities are found before anything else: their words ("in", "second", "m") would otherwise be read
as prepositions, ordinals and nouns.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
import re

from esg.draft.text.amounts import Amount, Bound, overlaps
from esg.draft.text.forms import told_in_forms
from esg.draft.text.measures import bounded, suffix
from esg.draft.text.numerals import DIGITS, NUMBER, Number, parse_number
from esg.draft.text.units import UNIT, Dimension, unit_of

_AT_LEAST = (
    r"not (?:under|below|before)|upwards? of|in excess of|north of|at least|(?:no|not) less than"
    r"|(?:more|greater|faster) than|over|above|(?:no|not) (?:earlier|sooner|slower) than"
    r"|a minimum of|exceeding|minimum|min\.?|[>≥]=?"
)
_AT_MOST = (
    r"not (?:over|above|after|exceeding)|no higher than|inside(?: of)?|a maximum of|at most"
    r"|(?:no|not) (?:faster|more|later) than|(?:less|fewer|slower) than|in less than"
    r"|(?<!speed )(?<!speeds )up to|(?:(?:with)?in|during|for) the (?:very )?first|within"
    r"|in under|under|below|maximum|max\.?|[<≤]=?"
)
_JUST = r"(?:just|slightly|a (?:little|bit|shade|touch|tad))"
_APPROX = (
    rf"(?:(?<![A-Za-z])(?:{_JUST} (?:under|over|below|above|more than|less than)"
    r"|over the (?:course|space) of|(?:in|within) the (?:course|space) of|as (?:much|little|fast"
    r"|slow|high|heavy|far) as|close on|c\.|ca\.|about|around"
    r"|roughly|approximately|approx\.?|nearly|almost|some"
    r"|circa|~|≈|exactly|precisely|just|only|all of|a mere|a full|a good|a whole|no fewer than"
    r"|close to|more or less|barely)\s*)?"
)
_GAP = r"[\s-]*"
_TO = r"\s*(?:~|–|—|-|\.\.+|…|to\b|or\b)\s*"
_VAGUELY = r"(?:\s*-?ish\b|\s+or\s+so\b|[\s-]+odd\b|(?<=\d)\s+of\s+an?\b)?"
"""Between a number and its unit: "3ish seconds", "2/3 of a second"."""
_PLUS_MINUS = r"(?:±|\+/-|\+-|plus or minus|plus/minus|,?\s*give or take)"
_END = r"(?![a-z0-9]|-shirt)"
_QUANTITY = re.compile(
    r"(?:\b(?:time|speed|mass|[a-zA-Z](?:_?[0-9a-zA-Z])?)\s*=\s*)?"
    rf"(?:(?:(?P<min>{_AT_LEAST})|(?P<max>{_AT_MOST}))\s*\b)?{_APPROX}"
    rf"(?P<between>between\s+|from\s+)?(?P<lo>{NUMBER})"
    rf"(?:{_GAP}(?P<unit1>{UNIT})?(?:{_TO}|(?(between)\s*and\s*|(?!)))(?P<hi>{NUMBER}))?"
    r"(?(between)(?(hi)|(?!)))"
    rf"(?P<plus>\+)?(?:\s*{_PLUS_MINUS}\s*(?P<tol1>{DIGITS}))?{_VAGUELY}"
    rf"(?:{_GAP}(?P<unit>{UNIT})){_END}"
    rf"(?:\s*\(?\s*{_PLUS_MINUS}\s*(?P<tol>{DIGITS})\s*(?:(?P<percent>%|percent\b)|{UNIT})?"
    rf"{_END}\)?)?",
    re.IGNORECASE,
)
_BOTH_BOUNDS = re.compile(
    rf"\b(?:{_AT_LEAST}|after)\s+(?P<lo>{NUMBER})(?:{_GAP}(?P<unit1>{UNIT}))?"
    rf",?\s*(?:but|and|yet)\s+(?:{_AT_MOST}|before)\s+(?P<hi>{NUMBER})"
    rf"(?:{_GAP}(?P<unit2>{UNIT}))?(?![a-z0-9])",
    re.IGNORECASE,
)
""" "at least 6 m/s but not more than 8"."""
_AND_A_HALF = re.compile(
    r"\s+and\s+a\s+(half|quarter)\b(?!-)(?!\s+(?:of\s+an?\b|full|empty|eaten|open))", re.IGNORECASE
)
_SMALLER = re.compile(rf"\s+(?:and\s+)?(?P<more>{NUMBER}){_GAP}(?P<unit>{UNIT}){_END}", re.I)
"""The rest of "6 feet 2 inches", "1 min 30 s"."""
_DELAY = re.compile(
    r"(?:\b(?:(?P<with>with)|(?P<over>over|through(?:out)?))\s+)?\b(?:an?|the)\s+"
    r"(?:(?:further|total|short|brief|additional)\s+)?"
    r"(?:delay|pause|gap|interval|lag|wait|period|duration|stretch|span)\s+of\s+$",
    re.IGNORECASE,
)
""" "after a delay of", "over a period of": words that only say that a time follows."""
_ARTICLE_COUNTS = {
    "length": r"\s+(?:away|apart|ahead|tall|high|wide|long|behind|in front|from)",
    "second": r"\s*(?:$|[.,;:!?]|later|after|before|and|the|then)",
    "time": "",
}
"""What follows "a metre", "a second" and "a minute" where they are quantities."""
_BARE = re.compile(
    rf"\b(?P<lead>at|doing|does|weighs?|weighing|by)\s+(?:about\s+|only\s+)?(?P<lo>{NUMBER})"
    r"(?=\s*(?:[,.;:!?)]|$|and\b|but\b|while\b|until\b|when\b|or\b))(?!\.\d)",
    re.IGNORECASE,
)
"""A number that ends its phrase and has no unit."""
_LISTED = re.compile(
    r"(?:\b(?:at|of|with|weigh|weighs|weighing|mass|masses|speeds?|velocit(?:y|ies)|radi(?:us|i)"
    r"|diameters?|heights?|lengths?|widths?|are|is|about|from|after)|[:(=])\s*"
    rf"(?P<list>{NUMBER}(?:\s*,\s*{NUMBER})*)\s*,?\s*(?:and|&)\s*$",
    re.IGNORECASE,
)
"""The first numbers of "1, 2 and 3 kg"."""
_NUMBER = re.compile(NUMBER, re.IGNORECASE)
_WORD = re.compile(r"[^\W_]+|.", re.DOTALL)


def find_amounts(text: str) -> list[Amount]:
    """All quantities with units in `text`, left to right, not overlapping."""
    return list(_found(text))


@lru_cache(maxsize=4)
def _found(text: str) -> tuple[Amount, ...]:
    """The quantities of the last few texts, which several steps of a draft ask for."""
    out: list[Amount] = []
    for found in (_both_bounds(text), told_in_forms(text)):
        for a in found:
            if not overlaps(a.start, a.end, out):
                out.append(a)
    position = 0
    while (m := _QUANTITY.search(text, position)) is not None:
        amount = None if overlaps(m.start(), m.end(), out) else _amount(m)
        if amount is not None:
            out.append(amount)
            position = m.end()
        elif (word := _WORD.match(text, m.start("lo"))) is not None:
            position = word.end()
    out += _without_unit(text, out)
    return tuple(sorted(out, key=lambda a: a.start))


def _amount(m: re.Match[str]) -> Amount | None:
    """A number and its unit, with what stands around them."""
    unit = unit_of(m["unit"])
    interval = _interval(m, unit) if unit is not None else None
    if unit is None or interval is None:
        return None
    (dimension, size), (low, high) = unit, interval
    if m["lo"].strip().lower() in ("a", "an") and not _article_counts(m, dimension):
        return None
    start, end = m.start(), m.end()
    if low == high:
        more, end = _rest(m, dimension, size)
        low = high = low + more
    end, measure = suffix(m.string, end, dimension)
    bound: Bound = "min" if m["min"] else "max" if m["max"] else None
    delay = _DELAY.search(m.string, max(0, start - 40), start) if dimension == "time" else None
    if delay is not None and bound is None:
        start, measure = delay.start(), "later" if delay["with"] else measure
    if m["hi"]:
        bound = None
    elif low == high:
        end, behind = bounded(m.string, end)
        bound = bound or ("min" if m["plus"] else behind)
    return Amount(dimension, low, high, start, end, m.string[start:end].strip(), bound, measure)


def _interval(m: re.Match[str], unit: tuple[Dimension, float]) -> tuple[float, float] | None:
    """What the numbers and the tolerance of a match say, in document units."""
    dimension, size = unit
    number, last = parse_number(m["lo"]), parse_number(m["hi"] or m["lo"])
    unit1 = unit_of(m["unit1"]) if m["unit1"] else unit
    if number is None or last is None or unit1 is None or unit1[0] != dimension:
        return None
    ends = (_ends(number)[0] * unit1[1], _ends(last)[1] * size)
    low, high = min(ends), max(ends)
    tolerance = parse_number(m["tol1"] or m["tol"] or "0")
    if not isinstance(tolerance, float):
        return None
    tolerance *= 0.01 * high if m["percent"] else size
    return low - tolerance, high + tolerance


def _ends(number: Number) -> tuple[float, float]:
    return number if isinstance(number, tuple) else (number, number)


def _article_counts(m: re.Match[str], dimension: Dimension) -> bool:
    """Whether "a <unit>" is a quantity ("after a second") and not a noun ("a second car")."""
    unit = m["unit"].strip().lower()
    if _AND_A_HALF.match(m.string, m.end()):
        return dimension == "mass" or (dimension in ("time", "length") and len(unit) > 2)
    follows = _ARTICLE_COUNTS.get("second" if unit == "second" else dimension)
    if follows is None or len(unit) < 3:
        return False
    return re.match(follows, m.string[m.end() :], re.IGNORECASE) is not None


def _rest(m: re.Match[str], dimension: Dimension, size: float) -> tuple[float, int]:
    """What "and a half" or a smaller unit adds to a quantity, and where that ends."""
    half = _AND_A_HALF.match(m.string, m.end())
    if half is not None:
        return (0.5 if half[1].lower() == "half" else 0.25) * size, half.end()
    more = _SMALLER.match(m.string, m.end())
    part = unit_of(more["unit"]) if more is not None else None
    extra = parse_number(more["more"]) if more is not None else None
    if more is None or part is None or part[0] != dimension or part[1] >= size:
        return 0.0, m.end()
    return (extra * part[1] if isinstance(extra, float) else 0.0), more.end()


def _both_bounds(text: str) -> Iterator[Amount]:
    for m in _BOTH_BOUNDS.finditer(text):
        unit = unit_of(m["unit2"] or m["unit1"] or "")
        low, high = parse_number(m["lo"]), parse_number(m["hi"])
        if unit is not None and isinstance(low, float) and isinstance(high, float):
            a, b = sorted((low * unit[1], high * unit[1]))
            yield Amount(unit[0], a, b, m.start(), m.end(), m.group().strip())


def _without_unit(text: str, known: Sequence[Amount]) -> list[Amount]:
    """Numbers that share the unit of another quantity: "the first at 3, the second at 5 m/s"."""
    shared: list[tuple[Amount, int, int]] = []
    out: list[Amount] = []
    for a in known:
        listed = _LISTED.search(text, max(0, a.start - 60), a.start)
        if listed is not None:
            numbers = _NUMBER.finditer(text, *listed.span("list"))
            shared += [(a, *number.span()) for number in numbers]
    for m in _BARE.finditer(text):
        lead = m["lead"].lower()
        wanted = "mass" if lead.startswith("weigh") else "angle" if lead == "by" else "speed"
        fit = [a for a in known if a.dimension == wanted]
        if fit and m["lo"].lower() not in ("a", "an", "one"):
            shared.append((min(fit, key=lambda a: abs(a.start - m.start("lo"))), *m.span("lo")))
    for a, start, end in shared:
        value = parse_number(text[start:end])
        if isinstance(value, float) and value > 0.0 and not overlaps(start, end, [*known, *out]):
            size = value * _unit_size(a)
            out.append(Amount(a.dimension, size, size, start, end, text[start:end]))
    return out


def _unit_size(a: Amount) -> float:
    """Size of the unit that a quantity is told in, in document units."""
    told = re.findall(rf"(?:\d|\s|-)({UNIT})(?![a-z0-9])", a.text, re.IGNORECASE)
    units = [u for u in map(unit_of, told) if u is not None and u[0] == a.dimension]
    return units[-1][1] if units else 1.0
