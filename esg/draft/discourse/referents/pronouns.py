"""What pronouns mean, and "one", "the other" and "the second" without a noun."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.attributes import other_of_two, told_by
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.matching import CONTRASTS, unlike
from esg.draft.discourse.referents.members import (
    at_place,
    name_by,
    next_of,
    one_more,
    place_word,
    ranked,
)
from esg.draft.discourse.referents.ranks import same_quantity
from esg.draft.discourse.referents.record import (
    World,
    all_rest,
    is_solid,
    last_group,
    named_alone,
)
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.grammar.rewrites.positions import NEIGHBOUR
from esg.draft.text.elements import Mention

_BEINGS = frozenset({"animal", "robot"})
_DRIVEN = lex.word_set("driven (persons)")
_LINKS = lex.word_set("links")
_MOVERS = _BEINGS | _DRIVEN | {"person", "flyer", "toyvehicle"}
_HE = lex.word_set("he")
_SHE = lex.word_set("she")
_HIS = frozenset({"he", "him", "himself"})
_HERS = frozenset({"she", "her", "herself"})
_ANYBODY = frozenset({"someone", "everyone"})
_NOTHING = frozenset({"i", "we", "you", "something", "everything"})
_THEY = frozenset(
    {"they", "them", "themselves", "these", "those", "both", "ones", "all", "each", "some"}
    | {"many", "several"}
)
_PLACES = frozenset({"right of", "left of", "in front of", "behind", "beside", "next to", "above"}
                    | {"below", "under", "between", "near", "by"})  # fmt: skip
_FACING = {"left": "right", "right": "left"}
_WAYS = frozenset({"stairs", "ramp"})
_IN_A_ROW = lex.ORDINALS.keys() | {"last", "final", "front", "rear", "middle"}
MATE = "@mate"
"""Adjective of one of the kind of what it is told to be beside ("the one next to it")."""
_GROWN_UP = lex.word_set("grown up")


def pronoun(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """Node ids of what a pronoun means, where the clauses told so far do not decide."""
    p = m.pronoun
    if p in _HIS | _HERS | _ANYBODY:
        return _person(world, m, subject, avoid)
    if p in _NOTHING:
        return []
    if p in _THEY:
        named = (told_by(world, m, avoid) or _painted(world, m)) if p == "ones" else []
        return named or _others(world, m, avoid) or _several(world, m, subject, avoid)
    if p in ("latter", "former"):
        told = [i for ids in world.salience[-6:] for i in ids if is_solid(world, i)]
        two = list(dict.fromkeys(reversed(world.movers if len(world.movers) > 1 else told)))[:2]
        found = two[:1] if p == "latter" else two[1:]
        return [i for i in two if i not in found] if {*found} & {*avoid} else found
    if p in ("one", "another", "other"):
        return one_of(world, m, subject, avoid)
    if m.after_prep == "behind" and (ahead := _ahead(world, avoid)):
        return ahead
    return _thing(world, subject, avoid)


def _ahead(world: World, avoid: list[str]) -> list[str]:
    """ "A bus leaves a kerb and a car behind it brakes": behind the vehicle told of last."""
    lone = [ids[0] for ids in reversed(world.subjects) if len(ids) == 1 and ids[0] not in avoid]
    driven = [i for i in [*avoid[:1], *lone[:1]] if world.entities[i].noun.kind in _DRIVEN]
    return lone[:1] if avoid and len(driven) == 2 else []


def _solids(world: World) -> list[Entity]:
    """Things of the scene, without its floors and walls, in order of mention."""
    return [e for i, e in world.entities.items() if is_solid(world, i)]


def _told(world: World) -> list[Entity]:
    """Things of the scene, once for every time they are named, most recent last."""
    return [world.entities[i] for ids in world.salience for i in ids if is_solid(world, i)]


def _person(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """Whom "he", "her" or "someone" means: the one named last; somebody new if there is none."""
    p = m.pronoun
    other = p in ("him", "her") and not subject  # never the subject of its own clause
    alone = named_alone(world)
    people = [
        ids
        for ids in alone
        if world.entities[ids[0]].noun.kind == "person" and not (other and ids[:1] == avoid[:1])
    ]
    alike = [ids for ids in people if not _of_other_gender(p, world.entities[ids[0]].head)]
    if found := alike or people:
        return found[0]
    if p not in _ANYBODY and not m.determiner and (being := _being(world, m, subject, avoid)):
        return being
    if not subject:
        return []
    person = lex.nouns()["person"]
    return [add_entity(world, person, "person", label=p, origin=m.start).id]


def _of_other_gender(word: str, head: str) -> bool:
    """Whether "he" or "she" is no word for somebody called a woman or a boy."""
    female = head in _SHE or head.endswith("woman")
    male = head in _HE or (head.endswith("man") and not female)
    return female if word in _HIS else male and word in _HERS


def _being(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """What "he" or "him" means where no known person was named.

    That is a thing with an unknown name, which is a person from now on; else an animal or a robot;
    else a vehicle ("overtakes him").
    """
    sets = [*world.salience, *(world.subjects if subject else ())]
    lone = [ids[0] for ids in reversed(sets) if len(ids) == 1 and ids[0] not in avoid]
    alone = [world.entities[i] for i in lone if i in world.entities]
    for e in alone:
        named = e.noun.kind == "generic" and not e.known and e.group is None
        if named and e.head.split()[-1] not in _LINKS:
            e.noun, e.known = lex.nouns()["person"], True
            return [e.id]
    beings = [e for e in alone if e.noun.kind in _BEINGS]
    driven = [e for e in alone if e.noun.kind in _DRIVEN and m.pronoun != "she"]
    return [e.id for e in (beings or driven)[:1]]


def _painted(world: World, m: Mention) -> list[str]:
    """ "Of the four cubes only the two red ones move": so many of a plural, from now on red."""
    color = next((a for a in m.adjectives if a in lex.COLORS), "")
    several = [ids for ids in reversed(world.salience) if len({*ids}) > 1]
    if not color or (m.count or 0) < 2 or not several:
        return []
    things = [world.entities[i] for i in dict.fromkeys(several[0])]
    free = [e for e in things if e.group and e.color is None and not e.place]
    if len(free) < (m.count or 0) or not m.determiner:
        return []
    return [i for e in free[: m.count] for i in name_by(world, e, color)]


def _others(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "the other two", "the rest": the members of a plural that were not told of."""
    mates = world.groups.get(world.entities[avoid[0]].group or "", []) if avoid else []
    rest = [i for i in mates if i not in avoid]
    if m.pronoun == "ones" and m.determiner == "the" and not m.adjectives and (m.count or 0) > 1:
        return rest[: m.count] if len(rest) >= (m.count or 0) and not m.after_prep else []
    if m.pronoun != "ones" or "other" not in m.adjectives:
        return []
    if rest := _rest_of_a_plural(world, m.count, avoid):
        return rest
    like = [world.entities[i] for i in avoid[:1] if is_solid(world, i)]
    alone = [e for e in reversed(_told(world)) if e.noun.kind != "person" and not world.groups]
    like = like or alone  # "leaving the other two where they are"
    return one_more(world, like[0], [], m, m.count) if like and m.count else []


def _rest_of_a_plural(world: World, count: int | None, avoid: list[str]) -> list[str]:
    """The members not told of, as many as are counted, of the plural told of last."""
    for ids in [avoid, *reversed(world.salience)] if avoid else reversed(world.salience):
        group = world.groups.get(world.entities[ids[0]].group or "", [])
        rest = [i for i in group if i not in ids and not world.entities[i].place]
        if rest and (count or len(rest)) == len(rest):
            return rest
    return []


def _several(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """What "they" or "both" means: the plural named last, else the last two things."""
    p = m.pronoun
    keep = m.count if m.count in (1, 2, 3) and p in ("them", "these", "those") else None
    keep = m.count if p == "ones" and not m.adjectives else keep  # "eleven run out"
    named = _told_last(world, m, subject, avoid)
    if two := _two_subjects(world, p, named) if subject else []:
        return two
    if two := _two_acted_on(world, m, avoid) if not subject else []:
        return two
    pool = [*reversed(world.subjects if subject and p != "both" else []), *reversed(world.salience)]
    many = [ids for ids in pool if len(ids) > 1]
    free = [ids for ids in many if subject or not set(ids) <= {*avoid}]
    if many:
        return list((free or many)[0])[:keep]
    group = world.groups.get(world.entities[named[0]].group or "", []) if named else []
    if len(group) > 1 and p not in ("both", "each"):
        return list(group)  # "the first domino ... they all topple"
    recent = list(dict.fromkeys(named))
    alike = [i for i in recent if _alike(world, world.entities[i], recent[0])]
    return (alike if p == "both" and len(alike) > 1 else recent)[:2][::-1]


def _told_last(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """Things that "they" can mean, the one named last first."""
    named = [i for ids in reversed(world.salience) for i in ids if is_solid(world, i)]
    named = [i for i in named if world.entities[i].noun.kind not in _WAYS or not subject]
    if not subject and m.pronoun in ("them", "both") and m.after_prep in _PLACES:
        # "a clock above a frame, with a lamp to the right of both": not of itself
        return [i for i in named if i not in avoid] or named
    return named


def _two_subjects(world: World, p: str, named: list[str]) -> list[str]:
    """The last two subjects, where they are of a kind or nothing was named after them.

    "A car passes a bus, a van passes it, and both brake", "a bus comes and they collide"
    """
    lone = [ids[0] for ids in reversed(world.subjects[-4:]) if len(ids) == 1]
    two = list(dict.fromkeys(lone))[:2]
    if len(two) < 2 or len(world.subjects[-1]) > 1 or p not in ("they", "both"):
        return []
    grouped = all(world.entities[i].group for i in two)
    alike = _alike(world, world.entities[two[0]], two[1]) and not grouped
    meet = two[0] == named[0] and not any(len(ids) > 1 for ids in world.salience)
    return two[::-1] if (alike if p == "both" else meet) else []


def _two_acted_on(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "Sets a mug on a book and carries both": the last two things but who acts; a pair first."""
    if m.pronoun != "both" and not (m.count == 2 and m.pronoun == "them"):
        return []
    units: list[list[str]] = []
    for ids in reversed(world.salience):
        own = [i for i in dict.fromkeys(ids) if is_solid(world, i) and i not in avoid]
        if not own or own[0] in (i for u in units for i in u):
            continue
        whole = world.entities[own[0]].group in world.collective  # "a stack of books" is one
        if len(own) > 1 and not whole:
            return own if len(own) == 2 and not units else []
        units.append(own)
        if len(units) == 2:
            return [*units[1], *units[0]]
    return []


def _thing(world: World, subject: bool, avoid: list[str]) -> list[str]:
    """What "it", "this" or "itself" means: a subject named before, else the thing named last."""
    for ids in [*reversed(world.subjects if subject else []), *reversed(world.salience)]:
        e = world.entities[ids[0]]
        fits = ids[0] not in avoid and is_solid(world, ids[0]) and e.noun.kind != "person"
        if fits and e.noun.name != "arm" and (len(ids) == 1 or e.group in world.collective):
            return list(ids)
    for ids in reversed(world.salience):
        if not set(ids) <= {*avoid}:
            heads = {world.entities[i].head for i in ids if world.entities[i].noun.kind == "person"}
            return [] if heads & _GROWN_UP else list(ids)
    return []


def one_of(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """ "the other one", "the second", "the red one", "the next": a member, or one thing more."""
    if beside := _next_to(world, m, avoid):
        return beside
    solid = _solids(world)
    row = [world.entities[i] for i in (_of_the_subject(world, m, subject) or last_group(world))]
    told = _told(world)
    near = list({e.id: e for e in told if e.id not in avoid}.values())
    among = _of_one_kind(world, solid, avoid) or row or solid
    if not place_word(m) and (having := told_by(world, m, avoid)):
        return having[:1]
    if found := _in_its_place(world, m, row or near, among, avoid):
        return found
    words = [a for a in m.adjectives if _tells(a)]
    if having := _having(world, m, solid, words, avoid):
        return having
    if row and "next" in m.adjectives:
        return next_of(world, row, avoid)
    other = bool({"another", "other"} & {m.pronoun, m.determiner, *m.adjectives})
    if other and m.determiner == "the" and (second := _the_other(world, row, words, avoid)):
        return second
    if row and (found := _of_row(world, row, words, told if other else [], avoid)):
        return found
    if words or other or "next" in m.adjectives:
        return _one_more_like(world, m, words, subject, avoid)
    return [e.id for e in near][-1:]


def _next_to(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "The one in front", "the one next to it": what is told by what it is beside."""
    if NEIGHBOUR in m.adjectives and (beside := _beside(world, m, avoid)):
        return beside
    return _mate(world, m, avoid) if MATE in m.adjectives else []


def _in_its_place(
    world: World, m: Mention, row: list[Entity], among: list[Entity], avoid: list[str]
) -> list[str]:
    """ "The second", "the one on the left", "the right one": by rank, by place, or facing."""
    found = ranked(world, m, row, avoid) or at_place(world, m, among)
    return found or _facing(world, m, _solids(world))


def _having(
    world: World, m: Mention, solid: list[Entity], words: list[str], avoid: list[str]
) -> list[str]:
    """ "The red one", "the 5 kg one": what has that, rather something not told of just now."""
    having = [e for e in solid if _has(e, words) or same_quantity(m, e, world.facts)]
    if not having:
        return []
    return [max(having, key=lambda e: (e.id not in avoid, solid.index(e))).id]


def _the_other(world: World, row: list[Entity], words: list[str], avoid: list[str]) -> list[str]:
    """ "The other one" of two: of a plural, by what is told of both, or of two of a kind."""
    if second := _second_of_two(world, row, avoid):
        return second
    return [] if words else other_of_two(world, avoid) or _of_two_alike(world, avoid)


def _of_two_alike(world: World, avoid: list[str]) -> list[str]:
    """ "A ball is thrown as another is dropped; neither lands before the other": of the two."""
    last = next(iter(named_alone(world)), [""])[0]
    if last not in world.entities or world.entities[last].group is not None:
        return []
    two = [e.id for e in _solids(world) if e.noun == world.entities[last].noun]
    used = {*avoid} & {*two} or {last}
    return [i for i in two if i not in used] if len(two) == 2 and len(used) == 1 else []


def _mate(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "A bin falls over and knocks down the one next to it": one more of the kind of who acts."""
    last = world.subjects[-1] if world.subjects else []
    like = next((world.entities[i] for i in (*avoid, *last) if is_solid(world, i)), None)
    if like is None:
        return []
    mates = [e.id for e in _solids(world) if e.noun == like.noun and e.id not in (like.id, *avoid)]
    return mates[:1] or one_more(world, like, ["other"], m)


def _facing(world: World, m: Mention, solid: list[Entity]) -> list[str]:
    """ "The left robot hands a box to the right one": one more, on the other side."""
    side = place_word(m)
    alone = [e for e in solid if e.group is None and side in _FACING]
    there = [e.id for e in alone if e.place == side]
    other = [e for e in alone if e.place == _FACING.get(side)]
    return there[-1:] or (one_more(world, other[-1], [side], m) if other else [])


def _of_the_subject(world: World, m: Mention, subject: bool) -> list[str]:
    """ "Three kids on sledges race, and the one on the red sledge wins": one of the kids."""
    last = world.subjects[-1] if world.subjects and subject else []
    row = last_group(world)
    waits = bool(row) and all_rest(world, row)  # "between the parked cars, the last one ..."
    told = m.determiner != "the" or len(last) < 2
    told = told or not {*m.adjectives} <= (_IN_A_ROW if waits else frozenset())
    return [] if told else world.groups.get(world.entities[last[0]].group or "", [])


def _second_of_two(world: World, row: list[Entity], avoid: list[str]) -> list[str]:
    """ "Two cars drive, one in front of the other": of both in one clause, the one not named."""
    two = [e.id for e in row]
    named = next(iter(named_alone(world)), [""])[0]
    both = len(two) == 2 and named in two and {*two} <= {*avoid}
    return [i for i in two if i != named] if both else []


def _of_one_kind(world: World, solid: list[Entity], avoid: list[str]) -> list[Entity]:
    """What "the second" is counted among: what is like the subject, or like a "first" thing."""
    mates = [e for e in solid if e.id not in avoid and any(_alike(world, e, i) for i in avoid)]
    placed = [e for e in solid if e.place in lex.ORDINALS and e.group is None]
    return mates or [e for e in solid if placed and e.noun == placed[-1].noun]


def _of_row(
    world: World, row: list[Entity], words: list[str], told: list[Entity], avoid: list[str]
) -> list[str]:
    """A member of a plural: one without a colour, the first, or the first not told of."""
    colors = [a for a in words if a in lex.COLORS]
    free = [e for e in row if e.color is None and e.id not in avoid]
    if words:
        return name_by(world, free[0], colors[0]) if colors and free else []
    used = avoid or [i for ids in world.salience[-1:] for i in ids]
    if not {e.id for e in row} & {*used}:  # "hits the left one. A second stone hits the other"
        used = [e.id for e in reversed(told) if e in row][:1]
    return [e.id for e in row if not told or e.id not in used][:1]


def _one_more_like(
    world: World, m: Mention, words: list[str], subject: bool, avoid: list[str]
) -> list[str]:
    """ "a blue car ... the red one", "A domino hits the next": one more of the kind meant."""
    colors = [a for a in words if a in lex.COLORS]
    solid = _solids(world)
    model = _rivals(solid, words)
    if colors and (world.billiards or (not model and m.adjectives == colors)):
        ball = lex.nouns()["billiard ball" if world.billiards else "ball"]
        label = f"{colors[0]} ball"
        more = add_entity(world, ball, "ball", adjectives=colors, label=label, origin=m.start)
        return [more.id]  # "Red knocks blue away"
    mine = avoid or (world.subjects[-1] if world.subjects else [])
    actor = [world.entities[i] for i in mine[:1] if is_solid(world, i)]
    rest = [e for e in solid if e.id not in mine]
    passed = actor and actor[0].noun.kind in _MOVERS and not subject and rest
    model = model or [e for e in solid if e.one]
    model = model or (rest if passed or not actor else actor)
    second = ["second"] if m.pronoun == "another" else []
    telling = words or [a for a in m.adjectives if a in ("next", "other")] or second
    return one_more(world, model[-1], telling, m) if model else []


def _rivals(solid: list[Entity], words: list[str]) -> list[Entity]:
    """What a colour, an ordinal or another adjective tells a thing apart from."""
    if {*words} & lex.COLORS.keys():
        return [e for e in solid if e.color is not None]
    if {*words} & lex.ORDINALS.keys():
        return [e for e in solid if e.place in lex.ORDINALS] or [e for e in solid if e.group]
    return [e for e in solid if any(unlike(e, a) for a in words)]


def _alike(world: World, e: Entity, i: str) -> bool:
    return e.noun == world.entities[i].noun and "structural" not in e.noun.traits


def _beside(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "the one in front (of it)": the next one of its row, or one more."""
    last = next(iter(named_alone(world)), [""])
    anchor = world.entities.get((avoid or last)[0])
    place = next((a for a in m.adjectives if a in ("front", "rear")), "")
    if anchor is None or not place or not is_solid(world, anchor.id):
        return []
    row = world.groups.get(anchor.group or "", [])
    if not row:
        alike = [e.id for e in world.entities.values() if _alike(world, e, anchor.id)]
        return [i for i in alike if i != anchor.id][-1:] or one_more(world, anchor, [place], m)
    k = {"front": 0, "rear": len(row) - 1, "last": len(row) - 1}.get(anchor.place, 0)
    k = (k if anchor.place else row.index(anchor.id)) + (-1 if place == "front" else 1)
    near = world.entities[row[min(max(k, 0), len(row) - 1)]]
    return name_by(world, near, place) if len(row) == 2 else [near.id]


def _tells(a: str) -> bool:
    """Whether an adjective tells a thing from others of its kind."""
    return a in lex.COLORS or a in lex.ORDINALS or any(a in c for c in CONTRASTS)


def _has(e: Entity, words: list[str]) -> bool:
    return any(lex.COLORS.get(a, a) in (e.color, e.place) or a in e.adjectives for a in words)
