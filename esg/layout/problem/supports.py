"""What every object stands on: ground, surface, inside of a container, wall or ceiling."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
import math
from typing import Literal

from esg.graph.floating import afloat, liquid_of
from esg.graph.models import (
    AssetConfiguration,
    EsgDocument,
    RegionType,
    RelationType,
    SupportSurface,
)
from esg.layout.problem.joined import joined, posed
from esg.layout.problem.parts import bounds_of
from esg.layout.problem.roles import ground_nodes
from esg.layout.problem.shapes import CIRCLE, Footprint, bounds, footprints

REST_GAP_CM = 0.01
"""Gap between an object and its support: far below what a settling step can notice."""
CEILING_CM = 260.0
SHELF_THICKNESS_CM = 4.0
"""Room that a shelf and the air below it take from what stands on the next lower one."""

Rect = tuple[float, float, float, float]


@dataclass(frozen=True)
class Support:
    """Where one node rests.

    Args:
        parent: Node whose frame carries it; None is the world.
        kind: How.
        rect: min x, min y, max x, max y of the surface in the parent's frame [cm]; None is
            unbounded.
        z_cm: Height of the node's origin above the parent's origin.
        yaw_fixed: The attachment dictates the heading.
        note: What is wrong with this support, for the report.
        afloat: Whether a liquid carries it, and nothing solid.
    """

    parent: str | None
    kind: Literal["ground", "on", "inside", "vertical", "hanging", "above", "joined"]
    rect: Rect | None
    z_cm: float
    yaw_fixed: bool = False
    note: str = ""
    afloat: bool = False


@dataclass
class Shape:
    """Geometry of one node, from its asset."""

    config: AssetConfiguration
    prims: tuple[Footprint, ...]
    hx: float
    hy: float
    height: float
    is_round: bool
    bottom: float = 0.0

    @property
    def is_decal(self) -> bool:
        """No proxies: lies flat on the ground and never collides."""
        return not self.prims

    @property
    def is_pavement(self) -> bool:
        """Whether it is a street side (`is_pavement`)."""
        return is_pavement(self.config)


def is_pavement(config: AssetConfiguration) -> bool:
    """The street side: what stands on it stands by it, and nothing is driven along it."""
    return config.asset_name == "pavement"


def shape_of(config: AssetConfiguration) -> Shape:
    """Measures an asset once."""
    prims = footprints(config)
    hx, hy, height, is_round = bounds(config, prims)
    return Shape(config, prims, hx, hy, height, is_round, min((p.z0 for p in prims), default=0.0))


def shapes(doc: EsgDocument) -> dict[str, Shape]:
    """Returns the geometry of every node; instances of one asset share it."""
    per_asset = {k: shape_of(c) for k, c in doc.asset_configurations.items()}
    out = {n: per_asset[v.asset_id] for n, v in doc.spatial_relation_graph.nodes.items()}
    held = joined(doc)
    out |= {n: shape_of(posed(out[n].config, t)) for n, t in held.tilt.items()}
    for name, root in held.root.items():  # a wagon stands on its wheels
        low = held.rise[name] + out[name].bottom
        if low < out[root].bottom - REST_GAP_CM:
            out[root] = replace(out[root], bottom=low)
    return out


TOP_CM = 2.0
"""Parts that end this far below the highest one carry with it: a rim, the slats of a bench."""


def top_of(shape: Shape) -> SupportSurface:
    """The upper end of an object without declared surfaces: where its highest parts are."""
    top = max(p.z1 for p in shape.prims)
    boxes: list[Rect] = []
    for p in shape.prims:
        if p.z1 < top - TOP_CM:
            continue
        c, n = abs(math.cos(p.yaw)), abs(math.sin(p.yaw))
        hx, hy = (p.hx, p.hx) if p.kind == CIRCLE else (p.hx * c + p.hy * n, p.hx * n + p.hy * c)
        boxes.append((p.x - hx, p.y - hy, p.x + hx, p.y + hy))
    x0, y0 = min(b[0] for b in boxes), min(b[1] for b in boxes)
    x1, y1 = max(b[2] for b in boxes), max(b[3] for b in boxes)
    return SupportSurface(
        name="top",
        center_cm=(0.5 * (x0 + x1), 0.5 * (y0 + y1), top),
        half_extents_cm=(0.5 * (x1 - x0), 0.5 * (y1 - y0)),
    )


def surfaces_of(shape: Shape) -> list[SupportSurface]:
    """The large surfaces of an object, the highest first, else its upper end."""
    surfaces = shape.config.support_surfaces
    if shape.is_decal:
        return [SupportSurface(
            name="decal", center_cm=(0.0, 0.0, 0.0), half_extents_cm=(shape.hx, shape.hy)
        )]  # fmt: skip
    if not surfaces:
        return [top_of(shape)]
    area = [4 * s.half_extents_cm[0] * s.half_extents_cm[1] for s in surfaces]
    large = [s for s, a in zip(surfaces, area, strict=True) if a >= 0.6 * max(area)]
    return sorted(large, key=lambda s: -s.center_cm[2])


def surface_for(shape: Shape) -> SupportSurface:
    """The surface that `on` means: the highest among the large ones, else the upper end."""
    return surfaces_of(shape)[0]


FULL = 0.5
"""Share of a surface that objects cover before the next ones go to the shelf below."""


def share_shelves(parent: Shape, children: dict[str, Shape]) -> dict[str, SupportSurface]:
    """Which surface carries which child, for an object with several large surfaces.

    The highest is filled first, to half its area; then the next lower one on which the object fits
    below the shelf above. What fits nowhere goes to the highest.

    Args:
        parent: What carries.
        children: Names and shapes, in the order in which they are set down.

    Returns:
        Surfaces of those that do not stand on the highest.
    """
    shelves = surfaces_of(parent)
    out: dict[str, SupportSurface] = {}
    if len(shelves) < 2:
        return out
    used = [0.0] * len(shelves)
    for name, child in children.items():
        need = 4 * child.hx * child.hy
        for k, shelf in enumerate(shelves):
            room = 4 * shelf.half_extents_cm[0] * shelf.half_extents_cm[1]
            gap = shelves[k - 1].center_cm[2] - shelf.center_cm[2] if k else float("inf")
            under = SHELF_THICKNESS_CM if k else 0.0
            if child.height < gap - under and (used[k] == 0 or used[k] + need <= FULL * room):
                used[k] += need
                if k:
                    out[name] = shelf
                break
    return out


def flat_top(shape: Shape, surface: SupportSurface) -> float:
    """Height of the solid under a declared surface: a declared height may be off by millimetres."""
    z = surface.center_cm[2]
    tops = [
        p.z1
        for p in shape.prims
        if not p.is_sphere
        and abs(p.z1 - z) <= 3.0
        and abs(p.x - surface.center_cm[0]) <= p.hx
        and abs(p.y - surface.center_cm[1]) <= max(p.hx, p.hy)
    ]
    return max(tops, key=lambda t: -abs(t - z)) if tops else z


@dataclass
class SupportMap:
    """Supports of all nodes plus the edges that had to be ignored."""

    of: dict[str, Support] = field(default_factory=dict)
    notes: dict[str, str] = field(default_factory=dict)

    def chain(self, name: str) -> list[str]:
        """Ancestors of a node, nearest first."""
        out: list[str] = []
        parent = self.of[name].parent
        while parent is not None and parent not in out:
            out.append(parent)
            parent = self.of[parent].parent
        return out


def _rect(surface: SupportSurface, bounds_cm: object = None) -> Rect:
    (cx, cy, _), (hx, hy) = surface.center_cm, surface.half_extents_cm
    rect = (cx - hx, cy - hy, cx + hx, cy + hy)
    if bounds_cm is not None:
        (lx, ly, _), (ux, uy, _) = bounds_cm  # type: ignore[misc]  # pair of Vec3
        rect = (max(rect[0], lx), max(rect[1], ly), min(rect[2], ux), min(rect[3], uy))
        if rect[0] >= rect[2] or rect[1] >= rect[3]:
            rect = (lx, ly, ux, uy)
    return rect


def stand_on(
    child: Shape,
    parent_name: str,
    parent: Shape,
    bounds_cm: object = None,
    surface: SupportSurface | None = None,
) -> Support:
    """Support of a child that stands on a parent's surface, or on a part of it."""
    surface = surface or surface_for(parent)
    z = flat_top(parent, surface)
    gap = 0.0 if child.is_decal else REST_GAP_CM
    return Support(parent_name, "on", _rect(surface, bounds_cm), z + gap - child.bottom)


def _inside(child: Shape, parent_name: str, parent: Shape) -> Support:
    regions = [r for r in parent.config.regions if r.kind in ("inside", "area", "goal", "lane")]
    regions.sort(key=lambda r: r.kind != "inside")
    if regions:
        (cx, cy, cz), (hx, hy, hz) = regions[0].center_cm, regions[0].half_extents_cm
        rect = (cx - hx, cy - hy, cx + hx, cy + hy)
        # stand on the solid floor below the region when there is one
        floors = [
            p.z1
            for p in parent.prims
            if abs(p.x - cx) <= p.hx and abs(p.y - cy) <= max(p.hx, p.hy) and p.z1 <= cz
        ]
        z = max([cz - hz, *floors]) if floors else max(0.0, cz - hz)
        line = _waterline(child, parent)
        if line > z:
            return Support(parent_name, "inside", rect, line, afloat=True)
        note = ""
        if child.hx > hx + 0.01 or child.hy > hy + 0.01:
            note = f"does not fit into {parent_name}"
        return Support(parent_name, "inside", rect, z + REST_GAP_CM - child.bottom, note=note)
    if parent.is_decal or not parent.prims:
        return Support(
            parent_name, "on", (-parent.hx, -parent.hy, parent.hx, parent.hy),
            (0.0 if child.is_decal else REST_GAP_CM) - child.bottom,
        )  # fmt: skip
    return Support(
        parent_name, "inside", (-parent.hx, -parent.hy, parent.hx, parent.hy),
        REST_GAP_CM - child.bottom, note=f"{parent_name} has no inside",
    )  # fmt: skip


def _waterline(child: Shape, parent: Shape) -> float:
    """Height of what floats in a liquid over the vessel's origin, -inf of what does not [cm]."""
    liquid = liquid_of(parent.config)
    if liquid is None:
        return -math.inf
    region, row = liquid
    level = region.center_cm[2] + region.half_extents_cm[2]
    share = afloat(child.config, row).share
    return level - share * child.height if share < 1.0 else -math.inf


def _vertical(child: Shape, parent_name: str, parent: Shape) -> Support:
    x = parent.hx + child.hx + REST_GAP_CM
    room = max(0.0, parent.hy - child.hy)
    z = max(0.0, min(0.6 * parent.height - 0.5 * child.height, parent.height - child.height))
    return Support(
        parent_name, "vertical", (x - child.hx, -room - child.hy, x + child.hx, room + child.hy),
        z, yaw_fixed=True,
    )  # fmt: skip


def _hanging(child: Shape, parent_name: str, parent: Shape, parent_z: float) -> Support:
    if parent_z < child.height:  # nothing can hang below it: fixed on its upper side
        return stand_on(child, parent_name, parent)
    return Support(
        parent_name, "hanging", (-parent.hx, -parent.hy, parent.hx, parent.hy),
        -child.height - REST_GAP_CM,
    )  # fmt: skip


_RELATIONS = {
    RelationType.ATTACHED_VERTICAL: "vertical",
    RelationType.ATTACHED_HORIZONTAL: "hanging",
    RelationType.INSIDE_OF: "inside",
    RelationType.ON: "on",
    RelationType.ABOVE: "above",
}
"""Relations that name a support, the most telling first."""
_REGIONS = {
    RegionType.SUPPORT_SURFACE: "on",
    RegionType.STORAGE: "inside",
    RegionType.ATTACHED_VERTICAL: "vertical",
    RegionType.ATTACHED_HORIZONTAL: "hanging",
}
_Wish = tuple[str, str, object]
"""A kind of support, what gives it, and the bounds of a part of that."""


def find_supports(doc: EsgDocument, shape: dict[str, Shape]) -> SupportMap:
    """Reads `on`, `inside_of`, attachment edges and semantic regions into one support per node.

    What a joint places is carried by it; else the first usable statement wins, in the order:
    attachment, inside_of, on, region, above. Cycles are cut at the statement that would close them
    and noted.
    """
    ground = set(ground_nodes(doc))
    out = SupportMap()
    held = joined(doc)
    wishes = _wishes(doc, shape)
    wishes |= {n: [("joined", root, None)] for n, root in held.root.items()}
    chosen = _chosen(wishes, ground, out.notes)
    shelf = _shelves(chosen, shape)
    height: dict[str, float] = {}

    def resolve(name: str) -> None:
        if name in out.of:
            return
        child = shape[name]
        wish = chosen.get(name)
        if doc.spatial_relation_graph.nodes[name].is_structural and "ceiling" in name.lower():
            out.of[name] = Support(None, "ground", None, CEILING_CM)
            height[name] = CEILING_CM
        elif name in ground or wish is None or wish[0] == "ground":
            out.of[name] = _on_ground(child, name in ground, wish)
            height[name] = out.of[name].z_cm
        elif name in held.root:
            root = held.root[name]
            resolve(root)
            out.of[name] = Support(root, "joined", None, held.rise[name], yaw_fixed=True)
            height[name] = height[root] + held.rise[name]
        else:
            resolve(wish[1])
            base = height[wish[1]]
            out.of[name] = _carried(child, wish, shape[wish[1]], base, shelf.get(name))
            height[name] = base + out.of[name].z_cm

    for name in doc.spatial_relation_graph.nodes:
        resolve(name)
    return out


def _wishes(doc: EsgDocument, shape: dict[str, Shape]) -> dict[str, list[_Wish]]:
    """Every statement about what carries a node, the most telling first."""
    graph = doc.spatial_relation_graph
    wishes: dict[str, list[_Wish]] = {n: [] for n in graph.nodes}
    for relation, kind in _RELATIONS.items():
        for e in graph.edges.binary_relations:
            if e.relation_type is relation and e.from_ in shape and e.to in shape:
                wishes[e.from_].append((kind, e.to, None))
    for name, node in graph.nodes.items():
        region = graph.semantic_regions.get(node.semantic_region or "")
        if region is None or region.parent_object not in shape or region.parent_object == name:
            continue
        mine, parent = wishes[name], region.parent_object
        limits = region.bounds_cm
        if region.part is not None:
            own, below = shape[name], shape[parent]
            limits = bounds_of(region.part, (below.hx, below.hy), (own.hx, own.hy))
        at = next((k for k, w in enumerate(mine) if w[1] == parent), None)
        if at is not None:  # the region refines the edge
            mine[at] = (mine[at][0], parent, limits)
        else:
            above = [k for k, w in enumerate(mine) if w[0] == "above"]
            wish = (_REGIONS[region.region_type], parent, limits)
            mine.insert(above[0] if above else len(mine), wish)
    return wishes


def _chosen(
    wishes: dict[str, list[_Wish]], ground: set[str], notes: dict[str, str]
) -> dict[str, _Wish]:
    """The statement that counts for each node; notes those that would close a cycle."""
    parent_of: dict[str, str] = {}

    def closes_cycle(child: str, parent: str) -> bool:
        while parent in parent_of:
            parent = parent_of[parent]
            if parent == child:
                return True
        return parent == child

    chosen: dict[str, _Wish] = {}
    for name, mine in wishes.items():
        for wish in mine:
            kind, parent, limits = wish
            if parent == name or closes_cycle(name, parent):
                notes[name] = f"{kind} {parent} closes a cycle of supports"
                continue
            if parent in ground and kind != "above":
                # a second statement may be more specific: a car on the road on the ground
                if all(w[1] in ground for w in mine):
                    chosen[name] = ("ground", parent, limits)
                    break
                continue
            chosen[name] = wish
            parent_of[name] = parent
            break
    return chosen


def _shelves(chosen: dict[str, _Wish], shape: dict[str, Shape]) -> dict[str, SupportSurface]:
    """The board of a shelf for each of several things that stand on it."""
    on_it: dict[str, dict[str, Shape]] = {}
    for name, (kind, parent, limits) in chosen.items():
        if kind == "on" and limits is None and not shape[name].is_decal:
            on_it.setdefault(parent, {})[name] = shape[name]
    out: dict[str, SupportSurface] = {}
    for parent, children in on_it.items():
        if len(children) > 1:
            out |= share_shelves(shape[parent], children)
    return out


def _on_ground(child: Shape, is_ground: bool, wish: _Wish | None) -> Support:
    rect = None
    if wish is not None and wish[2] is not None and wish[0] == "ground":
        (lx, ly, _), (ux, uy, _) = wish[2]  # type: ignore[misc]  # pair of Vec3
        rect = (lx, ly, ux, uy)
    lies = child.is_decal or is_ground
    return Support(None, "ground", rect, 0.0 if lies else REST_GAP_CM - child.bottom)


def _carried(
    child: Shape, wish: _Wish, parent: Shape, parent_z: float, surface: SupportSurface | None
) -> Support:
    kind, name, limits = wish
    if kind == "inside":
        return _inside(child, name, parent)
    if kind == "vertical":
        return _vertical(child, name, parent)
    if kind == "hanging":
        return _hanging(child, name, parent, parent_z)
    if kind == "above" and not child.config.is_movable:
        s = stand_on(child, name, parent)
        return Support(name, "above", s.rect, s.z_cm + 0.5 * child.height)
    return stand_on(child, name, parent, limits, surface)
