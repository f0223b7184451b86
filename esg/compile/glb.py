"""Animated GLB of a replayed scene: every body's own mesh, moving as the engine moved it.

glTF is right-handed with Y up in metres: (x, y, z) of the simulation becomes (x, z, -y), and a
quaternion (x, y, z, w) becomes (x, z, -y, w). The mesh files are merged as they are, so materials
and textures survive; bodies with the same file share its buffers. The same input gives the same
bytes.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field
import json
from pathlib import Path
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.compile.assets import mesh_file
from esg.engines.breaking import hidden
from esg.engines.scene import Body, Rollout, Shape, SimScene
from esg.engines.wheels import about_axle, wheel_angles
from esg.strangers.gltf import BIN, JSON, MAGIC, MOST_BYTES, read_glb
from esg.units import quat_rotate

_FLOAT, _SCALAR, _VEC3, _VEC4 = 5126, "SCALAR", "VEC3", "VEC4"
_VERTICES, _INDICES = 34962, 34963
_MOVED = 1e-6
"""Smallest change [m, or of a quaternion] that counts as motion."""

_SHARED = ("meshes", "materials", "textures", "images", "samplers", "accessors", "bufferViews")

Floats = NDArray[np.float64]


def to_gltf_vector(v: Any) -> Floats:
    """Simulation frame to glTF, shape [..., 3]."""
    x, y, z = np.moveaxis(np.asarray(v, float), -1, 0)
    return np.stack([x, z, -y], axis=-1)


def to_gltf_quaternion(q: Any) -> Floats:
    """Orientation (x, y, z, w) in glTF's frame, shape [..., 4]."""
    x, y, z, w = np.moveaxis(np.asarray(q, float), -1, 0)
    return np.stack([x, z, -y, w], axis=-1)


def origin_poses(body: Body, position: Any, quaternion: Any) -> tuple[Floats, Floats]:
    """Poses of the mesh's origin for poses of the centre of mass, shapes [T, 3] and [T, 4]."""
    q = np.asarray(quaternion, float)
    q = q / np.linalg.norm(q, axis=-1, keepdims=True)
    offset = np.broadcast_to(np.asarray(body.origin_offset, float), (*q.shape[:-1], 3))
    return np.asarray(position, float) + quat_rotate(q, offset), q


@dataclass
class _Document:
    """A growing glTF document with one buffer."""

    data: dict[str, Any] = field(default_factory=dict)
    binary: bytearray = field(default_factory=bytearray)
    extensions: set[str] = field(default_factory=set)
    required: set[str] = field(default_factory=set)
    channels: list[dict[str, Any]] = field(default_factory=list)
    samplers: list[dict[str, Any]] = field(default_factory=list)
    clock: int = -1

    def append(self, key: str, item: Any) -> int:
        items = self.data.setdefault(key, [])
        items.append(item)
        return len(items) - 1

    def floats(self, values: Any, kind: str, *, limits: bool = False) -> int:
        """Adds an accessor of float32 values, shape [n] or [n, k]."""
        array = np.ascontiguousarray(values, np.float32)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": array.nbytes}
        self.binary += array.tobytes()
        accessor: dict[str, Any] = {
            "bufferView": self.append("bufferViews", view),
            "componentType": _FLOAT,
            "count": len(array),
            "type": kind,
        }
        if limits:
            flat = array.reshape(len(array), -1)
            accessor["min"] = [float(v) for v in flat.min(0)]
            accessor["max"] = [float(v) for v in flat.max(0)]
        return self.append("accessors", accessor)

    def merge(self, source: bytes) -> tuple[list[dict[str, Any]], list[int]]:
        """Takes over a GLB's meshes; returns its nodes with meshes renumbered, and its roots."""
        other, binary = read_glb(source)
        start = {key: len(self.data.get(key, [])) for key in _SHARED}
        base = len(self.binary)
        self.binary += binary + b"\0" * (-len(binary) % 4)
        for view in other.get("bufferViews", []):
            view["buffer"] = 0
            view["byteOffset"] = view.get("byteOffset", 0) + base
        for accessor in other.get("accessors", []):
            _shift(accessor, "bufferView", start["bufferViews"])
        for image in other.get("images", []):
            _shift(image, "bufferView", start["bufferViews"])
        for texture in other.get("textures", []):
            _shift(texture, "source", start["images"])
            _shift(texture, "sampler", start["samplers"])
        for material in other.get("materials", []):
            _shift_textures(material, start["textures"])
        for mesh in other.get("meshes", []):
            for primitive in mesh["primitives"]:
                _say_use(other, primitive["attributes"].values(), _VERTICES, start["bufferViews"])
                indices = [primitive["indices"]] if "indices" in primitive else []
                _say_use(other, indices, _INDICES, start["bufferViews"])
                for key, value in primitive["attributes"].items():
                    primitive["attributes"][key] = value + start["accessors"]
                _shift(primitive, "indices", start["accessors"])
                _shift(primitive, "material", start["materials"])
        for key in _SHARED:
            for item in other.get(key, []):
                self.append(key, item)
        self.extensions |= set(other.get("extensionsUsed", []))
        self.required |= set(other.get("extensionsRequired", []))
        nodes = other.get("nodes", [])
        for node in nodes:
            _shift(node, "mesh", start["meshes"])
            for key in ("camera", "skin"):
                node.pop(key, None)
        scene = other.get("scenes", [{}])[other.get("scene", 0)]
        return nodes, list(scene.get("nodes", range(len(nodes))))

    def place(self, nodes: list[dict[str, Any]], roots: list[int]) -> list[int]:
        """Adds one copy of a file's nodes; returns the indices of the copied roots."""
        if not nodes:
            return []
        base = len(self.data.setdefault("nodes", []))
        for node in nodes:
            copy = dict(node)
            if "children" in copy:
                copy["children"] = [c + base for c in copy["children"]]
            self.data["nodes"].append(copy)
        return [r + base for r in roots]

    def animate(self, node: int, path: str, values: Floats, time: Floats) -> None:
        """Moves a node: key frames of its translation or rotation; none if it keeps still.

        Args:
            node: Its index.
            path: translation, rotation or scale.
            values: At the frames, shape [T, 3] or [T, 4].
            time: Of the frames [s], shape [T].
        """
        if len(time) < 2 or np.abs(values - values[0]).max() < _MOVED:
            return
        if self.clock < 0:
            self.clock = self.floats(time, _SCALAR, limits=True)
        turns = path == "rotation"
        keys = self.floats(_unit32(values) if turns else values, _VEC4 if turns else _VEC3)
        sampler = {"input": self.clock, "output": keys, "interpolation": "LINEAR"}
        self.samplers.append(sampler)
        target = {"node": node, "path": path}
        self.channels.append({"sampler": len(self.samplers) - 1, "target": target})

    def show(self, node: int, there: NDArray[np.bool_], time: Floats) -> None:
        """Shows a node only in some frames, shape [T]: elsewhere its size is 0."""
        if there.all():
            return
        sizes = np.repeat(there.astype(float)[:, None], 3, axis=1)
        self.data["nodes"][node]["scale"] = sizes[0].tolist()
        self.animate(node, "scale", sizes, time)
        if len(time) > 1 and (there != there[0]).any():
            self.samplers[-1]["interpolation"] = "STEP"

    def glb(self) -> bytes:
        """The file; a scene without bodies has neither buffer nor binary chunk."""
        if self.binary:
            self.data["buffers"] = [{"byteLength": len(self.binary)}]
        if self.extensions:
            self.data["extensionsUsed"] = sorted(self.extensions)
        if self.required:
            self.data["extensionsRequired"] = sorted(self.required)
        text = json.dumps(self.data, separators=(",", ":"), ensure_ascii=True).encode()
        text += b" " * (-len(text) % 4)
        binary = bytes(self.binary) + b"\0" * (-len(self.binary) % 4)
        chunks = [struct.pack("<II", len(text), JSON), text]
        if binary:
            chunks += [struct.pack("<II", len(binary), BIN), binary]
        length = 12 + sum(map(len, chunks))
        return b"".join([struct.pack("<III", MAGIC, 2, length), *chunks])


def _say_use(document: dict[str, Any], accessors: Any, use: int, first_view: int) -> None:
    """Marks the buffer views behind accessors as vertex or index data, which uploads faster."""
    for index in accessors:
        view = document["accessors"][index].get("bufferView")
        if view is not None:
            document["bufferViews"][view - first_view].setdefault("target", use)


def _shift(item: dict[str, Any], key: str, by: int) -> None:
    if key in item:
        item[key] += by


def _shift_textures(value: Any, by: int) -> None:
    """Renumbers every `...Texture: {index}` below a material, extensions included."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if key.endswith("Texture") and isinstance(inner, dict):
                _shift(inner, "index", by)
            _shift_textures(inner, by)


def scene_glb(scene: SimScene, rollout: Rollout, folder: Path, *, world: int = 0) -> bytes:
    """The replayed scene as an animated GLB.

    Args:
        scene: Bodies, in the rollout's order.
        rollout: Poses; its frames become key frames.
        folder: Scene folder with the meshes; a body without a readable one shows its collision.
        world: World of the rollout.
    """
    document = _Document({"asset": {"version": "2.0", "generator": "esg-scenes"}, "scene": 0})
    roots: list[int] = []
    library: dict[str, tuple[list[dict[str, Any]], list[int]]] = {}
    document.data["nodes"] = []
    absent = hidden(scene, rollout.position[world], rollout.quaternion[world])
    for i, body in enumerate(scene.bodies):
        key, data = mesh_of(body, folder)
        if data is None:
            continue
        if key not in library:
            library[key] = document.merge(data)
        parts = len(document.data["nodes"])
        children = document.place(*library[key])
        poses = rollout.position[world, :, i], rollout.quaternion[world, :, i]
        at, turn = origin_poses(body, *poses)
        at, turn = to_gltf_vector(at), _continuous(to_gltf_quaternion(turn))
        node: dict[str, Any] = {
            "name": body.name,
            "translation": at[0].astype(np.float32).tolist(),
            "rotation": _unit32(turn[:1])[0].tolist(),
            "extras": {"label": body.label, "category": body.category, "mass_kg": body.mass},
        }
        if children:
            node["children"] = children
        index = document.append("nodes", node)
        roots.append(index)
        document.animate(index, "translation", at, rollout.time)
        document.animate(index, "rotation", turn, rollout.time)
        document.show(index, ~absent[:, i], rollout.time)
        angles = wheel_angles(body, rollout.time, *poses, scene.gravity)
        _turn_wheels(document, range(parts, index), body, angles, rollout.time)
    document.data["scenes"] = [{"name": scene.scene_id, "nodes": roots}]
    if document.channels:
        document.data["animations"] = [
            {"name": "replay", "channels": document.channels, "samplers": document.samplers}
        ]
    if not roots:
        del document.data["scenes"][0]["nodes"], document.data["nodes"]
    return document.glb()


def _turn_wheels(
    document: _Document, nodes: range, body: Body, angles: Floats, time: Floats
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
            document.animate(index, "rotation", _continuous(turn), time)


def _continuous(q: Floats) -> Floats:
    """Signs chosen so that neighbouring key frames interpolate the short way, shape [T, 4]."""
    flips = np.sign(np.einsum("ti,ti->t", q[1:], q[:-1]))
    flips[flips == 0] = 1
    return q * np.concatenate([[1.0], np.cumprod(flips)])[:, None]


def _unit32(q: Floats) -> NDArray[np.float32]:
    single = q.astype(np.float32)
    return single / np.linalg.norm(single, axis=-1, keepdims=True)


def mesh_of(body: Body, folder: Path) -> tuple[str, bytes | None]:
    """Key and GLB of a body's mesh; its collision shapes where the file is missing or broken."""
    path = mesh_file(folder, body.mesh)
    if path is not None and path.stat().st_size <= MOST_BYTES:
        data = path.read_bytes()
        try:
            read_glb(data)
        except ValueError:
            pass
        else:
            return body.mesh, data
    if not body.shapes:
        return "", None
    return f"shapes of {body.name}", _shapes_glb(body)


def _shapes_glb(body: Body) -> bytes:
    import trimesh
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    color = [round(255 * c) for c in body.color] + [255]
    scene = trimesh.Scene()
    for number, shape in enumerate(body.shapes):
        mesh = shape_mesh(shape, body)
        vertices = to_gltf_vector(mesh.vertices)
        solid = trimesh.Trimesh(vertices, mesh.faces, process=False)
        material = PBRMaterial(name="collision", baseColorFactor=color, metallicFactor=0.0)
        solid.visual = TextureVisuals(material=material)
        name = f"shape_{number}"
        scene.add_geometry(solid, node_name=name, geom_name=name)
    data = scene.export(file_type="glb")
    assert isinstance(data, bytes)
    return data


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
    import io

    import trimesh

    loaded: Any = trimesh.load(io.BytesIO(data), file_type="glb", force="scene")
    parents = loaded.graph.transforms.parents
    scene = trimesh.Scene()
    for name in loaded.graph.nodes_geometry:
        holder = parents.get(name, "")
        if holder in without or (holders and holder not in holders):
            continue
        transform, geometry = loaded.graph[name]
        if holders:
            transform = np.linalg.inv(loaded.graph[holder][0]) @ transform
        mesh = loaded.geometry[geometry]
        scene.add_geometry(mesh, node_name=name, geom_name=geometry, transform=transform)
    out = scene.export(file_type="glb")
    assert isinstance(out, bytes)
    return out


class GltfMeshes:
    """Triangles of a GLB, back in the simulation's frame.

    Args:
        data: A binary glTF 2 file.
    """

    def __init__(self, data: bytes) -> None:
        self._data = data

    def parts(self) -> list[tuple[Floats, NDArray[np.int64], tuple[float, ...]]]:
        """Vertices [m], faces and RGBA of every part, in the file's order."""
        return [(vertices, faces, color) for _, vertices, faces, color in self.held_parts()]

    def held_parts(self) -> list[tuple[str, Floats, NDArray[np.int64], tuple[float, ...]]]:
        """The name of the node that holds a part, its vertices [m], faces and RGBA."""
        import io

        import trimesh

        loaded: Any = trimesh.load(io.BytesIO(self._data), file_type="glb", force="scene")
        out: list[tuple[str, Floats, NDArray[np.int64], tuple[float, ...]]] = []
        for name in loaded.graph.nodes_geometry:
            transform, geometry = loaded.graph[name]
            mesh = loaded.geometry[geometry]
            points = np.asarray(mesh.vertices) @ transform[:3, :3].T + transform[:3, 3]
            x, y, z = points.T
            material = getattr(mesh.visual, "material", None)
            base = getattr(material, "baseColorFactor", None)
            color = (0.6, 0.6, 0.6, 1.0) if base is None else tuple(float(c) / 255 for c in base)
            vertices = np.stack([x, -z, y], axis=1)
            holder = str(loaded.graph.transforms.parents.get(name, ""))
            out.append((holder, vertices, np.asarray(mesh.faces), color))
        return out
