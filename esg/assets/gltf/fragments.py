"""What the fragments of a broken thing look like: its largest surface, on their own faces."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import trimesh

    from esg.assets.geometry.finishing import Surface

Floats = NDArray[np.float64]
UNTOLD = 1.0
"""Edge of a tile where what broke has no texture coordinates to tell it: nothing is drawn in it."""


class Piece(Protocol):
    """A part of what broke, in metres or centimetres."""

    @property
    def vertices(self) -> Floats: ...

    @property
    def faces(self) -> NDArray[np.int64]: ...

    @property
    def uvs(self) -> Floats | None: ...


def largest(pieces: Sequence[Piece]) -> int:
    """Index of the part with the greatest area: what a thing is seen as.

    Args:
        pieces: At least one.
    """
    return int(np.argmax([_area(p.vertices, p.faces) for p in pieces]))


def tile_of(piece: Piece) -> float:
    """Edge of one tile of a part's texture, in the unit of its vertices."""
    if piece.uvs is None:
        return UNTOLD
    flat = np.c_[piece.uvs, np.zeros(len(piece.uvs))]
    tiles = _area(flat, piece.faces)
    return float(np.sqrt(_area(piece.vertices, piece.faces) / tiles)) if tiles > 1e-9 else UNTOLD


def skinned(mesh: trimesh.Trimesh, tile: float) -> Surface:
    """A convex piece with sharp edges and texture coordinates.

    Args:
        mesh: The piece.
        tile: Edge of one tile, in the unit of its vertices.
    """
    from esg.assets.geometry.finishing import Drawing, finished

    return finished(Drawing(lambda: mesh), tile)


def _area(vertices: Floats, faces: NDArray[np.int64]) -> float:
    corners = np.asarray(vertices)[np.asarray(faces)]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return 0.5 * float(np.linalg.norm(across, axis=1).sum())
