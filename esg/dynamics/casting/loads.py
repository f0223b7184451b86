"""What stands on a table or shelf has room there: three large boxes need a long shelf.

Where the prompt leaves sizes open, a support on which its load does not fit side by side grows, and
then what stands on it shrinks. What moves, and what something else of the story needs at its size,
is not touched.
"""

from __future__ import annotations

from collections.abc import Iterator

from esg.dynamics.casting.changes import resized
from esg.dynamics.story.stagecraft import support_of, top_surface
from esg.dynamics.story.story import Story
from esg.graph.models import AssetConfiguration, EsgDocument, NodeEvent
from esg.layout.problem.patterns import DOMINO_PITCH_OVER_HEIGHT, is_domino_like
from esg.layout.problem.supports import FULL, SHELF_THICKNESS_CM
from esg.thresholds import SAFE_FALLEN_BY

LARGER, SMALLER = 2.0, 0.4
"""Most that a support grows and its load shrinks."""
STEP = 0.05
"""How finely both are tried."""
GAP = 0.04
"""Room beside each, as a share of its extent."""


def fit_loads(doc: EsgDocument) -> dict[str, AssetConfiguration]:
    """Configurations of supports, and of what stands on them, that are too small or too large.

    Args:
        doc: A document with assets resolved.
    """
    out: dict[str, AssetConfiguration] = {}
    for support, load in _loads(doc).items():
        key = doc.spatial_relation_graph.nodes[support].asset_id
        config = doc.asset_configurations[key]
        keys, sizes = _blocks(doc, load)
        areas = _areas(config)
        if len(load) < 2 or _has_room(areas, sizes, 1.0):
            continue
        grow = 1.0
        if not doc.asset_requirement[key].dimensions_are_prescribed:
            grow = next((f for f in _factors(LARGER) if _has_room(areas, sizes, f)), LARGER)
            out[key] = resized(doc, key, config, grow)
        given = {k for k in keys if doc.asset_requirement[k].dimensions_are_prescribed}
        shrink = 1.0
        for shrink in _factors(SMALLER):
            smaller = [
                s if k in given else tuple(shrink * d for d in s)
                for k, s in zip(keys, sizes, strict=True)
            ]
            if _has_room(areas, smaller, grow):
                break
        for k in sorted(set(keys) - given) if shrink < 1.0 else ():
            out[k] = resized(doc, k, doc.asset_configurations[k], shrink)
    return out


def fit_fallen(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Smaller loads for what is so low that coming off it would be no fall: a keg on a handcart.

    Args:
        doc: A document with assets resolved.
        story: What happens in it.

    Returns:
        Configurations of the loads, by asset.
    """
    out: dict[str, AssetConfiguration] = {}
    for node in story.nodes.values():
        name = node.participants[0] if node.event is NodeEvent.FALL else ""
        support = support_of(doc, name) if name else None
        if support is None:
            continue
        if support_of(doc, support) is not None and support not in story.phases:
            continue  # what comes off a tray on a table may fall to the floor
        key = doc.spatial_relation_graph.nodes[name].asset_id
        told = doc.asset_requirement[key]
        given = told.dimensions_are_prescribed or told.mass_is_prescribed
        height = doc.asset_configurations[key].dimensions_cm[2]
        share = top_surface(doc, support).center_cm[2] / (SAFE_FALLEN_BY * height)
        if share < 1.0 and not given and told.shape != "capsule":
            out[key] = resized(doc, key, doc.asset_configurations[key], max(share, SMALLER))
    return out


def _blocks(doc: EsgDocument, load: list[str]) -> tuple[list[str], list[tuple[float, ...]]]:
    """Assets and extents [cm] of what stands side by side; a row of slabs as long as its pitch."""
    keys: list[str] = []
    sizes: list[tuple[float, ...]] = []
    rows: set[str] = set()
    for name in load:
        node = doc.spatial_relation_graph.nodes[name]
        size = doc.asset_configurations[node.asset_id].dimensions_cm
        if node.group is not None and node.group_pattern == "row" and is_domino_like(*size):
            if node.group in rows:
                continue
            rows.add(node.group)
            mates = sum(doc.spatial_relation_graph.nodes[n].group == node.group for n in load)
            pitch = DOMINO_PITCH_OVER_HEIGHT * size[2]
            size = (size[0] + (mates - 1) * pitch, *size[1:])
        keys.append(node.asset_id)
        sizes.append(tuple(size))
    return keys, sizes


def _factors(last: float) -> Iterator[float]:
    """1, then in steps to `last`."""
    count = round(abs(last - 1.0) / STEP)
    return (1.0 + (last - 1.0) * k / count for k in range(count + 1))


def _loads(doc: EsgDocument) -> dict[str, list[str]]:
    """What stands beside each other on what, stacks by their lowest; who sits has a seat."""
    stacks: set[str] = set()
    out: dict[str, list[str]] = {}
    nodes = doc.spatial_relation_graph.nodes
    seated = {
        j.child
        for j in doc.spatial_relation_graph.joints or ()
        if j.kind == "fixed" and j.parent_mount is not None
    }
    for name, node in nodes.items():
        support = support_of(doc, name)
        if support is None or nodes[support].is_structural or name in seated:
            continue
        config = doc.asset_configurations.get(node.asset_id)
        if config is None or not config.proxies or not _stands_on(doc, name):
            continue
        if node.group_pattern == "stack" and node.group is not None:
            if node.group in stacks:
                continue
            stacks.add(node.group)
        out.setdefault(support, []).append(name)
    return out


def _stands_on(doc: EsgDocument, name: str) -> bool:
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions[str(graph.nodes[name].semantic_region)]
    return region.region_type.value == "SUPPORT_SURFACE" and region.bounds_cm is None


def _areas(config: AssetConfiguration) -> list[tuple[float, float, float]]:
    """Surfaces that carry, the highest first: long side, short side, room above [cm]."""
    surfaces = sorted(config.support_surfaces, key=lambda s: -s.center_cm[2])
    if not surfaces:
        return [(max(config.dimensions_cm[:2]), min(config.dimensions_cm[:2]), float("inf"))]
    most = max(s.half_extents_cm[0] * s.half_extents_cm[1] for s in surfaces)
    large = [s for s in surfaces if s.half_extents_cm[0] * s.half_extents_cm[1] >= 0.6 * most]
    heights = [float("inf")] + [s.center_cm[2] for s in large]
    return [
        (2.0 * max(s.half_extents_cm), 2.0 * min(s.half_extents_cm), above - s.center_cm[2])
        for s, above in zip(large, heights, strict=False)
    ]


def _has_room(
    areas: list[tuple[float, float, float]], sizes: list[tuple[float, ...]], factor: float
) -> bool:
    """Whether all fit on surfaces `factor` times as large.

    Shelves are shared as the layout does: each half full, the highest first; what fits on none goes
    to the highest.
    """
    shelves = [(factor * long, factor * short, factor * room) for long, short, room in areas]
    on: list[list[tuple[float, ...]]] = [[] for _ in shelves]
    used = [0.0] * len(shelves)
    for size in sizes:
        need = size[0] * size[1]
        place = 0
        for k, (long, short, room) in enumerate(shelves):
            under = SHELF_THICKNESS_CM if k else 0.0
            full = used[k] and used[k] + need > FULL * long * short
            if size[2] < room - under and not full:
                place = k
                break
        used[place] += need
        on[place].append(size)
    return all(
        _in_rows(load, long, short) for load, (long, short, _) in zip(on, shelves, strict=True)
    )


def _in_rows(sizes: list[tuple[float, ...]], long: float, short: float) -> bool:
    """Whether boxes fit side by side on a rectangle, long sides across it where they can be."""
    row = depth = 0.0
    for size in sorted(sizes, key=lambda s: -s[0] * s[1]):
        lesser, greater = sorted((1.0 + GAP) * d for d in size[:2])
        along, across = (lesser, greater) if greater <= short else (greater, lesser)
        if row and row + along > long:
            short -= depth
            row = depth = 0.0
        if along > long or across > short:
            return False
        row, depth = row + along, max(depth, across)
    return True
