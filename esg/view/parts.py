"""The meshes of a scene as a renderer wants them: in body frames, coloured, on a ground."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color, Look
from esg.engines.scene import Rollout, SimScene
from esg.graph.casting import effective
from esg.graph.models import EsgDocument
from esg.lexicon.places import places
from esg.units import CM_PER_M
from esg.view.ground import is_ground, plane, span
from esg.view.render import Part, Turning


def scene_parts(scene: SimScene, rollout: Rollout, doc: EsgDocument) -> list[Part]:
    """Meshes of all bodies in their frames [m], and of the ground with what is drawn on it.

    What stands around the action is not among them: `surroundings_of` has it, and leaves out what
    is in a camera's way.
    """
    from esg.view.surroundings import GROUND, surroundings_of, thing_of

    around = surroundings_of(doc, scene, rollout)
    low, high = span(rollout)
    flat = [part for part in around.parts if thing_of(part) == GROUND]
    return [*body_parts(scene, doc), plane(0.5 * (low + high), around.ground), *flat]


def body_parts(scene: SimScene, doc: EsgDocument) -> list[Part]:
    """Meshes of all bodies in their frames [m] but those in whose place the ground is seen."""
    from esg.assets import build_mesh
    from esg.dressing.clearance import covered

    doc = effective(doc)
    around = None if doc.dressing is None else places()[doc.dressing.place].setting
    parts: list[Part] = []
    meshes: dict[str, Any] = {}
    turning = 0
    decals: list[tuple[float, float, list[Part]]] = []
    for index, body in enumerate(scene.bodies):
        first, turning = turning, turning + len(body.wheels)
        node = doc.spatial_relation_graph.nodes.get(body.name)
        if node is None:
            continue
        flat = not body.collides
        if is_ground(body) or (around is not None and covered(body, indoor=around == "indoor")):
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
    return parts


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
