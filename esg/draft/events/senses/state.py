"""Verbs of state: be, stand, weigh, contain, face, carry."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
import math
import re

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
from esg.draft.discourse.jointed import CRANES
from esg.draft.discourse.places import RELATION_PREPS, hang, holds, place, towers
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import head_of
from esg.draft.discourse.referents.members import OPPOSITE
from esg.draft.discourse.referents.registry import apply_amount, current_id
from esg.draft.discourse.scene import LIMBED, SELF_POWERED, Relation
from esg.draft.events.acts import add_event, add_hit
from esg.draft.events.hanging import turning
from esg.draft.events.lengths import starts_apart
from esg.draft.events.motions import flies_itself, hover, motion, sets_off_late
from esg.draft.events.roles import is_tool
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import speed_after, start_height, time_of
from esg.draft.events.told import (
    amount,
    at_rest,
    happened,
    ignore,
    moves,
    size_of,
    things,
    traits_of,
    unread,
)
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.grammar.rewrites.positions import NEIGHBOURS
from esg.draft.grammar.rewrites.shares import dealt
from esg.draft.text.elements import Mention
from esg.draft.text.quantities import Amount
from esg.graph.models import NodeEvent, Quantity

_WAITING = lex.word_set("waiting")
_HOVERING = lex.word_set("hovers")
_STILL = re.compile(
    r"(?:stay|remain|sit|stand|lie|keep)\w*\s+(?:\w+ly\s+)?"
    r"(?:still|motionless|stationary|immobile|unmoved|where (?:it is|they are)|in place|put)\b",
    re.IGNORECASE,
)
_PATIENT = frozenset({"wait", "pause", "queue", "idle"})
_HAS_A_DECK = frozenset({"watercraft", "vehicle", "building"})
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
_LEANING = frozenset({"lean", "prop"})
_CARRIES = ("carry", "haul", "lug")
_ABREAST = frozenset({"in a row", "from left to right", "from right to left"})
_LIGHT = lex.word_set("no acts (places)")
_AT_REST = lex.word_set("places of acts")
_HANGING = lex.word_set("hanging")
_HUNG_BY = lex.word_set("hung by")
_NAMED_BEFORE = ("it", "them", "him", "her", "both")
_APART = lex.BESIDE | {"above", "under", "below"}
"""Prepositions of what is outside of what it goes with."""
_BESIDE_IT = ("left", "right")
_BESIDE = ("on", "against", "at", "by")
_FILLING = ("cover", "load", "fill", "stack", "set")
_MEASURES = ("tall", "high", "wide", "long", "thick", "deep")
_SIDES = lex.word_set("sides (state)")
_CARRIED_ALONG = lex.word_set("carried along")


def attachment(d: Discourse, m: Mention, p: Phrase) -> None:
    """A noun phrase with a prepositional phrase: a place or a property."""
    owners = m.entities or ids_of(d, m)
    at = p.amount.start if p.amount is not None else p.mention.start if p.mention else -1
    later = [i for c in m.coordinated if c.start > at >= m.end for i in c.entities]
    owners = [i for i in owners if i not in later] or owners  # "the first at 2 m/s, the second"
    owners = _sharers(d, owners, p)
    if p.amount is not None:
        _tell(d, owners, [p.amount], "", p.prep)
    elif p.mention is not None and p.mention.attribute:
        _arrange(d, owners, p)
        listed = [p.mention, *[c for c in p.mention.coordinated if c.attribute]]
        _tell(d, owners, [a for c in listed for a in c.amounts], p.mention.head, p.prep)
    elif p.mention is not None:
        _beside_others(d, m, owners, p, p.mention)


def _beside_others(d: Discourse, owned: Mention, owners: list[str], p: Phrase, m: Mention) -> None:
    """Where things are with respect to what a phrase of theirs names."""
    others = m.entities or ids_of(d, m, avoid=owners)
    loose = [o for o in others if o not in d.scene.supported_by and o not in owners]
    if p.prep == "of" and {*owners} & {*others}:
        return  # "two of the buckets" hold no others
    if p.prep == "of":
        _carried_by_its_owner(d, owners, loose)
    elif p.prep == "with" and not is_tool(d, owned, p):
        # "a table with bottles on it": the on-phrase places them; else they rest on a support
        attachment_with(d, owners, [o for o in loose if not _placed_apart(d, o, p)])
    elif p.prep == "with":
        return  # "wipes the table with a sponge": it is no table with a sponge on it
    else:
        if p.prep == "on" and m.head in lex.BODY_PARTS:
            # "slides down a ramp on its belly": how it lies, not where the ramp is
            owners = [o for o in owners if movable(d, o) and not _bears(d, o)]
        if p.prep in ("on", "in") and _one_each(d, owners, others, m):
            for one, other in zip(owners, others, strict=True):
                place(d, [one], [other], p.prep, m.part)  # "three kids on sledges"
            return
        owners, others = _in_their_order(d, owned, owners, p.prep, others)
        place(d, owners, others, p.prep, m.part)
        if m.pronoun in ("both", "them") and p.prep in _APART and len(others) == 2:
            place(d, owners, others[1:], p.prep, m.part)  # "to the right of both"


def _in_their_order(
    d: Discourse, owned: Mention, owners: list[str], prep: str, others: list[str]
) -> tuple[list[str], list[str]]:
    """ "Two buses drive one behind the other. The front bus brakes": either may be the one."""
    here = NEIGHBOURS.get(prep, "")
    if here not in OPPOSITE or owned.pronoun != "one" or len(owners) != 1 or len(others) != 1:
        return owners, others
    ranks = tuple(d.world.entities[i].place for i in (*owners, *others) if i in d.world.entities)
    return (others, owners) if ranks == (OPPOSITE[here], here) else (owners, others)


def _carried_by_its_owner(d: Discourse, owners: list[str], things: list[str]) -> None:
    """ "A cart of laundry", "a table of cakes"; but "the deck of a ship" carries no ship."""
    if not owners:
        return
    held = [i for i in things if kind_of(d, i) not in _HAS_A_DECK and movable(d, i)]
    room = math.prod(d.world.entities[owners[0]].noun.dimensions_cm)
    if holds(d, owners[0]):  # "the drawer of the cabinet" holds no cabinet
        held = [i for i in held if math.prod(d.world.entities[i].noun.dimensions_cm) <= room]
    if holds(d, owners[0]):
        place(d, held, owners[:1], "in")
    elif "support" in traits_of(d, owners[0]) or kind_of(d, owners[0]) == "cart":
        place(d, held, owners[:1], "on")


def _one_each(d: Discourse, owners: list[str], others: list[str], m: Mention) -> bool:
    """ "Three kids on sledges", "two cups on two plates": one on each."""
    if len(owners) != len(others) or len(owners) < 2 or m.pronoun or m.determiner == "the":
        return False
    groups = [{entity_of(d, i).group for i in ids} for ids in (owners, others)]
    return all(len(g) == 1 and None not in g for g in groups) and groups[0] != groups[1]


def _placed_apart(d: Discourse, node: str, p: Phrase) -> bool:
    """ "A pot with a spoon to its right and a lemon in front of them": not in the pot."""
    phrases = [q for m, q in d.attached if q is not p and node in m.entities and q.mention]
    its = [q for q in phrases if q.mention is not None and q.mention.pronoun in _NAMED_BEFORE]
    sides = [q.mention for q in phrases if q.mention is not None and q.mention.head in _BESIDE_IT]
    apart = any(q.prep in _APART for q in its) or any(
        m.determiner in lex.POSSESSIVES for m in sides
    )
    return apart


def _bears(d: Discourse, node: str) -> bool:
    """Whether people and animals are on it, not it on them: slopes, furniture."""
    return bool({"support", "incline"} & traits_of(d, node))


def _tell(d: Discourse, owners: list[str], told: list[Amount], word: str, prep: str = "") -> None:
    """What quantities say of things, one value each where there are as many."""
    for o, its in zip(owners, dealt(told, len(owners)), strict=True):
        for a in its:
            if a.dimension == "speed":
                d.moves.stated[o] = a
            elif a.dimension == "length" and prep == "at" and word == "height":
                start_height(d, [o], a)
            elif apply_amount(d.world, entity_of(d, o), a, word):
                mark_used(d, a, o)


def _sharers(d: Discourse, owners: list[str], p: Phrase) -> list[str]:
    """ "two balls, red and blue, with masses of 1 kg and 3 kg": all that a list is told of."""
    number = max((len(a.shares) for a in p.told), default=0)
    if number < 2 or len(owners) != 1:
        return owners
    wholes = [*d.world.groups.values(), *d.world.salience[::-1]]
    return next((w for w in wholes if len(w) == number and w[-1] == owners[0]), owners)


def attachment_with(d: Discourse, owners: list[str], others: list[str]) -> None:
    """ "a table with bottles", "a cart has a box": on it, in it, or near it."""
    for host in owners[:1]:
        traits = traits_of(d, host)
        prep = "on" if "support" in traits else "in" if "container" in traits else "near"
        figures = [o for o in others if kind_of(d, o) == "animal"]
        if figures and turning(d, [host]):
            prep = "on"
            _carved(d, host, figures)
        for other in others:
            if prep != "near":
                place(d, [other], [host], prep)
            else:
                d.scene.relations.append(Relation(other, host, "near"))


def _carved(d: Discourse, host: str, figures: list[str]) -> None:
    """ "A carousel with four horses": they are as small as those of a carousel, which is roomy."""
    deck = entity_of(d, host)
    if deck.dimensions_cm is None:
        deck.dimensions_cm = [x * ROOMY for x in deck.noun.dimensions_cm]
    for e in (entity_of(d, i) for i in figures):
        if e.dimensions_cm is None:
            e.dimensions_cm = [x * CARVED for x in e.noun.dimensions_cm]


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


CARVED, ROOMY = 0.5, 1.6
"""Size of a carousel's animals over that of their kind (horses of 1.1 m), and of a carousel that
has some over a playground's."""


@sense("be")
def read_be(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """How high, large and where things are."""
    acts = f.verb.sense in ("posture", "carry") and f.object is not None and not f.verb.passive
    bodies = (o if acts else []) or s or o  # who leans a broom on a wall does not lean
    _hovering(d, f, bodies)
    places(d, f, bodies)
    named = f.subject.head if f.subject is not None and f.subject.attribute else ""
    for _, a in amounts_of(d, f):
        after = d.text[a.end : a.end + 12].strip().split(" ")[0].strip(".,;")
        side = named if named in _SIDES else after if after in _MEASURES else ""
        if a.dimension == "length" and side and unread(d, a):
            for t in bodies:
                apply_amount(d.world, entity_of(d, t), a, side)
            mark_used(d, a, side)
    mark_used(d, f, "state")


def _hovering(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """ "hovers 3 m above the ground": a height at the start."""
    others = things(f.phrase("above", "over", "off"))
    if f.verb.sense != "posture" or not all(map(partial(structural, d), others)):
        return
    for _, a in amounts_of(d, f):
        above = d.text[a.end : a.end + 7].strip().startswith(("above", "up", "high", "off"))
        at = "at " in d.text[max(0, a.start - 4) : a.start].lower()
        if a.dimension == "length" and (above or (at and f.verb.lemma in ("hover", "float"))):
            start_height(d, bodies, a)


@sense("posture")
def read_posture(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """A state, and how long it lasts; what sticks to something has hit it."""
    lasting = amount(d, f, "time")
    waits = lasting is not None and f.verb.lemma in _WAITING and not f.reduced
    left = f.verb.lemma == "stay" and "still" in f.adverbs  # "leaves the cup where it is"
    if (left or _STILL.match(d.text, f.verb.start)) and not f.unreal:
        d.moves.stays.update((a, f.verb.start) for a in s if movable(d, a))
    if lasting is None:
        _waits_for_nobody_knows_how_long(d, f, s)
    for actor in [a for a in s if waits and kind_of(d, a) in SELF_POWERED]:
        if moves(d, actor):
            add_event(d, NodeEvent.TRIGGER, (actor,), f, None)  # "drives for 4 s, waits"
            d.timeline.track(actor).motion = None
        if lasting is not None:
            d.moves.waiting[actor] = lasting
            mark_used(d, lasting, "waiting time")
    met = things(f.phrase("at", "on", "in", "against", "onto", "upon"))
    if f.verb.lemma == "settle" and not f.reduced and any(not at_rest(d, a) for a in s):
        read_as(d, "stop", f, s, o)  # "rolls back and settles in the corner"
    elif f.verb.lemma == "stick" and not f.reduced and s and met and not at_rest(d, s[0]):
        add_hit(d, f, s[:1], met[:1], time_of(d, f))
    else:
        read_be(d, f, s, o)
    if f.verb.lemma in _HOVERING:
        _holds_its_height(d, f, s)


def _waits_for_nobody_knows_how_long(d: Discourse, f: Frame, s: list[str]) -> None:
    """ "A cyclist on a bike waits": so does the bike."""
    if f.verb.lemma in _PATIENT and not f.reduced and not f.unreal:
        waiting = [*s, *(d.scene.supported_by.get(a, a) for a in s)]
        d.moves.patient.update(
            a for a in waiting if kind_of(d, a) in SELF_POWERED and at_rest(d, a)
        )


def _holds_its_height(d: Discourse, f: Frame, s: list[str]) -> None:
    """What flies by itself and goes nowhere yet stays in the air."""
    if f.unreal or f.verb.negated:
        return
    for actor in [a for a in s if flies_itself(d, a) and at_rest(d, a)]:
        hover(d, actor)


def stands_there(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """ "A dog barks beside a car", "grows in a pot": no act is shown, and yet a place is told.

    Where things are that have not moved; "waves at a boy" is no place.
    """
    if f.verb.negated or f.unreal or f.object is not None or f.verb.passive:
        return
    if f.verb.lemma in _LIGHT:
        return  # "takes on a rival", "gets on a bus"
    for p in f.phrases:
        others, prep = things(p), p.prep
        if prep == "out of" and others and holds(d, others[0]):
            prep = "in"  # "grows out of a pot"
        told = prep in _AT_REST and others and not structural(d, others[0])
        here = [i for i in bodies if at_rest(d, i) and movable(d, i) and i not in others]
        here = [i for i in here if not _related(d, i, others[0])] if told else []
        if here and p.mention is not None:
            place(d, here, others, prep, p.mention.part)


def _related(d: Discourse, body: str, other: str) -> bool:
    return any({r.source, r.target} == {body, other} for r in d.scene.relations)


@sense("unknown")
def read_unknown(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """An unknown verb is a motion if its phrases are; it is reported either way."""
    ways = f.phrase("toward", "towards", "into", "across", "along", "through", "down", "against")
    told = ways is not None or quantity_of(d, f, "speed") is not None
    if s and told and f.object is None:  # "pours milk into a cup" moves nobody
        motion(d, f, s, None)
        d.scene.used.pop((f.verb.start, f.verb.end), None)
    elif not told:
        stands_there(d, f, s)


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
    _measured(d, f, s, f.object.head if f.object is not None else "")
    if f.phrase("on", "in", "inside") is None:
        attachment_with(d, s, o)
    places(d, f, o)
    mark_used(d, f, "property")


@sense("measure")
def read_measure(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    _measured(d, f, s, "")
    mark_used(d, f, "size")


def _measured(d: Discourse, f: Frame, bodies: list[str], word: str) -> None:
    for t, its in zip(bodies, dealt([a for _, a in amounts_of(d, f)], len(bodies)), strict=True):
        for a in its:
            if apply_amount(d.world, entity_of(d, t), a, word):
                mark_used(d, a, t)


@sense("contain")
def read_contain(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if s and o:
        place(d, o, s, "in" if holds(d, s[0]) else "on")
    mark_used(d, f, "state")


@sense("face")
def read_face(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    target = o or [i for p in f.phrases for i in things(p)]
    for t in s:
        if target and target[0] != t:
            d.scene.facing[t] = target[0]
    mark_used(d, f, "facing")


@sense("surround")
def read_surround(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    around = [i for p in f.phrases if p.prep in ("by", "with") for i in things(p)]
    inner, outer = (s, around) if f.verb.passive else (o, s)
    for t in outer if inner else []:
        d.scene.relations.append(Relation(t, inner[0], "surround"))
    mark_used(d, f, "state")


def places(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """Where a clause says that things are, how far from others, and in what arrangement."""
    gap = next((a for p in ("", "at", "about") if (a := amount(d, f, "length", p))), None)
    pattern = "row" if _ABREAST & {*f.adverbs} else _PATTERN_VERBS.get(f.verb.lemma)
    for t in bodies:
        _pattern_of(d, t, pattern)
    for p in f.phrases:
        _place_by(d, f, bodies, p, gap)


def _place_by(d: Discourse, f: Frame, bodies: list[str], p: Phrase, gap: Amount | None) -> None:
    """Where one phrase says that things are."""
    others = things(p)
    end = p.mention is not None and p.mention.part.endswith("end") and bool(others)  # of a seesaw
    told = p.mention is not None and (end or not p.mention.attribute)
    if p.mention is None or not told or not (others or p.mention.noun):
        _arrange(d, bodies, p)
    elif f.verb.lemma in _HANGING and p.prep in _HUNG_BY and _hangs(d, bodies, others):
        return
    elif p.prep == "with" and f.verb.lemma in _FILLING:
        _filled(d, f, bodies, others)
    elif f.verb.lemma in _LEANING and p.prep in _BESIDE and others and _leans(d, others[0]):
        _lean(d, bodies, others)
    elif p.prep in RELATION_PREPS:
        fixed = _distance(d, gap) if bodies and p.prep not in ("on", "in", "inside") else None
        place(d, bodies, others, p.prep, p.mention.part, fixed)
    elif p.prep in ("from", "away from") and gap is not None and others and bodies:
        for t in bodies:
            d.scene.relations.append(Relation(t, others[0], "near", gap.value))
        mark_used(d, gap, "distance")


def _hangs(d: Discourse, bodies: list[str], others: list[str]) -> bool:
    """ "A lamp hangs from the ceiling": fixed to what is above it."""
    high = bool(others) and (towers(d, others[0]) or kind_of(d, others[0]) == "ceiling")
    hung = [t for t in bodies if high and not structural(d, t)]
    for t in hung:
        hang(d, t, others[0])
    return bool(hung)


def _leans(d: Discourse, host: str) -> bool:
    return size_of(d, host)[2] >= _LEANT_ON_CM


def _lean(d: Discourse, bodies: list[str], others: list[str]) -> None:
    """ "A broom leans on a wall": it stands beside it on its end, and can only tip over."""
    for t in bodies:
        e, dims = entity_of(d, t), size_of(d, t)
        if movable(d, t) and max(dims[:2]) > 2.0 * dims[2]:
            long = 0 if dims[0] >= dims[1] else 1
            dims[long], dims[2] = dims[2], dims[long]
            e.dimensions_cm = dims
        d.moves.leaning.add(t)
    place(d, bodies, others, "against")


def _arrange(d: Discourse, bodies: list[str], p: Phrase) -> None:
    """ "in a triangle", "in a queue": how a plural stands."""
    m = p.mention
    pattern = lex.ARRANGEMENTS.get(m.head) if m is not None else None
    if m is None or m.entities or p.prep not in ("in", "into") or pattern is None:
        return
    for t in bodies:
        _pattern_of(d, t, pattern)


def _pattern_of(d: Discourse, thing: str, pattern: str | None) -> None:
    e = entity_of(d, thing)
    if e.group is not None and pattern is not None:
        racked = pattern == "pins" and e.noun.kind == "billiard"
        e.pattern = "rack" if racked else pattern


@sense("carry")
def read_carry(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    # "a crane lifts a pallet, carries it over and sets it down"
    hoists = bool(s and o) and head_of(entity_of(d, s[0])) in CRANES
    if s and o and not (hoists and happened(d, NodeEvent.PICKED_UP, o[0])):
        place(d, o, s, "on")
    along = s and o and f.verb.lemma in ("carry", "transport") and not movable(d, s[0])
    if along and not turning(d, s[:1]):
        motion(d, f, o, "slide")  # "a conveyor carries a box past a guard"
    elif s and (quantity_of(d, f, "speed") or any(p.prep in _CARRIED_ALONG for p in f.phrases)):
        motion(d, f, s, None)
    elif s and o and not f.reduced and not f.verb.passive and f.verb.lemma in _CARRIES:
        walkers = [i for i in s if kind_of(d, i) in LIMBED]
        if walkers:
            motion(d, f, walkers, None)  # carrying is going
    mark_used(d, f, "carrying")


@sense("apply")
def read_apply(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    ignore(d, f, "no physical meaning")


@sense("start")
def read_start(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "starts at 5 m/s, 3 m from the pins": how the motion to come begins."""
    read_apply(d, f, s, o)
    speed = quantity_of(d, f, "speed")
    if speed is not None and len(s) == 1:
        d.moves.stated[s[0]] = speed[1]
    sets_off_late(d, f, s)
    starts_apart(d, f, s)
    driven = [a for a in s if at_rest(d, a) and kind_of(d, a) in SELF_POWERED]
    at = next((k for k, g in enumerate(d.told) if g.verb is f.verb), 0)
    later = {i for g in d.told[at + 1 :] if g.subject for i in g.subject.entities}
    if driven and not o and not f.phrases and not later & {*driven}:
        motion(d, f, driven, None)  # "The light turns green and the van starts"


def _filled(d: Discourse, f: Frame, bodies: list[str], others: list[str]) -> None:
    """ "A truck loaded with barrels" has them on it, "a cart filled with apples" as it can."""
    if f.verb.lemma == "load" and bodies and kind_of(d, bodies[0]) in SELF_POWERED:
        place(d, others, bodies[:1], "on")
    else:
        attachment_with(d, bodies, others)


def _distance(d: Discourse, gap: Amount | None) -> Quantity | None:
    """How far things are said to be from others; it is used from now on."""
    mark_used(d, gap, "distance")
    return gap.value if gap is not None else None
