"""Numbers in digits and in words."""

from __future__ import annotations

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

WORD_NUMBER = (
    r"(?:(?:twenty|thirty|forty|fifty|sixty|seventy|eighty|ninety)[- ]?"
    r"(?:one|two|three|four|five|six|seven|eight|nine)?"
    r"|(?:(?:a|one|two|three|four|five|six|seven|eight|nine)[- ])?hundred"
    r"(?:\s+and\s+[a-z]+)?"
    r"|(?:one|two|three|four|five|six|seven|eight|nine|ten|\d+) and an? (?:half|quarter)"
    r"|zero|one|two|three|four|five|six|seven|eight"
    r"|nine|ten|eleven|twelve|thirteen|fourteen|fifteen|sixteen|seventeen|eighteen|nineteen"
    r"|(?:an?|one|two|three|four|five|six|seven|eight|nine)[- ](?:tenth|hundredth|quarter|third)s?"
    r" of an?|half an?|an? half|half|a quarter of an?|three quarters of an?"
    r"|a couple of|a few|several|an?)"
)
DIGITS = r"(?:\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d+,\d{1,2}(?![\d,])|\d+/\d+|\d*\.?\d+(?:e[+-]?\d+)?)"
SIGN = r"(?:minus\s+|negative\s+|(?<![\w.])[-−](?=\d|\.\d))"
NUMBER = rf"(?:{SIGN}?{DIGITS}|{SIGN}?\b{WORD_NUMBER}(?![a-z]))"


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
    if re.fullmatch(DIGITS, t):
        if "/" in t:
            a, b = t.split("/")
            return sign * float(a) / float(b) if float(b) else None
        if re.fullmatch(r"\d+,\d{1,2}", t):
            return sign * float(t.replace(",", "."))  # "1,5 m/s"
        return sign * float(t.replace(",", ""))
    share = re.fullmatch(r"(\w+)[- ](tenth|hundredth|quarter|third)s? of an?", t)
    if share is not None:
        count = 1.0 if share[1] in ("a", "an") else NUMBER_WORDS.get(share[1], 1.0)
        return sign * count / {"tenth": 10, "hundredth": 100, "quarter": 4, "third": 3}[share[2]]
    total = current = 0.0
    seen = False
    for word in re.split(r"[\s-]+", t):
        if word in ("and", "a", "an", ""):
            continue
        if word.isdigit():
            seen, current = True, current + float(word)
            continue
        if word == "quarter":
            seen, current = True, current + 0.25
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
