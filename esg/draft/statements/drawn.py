"""What is drawn as something else: who looks at the film would not call it by its name."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.statements.book import Told
from esg.graph.models import Predicate


def drawn_otherwise(t: Told) -> None:
    """ "A pulley" that is drawn as a tyre, and what is a box because nothing is known of it.

    Each is owned up to once, where it is first named, unless its words are owned up to already.
    """
    d, book = t.d, t.book
    owned = [(s.start, s.end) for s in book.items if s.predicate is Predicate.NOT_REPRESENTED]
    told: set[str] = set()
    for m in sorted(d.mentions, key=lambda m: m.start):
        who = [i for i in d.world.resolved.get(id(m), m.entities) if i in d.world.entities]
        whole = [d.world.entities[i] for i in who if not d.world.entities[i].part]
        shown = {_shown_as(e) for e in whole if not e.lever} - {""}
        if len(shown) != 1 or told & {*who}:
            continue
        told |= {*who}
        if not any(a < m.end and m.start < b for a, b in owned):
            note = f"a stand-in is drawn: {shown.pop()}"
            book.add(Predicate.NOT_REPRESENTED, m.start, m.end, object=tuple(who), note=note)


def _shown_as(e: Entity) -> str:
    """What is drawn for a thing that it is not; "" if it is drawn as what it is."""
    own = lex.stand_ins().get(e.head) or lex.stand_ins().get(e.label) if e.known else None
    return own or e.noun.stand_in
