"""Whether a draft holds a stated quantity."""

from __future__ import annotations

from typing import Any

from benchmarks.drafting.corpus import bind
from benchmarks.drafting.events import NODE_EVENTS
from esg.graph.models import EsgDocument

RELATIVE_TOLERANCE = 0.02


def _close(found: Any, want: dict[str, Any], factor: float) -> bool:
    low, high = found if isinstance(found, (tuple, list)) else (found, found)
    low, high = low / factor, high / factor
    if "value" in want:
        v = want["value"]
        return abs(low - v) <= RELATIVE_TOLERANCE * abs(v) and abs(
            high - v
        ) <= RELATIVE_TOLERANCE * abs(v)
    a, b = want["range"]
    good_low = abs(low - a) <= 0.1 * max(abs(a), 0.5 * (b or a), 0.1) + 1e-9
    return good_low and (b is None or abs(high - b) <= RELATIVE_TOLERANCE * abs(b))


def _has(found: float, want: dict[str, Any], factor: float) -> bool:
    """Whether an object has a stated mass or size, which is one value: any of a stated range."""
    low, high = want.get("range", (None, None))
    if low is None or high is None:
        return _close(found, want, factor)
    return low <= found / factor <= high


def has_quantity(doc: EsgDocument, want: dict[str, Any]) -> bool:
    nodes = doc.spatial_relation_graph.nodes
    kind = want["quantity"]
    ids = bind(doc, want["object"]) if "object" in want else []
    assets = [doc.asset_requirement[nodes[i].asset_id] for i in ids]
    timeline = doc.timeline_system
    points = timeline.sequence_graph.nodes if timeline else ()
    edges = timeline.sequence_graph.edges if timeline else ()
    if kind == "mass":
        return any(a.mass_is_prescribed and _has(a.expected_mass_kg, want, 1.0) for a in assets)
    if kind == "size":
        return any(
            a.dimensions_are_prescribed
            and any(_has(x, want, 100.0) for x in a.expected_dimensions_cm)
            for a in assets
        )
    if kind in ("speed", "speed_before"):
        stated = [
            e.params.speed
            for e in edges
            if e.actor in ids and e.speed_is_prescribed and e.params.speed is not None
        ]
        stated += [
            c.value
            for n in points
            for c in n.constraints
            if c.object in ids and c.quantity in ("speed_before", "speed_after")
        ]
        return any(_close(v, want, 100.0) for v in stated)
    if kind == "acceleration":
        return any(
            e.params.acceleration is not None
            and e.actor in ids
            and _close(e.params.acceleration, want, 100.0)
            for e in edges
        )
    if kind in ("time", "time_since"):
        name = NODE_EVENTS.get(want["event"], "Trigger")
        for n in points:
            if n.event.value != name and not (
                want["event"] == "turns" and n.event.value == "Trigger"
            ):
                continue
            for c in n.constraints:
                if c.quantity in ("time_since", "time_to_stop") and _close(c.value, want, 1.0):
                    return True
            if n.time_is_prescribed and _close(
                n.timestamp if n.timestamp is not None else n.window, want, 1.0
            ):
                return True
        return False
    if kind == "angle":
        values: list[Any] = [
            n.turn_degrees for n in points if n.turn_degrees and n.participants[0] in ids
        ]
        values += [
            e.params.elevation_deg
            for e in edges
            if e.actor in ids and e.params.elevation_deg is not None
        ]
        values += [c.value for n in points for c in n.constraints if c.quantity == "angle"]
        return any(_close(v, want, 1.0) for v in values)
    factor = 100.0 if kind in ("speed_after", "height", "distance") else 1.0
    stated = [
        c.value for n in points for c in n.constraints if c.object in ids and c.quantity == kind
    ]
    if kind == "distance":
        stated += [
            r.distance_cm
            for r in doc.spatial_relation_graph.edges.binary_relations
            if r.distance_cm is not None
        ]
    if kind == "time_to_stop":
        stated += [
            c.value
            for n in points
            for c in n.constraints
            if c.object in ids and c.quantity == "time_since"
        ]
    if kind == "speed_after":
        stated += [
            e.params.speed
            for e in edges
            if e.actor in ids and e.speed_is_prescribed and e.params.speed is not None
        ]
    return any(_close(v, want, factor) for v in stated)
