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
from esg.draft.events.told import happened
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention
from esg.graph.models import NodeEvent


def landing_of(d: Discourse, f: Frame, moved: list[str]) -> bool:
    """Reads where what falls comes down; whether the clause says so."""
    for way in f.phrases:
        if way.prep == "through" and way.mention and opening(d, way.mention.entities):
            way.prep = "by way of"  # "drops through a hatch onto a cart"
    p = f.phrase("onto", "on", "into", "in", "through", "to", "upon")
    if p is None and f.verb.sense in ("fall", "topple"):
        p = f.phrase("against")
    m = p.mention if p is not None else None
    if p is None or m is None:
        return False
    if _on_own_side(d, m, moved):
        mark_used(d, f, "landing")  # "lands on its wheels"
        face = f.verb.sense == "fall" and bool(moved) and bool(m.entities)
        if face and kind_of(d, moved[0]) == "person":
            add_event(d, NodeEvent.TOPPLE, (moved[0],), f, time_of(d, f))  # "flat on his face"
        return True
    if not m.entities or (structural(d, m.entities[0]) and m.start < f.verb.start):
        return False  # "In a café a waiter drops a tray": where, not where to
    other = m.entities[0]
    d.moves.came_down.update(moved)
    for t in [t for t in moved if t != other]:
        if structural(d, other):
            _on_the_ground(d, f, t)
        elif takes_up_from_above(d, other, p.prep) or kind_of(d, other) in ("region", "water"):
            if kind_of(d, other) == "water":
                _off_a_deck(d, f, t)
            enter(d, f, t, other, m, time_of(d, f))
        else:
            add_hit(d, f, [t], m.entities, time_of(d, f))
    _lands_again(d, f, moved, p)
    return True


def _on_own_side(d: Discourse, m: Mention, moved: list[str]) -> bool:
    """ "on its roof", "on his back": a part of what falls itself."""
    if m.head not in lex.BODY_PARTS | lex.OWN_PARTS:
        return False
    built = bool(moved) and kind_of(d, moved[0]) in SELF_POWERED - {"person"}
    if m.determiner == "its" and (built or not m.entities):
        return True
    owned = m.determiner in ("its", "his", "her", "their")
    return owned and bool(m.entities) and not set(m.entities) - set(moved)


def _on_the_ground(d: Discourse, f: Frame, body: str) -> None:
    """A fall to the ground, unless it was in the air: a flight or a jump ends there."""
    lands = f.verb.sense == "land"
    held = body in d.scene.supported_by
    if kind_of(d, body) == "flyer" or (lands and is_airborne(d, body) and not held):
        return
    leaper = kind_of(d, body) in ("person", "animal") and lands
    if leaper and not held and body not in d.scene.heights:
        mark_used(d, f, "end of a jump")
    elif not happened(d, NodeEvent.FALL, body):
        add_event(d, NodeEvent.FALL, (body,), f, time_of(d, f))


def _off_a_deck(d: Discourse, f: Frame, thing: str) -> None:
    """What falls into the water leaves the quay or bridge that was named."""
    decks = [i for i, e in d.world.entities.items() if is_deck(e)]
    told = happened(d, NodeEvent.FALL, thing)
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
