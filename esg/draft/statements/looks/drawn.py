"""What is drawn as something else: who looks at the film would not call it by its name."""

from __future__ import annotations

from collections.abc import Iterable

from esg.draft import lexicon as lex
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import Entity
from esg.graph.models import Predicate, Statement


def drawn_otherwise(d: Discourse, said: Iterable[Statement]) -> tuple[Statement, ...]:
    """ "A pulley" that is drawn as a tyre, and what is a box because nothing is known of it.

    Each is owned up to once, where it is first named, unless its words are owned up to already.

    Args:
        d: The discourse, with all of its things.
        said: What is stated and owned up to so far.
    """
    before = [*said]
    owned = [(s.start, s.end) for s in before if s.predicate is Predicate.NOT_REPRESENTED]
    number = max((int(s.id[1:]) for s in before), default=0)
    told, out = set[str](), list[Statement]()
    for m in sorted(d.mentions, key=lambda m: m.start):
        who = [i for i in d.world.resolved.get(id(m), m.entities) if i in d.world.entities]
        others = {i for c in m.coordinated for i in c.entities}  # "a ball and a feather"
        who = [i for i in who if i not in others] or who
        whole = [d.world.entities[i] for i in who if not d.world.entities[i].part]
        shown = {_shown_as(e) for e in whole if not e.lever} - {""}
        if len(shown) != 1 or told & {*who}:
            continue
        told |= {*who}
        if not any(a < m.end and m.start < b for a, b in owned):
            number += 1
            out.append(
                Statement(
                    id=f"s{number}", predicate=Predicate.NOT_REPRESENTED, object=tuple(who),
                    text=d.text[m.start : m.end], start=m.start, end=m.end,
                    note=f"a stand-in is drawn: {shown.pop()}",
                )
            )  # fmt: skip
    return tuple(out)


def _shown_as(e: Entity) -> str:
    """What is drawn for a thing that it is not; "" if it is drawn as what it is."""
    if "structural" in e.noun.traits:
        return ""  # "on the wet tiles": the ground
    own = lex.stand_ins().get(e.head) or lex.stand_ins().get(e.label) if e.known else None
    return own or e.noun.stand_in
