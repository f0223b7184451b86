"""Meshes of dressing: boxes, sheets, tubes and clumps that gather by surface.

Frame of a thing: metres, origin at the middle of its bottom, front +X, Z up. Texture coordinates
are metres along the surface, v up.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
import math

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Point = Sequence[float] | Floats
_BOX_SIDES = (
    # corner, along, up: counter-clockwise seen from outside
    ("+x", (1, 0, 0), (0, 1, 0), (0, 0, 1)),
    ("-x", (0, 1, 0), (0, -1, 0), (0, 0, 1)),
    ("+y", (1, 1, 0), (-1, 0, 0), (0, 0, 1)),
    ("-y", (0, 0, 0), (1, 0, 0), (0, 0, 1)),
    ("+z", (0, 0, 1), (1, 0, 0), (0, 1, 0)),
    ("-z", (0, 1, 0), (1, 0, 0), (0, -1, 0)),
)
ALL_SIDES = frozenset(name for name, *_ in _BOX_SIDES)
STANDING = ALL_SIDES - {"-z"}
"""Sides of a box that stands on the ground."""


@dataclass(frozen=True)
class Solid:
    """Triangles of one surface and colour.

    Args:
        surface: Row of the table of surfaces; "" for paint in its colour.
        color: sRGB in [0, 1]; None for the usual one of the surface.
        vertices: [m], shape [n, 3].
        faces: Counter-clockwise seen from outside, shape [m, 3].
        normals: Unit normals at the vertices, shape [n, 3].
        uvs: Metres along the surface, v up, shape [n, 2].
    """

    surface: str
    color: Color | None
    vertices: Floats
    faces: Ints
    normals: Floats
    uvs: Floats


_CORNERS = np.array([corner for _, corner, _, _ in _BOX_SIDES], float)
_ALONG = np.array([along for _, _, along, _ in _BOX_SIDES], float)
_UP = np.array([up for _, _, _, up in _BOX_SIDES], float)
_ORDER = {name: k for k, (name, *_) in enumerate(_BOX_SIDES)}


@dataclass
class _Heap:
    """What is drawn in one surface and colour; sheets and boxes wait to be made all at once."""

    sheets: list[tuple[float, ...]] = field(default_factory=list[tuple[float, ...]])
    """Corner, along, up: nine numbers each."""
    boxes: dict[frozenset[str], list[tuple[float, ...]]] = field(
        default_factory=dict[frozenset[str], list[tuple[float, ...]]]
    )
    """By the sides that are seen, low and high: six numbers each."""
    meshes: list[tuple[Floats, Ints, Floats, Floats]] = field(
        default_factory=list[tuple[Floats, Ints, Floats, Floats]]
    )

    def all(self) -> list[tuple[Floats, Ints, Floats, Floats]]:
        """Vertices, faces, normals and texture coordinates of everything."""
        rows = [np.array(self.sheets, float).reshape(-1, 3, 3)]
        for sides, boxes in self.boxes.items():
            pick = sorted(_ORDER[s] for s in sides)
            ends = np.array(boxes, float).reshape(-1, 1, 2, 3)
            low, size = ends[:, :, 0], ends[:, :, 1] - ends[:, :, 0]
            parts = [low + size * _CORNERS[pick], size * _ALONG[pick], size * _UP[pick]]
            rows.append(np.stack(parts, axis=2).reshape(-1, 3, 3))
        quads = np.concatenate(rows)
        return [*self.meshes, *([_made(quads)] if len(quads) else [])]


def _made(quads: Floats) -> tuple[Floats, Ints, Floats, Floats]:
    """Parallelograms, shape [n, 3, 3] (corner, along, up), as a mesh of flat faces.

    Texture coordinates count from one origin, so that neighbours in a plane continue each other.
    """
    corner, along, up = quads[:, 0], quads[:, 1], quads[:, 2]
    width, height = np.linalg.norm(along, axis=1), np.linalg.norm(up, axis=1)
    real = (width > 1e-6) & (height > 1e-6)
    corner, along, up, width, height = (x[real] for x in (corner, along, up, width, height))
    vertices = np.stack([corner, corner + along, corner + along + up, corner + up], axis=1)
    normal = np.cross(along, up)
    normal = normal / np.linalg.norm(normal, axis=1, keepdims=True)
    start = np.stack([(corner * along).sum(1) / width, (corner * up).sum(1) / height], axis=1)
    size = np.stack([width, height], axis=1)[:, None]
    uvs = start[:, None] + size * np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    n = len(corner)
    faces = np.array([[0, 1, 2], [0, 2, 3]]) + 4 * np.arange(n)[:, None, None]
    normals = np.repeat(normal, 4, axis=0)
    return vertices.reshape(-1, 3), faces.reshape(-1, 3), normals, uvs.reshape(-1, 2)


class Drawing:
    """What builders draw into; pieces of one surface and colour become one mesh.

    Args:
        rng: Of what may differ from one thing to the next.
        night: Whether lamps are on behind windows.
    """

    def __init__(self, rng: np.random.Generator, *, night: bool = False) -> None:
        self.rng = rng
        self.night = night
        self._heaps: dict[tuple[str, Color | None], _Heap] = {}

    def solids(self) -> list[Solid]:
        """Everything drawn so far, one mesh a surface and colour."""
        out: list[Solid] = []
        for (surface, color), heap in self._heaps.items():
            meshes = heap.all()
            starts = np.cumsum([0, *(len(m[0]) for m in meshes[:-1])])
            faces = np.concatenate([m[1] + s for m, s in zip(meshes, starts, strict=True)])
            vertices = np.concatenate([m[0] for m in meshes])
            normals = np.concatenate([m[2] for m in meshes])
            uvs = np.concatenate([m[3] for m in meshes])
            out.append(Solid(surface, color, vertices, faces, normals, uvs))
        return out

    def sheet(
        self, surface: str, corner: Point, along: Point, up: Point, color: Color | None = None
    ) -> None:
        """A parallelogram, seen from where `along`, then `up` turn counter-clockwise."""
        self._heap(surface, color).sheets.append((*corner, *along, *up))

    def box(
        self,
        surface: str,
        low: Point,
        high: Point,
        color: Color | None = None,
        sides: frozenset[str] = STANDING,
    ) -> None:
        """A box between two corners, of which some sides are seen."""
        self._heap(surface, color).boxes.setdefault(sides, []).append((*low, *high))

    def tube(
        self,
        surface: str,
        foot: Point,
        radii: tuple[float, float],
        height: float,
        color: Color | None = None,
        sides: int = 10,
    ) -> None:
        """An upright round post, closed at its top."""
        angles = np.linspace(0.0, 2 * math.pi, sides + 1)
        ring = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        base = np.asarray(foot, float)
        low = base + np.column_stack([ring * radii[0], np.zeros(sides + 1)])
        high = base + np.column_stack([ring * radii[1], np.full(sides + 1, height)])
        k = np.arange(sides)
        n = sides + 1
        faces = np.concatenate(
            [np.stack([k, k + 1, k + 1 + n], 1), np.stack([k, k + 1 + n, k + n], 1)]
        )
        around = angles * max(radii)
        lean = (radii[0] - radii[1]) / max(height, 1e-6)
        normals = np.column_stack([ring, np.full(n, lean)])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        rises = np.repeat([0.0, height], n)
        cap = np.concatenate([(base + np.array([0.0, 0.0, height]))[None], high])
        self._heap(surface, color).meshes += [
            (
                np.concatenate([low, high]),
                faces,
                np.concatenate([normals, normals]),
                np.stack([np.tile(around, 2), rises], axis=1),
            ),
            (
                cap,
                np.stack([np.zeros(sides, int), k + 1, k + 2], axis=1),
                np.tile([0.0, 0.0, 1.0], (len(cap), 1)),
                cap[:, :2],
            ),
        ]

    def clump(
        self,
        surface: str,
        middle: Point,
        radii: Point,
        color: Color | None = None,
        *,
        rough: float = 0.12,
        level: int = 2,
    ) -> None:
        """A round mass of leaves, snow or rock.

        Args:
            surface, color: Of it.
            middle: Its centre.
            radii: Along X, Y and Z.
            rough: How far its surface wanders, in radii.
            level: 1 has 80 triangles, 2 has 320.
        """
        unit, faces = _sphere(level)
        waves = self.rng.normal(size=(6, 3)) * 3.2
        phases = self.rng.uniform(0, 2 * math.pi, 6)
        swell = 1.0 + rough * np.sin(unit @ waves.T + phases).sum(1) / 2.0
        vertices = unit * swell[:, None] * np.asarray(radii, float)
        corners = vertices[faces]
        flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals = np.zeros_like(vertices)
        for k in range(3):
            np.add.at(normals, faces[:, k], flat)
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
        size = float(np.mean(radii))
        turn = np.arctan2(unit[:, 1], unit[:, 0]) * size
        uvs = np.stack([turn, np.arcsin(np.clip(unit[:, 2], -1, 1)) * size], 1)
        self._heap(surface, color).meshes.append(
            (vertices + np.asarray(middle, float), faces, normals, uvs)
        )

    def _heap(self, surface: str, color: Color | None) -> _Heap:
        return self._heaps.setdefault((surface, color), _Heap())


@cache
def _sphere(level: int) -> tuple[Floats, Ints]:
    from trimesh.creation import icosphere

    ball = icosphere(subdivisions=level)
    return np.array(ball.vertices, float), np.array(ball.faces, np.int64)
