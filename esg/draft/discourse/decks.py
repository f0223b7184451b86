"""Scenes that take place on a pier, a quay, a bridge, a platform, a loading dock or a stage.

Where nothing leaves it, such a thing is what a road is: a flat surface under all that happens, long
and wide enough for it. Where something falls off, it stays what it is, carries all that takes part
until then, and is as large as that needs.
"""

from __future__ import annotations

from dataclasses import replace
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.scene import Relation, Scene
from esg.draft.verbphrases import DECKS
from esg.graph.models import NodeEvent

_LEAVES = re.compile(
    r"\b(?:off|throw\w*|thrown|drop\w*|lower\w*|jump\w*|dive\w*|leap\w*|launch\w*|fl(?:y|ies|ew))\b"
    r"|\b(?:under|beneath|below)\s+the\b|\binto\s+the\s+(?:water|sea|river|lake)\b"
    r"|\bover\s+(?:the|its)\s+(?:edge|side|end|rim|railing)\b",
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


UNDER_WAY, SHORE_CM = 4.0, 300.0
"""Lengths of water before and behind a boat, and what is left to its shores."""


def lay_decks(scene: Scene) -> None:
    """Makes a flat surface of a deck on which everything stays, and a roomy body of another.

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
        elif not (falls or enters or _LEAVES.search(scene.text)):
            _flatten(scene, deck, list(dict.fromkeys([*on_it, *acting])))


def widen_waters(scene: Scene) -> None:
    """Makes water as large as those need who are under way on it, side by side.

    Args:
        scene: Places and motions of the prompt; changed in place.
    """
    entities = scene.world.entities
    for water, e in entities.items():
        afloat = [i for i, on in scene.supported_by.items() if on == water and i in entities]
        if e.noun.name != "pool" or e.dimensions_prescribed or not afloat:
            continue
        if not any(i in scene.timeline.tracks for i in afloat):
            continue
        sizes = [entities[i].dimensions_cm or entities[i].noun.dimensions_cm for i in afloat]
        long = UNDER_WAY * max(max(s[:2]) for s in sizes) + SHORE_CM
        wide = 2.0 * sum(min(s[:2]) for s in sizes) + SHORE_CM
        usual = e.dimensions_cm or e.noun.dimensions_cm
        e.dimensions_cm = [max(usual[0], long), max(usual[1], wide), usual[2]]


def _carry(scene: Scene, deck: str, on_it: list[str], falls: list[str]) -> None:
    """Puts on a deck whoever meets what falls off it, and makes it as large as they need.

    The water that it stands in reaches as far as what falls off may fly.
    """
    entities = scene.world.entities
    flying = {e.actor for e in scene.timeline.edges if e.params.elevation_deg is not None}
    before = next(k for k, n in enumerate(scene.timeline.nodes) if n.event is NodeEvent.FALL)
    for node in reversed(scene.timeline.nodes[:before]):
        if node.event is not NodeEvent.COLLISION or not set(node.participants) & set(on_it):
            continue
        for i in node.participants:
            held = i in scene.supported_by or i in scene.inside_of or i in scene.attached
            e = entities[i]
            stands = "structural" not in e.noun.traits and e.noun.kind != "building"
            if stands and not held and i not in flying:
                scene.supported_by[i] = deck
                on_it.append(i)
    for e in entities.values():
        if e.noun.name == "pool" and not e.dimensions_prescribed:
            e.dimensions_cm = [*WATER_CM, e.noun.dimensions_cm[2]]
    entity = entities[deck]
    if entity.dimensions_prescribed or not entity.known:
        return
    sizes = [entities[i].dimensions_cm or entities[i].noun.dimensions_cm for i in on_it]
    tallest = max((entities[i].noun.dimensions_cm[2] for i in falls), default=0.0)
    needed = (ROOMY * max(s[0] for s in sizes), ROOMY * max(s[1] for s in sizes), HIGHER * tallest)
    usual = entity.dimensions_cm or entity.noun.dimensions_cm
    entity.dimensions_cm = [max(a, b) for a, b in zip(usual, needed, strict=True)]


def _flatten(scene: Scene, deck: str, users: list[str]) -> None:
    """Lays a surface instead of a body, under all who are on it."""
    entity = scene.world.entities[deck]
    kinds = {scene.world.entities[i].noun.kind for i in users}
    noun = lex.nouns()["sidewalk"]
    least = DRIVEN_CM if kinds & {"vehicle", "flyer"} else FLAT_CM
    usual = entity.noun.dimensions_cm
    size = (max(usual[0], least[0]), max(usual[1], least[1]), noun.dimensions_cm[2])
    if stated := entity.dimensions_cm:
        own = [size[k] if stated[k] == usual[k] else stated[k] for k in (0, 1)]
        entity.dimensions_cm = [*own, size[2]]
    entity.noun = replace(noun, dimensions_cm=size)
    scene.relations = [r for r in scene.relations if deck not in (r.source, r.target)]
    for i in users:
        if scene.supported_by.get(i) == deck:
            del scene.supported_by[i]
        if i not in scene.supported_by and i not in scene.inside_of:
            scene.marked[i] = deck
            scene.relations.append(Relation(i, deck, "structural", text="on"))
