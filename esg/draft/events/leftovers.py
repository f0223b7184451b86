"""Quantities of a clause that its verb has no use for, and what they belong to instead."""

from __future__ import annotations

from dataclasses import replace
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import amounts_of
from esg.draft.discourse.record import Discourse
from esg.draft.events.timing import start_height
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount

_ON_THE_WAY = lex.word_set("on the way")
_LASTS = re.compile(r"(?:over|(?:with)?in) the (?:course|space) of|within|inside|in under", re.I)
SETS_OFF = lex.word_set("sets off")
_ABOVE = re.compile(r"\s*(?:up\b|above\b|high\b|over the)", re.IGNORECASE)
_FLIGHTS = lex.word_set("flights")


def high_up(d: Discourse, f: Frame, subject: list[str]) -> None:
    """ "floats down from 3 m up": where it starts, and no way."""
    for p, a in amounts_of(d, f) if f.verb.sense in _FLIGHTS and subject else ():
        if a.dimension == "length" and p == "from" and _ABOVE.match(d.text, a.end):
            start_height(d, subject, a)


def hand_on(d: Discourse, f: Frame) -> None:
    """What is left of a clause after its verb has been read."""
    for p, a in amounts_of(d, f):
        if (a.start, a.end) in d.scene.used:
            continue
        if a.dimension == "time":
            _lasts_until(d, f, p, a)


def _lasts_until(d: Discourse, f: Frame, p: str, a: Amount) -> None:
    """ "closes the gap in 2 s and hits it": the time of what comes next in the sentence."""
    if f.verb.sense not in _ON_THE_WAY or a.measure or d.times.gap is not None:
        return
    if f.verb.lemma in SETS_OFF or f.verb.extra.get("start"):
        return  # "after 3 s it drives off and hits": when it sets off
    if p not in ("in", "within", "over") and not _LASTS.match(a.text):
        return
    following = [
        g
        for g in d.told
        if g.sentence == f.sentence and g.verb.start > f.verb.start and not g.unreal
    ]
    if not following or following[0].link == "purpose":
        return
    if a.bound == "max" or p == "within":
        a = replace(a, low=0.05 * a.high)
    d.times.gap, d.times.gap_of = a, f
