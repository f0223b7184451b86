"""Verbs of state: be, stand, weigh, contain, face, carry."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from esg.draft import lexicon as lex
from esg.draft.discourse.core import (
    amounts_of,
    entity_of,
    ids_of,
    kind_of,
    mark_used,
    movable,
    quantity_of,
    structural,
)
from esg.draft.discourse.places import RELATION_PREPS, holds, place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.registry import apply_amount, current_id
from esg.draft.discourse.scene import SELF_POWERED, Relation
from esg.draft.events.acts import add_event, add_hit
from esg.draft.events.motions import motion, sets_off_late
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import speed_after, start_height, time_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.grammar.rewrites.shares import dealt
from esg.draft.text.elements import Mention
from esg.draft.text.quantities import Amount
from esg.graph.models import NodeEvent

_WAITING = lex.word_set("waiting")
_PATTERN_VERBS = {
    "stack": "stack",
    "pile": "stack",
    "heap": "stack",
    "line": "row",
    "rack": "rack",
    "queue": "queue",
}
"""Arrangement of a plural by the verb that says how it stands."""
_LEANT_ON_CM = 60.0
_UPON = ("on", "in", "inside", "upon")
_LEANING = frozenset({"lean", "prop"})
_HANGING = lex.word_set("hanging")
_SIDES = lex.word_set("sides (state)")
_CARRIED_ALONG = lex.word_set("carried along")
_RESTING = lex.word_set("resting (state)")


def upon(d: Discourse, attachments: list[tuple[Mention, Phrase]]) -> None:
    """ "a cart with a box on it": what "it" is that the box is on."""
    bearers = {id(p.mention): m for m, p in attachments if p.prep == "with" and p.mention}
    for m, p in attachments:
        bearer = bearers.get(id(m))
        it = p.mention is not None and p.mention.pronoun in ("it", "them")
        if bearer is None or not it or p.mention is None or p.prep not in _UPON:
            continue
        p.mention.entities = d.world.resolved[id(p.mention)] = list(bearer.entities)
        d.refs.upon_it.add(id(m))


def attachment(d: Discourse, m: Mention, p: Phrase) -> None:
    """A noun phrase with a prepositional phrase: a place or a property."""
    owners = m.entities or ids_of(d, m)
    at = p.amount.start if p.amount is not None else p.mention.start if p.mention else -1
    later = [i for c in m.coordinated if c.start > at >= m.end for i in c.entities]
    owners = [i for i in owners if i not in later] or owners  # "the first at 2 m/s, the second"
    owners = _sharers(d, owners, p)
    if p.amount is not None:
        for o, own in zip(owners, dealt([p.amount], len(owners)), strict=True):
            for a in own:
                if a.dimension == "speed":
                    d.moves.stated[o] = a
                elif apply_amount(d.world, entity_of(d, o), a):
                    mark_used(d, a, o)
        return
    if p.mention is None:
        return
    if p.mention.attribute:
        _arrange(d, owners, p)
        listed = [p.mention, *[c for c in p.mention.coordinated if c.attribute]]
        told = dealt([a for c in listed for a in c.amounts], len(owners))
        for o, own in zip(owners, told, strict=True):
            for a in own:
                if a.dimension == "speed":
                    d.moves.stated[o] = a
                elif a.dimension == "length" and p.prep == "at" and p.mention.head == "height":
                    start_height(d, [o], a)
                elif apply_amount(d.world, entity_of(d, o), a, p.mention.head):
                    mark_used(d, a, o)
        return
    others = p.mention.entities or ids_of(d, p.mention, avoid=owners)
    if p.prep == "with" and id(p.mention) in d.refs.upon_it:
        return
    if p.prep == "with":
        # "a table with bottles on it": the on-phrase places them; else they rest on a support
        for o in others:
            if owners and o not in d.scene.supported_by and o not in owners:
                host = entity_of(d, owners[0]).noun
                if "support" in host.traits or "container" in host.traits:
                    place(d, [o], owners, "on" if "support" in host.traits else "in")
                else:
                    d.scene.relations.append(Relation(o, owners[0], "near"))
        return
    place(d, owners, others, p.prep, p.mention.part)


def _sharers(d: Discourse, owners: list[str], p: Phrase) -> list[str]:
    """ "two balls, red and blue, with masses of 1 kg and 3 kg": all that a list is told of."""
    number = max((len(a.shares) for a in p.told), default=0)
    if number < 2 or len(owners) != 1:
        return owners
    wholes = [*d.world.groups.values(), *d.world.salience[::-1]]
    return next((w for w in wholes if len(w) == number and w[-1] == owners[0]), owners)


def attachment_with(d: Discourse, owners: list[str], others: list[str]) -> None:
    host = entity_of(d, owners[0]).noun
    prep = "on" if "support" in host.traits else "in" if "container" in host.traits else "near"
    place(d, others, owners, prep)


def mass_of_load(d: Discourse, a: Amount) -> bool:
    """ "loaded with 400 kg of bricks": the mass of what the amount is of."""
    if not d.text[a.end : a.end + 4].startswith(" of "):
        return False
    later = [m for m in d.mentions if m.start >= a.end and m.entities]
    of = min(later, key=lambda m: m.start, default=None)
    if of is None or of.start > a.end + 8:
        return False
    for node in of.entities:
        share = replace(a, low=a.low / len(of.entities), high=a.high / len(of.entities))
        apply_amount(d.world, entity_of(d, current_id(d.world, node)), share)
    mark_used(d, a, of.entities[0])
    return True


@sense("be")
def read_be(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    things = s or o
    _hovering(d, f, things)
    places(d, f, things)
    for _, a in amounts_of(d, f):
        if (a.start, a.end) in d.scene.used:
            continue
        named = f.subject.head if f.subject is not None and f.subject.attribute else ""
        if a.dimension == "length" and named in _SIDES:
            for t in things:
                apply_amount(d.world, entity_of(d, t), a, named)
            mark_used(d, a, named)
        elif a.dimension == "length":
            word = next((x for x in f.adverbs), "")
            after = d.text[a.end : a.end + 12].strip().split(" ")[0].strip(".,;")
            if after in ("tall", "high", "wide", "long", "thick", "deep"):
                for t in things:
                    apply_amount(d.world, entity_of(d, t), a, after)
                mark_used(d, a, word or after)
    mark_used(d, f, "state")


def _hovering(d: Discourse, f: Frame, things: list[str]) -> None:
    """ "hovers 3 m above the ground": a height at the start."""
    grounded = f.phrase("above", "over", "off")
    others = grounded.mention.entities if grounded and grounded.mention else []
    for _, a in amounts_of(d, f):
        above = d.text[a.end : a.end + 7].strip().startswith(("above", "up", "high", "off"))
        tall = f.verb.sense == "posture" and all(map(partial(structural, d), others))
        above = above or (f.verb.lemma in ("hover", "float") and "at " in _just_before(d, a))
        if a.dimension == "length" and above and tall:
            start_height(d, things, a)


def _just_before(d: Discourse, a: Amount) -> str:
    return d.text[max(0, a.start - 4) : a.start].lower()


@sense("posture")
def read_posture(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """A state; of what has moved before, where it ends ("and at the end rests on a towel")."""
    lasting = next((a for _, a in amounts_of(d, f) if a.dimension == "time"), None)
    if lasting is not None and f.verb.lemma in _WAITING and not f.reduced:
        for actor in s:
            if kind_of(d, actor) in SELF_POWERED:
                track = d.timeline.tracks.get(actor)
                if track is not None and track.motion is not None and not track.closed:
                    add_event(d, NodeEvent.TRIGGER, (actor,), f, None)  # "drives for 4 s, waits"
                    track.motion = None
                d.moves.waiting[actor] = lasting
                mark_used(d, lasting, "waiting time")
    if f.verb.lemma == "stick" and not f.reduced and s and _at_end(d, f, s[0], "at"):
        p = f.phrase("at", "on", "in", "against", "onto", "upon")
        add_hit(d, f, s[:1], p.mention.entities[:1] if p and p.mention else [], time_of(d, f))
        return
    read_be(d, f, s, o)


def _at_end(d: Discourse, f: Frame, actor: str, *preps: str) -> bool:
    track = d.timeline.tracks.get(actor)
    if track is None or (track.motion is None and not track.hit):
        return False
    on = f.phrase("on", "in", "against", "onto", "upon", *preps)
    return on is not None and on.mention is not None and bool(on.mention.entities)


@sense("unknown")
def read_unknown(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """An unknown verb is a motion if its phrases are; it is reported either way."""
    ways = f.phrase("toward", "towards", "into", "across", "along", "through", "down", "against")
    if s and (ways is not None or quantity_of(d, f, "speed") is not None):
        motion(d, f, s, None)
        d.scene.used.pop((f.verb.start, f.verb.end), None)


@sense("acquire")
def read_acquire(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    found = quantity_of(d, f, "speed")
    if found is not None and s and not speed_after(d, s[0], found[1]):
        read_as(d, "accelerate", f, s, o)
    mark_used(d, f, "speed")


@sense("weigh")
def read_weigh(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    mark_used(d, f, "mass")


@sense("have")
def read_have(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    word = f.object.head if f.object is not None else ""
    _measured(d, f, s, word)
    if s and o and f.phrase("on", "in", "inside") is None:
        attachment_with(d, s, o)
    places(d, f, o)
    mark_used(d, f, "property")


@sense("measure")
def read_measure(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    _measured(d, f, s)
    mark_used(d, f, "size")


def _measured(d: Discourse, f: Frame, things: list[str], word: str = "") -> None:
    """What the quantities of a clause say of things, one value each where there are as many."""
    told = dealt([a for _, a in amounts_of(d, f)], len(things))
    for t, own in zip(things, told, strict=True):
        for a in own:
            if apply_amount(d.world, entity_of(d, t), a, word):
                mark_used(d, a, t)


@sense("contain")
def read_contain(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if s and o:
        place(d, o, s, "in" if holds(d, s[0]) else "on")
    mark_used(d, f, "state")


@sense("face")
def read_face(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    target = o or [i for p in f.phrases if p.mention for i in p.mention.entities]
    for t in s:
        if target and target[0] != t:
            d.scene.facing[t] = target[0]
    mark_used(d, f, "facing")


@sense("surround")
def read_surround(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    inner, outer = (
        (
            s,
            [
                i
                for p in f.phrases
                if p.prep in ("by", "with") and p.mention
                for i in p.mention.entities
            ],
        )
        if f.verb.passive
        else (o, s)
    )
    if inner and outer:
        for t in outer:
            d.scene.relations.append(Relation(t, inner[0], "surround"))
    mark_used(d, f, "state")


def places(d: Discourse, f: Frame, things: list[str]) -> None:
    distance = next(
        (a for p, a in amounts_of(d, f) if a.dimension == "length" and p in ("", "at", "about")),
        None,
    )
    pattern = _PATTERN_VERBS.get(f.verb.lemma)
    if "in a row" in f.adverbs:
        pattern = "row"
    for t in things if pattern is not None else []:
        _pattern_of(d, t, pattern)
    for p in f.phrases:
        if p.mention is None or p.mention.attribute:
            _arrange(d, things, p)
            continue
        others = p.mention.entities
        if f.verb.lemma in _LEANING and p.prep in ("on", "against", "at", "by") and others:
            host = entity_of(d, others[0])
            if (host.dimensions_cm or host.noun.dimensions_cm)[2] >= _LEANT_ON_CM:
                _lean(d, things, others)
                continue
        if p.prep == "with" and f.verb.lemma in ("cover", "load", "fill", "stack", "set"):
            for t in things[:1]:
                if f.verb.lemma == "load" and kind_of(d, t) in SELF_POWERED:
                    place(d, others, [t], "on")  # "a truck loaded with barrels"
                else:
                    attachment_with(d, [t], others)
            continue
        if p.prep in RELATION_PREPS:
            fixed = None
            if distance is not None and things and p.prep not in ("on", "in", "inside"):
                fixed = distance.value
                mark_used(d, distance, "distance")
            place(d, things, others, p.prep, p.mention.part, fixed)
        elif p.prep in ("from", "away from") and distance is not None and others and things:
            for t in things:
                d.scene.relations.append(Relation(t, others[0], "near", distance.value))
            mark_used(d, distance, "distance")


def _lean(d: Discourse, things: list[str], others: list[str]) -> None:
    """ "A broom leans on a wall": it stands beside it on its end, and can only tip over."""
    for t in things:
        e = entity_of(d, t)
        dims = list(e.dimensions_cm or e.noun.dimensions_cm)
        if movable(d, t) and max(dims[:2]) > 2.0 * dims[2]:
            long = 0 if dims[0] >= dims[1] else 1
            dims[long], dims[2] = dims[2], dims[long]
            e.dimensions_cm = dims
        d.moves.leaning.add(t)
    place(d, things, others, "against")


def _arrange(d: Discourse, things: list[str], p: Phrase) -> None:
    """ "in a triangle", "in a queue": how a plural stands."""
    m = p.mention
    pattern = lex.ARRANGEMENTS.get(m.head) if m is not None else None
    if m is None or not m.attribute or p.prep not in ("in", "into") or pattern is None:
        return
    for t in things:
        _pattern_of(d, t, pattern)


def _pattern_of(d: Discourse, thing: str, pattern: str | None) -> None:
    e = entity_of(d, thing)
    if e.group is not None and pattern is not None:
        racked = pattern == "pins" and e.noun.kind == "billiard"
        e.pattern = "rack" if racked else pattern


@sense("carry")
def read_carry(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if s and o:
        place(d, o, s, "on")
    if s and o and f.verb.lemma in ("carry", "transport") and not movable(d, s[0]):
        motion(d, f, o, "slide")  # "a conveyor carries a box past a guard"
    elif s and (quantity_of(d, f, "speed") or any(p.prep in _CARRIED_ALONG for p in f.phrases)):
        motion(d, f, s, None)
    mark_used(d, f, "carrying")


@sense("apply")
def read_apply(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    d.scene.ignored[(f.verb.start, f.verb.end)] = "no physical meaning"


@sense("start")
def read_start(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "starts at 5 m/s, 3 m from the pins": how the motion to come begins."""
    read_apply(d, f, s, o)
    speed = quantity_of(d, f, "speed")
    if speed is not None and len(s) == 1:
        d.moves.stated[s[0]] = speed[1]
    sets_off_late(d, f, s)
