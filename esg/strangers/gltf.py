"""glTF files: what they declare fits what they hold, before anything is allocated for it.

The document is checked for all that our own code and the mesh library take for granted: indices
that exist, views inside their buffers, accessors inside their views, a forest of nodes.
"""

from __future__ import annotations

import base64
from collections.abc import Callable, Sequence
import io
import json
import struct
from typing import Any

MOST_BYTES = 256 * 2**20
MOST_ITEMS = 50_000
"""Nodes, meshes, accessors and so on, of each kind."""
MOST_ELEMENTS = 20_000_000
"""Vertices and indices: of all accessors, and of all instances of meshes."""
MOST_PIXELS = 64_000_000
MOST_DEPTH = 200
"""Of nodes: the mesh library walks them."""

MAGIC, JSON, BIN = 0x46546C67, 0x4E4F534A, 0x004E4942
_COMPONENT_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_COMPONENTS = {
    "SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16,
}  # fmt: skip
_LISTS = (
    "accessors", "animations", "bufferViews", "buffers", "cameras", "images", "materials", "meshes",
    "nodes", "samplers", "scenes", "skins", "textures",
)  # fmt: skip
Item = dict[str, Any]


def read_glb(data: bytes) -> tuple[Item, bytes]:
    """JSON and binary chunk of a GLB.

    Raises:
        ValueError: If it is no binary glTF 2, cut off, or declares what it does not hold.
    """
    if len(data) > MOST_BYTES:
        raise ValueError(f"it has {len(data)} bytes, at most {MOST_BYTES} are read")
    if len(data) < 20 or struct.unpack_from("<II", data) != (MAGIC, 2):
        raise ValueError("not a binary glTF 2 file")
    if struct.unpack_from("<I", data, 8)[0] > len(data):
        raise ValueError("a binary glTF 2 file that is cut off")
    document: Any = {}
    binary = b""
    at = 12
    while at + 8 <= len(data):
        length, kind = struct.unpack_from("<II", data, at)
        chunk = data[at + 8 : at + 8 + length]
        if kind == JSON:
            document = parsed(chunk)
        elif kind == BIN:
            binary = chunk
        at += 8 + length + (-length % 4)
    check(document, binary)
    return document, binary


def parsed(text: bytes) -> Item:
    """The document of a glTF file.

    Raises:
        ValueError: If it is no JSON object.
    """
    try:
        document = json.loads(text)
    except RecursionError:
        raise ValueError("nested too deeply") from None
    if not isinstance(document, dict):
        raise ValueError("no JSON object")
    return document


def check(
    document: Item, binary: bytes, external: Callable[[str], bytes | None] = lambda _: None
) -> None:
    """Makes sure that a document holds together.

    Args:
        document: Of a glTF file.
        binary: The binary chunk, b"" if there is none.
        external: Gives the content of a file that the document names, None if it may not be read.

    Raises:
        ValueError: Naming the first thing that does not.
    """
    for name in _LISTS:
        items = document.get(name, [])
        if not isinstance(items, list) or not all(isinstance(item, dict) for item in items):
            raise ValueError(f"/{name} is no list of objects")
        if len(items) > MOST_ITEMS:
            raise ValueError(f"/{name} has {len(items)} entries, at most {MOST_ITEMS} are read")
    buffers = _buffers(document, binary, external)
    views = _views(document, buffers)
    counts = [
        _accessor(item, f"/accessors/{i}", views)
        for i, item in enumerate(_list(document, "accessors"))
    ]
    _few(sum(counts), "/accessors hold")
    sizes = _meshes(document, counts)
    _nodes(document, sizes)
    _images(document, views, buffers, external)
    _textures(document)


def _list(document: Item, name: str) -> list[Item]:
    return document.get(name, [])


def _index(item: Item, key: str, place: str, among: Sequence[Any], least: int = 0) -> int | None:
    """An index into a list, None if it is not given."""
    value = item.get(key)
    if value is None:
        return None
    if not isinstance(value, int) or isinstance(value, bool) or not least <= value < len(among):
        raise ValueError(f"{place}/{key} is {str(value)[:40]}, there are {len(among)}")
    return value


def _whole(item: Item, key: str, place: str, otherwise: int = 0) -> int:
    value = item.get(key, otherwise)
    if not isinstance(value, int) or isinstance(value, bool) or value < 0:
        raise ValueError(f"{place}/{key} is {str(value)[:40]}, not a count")
    return value


def _few(count: int, what: str) -> None:
    if count > MOST_ELEMENTS:
        raise ValueError(f"{what} {count} elements, at most {MOST_ELEMENTS} are read")


def _buffers(
    document: Item, binary: bytes, external: Callable[[str], bytes | None]
) -> list[bytes | None]:
    """Content of every buffer; None for one inside a `data:` text, which is as long as it is."""
    out: list[bytes | None] = []
    for i, item in enumerate(_list(document, "buffers")):
        place, said = f"/buffers/{i}", _whole(item, "byteLength", f"/buffers/{i}")
        uri = item.get("uri")
        if uri is None:
            held: bytes | None = binary if i == 0 else b""
        elif not isinstance(uri, str):
            raise ValueError(f"{place}/uri is no text")
        elif uri.startswith("data:"):
            held = None
        else:
            held = external(uri)
            if held is None:
                raise ValueError(f"{place}/uri names a file outside: {uri[:80]!r}")
        if said > (MOST_BYTES if held is None else len(held)):
            raise ValueError(f"{place} says {said} bytes, which it does not hold")
        out.append(held)
    return out


def _views(document: Item, buffers: Sequence[bytes | None]) -> list[Item]:
    views = _list(document, "bufferViews")
    declared = [_whole(b, "byteLength", "/buffers") for b in _list(document, "buffers")]
    for i, item in enumerate(views):
        place = f"/bufferViews/{i}"
        buffer = _index(item, "buffer", place, buffers)
        if buffer is None:
            raise ValueError(f"{place} names no buffer")
        end = _whole(item, "byteOffset", place) + _whole(item, "byteLength", place)
        if end > declared[buffer]:
            raise ValueError(f"{place} ends at byte {end} of a buffer of {declared[buffer]}")
        if _whole(item, "byteStride", place) > 252:
            raise ValueError(f"{place}/byteStride is {item['byteStride']}, at most 252")
    return views


def _accessor(item: Item, place: str, views: Sequence[Item]) -> int:
    """Elements of an accessor that fits its view."""
    count = _whole(item, "count", place)
    _few(count, f"{place} has")
    width = _COMPONENT_BYTES.get(item.get("componentType", 0))
    number = _COMPONENTS.get(str(item.get("type")))
    if width is None or number is None:
        raise ValueError(f"{place} is of no known type")
    view = _index(item, "bufferView", place, views)
    if view is not None and count:
        size = width * number
        stride = views[view].get("byteStride") or size
        end = _whole(item, "byteOffset", place) + (count - 1) * stride + size
        if end > views[view]["byteLength"]:
            raise ValueError(f"{place} says {count} elements, its view is too short for them")
    sparse = item.get("sparse")
    if sparse is not None and (
        not isinstance(sparse, dict) or _whole(sparse, "count", f"{place}/sparse") > count
    ):
        raise ValueError(f"{place}/sparse does not fit")
    return count


def _meshes(document: Item, counts: Sequence[int]) -> list[int]:
    """Vertices and indices of every mesh."""
    materials = _list(document, "materials")
    sizes: list[int] = []
    for i, mesh in enumerate(_list(document, "meshes")):
        primitives, total = mesh.get("primitives"), 0
        if not isinstance(primitives, list) or not all(isinstance(p, dict) for p in primitives):
            raise ValueError(f"/meshes/{i}/primitives is no list of objects")
        for k, primitive in enumerate(primitives):
            place = f"/meshes/{i}/primitives/{k}"
            attributes = primitive.get("attributes")
            if not isinstance(attributes, dict):
                raise ValueError(f"{place} has no attributes")
            used = [_index(attributes, key, place, counts) for key in attributes]
            used.append(_index(primitive, "indices", place, counts))
            _index(primitive, "material", place, materials)
            total += max((counts[u] for u in used if u is not None), default=0)
        sizes.append(total)
    return sizes


def _nodes(document: Item, sizes: Sequence[int]) -> None:
    """A forest of bearable size: what many nodes show is there many times."""
    nodes = _list(document, "nodes")
    parent: dict[int, int] = {}
    shown = 0
    for i, node in enumerate(nodes):
        mesh = _index(node, "mesh", f"/nodes/{i}", sizes)
        shown += 0 if mesh is None else sizes[mesh]
        for child in _indices(node.get("children", []), f"/nodes/{i}/children", nodes):
            if child in parent:
                raise ValueError(f"/nodes/{child} has two parents")
            parent[child] = i
    _few(shown, "/nodes show")
    depth: dict[int, int] = {}
    for start in range(len(nodes)):
        path = [start]
        while path[-1] in parent and path[-1] not in depth:
            path.append(parent[path[-1]])
            if len(path) > MOST_DEPTH:
                raise ValueError(f"/nodes/{start} is its own parent or lies too deep")
        base = depth.get(path[-1], 0)
        for step, node in enumerate(reversed(path)):
            depth[node] = base + step
        if depth[start] > MOST_DEPTH:
            raise ValueError(f"/nodes/{start} lies too deep")
    scenes = _list(document, "scenes")
    for i, scene in enumerate(scenes):
        _indices(scene.get("nodes", []), f"/scenes/{i}/nodes", nodes)
    if scenes:
        _index(document, "scene", "", scenes)


def _indices(values: Any, place: str, among: Sequence[Any]) -> list[int]:
    if not isinstance(values, list):
        raise ValueError(f"{place} is no list")
    found = [_index({"": value}, "", place, among) for value in values]
    if None in found or len(set(found)) != len(found):
        raise ValueError(f"{place} names one twice, or none")
    return [f for f in found if f is not None]


def _images(
    document: Item,
    views: Sequence[Item],
    buffers: Sequence[bytes | None],
    external: Callable[[str], bytes | None],
) -> None:
    for i, item in enumerate(_list(document, "images")):
        place = f"/images/{i}"
        view = _index(item, "bufferView", place, views)
        if view is None:
            check_picture(_named(item, place, external), place)
            continue
        held = buffers[views[view]["buffer"]]
        if held is not None:
            start = views[view].get("byteOffset", 0)
            check_picture(held[start : start + views[view]["byteLength"]], place)


def _named(item: Item, place: str, external: Callable[[str], bytes | None]) -> bytes:
    """What the address of an image names: a `data:` text or a file."""
    uri = item.get("uri")
    if not isinstance(uri, str):
        raise ValueError(f"{place} has neither a view nor an address")
    if uri.startswith("data:"):
        try:
            return base64.b64decode(uri.partition(",")[2], validate=True)
        except ValueError:
            raise ValueError(f"{place}/uri is no base64") from None
    held = external(uri)
    if held is None:
        raise ValueError(f"{place}/uri names a file outside: {uri[:80]!r}")
    return held


def check_picture(data: bytes, place: str) -> None:
    """Makes sure that a picture is not too large to be decoded.

    Raises:
        ValueError: If it is, or is no picture.
    """
    from PIL import Image

    try:
        with Image.open(io.BytesIO(data)) as image:
            width, height = image.size
    except Exception as error:  # a decoder's complaints have no common class
        raise ValueError(f"{place} is no picture ({type(error).__name__})") from None
    if width * height > MOST_PIXELS:
        raise ValueError(f"{place} has {width} x {height} pixels, at most {MOST_PIXELS} are read")


def _textures(document: Item) -> None:
    images, samplers = _list(document, "images"), _list(document, "samplers")
    textures = _list(document, "textures")
    for i, item in enumerate(textures):
        _index(item, "source", f"/textures/{i}", images)
        _index(item, "sampler", f"/textures/{i}", samplers)
    waiting: list[Any] = list(_list(document, "materials"))
    while waiting:
        value = waiting.pop()
        if not isinstance(value, dict):
            continue
        for key, inner in value.items():
            if key.endswith("Texture") and isinstance(inner, dict):
                _index(inner, "index", f"/materials/{key}", textures)
            waiting.append(inner)
