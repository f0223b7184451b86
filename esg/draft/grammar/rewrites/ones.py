"""Words that stand for a noun told before: "a second one", "a standing one"."""

from __future__ import annotations

from esg.draft.discourse.referents.entities import ORDINALS
from esg.draft.grammar.rewrites.conditions import is_word
from esg.draft.text.elements import Element, Mention


def name_ones(elements: list[Element]) -> list[Element]:
    """Gives "one" the noun that it stands for: "a second one", "a standing one".

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    for i, (e, after) in enumerate(zip(elements, [*elements[1:], None], strict=True)):
        if isinstance(e, Mention) and not is_word(after, "of"):
            _stands_for(e, elements[:i])
    return elements


def _stands_for(m: Mention, out: list[Element]) -> None:
    """ "a standing one", "a third": one more of what was named before."""
    if m.pronoun != "one" or m.determiner not in ("a", "an") or not m.adjectives:
        return
    if "other" in m.adjectives or "next" in m.adjectives or m.coordinated:
        return
    named = [
        e
        for e in out
        if isinstance(e, Mention) and not (e.attribute or e.pronoun or not e.head or e.letters)
    ]
    if not named:
        return
    like = named[-1]
    ordinal = next((ORDINALS[a] for a in m.adjectives if a in ORDINALS), None)
    if ordinal is not None:
        if like.noun is not None and "structural" in like.noun.traits and len(named) > 1:
            like = named[-2]
        if any((e.count or 1) > ordinal and e.head == like.head for e in named):
            return  # one of those told before
        same = [e for e in named if e.head == like.head]
        if not like.plural and ordinal > 1 and len(same) < 2:
            return
    elif any(e.plural or (e.count or 1) > 1 for e in named):
        return
    if like.noun is not None and like.noun.kind in ("region", "ground"):
        return
    m.pronoun, m.head, m.noun, m.known = "", like.head, like.noun, like.known
    m.text = f"{' '.join(a for a in m.adjectives if a[0] != '@')} {like.head}"
