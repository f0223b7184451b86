"""Which of the things that a prompt names turn or slide on a joint (`articulations.csv`)."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity, head_of
from esg.draft.discourse.referents.registry import current_id
from esg.draft.discourse.referents.sizes import dimensions_of
from esg.draft.discourse.scene import LIVING, Scene
from esg.graph.models import NodeEvent
from esg.lexicon.articulations import Articulation, articulations, hangers

HUNG = "hanging thing"
"""Row of what hangs by a rope and has none of its own."""
SPRUNG, LOAD = "thing on a spring", "hanging load"
BUMPER = "spring bumper"
"""What a spring is that things run into."""
_SPRINGS = frozenset({"spring", "coil spring"})
_WHOLES = frozenset(
    {"appliance", "box", "container", "electronics", "flyer", "furniture", "toyvehicle", "vehicle"}
)
"""Kinds of things whose doors and lids are parts of them: a car door is no door of a room."""
_HOUSE_CM = 200.0
"""What is wider and longer is a house: its door is drawn beside it, in a frame of its own."""


_FLAPS = lex.word_set("flaps")
_HOLLOW = lex.word_set("hollow parts")
CRANES = frozenset(hangers()[LOAD].serves)
"""What loads hang from."""
_OWNED = re.compile(r"(?:\bits|\bwith an?|['’]s)", re.IGNORECASE)
"""What is before a part: "its door", "with a lid"."""


def articulation_of(scene: Scene, text: str, e: Entity) -> Articulation | None:
    """The row of a thing; None for what is a part of something, or attached to it.

    "The door of a car" stays as it is; "the door of a cupboard" and "a cupboard door" have a row of
    their own, and so has a lamp below a ceiling, which hangs.
    """
    table = articulations()
    if e.whole:  # a ball of a cradle
        e = scene.world.entities[current_id(scene.world, e.whole)]
    row = next((table[name] for name in _names(scene, text, e) if name in table), None)
    if e.id in scene.sprung:
        return hangers()[SPRUNG]
    roped = bool(scene.hung.get(e.id)) or (e.noun.kind not in LIVING and _carried(scene))
    hung = e.id in scene.hung and roped
    hung = hung or e.id in scene.loosed
    hung = hung and e.id not in scene.tows
    if row is None and (hung or not hangers().keys().isdisjoint(_names(scene, text, e))):
        row = hangers()[LOAD if _under_a_crane(scene) else HUNG]
    if row is None or (e.id in scene.attached and not (row.hangs and _below_ceiling(scene, e))):
        return None
    return row


def _names(scene: Scene, text: str, e: Entity) -> list[str]:
    """What the table may call a thing, the most precise first."""
    head = head_of(e)
    whole = _whole_told(text, e)
    if whole is not None:
        others = (x for x in scene.world.entities.values() if x is not e)
        others = (x for x in others if not _houses(x))  # whose front door stands by it
        things = {head_of(x) for x in others if "structural" not in x.noun.traits}
        named = [f"{x} {head}" for x in sorted(things) if x in whole[1].lower()]
        named = [*(f"{a} {head}" for a in e.adjectives), *named] if named else []
        return named or [head]  # "the gate of a paddock", which is no thing
    if _OWNED.search(text) and _owned_by(e.head).search(text):
        others = [x for x in scene.world.entities.values() if x is not e]
        if its := [name for x in others if (name := f"{head_of(x)} {head}") in articulations()]:
            return its  # "A clock stands there. Its pendulum swings."
    if hollow := _of_what_is_there(scene, text, e):
        return hollow
    nouns = lex.nouns()
    if head in _SPRINGS and _run_into(scene, e):
        return [BUMPER]
    compounds = [f"{a} {head}" for a in e.adjectives]
    if any(a in nouns and nouns[a].kind in _WHOLES for a in e.adjectives):
        return compounds
    return [
        *compounds,
        *([f"hanging {head}"] if _below_ceiling(scene, e) or e.id in scene.hung else []),
        head,
    ]


def _of_what_is_there(scene: Scene, text: str, e: Entity) -> list[str]:
    """ "Falls out of the fridge as the door opens": a fridge was told of, and no door."""
    head, low = head_of(e), text.lower()
    at = low.find(f"the {head}")
    if e.adjectives or at < 0 or re.search(rf"\b(?:an?|two|another)\s+(?:\w+\s+)?{head}\b", low):
        return []
    named = [
        (f"{head_of(x)} {head}", x)
        for x in scene.world.entities.values()
        if x is not e and x.id not in scene.timeline.tracks and 0 <= low.find(head_of(x)) < at
    ]  # a fridge that falls off a truck is moved as one
    rows = articulations()
    return [n for n, _ in named if n in rows and rows[n].with_part in _HOLLOW]


def of_a_house(scene: Scene, text: str, e: Entity) -> bool:
    """ "The front door of a cottage": a leaf of its own only where that is told to move."""
    whole = _whole_told(text, e)
    others = (x for x in scene.world.entities.values() if x is not e)
    return whole is not None and any(_houses(x) and head_of(x) in whole[1].lower() for x in others)


def _run_into(scene: Scene, e: Entity) -> bool:
    """Whether something is told to hit a thing."""
    hits = (n for n in scene.timeline.nodes if n.event is NodeEvent.COLLISION)
    return any(e.id in n.participants[1:] for n in hits)


def behind_doors(scene: Scene, text: str) -> dict[str, str]:
    """What is drawn hollow, as its door is there: a fridge, by the node of its door."""
    entities = scene.world.entities.values()
    out: dict[str, str] = {}
    for door in entities:
        row = articulation_of(scene, text, door)
        if row is not None and row.with_part in _HOLLOW:
            out |= {e.id: door.id for e in entities if e is not door and head_of(e) in row.serves}
    return out


def is_flap(scene: Scene, text: str, node: str) -> bool:
    """Whether a thing carries what stands on it until it drops open: a trapdoor."""
    e = scene.world.entities.get(node)
    row = articulation_of(scene, text, e) if e is not None else None
    return row is not None and row.becomes in _FLAPS


def has_a_door(e: Entity) -> bool:
    """Whether a door can be told of that a thing lies behind: that of a fridge."""
    rows = (r for r in articulations().values() if r.with_part in _HOLLOW)
    return any(head_of(e) in r.serves for r in rows)


def _houses(e: Entity) -> bool:
    wide = min(dimensions_of(e)[:2]) > _HOUSE_CM
    return "fixed" in e.noun.traits and e.noun.kind not in _WHOLES and wide


def _whole_told(text: str, e: Entity) -> re.Match[str] | None:
    """What a thing is said to be of: "the door of a car"."""
    return _part_of(e.head).search(text) if " of " in text.lower() else None


@lru_cache(maxsize=4096)
def _part_of(head: str) -> re.Pattern[str]:
    of = rf"\b{re.escape(head)}s?\b of (?:an?|the|his|her|its|their|my) ((?:[\w-]+ ?){{1,4}})"
    return re.compile(of, re.IGNORECASE)


@lru_cache(maxsize=4096)
def _owned_by(head: str) -> re.Pattern[str]:
    return re.compile(rf"{_OWNED.pattern} (?:[\w-]+ )?{re.escape(head)}s?\b", re.IGNORECASE)


def _below_ceiling(scene: Scene, e: Entity) -> bool:
    host = scene.world.entities.get(scene.attached.get(e.id, ""))
    return host is not None and host.noun.kind == "ceiling"


def _under_a_crane(scene: Scene) -> bool:
    return _there(scene, hangers()[LOAD].serves)


def _carried(scene: Scene) -> bool:
    """Whether the prompt names what a thing may hang from without a rope being told of."""
    return _there(scene, hangers()[LOAD].serves + hangers()[HUNG].serves)


def _there(scene: Scene, nouns: tuple[str, ...]) -> bool:
    return any(head_of(x) in nouns for x in scene.world.entities.values())


def loosen(scene: Scene, text: str) -> None:
    """What hangs is not fixed, though what it hangs on is: a swing, a bell."""
    for e in scene.world.entities.values():
        row = articulation_of(scene, text, e)
        if row is not None and row.drawn is not None and row.carries == "with":
            e.noun = replace(e.noun, traits=e.noun.traits - {"fixed", "structural"})
