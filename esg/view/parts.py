"""The meshes of a scene as a renderer wants them: in body frames, coloured, on a ground."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color, Look
from esg.engines.scene import FRAGMENT, Body, Rollout, SimScene
from esg.graph.casting import effective
from esg.graph.models import EsgDocument
from esg.units import CM_PER_M
from esg.view.render import Part, Turning

GROUND_HALF_EXTENT_M = 45.0
"""A surface without collision at least this wide is the ground."""
TILE_RAISE_M = 0.0002
"""Tiles lie so much above the plane: less than depth resolves, more than a ray's rounding."""
GROUND_RGB = {"indoor": (0.47, 0.41, 0.35), "outdoor": (0.36, 0.38, 0.36)}


def scene_parts(scene: SimScene, rollout: Rollout, doc: EsgDocument) -> list[Part]:
    """Meshes of all bodies in their frames [m], and the ground they move over."""
    from esg.assets import build_mesh

    doc = effective(doc)
    parts: list[Part] = []
    meshes: dict[str, Any] = {}
    turning = 0
    ground = GROUND_RGB[doc.scene_definition.scene_parameters.scene_type]
    decals: list[tuple[float, float, list[Part]]] = []
    for index, body in enumerate(scene.bodies):
        first, turning = turning, turning + len(body.wheels)
        node = doc.spatial_relation_graph.nodes.get(body.name)
        if body.category == FRAGMENT:
            parts += _fragment(index, body)
        if node is None:
            continue
        flat = not body.collides
        if flat and max(body.half_extents[:2]) > GROUND_HALF_EXTENT_M:
            # The ground itself: drawn as an endless plane in its colour.
            ground = body.color
            continue
        if node.asset_id not in meshes:
            meshes[node.asset_id] = build_mesh(doc.asset_configurations[node.asset_id])
        mesh = meshes[node.asset_id]
        wheels = {w.name: Turning(first + k, w.axle) for k, w in enumerate(body.wheels)}
        offset = np.asarray(body.origin_offset)
        own = [
            Part(
                index,
                p.vertices / CM_PER_M + offset,
                p.faces,
                p.color,
                wheels.get(p.holder),
                p.look,
                p.normals,
                p.uvs,
                p.name,
            )
            for p in mesh_parts(mesh, body.color)
        ]
        if flat:
            area, thickness = body.half_extents[0] * body.half_extents[1], 2 * body.half_extents[2]
            decals.append((area, thickness, own))
        else:
            parts += own
    # Roads and markings lie on the ground, the smaller on the larger: a few millimetres apart.
    # Their thickness goes into the ground, or what stands at z = 0 would be sunk in them.
    for layer, (_, thickness, own) in enumerate(sorted(decals, key=lambda d: -d[0]), 1):
        lift = np.array([0.0, 0.0, 0.004 * layer - thickness])
        parts += [replace(p, vertices=p.vertices + lift) for p in own]
    return parts + _ground(rollout, ground)


def _fragment(index: int, body: Body) -> list[Part]:
    """A fragment as what collides: convex, in the colour of what broke."""
    from esg.engines.shapes import hull

    out: list[Part] = []
    for shape in body.shapes:
        vertices, faces = hull(np.array(shape.vertices))
        # Every face has corners of its own, so that its edges are sharp.
        flat = vertices[faces.reshape(-1)] + np.asarray(shape.position)
        out.append(Part(index, flat, np.arange(len(flat)).reshape(-1, 3), body.color))
    return out


@dataclass(frozen=True)
class Piece:
    """One geometry of an asset.

    Args:
        name: What it is.
        holder: Name of the node that holds it: that of its wheel, else the root.
        vertices: In the asset's frame [cm], shape [n, 3].
        faces: Vertex indices, shape [m, 3].
        color: sRGB in [0, 1], of the surface on average.
        look: Its surface, if a builder painted it.
        normals: At the vertices, shape [n, 3].
        uvs: At the vertices in tiles, shape [n, 2].
    """

    name: str
    holder: str
    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    color: Color
    look: Look | None
    normals: NDArray[np.float64] | None
    uvs: NDArray[np.float64] | None


def mesh_parts(mesh: Any, fallback: Color) -> list[Piece]:
    """Every geometry of an asset's scene, in the asset's frame."""
    out: list[Piece] = []
    parents = mesh.graph.transforms.parents
    for name in sorted(mesh.graph.nodes_geometry):
        transform, geometry_name = mesh.graph[name]
        geometry = mesh.geometry[geometry_name]
        if not len(getattr(geometry, "faces", ())):
            continue
        turn = transform[:3, :3]
        vertices = np.asarray(geometry.vertices, float) @ turn.T + transform[:3, 3]
        look = geometry.metadata.get("look")
        normals = uvs = None
        if look is not None:
            normals = np.asarray(geometry.vertex_normals, float) @ turn.T
            uvs = getattr(geometry.visual, "uv", None)
        color = geometry.metadata.get("color") or _color(geometry, fallback)
        faces = np.asarray(geometry.faces)
        out.append(Piece(name, parents.get(name, ""), vertices, faces, color, look, normals, uvs))
    return out


def _color(geometry: Any, fallback: Color) -> Color:
    visual = getattr(geometry, "visual", None)
    material = getattr(visual, "material", None)
    rgba = getattr(material, "main_color", None) if material is not None else None
    if rgba is None and visual is not None and getattr(visual, "defined", False):
        rgba = getattr(visual, "main_color", None)
    if rgba is None:
        return fallback
    red, green, blue = (float(c) / 255.0 for c in np.asarray(rgba)[:3])
    return red, green, blue


def _ground(rollout: Rollout, color: tuple[float, float, float]) -> list[Part]:
    """A plane and, as a sense of scale, a faint checkerboard of 1 m (or 0.25 m) tiles."""
    span = rollout.position[0, :, :, :2].reshape(-1, 2)
    span = span[np.isfinite(span).all(axis=1)]
    low, high = np.percentile(span, 2, axis=0), np.percentile(span, 98, axis=0)
    extent = float(np.max(high - low))
    tile = 0.25 if extent < 3 else 1.0
    margin = 14 * tile + 0.25 * extent
    start = np.floor((low - margin) / tile).astype(int)
    stop = np.ceil((high + margin) / tile).astype(int)
    if int(np.max(stop - start)) > 240:  # a runaway body: tiles around the origin only
        start, stop = np.array([-120, -120]), np.array([120, 120])
    corner = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    i, j = np.meshgrid(np.arange(start[0], stop[0]), np.arange(start[1], stop[1]), indexing="ij")
    cells = np.stack([i.ravel(), j.ravel()], axis=1)
    red, green, blue = (min(1.0, 1.1 * c) for c in color)
    # Every second tile, exactly at z = 0. The others are the plane just below: every ray searches
    # every mesh of the ground, so that another one for them would cost a fifth of a picture.
    lighter = cells[cells.sum(axis=1) % 2 == 0]
    corners = ((lighter[:, None, :] + corner) * tile).reshape(-1, 2)
    flat = np.concatenate([corners, np.zeros((len(corners), 1))], axis=1)
    square = np.array([[0, 1, 2], [0, 2, 3]])
    faces = (square[None] + 4 * np.arange(len(lighter))[:, None, None]).reshape(-1, 3)
    middle = 0.5 * (low + high)
    big = np.concatenate([(corner - 0.5) * 900 + middle, np.full((4, 1), -TILE_RAISE_M)], axis=1)
    return [Part(-1, big, square, color), Part(-1, flat, faces, (red, green, blue))]
