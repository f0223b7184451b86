"""Words that nothing in the finished document stands for.

Every phrase, adverb and argument of what is told is asked what carries it; what nothing carries is
owned up to. No list says what may be missing, only `data/carriers.csv` what can carry a
preposition, and the word set "passed over (unclaimed)" what shows nothing of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
import csv
from dataclasses import dataclass, field, replace
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, movable, structural
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import GROUND
from esg.draft.discourse.windows import Draft
from esg.draft.events.courses import measurable
from esg.draft.events.stated import exactly, start_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Element, Mention, Token, Word
from esg.draft.verbphrases import verb_readings
from esg.graph.models import EdgeEvent, NodeEvent, Predicate, Statement, TimelineEdge

_PASSED_OVER = lex.word_set("passed over (unclaimed)")
_QUALITIES = lex.word_set("unseen qualities")
_WAYS = frozenset(
    {"on", "in", "at", "along", "across", "over", "through", "down", "up", "onto", "to"}
)
"""Prepositions that the ground and what is painted on it answer by being there."""
_WHY = frozenset({"for", "like", "as", "because of", "due to", "despite"})
"""Prepositions that tell why, or what something is like, and not where it is."""
_AIR = frozenset({"air", "sky", "midair", "mid-air"})
_TURNS = frozenset(
    {"left", "right", "clockwise", "counterclockwise", "anticlockwise", "around", "round"}
)
_BACK_AND_FORTH = frozenset({"back", "forth", "fro"})
_SIDES = {
    "front": "in_front_of",
    "back": "behind",
    "rear": "behind",
    "left": "left_of",
    "right": "right_of",
}
"""Parts that name a side, and the relation that has it ("in the front of an apple")."""
_TO_A_PART = frozenset({"to", "toward", "towards", "at", "in", "into", "under", "with"})
_OWN = frozenset({"own", "fly", "reverse"})
_COMPANIONS = frozenset({"person", "animal", "robot"})
_ENTERED = frozenset({"building", "structure"})
_ENDS = frozenset({"ends_on", "ends_in", "ends_near", "above", "under"})
_EACH = frozenset(
    {"own", "fly", "fall", "roll", "slide", "launch", "drop", "bounce", "coast", "topple"}
)
"""Senses of which each of several things needs a motion of its own."""
_CHAINS = frozenset({"row", "pins", "rack"})
"""Patterns of which one member fells the next."""
_STATES = frozenset(
    {"be", "posture", "have", "weigh", "contain", "measure", "unknown", "lead", "noop", "park"}
)
_ALONG = frozenset({"own", "tow", "carry"})
"""Senses of which who does it goes where the object goes."""
_MOTIONS = frozenset({"own", "fly", "fall", "roll", "accelerate"})
_SMALL = (
    lex.DETERMINERS | lex.PREPOSITIONS | lex.PRONOUNS | lex.MODALS | lex.word_set("be")
    | frozenset({"and", "or", "but", "to", "not", "who", "which"})
)  # fmt: skip
_FILES = frozenset({"row", "line", "column", "file", "queue", "convoy"})
"""Arrangements one behind the other, or side by side."""
_FEET = frozenset({"bottom", "foot"})
HALF_TURN_DEG = 180.0
NO_MANNER = "manner is not simulated"
NO_EVENT = "nothing of the kind happens in the scene"
NOTHING = "nothing in the scene stands for it"


@dataclass(frozen=True)
class Gap:
    """Words, from `start` to `end` in the text, that nothing stands for, and what is missing.

    Args:
        nodes: What they are about.
    """

    start: int
    end: int
    missing: str
    nodes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Carriers:
    """What can stand for a preposition: relations, predicates, events (none given: any); support.

    `aims` is "yes" if going for what the phrase names does, "back" if that goes for who is told of.
    """

    relations: frozenset[str] = frozenset()
    states: frozenset[str] = frozenset()
    events: frozenset[str] = frozenset()
    holds: bool = True
    aims: str = "yes"
    example: str = ""


_ANY = Carriers()
"""Of prepositions without a row: anything between the two will do."""


@cache
def carriers() -> dict[str, Carriers]:
    """The table, by preposition; a cell with "none" has nothing."""
    out: dict[str, Carriers] = {}
    with open(lex.DATA / "carriers.csv", encoding="utf-8", newline="") as file:
        for r in csv.DictReader(file, delimiter=";"):
            row = Carriers(
                *[frozenset(r[k].split("|")) for k in ("relations", "states", "events")],
                holds=r["holds"] == "yes",
                aims=r["aims"],
                example=r["example"],
            )
            out.update(dict.fromkeys(r["preps"].split("|"), row))
    return out


@dataclass
class Account:
    """What has been told and stated: the text's elements, its clauses, its statements.

    Args:
        d: The discourse, after everything has been read.
        frames: The clauses whose verbs are kept.
        elements: What the text was read as.
        tokens: Its words.
        said: Its statements.
        untold: Where adverbs of what does not happen stand.
    """

    d: Discourse
    frames: list[Frame]
    elements: list[Element]
    tokens: list[Token]
    said: list[Statement]
    untold: set[tuple[int, int]] = field(default_factory=set[tuple[int, int]])

    @property
    def kept(self) -> list[Statement]:
        """The statements that the document holds."""
        return [s for s in self.said if s.predicate is not Predicate.NOT_REPRESENTED]


def unclaimed(a: Account) -> Iterator[Gap]:
    """Everything that nothing in the document stands for."""
    for find in _FINDERS:
        yield from find(a)


def _phrases(a: Account) -> Iterator[Gap]:
    """Phrases of clauses and nouns ("passes under a bridge", "a cart of laundry")."""
    asked: dict[int, tuple[Phrase, Frame | None, set[str]]] = {}
    for f in a.frames:
        about = _about(a.d, f)
        for p in f.phrases:
            if not _side_of_a_turn(a.d, f, p):
                asked.setdefault(id(p.mention), (p, f, set()))[2].update(about)
            about |= {*_nodes(a.d, p.mention)}
    for m, p in a.d.attached:
        asked.setdefault(id(p.mention), (p, None, set()))[2].update(_nodes(a.d, m))
    for p, f, about in asked.values():
        m = p.mention
        if m is None or p.amount is not None or m.amounts or p.prep in _WHY:
            continue
        others = {*_nodes(a.d, m)}
        about -= others
        if about and not (_answered(a, about, others, p, f) if others else _no_place(a, about, p)):
            missing = f'nothing in the scene stands for "{p.prep}"'
            yield Gap(max(start_of(p, a.d.text), 0), m.end, missing, tuple(sorted(about))[:1])


def _nodes(d: Discourse, m: Mention | None) -> list[str]:
    """What a noun phrase stands for in the scene."""
    named = [] if m is None else m.entities or d.world.resolved.get(id(m), [])
    return [i for i in named if i in d.world.entities]


def _about(d: Discourse, f: Frame) -> set[str]:
    """Who a clause is about, and who the event that was made of it."""
    about = {i for c in d.scene.clauses if c.frame.verb is f.verb for i in c.movers}
    about |= {i for m in (f.subject, f.object, f.object2) for i in _nodes(d, m)}
    made = d.timeline.node(d.scene.used.get((f.verb.start, f.verb.end), ""))
    return about | ({*made.participants} if made is not None else set())


def _side_of_a_turn(d: Discourse, f: Frame, p: Phrase) -> bool:
    """ "Turns to the left": an event has the side."""
    sided = p.mention is not None and {p.mention.head, p.mention.part} & {"left", "right"}
    return bool(sided) and _turns(d, _about(d, f))


def _turns(d: Discourse, about: set[str] | None = None) -> bool:
    turns = (NodeEvent.HEADING_REACHED, NodeEvent.SPIN)
    told = [n for n in d.timeline.nodes if n.event in turns]
    return any(about is None or about & {*n.participants} for n in told)


def _no_place(a: Account, about: set[str], p: Phrase) -> bool:
    """Whether a phrase that names nothing in the scene need not be missed."""
    m = p.mention
    assert m is not None
    if (
        p.prep == "of"
        or "same" in m.adjectives
        or m.pronoun
        or m.head in _PASSED_OVER
        or (m.start, m.end) in a.d.scene.used
    ):
        return True
    if m.noun is not None and m.noun.kind == "region":  # "into the side pocket"
        return any(n.event is NodeEvent.ENTER_REGION for n in a.d.timeline.nodes)
    if p.prep == "in" and m.head in _FILES and _in_line(a.d, about):
        return True
    if p.prep == "at" and m.head in _FEET and _below_a_slope(a, about):
        return True
    falls = [n for n in a.d.timeline.nodes if n.event is NodeEvent.FALL]
    if p.prep in ("off", "over", "from") and any(about & {*n.participants} for n in falls):
        return True  # "falls off the edge"
    start = start_of(p, a.d.text)
    if any(s.start < m.end and start < s.end for s in a.kept):
        return True
    flies = any(s.predicate is Predicate.AIRBORNE and about & {*s.object} for s in a.kept)
    return flies and m.head in _AIR


def _in_line(d: Discourse, about: set[str]) -> bool:
    """Whether some are laid out in a row, or one of them follows another into a hit."""
    rows = any(entity_of(d, i).pattern in ("row", "queue") for i in about)
    after = (e for e in d.timeline.edges if e.actor in about and e.target in about - {e.actor})
    return rows or any(after)


def _below_a_slope(a: Account, about: set[str]) -> bool:
    """ "Slides down a chute and hits a box at the bottom": what is hit stands on the ground."""
    d = a.d
    falls = {
        s.object[0] for s in a.kept if s.predicate is Predicate.MOVES and s.direction == "down"
    }
    for n in d.timeline.nodes:
        who = {*n.participants} & about
        met = who - falls
        slid = who & falls
        if n.event is NodeEvent.COLLISION and slid and met:
            return not any(d.scene.supported_by.get(i) for i in met)
    return False


def _answered(a: Account, about: set[str], others: set[str], p: Phrase, f: Frame | None) -> bool:
    """Whether something in the document is about both what a phrase names and who it is said of."""
    d, by = a.d, carriers().get(p.prep, _ANY)
    if any(structural(d, i) for i in others):
        return (
            p.prep in _WAYS
            or (p.prep == "into" and GROUND not in others)
            or (p.prep == "of" and GROUND in others and _definite(p))  # "the boards of the rink"
            or (p.prep in ("above", "over") and _aloft(a, about))
            or _laid_out(d, about, others, p.prep)
        )
    if p.prep == "with" and all(kind_of(d, i) in _COMPANIONS for i in others):
        by = replace(by, relations=by.relations | {"near"})
    part = p.mention.part if p.mention is not None else ""
    if part in _SIDES:
        by = replace(by, relations=frozenset({_SIDES[part]}))
    elif part and p.prep in _TO_A_PART:
        return any(about & {*s.object} and s.predicate.value in _ENDS for s in a.kept) or any(
            others & {*s.object} and s.predicate is Predicate.STRUCK_ON for s in a.kept
        )
    open_ = any(kind_of(d, i) in _ENTERED for i in others)
    if f is not None and f.verb.sense in _OWN and (open_ or p.prep in ("on", "onto")):
        by = replace(by, events=by.events - {"Collision"})  # "jumps onto a box" is no bump
    own = {node for g, node in d.times.of_frame if f is not None and g.verb is f.verb}
    return (
        (by.holds and _held(d, about, others))
        or _related(d, about, others, by)
        or any(_tells(s, about, others, p.prep, by) for s in a.kept)
        or any(_happens(n, about, others, by, own) for n in d.timeline.nodes)
        or any(_aims(e, about, others, by.aims) for e in d.timeline.edges)
    )


def _definite(p: Phrase) -> bool:
    return p.mention is not None and p.mention.determiner == "the"


def _aloft(a: Account, about: set[str]) -> bool:
    """Whether something is said to be in the air, or how high it is."""
    flies = any(s.predicate is Predicate.AIRBORNE and about & {*s.object} for s in a.kept)
    return flies or bool(about & {*a.d.scene.heights})


def _laid_out(d: Discourse, about: set[str], others: set[str], prep: str) -> bool:
    """Whether the document has something on or beside what is laid ("by the side of the road")."""
    others = others - {GROUND}
    marked = any(i in about and road in others for i, road in d.scene.marked.items())
    told = any(r.source in about and r.target in others and r.text == prep
               for r in d.scene.relations)  # fmt: skip
    return marked or (told and prep in carriers() and "near" in carriers()[prep].relations)


def _aims(e: TimelineEdge, about: set[str], others: set[str], which: str) -> bool:
    """Whether who is told of goes for what a phrase names; "back": the other way round."""
    ends = (e.actor, e.target) if which == "yes" else (e.target, e.actor)
    return bool(which) and ends[0] in about and ends[1] in others


def _held(d: Discourse, about: set[str], others: set[str]) -> bool:
    scene = d.scene
    places = (scene.supported_by, scene.inside_of, scene.attached, scene.marked)
    pairs = [{*pair} for at in places for pair in at.items()]
    return any(pair & about and pair & others for pair in pairs)


def _related(d: Discourse, about: set[str], others: set[str], by: Carriers) -> bool:
    for r in d.scene.relations:
        ends = {r.source, r.target, r.text}
        if ends & others and ends & about and (not by.relations or r.kind in by.relations):
            return True
    return False


def _tells(s: Statement, about: set[str], others: set[str], prep: str, by: Carriers) -> bool:
    ends = {*s.object, *s.target}
    fits = not by.states or s.predicate.value in by.states
    way = s.predicate is Predicate.MOVES and s.direction == prep  # "up the stairs": up
    return fits and bool(ends & about) and (way or bool(ends & others))


def _happens(n: Draft, about: set[str], others: set[str], by: Carriers, own: set[str]) -> bool:
    """Whether an event tells of both, or one of the clause's own is told by its place."""
    also = {*n.participants, str(n.extra.get("region", "")).split("/")[0]}
    if not measurable(n.event) or not about & also:
        return False
    if n.id in own and any(c.to in others for c in n.constraints):
        return True  # "stops 1 m in front of a gate"
    fits = not by.events or n.event.value in by.events
    return fits and bool(others & also)


def _arguments(a: Account) -> Iterator[Gap]:
    """What a clause says something of and the document does not ("a girl walks a dog")."""
    d, scene = a.d, a.d.scene
    taking = {i for n in d.timeline.nodes for i in n.participants}
    taking |= {str(n.extra.get("region", "")).split("/")[0] for n in d.timeline.nodes}
    taking |= {i for e in d.timeline.edges for i in (e.actor, e.target) if i}
    taking |= {i for r in scene.relations for i in (r.source, r.target, r.text)}
    for at in (scene.supported_by, scene.inside_of, scene.attached, scene.marked, scene.facing):
        taking |= {*at, *at.values()}
    taking |= {i for s in a.said for i in (*s.object, *s.target)} | {*d.moves.still}
    for f in a.frames:
        if f.verb.sense in _STATES:
            continue
        for m in (f.subject, f.object):
            ids = _nodes(d, m)
            if ids and not {*ids} & taking and not structural(d, ids[0]):
                yield Gap(f.verb.start, f.verb.end, NO_EVENT, tuple(ids))
        m = f.object if f.verb.sense not in ("avoid", "miss") else None
        if m is None or _nodes(d, m) or m.pronoun or m.amounts or m.count == 0:
            continue
        if m.head not in _PASSED_OVER and (m.start, m.end) not in d.scene.used:
            yield Gap(m.start, m.end, NOTHING)


def _left_behind(a: Account) -> Iterator[Gap]:
    """ "A woman walks a dog": what goes is only what she takes along."""
    d = a.d
    for c in d.scene.clauses:
        f = c.frame
        takes = f.verb.sense in _ALONG and c.movers and not f.verb.passive and f.object is not None
        if not takes or not any(f.verb is kept.verb for kept in a.frames):
            continue
        doers = [i for i in _nodes(d, f.subject) if movable(d, i) and i not in c.movers]
        going = {e.actor for e in d.timeline.edges}
        left = [i for i in doers if i not in going and not _held(d, {i}, {*c.movers})]
        rides = any(
            s.predicate in (Predicate.INSIDE, Predicate.SUPPORTED_BY) and {*left} & {*s.object}
            for s in a.kept
        )
        if left and not rides:
            yield Gap(f.verb.start, f.verb.end, "who does it does not go along", tuple(left))


def _idle(a: Account) -> Iterator[Gap]:
    """Clauses that tell of several things and move only some of them."""
    moving = {e.actor for e in a.d.timeline.edges}
    for c in a.d.scene.clauses:
        f = c.frame
        if not any(f.verb is kept.verb for kept in a.frames) or f.verb.passive:
            continue
        told = c.movers and f.verb.sense in _EACH and f.verb.auxiliary != "have"
        group = _nodes(a.d, f.subject) if told else []
        idle = [i for i in group if i not in moving and entity_of(a.d, i).pattern not in _CHAINS]
        if 0 < len(idle) < len(group):
            yield Gap(f.verb.start, f.verb.end, "only one of them does", tuple(idle))


def _adverbs(a: Account) -> Iterator[Gap]:
    """Adverbs that neither order events nor state anything."""
    turned = _turns(a.d)
    rebounds = {w for f in a.frames if f.verb.sense == "bounce" for w in f.adverbs}
    for w in a.elements:
        if not isinstance(w, Word) or w.kind != "adv" or (w.start, w.end) in a.d.scene.used:
            continue
        over = {*a.d.text[w.start : w.end].lower().split()} if w.low == "indeed" else set[str]()
        if over & _BACK_AND_FORTH:
            yield Gap(w.start, w.end, NOTHING)
        shown = _SHOWN_BY.get(w.low)
        if shown is not None:
            told = (_about(a.d, f) for f in a.frames if w.low in f.adverbs)
            if not all(shown(a.d, about) for about in told if len(about) > 1):
                yield Gap(w.start, w.end, NOTHING)
            continue
        if (
            w.low in _PASSED_OVER
            or (w.start, w.end) in a.untold
            or w.low in rebounds
            or (turned and w.low in _TURNS)
            or _says_how(a, w)
        ):
            continue
        if not any(s.start <= w.start < s.end for s in a.said):
            yield Gap(w.start, w.end, NO_MANNER if w.low.endswith("ly") else NOTHING)


def _says_how(a: Account, w: Word) -> bool:
    """Whether an adverb tells how exactly, how much or why of what the scene has."""
    if w.low == "right":
        return exactly(a.d.text, w.end)
    if w.low in ("twice", "half", "thrice"):  # "twice as fast as": a figure
        return re.match(r"\s+as\s", a.d.text[w.end :]) is not None
    f = next((f for f in a.frames if w.low in f.adverbs), None)
    if f is None:
        return False
    about = _about(a.d, f)
    if w.low == "from behind":
        ways = [e for e in a.d.timeline.edges if e.actor in about and e.target in about]
        ends = {(r.source, r.target) for r in a.d.scene.relations if r.kind == "behind"}
        return any((e.actor, e.target) in ends for e in ways)
    if w.low == "late" and f.verb.sense == "brake":  # it hits something all the same
        hits = {n.id for n in a.d.timeline.nodes if n.event is NodeEvent.COLLISION}
        braked = (e for e in a.d.timeline.edges if e.event is EdgeEvent.BRAKE)
        return any(e.actor in about and e.to in hits for e in braked)
    return w.low == "back" and any(
        n.event is NodeEvent.HEADING_REACHED and n.extra.get("turn_degrees") == HALF_TURN_DEG
        for n in a.d.timeline.nodes
        if about & {*n.participants}
    )


def _mutual(d: Discourse, about: set[str]) -> bool:
    """Whether two of them meet, or one of them goes for the other, or they fell each other."""
    met = (
        n for n in d.timeline.nodes if measurable(n.event) and len(about & {*n.participants}) > 1
    )
    chain = any(entity_of(d, i).pattern in _CHAINS for i in about)
    aims = (e for e in d.timeline.edges if e.actor in about and e.target in about)
    faces = (i for i in about if d.scene.facing.get(i) in about)
    relations = (r for r in d.scene.relations if {r.source, r.target} <= about)
    return chain or any(any(found) for found in (met, aims, faces, relations))


def _abreast(d: Discourse, about: set[str]) -> bool:
    relations = (r for r in d.scene.relations if {r.source, r.target} <= about)
    return any(entity_of(d, i).pattern == "row" for i in about) or any(relations)


_SHOWN_BY: dict[str, Callable[[Discourse, set[str]], bool]] = {
    "each other": _mutual,
    "one another": _mutual,
    "in a row": _in_line,
    "in a line": _in_line,
    "in rows": _in_line,
    "side by side": _abreast,
}
"""What adverbs of several things ask of the scene."""


def _qualities(a: Account) -> Iterator[Gap]:
    """ "A curious sloth", and "a moving vehicle" that does not move."""
    moving = {e.actor for e in a.d.timeline.edges}
    for m in a.d.mentions:
        ids = _nodes(a.d, m)
        if not ids or structural(a.d, ids[0]):
            continue
        for t in a.tokens:
            if not m.start <= t.start < m.end or t.low not in m.adjectives:
                continue
            going = t.low.endswith("ing") and _motion(t.low) and movable(a.d, ids[0])
            named = t.low in entity_of(a.d, ids[0]).noun.name
            if t.low in _QUALITIES or (going and not named and not {*ids} & moving):
                yield Gap(t.start, t.end, NOTHING, tuple(ids))


def _motion(word: str) -> bool:
    return any(r.form == "ing" and r.sense in _MOTIONS for r in verb_readings(word))


def _left_out(a: Account) -> Iterator[Gap]:
    """Words that were taken off before anything was read ("in a blue shirt")."""
    read = [(e.start, e.end) for e in a.elements]
    for t in a.tokens:
        if t.kind != "word" or t.low in _SMALL or t.low in _PASSED_OVER:
            continue
        if not any(start <= t.start < end for start, end in read):
            yield Gap(t.start, t.end, NOTHING)


_FINDERS: tuple[Callable[[Account], Iterator[Gap]], ...] = (
    _phrases,
    _arguments,
    _left_behind,
    _idle,
    _adverbs,
    _qualities,
    _left_out,
)
