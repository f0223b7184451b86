"""Which of several "one", "the other", "the second" and "the heavier one" mean."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.contrasts import contrasting
from esg.draft.discourse.referents.entities import FRONT, REAR, Entity, slug
from esg.draft.discourse.referents.matching import same_kind
from esg.draft.discourse.referents.ranks import extreme, rank, same_quantity
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.referents.registry import add_entity, current_id, new_id, rename
from esg.draft.grammar.rewrites.positions import NEIGHBOUR
from esg.draft.text.elements import Mention


def one_more(world: World, like: Entity, words: list[str], m: Mention) -> list[str]:
    """Another thing of a kind that is there, told apart by the phrase's words."""
    label = " ".join([*words, like.head])
    e = add_entity(
        world, like.noun, like.head, adjectives=words, label=label, known=like.known, origin=m.start
    )
    return [e.id]


def name_by_place(world: World, name: str, place: str) -> str:
    """Gives a member of a row or stack the name of its place; returns its id."""
    e = world.entities[name]
    if not e.letter and (not e.place or e.place in lex.STACKED) and e.place != place:
        e.place, e.label = place, f"{place} {e.head}"
        e.adjectives.append(place)
        rename(world, e, new_id(world, slug(e.label)))
    return e.id


def _neighbour(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "the one in front (of it)": the next one of its row, the other one, or one more."""
    last = next((ids for ids in reversed(world.salience) if len(ids) == 1), [])
    anchor = world.entities.get((avoid or last or [""])[0])
    place = next((a for a in m.adjectives if a in ("front", "rear")), "")
    if anchor is None or not place or "structural" in anchor.noun.traits:
        return []
    row = world.groups.get(anchor.group or "", [])
    if row:
        ahead = {"front": 0, "rear": len(row) - 1}.get(anchor.place, row.index(anchor.id))
        k = ahead + (-1 if place == "front" else 1)
        return [row[k]] if 0 <= k < len(row) else [row[0] if place == "front" else row[-1]]
    alike = [e.id for e in world.entities.values() if e.noun == anchor.noun and e is not anchor]
    if len(alike) == 1:
        return alike
    where = [e.id for e in world.entities.values() if e.place == place and e is not anchor]
    if where or alike:
        return where[-1:]
    return one_more(world, anchor, [place], m)


def middle_of(world: World) -> list[str]:
    """ "the middle one": of the row told last."""
    row = next((g for g in reversed(list(world.groups.values())) if len(g) > 2), [])
    if not row or world.entities[row[0]].pattern == "stack":
        return []
    return [name_by_place(world, row[len(row) // 2], "middle")]


def _another_like(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "The first runner falls, the second ...", "a blue car ... the red one", "the yellow"."""
    colors = [a for a in m.adjectives if a in lex.COLORS]
    ordinal = next((a for a in m.adjectives if a in lex.ORDINALS), None)
    solid = [
        e for e in reversed(list(world.entities.values())) if "structural" not in e.noun.traits
    ]
    model = None
    if colors and not any(e.group and e.color is None for e in solid):
        balls = [e for e in solid if e.noun.kind == "billiard"]
        tinted = [e for e in solid if e.color is not None]
        model = next(iter(balls or tinted), None)
        if world.billiards or (model is not None and model.noun.kind == "billiard"):
            label = f"{colors[0]} ball"
            ball = lex.nouns()["billiard ball"]
            return [
                add_entity(world, ball, "ball", adjectives=colors, label=label, origin=m.start).id
            ]
        if model is None and m.adjectives == colors:  # "Red knocks blue away"
            ball = lex.nouns()["ball"]
            label = f"{colors[0]} ball"
            return [
                add_entity(world, ball, "ball", adjectives=colors, label=label, origin=m.start).id
            ]
    elif ordinal is not None and (one := _single_before(world, ordinal)) is not None:
        model = one  # "the first coach changes horses, the second one passes it"
    elif ordinal is not None and _beyond_last(world, ordinal):
        model = world.entities[next(reversed(list(world.groups.values())))[0]]
    elif ordinal is not None and not any(e.group for e in solid):
        model = next((e for e in solid if e.place in lex.ORDINALS and e.place != ordinal), None)
    if model is None or (model.id in avoid and not ordinal and model.color is None):
        return []
    return one_more(world, model, [ordinal] if ordinal else colors, m)


def ranked(world: World, m: Mention, things: list[Entity], avoid: list[str]) -> list[str]:
    """ "the heavier one", "the tallest bottle": by what is known of sizes, masses, speeds."""
    word = rank(m)
    best = extreme(word, things, world.facts) if word else None
    if best is None and word and len(things) == 2 and things[0].group:
        end = lex.RANKS[word]  # "the smaller one turns, but the larger one scrapes it"
        other = world.ends.get((end[0], -end[1]), "")
        taken = {*avoid, current_id(world, other) if other else ""}
        free = [e for e in things if e.id not in taken] or things
        best = world.entities.get(current_id(world, world.ends.setdefault(end, free[0].id)))
    return [best.id] if best is not None else []


def comparable_with(world: World, avoid: list[str]) -> list[Entity]:
    """What "the heavier one" may be: the plural told last, else two things of one kind, else
    whatever can move.
    """
    group = next(reversed(list(world.groups.values())), [])
    told = dict.fromkeys(i for ids in world.salience for i in ids if i not in avoid)
    recent = [world.entities[i] for i in told if i in world.entities]
    alike = [e for e in recent if sum(e.noun == x.noun for x in recent) > 1]
    movable = [e for e in recent if e.movable]
    return [world.entities[i] for i in group] or alike or movable


def _single_before(world: World, ordinal: str) -> Entity | None:
    """A thing of no plural that the prompt called "the first", before its like."""
    placed = [e for e in world.entities.values() if e.place in lex.ORDINALS and e.group is None]
    before = [e for e in placed if e.place != ordinal]
    return before[-1] if before and len(before) == len(placed) else None


def _beyond_last(world: World, ordinal: str) -> bool:
    """ "passes three gates and hits the fourth": one more than the plural has."""
    group = next(reversed(list(world.groups.values())), [])
    return ordinal in lex.ORDINALS and len(group) > 1 and lex.ORDINALS[ordinal] == len(group)


def one_of(world: World, m: Mention, avoid: list[str]) -> list[str]:
    if NEIGHBOUR in m.adjectives and (near := _neighbour(world, m, avoid)):
        return near
    if "middle" in m.adjectives and (mid := middle_of(world)):
        return mid
    comparable = comparable_with(world, avoid)
    if found := ranked(world, m, comparable, avoid):
        return found
    if heavy := [e.id for e in comparable if same_quantity(m, e, world.facts)]:
        return heavy[:1]  # "the 5 kg one"
    same, unlike = contrasting(m, world.entities.values())
    if same and same not in avoid:
        return [same]
    if unlike is not None:  # "the heavy book hits the light one"
        return one_more(world, unlike, [a for a in m.adjectives if not a.startswith("@")], m)
    for a in m.adjectives:
        for group in reversed(list(world.groups.values())):
            for i in group:
                e = world.entities[i]
                if (a in lex.COLORS and e.color == lex.COLORS[a]) or e.place == a:
                    return [i]
    for a in m.adjectives:
        if a in lex.COLORS:
            for e in reversed(list(world.entities.values())):
                if e.color == lex.COLORS[a]:
                    return [e.id]
    side = next((a for a in m.adjectives if a in ("left", "right")), "")
    group = next(reversed(list(world.groups.values())), [])
    mates = [i for i in group if i not in avoid and not world.entities[i].place]
    if side and mates and len(group) <= 3:
        # "the left one ... the right one"
        chosen = world.entities[mates[0 if side == "left" else -1]]
        chosen.place, chosen.label = side, f"{side} {chosen.head}"
        rename(world, chosen, new_id(world, slug(chosen.label)))
        return [chosen.id]
    end = next((a for a in m.adjectives if a in FRONT | REAR), "")
    if end and 2 <= len(group) <= 12:
        where = "front" if end in FRONT else "rear"
        chosen = world.entities[group[0] if end in FRONT else group[-1]]
        if chosen.place in ("", where):
            chosen.place, chosen.label = where, f"{where} {chosen.head}"
            rename(world, chosen, new_id(world, slug(chosen.label)))
            return [chosen.id]  # "the rear one ... the front one"
    if end and not group:
        fore = FRONT if end in REAR else REAR
        like = [e for e in world.entities.values() if fore & {e.place, *e.adjectives}]
        if like and not any(e.place == end for e in world.entities.values()):
            return one_more(world, like[-1], [end], m)
    if "next" in m.adjectives and not world.groups:
        solid = [e for e in world.entities.values() if "structural" not in e.noun.traits]
        before = avoid or (world.subjects[-1] if world.subjects else [])
        last = next((ids for ids in reversed(world.salience) if not set(ids) <= {*before}), [])
        alone = len(last) == 1 and last[0] in world.entities and bool(before)
        passed = alone and world.entities[last[0]].label.lower().startswith("one ")
        kinds = ("person", "animal", "vehicle", "flyer", "watercraft", "robot", "toyvehicle")
        if passed or (alone and world.entities[before[0]].noun.kind in kinds):
            before = last  # "past one table, brushes against the next"
        model = [e for e in solid if e.id in before[:1]]
        if solid:  # "A domino falls and hits the next one", "One ball ..., the next one ..."
            return one_more(world, (model or solid)[-1], ["next"], m)
    fresh = _another_like(world, m, avoid)
    if fresh:
        return fresh
    last_group = next(reversed(list(world.groups.values())), None)
    own = next((world.entities[i].group for i in avoid if world.entities[i].group), None)
    if own in world.groups and "next" in m.adjectives:
        mates = world.groups[own]  # "the first domino hits the next": of its own row
        k = max((mates.index(i) for i in avoid if i in mates), default=0)
        return mates[k + 1 : k + 2] or mates[-1:]
    colors = [a for a in m.adjectives if a in lex.COLORS]
    if colors and last_group:
        plain = [
            world.entities[i]
            for i in last_group
            if world.entities[i].color is None and i not in avoid
        ]
        if plain:
            chosen = plain[0]
            chosen.adjectives.append(colors[0])
            chosen.label = f"{colors[0]} {chosen.head}"
            chosen.place = chosen.place or colors[0]
            rename(world, chosen, new_id(world, slug(chosen.label)))
            return [chosen.id]
    ordinal = next((a for a in m.adjectives if a in lex.ORDINALS or a == "last"), None)
    if last_group and avoid and any(a.endswith("er") for a in m.adjectives):
        mates = [i for i in last_group if i not in avoid]
        if mates and "other" not in m.adjectives:
            return mates[:1]  # "the heavier crate ... the lighter one"
    if set(lex.STACKED) & set(m.adjectives):
        stacks = [g for g in world.groups.values() if world.entities[g[0]].pattern == "stack"]
        level = world.of_stack(m, [world.entities[i] for i in stacks[-1]]) if stacks else []
        if level:
            return level
    if last_group and "next" in m.adjectives:
        return last_group[1:2]
    if last_group:
        if m.pronoun == "one" and m.determiner == "the" and "other" in m.adjectives and not avoid:
            return [last_group[-1]]
        if ordinal is not None:
            model = world.entities[last_group[0]]
            return ordinal_of(
                world, Mention(m.start, m.end, head=model.head, noun=model.noun), ordinal
            )
        if "other" in m.adjectives and set(last_group) <= set(avoid):
            return [last_group[-1]]
        if "other" in m.adjectives or m.pronoun in ("other", "another"):
            used = list(avoid or (world.salience[-1] if world.salience else []))
            if not set(used) & set(last_group):  # "hits the left one. A second stone hits ..."
                told = (x[0] for x in reversed(world.salience) if len(x) == 1)
                used += [i for i in told if i in last_group][:1]
            rest = [i for i in last_group if i not in used]
            return rest[:1]
        if m.pronoun == "one":
            return [last_group[0]]
    recent = [i for ids in reversed(world.salience) for i in reversed(ids) if i not in avoid]
    return recent[:1]


def ordinal_of(world: World, m: Mention, ordinal: str) -> list[str]:
    names = [e for e in world.entities.values() if same_kind(m, e)]
    exact = [e for e in names if e.place == ordinal]
    if exact:
        return [exact[0].id]
    grouped = [e for e in names if e.group]
    pool = grouped or names
    k = len(pool) - 1 if ordinal in ("last", "final") else lex.ORDINALS[ordinal]
    if ordinal not in lex.ORDINALS and not grouped and all(e.place for e in pool[-1:]):
        return []  # "the front car brakes ... the last car hits it"
    if ordinal in lex.ORDINALS and not grouped:
        # "a ball ... the second ball": the first is the one already there
        taken = [e for e in pool if e.place in ("", "first")]
        if ordinal == "first" and taken:
            return [taken[0].id]
        alike = [e for e in pool if e.head == m.head and e.place in ("", "first")]
        k = lex.ORDINALS[ordinal]
        return [alike[k].id] if 0 < k < len(alike) else []
    if 0 <= k < len(pool):
        e = pool[k]
        if not e.letter and len(grouped) <= 6:
            e.place = ordinal
            e.label = f"{ordinal} {m.head}"
            e.adjectives.append(ordinal)
            rename(world, e, new_id(world, slug(f"{ordinal} {m.head}")))
        return [e.id]
    return []
