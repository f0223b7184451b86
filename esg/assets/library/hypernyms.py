"""Nouns outside the library and the kind that stands for each: a samovar is an urn, so a vase.

The table was made from WordNet 3.0 (esg/assets/library/wordnet.py). It names the nearest concept
above a noun for which the library has a mesh, and how large and heavy things below that concept
are.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files

from esg.assets.library.catalogue import Entry, entries_by_name, normalize

TABLE_FILE = "hypernyms.txt"


@dataclass(frozen=True)
class Kin:
    """What a noun is, as far as the library can show it.

    Args:
        noun: The noun, or the last words of a compound.
        concept: The concept above it that has a mesh.
        kind: Name of the library's kind.
        longest_cm: Usual longest extent of such things; None for that of the kind.
        mass_kg: Usual mass; None for that of the kind.
    """

    noun: str
    concept: str
    kind: str
    longest_cm: float | None
    mass_kg: float | None

    @property
    def entry(self) -> Entry:
        """The kind itself."""
        return entries_by_name()[self.kind]


@lru_cache(maxsize=1)
def _table() -> tuple[dict[str, int], list[list[str]]]:
    text = files("esg.assets.data").joinpath(TABLE_FILE).read_text(encoding="utf-8")
    rows = [line.split("\t") for line in text.splitlines()]
    nouns = {noun: i for i, row in enumerate(rows) for noun in row[4].split(";")}
    for noun, i in list(nouns.items()):
        nouns.setdefault(noun.replace(" ", ""), i)
    return nouns, rows


def kin(text: str, *, whole: bool = False) -> Kin | None:
    """What the longest known ending of a noun phrase is ("copper samovar" -> samovar).

    Args:
        text: A noun phrase.
        whole: Whether the phrase itself must be known.
    """
    from esg.assets.library.lookup import head_phrase

    nouns, rows = _table()
    words = head_phrase(text).split()
    for start in range(1 if whole and words else len(words)):
        noun = normalize(" ".join(words[start:]))
        row = nouns.get(noun)
        if row is not None:
            kind, longest, mass, concept, _ = rows[row]
            return Kin(
                noun,
                concept,
                kind,
                float(longest) if longest else None,
                float(mass) if mass else None,
            )
    return None
