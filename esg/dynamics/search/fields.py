"""Voxel signed distance fields of a document's bodies, and samples of their surfaces."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Body, Shape, SimScene
from esg.graph.models import EsgDocument
from esg.units import quat_rotate

if TYPE_CHECKING:
    import trimesh

    from esg.engines.surrogate import BodyField

Floats = NDArray[np.float64]

RESOLUTION = 48
"""Cells along the longest side of a body."""
SAMPLES = 320
"""Points on a body's surface that are looked up in the fields of others."""
_CANDIDATES = 6000
_SHARP_RAD = 0.5
_THIN_CELLS = 0.75
_THIN_SHARE = 0.1


def body_fields(
    doc: EsgDocument,
    scene: SimScene,
    names: Collection[str],
    *,
    resolution: int = RESOLUTION,
    cache: Path | None = None,
    source: str = "parts",
) -> dict[str, BodyField]:
    """Fields of bodies by name.

    Args:
        doc: The document the scene was built from.
        scene: Bodies, SI.
        names: Bodies that get one.
        resolution: Cells along the longest side.
        cache: Folder of computed fields by content.
        source: "parts" for the surface of the collision parts, which is what the engines that
            judge collide; "mesh" for the asset's visible surface, where this machine has it.
    """
    made: dict[object, BodyField] = {}
    out: dict[str, BodyField] = {}
    nodes = doc.spatial_relation_graph.nodes
    for body in scene.bodies:
        if body.name not in names:
            continue
        asset = nodes[body.name].asset_id if body.name in nodes else body.name
        key = (asset, body.shapes)
        if key not in made:
            mesh = _asset_mesh(doc, asset, body) if source == "mesh" else None
            made[key] = field_of(mesh or parts_mesh(body), resolution=resolution, cache=cache)
        out[body.name] = made[key]
    return out


def field_of(
    mesh: trimesh.Trimesh, *, resolution: int = RESOLUTION, cache: Path | None = None
) -> BodyField:
    """Field and samples of a surface in the body's frame [m].

    Walls thinner than a cell leave no negative value; such surfaces are thickened by half a cell,
    so that nothing passes through them.
    """
    from esg.assets.geometry.sdf import voxel_sdf
    from esg.engines.surrogate import BodyField

    vertices, faces = np.asarray(mesh.vertices, float), np.asarray(mesh.faces)
    found = voxel_sdf(100.0 * vertices, faces, resolution, cache)
    points, normals = _surface(mesh)
    inside = found.sample(100.0 * points - _THIN_CELLS * found.cell_cm * normals)
    values = found.values / 100.0
    if float(np.mean(inside > -0.1 * found.cell_cm)) > _THIN_SHARE:
        values = values - 0.5 * found.cell_cm / 100.0
    return BodyField(
        values.astype(np.float32),
        np.asarray(found.origin_cm) / 100.0,
        found.cell_cm / 100.0,
        _samples(mesh, points),
    )


def spread_out(points: Floats, count: int, near: Floats | None = None) -> Floats:
    """A subset far apart from each other (farthest point sampling).

    Args:
        points: Shape [n, 3].
        count: How many; fewer if there are no more different points.
        near: Points that are chosen already, shape [m, 3]; if None the outermost point is first.
    """
    if near is None or not len(near):
        centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
        away = ((points - centre) ** 2).sum(axis=1)
        near = points[[int(np.argmax(away))]]
        chosen = [near[0]]
    else:
        chosen = []
    away = np.min([((points - p) ** 2).sum(axis=1) for p in near], axis=0)
    while len(chosen) < count:
        pick = int(np.argmax(away))
        if away[pick] <= 1e-12:
            break
        chosen.append(points[pick])
        away = np.minimum(away, ((points - points[pick]) ** 2).sum(axis=1))
    return np.array(chosen).reshape(-1, 3)


def _samples(mesh: trimesh.Trimesh, surface: Floats) -> Floats:
    """Corners, then points along sharp edges, then the rest of the surface."""
    sharp = mesh.face_adjacency_angles > _SHARP_RAD
    ends = np.asarray(mesh.vertices, float)[mesh.face_adjacency_edges[sharp]]
    if not len(ends):
        return spread_out(surface, SAMPLES)
    corners = spread_out(ends.reshape(-1, 3), SAMPLES // 4)
    share = np.linspace(0.0, 1.0, 13)[:, None, None]
    along = (ends[:, 0] + share * (ends[:, 1] - ends[:, 0])).reshape(-1, 3)
    edges = spread_out(along, SAMPLES // 4, corners)
    kept = np.concatenate([corners, edges])
    return np.concatenate([kept, spread_out(surface, SAMPLES - len(kept), kept)])


def parts_mesh(body: Body) -> trimesh.Trimesh:
    """All collision parts of a body as one surface in the body's frame [m]."""
    import trimesh

    whole: Any = trimesh.util.concatenate([_part(s) for s in body.shapes])
    return whole


def _part(shape: Shape) -> trimesh.Trimesh:
    import trimesh

    x, y, z = shape.size
    if shape.kind == "sphere":
        mesh = trimesh.creation.icosphere(subdivisions=3, radius=x)
    elif shape.kind == "box":
        mesh = trimesh.creation.box(extents=(2 * x, 2 * y, 2 * z))
    elif shape.kind == "capsule":
        mesh = trimesh.creation.capsule(height=2 * z, radius=x)
        mesh.apply_translation(-0.5 * (mesh.bounds[0] + mesh.bounds[1]))
    elif shape.kind == "cylinder":
        mesh = trimesh.creation.cylinder(radius=x, height=2 * z, sections=48)
    else:
        mesh = trimesh.convex.convex_hull(np.array(shape.vertices))
    mesh.vertices = quat_rotate(np.array(shape.quaternion), mesh.vertices) + shape.position
    return mesh


def _asset_mesh(doc: EsgDocument, asset: str, body: Body) -> trimesh.Trimesh | None:
    from esg.assets.geometry.mesh import closed_mesh
    from esg.outcomes import UserError

    config = doc.asset_configurations.get(asset)
    if config is None:
        return None
    try:
        mesh = closed_mesh(config)
    except (UserError, KeyError):
        return None
    mesh.vertices = mesh.vertices / 100.0 + np.array(body.origin_offset)
    return mesh


def _surface(mesh: trimesh.Trimesh) -> tuple[Floats, Floats]:
    """Points evenly drawn from the faces by area, and their normals."""
    rng = np.random.default_rng(0)
    area = np.asarray(mesh.area_faces, float)
    face = rng.choice(len(area), size=_CANDIDATES, p=area / area.sum())
    u = rng.random((_CANDIDATES, 2))
    over = u.sum(axis=1) > 1.0
    u[over] = 1.0 - u[over]
    corner = np.asarray(mesh.triangles, float)[face]
    points = corner[:, 0] + (u[:, :1] * (corner[:, 1] - corner[:, 0])
                             + u[:, 1:] * (corner[:, 2] - corner[:, 0]))  # fmt: skip
    return points, np.asarray(mesh.face_normals, float)[face]
