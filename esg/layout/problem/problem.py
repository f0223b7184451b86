"""One scene as arrays: the planar problem that the kernels search."""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np

from esg.graph.models import EsgDocument
from esg.layout.problem import terms
from esg.layout.problem.domains import unit_domains
from esg.layout.problem.edges import Term, binary_terms, multi_terms
from esg.layout.problem.heights import heights
from esg.layout.problem.hints import StartHints
from esg.layout.problem.obstacles import CLEAR_HEIGHT_CM, Obstacle, Prism, obstacles
from esg.layout.problem.ordering import break_parent_cycles, implied_faces, placement_order
from esg.layout.problem.pairs import collision_pairs
from esg.layout.problem.roles import falling_nodes, ground_nodes
from esg.layout.problem.shapes import CIRCLE
from esg.layout.problem.supports import Shape, SupportMap, find_supports, shapes
from esg.layout.problem.units import Unit, UnitBuilder

PARAMS = 6


@dataclass(frozen=True)
class LayoutProblem:
    """Arrays of one scene (lengths in cm, angles in rad).

    `names` lists the real nodes; nodes beyond them are corridors of planned motion. Units are in
    placement order (parents and what others depend on first); node indices are local. `ground` are
    the nodes that are the ground itself, `falling` those that fall in the story, `terms_of` the
    terms of each relation.
    """

    names: tuple[str, ...]
    units: tuple[Unit, ...]
    supports: SupportMap
    shape: dict[str, Shape]
    terms: tuple[Term, ...]
    obstacles: tuple[Obstacle, ...]
    notes: tuple[str, ...]
    ground: frozenset[str]
    falling: frozenset[str]
    terms_of: dict[str, list[Term]]
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
    unit_center: np.ndarray
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
    pair_avoid: np.ndarray


def build_problem(doc: EsgDocument, seed: int, hints: StartHints | None) -> LayoutProblem:
    """Turns a resolved document into arrays.

    Args:
        doc: Needs `asset_configurations` for every node.
        seed: Seeds scatter patterns only.
        hints: Planned starts.
    """
    graph = doc.spatial_relation_graph
    names = list(graph.nodes)
    shape = shapes(doc)
    supports = find_supports(doc, shape)
    builder = UnitBuilder(doc, shape, supports, hints, seed)
    units = builder.build()
    notes = list(builder.notes) + [f"{k}: {v}" for k, v in supports.notes.items()]
    z = heights(doc, builder, supports, shape)
    ground = set(ground_nodes(doc))
    unit_of = {n: i for i, u in enumerate(units) for n in u.members}
    break_parent_cycles(units, unit_of, notes)

    rel_terms: list[Term] = []
    for k, e in enumerate(graph.edges.binary_relations):
        if e.from_ in shape and e.to in shape and e.from_ != e.to:
            rel_terms += [
                t for t in binary_terms(k, e, shape, supports)
                if e.cardinal is not None or not {e.from_, e.to} & ground
            ]  # fmt: skip
    rel_terms += multi_terms(doc, shape, supports)
    rel_terms += [Term(terms.FACE, (a, b, None), 0.5, (0.0, 0.0)) for a, b in implied_faces(doc)]

    (bx0, by0, _), (bx1, by1, _) = doc.scene_definition.coordinate_system.world_bounds_cm
    world = (bx0, by0, bx1, by1)
    for i, u in enumerate(units):
        for n in u.members:
            s = supports.of[n]
            if n in ground or (shape[n].is_decal and max(shape[n].hx, shape[n].hy) > 1000.0):
                continue
            if s.parent is None or n in u.z_cm:
                rect = (s.rect if n not in u.z_cm else None) or world
                rel_terms.append(Term(terms.REGION, (n, None, None), 1.0, rect))
            elif unit_of.get(s.parent) != i and s.rect is not None:
                rect = _overhang(s.rect, shape[n])
                rel_terms.append(Term(terms.REGION, (n, s.parent, None), 1.0, rect))

    area = [
        sum(4 * shape[n].hx * shape[n].hy for n in u.members if not shape[n].is_decal)
        for u in units
    ]
    order = placement_order(units, rel_terms, unit_of, area)
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
    node_unit = [unit_of[n] for n in names]
    node_rel = [units[unit_of[n]].members[n] for n in names]
    node_z = [z[n] for n in names]
    node_half = [(shape[n].hx, shape[n].hy) for n in names]
    node_round = [int(shape[n].is_round) for n in names]
    node_height = [shape[n].height for n in names]
    prims: list[list[Prism]] = [
        [(float(p.kind), p.x, p.y, p.yaw, p.hx, p.hy, p.z0, p.z1) for p in shape[n].prims]
        if n not in ground else []
        for n in names
    ]  # fmt: skip

    blocked = obstacles(doc, units, supports, shape, z)
    for o in blocked:
        node_unit.append(o.unit)
        node_rel.append(o.rel)
        node_z.append(o.base_z_cm)
        node_half.append((1.0, 1.0))
        node_round.append(0)
        node_height.append(CLEAR_HEIGHT_CM)
        prims.append(list(o.prisms))
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

    pair, margin, avoid = collision_pairs(
        doc, names, node_unit, node_z, prims, blocked, supports, shape
    )
    edge_nodes = [tuple(-1 if n is None else index[n] for n in t.nodes) for t in rel_terms]
    params = np.zeros((len(rel_terms), PARAMS), np.float32)
    for i, t in enumerate(rel_terms):
        params[i, : len(t.params)] = t.params
    movers: list[set[int]] = [set() for _ in node_unit]
    for u, nodes_moved in enumerate(aff):
        for n in nodes_moved:
            movers[n].add(u)
    unit_edges: list[list[int]] = [[] for _ in units]
    for k, ns in enumerate(edge_nodes):
        for u in sorted(set().union(*(movers[n] for n in ns if n >= 0))):
            unit_edges[u].append(k)
    unit_pairs: list[list[int]] = [[] for _ in units]
    for k, (a, b) in enumerate(pair.tolist()):
        for u in sorted(movers[a] ^ movers[b]):  # a unit that moves both leaves them as they are
            unit_pairs[u].append(k)

    domains = unit_domains(
        doc,
        units,
        supports,
        shape,
        rel_terms,
        unit_edges,
        ground,
        np.random.default_rng([seed, 78]),
    )
    terms_of: dict[str, list[Term]] = {}
    for t in rel_terms:
        if t.source:
            terms_of.setdefault(t.source, []).append(t)
    flat = [p for ps in prims for p in ps]
    table = np.asarray(flat, np.float32).reshape(-1, 8)
    return LayoutProblem(
        names=tuple(names),
        units=tuple(units),
        supports=supports,
        shape=shape,
        terms=tuple(rel_terms),
        obstacles=tuple(blocked),
        notes=tuple(notes),
        ground=frozenset(ground),
        falling=falling_nodes(doc),
        terms_of=terms_of,
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
        unit_free=domains.free,
        unit_pose=domains.pose,
        unit_box=domains.box,
        unit_anchor=domains.anchor,
        unit_center=domains.centre,
        unit_step=domains.step,
        aff=aff,
        unit_edges=unit_edges,
        unit_pairs=unit_pairs,
        edge_kind=np.asarray([t.kind for t in rel_terms], np.int32),
        edge_node=np.asarray(edge_nodes, np.int32).reshape(-1, 3),
        edge_w=np.asarray([t.weight for t in rel_terms], np.float32),
        edge_p=params,
        pair=pair,
        pair_margin=margin,
        pair_avoid=avoid,
    )
