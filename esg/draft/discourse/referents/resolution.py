"""Discourse: which object each noun phrase and pronoun means."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.choices import ordinal_of, ranked
from esg.draft.discourse.referents.entities import FRONT, REAR, Entity
from esg.draft.discourse.referents.matching import matches, same_kind
from esg.draft.discourse.referents.members import (
    by_side,
    counted_from,
    kind_of_member,
    member_of,
    of_stack,
    picked,
    specialize,
)
from esg.draft.discourse.referents.pronouns import pronoun
from esg.draft.discourse.referents.ranks import measured, same_quantity
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.referents.registry import (
    create,
    current_id,
    enrich,
    letter_of,
    movers_of,
    note_referents,
)
from esg.draft.discourse.referents.surroundings import about_golf
from esg.draft.discourse.referents.wholes import compound, own_vehicle, owns, whole_of
from esg.draft.text.elements import Mention

_DURING = lex.word_set("during")
_SCENES = lex.word_set("scenes")
_ON_THE_GREEN = lex.word_set("on the green")
_STACKS = lex.word_set("stacks (resolution)")
_BEHIND_THE_HEAD = 4
"""Index of the pin straight behind the first one of a triangle (1, 2-3, 4-5-6)."""


def new_world() -> World:
    """A world in which nothing has been named."""
    world = World(
        facts=lambda node: [],
        resolve=lambda m, *, subject=False, avoid=None: resolve(
            world, m, subject=subject, avoid=avoid
        ),
        of_stack=lambda m, names: of_stack(world, m, names),
    )
    return world


def resolve(
    world: World, m: Mention, *, subject: bool = False, avoid: list[str] | None = None
) -> list[str]:
    """Node ids of a mention (and of what is coordinated with it); new objects are created.

    Args:
        m: The noun phrase.
        subject: Whether it is a grammatical subject (pronouns prefer the last subject then).
        avoid: Ids that it cannot mean (the subject of its own clause).
    """
    key = id(m)
    if key in world.resolved:
        ids = world.resolved[key]
    else:
        ids = resolve_one(world, m, subject, avoid or [])
        if m.pick and len(ids) > 1:
            ids = picked(world, m, ids)
        elif m.single and len(ids) > 1:
            ids = ids[:1]
        elif m.subset and len(ids) > m.subset:
            ids = ids[: m.subset]
        for other in m.coordinated:
            if other.pronoun == "another" and m.text.lower().startswith("one "):
                note_referents(world, ids)  # "hits one tin, then another"
            extra = resolve(world, other, avoid=avoid)
            ids = ids + [e for e in extra if e not in ids]
        world.resolved[key] = ids
        m.entities = ids
    ids[:] = [current_id(world, i) for i in ids]  # of which another mention may have told more
    note_referents(world, ids, subject)
    return ids


def resolve_one(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    told = any(a.endswith("ing") for a in m.adjectives)  # "the chasing group": another one
    named = m.attribute and m.head in lex.GROUP_WORDS and not told
    if named and m.determiner in ("the", "this", "that"):
        whole = next(reversed(list(world.groups.values())), None)  # "the stack collapses"
        if whole is not None:
            return list(whole)
    whole = set(m.adjectives) <= {"whole", "entire"}
    if m.determiner in ("the", "this", "that") and whole and not m.letters:
        named = [g for g, word in world.group_words.items() if word == m.head]
        if m.head in _STACKS:  # "three blocks are stacked, and the tower is hit"
            named = named or [
                g for g, ids in world.groups.items() if world.entities[ids[0]].pattern == "stack"
            ]
        if named and all(e.head != m.head for e in world.entities.values()):
            return list(world.groups[named[-1]])  # "a tower of cups ... the tower"
    if world.billiards and m.head in ("cushion", "rail"):
        m.attribute = True  # of the billiard table, which every ball touches anyway
        return []
    if world.billiards and m.head == "pool" and not m.determiner and m.after_prep in _DURING:
        m.attribute = True  # "a break shot in pool"
        return []
    if m.noun is None and m.head in _SCENES and m.after_prep in _DURING:
        m.attribute = True  # "collide in a harbor": where it takes place
        return []
    if _arranges(world, m):
        m.attribute = True  # "in a triangle": how a plural stands, no object
        return []
    beside = m.head in ("neighbour", "neighbor") and m.determiner in ("its", "their")
    if beside and avoid and world.entities[avoid[0]].noun.kind != "person":
        m.pronoun, m.adjectives, m.determiner, m.noun = "one", ["next"], "the", None
    if m.head == "leader" and m.determiner == "the" and _of_a_file(world):
        m.pronoun, m.adjectives, m.head, m.noun = "one", ["leading"], "", None
    whole = whole_of(world, m, subject, avoid)
    if whole:
        return whole
    own = m.determiner in ("his", "her", "its", "their")
    if own and m.head in lex.BODY_PARTS and m.noun is None:
        m.attribute = True  # "falls flat on his face"
    if m.attribute or (not m.head and not m.pronoun):
        if m.possessor is not None:
            return resolve(world, m.possessor)
        return []
    if m.count == 0:
        return []
    green = m.pronoun == "one" and m.adjectives == ["green"]
    balls = [e for e in world.entities.values() if e.noun.kind in ("ball", "billiard")]
    golf = about_golf(list(world.entities.values()), movers_of(world)) or (
        balls and all(e.noun.name == "golf ball" for e in balls)
    )
    if green and m.after_prep in _ON_THE_GREEN and golf:
        m.attribute = True  # "bounces on the green": no ball
        return []
    if m.pronoun and m.counted_from:
        whole = next((ids for ids in reversed(world.salience) if len(ids) > 1), [])
        if found := counted_from(world, m, [world.entities[current_id(world, i)] for i in whole]):
            return found
    if m.pronoun:
        found = pronoun(world, m, subject, avoid)
        if (
            m.amounts
            and found
            and not any(
                same_quantity(m, e, world.facts) for e in map(world.entities.__getitem__, found)
            )
        ):
            enrich(world, m, found)  # "the second, 12 cm tall"
        like = world.entities.get(avoid[0]) if len(avoid) == 1 else None
        if not found and m.determiner == "another" and like is not None and like.known:
            copy = Mention(m.start, m.end, head=like.head, noun=like.noun, text=like.head)
            return create(world, copy)  # "hits another one"
        return found
    if m.noun is not None and "structural" in m.noun.traits:
        m.letters = []
    own = own_vehicle(world, m, subject, avoid)
    if own:
        return own
    if m.role and m.noun is not None:
        driven = [
            ids
            for ids in reversed(world.salience)
            if len(ids) == 1
            and world.entities[ids[0]].noun.kind in ("vehicle", "flyer", "cart", "watercraft")
        ]
        if m.possessor is not None:
            return resolve(world, m.possessor)
        ridden = compound(world, m) if m.drives else []
        if ridden:
            return ridden
        if driven and m.determiner != "a":
            return driven[0]
    if m.possessor is not None and not m.attribute and owns(m.possessor):
        resolve(world, m.possessor)  # "the man's hat": the man is there too
    if (
        m.stacked
        and m.noun is not None
        and not any(matches(world, m, e) and e.pattern == "stack" for e in world.entities.values())
    ):
        create(world, 
            Mention(
                m.start, m.end, head=m.head, noun=m.noun, plural=True, pattern="stack",
                group_word="stack", text=m.head,
            )
        )  # fmt: skip
    found = existing_referents(world, m, avoid)
    if found and m.possessor is not None and not m.possessor.pronoun and set(found) <= {*avoid}:
        found = []  # "the police boat follows the smuggler's boat"
    another = bool({"next", "other", "following", "adjacent"} & {*m.adjectives})
    another = another or bool(found and world.entities[found[0]].head != m.head)
    if found and set(found) <= {*avoid} and another:
        found = []  # "a curling stone hits the guard stone": not itself
    if found:
        enrich(world, m, found)
        return found
    return kind_of_member(world, m, avoid) or create(world, m)


def next_in_row(world: World, names: list[Entity], avoid: list[str]) -> list[str]:
    """ "bumps the next wagon": the one after it in its row, else one more."""
    group = next((world.entities[i].group for i in avoid if i in world.entities), None)
    row = world.groups.get(group or "", [])
    k = max((row.index(i) for i in avoid if i in row), default=-1)
    later = [e.id for e in names if e.id in row[k + 1 :]] if row else []
    rest = [e.id for e in names if e.id not in avoid]
    return (later or rest)[:1]


def _arranges(world: World, m: Mention) -> bool:
    """Whether a phrase says how a plural stands ("in a queue") and names nothing itself."""
    if m.after_prep not in ("in", "into") or m.head not in lex.ARRANGEMENTS or m.group_word:
        return False
    if m.determiner not in ("", "a", "an", "one") or m.plural or m.letters:
        return False
    last = world.salience[-1] if world.salience else []
    many = len(last) > 1
    if m.head == "rack":  # bottles stand in a rack of their own
        return many and world.entities[last[0]].noun.kind == "billiard"
    return many or m.head in lex.SHAPES_OF_GROUPS


def _of_a_file(world: World) -> bool:
    """Whether a plural was named that one can lead ("three lorries ... the leader")."""
    whole = next(reversed(list(world.groups.values())), [])
    named = any(e.head == "leader" for e in world.entities.values())
    kinds = ("vehicle", "person", "animal", "watercraft", "flyer", "robot")
    return len(whole) > 1 and not named and world.entities[whole[0]].noun.kind in kinds


def existing_referents(world: World, m: Mention, avoid: list[str]) -> list[str]:
    if (
        (m.determiner in ("a", "an", "one", "any") or (m.count == 1 and not m.determiner))
        and not m.plural
        and not m.letters
        and m.count in (None, 1)
    ):
        return member_of(world, m, avoid)
    definite = m.determiner in (
        "the",
        "this",
        "that",
        "these",
        "those",
        "its",
        "his",
        "her",
        "their",
        "both",
        "all",
        "each",
        "every",
    ) or bool(m.letters)
    structural = m.noun is not None and "structural" in m.noun.traits
    bare = m.determiner == "" and not m.pattern
    if not (definite or structural or bare):
        return []
    if "another" in (m.determiner,) or ("other" in m.adjectives and not definite):
        return []
    names = [e for e in world.entities.values() if matches(world, m, e)]
    if m.letters:
        by_letter = {e.letter: e.id for e in names}
        ids = [by_letter[x] for x in m.letters if x in by_letter]
        missing = [x for x in m.letters if x not in by_letter]
        for x in missing:
            ids.append(letter_of(world, m, x))
        return ids
    if "other" in m.adjectives or "remaining" in m.adjectives:
        last = world.salience[-1] if world.salience else []
        among = {e.id for e in names}
        if not avoid and world.subjects and not m.plural and set(world.subjects[-1]) <= among:
            last = world.subjects[-1]  # "the cone hits another cone, and the other cone ..."
        rest = [e.id for e in names if e.id not in last and e.id not in avoid]
        return rest if m.plural else rest[:1]
    if not m.plural and " " in m.text:
        exact = [e for e in names if e.label.lower() == m.text.lower()]
        names = exact or names  # "a patrol boat ... a sailing boat ... the sailing boat"
    alike = [e for e in world.entities.values() if same_kind(m, e)]
    if m.counted_from and (found := counted_from(world, m, alike)):
        return found
    if not names and definite and len(alike) == 1 and alike[0].id not in avoid and measured(m):
        names = alike  # "A ball weighs 10 kg. The 5 kg ball ...": the same, contradicted
    if "next" in m.adjectives and not m.plural and names:
        return next_in_row(world, names, avoid)
    if found := ranked(world, m, [e for e in names if e.id not in avoid] or names, avoid):
        return found
    if not m.plural:  # "the 2 kg ball hits the 5 kg ball"
        names = [e for e in names if same_quantity(m, e, world.facts)] or names
    ordinal = next((a for a in m.adjectives if a in lex.ORDINALS or a in ("last", "final")), None)
    if ordinal is not None:
        found = ordinal_of(world, m, ordinal)
        if not found and ordinal == "first" and m.noun is not None and m.noun.kind == "domino":
            row = Mention(m.start, m.end, head=m.head, noun=m.noun, plural=True, text=m.head)
            create(world, row)
            found = ordinal_of(world, m, ordinal)
        return found
    level = of_stack(world, m, names)
    if level:
        return level
    place = next((a for a in m.adjectives if a in FRONT | REAR), None)
    pin = m.noun is not None and m.noun.kind == "pin"
    place = "front" if pin and "head" in m.adjectives else place
    if place is not None and not names and pin:
        create(world, Mention(m.start, m.end, head=m.head, noun=m.noun, plural=True))
        names = [e for e in world.entities.values() if matches(world, m, e)]
    if place is not None:
        want = "front" if place in FRONT else "rear"
        exact = [e for e in names if e.place == want]
        if exact:
            return [exact[-1].id]
        member = [e for e in names if e.group is not None and not e.place]
        if member:
            chosen = member[0] if want == "front" else member[-1]
            if want == "rear" and chosen.pattern == "pins" and len(member) > _BEHIND_THE_HEAD:
                rack = world.groups[chosen.group or ""]  # "the head pin ... the pin behind it"
                chosen = world.entities[rack[_BEHIND_THE_HEAD]]
            specialize(world, m, chosen)
            return [chosen.id]
        if bare and not definite:
            return []
        beside = any(w in m.text for w in ("behind", "following", "in front"))
        if beside and names and all(e.group is None and not e.place for e in names):
            return []  # "A car stops. The car behind hits it.": another one
    if definite and not m.plural and (sided := by_side(world, m, names)):
        return sided
    if not names:
        return []
    few = 2 <= len(names) <= 6 and len({e.group for e in names}) == 1 and names[0].group
    every = m.determiner in ("each", "every") and bool(few)
    if m.plural or (m.count or 1) > 1 or every:
        ids = [e.id for e in names]
        groups = {e.group for e in names if e.group}
        if m.count and len(ids) != m.count and len(groups) > 1:
            recent = next((g for g in reversed(list(world.groups)) if g in groups), None)
            if recent is not None and len(world.groups[recent]) == m.count:
                return list(world.groups[recent])
        if m.count and m.count > len(ids) and not definite:
            return []
        if m.count is None and not structural and len(ids) < 2 and (bare or m.group_word):
            return []
        return ids
    if bare and not structural and not definite:
        # a bare singular ("car hits wall") repeats an object only if one is there
        singles = [e for e in names if e.group is None]
        if singles or not (few and {"left", "right"} & {*m.adjectives}):
            return [singles[-1].id] if singles else []
    color = next((a for a in m.adjectives if a in lex.COLORS), None)
    if color is not None:
        exact = [e for e in names if e.color == lex.COLORS[color]]
        if exact:
            return [exact[-1].id]
        member = [e for e in names if e.group is not None and not e.letter]
        counted = bool(member) and member[0].group not in world.vague
        if member and (counted or member[0].noun.kind != "billiard"):
            specialize(world, m, member[0])
            return [member[0].id]
        return []
    order = [i for ids in world.salience for i in ids]
    candidates = [e for e in names if e.id not in avoid] or names
    exact_heads = [e for e in candidates if e.head == m.head or e.noun.name == m.head]
    pool = exact_heads or candidates
    if m.head == "ball" and any(e.noun.kind == "billiard" for e in pool):
        pool = [e for e in pool if not (e.group and e.noun.kind == "billiard")] or pool
    pool.sort(key=lambda e: max((k for k, i in enumerate(order) if i == e.id), default=-1))
    groups = {e.group for e in pool}
    told = [ids[0] for ids in world.salience if len(ids) == 1]
    mate = next((i for i in reversed(told) if i in {e.id for e in pool}), None)
    alone = mate is not None and m.determiner == "the" and not m.adjectives
    if len(pool) > 1 and len(groups) == 1 and None not in groups and alone:
        return [mate] if mate else []  # "a box falls off. The box hits ..."
    if len(pool) > 1 and len(groups) == 1 and None not in groups:
        return [pool[0].id]  # "the head pin"
    return [pool[-1].id]
