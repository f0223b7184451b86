"""Where what falls or is dropped comes down."""

from __future__ import annotations

from esg.draft.discourse.core import kind_of, mark_used, structural
from esg.draft.discourse.record import Discourse
from esg.draft.events.acts import add_event, add_hit
from esg.draft.events.arrivals import takes_up_from_above
from esg.draft.events.edges import opening
from esg.draft.events.timing import enter, is_airborne, time_of
from esg.draft.events.told import happened
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent


def landing_of(d: Discourse, f: Frame, moved: list[str]) -> bool:
    """Reads where what falls comes down; whether the clause says so."""
    for way in f.phrases:
        if way.prep == "through" and way.mention and opening(d, way.mention.entities):
            way.prep = "by way of"  # "drops through a hatch onto a cart"
    p = f.phrase("onto", "on", "into", "in", "through", "to", "upon")
    m = p.mention if p is not None else None
    if p is None or m is None:
        return False
    if not m.entities or (structural(d, m.entities[0]) and m.start < f.verb.start):
        return False  # "In a café a waiter drops a tray": where, not where to
    other = m.entities[0]
    d.moves.came_down.update(moved)
    for t in [t for t in moved if t != other]:
        if structural(d, other):
            _on_the_ground(d, f, t)
        elif takes_up_from_above(d, other, p.prep) or kind_of(d, other) in ("region", "water"):
            enter(d, f, t, other, time_of(d, f))
        else:
            add_hit(d, f, [t], m.entities, time_of(d, f))
    return True


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
