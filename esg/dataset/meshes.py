"""The mesh pack of a dataset: what the bodies of its manifests look like.

A mesh is JSON and one buffer. Scenes differ in the former (colours, wear), hardly in the latter.
So table `meshes` has the JSON of every mesh of every scene, as glTF whose buffer lies once in
`meshes/buffers/`, named by its hash.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
import hashlib
import json
from pathlib import Path
import struct
from typing import TYPE_CHECKING, Any

from esg.files import atomic_file
from esg.outcomes import UserError

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument

BUFFERS = "meshes/buffers"
_MAGIC, _JSON, _BINARY = 0x46546C67, 0x4E4F534A, 0x004E4942


def pack_meshes(doc: EsgDocument, out: Path) -> tuple[list[dict[str, Any]], list[Path]]:
    """Writes the buffers of a scene's meshes that the pack lacks.

    Args:
        doc: The scene.
        out: Folder of the dataset.

    Returns:
        Rows of table `meshes` without the columns of their scene, and the buffers they need.

    Raises:
        OSError: If a buffer cannot be written.
    """
    from esg.assets.geometry.mesh import meshes_of

    rows: list[dict[str, Any]] = []
    buffers: dict[str, Path] = {}
    for mesh in meshes_of(doc):
        config = doc.asset_configurations[mesh.asset]
        data, binary = _parts(mesh.glb)
        name = f"{BUFFERS}/{hashlib.sha256(binary).hexdigest()[:32]}.bin" if binary else None
        if name is not None:
            data["buffers"][0]["uri"] = name.removeprefix("meshes/")
            buffers[name] = out / name
            if not _holds(out / name, len(binary)):
                with atomic_file(out / name) as file:
                    file.write(binary)
        rows.append(
            {
                "mesh": mesh.path,
                "asset": config.asset_name,
                "gltf": _text(data),
                "buffer": name,
                "bytes": len(mesh.glb),
                "license": config.license,
                "attribution": config.attribution or None,
            }
        )
    return rows, list(buffers.values())


def _holds(path: Path, size: int) -> bool:
    try:
        return path.stat().st_size == size
    except OSError:
        return False


def unpack_meshes(
    dataset: Path, rows: Iterator[Mapping[str, Any]] | list[Mapping[str, Any]], folder: Path
) -> list[Path]:
    """Writes meshes of a scene as the GLB files that its manifest names.

    Args:
        dataset: Folder of the dataset.
        rows: Of table `meshes`.
        folder: Where the manifest is, or will be.

    Returns:
        The files.

    Raises:
        UserError: If a buffer is missing.
    """
    from esg.compile.assets import safe_source

    out: list[Path] = []
    for row in rows:
        binary = b""
        if row["buffer"]:
            try:
                binary = (dataset / safe_source(row["buffer"])).read_bytes()
            except OSError as error:
                raise UserError(
                    f"{dataset / row['buffer']} cannot be read ({error.strerror}); mesh "
                    f"{row['mesh']} of {row['scene_id']} needs it"
                ) from None
        out.append(folder / safe_source(row["mesh"]))
        with atomic_file(out[-1]) as file:
            file.write(_glb(json.loads(row["gltf"]), binary))
    return out


def _parts(glb: bytes) -> tuple[dict[str, Any], bytes]:
    """JSON and buffer of a GLB; without its padding, as its length is stated."""
    size = struct.unpack_from("<I", glb, 12)[0]
    data = json.loads(glb[20 : 20 + size])
    length = data["buffers"][0]["byteLength"] if data.get("buffers") else 0
    return data, glb[28 + size : 28 + size + length]


def _glb(data: dict[str, Any], binary: bytes) -> bytes:
    for buffer in data.get("buffers", ()):
        buffer.pop("uri", None)
    text = _text(data).encode()
    text += b" " * (-len(text) % 4)
    chunks = [struct.pack("<II", len(text), _JSON), text]
    if binary:
        binary += b"\0" * (-len(binary) % 4)
        chunks += [struct.pack("<II", len(binary), _BINARY), binary]
    return b"".join([struct.pack("<III", _MAGIC, 2, 12 + sum(map(len, chunks))), *chunks])


def _text(data: Mapping[str, Any]) -> str:
    return json.dumps(data, separators=(",", ":"), ensure_ascii=True)
