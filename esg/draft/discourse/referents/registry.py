"""The objects of a scene by node id: creation, counts, groups, stated properties."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import FRONT, REAR, Entity, slug, unknown_noun
from esg.draft.discourse.referents.matching import same_kind
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.referents.sizes import HOLLOW, holding, inclined, sized
from esg.draft.discourse.referents.surroundings import noun_here
from esg.draft.discourse.referents.toys import as_toy
from esg.draft.grammar.rewrites.shares import dealt
from esg.draft.text.elements import Mention
from esg.draft.text.quantities import Amount

_NAMED_GROUPS = lex.word_set("named groups")
_PEOPLE = re.compile(r"(?:man|men|woman|women|person|ist|player|keeper|worker|driver|officer)$")
"""Endings of nouns for people."""
LARGEST_CM, LIGHTEST_KG = 9000.0, 1e-3
MAX_COUNT = 40
"""Most members of one lex.plural."""

_TWINS = lex.word_set("twins")


def new_id(world: World, stem: str) -> str:
    n = 1
    while f"{stem}_{n}" in world.entities:
        n += 1
    return f"{stem}_{n}"


def add_entity(
    world: World,
    noun: lex.Noun,
    head: str,
    *,
    adjectives: list[str] | None = None,
    letter: str = "",
    label: str = "",
    group: str | None = None,
    pattern: str | None = None,
    mentioned: bool = True,
    known: bool = True,
    origin: int = -1,
) -> Entity:
    """Creates one entity with a readable node id."""
    adjectives = list(adjectives or [])
    noun = as_toy(noun, head, adjectives)
    naming = [
        a
        for a in adjectives
        if a in lex.COLORS or a in FRONT or a in REAR or a in lex.ORDINALS or a in ("left", "right")
    ]
    stem = slug(" ".join([*naming, head])) or "object"
    if stem[0].isdigit():
        stem = f"{slug(noun.name)}_{stem}"  # ids become identifiers of emitted code
    if letter:
        name = slug(f"{head}_{letter}")
        name = name if name not in world.entities else new_id(world, name)
    else:
        name = new_id(world, stem)
    entity = Entity(
        name,
        noun,
        head,
        label or head,
        adjectives,
        letter,
        group,
        pattern,
        mentioned,
        known,
        origin=origin,
    )
    for adjective in adjectives:
        place_of(entity, adjective)
    world.entities[name] = entity
    return entity


def place_of(entity: Entity, adjective: str) -> None:
    if adjective in FRONT:
        entity.place = "front"
    elif adjective in REAR:
        entity.place = "rear"
    elif adjective in lex.ORDINALS:
        entity.place = adjective
    elif adjective in ("left", "right", "leftmost", "rightmost"):
        entity.place = adjective[:5].removesuffix("m")


def note_referents(world: World, ids: list[str], subject: bool = False) -> None:
    """Makes a referent set the most salient one."""
    if ids and world.entities[ids[0]].noun.kind != "region":
        world.salience.append(ids)
        if subject:
            world.subjects.append(ids)


def current_id(world: World, name: str) -> str:
    """The id by which an entity goes now, which a later mention may have made more precise."""
    while name not in world.entities and name in world.renamed:
        name = world.renamed[name]
    return name


def rename(world: World, e: Entity, name: str) -> None:
    if name in world.entities:
        return
    old = e.id
    world.entities = {(name if k == old else k): v for k, v in world.entities.items()}
    e.id = name
    world.renamed[old] = name

    def swap(ids: list[str]) -> list[str]:
        return [name if i == old else i for i in ids]

    world.groups = {g: swap(ids) for g, ids in world.groups.items()}
    for ids in [*world.salience, *world.subjects, *world.resolved.values()]:
        ids[:] = swap(ids)


def count_of(world: World, m: Mention, noun: lex.Noun) -> int:
    if m.count is None and m.plural and m.determiner in ("a", "an") and not m.group_word:
        return 1  # "a 50 g dice"
    if m.count is not None:
        if m.count > MAX_COUNT:
            world.warnings.append(
                f'"{m.text}": {MAX_COUNT} of {m.count} are placed, the most a scene holds.'
            )
        return max(1, min(m.count, MAX_COUNT))
    if not m.plural and m.pattern is None:
        return 1
    listed = [a for a in m.amounts if a.shares]
    if m.plural and listed:
        return len(listed[0].shares)  # "2 kg and 3 kg crates"
    if noun.kind == "pin":
        return 10
    if noun.kind == "domino":
        return 8
    return {"row": 5, "stack": 3, "rack": 6, "queue": 3, "pins": 10}.get(
        m.pattern or "", 4 if m.pattern else 3
    )


def pattern_of(m: Mention, noun: lex.Noun, count: int) -> str | None:
    if count <= 1:
        return None
    if noun.kind == "pin" and m.pattern in (None, "scatter", "pins", "rack"):
        return "pins"
    if noun.kind == "domino" and m.pattern is None:
        return "row"
    if m.pattern is None and {"stacked", "piled"} & set(m.adjectives):
        return "stack"
    if m.pattern:
        return m.pattern
    if noun.kind in ("vehicle",):
        return "queue" if count <= 3 else "row"
    if count <= 4 and noun.kind in ("ball", "billiard", "box", "block", "barrel"):
        return "scatter"
    return "scatter"


def enrich(world: World, m: Mention, ids: list[str]) -> None:
    for k, i in enumerate(ids):
        e = world.entities[i]
        _amounts(world, m, e, k, len(ids))
        if e.group is None:
            for a in m.adjectives:
                if a in lex.COLORS and e.color is None:
                    e.adjectives.append(a)


def _amounts(world: World, m: Mention, e: Entity, k: int = 0, number: int = 1) -> None:
    """What a noun phrase says of thing k of a number ("two boys of 30 kg and 40 kg")."""
    said = {part: a.start for a in m.amounts for part in a.shares or (a,)}
    for amount in dealt(m.amounts, number)[k]:
        at = f"@{said[amount]}:"
        word = next((a.split(":")[1] for a in m.adjectives if a.startswith(at)), "")
        apply_amount(world, e, amount, word)


def apply_amount(world: World, e: Entity, amount: Amount, word: str = "") -> str:
    """Applies a mass or size to an entity; returns the field it set or ""."""
    if amount.dimension == "mass":
        if e.mass_prescribed and e.mass_kg is not None and abs(e.mass_kg - amount.middle) > 1e-6:
            world.conflicts.append(f"{e.label} weighs {e.mass_kg:g} kg and {amount.middle:g} kg")
        if amount.middle < LIGHTEST_KG:
            world.warnings.append(
                f'"{amount.text}": the lightest object of a scene has {1e3 * LIGHTEST_KG:g} g.'
            )
        e.mass_kg, e.mass_prescribed = max(amount.middle, LIGHTEST_KG), True
        return "expected_mass_kg"
    if amount.dimension == "length":
        _same_size(world, e, amount, word)
        if amount.middle > LARGEST_CM and "structural" not in e.noun.traits:
            world.warnings.append(
                f'"{amount.text}": the largest object of a scene has {LARGEST_CM / 100:g} m.'
            )
        e.dimensions_cm, e.dimensions_prescribed = sized(e, amount, word), True
        return "expected_dimensions_cm"
    if amount.dimension == "volume" and e.noun.kind in HOLLOW:
        e.dimensions_cm = holding(e, amount.middle)
        return "expected_dimensions_cm"
    if amount.dimension == "angle" and "incline" in e.noun.traits:
        e.dimensions_cm = inclined(e, amount.middle)
        e.dimensions_prescribed = True
        return "expected_dimensions_cm"
    return ""


def _same_size(world: World, e: Entity, amount: Amount, word: str) -> None:
    """Notes a side of which two lengths are stated ("is 2 m tall ... which is 1 m tall")."""
    side = {"tall": "high", "height": "high", "width": "wide", "length": "long"}.get(word, word)
    if side not in ("high", "wide", "long", "diameter", "radius"):
        return
    before = e.sides.setdefault(side, amount.middle)
    if abs(before - amount.middle) > 0.01 * before:
        world.conflicts.append(f"{e.label} is {before:g} cm and {amount.middle:g} cm {side}")


def _ground(world: World, noun: lex.Noun, m: Mention) -> list[str]:
    e = Entity("ground_1", noun, m.head, m.text or m.head, list(m.adjectives), origin=m.start)
    world.entities["ground_1"] = e
    return ["ground_1"]


def create(world: World, m: Mention) -> list[str]:
    if m.noun is None and _PEOPLE.search(m.head):
        m.noun = lex.nouns()["person"]
    noun = m.noun or unknown_noun(m.head)
    if m.group_word == "pair" and m.head in _TWINS:
        m.count, m.plural, m.group_word = None, False, ""  # "a pair of scissors" is one thing
    named, movers = list(world.entities.values()), movers_of(world)
    noun = noun_here(m, noun, named, movers, net_sport=world.net_sport)
    if "structural" in noun.traits and "decal" not in noun.traits:
        return ["ground_1"] if "ground_1" in world.entities else _ground(world, noun, m)
    if m.determiner == "another" or "other" in m.adjectives:
        like = [e for e in world.entities.values() if e.head.split()[-1] == m.head and e.known]
        if like and like[-1].head != m.head:
            noun, m.head = like[-1].noun, like[-1].head  # "a curling stone ... another stone"
    plain = [a for a in m.adjectives if not a.startswith("@")]
    if m.letters:
        return [letter_of(world, m, x) for x in m.letters]
    count = count_of(world, m, noun)
    pattern = pattern_of(m, noun, count)
    if "structural" in noun.traits:
        count = 1
    if count <= 1:
        e = add_entity(
            world,
            noun,
            m.head,
            adjectives=plain,
            label=m.text or m.head,
            known=m.noun is not None,
            origin=m.start,
        )
        _amounts(world, m, e)
        return [e.id]
    group = slug(" ".join([*[a for a in plain if a in lex.COLORS], lex.plural(m.head)]))
    base = group
    n = 2
    while group in world.groups:
        group, n = f"{base}_{n}", n + 1
    ids: list[str] = []
    for k in range(count):
        label = (
            f"{m.group_word} of {lex.plural(m.head)}" if m.group_word in _NAMED_GROUPS else m.head
        )
        e = add_entity(
            world,
            noun,
            m.head,
            adjectives=plain,
            label=label,
            group=group,
            pattern=pattern,
            known=m.noun is not None,
            origin=m.start,
        )
        _amounts(world, m, e, k, count)
        ids.append(e.id)
    world.groups[group] = ids
    if m.count is None or m.vague:
        world.vague.add(group)
    if m.group_word and m.group_word not in ("pair", "couple", "number", "lot", "dozen"):
        world.collective.add(group)
        world.group_words[group] = m.group_word
    if world.file_of_two and count == 2:
        world.file_of_two = False
        for i, place in zip(list(ids), ("front", "rear"), strict=True):
            e = world.entities[i]
            e.place, e.label = place, f"{place} {m.head}"
            e.adjectives.append(place)
            rename(world, e, new_id(world, slug(e.label)))
    return list(world.groups[group])


def movers_of(world: World) -> list[Entity]:
    """What the clause is about, as far as it is there."""
    return [world.entities[i] for i in world.movers if i in world.entities]


def letter_of(world: World, m: Mention, letter: str) -> str:
    """Names a member of a lex.plural, or creates the individual."""
    pool = [
        e
        for e in world.entities.values()
        if e.group and not e.letter and same_kind(m, e) and not e.place
    ]
    if pool:
        e = pool[0]
        rename(world, e, slug(f"{m.head}_{letter}"))
        e.letter = letter
        e.label = f"{m.head} {letter}"
        return e.id
    if m.head == "@":
        like = [e for e in world.entities.values() if e.letter]
        if like:
            alike = [e for e in like if e.letter[0] == letter[0] and len(letter) > 1]
            model = (alike or like)[-1]  # "ball A hits ball B; B hits C", "robot R1 ... R2"
            m.noun, m.head = model.noun, model.head
    noun = m.noun or unknown_noun(m.head)
    plain = [a for a in m.adjectives if not a.startswith("@")]
    entity = add_entity(
        world,
        noun,
        m.head,
        adjectives=plain,
        letter=letter,
        label=f"{m.head} {letter}",
        known=m.noun is not None,
        origin=m.start,
    )
    _amounts(world, m, entity)
    return entity.id
