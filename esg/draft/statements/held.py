"""What holds, carries, draws or drives something."""

from __future__ import annotations

from esg.draft.discourse.core import entity_of, kind_of, structural
from esg.draft.discourse.proposition import Clause, Said
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import is_toy
from esg.draft.discourse.scene import GROUND, LIMBED, SELF_POWERED
from esg.draft.events.ends import EDGES
from esg.draft.events.stated import comes_later, start_of
from esg.draft.events.told import things
from esg.draft.events.tops import movers_on_top, stays_up
from esg.draft.grammar.clauses.frames import Phrase
from esg.draft.statements.book import Book, Told, ids, span
from esg.draft.statements.periods import hurled, period
from esg.graph.models import NodeEvent, Predicate

_POSTURES = {
    **dict.fromkeys(("hang", "dangle", "suspend"), Predicate.HANGS_FROM),
    **dict.fromkeys(("lean", "prop"), Predicate.LEANS_ON),
}
"""What verbs of posture say of what holds something."""
_LENGTHWISE = ("along", "across")
_TO, _AT = ("to", "up to"), ("at", "on", "near")
_CARRYING = (Predicate.SUPPORTED_BY, Predicate.CARRIED_BY, Predicate.ENDS_ON)
_LASTING = ("own", "roll", "slide", "spin", "coast", "continue", "accelerate", "brake", "swerve")
"""Senses of moving on something, and not onto it."""


def carried(book: Book, clause: Clause, s: Said, mover: str) -> None:
    """ "A truck carries a crate"."""
    d, f = book.d, clause.frame
    bearers = [i for i in ids(f.subject) if i != mover] or [mover]
    for load in ids(f.object):
        bearer = d.scene.supported_by.get(load)
        if load in d.world.entities and bearer in bearers:
            book.add(s.row.states, s.start, s.end, object=(load,), target=(bearer,))
            others = tuple(i for i in ids(f.subject) if i != bearer and i in d.world.entities)
            if others:  # "two men carry a sofa"
                book.add(Predicate.NOT_REPRESENTED, s.start, s.end, object=others,
                         note="only one of them carries it")  # fmt: skip


def driver(book: Book, clause: Clause, s: Said, mover: str) -> None:
    """ "A man drives a car": he is in it; "rides a horse": on it."""
    d = book.d
    riders = [i for i in ids(clause.frame.subject) if i in d.world.entities]
    riders = [i for i in riders if i not in clause.movers]
    toys = [i for i in riders if kind_of(d, i) == "toy" and d.scene.supported_by.get(i) == mover]
    riders = [i for i in riders if kind_of(d, i) in LIMBED or i in toys]
    if s.row.states is Predicate.SUPPORTED_BY:
        _comes_to_ride(book, s, [i for i in riders if d.scene.supported_by.get(i)], mover)
    riders = [i for i in riders if d.scene.supported_by.get(i, mover) == mover]
    stands = bool(riders) and d.scene.supported_by.get(riders[0]) == mover
    glides = stands and kind_of(d, mover) == "sliding"  # "a penguin riding a surfboard"
    goes = kind_of(d, mover) in SELF_POWERED and not is_toy(entity_of(d, mover))
    if riders and (goes or glides or toys):
        open_ = d.scene.supported_by.get(riders[0]) == mover or s.row.states is not Predicate.INSIDE
        says = Predicate.SUPPORTED_BY if open_ else Predicate.INSIDE
        book.add(says, s.start, s.end, object=tuple(riders), target=(mover,))


def _comes_to_ride(book: Book, s: Said, riders: list[str], mover: str) -> None:
    """ "Jumps off a fridge, lands on a cart and rides it": in the end it is on the cart."""
    hits = (n for n in book.d.timeline.nodes if n.event is NodeEvent.COLLISION)
    met = {i for n in hits if mover in n.participants for i in n.participants}
    for rider in riders:
        if rider in met and book.d.scene.supported_by[rider] != mover:
            book.add(Predicate.ENDS_ON, s.start, s.end, object=(rider,), target=(mover,),
                     when="end")  # fmt: skip


def tow(book: Book, clause: Clause) -> None:
    """ "A truck tows a trailer": a joint holds them together."""
    if clause.frame.verb.sense == "tow":
        named = [i for m in (clause.frame.subject, clause.frame.object) for i in ids(m)]
        scene = book.d.scene
        carts = (scene.supported_by.get(i) or scene.inside_of.get(i) for i in named)
        for node in dict.fromkeys([*named, *(i for i in carts if i)]):
            tow = book.d.scene.tows.get(node)
            if tow is not None:
                book.add(Predicate.ATTACHED_TO, *span(clause.frame), object=(node,),
                         target=(tow.by,), when="start")  # fmt: skip
        by = {tow.by for tow in book.d.scene.tows.values()}
        drawing = ids(clause.frame.subject)
        others = tuple(i for i in drawing if i not in by and i not in book.d.scene.tows)
        if others and by & {*drawing}:  # "two oxen pull a wagon"
            book.add(Predicate.NOT_REPRESENTED, *span(clause.frame), object=others,
                     note="only one of them draws it")  # fmt: skip


def posture(book: Book, clause: Clause) -> None:
    """ "A lamp hangs from a branch", "a broom leans on a wall"."""
    d, f = book.d, clause.frame
    if f.verb.lemma == "hover":
        for body in (i for i in ids(f.subject) if i in d.world.entities):
            book.add(Predicate.AIRBORNE, *span(f), object=(body,))
    for p in f.phrases if f.verb.sense == "posture" else ():
        seated = tuple(i for i in ids(f.subject) if i in d.scene.at_ends) if p.prep == "on" else ()
        if seated and p.mention is not None:
            book.add(Predicate.SUPPORTED_BY, start_of(p, d.text), p.mention.end, object=seated,
                     target=(d.scene.supported_by[seated[0]],), when="start")  # fmt: skip
    says = _POSTURES.get(f.verb.lemma)
    held = f.phrase("from", "by") if says is Predicate.HANGS_FROM else f.phrase("on", "against")
    targets = [i for i in things(held) if i in d.world.entities][:1]
    if says is None or not targets or held is None or held.mention is None:
        return
    acted_on = [] if f.verb.passive else ids(f.object)
    for body in acted_on or ids(f.subject):
        if body in d.world.entities and body not in targets:
            start = start_of(held, d.text)
            book.add(says, start, held.mention.end, object=(body,), target=tuple(targets),
                     when="start")  # fmt: skip


def support(book: Book, clause: Clause, p: Phrase) -> None:
    """ "Rolls on a table": it starts on it, and stays unless it is told to leave it."""
    d = book.d
    if p.mention is None or p.prep not in ("on", "along", "across", "atop"):
        return
    sense = clause.frame.verb.sense
    if comes_later(p, clause.frame, d.text):
        return
    if sense not in _LASTING and (sense != "launch" or p.prep not in _LENGTHWISE):
        return
    for mover in clause.movers:
        if sense == "launch" and hurled(d, mover):
            continue  # "throws a ball across a table"
        host = d.scene.supported_by.get(mover)
        road = next((i for i in things(p) if structural(d, i) and i != GROUND), None)
        if host is None and road is not None and p.prep == "on":
            book.add(Predicate.SUPPORTED_BY, p.mention.start, p.mention.end, object=(mover,),
                     target=(road,), when="start")  # fmt: skip
        if host is None or host not in p.mention.entities or structural(d, host):
            continue
        met = [n.event.value for n in d.timeline.nodes if mover in n.participants]
        when = "start" if {*met} & {"Fall", "EnterRegion"} else period(d, clause, mover)
        whens = _on_top_when(d, mover) if stays_up(d, mover) is not None else [when]
        for when in whens:
            book.add(Predicate.SUPPORTED_BY, p.mention.start, p.mention.end, object=(mover,),
                     target=(host,), when=when)  # fmt: skip


def _on_top_when(d: Discourse, mover: str) -> list[str]:
    """When what stays on a table is on it: throughout; a hit may make it hop."""
    hits = (n.id for n in d.timeline.nodes
            if n.event is NodeEvent.COLLISION and mover in n.participants)  # fmt: skip
    hit = next(hits, None)
    return ["throughout"] if hit is None else [f"start..{hit}", "end"]


def short_of_edges(told: Told) -> None:
    """ "Rolls to the edge of a stage and stops": it stops on it, nothing sees to where."""
    d, book = told.d, told.book
    fallen = {n.participants[0] for n in d.timeline.nodes if n.event is NodeEvent.FALL}
    for clause in d.scene.clauses:
        sense = clause.frame.verb.sense
        preps = _TO if sense in (*_LASTING, "coast") else _AT if sense == "stop" else ()
        for p in clause.frame.phrases:
            m = p.mention
            who = tuple(i for i in clause.movers if i not in fallen)
            if m is not None and m.part in EDGES and p.prep in preps and who:
                book.add(Predicate.NOT_REPRESENTED, start_of(p, d.text), m.end, object=who,
                         note="nothing sees to it that it ends there")  # fmt: skip


def kept_on_top(told: Told) -> None:
    """ "On a desk, a marble rolls past a cup": on the desk throughout, in whatever words."""
    d, book = told.d, told.book
    stated = {(i, s.target) for s in book.items for i in s.object if s.predicate in _CARRYING}
    for mover, host in movers_on_top(d):
        named = [m for m in d.mentions if host in m.entities and not m.pronoun]
        for m in named[:1] if (mover, (host,)) not in stated else ():
            for when in _on_top_when(d, mover):
                book.add(Predicate.SUPPORTED_BY, m.start, m.end, object=(mover,), target=(host,),
                         when=when)  # fmt: skip
