"""How long things are along which somebody goes: as long as the way, where that is open."""

from __future__ import annotations

from esg.dynamics.casting.changes import Configs, resized
from esg.dynamics.story.paces import EVERYDAY, top_speed
from esg.dynamics.story.stagecraft import default_speed, prop
from esg.dynamics.story.story import Story, bounds
from esg.graph.models import EsgDocument, Predicate

RUN_S = 3.0
"""Time of a run to nowhere with its coming to rest [s]."""
SLENDER = 4.0
"""A fence, a wall, a hedge is at least so many times as long as it is deep."""
LONGEST_M = 30.0
"""Nothing is made longer."""


def fit_along(doc: EsgDocument, story: Story) -> Configs:
    """Longer walls, fences, hedges beside a way that leads along them."""
    nodes, out = doc.spatial_relation_graph.nodes, Configs()
    for s in doc.statements or ():
        if s.predicate is not Predicate.MOVES or s.direction != "along" or len(s.target) != 1:
            continue
        node = nodes[s.target[0]]
        config = doc.asset_configurations[node.asset_id]
        need = max((_way(doc, story, a) for a in s.object if a in story.phases), default=0.0)
        length, width, height = config.dimensions_cm
        slender = max(length, width) >= SLENDER * min(length, width)
        fixed = node.is_structural or doc.asset_requirement[node.asset_id].dimensions_are_prescribed
        if fixed or not slender or config.is_movable or not config.proxies:
            continue
        longer = min(100.0 * need, 100.0 * LONGEST_M)
        if longer > max(length, width):
            size = (longer, width, height) if length > width else (length, longer, height)
            made = resized(doc, node.asset_id, config, 1.0, dimensions=size)
            out[node.asset_id] = made.model_copy(update={"is_movable": False})
    return out


def _way(doc: EsgDocument, story: Story, actor: str) -> float:
    """About how far [m] an actor goes."""
    phase = story.phases[actor][0]
    usual = min(default_speed(prop(doc, actor)), EVERYDAY * top_speed(doc, actor, False))
    low, high, _ = bounds(phase.edge.params.speed, (100.0 * usual, 100.0 * usual))
    return RUN_S * max(min(usual, 0.01 * high), 0.01 * low) + prop(doc, actor).length
