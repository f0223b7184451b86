"""What a prompt is read as while it is typed, and what of it can be turned."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
import json
from typing import Any

from esg.graph.models import EsgDocument, Quantity, TimelineEdge

SPEED_SPAN = (0.25, 3.0)
"""How far a stated speed can be turned, as shares of it."""
MASS_SPAN = (0.1, 10.0)
TIME_SPAN_S = (0.1, 15.0)
FASTEST_CM_S = 15000.0


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


def read(prompt: str, seed: int) -> dict[str, Any]:
    """A prompt as the drafter reads it, for the page.

    Args:
        prompt: As `esg.api.inputs.clean_prompt` gives it.
        seed: Of the draft.

    Returns:
        Pieces of the prompt with what became of each, objects, events, warnings, what is not kept,
        violations, knobs and the document as text.
    """
    from esg.draft import draft
    from esg.fidelity import shortfalls, statement_rows
    from esg.graph import verify
    from esg.report.words import pieces

    doc = draft(prompt, seed=seed)
    data = doc.model_dump(mode="json", by_alias=True, exclude_none=True)
    rows = statement_rows(data)
    timeline = doc.timeline_system
    return {
        "pieces": pieces(prompt, data, rows),
        "objects": [n.label or name for name, n in doc.spatial_relation_graph.nodes.items()
                    if not n.is_structural],
        "events": [n.description for n in timeline.sequence_graph.nodes if n.participants]
        if timeline else [],
        "warnings": list(doc.coverage.warnings),
        "lost": shortfalls(data, rows),
        "violations": [v.to_json() for v in verify(doc)],
        "knobs": [asdict(k) for k in knobs(doc)],
        "document": json.dumps(data, indent=1, ensure_ascii=False),
    }  # fmt: skip


def knobs(doc: EsgDocument) -> list[Knob]:
    """Speeds, masses and times of a draft, in its order.

    Args:
        doc: A draft.
    """
    found: list[Knob] = []
    system, graph = doc.timeline_system, doc.spatial_relation_graph

    def called(node: str) -> str:
        return graph.nodes[node].label or node if node in graph.nodes else node

    for edge in system.sequence_graph.edges if system else ():
        if edge.params.speed is not None:
            found.append(_speed(edge, called(edge.actor)))
    for node in system.sequence_graph.nodes if system else ():
        if node.participants and node.window is not None:
            middle = 0.5 * sum(node.window) if node.timestamp is None else node.timestamp
            label = f"time: {node.description or node.id}"
            found.append(
                Knob(f"time/{node.id}", label, "s", *TIME_SPAN_S, middle, node.time_is_prescribed)
            )
    for name, node in graph.nodes.items():
        need = doc.asset_requirement.get(node.asset_id)
        if need is not None and need.is_movable and not node.is_structural and node.mentioned:
            low, high = (share * need.expected_mass_kg for share in MASS_SPAN)
            label = f"mass of {called(name)}"
            found.append(
                Knob(
                    f"mass/{node.asset_id}",
                    label,
                    "kg",
                    low,
                    high,
                    need.expected_mass_kg,
                    need.mass_is_prescribed,
                )
            )
    return list({k.id: k for k in found}.values())


def _speed(edge: TimelineEdge, who: str) -> Knob:
    low, high = _ends(edge.params.speed)
    middle = 0.5 * (low + high)
    span = (SPEED_SPAN[0] * middle, SPEED_SPAN[1] * middle) if low == high else (0.5 * low, high)
    return Knob(
        f"speed/{edge.id}",
        f"speed of {who} ({edge.event.value})",
        "m/s",
        max(span[0], 5.0) / 100.0,
        min(span[1], FASTEST_CM_S) / 100.0,
        middle / 100.0,
        edge.speed_is_prescribed,
    )


def _ends(value: Quantity | None) -> tuple[float, float]:
    if value is None:
        return 0.0, 0.0
    return value if isinstance(value, tuple) else (value, value)


def turned(doc: EsgDocument, values: Mapping[str, float]) -> EsgDocument:
    """A draft with numbers as sliders say: each becomes one that the prompt states.

    Args:
        doc: A draft.
        values: By knob id, in the knob's unit; those of no knob are passed over.
    """
    need = dict(doc.asset_requirement)
    for key, requirement in need.items():
        mass = values.get(f"mass/{key}")
        if mass is not None:
            stated = {"expected_mass_kg": mass, "mass_is_prescribed": True}
            need[key] = requirement.model_copy(update=stated)
    doc = doc.model_copy(update={"asset_requirement": need})
    system = doc.timeline_system
    if system is None:
        return doc
    edges, nodes = list(system.sequence_graph.edges), list(system.sequence_graph.nodes)
    for k, edge in enumerate(edges):
        speed = values.get(f"speed/{edge.id}")
        if speed is not None:
            params = edge.params.model_copy(update={"speed": 100.0 * speed})
            edges[k] = edge.model_copy(update={"params": params, "speed_is_prescribed": True})
    for k, node in enumerate(nodes):
        time = values.get(f"time/{node.id}")
        if time is not None:
            told = {"timestamp": time, "window": None, "time_is_prescribed": True}
            nodes[k] = node.model_copy(update=told)
    graph = system.sequence_graph.model_copy(update={"edges": tuple(edges), "nodes": tuple(nodes)})
    return doc.model_copy(
        update={"timeline_system": system.model_copy(update={"sequence_graph": graph})}
    )
