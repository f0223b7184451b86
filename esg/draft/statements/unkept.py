"""Verbs whose meaning the document cannot hold, and words that say why.

`data/unkept.csv` names them by sense, lemma and voice, with a sentence for each.
"""

from __future__ import annotations

from collections.abc import Callable
import csv
from dataclasses import dataclass
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, movable, structural
from esg.draft.discourse.links import snapped
from esg.draft.discourse.proposition import Clause
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import LIMBED
from esg.draft.events.courses import measurable
from esg.draft.events.hanging import row_of
from esg.draft.events.motions import flies_itself
from esg.draft.events.senses.climbing import COMES_OFF
from esg.draft.events.told import last_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.statements.account import held
from esg.draft.statements.climbed import climbs_told
from esg.draft.statements.looks.gestures import gestures_told
from esg.draft.statements.looks.postures import poses_told
from esg.draft.statements.ways import comes_to_ground
from esg.graph.models import EdgeEvent, NodeEvent, Predicate

_NO_PICTURE = lex.word_set("no picture (statements)")
_PICTURED = frozenset({"refuse", "lose"})
"""Verbs without a picture that have one with an object."""
_NOT_TOLD = frozenset({"gerund", "no event of its own"})
"""Reasons for which a verb is no statement of the prompt."""
_STATES = frozenset(
    {"be", "posture", "have", "weigh", "contain", "face", "measure", "surround", "lead", "unknown",
     "park", "give", "acquire", "apply", "cause", "continue", "avoid", "miss", "end", "lose",
     "start", "left_so"}
)  # fmt: skip
"""Senses that may add nothing to a scene: states, and what other clauses tell."""
_SETS_IN_MOTION = frozenset({"drop", "launch", "roll", "slide", "knock", "scatter", "pocket"})
"""Senses of which the object moves."""
_GUIDED = frozenset({"picked up", "put"})
"""What became of verbs whose object is guided, by nobody who is there."""
_WAYS = frozenset({"along", "across", "through", "up", "down", "around", "past"})
_INTO_WATER = frozenset({"into", "onto", "through", "across"})
_WORDS = re.compile(r"[a-z]+")
_NO_DEPTH = lex.word_set("no depth (water)")
_EDGEWISE = lex.word_set("spins on its edge")
_TURNED = frozenset({NodeEvent.SPIN, NodeEvent.HEADING_REACHED, NodeEvent.SWING})
NOTHING_MOVES = "nothing of the kind happens in the scene"
COMES_DOWN = "nothing holds it any longer: it comes down"
_HANGING = lex.word_set("hanging")
UNTOUCHED = "nothing touches it: it sets off by itself"
UNCARRIED = "it moves by itself: nothing carries it"
BY_ITSELF = "nothing makes it fall: it falls by itself, and at any time"


@dataclass(frozen=True)
class _Row:
    sense: str
    lemmas: frozenset[str]
    all_but: bool
    voice: str
    missing: str
    example: str

    def names(self, f: Frame) -> bool:
        """Whether a clause's verb is of the row's sense, and listed."""
        listed = f.verb.lemma in self.lemmas or "*" in self.lemmas
        return self.sense == f.verb.sense and listed is not self.all_but


@cache
def rows() -> tuple[_Row, ...]:
    """The table."""
    with open(lex.DATA / "unkept.csv", encoding="utf-8", newline="") as file:
        return tuple(
            _Row(r["sense"], frozenset(r["lemmas"].lstrip("!").split("|")), r["lemmas"][0] == "!",
                 r["voice"], r["missing"], r["example"])
            for r in csv.DictReader(file, delimiter=";")
        )  # fmt: skip


def missing(d: Discourse, clause: Clause) -> str:
    """What a clause that was read says and the document does not hold; empty if it holds it."""
    f = clause.frame
    if (
        poses_told(d, clause)
        or gestures_told(d, clause)
        or climbs_told(d, clause)
        or d.scene.used.get((f.verb.start, f.verb.end)) == COMES_OFF
    ):
        return ""
    for row in rows():
        if row.names(f) and _applies(d, row.voice, clause):
            return row.missing
    if _hung_on(d, clause):
        return COMES_DOWN
    note = d.scene.used.get((f.verb.start, f.verb.end), "")
    if note in _GUIDED and _goes_with_it(d, clause):
        return UNCARRIED
    if note == "let go" and f.verb.passive:
        return ""  # "is released and rolls"
    again = any(n.id == note for n in d.timeline.nodes)
    told = clause.told or again or bool(clause.movers)
    if told and not clause.movers and not again and _moves_nothing(d, f):
        return NOTHING_MOVES
    doers = [*f.subject.entities] if f.subject is not None else []
    loads = [*f.object.entities] if f.object is not None else []
    borne = any(s.row.states is Predicate.CARRIED_BY for s in clause.said) and any(
        d.scene.supported_by.get(i) in doers for i in loads
    )
    return "" if told or borne or f.verb.sense in _STATES else NOTHING_MOVES


def _hung_on(d: Discourse, clause: Clause) -> bool:
    """ "One chain snaps, and the sign stays hanging from the other": all of it comes down."""
    f = clause.frame
    loose = f.verb.lemma in _HANGING and bool({*_doers(f)} & d.scene.loosed)
    return loose and any(g.verb.start < f.verb.start and snapped(d, g) for g in d.told)


def _goes_with_it(d: Discourse, clause: Clause) -> bool:
    """ "A drone picks up a parcel and flies off": who has it goes, and nothing takes it along.

    Who stands beside it has it in hand; a flyer has no hand that reaches it.
    """
    who = {i for i in _doers(clause.frame) if i in d.world.entities} - {*clause.movers}
    if not clause.movers or not who or held(d, {*clause.movers}, who):
        return False
    acts = [c for c in d.scene.clauses if {*c.movers} & {*clause.movers}]
    at = next(k for k, c in enumerate(acts) if c is clause)
    put = d.scene.used.get((clause.frame.verb.start, clause.frame.verb.end)) == "put"
    begin, end = (acts[at - 1 : at], [clause]) if put else ([clause], acts[at + 1 : at + 2])
    spans = [c.frame.verb.start for c in (*begin, *end)]
    low, high = (spans[0], spans[-1]) if len(spans) > 1 else (spans[0], len(d.text))
    goes = (c for c in d.scene.clauses if low < c.frame.verb.start < high and who & {*c.movers})
    held_on = len(spans) > 1 or not put
    return any(flies_itself(d, i) for i in who) or (held_on and any(goes))


def _moves_nothing(d: Discourse, f: Frame) -> bool:
    """ "A truck dumps gravel": what would move is no body of the scene."""
    if f.verb.sense not in _SETS_IN_MOTION or f.verb.passive or f.object is None:
        return False
    bodies = [i for i in f.object.entities if i in d.world.entities]
    return not any(movable(d, i) for i in bodies)


def _applies(d: Discourse, voice: str, clause: Clause) -> bool:
    """Whether a row's conditions hold: words of `_TESTS`, and those of a prefix.

    "without:WORD" asks for no such word in the clause, "of:KIND" for a thing of a kind among those
    who act, "!KIND" for none.
    """
    named = (*_doers(clause.frame), *clause.movers)
    kinds = {kind_of(d, i) for i in named if i in d.world.entities}
    for condition in voice.split():
        test = _TESTS.get(condition)
        if test is not None and not test(d, clause):
            return False
        if condition.startswith("without:") and _tells(d, clause, condition[8:]):
            return False
        if condition.startswith("!") and condition[1:] in kinds:
            return False
        if condition.startswith("of:") and condition[3:] not in kinds:
            return False
    return True


def _doers(f: Frame) -> list[str]:
    """Who a clause is said of, and of a passive one who does it ("is caught by a girl")."""
    by = f.phrase("by") if f.verb.passive else None
    named = (f.subject, by.mention if by is not None else None)
    return [i for m in named if m is not None for i in m.entities]


def _loose(d: Discourse, clause: Clause) -> bool:
    """Whether nothing that a clause moves is on a joint."""
    named = clause.frame.subject.entities if clause.frame.subject is not None else []
    return all(row_of(d, i) is None for i in (*clause.movers, *named))


def _bumped(d: Discourse, f: Frame) -> bool:
    """Whether the last that happens to what a clause acts on is that it is touched."""
    told = [last_of(d, i) for i in (f.object.entities[:1] if f.object is not None else [])]
    return any(n is not None and n.event is NodeEvent.COLLISION for n in told)


def _rammed(d: Discourse, clause: Clause) -> bool:
    """Whether who is to pull a thing runs into it."""
    doers, f = {*_doers(clause.frame)}, clause.frame
    pulled = {*(f.object.entities if f.object is not None and not f.verb.passive else ())}
    hits = (n for n in d.timeline.nodes if n.event is NodeEvent.COLLISION)
    return any({*n.participants} & doers and {*n.participants} & pulled for n in hits)


def _tied(d: Discourse, f: Frame) -> bool:
    """Whether what a clause acts on, or what that rides in, is joined to what draws it."""
    named = f.subject if f.verb.passive else f.object
    acted_on = [] if named is None else named.entities
    hosts = (
        places.get(i, "") for i in acted_on for places in (d.scene.supported_by, d.scene.inside_of)
    )
    return bool({*acted_on, *hosts} & {*d.scene.tows})


def _restless(d: Discourse, clause: Clause) -> bool:
    """Whether one of those who wait is on its way, and at no time told to stand still."""
    who = [i for i in _doers(clause.frame) if i in d.world.entities]
    who += [d.scene.supported_by[i] for i in who if i in d.scene.supported_by]
    stands = {i for n in d.timeline.nodes if n.event is NodeEvent.STOP for i in n.participants}
    legs = [e for e in d.timeline.edges if e.event is not EdgeEvent.INERTIAL_CONNECTOR]
    stands |= {e.actor for e in legs if e.params.speed == 0.0}
    at = next(k for k, c in enumerate(d.scene.clauses) if c is clause)
    goes_on = {i for c in d.scene.clauses[at + 1 :] for i in c.movers}
    arrived = {n.id for n in d.timeline.nodes if n.event is NodeEvent.REACH}
    stands |= {e.actor for e in legs if e.to in arrived} - goes_on  # "goes to a table and waits"
    return any(e.actor in who and e.actor not in stands for e in legs)


def _parted(d: Discourse, clause: Clause) -> bool:
    """ "Grabs a fish and carries it to its nest": who carries it goes, and it does not."""
    f = clause.frame
    taken = [] if f.object is None or f.verb.passive else f.object.entities
    left = {i for i in taken if i in d.world.entities and movable(d, i)} - {*clause.movers}
    going = {*clause.movers} & {e.actor for e in d.timeline.edges}
    later = {e.actor for e in d.timeline.edges if e.event is EdgeEvent.GUIDE and e.target}
    return bool(going and left) and not (left & later) and not held(d, left, going)


def _goes_down(d: Discourse, clause: Clause) -> bool:
    verb = clause.frame.verb
    return "down" in d.text[verb.start : verb.end + 5].lower().split()


def _shoved(d: Discourse, clause: Clause) -> bool:
    """Whether what is thrown leaves what it lies on without a flight."""
    first = (next((e for e in d.timeline.edges if e.actor == m), None) for m in clause.movers)
    return any(e is not None and e.params.elevation_deg is None for e in first)


def _flung(d: Discourse, clause: Clause) -> bool:
    """Whether what is moved over something leaves the ground for it."""
    over = clause.frame.phrase("over", "onto", "across")
    first = (next((e for e in d.timeline.edges if e.actor == m), None) for m in clause.movers)
    return over is not None and any(e and e.params.elevation_deg is not None for e in first)


def _far(d: Discourse, clause: Clause) -> bool:
    """Whether a body is moved along a way that who moves it has to go too."""
    f = clause.frame
    limbed = any(kind_of(d, i) in LIMBED for i in _doers(f) if i in d.world.entities)
    return (
        limbed and (f.object is not None or f.verb.passive) and any(_way(d, p) for p in f.phrases)
    )


def _met_or_bounced(d: Discourse, body: str) -> bool:
    """Whether it bounces, or is thrown back by what it meets."""
    kinds = (NodeEvent.BOUNCE, NodeEvent.COLLISION)
    return any(n.event in kinds and body in n.participants for n in d.timeline.nodes)


def _way(d: Discourse, p: Phrase) -> bool:
    """ "Up a hill", "across the lawn", "down a street": not across a table."""
    named = [] if p.mention is None or p.prep not in _WAYS else p.mention.entities
    bodies = [i for i in named if i in d.world.entities]
    up = p.prep == "up" and any("incline" in entity_of(d, i).noun.traits for i in bodies)
    return up or any(structural(d, i) for i in bodies)


def _alone(d: Discourse, clause: Clause) -> bool:
    """ "A boy kicks a ball and the lamp falls over": nothing that is told touches the lamp."""
    f, about = clause.frame, {*clause.movers}
    at = next(k for k, c in enumerate(d.scene.clauses) if c is clause)
    before = d.scene.clauses[at - 1] if at else None
    if before is None or f.verb.passive or f.relative or f.subordinate or f.subject is None:
        return False
    acts = before.frame.verb.sense in _SETS_IN_MOTION | {"hit"}
    joined = before.frame.sentence == f.sentence and not {*before.movers} & about
    met = any(about < {*n.participants} for n in d.timeline.nodes)
    carried = (e for e in d.timeline.edges if e.event is EdgeEvent.INERTIAL_CONNECTOR)
    borne = any(e.actor in about for e in carried)
    met = met or borne  # "a cart hits a wall and the vase on it falls off"
    first = not any(about & {*c.movers} for c in d.scene.clauses[:at])
    return acts and joined and first and f.subject.determiner == "the" and not met


def _moved_by_none(d: Discourse, clause: Clause) -> bool:
    """Whether who opens something is not told to meet it: a door moves by itself then."""
    doers, about = {*_doers(clause.frame)}, {*clause.movers}
    done = {*(clause.frame.object.entities if clause.frame.object is not None else [])} | about
    hits = (n for n in d.timeline.nodes if n.event is NodeEvent.COLLISION)
    return not any({*n.participants[:1]} & doers and {*n.participants[1:]} & done for n in hits)


def _acts_on_something(d: Discourse, clause: Clause) -> bool:
    """Whether somebody acts on a thing: with an object, or as the agent of a passive."""
    f = clause.frame
    if f.verb.passive:
        by = f.phrase("by")
        named = [] if by is None or by.mention is None else by.mention.entities
        return any(kind_of(d, i) in LIMBED for i in named if i in d.world.entities)
    return f.object is not None and (f.relative or not f.reduced)


def _later_act(d: Discourse, clause: Clause) -> bool:
    """Whether who acts has acted before."""
    return not clause.frame.relative and _acted_before(d, clause, _doers(clause.frame))


def _unsent(d: Discourse, clause: Clause) -> bool:
    """ "She serves wide", "a soldier shoots at a tank": nothing is sent off, or who does it is."""
    f = clause.frame
    doers = [i for i in _doers(f) if i in d.world.entities and kind_of(d, i) in LIMBED]
    sent = {*clause.movers} - {*doers}
    active = not f.verb.passive and f.object is None and not f.relative
    return active and bool(doers) and not sent and not _flies(d)


def _flies(d: Discourse) -> bool:
    """Whether something without limbs goes off: "he shoots, the puck hits the post"."""
    set_off = {e.actor for e in d.timeline.edges if e.event is EdgeEvent.TOWARD}
    return any(kind_of(d, i) not in LIMBED for i in set_off)


def _on_water(d: Discourse, clause: Clause) -> bool:
    """ "Runs into the sea", "crosses a river": deep water, which bears whoever goes there."""
    f = clause.frame
    named = [p.mention for p in f.phrases if p.prep in _INTO_WATER]
    into = _INTO_WATER & {*d.text[f.verb.start : f.verb.end].lower().split()}
    if f.object is not None and not f.verb.passive and (into or f.verb.lemma == "cross"):
        named.append(f.object)
    bodies = [i for m in named if m is not None for i in m.entities if i in d.world.entities]
    shallow = _NO_DEPTH & {*_WORDS.findall(d.text.lower())}
    return not shallow and any(entity_of(d, i).noun.name == "pool" for i in bodies)


def _unspun(d: Discourse, clause: Clause) -> bool:
    """ "Clips a barrier and spins out": nothing has it turn."""
    f = clause.frame
    about = {*clause.movers, *_doers(f), *(f.object.entities if f.object is not None else [])}
    if d.timeline.node(d.scene.used.get((f.verb.start, f.verb.end), "")) is not None:
        return False  # what turns on its axle
    return not any(n.event in _TURNED and about & {*n.participants} for n in d.timeline.nodes)


def _not_through(d: Discourse, clause: Clause) -> bool:
    """ "Smashes through a wall", which stays whole and in the way."""
    f = clause.frame
    told = f.phrase("through") is None
    told = told and "through" in d.text[f.verb.start : f.verb.end + 9].lower().split()
    broken = (n for n in d.timeline.nodes if n.event in (NodeEvent.BREAK, NodeEvent.TOPPLE))
    met = {*(f.object.entities if f.object is not None else [])}
    met |= {i for p in f.phrases if p.mention is not None for i in p.mention.entities}
    return told and bool(met) and not any(met & {*n.participants} for n in broken)


def _met(d: Discourse, clause: Clause) -> bool:
    """Whether another body runs into what a clause moves."""
    hits = (n for n in d.timeline.nodes if n.event is NodeEvent.COLLISION)
    return any({*n.participants[1:]} & {*clause.movers} for n in hits)


def _not_all_fly(d: Discourse, clause: Clause) -> bool:
    """Whether something that a clause moves does not fly by itself, or it moves nothing."""
    return not clause.movers or not all(flies_itself(d, i) for i in clause.movers)


_TESTS: dict[str, Callable[[Discourse, Clause], bool]] = {
    "active": _acts_on_something,
    "unmet": lambda d, c: not _leads_to_an_event(d, c),
    "later": _later_act,
    "!flyer": _not_all_fly,
    "loose": lambda d, c: bool(c.movers) and _loose(d, c),
    "aloft": lambda d, c: not any(comes_to_ground(d, c, i) for i in c.movers),
    "bumped": lambda d, c: c.frame.verb.form == "ing" and _bumped(d, c.frame),
    "down": _goes_down,
    "parted": _parted,
    "restless": _restless,
    "rammed": _rammed,
    "finite": lambda d, c: (
        not c.frame.verb.passive and (not c.frame.reduced or c.frame.verb.form == "s")
    ),
    "shoved": _shoved,
    "flung": _flung,
    "unbounced": lambda d, c: bool(c.movers) and not any(_met_or_bounced(d, i) for i in c.movers),
    "far": _far,
    "flat": lambda d, c: any(entity_of(d, i).noun.name in _EDGEWISE for i in c.movers),
    "limbed": lambda d, c: any(
        kind_of(d, i) in LIMBED for i in _doers(c.frame) if i in d.world.entities
    ),
    "alone": _alone,
    "driven": lambda d, c: "driven" in c.frame.verb.extra,
    "afloat": _on_water,
    "agentless": lambda d, c: c.frame.verb.passive and c.frame.phrase("by") is None,
    "untouched": _moved_by_none,
    "untied": lambda d, c: not _tied(d, c.frame),
    "unsent": _unsent,
    "unspun": _unspun,
    "grounded": lambda d, c: (
        c.frame.object is not None and all(structural(d, i) for i in c.frame.object.entities)
    ),
    "through": _not_through,
    "other": lambda d, c: bool({*c.movers} - {*_doers(c.frame)}),
    "here": lambda d, c: not any(p.prep in _WAYS for p in c.frame.phrases),
    "in": lambda d, c: " in " in d.text[c.frame.verb.start : c.frame.verb.end + len(" in ")],
    "living": lambda d, c: (
        bool(c.movers) and all(kind_of(d, i) in LIMBED for i in c.movers) and not _met(d, c)
    ),
}
"""Conditions of a row that look at the scene or at the words around the verb."""


def _leads_to_an_event(d: Discourse, clause: Clause) -> bool:
    """Whether an event that one could see is told of what a clause moves."""
    f, about = clause.frame, {*clause.movers}
    own = d.scene.used.get((f.verb.start, f.verb.end))
    if f.verb.sense == "posture" and f.object is not None and not f.verb.passive:
        about &= {*f.object.entities}  # "pushes a crate and sets the vase on it": not the pusher
    told = [n.event for n in d.timeline.nodes if about & {*n.participants} or n.id == own]
    return any(measurable(event) for event in told)


def _tells(d: Discourse, clause: Clause, kind: str) -> bool:
    """Whether a clause itself tells of an event of a kind: another leap is none of its own."""
    at = clause.frame.verb.start
    own = d.scene.used.get((at, clause.frame.verb.end))
    ids = {own, *(n for g, n in d.times.of_frame if g.verb.start == at)}
    return any(n.id in ids and n.event.value == kind for n in d.timeline.nodes)


def _acted_before(d: Discourse, clause: Clause, doers: list[str]) -> bool:
    """Whether those who act have bodies to pose, and an earlier clause tells of their motion."""
    if not {kind_of(d, i) for i in doers if i in d.world.entities} & {"person", "animal"}:
        return False
    earlier = d.scene.clauses[: d.scene.clauses.index(clause)]
    return any({*doers} & {*c.movers} for c in earlier)


def dropped(d: Discourse, f: Frame) -> str:
    """Why a clause that no reading took up is missed in the scene; empty if it need not be."""
    span = (f.verb.start, f.verb.end)
    why = d.scene.ignored.get(span)
    if why is None or span in d.scene.used or f.unreal or f.times or why in _NOT_TOLD:
        return ""
    pictured = f.verb.lemma in _PICTURED and f.object is not None  # "refuses the jump"
    pictured |= f.verb.lemma == "look" and f.phrase("for") is not None  # "looking for his keys"
    pictured |= f.verb.lemma == "fail" and not d.text[f.verb.end :].startswith(" to ")
    if (
        f.verb.negated
        or (f.verb.lemma in _NO_PICTURE and not pictured)
        or f.verb.auxiliary == f.verb.lemma
    ):
        return ""
    return NOTHING_MOVES if why == "no physical meaning" else why
