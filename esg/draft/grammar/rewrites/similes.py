"""Comparisons that say how something happens and name no object: "topples like dominoes"."""

from __future__ import annotations

from esg.draft.text.elements import Element, Mention, Verb, Word


def drop_similes(elements: list[Element]) -> list[Element]:
    """Turns "like a leaf" after a verb into an adverb, so that no leaf is drawn.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.

    Returns:
        The elements; "something like a brick falls" keeps its brick, as no verb precedes it.
    """
    out: list[Element] = []
    told = False
    skip = False
    for e, nxt in zip(elements, [*elements[1:], None], strict=True):
        if skip:
            skip = False
            continue
        if isinstance(e, Word) and e.low in (".", ";", "!", "?"):
            told = False
        told = told or (isinstance(e, Verb) and e.sense not in ("be", "have", "park"))
        like = isinstance(e, Word) and e.kind == "prep" and e.low == "like"
        if like and told and isinstance(nxt, Mention) and nxt.noun is not None:
            loose = nxt.determiner in ("a", "an") or (not nxt.determiner and nxt.plural)
            if loose and not (nxt.letters or nxt.pronoun or nxt.count):
                out.append(Word(e.start, nxt.end, "adv", "like this"))
                skip = True
                continue
        out.append(e)
    return out
