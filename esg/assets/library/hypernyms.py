"""Nouns outside the library and the kind that stands for each: a samovar is an urn, so a vase.

The table is esg/lexicon/hypernyms.txt.
"""

from __future__ import annotations

from dataclasses import dataclass

from esg.assets.library.catalogue import Entry, entries_by_name, normalize
from esg.lexicon.hypernyms import hypernyms


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


def kin(text: str, *, whole: bool = False) -> Kin | None:
    """What the longest known ending of a noun phrase is ("copper samovar" -> samovar).

    Args:
        text: A noun phrase.
        whole: Whether the phrase itself must be known.
    """
    from esg.assets.library.lookup import head_phrase

    words = head_phrase(text).split()
    for start in range(1 if whole and words else len(words)):
        noun = normalize(" ".join(words[start:]))
        wider = hypernyms().get(noun)
        if wider is not None:
            return Kin(noun, wider.concept, wider.kind, wider.longest_cm, wider.mass_kg)
    return None
