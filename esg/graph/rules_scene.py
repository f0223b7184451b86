"""Rules on the scene, its assets, objects and regions."""

from __future__ import annotations

import re

from esg.graph.context import Context, components
from esg.graph.models import AssetRequirement, Interval, Node
from esg.graph.violations import listing, pointer

SIZE_CM = (0.1, 1e4)
STRUCTURAL_SIZE_CM = (0.1, 1e5)
MASS_KG = (1e-3, 1e5)
DENSITY_KG_M3 = (1.0, 25_000.0)
"""Over the bounding box. A beach ball has 2, an empty carton 4, a tungsten cube 19,300."""
BASE_CATEGORIES = frozenset({"ground", "floor", "terrain", "land"})
DAMPING_PER_S = (0.0, 100.0)

_NAME = re.compile(r"[^\s/:]+")
_SCENE_ID = re.compile(r"[\w][\w.\-]{0,127}")
_GRAPH = "spatial_relation_graph"


def check(ctx: Context) -> None:
    """Adds violations of scene, assets, nodes and regions."""
    _scene(ctx)
    _assets(ctx)
    _nodes(ctx)
    _regions(ctx)
    _groups(ctx)


def _scene(ctx: Context) -> None:
    scene = ctx.doc.scene_definition
    if not _SCENE_ID.fullmatch(scene.scene_id):
        ctx.add(
            "SCENE_ID_MALFORMED",
            pointer("scene_definition", "scene_id"),
            scene.scene_id,
            f"Scene id {scene.scene_id[:80]!r} cannot be a folder name.",
            "Use 1 to 128 letters, digits, '_', '-' and '.', not beginning with '.' or '-'.",
        )
    lower, upper = scene.coordinate_system.world_bounds_cm
    for axis in range(3):
        interval(
            ctx,
            pointer("scene_definition", "coordinate_system", "world_bounds_cm"),
            (lower[axis], upper[axis]),
            strict=True,
        )
    if not ctx.parsed.intact(_GRAPH, "nodes"):
        return
    if not ctx.node_names:
        ctx.add(
            "SCENE_EMPTY",
            pointer(_GRAPH, "nodes"),
            {},
            "The scene has no objects.",
            "Add at least one object and the ground or floor it stands on.",
        )
    elif not any(map(ctx.is_structural, ctx.nodes)):
        ctx.add(
            "SCENE_NO_BASE",
            pointer(_GRAPH, "nodes"),
            sorted(ctx.nodes),
            "No object is structural, so nothing carries the scene.",
            "Add a ground, road or floor with is_structural = true.",
        )
    bases = [n for n, node in ctx.nodes.items() if _is_base(ctx, node)]
    for name in bases[1:]:
        ctx.add(
            "SCENE_TWO_BASES",
            pointer(_GRAPH, "nodes", name),
            name,
            f"{name!r} is a second base beside {bases[0]!r}.",
            "Let one ground or floor be the whole walkable surface.",
        )


def _is_base(ctx: Context, node: Node) -> bool:
    """Whether a node is the one surface that carries everything (roads and lanes lie on it)."""
    asset = ctx.requirement(node)
    category = asset.asset_category.strip().lower() if asset is not None else ""
    return node.is_structural and category in BASE_CATEGORIES


def interval(ctx: Context, where: str, value: Interval, *, strict: bool = False) -> bool:
    """Reports an interval whose bounds are swapped; returns whether it is in order."""
    lower, upper = value
    if lower > upper or (strict and lower == upper):
        ctx.add(
            "INTERVAL_REVERSED",
            where,
            list(value),
            f"The lower bound {lower:g} is {'not below' if strict else 'above'} the upper "
            f"bound {upper:g}.",
            "Write the smaller number first.",
        )
        return False
    return True


def outside(value: float, limits: tuple[float, float]) -> bool:
    """Whether a number lies outside closed limits."""
    return not limits[0] <= value <= limits[1]


def _assets(ctx: Context) -> None:
    used = {node.asset_id for node in ctx.nodes.values()}
    regular = {n.asset_id for n in ctx.nodes.values() if not n.is_structural}
    for name, asset in ctx.doc.asset_requirement.items():
        where = pointer("asset_requirement", name)
        _name(ctx, where, name)
        if name not in used and ctx.parsed.intact(_GRAPH, "nodes"):
            ctx.add(
                "ASSET_UNUSED",
                where,
                name,
                f"Asset {name!r} is required but no node uses it.",
                "Add a node with this asset_id, or remove the requirement.",
            )
        structural = name not in regular and not asset.is_movable
        size_ok = _size(ctx, name, asset, structural)
        _mass(ctx, name, asset, size_ok and not structural)
        if outside(asset.linear_damping, DAMPING_PER_S):
            ctx.add(
                "UNIT_DAMPING",
                where + "/linear_damping",
                asset.linear_damping,
                f"Linear damping {asset.linear_damping:g} 1/s of {name!r} is not plausible.",
                "Use 0 to 100 1/s; 0.1 is the default.",
            )


def _name(ctx: Context, where: str, name: str) -> None:
    if not _NAME.fullmatch(name):
        ctx.add(
            "ID_MALFORMED",
            where,
            name,
            f"{name[:80]!r} is not usable as a name.",
            "Use a logical name such as car_1, without white space, '/' or ':'.",
        )


def _size(ctx: Context, name: str, asset: AssetRequirement, structural: bool) -> bool:
    limits = STRUCTURAL_SIZE_CM if structural else SIZE_CM
    size = asset.expected_dimensions_cm
    if any(outside(v, limits) for v in size):
        ctx.add(
            "UNIT_SIZE",
            pointer("asset_requirement", name, "expected_dimensions_cm"),
            list(size),
            f"Size {' x '.join(f'{v:g}' for v in size)} cm of {name!r} is not plausible.",
            f"Use {limits[0]:g} to {limits[1]:g} cm along each axis (the unit is cm).",
        )
        return False
    return True


def _mass(ctx: Context, name: str, asset: AssetRequirement, check_density: bool) -> None:
    mass = asset.expected_mass_kg
    where = pointer("asset_requirement", name, "expected_mass_kg")
    if (asset.is_movable and outside(mass, MASS_KG)) or mass < 0.0:
        ctx.add(
            "UNIT_MASS",
            where,
            mass,
            f"Mass {mass:g} kg of {name!r} is not plausible.",
            "Use 0.001 to 100000 kg (the unit is kg).",
        )
        return
    if not (asset.is_movable and check_density) or asset.mass_is_prescribed:
        return
    length, width, height = asset.expected_dimensions_cm
    density = mass / (length * width * height * 1e-6)
    if outside(density, DENSITY_KG_M3):
        low, high = (d * length * width * height * 1e-6 for d in DENSITY_KG_M3)
        ctx.add(
            "UNIT_DENSITY",
            where,
            mass,
            f"{mass:g} kg in {length:g} x {width:g} x {height:g} cm is {density:.3g} kg/m^3, which "
            f"is not plausible for {name!r}.",
            f"Use {low:.3g} to {high:.3g} kg for this size, or correct the size (kg and cm).",
        )


def _nodes(ctx: Context) -> None:
    for name, node in ctx.nodes.items():
        where = pointer(_GRAPH, "nodes", name)
        _name(ctx, where, name)
        if node.asset_id not in ctx.asset_names:
            ctx.add(
                "REF_ASSET",
                where + "/asset_id",
                node.asset_id,
                f"{name!r} uses asset {node.asset_id!r}, which is not required.",
                f"Use one of {listing(ctx.asset_names)}, or add the requirement.",
            )
        region = node.semantic_region
        intact = ctx.parsed.intact(_GRAPH, "nodes", name)
        if region is None and not node.is_structural and intact:
            ctx.add(
                "REGION_MISSING",
                where + "/semantic_region",
                None,
                f"{name!r} belongs to no region.",
                f"Name the region it stands on, in or at: {listing(ctx.region_names)}.",
            )
        elif region is not None and region not in ctx.region_names:
            ctx.add(
                "REF_REGION",
                where + "/semantic_region",
                region,
                f"{name!r} belongs to region {region!r}, which is not defined.",
                f"Use one of {listing(ctx.region_names)}.",
            )


def _regions(ctx: Context) -> None:
    edges: list[tuple[str, str]] = []
    for name, region in ctx.graph.semantic_regions.items():
        where = pointer(_GRAPH, "semantic_regions", name)
        _name(ctx, where, name)
        if region.parent_object not in ctx.node_names:
            ctx.add(
                "REF_REGION_PARENT",
                where + "/parent_object",
                region.parent_object,
                f"Region {name!r} is a part of {region.parent_object!r}, which is not a node.",
                f"Use one of {listing(ctx.node_names)}.",
            )
        if region.bounds_cm is not None:
            for axis in range(3):
                pair = (region.bounds_cm[0][axis], region.bounds_cm[1][axis])
                if not interval(ctx, where + "/bounds_cm", pair):
                    break
    for name in ctx.nodes:
        parent = ctx.support_of(name)
        if parent is not None:
            edges.append((name, parent))
    for cycle in components(list(ctx.nodes), edges):
        first = cycle[0]
        ctx.add(
            "REGION_CYCLE",
            pointer(_GRAPH, "nodes", first, "semantic_region"),
            ctx.nodes[first].semantic_region,
            f"Regions carry each other in a circle: {listing(cycle)}.",
            "Let one of them stand in a region of the ground or floor.",
        )


def _groups(ctx: Context) -> None:
    pattern_of: dict[str, str] = {}
    for name, node in ctx.nodes.items():
        if node.group_pattern is None:
            continue
        where = pointer(_GRAPH, "nodes", name, "group_pattern")
        if node.group is None:
            ctx.add(
                "GROUP_PATTERN",
                where,
                node.group_pattern,
                f"{name!r} has a group pattern but no group.",
                "Name the group, or remove the pattern.",
            )
            continue
        known = pattern_of.setdefault(node.group, node.group_pattern)
        if known != node.group_pattern:
            ctx.add(
                "GROUP_PATTERN",
                where,
                node.group_pattern,
                f"Group {node.group!r} is arranged as {known!r} and as {node.group_pattern!r}.",
                "Give all members one pattern.",
            )
