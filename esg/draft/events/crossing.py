"""How long who goes across a road or a lake takes: as long as its width needs at his pace."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.sizes import dimensions_of
from esg.draft.discourse.scene import LIVING, Scene
from esg.graph.models import (
    MotionParams,
    NodeEvent,
    Predicate,
    SequenceGraph,
    Statement,
    TimelineSystem,
)

PART, ALL, ALONG = 0.6, 1.2, 0.85
"""Shares of the width that are gone at least and at most: half is crossing; of a bridge, whose
length it is, less than all."""
AFLOAT = (0.55, 0.7)
"""The same of a water, which what floats or swims on it does not leave."""
BRISK_CM_S = 300.0
"""What goes on foot at a speed that is left open goes no faster."""
LEAST_S = 2.0
"""So long it takes at least to cross a water: on a pond boats are slow, and soon at rest."""


def take_time(
    timeline: TimelineSystem | None, statements: Iterable[Statement], scene: Scene
) -> TimelineSystem | None:
    """The timeline in which who crosses something flat has the time to get to its other side.

    Args:
        timeline: Its open motions end after a second or so.
        statements: Which of them lead across what.
        scene: Sizes of what is crossed.
    """
    if timeline is None:
        return None
    graph = timeline.sequence_graph
    open_ended = {n.id for n in graph.nodes if n.event is NodeEvent.TRIGGER}
    told = {k: v for k, v in _times(graph, tuple(statements), scene).items() if k in open_ended}
    edges = tuple(
        e.model_copy(update={"params": e.params.model_copy(update=_params(told[e.to]))})
        if e.to in told
        else e
        for e in graph.edges
    )
    begun = {e.to: _latest(graph, e.from_) for e in graph.edges if e.to in told}
    nodes = tuple(
        n.model_copy(update={"window": _after(begun[n.id], told[n.id].window)})
        if n.id in told and not n.time_is_prescribed
        else n
        for n in graph.nodes
    )
    graph = graph.model_copy(update={"nodes": nodes, "edges": edges})
    return timeline.model_copy(update={"sequence_graph": graph})


def _latest(graph: SequenceGraph, event: str) -> float:
    """When an event has happened at the latest [s]."""
    node = next(n for n in graph.nodes if n.id == event)
    return node.window[1] if node.window is not None else node.timestamp or 0.0


def _after(begin: float, span: tuple[float, float]) -> tuple[float, float]:
    """When what begins at a time and takes some is over [s]."""
    return round(begin + span[0], 2), round(begin + span[1], 2)


@dataclass(frozen=True)
class _Crossing:
    """How long a way across takes [s], and how fast it goes where that is slower than usual."""

    window: tuple[float, float]
    speed_cm_s: tuple[float, float] | None = None


def _params(crossing: _Crossing) -> dict[str, tuple[float, float]]:
    slower = {} if crossing.speed_cm_s is None else {"speed": crossing.speed_cm_s}
    return {"duration": crossing.window, **slower}


def _times(
    graph: SequenceGraph, statements: Sequence[Statement], scene: Scene
) -> dict[str, _Crossing]:
    """Of each way across something flat, by the event that ends it."""
    things, out = scene.world.entities, dict[str, _Crossing]()
    lengthwise = {(s.object, s.target) for s in statements if s.direction == "along"}
    for s in statements:
        across = s.predicate is Predicate.MOVES and s.direction == "across"
        flat = [things[i] for i in s.target if i in things and "decal" in things[i].noun.traits]
        if not across or not flat:
            continue
        along = (s.object, s.target) in lengthwise
        for e in graph.edges:
            kind = things[e.actor].noun.kind if e.actor in s.object else ""
            if kind in LIVING or kind == "watercraft":
                crossing = _crossing(e.params, kind, flat[0], along=along)
                out |= {} if crossing is None else {e.to: crossing}
    ends_of = {e.actor: e.to for e in graph.edges}
    for r in scene.relations:  # who follows goes as long
        led = out.get(ends_of.get(r.target, ""))
        if led is not None and r.kind == "behind" and r.source in ends_of:
            out.setdefault(ends_of[r.source], _Crossing(led.window))
    return out


def _crossing(params: MotionParams, kind: str, flat: Entity, *, along: bool) -> _Crossing | None:
    """How long a motion takes across something; None where its speed is told, or it flies."""
    if not isinstance(params.speed, tuple) or params.elevation_deg is not None:
        return None
    width = (max if along else min)(dimensions_of(flat)[:2])
    wet = flat.noun.kind == "water" and not along
    least, most = AFLOAT if wet else (PART, ALONG if along else ALL)
    pace = 0.9 * params.speed[1]
    pace = min(pace, BRISK_CM_S) if kind in LIVING else pace
    pace = min(pace, most * width / LEAST_S) if wet else pace
    return _Crossing(
        (round(least * width / pace, 2), round(most * width / pace, 2)),
        (round(0.7 * pace, 1), round(pace, 1)) if wet else None,
    )
