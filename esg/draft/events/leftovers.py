"""Quantities of a clause that its verb has no use for, and what they belong to instead."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import amounts_of
from esg.draft.discourse.record import Discourse
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount

_LASTS = re.compile(r"(?:over|(?:with)?in) the (?:course|space) of|within|inside|in under", re.I)
SETS_OFF = lex.word_set("sets off")


def hand_on(d: Discourse, f: Frame) -> None:
    """What is left of a clause after its verb has been read."""
    for p, a in amounts_of(d, f):
        if a.dimension == "time":
            _lasts_until(d, f, p, a)


def _lasts_until(d: Discourse, f: Frame, p: str, a: Amount) -> None:
    """ "closes the gap in 2 s and hits it": the time of what comes next in the sentence."""
    if p not in ("in", "within", "over") and not _LASTS.match(a.text):
        return
    d.times.gap, d.times.gap_of = a, f
