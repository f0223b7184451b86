"""Who hits whom in a story, and how fast the mover may arrive."""

from __future__ import annotations

from esg.dynamics.choreography.hits.demands import KEPT, passed_on
from esg.dynamics.choreography.stage import FASTEST_MPS
from esg.dynamics.story.stagecraft import prop
from esg.dynamics.story.story import Story, bounds, hits
from esg.graph.models import EdgeEvent, EsgDocument, TimelineNode

FALLS_TOO = 0.5
"""Share of a stated speed that counts where something thrown falls as well."""
DRIVEN_MPS = 2.5
"""Speed with which what is driven along a joint meets something: a door, a drawer."""
USUAL_CARRIED_MPS = 3.0
"""Speed with which something that was struck arrives at the next thing, where it is open."""


def carried(doc: EsgDocument, story: Story, name: str, node: TimelineNode) -> float:
    """Speed [m/s] at which what was set in motion by an earlier hit may arrive at an event."""
    before = story.ancestors(node.id)
    for hit, mover, target in hits(doc, story):
        if hit.id not in before or target != name or mover == name:
            continue
        active = story.is_active(mover)
        came = fastest(story, mover, hit.id) if active else carried(doc, story, mover, hit)
        stated = active and any(
            p.end.id == hit.id and p.edge.speed_is_prescribed for p in story.phases[mover]
        )
        speed = KEPT * passed_on(prop(doc, mover), prop(doc, name)) * came
        return speed if stated else min(speed, USUAL_CARRIED_MPS)
    return USUAL_CARRIED_MPS


def launched(story: Story, actor: str, node_id: str) -> bool:
    """Whether an actor meets an event by what a launch gave it, not under its own power."""
    return any(
        p.end.id == node_id and p.edge.event is EdgeEvent.TOWARD
        for p in story.phases.get(actor, ())
    )


def fastest(story: Story, actor: str, node_id: str) -> float:
    """Speed [m/s] at which an actor may arrive."""
    for phase in story.phases.get(actor, ()):
        if phase.end.id == node_id and phase.edge.event is EdgeEvent.DRIVE:
            return DRIVEN_MPS
        if phase.end.id != node_id or phase.edge.params.speed is None:
            continue
        low, high, _ = bounds(phase.edge.params.speed, (0.0, 100.0 * FASTEST_MPS))
        if phase.edge.speed_is_prescribed:
            share = FALLS_TOO if story.flies(actor) else 0.9
            return share * max(low, high) / 100.0
        thrown = phase.edge.event is EdgeEvent.TOWARD
        return 0.6 * FASTEST_MPS if thrown else max(high / 100.0, 8.0)
    return 3.0
