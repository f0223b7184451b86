"""Verbs of what a hit leads to: knock, send, give, topple, scatter."""

from __future__ import annotations

from functools import partial

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used, movable, quantity_of
from esg.draft.discourse.places import fits_on, place, set_free
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import OTHER
from esg.draft.discourse.referents.registry import note_referents
from esg.draft.events.acts import add_event, add_hit, kinematics
from esg.draft.events.consequences import (
    already_hit,
    carried_along,
    consequence,
    knock_on,
    struck_before,
)
from esg.draft.events.motions import motion, start_motion
from esg.draft.events.senses.contact import mutual, read_hit, whose_way
from esg.draft.events.senses.fall import has_toppled
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import moved_by_others, representatives, speed_after, time_of
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent

_LOW_CM = 40.0
"""Height of a pallet or a platform: what hits it hits what stands on it."""

_OF_ONES_OWN = lex.word_set("of ones own")


@sense("knock")
def read_knock(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if f.verb.passive:
        by = f.phrase("by")
        movers = by.mention.entities if by is not None and by.mention is not None else []
        s, o = list(movers), s
    if not o:
        p = f.phrase("into", "against", "on")
        if p is not None and p.mention is not None and s:
            read_hit(d, f, s, [])
        elif len(s) == 2 and not f.phrases and f.verb.lemma in ("knock", "bang", "crack"):
            mutual(d, f, s, time_of(d, f))  # "slide together and knock"
        return
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
        group = entity_of(d, a).group
        fallen = any(n.event is NodeEvent.TOPPLE and a in n.participants for n in d.timeline.nodes)
        upright = kind_of(d, a) in ("domino", "pin") or "topples" in entity_of(d, a).noun.traits
        if group is None or fallen or not upright or not moved_by_others(d, a):
            continue
        if any(entity_of(d, b).group == group for b in o):
            add_event(d, NodeEvent.TOPPLE, (a,), f, None)


@sense("cause")
def read_cause(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    mark_used(d, f, "consequence")
    if f.verb.passive:
        o, s = s, []
    if not o:
        return
    if f.verb.lemma in ("send", "force") and s and not already_hit(d, f, s, o) and f.causer is None:
        if any(g.causer is f and g.verb.sense in _OF_ONES_OWN for g in d.told):
            return  # "forces a cyclist to brake": by being in the way
        if kind_of(d, s[0]) != "person":
            add_hit(d, f, s, o, time_of(d, f))
        else:
            start_motion(d, f, o)
    if f.verb.lemma in ("send", "force"):
        knock_on(d, f, o)
        consequence(d, f, o)
    note_referents(d.world, o)


@sense("lead")
def read_lead(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    mark_used(d, f, "consequence")


@sense("give")
def read_give(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    body = o
    if not body:
        p = f.phrase("to")
        body = p.mention.entities if p is not None and p.mention is not None else []
    found = quantity_of(d, f, "speed")
    body = body or s if f.verb.passive else body  # "is given a speed of 4 m/s"
    if found is not None and body and not speed_after(d, body[0], found[1]):
        d.moves.stated[body[0]] = found[1]
    mark_used(d, f, "speed after the collision")


@sense("topple")
def read_topple(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if f.verb.extra.get("down") and not any(map(partial(_upright, d), s)):
        motion(d, f, s, None)  # what goes down need not topple
        return
    off = f.phrase("off", "out of")
    if off is not None and not o and s and not f.verb.passive:
        read_as(d, "fall", f, s, o)  # "a pallet tips off a forklift"
        return
    set_free(d, o or s)
    if (
        f.subject is not None
        and f.subject.determiner in ("each", "every")
        and f.object is not None
        and "next" in f.object.adjectives
        and s
    ):
        mates = d.world.groups.get(entity_of(d, s[0]).group or "", s)
        s, o = (mates[:1], mates[1:2]) if len(mates) > 1 else (s, o)
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
            _shaken(d, f, b)
            b = _passed_on(d, f, b)
            b = _collapsing(d, b) if b not in d.timeline.tracks else b
        tipped = f.verb.lemma == "tip" and bool(o)
        if tipped and b not in d.timeline.tracks:
            set_free(d, [b])
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
    every = m.determiner in ("every", "all", "each") or m.pronoun in ("all", "they", "each")
    down = any(n.event is NodeEvent.TOPPLE and hit[1] in n.participants for n in d.timeline.nodes)
    if every and not OTHER & {*m.adjectives} and not down:
        return hit[1]
    if e.pattern == "row" and body != mates[-1]:
        carried_along(d, body)
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
    e = entity_of(d, body)
    if last is None or d.moves.last_hit is None or last.event is not NodeEvent.COLLISION:
        return
    mates = d.world.groups.get(e.group or "", [])
    striker, host = d.moves.last_hit
    if e.pattern != "stack" or d.moves.last_hit != last.participants or {striker, host} & {*mates}:
        return
    if body not in d.scene.supported_by and fits_on(d, body, host):
        place(d, mates, [host], "on")
    low = (entity_of(d, host).dimensions_cm or entity_of(d, host).noun.dimensions_cm)[2] <= _LOW_CM
    if low and d.scene.supported_by.get(body) == host:
        carried_along(d, body)


def _upright(d: Discourse, node: str) -> bool:
    traits = entity_of(d, node).noun.traits
    return "topples" in traits or kind_of(d, node) in ("domino", "pin", "plant", "post", "wall")


@sense("scatter")
def read_scatter(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    bodies = o or s
    if o and s and not already_hit(d, f, s, o):
        add_hit(d, f, s[:1], o, time_of(d, f))
    if bodies and kind_of(d, bodies[0]) in ("pin", "domino"):
        add_event(d, NodeEvent.TOPPLE, (representatives(d, bodies, [])[0],), f, None)
    mark_used(d, f, "scatter")
