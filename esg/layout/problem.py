"""One scene as arrays: the planar problem that the kernels search."""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np

from esg.graph.models import EsgDocument, RelationType
from esg.layout import terms
from esg.layout.edges import Term, binary_terms, characteristic, multi_terms
from esg.layout.hints import StartHints
from esg.layout.shapes import CIRCLE, RECTANGLE
from esg.layout.supports import Shape, SupportMap, find_supports, ground_nodes, shapes
from esg.layout.units import Unit, UnitBuilder

PARAMS = 6
ANCHORS = {
    "center": (0.0, 0.0),
    "left": (0.7, 0.0),
    "right": (-0.7, 0.0),
    "front": (0.0, 0.7),
    "back": (0.0, -0.7),
    "boundary": (0.7, 0.7),
}
SEATS = ("chair", "stool", "seat", "armchair")
FACED = ("desk", "table", "counter", "computer", "monitor", "television", "tv")


@dataclass(frozen=True)
class LayoutProblem:
    """Arrays of one scene (lengths in cm, angles in rad).

    `names` lists the real nodes; nodes beyond them are corridors of planned motion. Units are in
    placement order (parents and what others depend on first); node indices are local.
    """

    names: tuple[str, ...]
    units: tuple[Unit, ...]
    supports: SupportMap
    shape: dict[str, Shape]
    terms: tuple[Term, ...]
    notes: tuple[str, ...]
    node_unit: np.ndarray
    node_rel: np.ndarray
    node_z: np.ndarray
    node_half: np.ndarray
    node_round: np.ndarray
    node_height: np.ndarray
    node_radius: np.ndarray
    prim_off: np.ndarray
    prim_kind: np.ndarray
    prim_pose: np.ndarray
    prim_half: np.ndarray
    prim_z: np.ndarray
    unit_parent: np.ndarray
    unit_free: np.ndarray
    unit_pose: np.ndarray
    unit_box: np.ndarray
    unit_anchor: np.ndarray
    unit_step: np.ndarray
    aff: list[list[int]]
    unit_edges: list[list[int]]
    unit_pairs: list[list[int]]
    edge_kind: np.ndarray
    edge_node: np.ndarray
    edge_w: np.ndarray
    edge_p: np.ndarray
    pair: np.ndarray
    pair_margin: np.ndarray


def _heights(
    names: list[str], builder: UnitBuilder, supports: SupportMap, shape: dict[str, Shape]
) -> dict[str, float]:
    """World height of every origin: constants, because everything rests on something level."""
    from esg.layout.supports import _on  # the stack pattern adds supports of its own

    for above, below in builder.stacked.items():
        if supports.of[above].parent != below:
            supports.of[above] = _on(shape[above], below, shape[below])
    airborne = {n: z for u in builder.units for n, z in u.z_cm.items()}
    out: dict[str, float] = {}

    def height(name: str, depth: int = 0) -> float:
        if name not in out:
            s = supports.of[name]
            if name in airborne:
                out[name] = airborne[name]
            elif s.parent is None or depth > len(names):
                out[name] = s.z_cm
            else:
                out[name] = height(s.parent, depth + 1) + s.z_cm
        return out[name]

    for n in names:
        height(n)
    return out


def _order(
    units: list[Unit], all_terms: list[Term], unit_of: dict[str, int], area: list[float]
) -> list[int]:
    """Placement order: parents first, then `to` before `from`, the larger first among equals."""
    count = len(units)
    parents = [unit_of[u.parent] if u.parent is not None else -1 for u in units]
    needs: list[set[int]] = [set() for _ in units]
    for t in all_terms:
        a = unit_of[t.nodes[0]]
        for other in t.nodes[1:]:
            if other is not None and unit_of[other] != a:
                needs[a].add(unit_of[other])
    placed: set[int] = set()
    out: list[int] = []
    while len(out) < count:
        open_ = [
            i for i in range(count) if i not in placed and (parents[i] < 0 or parents[i] in placed)
        ]

        def rank(i: int) -> tuple[bool, int, bool, float, int]:
            return (
                any(units[i].free),
                len(needs[i] - placed),
                not units[i].is_planned,
                -area[i],
                i,
            )

        best = min(open_, key=rank)
        placed.add(best)
        out.append(best)
    return out


def _break_parent_cycles(units: list[Unit], unit_of: dict[str, int], notes: list[str]) -> None:
    for i, u in enumerate(units):
        seen = {i}
        at = u.parent
        while at is not None:
            k = unit_of[at]
            if k in seen:
                notes.append(f"{next(iter(u.members))} cannot stand on itself; placed in the world")
                u.parent = None
                break
            seen.add(k)
            at = units[k].parent


def _implied_faces(doc: EsgDocument) -> list[tuple[str, str]]:
    """Seats turn to the desk or table that they are near, unless the prompt says otherwise."""
    graph = doc.spatial_relation_graph
    facing = {e.from_ for e in graph.edges.binary_relations if e.relation_type is RelationType.FACE}

    def words(n: str) -> set[str]:
        c = doc.asset_configurations[graph.nodes[n].asset_id]
        return set(f"{c.category} {n}".lower().replace("_", " ").replace("-", " ").split())

    out = []
    for e in graph.edges.binary_relations:
        for a, b in ((e.from_, e.to), (e.to, e.from_)):
            if a not in graph.nodes or b not in graph.nodes or a in facing:
                continue
            if words(a) & set(SEATS) and words(b) & set(FACED) and not words(b) & set(SEATS):
                facing.add(a)
                out.append((a, b))
    return out


def build_problem(doc: EsgDocument, seed: int, hints: StartHints | None) -> LayoutProblem:
    """Turns a resolved document into arrays.

    Args:
        doc: Needs `asset_configurations` for every node.
        seed: Seeds scatter patterns only.
        hints: Planned starts.
    """
    rng = np.random.default_rng([seed, 77])
    graph = doc.spatial_relation_graph
    names = list(graph.nodes)
    shape = shapes(doc)
    supports = find_supports(doc, shape)
    builder = UnitBuilder(doc, shape, supports, hints, rng)
    units = builder.build()
    notes = list(builder.notes) + [f"{k}: {v}" for k, v in supports.notes.items()]
    z = _heights(names, builder, supports, shape)
    ground = set(ground_nodes(doc))
    unit_of = {n: i for i, u in enumerate(units) for n in u.members}
    _break_parent_cycles(units, unit_of, notes)

    rel_terms: list[Term] = []
    for k, e in enumerate(graph.edges.binary_relations):
        if e.from_ in shape and e.to in shape and e.from_ != e.to:
            rel_terms += [
                t for t in binary_terms(k, e, shape, supports)
                if not (e.to in ground and t.kind != terms.FACE)
            ]  # fmt: skip
    rel_terms += multi_terms(doc, shape, supports)
    rel_terms += [Term(terms.FACE, (a, b, None), 0.5, (0.0, 0.0)) for a, b in _implied_faces(doc)]

    (bx0, by0, _), (bx1, by1, _) = doc.scene_definition.coordinate_system.world_bounds_cm
    world = (bx0, by0, bx1, by1)
    for i, u in enumerate(units):
        for n in u.members:
            s = supports.of[n]
            if n in ground or (shape[n].is_decal and max(shape[n].hx, shape[n].hy) > 1000.0):
                continue
            if s.parent is None or n in u.z_cm:
                rel_terms.append(Term(terms.REGION, (n, None, None), 1.0, s.rect or world))
            elif unit_of.get(s.parent) != i or len(u.members) == 1:
                if s.rect is not None:
                    rel_terms.append(
                        Term(terms.REGION, (n, s.parent, None), 1.0, _overhang(s.rect, shape[n]))
                    )

    area = [
        sum(4 * shape[n].hx * shape[n].hy for n in u.members if not shape[n].is_decal)
        for u in units
    ]
    order = _order(units, rel_terms, unit_of, area)
    units = [units[i] for i in order]
    unit_of = {n: i for i, u in enumerate(units) for n in u.members}
    return _arrays(doc, names, units, unit_of, supports, shape, rel_terms, notes, z, ground, seed)


def _overhang(
    rect: tuple[float, float, float, float], child: Shape
) -> tuple[float, float, float, float]:
    """A surface smaller than the object holds the object's centre instead of its footprint."""
    x0, y0, x1, y1 = rect
    if child.hx > 0.5 * (x1 - x0):
        m = 0.5 * (x0 + x1)
        x0, x1 = m - child.hx - 0.01, m + child.hx + 0.01
    if child.hy > 0.5 * (y1 - y0):
        m = 0.5 * (y0 + y1)
        y0, y1 = m - child.hy - 0.01, m + child.hy + 0.01
    return x0, y0, x1, y1


def _arrays(
    doc: EsgDocument,
    names: list[str],
    units: list[Unit],
    unit_of: dict[str, int],
    supports: SupportMap,
    shape: dict[str, Shape],
    rel_terms: list[Term],
    notes: list[str],
    z: dict[str, float],
    ground: set[str],
    seed: int,
) -> LayoutProblem:
    index = {n: i for i, n in enumerate(names)}
    nodes = doc.spatial_relation_graph.nodes
    node_unit = [unit_of[n] for n in names]
    node_rel = [units[unit_of[n]].members[n] for n in names]
    node_z = [z[n] for n in names]
    node_half = [(shape[n].hx, shape[n].hy) for n in names]
    node_round = [int(shape[n].is_round) for n in names]
    node_height = [shape[n].height for n in names]
    prims = [
        [(p.kind, p.x, p.y, p.yaw, p.hx, p.hy, p.z0, p.z1) for p in shape[n].prims]
        if n not in ground else []
        for n in names
    ]  # fmt: skip

    # corridors are obstacles that belong to their unit
    exempt: list[set[int]] = []
    for u, unit in enumerate(units):
        for c in unit.corridors:
            allowed: set[str] = set()
            for p in c.participants:
                if p.startswith("group:"):
                    allowed |= {n for n in names if nodes[n].group == p.removeprefix("group:")}
                else:
                    allowed.add(p)
            allowed |= {a for n in allowed if n in index for a in supports.chain(n)}
            allowed |= {n for n in names if set(supports.chain(n)) & allowed and n in unit.members}
            movers = [n for n in c.participants if n in index]
            base = min((z[n] for n in movers), default=0.0)
            boxes = []
            for (x0, y0), (x1, y1) in zip(c.points_cm, c.points_cm[1:], strict=False):
                length = math.hypot(x1 - x0, y1 - y0)
                boxes.append(
                    (
                        RECTANGLE, 0.5 * (x0 + x1), 0.5 * (y0 + y1), math.atan2(y1 - y0, x1 - x0),
                        0.5 * length + c.half_width_cm, c.half_width_cm, 0.5, 300.0,
                    )
                )  # fmt: skip
            node_unit.append(u)
            node_rel.append((0.0, 0.0, 0.0))
            node_z.append(base)
            node_half.append((1.0, 1.0))
            node_round.append(0)
            node_height.append(300.0)
            prims.append(boxes)
            exempt.append({index[n] for n in allowed if n in index})
    radius = [
        max(
            (
                math.hypot(p[1], p[2]) + (p[4] if p[0] == CIRCLE else math.hypot(p[4], p[5]))
                for p in ps
            ),
            default=0.0,
        )
        for ps in prims
    ]

    parents_of_unit = [unit_of[u.parent] if u.parent is not None else -1 for u in units]
    moved_by: list[set[int]] = []
    for u in range(len(units)):
        moved = {u}
        for v in range(u + 1, len(units)):
            if parents_of_unit[v] in moved:
                moved.add(v)
        moved_by.append(moved)
    aff = [
        sorted(
            (i for i in range(len(node_unit)) if node_unit[i] in moved),
            key=lambda i: (node_unit[i], i),
        )
        for moved in moved_by
    ]

    tops = [
        (
            min((p[6] for p in ps), default=0.0) + node_z[i],
            max((p[7] for p in ps), default=0.0) + node_z[i],
        )
        for i, ps in enumerate(prims)
    ]
    pair, margin = [], []
    for i in range(len(node_unit)):
        for j in range(i):
            if node_unit[i] == node_unit[j] or not prims[i] or not prims[j]:
                continue
            if min(tops[i][1], tops[j][1]) - max(tops[i][0], tops[j][0]) <= 0.2:
                continue
            if i >= len(names):
                if j >= len(names) or j in exempt[i - len(names)]:
                    continue
                pair.append((j, i))
                margin.append(0.5)
                continue
            pair.append((j, i))
            a, b = shape[names[j]], shape[names[i]]
            m = min(max(0.04 * min(characteristic(a), characteristic(b)), 0.7), 4.0)
            if names[i] in supports.chain(names[j]) or names[j] in supports.chain(names[i]):
                m = min(m, 0.7)
            margin.append(m)

    edge_nodes = [tuple(-1 if n is None else index[n] for n in t.nodes) for t in rel_terms]
    params = np.zeros((len(rel_terms), PARAMS), np.float32)
    for i, t in enumerate(rel_terms):
        params[i, : len(t.params)] = t.params
    unit_edges: list[list[int]] = []
    unit_pairs: list[list[int]] = []
    for u in range(len(units)):
        moved = moved_by[u]
        unit_edges.append(
            [
                k
                for k, ns in enumerate(edge_nodes)
                if any(n >= 0 and node_unit[n] in moved for n in ns)
            ]
        )
        unit_pairs.append(
            [
                k
                for k, (a, b) in enumerate(pair)
                if (node_unit[a] in moved) != (node_unit[b] in moved)
            ]
        )

    rng = np.random.default_rng([seed, 78])
    total = sum(
        4 * shape[n].hx * shape[n].hy
        for n in names
        if n not in ground and not shape[n].is_decal and supports.of[n].parent is None
    )
    biggest = max(
        (max(shape[n].hx, shape[n].hy) for n in names if n not in ground and not shape[n].is_decal),
        default=50.0,
    )
    span = max(1.5 * math.sqrt(max(total, 1.0)), 2.0 * biggest)
    box, anchor, free, pose, step = [], [], [], [], []
    for u, unit in enumerate(units):
        first = next(iter(unit.members))
        s = supports.of[first]
        rect = s.rect if unit.parent is not None or s.parent is None else None
        if rect is None:
            (bx0, by0, _), (bx1, by1, _) = doc.scene_definition.coordinate_system.world_bounds_cm
            rect = (max(-span, bx0), max(-span, by0), min(span, bx1), min(span, by1))
        cx, cy = 0.5 * (rect[0] + rect[2]), 0.5 * (rect[1] + rect[3])
        hx, hy = 0.5 * (rect[2] - rect[0]), 0.5 * (rect[3] - rect[1])
        box.append((cx, cy, hx, hy))
        preference = nodes[first].layout_preference
        if preference.anchor == "none":
            # unconstrained objects spread out instead of crowding in the middle
            ax, ay = rng.uniform(-0.6, 0.6, 2)
            weight = 0.3
        else:
            ax, ay = ANCHORS[preference.anchor]
            weight = preference.weight
        anchor.append((cx + ax * hx, cy + ay * hy, weight))
        f = list(unit.free)
        p = list(unit.pose)
        if len(unit.members) == 1 and supports.of[first].yaw_fixed:
            f[2] = False
        turns = any(t.kind == terms.FACE and t.nodes[0] in unit.members for t in rel_terms)
        if len(unit.members) == 1 and shape[first].is_round and not turns:
            f[2] = False
        if first in ground or (shape[first].is_decal and unit.parent is None and not any(
            k for k in unit_edges[u] if rel_terms[k].source
        ) and len(unit.members) == 1):  # fmt: skip
            f = [False, False, False]
        free.append(f)
        pose.append(p)
        sizes = [min(shape[n].hx, shape[n].hy) for n in unit.members]
        step.append(min(max(0.1 * float(np.mean(sizes)), 0.3), 8.0))

    flat = [p for ps in prims for p in ps]
    table = np.asarray(flat, np.float32).reshape(-1, 8)
    return LayoutProblem(
        names=tuple(names),
        units=tuple(units),
        supports=supports,
        shape=shape,
        terms=tuple(rel_terms),
        notes=tuple(notes),
        node_unit=np.asarray(node_unit, np.int32),
        node_rel=np.asarray(node_rel, np.float32).reshape(-1, 3),
        node_z=np.asarray(node_z, np.float32),
        node_half=np.asarray(node_half, np.float32).reshape(-1, 2),
        node_round=np.asarray(node_round, np.int32),
        node_height=np.asarray(node_height, np.float32),
        node_radius=np.asarray(radius, np.float32),
        prim_off=np.cumsum([0, *[len(p) for p in prims]]).astype(np.int32),
        prim_kind=table[:, 0].astype(np.int32),
        prim_pose=table[:, 1:4].copy(),
        prim_half=table[:, 4:6].copy(),
        prim_z=table[:, 6:8].copy(),
        unit_parent=np.asarray(
            [-1 if u.parent is None else index[u.parent] for u in units], np.int32
        ),
        unit_free=np.asarray(free, np.float32).reshape(-1, 3),
        unit_pose=np.asarray(pose, np.float32).reshape(-1, 3),
        unit_box=np.asarray(box, np.float32).reshape(-1, 4),
        unit_anchor=np.asarray(anchor, np.float32).reshape(-1, 3),
        unit_step=np.asarray(step, np.float32),
        aff=aff,
        unit_edges=unit_edges,
        unit_pairs=unit_pairs,
        edge_kind=np.asarray([t.kind for t in rel_terms], np.int32),
        edge_node=np.asarray(edge_nodes, np.int32).reshape(-1, 3),
        edge_w=np.asarray([t.weight for t in rel_terms], np.float32),
        edge_p=params,
        pair=np.asarray(pair, np.int32).reshape(-1, 2),
        pair_margin=np.asarray(margin, np.float32),
    )
