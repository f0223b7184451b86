"""Small documents for layout tests: analytic assets, no drafting and no resolving."""

from __future__ import annotations

from typing import Any

from esg.graph.models import (
    AssetConfiguration,
    BinaryRelation,
    EsgDocument,
    MultiRelation,
    NamedRegion,
    Node,
    Proxy,
    ProxyKind,
    RelationEdges,
    SceneDefinition,
    SceneParameters,
    SpatialRelationGraph,
    SupportSurface,
)


def asset(
    name: str, proxies: tuple[Proxy, ...], dims: tuple[float, float, float], **kw: Any
) -> AssetConfiguration:
    return AssetConfiguration(
        asset_name=name,
        source="parametric",
        category=kw.pop("category", name),
        mesh_path=f"meshes/{name}.glb",
        dimensions_cm=dims,
        proxies=proxies,
        mass_kg=kw.pop("mass_kg", 1.0),
        is_movable=kw.pop("is_movable", True),
        friction=0.5,
        restitution=0.2,
        **kw,
    )


def box(name: str, lx: float, ly: float, h: float, **kw: Any) -> AssetConfiguration:
    proxy = Proxy(kind=ProxyKind.BOX, size_cm=(lx / 2, ly / 2, h / 2), position_cm=(0, 0, h / 2))
    top = SupportSurface(name="top", center_cm=(0, 0, h), half_extents_cm=(lx / 2, ly / 2))
    return asset(name, (proxy,), (lx, ly, h), support_surfaces=(top,), **kw)


def ball(name: str, r: float, **kw: Any) -> AssetConfiguration:
    proxy = Proxy(kind=ProxyKind.SPHERE, size_cm=(r, r, r), position_cm=(0, 0, r))
    return asset(name, (proxy,), (2 * r, 2 * r, 2 * r), rolls=True, **kw)


def cylinder(name: str, r: float, h: float, **kw: Any) -> AssetConfiguration:
    proxy = Proxy(kind=ProxyKind.CYLINDER, size_cm=(r, r, h / 2), position_cm=(0, 0, h / 2))
    return asset(name, (proxy,), (2 * r, 2 * r, h), **kw)


def table(name: str, lx: float, ly: float, h: float, **kw: Any) -> AssetConfiguration:
    leg = 4.0
    parts = [Proxy(kind=ProxyKind.BOX, size_cm=(lx / 2, ly / 2, 2), position_cm=(0, 0, h - 2))]
    for sx in (-1, 1):
        for sy in (-1, 1):
            parts.append(
                Proxy(
                    kind=ProxyKind.BOX,
                    size_cm=(leg / 2, leg / 2, (h - 4) / 2),
                    position_cm=(sx * (lx / 2 - leg), sy * (ly / 2 - leg), (h - 4) / 2),
                )
            )
    top = SupportSurface(name="top", center_cm=(0, 0, h), half_extents_cm=(lx / 2, ly / 2))
    return asset(
        name,
        tuple(parts),
        (lx, ly, h),
        support_surfaces=(top,),
        category=kw.pop("category", "table"),
        **kw,
    )


def bin_(
    name: str, lx: float, ly: float, h: float, t: float = 2.0, **kw: Any
) -> AssetConfiguration:
    """An open box with walls of thickness t and an `inside` region."""
    parts = [Proxy(kind=ProxyKind.BOX, size_cm=(lx / 2, ly / 2, t / 2), position_cm=(0, 0, t / 2))]
    for s in (-1, 1):
        parts.append(
            Proxy(
                kind=ProxyKind.BOX,
                size_cm=(t / 2, ly / 2, h / 2),
                position_cm=(s * (lx - t) / 2, 0, h / 2),
            )
        )
        parts.append(
            Proxy(
                kind=ProxyKind.BOX,
                size_cm=(lx / 2, t / 2, h / 2),
                position_cm=(0, s * (ly - t) / 2, h / 2),
            )
        )
    inside = NamedRegion(
        name="inside",
        center_cm=(0, 0, (h + t) / 2),
        half_extents_cm=(lx / 2 - t, ly / 2 - t, (h - t) / 2),
        kind="inside",
    )
    return asset(name, tuple(parts), (lx, ly, h), regions=(inside,), **kw)


def decal(name: str, lx: float, ly: float, **kw: Any) -> AssetConfiguration:
    return asset(name, (), (lx, ly, 0.0), is_movable=False, **kw)


GROUND = asset("ground", (), (10000.0, 10000.0, 0.0), is_movable=False, category="ground")


def document(
    assets: dict[str, AssetConfiguration],
    nodes: dict[str, str | tuple[str, dict[str, Any]]],
    edges: list[tuple[Any, ...]] = (),  # type: ignore[assignment]  # empty default
    multi: list[MultiRelation] = (),  # type: ignore[assignment]  # empty default
    regions: dict[str, Any] | None = None,
) -> EsgDocument:
    """nodes: id -> asset id or (asset id, node fields); edges: (from, relation, to[, fields])."""
    table_ = {"ground_1": Node(asset_id="ground", is_structural=True)}
    for name, value in nodes.items():
        a, kw = (value, {}) if isinstance(value, str) else value
        table_[name] = Node(asset_id=a, **kw)
    return EsgDocument(
        scene_definition=SceneDefinition(
            scene_id="t",
            original_description="",
            scene_parameters=SceneParameters(is_dynamic=False, scene_type="indoor"),
        ),
        asset_configurations={"ground": GROUND, **assets},
        spatial_relation_graph=SpatialRelationGraph(
            semantic_regions=regions or {},
            nodes=table_,
            edges=RelationEdges(
                binary_relations=tuple(
                    BinaryRelation(
                        from_=e[0], relation_type=e[1], to=e[2], **(e[3] if len(e) > 3 else {})
                    )
                    for e in edges
                ),
                multi_relations=tuple(multi),
            ),
        ),
    )
