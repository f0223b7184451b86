"""Standing what the story tips over on its end: a plank, a book, a board usually drawn flat.

What lies flat cannot fall over. A board whose size the prompt states keeps its sides as they are.
"""

from __future__ import annotations

from esg.dynamics.story.story import Story
from esg.graph.models import AssetConfiguration, EdgeEvent, EsgDocument, NodeEvent, ProxyKind

THIN, NARROW = 0.1, 0.4
"""Height and width over length below which a thing of several parts is a stick that lies."""
FLAT, SAME = 0.35, 0.05
"""Height over length below which a board lies, and what its length may differ."""


def fit_upright(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Configurations on their ends of boards that topple, their broad sides in front.

    What a joint holds stays as it hangs: the board of a seesaw.
    """
    nodes = doc.spatial_relation_graph.nodes
    held = {j.child for j in doc.spatial_relation_graph.joints or ()}
    out: dict[str, AssetConfiguration] = {}
    for name, node in nodes.items():
        if node.is_structural or not story.topples(name) or name in held:
            continue
        config = doc.asset_configurations[node.asset_id]
        stated = doc.asset_requirement[node.asset_id].dimensions_are_prescribed
        passed_over = is_stick(config) and _met_by_a_leaf(story, name)
        if not stated and (is_board(config) or passed_over):
            out[node.asset_id] = _on_end(doc, node.asset_id, config)
    return out


def is_board(config: AssetConfiguration) -> bool:
    """Whether something is a single flat box without wheels."""
    height = config.dimensions_cm[2]
    boxes = [p.kind is ProxyKind.BOX for p in config.proxies]
    return boxes == [True] and not config.is_wheeled and height < FLAT * max(config.dimensions_cm)


def _met_by_a_leaf(story: Story, name: str) -> bool:
    """Whether what a joint moves hits something: a door, which passes over what lies."""
    driven = {a for a, ps in story.phases.items() if ps[0].edge.event is EdgeEvent.DRIVE}
    hits = (n for n in story.nodes.values() if n.event is NodeEvent.COLLISION)
    return any(name in n.participants and driven & {*n.participants} for n in hits)


def is_stick(config: AssetConfiguration) -> bool:
    """Whether something lies that is long and narrow: a broom, a rake."""
    length, width, height = config.dimensions_cm
    boxes = all(p.kind is ProxyKind.BOX for p in config.proxies)
    return boxes and not config.is_wheeled and height < THIN * length and width < NARROW * length


def _on_end(doc: EsgDocument, key: str, config: AssetConfiguration) -> AssetConfiguration:
    from esg.assets.stage import configure

    size = tuple(sorted(config.dimensions_cm))
    made = config
    # What is only drawn lying (a surfboard) is a plain board of its size on its end.
    for kind in ({}, {"asset_category": "plank", "asset_description": "upright plank"}):
        update: dict[str, object] = {
            **kind,
            "expected_dimensions_cm": size,
            "expected_mass_kg": config.mass_kg,
            "dimensions_are_prescribed": True,
            "mass_is_prescribed": True,
        }
        made = configure(key, doc.asset_requirement[key].model_copy(update=update))
        if abs(made.dimensions_cm[2] - size[2]) < SAME * size[2]:
            break
    return made.model_copy(update={"is_movable": True})
