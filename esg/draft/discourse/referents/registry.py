"""The objects of a scene by node id: creation, counts, groups, stated properties."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import count

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import PLACES, Entity, slug
from esg.draft.discourse.referents.likeness import unknown_noun
from esg.draft.discourse.referents.matching import ONLY_ONE, same_kind
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.referents.sizes import HOLLOW, holding, inclined, sized
from esg.draft.discourse.referents.slopes import as_slope
from esg.draft.discourse.referents.surroundings import noun_here
from esg.draft.discourse.referents.toys import as_toy
from esg.draft.grammar.rewrites.shares import dealt
from esg.draft.text.elements import Mention
from esg.draft.text.quantities import Amount
from esg.lexicon import plural

_NAMED_GROUPS = lex.word_set("named groups")
_NO_NAMES = frozenset({"", "pair", "couple", "number", "lot", "dozen"})
_TWINS = lex.word_set("twins")
LARGEST_CM, LIGHTEST_KG = 9000.0, 1e-3
MAX_COUNT = 40
"""Most members of one plural."""
_FLIGHTS, _STEPS = (
    frozenset({"stairs", "staircase"}),
    frozenset({"step", "steps", "stair", "stairs"}),
)
_RISE_CM, _GOING_CM, _MOST_STEPS = 17.0, 37.0, 12
"""Of a flight of so many steps, its landing included (`stairs` of the parametric library)."""
_USUAL = {"pin": 10, "domino": 8}
_USUAL_IN = {"row": 5, "stack": 3, "rack": 6, "queue": 3, "pins": 10, "": 3}
"""Members of a plural without a number, by kind and by arrangement."""
_NAMING = frozenset({"front", "rear", "left", "right"}) | lex.ORDINALS.keys()
"""Places that are part of a name from the first."""


def unique(base: str, used: Iterable[str]) -> str:
    """A name that is not used yet: with a number, if need be."""
    taken, name, n = set(used), base, 2
    while name in taken:
        name, n = f"{base}_{n}", n + 1
    return name


def new_id(world: World, stem: str) -> str:
    """The first id with a number that is free."""
    return next(i for n in count(1) if (i := f"{stem}_{n}") not in world.entities)


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
    words = list(adjectives or [])
    noun = as_slope(as_toy(noun, head, words), head, words)
    places = {a: p for a in words if (p := PLACES.get(a, a)) in _NAMING and a != "head"}
    telling = [a for a in words if a in lex.COLORS or a in places or a in ONLY_ONE]
    stem = slug(" ".join([*telling, head])) or "object"
    if stem[0].isdigit():
        stem = f"{slug(noun.name)}_{stem}"  # ids become identifiers of emitted code
    lettered = slug(f"{head}_{letter}") if letter else ""
    free = lettered and lettered not in world.entities
    name = lettered if free else new_id(world, lettered or stem)
    entity = Entity(
        name, noun, head, label or head, words, letter, group, pattern, mentioned, known,
        origin=origin, place=next(reversed(places.values()), ""),
    )  # fmt: skip
    world.entities[name] = entity
    return entity


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


def _count(world: World, m: Mention, noun: lex.Noun) -> int:
    """How many things a phrase names; a usual number where it gives none."""
    one = m.plural and m.determiner in ("a", "an") and not m.group_word  # "a 50 g dice"
    mass = m.head in lex.SUBSTANCES and m.text.lower().split()[-1:] == [m.head]
    if mass and (m.vague or m.group_word):
        return 1  # "some water", "a pile of hay"
    if m.count is not None:
        if m.count > MAX_COUNT:
            world.warnings.append(
                f'"{m.text}": {MAX_COUNT} of {m.count} are placed, the most a scene holds.'
            )
        return max(1, min(m.count, MAX_COUNT))
    if one or "structural" in noun.traits or (not m.plural and m.pattern is None):
        return 1
    listed = [a for a in m.amounts if a.shares]
    if m.plural and listed:
        return len(listed[0].shares)  # "2 kg and 3 kg crates"
    return _USUAL.get(noun.kind, _USUAL_IN.get(m.pattern or "", 4))


def _steps(m: Mention, noun: lex.Noun) -> int:
    """ "Up three steps": so many of one flight; 0 for stairs that are not counted so."""
    counted = noun.name in _FLIGHTS and m.head in _STEPS and m.after_prep in ("up", "down")
    return m.count or 0 if counted and 2 <= (m.count or 0) <= _MOST_STEPS else 0


def _pattern(m: Mention, noun: lex.Noun, number: int) -> str | None:
    """How the members of a plural stand."""
    if number <= 1:
        return None
    if noun.kind == "pin" and m.pattern in (None, "scatter", "pins", "rack"):
        return "pins"
    if m.pattern is None and {"stacked", "piled"} & {*m.adjectives}:
        return "stack"
    if m.pattern:
        return m.pattern
    if noun.kind == "vehicle":
        return "queue" if number <= 3 else "row"
    return "row" if noun.kind == "domino" else "scatter"


def enrich(world: World, m: Mention, ids: list[str]) -> None:
    """Applies what a phrase states of things of a number ("two boys of 30 kg and 40 kg")."""
    said = {part: a.start for a in m.amounts for part in a.shares or (a,)}
    for i, amounts in zip(ids, dealt(m.amounts, len(ids)), strict=False):
        for amount in amounts:
            at = f"@{said[amount]}:"
            word = next((a.split(":")[1] for a in m.adjectives if a.startswith(at)), "")
            apply_amount(world, world.entities[i], amount, word)


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


def create(world: World, m: Mention) -> list[str]:
    """The new things that a phrase names; their ids."""
    if m.group_word == "pair" and m.head in _TWINS:
        m.count, m.plural, m.group_word = None, False, ""  # "a pair of scissors" is one thing
    noun = m.noun or unknown_noun(m.head, m.adjectives)
    named = list(world.entities.values())
    noun = noun_here(
        m, noun, named, movers_of(world), net_sport=world.net_sport, cricket=world.cricket
    )
    if "structural" in noun.traits and "decal" not in noun.traits:
        ground = Entity("ground_1", noun, m.head, m.text or m.head, [*m.adjectives], origin=m.start)
        return [world.entities.setdefault("ground_1", ground).id]
    if m.determiner == "another" or "other" in m.adjectives:
        like = [e for e in named if e.head.split()[-1] == m.head and e.known]
        if like:
            noun, m.head = like[-1].noun, like[-1].head  # "a curling stone ... another stone"
    if m.letters:
        return [letter_of(world, m, x) for x in m.letters]
    steps = _steps(m, noun)
    number = 1 if steps else _count(world, m, noun)
    plain = [a for a in m.adjectives if not a.startswith("@")]
    group, label = None, (m.text or m.head).removesuffix(f" {m.part}")
    if number > 1:
        words = [*[a for a in plain if a in lex.COLORS], plural(m.head)]
        group, label = unique(slug(" ".join(words)), world.groups), m.head
        if m.group_word in _NAMED_GROUPS or (m.group_word and " of " not in m.text):
            label = f"{m.group_word} of {plural(m.head)}"
    ids = [
        add_entity(
            world, noun, m.head, adjectives=plain, label=label, group=group,
            pattern=_pattern(m, noun, number), known=m.noun is not None, origin=m.start,
        ).id
        for _ in range(number)
    ]  # fmt: skip
    enrich(world, m, ids)
    if steps:
        flight = world.entities[ids[0]]
        flight.dimensions_cm = [steps * _GOING_CM, noun.dimensions_cm[1], steps * _RISE_CM]
        flight.dimensions_prescribed = True
    if group is None:
        only = world.entities[ids[0]]
        only.one, only.given = m.count == 1, m.determiner == "the"
        return ids
    world.groups[group] = ids
    if m.count is None or m.vague:
        world.vague.add(group)
    if m.group_word not in _NO_NAMES:
        world.collective.add(group)
        world.group_words[group] = m.group_word
    return list(ids)


def movers_of(world: World) -> list[Entity]:
    """What the clause is about, as far as it is there."""
    return [world.entities[i] for i in world.movers if i in world.entities]


def letter_of(world: World, m: Mention, letter: str) -> str:
    """Names a member of a plural, or creates the individual."""
    free = [e for e in world.entities.values() if e.group and not e.letter and not e.place]
    pool = [e for e in free if same_kind(m, e)]
    if pool:
        e = pool[0]
        rename(world, e, slug(f"{m.head}_{letter}"))
        e.letter, e.label = letter, f"{m.head} {letter}"
        return e.id
    like = [e for e in world.entities.values() if e.letter]
    if m.head == "@" and like:
        alike = [e for e in like if e.letter[0] == letter[0] and len(letter) > 1]
        model = (alike or like)[-1]  # "ball A hits ball B; B hits C", "robot R1 ... R2"
        m.noun, m.head = model.noun, model.head
    noun, known = m.noun or unknown_noun(m.head, m.adjectives), m.noun is not None
    plain = [a for a in m.adjectives if not a.startswith("@")]
    entity = add_entity(
        world, noun, m.head, adjectives=plain, letter=letter, label=f"{m.head} {letter}",
        known=known, origin=m.start,
    )  # fmt: skip
    enrich(world, m, [entity.id])
    return entity.id
