"""The GLB of a built asset: a node and a mesh a part, wheels in nodes that can turn."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.gltf.document import Corners, Document
from esg.assets.gltf.surfaces import surface_of
from esg.units import CM_PER_M

Floats = NDArray[np.float64]


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
