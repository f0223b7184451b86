"""Physics-aware expansion: what the prompt implies but does not say.

Supports come first (a billiard table under billiards): they are needed even when the prompt forbids
other objects. Context (a road, a lane marking) is left out then.
"""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.decks import is_driven, lay_decks
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.discourse.scene import Scene
from esg.graph.models import NodeEvent


def _find(scene: Scene, *names: str) -> str | None:
    return next((i for i, e in scene.world.entities.items() if e.noun.name in names), None)


LARGEST_ON_TABLE_CM = 40.0
"""Size up to which what billiard balls hit stands on their table."""


def _add(scene: Scene, name: str, reasons: list[str], reason: str) -> str:
    noun = lex.nouns()[name]
    entity = add_entity(scene.world, noun, name, mentioned=False)
    reasons.append(f"{name} added: {reason}")
    return entity.id


def expand(scene: Scene, prompt: str, restricted: bool) -> list[str]:
    """Adds implied objects and supports; returns one reason per addition."""
    reasons: list[str] = []
    _drop_region_entities(scene)
    entities = scene.world.entities
    if scene.world.billiards and _find(scene, "billiard table") is not None:
        for i, e in entities.items():
            if e.noun.name == "ball" and i not in scene.supported_by:
                e.noun = lex.nouns()["billiard ball"]  # "the red ball" of a pool table
    kinds = {e.noun.kind for e in entities.values()}
    dynamic = bool(scene.timeline.nodes) or any(t.motion for t in scene.timeline.tracks.values())
    if "billiard" in kinds or any(need == "billiard_table" for need, _ in scene.needs):
        plain = next((e for e in entities.values() if e.noun.name == "table"), None)
        if plain is not None and _find(scene, "billiard table") is None:
            plain.noun = lex.nouns()["billiard table"]  # "the table" of a snooker ball
        table = _find(scene, "billiard table") or _add(
            scene, "billiard table", reasons, "billiard balls are played on it"
        )
        for i, e in entities.items():
            if e.noun.kind == "billiard" and i not in scene.supported_by:
                scene.supported_by[i] = table
            elif e.noun.name == "ball" and scene.supported_by.get(i, table) == table:
                scene.supported_by[i] = table
                e.noun = lex.nouns()["billiard ball"]
        _rename_regions(scene, table)
        _set_on_table(scene, table)
    _fill_targets(scene, reasons)
    lay_decks(scene)
    _elevated_targets(scene, prompt)
    _topple_shots(scene, prompt)
    _roll_down(scene, prompt, reasons)
    if not restricted:
        if (
            "pin" in kinds
            and _find(scene, "bowling lane") is None
            and any(
                e.noun.kind == "pin" and e.noun.name != "chess piece" for e in entities.values()
            )
        ):
            _add(scene, "bowling lane", reasons, "bowling pins stand at the end of a lane")
        if (
            dynamic
            and "vehicle" in kinds
            and _find(scene, "road", "parking lot", "crossroad") is None
            and not any(is_driven(scene, i) for i in entities)
        ):
            _add(scene, "road", reasons, "vehicles drive on a road")
        turns = any(
            n.event is NodeEvent.HEADING_REACHED and float(n.extra.get("turn_degrees") or 0) >= 60
            for n in scene.timeline.nodes
        )
        if (
            turns
            and "vehicle" in kinds
            and _find(scene, "crossroad") is None
            and _find(scene, "road") is not None
        ):
            _add(scene, "crossroad", reasons, "a turn needs a crossing road")
    return reasons


def _drop_region_entities(scene: Scene) -> None:
    """Pockets are regions of the table, not objects."""
    for i in [i for i, e in scene.world.entities.items() if e.noun.kind == "region"]:
        del scene.world.entities[i]
        scene.supported_by.pop(i, None)
        scene.relations = [r for r in scene.relations if i not in (r.source, r.target)]


def _set_on_table(scene: Scene, table: str) -> None:
    """A chess piece or a bottle that billiard balls hit stands on their table, too."""
    for node in scene.timeline.nodes:
        if node.event is not NodeEvent.COLLISION:
            continue
        if not any(scene.supported_by.get(p) == table for p in node.participants):
            continue
        for p in node.participants:
            e = scene.world.entities.get(p)
            if e is None or p == table or p in scene.supported_by or p in scene.inside_of:
                continue
            fixed = {"structural", "fixed", "wheeled", "support"} & e.noun.traits
            size = max(e.dimensions_cm or e.noun.dimensions_cm)
            if not fixed and e.noun.kind != "person" and size <= LARGEST_ON_TABLE_CM:
                scene.supported_by[p] = table


def _rename_regions(scene: Scene, table: str) -> None:
    for n in scene.timeline.nodes:
        region = n.extra.get("region")
        if isinstance(region, str) and "pocket" in region:
            n.extra["region"] = f"{table}/{region.split('/', 1)[1]}"


def _fill_targets(scene: Scene, reasons: list[str]) -> None:
    if (
        any(need == "billiard_table" for need, _ in scene.needs)
        and _find(scene, "billiard table") is None
    ):
        table = _add(scene, "billiard table", reasons, "a pocket belongs to a billiard table")
        _rename_regions(scene, table)
        for _, actor in scene.needs:
            scene.supported_by.setdefault(actor, table)


def _says_roll(prompt: str) -> bool:
    return re.search(r"\broll", prompt.lower()) is not None


def _throw_instead(scene: Scene, k: int) -> None:
    """Makes a throw of the timeline's k-th motion, which was to roll or slide."""
    from esg.graph.models import ForceDirection

    edge = scene.timeline.edges[k]
    params = edge.params.model_copy(update={"spin": "none", "elevation_deg": (-10.0, 60.0)})
    scene.timeline.edges[k] = edge.model_copy(update={"params": params})
    scene.timeline.tracks[edge.actor].direction = ForceDirection.ANY_3D


def _elevated_targets(scene: Scene, prompt: str) -> None:
    """A body on the ground cannot hit what stands on a table or hangs: it is thrown instead."""
    raised = {
        t
        for t, host in scene.supported_by.items()
        if host in scene.world.entities
        and "support" in scene.world.entities[host].noun.traits
        and scene.world.entities[host].noun.dimensions_cm[2] > 25.0
        and "incline" not in scene.world.entities[host].noun.traits
    }
    if not _says_roll(prompt):
        raised |= {i for i, e in scene.world.entities.items() if e.noun.kind == "hoop"}
    for k, edge in enumerate(scene.timeline.edges):
        if (
            edge.target in raised
            and edge.actor not in scene.supported_by
            and edge.event.value == "Toward"
            and edge.params.spin in ("roll", "slide")
        ):
            _throw_instead(scene, k)


def _topple_shots(scene: Scene, prompt: str) -> None:
    """What hits a tall thing far below its middle slides it along: it is kicked up instead."""
    from esg.graph.models import NodeEvent

    if _says_roll(prompt):
        return
    toppled = {n.participants[0] for n in scene.timeline.nodes if n.event is NodeEvent.TOPPLE}
    for k, edge in enumerate(scene.timeline.edges):
        if edge.target not in toppled or edge.event.value != "Toward":
            continue
        height = scene.world.entities[edge.target].noun.dimensions_cm[2]
        if edge.params.spin != "none" and (
            scene.world.entities[edge.actor].noun.dimensions_cm[2] < 0.5 * height
        ):
            _throw_instead(scene, k)


def _roll_down(scene: Scene, prompt: str, reasons: list[str]) -> None:
    """What rolls down needs something to roll down from."""
    t = prompt.lower()
    if not re.search(
        r"\b(?:roll\w*|slid\w*|bounc\w*|tumbl\w*)\s+down(?:hill|wards?)?\b(?!\s+the\s+(?:road|street|lane|alley|hall|track))",
        t,
    ):
        return
    slope = next((i for i, e in scene.world.entities.items() if "incline" in e.noun.traits), None)
    movers = [
        a for a, tr in scene.timeline.tracks.items() if tr.launched and a not in scene.supported_by
    ]
    if slope is None:
        if (
            re.search(r"down\s+(?:the|a|an)\s+\w+", t)
            and not re.search(r"downhill", t)
            and any(e.noun.kind == "ground" for e in scene.world.entities.values())
        ):
            return
        slope = _add(
            scene,
            "staircase" if re.search(r"stairs|steps", t) else "ramp",
            reasons,
            "something rolls down it",
        )
    for mover in movers[:1]:
        if mover != slope:
            scene.supported_by[mover] = slope


__all__ = ["Entity", "expand"]
