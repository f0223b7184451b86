"""Generated layout problems that admit a solution: relations are read off a hidden layout.

A witness places 3-25 objects without overlap (bounding circles, random headings); relations that
hold in it are sampled. The solver sees the relations only.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from esg.graph.models import (
    AssetConfiguration,
    BinaryRelation,
    EsgDocument,
    NamedRegion,
    Node,
    Proxy,
    ProxyKind,
    RelationEdges,
    RelationType,
    SceneDefinition,
    SceneParameters,
    SpatialRelationGraph,
    SupportSurface,
)
from esg.layout.judge.check import World, binary_violation
from esg.layout.problem.poses import compose
from esg.layout.problem.problem import build_problem


def _asset(
    name: str, dims: tuple[float, float, float], proxies: tuple[Proxy, ...], mass: float, **kw: Any
) -> AssetConfiguration:
    x, y, h = dims
    inertia = tuple(mass / 12.0 * v for v in (y * y + h * h, x * x + h * h, x * x + y * y))
    return AssetConfiguration(
        asset_name=name,
        source="parametric",
        inertia_kg_cm2=(*inertia, 0.0, 0.0, 0.0),  # of the bounding box
        category=name,
        mesh_path=f"meshes/{name}.glb",
        dimensions_cm=dims,
        proxies=proxies,
        mass_kg=mass,
        is_movable=kw.pop("is_movable", True),
        friction=0.6,
        restitution=0.1,
        center_of_mass_cm=(0.0, 0.0, 0.4 * dims[2]),
        **kw,
    )


def _box(half: tuple[float, float, float], at: tuple[float, float, float]) -> Proxy:
    return Proxy(kind=ProxyKind.BOX, size_cm=half, position_cm=at)


def _solid(name: str, x: float, y: float, z: float, mass: float) -> AssetConfiguration:
    top = SupportSurface(name="top", center_cm=(0, 0, z), half_extents_cm=(x / 2, y / 2))
    return _asset(
        name,
        (x, y, z),
        (_box((x / 2, y / 2, z / 2), (0, 0, z / 2)),),
        mass,
        support_surfaces=(top,),
    )


def _round(name: str, r: float, h: float, mass: float) -> AssetConfiguration:
    proxy = Proxy(kind=ProxyKind.CYLINDER, size_cm=(r, r, h / 2), position_cm=(0, 0, h / 2))
    return _asset(name, (2 * r, 2 * r, h), (proxy,), mass)


def _table(name: str, x: float, y: float, z: float, mass: float) -> AssetConfiguration:
    parts = [_box((x / 2, y / 2, 2), (0, 0, z - 2))]
    for sx in (-1, 1):
        for sy in (-1, 1):
            at = (sx * (x / 2 - 5), sy * (y / 2 - 5), (z - 4) / 2)
            parts.append(_box((3, 3, (z - 4) / 2), at))
    top = SupportSurface(name="top", center_cm=(0, 0, z), half_extents_cm=(x / 2, y / 2))
    return _asset(name, (x, y, z), tuple(parts), mass, support_surfaces=(top,))


def _bin(name: str, x: float, y: float, z: float, mass: float) -> AssetConfiguration:
    t = 2.0
    parts = [_box((x / 2, y / 2, t / 2), (0, 0, t / 2))]
    for s in (-1, 1):
        parts.append(_box((t / 2, y / 2, z / 2), (s * (x - t) / 2, 0, z / 2)))
        parts.append(_box((x / 2, t / 2, z / 2), (0, s * (y - t) / 2, z / 2)))
    inside = NamedRegion(
        name="inside",
        center_cm=(0, 0, (z + t) / 2),
        half_extents_cm=(x / 2 - t, y / 2 - t, (z - t) / 2),
        kind="inside",
    )
    return _asset(name, (x, y, z), tuple(parts), mass, regions=(inside,))


def _chair(name: str) -> AssetConfiguration:
    parts = [_box((22, 22, 2), (2, 0, 44)), _box((2, 22, 22), (-20, 0, 68))]
    for sx in (-18, 22):
        for sy in (-20, 20):
            parts.append(_box((2, 2, 21), (sx, sy, 21)))
    return _asset(name, (48, 44, 90), tuple(parts), 6.0)


CATALOGUE: dict[str, AssetConfiguration] = {
    "ground": _asset("ground", (12000, 12000, 0), (), 0.0, is_movable=False),
    "desk": _table("desk", 80, 160, 75, 30.0),
    "round_crate": _round("round_crate", 40, 60, 12.0),
    "picnic_table": _table("picnic_table", 150, 180, 76, 40.0),
    "sideboard": _solid("sideboard", 45, 140, 80, 40.0),
    "chair": _chair("chair"),
    "sofa": _solid("sofa", 90, 200, 80, 50.0),
    "crate": _solid("crate", 40, 60, 35, 5.0),
    "bin": _bin("bin", 50, 40, 45, 3.0),
    "plant": _round("plant", 18, 90, 6.0),
    "ball": _asset(
        "ball",
        (22, 22, 22),
        (Proxy(kind=ProxyKind.SPHERE, size_cm=(11, 11, 11), position_cm=(0, 0, 11)),),
        0.5,
        rolls=True,
        angular_damping=0.5,
    ),
    "laptop": _solid("laptop", 25, 36, 3, 2.0),
    "mug": _round("mug", 4.5, 10, 0.3),
    "bottle": _round("bottle", 4, 24, 0.6),
    "book": _solid("book", 15, 21, 3, 0.5),
    "lamp": _round("lamp", 9, 45, 2.0),
    "box": _solid("box", 12, 18, 10, 0.8),
}
CARRIERS = ("desk", "picnic_table", "sideboard")
FLOOR = ("chair", "sofa", "crate", "bin", "plant", "ball", "round_crate")
SMALL = ("laptop", "mug", "bottle", "book", "lamp", "box")
SOFT = (
    RelationType.NEAR,
    RelationType.ADJACENT,
    RelationType.FAR_FROM,
    RelationType.LEFT_OF,
    RelationType.RIGHT_OF,
    RelationType.IN_FRONT_OF,
    RelationType.BEHIND,
    RelationType.FACE,
)


def _dart(
    rng: np.random.Generator,
    rect: tuple[float, float, float, float],
    radius: float,
    taken: list[tuple[float, float, float]],
) -> tuple[float, float] | None:
    x0, y0, x1, y1 = rect
    if x1 - x0 < 2 * radius or y1 - y0 < 2 * radius:
        return None
    for _ in range(60):
        x = float(rng.uniform(x0 + radius, x1 - radius))
        y = float(rng.uniform(y0 + radius, y1 - radius))
        if all(math.hypot(x - a, y - b) > radius + r + 1.0 for a, b, r in taken):
            return x, y
    return None


def _document(name: str, nodes: dict[str, Node], edges: list[BinaryRelation]) -> EsgDocument:
    return EsgDocument(
        scene_definition=SceneDefinition(
            scene_id=name,
            original_description="generated layout problem",
            scene_parameters=SceneParameters(is_dynamic=False, scene_type="indoor"),
        ),
        asset_configurations={n.asset_id: CATALOGUE[n.asset_id] for n in nodes.values()},
        spatial_relation_graph=SpatialRelationGraph(
            nodes=nodes, edges=RelationEdges(binary_relations=tuple(edges))
        ),
    )


def generate(seed: int, count: int | None = None, density: float = 1.2) -> EsgDocument:
    """Returns one solvable document.

    Args:
        seed: Seed of everything.
        count: Objects; None draws 3-25.
        density: Sampled relations per object, besides the supports.
    """
    rng = np.random.default_rng([seed, 2024])
    count = int(rng.integers(3, 26)) if count is None else count
    nodes = {"ground_1": Node(asset_id="ground", is_structural=True)}
    pose: dict[str, tuple[float, float, float]] = {"ground_1": (0.0, 0.0, 0.0)}
    edges: list[BinaryRelation] = []
    taken: dict[str, list[tuple[float, float, float]]] = {"ground_1": []}
    carriers: list[str] = []
    bins: list[str] = []
    span = 120.0 * math.sqrt(count) + 100.0
    while len(nodes) - 1 < count:
        k = len(nodes)
        wish = rng.random()
        if (wish < 0.3 or not carriers) and len(carriers) < 1 + count // 8:
            kind, support = str(rng.choice(CARRIERS)), "ground_1"
        elif wish < 0.65 and carriers:
            kind, support = str(rng.choice(SMALL)), str(rng.choice(carriers))
        elif wish < 0.72 and bins:
            kind, support = str(rng.choice(("mug", "bottle", "box"))), str(rng.choice(bins))
        else:
            kind, support = str(rng.choice(FLOOR)), "ground_1"
        name = f"{kind}_{k}"
        c = CATALOGUE[kind]
        radius = 0.5 * math.hypot(c.dimensions_cm[0], c.dimensions_cm[1])
        if support == "ground_1":
            rect = (-span, -span, span, span)
        else:
            s = CATALOGUE[nodes[support].asset_id]
            if support in bins:
                (cx, cy, _), (hx, hy, _) = s.regions[0].center_cm, s.regions[0].half_extents_cm
            else:
                (cx, cy, _), (hx, hy) = (
                    s.support_surfaces[0].center_cm,
                    s.support_surfaces[0].half_extents_cm,
                )
            rect = (cx - hx, cy - hy, cx + hx, cy + hy)
        at = _dart(rng, rect, radius, taken.setdefault(support, []))
        if at is None:
            span *= 1.05
            continue
        taken[support].append((*at, radius))
        yaw = float(rng.integers(4)) * math.pi / 2
        if rng.random() < 0.3:
            yaw = float(rng.uniform(0, 2 * math.pi))
        nodes[name] = Node(asset_id=kind)
        pose[name] = compose(pose[support], (*at, yaw))
        relation = RelationType.INSIDE_OF if support in bins else RelationType.ON
        edges.append(BinaryRelation(from_=name, relation_type=relation, to=support))
        if kind in CARRIERS:
            carriers.append(name)
        if kind == "bin":
            bins.append(name)

    names = [n for n in nodes if n != "ground_1"]
    parent = {e.from_: e.to for e in edges}
    pool: list[BinaryRelation] = []
    for a in names:
        for b in names:
            if a != b and parent[a] == parent[b]:
                pool += [BinaryRelation(from_=a, relation_type=t, to=b) for t in SOFT]
    trial = _document("trial", nodes, [*edges, *pool])
    problem = build_problem(trial, 0, None)
    z = {n: float(problem.node_z[i]) for i, n in enumerate(problem.names)}
    world = World(pose, z)
    base = len(edges)
    true = [e for k, e in enumerate(pool) if binary_violation(problem, world, base + k, e)[0] <= 0]
    # rare relations (near, adjacent, face) count as much as the common directional ones
    kinds = sorted({e.relation_type.value for e in true})
    chosen: list[BinaryRelation] = []
    faced: set[str] = set()
    want = round(density * count)
    for _ in range(20 * want):
        if len(chosen) >= want or not kinds:
            break
        kind = str(rng.choice(kinds))
        options = [e for e in true if e.relation_type.value == kind and e not in chosen]
        if not options:
            kinds.remove(kind)
            continue
        e = options[int(rng.integers(len(options)))]
        if kind == "face":
            if e.from_ in faced:
                continue
            faced.add(e.from_)
        if any({e.from_, e.to} == {o.from_, o.to} for o in chosen):
            continue
        chosen.append(e)
    return _document(f"graph_{seed:04d}", nodes, [*edges, *chosen])
