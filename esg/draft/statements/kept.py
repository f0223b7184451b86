"""What is told of the scene beside its motions: upright, borne, untouched, absent, at rest."""

from __future__ import annotations

from collections.abc import Callable
import re

from esg.draft.discourse.bearing import bears, borne_until
from esg.draft.discourse.core import entity_of, kind_of
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.thinghood import without
from esg.draft.discourse.scene import GROUND, LIMBED
from esg.draft.discourse.windows import START
from esg.draft.events.courses import measurable, oncoming
from esg.draft.events.hanging import SENT_UP, UNMET, row_of
from esg.draft.events.motions import ROLLING, can_roll, flies_itself
from esg.draft.events.stated import start_of
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.grammar.clauses.modality import NOBODY_DOES, STOPPED_FIRST
from esg.draft.statements.book import Told, ids, span, word_end
from esg.draft.statements.looks.contents import contained
from esg.draft.statements.periods import is_told, segment_from, since_the_jolt
from esg.draft.statements.struck import struck
from esg.graph.models import NodeEvent, Predicate

_CARRIED_ON = ("on", "atop", "on top of", "upon")
"""Prepositions of what carries something."""
_STAYING = frozenset({"stay", "remain", "keep"})
_ON_END = re.compile(
    r"\s+(?:still\s+)?(?:upright|standing|on (?:its|their|his|her) feet)\b", re.IGNORECASE
)
_STAND = "the stand of a seesaw is drawn for it"
_STANDS = "nothing sees to it that it comes the other way"
_UNANSWERED = "a question: nothing of it is drafted"
_UNSEEN_TO = "nothing sees to it that none does"
_COMES_DOWN = frozenset({"break", "fall", "topple"})
"""Senses of what may come of a motion that is told."""


def _sides_struck(t: Told) -> None:
    """Which side of a thing is said to be hit."""
    d, book = t.d, t.book
    for hit in struck(d, t.frames):
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


def _upright(t: Told) -> None:
    """ "The bottle does not tip over": unless it does so elsewhere in the text."""
    d, book = t.d, t.book
    told = (n for n in d.timeline.nodes if n.event in (NodeEvent.TOPPLE, NodeEvent.FALL))
    fallen = {i for n in told for i in n.participants}
    for f in t.frames:
        denied = f.verb.negated and f.verb.sense in ("topple", "knock", "fall") and not f.unreal
        acted = f.object is not None and not f.verb.passive
        who = ids(f.object if acted else f.subject) if denied else []
        if f.verb.sense == "fall" or (acted and f.verb.sense == "knock" and not _over(f)):
            who = (
                [] if f.phrases or "off" in f.adverbs else [i for i in who if _upright_thing(d, i)]
            )
        stand = tuple(i for i in who if i in d.world.entities)
        stays = f.verb.lemma in _STAYING and _ON_END.match(d.text, f.verb.end)
        if stays and not f.unreal and not f.verb.negated:
            stand = tuple(i for i in ids(f.subject) if i in d.world.entities)
        if stand and not fallen & {*stand}:
            book.add(Predicate.STAYS_UPRIGHT, *span(f), object=stand)


def _sets_off(t: Told, i: str) -> bool:
    """ "A bird is perched on a fence, then it flies to a tree": whether it leaves by air."""
    aloft = any(s.predicate is Predicate.AIRBORNE and i in s.object for s in t.book.items)
    return aloft and flies_itself(t.d, i)


def _borne(t: Told) -> None:
    """ "Stands on a turntable that spins": it stays there, and who stands or lives stays upright.

    On a swing he leans as it does. What flies off was on it at the start.
    """
    d, book = t.d, t.book
    said = [(ids(m), p, False) for m, p in d.attached]
    said += [(ids(f.subject), p, f.verb.lemma == "stand") for f in t.frames for p in f.phrases]
    for about, p, stands in said:
        hosts = ids(p.mention) if p.prep in _CARRIED_ON or p.prep == "from" else []
        for rider in about:
            bearer = d.scene.supported_by.get(rider, "")
            if bearer not in hosts or p.mention is None:
                continue
            words = (start_of(p, d.text), p.mention.end)
            if bearer != GROUND and _sets_off(t, rider):
                book.add(Predicate.SUPPORTED_BY, *words, object=(rider,), target=(bearer,),
                         when="start")  # fmt: skip
            if p.prep == "from" or rider in d.timeline.tracks or not bears(d.scene, bearer):
                continue
            parted = borne_until(d.scene, rider, bearer)
            when = "throughout" if parted is None else f"start..{parted}"
            book.add(Predicate.SUPPORTED_BY, *words, object=(rider,), target=(bearer,), when=when)
            row = row_of(d, bearer)
            steady = row is None or row.drawn is None
            if steady and (stands or kind_of(d, rider) in LIMBED):
                book.add(Predicate.STAYS_UPRIGHT, *words, object=(rider,), when=when)


_ARRIVES = frozenset({"hit", "reach"})


def _unmet(t: Told) -> None:
    """ "Stops just before hitting a child", "before it reaches her", "without touching the cup"."""
    d, book = t.d, t.book
    for f in t.frames:
        spared = f.verb.sense == "stop" and "before" in f.verb.extra and not f.unreal
        spared = spared or d.scene.used.get(span(f)) == UNMET
        spared = spared or (f.unreal == STOPPED_FIRST and f.verb.sense in _ARRIVES)
        who = [i for i in ids(f.subject) if i in d.world.entities] if spared else []
        others = tuple(i for i in ids(f.object) if i in d.world.entities and i not in who)
        if who and others and not is_told(d, who[0], [*others]):
            book.add(Predicate.NEVER_TOUCHES, *span(f), object=tuple(who), target=others)


def _sent_up(t: Told) -> None:
    """ "A stone falls on one end and the other end flings a coin up": it rises from the jolt on."""
    d, book = t.d, t.book
    for f in t.frames:
        if d.scene.used.get(span(f)) != SENT_UP:
            continue
        sent = ids(f.object) if f.object is not None and not f.verb.passive else ids(f.subject)
        for body in sent:
            if when := since_the_jolt(d, body):
                book.add(Predicate.MOVES, *span(f), object=(body,), direction="up", when=when)
    for e in d.world.entities.values():
        start = d.text.find(e.label, max(e.origin, 0)) if e.lever == "fulcrum" else -1
        if start >= 0:
            book.add(Predicate.NOT_REPRESENTED, start, start + len(e.label), object=(e.id,),
                     note=_STAND)  # fmt: skip


def _rolling(t: Told) -> None:
    """ "A rolling can hits a candle": until what it is on its way to, unless a verb says so."""
    d, book = t.d, t.book
    rolls = {i for s in book.items if s.predicate is Predicate.ROLLS for i in s.object}
    for m in (m for m in d.mentions if ROLLING in m.adjectives):
        at = d.text.lower().find(ROLLING, m.start, m.end)
        for body in [i for i in ids(m) if i in d.world.entities and i not in rolls and at >= 0]:
            leg = segment_from(d, body, START)
            end = d.timeline.node(leg.to) if leg is not None and can_roll(d, body) else None
            if leg is not None and leg.params.spin == "roll" and end is not None:
                when = f"start..{end.id}" if measurable(end.event) else "throughout"
                book.add(Predicate.ROLLS, at, at + len(ROLLING), object=(body,), when=when)


def _unmanned(t: Told) -> None:
    """ "A cart with nobody in it": no person is drawn, unless another is told of."""
    d, book = t.d, t.book
    people = any(e.noun.kind == "person" for e in d.world.entities.values())
    for e in t.elements if not people else ():
        if getattr(e, "low", "") == "unmanned":
            book.add(Predicate.ABSENT, e.start, e.end, noun="person")


def _comes_on(t: Told) -> None:
    """ "An oncoming truck": it drives, and nothing sees to it that it comes the other way."""
    d, book = t.d, t.book
    for start, end, who, _ in oncoming(d):
        book.add(Predicate.NOT_REPRESENTED, start, end, object=(who,), note=_STANDS)


def _untouched(t: Told) -> None:
    """ "Hits neither of them", "touches nothing": but for what it is told to hit."""
    d, book = t.d, t.book
    told = (n for n in d.timeline.nodes if n.event in (NodeEvent.COLLISION, NodeEvent.MISS))
    met = {frozenset(n.participants) for n in told}
    for u in d.scene.untouched:
        others = tuple(
            i for i in u.others if frozenset((u.who, i)) not in met and not _borne_by(d, u.who, i)
        )
        if others:
            book.add(Predicate.NEVER_TOUCHES, u.start, u.end, object=(u.who,), target=others)


def _spared(t: Told) -> None:
    """ "A cart hits a rack, and nothing falls off": nothing sees to it."""
    d, book = t.d, t.book
    for f in t.frames if d.timeline.edges else ():
        if f.unreal == NOBODY_DOES and f.verb.sense in _COMES_DOWN:
            book.add(Predicate.NOT_REPRESENTED, *span(f), note=_UNSEEN_TO)


def _borne_by(d: Discourse, one: str, other: str) -> bool:
    """Whether one of two things is on or in the other, as may be told only later."""
    for bearing in (d.scene.supported_by, d.scene.inside_of):
        if bearing.get(one) == other or bearing.get(other) == one:
            return True
    return False


def _absent(t: Told) -> None:
    """ "Without a lid"."""
    for m in (m for m in t.d.mentions if without(m, t.d.text)):
        t.book.add(Predicate.ABSENT, m.start - len("without "), m.end, noun=m.head)


def _unanswered(t: Told) -> None:
    for q in (q for q in t.d.scene.asked if not q.answered):
        t.book.add(Predicate.NOT_REPRESENTED, q.start, q.end, note=_UNANSWERED)


def _still(t: Told) -> None:
    """What is said to stand still all the time."""
    for actor, at in t.d.moves.still.items():
        if actor in t.d.world.entities:
            t.book.add(Predicate.STAYS_STILL, at, word_end(t.d.text, at), object=(actor,))


def _stays(t: Told) -> None:
    """What stays where it is, at least until something hits it."""
    d = t.d
    moved = {e.actor for e in d.timeline.edges}
    for actor, at in d.moves.stays.items():
        if actor in d.world.entities and actor not in moved:
            hits = (n for n in d.timeline.nodes if n.event is NodeEvent.COLLISION)
            hit = next((n.id for n in hits if actor in n.participants), None)
            t.book.add(Predicate.STAYS_STILL, at, word_end(d.text, at), object=(actor,),
                       when="throughout" if hit is None else f"start..{hit}")  # fmt: skip


BESIDE_MOTIONS: tuple[Callable[[Told], None], ...] = (
    _sides_struck,
    _upright,
    _rolling,
    _borne,
    _unmet,
    _unmanned,
    _comes_on,
    _sent_up,
    _untouched,
    _spared,
    _absent,
    contained,
    _unanswered,
)
"""What clauses tell beside the motions that were read from them; each writes what it finds."""
AT_REST: tuple[Callable[[Told], None], ...] = (_still, _stays)
"""What is told of what does not move, in which nothing that is lost is sought."""
