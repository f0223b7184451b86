"""Parts that stand for what they belong to: "the dog's tail", "its bumper", "the bonnet"."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import WORN, Entity, head_of
from esg.draft.discourse.referents.pronouns import pronoun
from esg.draft.discourse.referents.record import World
from esg.draft.text.elements import Mention
from esg.lexicon.articulations import articulations

_TURNED_BY = lex.word_set("turned by")
_LINKS = lex.word_set("links")
_BODYWORK = lex.word_set("bodywork")
_OWN = lex.OWN_PARTS | lex.word_set("cabs")
_HOLDING = ("in", "into", "inside", "from", "out of", "off", "with", "on", "onto")
_THIS_ONE = ("the", "that", "this", "each", "either", "one", "its", "")
_PRONOUNS = {"his": "he", "her": "she", "its": "it", "their": "they"}
_HAVE = (
    (lex.BODY_PARTS, {"person", "animal", "robot", "tool", "seat", "furniture", "table"}),
    (WORN, {"person"}),
    (_OWN, {"vehicle", "cart", "watercraft", "flyer"}),
    (frozenset({"roof"}), {"building", "generic"}),
)
"""Parts, and the kinds of things that are hit when those are."""


def tips(e: Entity) -> bool:
    """Whether a thing tips to one side or the other, so that it has an end that is up: a seesaw."""
    row = articulations().get(head_of(e))
    return row is not None and row.tips


def has_pans(e: Entity, part: str) -> bool:
    """Whether something is told of an end of what tips by the name of a part: a balance's pan."""
    return bool(part) and tips(e) and lex.is_part(part.split()[-1], e.noun)


def whole_of(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """What a part belongs to: "the dog's tail", "the open door of a car", "its roof"."""
    body = m.head in lex.BODY_PARTS
    if m.attribute and m.part.endswith(("end", "side")):
        return [e.id for e in world.entities.values() if tips(e)][-1:]
    if boards := _of_a_balance(world, m):
        m.part = m.head
        return boards
    if m.possessor is not None and _part_of_a_joint(m.head, m.possessor):
        m.part = m.head
        return world.resolve(m.possessor)
    if m.possessor is not None:
        return _of_owner(world, m, m.possessor, subject and not body)
    if m.head in _BODYWORK and m.determiner in ("the", "a"):
        return _of_a_car(world, m)
    if body and m.determiner == "the" and m.after_prep in ("in", "on") and m.noun is None:
        last = [world.entities[i] for ids in world.salience[-2:] for i in ids]
        return [e.id for e in last if e.noun.kind in ("person", "animal")][-1:]
    if m.determiner not in _PRONOUNS or not (body or (m.head in _OWN and not subject)):
        return []
    word = _PRONOUNS[m.determiner]
    ids = pronoun(world, Mention(m.start, m.end, pronoun=word), subject, avoid)
    person = all(world.entities[i].noun.kind == "person" for i in ids)
    return list(avoid) if ids and person and word == "it" else ids


def _of_a_balance(world: World, m: Mention) -> list[str]:
    """ "A balance scale stands there. An apple falls on the left pan." """
    known = m.determiner in _THIS_ONE and (m.determiner or not m.plural)
    if not known or m.pronoun or m.possessor is not None:
        return []
    return [e.id for e in world.entities.values() if has_pans(e, m.head)][-1:]


def _of_a_car(world: World, m: Mention) -> list[str]:
    """ "Falls on the bonnet": of the vehicle named last, else of a car that is not named."""
    cars = [e.id for e in world.entities.values() if e.noun.kind == "vehicle"]
    if m.attribute and not cars:
        m.attribute, m.noun, m.part = False, lex.nouns()["car"], ""
    return cars[-1:] if m.attribute else []


def made_of(world: World, m: Mention) -> list[str]:
    """ "Hits the window and the glass shatters": what is of glass, if no glass was named.

    Nothing is poured into it, and it is no glass of something.
    """
    told = m.head == "glass" and m.determiner in ("the", "its") and not m.plural
    if not told or m.adjectives or m.after_prep in _HOLDING or m.possessor is not None:
        return []
    things = [*world.entities.values()]
    if " of " in m.text or m.head in world.filled.values():
        return []
    if any(e.head.split()[-1] == m.head for e in things):
        return []
    return [e.id for e in things if m.head in (e.noun.material, *e.adjectives)][-1:]


def _part_of_a_joint(head: str, owner: Mention) -> bool:
    """ "The chandelier's rope", "the arm of a turnstile": what is drawn with its owner."""
    if owner.pronoun:
        return False
    row = articulations().get(owner.head) if head in _TURNED_BY else None
    return head in _LINKS or (row is not None and row.turns and row.carries == "with")


def _of_owner(world: World, m: Mention, owner: Mention, subject: bool) -> list[str]:
    """The owner of a part, if that is what is hit when the part is."""
    if not owner.pronoun and owner.noun is not None and lex.is_part(m.head, owner.noun):
        m.part = m.head
        return world.resolve(owner)
    kinds = [k for parts, k in _HAVE if m.head in parts and not subject]
    known = not owner.pronoun and (owner.noun is not None or m.head == "roof")
    if not kinds or not known or (m.head in WORN and m.after_prep == "off"):
        return []
    ids = world.resolve(owner)
    return ids if any(world.entities[i].noun.kind in k for k in kinds for i in ids) else []
