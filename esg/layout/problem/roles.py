"""Parts that nodes play in a layout: what is the ground itself, what falls in the story."""

from __future__ import annotations

from esg.graph.models import EsgDocument, NodeEvent

GROUND_WORDS = ("ground", "floor", "terrain")


def falling_nodes(doc: EsgDocument) -> frozenset[str]:
    """Nodes that fall or topple in the story: they may start over the edge of what carries them."""
    if doc.timeline_system is None:
        return frozenset()
    return frozenset(
        n.participants[0]
        for n in doc.timeline_system.sequence_graph.nodes
        if n.event in (NodeEvent.FALL, NodeEvent.TOPPLE) and n.participants
    )


def ground_nodes(doc: EsgDocument) -> tuple[str, ...]:
    """Structural nodes that are the ground itself: by name, else by what they are made of.

    The name decides first, because roads and pitches are ground too in a wider sense.
    """
    graph = doc.spatial_relation_graph
    structural = [n for n, node in graph.nodes.items() if node.is_structural]

    def words(text: str) -> set[str]:
        return set(text.lower().replace("_", " ").replace("-", " ").split())

    named = tuple(n for n in structural if words(n) & set(GROUND_WORDS))
    if named:
        return named
    out = []
    for n in structural:
        config = doc.asset_configurations[graph.nodes[n].asset_id]
        if words(f"{config.category} {config.asset_name}") & set(GROUND_WORDS):
            out.append(n)
    return tuple(out[:1])
