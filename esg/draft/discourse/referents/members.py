"""Members of plurals, rows and stacks: which one a phrase picks, and the name it gets."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import OTHER, PLACES, Entity, slug
from esg.draft.discourse.referents.matching import matches
from esg.draft.discourse.referents.ranks import extreme, measured, rank, same_quantity
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.referents.registry import create, new_id, rename
from esg.draft.text.elements import Mention

OPPOSITE = {"front": "rear", "rear": "front"}
_AS_TOLD = {
    ("size", 1.0): ("large",), ("size", -1.0): ("small",), ("mass", 1.0): ("heavy",),
    ("mass", -1.0): ("light",), ("height", 1.0): ("tall",), ("height", -1.0): ("short",),
    ("length", 1.0): ("long",),
}  # fmt: skip
"""Adjectives by which one of two alike things is what a comparative says of it."""
_NAMED = 7
"""Most members of a row that go by their number."""
_ARRIVING = lex.word_set("arriving")
_LEVELS = frozenset({"top", "bottom"})


def name_by(world: World, e: Entity, word: str) -> list[str]:
    """Gives a member of a plural the name of its place or colour, if it has none; its id."""
    if not e.letter and (not e.place or e.place in _LEVELS) and e.place != word:
        e.place, e.label = word, f"{word} {e.head}"
        e.adjectives.append(word)
        rename(world, e, new_id(world, slug(e.label)))
    return [e.id]


def place_word(m: Mention) -> str:
    """The word of a phrase that says where in a row, queue or stack a thing is."""
    return next((a for a in m.adjectives if a in PLACES or a in lex.ORDINALS), "")


def at_place(world: World, m: Mention, things: list[Entity]) -> list[str]:
    """ "the second ball", "the rear car", "the top crate", "the third from the left".

    Args:
        m: The phrase.
        things: What it may be, in the order of the text.
    """
    word = place_word(m)
    if not word or m.plural or (m.count or 1) > 1:
        return []
    place = PLACES.get(word, word)
    exact = [e.id for e in things if e.place == place]
    rows = [e.group for e in things if e.group in world.groups]
    rows = [g for g in rows if place not in _LEVELS or _pattern(world, g) == "stack"]
    if exact or not rows:
        return exact[-1:] or _alone_at(place, things)
    row = [world.entities[i] for i in world.groups[rows[-1] or ""]]
    k, place = _index(row, m, word, place)
    if not -len(row) <= k < len(row) or (place == "middle" and len(row) < 3):
        return []
    if len(row) > _NAMED and word in lex.ORDINALS:
        return [row[k].id]
    found = name_by(world, row[k], place)
    if len(row) == 2 and place in OPPOSITE and not row[1 - k % 2].place:
        name_by(world, row[1 - k % 2], OPPOSITE[place])
    return found


def _index(row: list[Entity], m: Mention, word: str, place: str) -> tuple[int, str]:
    """Where in a row a phrase looks, and what it calls the member there."""
    k = {"rear": -1, "right": -1, "last": -1, "top": -1, "middle": len(row) // 2}.get(place, 0)
    k = lex.ORDINALS.get(word, k)
    if not m.counted_from:
        return k, place
    for e in row:
        e.pattern = "row" if e.pattern in (None, "scatter", "queue") else e.pattern
    if lex.COUNTED_FROM[m.counted_from] > 0:
        return k, place
    return len(row) - 1 - k, f"{word} last" if k else "last"


def _pattern(world: World, group: str | None) -> str | None:
    return world.entities[world.groups[group or ""][0]].pattern


def _alone_at(place: str, things: list[Entity]) -> list[str]:
    """ "a ball ... the second ball": the first is the one already there."""
    plain = [e.id for e in things if e.place in ("", "first") and e.group is None]
    k = lex.ORDINALS.get(place, -1)
    return plain[k : k + 1] if k >= 0 else []


def ranked(world: World, m: Mention, things: list[Entity], avoid: list[str]) -> list[str]:
    """ "the heavier one", "the tallest bottle": by what is known of sizes, masses, speeds."""
    word = rank(m)
    best = extreme(word, things, world.facts) if word else None
    if best is None and word and len(things) == 2 and things[0].group:
        told = [e for e in things if word in e.adjectives]
        free = [e for e in things if e.id not in avoid and not lex.RANKS.keys() & {*e.adjectives}]
        if not told and not free:
            return []  # "the two smaller cubes ... the larger one": none of the two
        best = (told or free)[0]
        best.adjectives += [] if told else [word, *_AS_TOLD.get(lex.RANKS[word], ())]
    return [best.id] if best is not None else []


def next_of(world: World, things: list[Entity], avoid: list[str]) -> list[str]:
    """ "bumps the next wagon": the one after it in its row, else another one."""
    group = next((world.entities[i].group for i in avoid), None)
    row = world.groups.get(group or "", [])
    k = max((row.index(i) for i in avoid if i in row), default=-1)
    later = row[k + 1 :]
    return (later or [e.id for e in things if e.id not in avoid])[:1]


def beside(world: World, ids: list[str]) -> list[str]:
    """ "Hits its neighbor": the next of the row that a thing is one of, else the one before."""
    node = ids[-1] if ids else ""
    row = next((r for r in world.groups.values() if node in r), list[str]())
    k = row.index(node) if row else 0
    return row[k + 1 : k + 2] or row[max(k - 1, 0) : k]


def picked(world: World, m: Mention, ids: list[str]) -> list[str]:
    """ "the first of two barrels": one member, named by its place."""
    things = [world.entities[i] for i in ids]
    if m.pick in lex.STACKED:
        for e in things:
            e.pattern = "stack"
    like = Mention(m.start, m.end, head=m.head, noun=m.noun, determiner="the", adjectives=[m.pick])
    return (
        ranked(world, like, things, [])
        or at_place(world, like, things)
        or name_by(world, things[0], m.pick)
    )


def member_of(world: World, m: Mention, avoid: list[str]) -> list[str]:
    """ "two blue balls ... hits a blue ball": an indefinite that picks a member of a plural."""
    if OTHER & {*m.adjectives} or _ARRIVING & {*m.adjectives}:
        return []  # "two parked vans; a passing van brakes": one more
    colors = {lex.COLORS[a] for a in m.adjectives if a in lex.COLORS}
    pool = [
        e.id
        for e in world.entities.values()
        if e.group and e.id not in avoid and matches(world, m, e) and e.noun == m.noun
        and e.origin < m.start and _goes_by(m, e)
        and (same_quantity(m, e, world.facts) or not measured(m))
        and (not colors or e.color in colors)
    ]  # fmt: skip
    return pool[:1]


def _goes_by(m: Mention, e: Entity) -> bool:
    """Whether a thing is called what a phrase calls it; "a candle" is none of two candlesticks."""
    return m.head in (e.head, e.head.split()[-1]) or m.head.split()[-1] == e.head


def one_more(world: World, like: Entity, words: list[str], m: Mention, count: int = 1) -> list[str]:
    """Another thing of a kind that is there, told apart by the phrase's words."""
    several = count if count > 1 else None
    copy = Mention(
        m.start, m.end, head=like.head, noun=like.noun, adjectives=words, count=several,
        plural=count > 1, text=" ".join([*words, like.head]), known=like.known,
    )  # fmt: skip
    return create(world, copy)
