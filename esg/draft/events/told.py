"""Questions about what has been told so far, and notes on clauses, as every reading needs them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from esg.draft.discourse.core import amounts_of, entity_of
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.windows import Draft
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention
from esg.draft.text.quantities import Amount
from esg.graph.models import EventConstraint, NodeEvent, Quantity

_IT = ("it", "that", "this", "which")


def ignore(d: Discourse, f: Frame, why: str) -> None:
    """Notes why a clause tells nothing of its own."""
    d.scene.ignored[(f.verb.start, f.verb.end)] = why


def things(p: Phrase | None) -> list[str]:
    """What a phrase names, nothing without one."""
    return list(p.mention.entities) if p is not None and p.mention is not None else []


def amount(d: Discourse, f: Frame, dimension: str, *preps: str) -> Amount | None:
    """The first quantity of a dimension that a clause tells, after one of the prepositions."""
    told = (
        a for p, a in amounts_of(d, f) if a.dimension == dimension and (p in preps or not preps)
    )
    return next(told, None)


def unread(d: Discourse, a: Amount) -> bool:
    """Whether nothing has used a quantity yet."""
    return (a.start, a.end) not in d.scene.used


def moves(d: Discourse, body: str) -> bool:
    """Whether a motion of a body is under way that has led to no event yet."""
    track = d.timeline.tracks.get(body)
    return track is not None and track.motion is not None and not track.closed


def at_rest(d: Discourse, body: str) -> bool:
    """Whether nothing told so far moves a body."""
    track = d.timeline.tracks.get(body)
    return track is None or (track.motion is None and not track.hit)


def happened(d: Discourse, kind: NodeEvent, body: str) -> bool:
    """Whether an event of a kind has been told of a body."""
    return any(n.event is kind and body in n.participants for n in d.timeline.nodes)


def last_of(d: Discourse, body: str) -> Draft | None:
    """The last event told of a body."""
    return next((n for n in reversed(d.timeline.nodes) if body in n.participants), None)


def has_stopped(d: Discourse, body: str) -> bool:
    """Whether the last that has been told of a body is that it comes to a stop."""
    last = last_of(d, body)
    return last is not None and last.event is NodeEvent.STOP and last.participants[0] == body


def last_event(d: Discourse) -> Draft | None:
    """The last event told."""
    return d.timeline.node(d.timeline.last_event or "")


def recent(d: Discourse) -> list[str]:
    """What the prompt has named, the last first."""
    return [i for ids in reversed(d.world.salience) for i in ids if i in d.world.entities]


def one_that(
    d: Discourse, m: Mention | None, bodies: list[str], can: Callable[[str], bool]
) -> list[str]:
    """ "A hammer hits a melon and it breaks": of those named last what can, where "it" cannot."""
    if m is None or m.pronoun not in _IT or any(map(can, bodies)):
        return bodies
    return next(([i] for i in recent(d) if can(i)), bodies)


def mates_of(d: Discourse, body: str) -> list[str]:
    """The members of the plural that a body belongs to."""
    return d.world.groups.get(entity_of(d, body).group or "", [])


def size_of(d: Discourse, body: str) -> list[float]:
    """Length, width and height [cm]."""
    return list(entity_of(d, body).dimensions_cm or entity_of(d, body).noun.dimensions_cm)


def traits_of(d: Discourse, body: str) -> frozenset[str]:
    """The traits of a body's noun."""
    return entity_of(d, body).noun.traits


Measure = Literal[
    "speed_after", "speed_before", "time_since", "time_to_stop", "distance", "height", "angle"
]


def constrain(
    node: Draft | None,
    quantity: Measure,
    value: Quantity,
    body: str = "",
    since: str | None = None,
    to: str | None = None,
) -> None:
    """States a quantity of an event, of its first participant unless another body is given."""
    if node is not None:
        body = body or node.participants[0]
        told = EventConstraint(quantity=quantity, object=body, value=value, since=since, to=to)
        node.constraints.append(told)
