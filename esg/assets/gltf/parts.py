"""The parts of a GLB in our own frame: triangles, normals, texture coordinates and surfaces."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.gltf.surfaces import Picture, Surface
from esg.assets.looks import Color
from esg.strangers.gltf import read_glb
from esg.units import quat_rotate

Floats = NDArray[np.float64]
Faces = NDArray[np.int64]

_DTYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_TRIANGLES, _STRIP, _FAN = 4, 5, 6
PLAIN = Surface()


@dataclass(frozen=True)
class MeshPart:
    """One mesh of one surface in the frame of its file, Z up.

    Args:
        holder: Name of the node above its own, "" for none.
        name: Of its node.
        vertices: [m], shape [n, 3].
        faces: Vertex indices, counter-clockwise seen from outside, shape [m, 3].
        normals: Unit normals at the vertices, shape [n, 3]; None for flat faces.
        uvs: Texture coordinates at the vertices, v up, shape [n, 2].
        surface: What it is made of.
    """

    holder: str
    name: str
    vertices: Floats
    faces: Faces
    normals: Floats | None
    uvs: Floats | None
    surface: Surface


def parts_of(data: bytes) -> list[MeshPart]:
    """The parts of a GLB's scene, in the order of its nodes.

    Lines, points and pictures outside the file are passed over.

    Raises:
        ValueError: If it is no GLB or holds what does not fit together.
    """
    document, binary = read_glb(data)
    surfaces = [_surface(document, binary, m) for m in document.get("materials", [])]
    out: list[MeshPart] = []
    for node, matrix, holder in _walked(document):
        if "mesh" not in node:
            continue
        for primitive in document["meshes"][node["mesh"]]["primitives"]:
            part = _part(document, binary, primitive, matrix, surfaces)
            if part is not None:
                out.append(MeshPart(holder, str(node.get("name", "")), *part))
    return out


def node_matrices(data: bytes) -> dict[str, Floats]:
    """Where the nodes of a GLB are, by name, in glTF's frame [m], shape [4, 4]."""
    document, _ = read_glb(data)
    return {str(node.get("name", "")): matrix for node, matrix, _ in _walked(document)}


def _walked(document: dict[str, Any]) -> Iterator[tuple[dict[str, Any], Floats, str]]:
    """The nodes of a document's scene, with their matrices and the names of what holds them."""
    nodes = document.get("nodes", [])
    scenes = document.get("scenes", [])
    roots = scenes[document.get("scene", 0)].get("nodes", []) if scenes else range(len(nodes))
    waiting = [(index, np.eye(4), "") for index in reversed(roots)]
    while waiting:
        index, above, holder = waiting.pop()
        node = nodes[index]
        matrix = above @ matrix_of(node)
        yield node, matrix, holder
        name = str(node.get("name", ""))
        waiting += [(child, matrix, name) for child in reversed(node.get("children", []))]


def _part(
    document: dict[str, Any],
    binary: bytes,
    primitive: dict[str, Any],
    matrix: Floats,
    surfaces: list[Surface],
) -> tuple[Floats, Faces, Floats | None, Floats | None, Surface] | None:
    attributes = primitive["attributes"]
    mode = primitive.get("mode", _TRIANGLES)
    if "POSITION" not in attributes or mode not in (_TRIANGLES, _STRIP, _FAN):
        return None
    points = values_of(document, binary, attributes["POSITION"], 3)
    if "indices" in primitive:
        index = values_of(document, binary, primitive["indices"], 1).astype(np.int64).ravel()
    else:
        index = np.arange(len(points))
    if index.size and index.max() >= len(points):
        raise ValueError(f"it names vertex {index.max()} of {len(points)}")
    faces = triangles_of(index, mode)
    if np.linalg.det(matrix[:3, :3]) < 0.0:
        faces = faces[:, ::-1]
    normals = uvs = None
    if "NORMAL" in attributes:
        turned = values_of(document, binary, attributes["NORMAL"], 3) @ _normal_matrix(matrix).T
        length = np.linalg.norm(turned, axis=1, keepdims=True)
        normals = _z_up(turned / np.where(length > 0.0, length, 1.0))
    if "TEXCOORD_0" in attributes:
        uvs = values_of(document, binary, attributes["TEXCOORD_0"], 2) * (1.0, -1.0) + (0.0, 1.0)
    if any(len(v) != len(points) for v in (normals, uvs) if v is not None):
        raise ValueError("it has not as many normals or texture coordinates as vertices")
    vertices = _z_up(points @ matrix[:3, :3].T + matrix[:3, 3])
    material = primitive.get("material")
    return vertices, faces, normals, uvs, PLAIN if material is None else surfaces[material]


def _z_up(points: Floats) -> Floats:
    x, y, z = points.T
    return np.stack([x, -z, y], axis=1)


def _normal_matrix(matrix: Floats) -> Floats:
    """The inverse transpose of a matrix, up to a positive factor; itself where it has none."""
    turn = matrix[:3, :3]
    determinant = float(np.linalg.det(turn))
    return np.linalg.inv(turn).T.astype(float) if abs(determinant) > 1e-12 else turn


def triangles_of(index: Faces, mode: int) -> Faces:
    """Triangles of a primitive's indices, shape [m, 3]; `mode` is glTF's."""
    if mode == _TRIANGLES:
        return index[: len(index) // 3 * 3].reshape(-1, 3)
    first = np.arange(max(len(index) - 2, 0))
    if mode == _FAN:
        return index[np.stack([np.zeros_like(first), first + 1, first + 2], axis=1)]
    odd = first % 2
    return index[np.stack([first, first + 1 + odd, first + 2 - odd], axis=1)]


def matrix_of(node: dict[str, Any]) -> Floats:
    """Where a node is in the one above it, in glTF's frame [m], shape [4, 4]."""
    if "matrix" in node:
        return np.array(node["matrix"], float).reshape(4, 4).T
    matrix = np.eye(4)
    turn = np.array(node.get("rotation", (0.0, 0.0, 0.0, 1.0)), float)
    scale = np.array(node.get("scale", (1.0, 1.0, 1.0)), float)
    matrix[:3, :3] = quat_rotate(turn, np.eye(3)).T * scale
    matrix[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return matrix


def values_of(document: dict[str, Any], binary: bytes, index: int, width: int) -> Floats:
    """The values of an accessor, shape [n, width]; normalized ones in [-1, 1]."""
    accessor = document["accessors"][index]
    if _WIDTHS.get(accessor["type"]) != width:
        raise ValueError(f"/accessors/{index} is a {accessor['type']}, not of {width} numbers")
    kind = np.dtype(_DTYPES[accessor["componentType"]])
    count, size = accessor["count"], width * kind.itemsize
    if "bufferView" not in accessor:
        return np.zeros((count, width))
    view = document["bufferViews"][accessor["bufferView"]]
    if "uri" in document["buffers"][view["buffer"]]:
        raise ValueError(f"/accessors/{index} lies outside the file")
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    stride = view.get("byteStride") or size
    raw = np.frombuffer(binary, np.uint8, (count - 1) * stride + size if count else 0, start)
    rows = np.lib.stride_tricks.as_strided(raw, (count, size), (stride, 1), writeable=False)
    values = np.ascontiguousarray(rows).view(kind).reshape(count, width).astype(float)
    if accessor.get("normalized") and kind.kind in "iu":
        values = np.maximum(values / np.iinfo(kind).max, -1.0)
    return values


def _surface(document: dict[str, Any], binary: bytes, material: dict[str, Any]) -> Surface:
    pbr = material.get("pbrMetallicRoughness", {})
    red, green, blue, alpha = pbr.get("baseColorFactor", (1.0, 1.0, 1.0, 1.0))
    opaque = material.get("alphaMode", "OPAQUE") == "OPAQUE"

    def seen(holder: dict[str, Any], key: str) -> Picture | None:
        return _picture(document, binary, holder.get(key, {}).get("index"))

    return Surface(
        name=str(material.get("name", "")),
        color=(float(red), float(green), float(blue)),
        roughness=float(pbr.get("roughnessFactor", 1.0)),
        metalness=float(pbr.get("metallicFactor", 1.0)),
        alpha=1.0 if opaque else float(alpha),
        base=seen(pbr, "baseColorTexture"),
        normal=seen(material, "normalTexture"),
        normal_scale=float(material.get("normalTexture", {}).get("scale", 1.0)),
        rough_metal=seen(pbr, "metallicRoughnessTexture"),
        two_sided=bool(material.get("doubleSided", False)),
        average=_average(material.get("extras")),
    )


def _average(extras: Any) -> Color | None:
    """What our own files tell of a surface's colour on average."""
    told = extras.get("color") if isinstance(extras, dict) else None
    if not isinstance(told, list) or len(told) != 3:
        return None
    if not all(isinstance(c, (int, float)) and 0.0 <= c <= 1.0 for c in told):
        return None
    red, green, blue = (float(c) for c in told)
    return red, green, blue


def _picture(document: dict[str, Any], binary: bytes, texture: int | None) -> Picture | None:
    """The picture of a texture, if it is a PNG or JPEG inside the file."""
    if texture is None:
        return None
    source = document["textures"][texture].get("source")
    image = document["images"][source] if source is not None else {}
    if "bufferView" not in image:
        return None
    view = document["bufferViews"][image["bufferView"]]
    start = view.get("byteOffset", 0)
    name = str(image.get("name", ""))
    found = Picture(binary[start : start + view["byteLength"]], name)
    return found if found.suffix else None
