"""Several alike things that a clause lets fall: each of them does, at once or in turn."""

from __future__ import annotations

from esg.draft.discourse.core import entity_of, movable
from esg.draft.discourse.record import Discourse
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Mention
from esg.graph.models import NodeEvent

MOST = 12
"""Most members of a plural that fall together, of which each has an event of its own."""
DOWN = frozenset({"drop", "fall"})
"""Senses of which each of several that are let go does the same."""
_AS_ONE = frozenset({"row", "pins", "rack", "stack", "column", "queue"})
_STANDING = frozenset({"row", "pins"})
"""How dominoes and pins stand where nothing is told."""
_LANDS = (NodeEvent.COLLISION, NodeEvent.ENTER_REGION)
IN_TURN = "one by one"


def come_down(d: Discourse, f: Frame, m: Mention) -> bool:
    """ "Six cubes are dropped", "four balls fall": whether it names several that all do."""
    if f.verb.sense not in DOWN or not 2 <= len(m.entities) <= MOST or m.single:
        return False
    sent = f.object if f.object is not None and not f.verb.passive else f.subject
    if m is not sent or not all(movable(d, i) for i in m.entities):
        return False
    if any(i in d.timeline.tracks for i in m.entities):
        return False
    if f.verb.sense == "drop" and not m.pattern and not m.adjectives:
        for e in (entity_of(d, i) for i in m.entities):
            e.pattern = "scatter" if e.pattern in _STANDING else e.pattern  # no row in the air
    return all(entity_of(d, i).pattern not in _AS_ONE for i in m.entities)


def mates_event(
    d: Discourse, kind: NodeEvent, participants: tuple[str, ...], f: Frame
) -> tuple[str, None] | None:
    """The event of a mate in the same fall, which is told no time from it.

    Args:
        kind: What is about to happen.
        participants: Whom it happens to; the first falls.
        f: The clause that tells it.
    """
    group = entity_of(d, participants[0]).group
    if f.verb.sense not in DOWN and kind is not NodeEvent.BOUNCE:
        return None
    own = [n for g, n in d.times.of_frame if g is f]
    told = [n for n in d.timeline.nodes if n.id in own and n.event is kind]
    mates = [n for n in told if n.participants[0] != participants[0]]
    several = group is not None or any(entity_of(d, n.participants[0]).group for n in mates)
    return (mates[-1].id, None) if mates and several else None


def lands_in_turn(kind: NodeEvent, f: Frame) -> bool:
    """ "Falls into a bucket one by one": whether an event comes after that of the mate before."""
    return IN_TURN in f.adverbs and kind in _LANDS
