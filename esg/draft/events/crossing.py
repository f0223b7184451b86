"""How long who goes across a road or a lake takes: as long as its width needs at his pace."""

from __future__ import annotations

from collections.abc import Iterable

from esg.draft.discourse.referents.sizes import dimensions_of
from esg.draft.discourse.scene import LIVING, Scene
from esg.graph.models import NodeEvent, Predicate, Statement, TimelineSystem

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
    graph, windows = timeline.sequence_graph, dict[str, tuple[float, float]]()
    paces: dict[str, tuple[float, float]] = {}
    ends = {n.id: n for n in graph.nodes}
    things = scene.world.entities
    statements = tuple(statements)
    lengthwise = {(s.object, s.target) for s in statements if s.direction == "along"}
    for s in statements:
        across = s.predicate is Predicate.MOVES and s.direction == "across"
        flat = [things[i] for i in s.target if i in things and "decal" in things[i].noun.traits]
        if not across or not flat:
            continue
        along = (s.object, s.target) in lengthwise
        width = (max if along else min)(dimensions_of(flat[0])[:2])
        wet = flat[0].noun.kind == "water" and not along
        least, most = AFLOAT if wet else (PART, ALONG if along else ALL)
        for e in graph.edges:
            speed = e.params.speed
            kind = things[e.actor].noun.kind if e.actor in s.object else ""
            slow = kind in LIVING or kind == "watercraft"
            if slow and isinstance(speed, tuple) and e.params.elevation_deg is None:
                pace = 0.9 * speed[1]
                pace = min(pace, BRISK_CM_S) if kind in LIVING else pace
                if wet:
                    pace = min(pace, most * width / LEAST_S)
                    paces[e.to] = (round(0.7 * pace, 1), round(pace, 1))
                windows[e.to] = (round(least * width / pace, 2), round(most * width / pace, 2))
    ends_of = {e.actor: e.to for e in graph.edges}
    for r in scene.relations:  # who follows goes as long
        led = windows.get(ends_of.get(r.target, ""))
        if led is not None and r.kind == "behind" and r.source in ends_of:
            windows.setdefault(ends_of[r.source], led)
    edges = tuple(
        e.model_copy(
            update={
                "params": e.params.model_copy(
                    update={
                        "duration": windows[e.to],
                        "speed": paces.get(e.to, e.params.speed),
                    }
                )
            }
        )
        if e.to in windows and ends[e.to].event is NodeEvent.TRIGGER
        else e
        for e in graph.edges
    )
    nodes = tuple(
        n.model_copy(update={"window": windows[n.id]})
        if n.id in windows and n.event is NodeEvent.TRIGGER and not n.time_is_prescribed
        else n
        for n in graph.nodes
    )
    graph = graph.model_copy(update={"nodes": nodes, "edges": edges})
    return timeline.model_copy(update={"sequence_graph": graph})
