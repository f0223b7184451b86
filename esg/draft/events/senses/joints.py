"""Verbs of what turns or slides on a joint: opens, closes, swings."""

from __future__ import annotations

import re

from esg.draft.discourse.core import kind_of, mark_used, movable
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.tracks import Motion
from esg.draft.events.acts import add_event, add_hit
from esg.draft.events.consequences import already_hit, struck_before
from esg.draft.events.hanging import (
    BACK_AND_FORTH,
    OTHER_SIDE,
    SHUTTING,
    hanging,
    let_go,
    lies_shut,
    lowered,
    openable,
    row_of,
    row_parts,
    tipping,
    walks_into,
)
from esg.draft.events.roles import doer_and_done
from esg.draft.events.senses.contact import hit_targets
from esg.draft.events.senses.handling import so_often
from esg.draft.events.stated import place_of
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import moved_by_others, time_of
from esg.draft.events.told import at_rest, last_of
from esg.draft.events.told import things as things_of
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import ForceDirection, NodeEvent

_TO_AND_FRO = 3
"""How often what swings back and forth passes its lowest point, at least."""
PASSED_ON = 0.5
"""Share of the angle at which one ball of a cradle is let go by which the last swings out."""


@sense("open")
def read_open(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "The gate swings open", "a ball pushes the door open", "the drawer closes"."""
    doers, moved = doer_and_done(f, s, o) if o or f.verb.passive else ([], s)
    moved = openable(d, moved)
    if lies_shut(d, f, moved):
        f.verb.sense, f.verb.extra = "left_so", {**f.verb.extra, "result": "shut"}
        read_as(d, "left_so", f, s, o)
        return
    last = d.text[f.verb.start : f.verb.end].lower().split()[-1]
    shut = lowered(f) or bool({f.verb.extra.get("result", f.verb.lemma), last} & SHUTTING)
    event = NodeEvent.CLOSE if shut else NodeEvent.OPEN
    note = "opens or closes"
    things = [i for i in doers if movable(d, i) and i not in moved]
    things = [i for i in things if kind_of(d, i) != "person" or walks_into(d, f, moved)]
    _ajar(d, moved, shut)
    if things and not already_hit(d, f, things, moved):
        add_hit(d, f, things[:1], moved, time_of(d, f))
    for body in moved:
        still = at_rest(d, body) and not moved_by_others(d, body)
        if still or (not things and _back_again(d, event, body)):
            d.timeline.move(body, Motion("drive"), ForceDirection.ANY_3D)
        note = add_event(d, event, (body,), f, time_of(d, f))
        d.timeline.track(body).motion = None
    mark_used(d, f, note)
    beneath = f.phrase("under", "beneath", "below", "underneath")
    place(d, moved, things_of(beneath), "under")  # "a trapdoor opens under a crate"
    for word in (f.verb.extra.get("result"), "further", "wide"):
        at = place_of(word, d.text, f) if word in f.adverbs else None
        if at is not None:
            d.scene.used[at] = note


def _ajar(d: Discourse, bodies: list[str], shut: bool) -> None:
    """What closes was open, and what opens was closed, where nothing is told of it before."""
    for body in bodies:
        row = row_of(d, body)
        if row is not None and (shut or row.start) and body not in d.timeline.tracks:
            d.scene.openings.setdefault(body, (row.opened or 0.0) if shut else 0.0)


@sense("left_so")
def read_left_so(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "The lid stands open until a coconut drops on it", "it lies shut": how it starts."""
    note, shut = "how it starts", f.verb.extra["result"] in SHUTTING
    for body in openable(d, s):
        row = row_of(d, body)
        if row is not None and body not in d.timeline.tracks:
            d.scene.openings.setdefault(body, 0.0 if shut else row.opened or 0.0)
    mark_used(d, f, note)
    at = place_of(f.verb.extra["result"], d.text, f)
    if at is not None:
        d.scene.used[at] = note


@sense("tip")
def read_tip(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "A seesaw tips to the other side": by what landed on it, else of its own accord."""
    doers, moved = doer_and_done(f, s, o) if o or f.verb.passive else ([], s)
    moved = tipping(d, moved)
    if doers and not already_hit(d, f, doers, moved):
        add_hit(d, f, doers[:1], moved, time_of(d, f))
    for body in moved:
        if at_rest(d, body) and not moved_by_others(d, body):
            d.timeline.move(body, Motion("drive"), ForceDirection.ANY_3D)
        note = add_event(d, NodeEvent.OPEN, (body,), f, time_of(d, f))
        d.timeline.track(body).motion = None
        mark_used(d, f, note)
    way = OTHER_SIDE.search(d.text, f.verb.end)
    if moved and way is not None:
        d.scene.used[way.span()] = "tips"


@sense("swing")
def read_swing(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "A pendulum swings into a box", "the lamp sways": what hangs is let go, or was hit."""
    doers, hung = doer_and_done(f, s, o) if o or f.verb.passive else ([], s)
    hung = hanging(d, hung) or ([] if o else hanging(d, _sat_on(d, f, s)))
    if not hung:
        opens = bool(openable(d, o or s))
        if opens:
            f.verb.sense = "open"
        read_as(d, "open" if opens else "swing_round", f, s, o)
        return
    things = [i for i in doers if movable(d, i) and i not in hung]
    if things and not already_hit(d, f, things, hung):
        add_hit(d, f, things[:1], hung, time_of(d, f))
    for body in hung:
        struck_before(d, f, body)
    pushed = [body for body in hung if _handed_on(d, f, body)]
    let_go(d, f, [body for body in hung if body not in pushed])
    met = f.phrase("at", "into", "against", "through", "on") is not None
    met = met and not {*hung} & d.scene.sprung  # "bobs up and down on a spring"
    target = [i for i in hit_targets(f, s, o) if i not in hung] if met else []
    note = "swings"
    if target:
        add_hit(d, f, hung[:1], target, time_of(d, f))
    elif "down" not in f.adverbs or "up" in f.adverbs:  # "swings down and hits": the way there
        for body in hung:
            if body in pushed:  # it comes back to its lowest point, and stays there
                drawn = max(abs(v) for v in map(d.scene.openings.get, row_parts(d, body)) if v)
                note = add_event(d, NodeEvent.OPEN, (body,), f, time_of(d, f))
                opened = d.timeline.node(note)
                assert opened is not None
                opened.extra["turn_degrees"] = PASSED_ON * drawn
                continue
            note = node = add_event(d, NodeEvent.SWING, (body,), f, time_of(d, f))
            so_often(d, f, node)
            draft, often = d.timeline.node(node), BACK_AND_FORTH.search(d.text, f.verb.end)
            if draft is not None and often is not None:
                draft.extra.setdefault("times", _TO_AND_FRO)
                words = re.finditer(r"\w+", often[0])
                spans = [(often.start() + w.start(), often.start() + w.end()) for w in words]
                d.scene.used |= dict.fromkeys([often.span(), *spans], node)
    mark_used(d, f, note)


def _sat_on(d: Discourse, f: Frame, s: list[str]) -> list[str]:
    """ "A boy swings on a swing", "a girl sits on a swing and swings": what carries who swings."""
    told = hanging(d, things_of(f.phrase("on", "in")))
    seats = told if len(told) == len(s) else told[:1] * len(s)
    for who, seat in zip(s, seats, strict=False):
        if who not in d.scene.supported_by:
            place(d, [who], [seat], "on")
    on = [d.scene.supported_by[i] for i in s if i in d.scene.supported_by]
    return [*dict.fromkeys(on)]


@sense("let_go")
def read_let_go(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "A pendulum is released at 40 degrees", "the wrecking ball is let go"."""
    hung = hanging(d, s if f.verb.passive or not o else o)
    if not hung:
        read_as(d, "drop", f, s, o)
        return
    let_go(d, f, hung)
    mark_used(d, f, "let go")


def _back_again(d: Discourse, event: NodeEvent, body: str) -> bool:
    """ "A cow pushes the gate open ... it swings shut behind her": no blow does that."""
    last = last_of(d, body)
    return last is not None and {last.event, event} == {NodeEvent.OPEN, NodeEvent.CLOSE}


def _handed_on(d: Discourse, f: Frame, body: str) -> bool:
    """Lets the part of a row that was let go hit its neighbour, whose blow goes on to `body`."""
    row = row_parts(d, body)
    sent = next((i for i in row if i in d.scene.openings and i != body), None)
    if sent is None:
        return False
    beside = row[row.index(sent) + (1 if row.index(body) > row.index(sent) else -1)]
    first = d.timeline.tracks.get(beside)
    if first is None or not first.hit:
        add_hit(d, f, [sent], [beside], time_of(d, f))
    if body != beside and at_rest(d, body):
        # the balls between them stay where they are: one blow goes through all of them
        first, last = d.timeline.track(beside), d.timeline.track(body)
        last.at, last.hit, last.role = first.at, True, first.role
    return True
