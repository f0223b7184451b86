"""What sets off after something else, though no word like "then" says so.

A story is told in the order in which it happens: "The bus stops and a woman gets off" says that
she waits for it, and "The dog ran after it" goes on from what "it" has done. What is only going
on at the same time ("is walking by", "while") tells no such order.
"""

from __future__ import annotations

from collections.abc import Iterator
import re

from esg.draft.discourse.antecedents import STATES
from esg.draft.discourse.bearing import bearers
from esg.draft.discourse.core import kind_of
from esg.draft.discourse.proposition import Clause
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import LIMBED
from esg.draft.discourse.timeline import START
from esg.draft.discourse.windows import Draft
from esg.draft.events.courses import measurable
from esg.draft.events.motions import flies_itself, on_the_way_with
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import EdgeEvent, NodeEvent, TimelineEdge

_GOES_ON = ("then", "cause", "until")
_WAS_GOING = frozenset({"brake", "stop", "slow", "swerve", "turn", "continue", "accelerate"})
"""Senses of what does something else than it has done so far."""
_ON = re.compile(r"\s+on(?=\s*[,.;!?]|\s+(?:and|but|until)\b|\s*$)", re.IGNORECASE)
""" "Runs on", "rolls on until": it was on its way."""
_LEFT_SO = STATES | {"left_so"}
KNOWN = frozenset({"the", "this", "that", "these", "those"})


def follow_on(d: Discourse) -> None:
    """Lets those wait who set off after another one's event, by the order of the telling."""
    for clause in d.scene.clauses:
        event = follows(d, clause)
        for actor in fresh(d, clause) if event is not None else []:
            if event is None or actor in event.participants or shaken(d, actor, event):
                continue
            if _would_run(d, clause, actor):
                d.timeline.hold(actor, event.id)


def follows(d: Discourse, clause: Clause) -> Draft | None:
    """The last event that is over when a clause about others begins; None if none is told."""
    f = clause.frame
    if not steps_on(f) or not clause.movers:
        return None
    for g in (g for g in before(d, f) if not on_the_way_with(f, g)):
        told = [d.timeline.node(n) for h, n in d.times.of_frame if h.verb is g.verb]
        ended = [n for n in told if n is not None and _over(n)]
        if ended:
            linked = f.sentence == g.sentence or goes_back(d, f)
            was_going = f.verb.sense in _WAS_GOING or _on_its_way(d, f)
            sets_off = linked and not was_going
            return ended[-1] if sets_off or _same_doer(f, g) else None
    return None


def fresh(d: Discourse, clause: Clause) -> list[str]:
    """Those of whom a clause tells the first motion."""
    at = next(k for k, c in enumerate(d.scene.clauses) if c is clause)
    moved = {i for c in d.scene.clauses[:at] for i in c.movers}
    return [i for i in clause.movers if i not in moved and i in d.world.entities]


def goes_back(d: Discourse, f: Frame) -> bool:
    """Whether a clause is about something that was named before it."""
    named = [f.subject, f.object, *(p.mention for p in f.phrases)]
    return any(m is not None and (m.pronoun or m.determiner in KNOWN or m.possessor) for m in named)


def first_leg(d: Discourse, actor: str) -> TimelineEdge | None:
    """The segment in which an actor first moves, after the wait if it waits."""
    legs = [e for e in d.timeline.edges if e.actor == actor]
    first = next((e for e in legs if e.from_ == START), None)
    if first is not None and first.event is EdgeEvent.UNIFORM_MOTION and first.params.speed == 0.0:
        return next((e for e in legs if e.from_ == first.to), None)
    return first


def borne(d: Discourse, actor: str) -> bool:
    """Whether something that moves bears an actor ("the glasses on his tray")."""
    moved = {e.actor for e in d.timeline.edges}
    return any(host in moved for host in bearers(d.scene, actor))


def shaken(d: Discourse, actor: str, event: Draft) -> bool:
    """Whether an event befalls what an actor stands on: that already sets its time."""
    return any(host in event.participants for host in bearers(d.scene, actor))


def inert(d: Discourse, actor: str) -> bool:
    """Whether a thing has no body that acts, and does not fly: a vehicle that falls is one."""
    return kind_of(d, actor) not in LIMBED and not flies_itself(d, actor)


def before(d: Discourse, f: Frame) -> Iterator[Frame]:
    """What a clause goes on from, the last one first: of its sentence or the one before."""
    if not any(g is f for g in d.told):
        return
    at = next(k for k, g in enumerate(d.told) if g is f)
    for g in reversed(d.told[:at]):
        if f.sentence - g.sentence > 1:
            return
        told = any(h.verb is g.verb for h, _ in d.times.of_frame)
        beside = g.subordinate in ("while", "as") or g.link == "while"
        if not (g.unreal or g.verb.negated or beside) and (told or g.verb.sense not in _LEFT_SO):
            yield g


def steps_on(f: Frame) -> bool:
    """Whether a clause tells the next step of a story."""
    beside = f.reduced or f.opening or (f.relative and not f.resulting) or bool(f.subordinate)
    going_on = f.verb.form == "ing" or f.verb.sense in STATES
    return f.link in _GOES_ON and not beside and not going_on and not f.unreal


def _over(n: Draft) -> bool:
    return measurable(n.event) and n.event is not NodeEvent.MISS


def _on_its_way(d: Discourse, f: Frame) -> bool:
    found = _ON.search(d.text, f.verb.start)
    return found is not None and found.start() <= f.verb.end


def _same_doer(f: Frame, g: Frame) -> bool:
    doers = [[*m.entities] if m is not None else [] for m in (f.subject, g.subject)]
    return bool(doers[0]) and doers[0] == doers[1]


def _would_run(d: Discourse, clause: Clause, actor: str) -> bool:
    """Whether nothing else puts an actor's motion off: no event that it goes for ends it, and
    nothing that moves bears it.
    """
    track = d.timeline.track(actor)
    if borne(d, actor):
        return False
    first = next((e for e in d.timeline.edges if e.actor == actor and e.from_ == START), None)
    if track.after is not None:
        return False
    if first is None:
        return True
    leads_to = d.timeline.node(first.to)
    met = leads_to is not None and measurable(leads_to.event)
    same = any(_same_doer(clause.frame, g) for g in before(d, clause.frame))
    return same or not met or first.event is EdgeEvent.TOWARD
