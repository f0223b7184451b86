"""What people and animals do with arms, head or tail, and whom they face, as statements."""

from __future__ import annotations

import re

from esg.draft.discourse.proposition import Clause
from esg.draft.discourse.record import Discourse, Gesturing
from esg.draft.events.courses import measurable
from esg.draft.statements.book import Told
from esg.draft.statements.order import UNKEPT
from esg.graph.models import Predicate


def gestures_told(d: Discourse, clause: Clause) -> list[Gesturing]:
    """The gestures that a clause tells of."""
    at = clause.frame.verb.start
    return [g for g in d.moves.gestures if g.words[0] == at]


def _since(d: Discourse, g: Gesturing) -> str | None:
    """The event told before it, his own rather than others', after which it is made."""
    if g.meanwhile:
        return None
    kinds = {n.id: n for n in d.timeline.nodes}
    before = [
        (f.verb.start, kinds[n]) for f, n in d.times.of_frame
        if f.verb.start < g.words[0] and n in kinds and measurable(kinds[n].event)
    ]  # fmt: skip
    own = [(at, n) for at, n in before if g.actor in n.participants]
    last = max(own or before, key=lambda x: x[0], default=None)
    return None if last is None else last[1].id


def _out_of_order(told: Told, g: Gesturing) -> None:
    """ "Nods and then walks away": he goes while he nods."""
    d = told.d
    later = (
        c.frame.verb.start for c in d.scene.clauses
        if g.actor in c.movers and c.frame.verb.start > g.words[1]
    )  # fmt: skip
    nxt = min(later, default=None)
    then = None if nxt is None else _THEN.search(d.text, g.words[1], nxt)
    if then is not None:
        told.book.add(Predicate.NOT_REPRESENTED, *then.span(), object=(g.actor,), note=UNKEPT)


_LOOKS = ("looks up", "looks down")
"""Gestures that say where their target is."""
_THEN = re.compile(r"\b(?:then|before|afterwards)\b", re.IGNORECASE)


def gestures(told: Told) -> None:
    """Every gesture that is told, from the event on that is told before it."""
    d, book = told.d, told.book
    together: dict[tuple[int, int], list[Gesturing]] = {}
    for g in d.moves.gestures:
        together.setdefault(g.words, []).append(g)
    for words, alike in together.items():
        first, who = alike[0], tuple(g.actor for g in alike)
        if first.gesture:
            mine = [g for g in d.moves.gestures if g.actor == first.actor and g.gesture]
            later = next(iter(mine[mine.index(first) + 1 :]), None)
            ends = (None if later is None else _since(d, later)) or "end"
            when = f"{_since(d, first) or 'start'}..{ends}"
            when = "throughout" if when == "start..end" else when
            to = (first.target,) if first.target and first.gesture in _LOOKS else ()
            book.add(
                Predicate.GESTURES, *words, object=who, target=to, noun=first.gesture, when=when
            )
            _out_of_order(told, first)
        for target in dict.fromkeys(g.target for g in alike if g.target is not None):
            facing = tuple(g.actor for g in alike if g.target == target)
            goes = any(e.actor in (*facing, target) for e in d.timeline.edges)
            book.add(
                Predicate.FACES, *words, object=facing, target=(target,),
                when="start" if goes else "throughout",
            )  # fmt: skip
