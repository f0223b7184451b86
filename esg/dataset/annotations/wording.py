"""Rows of wording and the little grammar that fills them: verbs agree, sentences begin large."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
import csv
from dataclasses import dataclass
from functools import cache
import hashlib
from pathlib import Path
import re
from typing import TypeVar

HERE = Path(__file__).parent
_VERB = re.compile(r"\[([a-z]+)\]")
_THIRD = {"be": "is", "have": "has", "do": "does"}
_PLURAL = {"be": "are"}

_T = TypeVar("_T")


@dataclass(frozen=True)
class Row:
    """One row of a table of wordings.

    Args:
        what: What it says.
        template: With {names} to fill, and verbs in [brackets] that agree with the subject.
        example: A sentence that it makes; the tests make it.
        answer: Of a question: how the answer reads.
    """

    what: str
    template: str
    example: str
    answer: str = ""


@cache
def rows(table: str) -> Mapping[str, tuple[Row, ...]]:
    """Rows of a table (`clauses`, `questions`, `supposed`) by what they say."""
    out: dict[str, tuple[Row, ...]] = {}
    with open(HERE / f"{table}.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            item = Row(row["what"], row["template"], row["example"], row.get("answer") or "")
            out[item.what] = (*out.get(item.what, ()), item)
    return out


@cache
def manners() -> Mapping[tuple[str, str], str]:
    """Verbs of motion by manner and category; an empty category stands for all others."""
    with open(HERE / "manners.csv", encoding="utf-8", newline="") as file:
        return {(r["manner"], r["category"]): r["verb"] for r in csv.DictReader(file)}


def verb_of(manner: str, category: str) -> str:
    """The verb, in brackets, of how something moves."""
    known = manners()
    return known.get((manner, category)) or known[manner, ""]


def third(verb: str) -> str:
    """Third person singular (Quirk et al., A Comprehensive Grammar of English, 3.5)."""
    if verb in _THIRD:
        return _THIRD[verb]
    if re.search(r"(?:s|x|z|ch|sh|o)$", verb):
        return f"{verb}es"
    return f"{verb[:-1]}ies" if re.search(r"[^aeiou]y$", verb) else f"{verb}s"


def agreeing(text: str, *, plural: bool) -> str:
    """Puts every bracketed verb into the form that the subject asks for."""

    def form(match: re.Match[str]) -> str:
        verb = match.group(1)
        return _PLURAL.get(verb, verb) if plural else third(verb)

    return _VERB.sub(form, text)


def sentence(text: str, end: str = ".") -> str:
    """The text with a capital and a full stop."""
    text = " ".join(text.split())
    return f"{text[:1].upper()}{text[1:]}{end}"


class Chooser:
    """Picks among wordings by a seed, the same on every machine.

    Args:
        seed: Of the scene.
    """

    def __init__(self, seed: str) -> None:
        self._seed = seed
        self._n = 0

    def of(self, choices: Sequence[_T]) -> _T:
        """The next choice."""
        return choices[self.below(len(choices))]

    def below(self, n: int) -> int:
        """The next number from 0 to n - 1."""
        self._n += 1
        digest = hashlib.sha256(f"{self._seed}/{self._n}".encode()).digest()
        return int.from_bytes(digest[:8], "big") % n

    def shuffled(self, items: Sequence[_T]) -> list[_T]:
        """The items in an order of the seed."""
        left, out = list(items), list[_T]()
        while left:
            out.append(left.pop(self.below(len(left))))
        return out


def metres(value: float) -> str:
    """A distance as people say it: 35 cm, 2.4 m, 31 m."""
    if value < 0.995:
        return f"{max(1, round(100 * value))} cm"
    return f"{value:.1f} m" if value < 9.95 else f"{value:.0f} m"


def three_digits(value: float) -> str:
    """A number to three digits, without an exponent."""
    if value >= 100:
        digits = len(str(int(value))) - 3
        return str(round(value / 10**digits) * 10**digits)
    return f"{value:.3g}"
