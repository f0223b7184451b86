"""What something enters has an inside: a net is a goal's, a crate is open, a tent can be entered.

Assets that are usually solid, or drawn flat, get the region that an event speaks of. On the ground
that is a shell of walls and a roof whose front (+X) is open; from above it is an open vessel.
"""

from __future__ import annotations

from esg.dynamics.casting.changes import resized
from esg.dynamics.casting.containers import comes_down, down_a_slope
from esg.dynamics.story.story import Story
from esg.graph.models import (
    AssetConfiguration,
    EsgDocument,
    NamedRegion,
    NodeEvent,
    Proxy,
    ProxyKind,
    TimelineNode,
)

VESSELS = ("open_crate", "bucket")
GOALS = {"puck": "hockey_goal"}
"""Kind of goal by a word for what goes in; `goal` for all others."""
WALL = 0.03
"""Thickness of a shell's walls as a share of its least extent."""
ROOMY = 1.5
"""Least width of a shell over that of what goes in."""
AREA_CM = 100.0
"""Height of the space over what is drawn flat."""
LOW = 0.65
"""The same over the height of what falls there: its middle is in it once it lies there, not before
it has fallen."""


def fit_openings(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Configurations of what shall be entered but has no such region.

    Args:
        doc: A document with assets resolved.
        story: Its timeline.
    """
    out: dict[str, AssetConfiguration] = {}
    nodes = doc.spatial_relation_graph.nodes
    for node in story.nodes.values():
        owner, _, name = (node.region or "").partition("/")
        if node.event is not NodeEvent.ENTER_REGION or owner not in nodes or not node.participants:
            continue
        key = nodes[owner].asset_id
        config = out.get(key, doc.asset_configurations[key])
        if node.participants[0] not in nodes or any(r.name == name for r in config.regions):
            continue
        made = _opened(doc, story, node, owner, config, name)
        if made is not None:
            out[key] = made
    return out


def _opened(
    doc: EsgDocument,
    story: Story,
    node: TimelineNode,
    owner: str,
    config: AssetConfiguration,
    name: str,
) -> AssetConfiguration | None:
    nodes = doc.spatial_relation_graph.nodes
    key, thing = nodes[owner].asset_id, node.participants[0]
    words = f"{nodes[owner].label} {owner.replace('_', ' ')}".lower().split()
    if not config.proxies:
        length, width, height = config.dimensions_cm
        high = AREA_CM
        if _falls_first(story, node, thing):
            body = doc.asset_configurations[nodes[thing].asset_id]
            high = min(high, max(LOW * body.dimensions_cm[2], 1.0))
        over = NamedRegion(
            name=name,
            kind="area",
            center_cm=(0.0, 0.0, height + 0.5 * high),
            half_extents_cm=(0.5 * length, 0.5 * width, 0.5 * high),
        )
        return config.model_copy(update={"regions": (*config.regions, over)})
    if "net" in words or config.category == "goal":
        entering = f"{nodes[thing].label} {thing}".lower()
        kind = next((v for k, v in GOALS.items() if k in entering), "goal")
        return _remade(doc, key, config, kind, name, usual_size=True)
    if comes_down(story, node, thing) or down_a_slope(doc, story, thing, owner):
        for kind in VESSELS:
            made = _remade(doc, key, config, kind, name)
            if made is not None:
                return made
        return None
    return _shell(config, doc.asset_configurations[nodes[thing].asset_id], name)


def _falls_first(story: Story, node: TimelineNode, thing: str) -> bool:
    """Whether a thing falls off something before it enters."""
    for other in story.nodes.values():
        if other.event is NodeEvent.FALL and thing in other.participants:
            return node.id in {n.id for n in story.after(other.id)}
    return False


def _remade(
    doc: EsgDocument,
    key: str,
    config: AssetConfiguration,
    kind: str,
    name: str,
    *,
    usual_size: bool = False,
) -> AssetConfiguration | None:
    """The same thing made as another one that has an inside; None if that has none either."""
    from esg.assets.library.catalogue import entries_by_name

    entry = entries_by_name().get(kind)
    if entry is None:
        return None
    wanted = doc.asset_requirement[key].model_copy(
        update={"asset_category": kind, "asset_description": entry.name.replace("_", " ")}
    )
    if usual_size and not doc.asset_requirement[key].dimensions_are_prescribed:
        config = config.model_copy(
            update={"dimensions_cm": entry.dimensions_cm, "mass_kg": entry.mass_kg}
        )
    made = resized(doc, key, config, 1.0, wanted)
    inside = next((r for r in made.regions if r.kind in ("goal", "inside")), None)
    if inside is None:
        return None
    if any(r.name == name for r in made.regions):
        return made
    return made.model_copy(
        update={"regions": (*made.regions, inside.model_copy(update={"name": name}))}
    )


def _shell(config: AssetConfiguration, thing: AssetConfiguration, name: str) -> AssetConfiguration:
    """A body that can be entered on the ground: two sides, a back and a roof."""
    length, width, height = config.dimensions_cm
    across = max(thing.dimensions_cm[:2])
    width = max(width, ROOMY * across)
    length, height = max(length, ROOMY * across), max(height, ROOMY * thing.dimensions_cm[2])
    wall = max(WALL * min(length, width, height), 0.5)
    a, b, c, t = 0.5 * length, 0.5 * width, 0.5 * height, 0.5 * wall
    parts = (
        ((a, t, c), (0.0, b - t, c)),
        ((a, t, c), (0.0, t - b, c)),
        ((t, b - wall, c), (t - a, 0.0, c)),
        ((a - t, b - wall, t), (t, 0.0, height - t)),
    )
    walls = tuple(Proxy(kind=ProxyKind.BOX, size_cm=s, position_cm=p) for s, p in parts)
    inside = NamedRegion(
        name=name,
        kind="inside",
        center_cm=(0.0, 0.0, c),
        half_extents_cm=(a - wall, b - wall, c - wall),
    )
    return config.model_copy(
        update={
            "proxies": walls,
            "regions": (*config.regions, inside),
            "dimensions_cm": (length, width, height),
            "center_of_mass_cm": (0.0, 0.0, c),
        }
    )
