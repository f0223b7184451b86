"""Physics-aware expansion: what the prompt implies but does not say.

Supports come first (a billiard table under billiards): they are needed even when the prompt forbids
other objects. Context (a road, a lane marking) is left out then.
"""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.decks import is_driven, lay_decks, widen_waters
from esg.draft.discourse.jointed import articulation_of
from esg.draft.discourse.places import told_by_side
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.discourse.referents.sizes import dimensions_of
from esg.draft.discourse.scene import GROUND, Relation, Scene
from esg.draft.discourse.windows import START
from esg.draft.document.joining import ARM_CM, join_parts, lowers
from esg.draft.document.riding import board, put_into_cars, seat_riders
from esg.draft.document.towing import tie_tows
from esg.graph.models import EventConstraint, ForceDirection, NodeEvent, TimelineEdge
from esg.lexicon.grounds import grounds

RAISED_CM = 25.0
"""Height from which on what stands on a support is out of reach of what rolls on the ground."""
_AT_THE_FOOT_CM = (0.0, 6.0)
"""Height of the lowest point of what is kicked off the ground."""
_OFF_ROAD = lex.word_set("off the road")
_TOYS = lex.word_set("never on a road")
_ON_RAILS = lex.word_set("on rails (context)")
_OFF_THE_ROAD = re.compile(
    rf"\b(?:in|inside|across|through|along|around)\s+(?:an?|the|its|his|her)\s+(?:[\w-]+\s+){{0,3}}?"
    rf"(?:{'|'.join(sorted(lex.word_set('no road (context)'), key=len, reverse=True))})\b",
    re.IGNORECASE,
)
"""Places in which no road is where they are said to be gone in."""
_LOOSE = frozenset(word for row in grounds().values() for word in row.lies_as)
"""Grounds that no road leads over where they are named themselves."""
CROSSING_DEG = 60.0
"""Smallest turn of a vehicle that needs a crossing road."""


_ROLLS = re.compile(r"\broll", re.IGNORECASE)
_DOWN = re.compile(
    r"\b(?:roll|slid|bounc|tumbl)\w*\s+down(?:hill|wards?)?\b"
    r"(?!\s+the\s+(?:road|street|lane|alley|hall|track))",
    re.IGNORECASE,
)
_DOWN_A_THING = re.compile(r"down\s+(?:the|an?)\s+\w+", re.IGNORECASE)
_COMES_DOWN = re.compile(r"\b(?:comes?|came|coming)\s+$", re.IGNORECASE)
_DOWN_WHAT_STANDS = re.compile(
    rf"\s+(?:the|an?|its|his|her|their)\s+(?:[\w'-]+\s+){{0,2}}"
    rf"(?:{'|'.join(sorted(lex.word_set('upright (slopes)')))})\b",
    re.IGNORECASE,
)


def expand(scene: Scene, prompt: str, restricted: bool) -> list[str]:
    """Adds implied objects and supports; returns one reason per addition."""
    reasons: list[str] = []
    _drop_regions(scene)
    _set_up_billiards(scene, reasons)
    seat_riders(scene)
    put_into_cars(scene)
    board(scene)
    lay_decks(scene)
    widen_waters(scene)
    for left, right in told_by_side(scene.world.entities):
        scene.relations.append(Relation(left, right, "left_of"))
    _throw_what_rolls_too_low(scene, prompt)
    _kick_from_the_ground(scene)
    _lay_slope(scene, prompt, reasons)
    if not restricted:
        _add_context(scene, prompt, reasons)
    reasons += join_parts(scene)
    tie_tows(scene)
    return reasons


def _find(scene: Scene, *names: str) -> str | None:
    return next((i for i, e in scene.world.entities.items() if e.noun.name in names), None)


def _add(scene: Scene, name: str, reasons: list[str], reason: str) -> str:
    reasons.append(f"{name} added: {reason}")
    return add_entity(scene.world, lex.nouns()[name], name, mentioned=False).id


def _drop_regions(scene: Scene) -> None:
    """Pockets are regions of the table, not objects."""
    for i in [i for i, e in scene.world.entities.items() if e.noun.kind == "region"]:
        del scene.world.entities[i]
        scene.supported_by.pop(i, None)
        scene.relations = [r for r in scene.relations if i not in (r.source, r.target)]


def _set_up_billiards(scene: Scene, reasons: list[str]) -> None:
    """Billiard balls lie on a billiard table, as do the other balls beside them."""
    entities, nouns = scene.world.entities, lex.nouns()
    table = _find(scene, "billiard table")
    told = scene.needs or (table is not None and scene.world.billiards)
    if not told and all(e.noun.kind != "billiard" for e in entities.values()):
        return
    plain = _find(scene, "table")
    if table is None and plain is not None:
        table, entities[plain].noun = plain, nouns["billiard table"]  # "the table" of snooker
    table = table or _add(scene, "billiard table", reasons, "billiard balls are played on it")
    for i, e in entities.items():
        if e.noun.name == "ball" and scene.supported_by.get(i, table) == table:
            e.noun = nouns["billiard ball"]
        if e.noun.kind == "billiard":
            scene.supported_by.setdefault(i, table)


def _throw_what_rolls_too_low(scene: Scene, prompt: str) -> None:
    """What would roll or slide against something out of its reach is thrown at it instead."""
    timeline, told = scene.timeline, _ROLLS.search(prompt) is not None
    toppled = {n.participants[0] for n in timeline.nodes if n.event is NodeEvent.TOPPLE}
    for k, edge in enumerate(timeline.edges):
        if edge.event.value != "Toward" or edge.params.spin == "none":
            continue
        raised = edge.params.spin is not None and _is_raised(scene, edge, told)
        if raised or (edge.target in toppled and not told and _is_low(scene, edge)):
            params = edge.params.model_copy(update={"spin": "none", "elevation_deg": (-10.0, 60.0)})
            timeline.edges[k] = edge.model_copy(update={"params": params})
            timeline.tracks[edge.actor].direction = ForceDirection.ANY_3D


def _kick_from_the_ground(scene: Scene) -> None:
    """ "Kicks a ball at a punching bag": it flies up from the foot, not out of a hand."""
    for edge in scene.timeline.edges:
        flies = edge.params.elevation_deg is not None and edge.from_ == START
        high = edge.actor in scene.supported_by or edge.actor in scene.heights
        if flies and edge.actor in scene.kicked and not high:
            scene.timeline.start_constraints.append(
                EventConstraint(quantity="height", object=edge.actor, value=_AT_THE_FOOT_CM)
            )


def _is_raised(scene: Scene, edge: TimelineEdge, told: bool) -> bool:
    """Whether a body on the ground goes at what stands on a table or hangs."""
    entities, supports = scene.world.entities, scene.supported_by
    if edge.actor in supports or edge.target not in entities:
        return False
    host = entities.get(supports.get(edge.target, ""))
    if host is not None and host.noun.dimensions_cm[2] > RAISED_CM:
        return "support" in host.noun.traits and "incline" not in host.noun.traits
    if told:
        return False
    row = articulation_of(scene, scene.text, entities[edge.target])
    if row is not None and lowers(row, dimensions_of(entities[edge.actor])[2] + ARM_CM):
        return False
    hangs = row is not None and row.above_cm > entities[edge.actor].noun.dimensions_cm[2]
    return hangs or entities[edge.target].noun.kind == "hoop"


def _is_low(scene: Scene, edge: TimelineEdge) -> bool:
    """Whether a body meets what it topples far below its middle, and would slide it along."""
    entities = scene.world.entities
    height = entities[edge.target].noun.dimensions_cm[2] if edge.target in entities else 0.0
    return entities[edge.actor].noun.dimensions_cm[2] < 0.5 * height


def _lay_slope(scene: Scene, prompt: str, reasons: list[str]) -> None:
    """What rolls down needs something to roll down from; no wall, and no tower that comes down."""
    told = [m for m in _DOWN.finditer(prompt) if not _COMES_DOWN.search(prompt, 0, m.start())]
    if all(_DOWN_WHAT_STANDS.match(prompt, m.end()) for m in told):
        return
    entities, supports = scene.world.entities, scene.supported_by
    slope = next((i for i, e in entities.items() if "incline" in e.noun.traits), None)
    tracks = scene.timeline.tracks.items()
    movers = [a for a, track in tracks if track.launched and a not in supports]
    if slope is None:
        named = _DOWN_A_THING.search(prompt) is not None and "downhill" not in prompt.lower()
        if named and any(e.noun.kind == "ground" for e in entities.values()):
            return
        slope = _add(scene, "ramp", reasons, "something rolls down it")
    if movers and movers[0] != slope:
        supports[movers[0]] = slope


def _no_road(scene: Scene, prompt: str) -> bool:
    """ "A train brakes", "in a warehouse, a forklift ...": they go on no road."""
    vehicles = [e for e in scene.world.entities.values() if e.noun.kind == "vehicle"]
    return all(e.noun.name in _ON_RAILS for e in vehicles) or bool(_OFF_THE_ROAD.search(prompt))


def _add_context(scene: Scene, prompt: str, reasons: list[str]) -> None:
    """What such scenes take place on: a bowling lane, a road, a crossing."""
    entities, timeline = scene.world.entities, scene.timeline
    pins = any(e.noun.kind == "pin" and e.noun.name != "chess piece" for e in entities.values())
    if pins and _find(scene, "bowling lane") is None:
        _add(scene, "bowling lane", reasons, "bowling pins stand at the end of a lane")
    if all(e.noun.kind != "vehicle" for e in entities.values()):
        return
    if _off_the_road(entities):
        return
    if _no_road(scene, prompt):
        return
    dynamic = bool(timeline.nodes) or any(t.motion for t in timeline.tracks.values())
    paved = _find(scene, "road", "parking lot") is not None
    if dynamic and not paved and not any(is_driven(scene, i) for i in entities):
        _add(scene, "road", reasons, "vehicles drive on a road")
    turns = any(
        n.event is NodeEvent.HEADING_REACHED
        and float(n.extra.get("turn_degrees") or 0) >= CROSSING_DEG
        for n in timeline.nodes
    )
    if turns and _find(scene, "crossroad") is None and _find(scene, "road") is not None:
        _add(scene, "crossroad", reasons, "a turn needs a crossing road")


def _off_the_road(entities: dict[str, Entity]) -> bool:
    """ "Rides a bicycle through the park", "drives across the sand", and toys anywhere."""
    vehicles = {e.noun.name for e in entities.values() if e.noun.kind == "vehicle"}
    if vehicles <= _TOYS:
        return True
    ground = entities.get(GROUND)
    if ground is None or not ground.mentioned:
        return False
    return vehicles <= _OFF_ROAD or ground.head in _LOOSE
