"""The document as it is played: what casting chose applied to what draft and resolve wrote.

The saved document keeps every stage's words apart; whoever needs the bodies and the timeline that
are laid out, simulated, judged and drawn asks `effective` for them.
"""

from __future__ import annotations

from esg.graph.models import Casting, EsgDocument, SpatialRelationGraph, TimelineSystem


def effective(doc: EsgDocument) -> EsgDocument:
    """The document with its casting applied.

    Args:
        doc: A document; one that was not cast, or to which this was applied before, stays itself.

    Returns:
        The document with the chosen configurations, nodes, actors and segments in the place of the
        given ones, and without a `casting`. Choices for what the document lacks are left out.
    """
    casting = doc.casting
    if casting is None:
        return doc
    configurations = {
        key: casting.assets[key].configuration if key in casting.assets else given
        for key, given in doc.asset_configurations.items()
    }
    return doc.model_copy(
        update={
            "asset_configurations": configurations,
            "spatial_relation_graph": _graph(doc.spatial_relation_graph, casting),
            "timeline_system": _timeline(doc.timeline_system, casting),
            "casting": None,
        }
    )


def _graph(graph: SpatialRelationGraph, casting: Casting) -> SpatialRelationGraph:
    if not casting.nodes:
        return graph
    nodes = {
        name: node.model_copy(update={"is_static": casting.nodes[name].is_static})
        if name in casting.nodes
        else node
        for name, node in graph.nodes.items()
    }
    return graph.model_copy(update={"nodes": nodes})


def _timeline(timeline: TimelineSystem | None, casting: Casting) -> TimelineSystem | None:
    if timeline is None or not (casting.actors or casting.segments):
        return timeline
    actors = {
        name: actor.model_copy(update={"force_direction": casting.actors[name].force_direction})
        if name in casting.actors
        else actor
        for name, actor in timeline.actors.items()
    }
    sequence = timeline.sequence_graph
    edges = tuple(
        e.model_copy(update={"params": casting.segments[e.id].params})
        if e.id in casting.segments
        else e
        for e in sequence.edges
    )
    return timeline.model_copy(
        update={"actors": actors, "sequence_graph": sequence.model_copy(update={"edges": edges})}
    )
