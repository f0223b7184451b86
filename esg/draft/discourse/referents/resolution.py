"""Which object each noun phrase means: one of those named so far, or a new one."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import OTHER, Entity
from esg.draft.discourse.referents.matching import CONTRASTS, matches, same_kind, unlike
from esg.draft.discourse.referents.members import (
    at_place,
    beside,
    member_of,
    name_by,
    next_of,
    picked,
    place_word,
    ranked,
)
from esg.draft.discourse.referents.parts import counted_parts
from esg.draft.discourse.referents.pronouns import pronoun
from esg.draft.discourse.referents.ranks import measured, same_quantity
from esg.draft.discourse.referents.record import World, all_rest, last_group, named_alone
from esg.draft.discourse.referents.registry import (
    create,
    current_id,
    enrich,
    letter_of,
    note_referents,
)
from esg.draft.discourse.referents.thinghood import names_nothing
from esg.draft.discourse.referents.wholes import made_of, whole_of
from esg.draft.text.elements import ONE_OF_THESE, Mention

_STACKS = lex.word_set("stacks (resolution)")
_OF_A_TRADE = lex.word_set("of a trade")
_RESTING = lex.word_set("resting (underway)")
_TELLING = _RESTING | {w for words in CONTRASTS for w in words} | lex.COLORS.keys()
"""Adjectives that tell a plural without an article from what is known."""
_THE = ("the", "this", "that")
_ONE = ("a", "an", "one", "any")
_KNOWN = frozenset({*_THE, "these", "those", "its", "his", "her", "their"}) | frozenset(
    {"both", "all", "each", "every"}
)
_NEIGHBOURS = frozenset({"neighbor", "neighbour"})
_LEFT_ALONE = frozenset({"building", "plant", "vehicle"})
"""Kinds of things that are without their owners."""
_DRIVEN = ("vehicle", "flyer", "cart", "watercraft")


def new_world() -> World:
    """A world in which nothing has been named."""

    def means(m: Mention, *, subject: bool = False, avoid: list[str] | None = None) -> list[str]:
        return resolve(world, m, subject=subject, avoid=avoid)

    world = World(facts=lambda node: [], resolve=means)
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
        elif (m.single or m.subset) and len(ids) > 1:
            ids = ids[: m.subset or 1]
        for name in ids if m.wears else ():
            world.entities[name].wears += [put.phrase for put in m.wears]
        for other in m.coordinated:
            extra = resolve(world, other, avoid=avoid)
            ids = ids + [e for e in extra if e not in ids]
        world.resolved[key] = ids
        m.entities = ids
    ids[:] = [current_id(world, i) for i in ids]  # of which another mention may have told more
    note_referents(world, ids, subject)
    return ids


def resolve_one(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """Node ids of what a noun phrase means, without what is coordinated with it."""
    known = (
        _plural_by_name(world, m)
        or whole_of(world, m, subject, avoid)
        or _neighbour(world, m, avoid)
        or made_of(world, m)
        or _vessel_of(world, m)
    )
    if known:
        return known
    if names_nothing(world, m, subject):
        m.attribute = True
        return []
    if m.attribute or (not m.head and not m.pronoun):
        return resolve(world, m.possessor) if m.possessor is not None else []
    if m.count == 0:
        return []
    if m.pronoun:
        found = pronoun(world, m, subject, avoid)
        enrich(world, m, found)
        return found
    return _by_its_noun(world, m, subject, avoid)


def _vessel_of(world: World, m: Mention) -> list[str]:
    """ "Into the water": the bucket that was said to be filled with it."""
    vessel = world.filled.get(m.head) if m.determiner in ("the", "its") else None
    named = [e for e in world.entities.values() if e.head.rpartition(" ")[2] == vessel]
    return [e.id for e in named if vessel and e.group == named[-1].group][-1:] if named else []


def _neighbour(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "Its neighbour": the next of its row."""
    return beside(world, avoid) if m.head in _NEIGHBOURS and m.determiner == "its" else []


def _by_its_noun(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """What a noun names: something known, parts that are counted, or something new."""
    if m.noun is not None and "structural" in m.noun.traits:
        m.letters = []
    owner = m.possessor
    if m.role and m.determiner != "a" and (driven := _driven(world, owner)):
        return driven  # "the driver brakes": the car
    known = owner is not None and not owner.pronoun and owner.noun is not None
    if owner is not None and known and not (_any(owner, m) or _stays_behind(world, owner, m)):
        resolve(world, owner)  # "the man's hat": the man is there too
    found = existing(world, m, avoid)
    if subject and found and m.determiner in ("a", "an") and all_rest(world, found):
        found = []  # "two parked cars ... a car brakes": one more
    if found and _itself(world, m, found, avoid):
        found = []  # "a curling stone hits the guard stone": not itself
    found = found or _told_before(world, m)
    enrich(world, m, found)
    return found or counted_parts(world, m) or create(world, m)


def _told_before(world: World, m: Mention) -> list[str]:
    """ "Falls onto a steel plate upon impact with the plate": read later, and told first."""
    if m.determiner not in ("a", "an") or m.plural or m.letters or m.group_word:
        return []
    later = (e for e in world.entities.values() if e.origin > m.start and e.given)
    e = next((e for e in later if e.group is None and matches(world, m, e)), None)
    if e is None:
        return []
    e.adjectives += [a for a in m.adjectives if a not in e.adjectives and not a.startswith("@")]
    e.label, e.origin, e.given = m.text or e.label, m.start, False
    return [e.id]


def _stays_behind(world: World, owner: Mention, m: Mention) -> bool:
    """ "The neighbour's hedge", "the player's car": whose it is need not be there."""
    person = owner.noun is not None and owner.noun.kind == "person" and not owner.plural
    fixed = m.noun is not None and m.noun.kind in _LEFT_ALONE
    return person and fixed and not any(same_kind(owner, e) for e in world.entities.values())


def _itself(world: World, m: Mention, found: list[str], avoid: list[str]) -> bool:
    """Whether what is found can only be who acts, and the phrase tells of another."""
    if ONE_OF_THESE in m.adjectives or not set(found) <= {*avoid}:
        return False
    if (m.part or m.after_prep == "of") and m.determiner == "the" and not m.adjectives:
        return False  # "a rubber ball falls, showing the bounce of the ball"
    another = bool(OTHER & {*m.adjectives}) or m.possessor is not None
    return another or world.entities[found[0]].head != m.head


def _any(owner: Mention, m: Mention) -> bool:
    """ "a student's desk", "a barber's chair": what sort of thing it is, not whose."""
    person = owner.noun is not None and owner.noun.kind == "person"
    return (
        person
        and owner.determiner in ("a", "an")
        and m.noun is not None
        and (m.noun.kind in _OF_A_TRADE)
    )


def _plural_by_name(world: World, m: Mention) -> list[str]:
    """ "a tower of cups ... the tower", "three blocks are stacked ... the tower", "the group"."""
    if m.determiner not in _THE or m.letters or not set(m.adjectives) <= {"whole", "entire"}:
        return []
    if m.attribute and m.head in lex.GROUP_WORDS:
        return list(last_group(world))
    named = [g for g, word in world.group_words.items() if word == m.head]
    stacks = [g for g, x in world.groups.items() if world.entities[x[0]].pattern == "stack"]
    named = named or (stacks if m.head in _STACKS else [])
    own = any(e.head == m.head for e in world.entities.values())
    return list(world.groups[named[-1]]) if named and not own else []


def _driven(world: World, owner: Mention | None) -> list[str]:
    """The vehicle that a driver is said to drive, else the one named last."""
    if owner is not None:
        return resolve(world, owner)
    driven = (i for i in named_alone(world) if world.entities[i[0]].noun.kind in _DRIVEN)
    return next(driven, list[str]())


def existing(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """What a noun phrase means among the things named so far; none if it names something new."""
    single = not m.plural and m.count in (None, 1)
    if single and not m.letters and _one_of_them(m):
        return member_of(world, m, avoid)
    definite = m.determiner in _KNOWN or bool(m.letters)
    if not (definite or single) and _told_anew(world, m):
        return []
    bare = not m.determiner and not m.pattern and "other" not in m.adjectives
    if not (definite or bare or _structural(m)):
        return []
    names = [e for e in world.entities.values() if matches(world, m, e)]
    if m.letters:
        by_letter = {e.letter: e.id for e in names}
        return [by_letter.get(x) or letter_of(world, m, x) for x in m.letters]
    if {"other", "remaining"} & {*m.adjectives}:
        return _rest(world, m, names, avoid)
    if single and not _structural(m):
        found = _by_place(world, m, names, avoid)
        if found or (found is not None and definite):
            return found
    return _of_these(world, m, names, avoid, single, definite)


def _one_of_them(m: Mention) -> bool:
    """ "A car", "one car": one of those that were told of, or one more."""
    return m.determiner in _ONE or bool(m.count and not m.determiner)


def _told_anew(world: World, m: Mention) -> bool:
    """ "Two cars meet. There are parked cars on both sides": others than those that are known."""
    words = {a for a in m.adjectives if not a.startswith("@")} - {"other", "remaining"}
    if not words & _TELLING or m.count is not None or m.pattern:
        return False
    return not any(words <= {*e.adjectives} for e in world.entities.values() if same_kind(m, e))


def _structural(m: Mention) -> bool:
    return m.noun is not None and "structural" in m.noun.traits


def _of_these(
    world: World, m: Mention, names: list[Entity], avoid: list[str], single: bool, definite: bool
) -> list[str]:
    """Of the things that agree with a phrase all, if it is a plural, else the best."""
    if not names and definite and measured(m):
        names = _contradicted(world, m, avoid)
    groups = {e.group for e in names}
    every = m.determiner in ("each", "every") and len(groups) == 1 and None not in groups
    if not single or every:
        if _more_than(m, names, avoid):
            return []
        few = (m.count or 2) > len(names) and not definite
        return [] if few and not _structural(m) else [e.id for e in names]
    if not m.determiner and not m.pattern and not _structural(m):
        names = [e for e in names if e.group is None]  # "car hits wall" repeats what is one
    return _best(world, m, names, avoid)


def _more_than(m: Mention, names: list[Entity], avoid: list[str]) -> bool:
    """ "The red cube hits the stack of four cubes": more than the one that acts."""
    if not m.count or m.group_word == "pair" or m.count <= len(names):
        return False
    return {e.id for e in names} <= {*avoid}


def _rest(world: World, m: Mention, names: list[Entity], avoid: list[str]) -> list[str]:
    """ "the other cone", "the remaining pins": what was not told of."""
    told = world.salience if avoid or m.plural else world.subjects
    last = told[-1] if told else []
    rest = [e.id for e in names if e.id not in last and e.id not in avoid]
    return rest if m.plural else rest[:1]


def _contradicted(world: World, m: Mention, avoid: list[str]) -> list[Entity]:
    """ "A ball weighs 10 kg. The 5 kg ball ...": the only thing of its kind all the same."""
    alike = [e for e in world.entities.values() if same_kind(m, e)]
    only = [e for e in alike if len(alike) == 1 and e.id not in avoid]
    return [e for e in only if not any(unlike(e, a) for a in m.adjectives)]


def _best(world: World, m: Mention, names: list[Entity], avoid: list[str]) -> list[str]:
    """The thing that agrees best; a member of a plural gets its colour from the phrase."""
    color = next((lex.COLORS[a] for a in m.adjectives if a in lex.COLORS), None)
    if color:  # "several billiard balls ... the red ball": one more
        uncounted = [e.id for e in names if e.noun.kind == "billiard" and e.group in world.vague]
        names = [e for e in names if e.color == color or e.id not in uncounted]
    if not names:
        return []
    best = max(names, key=lambda e: _agreement(world, m, e, avoid))
    return [best.id] if color == best.color or not color else name_by(world, best, color)


def _by_place(world: World, m: Mention, names: list[Entity], avoid: list[str]) -> list[str] | None:
    """The member that a rank, an order or a place picks; None if the phrase names no such."""
    if "next" in m.adjectives and names:
        mates = [i for i in avoid if world.entities[i].noun == names[-1].noun]
        return next_of(world, names, mates)
    if found := ranked(world, m, [e for e in names if e.id not in avoid] or names, avoid):
        return found
    word = place_word(m)
    alike = [e for e in world.entities.values() if same_kind(m, e)]
    if ONE_OF_THESE in m.adjectives and len(names or alike) == 1:
        return [(names or alike)[0].id]
    rows = m.stacked or (m.noun is not None and m.noun.kind in ("pin", "domino"))
    if word and rows and not alike:
        row = Mention(m.start, m.end, head=m.head, noun=m.noun, plural=True)
        row.pattern = "stack" if m.stacked else None
        alike = [world.entities[i] for i in create(world, row)]
    if found := at_place(world, m, alike):
        return found
    return [] if word and _tells_a_new_one(m, word, names) else None


def _tells_a_new_one(m: Mention, word: str, names: list[Entity]) -> bool:
    """ "The car behind hits it", "the third car": another one than those that are known."""
    if word in lex.ORDINALS:
        return True
    ahead = any(w in m.text for w in ("behind", "following", "in front"))
    return ahead and all(not e.group and not e.place for e in names)


def _agreement(world: World, m: Mention, e: Entity, avoid: list[str]) -> tuple[bool | int, ...]:
    """How well a thing agrees with a phrase, the weightiest criterion first."""
    colors = [lex.COLORS[a] for a in m.adjectives if a in lex.COLORS]
    return (
        same_quantity(m, e, world.facts),
        not colors or e.color in colors,
        e.id not in avoid,
        len({*m.adjectives} & {*e.adjectives}),
        " " in m.text and e.label.lower() == m.text.lower(),
        m.head in (e.head, e.noun.name),
        max((k for k, ids in enumerate(world.salience) if e.id in ids), default=-1),
    )
