"""Parts that stand for what they belong to: "the dog's tail", "his car", "a car roof"."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import WORN
from esg.draft.discourse.referents.pronouns import pronoun
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.referents.registry import create
from esg.draft.text.elements import Mention

_BODYWORK = lex.word_set("bodywork")
_ANIMAL_PARTS = lex.word_set("animal parts")
_CABS = lex.word_set("cabs")
_TOPS = lex.word_set("tops")


def own_vehicle(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """ "The insured brakes and a lorry hits his car": who drives is drawn as the vehicle."""
    if m.noun is None or m.noun.kind != "vehicle":
        return []
    if m.possessor is not None:
        ids = world.resolve(m.possessor) if m.possessor.head else []
    elif m.determiner in ("his", "her"):
        word = "he" if m.determiner == "his" else "she"
        ids = pronoun(world, Mention(m.start, m.end, pronoun=word), False, avoid)
    else:
        return []
    if len(ids) != 1 or ids[0] not in world.drivers or ids[0] in avoid:
        return []
    driver = world.entities[ids[0]]
    driver.noun, driver.known = m.noun, True
    return ids


def compound(world: World, m: Mention) -> list[str]:
    """The vehicle that "the bus driver" or "a car roof" names first; made if not there yet."""
    for a in m.adjectives:
        noun = lex.nouns().get(a)
        if noun is None or noun.kind not in ("vehicle", "flyer", "watercraft"):
            continue
        same = [e.id for e in world.entities.values() if e.noun.name == noun.name]
        vehicle = Mention(m.start, m.end, head=a, noun=noun, determiner="the", text=a)
        return same[-1:] or create(world, vehicle)
    return []


def whole_of(world: World, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
    """What a part belongs to: "the dog's tail", "the open door of a car", "its roof"."""
    owner = m.possessor
    body = m.head in lex.BODY_PARTS
    if m.part and m.determiner in ("a", "an", "one") and m.noun is not None:
        same = [e for e in world.entities.values() if e.noun == m.noun and e.id not in avoid]
        if len(same) == 1 and same[0].head == m.head and not m.adjectives:
            return [same[0].id]  # "drives under a table and hits a table leg"
    if owner is None and m.head in lex.OWN_PARTS and not subject:
        vehicle = compound(world, m)
        if vehicle:
            return vehicle
    if owner is None and m.head in _BODYWORK and m.determiner in ("the", "a"):
        cars = [e.id for e in world.entities.values() if e.noun.kind == "vehicle"]
        if m.attribute and not cars:  # "falls on the bonnet": of a car that is not named
            m.attribute, m.noun, m.part = False, lex.nouns()["car"], ""
        return cars[-1:] if m.attribute else []
    if owner is not None:
        named = owner.determiner in ("the", "a", "an") and m.head == "roof"
        ids = world.resolve(owner) if owns(owner) or named else []
        kinds = {world.entities[i].noun.kind for i in ids}
        if body and kinds & {"person", "animal", "robot", "tool"}:
            return ids
        if body and kinds & {"seat", "furniture", "table"}:
            return ids  # "slides from the arm of the sofa"
        if m.head in WORN and kinds & {"person"} and m.after_prep != "off":
            return ids
        own = m.head in lex.OWN_PARTS | _CABS and not subject
        if m.head == "roof" and not subject and kinds in ({"building"}, {"generic"}):
            return ids  # "lands on the roof of a shed"
        return ids if own and kinds & {"vehicle", "cart", "watercraft", "flyer"} else []
    if m.head in _TOPS and m.determiner == "the" and not subject and not m.adjectives:
        last = [i for ids in world.salience[-3:] for i in ids if i in world.entities]
        built = [i for i in last if world.entities[i].noun.kind in ("building", "vehicle")]
        hut = [i for i in built if world.entities[i].head != m.head]
        if hut:
            return hut[-1:]  # "throws it at the hut. It bounces off the roof"
    if m.head == "fork" and m.plural and m.determiner in ("its", "the") and owner is None:
        named = (i for ids in reversed(world.salience) for i in ids if i in world.entities)
        lifts = (i for i in named if "fork" in world.entities[i].noun.name)
        return list(next(([i] for i in lifts), []))  # "slides off its forks"
    if body and m.determiner == "the" and m.after_prep in ("in", "on") and m.noun is None:
        last = [i for ids in world.salience[-2:] for i in ids if i in world.entities]
        hit = [i for i in last if world.entities[i].noun.kind in ("person", "animal")]
        return hit[-1:]  # "hits him in the midriff"
    if m.determiner in ("his", "her", "its", "their") and (
        body or (m.head in lex.OWN_PARTS | _CABS and not subject)
    ):
        word = {"his": "he", "her": "she", "its": "it", "their": "they"}[m.determiner]
        ids = pronoun(world, Mention(m.start, m.end, pronoun=word), subject, avoid)
        if m.head in _ANIMAL_PARTS and word == "it":
            ids = _last_animal(world) or ids  # "a boy in a boat throws a crust at its wing"
        person = all(world.entities[i].noun.kind == "person" for i in ids)
        return list(avoid) if ids and person and word == "it" else ids
    return []


def _last_animal(world: World) -> list[str]:
    """The animal or aircraft that was named last."""
    named = (i for ids in reversed(world.salience) for i in ids if i in world.entities)
    winged = (i for i in named if world.entities[i].noun.kind in ("animal", "flyer"))
    return [i for i in (next(winged, ""),) if i]


def owns(m: Mention) -> bool:
    """Whether a possessor is an object of the scene ("the man's hat", not "today's race")."""
    return not m.pronoun and m.noun is not None and "structural" not in m.noun.traits
