"""Singular and plural of English nouns: regular by rule, the others by `irregulars.csv`.

The table holds nouns whose plural the rules miss (Quirk et al., A Comprehensive Grammar of the
English Language, 5.75-5.103) and words in -s that are no plurals.
"""

from __future__ import annotations

import csv
from functools import cache, lru_cache
from pathlib import Path
import re

TABLE = Path(__file__).parent / "irregulars.csv"
_SIBILANT_ES = re.compile(r"(?:ch|sh|x|ss|zz)es$")
_SINGULAR_S = ("ss", "us", "is")
"""Endings of singulars: grass, walrus, tennis."""


@cache
def _singulars() -> dict[str, str]:
    with open(TABLE, encoding="utf-8", newline="") as file:
        return {row["plural"]: row["singular"] for row in csv.DictReader(file)}


@cache
def _plurals() -> dict[str, str]:
    out: dict[str, str] = {}
    for many, one in _singulars().items():
        out.setdefault(one, many)
    return out


@lru_cache(maxsize=16384)
def singular(text: str) -> str:
    """Singular of a noun or of the last word of a phrase (lower case); itself if it is none."""
    front, space, word = text.rpartition(" ")
    return front + space + _singular(word)


def _singular(word: str) -> str:
    if word in _singulars():
        return _singulars()[word]
    if word.endswith("men") and len(word) > 5:
        return word[:-2] + "an"  # fishermen
    if not word.endswith("s") or len(word) < 4 or word.endswith(_SINGULAR_S):
        return word
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    return word[:-2] if _SIBILANT_ES.search(word) else word[:-1]


def plural(text: str) -> str:
    """Plural of a noun or of the last word of a phrase; itself if it is one."""
    front, space, word = text.rpartition(" ")
    return front + space + _plural(word)


def _plural(word: str) -> str:
    if word in _plurals():
        return _plurals()[word]
    if _singular(word) != word:
        return word
    if word.endswith("man") and len(word) > 5:
        return word[:-2] + "en"
    if word.endswith(("s", "x", "ch", "sh", "z")):
        return word + "es"
    if word.endswith("y") and word[-2:-1] not in "aeiou":
        return word[:-1] + "ies"
    return word + "s"
