"""The meshes of a scene as a renderer wants them: in body frames, coloured, on a ground."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from esg.compile.visuals.decals import drawn_lifts, is_ground
from esg.engines.breaking import whole_of_fragments
from esg.engines.scene import FRAGMENT, Body, Rollout, SimScene
from esg.graph.casting import effective
from esg.graph.models import EsgDocument
from esg.lexicon.places import places
from esg.units import CM_PER_M
from esg.view.ground import plane, span
from esg.view.pieces import Part, Turning
from esg.view.seeing.geometries import Piece, fixed, mesh_parts
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
            parts += fixed(index, body, mesh, np.array(body.origin_offset), {})
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
        parts += fixed(index, body, mesh, offset, wheels)
    return parts


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
