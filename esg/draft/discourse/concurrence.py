"""Events that happen together, and several times in one clause."""

from __future__ import annotations

from dataclasses import replace
import re

from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.windows import Draft
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount
from esg.graph.models import EventConstraint, NodeEvent, Quantity

_GOES_ON = re.compile(r"\b(?:then|next|afterwards?|later|finally|subsequently)\b", re.IGNORECASE)


def one_time_each(f: Frame) -> list[Frame]:
    """ "The cars brake after 2 s and 3 s", "hits A at 1 s and B at 3 s": a clause for each time."""
    timed = [p for p in f.phrases if p.amount is not None and p.amount.dimension == "time"]
    at = [p for p in timed if p.prep in ("after", "at", "in", "")]
    s, o = f.subject, f.object
    if len(at) < 2 or len(at) != len(timed):
        return [f]
    if o is not None and len(o.coordinated) + 1 == len(at):
        things = [o, *o.coordinated]
        more = [{i for x in things[k + 1 :] for i in x.entities} for k in range(len(things))]
        own = [[i for i in x.entities if i not in m] for x, m in zip(things, more, strict=True)]
        objects = [replace(x, entities=e, coordinated=[]) for x, e in zip(things, own, strict=True)]
        parts = [replace(f, object=x) for x in objects]
    elif s is not None and len(s.entities) >= len(at) and s.count in (None, len(at)):
        members = [replace(s, entities=[i], coordinated=[], amounts=[]) for i in s.entities]
        parts = [replace(f, subject=x) for x in members]
    else:
        return [f]
    rest = [p for p in f.phrases if p not in timed]
    preps = [at[0].prep or "after", *["at" for _ in at[1:]]]  # all from the start
    times = [replace(p, prep=prep) for p, prep in zip(at, preps, strict=True)]
    return [replace(x, phrases=[*rest, t]) for x, t in zip(parts, times, strict=False)]


def partner_of(
    d: Discourse, kind: NodeEvent, participants: tuple[str, ...], f: Frame
) -> tuple[str, Quantity] | None:
    """The event that one about to be added goes with, and the time between them [s].

    Args:
        kind: What is about to happen.
        participants: Whom it happens to; the first moves.
        f: The clause that tells it.
    """
    told = d.times.of_frame
    alike = {n.id for n in d.timeline.nodes if n.event is kind}
    own = [n for g, n in told if g is f and n in alike and _other_story(d, n, participants)]
    if own and "simultaneously" in f.adverbs:
        return own[0], 0.0
    before = [(g, n) for g, n in told if g is not f and g.sentence >= f.sentence - 1]
    opens = bool(before) and before[0][0].link == "simultaneously" and f.link == "then"
    opens = opens and before[0][0].sentence == f.sentence  # "At that moment X hits Y and Z hits W"
    together = f.link == "simultaneously" or opens
    if own or not before or not together or not _other_story(d, before[-1][1], participants):
        return None
    return before[-1][1], 0.0


def _other_story(d: Discourse, node: str, participants: tuple[str, ...]) -> bool:
    """Whether an event is another mover's, and not what set this one in motion."""
    other = d.timeline.node(node)
    track = d.timeline.tracks.get(participants[0])
    caused = track is not None and track.at == node
    return other is not None and other.participants[0] != participants[0] and not caused


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


def coincide(d: Discourse, draft: Draft, partner: tuple[str, Quantity | None] | None) -> None:
    """Adds the time between an event and its partner."""
    timed = any(c.quantity in ("time_since", "time_to_stop") for c in draft.constraints)
    since, value = partner or ("", None)
    if value is None or timed or draft.time is not None:
        return
    actor = draft.participants[0]
    draft.constraints.append(
        EventConstraint(quantity="time_since", object=actor, value=value, since=since)
    )
