"""Toys and models: small, light and loose, whatever the thing itself is."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
import math

from esg.draft import lexicon as lex
from esg.draft.lexicon import Noun

WORDS = lex.word_set("words")
_OWN_SIZE = lex.word_set("own size")
_DRIVEN = frozenset({"vehicle", "cart"})
_SMALLEST_CM, _FROM_CM, _PER_DECADE_CM = 15.0, 60.0, 8.0
_LARGEST_CM = 40.0
DENSITY_KG_PER_CM3 = 2.5e-4
"""Mass over bounding box of hollow plastic: cars of 20 cm weigh 0.3-0.4 kg."""


def length_of_toy(length_cm: float) -> float:
    """Longest side of a toy of something: 15 cm up to 60 cm, 22 cm for a car, 29 cm for a liner."""
    if length_cm <= _FROM_CM:
        return min(length_cm, _SMALLEST_CM)
    grown = _SMALLEST_CM + _PER_DECADE_CM * math.log10(length_cm / _FROM_CM)
    return min(grown, _LARGEST_CM)


def as_toy(noun: Noun, head: str, adjectives: Iterable[str]) -> Noun:
    """The noun as a toy if an adjective makes it one, else itself.

    A model is no toy of a person, and a miniature horse is a horse.

    Args:
        noun: The full-sized thing.
        head: The prompt's own noun.
        adjectives: What stands before it.
    """
    said = WORDS.intersection(adjectives)
    if not said or noun.kind in _OWN_SIZE or {"structural", "decal"} & noun.traits:
        return noun
    if noun.kind in ("animal", "person") and "toy" not in said:
        return noun
    longest = max(noun.dimensions_cm)
    l, w, h = (d * length_of_toy(longest) / longest for d in noun.dimensions_cm)  # noqa: E741
    return replace(
        noun,
        kind="toyvehicle" if noun.kind in _DRIVEN else noun.kind,
        dimensions_cm=(l, w, h),
        mass_kg=max(min(l * w * h * DENSITY_KG_PER_CM3, noun.mass_kg), 0.005),
        material="plastic",
        traits=noun.traits - {"fixed"},
    )
