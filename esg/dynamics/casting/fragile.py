"""Casting of what a blow is to break: no heavier than the blow breaks it."""

from __future__ import annotations

from esg.dynamics.casting.changes import Configs, scaled
from esg.dynamics.casting.toppling import LIGHTEST
from esg.dynamics.choreography.stage import FASTEST_MPS
from esg.dynamics.story.stagecraft import prop, thrown_back
from esg.dynamics.story.story import Story, bounds, hits
from esg.graph.models import EsgDocument

SURELY_BREAKS = 1.35
"""A blow is so much harder than what is to break bears; the search asks for 1.25 times that."""
ARRIVES = 0.95
"""Share of a stated speed with which something gets there."""


def fit_fragile(doc: EsgDocument, story: Story) -> Configs:
    """Masses at which the blow of what hits them breaks things: a thin pane for a golf ball.

    A blow is (1 + e) times the reduced mass times its speed, and what it breaks bears its own mass
    times the change of speed that breaks it, which is the glass's and stays.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: Configs = {}
    for node, a, b in hits(doc, story):
        breaking = nodes[b].breaking
        if breaking is None or not story.breaks_after(node.id, b) or not story.is_active(a):
            continue
        key = nodes[b].asset_id
        if doc.asset_requirement[key].mass_is_prescribed:
            continue
        mover, target = prop(doc, a), prop(doc, b)
        reduced = mover.mass
        if not target.fixed:
            reduced *= target.mass / (mover.mass + target.mass)
        blow = thrown_back(mover, target) * reduced * _speed(story, a, node.id)
        share = blow / (SURELY_BREAKS * target.mass * breaking.speed / 100.0)
        if share < 1.0:
            out[key] = scaled(doc.asset_configurations[key], max(share, LIGHTEST))
    return out


def _speed(story: Story, actor: str, node_id: str) -> float:
    """Speed at which an actor may arrive [m/s]: a stated one, or the fastest that is guessed."""
    for phase in story.phases.get(actor, ()):
        if phase.end.id == node_id and phase.edge.speed_is_prescribed:
            low, high, _ = bounds(phase.edge.params.speed, (0.0, 100.0 * FASTEST_MPS))
            return ARRIVES * max(low, high) / 100.0
    return FASTEST_MPS
