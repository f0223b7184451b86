"""What wobbles: of its own from the start, or after what befalls it."""

from __future__ import annotations

import math

from esg.draft.discourse.core import entity_of, movable, structural
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.sizes import dimensions_of
from esg.draft.discourse.windows import Draft
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.statements.account import nodes_of
from esg.draft.statements.book import Told, span
from esg.draft.statements.looks.lying import cannot
from esg.graph.models import NodeEvent, Predicate
from esg.lexicon.lying import TIPPED_UP

_WOBBLING = frozenset({"wobble", "teeter", "totter"})
_SETTLING = frozenset({"settle"})
_SLENDER_DEG = 28.0
"""A thing wobbles when it is let go if its half width is seen at less from its middle."""
_AS = ("as", "when", "after", "once")
_DOWN = (NodeEvent.TOPPLE, NodeEvent.FALL, NodeEvent.BREAK)


def wobbling(t: Told) -> None:
    """ "A vase wobbles and settles", "a ball hits a bottle; the bottle teeters"."""
    d, shaken = t.d, set[str]()
    for f in t.frames:
        lemma, who = f.verb.lemma.split()[0], tuple(nodes_of(d, f.subject))
        if f.unreal or f.verb.negated or not who:
            continue
        if lemma in _SETTLING and shaken.issuperset(who):
            t.book.add(Predicate.AT_REST, *span(f), object=who, when="end")
        if lemma not in _WOBBLING or any(structural(d, i) for i in who) or cannot(d, who):
            continue
        when = _when(t, f, who)
        if when is None:
            continue
        shaken.update(who)
        if when == "throughout":
            for i in who:
                d.world.entities[i].lies = TIPPED_UP
        t.book.add(Predicate.WOBBLES, *span(f), object=who, when=when)


def _when(t: Told, f: Frame, who: tuple[str, ...]) -> str | None:
    """When things wobble; None if nothing makes them."""
    d = t.d
    made = {d.scene.used.get(span(g)): g for g in t.frames}
    told: list[Draft] = [n for n in d.timeline.nodes if {*n.participants} & {*who}]
    if any(n.event in _DOWN for n in told) or not all(_can(d, i) for i in who):
        return None  # how it got there is part of its fall
    for n in told:
        g = made.get(n.id)
        before = g is not None and (g.verb.start < f.verb.start or g.subordinate in _AS)
        if n.event is NodeEvent.COLLISION and before:
            return f"{n.id}..end"
    moves = any(e.actor in who for e in d.timeline.edges)
    lain = any(d.world.entities[i].lies is not None for i in who)
    later = any(g.verb.start < f.verb.start for k, g in made.items() if d.timeline.node(k or ""))
    apart = all(_leans_deg(d, i) <= _SLENDER_DEG and not entity_of(d, i).group for i in who)
    return None if told or moves or lain or later or not apart else "throughout"


def _can(d: Discourse, node: str) -> bool:
    """Whether a thing leans and comes back: it is not fixed, and no ball."""
    return movable(d, node) and "round" not in entity_of(d, node).noun.traits


def _leans_deg(d: Discourse, node: str) -> float:
    """The lean at which a box of a thing's size falls over [degrees]."""
    length, width, height = dimensions_of(entity_of(d, node))
    return math.degrees(math.atan2(min(length, width), height))
