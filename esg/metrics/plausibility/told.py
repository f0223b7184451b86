"""What a document says that plausibility has to know: who moves by himself, what is prescribed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
import re

from esg.graph.casting import effective
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, Predicate, Quantity, Role
from esg.units import m_from_cm

_OFF_ROAD = re.compile(
    r"\boff-?road\b|\b(?:off|leav(?:es?|ing))\s+(?:of\s+)?(?:the\s+)?"
    r"(?:road|street|highway|lane|track|roadway|pavement)\b",
    re.IGNORECASE,
)
_TOO_EARLY = (NodeEvent.SCENE_START, NodeEvent.TRIGGER)


@dataclass(frozen=True)
class Told:
    """What is known of a scene beside its physics.

    Args:
        movers: Bodies that may set out before anything touches them: whoever acts, and whatever
            the first events are about (a tree that topples, a ball that falls), what wobbles.
        speeds_mps: The largest speed that the prompt states of a body.
        slides: Bodies that are said to slide, or not to roll.
        surface: dry, or a row of the table of grounds.
        off_road: Whether something is said to leave the road.
        stands_on: By body, what it stands on or in at the start.
    """

    movers: frozenset[str] = frozenset()
    speeds_mps: Mapping[str, float] = field(default_factory=dict[str, float])
    slides: frozenset[str] = frozenset()
    surface: str = "dry"
    off_road: bool = False
    stands_on: Mapping[str, str] = field(default_factory=dict[str, str])


def told_of(doc: EsgDocument) -> Told:
    """What a document says, drafted or cast."""
    doc = effective(doc)
    definition = doc.scene_definition
    groups: dict[str, list[str]] = {}
    for name, node in doc.spatial_relation_graph.nodes.items():
        groups.setdefault(node.group or name, []).append(name)

    def members(names: Iterable[str]) -> list[str]:
        return [n for name in names for n in groups.get(name, [name])]

    slides = {n for s in doc.statements or () if s.predicate is Predicate.SLIDES for n in s.object}
    # What wobbles of its own is let go from a lean.
    wobbles = (s for s in doc.statements or () if s.predicate is Predicate.WOBBLES)
    movers = {n for s in wobbles if s.when == "throughout" for n in s.object}
    speeds: dict[str, float] = {}
    if doc.timeline_system is not None:
        timeline = doc.timeline_system
        movers |= {n for n, a in timeline.actors.items() if a.role is Role.ACTIVE}
        graph = timeline.sequence_graph
        nodes = {n.id: n for n in graph.nodes}
        later = {e.to for e in graph.edges if nodes[e.from_].event not in _TOO_EARLY}
        first = [n for n in graph.nodes if n.event not in _TOO_EARLY and n.id not in later]
        movers |= {p for n in first for p in n.participants[:1]}
        for edge in graph.edges:
            if edge.params.spin in ("slide", "none") or edge.event is EdgeEvent.SPIN:
                slides.add(edge.actor)
            if edge.speed_is_prescribed and edge.params.speed is not None:
                _raise(speeds, members([edge.actor]), edge.params.speed)
        for node in graph.nodes:
            for c in node.constraints:
                if c.quantity in ("speed_after", "speed_before"):
                    _raise(speeds, members([c.object]), c.value)
    return Told(
        movers=frozenset(members(movers)),
        speeds_mps=speeds,
        slides=frozenset(members(slides)),
        surface=surface_of(doc),
        off_road=_OFF_ROAD.search(definition.original_description) is not None,
        stands_on=_stands_on(doc),
    )


def _stands_on(doc: EsgDocument) -> dict[str, str]:
    graph = doc.spatial_relation_graph
    regions = graph.semantic_regions
    placed = ((n, regions.get(node.semantic_region or "")) for n, node in graph.nodes.items())
    return {n: r.parent_object for n, r in placed if r is not None}


def surface_of(doc: EsgDocument) -> str:
    """What a prompt says of the ground: dry, or a row of the table of grounds."""
    said = doc.scene_definition.wording
    return "dry" if said is None or said.surface is None else said.surface


def _raise(speeds: dict[str, float], names: Iterable[str], value: Quantity) -> None:
    most = m_from_cm(max(value) if isinstance(value, tuple) else value)
    for name in names:
        speeds[name] = max(speeds.get(name, 0.0), most)
