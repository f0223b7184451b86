"""What shall end up in a container fits through its opening and does not bounce out again.

Where the prompt leaves sizes open, the bucket of a basketball is a large bucket and the beanbag of
a box is one that goes in; where it says nothing of materials, a thing that comes down in a bowl
finds its bottom soft enough to stay there.
"""

from __future__ import annotations

import math

from esg.dynamics.casting.changes import resized
from esg.dynamics.choreography.bounces import apex_after
from esg.dynamics.choreography.falling.throws import fallen, is_dropped, stated_height
from esg.dynamics.choreography.slopes import slope_of
from esg.dynamics.story.stagecraft import prop, support_of, top_surface
from esg.dynamics.story.story import Story, bounds
from esg.graph.floating import liquid_of
from esg.graph.models import (
    AssetConfiguration,
    EsgDocument,
    NamedRegion,
    NodeEvent,
    ProxyKind,
    RegionType,
    RelationType,
    TimelineNode,
)
from esg.units import GRAVITY_MPS2

SNUG = 0.8
"""Largest share of the opening that the thing may take up."""
LARGER, SMALLER = 1.6, 0.4
"""Most that a container grows and a thing shrinks."""
DULLEST = 0.4
"""Least share of its usual restitution that the thing keeps."""
REBOUND = 0.7
"""Largest share of the container's depth that a bounce may reach."""
DOUBT = 0.1
"""Restitution that is unsure: even with so much more nothing bounces out again."""
BELOW_EDGE, LOWEST = 0.7, 0.3
"""Height of a container over that of the edge above it, and its least share of the usual one."""
USUAL_DROP_M = 1.0
"""Height from which things come down that nobody gave a height for."""


def entries(doc: EsgDocument, story: Story) -> list[tuple[TimelineNode, str, str, NamedRegion]]:
    """Events in which something ends up in a container: event, thing, container, inside."""
    nodes = doc.spatial_relation_graph.nodes
    out: list[tuple[TimelineNode, str, str, NamedRegion]] = []
    for node in story.nodes.values():
        inside = _inside_of(doc, node)
        if not inside or not node.participants:
            continue
        owner, _, name = inside.partition("/")
        thing = node.participants[0]
        if owner not in nodes or thing not in nodes:
            continue
        regions = doc.asset_configurations[nodes[owner].asset_id].regions
        mouth = next((r for r in regions if r.name == name), None)
        passes = any(r.kind in ("goal", "lane", "area", "pocket") for r in regions)
        if mouth is not None and mouth.kind in ("inside", "hole") and not passes:
            out.append((node, thing, owner, mouth))
    return out


def _inside_of(doc: EsgDocument, node: TimelineNode) -> str:
    """The region that something ends up in: what is set down on the level of a liquid, too."""
    if node.event is NodeEvent.ENTER_REGION:
        return node.region or ""
    nodes = doc.spatial_relation_graph.nodes
    if node.event is not NodeEvent.PLACED or len(node.participants) < 2:
        return ""
    vessel = node.participants[1]
    if vessel not in nodes or liquid_of(doc.asset_configurations[nodes[vessel].asset_id]) is None:
        return ""
    return f"{vessel}/inside"


def comes_down(story: Story, node: TimelineNode, thing: str) -> bool:
    """Whether a thing reaches a container from above: thrown, dropped or off something."""
    if story.is_active(thing) and story.flies(thing):
        return True
    before = story.ancestors(node.id)
    return any(
        n.event is NodeEvent.FALL and thing in n.participants
        for n in story.nodes.values()
        if n.id in before
    )


def down_a_slope(doc: EsgDocument, story: Story, thing: str, owner: str) -> bool:
    """Whether a thing comes down a slope to a container on the ground, and falls in (`chutes`)."""
    support, holder = support_of(doc, thing), prop(doc, owner)
    if support is None or story.flies(thing) or support_of(doc, owner) is not None:
        return False
    entered = holder.fixed or holder.wheeled  # a garage, a van
    return not entered and slope_of(doc, support) is not None


def fit_containers(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Configurations of containers and of what they shall hold, changed where they must be."""
    out: dict[str, AssetConfiguration] = {}
    nodes = doc.spatial_relation_graph.nodes
    for node, thing, owner, mouth in entries(doc, story):
        keys = nodes[thing].asset_id, nodes[owner].asset_id
        body, holder = (out.get(k, doc.asset_configurations[k]) for k in keys)
        if is_filled(holder, mouth):
            hollow = _hollow(doc, keys[1], holder)
            found = next((r for r in hollow.regions if r.name == mouth.name), None)
            if found is not None and not is_filled(hollow, found):
                holder, mouth = hollow, found
                out[keys[1]] = hollow
        falls = comes_down(story, node, thing)
        slides = not falls and down_a_slope(doc, story, thing, owner)
        highest = _below_edge(doc, thing, owner) if falls else math.inf
        if holder.dimensions_cm[2] > highest:
            lower = _lowered(doc, keys[1], holder, highest)
            found = next((r for r in lower.regions if r.name == mouth.name), None)
            if found is not None:
                holder, mouth = lower, found
                out[keys[1]] = lower
        most = min(LARGER, max(highest / holder.dimensions_cm[2], 1.0))
        grow, shrink = _factors(doc, keys, body, mouth, most)
        if grow > 1.0:
            holder = out[keys[1]] = resized(doc, keys[1], holder, grow)
        if shrink < 1.0:
            body = out[keys[0]] = resized(doc, keys[0], body, shrink)
        if not (falls or slides):
            continue
        depth = 0.02 * mouth.half_extents_cm[2] * grow
        drop = max(_drop_height(doc, story, node, thing), _comes_through(doc, story, node))
        livelier = max(math.sqrt(depth / drop) - DOUBT, 0.0)
        pair = 2.0 * min(math.sqrt(REBOUND * depth / drop), livelier)
        softest = max(pair - body.restitution, 0.0)
        if softest < holder.restitution:
            out[keys[1]] = holder.model_copy(update={"restitution": round(softest, 3)})
        if body.restitution + softest > pair + 1e-9:
            dull = max(pair, DULLEST * body.restitution)
            out[keys[0]] = body.model_copy(update={"restitution": round(dull, 3)})
    return out


def fit_holders(doc: EsgDocument) -> dict[str, AssetConfiguration]:
    """Configurations of what holds things at the start, open where it is usually drawn closed."""
    graph = doc.spatial_relation_graph
    regions = graph.semantic_regions
    edges = graph.edges.binary_relations
    holds = {e.to for e in edges if e.relation_type is RelationType.INSIDE_OF}
    for node in graph.nodes.values():
        region = regions.get(node.semantic_region or "")
        if region is not None and region.region_type is RegionType.STORAGE:
            holds.add(region.parent_object)
    out: dict[str, AssetConfiguration] = {}
    for name in sorted(holds & graph.nodes.keys()):
        key = graph.nodes[name].asset_id
        config = doc.asset_configurations[key]
        if config.regions or not config.proxies or graph.nodes[name].is_structural:
            continue
        box = doc.asset_requirement[key].model_copy(
            update={"asset_category": "open box", "asset_description": "open box"}
        )
        found = resized(doc, key, config, 1.0, box, dimensions=config.dimensions_cm)
        if any(r.kind == "inside" for r in found.regions):
            out[key] = found
    return out


def _below_edge(doc: EsgDocument, thing: str, owner: str) -> float:
    """Greatest height [cm] of a container that stands below the edge off which its content comes.

    What slides off a belt 80 cm high cannot end up in a bin of 95 cm. Infinite where nothing asks
    for a low one, or the prompt gives its size.
    """
    edge = support_of(doc, thing)
    key = doc.spatial_relation_graph.nodes[owner].asset_id
    if edge is None or edge == owner or support_of(doc, owner) is not None:
        return math.inf
    if doc.asset_requirement[key].dimensions_are_prescribed:
        return math.inf
    return BELOW_EDGE * top_surface(doc, edge).center_cm[2]


def _lowered(
    doc: EsgDocument, key: str, config: AssetConfiguration, height: float
) -> AssetConfiguration:
    """The same container, lower: what is never broad and low (a dustbin) becomes an open box."""
    length, width, _ = config.dimensions_cm
    share = max(height / config.dimensions_cm[2], LOWEST)
    size = (length, width, share * config.dimensions_cm[2])
    lighter = share ** (1.0 / 3.0)  # only as much lighter as it is lower: it shall not tip
    low = resized(doc, key, config, lighter, dimensions=size)
    if min(low.dimensions_cm[:2]) > SNUG * min(length, width):
        return low
    box = doc.asset_requirement[key].model_copy(
        update={"asset_category": "open box", "asset_description": "open box"}
    )
    return resized(doc, key, config, lighter, box, dimensions=size)


def is_filled(config: AssetConfiguration, mouth: NamedRegion) -> bool:
    """Whether the middle of a region lies within a collision shape: a bin drawn with its lid on."""
    for proxy in config.proxies:
        x, y, z = (abs(m - p) for m, p in zip(mouth.center_cm, proxy.position_cm, strict=True))
        a, b, c = proxy.size_cm
        if proxy.kind is ProxyKind.BOX and x < a and y < b and z < c:
            return True
        if proxy.kind in (ProxyKind.CYLINDER, ProxyKind.CAPSULE) and math.hypot(x, y) < a and z < c:
            return True
    return False


def _hollow(doc: EsgDocument, key: str, config: AssetConfiguration) -> AssetConfiguration:
    """An open vessel of the same size, for what is usually drawn closed."""
    vessel = doc.asset_requirement[key].model_copy(
        update={"asset_category": "bucket", "asset_description": "open bucket"}
    )
    return resized(doc, key, config, 1.0, vessel)


def _factors(
    doc: EsgDocument,
    keys: tuple[str, str],
    body: AssetConfiguration,
    mouth: NamedRegion,
    most: float = LARGER,
) -> tuple[float, float]:
    """How much larger the container (`most` at most) and smaller the thing must be, where open."""
    room = 2.0 * min(mouth.half_extents_cm[:2])
    across = max(body.dimensions_cm[:2])
    missing = across / max(SNUG * room, 1e-6)
    grow = shrink = 1.0
    if missing <= 1.0 or keys[0] == keys[1]:
        return grow, shrink
    if not doc.asset_requirement[keys[1]].dimensions_are_prescribed:
        grow = min(missing, most)
    if not doc.asset_requirement[keys[0]].dimensions_are_prescribed:
        shrink = max(grow / missing, SMALLER)
    return grow, shrink


def _comes_through(doc: EsgDocument, story: Story, node: TimelineNode) -> float:
    """Height [m] of what something fell through before (a hoop); 0 if nothing."""
    nodes = doc.spatial_relation_graph.nodes
    heights = [0.0]
    for before in story.ancestors(node.id):
        owner, _, name = (story.nodes[before].region or "").partition("/")
        if owner in nodes and set(story.nodes[before].participants) & set(node.participants):
            regions = doc.asset_configurations[nodes[owner].asset_id].regions
            heights += [r.center_cm[2] / 100.0 for r in regions if r.name == name]
    return max(heights)


def _drop_height(doc: EsgDocument, story: Story, node: TimelineNode, thing: str) -> float:
    """Height [m] whose fall is as fast as the thing comes down: a long flight goes high."""
    flight = 0.0
    if node.time_is_prescribed:
        low, high = node.window or (node.timestamp or 0.0, node.timestamp or 0.0)
        flight = 0.5 * (low + high)
    for c in node.constraints:
        if c.quantity == "time_since" and c.since in story.nodes:
            low, high, _ = bounds(c.value, (0.0, 0.0))
            flight = max(flight, 0.5 * (low + high))
    if any(p.end.id == node.id and is_dropped(p) for p in story.phases.get(thing, ())):
        return max(USUAL_DROP_M, stated_height(story, node, thing) or 0.0, fallen(flight))
    risen = apex_after(doc, story, node, thing) or 0.0
    return max(USUAL_DROP_M, risen, GRAVITY_MPS2 * flight * flight / 8.0 + 0.5)
