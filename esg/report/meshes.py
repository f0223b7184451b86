"""Meshes of scene folders, small enough to travel inside a page."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
import hashlib
from pathlib import Path

import numpy as np

from esg.assets.gltf.parts import parts_of
from esg.compile.glb import mesh_of
from esg.engines.scene import Body
from esg.report.binary import Chunk
from esg.scenereading import damaged


class MeshLibrary:
    """Every mesh once, however many scenes use it: keys are hashes of the files' contents."""

    def __init__(self) -> None:
        self.chunks: dict[str, str] = {}
        self._keys: dict[tuple[str, str], str] = {}

    def add(self, body: Body, folder: Path, problems: list[str] | None = None) -> str:
        """Key of a body's mesh, empty if it has none.

        Args:
            body: Its collision shapes stand in for a missing file.
            folder: The scene folder.
            problems: Receives what is wrong with a damaged file.
        """
        known = self._keys.get((str(folder), body.mesh)) if body.mesh else None
        if known:
            return known
        source, data = mesh_of(body, folder)
        path = folder / body.mesh
        if body.mesh and source != body.mesh and path.exists() and problems is not None:
            problems.append(str(damaged(path, "no binary glTF: its collision shapes are shown")))
        if data is None:
            return ""
        key = hashlib.sha256(data).hexdigest()[:16]
        if key not in self.chunks:
            try:
                self.chunks[key] = mesh_chunk(data, [w.name for w in body.wheels])
            except Exception as error:  # whatever a reader of models meets in a damaged one
                if source != body.mesh or problems is None:
                    raise
                problems.append(str(damaged(path, f"{error}: its collision shapes are shown")))
                return self.add(replace(body, mesh=""), folder, problems)
        if source == body.mesh:
            self._keys[str(folder), body.mesh] = key
        return key


def mesh_chunk(data: bytes, wheels: Collection[str] = ()) -> str:
    """A GLB as a chunk: parts of one colour merged, vertices welded, in the asset's frame [m].

    Args:
        data: A binary glTF file.
        wheels: Names of the nodes that turn: their parts stay apart.
    """
    pieces: dict[tuple[str, tuple[float, ...]], list[tuple[np.ndarray, np.ndarray]]] = {}
    for part in parts_of(data):
        color = (*part.surface.shown, part.surface.alpha)
        key = part.holder if part.holder in wheels else "", tuple(round(c, 3) for c in color)
        pieces.setdefault(key, []).append((part.vertices, part.faces))
    colors, vertices, faces, counts, start = [], [], [], [], 0
    for (_, color), parts in pieces.items():
        total = 0
        for points, triangles in parts:
            welded, index = np.unique(np.round(points, 5), axis=0, return_inverse=True)
            vertices.append(welded)
            faces.append(index.reshape(-1)[triangles] + start)
            start += len(welded)
            total += 3 * len(triangles)
        colors.append(list(color))
        counts.append(total)
    chunk = Chunk({"colors": colors, "counts": counts})
    if wheels:
        chunk.head["wheels"] = [wheel for wheel, _ in pieces]
    chunk.quantized("vertices", np.concatenate(vertices) if vertices else np.zeros((0, 3)))
    index = np.concatenate(faces).reshape(-1) if faces else np.zeros(0, int)
    chunk.integers("index", index, "u2" if start < 65536 else "u4")
    return chunk.text()
