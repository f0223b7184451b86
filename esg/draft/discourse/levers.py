"""Levers said without their word: a plank that lies across a log, and one of its ends."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, ids_of
from esg.draft.discourse.record import Discourse
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention

_PLANKS = lex.word_set("planks")
_FULCRUMS = lex.word_set("fulcrums")
ACROSS = frozenset({"across", "over", "on", "upon", "atop", "on top of"})
"""Prepositions of what a plank lies across."""
_LIES = frozenset({"lie", "rest", "balance", "sit", "place", "lay", "put", "set", "be"})
_ENDS = re.compile(
    r"\b(?:one|other|opposite|left|right|raised|lower|low|high|far|near|free|upper)\s+(?:end|side)\b",
    re.IGNORECASE,
)


def levers(d: Discourse, f: Frame, boards: list[str]) -> None:
    """ "A plank lies across a log": a seesaw, where something is told of one of its ends.

    Args:
        d: The discourse.
        f: A clause whose noun phrases have been resolved.
        boards: What it says of where something is (node ids).
    """
    if f.verb.lemma not in _LIES or not _ENDS.search(d.text, f.verb.end):
        return
    for p in f.phrases:
        _lever(d, boards, p)


def attached_levers(d: Discourse) -> None:
    """ "One end of a plank on a barrel": the same of a noun."""
    for m, p in d.attached:
        under = p.mention.head if p.mention is not None and p.prep in ACROSS else ""
        if m.head in _PLANKS and under in _FULCRUMS and not m.plural and _ENDS.search(d.text):
            _lever(d, ids_of(d, m), p)


def _lever(d: Discourse, boards: list[str], p: Phrase) -> None:
    m: Mention | None = p.mention
    if m is None or p.prep not in ACROSS or len(boards) != 1:
        return
    board, under = entity_of(d, boards[0]), ids_of(d, m)
    if board.head.split()[-1] in _PLANKS and m.head.split()[-1] in _FULCRUMS and len(under) == 1:
        board.lever, entity_of(d, under[0]).lever = "seesaw", "fulcrum"
        board.noun = lex.nouns()["seesaw"]
