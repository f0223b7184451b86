"""The geometries of an asset's mesh, and as parts that are fixed to a body."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color, Look
from esg.engines.scene import Body
from esg.units import CM_PER_M
from esg.view.pieces import Part, Turning


def fixed(
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
