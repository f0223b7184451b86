"""Words that stand for a noun told before: "a second one", "a standing one"."""

from __future__ import annotations

from itertools import pairwise

from esg.draft.grammar.rewrites.conditions import is_word
from esg.draft.text.elements import Element, Mention, Word

_WAYS = frozenset({"up", "down", "over", "onto", "to", "into", "on", "off", "under", "through"})
_LEVELS = ("below", "above", "beneath", "underneath")


def name_ones(elements: list[Element]) -> list[Element]:
    """Gives "one" the noun that it stands for: "a second one", "a standing one".

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    for i, (e, after) in enumerate(zip(elements, [*elements[1:], None], strict=True)):
        if isinstance(e, Mention) and not is_word(after, "of"):
            _stands_for(e, elements[:i])
            _another_place(e, elements[:i], after)
    return elements


def _in_the_same_phrase(before: list[Element], named: list[Mention]) -> Mention | None:
    """ "A woman with a red umbrella passes a man with a blue one": no blue man."""
    prep = before[-1]
    if not isinstance(prep, Word) or prep.kind != "prep":
        return None
    alike = [e for b, e in pairwise(before) if is_word(b, prep.low) and isinstance(e, Mention)]
    return next((e for e in reversed(alike) if e in named), None)


def _another_place(m: Mention, before: list[Element], after: Element | None) -> None:
    """ "Rolls down a slope, then up another one", "off a shelf onto the one below": one more."""
    told = m.pronoun == "one" and not (m.adjectives or m.coordinated)
    level = m.determiner == "the" and is_word(after, *_LEVELS)
    prep = before[-1] if before else None
    if not told or not (level or m.determiner == "another"):
        return
    ends = after is None or (isinstance(after, Word) and after.kind == "punct")
    joined = ends and isinstance(prep, Word) and prep.low in ("and", "then")
    if not isinstance(prep, Word) or (prep.low not in _WAYS and not joined):
        return
    known = (
        e for e in reversed(before)
        if isinstance(e, Mention) and not (e.attribute or e.pronoun or not e.head)
    )  # fmt: skip
    like = next(known, None)
    if like is None or like.noun is None or like.plural or "structural" in like.noun.traits:
        return
    m.pronoun, m.head, m.noun, m.known = "", like.head, like.noun, like.known
    m.determiner, m.text = "another", f"another {like.head}"


def _stands_for(m: Mention, before: list[Element]) -> None:
    """ "a standing one", "a second one": one more of what was named before."""
    several = m.pronoun == "ones" and (m.count or 0) > 1 and not m.determiner
    one = m.pronoun == "one" and m.determiner in ("a", "an")
    if not (one or several) or not m.adjectives or m.coordinated:
        return
    named = [
        e
        for e in before
        if isinstance(e, Mention) and not (e.attribute or e.pronoun or not e.head or e.letters)
    ]
    if not named or {"other", "next"} & {*m.adjectives}:
        return
    like = _in_the_same_phrase(before, named) or named[-1]
    if any(e.plural or (e.count or 1) > 1 for e in named) or (
        like.noun is not None and like.noun.kind in ("region", "ground")
    ):
        return
    m.pronoun, m.head, m.noun, m.known = "", like.head, like.noun, like.known
    m.plural = several  # "two brown ones"
    m.text = f"{' '.join(a for a in m.adjectives if a[0] != '@')} {like.head}"
