"""Numbers in digits and in words."""

from __future__ import annotations

from functools import lru_cache
import re

Number = float | tuple[float, float]
"""A number, or the interval of a vague word."""
_ONES = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine")
_TEENS = ("ten", "eleven", "twelve", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen",
          "eighteen", "nineteen")  # fmt: skip
_TENS = ("twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety")
_TIMES = {"dozen": 12.0, "hundred": 100.0, "thousand": 1000.0}
"""Words that multiply the number before them."""
NUMBER_WORDS: dict[str, float] = {
    **{word: float(n) for n, word in enumerate((*_ONES, *_TEENS))},
    **{word: 10.0 * n for n, word in enumerate(_TENS, start=2)},
    **_TIMES, "half": 0.5, "quarter": 0.25, "nought": 0.0,
}  # fmt: skip
_VAGUE: dict[str, Number] = {
    "a couple of": 2.0, "a few": (2.0, 5.0), "several": (3.0, 7.0), "a": 1.0, "an": 1.0,
    "half a": 0.5, "half an": 0.5, "a half": 0.5, "an half": 0.5,
}  # fmt: skip
_PARTS = {
    "half": 2.0, "halve": 2.0, "third": 3.0, "quarter": 4.0, "fourth": 4.0, "fifth": 5.0,
    "sixth": 6.0, "eighth": 8.0, "tenth": 10.0, "twentieth": 20.0, "hundredth": 100.0,
    "thousandth": 1000.0,
}  # fmt: skip
"""What a share of one divides by."""
_FRACTIONS = {"½": 0.5, "¼": 0.25, "¾": 0.75, "⅓": 1 / 3, "⅔": 2 / 3, "⅛": 0.125}

_1_TO_9, _1_TO_10 = "|".join(_ONES[1:]), "|".join((*_ONES[1:], "ten"))
_DIGIT_WORD = rf"(?:zero|nought|{_1_TO_9})"
_SHARE = rf"(?:{'|'.join(_PARTS)})s? of an?"
WORD_NUMBER = (
    rf"(?:(?:(?:{_DIGIT_WORD}|ten|eleven|twelve)\s+)?point(?:\s+{_DIGIT_WORD})+"
    rf"|(?:{'|'.join(_TEENS[1:])}) hundred"
    r"|(?:an?|one|two|three|four|five|half an?)[- ]dozen"
    rf"|(?:{_1_TO_10})-and-an?-(?:half|quarter)"
    rf"|(?:{'|'.join(_TENS)})[- ]?(?:{_1_TO_9})?"
    rf"|(?:(?:a|{_1_TO_9})[- ])?hundred(?:\s+and\s+[a-z]+)?"
    rf"|(?:{_1_TO_10}|\d+) and an? (?:half|quarter)"
    rf"|{'|'.join((*_ONES, *_TEENS))}"
    rf"|(?:an?|{_1_TO_9})[- ]{_SHARE}"
    r"|half an?|an? half|half"
    r"|a couple of|a few|several|an?)"
)
DIGITS = (
    r"(?:\d*\s?[½¼¾⅓⅔⅛](?:\s+of\s+an?\b)?"
    r"|\d+\s+\d/\d+|\d{1,3}(?:\s000|'\d{3})+(?!\d)|\d+(?:\.\d+)?\s+(?:hundred|thousand)\b"
    r"|\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d+,\d{1,2}(?![\d,])|\d+/\d+|\d*\.?\d+(?:e[+-]?\d+)?)"
)
_SIGN = r"(?:minus\s+|negative\s+|(?<![\w.])[-−](?=\d|\.\d))"
NUMBER = rf"(?:{_SIGN}?{DIGITS}|{_SIGN}?\b{WORD_NUMBER}(?![a-z]))"


@lru_cache(maxsize=4096)
def parse_number(text: str) -> Number | None:
    """Value of a number in digits or words; "a few" and "several" give an interval.

    Returns:
        The number, an interval for vague words, or None if the text is no number.
    """
    t = " ".join(text.lower().replace("−", "-").split())
    sign = 1.0
    for minus in ("minus ", "negative ", "-"):
        if t.startswith(minus):
            sign, t = -1.0, t[len(minus) :].strip()
    value = _VAGUE.get(t)
    if value is None:
        value = _in_digits(t) if re.fullmatch(DIGITS, t) else _in_words(t)
    return sign * value if isinstance(value, float) else value


def _in_digits(t: str) -> float | None:
    """ "1 1/2", "¾ of a", "2 hundred", "1,5", "1,500", "1'500", "1e3"."""
    number = t.split(" of ")[0]
    if number[-1] in _FRACTIONS:
        return float(number[:-1].strip() or 0.0) + _FRACTIONS[number[-1]]
    whole, _, share = t.rpartition(" ")
    if "/" in share:
        above, below = share.split("/")
        return float(whole or 0.0) + float(above) / float(below) if float(below) else None
    if share in _TIMES:
        return float(whole) * _TIMES[share]
    if re.fullmatch(r"\d+,\d{1,2}", t):
        return float(t.replace(",", "."))
    return float(re.sub(r"[', ]", "", t))


def _in_words(t: str) -> float | None:
    """ "zero point three", "two thirds of a", "fifteen hundred", "two and a half"."""
    words = [w for w in re.split(r"[\s-]+", t) if w not in ("and", "a", "an", "")]
    if "point" in words:
        at = words.index("point")
        digits = "".join(str(int(NUMBER_WORDS[w])) for w in words[at + 1 :])
        return (NUMBER_WORDS[words[0]] if at else 0.0) + float(f"0.{digits}")
    if share := re.fullmatch(rf"(\w+)[- ]({_SHARE})", t):
        part = share[2].split(" ")[0]
        below = _PARTS.get(part) or _PARTS[part.removesuffix("s")]
        return (1.0 if share[1] in ("a", "an") else NUMBER_WORDS.get(share[1], 1.0)) / below
    total = None
    for word in words:
        value = float(word) if word.isdecimal() else NUMBER_WORDS.get(word)
        if value is None:
            return None
        total = (total or 1.0) * value if word in _TIMES else (total or 0.0) + value
    return total
