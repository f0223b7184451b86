"""Turns one scene into arrays: the planar problem that the kernels search."""

from __future__ import annotations

from dataclasses import dataclass, replace
import math

import numpy as np

from esg.graph.models import EsgDocument
from esg.layout.problem import terms
from esg.layout.problem.domains import unit_domains
from esg.layout.problem.edges import Term, binary_terms, multi_terms
from esg.layout.problem.grouping import UnitBuilder
from esg.layout.problem.heights import heights
from esg.layout.problem.hints import StartHints
from esg.layout.problem.joined import joined
from esg.layout.problem.obstacles import CLEAR_HEIGHT_CM, Obstacle, Prism, obstacles
from esg.layout.problem.ordering import break_parent_cycles, implied_faces, placement_order
from esg.layout.problem.pairs import collision_pairs
from esg.layout.problem.poses import Pose2
from esg.layout.problem.record import PARAMS, LayoutProblem
from esg.layout.problem.roles import falling_nodes, ground_nodes
from esg.layout.problem.shapes import CIRCLE
from esg.layout.problem.supports import Rect, Shape, SupportMap, find_supports, shapes
from esg.layout.problem.units import Unit


@dataclass(frozen=True)
class _Scene:
    """A document as far as it was read: its units in order, and what stands between them."""

    doc: EsgDocument
    shape: dict[str, Shape]
    supports: SupportMap
    units: list[Unit]
    unit_of: dict[str, int]
    terms: list[Term]
    z: dict[str, float]
    ground: set[str]

    @property
    def names(self) -> list[str]:
        return list(self.doc.spatial_relation_graph.nodes)


@dataclass(frozen=True)
class _Nodes:
    """Columns of the nodes: the real ones first, then the swept paths."""

    unit: list[int]
    rel: list[Pose2]
    z: list[float]
    half: list[tuple[float, float]]
    round: list[int]
    height: list[float]
    prims: list[list[Prism]]


def build_problem(doc: EsgDocument, seed: int, hints: StartHints | None) -> LayoutProblem:
    """Turns a resolved document into arrays.

    Args:
        doc: Needs `asset_configurations` for every node.
        seed: Seeds scatter patterns only.
        hints: Planned starts.
    """
    shape = shapes(doc)
    supports = find_supports(doc, shape)
    builder = UnitBuilder(doc, shape, supports, hints, seed)
    units = builder.build()
    notes = list(builder.notes) + [f"{k}: {v}" for k, v in supports.notes.items()]
    z = heights(doc, builder, supports, shape)
    unit_of = {n: i for i, u in enumerate(units) for n in u.members}
    break_parent_cycles(units, unit_of, notes)
    scene = _Scene(doc, shape, supports, units, unit_of, [], z, set(ground_nodes(doc)))
    scene = replace(scene, terms=[*_relation_terms(scene), *_region_terms(scene)])
    area = [
        sum(4 * shape[n].hx * shape[n].hy for n in u.members if not shape[n].is_decal)
        for u in units
    ]
    order = placement_order(units, scene.terms, unit_of, area)
    units = [units[i] for i in order]
    unit_of = {n: i for i, u in enumerate(units) for n in u.members}
    return _arrays(replace(scene, units=units, unit_of=unit_of), notes, seed)


def _relation_terms(scene: _Scene) -> list[Term]:
    """Energy terms of the stated relations, and of faces that follow from them."""
    doc, shape = scene.doc, scene.shape
    out: list[Term] = []
    for k, e in enumerate(doc.spatial_relation_graph.edges.binary_relations):
        if e.from_ in shape and e.to in shape and e.from_ != e.to:
            out += [
                t for t in binary_terms(k, e, shape, scene.supports)
                if e.cardinal is not None or not {e.from_, e.to} & scene.ground
            ]  # fmt: skip
    out += multi_terms(doc, shape, scene.supports)
    out += [Term(terms.FACE, (a, b, None), 0.5, (0.0, 0.0)) for a, b in implied_faces(doc)]
    return out


def _region_terms(scene: _Scene) -> list[Term]:
    """What keeps things on what carries them, and within the world."""
    (bx0, by0, _), (bx1, by1, _) = scene.doc.scene_definition.coordinate_system.world_bounds_cm
    out: list[Term] = []
    for i, u in enumerate(scene.units):
        for n in u.members:
            s, child = scene.supports.of[n], scene.shape[n]
            if n in scene.ground or (child.is_decal and max(child.hx, child.hy) > 1000.0):
                continue
            if s.parent is None or n in u.z_cm:
                rect = (s.rect if n not in u.z_cm else None) or (bx0, by0, bx1, by1)
                out.append(Term(terms.REGION, (n, None, None), 1.0, rect))
            elif scene.unit_of.get(s.parent) != i and s.rect is not None:
                out.append(Term(terms.REGION, (n, s.parent, None), 1.0, _overhang(s.rect, child)))
    return out


def _overhang(rect: Rect, child: Shape) -> Rect:
    """A surface smaller than the object holds the object's centre instead of its footprint."""
    x0, y0, x1, y1 = rect
    if child.hx > 0.5 * (x1 - x0):
        m = 0.5 * (x0 + x1)
        x0, x1 = m - child.hx - 0.01, m + child.hx + 0.01
    if child.hy > 0.5 * (y1 - y0):
        m = 0.5 * (y0 + y1)
        y0, y1 = m - child.hy - 0.01, m + child.hy + 0.01
    return x0, y0, x1, y1


def _nodes(scene: _Scene, blocked: list[Obstacle]) -> _Nodes:
    names, shape = scene.names, scene.shape
    return _Nodes(
        unit=[scene.unit_of[n] for n in names] + [o.unit for o in blocked],
        rel=[scene.units[scene.unit_of[n]].members[n] for n in names] + [o.rel for o in blocked],
        z=[scene.z[n] for n in names] + [o.base_z_cm for o in blocked],
        half=[(shape[n].hx, shape[n].hy) for n in names] + [(1.0, 1.0)] * len(blocked),
        round=[int(shape[n].is_round) for n in names] + [0] * len(blocked),
        height=[shape[n].height for n in names] + [CLEAR_HEIGHT_CM] * len(blocked),
        prims=[_prisms(shape[n]) if n not in scene.ground else [] for n in names]
        + [list(o.prisms) for o in blocked],
    )


def _prisms(shape: Shape) -> list[Prism]:
    return [(float(p.kind), p.x, p.y, p.yaw, p.hx, p.hy, p.z0, p.z1) for p in shape.prims]


def _radius(prisms: list[Prism]) -> float:
    """Radius about a node's origin that holds its prisms [cm]."""
    reach = (p[4] if p[0] == CIRCLE else math.hypot(p[4], p[5]) for p in prisms)
    return max(
        (math.hypot(p[1], p[2]) + r for p, r in zip(prisms, reach, strict=True)), default=0.0
    )


def _moved_nodes(scene: _Scene, node_unit: list[int]) -> list[list[int]]:
    """Nodes that each unit moves: its own, and those of the units that it carries."""
    parents = [scene.unit_of[u.parent] if u.parent is not None else -1 for u in scene.units]
    out: list[list[int]] = []
    for u in range(len(scene.units)):
        moved = {u}
        for v in range(u + 1, len(scene.units)):
            if parents[v] in moved:
                moved.add(v)
        nodes = (i for i, unit in enumerate(node_unit) if unit in moved)
        out.append(sorted(nodes, key=lambda i: (node_unit[i], i)))
    return out


def _touched(
    aff: list[list[int]], count: int, edge_nodes: list[tuple[int, ...]], pair: np.ndarray
) -> tuple[list[list[int]], list[list[int]]]:
    """Terms and pairs whose energy each unit changes by moving, of `count` nodes."""
    movers: list[set[int]] = [set() for _ in range(count)]
    for u, nodes in enumerate(aff):
        for n in nodes:
            movers[n].add(u)
    unit_edges: list[list[int]] = [[] for _ in aff]
    for k, ns in enumerate(edge_nodes):
        for u in sorted(set[int]().union(*(movers[n] for n in ns if n >= 0))):
            unit_edges[u].append(k)
    unit_pairs: list[list[int]] = [[] for _ in aff]
    for k, (a, b) in enumerate(pair.tolist()):
        for u in sorted(movers[a] ^ movers[b]):  # a unit that moves both leaves them as they are
            unit_pairs[u].append(k)
    return unit_edges, unit_pairs


def _params(rel_terms: list[Term]) -> np.ndarray:
    out = np.zeros((len(rel_terms), PARAMS), np.float32)
    for i, t in enumerate(rel_terms):
        out[i, : len(t.params)] = t.params
    return out


def _arrays(scene: _Scene, notes: list[str], seed: int) -> LayoutProblem:
    doc, units, supports, shape = scene.doc, scene.units, scene.supports, scene.shape
    names, rel_terms = scene.names, scene.terms
    index = {n: i for i, n in enumerate(names)}
    blocked = obstacles(doc, units, supports, shape, scene.z)
    node = _nodes(scene, blocked)
    pair, margin, avoid = collision_pairs(
        doc, names, node.unit, node.z, node.prims, blocked, supports, shape
    )
    aff = _moved_nodes(scene, node.unit)
    edge_nodes = [tuple(-1 if n is None else index[n] for n in t.nodes) for t in rel_terms]
    unit_edges, unit_pairs = _touched(aff, len(node.unit), edge_nodes, pair)
    rng = np.random.default_rng([seed, 78])
    domains = unit_domains(doc, units, supports, shape, rel_terms, unit_edges, scene.ground, rng)
    terms_of: dict[str, list[Term]] = {}
    for t in rel_terms:
        if t.source:
            terms_of.setdefault(t.source, []).append(t)
    table = np.asarray([p for ps in node.prims for p in ps], np.float32).reshape(-1, 8)
    return LayoutProblem(
        names=tuple(names),
        units=tuple(units),
        supports=supports,
        shape=shape,
        terms=tuple(rel_terms),
        obstacles=tuple(blocked),
        notes=tuple(notes),
        ground=frozenset(scene.ground),
        falling=falling_nodes(doc),
        terms_of=terms_of,
        joined=joined(doc),
        node_unit=np.asarray(node.unit, np.int32),
        node_rel=np.asarray(node.rel, np.float32).reshape(-1, 3),
        node_z=np.asarray(node.z, np.float32),
        node_half=np.asarray(node.half, np.float32).reshape(-1, 2),
        node_round=np.asarray(node.round, np.int32),
        node_height=np.asarray(node.height, np.float32),
        node_radius=np.asarray([_radius(ps) for ps in node.prims], np.float32),
        prim_off=np.cumsum([0, *[len(p) for p in node.prims]]).astype(np.int32),
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
        edge_p=_params(rel_terms),
        pair=pair,
        pair_margin=margin,
        pair_avoid=avoid,
    )
