"""Which way something goes, and where to: directions, slopes, goals, landings."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, structural
from esg.draft.discourse.proposition import Clause, Said
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import GROUND, LIVING
from esg.draft.discourse.windows import START
from esg.draft.events.courses import TURNING, measurable, queues_behind
from esg.draft.events.motions import flies_itself
from esg.draft.events.stated import start_of
from esg.draft.events.told import things
from esg.draft.grammar.clauses.frames import Phrase
from esg.draft.statements.book import Book, ids, span
from esg.draft.statements.looks.postures import poses_told
from esg.draft.statements.periods import STRAIGHT_DOWN_DEG, hurled, is_told, period, segments
from esg.graph.models import NodeEvent, Predicate

_ON_THE_WAY = ("along", "across", "through")
"""Directions that roads, fields and floors have, too."""
_ABOUT = ("around", "along", "across")
"""Directions that are no way on what carries something: "slides around a pan", about in it."""
_SIDE_WORDS = {
    "left_of": re.compile(r"\bleft\b", re.IGNORECASE),
    "right_of": re.compile(r"\bright\b", re.IGNORECASE),
    "in_front_of": re.compile(r"\bfront\b", re.IGNORECASE),
    "behind": re.compile(r"\b(?:behind|back|rear)\b", re.IGNORECASE),
}
"""The words of a side, of which the first in the text is where something starts."""
_SPANS = lex.word_set("spans")
_DOWN = frozenset({"fall", "topple", "drop"})
_SENT = ("over", "across", "through", "past")
"""What leads on from a hit: "hits a ball over the net"."""
_SHEDS = frozenset({"incline", "round", "goal"})
"""Traits of what nothing stays on that comes down from above."""
_ROUND_DEG = 180.0
"""A turn by more is a round way."""
_STRAIGHT_DOWN = "it falls straight down"
_TARGETED = frozenset({"toward", "away_from", "along", "past", "across", "through", "around"})


def moved(book: Book, clause: Clause, s: Said, mover: str) -> None:
    """Which way something moves: by an adverb, a phrase, or the verb itself ("crosses")."""
    if s.row.part == "course":
        _in_circles(book, s, mover)
        return
    if s.row.part == "adverb" and s.row.direction in _TARGETED:
        _back(book, clause, s, mover)
        return
    if s.row.part != "verb":
        _direction(book, clause, s, mover, period(book.d, clause, mover))
        return
    d, acted_on = book.d, ids(clause.frame.object)
    if poses_told(d, clause):
        return  # "rises to her feet" leads nowhere
    targeted = s.row.direction in _TARGETED
    if targeted and mover in acted_on:
        return  # "chases two cats": neither chases the other
    others = [i for i in acted_on if i != mover and i in d.world.entities][:1]
    if not targeted or (others and not is_told(d, mover, others)):
        target = tuple(others) if targeted else ()
        rounds = s.row.direction == "around"
        book.add(s.row.states, s.start, s.end, object=(mover,), target=target,
                 direction=s.row.direction,
                 when="throughout" if rounds else period(d, clause, mover))  # fmt: skip
        _lengthwise(book, s, mover, target, s.row.direction or "", period(d, clause, mover))


def _back(book: Book, clause: Clause, s: Said, mover: str) -> None:
    """ "Hits a wall and rolls back": away from what it has hit; "apart" from each other.

    "Is hit and slides out of view" is away from what has hit it.
    """
    d, f, since = book.d, clause.frame, book.d.timeline.node(clause.since.get(mover, START))
    if f.verb.sense == "topple":
        return  # "falls on its back"
    others = tuple(i for i in clause.movers if i != mover) if "apart" in s.row.words else ()
    struck_here = since is not None and since.event is NodeEvent.COLLISION
    met = [*since.participants] if since is not None and struck_here else list[str]()
    if mover in met and (mover == met[0]) is ("out of view" not in s.row.words):
        others = tuple(i for i in met if i != mover)
    if others and not f.object and not f.verb.passive:
        book.add(s.row.states, s.start, s.end, object=(mover,), target=others[:1],
                 direction=s.row.direction, when=period(d, clause, mover))  # fmt: skip


def _no_way(d: Discourse, clause: Clause, s: Said, mover: str) -> bool:
    """ "Puts a bag by the fence", "a dog slides over the ice": where it is, not what it passes."""
    prep = s.phrase.prep if s.phrase is not None else ""
    put = prep == "by" and d.scene.used.get(span(clause.frame)) == "put"
    grounded = clause.frame.verb.sense in ("slide", "roll") and kind_of(d, mover) == "animal"
    flies = mover in d.moves.flying or flies_itself(d, mover) or hurled(d, mover)
    return put or (prep == "over" and (grounded or not flies))


def _direction(book: Book, clause: Clause, s: Said, mover: str, where: str) -> None:
    """The way that an adverb or a phrase tells."""
    d, direction = book.d, s.row.direction
    if _no_way(d, clause, s, mover):
        return
    if s.phrase is not None and direction in ("up", "down"):
        _slope(book, s, mover, where)
        return
    if clause.frame.verb.sense == "topple":
        note = "it falls over whichever way it is pushed"
        book.add(Predicate.NOT_REPRESENTED, s.start, s.end, object=(mover,), note=note)
        return
    if direction in ("left", "right") and _drops(d, mover):
        book.add(Predicate.NOT_REPRESENTED, s.start, s.end, object=(mover,), note=_STRAIGHT_DOWN)
        return
    turns = clause.frame.verb.sense in TURNING
    if turns or ("turn" in d.scene.used.get(span(clause.frame), "") and direction != "around"):
        return
    if direction not in _TARGETED and direction != "between":
        book.add(Predicate.MOVES, s.start, s.end, object=(mover,), direction=direction, when=where)
        return
    _by_others(book, clause, s, mover, where)


def _sent_on(d: Discourse, clause: Clause, s: Said, mover: str) -> tuple[str, str] | None:
    """ "A racket hits a ball over the net": what is hit goes that way, from the hit on."""
    f = clause.frame
    if f.verb.sense != "hit" or f.verb.passive or f.object is None or s.phrase is None:
        return None
    if s.phrase.prep not in _SENT or start_of(s.phrase, d.text) < f.object.end:
        return None
    hits = [
        n for n in d.timeline.nodes if n.event is NodeEvent.COLLISION and mover in n.participants
    ]
    for met in f.object.entities:
        hit = next((n for n in hits if met in n.participants and met != mover), None)
        if hit is not None:
            return met, f"{hit.id}..end"
    return None


def _by_others(book: Book, clause: Clause, s: Said, mover: str, where: str) -> None:
    """The way with respect to what a phrase names: "past a cone", "between them"."""
    d, direction = book.d, s.row.direction or ""
    sent = _sent_on(d, clause, s, mover)
    if sent is not None:
        mover, where = sent
    over = s.phrase is not None and s.phrase.prep == "over"
    targets = [i for i in things(s.phrase) if i != mover and i in d.world.entities]
    if not targets or is_told(d, mover, targets):
        return  # what it meets is an event
    stays = mover in d.moves.hovering  # "hovers over a car"
    if over and (targets == [GROUND] or stays):  # "flies over a forest"
        book.add(Predicate.ABOVE, s.start, s.end, object=(mover,), target=tuple(targets[:1]),
                 when="start" if stays else where)  # fmt: skip
        return
    if direction == "through" and targets == [GROUND]:
        if clause.frame.verb.sense in _DOWN:
            return  # "falls through the floor"
        direction = "across"  # "through a meadow", "through the park": it has no other side
    rounds = direction == "around" and targets == [GROUND] and _bends(d, mover)
    if structural(d, targets[0]) and direction not in _ON_THE_WAY and not rounds:
        return  # "around the yard": its course bends
    if direction in _ABOUT and d.scene.supported_by.get(mover) in targets:
        return
    on_it = direction == "toward" and d.scene.supported_by.get(mover) in targets
    if not targets or on_it:  # "rolls toward the edge of a table": it is on it
        return
    some = tuple(targets) if direction == "between" else tuple(targets[:1])
    where = "throughout" if direction == "around" else where  # its course bends, that is all
    book.add(Predicate.MOVES, s.start, s.end, object=(mover,), target=some, direction=direction,
             when=where)  # fmt: skip
    _lengthwise(book, s, mover, some, direction, where)


def _bends(d: Discourse, mover: str) -> bool:
    """Whether something goes round and round."""
    going = (mover, d.scene.supported_by.get(mover, mover))
    turned = (e.params.turn_degrees for e in d.timeline.edges if e.actor in going)
    return any(isinstance(x, int | float) and x >= _ROUND_DEG for x in turned)


def _in_circles(book: Book, s: Said, mover: str) -> None:
    """ "Runs in circles": on a round way, about no thing."""
    if _bends(book.d, mover):
        book.add(s.row.states, s.start, s.end, object=(mover,), target=(GROUND,),
                 direction="around", when="throughout")  # fmt: skip


def _lengthwise(
    book: Book, s: Said, mover: str, over: tuple[str, ...], direction: str, when: str
) -> None:
    """ "Across a bridge" is the long way of it."""
    heads = {entity_of(book.d, i).head.rpartition(" ")[2] for i in over}
    if direction == "across" and heads & _SPANS:
        book.add(Predicate.MOVES, s.start, s.end, object=(mover,), target=over, direction="along",
                 when=when)  # fmt: skip


def _drops(d: Discourse, mover: str) -> bool:
    """Whether all that it does is fall: "they land one by one, from left to right"."""
    ways = [e.params.elevation_deg for e in d.timeline.edges if e.actor == mover]
    return bool(ways) and all(x == STRAIGHT_DOWN_DEG for x in ways)


def _slope(book: Book, s: Said, mover: str, where: str) -> None:
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


def goal(book: Book, clause: Clause, s: Said, mover: str) -> None:
    """ "Runs to the left of a chair": where it gets to; beside what moves, where it keeps."""
    d = book.d
    itself = {mover, *(ids(clause.frame.subject) if clause.frame.object is None else ())}
    targets = [i for i in things(s.phrase) if i not in itself and i in d.world.entities][:1]
    if not targets or structural(d, targets[0]) or is_told(d, mover, targets):
        return
    if _is_of_what_hangs(d, s, targets[0]):
        return
    if s.row.states is Predicate.ENDS_NEAR and d.scene.used.get(span(clause.frame)) != "put":
        return  # "runs next to a horse": it need not end there
    if queues_behind(d, s, mover) is not None:
        book.add(Predicate.MOVES, s.start, s.end, object=(mover,), target=tuple(targets),
                 direction="toward", when=period(d, clause, mover))  # fmt: skip
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


def _is_of_what_hangs(d: Discourse, s: Said, target: str) -> bool:
    """ "Drifts into the fan above the table": what hangs there is above it."""
    hung = {j.child for j in d.scene.joints} | {*d.scene.attached}
    held = (r for r in d.scene.relations if r.target == target and r.source in hung)
    return any(r.kind == s.row.states.value for r in held)


def _goes_elsewhere(d: Discourse, clause: Clause, mover: str) -> bool:
    """ "Rolls under a truck and ends up in the gutter": it does not end under it."""
    at = next(k for k, c in enumerate(d.scene.clauses) if c is clause)
    later = [c for c in d.scene.clauses[at + 1 :] if mover in c.movers]
    return any(c.frame.verb is not clause.frame.verb and c.frame.phrases for c in later)


def _starts_there(book: Book, mover: str, other: str, says: Predicate) -> None:
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


def landed(book: Book, clause: Clause, p: Phrase) -> None:
    """ "A bird lands on a branch": it comes down by itself, and there it stays.

    So does what has fallen or was thrown, and lands on the ground.
    """
    d = book.d
    if p.mention is None or p.prep not in (*lex.ONTO, "in"):
        return
    words = (start_of(p, d.text), p.mention.end)
    grounds = [i for i in things(p) if structural(d, i)][:1]
    if grounds:
        for mover in clause.movers:
            if comes_to_ground(d, clause, mover):
                book.add(Predicate.ENDS_ON, *words, object=(mover,), target=tuple(grounds),
                         when="end")  # fmt: skip
        return
    hosts = [i for i in things(p) if i in d.world.entities and p.prep in lex.ONTO][:1]
    for mover in clause.movers if hosts else []:
        if comes_down_on(d, clause, mover, hosts[0]):
            book.add(Predicate.ENDS_ON, *words, object=(mover,), target=tuple(hosts), when="end")
            continue
        edges = list(segments(d, mover))
        kinds = {n.id: n.event for n in d.timeline.nodes}
        over = bool(edges) and measurable(kinds.get(edges[-1].to, NodeEvent.TRIGGER))
        if not flies_itself(d, mover) or not over or mover in hosts:
            continue
        book.add(Predicate.MOVES, *span(clause.frame), object=(mover,), direction="down",
                 when=period(d, clause, mover))  # fmt: skip
        book.add(Predicate.ENDS_ON, *words, object=(mover,), target=tuple(hosts), when="end")


def comes_to_ground(d: Discourse, clause: Clause, mover: str) -> bool:
    """Whether a landing is the last that is told of a thing that was in the air, and it stays."""
    if kind_of(d, mover) in LIVING or flies_itself(d, mover) or _goes_elsewhere(d, clause, mover):
        return False
    told = [n for n in d.timeline.nodes if mover in n.participants and measurable(n.event)]
    fell = bool(told) and told[-1].event is NodeEvent.FALL
    return fell or (not told and hurled(d, mover))


def comes_down_on(d: Discourse, clause: Clause, mover: str, host: str) -> bool:
    """Whether what fell or was thrown stays on the thing that it lands on: nothing more is told.

    Who is landed on, what turns or gives way under it, slopes and what rolls keep nothing.
    """
    noun = entity_of(d, host).noun
    if kind_of(d, host) in LIVING or noun.traits & _SHEDS or host in _jointed(d):
        return False
    if mover == host or kind_of(d, mover) in LIVING or flies_itself(d, mover):
        return False
    told = [n for n in d.timeline.nodes if mover in n.participants and measurable(n.event)]
    last = bool(told) and told[-1].event is NodeEvent.COLLISION and host in told[-1].participants
    fell = any(n.event is NodeEvent.FALL for n in told) or hurled(d, mover)
    return last and (fell or _drops(d, mover)) and not _goes_elsewhere(d, clause, mover)


def _jointed(d: Discourse) -> set[str]:
    return {name for j in d.scene.joints for name in (j.child, j.parent) if name}


def leapt(book: Book, p: Phrase) -> None:
    """ "Jumps onto a table": there it stays, unless more is told of it."""
    d = book.d
    for mover, host in d.moves.upon.items():
        last = next((n for n in reversed(d.timeline.nodes) if mover in n.participants), None)
        stays = last is not None and host in last.participants
        if p.mention is not None and stays and host in things(p):
            words = (start_of(p, d.text), p.mention.end)
            book.add(Predicate.ENDS_ON, *words, object=(mover,), target=(host,), when="end")
