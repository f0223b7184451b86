"""The statements of a prompt, clause by clause."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
import re
from typing import Any

from esg.draft.discourse.bearing import bears, borne_until
from esg.draft.discourse.core import amounts_of, entity_of, kind_of, structural
from esg.draft.discourse.proposition import Clause, Said
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.thinghood import without
from esg.draft.discourse.scene import GROUND, LIMBED, SELF_POWERED, SPEEDS
from esg.draft.discourse.windows import START
from esg.draft.events.courses import (
    GENTLE_BRAKE_CM_S2,
    HARD_BRAKE_CM_S2,
    TURNING,
    chosen_pace,
    measurable,
    oncoming,
    queues_behind,
)
from esg.draft.events.hanging import SENT_UP, UNMET, row_of
from esg.draft.events.motions import can_roll, flies_itself
from esg.draft.events.stated import adverbs_of, place_of, start_of
from esg.draft.events.told import things
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.statements.account import Account
from esg.draft.statements.order import ALONE, UNKEPT, orders, started_alone
from esg.draft.statements.struck import struck
from esg.draft.statements.unclaimed import unclaimed
from esg.draft.statements.unkept import BY_ITSELF, UNTOUCHED, dropped, missing
from esg.draft.statements.unseen import unseen
from esg.draft.text.elements import Element, Token
from esg.graph.models import (
    EdgeEvent,
    NodeEvent,
    Predicate,
    Quantity,
    Statement,
    TimelineEdge,
)

GENTLE_CM_S = 150.0
"""What is put down "gently" is nowhere faster: hands that reach go at 0.5 to 1.5 m/s."""
_STAND = "the stand of a seesaw is drawn for it"
_STANDS = "nothing sees to it that it comes the other way"
_LASTING = ("own", "roll", "slide", "spin", "coast", "continue", "accelerate", "brake", "swerve")
"""Senses of moving on something, and not onto it."""
_SIDE_WORDS = {
    "left_of": re.compile(r"\bleft\b", re.IGNORECASE),
    "right_of": re.compile(r"\bright\b", re.IGNORECASE),
    "in_front_of": re.compile(r"\bfront\b", re.IGNORECASE),
    "behind": re.compile(r"\b(?:behind|back|rear)\b", re.IGNORECASE),
}
"""The words of a side, of which the first in the text is where something starts."""
_POSTURES = {
    **dict.fromkeys(("hang", "dangle", "suspend"), Predicate.HANGS_FROM),
    **dict.fromkeys(("lean", "prop"), Predicate.LEANS_ON),
}
"""What verbs of posture say of what holds something."""
_CARRIED_ON = ("on", "atop", "on top of", "upon")
"""Prepositions of what carries something."""
_ON_THE_WAY = ("along", "across", "through")
"""Directions that roads, fields and floors have, too."""
_ON_NO_WHEELS = frozenset({"baby", "boy", "child", "girl", "kid", "man", "toddler", "woman"})
"""Persons of whom "rolls" says that they turn over and over, which a skateboarder does not."""
_STAYING = frozenset({"stay", "remain", "keep"})
_ON_END = re.compile(
    r"\s+(?:still\s+)?(?:upright|standing|on (?:its|their|his|her) feet)\b", re.IGNORECASE
)
UNANSWERED = "a question: nothing of it is drafted"
_CORNERED = ("box", "compound")
"""Shapes that do not roll, whatever a text says."""
_CAUSES = frozenset({ALONE, BY_ITSELF, UNTOUCHED})
"""What is owned up to of a verb whose motion is shown: only nothing brings it about."""
_TARGETED = frozenset({"toward", "away_from", "along", "past", "across", "through", "around"})


@dataclass
class _Book:
    """The statements so far."""

    d: Discourse
    items: list[Statement] = field(default_factory=list[Statement])

    def add(self, says: Predicate, start: int, end: int, **more: Any) -> None:
        """Writes down a statement whose words stand in the text from start to end."""
        words = self.d.text[start:end]
        told = Statement(
            id=f"s{len(self.items) + 1}", predicate=says, text=words, start=start, end=end, **more
        )
        lost = says is Predicate.NOT_REPRESENTED  # each word of its own
        same = ("id",) if lost else ("id", "text", "start", "end")
        if all(
            told.model_dump(exclude={*same}) != x.model_dump(exclude={*same}) for x in self.items
        ):
            self.items.append(told)
        if not lost:
            self.d.scene.used.setdefault((start, end), f"statement: {says.value}")


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
    book = _Book(d)
    read = {_span(c.frame) for c in d.scene.clauses}
    for clause in d.scene.clauses:
        why = missing(d, clause)
        if why:
            _unkept(book, clause.frame, why)
        _tow(book, clause)
        if clause.movers:
            _motion(book, clause)
        else:
            _posture(book, clause)
            for s in clause.said:
                if s.row.states is Predicate.CARRIED_BY:
                    _carried(book, clause, s, "")
    said = {(s.start, s.end) for s in book.items}
    for f in frames:
        why = "" if _span(f) in said else dropped(d, f)
        if why and (_span(f) not in read or not _moves(d, f)):
            _unkept(book, f, why)
    for start, end, why in unseen(d, frames, elements):
        book.add(Predicate.NOT_REPRESENTED, start, end, note=why)
    _struck(book, frames)
    _upright(book, frames)
    _borne(book, frames)
    _unmet(book, frames)
    _unmanned(book, elements)
    _comes_on(book)
    _sent_up(book, frames)
    _untouched(book)
    for m in (m for m in d.mentions if without(m, d.text)):
        book.add(Predicate.ABSENT, m.start - len("without "), m.end, noun=m.head)
    for q in (q for q in d.scene.asked if not q.answered):
        book.add(Predicate.NOT_REPRESENTED, q.start, q.end, note=UNANSWERED)
    _in_order(book)
    _own_up(book, frames, elements, tokens)
    for actor, at in d.moves.still.items():
        if actor in d.world.entities:
            book.add(Predicate.STAYS_STILL, at, _word_end(d.text, at), object=(actor,))
    moved = {e.actor for e in d.timeline.edges}
    for actor, at in d.moves.stays.items():
        if actor in d.world.entities and actor not in moved:
            hits = (n for n in d.timeline.nodes if n.event is NodeEvent.COLLISION)
            hit = next((n.id for n in hits if actor in n.participants), None)
            book.add(Predicate.STAYS_STILL, at, _word_end(d.text, at), object=(actor,),
                     when="throughout" if hit is None else f"start..{hit}")  # fmt: skip
    return tuple(sorted(book.items, key=lambda s: s.start)) or None


def _struck(book: _Book, frames: list[Frame]) -> None:
    """Which side of a thing is said to be hit."""
    for hit in struck(book.d, frames):
        if hit.side is None:
            book.add(Predicate.NOT_REPRESENTED, hit.start, hit.end, object=(hit.struck,),
                     note=hit.note)  # fmt: skip
        else:
            book.add(Predicate.STRUCK_ON, hit.start, hit.end, object=(hit.struck,),
                     target=(hit.by,), side=hit.side, when=hit.event)  # fmt: skip


def _over(f: Frame) -> bool:
    return bool({"over", "down"} & {*f.adverbs})


def _upright_thing(d: Discourse, i: str) -> bool:
    """Whether "falls" of a thing means that it topples."""
    return i in d.world.entities and "topples" in entity_of(d, i).noun.traits


def _upright(book: _Book, frames: list[Frame]) -> None:
    """ "The bottle does not tip over": unless it does so elsewhere in the text."""
    told = (n for n in book.d.timeline.nodes if n.event in (NodeEvent.TOPPLE, NodeEvent.FALL))
    fallen = {i for n in told for i in n.participants}
    for f in frames:
        denied = f.verb.negated and f.verb.sense in ("topple", "knock", "fall") and not f.unreal
        acted = f.object is not None and not f.verb.passive
        who = _ids(f.object if acted else f.subject) if denied else []
        if f.verb.sense == "fall" or (acted and f.verb.sense == "knock" and not _over(f)):
            who = (
                []
                if f.phrases or "off" in f.adverbs
                else [i for i in who if _upright_thing(book.d, i)]
            )
        stand = tuple(i for i in who if i in book.d.world.entities)
        stays = f.verb.lemma in _STAYING and _ON_END.match(book.d.text, f.verb.end)
        if stays and not f.unreal and not f.verb.negated:
            stand = tuple(i for i in _ids(f.subject) if i in book.d.world.entities)
        if stand and not fallen & {*stand}:
            book.add(Predicate.STAYS_UPRIGHT, *_span(f), object=stand)


def _borne(book: _Book, frames: list[Frame]) -> None:
    """ "Stands on a turntable that spins": it stays there, and who stands or lives stays upright.

    On a swing he leans as it does.
    """
    d = book.d
    said = [(_ids(m), p, False) for m, p in d.attached]
    said += [(_ids(f.subject), p, f.verb.lemma == "stand") for f in frames for p in f.phrases]
    for about, p, stands in said:
        hosts = _ids(p.mention) if p.prep in _CARRIED_ON else []
        for rider in about:
            bearer = d.scene.supported_by.get(rider, "")
            if bearer not in hosts or rider in d.timeline.tracks or not bears(d.scene, bearer):
                continue
            parted = borne_until(d.scene, rider, bearer)
            words = (start_of(p, d.text), p.mention.end if p.mention is not None else 0)
            when = "throughout" if parted is None else f"start..{parted}"
            book.add(Predicate.SUPPORTED_BY, *words, object=(rider,), target=(bearer,), when=when)
            row = row_of(d, bearer)
            steady = row is None or row.drawn is None
            if steady and (stands or kind_of(d, rider) in LIMBED):
                book.add(Predicate.STAYS_UPRIGHT, *words, object=(rider,), when=when)


def _unmet(book: _Book, frames: list[Frame]) -> None:
    """ "Stops just before hitting a child", "puts it down without touching the cup"."""
    for f in frames:
        spared = f.verb.sense == "stop" and "before" in f.verb.extra and not f.unreal
        spared = spared or book.d.scene.used.get(_span(f)) == UNMET
        who = [i for i in _ids(f.subject) if i in book.d.world.entities] if spared else []
        others = tuple(i for i in _ids(f.object) if i in book.d.world.entities and i not in who)
        if who and others and not _met(book.d, who[0], [*others]):
            book.add(Predicate.NEVER_TOUCHES, *_span(f), object=tuple(who), target=others)


def _sent_up(book: _Book, frames: list[Frame]) -> None:
    """ "A stone falls on one end and the other end flings a coin up": it rises from the jolt on."""
    for f in frames:
        if book.d.scene.used.get(_span(f)) != SENT_UP:
            continue
        sent = _ids(f.object) if f.object is not None and not f.verb.passive else _ids(f.subject)
        for body in sent:
            if when := _since_the_jolt(book.d, body):
                book.add(Predicate.MOVES, *_span(f), object=(body,), direction="up", when=when)
    for e in book.d.world.entities.values():
        start = book.d.text.find(e.label, max(e.origin, 0)) if e.lever == "fulcrum" else -1
        if start >= 0:
            book.add(Predicate.NOT_REPRESENTED, start, start + len(e.label), object=(e.id,),
                     note=_STAND)  # fmt: skip


def _since_the_jolt(d: Discourse, body: str) -> str:
    """The time after something has hit the seesaw that a body is on; "" if nothing does."""
    board = d.scene.supported_by.get(body)
    hits = (n for n in d.timeline.nodes if n.event is NodeEvent.COLLISION)
    jolt = next((n.id for n in hits if board in n.participants), "")
    return jolt and f"{jolt}..end"


def _unmanned(book: _Book, elements: list[Element]) -> None:
    """ "A cart with nobody in it": no person is drawn, unless another is told of."""
    people = any(e.noun.kind == "person" for e in book.d.world.entities.values())
    for e in elements if not people else ():
        if getattr(e, "low", "") == "unmanned":
            book.add(Predicate.ABSENT, e.start, e.end, noun="person")


def _comes_on(book: _Book) -> None:
    """ "An oncoming truck": it drives, and nothing sees to it that it comes the other way."""
    for start, end, who, _ in oncoming(book.d):
        book.add(Predicate.NOT_REPRESENTED, start, end, object=(who,), note=_STANDS)


def _untouched(book: _Book) -> None:
    """ "Hits neither of them", "touches nothing": but for what it is told to hit."""
    told = (n for n in book.d.timeline.nodes if n.event in (NodeEvent.COLLISION, NodeEvent.MISS))
    met = {frozenset(n.participants) for n in told}
    for u in book.d.scene.untouched:
        others = tuple(i for i in u.others if frozenset((u.who, i)) not in met)
        if others:
            book.add(Predicate.NEVER_TOUCHES, u.start, u.end, object=(u.who,), target=others)


def _in_order(book: _Book) -> None:
    """In what order different things act, and who sets off by itself."""
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


def _own_up(book: _Book, frames: list[Frame], elements: list[Element], tokens: list[Token]) -> None:
    """Writes down what nothing in the document stands for, each of the words once."""
    d = book.d
    owned = [s for s in book.items if s.predicate is Predicate.NOT_REPRESENTED]
    lost = [(s.start, s.end) for s in owned]
    gone = [(s.start, s.end) for s in owned if s.note not in _CAUSES]
    told = [f for f in frames if not f.unreal and not f.verb.negated]
    told = [f for f in told if _span(f) in d.scene.used and _span(f) not in gone]
    untold = _of_what_does_not_happen(d, frames)
    for gap in unclaimed(Account(d, told, elements, tokens, [*book.items], untold)):
        asked = any(q.start <= gap.start < q.end for q in d.scene.asked)
        if not asked and not any(a < gap.end and gap.start < b for a, b in lost):
            lost.append((gap.start, gap.end))
            book.add(Predicate.NOT_REPRESENTED, gap.start, gap.end, object=gap.nodes,
                     note=gap.missing)  # fmt: skip


def _of_what_does_not_happen(d: Discourse, frames: list[Frame]) -> set[tuple[int, int]]:
    """Where the adverbs of clauses that tell of nothing stand ("does not walk carefully")."""
    denied = [f for f in frames if f.unreal or f.verb.negated]
    places = (place_of(word, d.text, f) for f in denied for word in adverbs_of(d.text, f))
    return {at for at in places if at is not None}


def _moves(d: Discourse, f: Frame) -> bool:
    return any(c.frame.verb is f.verb and c.movers for c in d.scene.clauses)


def _unkept(book: _Book, f: Frame, why: str) -> None:
    """A verb that no part of the document stands for."""
    about = [i for m in (f.subject, f.object) if m is not None for i in m.entities]
    nodes = tuple(i for i in dict.fromkeys(about) if i in book.d.world.entities)
    book.add(Predicate.NOT_REPRESENTED, *_span(f), object=nodes, note=why)


def _motion(book: _Book, clause: Clause) -> None:
    """What the words of a clause state of what it moves."""
    for s in clause.said:
        for mover in clause.movers:
            _said(book, clause, s, mover)
    for p in clause.frame.phrases:
        _support(book, clause, p)
        if clause.frame.verb.sense == "land":
            _landed(book, clause, p)
        _leapt(book, p)
    if clause.frame.verb.sense == "accelerate":
        for mover in clause.movers:
            _gains(book, clause, mover)


def _landed(book: _Book, clause: Clause, p: Phrase) -> None:
    """ "A bird lands on a branch": it comes down by itself, and there it stays."""
    d = book.d
    if p.mention is None or p.prep not in ("on", "onto", "upon", "atop", "on top of"):
        return
    hosts = [i for i in things(p) if i in d.world.entities and not structural(d, i)][:1]
    for mover in clause.movers if hosts else []:
        edges = list(_of(d, mover))
        kinds = {n.id: n.event for n in d.timeline.nodes}
        over = bool(edges) and measurable(kinds.get(edges[-1].to, NodeEvent.TRIGGER))
        if not flies_itself(d, mover) or not over or mover in hosts:
            continue
        words = (start_of(p, d.text), p.mention.end)
        book.add(Predicate.MOVES, *_span(clause.frame), object=(mover,), direction="down",
                 when=_when(d, clause, mover))  # fmt: skip
        book.add(Predicate.ENDS_ON, *words, object=(mover,), target=tuple(hosts), when="end")


def _leapt(book: _Book, p: Phrase) -> None:
    """ "Jumps onto a table": there it stays, unless more is told of it."""
    d = book.d
    for mover, host in d.moves.upon.items():
        last = next((n for n in reversed(d.timeline.nodes) if mover in n.participants), None)
        stays = last is not None and host in last.participants
        if p.mention is not None and stays and host in things(p):
            words = (start_of(p, d.text), p.mention.end)
            book.add(Predicate.ENDS_ON, *words, object=(mover,), target=(host,), when="end")


def _gains(book: _Book, clause: Clause, mover: str) -> None:
    """ "A train accelerates": in the end it has at least the speed that its kind usually has."""
    edges = list(_of(book.d, mover))
    last = next((e for e in edges if e.event is EdgeEvent.ACCELERATED_MOTION), None)
    end = book.d.timeline.node(last.to) if last is not None else None
    usual = SPEEDS.get(kind_of(book.d, mover))
    if end is None or not isinstance(usual, tuple) or amounts_of(book.d, clause.frame):
        return  # numbers say it better
    if measurable(end.event) or last is edges[-1]:
        when = end.id if measurable(end.event) else "end"
        book.add(Predicate.FASTER_THAN, *_span(clause.frame), object=(mover,), quantity="speed",
                 value=usual[0], when=when)  # fmt: skip


def _said(book: _Book, clause: Clause, s: Said, mover: str) -> None:
    if s.row.part == "goal":
        if clause.frame.verb.lemma == "pass":
            return  # "passes under a bridge": it does not end there
        _goal(book, clause, s, mover)
    else:
        _SAYINGS[s.row.states](book, clause, s, mover)


def _paced(book: _Book, clause: Clause, s: Said, mover: str) -> None:
    """ "Slowly", "races": no faster, or faster, than what the word leaves of its kind's speeds."""
    if s.row.part == "braking":
        rate = HARD_BRAKE_CM_S2 if s.row.pace == "fast" else GENTLE_BRAKE_CM_S2
        book.add(s.row.states, s.start, s.end, object=(mover,), quantity="deceleration",
                 value=round(rate, 2))  # fmt: skip
        return
    if not chosen_pace(clause.frame, s):
        return
    value = _pace(book.d, clause, mover, s.row.states)
    if value is not None:
        book.add(s.row.states, s.start, s.end, object=(mover,), quantity="speed", value=value,
                 when=_when(book.d, clause, mover))  # fmt: skip


def _carried(book: _Book, clause: Clause, s: Said, mover: str) -> None:
    """ "A truck carries a crate"."""
    d, f = book.d, clause.frame
    bearers = [i for i in _ids(f.subject) if i != mover] or [mover]
    for load in _ids(f.object):
        bearer = d.scene.supported_by.get(load)
        if load in d.world.entities and bearer in bearers:
            book.add(s.row.states, s.start, s.end, object=(load,), target=(bearer,))
            others = tuple(i for i in _ids(f.subject) if i != bearer and i in d.world.entities)
            if others:  # "two men carry a sofa"
                book.add(Predicate.NOT_REPRESENTED, s.start, s.end, object=others,
                         note="only one of them carries it")  # fmt: skip


def _rolled(book: _Book, clause: Clause, s: Said, mover: str) -> None:
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
        _plainly(book, clause, s, mover)


def _plainly(book: _Book, clause: Clause, s: Said, mover: str) -> None:
    where = _when(book.d, clause, mover)
    book.add(s.row.states, s.start, s.end, object=(mover,), when=where)


def _flown(book: _Book, clause: Clause, s: Said, mover: str) -> None:
    """ "Flies", and "floats" of what stays in the air."""
    d = book.d
    if any(j.child == mover and j.kind != "rope" for j in d.scene.joints):
        return  # "the last ball of the cradle flies out": its string holds it
    if d.scene.used.get(_span(clause.frame)) == SENT_UP:
        return  # it rises, and comes down again
    if clause.frame.verb.sense == "fly" or mover in d.moves.flying or flies_itself(d, mover):
        _plainly(book, clause, s, mover)


def _moved(book: _Book, clause: Clause, s: Said, mover: str) -> None:
    """Which way something moves: by an adverb, a phrase, or the verb itself ("crosses")."""
    if s.row.part == "adverb" and s.row.direction in _TARGETED:
        _back(book, clause, s, mover)
        return
    if s.row.part != "verb":
        _direction(book, clause, s, mover, _when(book.d, clause, mover))
        return
    d = book.d
    others = [i for i in _ids(clause.frame.object) if i != mover and i in d.world.entities][:1]
    targeted = s.row.direction in _TARGETED
    if not targeted or (others and not _met(d, mover, others)):
        target = tuple(others) if targeted else ()
        book.add(s.row.states, s.start, s.end, object=(mover,), target=target,
                 direction=s.row.direction, when=_when(d, clause, mover))  # fmt: skip


def _back(book: _Book, clause: Clause, s: Said, mover: str) -> None:
    """ "Hits a wall and rolls back": away from what it has hit; "apart" from each other.

    "Is hit and slides out of view" is away from what has hit it.
    """
    d, f, since = book.d, clause.frame, book.d.timeline.node(clause.since.get(mover, START))
    others = tuple(i for i in clause.movers if i != mover) if "apart" in s.row.words else ()
    struck_here = since is not None and since.event is NodeEvent.COLLISION
    met = [*since.participants] if since is not None and struck_here else list[str]()
    if mover in met and (mover == met[0]) is ("out of view" not in s.row.words):
        others = tuple(i for i in met if i != mover)
    if others and not f.object and not f.verb.passive:
        book.add(s.row.states, s.start, s.end, object=(mover,), target=others[:1],
                 direction=s.row.direction, when=_when(d, clause, mover))  # fmt: skip


def _tow(book: _Book, clause: Clause) -> None:
    """ "A truck tows a trailer": a joint holds them together."""
    if clause.frame.verb.sense == "tow":
        named = [i for m in (clause.frame.subject, clause.frame.object) for i in _ids(m)]
        scene = book.d.scene
        carts = (scene.supported_by.get(i) or scene.inside_of.get(i) for i in named)
        for node in dict.fromkeys([*named, *(i for i in carts if i)]):
            tow = book.d.scene.tows.get(node)
            if tow is not None:
                book.add(Predicate.ATTACHED_TO, *_span(clause.frame), object=(node,),
                         target=(tow.by,), when="start")  # fmt: skip
        by = {tow.by for tow in book.d.scene.tows.values()}
        drawing = _ids(clause.frame.subject)
        others = tuple(i for i in drawing if i not in by and i not in book.d.scene.tows)
        if others and by & {*drawing}:  # "two oxen pull a wagon"
            book.add(Predicate.NOT_REPRESENTED, *_span(clause.frame), object=others,
                     note="only one of them draws it")  # fmt: skip


def _posture(book: _Book, clause: Clause) -> None:
    """ "A lamp hangs from a branch", "a broom leans on a wall"."""
    d, f = book.d, clause.frame
    if f.verb.lemma == "hover":
        for body in (i for i in _ids(f.subject) if i in d.world.entities):
            book.add(Predicate.AIRBORNE, *_span(f), object=(body,))
    says = _POSTURES.get(f.verb.lemma)
    held = f.phrase("from", "by") if says is Predicate.HANGS_FROM else f.phrase("on", "against")
    targets = [i for i in things(held) if i in d.world.entities][:1]
    if says is None or not targets or held is None or held.mention is None:
        return
    acted_on = [] if f.verb.passive else _ids(f.object)
    for body in acted_on or _ids(f.subject):
        if body in d.world.entities and body not in targets:
            start = start_of(held, d.text)
            book.add(says, start, held.mention.end, object=(body,), target=tuple(targets),
                     when="start")  # fmt: skip


def _goal(book: _Book, clause: Clause, s: Said, mover: str) -> None:
    """ "Runs to the left of a chair": where it gets to; beside what moves, where it keeps."""
    d = book.d
    targets = [i for i in things(s.phrase) if i != mover and i in d.world.entities][:1]
    if not targets or structural(d, targets[0]) or _met(d, mover, targets):
        return
    hung = {j.child for j in d.scene.joints} | {*d.scene.attached}
    held = (r for r in d.scene.relations if r.target == targets[0] and r.source in hung)
    if any(r.kind == s.row.states.value for r in held):
        return  # "drifts into the fan above the table": what hangs there is above it
    if s.row.states is Predicate.ABOVE and clause.frame.verb.sense in ("drop", "fall"):
        return  # that is where it starts
    if queues_behind(d, s, mover) is not None:
        book.add(Predicate.MOVES, s.start, s.end, object=(mover,), target=tuple(targets),
                 direction="toward", when=_when(d, clause, mover))  # fmt: skip
        book.add(Predicate.ENDS_NEAR, s.start, s.end, object=(mover,), target=tuple(targets),
                 when="end")  # fmt: skip
        return
    also = {i for c in d.scene.clauses for i in c.movers}
    own = any(e.to and e.actor == mover for e in d.timeline.edges)
    if own and not any(c.to in targets for n in d.timeline.nodes for c in n.constraints):
        when = "throughout" if targets[0] in also else "end"
        if when == "end" and _goes_elsewhere(d, clause, mover):
            return
        book.add(s.row.states, s.start, s.end, object=(mover,), target=tuple(targets), when=when)
        _starts_there(book, mover, targets[0], s.row.states)


def _goes_elsewhere(d: Discourse, clause: Clause, mover: str) -> bool:
    """ "Rolls under a truck and ends up in the gutter": it does not end under it."""
    at = next(k for k, c in enumerate(d.scene.clauses) if c is clause)
    later = [c for c in d.scene.clauses[at + 1 :] if mover in c.movers]
    return any(c.frame.verb is not clause.frame.verb and c.frame.phrases for c in later)


def _starts_there(book: _Book, mover: str, other: str, says: Predicate) -> None:
    """ "Is on the left of a chair, then ...": where it starts is stated of what gets elsewhere."""
    d = book.d
    for r in d.scene.relations:
        words = _SIDE_WORDS.get(r.kind)
        if words is None or (r.source, r.target) != (mover, other) or r.kind == says.value:
            continue
        found = words.search(d.text)
        if found is not None:
            book.add(Predicate(r.kind), found.start(), found.end(), object=(mover,),
                     target=(other,), when="start")  # fmt: skip


def _driver(book: _Book, clause: Clause, s: Said, mover: str) -> None:
    """ "A man drives a car": he is in it; "rides a horse": on it."""
    d = book.d
    riders = [i for i in _ids(clause.frame.subject) if i in d.world.entities]
    riders = [i for i in riders if i not in clause.movers]
    riders = [i for i in riders if kind_of(d, i) in LIMBED]
    riders = [i for i in riders if d.scene.supported_by.get(i, mover) == mover]
    if riders and kind_of(d, mover) in SELF_POWERED:
        open_ = d.scene.supported_by.get(riders[0]) == mover or s.row.states is not Predicate.INSIDE
        says = Predicate.SUPPORTED_BY if open_ else Predicate.INSIDE
        book.add(says, s.start, s.end, object=tuple(riders), target=(mover,))


def _direction(book: _Book, clause: Clause, s: Said, mover: str, where: str) -> None:
    d, direction = book.d, s.row.direction
    over = s.phrase is not None and s.phrase.prep == "over"
    grounded = clause.frame.verb.sense in ("slide", "roll") and kind_of(d, mover) == "animal"
    if over and (grounded or not (mover in d.moves.flying or flies_itself(d, mover))):
        return
    if s.phrase is not None and direction in ("up", "down"):
        _slope(book, s, mover, where)
        return
    if clause.frame.verb.sense == "topple":
        note = "it falls over whichever way it is pushed"
        book.add(Predicate.NOT_REPRESENTED, s.start, s.end, object=(mover,), note=note)
        return
    if clause.frame.verb.sense in TURNING or "turn" in d.scene.used.get(_span(clause.frame), ""):
        return
    if direction not in _TARGETED and direction != "between":
        book.add(Predicate.MOVES, s.start, s.end, object=(mover,), direction=direction, when=where)
        return
    targets = [i for i in things(s.phrase) if i != mover and i in d.world.entities]
    if not targets or _met(d, mover, targets):
        return  # what it meets is an event
    if over and targets == [GROUND]:  # "flies over a forest"
        book.add(Predicate.ABOVE, s.start, s.end, object=(mover,), target=(GROUND,), when=where)
        return
    if direction == "through" and targets == [GROUND]:
        direction = "across"  # "through a meadow", "through the park": it has no other side
    if structural(d, targets[0]) and direction not in _ON_THE_WAY:
        return
    if direction in ("along", "across") and d.scene.supported_by.get(mover) in targets:
        return  # told as what carries it
    if direction == "between" and len(targets) == 1:  # "a cube left of a bin ... between them"
        pairs = [(r.source, r.target) for r in d.scene.relations if targets[0] in
                 (r.source, r.target) and mover not in (r.source, r.target)]  # fmt: skip
        targets = [*pairs[0]] if pairs else []
    if not targets:
        return
    some = tuple(targets) if direction == "between" else tuple(targets[:1])
    book.add(Predicate.MOVES, s.start, s.end, object=(mover,), target=some, direction=direction,
             when=where)  # fmt: skip


def _slope(book: _Book, s: Said, mover: str, where: str) -> None:
    """ "Up the stairs" is a way up; "down the road" one along it."""
    d = book.d
    on = [i for i in things(s.phrase) if i != mover and i in d.world.entities][:1]
    if on and (structural(d, on[0]) or kind_of(d, on[0]) == "water"):
        book.add(Predicate.MOVES, s.start, s.end, object=(mover,), target=tuple(on),
                 direction="along", when=where)  # fmt: skip
    elif on:
        sloped = on if "incline" in entity_of(d, on[0]).noun.traits else []
        book.add(Predicate.MOVES, s.start, s.end, object=(mover,), target=tuple(sloped),
                 direction=s.row.direction, when=where)  # fmt: skip


def _met(d: Discourse, mover: str, others: list[str]) -> bool:
    """Whether an event tells of the mover and one of the others."""
    for n in d.timeline.nodes:
        about = {*n.participants, str(n.extra.get("region", "")).split("/")[0]}
        if measurable(n.event) and mover in about and about & {*others}:
            return True
    return False


def _support(book: _Book, clause: Clause, p: Phrase) -> None:
    """ "Rolls on a table": it starts on it, and stays unless it is told to leave it."""
    d = book.d
    if p.mention is None or p.prep not in ("on", "along", "across", "atop"):
        return
    if clause.frame.verb.sense not in _LASTING:
        return
    for mover in clause.movers:
        host = d.scene.supported_by.get(mover)
        road = next((i for i in things(p) if structural(d, i) and i != GROUND), None)
        if host is None and road is not None and p.prep == "on":
            book.add(Predicate.SUPPORTED_BY, p.mention.start, p.mention.end, object=(mover,),
                     target=(road,), when="start")  # fmt: skip
        if host is None or host not in p.mention.entities or structural(d, host):
            continue
        leaves = any(mover in n.participants and n.event.value in ("Fall", "EnterRegion")
                     for n in d.timeline.nodes)  # fmt: skip
        book.add(Predicate.SUPPORTED_BY, p.mention.start, p.mention.end, object=(mover,),
                 target=(host,), when="start" if leaves else _when(d, clause, mover))  # fmt: skip


def _when(d: Discourse, clause: Clause, mover: str) -> str:
    """The part of the scene that a clause tells: from one event to the next."""
    since = clause.since.get(mover, START)
    if d.scene.used.get(_span(clause.frame)) == SENT_UP and (jolted := _since_the_jolt(d, mover)):
        return jolted
    edge = _going(d, mover, since)
    kinds = {n.id: n.event for n in d.timeline.nodes}
    begin = "start" if since == START else since
    end = edge.to if edge is not None else "end"
    turns = any(e.event is EdgeEvent.TURN for e in _of(d, mover))
    if turns and end in kinds and not measurable(kinds[end]):
        return "start" if begin == "start" else "throughout"  # it goes another way later
    track = d.timeline.tracks.get(mover)
    first = next(_of(d, mover), None)
    if begin == "start" and track is not None and track.after and first is not edge:
        begin = track.after  # it stands still until then
    if begin != "start" and not measurable(kinds[begin]):
        return "throughout"
    end = end if end in kinds and measurable(kinds[end]) else "end"
    return "throughout" if (begin, end) == ("start", "end") else f"{begin}..{end}"


def _of(d: Discourse, mover: str) -> Iterator[TimelineEdge]:
    return (e for e in d.timeline.edges if e.actor == mover)


def _going(d: Discourse, mover: str, since: str) -> TimelineEdge | None:
    """The segment of a motion that is told from an event on: the one after a wait, if it waits."""
    edge = next((e for e in _of(d, mover) if e.from_ == since), None)
    if edge is not None and edge.event is EdgeEvent.UNIFORM_MOTION and edge.params.speed == 0.0:
        return next((e for e in _of(d, mover) if e.from_ == edge.to), edge)
    return edge


def _pace(d: Discourse, clause: Clause, mover: str, says: Predicate) -> float | None:
    """The speed [cm/s] that a word such as "slowly" leaves a mover of its kind."""
    since = clause.since.get(mover, START)
    edge = _going(d, mover, since)
    if edge is not None and edge.event is EdgeEvent.GUIDE:
        return GENTLE_CM_S if says is Predicate.SLOWER_THAN else None
    speed: Quantity | None = edge.params.speed if edge is not None else None
    if edge is None or edge.speed_is_prescribed or not isinstance(speed, tuple):
        return None
    return round(1.1 * speed[1] if says is Predicate.SLOWER_THAN else 0.9 * speed[0], 2)


def _span(f: Frame) -> tuple[int, int]:
    return (f.verb.start, f.verb.end)


def _ids(m: object) -> list[str]:
    return list(getattr(m, "entities", ()))


def _word_end(text: str, start: int) -> int:
    end = start
    while end < len(text) and (text[end].isalnum() or text[end] in "'’"):
        end += 1
    return max(end, start + 1)


_SAYINGS: dict[Predicate, Callable[[_Book, Clause, Said, str], None]] = {
    Predicate.SLOWER_THAN: _paced,
    Predicate.FASTER_THAN: _paced,
    Predicate.CARRIED_BY: _carried,
    Predicate.ROLLS: _rolled,
    Predicate.SLIDES: _plainly,
    Predicate.AIRBORNE: _flown,
    Predicate.INSIDE: _driver,
    Predicate.SUPPORTED_BY: _driver,
    Predicate.MOVES: _moved,
}
"""How each predicate that a row of the table states is written down."""
