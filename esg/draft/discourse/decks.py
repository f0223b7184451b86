"""Scenes that take place on a pier, a quay, a bridge, a platform, a loading dock or a stage.

Where nothing leaves it, such a thing is what a road is: a flat surface under all that happens, long
and wide enough for it. Where something falls off, it stays what it is, carries all that takes part
until then, and is as large as that needs.
"""

from __future__ import annotations

from dataclasses import replace
import re
from typing import TYPE_CHECKING

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.verbphrases import DECK_PHRASE, DECKS
from esg.graph.models import EdgeEvent, NodeEvent

if TYPE_CHECKING:
    from esg.draft.discourse.scene import Scene

_SMALL = frozenset({"platform", "stage"})
"""What may as well be a plinth, unless something goes along it."""
_HIGH = lex.word_set("high")
_LEAVES = re.compile(
    r"\b(?:off|throw\w*|thrown|drop\w*|lower\w*|jump\w*|dive\w*|leap\w*|launch\w*|fl(?:y|ies|ew))\b"
    r"|\bover\s+(?:the|its)\s+(?:edge|side|end|rim|railing)\b|\binto\s+the\s+(?:water|sea|river|lake)\b",
    re.IGNORECASE,
)
ROOMY, HIGHER = 4.0, 1.0
"""Length and width of a deck over those of what is on it, its height over that of what falls."""
WATER_CM = (4000.0, 3000.0)
"""Length and width of the water beside a deck."""
FLAT_CM, DRIVEN_CM = (1500.0, 600.0), (4000.0, 900.0)
"""Length and width of a surface that things roll or walk on, and of one that vehicles drive on."""


def is_deck(entity: Entity) -> bool:
    """Whether something is a large raised surface that scenes take place on."""
    words = entity.head.split()
    raised = {"support", "structural"} & entity.noun.traits == {"support"}
    return bool(words) and words[-1] in DECKS and (raised or not entity.known)


def is_driven(scene: Scene, node: str) -> bool:
    """Whether a deck is what vehicles drive on: no road is needed then."""
    if node in scene.marked.values():
        return scene.world.entities[node].head.split()[-1] in DECKS
    on_it = [i for i, host in scene.supported_by.items() if host == node]
    moved = any(scene.world.entities[i].noun.kind == "vehicle" for i in on_it)
    return moved and is_deck(scene.world.entities[node])


def lay_decks(scene: Scene) -> None:
    """Makes a flat surface of a deck on which everything stays.

    Args:
        scene: Places, motions and events of the prompt; changed in place.
    """
    acting = [i for n in scene.timeline.nodes for i in n.participants]
    acting = list(dict.fromkeys([*acting, *scene.timeline.tracks]))
    falls = [n.participants[0] for n in scene.timeline.nodes if n.event is NodeEvent.FALL]
    enters = any(n.event is NodeEvent.ENTER_REGION for n in scene.timeline.nodes)
    for deck in [i for i, e in scene.world.entities.items() if is_deck(e)]:
        on_it = [i for i, host in scene.supported_by.items() if host == deck]
        if deck in acting or not set(on_it) & set(acting):
            continue
        if set(on_it) & set(falls):
            _carry(scene, deck, [i for i in on_it if i in acting], falls)
            _fill(scene)
            continue
        movers = [
            e.actor for e in scene.timeline.edges if e.event is not EdgeEvent.INERTIAL_CONNECTOR
        ]
        leaves = falls or enters or _LEAVES.search(scene.text) is not None
        if not leaves and _takes_place_on(scene, deck, movers, on_it):
            _flatten(scene, deck, [*on_it, *(i for i in acting if i not in on_it)])


def _fill(scene: Scene) -> None:
    """The water that a quay or bridge stands in reaches as far as what falls off it may fly."""
    for entity in scene.world.entities.values():
        if entity.noun.name == "pool" and not entity.dimensions_prescribed:
            entity.dimensions_cm = [*WATER_CM, entity.noun.dimensions_cm[2]]


def _carry(scene: Scene, deck: str, on_it: list[str], falls: list[str]) -> None:
    """Puts on a deck whoever meets what falls off it, and makes it as large as they need."""
    entities = scene.world.entities
    flying = {e.actor for e in scene.timeline.edges if e.params.elevation_deg is not None}
    before = next(k for k, n in enumerate(scene.timeline.nodes) if n.event is NodeEvent.FALL)
    for node in reversed(scene.timeline.nodes[:before]):
        if node.event is not NodeEvent.COLLISION or not set(node.participants) & set(on_it):
            continue
        for i in node.participants:
            held = i in scene.supported_by or i in scene.inside_of or i in scene.attached
            if i in entities and not held and i not in flying and _stands_there(entities[i]):
                scene.supported_by[i] = deck
                on_it.append(i)
    entity = entities[deck]
    if entity.dimensions_prescribed or not entity.known:
        return
    sizes = [entities[i].dimensions_cm or entities[i].noun.dimensions_cm for i in on_it]
    longest, widest = max(s[0] for s in sizes), max(s[1] for s in sizes)
    tallest = max((entities[i].noun.dimensions_cm[2] for i in falls if i in entities), default=0.0)
    usual = entity.dimensions_cm or list(entity.noun.dimensions_cm)
    needed = [ROOMY * longest, ROOMY * widest, HIGHER * tallest]
    grown = [max(a, b) for a, b in zip(usual, needed, strict=True)]
    if grown != list(usual):
        entity.dimensions_cm = grown


def _stands_there(entity: Entity) -> bool:
    """Whether it may stand on a deck: neither the ground nor a building."""
    return "structural" not in entity.noun.traits and entity.noun.kind != "building"


def _takes_place_on(scene: Scene, deck: str, movers: list[str], on_it: list[str]) -> bool:
    """Whether the motions are on it, not at its foot or up to it."""
    word = re.escape(scene.world.entities[deck].head.split()[-1])
    runs = re.compile(rf"\b(?:over|across|along|down|cross\w*)\s+{DECK_PHRASE}{word}\b", re.I)
    if runs.search(scene.text):
        return True
    last = word.lower()
    if last in _SMALL:
        kinds = {scene.world.entities[i].noun.kind for i in on_it if i in movers}
        return bool(kinds & {"person", "vehicle", "cart", "robot", "animal"})
    if last in _HIGH:
        return bool(set(movers) & set(on_it))
    below = re.compile(rf"\b(?:under|beneath|below|beside|past)\s+{DECK_PHRASE}{word}\b", re.I)
    return below.search(scene.text) is None


def _flatten(scene: Scene, deck: str, users: list[str]) -> None:
    """Lays a surface instead of a body, under all who are on it."""
    from esg.draft.discourse.scene import Relation

    entity = scene.world.entities[deck]
    kinds = {scene.world.entities[i].noun.kind for i in users if i in scene.world.entities}
    driven = bool(kinds & {"vehicle", "flyer"})
    noun = lex.nouns()["sidewalk"]
    least = DRIVEN_CM if driven else FLAT_CM
    length, width, _ = entity.noun.dimensions_cm
    size = (max(length, least[0]), max(width, least[1]), noun.dimensions_cm[2])
    if entity.dimensions_cm is not None:
        entity.dimensions_cm = [*entity.dimensions_cm[:2], size[2]]
        usual = entity.noun.dimensions_cm
        for k in (0, 1):
            if entity.dimensions_cm[k] == usual[k]:
                entity.dimensions_cm[k] = size[k]
    entity.noun = replace(noun, dimensions_cm=size)
    scene.relations = [r for r in scene.relations if deck not in (r.source, r.target)]
    for i in users:
        if i not in scene.world.entities:
            continue
        if scene.supported_by.get(i) == deck:
            del scene.supported_by[i]
        if i not in scene.supported_by and i not in scene.inside_of:
            scene.marked[i] = deck
            scene.relations.append(Relation(i, deck, "structural", text="on"))
