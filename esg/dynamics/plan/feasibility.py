"""Why a scene cannot do what its prompt asks, where a closed form says so."""

from __future__ import annotations

from esg.dynamics.choreography.stage import FASTEST_MPS
from esg.dynamics.story.stagecraft import Prop, prop
from esg.dynamics.story.story import Story, bounds
from esg.dynamics.story.tipping import first_touch, least_topple_speed, stand_of
from esg.graph.models import EsgDocument, NodeEvent, TimelineNode
from esg.units import m_from_cm

BEYOND = 1.5
"""How far a closed form must miss before it counts as proof: it knows neither spin nor tumbling."""


def impossible(doc: EsgDocument, story: Story) -> dict[str, str]:
    """Events that physics rules out, by id, each with one sentence that says why.

    Args:
        doc: A document with assets.
        story: Its timeline.
    """
    out: dict[str, str] = {}
    for node in story.nodes.values():
        if node.event is NodeEvent.TOPPLE:
            why = _too_weak_to_topple(doc, story, node)
            if why:
                out[node.id] = why
    return out


def ruled_out(doc: EsgDocument, story: Story) -> frozenset[str]:
    """Events that physics rules out, and those that follow from them."""
    first = set(impossible(doc, story))
    return frozenset(k for k in story.nodes if k in first or story.ancestors(k) & first)


def _too_weak_to_topple(doc: EsgDocument, story: Story, node: TimelineNode) -> str:
    """Why the hit before a topple cannot bring it about; "" where it may."""
    nodes = doc.spatial_relation_graph.nodes
    target = node.participants[0] if node.participants else ""
    before = story.ancestors(node.id)
    for hit in story.nodes.values():
        if hit.id not in before or hit.event is not NodeEvent.COLLISION:
            continue
        movers = [p for p in hit.participants if p != target]
        if target not in hit.participants or not movers or target in story.group_of:
            continue
        mover = movers[0]
        if mover not in nodes or target not in nodes or story.is_active(target):
            continue
        flies = story.is_active(mover) and story.flies(mover)
        hitting, struck = prop(doc, mover), prop(doc, target)
        needed = least_topple_speed(hitting, struck, flies=flies)
        fastest = fastest_speed(story, mover, hit.id)
        if needed > BEYOND * fastest:
            return (
                f"{target} cannot topple: {mover} would have to hit it at {needed:.0f} m/s, "
                f"but reaches {fastest:.0f} m/s at most{_where(hitting, struck, flies=flies)}"
            )
    return ""


def _where(mover: Prop, target: Prop, *, flies: bool) -> str:
    """What a hit below the centre of mass has to do with it; "" for one above."""
    stand = stand_of(target)
    touch = first_touch(mover, target, stand, flies=flies)
    if touch is None or touch.height >= stand.height:
        return ""
    return (
        f"; it meets it {100.0 * touch.height:.0f} cm above the ground, below its centre of mass "
        f"at {100.0 * stand.height:.0f} cm"
    )


def fastest_speed(story: Story, actor: str, node_id: str) -> float:
    """Highest speed [m/s] at which an actor can arrive at an event."""
    for phase in story.phases.get(actor, ()):
        if phase.end.id == node_id and phase.edge.speed_is_prescribed:
            _, high, _ = bounds(phase.edge.params.speed, (0.0, 100.0 * FASTEST_MPS))
            return m_from_cm(high)
    return 2.0 * FASTEST_MPS
