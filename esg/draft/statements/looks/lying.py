"""How things lie and stand, as statements; of what is so at first, its node is to be drawn so."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, structural
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.sizes import dimensions_of
from esg.draft.discourse.scene import LIVING
from esg.draft.events.stated import start_of
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.statements.account import nodes_of
from esg.draft.statements.book import Told
from esg.draft.statements.looks.contents import named_at
from esg.draft.text.lying import Lain
from esg.draft.text.shown import BEFORE
from esg.graph.models import NodeEvent, Predicate
from esg.lexicon.lying import AS_DRAWN, ups

USED = "how it lies"
"""What became of words of a pose that is held."""
AGAINST = "it runs against it, and does not get in"
AT_THE_KERB = "it lies beside the street"
NOBODY = "nothing in the scene lies so"
ALIVE = "bodies keep their pose"
FIXED = "what it is part of keeps it as it is"
_NOT_DROPPED = frozenset({"building", "structure", "ground", "water", "wall", "door", "place"})
_FELLED = frozenset({"plant", "post", "street"})
"""Kinds of what is fixed where it stands, and lies about once it has come down."""
"""Kinds that do not lie about for being said to lie somewhere."""


def lying(t: Told) -> None:
    """ "Lies on its side", "an overturned car", "lands upside down"; and a bottle that "lies"."""
    d, book = t.d, t.book
    said: set[str] = set()
    for lain in d.scene.fillings.lain:
        who = tuple(i for i in _bearers(t, lain) if not structural(d, i))
        said.update(who)
        why = cannot(d, who)
        if why:
            book.add(Predicate.NOT_REPRESENTED, lain.start, lain.end, object=who, note=why)
            continue
        d.scene.used.setdefault((lain.start, lain.end), USED)
        if _afterwards(t, lain.start, who):
            lain = replace(lain, at_last=True)
        if not lain.at_last:
            who = tuple(i for i in who if _differs(d, i, lain.pose))
        if who:
            _state(t, lain, who)
    for f, who in _lie_about(t):
        if not said & {*who}:
            late = _ENDS.match(d.text, f.verb.start) or _afterwards(t, f.verb.start, who)
            _state(t, Lain("flat", f.verb.start, f.verb.end, at_last=bool(late)), who)
    _run_into(t)
    _across_roads(t)


def _run_into(t: Told) -> None:
    """ "A ball rolls into a bucket that lies on its side": no entry is planned from the side."""
    d = t.d
    into = [n for n in d.timeline.nodes if n.event is NodeEvent.ENTER_REGION]
    entered = {str(n.extra.get("region", "")).partition("/")[0] for n in into}
    for f in t.frames:
        for p in f.phrases:
            if p.prep not in ("into", "inside") or p.mention is None or f.unreal:
                continue
            goals = [i for i in nodes_of(d, p.mention) if d.world.entities[i].lies is not None]
            open_ = [i for i in goals if "container" in entity_of(d, i).noun.traits]
            if open_ and not entered & {*open_}:
                at = (start_of(p, d.text), p.mention.end)
                t.book.add(Predicate.NOT_REPRESENTED, *at, object=tuple(open_), note=AGAINST)


def _across_roads(t: Told) -> None:
    """ "A tree lies across the road": what no motion places is set at the kerb of a street."""
    d = t.d
    for f in t.frames:
        who = [i for i in nodes_of(d, f.subject) if d.world.entities[i].lies is not None]
        for p in f.phrases if who else ():
            streets = [i for i in nodes_of(d, p.mention) if entity_of(d, i).noun.name == "road"]
            if p.prep == "across" and streets and p.mention is not None:
                at = (start_of(p, d.text), p.mention.end)
                t.book.add(Predicate.NOT_REPRESENTED, *at, object=tuple(who), note=AT_THE_KERB)


def _afterwards(t: Told, at: int, who: tuple[str, ...]) -> bool:
    """Whether it is told of what has acted before in the text, in a clause of its own."""
    here = max((f for f in t.frames if f.verb.start < at + 1), key=lambda f: f.verb.start,
               default=None)  # fmt: skip
    if here is None or here.reduced or here.relative or here.subordinate:
        return False
    events = {n.id for n in t.d.timeline.nodes if {*n.participants} & {*who}}
    told = (f for f in t.frames if f.verb.start < here.verb.start)
    return any(t.d.scene.used.get((f.verb.start, f.verb.end)) in events for f in told)


def _state(t: Told, lain: Lain, who: tuple[str, ...]) -> None:
    d = t.d
    when = "end"
    if not lain.at_last:
        acting = {e.actor for e in d.timeline.edges}
        acting |= {i for n in d.timeline.nodes for i in n.participants}
        when = "start" if acting & {*who} else "throughout"
        for i in who:
            d.world.entities[i].lies = lain.pose
    t.book.add(Predicate.LIES, lain.start, lain.end, object=who, noun=lain.pose, when=when)


def cannot(d: Discourse, who: tuple[str, ...]) -> str:
    """Why things are not drawn so; empty if they are."""
    if not who:
        return NOBODY
    if any(kind_of(d, i) in LIVING for i in who):
        return ALIVE
    jointed = {n for j in d.scene.joints for n in (j.parent, j.child)}
    hung = (d.scene.attached, d.scene.hung)
    if any(i in jointed or entity_of(d, i).part or any(i in at for at in hung) for i in who):
        return FIXED
    return ""


def _differs(d: Discourse, node: str, pose: str) -> bool:
    """Whether a thing is usually drawn otherwise: a book lies flat anyway."""
    return ups(pose, dimensions_of(entity_of(d, node)))[0] != AS_DRAWN or pose in _STRONG


_OF_THEM = re.compile(r"\b(?:one|two|some)\s+of\s+(?:them|which|these)\s+$", re.IGNORECASE)
"""Before what only some of several do."""
_ENDS = re.compile(r"(?:ends?|ended|winds?|wound|comes?\s+to)\s+(?:up\s+)?", re.IGNORECASE)
_AWAY = re.compile(r"\s+(?:ahead|beyond|behind|before|opposite|outside|between)\b", re.IGNORECASE)
"""After "lies" that tells where something is, and not how."""
_STRONG = frozenset({"on its edge", "on its side", "on end", "tipped over", "overturned"})
"""Poses that a table of sizes alone does not settle: they are stated, and measured."""


def _bearers(t: Told, lain: Lain) -> list[str]:
    """What it is said of: what is named there, else what the clause there is about."""
    if lain.about != BEFORE:
        return named_at(t.d, lain.about)
    frames = [f for f in t.frames if f.verb.start < lain.end]
    for f in sorted(frames, key=lambda f: -f.verb.start):
        done = f.object if f.verb.passive or f.object is not None else f.subject
        for m in (done, f.subject):
            if m is not None and m.start < lain.start and (found := nodes_of(t.d, m)):
                return found
        break
    before = sorted((m for m in t.d.mentions if m.end <= lain.start), key=lambda m: -m.start)
    return next((found for m in before if (found := nodes_of(t.d, m))), list[str]())


def _lie_about(t: Told) -> Iterator[tuple[Frame, tuple[str, ...]]]:
    """Clauses that say of what is drawn upright that it lies somewhere."""
    d = t.d
    for f in t.frames:
        if f.verb.lemma.split()[0] != "lie" or f.verb.negated or f.unreal or f.object is not None:
            continue
        who = tuple(i for i in nodes_of(d, f.subject) if i in d.world.entities)
        if _OF_THEM.search(d.text[: f.verb.start]) or _AWAY.match(d.text, f.verb.end):
            continue
        if who and not cannot(d, who) and all(_lies_down(d, i) for i in who):
            yield f, who


def _lies_down(d: Discourse, node: str) -> bool:
    e = entity_of(d, node)
    stays = e.noun.kind in _NOT_DROPPED or structural(d, node)
    stays |= "fixed" in e.noun.traits and e.noun.kind not in _FELLED
    known = e.noun in lex.nouns().values() and not e.noun.stand_in
    return known and not stays and ups("flat", dimensions_of(e))[0] != AS_DRAWN
