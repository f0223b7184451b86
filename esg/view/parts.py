"""The meshes of a scene as a renderer wants them: in body frames, coloured, on a ground."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color, Look
from esg.compile.visuals.decals import drawn_lifts, is_ground
from esg.engines.scene import Rollout, SimScene
from esg.graph.casting import effective
from esg.graph.models import EsgDocument
from esg.lexicon.places import places
from esg.units import CM_PER_M
from esg.view.pieces import Part, Turning

TILE_RAISE_M = 0.0002
"""Tiles lie so much above the plane: less than depth resolves, more than a ray's rounding."""
GROUND_RGB = {"indoor": (0.47, 0.41, 0.35), "outdoor": (0.36, 0.38, 0.36)}


def scene_parts(scene: SimScene, rollout: Rollout, doc: EsgDocument) -> list[Part]:
    """Meshes of all bodies in their frames [m], and of the ground with what is drawn on it.

    What stands around the action is not among them: `surroundings_of` has it, and leaves out what
    is in a camera's way.
    """
    from esg.view.surroundings import GROUND, surroundings_of, thing_of

    around = surroundings_of(doc, scene, rollout)
    low, high = _span(rollout)
    flat = [part for part in around.parts if thing_of(part) == GROUND]
    return [*body_parts(scene, doc), _plane(0.5 * (low + high), around.ground), *flat]


def body_parts(scene: SimScene, doc: EsgDocument) -> list[Part]:
    """Meshes of all bodies in their frames [m] but those in whose place the ground is seen."""
    from esg.assets import build_mesh

    hidden = ground_bodies(scene, doc)
    lifts = drawn_lifts(scene, {scene.bodies[i].name for i in hidden})
    doc = effective(doc)
    parts: list[Part] = []
    meshes: dict[str, Any] = {}
    turning = 0
    for index, body in enumerate(scene.bodies):
        first, turning = turning, turning + len(body.wheels)
        node = doc.spatial_relation_graph.nodes.get(body.name)
        if node is None:
            continue
        if index in hidden:
            continue
        if node.asset_id not in meshes:
            meshes[node.asset_id] = build_mesh(doc.asset_configurations[node.asset_id])
        mesh = meshes[node.asset_id]
        wheels = {w.name: Turning(first + k, w.axle) for k, w in enumerate(body.wheels)}
        offset = body.origin_offset + np.array([0.0, 0.0, lifts.get(index, 0.0)])
        parts += [
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
    return parts


def ground_bodies(scene: SimScene, doc: EsgDocument) -> frozenset[int]:
    """Indices of the bodies in whose place the ground is seen."""
    from esg.dressing.clearance import covered

    around = None if doc.dressing is None else places()[doc.dressing.place].setting
    return frozenset(
        index
        for index, body in enumerate(scene.bodies)
        if is_ground(body) or (around is not None and covered(body, indoor=around == "indoor"))
    )


def ground_color(scene: SimScene, doc: EsgDocument) -> Color:
    """Of the endless plane where nothing dresses it (sRGB)."""
    own = [b.color for b in scene.bodies if is_ground(b)]
    return own[-1] if own else GROUND_RGB[doc.scene_definition.scene_parameters.scene_type]


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


def _span(rollout: Rollout) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Between which points of the plane nearly all happens [m], each of shape [2]."""
    span = rollout.position[0, :, :, :2].reshape(-1, 2)
    span = span[np.isfinite(span).all(axis=1)]
    low, high = np.percentile(span, [2, 98], axis=0).astype(np.float64)
    return low, high


def _plane(middle: NDArray[np.float64], look: Look) -> Part:
    """The ground: a plane just below what is drawn at z = 0."""
    corner = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    flat = (corner - 0.5) * 900 + middle
    vertices = np.concatenate([flat, np.full((4, 1), -TILE_RAISE_M)], axis=1)
    normals = np.tile([0.0, 0.0, 1.0], (4, 1))
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    return Part(-1, vertices, faces, shown(look), None, look, normals, flat / look.tile_m, "ground")


def shown(look: Look) -> Color:
    """The colour (sRGB) that a surface has on average."""
    from esg.assets.textures import linear, recipes, srgb

    if look.texture is None:
        return look.color
    light = linear(look.color) * linear(recipes()[look.texture].mean)
    red, green, blue = (float(c) for c in srgb(light))
    return red, green, blue


def checkerboard(rollout: Rollout, color: Color) -> tuple[Part, ...]:
    """As a sense of scale every second one of faint tiles of 1 m (or 0.25 m), at z = 0."""
    low, high = _span(rollout)
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
    # The others are the plane just below: every ray searches every mesh of the ground, so that
    # another one for them would cost a fifth of a picture.
    lighter = cells[cells.sum(axis=1) % 2 == 0]
    corners = ((lighter[:, None, :] + corner) * tile).reshape(-1, 2)
    flat = np.concatenate([corners, np.zeros((len(corners), 1))], axis=1)
    square = np.array([[0, 1, 2], [0, 2, 3]])
    faces = (square[None] + 4 * np.arange(len(lighter))[:, None, None]).reshape(-1, 3)
    return (Part(-1, flat, faces, (red, green, blue), name="ground/tiles"),)
