"""Persons that the lexicon does not know."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.text.elements import Element, Mention, Verb, Word

_PEOPLE = ("er", "or", "ist", "ian", "ee", "man", "woman", "boy", "girl")
_PERSONS_DO = lex.word_set("persons do")


def mark_persons(elements: list[Element]) -> list[Element]:
    """Reads "a lumberjack, who ..." as a person: an unknown noun that "who" refers to."""
    before: list[Element] = []
    for e in elements:
        if isinstance(e, Word) and e.kind == "rel" and e.low == "who":
            named = [x for x in before[-2:] if not (isinstance(x, Word) and x.low == ",")]
            m = named[-1] if named else None
            if isinstance(m, Mention) and m.noun is None and m.head and not m.attribute:
                m.noun = lex.nouns()["person"]
        elif isinstance(e, Verb) and before and e.lemma in _PERSONS_DO and not e.passive:
            m = before[-1]
            if isinstance(m, Mention) and m.noun is None and m.head.endswith(_PEOPLE):
                m.noun = None if m.attribute or m.pronoun else lex.nouns()["person"]
        before.append(e)
    return elements
