"""How people and animals hold themselves, as statements."""

from __future__ import annotations

from esg.draft.discourse.proposition import Clause
from esg.draft.discourse.record import Discourse, Posing
from esg.draft.statements.book import Told
from esg.graph.models import Predicate


def poses_told(d: Discourse, clause: Clause) -> list[Posing]:
    """The postures that a clause tells of."""
    at = clause.frame.verb.start
    return [p for p in d.moves.postures if p.words[0] == at < p.words[1]]


def postures(told: Told) -> None:
    """Every posture that is told or follows from what is: at first, for a while, or at the end."""
    d, book = told.d, told.book
    for k, p in enumerate(d.moves.postures):
        later = [o for o in d.moves.postures[k + 1 :] if o.actor == p.actor]
        after = {e.from_ for e in d.timeline.edges if e.actor == p.actor}
        if p.node is None:
            when = "start" if later or after else "throughout"
        else:
            when = "start..end" if later or p.node in after else "end"
        start, end = p.words
        if start == end:
            end = next((o.words[1] for o in later), end)
        book.add(Predicate.POSTURE, start, end, object=(p.actor,), noun=p.posture, when=when)
