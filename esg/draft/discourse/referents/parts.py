"""Parts that a jointed thing has several of, and that go by their number: a cradle's balls."""

from __future__ import annotations

from esg.draft.discourse.referents.entities import Entity, head_of
from esg.draft.discourse.referents.members import at_place, place_word
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.referents.registry import add_entity, current_id, unique
from esg.draft.text.elements import Mention
from esg.lexicon import plural
from esg.lexicon.articulations import articulations

_THE = ("the", "this", "that", "its")


def counted_parts(world: World, m: Mention) -> list[str]:
    """ "The first ball", "five steel balls", "one ball" of a Newton's cradle; their ids.

    The parts are things of the scene from the first phrase on that names them.

    Args:
        world: Of the prompt.
        m: A phrase that means nothing named so far.
    """
    if m.noun is None:
        return []
    for whole in list(world.entities.values()):
        row = articulations().get(head_of(whole))
        if row is None or row.count < 2 or m.head.split()[-1] not in row.serves:
            continue
        told = m.plural or place_word(m) or m.determiner in _THE or m.count == 1
        if not told or (m.count or 1) > row.count:
            return []
        parts = parts_of(world, whole) or _all_parts(world, whole, m, row.count)
        if m.plural:
            return [e.id for e in parts[: m.count]]
        return at_place(world, m, parts) or [parts[0].id]
    return []


def has_counted_parts(m: Mention) -> bool:
    """Whether a phrase names a thing whose parts go by their number."""
    row = articulations().get(m.head.lower().replace(" 's", "'s"))
    return row is not None and row.count > 1 and bool(row.serves)


def parts_of(world: World, whole: Entity) -> list[Entity]:
    """The parts of a jointed thing that the prompt names, in their order there."""
    found = (e for e in world.entities.values() if e.whole)
    return [e for e in found if current_id(world, e.whole) == whole.id]


def _all_parts(world: World, whole: Entity, m: Mention, count: int) -> list[Entity]:
    assert m.noun is not None
    group = unique(plural(m.head), world.groups)
    parts = [
        add_entity(world, m.noun, m.head, group=group, pattern="row", origin=m.start)
        for _ in range(count)
    ]
    for e in parts:
        e.whole = whole.id
    world.groups[group] = [e.id for e in parts]
    return parts
