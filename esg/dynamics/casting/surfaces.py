"""The ground that a prompt tells of, ice under what slides on it, snow under what glides."""

from __future__ import annotations

from esg.dynamics.story.stagecraft import ground_friction, prop, support_of
from esg.dynamics.story.story import Story
from esg.graph.models import AssetConfiguration, EdgeEvent, EsgDocument
from esg.lexicon.grounds import grounds
from esg.lexicon.places import surfaces
from esg.metrics.plausibility.limits import limit, motion_of

ICE = grounds()["ice"].friction
"""Friction of ice and of what slides on it."""
OF_ICE = ("puck", "curling_stone", "curling stone")
"""Words of categories that are at home there."""

SOLES = 0.8
"""Share of a ground's grip that soles rub with: PhysX holds up to 12% more near rest, and who stops
brakes besides."""
WAXED = 0.05
"""Friction of a ski's base (on snow 0.02-0.1: Colbeck, Friction of snow skis, 1992)."""


def fit_ground(doc: EsgDocument) -> dict[str, AssetConfiguration]:
    """A ground, and soles on it, with the friction that it is said to have; see ice apart.

    Args:
        doc: A document with assets resolved.
    """
    wording = doc.scene_definition.wording
    row = None if wording is None else grounds().get(wording.surface or "")
    if row is None or row.name == "ice":
        return {}
    nodes = doc.spatial_relation_graph.nodes
    # A pair has the mean of both, and soles find no more than the grip.
    soles = 2.0 * SOLES * row.grip - row.friction
    most = {v.asset_id: soles for n, v in nodes.items() if _walks(doc, n)}
    most |= dict.fromkeys(_grounds(doc), row.friction)
    return {
        key: config.model_copy(update={"friction": friction})
        for key, friction in sorted(most.items())
        if (config := doc.asset_configurations[key]).friction > friction
    }


def _grounds(doc: EsgDocument) -> list[str]:
    """Assets that everything stands on."""
    nodes = doc.spatial_relation_graph.nodes.values()
    keys = {n.asset_id for n in nodes if n.is_structural}
    return sorted(key for key in keys if not doc.asset_configurations[key].proxies)


def fit_ice(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Ground and bodies as slippery as ice, where something is slid on it.

    Args:
        doc: A document with assets resolved.
        story: Its timeline.
    """
    nodes = doc.spatial_relation_graph.nodes
    wording = doc.scene_definition.wording
    told = None if wording is None else wording.surface
    said = told == "ice"
    slid = {a for a in story.phases if _slides(doc, story, a) and (said or _of_ice(doc, a))}
    icy = said or (told is None and ground_friction(doc) < limit("icy ground"))
    # Who skates or walks on ice goes on sliding when he has fallen.
    slid |= {n for n in nodes if icy and _walks(doc, n)}
    if not slid:
        return {}
    kinds = {nodes[a].asset_id for a in slid}
    kinds |= {v.asset_id for n, v in nodes.items() if _of_ice(doc, n)}
    kinds |= {*_grounds(doc)}
    return {
        key: config.model_copy(update={"friction": ICE})
        for key in sorted(kinds)
        if (config := doc.asset_configurations[key]).friction > ICE
    }


def fit_snow(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Snow under what glides (skis, sleds), which nothing carries over another ground.

    Args:
        doc: A document with assets resolved.
        story: Its timeline.
    """
    from esg.assets.configuration import parametric_entry
    from esg.assets.materials import MATERIALS

    nodes = doc.spatial_relation_graph.nodes
    where = doc.scene_definition.scene_parameters
    others = (s.said_as for s in surfaces().values() if s.material != "snow")
    if where.scene_type == "indoor" or any(where.environment in words for words in others):
        return {}
    entries = {
        actor: parametric_entry(doc.asset_configurations[nodes[actor].asset_id])
        for actor in story.phases
        if actor in nodes
    }
    gliding = {a for a, entry in entries.items() if entry is not None and "glides" in entry.flags}
    if not gliding:
        return {}
    most = {nodes[a].asset_id: WAXED for a in gliding}
    most |= dict.fromkeys(_grounds(doc), MATERIALS["snow"].friction)
    return {
        key: config.model_copy(update={"friction": friction})
        for key, friction in sorted(most.items())
        if (config := doc.asset_configurations[key]).friction > friction
    }


def _slides(doc: EsgDocument, story: Story, actor: str) -> bool:
    """Whether something is sent sliding over the ground."""
    body, first = prop(doc, actor), story.phases[actor][0]
    launched = first.edge.event is EdgeEvent.TOWARD and not story.flies(actor)
    return launched and not (body.rolls or body.wheeled) and support_of(doc, actor) is None


def _walks(doc: EsgDocument, name: str) -> bool:
    """Whether a thing moves on feet."""
    node = doc.spatial_relation_graph.nodes[name]
    category = doc.asset_configurations[node.asset_id].category
    return not node.is_structural and motion_of(node.label, category).moves == "legs"


def _of_ice(doc: EsgDocument, name: str) -> bool:
    """Whether a thing is at home on ice."""
    category = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id].category
    return any(word in category for word in OF_ICE)
