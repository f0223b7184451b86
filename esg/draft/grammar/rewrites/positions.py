"""Members told by where they are: "the one in front", "the cart on the right"."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.conditions import mention_at, word_at
from esg.draft.text.elements import Element, Mention, Verb, Word

_ADVERBS = {
    "ahead": "front", "in front": "front", "front": "front", "behind": "rear", "beside": "other",
    "opposite": "other",
}  # fmt: skip
_RELATIVE = {"in front of": "front", "ahead of": "front", "behind": "rear"}
"""Where a member is from another one, by the preposition before that one."""
_ENDS = {
    "front": "front", "lead": "front", "back": "rear", "rear": "rear", "middle": "middle",
    "center": "middle", "centre": "middle", "left": "left", "right": "right", "far left": "left",
    "far right": "right", "end": "last",
}  # fmt: skip
_IT = lex.word_set("it")
NEIGHBOUR = "@beside"
"""Adjective of a phrase that says which neighbour of the subject, or of "it", is meant."""


def positioned(elements: list[Element]) -> list[Element]:
    """Makes adjectives of the places by which one of several is told.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        e = elements[i]
        used = 0
        if isinstance(e, Mention) and _picks(e):
            used = _place(elements, i, e)
        out.append(e)
        i += 1 + used
    return out


def _picks(m: Mention) -> bool:
    """Whether a phrase may be one of several: "the one", "the cart", nothing else said of it."""
    if m.determiner != "the" or m.adjectives or m.plural or m.letters or m.possessor is not None:
        return False
    return m.pronoun == "one" or (m.noun is not None and not m.pronoun and not m.attribute)


def _place(elements: list[Element], i: int, m: Mention) -> int:
    """Reads the place after a mention into it; returns how many elements it took."""
    where, after = word_at(elements, i + 1), mention_at(elements, i + 2)
    if where is None:
        return 0
    named = m.pronoun != "one"
    if where.low in _RELATIVE and after is not None and after.pronoun in _IT:
        last = not named and mention_at(elements, i + 3) is None
        return _read(m, _RELATIVE[where.low], after.end, 2, beside=True) if last else 0
    if not named and where.low in _ADVERBS and after is None:
        return _read(m, _ADVERBS[where.low], where.end, 1, beside=True)
    front = word_at(elements, i + 2)
    if where.low == "in" and front is not None and front.low == "front":
        return 0 if named else _read(m, "front", front.end, 2, beside=True)
    if where.low not in ("in", "on", "at", "to") or after is None:
        return 0
    place = _ENDS.get(after.head or (after.adjectives or [""])[-1], "")
    bare = not after.adjectives or (after.pronoun == "one" and len(after.adjectives) == 1)
    of = word_at(elements, i + 3)
    if not place or not bare or after.possessor is not None or (of is not None and of.low == "of"):
        return 0
    if after.determiner not in ("", "the") or (named and not _goes_on(elements, i + 3)):
        return 0
    beside = where.low == "in" and place == "front" and not after.determiner
    return 0 if beside and named else _read(m, place, after.end, 2, beside=beside)


def _goes_on(elements: list[Element], k: int) -> bool:
    """Whether the clause goes on with a verb, or ends ("slides into the box on the left.")."""
    e = elements[k] if k < len(elements) else None
    return e is None or isinstance(e, Verb) or (isinstance(e, Word) and e.low in ".,;:!?")


def _read(m: Mention, place: str, end: int, used: int, beside: bool = False) -> int:
    m.adjectives.append(place)
    if beside and place != "other":
        m.adjectives.append(NEIGHBOUR)
    m.end = max(m.end, end)
    return used
