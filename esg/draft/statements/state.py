"""The statements of a prompt, clause by clause."""

from __future__ import annotations

from collections.abc import Callable

from esg.draft.discourse.jointed import is_flap
from esg.draft.discourse.places import told_by_side
from esg.draft.discourse.proposition import Clause, Said
from esg.draft.discourse.record import Discourse
from esg.draft.events.senses.gestures import USED as GESTURE
from esg.draft.events.stated import adverbs_of, place_of
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.statements.account import Account
from esg.draft.statements.book import Book, Told, span
from esg.draft.statements.climbed import climbed, climbs_told
from esg.draft.statements.ends import at_parts
from esg.draft.statements.held import (
    carried,
    driver,
    kept_on_top,
    posture,
    short_of_edges,
    support,
    tow,
)
from esg.draft.statements.kept import AT_REST, BESIDE_MOTIONS
from esg.draft.statements.looks.gestures import gestures
from esg.draft.statements.looks.lying import USED as LIES
from esg.draft.statements.looks.lying import lying
from esg.draft.statements.looks.postures import postures
from esg.draft.statements.looks.shown import shown
from esg.draft.statements.looks.wobbling import wobbling
from esg.draft.statements.looks.worn import USED, worn
from esg.draft.statements.manners import flown, gains, paced, rolled, slid
from esg.draft.statements.order import ALONE, UNKEPT, orders, started_alone
from esg.draft.statements.unclaimed import unclaimed
from esg.draft.statements.unkept import BY_ITSELF, UNCARRIED, UNTOUCHED, dropped, missing
from esg.draft.statements.unseen import unseen
from esg.draft.statements.ways import goal, landed, leapt, moved
from esg.draft.text.elements import Element, Token
from esg.graph.models import Predicate, Statement

_CAUSES = frozenset({ALONE, BY_ITSELF, UNCARRIED, UNTOUCHED})
"""What is owned up to of a verb whose motion is shown: only nothing brings it about."""


def state(
    d: Discourse, frames: list[Frame], elements: list[Element], tokens: list[Token]
) -> tuple[Statement, ...] | None:
    """What the prompt states beyond objects, relations and events; None if nothing.

    Args:
        d: The discourse, after the timeline's motions have been finished.
        frames: All clauses.
        elements: What the text was read as.
        tokens: Its words.
    """
    book = Book(d)
    told = Told(d, book, frames, elements, tokens)
    for write_down in WRITTEN:
        write_down(told)
    return tuple(sorted(book.items, key=lambda s: s.start)) or None


def _clauses(told: Told) -> None:
    """What each clause that was read moves or holds, and what was lost of it."""
    d, book = told.d, told.book
    shown = (Predicate.WOBBLES, Predicate.AT_REST)
    said = {(s.start, s.end) for s in book.items if s.predicate in shown}
    for clause in d.scene.clauses:
        why = "" if span(clause.frame) in said else missing(d, clause)
        if why:
            _unkept(book, clause.frame, why)
        tow(book, clause)
        if clause.movers:
            _motion(book, clause)
        else:
            posture(book, clause)
            for s in clause.said:
                if s.row.states is Predicate.CARRIED_BY:
                    carried(book, clause, s, "")


def _dropped(told: Told) -> None:
    """Clauses that nothing was read from, and words that no clause holds."""
    d, book = told.d, told.book
    read = {span(c.frame) for c in d.scene.clauses}
    said = {(s.start, s.end) for s in book.items}
    for f in told.frames:
        why = "" if span(f) in said else dropped(d, f)
        if why and (span(f) not in read or not _moves(d, f)):
            _unkept(book, f, why)
    rounds = [(s.start, s.end) for s in book.items if s.direction == "around"]  # "in circles"
    for start, end, why in unseen(d, told.frames, told.elements):
        if not any(a <= start and end <= b for a, b in rounds):
            book.add(Predicate.NOT_REPRESENTED, start, end, note=why)


def _in_order(t: Told) -> None:
    """In what order different things act, and who sets off by itself."""
    book = t.book
    for told in orders(book.d):
        if told.says is None:
            book.add(Predicate.NOT_REPRESENTED, told.start, told.end, note=UNKEPT)
        else:
            book.add(told.says, told.start, told.end, object=told.about, when=told.when)
    alone: dict[tuple[int, int], list[str]] = {}
    for start, end, who in started_alone(book.d):
        alone.setdefault((start, end), []).append(who)
    lost = {(s.start, s.end) for s in book.items if s.note == BY_ITSELF}
    for (start, end), who in alone.items():
        if (start, end) not in lost:
            book.add(Predicate.NOT_REPRESENTED, start, end, object=tuple(who), note=ALONE)


def _sides(t: Told) -> None:
    """ "The left plate", where there is a right one: it is on the left of that."""
    entities = t.d.world.entities
    for left, right in told_by_side(entities):
        for one, other, says in (
            (left, right, Predicate.LEFT_OF),
            (right, left, Predicate.RIGHT_OF),
        ):
            side = entities[one].label.split()[0]
            named = (m for m in t.d.mentions if one in m.entities and side in m.adjectives)
            for m in [*named][:1]:
                t.book.add(says, m.start, m.end, object=(one,), target=(other,), when="start")


def _own_up(t: Told) -> None:
    """Writes down what nothing in the document stands for, each of the words once."""
    d, book = t.d, t.book
    owned = [s for s in book.items if s.predicate is Predicate.NOT_REPRESENTED]
    lost = [(s.start, s.end) for s in owned]
    lost += [at for at, why in d.scene.used.items() if why in (USED, GESTURE, LIES)]
    gone = [(s.start, s.end) for s in owned if s.note not in _CAUSES]
    told = [f for f in t.frames if not f.unreal and not f.verb.negated]
    lost_clauses = [f for f in told if _is_lost(d, f, gone)]
    told = [f for f in told if span(f) in d.scene.used and span(f) not in gone]
    untold = _of_what_does_not_happen(d, t.frames)
    said = [*book.items]
    for gap in unclaimed(Account(d, told, t.elements, t.tokens, said, untold, lost_clauses)):
        asked = any(q.start <= gap.start < q.end for q in d.scene.asked)
        if not asked and not any(a < gap.end and gap.start < b for a, b in lost):
            lost.append((gap.start, gap.end))
            book.add(Predicate.NOT_REPRESENTED, gap.start, gap.end, object=gap.nodes,
                     note=gap.missing)  # fmt: skip


def _is_lost(d: Discourse, f: Frame, gone: list[tuple[int, int]]) -> bool:
    """Whether nothing was made of a verb, or not what it says: its places are asked for too."""
    unread = span(f) not in d.scene.used and span(f) not in d.scene.ignored
    return span(f) in gone or (unread and not f.times)


def _of_what_does_not_happen(d: Discourse, frames: list[Frame]) -> set[tuple[int, int]]:
    """Where the adverbs of clauses that tell of nothing stand ("does not walk carefully")."""
    denied = [f for f in frames if f.unreal or f.verb.negated]
    places = (place_of(word, d.text, f) for f in denied for word in adverbs_of(d.text, f))
    return {at for at in places if at is not None}


def _moves(d: Discourse, f: Frame) -> bool:
    return any(c.frame.verb is f.verb and c.movers for c in d.scene.clauses)


def _unkept(book: Book, f: Frame, why: str) -> None:
    """A verb that no part of the document stands for."""
    about = [i for m in (f.subject, f.object) if m is not None for i in m.entities]
    nodes = tuple(i for i in dict.fromkeys(about) if i in book.d.world.entities)
    book.add(Predicate.NOT_REPRESENTED, *span(f), object=nodes, note=why)


def _motion(book: Book, clause: Clause) -> None:
    """What the words of a clause state of what it moves."""
    climbed(book, clause)
    for s in clause.said:
        for mover in clause.movers:
            _said(book, clause, s, mover)
    for p in clause.frame.phrases:
        support(book, clause, p)
        if clause.frame.verb.sense == "land":
            landed(book, clause, p)
        leapt(book, p)
    if clause.frame.verb.sense == "accelerate":
        for mover in clause.movers:
            gains(book, clause, mover)


def _said(book: Book, clause: Clause, s: Said, mover: str) -> None:
    if s.row.states is Predicate.MOVES and climbs_told(book.d, clause):
        return  # up what it climbs
    if s.row.part == "goal":
        flap = s.row.states is Predicate.UNDER and is_flap(book.d.scene, book.d.text, mover)
        if clause.frame.verb.lemma == "pass" or flap:
            return  # "passes under a bridge": it does not end there; "a trapdoor opens under him"
        goal(book, clause, s, mover)
    else:
        _SAYINGS[s.row.states](book, clause, s, mover)


_SAYINGS: dict[Predicate, Callable[[Book, Clause, Said, str], None]] = {
    Predicate.SLOWER_THAN: paced,
    Predicate.FASTER_THAN: paced,
    Predicate.CARRIED_BY: carried,
    Predicate.ROLLS: rolled,
    Predicate.SLIDES: slid,
    Predicate.AIRBORNE: flown,
    Predicate.INSIDE: driver,
    Predicate.SUPPORTED_BY: driver,
    Predicate.MOVES: moved,
}
"""How each predicate that a row of the table states is written down."""

WRITTEN: tuple[Callable[[Told], None], ...] = (
    worn,
    _sides,
    shown,
    lying,
    wobbling,
    postures,
    gestures,
    _clauses,
    _dropped,
    at_parts,
    kept_on_top,
    short_of_edges,
    *BESIDE_MOTIONS,
    _in_order,
    _own_up,
    *AT_REST,
)
"""What is written down, in this order: what owns up to the rest sees what is stated before it."""
