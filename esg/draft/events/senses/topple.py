"""Verbs of what a hit leads to: knock, send, give, topple, scatter."""

from __future__ import annotations

import itertools
import re

from esg.draft.discourse.core import entity_of, kind_of, mark_used, movable, quantity_of
from esg.draft.discourse.places import fits_on, set_free
from esg.draft.discourse.record import Discourse
from esg.draft.events.acts import add_event, add_hit, kinematics
from esg.draft.events.consequences import (
    already_hit,
    consequence,
    knock_on,
    passed_on,
    struck_before,
)
from esg.draft.events.hanging import hanging
from esg.draft.events.motions import moves_on_it, start_motion
from esg.draft.events.roles import doer_and_done
from esg.draft.events.senses.contact import whose_way
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import moved_by_others, representatives, speed_after, time_of
from esg.draft.events.told import at_rest, happened, mates_of, things, traits_of
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent

_ROW = re.compile(r"(?: \w+){0,4} in (?:an?|one) (?:\w+ )?(?:row|line)\b", re.IGNORECASE)
"""Says that things stand in a row, after them: "three bottles standing in a row"."""


@sense("knock")
def read_knock(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    s, o = doer_and_done(f, s, o)
    if already_hit(d, f, s, o):
        mark_used(d, f, "consequence of the collision")
    elif s:
        kinematics(d, f, s, o)
        add_hit(d, f, s, o, time_of(d, f))
    _topples_too(d, f, s, o)
    knock_on(d, f, o)
    consequence(d, f, o)


def _topples_too(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """A member of a row that knocks over the next one falls over itself."""
    for a in s[:1]:
        upright = kind_of(d, a) in ("domino", "pin") or "topples" in traits_of(d, a)
        fallen = happened(d, NodeEvent.TOPPLE, a)
        if upright and not fallen and moved_by_others(d, a) and {*mates_of(d, a)} & {*o}:
            add_event(d, NodeEvent.TOPPLE, (a,), f, None)


@sense("cause")
def read_cause(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "sends a can off the shelf", "forces a cyclist to brake"."""
    mark_used(d, f, "consequence")
    if f.verb.passive:
        s, o = [], s
    if not o or f.verb.lemma not in ("send", "force"):
        return
    if s and f.causer is None and not already_hit(d, f, s, o):
        if kind_of(d, s[0]) != "person":
            add_hit(d, f, s, o, time_of(d, f))
        else:
            start_motion(d, f, o)
    knock_on(d, f, o)
    consequence(d, f, o)


@sense("lead")
def read_lead(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    mark_used(d, f, "consequence")


@sense("give")
def read_give(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    body = o or (s if f.verb.passive else [])  # "is given a speed of 4 m/s"
    found = quantity_of(d, f, "speed")
    if found is not None and body and not speed_after(d, body[0], found[1]):
        d.moves.stated[body[0]] = found[1]
    mark_used(d, f, "speed after the collision")


@sense("topple")
def read_topple(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """Falls over by itself, or because of what knocks it over."""
    if s and not o and _only_falls(d, f, s):
        read_as(d, "fall", f, s, o)
        return
    set_free(d, o or s)
    s, o = _knocker(d, f, s, o)
    movers = [m for m in s if kind_of(d, m) != "person"] or s
    # tipping a thing over is no blow
    tipped = f.verb.lemma == "tip" and all(kind_of(d, m) == "person" for m in movers)
    if o and movers and not tipped and not already_hit(d, f, movers, o):
        if _one_after_another(d, f, movers, o):
            return
        add_hit(d, f, movers[:1], o, time_of(d, f))
    bodies = representatives(d, o, s) if o else representatives(d, s, [])
    _topples_too(d, f, s, bodies if o else [])
    for b in bodies:
        if not movable(d, b) or (len(s) > 1 and happened(d, NodeEvent.TOPPLE, b)):
            continue  # "a bike falls over, and all the bikes fall over": once
        struck_before(d, f, b)
        _goes_over(d, f, b, by_itself=not o)
    knock_on(d, f, bodies)


def _only_falls(d: Discourse, f: Frame, bodies: list[str]) -> bool:
    """ "A pallet tips off a forklift", "the ball drops on her side": it does not fall over."""
    if f.phrase("off", "out of") is not None and not f.verb.passive:
        return True
    return f.verb.lemma == "drop" and all("round" in traits_of(d, i) for i in bodies)


def _goes_over(d: Discourse, f: Frame, body: str, *, by_itself: bool) -> None:
    """A thing falls over: hit, passed on to, or set in motion for it."""
    if by_itself and body not in d.timeline.tracks:
        body = _collapsing(d, body)
    if by_itself and at_rest(d, body):
        passed_on(d, f, body)
    if at_rest(d, body):
        if by_itself and fits_on(d, body, next(iter(things(f.phrase("on"))), body)):
            moves_on_it(d, f, [body])  # "falls flat on the table"
        start_motion(d, f, [body], "slide")
    add_event(d, NodeEvent.TOPPLE, (body,), f, time_of(d, f))


def _one_after_another(d: Discourse, f: Frame, movers: list[str], felled: list[str]) -> bool:
    """Lets something that swings into a row meet the first, and each fall on the next one.

    Its arc leads over those behind. Each topples after its own hit, and not after the last.

    Returns:
        Whether that is what the clause tells.
    """
    if len(felled) < 2 or not hanging(d, movers) or not _in_a_row(d, felled):
        return False
    pairs = itertools.pairwise([movers[0], *felled])
    hits = [add_hit(d, f, [a], [b], time_of(d, f) if a in movers else None) for a, b in pairs]
    for body, met in zip(felled, hits, strict=True):
        d.timeline.track(body).at = met[0]
        add_event(d, NodeEvent.TOPPLE, (body,), f, None)
    return True


def _in_a_row(d: Discourse, bodies: list[str]) -> bool:
    """Whether things stand in a row, which is told right after them."""
    told = any(_ROW.match(d.text, m.end) for m in d.mentions if m.entities == bodies)
    for body in bodies if told else []:
        entity_of(d, body).pattern = "row"
    return bool(bodies) and entity_of(d, bodies[0]).pattern == "row"


def _knocker(d: Discourse, f: Frame, s: list[str], o: list[str]) -> tuple[list[str], list[str]]:
    """What knocks over what: "each domino knocks over the next" is the first and the second."""
    next_one = f.object is not None and "next" in f.object.adjectives
    if s and next_one and f.subject is not None and f.subject.determiner in ("each", "every"):
        mates = mates_of(d, s[0])
        s, o = (mates[:1], mates[1:2]) if len(mates) > 1 else (s, o)
    if f.verb.passive:
        s, o = doer_and_done(f, s, o)
        knocked = f.verb.extra.get("contact") and o and not moved_by_others(d, o[0])
        s = s or (whose_way(d, f, o) if knocked else [])
    return s, o


def _collapsing(d: Discourse, body: str) -> str:
    """The top member of a stack that nothing has touched: the bottom one rarely tips."""
    mates = mates_of(d, body)
    stack = entity_of(d, body).pattern == "stack" and mates
    return mates[-1] if stack and not any(i in d.timeline.tracks for i in mates) else body


@sense("scatter")
def read_scatter(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    bodies = o or s
    if o and s and not already_hit(d, f, s, o):
        add_hit(d, f, s[:1], o, time_of(d, f))
    if bodies and kind_of(d, bodies[0]) in ("pin", "domino"):
        add_event(d, NodeEvent.TOPPLE, (representatives(d, bodies, [])[0],), f, None)
    mark_used(d, f, "scatter")
