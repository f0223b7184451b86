"""Meshes of scene folders, small enough to travel inside a page."""

from __future__ import annotations

import base64
from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace
import hashlib
import io
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.gltf.parts import parts_of
from esg.assets.gltf.surfaces import Surface
from esg.compile.glb import mesh_of
from esg.engines.scene import Body
from esg.report.binary import Chunk
from esg.scenereading import damaged

TEXTURE_PX = 256
"""Edge of a picture on a surface; pages share each."""


class MeshLibrary:
    """Every mesh once, however many scenes use it: keys are hashes of the files' contents."""

    def __init__(self) -> None:
        self.chunks: dict[str, str] = {}
        self.pictures: dict[str, str] = {}
        self._keys: dict[tuple[str, str], str] = {}

    def add_pieces(self, pieces: Iterable[Piece]) -> str:
        """Key of meshes that stand in the world; `holders` lists what each is of."""
        text = pieces_chunk(pieces, self.pictures, holders="holders")
        key = hashlib.sha256(text.encode()).hexdigest()[:16]
        self.chunks[key] = text
        return key

    def add(
        self,
        body: Body,
        folder: Path,
        problems: list[str] | None = None,
        whole: Body | None = None,
    ) -> str:
        """Key of a body's mesh, empty if it has none.

        Args:
            body: Its collision shapes stand in for a missing file.
            folder: The scene folder.
            problems: Receives what is wrong with a damaged file.
            whole: What a fragment is of, whose surface it shows.
        """
        known = self._keys.get((str(folder), body.mesh)) if body.mesh else None
        if known:
            return known
        source, data = mesh_of(body, folder, whole)
        path = folder / body.mesh
        if body.mesh and source != body.mesh and path.exists() and problems is not None:
            problems.append(str(damaged(path, "no binary glTF: its collision shapes are shown")))
        if data is None:
            return ""
        key = hashlib.sha256(data).hexdigest()[:16]
        if key not in self.chunks:
            try:
                self.chunks[key] = mesh_chunk(data, [w.name for w in body.wheels], self.pictures)
            except Exception as error:  # whatever a reader of models meets in a damaged one
                if source != body.mesh or problems is None:
                    raise
                problems.append(str(damaged(path, f"{error}: its collision shapes are shown")))
                return self.add(replace(body, mesh=""), folder, problems)
        if source == body.mesh:
            self._keys[str(folder), body.mesh] = key
        return key


def mesh_chunk(
    data: bytes, wheels: Collection[str] = (), pictures: dict[str, str] | None = None
) -> str:
    """A GLB as a chunk: parts of one surface merged, vertices welded, in the asset's frame [m].

    Args:
        data: A binary glTF file.
        wheels: Names of the nodes that turn: their parts stay apart.
        pictures: Receives the base colours by key, as base64 (WebP).
    """
    pieces = [
        Piece(p.holder if p.holder in wheels else "", p.vertices, p.faces, p.uvs, p.surface)
        for p in parts_of(data)
    ]
    return pieces_chunk(pieces, pictures, holders="wheels" if wheels else "")


@dataclass(frozen=True)
class Piece:
    """A mesh of one surface.

    Args:
        holder: What it is a part of; pieces of different ones stay apart.
        vertices: [m], shape [n, 3].
        faces: Vertex indices, shape [m, 3].
        uvs: Texture coordinates at the vertices, v up, shape [n, 2]; None without.
        surface: What it is made of.
    """

    holder: str
    vertices: NDArray[Any]
    faces: NDArray[Any]
    uvs: NDArray[Any] | None
    surface: Surface


def pieces_chunk(
    pieces: Iterable[Piece], pictures: dict[str, str] | None = None, holders: str = ""
) -> str:
    """Meshes as a chunk, those of one holder and surface merged, vertices welded.

    Args:
        pieces: The meshes.
        pictures: Receives the base colours by key, as base64 (WebP).
        holders: Name under which the holders of the merged meshes are listed; "" lists none.
    """
    groups: dict[tuple[Any, ...], list[Piece]] = {}
    for piece in pieces:
        s = piece.surface
        look = (*s.shown, s.alpha, s.roughness, s.metalness)
        shown = _picture(s, pictures) if pictures is not None and piece.uvs is not None else ""
        key = (piece.holder, shown, *(round(v, 3) for v in look))
        groups.setdefault(key, []).append(piece)
    corners, faces, counts, start = [], [], [], 0
    for members in groups.values():
        total = 0
        for m in members:
            uvs = m.uvs if m.uvs is not None else np.zeros((len(m.vertices), 2))
            rows = np.round(np.concatenate([m.vertices, uvs], axis=1), 5)
            welded, index = np.unique(rows, axis=0, return_inverse=True)
            corners.append(welded)
            faces.append(index.reshape(-1)[m.faces] + start)
            start += len(welded)
            total += 3 * len(m.faces)
        counts.append(total)
    chunk = Chunk({"colors": [list(key[2:6]) for key in groups], "counts": counts})
    chunk.head["surfaces"] = [[*key[6:], key[1]] for key in groups]
    if holders:
        chunk.head[holders] = [key[0] for key in groups]
    table = np.concatenate(corners) if corners else np.zeros((0, 5))
    chunk.quantized("vertices", table[:, :3])
    if any(key[1] for key in groups):
        chunk.quantized("uvs", table[:, 3:])
    index = np.concatenate(faces).reshape(-1) if faces else np.zeros(0, int)
    chunk.integers("index", index, "u2" if start < 65536 else "u4")
    return chunk.text()


def _picture(surface: Surface, pictures: dict[str, str]) -> str:
    """Key of a surface's base colours, empty if it has none that can be read."""
    picture = surface.base
    if picture is None:
        return ""
    if picture.digest not in pictures:
        from PIL import Image

        from esg.strangers.gltf import MOST_PIXELS

        try:
            with Image.open(io.BytesIO(picture.data), formats=("PNG", "JPEG")) as image:
                small = image.width * image.height <= MOST_PIXELS
                made = _webp(image.convert("RGB")) if small else ""
        except (OSError, ValueError, SyntaxError):  # a decoder's complaints
            made = ""
        pictures[picture.digest] = made
    return picture.digest if pictures[picture.digest] else ""


def _webp(image: Any) -> str:
    out = io.BytesIO()
    image.resize((TEXTURE_PX, TEXTURE_PX)).save(out, "WEBP", quality=70, method=4)
    return base64.b64encode(out.getvalue()).decode("ascii")
