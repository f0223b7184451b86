"""Verbs of what a hit leads to: knock, send, give, topple, scatter."""

from __future__ import annotations

from esg.draft.discourse.core import entity_of, kind_of, mark_used, movable, quantity_of
from esg.draft.discourse.places import set_free
from esg.draft.discourse.record import Discourse
from esg.draft.events.acts import add_event, add_hit, kinematics
from esg.draft.events.consequences import (
    already_hit,
    consequence,
    knock_on,
    struck_before,
)
from esg.draft.events.motions import start_motion
from esg.draft.events.senses.contact import whose_way
from esg.draft.events.senses.fall import has_toppled
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import moved_by_others, representatives, speed_after, time_of
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent


@sense("knock")
def read_knock(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if f.verb.passive:
        by = f.phrase("by")
        movers = by.mention.entities if by is not None and by.mention is not None else []
        s, o = list(movers), s
    if already_hit(d, f, s, o):
        mark_used(d, f, "consequence of the collision")
    elif s:
        kinematics(d, f, s, o)
        add_hit(d, f, s, o, time_of(d, f))
    knock_on(d, f, o)
    consequence(d, f, o)


def _topples_too(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """A member of a row that knocks over the next one falls over itself."""
    for a in s[:1]:
        group = entity_of(d, a).group
        fallen = any(n.event is NodeEvent.TOPPLE and a in n.participants for n in d.timeline.nodes)
        upright = kind_of(d, a) in ("domino", "pin") or "topples" in entity_of(d, a).noun.traits
        if group is None or fallen or not upright or not moved_by_others(d, a):
            continue


@sense("cause")
def read_cause(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    mark_used(d, f, "consequence")
    if f.verb.passive:
        o, s = s, []
    if not o:
        return
    if f.verb.lemma in ("send", "force") and s and not already_hit(d, f, s, o) and f.causer is None:
        if kind_of(d, s[0]) != "person":
            add_hit(d, f, s, o, time_of(d, f))
        else:
            start_motion(d, f, o)
    if f.verb.lemma in ("send", "force"):
        knock_on(d, f, o)
        consequence(d, f, o)


@sense("lead")
def read_lead(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    mark_used(d, f, "consequence")


@sense("give")
def read_give(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    body = o
    found = quantity_of(d, f, "speed")
    body = body or s if f.verb.passive else body  # "is given a speed of 4 m/s"
    if found is not None and body and not speed_after(d, body[0], found[1]):
        d.moves.stated[body[0]] = found[1]
    mark_used(d, f, "speed after the collision")


@sense("topple")
def read_topple(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    off = f.phrase("off", "out of")
    if off is not None and not o and s and not f.verb.passive:
        read_as(d, "fall", f, s, o)  # "a pallet tips off a forklift"
        return
    set_free(d, o or s)
    if f.verb.passive:
        by = f.phrase("by")
        agent = list(by.mention.entities) if by is not None and by.mention is not None else []
        knocked = f.verb.extra.get("contact") and not moved_by_others(d, s[0] if s else "")
        o, s = s, agent or (whose_way(d, f, s) if knocked else [])
    if o:
        bodies = representatives(d, o, s)
        movers = [m for m in s if kind_of(d, m) != "person"] or s
        if f.verb.lemma == "tip" and all(kind_of(d, m) == "person" for m in movers):
            movers = []  # tipping a thing over is no blow
        if movers and not already_hit(d, f, movers, o):
            add_hit(d, f, movers[:1], o, time_of(d, f))
        _topples_too(d, f, s, bodies)
    else:
        bodies = representatives(d, s, []) if not f.verb.passive else []
    for b in bodies:
        if not movable(d, b) or (len(s) > 1 and has_toppled(d, b)):
            continue  # "a bike falls over, and all the bikes fall over": once
        struck_before(d, f, b)
        if b not in d.timeline.tracks and not o:
            b = _passed_on(d, f, b)
            b = _collapsing(d, b) if b not in d.timeline.tracks else b
        if b not in d.timeline.tracks or (
            d.timeline.tracks[b].motion is None and not d.timeline.tracks[b].hit
        ):
            start_motion(d, f, [b], "slide")
        add_event(d, NodeEvent.TOPPLE, (b,), f, time_of(d, f))
    knock_on(d, f, bodies)


def _passed_on(d: Discourse, f: Frame, body: str) -> str:
    """Who topples first of a plural one of which was hit.

    "Hits the head pin, and every pin goes down": the head pin. "Hits the first domino; the
    remaining ones fall over": the next one, to which the row passes the blow on.
    """
    e, hit, m = entity_of(d, body), d.moves.last_hit, f.subject
    mates = d.world.groups.get(e.group or "", [])
    if hit is None or hit[1] not in mates or hit[1] == body or m is None:
        return body
    return body


def _collapsing(d: Discourse, body: str) -> str:
    """The top member of a stack that nothing has touched: the bottom one rarely tips."""
    e = entity_of(d, body)
    mates = d.world.groups.get(e.group or "", [])
    tracked = any(i in d.timeline.tracks for i in mates)
    return mates[-1] if e.pattern == "stack" and mates and not tracked else body


def _shaken(d: Discourse, f: Frame, body: str) -> None:
    """ "hits the pallet and the stack of boxes collapses": the blow reaches the stack."""
    last = d.timeline.node(d.timeline.last_event or "")
    if last is None or d.moves.last_hit is None or last.event is not NodeEvent.COLLISION:
        return


@sense("scatter")
def read_scatter(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    bodies = o or s
    if o and s and not already_hit(d, f, s, o):
        add_hit(d, f, s[:1], o, time_of(d, f))
    if bodies and kind_of(d, bodies[0]) in ("pin", "domino"):
        add_event(d, NodeEvent.TOPPLE, (representatives(d, bodies, [])[0],), f, None)
    mark_used(d, f, "scatter")
