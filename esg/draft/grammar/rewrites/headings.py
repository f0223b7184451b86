"""Headings in front of a colon name nothing: "Curling: ...", "Cart race: two carts ..."."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.conditions import STOPS, is_word, opens
from esg.draft.text.elements import Element, Mention, Verb, Word

_LABELS = lex.word_set("labels")
_STATED = lex.word_set("stated")
_LONGEST = 9
"""Elements of a heading."""


def headings(elements: list[Element]) -> list[Element]:
    """Makes one word of what stands before the colon of a heading.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        colon = _colon(elements, i) if opens(elements, i, out) else 0
        if colon and _heads(elements[i:colon], elements[colon + 1 :], i == 0):
            out.append(Word(elements[i].start, elements[colon].end, "adv", "heading"))
            i = colon + 1
            continue
        out.append(elements[i])
        i += 1
    return out


def _colon(elements: list[Element], i: int) -> int:
    """Where the colon is that ends a heading begun at i; 0 if there is none."""
    for k in range(i + 1, min(i + 1 + _LONGEST, len(elements))):
        if is_word(elements[k], *STOPS):
            return k if is_word(elements[k], ":") else 0
    return 0


def _heads(head: list[Element], rest: list[Element], first: bool) -> bool:
    """Whether the words before a colon are a heading of those behind it."""
    if not any(isinstance(e, (Mention, Verb)) for e in rest[:3]):
        return False
    if len(head) == 1:
        return _topic(head[0])
    told = any(isinstance(e, Verb) and e.form in ("s", "past", "base") for e in rest)
    does = [isinstance(e, Verb) and e.form not in ("pp", "ing") for e in head]
    labelled = first and told and any(map(_label, head))
    return labelled and not any(does[:-1]) and getattr(head[-1], "form", "") != "s"


def _topic(e: Element) -> bool:
    """ "Curling", "Rodeo": no thing that is counted, measured or known."""
    if isinstance(e, Verb):
        return e.form == "ing" and not e.auxiliary
    if not isinstance(e, Mention) or e.plural or (e.noun and e.known):
        return False
    said = e.determiner or e.count or e.letters or e.amounts or e.pronoun or e.coordinated
    return not said and not (e.attribute and e.head in _STATED)


def _label(e: Element) -> bool:
    if isinstance(e, Mention):
        return e.head in _LABELS and not e.amounts
    return (e.lemma if isinstance(e, Verb) else e.low) in _LABELS
