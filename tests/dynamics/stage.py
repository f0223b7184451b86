"""Small resolved documents with simple proxies, and the plainest possible layout."""

from __future__ import annotations

import math

from esg.dynamics import start_hints
from esg.graph.models import (
    Actor,
    AssetConfiguration,
    AssetRequirement,
    EsgDocument,
    LayoutResult,
    NamedRegion,
    Node,
    Pose,
    Proxy,
    SceneDefinition,
    SceneParameters,
    SemanticRegion,
    SequenceGraph,
    SpatialRelationGraph,
    SupportSurface,
    TimelineEdge,
    TimelineNode,
    TimelineSystem,
)


def asset(
    category: str,
    dims: tuple[float, float, float],
    mass: float,
    shape: str = "box",
    *,
    friction: float = 0.5,
    restitution: float = 0.2,
    wheeled: bool = False,
    movable: bool = True,
    surface: bool = False,
    regions: tuple[NamedRegion, ...] = (),
) -> AssetConfiguration:
    """One asset with a single exact proxy [cm, kg]."""
    length, width, height = dims
    half = (length / 2, width / 2, height / 2)
    size = {"sphere": (half[2],) * 3, "cylinder": (half[0], half[0], half[2]), "box": half}[shape]
    k = [v / 100 for v in dims]
    if shape == "sphere":
        i = [0.4 * mass * (k[2] / 2) ** 2] * 3
    else:
        i = [mass / 12 * (k[(a + 1) % 3] ** 2 + k[(a + 2) % 3] ** 2) for a in range(3)]
    return AssetConfiguration(
        asset_name=category,
        source="parametric",
        category=category,
        mesh_path=f"meshes/{category}.glb",
        dimensions_cm=dims,
        proxies=(Proxy(kind=shape, size_cm=size, position_cm=(0, 0, half[2])),),
        support_surfaces=(
            (SupportSurface(name="top", center_cm=(0, 0, height), half_extents_cm=half[:2]),)
            if surface
            else ()
        ),
        regions=regions,
        mass_kg=mass,
        is_movable=movable,
        center_of_mass_cm=(0, 0, half[2]),
        inertia_kg_cm2=(i[0] * 1e4, i[1] * 1e4, i[2] * 1e4, 0, 0, 0),
        friction=friction,
        restitution=restitution,
        angular_damping=0.05 if shape == "sphere" else 0.0,
        is_wheeled=wheeled,
        rolls=shape == "sphere",
    )


CAR = asset("car", (450, 180, 145), 1300, friction=0.1, restitution=0.1, wheeled=True)
BIN = asset("trash_bin", (60, 60, 95), 12, "cylinder")
TABLE = asset("picnic_table", (180, 150, 75), 40, surface=True)
BALL = asset("ball", (22, 22, 22), 0.45, "sphere", restitution=0.7)
GROUND = AssetConfiguration(
    asset_name="ground", source="parametric", category="ground", mesh_path="meshes/ground.glb",
    dimensions_cm=(8000, 8000, 1), mass_kg=1, is_movable=False, friction=0.7, restitution=0.3,
)  # fmt: skip


def document(
    prompt: str,
    objects: dict[str, AssetConfiguration],
    actors: dict[str, Actor],
    nodes: list[TimelineNode],
    edges: list[TimelineEdge],
    *,
    on: dict[str, str] | None = None,
) -> EsgDocument:
    """A resolved document; `on` names the supporting node of what does not stand on ground."""
    everything = {"ground_1": GROUND, **objects}
    on = on or {}
    parents = {"ground_1", *on.values()}
    return EsgDocument(
        scene_definition=SceneDefinition(
            scene_id="test",
            original_description=prompt,
            scene_parameters=SceneParameters(is_dynamic=bool(nodes), scene_type="outdoor"),
        ),
        asset_requirement={
            n: AssetRequirement(
                asset_category=a.category,
                asset_description=a.category,
                expected_dimensions_cm=a.dimensions_cm,
                expected_mass_kg=a.mass_kg,
            )
            for n, a in everything.items()
        },
        asset_configurations=everything,
        spatial_relation_graph=SpatialRelationGraph(
            semantic_regions={
                f"{p}_top": SemanticRegion(
                    region_description="", region_type="SUPPORT_SURFACE", parent_object=p
                )
                for p in parents
            },
            nodes={
                n: Node(
                    asset_id=n,
                    semantic_region=None if n == "ground_1" else f"{on.get(n, 'ground_1')}_top",
                    is_structural=n == "ground_1",
                    label=n.replace("_", " "),
                )
                for n in everything
            },
        ),
        timeline_system=TimelineSystem(
            actors=actors, sequence_graph=SequenceGraph(nodes=tuple(nodes), edges=tuple(edges))
        )
        if nodes
        else None,
    )


def lay_out(doc: EsgDocument, seed: int = 0) -> EsgDocument:
    """Puts every constellation at the origin of its frame; anchors stand at the world's origin."""
    poses = {"ground_1": Pose(position_cm=(0, 0, 0))}
    nodes = doc.spatial_relation_graph.nodes
    for k, c in enumerate(start_hints(doc, seed=seed).constellations):
        base = 0.0
        if c.anchor:
            poses[c.anchor] = Pose(position_cm=(0, 0, 0))
            config = doc.asset_configurations[nodes[c.anchor].asset_id]
            base = config.support_surfaces[0].center_cm[2]
        for p in c.placements:
            z = base if p.z_cm is None else p.z_cm
            poses[p.node] = Pose(
                position_cm=(p.x_cm, p.y_cm + 1500 * k, z), yaw_deg=p.yaw_deg or 0.0
            )
    for i, n in enumerate(nodes):
        poses.setdefault(n, Pose(position_cm=(0, -1500 - 300 * i, 0)))
    assert all(math.isfinite(v) for p in poses.values() for v in p.position_cm)
    return doc.model_copy(update={"layout_result": LayoutResult(poses=poses, energy=0.0)})
