"""The meshes of a scene as a renderer wants them: in body frames, coloured, on a ground."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color, Look
from esg.compile.visuals.decals import drawn_lifts, is_ground
from esg.engines.breaking import whole_of_fragments
from esg.engines.scene import FRAGMENT, Body, Rollout, SimScene
from esg.graph.casting import effective
from esg.graph.models import EsgDocument
from esg.lexicon.places import places
from esg.units import CM_PER_M
from esg.view.ground import plane, span
from esg.view.pieces import Part, Turning
from esg.view.seeing.limbs import with_limbs
from esg.view.seeing.shows import with_shows
from esg.view.surroundings import GROUND, Surroundings, surroundings_of, thing_of


def scene_parts(scene: SimScene, rollout: Rollout, doc: EsgDocument) -> list[Part]:
    """Meshes of all bodies in their frames [m], and of the ground with what is drawn on it.

    What stands around the action is not among them: `surroundings_of` has it, and leaves out what
    is in a camera's way.
    """
    around = surroundings_of(doc, scene, rollout)
    bodies = with_limbs(body_parts(scene, doc), scene, rollout, doc)
    bodies = with_shows(bodies, scene, rollout, doc)
    return [*bodies, *ground_parts(rollout, around)]


def ground_parts(rollout: Rollout, around: Surroundings) -> list[Part]:
    """The ground as a plane, and what is drawn on it."""
    low, high = span(rollout)
    flat = [part for part in around.parts if thing_of(part) == GROUND]
    return [plane(0.5 * (low + high), around.ground), *flat]


def body_parts(scene: SimScene, doc: EsgDocument) -> list[Part]:
    """Meshes of all bodies in their frames [m] but those in whose place the ground is seen."""
    from esg.assets import build_mesh
    from esg.assets.appearances import appearances
    from esg.assets.postures import config_of, taken

    hidden = ground_bodies(scene, doc)
    lifts = drawn_lifts(scene, {scene.bodies[i].name for i in hidden})
    doc = effective(doc)
    parts: list[Part] = []
    looks = appearances(doc)
    postures = {h.name: h for own in taken(doc).values() for h in own}
    meshes: dict[Any, Any] = {}

    def mesh_of(name: str) -> Any:
        asset = doc.spatial_relation_graph.nodes[name].asset_id
        key = (asset, looks[name])
        if key not in meshes:
            meshes[key] = build_mesh(doc.asset_configurations[asset], looks[name])
        return meshes[key]

    turning = 0
    for index, body in enumerate(scene.bodies):
        first, turning = turning, turning + len(body.wheels)
        node = doc.spatial_relation_graph.nodes.get(body.name)
        if body.name in postures:
            h = postures[body.name]
            mesh = build_mesh(config_of(doc, h.node), h.drawn(looks[h.node]))
            parts += _fixed(index, body, mesh, np.array(body.origin_offset), {})
        elif body.category == FRAGMENT:
            whole = whole_of_fragments(scene)[body.name]
            parts += _fragment(index, body, mesh_parts(mesh_of(whole.name), whole.color))
        if node is None:
            continue
        if index in hidden:
            continue
        mesh = mesh_of(body.name)
        wheels = {w.name: Turning(first + k, w.axle) for k, w in enumerate(body.wheels)}
        offset = body.origin_offset + np.array([0.0, 0.0, lifts.get(index, 0.0)])
        parts += _fixed(index, body, mesh, offset, wheels)
    return parts


def _fixed(
    index: int, body: Body, mesh: Any, offset: NDArray[np.float64], wheels: dict[str, Turning]
) -> list[Part]:
    """The parts of a mesh on a body, its origin at `offset` [m]."""
    return [
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


def ground_bodies(scene: SimScene, doc: EsgDocument) -> frozenset[int]:
    """Indices of the bodies in whose place the ground is seen."""
    from esg.dressing.clearance import covered

    told = doc.dressing
    indoor = told is not None and places()[told.place].setting == "indoor"
    return frozenset(
        index
        for index, body in enumerate(scene.bodies)
        if is_ground(body)
        or (told is not None and covered(body, indoor=indoor, ground=told.ground))
    )


def _fragment(index: int, body: Body, whole: Sequence[Piece]) -> list[Part]:
    """A fragment as what collides: convex, of the surface that most of what broke shows."""
    import trimesh

    from esg.assets.gltf.fragments import largest, skinned, tile_of
    from esg.engines.shapes import hull

    seen = whole[largest(whole)]
    out: list[Part] = []
    for shape in body.shapes:
        vertices, faces = hull(np.array(shape.vertices))
        skin = skinned(trimesh.Trimesh(vertices, faces, process=False), tile_of(seen) / CM_PER_M)
        at = skin.vertices + np.asarray(shape.position)
        out.append(Part(index, at, skin.faces, seen.color, None, seen.look, skin.normals, skin.uvs))
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
