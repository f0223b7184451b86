"""What pronouns, ordinals and "one" mean."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.choices import one_more, one_of
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.meetings import before_this, meeting, the_others
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.referents.registry import add_entity, create
from esg.draft.text.elements import Mention

_NEAR = 80
"""Characters within which "former" and "latter" mean the same two things."""
_BEINGS = frozenset({"animal", "robot"})
_HE = lex.word_set("he")
_SHE = lex.word_set("she")
_DRIVEN = lex.word_set("driven (persons)")
_HERS = frozenset({"she", "her", "herself"})
_WAYS = frozenset({"stairs", "ramp"})
"""What things move along."""


def pronoun(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    p = m.pronoun
    if p in ("he", "she", "him", "her", "himself", "herself", "someone", "everyone"):
        other = p in ("him", "her") and not subject  # never the subject of its own clause
        people = [
            ids
            for ids in reversed(world.salience)
            if len(ids) == 1 and world.entities[ids[0]].noun.kind == "person"
            and not (other and ids[:1] == avoid[:1])
        ]  # fmt: skip
        like = (x for x in people if not of_other_gender(p, world.entities[x[0]].head))
        if who := next(like, next(iter(people), None)):
            return who
        if p not in ("someone", "everyone") and not m.determiner:
            being = _named_by_no_person(world, p, subject, avoid)
            if being:
                return being
        if p in ("he", "she", "someone") and subject:
            person = lex.nouns()["person"]
            return [add_entity(world, person, "person", label=p, origin=m.start).id]
        return []
    if p in ("i", "we", "you", "something", "everything"):
        return []
    if p == "another" and not world.groups:
        told = (ids for ids in reversed(world.salience) if not set(ids) <= {*avoid})
        last = next(told, []) if not subject else []
        one = len(last) == 1 and world.entities[last[0]].label.lower().startswith("one ")
        others = (
            last if one else avoid or (world.subjects[-1] if subject and world.subjects else [])
        )
        solid = (world.entities[i] for i in others)
        model = next((e for e in solid if "structural" not in e.noun.traits), None)
        if model is not None:
            return one_more(world, model, ["second"], m)
    if p == "ones" and m.count and m.count > 1 and "other" in m.adjectives and avoid:
        known = world.groups.get(world.entities[avoid[0]].group or "", [])
        rest = [i for i in known if i not in avoid]
        if len(rest) == m.count:
            return rest  # "one of three skaters takes the other two down"
        if not known and "structural" not in world.entities[avoid[0]].noun.traits:
            like = world.entities[avoid[0]]
            return create(
                world,
                Mention(m.start, m.end, head=like.head, noun=like.noun, count=m.count, plural=True),
            )
    if p == "ones" and m.count is None and m.adjectives == ["other"]:
        rest = the_others(world.salience, world.groups, world.entities)
        if rest:
            return rest
    if p in (
        "they",
        "them",
        "themselves",
        "these",
        "those",
        "both",
        "ones",
        "all",
        "each",
        "some",
        "many",
        "several",
    ):
        pool = world.subjects if subject and p not in ("both",) else world.salience
        two = _last_two_alike(world) if p == "both" and subject else []
        if two:
            return two
        keep = m.count if m.count in (1, 2, 3) and p in ("them", "these", "those") else None
        keep = m.count if p == "ones" and not m.adjectives else keep  # "eleven run out"
        for ids in reversed(pool):
            if len(ids) > 1 and (subject or not set(ids) <= set(avoid)):
                return list(ids)[:keep]
        for ids in reversed(world.salience):
            if len(ids) > 1:
                return list(ids)[:keep]
        for ids in reversed(world.salience) if p not in ("both", "each") else ():
            group = world.groups.get(world.entities[ids[0]].group or "", [])
            if len(ids) == 1 and len(group) > 1:
                return list(group)  # "the first domino ... they all topple"
        recent: list[str] = []
        for ids in reversed(world.salience):
            for i in ids:
                if subject and p == "they" and world.entities[i].noun.kind in _WAYS:
                    continue  # "rolls down the ramp, and they collide"
                if i not in recent and "structural" not in world.entities[i].noun.traits:
                    recent.append(i)
            if len(recent) >= 2 and (p != "both" or len(recent) > 3):
                break
        alike = [i for i in recent if world.entities[i].noun == world.entities[recent[0]].noun]
        recent = alike if p == "both" and len(alike) > 1 else recent
        if len(recent) >= 2:
            met = meeting(world.subjects, recent, world.entities) if subject else []
            return met or recent[:2][::-1]
        return recent
    if p in ("latter", "former"):
        two = list(dict.fromkeys(i for i in world.movers if i in world.entities))
        if 0 <= m.start - world.two[0] < _NEAR:
            two = world.two[1]  # "the former hits the latter"
        if len(two) < 2:
            last = [i for ids in world.salience[-6:] for i in ids if i in world.entities]
            solid = [i for i in last if "structural" not in world.entities[i].noun.traits]
            two = list(dict.fromkeys(reversed(solid)))[:2][::-1]
        world.two = (m.start, two)
        return two[-1:] if p == "latter" else two[:1]
    if p == "one" and m.determiner in ("this", "that") and not m.adjectives:
        for ids in reversed(world.salience):  # "hits the red ball and this one rolls away"
            if len(ids) == 1 and "structural" not in world.entities[ids[0]].noun.traits:
                return list(ids)
    if p in ("one", "another", "other"):
        if (p == "other" or "other" in m.adjectives) and m.determiner == "the":
            other = _other_of_one(world, m)
            if other:
                return other
        named = next((a for a in m.adjectives if a in lex.ORDINALS), None)
        like = before_this(named, avoid, world.entities)
        if like:
            return like
        told = [e.id for e in world.entities.values() if named and e.place == named]
        if named and told:
            return told[-1:]  # "a third car hits the second"
        if named and m.determiner == "the" and not world.groups and m.adjectives == [named]:
            solid = [e.id for e in world.entities.values() if _counts(e)]
            pair = next((ids for ids in reversed(world.salience) if len(ids) == 2), solid)
            solid = list(pair) if len(solid) != 2 else solid
            placed = any(e.place in lex.ORDINALS for e in world.entities.values())
            if len(solid) == 2 and lex.ORDINALS[named] < 2 and not placed:
                return [solid[lex.ORDINALS[named]]]  # "a car and a fence. The first one hits"
        return one_of(world, m, avoid)
    # it, itself, this, that
    pools = [world.subjects, world.salience] if subject else [world.salience]
    for pool in pools:
        for ids in reversed(pool):
            fits = [
                i
                for i in ids
                if i not in avoid
                and "structural" not in world.entities[i].noun.traits
                and world.entities[i].noun.kind != "person"
                and world.entities[i].noun.name != "arm"
                and (world.entities[i].noun.kind not in _WAYS or not _anything_else(world, avoid))
            ]
            if len(ids) == 1 and fits:
                return fits
            whole = world.entities[ids[0]].group in world.collective
            if fits and len(ids) > 1 and whole and not (subject and pool is world.salience):
                return list(ids)
    for ids in reversed(world.salience):
        if ids and not set(ids) <= set(avoid):
            grown = p == "it" and all(_grown_up(world, i) for i in ids)
            return [] if grown else list(ids)
    return []


def _other_of_one(world: World, m: Mention) -> list[str]:
    """ "One forklift waits; the other one drives off": a second forklift."""
    alone = [e for e in world.entities.values() if e.label.lower().startswith("one ")]
    if len(alone) != 1 or world.groups or "structural" in alone[0].noun.traits:
        return []
    model = alone[0]
    like = [e for e in world.entities.values() if e.noun == model.noun and e.id != model.id]
    if like:
        return [like[0].id] if len(like) == 1 else []
    return one_more(world, model, ["other"], m)


def _grown_up(world: World, i: str) -> bool:
    """Whether "it" is no word for a person ("the child ... it" is one)."""
    e = world.entities[i]
    return e.noun.kind == "person" and e.head in ("person", "he", "she", "man", "woman")


def _counts(e: Entity) -> bool:
    """Whether it is a thing of its own, no ground, road or place."""
    traits = e.noun.traits
    return not ({"ground", "decal"} & traits) and ("structural" not in traits or e.mentioned)


def _last_two_alike(world: World) -> list[str]:
    """The subjects of the clauses before, if they are of one kind ("and both brake")."""
    last = [ids[0] for ids in world.subjects[-4:] if len(ids) == 1 and ids[0] in world.entities]
    two = list(dict.fromkeys(reversed(last)))[:2][::-1]
    if len(two) < 2 or len(world.subjects[-1]) > 1:
        return []
    one, other = (world.entities[i] for i in two)
    return two if one.noun == other.noun and (one.group is None or other.group is None) else []


def _anything_else(world: World, avoid: list[str]) -> bool:
    """Whether the prompt named something that moves, which "it" rather means."""
    return any(
        e.movable and e.noun.kind not in ("person", *_WAYS)
        for ids in world.salience[-4:]
        for i in ids
        if i not in avoid and (e := world.entities.get(i)) is not None
    )


def of_other_gender(word: str, head: str) -> bool:
    """Whether "he" or "she" is no word for somebody called a woman or a boy."""
    female = head in _SHE or head.endswith("woman")
    male = head in _HE or (head.endswith("man") and not female)
    return female if word in ("he", "him", "himself") else male and word in _HERS


def _named_by_no_person(world: World, word: str, subject: bool, avoid: list[str]) -> list[str]:
    """What "he" or "him" means where no known person was named.

    That is a thing with an unknown name, which is a person from now on; else an animal or a robot;
    else a vehicle ("overtakes him").
    """
    sets = [*world.salience, *(world.subjects if subject else ())]
    lone = [ids[0] for ids in reversed(sets) if len(ids) == 1 and ids[0] not in avoid]
    alone = [world.entities[i] for i in lone if i in world.entities]
    for e in alone:
        if e.noun.kind == "generic" and not e.known and e.group is None:
            e.noun, e.known = lex.nouns()["person"], True
            return [e.id]
    beings = [e for e in alone if e.noun.kind in _BEINGS]
    driven = [e for e in alone if e.noun.kind in _DRIVEN and word != "she"]
    return [e.id for e in (beings or driven)[:1]]
