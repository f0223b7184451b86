"""Things told apart by a quantity: "the heavier one", "the tallest bottle", "the 2 kg ball"."""

from __future__ import annotations

from collections.abc import Callable, Iterable
import math

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.sizes import dimensions_of, mass_of
from esg.draft.text.elements import Mention
from esg.draft.text.quantities import Amount

Facts = Callable[[str], list[Amount]]
"""The quantities that the prompt tells of a node, wherever it does."""


def rank(m: Mention) -> str:
    """The comparative or superlative of a definite noun phrase, or ""."""
    if m.determiner not in ("the", "this", "that") or m.plural or (m.count or 1) > 1:
        return ""
    return next((a for a in m.adjectives if a in lex.RANKS), "")


def extreme(word: str, things: Iterable[Entity], facts: Facts) -> Entity | None:
    """The one thing that lies at the end a word means; None if two are equal or nothing is known.

    Args:
        word: A key of `lex.RANKS`.
        things: What it may be.
        facts: What the prompt tells of them.
    """
    quantity, sign = lex.RANKS[word]
    known = [(sign * v, e) for e in things if (v := _value(e, quantity, facts)) is not None]
    known.sort(key=lambda pair: pair[0], reverse=True)
    if len(known) < 2 or math.isclose(known[0][0], known[1][0], rel_tol=1e-9):
        return None
    return known[0][1]


def _value(e: Entity, quantity: str, facts: Facts) -> float | None:
    dimension = {"speed": "speed", "mass": "mass"}.get(quantity, "length")
    told = [a.middle for a in facts(e.id) if a.dimension == dimension]
    if quantity == "speed" or (told and not (e.mass_prescribed or e.dimensions_prescribed)):
        return told[0] if told else None
    size = dimensions_of(e)
    if quantity == "mass":
        return mass_of(e, size)
    if quantity == "size":
        return size[0] * size[1] * size[2]
    return {"height": size[2], "length": max(size), "width": min(size[:2])}[quantity]


def told_apart(m: Mention, e: Entity, facts: Facts) -> bool:
    """Whether a noun phrase states another mass or size than the one that a thing has."""
    return _agrees(m, e, facts) is False


def same_quantity(m: Mention, e: Entity, facts: Facts) -> bool:
    """Whether a noun phrase states the mass or the size that a thing was said to have."""
    return _agrees(m, e, facts) is True


def _agrees(m: Mention, e: Entity, facts: Facts) -> bool | None:
    """Whether what a noun phrase states is what a thing has; None if one of both is not told."""
    stated = _stated(m)
    known = _known(e, stated.dimension, facts) if stated is not None else []
    if stated is None or not known:
        return None
    return any(math.isclose(stated.middle, x, rel_tol=1e-6) for x in known)


def measured(m: Mention) -> bool:
    """Whether a noun phrase states a mass or a size."""
    return _stated(m) is not None


def _stated(m: Mention) -> Amount | None:
    """The mass, else the length, that tells a thing from others of its kind."""
    said = [a for a in m.amounts if not a.shares and not a.sides]
    said.sort(key=lambda a: a.dimension != "mass")
    return next((a for a in said if a.dimension in ("mass", "length")), None)


def _known(e: Entity, dimension: str, facts: Facts) -> list[float]:
    if dimension == "mass" and e.mass_prescribed and e.mass_kg is not None:
        return [e.mass_kg]
    if dimension == "length" and e.dimensions_prescribed and e.dimensions_cm is not None:
        return list(e.dimensions_cm)
    return [a.middle for a in facts(e.id) if a.dimension == dimension]
