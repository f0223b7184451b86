"""Words that nothing in the finished document stands for.

Every clause, phrase and adverb is asked what carries it; what nothing carries is owned up to. There is no list of what may be
missing, only of what may be passed over: `data/carriers.csv` says what can carry a preposition.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
import csv
from dataclasses import dataclass
from functools import cache

from esg.draft import lexicon as lex
from esg.draft.discourse.core import structural
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import GROUND
from esg.draft.events.courses import measurable
from esg.draft.events.stated import start_of
from esg.draft.events.told import things
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Element, Mention, Token, Verb, Word
from esg.graph.models import NodeEvent, Predicate, Statement

Gap = tuple[int, int, tuple[str, ...], str]
"""Where words stand that nothing stands for, the nodes that they are about, and what is missing."""

_PASSED_OVER = lex.word_set("passed over (unclaimed)")
"""Words that tell nothing of their own: of order, of degree, particles of verbs."""
_WAYS = frozenset({"on", "in", "at", "along", "across", "over", "through", "down", "up", "onto", "to"})
"""Prepositions that the ground and what is painted on it answer by being there."""
_OPEN = frozenset({"for", "like", "as", "because of", "due to", "despite"})
"""Prepositions of reasons and likeness, and "of", which belongs to its noun."""


@dataclass(frozen=True)
class Carriers:
    """What can stand for a preposition: kinds of relations, predicates, events, and whether being carried or held does."""

    relations: frozenset[str]
    states: frozenset[str]
    events: frozenset[str]
    holds: str
    aims: str
    example: str


@cache
def carriers() -> dict[str, Carriers]:
    """The table, by preposition."""
    out: dict[str, Carriers] = {}
    with open(lex.DATA / "carriers.csv", encoding="utf-8", newline="") as file:
        for r in csv.DictReader(file, delimiter=";"):
            sets = (frozenset(filter(None, r[k].split("|"))) for k in ("relations", "states", "events"))
            row = Carriers(*sets, r["holds"], r["aims"], r["example"])
            out.update(dict.fromkeys(r["preps"].split("|"), row))
    return out


_ANY = Carriers(frozenset(), frozenset(), frozenset(), "yes", "yes", "")
"""Of prepositions without a row: anything between the two will do."""


def phrases(d: Discourse, frames: Iterable[Frame], said: list[Statement]) -> Iterator[Gap]:
    """Phrases of clauses and nouns that nothing takes up ("passes under a bridge")."""
    asked: dict[int, tuple[Phrase, set[str]]] = {}
    for f in frames:
        about = _about(d, f)
        for p in f.phrases:
            if not _turned(d, f, p):
                asked.setdefault(id(p.mention), (p, set()))[1].update(about)
            about |= {*_nodes(d, p.mention)}
    for m, p in d.attached:
        asked.setdefault(id(p.mention), (p, set()))[1].update(_nodes(d, m))
    for p, about in asked.values():
        yield from _phrase(d, about - {*_nodes(d, p.mention)}, p, said)


def _about(d: Discourse, f: Frame) -> set[str]:
    """Who a clause is about, and who the event that was made of it."""
    about = {i for c in d.scene.clauses if c.frame.verb is f.verb for i in c.movers}
    about |= {i for m in (f.subject, f.object, f.object2) for i in _nodes(d, m)}
    made = d.timeline.node(d.scene.used.get((f.verb.start, f.verb.end), ""))
    return about | ({*made.participants} if made is not None else set())


def _nodes(d: Discourse, m: Mention | None) -> list[str]:
    """What a noun phrase stands for in the scene."""
    named = [] if m is None else m.entities or d.world.resolved.get(id(m), [])
    return [i for i in named if i in d.world.entities]


def _phrase(d: Discourse, about: set[str], p: Phrase, said: list[Statement]) -> Iterator[Gap]:
    m = p.mention
    if m is None or p.amount is not None or m.amounts or p.prep in _OPEN or not about:
        return
    start = max(start_of(p, d.text), 0)
    others = _nodes(d, m)
    if not others:
        kept = (s for s in said if s.predicate is not Predicate.NOT_REPRESENTED)
        if any(s.start < m.end and start < s.end for s in kept):
            return
        flies = any(s.predicate is Predicate.AIRBORNE and about & {*s.object} for s in said)
        if m.head in _AIR and flies:
            return
        named = m.pronoun or m.head in _PASSED_OVER or (m.start, m.end) in d.scene.used
        if named or p.prep == "of":
            return
    elif _carried(d, about, p, others, said) and not _part_lost(p, about, said):
        return
    nodes = tuple(sorted(about))[:1]
    yield start, m.end, nodes, f'nothing in the scene stands for "{p.prep}"'


def _part_lost(p: Phrase, about: set[str], said: list[Statement]) -> bool:
    """Whether a phrase names a part that its preposition alone does not ("to the top of the box")."""
    part = p.mention.part if p.mention is not None else ""
    if not part or part in _SIDES or p.prep not in _PLACES:
        return False
    return not any(about & {*s.object} and s.predicate.value in _ENDS for s in said)


_PLACES = frozenset({"to", "toward", "towards", "at", "in", "into", "under", "with"})
_ENDS = frozenset({"ends_on", "ends_in", "ends_near", "above", "under"})


def _turned(d: Discourse, f: Frame, p: Phrase) -> bool:
    """Whether a phrase tells the side of a turn, which an event has."""
    sided = p.mention is not None and {p.mention.head, p.mention.part} & {"left", "right"}
    return bool(sided) and _event_to(d, f, "")


def _event_to(d: Discourse, f: Frame | None, side: str) -> bool:
    """Whether a turn is told, to a side if one is named."""
    for n in d.timeline.nodes:
        turns = n.event in (NodeEvent.HEADING_REACHED, NodeEvent.SPIN)
        if turns and (f is None or _about(d, f) & {*n.participants}):
            return True
    return False


_TURNS = frozenset({"left", "right", "clockwise", "counterclockwise", "anticlockwise", "around", "round"})
_AIR = frozenset({"air", "sky", "midair", "mid-air"})


def _carried(d: Discourse, about: set[str], p: Phrase, others: list[str], said: list[Statement]) -> bool:
    """Whether something in the document is about what a phrase names and those it is said of."""
    by, some = carriers().get(p.prep) or _ANY, {*others}
    if structural(d, others[0]) and (p.prep in _WAYS or (p.prep == "around" and others[0] == GROUND)):
        return True
    return (
        (by.holds == "yes" and _holds(d, about, some))
        or _related(d, about, some, by, p.mention.part if p.mention else "")
        or any(_tells(s, about, some, p.prep, by) for s in said)
        or _happens(d, about, some, by)
        or (by.aims == "yes" and any(e.actor in about and e.target in some for e in d.timeline.edges))
    )


def _holds(d: Discourse, about: set[str], some: set[str]) -> bool:
    scene = d.scene
    places = (scene.supported_by, scene.inside_of, scene.attached, scene.marked)
    pairs = [pair for at in places for pair in at.items()]
    return any((i in about and h in some) or (i in some and h in about) for i, h in pairs)


def _related(d: Discourse, about: set[str], some: set[str], by: Carriers, part: str) -> bool:
    side = _SIDES.get(part)
    for r in d.scene.relations:
        ends = {r.source, r.target, r.text}
        fits = r.kind == side if side else not by.relations or r.kind in by.relations
        if fits and ends & some and ends & about:
            return True
    return False


_SIDES = {"front": "in_front_of", "back": "behind", "rear": "behind", "left": "left_of", "right": "right_of"}


def _tells(s: Statement, about: set[str], some: set[str], prep: str, by: Carriers) -> bool:
    ends = {*s.object, *s.target}
    if s.predicate is Predicate.NOT_REPRESENTED or not ends & about:
        return False
    fits = not by.states or s.predicate.value in by.states
    return (fits and bool(ends & some)) or (s.predicate is Predicate.MOVES and s.direction == prep)


def _happens(d: Discourse, about: set[str], some: set[str], by: Carriers) -> bool:
    for n in d.timeline.nodes:
        also = {*n.participants, str(n.extra.get("region", "")).split("/")[0]}
        if measurable(n.event) and about & also and any(c.to in some for c in n.constraints):
            return True  # "stops 1 m in front of a gate"
        fits = not by.events or n.event.value in by.events
        if measurable(n.event) and fits and about & also and some & also:
            return True
    return False


def arguments(d: Discourse, frames: Iterable[Frame], said: list[Statement]) -> Iterator[Gap]:
    """What a clause says something of and nothing in the document does ("a girl walks a dog")."""
    taking = {i for n in d.timeline.nodes for i in n.participants}
    taking |= {i for e in d.timeline.edges for i in (e.actor, e.target) if i}
    taking |= {i for r in d.scene.relations for i in (r.source, r.target, r.text)}
    for at in (d.scene.supported_by, d.scene.inside_of, d.scene.attached, d.scene.marked, d.scene.facing):
        taking |= {*at, *at.values()}
    taking |= {i for s in said for i in (*s.object, *s.target)} | {*d.moves.still}
    for f in frames:
        if f.verb.sense in _STATES:
            continue
        for m in (f.subject, f.object):
            ids = _nodes(d, m)
            if m is not None and ids and not {*ids} & taking and not structural(d, ids[0]):
                yield f.verb.start, f.verb.end, tuple(ids), "nothing of the kind happens in the scene"


_STATES = frozenset({"be", "posture", "have", "weigh", "contain", "measure", "unknown", "lead", "noop"})


def adverbs(d: Discourse, words: Iterable[Word], said: list[Statement]) -> Iterator[Gap]:
    """Adverbs that neither order events nor state anything."""
    told = [(s.start, s.end) for s in said]
    for w in words:
        if (w.start, w.end) in d.scene.used or w.low in _PASSED_OVER:
            continue
        if w.low in _TURNS and _event_to(d, None, w.low):
            continue
        if not any(a <= w.start < b for a, b in told):
            yield w.start, w.end, (), "nothing in the scene stands for it"


def dropped_words(d: Discourse, elements: Iterable[Element], tokens: Iterable[Token]) -> Iterator[Gap]:
    """Words that were taken off before anything was read, and had something to say ("in a blue shirt")."""
    read = [(e.start, e.end) for e in elements]
    for t in tokens:
        if t.kind != "word" or t.low in _SMALL or t.low in _PASSED_OVER:
            continue
        if not any(a <= t.start < b for a, b in read):
            yield t.start, t.end, (), "nothing in the scene stands for it"


_SMALL = lex.DETERMINERS | lex.PREPOSITIONS | lex.PRONOUNS | lex.MODALS | lex.word_set("be") | frozenset({"and", "or", "but", "to", "not", "that", "who", "which"})


def idle_members(d: Discourse, frames: Iterable[Frame]) -> Iterator[Gap]:
    """Clauses that tell of several things and move only some of them."""
    for c in d.scene.clauses:
        f = c.frame
        m = f.subject
        if m is None or f.verb.passive or not c.movers or f.verb.sense not in _EACH or f.verb.auxiliary == "have":
            continue
        group = [i for i in m.entities if i in d.world.entities]
        moving = {e.actor for e in d.timeline.edges}
        idle = [i for i in group if i not in moving]
        if 0 < len(idle) < len(group):
            yield f.verb.start, f.verb.end, tuple(idle), "only one of them does"


_EACH = frozenset({"own", "fly", "fall", "roll", "slide", "launch", "drop", "bounce", "coast"})
