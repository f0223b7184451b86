"""Events that happen together, or a stated time apart: "simultaneously", "2 s apart"."""

from __future__ import annotations

import re

from esg.draft.discourse.core import amounts_of, mark_used
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.windows import Draft
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount
from esg.graph.models import EventConstraint, NodeEvent, Quantity

_APART = re.compile(
    r"\s*(?:apart\b|(?:after|behind|from)\s+(?:one\s+another|each\s+other)\b|in\s+between\b"
    r"|between\s+(?:them|each|the\s+(?:two|hits|impacts|collisions|landings)|hits|impacts)\b"
    r"|intervals?\b)",
    re.IGNORECASE,
)
_GOES_ON = re.compile(r"\b(?:then|next|afterwards?|later|finally|subsequently)\b", re.IGNORECASE)
_INTERVALS = re.compile(r"\bat\s+intervals\s+of\s*$", re.IGNORECASE)
_TOGETHER = frozenset(
    {NodeEvent.COLLISION, NodeEvent.ENTER_REGION, NodeEvent.FALL, NodeEvent.TOPPLE}
    | {NodeEvent.STOP, NodeEvent.REACH, NodeEvent.MISS, NodeEvent.HEADING_REACHED}
)
"""Point events that can be said to happen at the same time."""


def told_apart_by(d: Discourse, a: Amount) -> bool:
    """Whether a time lies between the events of one clause ("hit the wall 2 s apart")."""
    if a.dimension != "time":
        return False
    after = _APART.match(d.text, a.end) is not None
    return after or _INTERVALS.search(d.text, max(0, a.start - 24), a.start) is not None


def partner_of(
    d: Discourse, kind: NodeEvent, participants: tuple[str, ...], f: Frame
) -> tuple[str, Quantity] | None:
    """The event that one about to be added goes with, and the time between them [s].

    Args:
        kind: What is about to happen.
        participants: Whom it happens to; the first moves.
        f: The clause that tells it.
    """
    if kind not in _TOGETHER:
        return None
    own = [n for g, n in d.times.of_frame if g is f and _other_story(d, n, kind, participants)]
    apart = next((a for _, a in amounts_of(d, f) if told_apart_by(d, a)), None)
    if own and apart is not None:
        mark_used(d, apart, "time between the events")
        return own[-1], apart.value
    if own and "simultaneously" in f.adverbs:
        return own[0], 0.0
    if own or f.link not in ("simultaneously", "then"):
        return None
    if f.link == "simultaneously":
        if not any(g.sentence == f.sentence - 1 or g is not f for g, _ in d.times.of_frame):
            d.now.at_once = f.sentence  # "At the same moment X hits Y and Z hits W"
        several = f.subject is not None and len(f.subject.entities) > 1
        before = [n for g, n in d.times.of_frame if g is not f and g.sentence >= f.sentence - 1]
        if several and "simultaneously" in f.adverbs:
            return None
    else:
        if d.now.at_once != f.sentence:
            return None
        before = [n for g, n in d.times.of_frame if g.sentence == f.sentence]
    if before and _other_story(d, before[-1], None, participants):
        return before[-1], 0.0
    return None


def _other_story(
    d: Discourse, node: str, kind: NodeEvent | None, participants: tuple[str, ...]
) -> bool:
    """Whether an event is another mover's, and not what set this one in motion."""
    other = d.timeline.node(node)
    if other is None or other.event not in _TOGETHER or kind not in (None, other.event):
        return False
    track = d.timeline.tracks.get(participants[0])
    caused = track is not None and track.at == node
    return other.participants[0] != participants[0] and not caused


def later(d: Discourse, a: Amount) -> bool:
    """ "2 s later", "with a delay of 2 s": counted from the event told last."""
    return a.measure == "later" or d.text[a.end :].lstrip().lower().startswith("later")


def on_its_own(d: Discourse, f: Frame, participants: tuple[str, ...], time: Time) -> bool:
    """Whether a time counts from the start: nothing that takes part has met with anything yet.

    "The red ball hits a box after 1 s and the blue ball hits a barrel after 2 s" are two
    stories; "later", "then" and a time in front of the clause go on from the one before.
    """
    amount = time[1]
    follows = d.text[: amount.start].rstrip().lower().endswith("after")
    if not follows or amount.start < f.verb.start or amount.measure:
        return False
    begins = f.verb.start if f.subject is None else min(f.subject.start, f.verb.start)
    if _GOES_ON.search(d.text[max(0, begins - 20) : amount.start]):
        return False
    met = {p for n in d.timeline.nodes for p in n.participants}
    return not met & set(participants)


def coincide(d: Discourse, draft: Draft, partner: tuple[str, Quantity] | None) -> None:
    """Adds the time between an event and its partner."""
    timed = any(c.quantity in ("time_since", "time_to_stop") for c in draft.constraints)
    if partner is None or timed or draft.time is not None:
        return
    draft.constraints.append(
        EventConstraint(
            quantity="time_since",
            object=draft.participants[0],
            value=partner[1],
            since=partner[0],
        )
    )
