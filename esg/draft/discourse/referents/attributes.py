"""What "the rubber one", "the heavy one" and "the other" pick among the things that are there."""

from __future__ import annotations

from collections.abc import Iterator

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.ranks import extreme
from esg.draft.discourse.referents.record import World, all_rest, is_solid, links
from esg.draft.text.elements import Mention

_ENDS = {
    **dict.fromkeys(("heavy", "weighty"), "heavier"),
    **dict.fromkeys(("light", "lightweight"), "lighter"),
    **dict.fromkeys(("big", "large", "huge", "giant", "enormous"), "bigger"),
    **dict.fromkeys(("small", "little", "tiny"), "smaller"),
    **{"tall": "taller", "high": "taller", "short": "shorter", "long": "longer"},
    **dict.fromkeys(("wide", "thick", "broad"), "wider"),
    **dict.fromkeys(("narrow", "thin"), "narrower"),
    **{word: word for word in lex.RANKS},
}
"""Adjectives that pick the one at an end of what they measure, as their comparatives do."""
_ROUND, _ANGULAR = frozenset({"round"}), frozenset({"square", "angular", "cubic"})


def told_by(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """The things that have the attributes a phrase without a noun tells them by.

    Args:
        world: The referents so far.
        m: "the rubber one", "the heavy ones".
        avoid: Ids that it cannot mean.

    Returns:
        Node ids, the first of them the one named last; none where nothing has all its attributes.
    """
    words = [a for a in m.adjectives if not a.startswith("@")]
    if not words or m.determiner not in ("the", "this", "that", "these", "those", ""):
        return []
    for things in _pools(world, avoid):
        for word in words:
            things = _having(world, word, things)
        if things:
            return [e.id for e in things]
    return []


def other_of_two(world: World, avoid: list[str]) -> list[str]:
    """ "A cube and a ball ... the ball rolls off, the other stays": of two told together."""
    used = {*avoid}
    for ids in reversed(world.salience):
        two = [i for i in dict.fromkeys(ids) if is_solid(world, i)]
        if len(two) == 2 and len(used & {*two}) == 1:
            return [i for i in two if i not in used]
        if len(two) > 1 and not all_rest(world, two):
            return []
        used |= {*two}
    return []


def _pools(world: World, avoid: list[str]) -> Iterator[list[Entity]]:
    """What may be meant: those told of together last, those of one kind, all that may move."""
    told = [ids for ids in reversed(world.salience) if len({*ids}) > 1 and not links(world, ids)]
    for ids in told[:1]:
        yield [world.entities[i] for i in dict.fromkeys(ids) if is_solid(world, i)]
    named = [i for ids in reversed(world.salience) for i in ids if is_solid(world, i)]
    near = [world.entities[i] for i in dict.fromkeys(named) if i not in avoid]
    kinds = [e.noun.name for e in near]
    alike = [e for e in near if kinds.count(e.noun.name) > 1]
    if alike:
        yield alike
    yield [e for e in near if not {"fixed", "support"} & e.noun.traits]


def _having(world: World, word: str, things: list[Entity]) -> list[Entity]:
    """Those of some things that have an attribute; by words first, then by what they are."""
    color = lex.COLORS.get(word)
    said = [e for e in things if word in _words_of(e) or (color and e.color == color)]
    if said:
        return said
    if word in lex.MATERIALS:
        return [e for e in things if _material(e) == lex.MATERIALS[word][0]]
    if word in _ROUND | _ANGULAR:
        round_ = [e for e in things if e.noun.shape == "sphere" or "round" in e.noun.traits]
        return round_ if word in _ROUND else [e for e in things if e.noun.shape == "box"]
    if word not in _ENDS or len(things) < 2:
        return []
    fit = [e for e in things if not _opposite(e, _ENDS[word])]
    end = extreme(_ENDS[word], things, world.facts)
    if end is None and len(fit) == len(things) and all(e.group for e in things):
        free = [e for e in things if not _ENDS.keys() & {*e.adjectives}]
        end = (free or things)[0]  # "Two boxes ... the small one": only this tells them apart
        end.adjectives.append(word)
    if end is None and len(fit) == 1 and len(things) == 2:
        return fit  # "the smaller in front of the larger"
    return [end] if end is not None and end in fit else []


def _opposite(e: Entity, end: str) -> bool:
    """Whether a thing is said to be at the other end: small, where the bigger one is asked for."""
    quantity, sign = lex.RANKS[end]
    told = [lex.RANKS[_ENDS[a]] for a in e.adjectives if a in _ENDS]
    return any(q == quantity and s != sign for q, s in told)


def _words_of(e: Entity) -> set[str]:
    return {*e.adjectives, *e.label.lower().split(), *e.head.lower().split()}


def _material(e: Entity) -> str:
    """What a thing is made of: as its words say, else as its kind is."""
    said = [w for w in (*e.adjectives, *e.head.lower().split()) if w in lex.MATERIALS]
    return lex.MATERIALS[said[0]][0] if said else e.noun.material
