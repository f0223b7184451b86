"""Who climbs what, as statements: up, down, over, and onto its top."""

from __future__ import annotations

import re

from esg.draft.discourse.proposition import Clause
from esg.draft.discourse.record import Climbing, Discourse
from esg.draft.events.senses.climbing import HALFWAY
from esg.draft.statements.book import Book
from esg.graph.models import Predicate

_AND_DOWN = re.compile(r"\s+and\s+((?:back\s+)?(?:down|up))\b(?!\s+\w+s\b)", re.IGNORECASE)
_DIRECTIONS = {"up": "up", "down": "down", "onto": "up", "over": "across"}


def climbs_told(d: Discourse, clause: Clause) -> list[Climbing]:
    """The climbs that a clause tells of."""
    at = clause.frame.verb.start
    return [c for c in d.moves.climbs if c.words[0] <= at < c.words[1]]


def climbed(book: Book, clause: Clause) -> None:
    """ "Climbs a ladder" is a way up it; "climbs onto a box" ends on it, too."""
    d = book.d
    for c in climbs_told(d, clause):
        edge = next(e for e in d.timeline.edges if e.to == c.node and e.actor == c.actor)
        book.add(Predicate.CLIMBS, *c.words, object=(c.actor,), target=(c.thing,),
                 direction=_DIRECTIONS[c.course], value=edge.params.height_cm)  # fmt: skip
        half = HALFWAY.search(d.text, *c.words)
        if half is not None and edge.params.height_cm is None:
            book.add(Predicate.NOT_REPRESENTED, *half.span(), object=(c.actor,),
                     note="how far it gets is open")  # fmt: skip
        back = _AND_DOWN.match(d.text, c.words[1])
        if back is not None:
            book.add(Predicate.NOT_REPRESENTED, *back.span(1), object=(c.actor,),
                     note="it stays where it has got")  # fmt: skip
        later = any(e.actor == c.actor and e.from_ == c.node for e in d.timeline.edges)
        if c.course == "onto" and not later:
            book.add(Predicate.ENDS_ON, *c.words, object=(c.actor,), target=(c.thing,),
                     when="end")  # fmt: skip
