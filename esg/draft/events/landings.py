"""Where what falls or is dropped comes down."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import kind_of, mark_used, structural
from esg.draft.discourse.decks import is_deck
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import SELF_POWERED
from esg.draft.events.acts import add_event, add_hit, go_into
from esg.draft.events.arrivals import takes_up_from_above
from esg.draft.events.edges import opening
from esg.draft.events.timing import enter, is_airborne, time_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import NodeEvent


def named(d: Discourse) -> list[str]:
    return [i for ids in d.world.salience for i in ids if i in d.world.entities]


def landing_of(d: Discourse, f: Frame, moved: list[str]) -> bool:
    for way in f.phrases:
        if way.prep == "through" and way.mention and opening(d, way.mention.entities):
            way.prep = "by way of"  # "drops through a hatch onto a cart"
    p = f.phrase("onto", "on", "into", "in", "through", "to", "upon")
    if p is None and f.verb.sense in ("fall", "topple"):
        p = f.phrase("against")
    m = p.mention if p is not None else None
    own_side = m is not None and m.determiner == "its" and not m.entities
    built = m is not None and m.determiner == "its" and bool(moved)
    own_side = own_side or (built and kind_of(d, moved[0]) in SELF_POWERED - {"person"})
    if own_side and m is not None and m.head in lex.BODY_PARTS | lex.OWN_PARTS:
        mark_used(d, f, "landing")
        return True
    if p is None or p.mention is None or not p.mention.entities:
        return False
    other = p.mention.entities[0]
    if structural(d, other) and p.mention.start < f.verb.start:
        return False  # "In a café a waiter drops a tray": where, not where to
    owned = p.mention.determiner in ("its", "his", "her", "their")
    itself = not set(p.mention.entities) - set(moved)
    if owned and itself and p.mention.head in lex.BODY_PARTS | lex.OWN_PARTS:
        mark_used(d, f, "landing")  # "lands on its wheels"
        if f.verb.sense == "fall" and moved and kind_of(d, moved[0]) == "person":
            add_event(d, NodeEvent.TOPPLE, (moved[0],), f, time_of(d, f))  # "flat on his face"
        return True
    d.moves.came_down.update(moved)
    for t in moved:
        if t == other:
            continue
        if structural(d, other):
            if kind_of(d, t) == "flyer":
                continue  # it lands
            leaper = kind_of(d, t) in ("person", "animal") and f.verb.sense == "land"
            if leaper and t not in d.scene.supported_by and t not in d.scene.heights:
                mark_used(d, f, "end of a jump")
                continue
            if is_airborne(d, t) and t not in d.scene.supported_by and f.verb.sense == "land":
                continue
            if not any(n.event is NodeEvent.FALL and t in n.participants for n in d.timeline.nodes):
                add_event(d, NodeEvent.FALL, (t,), f, time_of(d, f))
        elif takes_up_from_above(d, other, p.prep) or kind_of(d, other) in (
            "region",
            "water",
        ):
            if kind_of(d, other) == "water":
                _off_a_deck(d, f, t)
            enter(d, f, t, other, p.mention, time_of(d, f))
        else:
            add_hit(d, f, [t], p.mention.entities, time_of(d, f))
    _lands_again(d, f, moved, p)
    return True


def _off_a_deck(d: Discourse, f: Frame, thing: str) -> None:
    """What falls into the water leaves the quay or bridge that was named."""
    decks = [i for i, e in d.world.entities.items() if is_deck(e)]
    told = any(n.event is NodeEvent.FALL and thing in n.participants for n in d.timeline.nodes)
    host = d.scene.supported_by.get(thing)
    towed = [r for r in d.scene.relations if r.source == thing and r.kind == "behind"]
    afloat = any(kind_of(d, r.target) == "watercraft" for r in towed)
    if len(decks) != 1 or told or thing in decks or is_airborne(d, thing) or afloat:
        return
    if host is None:
        place(d, [thing], decks, "on")
    if host in (None, decks[0]):
        add_event(d, NodeEvent.FALL, (thing,), f, None)


def _lands_again(d: Discourse, f: Frame, moved: list[str], first: Phrase) -> None:
    """ "falls into a funnel, out of it onto a ramp and from the ramp into a cup"."""
    if first not in f.phrases:
        return
    for p in f.phrases[f.phrases.index(first) + 1 :]:
        m = p.mention
        if m is None or m.attribute or p.prep not in ("onto", "into", "on"):
            continue
        others = [i for i in m.entities if i not in moved and not structural(d, i)]
        for t in moved if others else []:
            if p.prep == "into":
                go_into(d, f, t, others, p, None)
            else:
                add_hit(d, f, [t], others[:1])
