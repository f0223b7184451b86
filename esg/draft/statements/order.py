"""The order that words tell between what different things do ("after the bus stops, a dog runs").

What one thing does after another one's event is no segment between the two, so that nothing but a
statement says so: who waits stays still until then, or the one event comes before the other one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
import re

from esg.draft.discourse.antecedents import STATES
from esg.draft.discourse.core import entity_of
from esg.draft.discourse.proposition import Clause
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.timeline import START
from esg.draft.events.courses import measurable
from esg.draft.events.following import KNOWN, before, borne, first_leg, inert, steps_on
from esg.draft.events.motions import AFTER_THAT, THEN, told_after
from esg.draft.events.told import mates_of
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Mention
from esg.graph.models import EdgeEvent, Predicate

UNKEPT = "the order is not kept: nothing that is measured ends what comes first"
ALONE = "it moves by itself: nothing is passed on to it"
_NO_CAUSES = frozenset({"fall", "topple", "drop", "miss"})
"""Senses of what happens to one thing and brings about no fall of another."""
_THEN = re.compile(rf"\b(?:{'|'.join(sorted(THEN))})\b(?! to\b)|{AFTER_THAT}", re.IGNORECASE)


@dataclass(frozen=True)
class Ordered:
    """What the words between start and end say of an order; without `says` nothing keeps it."""

    start: int
    end: int
    says: Predicate | None = None
    about: tuple[str, ...] = ()
    when: str = "throughout"


def orders(d: Discourse) -> Iterator[Ordered]:
    """The order of clauses about different things, as far as words tell it."""
    for first, later in d.moves.outrun:
        f = next((g for g, n in d.times.of_frame if n == first), None)
        if f is not None:
            yield Ordered(f.verb.start, f.verb.end, Predicate.BEFORE, (first, later))
    for clause in d.scene.clauses:
        earlier = told_after(d, clause.frame)
        if earlier:
            yield from _order(d, clause, earlier)


def started_alone(d: Discourse) -> Iterator[tuple[int, int, str]]:
    """Where something sets off by itself that others should move: those of a row that have been
    hit, what it stands on and is taken away, or what was done before ("trips, and the cup falls").
    """
    met: set[str] = set()
    moved: set[str] = set()
    for clause in d.scene.clauses:
        for mover in (m for m in clause.movers if m in d.world.entities):
            mates = {*mates_of(d, mover)} - {mover}
            row = entity_of(d, mover).pattern == "row" and mates & met
            taken = d.scene.supported_by.get(mover) in moved | met and mover not in moved
            leg = first_leg(d, mover)
            launched = leg is not None and leg.event is EdgeEvent.TOWARD
            alone = row or taken or (mover not in moved and borne(d, mover))
            by_itself = mover not in moved and _by_itself(d, clause, mover)
            if mover not in met and ((alone and launched) or by_itself):
                yield clause.frame.verb.start, clause.frame.verb.end, mover
        moved |= {*clause.movers}
        verb = id(clause.frame.verb)
        told = {n for g, n in d.times.of_frame if id(g.verb) == verb}
        met |= {p for n in d.timeline.nodes if n.id in told for p in n.participants}


def _by_itself(d: Discourse, clause: Clause, mover: str) -> bool:
    """ "She pulls the tablecloth, and the cup falls": a thing that others are to set in motion."""
    f, leg = clause.frame, first_leg(d, mover)
    acts = f.subject is not None and mover in f.subject.entities and not f.verb.passive
    if (
        not acts
        or _let(f)
        or f.object is not None
        or leg is None
        or leg.event is not EdgeEvent.TOWARD
    ):
        return False
    below = d.scene.supported_by.get(mover, "")
    sloped = below in d.world.entities and "incline" in entity_of(d, below).noun.traits
    if sloped or not inert(d, mover) or f.subject is None or not steps_on(f):
        return False
    falls = f.verb.sense in ("fall", "topple")
    known = bool(f.subject.pronoun or f.subject.possessor or f.subject.determiner in KNOWN)
    others = (g for g in before(d, f) if g.sentence == f.sentence or _named(d, mover, f))
    if any(mover in _ids_of(g.object) for g in before(d, f)):
        return False  # "lets go of a stone. It glides on"
    acts_of_others = [g for g in others if mover not in _ids_of(g.subject)]
    if not known and falls:  # "brakes hard, and a suitcase falls off the rack"
        causes = [g for g in acts_of_others if g.verb.sense not in _NO_CAUSES]
        return any(g.sentence == f.sentence for g in causes)
    return known and bool(acts_of_others)


def _let(f: Frame) -> bool:
    """ "Lets it fall": what only has to be let go."""
    return f.causer is not None and f.causer.verb.lemma == "let"


def _named(d: Discourse, who: str, f: Frame) -> bool:
    """Whether the text names a thing before a clause."""
    begin = f.subject.start if f.subject is not None else f.verb.start
    return any(m.start < begin and who in _ids_of(m) for m in d.mentions)


def _ids_of(m: Mention | None) -> list[str]:
    return [] if m is None else [*m.entities]


def _order(d: Discourse, clause: Clause, earlier: list[Frame]) -> Iterator[Ordered]:
    start, end = _words(d, clause.frame, earlier)
    first, second = _last_event(d, earlier), _events(d, [clause.frame])
    if first is None:
        others = [c for c in d.scene.clauses if any(c.frame.verb is g.verb for g in earlier)]
        apart = any({*c.movers} - {*clause.movers} for c in others)
        so = clause.frame.subordinate == "so"
        if apart and (clause.movers or second) and _acts(earlier) and not so:
            yield Ordered(start, end)
        return
    node = d.timeline.node(first)
    about = {*node.participants} if node is not None else set[str]()
    apart = [m for m in clause.movers if m not in about]
    waiting = tuple(m for m in apart if _waits(d, m))
    if waiting:
        yield Ordered(start, end, Predicate.STAYS_STILL, waiting, f"start..{first}")
    later = next((e for e in second if e != first and not _leads(d, first, e)), None)
    if later is not None and (apart or not clause.movers) and len(waiting) < max(len(apart), 1):
        yield Ordered(start, end, Predicate.BEFORE, (first, later))
    elif apart and not second and not waiting:
        yield Ordered(start, end)


def _acts(earlier: list[Frame]) -> bool:
    return any(g.verb.sense not in STATES for g in earlier)


def _events(d: Discourse, clauses: list[Frame]) -> list[str]:
    """The measured events that clauses tell, in the order told."""
    verbs = {id(g.verb) for g in clauses}
    nodes = [d.timeline.node(n) for g, n in d.times.of_frame if id(g.verb) in verbs]
    return [n.id for n in nodes if n is not None and measurable(n.event)]


def _last_event(d: Discourse, clauses: list[Frame]) -> str | None:
    return next(reversed(_events(d, clauses)), None)


def _waits(d: Discourse, actor: str) -> bool:
    """Whether it stands still at first."""
    first = next((e for e in d.timeline.edges if e.actor == actor and e.from_ == START), None)
    uniform = first is not None and first.event is EdgeEvent.UNIFORM_MOTION
    return uniform and first is not None and first.params.speed == 0.0


def _leads(d: Discourse, first: str, second: str) -> bool:
    """Whether segments lead from one event to the other: the judge asks for that order anyway."""
    reached, before = {first}, set[str]()
    while reached != before:
        before = {*reached}
        reached |= {e.to for e in d.timeline.edges if e.from_ in reached}
    return second in reached


def _words(d: Discourse, f: Frame, earlier: list[Frame]) -> tuple[int, int]:
    """Where the order is told: the conjunction, or "then"; else the verb."""
    for g in (*earlier, f):
        word = rf"\b{re.escape(g.subordinate)}\b" if g.subordinate else None
        found = [*re.finditer(word, d.text[: g.verb.start], re.IGNORECASE)] if word else []
        if found and (g.main is f or g is f):
            return found[-1].span()
    begin = max((g.verb.end for g in earlier if g.verb.end < f.verb.start), default=0)
    found = [*_THEN.finditer(d.text, begin, f.verb.end + 20)]
    return found[0].span() if found else (f.verb.start, f.verb.end)
