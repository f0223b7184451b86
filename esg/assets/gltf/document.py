"""A growing glTF document: files merged into it, meshes, surfaces and key frames added to it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
import hashlib
import json
import struct
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from esg.assets.gltf.surfaces import Picture, Surface
from esg.machine.recent import Recent
from esg.strangers.gltf import BIN, JSON, MAGIC, read_glb

Floats = NDArray[np.float64]
Item = dict[str, Any]
Corners = tuple[Floats, NDArray[np.int64], Floats | None, Floats | None]
"""Vertices [m], faces, normals and texture coordinates (v up) of a mesh."""

_FLOAT, _SHORT, _INT = 5126, 5123, 5125
_KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}
_VERTICES, _INDICES = 34962, 34963
_SAMPLER = {"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}
"""Linear, with mipmaps, repeated."""
STRENGTH = "KHR_materials_emissive_strength"
_MIME = {"png": "image/png", "jpg": "image/jpeg"}
_KEPT_BYTES = 2 * 2**20
"""Of tangents that a process keeps: exports of one scene ask for those of a surface again."""
_kept: Recent[bytes, NDArray[np.float32]] = Recent(_KEPT_BYTES, lambda array: array.nbytes)
MOVED = 1e-6
"""Smallest change [m, or of a quaternion] that counts as motion."""


class Packed(NamedTuple):
    """Numbers as a file holds them.

    Args:
        data: Their bytes.
        accessor: What a file says of them, but where they are.
        use: Of their view; None if nothing is said.
    """

    data: bytes
    accessor: Item
    use: int | None


class Encoded(NamedTuple):
    """A mesh as a file holds it: its attributes by name, in order, and its faces."""

    attributes: tuple[tuple[str, Packed], ...]
    indices: Packed

    @property
    def n_bytes(self) -> int:
        """Of all its numbers."""
        return len(self.indices.data) + sum(len(numbers.data) for _, numbers in self.attributes)


@dataclass
class Document:
    """A glTF document with one buffer; what it is given twice it holds once."""

    data: Item = field(default_factory=dict)
    binary: bytearray = field(default_factory=bytearray)
    extensions: set[str] = field(default_factory=set)
    required: set[str] = field(default_factory=set)
    channels: list[Item] = field(default_factory=list)
    samplers: list[Item] = field(default_factory=list)
    clock: int = -1
    known: dict[tuple[str, str], int] = field(default_factory=dict)

    def append(self, key: str, item: Any) -> int:
        """Adds an item to one of the document's lists; returns its index."""
        items = self.data.setdefault(key, [])
        items.append(item)
        return len(items) - 1

    def once(self, key: str, item: Item, *, by: str = "") -> int:
        """Adds an item unless the same is there; returns its index.

        Args:
            key: Of the list.
            item: To add.
            by: What tells it from others, default its content.
        """
        sign = key, by or json.dumps(item, sort_keys=True)
        if sign not in self.known:
            self.known[sign] = self.append(key, item)
        return self.known[sign]

    def view(self, data: bytes | bytearray | memoryview, **more: int) -> int:
        """Adds bytes to the buffer; returns the index of their view."""
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data), **more}
        self.binary += data
        return self.append("bufferViews", view)

    def values(
        self, values: Any, kind: int = _FLOAT, *, limits: bool = False, use: int | None = None
    ) -> int:
        """Adds an accessor of numbers, shape [n] or [n, k]; of float32 unless told otherwise."""
        return self.packed(pack(values, kind, limits=limits, use=use))

    def packed(self, numbers: Packed) -> int:
        """Adds an accessor of numbers that are as a file holds them."""
        more = {} if numbers.use is None else {"target": numbers.use}
        view = self.view(numbers.data, **more)
        return self.append("accessors", {"bufferView": view, **numbers.accessor})

    def merge(self, source: bytes) -> tuple[list[Item], list[int]]:
        """Takes over a GLB's meshes; returns its nodes with meshes renumbered, and its roots."""
        other, binary = read_glb(source)
        for mesh in other.get("meshes", []):
            for primitive in mesh["primitives"]:
                _say_use(other, primitive["attributes"].values(), _VERTICES)
                _say_use(other, [primitive["indices"]] if "indices" in primitive else [], _INDICES)
        views, images = self._take_bytes(other, binary)
        accessors: list[int] = []
        for accessor in other.get("accessors", []):
            _renumber(accessor, "bufferView", views)
            accessors.append(self.append("accessors", accessor))
        samplers = [self.once("samplers", item) for item in other.get("samplers", [])]
        textures: list[int] = []
        for texture in other.get("textures", []):
            _renumber(texture, "source", images)
            _renumber(texture, "sampler", samplers)
            textures.append(self.once("textures", texture))
        materials: list[int] = []
        for material in other.get("materials", []):
            _renumber_textures(material, textures)
            materials.append(self.once("materials", material))
        meshes: list[int] = []
        for mesh in other.get("meshes", []):
            for primitive in mesh["primitives"]:
                for key, value in primitive["attributes"].items():
                    primitive["attributes"][key] = accessors[value]
                _renumber(primitive, "indices", accessors)
                _renumber(primitive, "material", materials)
            meshes.append(self.append("meshes", mesh))
        self.extensions |= set(other.get("extensionsUsed", []))
        self.required |= set(other.get("extensionsRequired", []))
        nodes = other.get("nodes", [])
        for node in nodes:
            _renumber(node, "mesh", meshes)
            for key in ("camera", "skin"):
                node.pop(key, None)
        scene = other.get("scenes", [{}])[other.get("scene", 0)]
        return nodes, list(scene.get("nodes", range(len(nodes))))

    def _take_bytes(self, other: Item, binary: bytes) -> tuple[list[int], list[int]]:
        """Copies views and images; a picture that is known is not copied again."""
        views = other.get("bufferViews", [])
        held = [binary[v.get("byteOffset", 0) :][: v["byteLength"]] for v in views]
        numbers: dict[int, int] = {}
        # Views that overlap are copied together, or a file could grow without bound.
        whole = sum(map(len, held)) > len(binary)
        base = 0
        if whole:
            self.binary += b"\0" * (-len(self.binary) % 4)
            base = len(self.binary)
            self.binary += binary

        def copied(index: int) -> int:
            if index not in numbers:
                view = views[index] | {"buffer": 0}
                if whole:
                    view["byteOffset"] = view.get("byteOffset", 0) + base
                    numbers[index] = self.append("bufferViews", view)
                else:
                    more = {k: view[k] for k in ("byteStride", "target") if k in view}
                    numbers[index] = self.view(held[index], **more)
            return numbers[index]

        images: list[int] = []
        pictures = {i["bufferView"] for i in other.get("images", []) if "bufferView" in i}
        for image in other.get("images", []):
            if "bufferView" in image:
                data = held[image["bufferView"]]
                sign = f"{image.get('mimeType')} {hashlib.sha256(data).hexdigest()}"
                if ("images", sign) not in self.known:
                    image["bufferView"] = copied(image["bufferView"])
                images.append(self.once("images", image, by=sign))
            else:
                images.append(self.once("images", image))
        used = {a["bufferView"] for a in other.get("accessors", []) if "bufferView" in a}
        for index in range(len(views)):
            if index not in pictures or index in used:
                copied(index)
        return [numbers.get(index, -1) for index in range(len(views))], images

    def material(self, surface: Surface) -> int:
        """Adds a surface unless it is there; returns the index of its material."""
        pbr: Item = {
            "baseColorFactor": [*map(_six, surface.color), _six(surface.alpha)],
            "metallicFactor": _six(surface.metalness),
            "roughnessFactor": _six(surface.roughness),
        }
        item: Item = {"name": surface.name, "pbrMetallicRoughness": pbr}
        for holder, key, picture in (
            (pbr, "baseColorTexture", surface.base),
            (pbr, "metallicRoughnessTexture", surface.rough_metal),
            (item, "normalTexture", surface.normal),
        ):
            if picture is not None:
                holder[key] = {"index": self._texture(picture)}
        if surface.normal is not None and surface.normal_scale != 1.0:
            item["normalTexture"]["scale"] = _six(surface.normal_scale)
        if surface.average is not None:
            # For readers without pictures: sRGB of the surface on average.
            item["extras"] = {"color": [round(c, 4) for c in surface.average]}
        if surface.glow > 0.0:
            item["emissiveFactor"] = [*map(_six, surface.color)]
            item["extensions"] = {STRENGTH: {"emissiveStrength": _six(surface.glow)}}
            self.extensions.add(STRENGTH)
        if surface.alpha < 1.0:
            item["alphaMode"] = "BLEND"
        if surface.two_sided:
            item["doubleSided"] = True
        return self.once("materials", item)

    def _texture(self, picture: Picture) -> int:
        mime = _MIME[picture.suffix]
        sign = f"{mime} {picture.sha256}"
        if ("images", sign) not in self.known:
            image: Item = {"bufferView": self.view(picture.data), "mimeType": mime}
            if picture.name:
                image["name"] = picture.name
            self.once("images", image, by=sign)
        source = self.known["images", sign]
        return self.once("textures", {"sampler": self.once("samplers", _SAMPLER), "source": source})

    def mesh(self, name: str, parts: Iterable[tuple[Corners, int]]) -> int:
        """Adds a mesh; returns its index.

        Args:
            name: Of the mesh.
            parts: What it consists of, in glTF's frame, each with the index of its material.
        """
        return self.encoded(
            name,
            [
                (encode(*corners, bumpy=self.bumpy(material)), material)
                for corners, material in parts
            ],
        )

    def bumpy(self, material: int) -> bool:
        """Whether a material has normals of its own, for which a mesh needs tangents."""
        return "normalTexture" in self.data["materials"][material]

    def encoded(self, name: str, parts: Iterable[tuple[Encoded, int]]) -> int:
        """As `mesh`, of parts that are as a file holds them."""
        primitives: list[Item] = []
        for (attributes, indices), material in parts:
            held = {key: self.packed(numbers) for key, numbers in attributes}
            primitives.append(
                {"attributes": held, "indices": self.packed(indices), "material": material}
            )
        return self.append("meshes", {"name": name, "primitives": primitives})

    def place(self, nodes: list[Item], roots: list[int]) -> list[int]:
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
        """Moves a node: key frames of its pose; none if it keeps still.

        Args:
            node: Its index.
            path: translation, rotation or scale.
            values: At the frames, shape [T, 3] or [T, 4].
            time: Of the frames [s], shape [T].
        """
        if len(time) < 2 or np.abs(values - values[0]).max() < MOVED:
            return
        if self.clock < 0:
            self.clock = self.values(time, limits=True)
        keys = self.values(_units(values) if path == "rotation" else values)
        self.samplers.append({"input": self.clock, "output": keys, "interpolation": "LINEAR"})
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


def pack(
    values: Any, kind: int = _FLOAT, *, limits: bool = False, use: int | None = None
) -> Packed:
    """Numbers of shape [n] or [n, k] as a file holds them.

    Args:
        values: The numbers.
        kind: Of a component, by the number that glTF has for it.
        limits: Whether the file says how small and how large they are.
        use: Of their view; None if nothing is said.
    """
    dtype = {_FLOAT: np.float32, _SHORT: np.uint16, _INT: np.uint32}[kind]
    array = np.ascontiguousarray(values, dtype)
    flat = array.reshape(len(array), -1)
    accessor: Item = {"componentType": kind, "count": len(array), "type": _KINDS[flat.shape[1]]}
    if limits:
        accessor["min"] = [float(v) for v in flat.min(0)]
        accessor["max"] = [float(v) for v in flat.max(0)]
    return Packed(array.tobytes(), accessor, use)


def encode(
    vertices: Floats,
    faces: NDArray[np.int64],
    normals: Floats | None,
    uvs: Floats | None,
    *,
    bumpy: bool,
) -> Encoded:
    """Corners of a mesh as a file holds them.

    Args:
        vertices: In glTF's frame [m], shape [n, 3].
        faces: Shape [m, 3].
        normals: Shape [n, 3]; None for none.
        uvs: Texture coordinates (v up), shape [n, 2]; None for none.
        bumpy: Whether its material has normals of its own: tangents go with them.
    """
    attributes = [("POSITION", pack(vertices, limits=True, use=_VERTICES))]
    if normals is not None:
        attributes.append(("NORMAL", pack(_units(normals), use=_VERTICES)))
    if uvs is not None:
        flipped = np.asarray(uvs, float) * (1.0, -1.0) + (0.0, 1.0)
        attributes.append(("TEXCOORD_0", pack(flipped, use=_VERTICES)))
    if bumpy and normals is not None and uvs is not None:
        tangents = _kept_tangents(vertices, faces, normals, uvs)
        attributes.append(("TANGENT", pack(tangents, use=_VERTICES)))
    kind = _SHORT if len(vertices) < 65535 else _INT
    return Encoded(tuple(attributes), pack(np.ravel(faces), kind, use=_INDICES))


def unit(q: Any) -> list[float]:
    """A quaternion as a node states it."""
    return _units(np.asarray(q, float)[None])[0].tolist()


def _units(values: Any) -> NDArray[Any]:
    single = np.asarray(values).astype(np.float32)
    length = np.linalg.norm(single, axis=-1, keepdims=True)
    return single / np.where(length > 0.0, length, 1.0)


def _kept_tangents(
    vertices: Floats, faces: NDArray[np.int64], normals: Floats, uvs: Floats
) -> NDArray[np.float32]:
    """`_tangents` as they are stored; those of what is asked for again are kept."""
    digest = hashlib.blake2b(digest_size=16)
    for array in (vertices, faces, normals, uvs):
        digest.update(f"{array.shape} {array.dtype}".encode())
        digest.update(np.ascontiguousarray(array).data)
    return _kept.get(
        digest.digest(), lambda: _tangents(vertices, faces, normals, uvs).astype(np.float32)
    )


def _tangents(vertices: Floats, faces: NDArray[np.int64], normals: Floats, uvs: Floats) -> Floats:
    """Along +u in the surface, and the side of +v as +-1, at every vertex, shape [n, 4]."""
    a, b, c = (np.asarray(vertices, float)[faces[:, k]] for k in range(3))
    p, q, r = (np.asarray(uvs, float)[faces[:, k]] for k in range(3))
    one, two, s, t = b - a, c - a, q - p, r - p
    area = s[:, 0] * t[:, 1] - s[:, 1] * t[:, 0]
    sign = np.where(area < 0.0, -1.0, 1.0)[:, None]
    along = sign * (one * t[:, 1:] - two * s[:, 1:])
    up = sign * (two * s[:, :1] - one * t[:, :1])
    count = len(vertices)
    index = np.ravel(faces)

    def gathered(values: Floats) -> Floats:
        each = np.repeat(values, 3, axis=0)
        sums = [np.bincount(index, column, count).astype(float) for column in each.T]
        return np.stack(sums, axis=1)

    along, up = gathered(along), gathered(up)
    normals = np.asarray(_units(normals), float)
    along = along - normals * np.einsum("ij,ij->i", normals, along)[:, None]
    # Where coordinates do not tell, any direction across the normal.
    other = np.eye(3)[np.abs(normals).argmin(axis=1)]
    other = np.cross(normals, other)
    lost = np.linalg.norm(along, axis=1, keepdims=True) < 1e-12
    along = _units(np.where(lost, other, along))
    side = np.einsum("ij,ij->i", np.cross(normals, along), up)
    return np.concatenate([along, np.where(side < 0.0, -1.0, 1.0)[:, None]], axis=1)


def _six(value: float) -> float:
    """As many digits of a factor as an eye can tell."""
    return round(float(value), 6)


def _say_use(document: Item, accessors: Iterable[int], use: int) -> None:
    """Marks the buffer views behind accessors as vertex or index data, which uploads faster."""
    for index in accessors:
        view = document["accessors"][index].get("bufferView")
        if view is not None:
            document["bufferViews"][view].setdefault("target", use)


def _renumber(item: Item, key: str, numbers: list[int]) -> None:
    if key in item:
        item[key] = numbers[item[key]]


def _renumber_textures(value: Any, numbers: list[int]) -> None:
    """Renumbers every `...Texture: {index}` below a material, extensions included."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if key.endswith("Texture") and isinstance(inner, dict):
                _renumber(inner, "index", numbers)
            _renumber_textures(inner, numbers)
