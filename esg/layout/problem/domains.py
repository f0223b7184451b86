"""Where each unit may be sampled, where it would rather stand, and what of its pose is free."""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np

from esg.graph.models import EsgDocument, LayoutPreference
from esg.layout.problem import terms
from esg.layout.problem.edges import Term
from esg.layout.problem.supports import Rect, Shape, SupportMap
from esg.layout.problem.units import Unit

ANCHORS = {
    "center": (0.0, 0.0),
    "left": (0.7, 0.0),
    "right": (-0.7, 0.0),
    "front": (0.0, 0.7),
    "back": (0.0, -0.7),
}
FACING_VIEWER = 0.5 * math.pi
"""Furniture on the ground turns its front to the viewer unless something else is said."""


@dataclass(frozen=True)
class Domains:
    """Search domain per unit (cm, rad).

    Args:
        box: Centre and half extents of the sampling rectangle, shape [n, 4].
        anchor: Preferred x, y, its weight and the weight of the preferred yaw, shape [n, 4].
        centre: Point of the unit's frame that box and anchor refer to, shape [n, 2].
        free: 1 where x, y, yaw may change, shape [n, 3].
        pose: Fixed or preferred pose, shape [n, 3].
        step: Length scale of an optimization step, shape [n].
    """

    box: np.ndarray
    anchor: np.ndarray
    centre: np.ndarray
    free: np.ndarray
    pose: np.ndarray
    step: np.ndarray


def extent(unit: Unit, shape: dict[str, Shape]) -> tuple[float, float, float, float]:
    """Bounding box of a unit in its own frame: min x, min y, max x, max y [cm]."""
    boxes = []
    for n, (x, y, _) in unit.members.items():
        if shape[n].is_decal and len(unit.members) > 1:
            continue
        r = math.hypot(shape[n].hx, shape[n].hy)
        boxes.append((x - r, y - r, x + r, y + r))
    for c in unit.corridors:
        w = c.half_width_cm
        boxes += [(x - w, y - w, x + w, y + w) for x, y in c.points_cm]
    if not boxes:
        return (0.0, 0.0, 0.0, 0.0)
    a = np.asarray(boxes)
    return (
        float(a[:, 0].min()),
        float(a[:, 1].min()),
        float(a[:, 2].max()),
        float(a[:, 3].max()),
    )


@dataclass(frozen=True)
class _Place:
    """What a unit's domain depends on besides the unit.

    Args:
        rect: Where it may be sampled: min x, min y, max x, max y [cm].
        related: Whether a stated relation says where it stands.
        is_middle: Whether it is the middle of the scene.
    """

    rect: Rect
    related: bool
    is_middle: bool

    @property
    def centre(self) -> tuple[float, float]:
        return 0.5 * (self.rect[0] + self.rect[2]), 0.5 * (self.rect[1] + self.rect[3])

    @property
    def half(self) -> tuple[float, float]:
        return 0.5 * (self.rect[2] - self.rect[0]), 0.5 * (self.rect[3] - self.rect[1])


def unit_domains(
    doc: EsgDocument,
    units: list[Unit],
    supports: SupportMap,
    shape: dict[str, Shape],
    rel_terms: list[Term],
    unit_edges: list[list[int]],
    ground: set[str],
    rng: np.random.Generator,
) -> Domains:
    """Derives the search domain of every unit.

    Units on open ground are sampled in a square around the origin whose area grows with the floor
    area in use and that covers planned motion.
    """
    nodes = doc.spatial_relation_graph.nodes
    (wx0, wy0, _), (wx1, wy1, _) = doc.scene_definition.coordinate_system.world_bounds_cm
    span = _span(list(nodes), units, supports, shape, ground)
    open_ground = (max(-span, wx0), max(-span, wy0), min(span, wx1), min(span, wy1))
    middle = _middle(units, shape, ground)
    facing = {t.nodes[0] for t in rel_terms if t.kind == terms.FACE}
    box, anchor, centre, free, pose, step = [], [], [], [], [], []
    for u, unit in enumerate(units):
        first = next(iter(unit.members))
        s = supports.of[first]
        rect = s.rect if (unit.parent is not None or s.parent is None) else None
        related = any(rel_terms[k].source for k in unit_edges[u])
        place = _Place(rect or open_ground, related, u == middle)
        box.append((*place.centre, *place.half))
        anchor.append(_anchor(unit, first, nodes[first].layout_preference, place, rng))
        x0, y0, x1, y1 = extent(unit, shape) if _moves_freely(unit) else (0.0,) * 4
        centre.append((0.5 * (x0 + x1), 0.5 * (y0 + y1)))
        fixed = first in ground or (
            len(unit.members) == 1 and shape[first].is_decal and not related
        )
        turns = not facing.isdisjoint(unit.members)
        free.append([False] * 3 if fixed else _freedom(unit, shape[first], s.yaw_fixed, turns))
        pose.append([0.0] * 3 if fixed else _pose(unit, shape[first]))
        sizes = [min(shape[n].hx, shape[n].hy) for n in unit.members]
        size = float(np.mean(sizes)) if len(sizes) > 1 else sizes[0]
        step.append(min(max(0.1 * size, 0.3), 8.0))
    return Domains(
        np.asarray(box, np.float32).reshape(-1, 4),
        np.asarray(anchor, np.float32).reshape(-1, 4),
        np.asarray(centre, np.float32).reshape(-1, 2),
        np.asarray(free, np.float32).reshape(-1, 3),
        np.asarray(pose, np.float32).reshape(-1, 3),
        np.asarray(step, np.float32),
    )


def _moves_freely(unit: Unit) -> bool:
    """Whether it holds planned motion in the open, which is centred in the world."""
    return unit.is_planned and unit.parent is None


def _span(
    nodes: list[str],
    units: list[Unit],
    supports: SupportMap,
    shape: dict[str, Shape],
    ground: set[str],
) -> float:
    """Half the side of the square of open ground that is sampled [cm]."""
    on_ground = [
        shape[n]
        for n in nodes
        if n not in ground and not shape[n].is_decal and supports.of[n].parent is None
    ]
    area = sum(4 * s.hx * s.hy for s in on_ground)
    biggest = max((max(s.hx, s.hy) for s in on_ground), default=50.0)
    reach = 0.0
    for unit in filter(_moves_freely, units):
        x0, y0, x1, y1 = extent(unit, shape)
        reach = max(reach, 0.5 * (x1 - x0), 0.5 * (y1 - y0))
    roads = max(
        (min(shape[n].hx, shape[n].hy) for n in nodes if shape[n].is_decal and n not in ground),
        default=0.0,
    )
    return max(1.5 * math.sqrt(max(area, 1.0)), 2.0 * biggest, reach) + min(roads, 1500.0)


def _middle(units: list[Unit], shape: dict[str, Shape], ground: set[str]) -> int:
    """The largest thing on the ground, the middle of a scene without planned motion; else -1."""
    if any(unit.is_planned for unit in units):
        return -1
    sizes = [
        sum(shape[n].hx * shape[n].hy for n in unit.members if not shape[n].is_decal)
        if unit.parent is None
        and not set(unit.members) & ground
        and "wall" not in next(iter(unit.members)).lower()
        else 0.0
        for unit in units
    ]
    return int(np.argmax(sizes)) if sizes and max(sizes) > 0 else -1


def _anchor(
    unit: Unit,
    first: str,
    preference: LayoutPreference,
    place: _Place,
    rng: np.random.Generator,
) -> tuple[float, float, float, float]:
    """Preferred x, y [cm], its weight, and the weight of the preferred yaw."""
    (cx, cy), (hx, hy) = place.centre, place.half
    if _moves_freely(unit):
        return (0.0, 0.0, 0.3, 50.0)
    if preference.anchor == "boundary":
        side = [(0.9, 0.0), (-0.9, 0.0), (0.0, 0.9), (0.0, -0.9)][int(rng.integers(4))]
        return (cx + side[0] * hx, cy + side[1] * hy, preference.weight, 10.0)
    if preference.anchor in ANCHORS:
        ax, ay = ANCHORS[preference.anchor]
        return (cx + ax * hx, cy + ay * hy, preference.weight, 10.0)
    if unit.parent is None and "wall" in first.lower():
        # walls close the scene at the back and show their face to the viewer
        return (cx, cy - hy, 1.0, 200.0)
    if place.is_middle:
        return (cx, cy, 0.3, 10.0)
    # unconstrained objects spread out instead of crowding in the middle
    ax, ay = rng.uniform(-0.6, 0.6, 2)
    if unit.parent is None and place.related:
        ax, ay = 0.25 * ax, 0.25 * ay
    return (cx + ax * hx, cy + ay * hy, 0.3, 10.0)


def _freedom(unit: Unit, first: Shape, yaw_fixed: bool, turns: bool) -> list[bool]:
    """Whether x, y and yaw may change; a round thing turns only where it must face something."""
    x, y, yaw = unit.free
    single = len(unit.members) == 1
    return [x, y, yaw and not (single and (yaw_fixed or (first.is_round and not turns)))]


def _pose(unit: Unit, first: Shape) -> list[float]:
    x, y, yaw = unit.pose
    if not unit.is_planned and unit.parent is None:
        yaw = 0.0 if first.config.is_wheeled or first.is_round else FACING_VIEWER
    return [x, y, yaw]
