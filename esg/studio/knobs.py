"""The numbers of a draft that sliders turn: speeds, times, masses, and places as distances."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from esg.graph.models import (
    BinaryRelation,
    EdgeEvent,
    EsgDocument,
    EventConstraint,
    Quantity,
    RelationType,
    TimelineEdge,
    TimelineNode,
)

SPEED_SPAN = (0.25, 3.0)
"""How far a stated speed can be turned, as shares of it."""
MASS_SPAN = (0.1, 10.0)
TIME_SPAN_S = (0.1, 15.0)
GAP_SPAN_M = (0.05, 10.0)
FREE_GAP_M = 1.0
"""Where a slider stands for a distance that the prompt leaves open."""
APART = (
    RelationType.NEAR, RelationType.ADJACENT, RelationType.FAR_FROM, RelationType.LEFT_OF,
    RelationType.RIGHT_OF, RelationType.IN_FRONT_OF, RelationType.BEHIND,
)  # fmt: skip
"""Relations of things that stand apart, which a distance can be stated of."""
FASTEST_CM_S = 15000.0
HOW = {
    EdgeEvent.TOWARD: " when launched",
    EdgeEvent.ACCELERATED_MOTION: " as it speeds up",
    EdgeEvent.BRAKE: " as it brakes",
    EdgeEvent.TURN: " in its turn",
    EdgeEvent.INERTIAL_CONNECTOR: " between its hits",
    EdgeEvent.GUIDE: " as it is moved",
    EdgeEvent.DRIVE: " at its joint",
}
"""What a slider says of the part of a motion that it turns."""


@dataclass(frozen=True)
class Knob:
    """A number of a scene that a slider turns.

    Args:
        id: What `turned` knows it by.
        label: For people.
        unit: Of the values.
        low, high: Ends of the slider.
        value: Where it stands.
        stated: Whether the prompt gives the number; else the search is free to choose.
    """

    id: str
    label: str
    unit: str
    low: float
    high: float
    value: float
    stated: bool


def knobs(doc: EsgDocument) -> list[Knob]:
    """Speeds, times, distances and masses of a draft, in its order.

    Args:
        doc: A draft.
    """
    graph = doc.spatial_relation_graph
    names = {name: node.label or name for name, node in graph.nodes.items()}

    def called(node: str) -> str:
        return names.get(node, node)

    found = [*_of_timeline(doc, called), *_of_relations(doc, called)]
    for name, node in graph.nodes.items():
        need = doc.asset_requirement.get(node.asset_id)
        if need is not None and need.is_movable and not node.is_structural and node.mentioned:
            mass = need.expected_mass_kg
            low, high = (share * mass for share in MASS_SPAN)
            label = f"mass of {called(name)}"
            stated = need.mass_is_prescribed
            found.append(Knob(f"mass/{node.asset_id}", label, "kg", low, high, mass, stated))
    return list({k.id: k for k in found}.values())


def _of_timeline(doc: EsgDocument, called: Callable[[str], str]) -> Iterator[Knob]:
    system = doc.timeline_system
    if system is None:
        return
    for edge in system.sequence_graph.edges:
        if edge.params.speed is not None:
            yield _speed(edge, called(edge.actor))
    for node in system.sequence_graph.nodes:
        what = node.description or node.id
        if node.participants and node.window is not None:
            middle = 0.5 * sum(node.window) if node.timestamp is None else node.timestamp
            stated = node.time_is_prescribed
            yield Knob(f"time/{node.id}", f"time: {what}", "s", *TIME_SPAN_S, middle, stated)
        for k, constraint in enumerate(node.constraints):
            if constraint.quantity in ("distance", "height"):
                label = f"{constraint.quantity} of {called(constraint.object)}: {what}"
                yield _gap(f"end/{node.id}/{k}", label, constraint.value)


def _of_relations(doc: EsgDocument, called: Callable[[str], str]) -> Iterator[Knob]:
    for k, edge in enumerate(doc.spatial_relation_graph.edges.binary_relations):
        if edge.relation_type in APART:
            relation = edge.relation_type.value.replace("_", " ")
            label = f"distance: {called(edge.from_)} {relation} {called(edge.to)}"
            yield _gap(f"gap/{k}", label, edge.distance_cm)


def _gap(name: str, label: str, value: Quantity | None) -> Knob:
    """A distance, of a prompt that states it or leaves it open (None)."""
    if value is None:
        return Knob(name, label, "m", *GAP_SPAN_M, FREE_GAP_M, stated=False)
    middle = 0.5 * sum(_ends(value)) / 100.0
    low, high = min(GAP_SPAN_M[0], 0.5 * middle), max(GAP_SPAN_M[1], 2.0 * middle)
    return Knob(name, label, "m", low, high, middle, stated=True)


def _speed(edge: TimelineEdge, who: str) -> Knob:
    low, high = _ends(edge.params.speed or 0.0)
    middle = 0.5 * (low + high)
    span = (SPEED_SPAN[0] * middle, SPEED_SPAN[1] * middle) if low == high else (0.5 * low, high)
    return Knob(
        f"speed/{edge.id}",
        f"speed of {who}{HOW.get(edge.event, '')}",
        "m/s",
        max(span[0], 5.0) / 100.0,
        min(span[1], FASTEST_CM_S) / 100.0,
        middle / 100.0,
        edge.speed_is_prescribed,
    )


def _ends(value: Quantity) -> tuple[float, float]:
    return value if isinstance(value, tuple) else (value, value)


def turned(doc: EsgDocument, values: Mapping[str, float]) -> EsgDocument:
    """A draft with numbers as sliders say: each becomes one that the prompt states.

    Args:
        doc: A draft.
        values: By knob id, in the knob's unit; those of no knob are passed over.
    """
    need = {
        key: requirement.model_copy(
            update={"expected_mass_kg": values[f"mass/{key}"], "mass_is_prescribed": True}
        )
        if f"mass/{key}" in values
        else requirement
        for key, requirement in doc.asset_requirement.items()
    }
    spatial = doc.spatial_relation_graph
    relations = tuple(
        _apart(edge, values.get(f"gap/{k}"))
        for k, edge in enumerate(spatial.edges.binary_relations)
    )
    edges = spatial.edges.model_copy(update={"binary_relations": relations})
    changed: dict[str, Any] = {
        "asset_requirement": need,
        "spatial_relation_graph": spatial.model_copy(update={"edges": edges}),
    }
    system = doc.timeline_system
    if system is not None:
        told = {
            "edges": tuple(_moved(edge, values) for edge in system.sequence_graph.edges),
            "nodes": tuple(_timed(node, values) for node in system.sequence_graph.nodes),
        }
        graph = system.sequence_graph.model_copy(update=told)
        changed["timeline_system"] = system.model_copy(update={"sequence_graph": graph})
    return doc.model_copy(update=changed)


def _apart(edge: BinaryRelation, gap_m: float | None) -> BinaryRelation:
    if gap_m is None or edge.relation_type not in APART:
        return edge
    return edge.model_copy(update={"distance_cm": 100.0 * gap_m})


def _moved(edge: TimelineEdge, values: Mapping[str, float]) -> TimelineEdge:
    speed = values.get(f"speed/{edge.id}")
    if speed is None:
        return edge
    params = edge.params.model_copy(update={"speed": 100.0 * speed})
    return edge.model_copy(update={"params": params, "speed_is_prescribed": True})


def _timed(node: TimelineNode, values: Mapping[str, float]) -> TimelineNode:
    def ended(k: int, constraint: EventConstraint) -> EventConstraint:
        gap_m = values.get(f"end/{node.id}/{k}")
        if gap_m is None or constraint.quantity not in ("distance", "height"):
            return constraint
        return constraint.model_copy(update={"value": 100.0 * gap_m})

    changed: dict[str, Any] = {
        "constraints": tuple(ended(k, c) for k, c in enumerate(node.constraints))
    }
    time = values.get(f"time/{node.id}")
    if time is not None:
        changed |= {"timestamp": time, "window": None, "time_is_prescribed": True}
    return node.model_copy(update=changed)
