"""Animated GLB of a replayed scene: every body's own mesh, moving as the engine moved it.

glTF is right-handed with Y up in metres: (x, y, z) of the simulation becomes (x, z, -y), and a
quaternion (x, y, z, w) becomes (x, z, -y, w). The mesh files are merged as they are, so materials
and textures survive; bodies with the same file share its buffers, and pictures, textures and
materials that several files hold stand in it once. The same input gives the same bytes.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.gltf.asset import gltf_vector
from esg.assets.gltf.document import Document, unit
from esg.assets.gltf.fragments import largest, skinned, tile_of
from esg.assets.gltf.parts import MeshPart, node_matrices, parts_of
from esg.assets.gltf.surfaces import Surface, surface_of
from esg.assets.textures import linear
from esg.compile.assets import mesh_file
from esg.compile.visuals.decals import drawn_lifts
from esg.compile.visuals.ropes import LOOKS, Rope, rope_mesh, ropes_of
from esg.compile.visuals.setting import (
    Setting,
    View,
    by_surface,
    by_thing,
    by_track,
    facing,
    ground_mesh,
    seen_at,
    strength,
)
from esg.engines.breaking import hidden, whole_of_fragments
from esg.engines.scene import Body, Rollout, Shape, SimScene
from esg.engines.wheels import about_axle, wheel_angles
from esg.strangers.gltf import MOST_BYTES, read_glb
from esg.units import quat_multiply, quat_rotate

if TYPE_CHECKING:
    from esg.view.pieces import Part

Floats = NDArray[np.float64]

LIGHTS = "KHR_lights_punctual"


def to_gltf_quaternion(q: Any) -> Floats:
    """Orientation (x, y, z, w) in glTF's frame, shape [..., 4]."""
    x, y, z, w = np.moveaxis(np.asarray(q, float), -1, 0)
    return np.stack([x, z, -y, w], axis=-1)


def to_gltf_looking(q: Any) -> Floats:
    """Orientation in glTF's frame of what keeps its own axes (cameras, lights), shape [..., 4]."""
    return quat_multiply((-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)), q)


def origin_poses(body: Body, position: Any, quaternion: Any) -> tuple[Floats, Floats]:
    """Poses of the mesh's origin for poses of the centre of mass, shapes [T, 3] and [T, 4]."""
    q = np.asarray(quaternion, float)
    q = q / np.linalg.norm(q, axis=-1, keepdims=True)
    offset = np.broadcast_to(np.asarray(body.origin_offset, float), (*q.shape[:-1], 3))
    return np.asarray(position, float) + quat_rotate(q, offset), q


def scene_glb(
    scene: SimScene,
    rollout: Rollout,
    folder: Path,
    *,
    setting: Setting | None = None,
    world: int = 0,
    manifest: Mapping[str, Any] | None = None,
) -> bytes:
    """The replayed scene as an animated GLB.

    Args:
        scene: Bodies, in the rollout's order.
        rollout: Poses; its frames become key frames.
        folder: Scene folder with the meshes; a body without a readable one shows its collision.
        setting: Ground, dressing, light and cameras; None: the bodies alone.
        world: World of the rollout.
        manifest: The physical scene as JSON, for the scene's `extras`: what a judge cannot see in
            meshes (docs/judging.md). None: it is left out.
    """
    document = Document({"asset": {"version": "2.0", "generator": "esg-scenes"}, "scene": 0})
    library: dict[str, tuple[list[dict[str, Any]], list[int]]] = {}
    document.data["nodes"] = []
    lifts = {} if setting is None else drawn_lifts(scene, setting.covered)
    roots: list[int] = []
    wholes = whole_of_fragments(scene)
    absent = hidden(scene, rollout.position[world], rollout.quaternion[world])
    for i, body in enumerate(scene.bodies):
        if setting is not None and body.name in setting.covered:
            continue
        key, data = mesh_of(body, folder, wholes.get(body.name))
        if data is None:
            continue
        redrawn = setting is not None and body.name in setting.redrawn
        if key not in library and not redrawn:
            library[key] = document.merge(data)
        poses = rollout.position[world, :, i], rollout.quaternion[world, :, i]
        mesh = ([], []) if redrawn else library[key]
        roots.append(_body(document, body, mesh, poses, rollout.time, scene, lifts.get(i)))
        _shows(document, roots[-1], i, setting, rollout.time)
        document.show(roots[-1], ~absent[:, i], rollout.time)
    for rope in ropes_of(scene, rollout.position[world], rollout.quaternion[world]):
        roots.append(_rope(document, rope, rollout.time))
    if setting is not None:
        roots += _surroundings(document, setting)
        roots += _shows(document, None, -1, setting, rollout.time)
        roots += [_view(document, view, rollout.time) for view in setting.views]
    told = {} if manifest is None else {"extras": {"manifest": manifest}}
    document.data["scenes"] = [{"name": scene.scene_id, "nodes": roots, **told}]
    if document.channels:
        document.data["animations"] = [
            {"name": "replay", "channels": document.channels, "samplers": document.samplers}
        ]
    if not roots:
        del document.data["scenes"][0]["nodes"], document.data["nodes"]
    return document.glb()


def _body(
    document: Document,
    body: Body,
    mesh: tuple[list[dict[str, Any]], list[int]],
    poses: tuple[Any, Any],
    time: Floats,
    scene: SimScene,
    lift: float | None,
) -> int:
    """Adds a body that moves through poses of its centre of mass; returns its node."""
    first = len(document.data["nodes"])
    children = document.place(*mesh)
    at, turn = origin_poses(body, *poses)
    if lift is not None:
        at = at + np.array([0.0, 0.0, lift])
    at, turn = gltf_vector(at), continuous(to_gltf_quaternion(turn))
    node: dict[str, Any] = {
        "name": body.name,
        "translation": at[0].astype(np.float32).tolist(),
        "rotation": unit(turn[0]),
        "extras": {"label": body.label, "category": body.category, "mass_kg": body.mass},
    }
    if children:
        node["children"] = children
    index = document.append("nodes", node)
    document.animate(index, "translation", at, time)
    document.animate(index, "rotation", turn, time)
    angles = wheel_angles(body, time, *poses, scene.gravity)
    _turn_wheels(document, range(first, index), body, angles, time)
    return index


def _shows(
    document: Document, holder: int | None, body: int, setting: Setting | None, time: Floats
) -> list[int]:
    """Adds what moves by the time alone, below the node of its body; returns the new nodes."""
    made: list[int] = []
    for alike in () if setting is None else by_track(setting.shows):
        part = alike[0]
        if part.body != body or part.act is None:
            continue
        at, turn = part.act.local(time)
        at, turn = gltf_vector(at), continuous(to_gltf_quaternion(turn))
        node = {
            "name": part.name or "part",
            "mesh": _dressing(document, part.name or "part", [*alike]),
            "translation": at[0].astype(np.float32).tolist(),
            "rotation": unit(turn[0]),
        }
        index = document.append("nodes", node)
        document.animate(index, "translation", at, time)
        document.animate(index, "rotation", turn, time)
        document.show(index, part.act.seen(time), time)
        made.append(index)
    if holder is not None and made:
        own = document.data["nodes"][holder]
        own["children"] = [*own.get("children", ()), *made]
    return made


def _turn_wheels(
    document: Document, nodes: range, body: Body, angles: Floats, time: Floats
) -> None:
    """Turns the nodes of a body's wheels, among `nodes`, by angles [rad], shape [T, wheels]."""
    for wheel, angle in zip(body.wheels, angles.T, strict=True):
        for index in nodes:
            node = document.data["nodes"][index]
            if node.get("name") != wheel.name:
                continue
            # A node that is animated states its place as a translation, not as a matrix.
            matrix = node.pop("matrix", None)
            if matrix is not None:
                node["translation"] = matrix[12:15]
            turn = to_gltf_quaternion(about_axle(angle))
            document.animate(index, "rotation", continuous(turn), time)


def _rope(document: Document, rope: Rope, time: Floats) -> int:
    """Adds a rope or spring; returns its node."""
    vertices, faces, normals = rope_mesh(rope.kind)
    corners = gltf_vector(vertices), faces, gltf_vector(normals), None
    sign = "ropes", rope.kind
    if sign not in document.known:
        material = document.material(surface_of(LOOKS[rope.kind]))
        document.known[sign] = document.mesh(rope.kind, [(corners, material)])
    at = gltf_vector(rope.position)
    turn = continuous(to_gltf_quaternion(rope.quaternion))
    across = np.where(rope.length > 0.0, rope.radius, 0.0)
    scale = np.stack([across, rope.length, across], axis=1)
    node = {
        "name": rope.name,
        "mesh": document.known[sign],
        "translation": at[0].astype(np.float32).tolist(),
        "rotation": unit(turn[0]),
        "scale": scale[0].astype(np.float32).tolist(),
        "extras": {"joint": rope.kind},
    }
    index = document.append("nodes", node)
    document.animate(index, "translation", at, time)
    document.animate(index, "rotation", turn, time)
    document.animate(index, "scale", scale, time)
    return index


def _surroundings(document: Document, setting: Setting) -> list[int]:
    """Adds ground, dressing and sun; returns their nodes."""
    vertices, faces, normals, uvs = ground_mesh(setting)
    ground = surface_of(setting.ground)
    corners = (
        gltf_vector(vertices), faces, gltf_vector(normals),
        uvs if ground.base is not None else None,
    )  # fmt: skip
    mesh = document.mesh("ground", [(corners, document.material(ground))])
    nodes = [document.append("nodes", {"name": "ground", "mesh": mesh})]
    dressing = [
        document.append("nodes", {"name": name, "mesh": _dressing(document, name, parts)})
        for name, parts in by_thing(setting.parts).items()
    ]
    if dressing:
        nodes.append(document.append("nodes", {"name": "dressing", "children": dressing}))
    most, color = strength(setting.sky.sun_rgb)
    # White paper that faces a light of pi lux reflects one unit of luminance.
    light = {
        "type": "directional",
        "name": "sun",
        "color": [round(c, 6) for c in color],
        "intensity": round(math.pi * most, 6),
    }
    document.extensions.add(LIGHTS)
    document.data["extensions"] = {LIGHTS: {"lights": [light]}}
    turn = unit(to_gltf_looking(facing(setting.sky.sun)))
    sun = {"name": "sun", "rotation": turn, "extensions": {LIGHTS: {"light": 0}}}
    return [*nodes, document.append("nodes", sun)]


def _dressing(document: Document, name: str, parts: list[Part]) -> int:
    """Adds parts that are fixed to the world as one mesh; returns its index."""
    primitives: list[Any] = []
    for surface, (vertices, faces, normals, uvs) in by_surface(parts):
        turned = None if normals is None else gltf_vector(normals)
        corners = gltf_vector(vertices), faces, turned, uvs
        primitives.append((corners, document.material(surface)))
    return document.mesh(name, primitives)


def _view(document: Document, view: View, time: Floats) -> int:
    """Adds a camera; returns its node."""
    lens = {"yfov": view.fov, "aspectRatio": view.aspect, "znear": view.near}
    camera = {"type": "perspective", "name": view.name, "perspective": lens}
    at, turn = seen_at(view, time)
    at, turn = gltf_vector(at), continuous(to_gltf_looking(turn))
    node = {
        "name": view.name,
        "camera": document.append("cameras", camera),
        "translation": at[0].astype(np.float32).tolist(),
        "rotation": unit(turn[0]),
    }
    index = document.append("nodes", node)
    document.animate(index, "translation", at, time)
    document.animate(index, "rotation", turn, time)
    return index


def continuous(q: Floats) -> Floats:
    """Signs chosen so that neighbouring key frames interpolate the short way, shape [T, 4]."""
    flips = np.sign(np.einsum("ti,ti->t", q[1:], q[:-1]))
    flips[flips == 0] = 1
    return q * np.concatenate([[1.0], np.cumprod(flips)])[:, None]


def mesh_of(body: Body, folder: Path, whole: Body | None = None) -> tuple[str, bytes | None]:
    """Key and GLB of a body's mesh; its collision shapes where the file is missing or broken.

    Args:
        body: Whose mesh it is.
        folder: The scene folder.
        whole: What a fragment is of, whose surface it shows.
    """
    path = mesh_file(folder, body.mesh, body.name)
    if path is not None and path.stat().st_size <= MOST_BYTES:
        data = path.read_bytes()
        try:
            read_glb(data)
        except ValueError:
            pass
        else:
            return path.relative_to(folder).as_posix(), data
    if not body.shapes:
        return "", None
    broke = None if whole is None else mesh_of(whole, folder)[1]
    seen = parts_of(broke) if broke is not None else []
    return f"shapes of {body.name}", _shapes_glb(body, seen[largest(seen)] if seen else None)


def _shapes_glb(body: Body, seen: MeshPart | None) -> bytes:
    """Collision shapes, in the body's colour or with the surface of another mesh."""
    document = Document({"asset": {"version": "2.0", "generator": "esg-scenes"}, "scene": 0})
    red, green, blue = (float(c) for c in linear(body.color))
    plain = Surface("collision", (red, green, blue), roughness=0.8)
    material = document.material(plain if seen is None else seen.surface)
    for number, shape in enumerate(body.shapes):
        mesh = shape_mesh(shape, body)
        corners = gltf_vector(mesh.vertices), np.asarray(mesh.faces), None, None
        if seen is not None:
            skin = skinned(mesh, tile_of(seen))
            corners = gltf_vector(skin.vertices), skin.faces, gltf_vector(skin.normals), skin.uvs
        name = f"shape_{number}"
        index = document.mesh(name, [(corners, material)])
        document.append("nodes", {"name": name, "mesh": index})
    document.data["scenes"] = [{"nodes": list(range(len(body.shapes)))}]
    return document.glb()


def shape_mesh(shape: Shape, body: Body) -> Any:
    """Triangles of a collision shape in the frame of the body's mesh [m] (a trimesh.Trimesh)."""
    import trimesh

    x, y, z = shape.size
    if shape.kind == "sphere":
        mesh = trimesh.creation.icosphere(subdivisions=3, radius=x)
    elif shape.kind == "box":
        mesh = trimesh.creation.box(extents=(2 * x, 2 * y, 2 * z))
    elif shape.kind == "capsule":
        mesh = trimesh.creation.capsule(height=2 * z, radius=x)
        mesh.apply_translation([0.0, 0.0, -mesh.bounds.mean(0)[2]])
    elif shape.kind == "cylinder":
        mesh = trimesh.creation.cylinder(radius=x, height=2 * z, sections=32)
    else:
        mesh = trimesh.Trimesh(np.array(shape.vertices)).convex_hull
    at = np.array(shape.position) - np.array(body.origin_offset)
    mesh.vertices = quat_rotate(shape.quaternion, mesh.vertices) + at
    return mesh


def part_of(data: bytes, *, holders: Collection[str] = (), without: Collection[str] = ()) -> bytes:
    """A GLB of some parts of another: those in the nodes `holders`, or all but those in `without`.

    What one node holds comes in that node's frame.
    """
    document = Document({"asset": {"version": "2.0", "generator": "esg-scenes"}, "scene": 0})
    frames = node_matrices(data)
    nodes: list[int] = []
    for part in parts_of(data):
        if part.holder in without or (holders and part.holder not in holders):
            continue
        vertices = gltf_vector(part.vertices)
        normals = None if part.normals is None else gltf_vector(part.normals)
        if holders:
            back = np.linalg.inv(frames[part.holder])
            vertices = vertices @ back[:3, :3].T + back[:3, 3]
            normals = None if normals is None else normals @ back[:3, :3].T
        corners = vertices, part.faces, normals, part.uvs
        mesh = document.mesh(part.name, [(corners, document.material(part.surface))])
        nodes.append(document.append("nodes", {"name": part.name, "mesh": mesh}))
    document.data["scenes"] = [{"nodes": nodes}]
    return document.glb()
