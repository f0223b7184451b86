"""How something moves: fast or slowly, rolling, sliding, flying."""

from __future__ import annotations

import re

from esg.draft.discourse.core import amounts_of, entity_of, kind_of
from esg.draft.discourse.proposition import Clause, Said
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import SELF_POWERED, SPEEDS
from esg.draft.discourse.windows import START
from esg.draft.events.courses import GENTLE_BRAKE_CM_S2, HARD_BRAKE_CM_S2, chosen_pace, measurable
from esg.draft.events.gaits import on_legs
from esg.draft.events.motions import can_roll, flies_itself
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.statements.book import Book, span
from esg.draft.statements.climbed import climbs_told
from esg.draft.statements.periods import hurled, period, segment_from, segments
from esg.draft.verbphrases import verb_readings
from esg.graph.models import EdgeEvent, Predicate, Quantity

_CORNERED = ("box", "compound")
"""Shapes that do not roll, whatever a text says."""
_ON_NO_WHEELS = frozenset({"baby", "boy", "child", "girl", "kid", "man", "toddler", "woman"})
"""Persons of whom "rolls" says that they turn over and over, which a skateboarder does not."""
GENTLE_CM_S = 150.0
"""What is put down "gently" is nowhere faster: hands that reach go at 0.5 to 1.5 m/s."""


def paced(book: Book, clause: Clause, s: Said, mover: str) -> None:
    """ "Slowly", "races": no faster, or faster, than what the word leaves of its kind's speeds.

    "Walks" and "runs" without a word of pace are said of legs only.
    """
    legs = on_legs(entity_of(book.d, mover), clause.frame.verb.lemma)
    if not s.row.pace and legs is None:
        return
    if s.row.part == "braking":
        rate = HARD_BRAKE_CM_S2 if s.row.pace == "fast" else GENTLE_BRAKE_CM_S2
        book.add(s.row.states, s.start, s.end, object=(mover,), quantity="deceleration",
                 value=round(rate, 2))  # fmt: skip
        return
    if not chosen_pace(clause.frame, s):
        return
    value = _pace(book.d, clause, mover, s.row.states)
    if value is not None:
        start, end = s.start, s.end
        if not s.row.pace and legs is not None and not climbs_told(book.d, clause):
            (start, end), slow = _gait_word(book.d, s), s.row.states is Predicate.SLOWER_THAN
            value = round(1.1 * legs[1] if slow else 0.9 * legs[0], 2)
        book.add(s.row.states, start, end, object=(mover,), quantity="speed", value=value,
                 when=period(book.d, clause, mover))  # fmt: skip


_STEPS = 1.8
"""Who climbs goes up in steps, each of them faster than all of them together."""


def _gait_word(d: Discourse, s: Said) -> tuple[int, int]:
    """Where the verb itself stands: "run" of "run out", of which "out" says more."""
    for word in re.finditer(r"\w+", d.text[s.start : s.end]):
        if any(r.lemma in s.row.words for r in verb_readings(word[0].lower())):
            return s.start + word.start(), s.start + word.end()
    return s.start, s.end


def _pace(d: Discourse, clause: Clause, mover: str, says: Predicate) -> float | None:
    """The speed [cm/s] that a word such as "slowly" leaves a mover of its kind."""
    since = clause.since.get(mover, START)
    edge = segment_from(d, mover, since)
    if edge is not None and edge.event is EdgeEvent.GUIDE and edge.params.climbs is None:
        return GENTLE_CM_S if says is Predicate.SLOWER_THAN else None
    speed: Quantity | None = edge.params.speed if edge is not None else None
    if edge is None or edge.speed_is_prescribed or not isinstance(speed, tuple):
        return None
    most = _STEPS if edge.params.climbs is not None else 1.1
    return round(most * speed[1] if says is Predicate.SLOWER_THAN else 0.9 * speed[0], 2)


def gains(book: Book, clause: Clause, mover: str) -> None:
    """ "A train accelerates": in the end it has at least the speed that its kind usually has."""
    edges = list(segments(book.d, mover))
    last = next((e for e in edges if e.event is EdgeEvent.ACCELERATED_MOTION), None)
    end = book.d.timeline.node(last.to) if last is not None else None
    usual = SPEEDS.get(kind_of(book.d, mover))
    if end is None or not isinstance(usual, tuple) or amounts_of(book.d, clause.frame):
        return  # numbers say it better
    if measurable(end.event) or last is edges[-1]:
        when = end.id if measurable(end.event) else "end"
        book.add(Predicate.FASTER_THAN, *span(clause.frame), object=(mover,), quantity="speed",
                 value=usual[0], when=when)  # fmt: skip


def rolled(book: Book, clause: Clause, s: Said, mover: str) -> None:
    """ "A ball rolls"; of a car it is only how one says that it moves, and a box cannot."""
    d = book.d
    noun = entity_of(d, mover).noun
    if "round" not in noun.traits and noun.kind in SELF_POWERED:
        bodily = noun.kind == "animal" or entity_of(d, mover).head in _ON_NO_WHEELS
        if bodily and clause.frame.verb.lemma == "roll":
            note = f"{entity_of(d, mover).head} does not turn over: it moves"
            book.add(Predicate.NOT_REPRESENTED, s.start, s.end, object=(mover,), note=note)
        return
    if noun.shape in _CORNERED and not can_roll(d, mover) and "wheeled" not in noun.traits:
        note = f"{entity_of(d, mover).head} is not round: it slides"
        book.add(Predicate.NOT_REPRESENTED, s.start, s.end, object=(mover,), note=note)
    else:
        plainly(book, clause, s, mover)


def slid(book: Book, clause: Clause, s: Said, mover: str) -> None:
    """ "A crate slides"; of a balloon "slips away" says that it goes off into the air.

    Who slides a drawer shut does not slide.
    """
    f = clause.frame
    done_to = [] if f.object is None or f.verb.passive else f.object.entities
    does_it = bool(done_to) and mover not in done_to and mover in _doers(f)
    if f.verb.sense != "fly" and not does_it:
        plainly(book, clause, s, mover)


def _doers(f: Frame) -> list[str]:
    return [] if f.subject is None else f.subject.entities


def plainly(book: Book, clause: Clause, s: Said, mover: str) -> None:
    """Writes a predicate down for as long as its clause tells."""
    where = period(book.d, clause, mover)
    book.add(s.row.states, s.start, s.end, object=(mover,), when=where)


def flown(book: Book, clause: Clause, s: Said, mover: str) -> None:
    """ "Flies", and "floats" of what stays in the air."""
    d = book.d
    if any(j.child == mover and j.kind != "rope" for j in d.scene.joints):
        return  # "the last ball of the cradle flies out": its string holds it
    host = d.scene.supported_by.get(mover)
    if host is not None and d.world.entities[host].noun.kind == "water":
        return  # "a duck floats on a pond": on what it lies is stated
    if hurled(d, mover) and period(d, clause, mover) == "throughout":
        # What is thrown comes down again.
        book.add(s.row.states, s.start, s.end, object=(mover,), when="start")
    elif clause.frame.verb.sense == "fly" or mover in d.moves.flying or flies_itself(d, mover):
        plainly(book, clause, s, mover)
