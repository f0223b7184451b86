"""Where each unit may be sampled, where it would rather stand, and what of its pose is free."""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np

from esg.graph.models import EsgDocument
from esg.layout.problem import terms
from esg.layout.problem.edges import Term
from esg.layout.problem.supports import Shape, SupportMap
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
    on_ground = [
        n
        for n in nodes
        if n not in ground and not shape[n].is_decal and supports.of[n].parent is None
    ]
    area = sum(4 * shape[n].hx * shape[n].hy for n in on_ground)
    biggest = max((max(shape[n].hx, shape[n].hy) for n in on_ground), default=50.0)
    reach = 0.0
    for unit in units:
        if unit.is_planned and unit.parent is None:
            x0, y0, x1, y1 = extent(unit, shape)
            reach = max(reach, 0.5 * (x1 - x0), 0.5 * (y1 - y0))
    roads = max(
        (min(shape[n].hx, shape[n].hy) for n in nodes if shape[n].is_decal and n not in ground),
        default=0.0,
    )
    span = max(1.5 * math.sqrt(max(area, 1.0)), 2.0 * biggest, reach) + min(roads, 1500.0)

    # without planned motion the largest thing on the ground is the middle of the scene
    middle = -1
    if not any(unit.is_planned for unit in units):
        sizes = [
            sum(shape[n].hx * shape[n].hy for n in unit.members if not shape[n].is_decal)
            if unit.parent is None
            and not set(unit.members) & ground
            and "wall" not in next(iter(unit.members)).lower()
            else 0.0
            for unit in units
        ]  # fmt: skip
        middle = int(np.argmax(sizes)) if sizes and max(sizes) > 0 else -1
    box, anchor, centre, free, pose, step = [], [], [], [], [], []
    facing = {t.nodes[0] for t in rel_terms if t.kind == terms.FACE}
    for u, unit in enumerate(units):
        first = next(iter(unit.members))
        related = any(rel_terms[k].source for k in unit_edges[u])
        single = len(unit.members) == 1
        s = supports.of[first]
        rect = s.rect if (unit.parent is not None or s.parent is None) else None
        if rect is None:
            rect = (max(-span, wx0), max(-span, wy0), min(span, wx1), min(span, wy1))
        cx, cy = 0.5 * (rect[0] + rect[2]), 0.5 * (rect[1] + rect[3])
        hx, hy = 0.5 * (rect[2] - rect[0]), 0.5 * (rect[3] - rect[1])
        box.append((cx, cy, hx, hy))

        p = list(unit.pose)
        f = list(unit.free)
        preference = nodes[first].layout_preference
        middle_at = (0.0, 0.0)
        if unit.is_planned and unit.parent is None:
            # planned motion is centred in the world
            x0, y0, x1, y1 = extent(unit, shape)
            middle_at = (0.5 * (x0 + x1), 0.5 * (y0 + y1))
            anchor.append((0.0, 0.0, 0.3, 50.0))
        elif preference.anchor == "boundary":
            k = int(rng.integers(4))
            side = [(0.9, 0.0), (-0.9, 0.0), (0.0, 0.9), (0.0, -0.9)][k]
            anchor.append((cx + side[0] * hx, cy + side[1] * hy, preference.weight, 10.0))
        elif preference.anchor in ANCHORS:
            ax, ay = ANCHORS[preference.anchor]
            anchor.append((cx + ax * hx, cy + ay * hy, preference.weight, 10.0))
        elif unit.parent is None and "wall" in first.lower():
            # walls close the scene at the back and show their face to the viewer
            anchor.append((cx, cy - hy, 1.0, 200.0))
        elif u == middle:
            anchor.append((cx, cy, 0.3, 10.0))
        else:
            # unconstrained objects spread out instead of crowding in the middle
            ax, ay = rng.uniform(-0.6, 0.6, 2)
            if unit.parent is None and related:
                ax, ay = 0.25 * ax, 0.25 * ay
            anchor.append((cx + ax * hx, cy + ay * hy, 0.3, 10.0))
        if not unit.is_planned and unit.parent is None:
            vehicle = shape[first].config.is_wheeled
            p[2] = 0.0 if vehicle or shape[first].is_round else FACING_VIEWER

        if single and s.yaw_fixed:
            f[2] = False
        turns = not facing.isdisjoint(unit.members)
        if single and shape[first].is_round and not turns:
            f[2] = False
        if first in ground or (single and shape[first].is_decal and not related):
            f, p = [False, False, False], [0.0, 0.0, 0.0]
        centre.append(middle_at)
        free.append(f)
        pose.append(p)
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
