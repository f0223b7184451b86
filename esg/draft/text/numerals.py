"""Numbers in digits and in words."""

from __future__ import annotations

from functools import lru_cache
import re

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

_DIGIT_WORD = r"(?:zero|nought|one|two|three|four|five|six|seven|eight|nine)"
_PARTS = {
    "half": 2.0, "halve": 2.0, "third": 3.0, "quarter": 4.0, "fourth": 4.0, "fifth": 5.0,
    "sixth": 6.0, "eighth": 8.0, "tenth": 10.0, "twentieth": 20.0, "hundredth": 100.0,
    "thousandth": 1000.0,
}  # fmt: skip
"""What a share of one divides by."""
_FRACTIONS = {"½": 0.5, "¼": 0.25, "¾": 0.75, "⅓": 1 / 3, "⅔": 2 / 3, "⅛": 0.125}
_SHARES = "|".join(_PARTS)

WORD_NUMBER = (
    rf"(?:(?:(?:{_DIGIT_WORD}|ten|eleven|twelve)\s+)?point(?:\s+{_DIGIT_WORD})+"
    r"|(?:eleven|twelve|thirteen|fourteen|fifteen|sixteen|seventeen|eighteen|nineteen) hundred"
    r"|(?:an?|one|two|three|four|five|half an?)[- ]dozen"
    r"|(?:one|two|three|four|five|six|seven|eight|nine|ten)-and-an?-(?:half|quarter)"
    r"|(?:twenty|thirty|forty|fifty|sixty|seventy|eighty|ninety)[- ]?"
    r"(?:one|two|three|four|five|six|seven|eight|nine)?"
    r"|(?:(?:a|one|two|three|four|five|six|seven|eight|nine)[- ])?hundred"
    r"(?:\s+and\s+[a-z]+)?"
    r"|(?:one|two|three|four|five|six|seven|eight|nine|ten|\d+) and an? (?:half|quarter)"
    r"|zero|one|two|three|four|five|six|seven|eight"
    r"|nine|ten|eleven|twelve|thirteen|fourteen|fifteen|sixteen|seventeen|eighteen|nineteen"
    rf"|(?:an?|one|two|three|four|five|six|seven|eight|nine)[- ](?:{_SHARES})s? of an?"
    r"|half an?|an? half|half|a quarter of an?|three quarters of an?"
    r"|a couple of|a few|several|an?)"
)
DIGITS = (
    r"(?:\d*\s?[½¼¾⅓⅔⅛](?:\s+of\s+an?\b)?"
    r"|\d+\s+\d/\d+|\d{1,3}(?:\s000|'\d{3})+(?!\d)|\d+(?:\.\d+)?\s+(?:hundred|thousand)\b"
    r"|\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d+,\d{1,2}(?![\d,])|\d+/\d+|\d*\.?\d+(?:e[+-]?\d+)?)"
)
SIGN = r"(?:minus\s+|negative\s+|(?<![\w.])[-−](?=\d|\.\d))"
NUMBER = rf"(?:{SIGN}?{DIGITS}|{SIGN}?\b{WORD_NUMBER}(?![a-z]))"


@lru_cache(maxsize=4096)
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
    if t.split(" of ")[0][-1:] in _FRACTIONS:
        whole = t.split(" of ")[0][:-1].strip()
        return sign * (float(whole or 0.0) + _FRACTIONS[t.split(" of ")[0][-1]])
    if "point" in t.split():
        before, after = t.replace("nought", "zero").split("point")
        digits = "".join(str(int(NUMBER_WORDS[w])) for w in after.split())
        return sign * (NUMBER_WORDS[before.strip() or "zero"] + float(f"0.{digits}"))
    if re.fullmatch(DIGITS, t):
        mixed = re.fullmatch(r"(\d+)\s+(\d)/(\d+)", t)
        if mixed is not None and float(mixed[3]):
            return sign * (float(mixed[1]) + float(mixed[2]) / float(mixed[3]))  # "1 1/2"
        scaled = re.fullmatch(r"(\d+(?:\.\d+)?)\s+(hundred|thousand)", t)
        if scaled is not None:
            return sign * float(scaled[1]) * NUMBER_WORDS[scaled[2]]
        t = t.replace("'", "").replace(" ", "")
        if "/" in t:
            a, b = t.split("/")
            return sign * float(a) / float(b) if float(b) else None
        if re.fullmatch(r"\d+,\d{1,2}", t):
            return sign * float(t.replace(",", "."))  # "1,5 m/s"
        return sign * float(t.replace(",", ""))
    share = re.fullmatch(rf"(\w+)[- ]({_SHARES})s? of an?", t)
    if share is not None:
        count = 1.0 if share[1] in ("a", "an") else NUMBER_WORDS.get(share[1], 1.0)
        return sign * count / _PARTS[share[2]]
    total = current = 0.0
    seen = False
    for word in re.split(r"[\s-]+", t):
        if word in ("and", "a", "an", ""):
            continue
        if word.isdecimal():
            seen, current = True, current + float(word)
            continue
        if word == "quarter":
            seen, current = True, current + 0.25
            continue
        if word not in NUMBER_WORDS:
            return None
        seen = True
        value = NUMBER_WORDS[word]
        if word == "dozen" and "half" in t.split():
            current = 6.0
        elif value in (12.0, 100.0, 1000.0) and word != "twelve":
            current = (current or 1.0) * value
        else:
            current += value
    total += current
    return sign * total if seen else None
