"""Members of plurals, rows and stacks: which one a phrase picks, and the name it gets."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.choices import name_by_place
from esg.draft.discourse.referents.entities import FRONT, OTHER, REAR, Entity, slug
from esg.draft.discourse.referents.matching import HYPERNYMS, matches
from esg.draft.discourse.referents.ranks import extreme, measured, same_quantity
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.referents.registry import new_id, place_of, rename
from esg.draft.text.elements import Mention

_CHILDREN = frozenset({"boy", "girl"})
_PEOPLE = {"child": _CHILDREN, "kid": _CHILDREN, "person": _CHILDREN | {"man", "woman"}}
"""Whom a plural of persons may consist of, told by a definite phrase."""
_SIDES = {"left": 0, "middle": 1, "right": -1}
_LEVELS = {-1: "top", 0: "bottom", 1: "middle"}


def of_stack(world: World, m: Mention, names: list[Entity]) -> list[str]:
    """ "the top crate", "the lowest one": by its level in the stack told last."""
    word = next((a for a in m.adjectives if a in lex.STACKED), None)
    if word is None or m.plural or (m.count or 1) > 1:
        return []
    stacked = [e for e in names if e.group in world.groups and e.pattern == "stack"]
    if not stacked:
        return []
    members = world.groups[stacked[-1].group or ""]
    k = lex.STACKED[word] if lex.STACKED[word] <= 0 else len(members) // 2
    return [name_by_place(world, members[k], _LEVELS[lex.STACKED[word]])]


def by_side(world: World, m: Mention, names: list[Entity]) -> list[str]:
    """ "the crate on the right", "the middle truck": by where it stands in its row."""
    side = next((a for a in m.adjectives if a in _SIDES), "")
    exact = [e.id for e in names if side and e.place == side]
    row = next((world.groups[e.group] for e in reversed(names) if e.group in world.groups), [])
    if exact or not side or len(row) < 2 + (side == "middle"):
        return exact[-1:]
    e = world.entities[row[_SIDES[side] if side != "middle" else len(row) // 2]]
    return [] if e.place or e.letter else [name_by_place(world, e.id, side)]


def counted_from(world: World, m: Mention, names: list[Entity]) -> list[str]:
    """ "the second crate from the left", "the third from the top"."""
    ordinal = next((lex.ORDINALS[a] for a in m.adjectives if a in lex.ORDINALS), 0)
    groups = [e.group for e in names if e.group in world.groups]
    if not groups:
        return []
    members = world.groups[groups[-1] or ""]
    k = ordinal if lex.COUNTED_FROM[m.counted_from] > 0 else len(members) - 1 - ordinal
    if not 0 <= k < len(members):
        return []
    word = next((a for a in m.adjectives if a in lex.ORDINALS), "first")
    for i in members:
        if world.entities[i].pattern in (None, "scatter", "queue"):
            world.entities[i].pattern = "row"
    if lex.COUNTED_FROM[m.counted_from] < 0:
        word = f"{word} last" if ordinal else "last"
    return [name_by_place(world, members[k], word)]


def picked(world: World, m: Mention, ids: list[str]) -> list[str]:
    """ "the first of two barrels": one member, named by its place."""
    if m.pick in lex.STACKED and world.entities[ids[0]].group:
        for i in ids:
            world.entities[i].pattern = "stack"
        like = Mention(m.start, m.end, head=m.head, noun=m.noun, adjectives=[m.pick])
        return of_stack(world, like, [world.entities[i] for i in ids])
    if m.pick in lex.RANKS:
        best = extreme(m.pick, [world.entities[i] for i in ids], world.facts)
        if best is not None:
            return [best.id]  # "the heavier of two crates"
    k = lex.ORDINALS.get(
        m.pick, len(ids) - 1 if m.pick in ("last", "final", "rightmost", "rear") else 0
    )
    entity = world.entities[ids[min(k, len(ids) - 1)]]
    if not entity.place and not entity.letter:
        entity.place, entity.label = m.pick, f"{m.pick} {entity.head}"
        entity.adjectives.append(m.pick)
        rename(world, entity, new_id(world, slug(entity.label)))
    return [entity.id]


def member_of(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "two blue balls ... hits a blue ball": an indefinite that picks a member of a plural."""
    if any(a in OTHER for a in m.adjectives):
        return []
    colors = {lex.COLORS[a] for a in m.adjectives if a in lex.COLORS}
    pool = [
        e
        for e in world.entities.values()
        if e.group
        and e.id not in avoid
        and matches(world, m, e)
        and e.noun == m.noun
        and (same_quantity(m, e, world.facts) or not measured(m))
        and (not colors or e.color in colors)
    ]
    return [pool[0].id] if pool else []


def kind_of_member(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "Two vehicles meet. The truck stops, the bus ...": members told apart by their kind."""
    if m.determiner != "the" or m.plural or m.noun is None or m.adjectives or m.letters:
        return []
    if (m.count or 1) > 1 or m.part or m.attribute or m.possessor is not None:
        return []
    for ids in world.groups.values():
        free = [world.entities[i] for i in ids]
        free = [e for e in free if not (e.place or e.letter) and e.id not in avoid]
        wide = free[0].head if free else ""
        kinds = HYPERNYMS.get(wide, frozenset())
        wider = m.noun.kind in kinds and (wide not in _PEOPLE or m.head in _PEOPLE[wide])
        if len(ids) > 3 or not wider or m.head == wide:
            continue
        e = free[0]
        e.noun, e.head, e.known = m.noun, m.head, True
        e.label = e.place = m.head
        rename(world, e, new_id(world, slug(m.head)))
        return [e.id]
    return []


def specialize(world: World, m: Mention, e: Entity) -> None:
    """A member of a plural gets its own name ("two cars ... the front car")."""
    for a in m.adjectives:
        if not a.startswith("@") and a not in e.adjectives:
            e.adjectives.append(a)
        place_of(e, a)
    e.label = m.text or e.label
    e.place = e.place or next((a for a in m.adjectives if a in lex.COLORS), "")
    keep = [
        a
        for a in m.adjectives
        if a in lex.COLORS or a in FRONT | REAR or a in lex.ORDINALS or a in ("left", "right")
    ]
    if keep:
        rename(world, e, new_id(world, slug(" ".join([*keep, e.head]))))
    others = [x for x in world.groups.get(e.group or "", []) if x != e.id]
    if len(others) == 1 and e.place in ("front", "rear"):
        o = world.entities[others[0]]
        if not o.place:
            o.place = "rear" if e.place == "front" else "front"
            o.label = f"{o.place} {o.head}"
            o.adjectives.append(o.place)
            rename(world, o, new_id(world, slug(o.label)))
