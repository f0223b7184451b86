"""Those who only walk about keep their balance.

A walker is moved by its program; what its soles rub off in every step tilts it forward and turns
it back, by tens of degrees in a few seconds. So where nothing is to happen to it but its way, its
weight is low and hard to turn, as if its legs carried it.
"""

from __future__ import annotations

from esg.dynamics.casting.changes import Configs
from esg.dynamics.story.stagecraft import ground_friction, prop, support_of
from esg.dynamics.story.story import POWERED, Story
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent

STEADIER = 10.0
"""Factor on its inertia: its soles turn it against its way so much less."""
SURELY = 0.6
"""Share of the height of its weight at which a walker would begin to tip over."""
_WALKED = (*POWERED, EdgeEvent.TURN, EdgeEvent.BRAKE)
_ON_THE_WAY = frozenset(
    {NodeEvent.SCENE_START, NodeEvent.TRIGGER, NodeEvent.STOP, NodeEvent.HEADING_REACHED}
    | {NodeEvent.MISS, NodeEvent.REACH, NodeEvent.POSITION_AT}
)
"""Events that nothing touches a walker in."""


def fit_balanced(doc: EsgDocument, story: Story) -> Configs:
    """A low weight, hard to turn, of those who walk about and touch nothing."""
    nodes = doc.spatial_relation_graph.nodes
    out: Configs = {}
    walkers = {a for a in story.phases if _only_walks(doc, story, a)}
    for actor in sorted(walkers):
        key = nodes[actor].asset_id
        if not all(n in walkers for n, node in nodes.items() if node.asset_id == key):
            continue
        config, body = doc.asset_configurations[key], prop(doc, actor)
        grip = 0.5 * (config.friction + ground_friction(doc))
        x, y, z = config.center_of_mass_cm
        low = 100.0 * SURELY * min(body.half_length, body.half_width) / max(grip, 1e-3)
        out[key] = config.model_copy(
            update={
                "center_of_mass_cm": (x, y, min(z, low)),
                "inertia_kg_cm2": tuple(STEADIER * v for v in config.inertia_kg_cm2),
            }
        )
    return out


def _only_walks(doc: EsgDocument, story: Story, actor: str) -> bool:
    """Whether an actor goes on its feet all the time, and nothing touches it."""
    body = prop(doc, actor)
    carries = any(
        support_of(doc, n) == actor for n in doc.spatial_relation_graph.nodes if n != actor
    )
    if body.wheeled or body.rolls or story.flies(actor) or carries:
        return False
    walks = all(p.edge.event in _WALKED for p in story.phases[actor])
    events = (n.event for n in story.nodes.values() if actor in n.participants)
    return walks and all(e in _ON_THE_WAY for e in events)
