"""Verbs of contact: hit, strike, collide, crash, trip, catch."""

from __future__ import annotations

from functools import partial
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used, movable, quantity_of, structural
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.scene import SELF_POWERED
from esg.draft.events.acts import (
    WAYS,
    add_event,
    add_hit,
    comes_down_a_slope,
    ensure_mover,
    kinematics,
    outcomes,
)
from esg.draft.events.consequences import knock_on
from esg.draft.events.motions import motion, reverse, start_motion
from esg.draft.events.senses.launch import launch_by, motion_of_things, read_launch
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import enterable, time_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import NodeEvent

_MEETING = lex.word_set("meeting (contact)")
_NO_THINGS = lex.word_set("no things")
_PLACES_HIT = lex.word_set("places hit")
_AHEAD = frozenset({"in front of", "before"})
_STUMBLING = frozenset({"trip", "stumble"})
_BESIDE = re.compile(
    r"\s*(?:,\s*)?(?:\(|at|with\s+(?:an?\s+)?(?:constant\s+)?(?:speed|velocity)\s+of|doing|going"
    r"|(?:which\s+is\s+|that\s+is\s+)?(?:moving|travell?ing|driving|rolling|sliding|coming)"
    r"(?:\s+\w+){0,4}\s+(?:at|with))\s*",
    re.IGNORECASE,
)
"""What may stand between a thing and its own speed."""


_FELLING = lex.word_set("felling")


@sense("hit")
def read_hit(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    struck = s if f.verb.passive else o
    out = f.verb.lemma != "take" or "out" in d.text[f.verb.start : f.verb.end + 5].split()
    felled = f.verb.lemma in _FELLING and out and bool(struck)
    if felled and kind_of(d, struck[0]) in ("pin", "domino"):
        read_as(d, "knock", f, s, o)  # "takes out eight pins"
        for pin in struck if len(struck) <= 3 else struck[:1]:
            add_event(d, NodeEvent.TOPPLE, (pin,), f, None)
        return
    time = time_of(d, f)
    if f.verb.passive and f.verb.extra.get("motion") and f.phrase("by") is None:
        f.verb.passive = False  # "is reversed into a lamp post"
        o = [i for i in o if i not in s]
    if f.verb.passive and f.verb.lemma == "stick" and o and f.phrase("by") is None:
        f.verb.passive = False  # "gets stuck in a bush"
    if f.verb.passive:
        by = f.phrase("by")
        by = by or f.phrase("with")
        movers = by.mention.entities if by is not None and by.mention is not None else []
        if not movers:
            movers = whose_way(d, f, s)
        if not movers:
            movers = [
                a for a, t in d.timeline.tracks.items() if t.motion is not None and a not in s
            ][-1:]
        if not movers and s:
            if quantity_of(d, f, "angle") is not None:
                motion_of_things(d, f, s, "throw")
            else:
                motion(d, f, s, None)  # "a cue ball is struck at 3 m/s"
            return
        targets = s
    else:
        movers, targets = s, hit_targets(d, f, s, o)
        if not s and o and f.subject is None:
            # imperative "hit the ball into the goal": a launch
            read_launch(d, f, s, o)
            return
    if (
        movers
        and all(kind_of(d, m) == "person" for m in movers)
        and targets
        and (not f.verb.passive or f.reduced)
        and f.verb.lemma in ("hit", "strike", "tap", "smack", "whack")
        and kind_of(d, targets[0]) in ("ball", "billiard", "sliding")
    ):
        launch_by(d, f, movers, targets)
        return
    host = f.phrase("on", "in", "at")
    if (
        len(movers) >= 2
        and host is not None
        and host.mention is not None
        and targets == host.mention.entities
    ):
        place(d, movers, targets, host.prep)
        targets = []
    over = d.text[f.verb.start : f.verb.end].lower().endswith("over")
    if over and targets and all(map(partial(enterable, d), targets)):
        motion(d, f, movers, None)  # "runs over the hole": a path
        return
    flat = all(map(partial(structural, d), targets))
    if flat and movers and not f.verb.passive and _crashes_down(d, f, movers):
        return
    if not targets and len(movers) >= 2:
        mutual(d, f, movers, time)
        return
    rim = f.object is not None and f.object.head in ("cushion", "rail") and f.object.attribute
    if rim and not targets:
        for mover in movers:
            ensure_mover(d, f, mover, None)
            d.scene.needs.append(("billiard_table", mover))
        d.scene.ignored[(f.verb.start, f.verb.end)] = "a part that every ball touches"
        return
    if not targets and movers and f.object is None and _names_something(d, f):
        d.scene.ignored[(f.verb.start, f.verb.end)] = "what is hit was not understood"
        return
    if not targets and f.object is not None and f.object.head in _NO_THINGS:
        d.scene.ignored[(f.verb.start, f.verb.end)] = "what is hit is no thing"
        return
    if not targets and f.verb.lemma in _STUMBLING:
        mark_used(d, f, "stumbles")
        return
    named = f.object is not None and f.object.attribute and f.object.head not in _PLACES_HIT
    if not targets and named and not f.verb.passive and f.object.determiner in ("a", "an"):
        d.scene.ignored[(f.verb.start, f.verb.end)] = "what is hit was not understood"
        return
    if not targets and movers:
        aimed = d.moves.aim.get(movers[0]) or aim_of_mates(d, movers[0])
        if aimed is not None and aimed != movers[0]:
            targets = [aimed]
        else:
            targets = [
                i
                for ids in reversed(d.world.salience)
                for i in ids
                if i not in movers and not structural(d, i)
            ][:1]
    kinematics(d, f, movers, targets)
    if f.verb.extra.get("motion") == "reverse":
        reverse(d, movers)
    changing = [m for m in movers if _brakes_now(d, m) or comes_down_a_slope(d, m)]
    nodes = add_hit(d, f, movers, targets, time)
    if not o and not f.verb.passive:
        seen = list(targets)
        for p in f.phrases:
            if (
                (p.prep in ("into", "against", "through") or _meets_with(f, p))
                and p.mention is not None
                and not p.mention.attribute
            ):
                extra = [
                    i
                    for i in p.mention.entities
                    if i not in seen and i not in movers and not structural(d, i)
                ]
                seen += extra
                add_hit(d, f, movers, extra)
    tail = f.phrase("off")
    if tail is not None and tail.mention is not None and targets:
        outcomes(d, f, targets[:1])
    elif o and f.phrase("into", "onto", "toward", "towards", "against") is not None and nodes:
        knock_on(d, f, targets[:1])


def whose_way(d: Discourse, f: Frame, struck: list[str]) -> list[str]:
    """ "gets in the way of a tram and is hit", "runs in front of a bus": by that."""
    now = next((k for k, x in enumerate(d.told) if x.verb is f.verb), 0)
    for g in reversed(d.told[:now]):
        if g.sentence < f.sentence - 1:
            break
        about = g.subject is not None and set(g.subject.entities) & {*struck}
        for p in [Phrase("", g.object), *g.phrases] if about else ():
            m = p.mention
            if m is None or (m.part not in WAYS and p.prep not in _AHEAD):
                continue
            if set(m.entities) - {*struck}:
                return [i for i in m.entities if i not in struck and movable(d, i)][:1]
    return []


def caught(d: Discourse, f: Frame, s: list[str]) -> bool:
    """ "is squeezed between it and the wall", "is pinned against a wall by a car"."""
    between, against = f.phrase("between"), f.phrase("against")
    p = between or against
    if p is None or p.mention is None or len(s) != 1:
        return False
    others = [i for i in p.mention.entities if i != s[0]]
    by = f.phrase("by")
    if between is None:
        others = [*(by.mention.entities if by and by.mention else []), *others]
    movers = [i for i in others if movable(d, i) and kind_of(d, i) in SELF_POWERED]
    moving = [i for i in movers if i in d.timeline.tracks] or movers
    if len(others) != 2 or not moving:
        return False
    return True


def _meets_with(f: Frame, p: Phrase) -> bool:
    """ "collides with a van", not "hits the hurdle with his knee"."""
    return p.prep == "with" and f.verb.lemma in _MEETING


def _crashes_down(d: Discourse, f: Frame, movers: list[str]) -> bool:
    """ "crashes to the floor": a fall from where it stands."""
    p = f.phrase("to", "onto", "on", "down")
    if p is None or p.mention is None or not all(map(partial(structural, d), p.mention.entities)):
        return False
    for mover in movers:
        fresh = mover not in d.timeline.tracks and kind_of(d, mover) not in SELF_POWERED
        if mover in d.scene.supported_by or (fresh and p.prep == "to"):
            add_event(d, NodeEvent.FALL, (mover,), f, time_of(d, f))
    return any(m in d.scene.supported_by for m in movers)


def aim_of_mates(d: Discourse, mover: str) -> str | None:
    """ "The first stone misses the can. The second one hits.": the can."""
    kind = entity_of(d, mover).noun.name
    like = [a for a in d.moves.aim if a in d.world.entities and entity_of(d, a).noun.name == kind]
    return d.moves.aim[like[-1]] if like else None


def _names_something(d: Discourse, f: Frame) -> bool:
    """Whether an article follows the verb, so that there is an object that was not read."""
    after = d.text[f.verb.end : f.verb.end + 12].lower().split()
    return bool(after) and after[0] in ("a", "an", "the", "its", "his", "her")


def _brakes_now(d: Discourse, actor: str) -> bool:
    track = d.timeline.tracks.get(actor)
    return track is not None and track.motion is not None and track.motion.mode == "brake"


def hit_targets(d: Discourse, f: Frame, s: list[str], o: list[str]) -> list[str]:
    if o:
        return o
    p = f.phrase("with", "through", "into", "against", "at", "on", "onto", "to", "in")
    if f.verb.lemma in _STUMBLING:
        p = f.phrase("over", "on", "into", "against") or p
    if p is not None and p.mention is not None and not (p.prep == "in" and p.mention.attribute):
        found = [i for i in p.mention.entities if i not in s]
        if found:
            return found
    return []


def mutual(d: Discourse, f: Frame, movers: list[str], time: Time | None) -> None:
    """ "Two cars collide": who moves, who is hit."""
    a, b = movers[0], movers[1]
    moving = [
        m
        for m in (a, b)
        if (t := d.timeline.tracks.get(m)) is not None and (t.motion is not None or t.hit)
    ]
    if not moving:
        driven = any(kind_of(d, m) in SELF_POWERED for m in (a, b))
        driven = driven or all(m in d.moves.stated or m in d.moves.own_speed for m in (a, b))
        for m in (a, b) if driven else (a,):
            if movable(d, m):
                start_motion(d, f, [m], None, b if m == a else a)
    add_hit(d, f, [a], [b], time)
