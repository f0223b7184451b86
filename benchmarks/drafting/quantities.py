"""Whether a draft holds a stated quantity."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

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
    """Whether a draft holds a quantity that a label states.

    Args:
        doc: The draft.
        want: `quantity` (a key of `READ`, or of `Constraint.quantity`), its `value` or `range` in
            the units of labels (kg, m, m/s, s, degrees), and the `object` or `event` it is of.
    """
    kind = want["quantity"]
    read = READ.get(kind, _constraints)
    return any(read.same(found, want, read.factor) for found in read.values(_Draft(doc, want)))


class _Draft:
    """What a quantity may be read from."""

    def __init__(self, doc: EsgDocument, want: dict[str, Any]) -> None:
        graph, timeline = doc.spatial_relation_graph, doc.timeline_system
        self.want = want
        self.ids = bind(doc, want["object"]) if "object" in want else []
        self.assets = [doc.asset_requirement[graph.nodes[i].asset_id] for i in self.ids]
        self.relations = graph.edges.binary_relations
        self.points = timeline.sequence_graph.nodes if timeline else ()
        edges = timeline.sequence_graph.edges if timeline else ()
        self.segments = [e for e in edges if e.actor in self.ids]

    def constraints(self, *quantities: str) -> Iterator[float]:
        """Values of the constraints on the objects."""
        for point in self.points:
            for c in point.constraints:
                if c.object in self.ids and c.quantity in quantities:
                    yield c.value


class _Read(NamedTuple):
    """How a quantity is found.

    Args:
        values: All that a draft says of it.
        factor: Units of documents in one of labels.
        same: Whether a value is the one asked for.
    """

    values: Callable[[_Draft], Iterable[Any]]
    factor: float = 1.0
    same: Callable[[Any, dict[str, Any], float], bool] = _close


def _masses(draft: _Draft) -> Iterator[float]:
    return (a.expected_mass_kg for a in draft.assets if a.mass_is_prescribed)


def _sizes(draft: _Draft) -> Iterator[float]:
    for asset in draft.assets:
        if asset.dimensions_are_prescribed:
            yield from asset.expected_dimensions_cm


def _prescribed_speeds(draft: _Draft) -> Iterator[float]:
    for e in draft.segments:
        if e.speed_is_prescribed and e.params.speed is not None:
            yield e.params.speed


def _speeds(draft: _Draft) -> Iterator[float]:
    yield from _prescribed_speeds(draft)
    yield from draft.constraints("speed_before", "speed_after")


def _speeds_after(draft: _Draft) -> Iterator[float]:
    yield from draft.constraints("speed_after")
    yield from _prescribed_speeds(draft)


def _accelerations(draft: _Draft) -> Iterator[Any]:
    return (e.params.acceleration for e in draft.segments if e.params.acceleration is not None)


def _times(draft: _Draft) -> Iterator[Any]:
    event = draft.want["event"]
    names = {NODE_EVENTS.get(event, "Trigger")} | ({"Trigger"} if event == "turns" else set())
    for point in draft.points:
        if point.event.value not in names:
            continue
        for c in point.constraints:
            if c.quantity in ("time_since", "time_to_stop"):
                yield c.value
        if point.time_is_prescribed:
            yield point.window if point.timestamp is None else point.timestamp


def _angles(draft: _Draft) -> Iterator[Any]:
    for point in draft.points:
        if point.turn_degrees and point.participants[0] in draft.ids:
            yield point.turn_degrees
        yield from (c.value for c in point.constraints if c.quantity == "angle")
    for e in draft.segments:
        if e.params.elevation_deg is not None:
            yield e.params.elevation_deg


def _distances(draft: _Draft) -> Iterator[Any]:
    yield from draft.constraints("distance")
    yield from (r.distance_cm for r in draft.relations if r.distance_cm is not None)


_constraints = _Read(lambda draft: draft.constraints(draft.want["quantity"]))

READ = {
    "mass": _Read(_masses, 1.0, _has),
    "size": _Read(_sizes, 100.0, _has),
    "speed": _Read(_speeds, 100.0),
    "speed_before": _Read(_speeds, 100.0),
    "speed_after": _Read(_speeds_after, 100.0),
    "acceleration": _Read(_accelerations, 100.0),
    "time": _Read(_times),
    "time_since": _Read(_times),
    "time_to_stop": _Read(lambda draft: draft.constraints("time_to_stop", "time_since")),
    "angle": _Read(_angles),
    "height": _Read(lambda draft: draft.constraints("height"), 100.0),
    "distance": _Read(_distances, 100.0),
}
"""By what labels call the quantity; any other is a constraint of that name."""
