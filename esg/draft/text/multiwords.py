"""Multiword expressions: sequences of words that act as one preposition, adverb or subordinator.

Each row of `data/multiwords.csv` has expressions ("in/at the end|at the very? last second", where
"very" may be left out; "very_same" is one token), what kind of word they are, which word they read
as, and an example.
"""

from __future__ import annotations

from collections.abc import Iterator
import csv
from functools import cache
from itertools import product
import re
from typing import Literal, cast

from esg.draft import lexicon as lex

Kind = Literal["prep", "adv", "sub", "conj"]
Multiword = tuple[tuple[str, ...], Kind, str]


def spelled(expression: str) -> Iterator[tuple[str, ...]]:
    """The sequences of words that an expression of the table stands for."""
    choices = [
        [*word.removesuffix("?").split("/"), *([""] if word.endswith("?") else [])]
        for word in expression.split()
    ]
    for words in product(*choices):
        yield tuple(w.replace("_", " ") for w in words if w)


def _multiwords() -> dict[str, list[Multiword]]:
    found: list[Multiword] = []
    with open(lex.DATA / "multiwords.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE):
            for expression in row["words"].split("|"):
                for words in spelled(expression):
                    found.append((words, cast(Kind, row["kind"]), row["reads as"]))
    out: dict[str, list[Multiword]] = {}
    for multiword in sorted(found, key=lambda m: -len(m[0])):
        out.setdefault(multiword[0][0], []).append(multiword)
    return out


MULTIWORDS = _multiwords()
"""(words, kind, what they read as) by the first word, the longest first, so that a part never hides
the whole.
"""


@cache
def spellings(low: str) -> re.Pattern[str]:
    """Matches every expression that reads as a word, the longest first."""
    told = [
        " ".join(words).replace(" 's", "'s")
        for rows in MULTIWORDS.values()
        for words, _, reads in rows
        if reads == low
    ]
    longest = sorted(told, key=lambda t: (-len(t), t))
    said = rf"\b(?:{'|'.join(map(re.escape, longest))})\b" if told else r"(?!)"
    return re.compile(said, re.IGNORECASE)
