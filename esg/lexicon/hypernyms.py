"""Nouns outside the table of kinds and the kind that stands for each: a samovar is like a vase.

The table was made from WordNet 3.0 (esg/assets/library/wordnet.py). It names the nearest concept
above a noun for which there is a kind that is drawn, and how large and heavy things below that
concept are.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

TABLE = Path(__file__).parent / "hypernyms.txt"


@dataclass(frozen=True)
class Hypernym:
    """What stands above nouns.

    Args:
        kind: Name of the kind, with underscores.
        longest_cm: Usual longest extent of such things; None for that of the kind.
        mass_kg: Usual mass; None for that of the kind.
        concept: The concept above them.
        stands_in: Whether the kind only stands for them: a pulley is no tire. They are none, or
            only in a rare sense.
    """

    kind: str
    longest_cm: float | None
    mass_kg: float | None
    concept: str
    stands_in: bool = False


@cache
def hypernyms() -> dict[str, Hypernym]:
    """Singular nouns without hyphens, and without spaces too, and what is above each."""
    nouns: dict[str, Hypernym] = {}
    for line in TABLE.read_text(encoding="utf-8").splitlines():
        kind, longest, mass, concept, such, others = line.split("\t")
        wider = Hypernym(
            kind, float(longest) if longest else None, float(mass) if mass else None, concept
        )
        for words, stands_in in ((such, False), (others, True)):
            if words:
                of = replace(wider, stands_in=stands_in)
                nouns.update(dict.fromkeys(words.split(";"), of))
    for noun, wider in list(nouns.items()):
        nouns.setdefault(noun.replace(" ", ""), wider)
    return nouns
