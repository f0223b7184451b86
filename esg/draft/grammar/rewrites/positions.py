"""Members told by where they are: "the one in front", "the cart on the right"."""

from __future__ import annotations

from esg.draft.text.elements import Element, Mention, Word

NEIGHBOUR = "@beside"
"""Adjective of a phrase that says which neighbour of the subject, or of "it", is meant."""
NEIGHBOURS = {
    "in front of": "front", "ahead of": "front", "ahead": "front", "in front": "front",
    "front": "front", "behind": "rear", "beside": "other", "opposite": "other",
}  # fmt: skip
_ENDS = {
    "front": "front", "lead": "front", "back": "rear", "rear": "rear", "middle": "middle",
    "center": "middle", "centre": "middle", "left": "left", "right": "right", "far left": "left",
    "far right": "right", "end": "last",
}  # fmt: skip


def picks(e: Element) -> bool:
    """Whether a phrase may be one of several: "the one", "the cart", nothing else said of it."""
    if not isinstance(e, Mention) or e.determiner != "the" or e.possessor is not None:
        return False
    if e.adjectives or e.plural or e.letters:
        return False
    return e.pronoun == "one" or (e.noun is not None and not e.pronoun and not e.attribute)


def place_of(e: Element) -> str:
    """Where one of several is, by "behind" or "the left"; "" for any other words."""
    if isinstance(e, Word):
        return NEIGHBOURS.get(e.low, "")
    if not isinstance(e, Mention) or e.possessor is not None or e.determiner not in ("", "the"):
        return ""
    bare = not e.adjectives or (e.pronoun == "one" and len(e.adjectives) == 1)
    return _ENDS.get(e.head or (e.adjectives or [""])[-1], "") if bare else ""


def put(m: Mention, where: Element) -> None:
    """Makes an adjective of the place by which one of several is told."""
    place = place_of(where)
    m.adjectives.append(place)
    of_it = isinstance(where, Word) or getattr(where, "determiner", "") == ""
    if of_it and place != "other":
        m.adjectives.append(NEIGHBOUR)
    m.end = max(m.end, where.end)
