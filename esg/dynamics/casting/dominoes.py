"""What falls onto its equal is to be down first: where sizes are open and there is room, it grows.

A toy domino takes 0.02 s from where it counts as toppled to the touch of its equal, a slab of a
metre a tenth of a second and more (`story.slabs`): such a chain is built of garden dominoes.
"""

from __future__ import annotations

import math

from esg.dynamics.casting.changes import resized
from esg.dynamics.story.slabs import BY_ITSELF_S, KNOCKED_S, ORDER_S, REACH
from esg.dynamics.story.stagecraft import support_of, top_surface
from esg.dynamics.story.story import Story, hits
from esg.graph.models import AssetConfiguration, EsgDocument, NodeEvent, TimelineNode
from esg.layout.problem.patterns import is_domino_like

TALLEST_CM, LARGEST = 180.0, 2.5
"""Most height of a garden domino, and the most that other slabs grow."""
TOUCHED = 0.35
"""Height of the first hit, over that of a slab, from which on it surely tips it over."""
LIGHTEST = 0.1
"""Least share of its mass: cut of foam instead of wood."""
TABLE = 2.0
"""Most that the table under them grows (`loads`)."""


def fit_falling(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Slabs so large that they are down before they hit the next one, where the story says so.

    Args:
        doc: A document with assets resolved.
        story: Its timeline.
    """
    nodes = doc.spatial_relation_graph.nodes
    needed: dict[str, float] = {}
    for node in story.nodes.values():
        knocked = _falls_onto_equal(doc, story, node)
        if knocked is None:
            continue
        takes = KNOCKED_S if knocked else BY_ITSELF_S
        for key in {nodes[n].asset_id for n in node.participants[:2]}:
            needed[key] = max(needed.get(key, 0.0), 100.0 * (ORDER_S / takes) ** 2)
    if needed:
        # Equals stay equals.
        needed = dict.fromkeys(sorted(needed), max(needed.values()))
    out: dict[str, AssetConfiguration] = {}
    for key, height in needed.items():
        config = doc.asset_configurations[key]
        factor = height / config.dimensions_cm[2]
        most = TALLEST_CM / config.dimensions_cm[2]
        if config.category != "domino":
            most = min(most, LARGEST)
        if not 1.0 < factor <= most or height > _highest_hit(doc, story, key):
            continue
        if _has_room(doc, key, height):
            made = resized(doc, key, config, factor)
            light = max(LIGHTEST, 1.0 / factor)
            out[key] = made.model_copy(
                update={
                    "mass_kg": light * made.mass_kg,
                    "inertia_kg_cm2": tuple(light * v for v in made.inertia_kg_cm2),
                }
            )
    return out


def _highest_hit(doc: EsgDocument, story: Story, key: str) -> float:
    """Greatest height [cm] of slabs that all that hits them on the ground would tip over."""
    nodes = doc.spatial_relation_graph.nodes
    most = math.inf
    for _, a, b in hits(doc, story):
        flies = story.is_active(a) and story.flies(a)
        if nodes[b].asset_id != key or nodes[a].asset_id == key or flies:
            continue
        mover = doc.asset_configurations[nodes[a].asset_id]
        if mover.category == doc.asset_configurations[key].category:
            continue
        touch = (0.5 if mover.rolls else 1.0) * mover.dimensions_cm[2]
        most = min(most, touch / TOUCHED)
    return most


def _falls_onto_equal(doc: EsgDocument, story: Story, node: TimelineNode) -> bool | None:
    """Whether something knocked over what is to be down before it hits its equal here.

    None where nothing is.
    """
    nodes = doc.spatial_relation_graph.nodes
    if node.event is not NodeEvent.COLLISION or len(node.participants) < 2:
        return None
    before = [story.nodes[i] for i in story.ancestors(node.id)]
    for a, b in (node.participants[:2], node.participants[1::-1]):
        if a not in nodes or b not in nodes:
            continue
        if not any(n.event is NodeEvent.TOPPLE and a in n.participants for n in before):
            continue
        keys = nodes[a].asset_id, nodes[b].asset_id
        configs = [doc.asset_configurations[k] for k in keys]
        wanted = [doc.asset_requirement[k] for k in keys]
        if any(r.dimensions_are_prescribed or r.mass_is_prescribed for r in wanted):
            continue
        alike = configs[0].category == configs[1].category
        if alike and all(is_domino_like(*c.dimensions_cm) for c in configs):
            return any(n.event is NodeEvent.COLLISION and a in n.participants for n in before)
    return None


def _has_room(doc: EsgDocument, key: str, height_cm: float) -> bool:
    """Whether all of a kind fit in a row on what they stand on, once they are so high."""
    nodes = doc.spatial_relation_graph.nodes
    alike = [n for n, v in nodes.items() if v.asset_id == key]
    for support in {s for n in alike if (s := support_of(doc, n)) is not None}:
        wanted = doc.asset_requirement.get(nodes[support].asset_id)
        grows = 1.0 if wanted is None or wanted.dimensions_are_prescribed else TABLE
        room = 2.0 * grows * max(top_surface(doc, support).half_extents_cm)
        if len(alike) * height_cm * REACH > room:
            return False
    return True
