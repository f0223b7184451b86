"""The GLB of a built asset: a node and a mesh a part, wheels in nodes that can turn."""

from __future__ import annotations

from collections.abc import Sequence
import hashlib
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from esg.assets.gltf.document import Corners, Document, Encoded, Item, encode
from esg.assets.gltf.surfaces import surface_of
from esg.assets.looks import Color, Look
from esg.graph.models import Wheel
from esg.machine.recent import Recent
from esg.units import CM_PER_M

Floats = NDArray[np.float64]

_KEPT_BYTES = 16 * 2**20
"""Of meshes as files hold them: scenes of a dataset differ in colours and share most meshes."""
_kept: Recent[bytes, Encoded] = Recent(_KEPT_BYTES, lambda encoded: encoded.n_bytes)


def asset_glb(scene: Any) -> bytes:
    """Binary glTF (metres, Y up) of a scene that was built; the same scene gives the same bytes.

    Args:
        scene: A `trimesh.Scene` in the asset's frame [cm], every geometry with its `look` and
            `color` in `metadata`. Nodes without a geometry hold wheels: what is in them turns
            about them.
    """
    document = Document({"asset": {"version": "2.0", "generator": "esg-scenes"}, "scene": 0})
    graph = scene.graph
    wheels: dict[str, int] = {}
    roots: list[int] = []
    for name in graph.nodes_geometry:
        transform, geometry = graph[name]
        holder = graph.transforms.parents.get(name, graph.base_frame)
        if holder != graph.base_frame:
            if holder not in wheels:
                axle = gltf_vector(graph[holder][0][:3, 3] / CM_PER_M)
                node = {"name": holder, "translation": axle.tolist(), "children": []}
                wheels[holder] = document.append("nodes", node)
                roots.append(wheels[holder])
            transform = np.linalg.inv(graph[holder][0]) @ transform
        mesh = scene.geometry[geometry]
        look, color = mesh.metadata["look"], mesh.metadata["color"]
        material = document.material(surface_of(look, color))
        corners = _corners(mesh, transform, textured=look.texture is not None)
        number = document.append(
            "nodes", {"name": name, "mesh": document.mesh(name, [(corners, material)])}
        )
        if holder == graph.base_frame:
            roots.append(number)
        else:
            document.data["nodes"][wheels[holder]]["children"].append(number)
    document.data["scenes"] = [{"nodes": roots}]
    return document.glb()


class Drawn(Protocol):
    """What is of one look and turns together (`esg.assets.geometry.mesh.Model`)."""

    @property
    def name(self) -> str: ...
    @property
    def look(self) -> Look: ...
    @property
    def color(self) -> Color: ...
    @property
    def wheel(self) -> int | None: ...
    @property
    def surface(self) -> tuple[Floats, NDArray[np.int64], Floats, Floats]: ...
    @property
    def key(self) -> bytes: ...


def models_glb(models: Sequence[Drawn], wheels: Sequence[Wheel]) -> bytes:
    """As `asset_glb`, of models by themselves: none is drawn whose mesh is kept as files hold it.

    Args:
        models: Of an asset [cm], those of a wheel about its axle.
        wheels: Of the asset.
    """
    document = Document({"asset": {"version": "2.0", "generator": "esg-scenes"}, "scene": 0})
    holders: dict[int, Item] = {}
    roots: list[int] = []
    for model in models:
        if model.wheel is not None and model.wheel not in holders:
            wheel = wheels[model.wheel]
            axle = gltf_vector(np.asarray(wheel.axle_cm, float) / CM_PER_M)
            node: Item = {"name": wheel.name, "translation": axle.tolist(), "children": []}
            holders[model.wheel] = node
            roots.append(document.append("nodes", node))
        material = document.material(surface_of(model.look, model.color))
        encoded = _encoded(model, document.bumpy(material))
        mesh = document.encoded(model.name, [(encoded, material)])
        number = document.append("nodes", {"name": model.name, "mesh": mesh})
        (roots if model.wheel is None else holders[model.wheel]["children"]).append(number)
    document.data["scenes"] = [{"nodes": roots}]
    return document.glb()


def _encoded(model: Drawn, bumpy: bool) -> Encoded:
    """A model's mesh in glTF's frame [m], as a file holds it."""
    textured = model.look.texture is not None
    key = hashlib.blake2b(model.key + repr((textured, bumpy)).encode(), digest_size=16).digest()

    def encoded() -> Encoded:
        vertices, faces, normals, uvs = model.surface
        vertices = gltf_vector((vertices + 0.0) / CM_PER_M)  # nothing is at -0
        return encode(
            vertices, faces, gltf_vector(normals + 0.0), uvs if textured else None, bumpy=bumpy
        )

    return _kept.get(key, encoded)


def gltf_vector(v: Any) -> Floats:
    """A vector in glTF's frame, Y up, shape [..., 3]."""
    x, y, z = np.moveaxis(np.asarray(v, float), -1, 0)
    return np.stack([x, z, -y], axis=-1)


def _corners(mesh: Any, transform: Floats, *, textured: bool) -> Corners:
    """A geometry in its holder's frame of a glTF file [m]."""
    turn, at = transform[:3, :3], transform[:3, 3]
    vertices = gltf_vector((np.asarray(mesh.vertices, float) @ turn.T + at) / CM_PER_M)
    normals = gltf_vector(np.asarray(mesh.vertex_normals, float) @ turn.T)
    uvs = getattr(mesh.visual, "uv", None) if textured else None
    return vertices, np.asarray(mesh.faces), normals, uvs
