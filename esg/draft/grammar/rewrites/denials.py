"""Contacts with none: the rows `denials` of the table, where a word of the text denies one."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.patterns import rewrite
from esg.draft.text.elements import Element, Mention, Word

_DENYING = lex.word_set("denying")


def deny(elements: list[Element]) -> list[Element]:
    """Puts denied contacts into plain order ("touches neither", "hits A, but not B").

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    denied = any(_denies(e) for e in elements)
    return rewrite(elements, reading="denials") if denied else elements


def _denies(e: Element) -> bool:
    if isinstance(e, Word):
        return e.low in _DENYING
    if not isinstance(e, Mention):
        return False
    return e.determiner == "no" or bool({e.head, *e.text.lower().split()[:1]} & _DENYING)
