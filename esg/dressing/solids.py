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
_BEHIND = {"+x": "-x", "-x": "+x", "+y": "-y", "-y": "+y"}
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
        self.about = False
        """Whether sheets and boxes are drawn half a turn about Z: what faces +X then faces -X."""
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
        rows = (*corner, *along, *up)
        if self.about:
            rows = tuple(v if k % 3 == 2 else -v for k, v in enumerate(rows))
        self._heap(surface, color).sheets.append(rows)

    def box(
        self,
        surface: str,
        low: Point,
        high: Point,
        color: Color | None = None,
        sides: frozenset[str] = STANDING,
    ) -> None:
        """A box between two corners, of which some sides are seen."""
        if self.about:
            low, high = (-high[0], -high[1], low[2]), (-low[0], -low[1], high[2])
            sides = frozenset(_BEHIND.get(side, side) for side in sides)
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

    def prism(
        self,
        surface: str,
        outline: Point,
        halves: Point,
        color: Color | None = None,
    ) -> None:
        """A body with one outline from the side and at every corner of it a width.

        Args:
            surface, color: Of it.
            outline: Corners (x, z) [m] counter-clockwise as seen along +Y, shape [n, 2]; the
                outline can be seen whole from its middle.
            halves: Half widths [m] at the corners, shape [n].
        """
        flat, half = np.asarray(outline, float), np.asarray(halves, float)
        n = len(flat)
        sides = [np.column_stack([flat[:, 0], sign * half, flat[:, 1]]) for sign in (-1.0, 1.0)]
        k = np.arange(n)
        low, high = sides
        for a, b in zip(k, (k + 1) % n, strict=True):
            if abs(half[a] - half[b]) < 1e-9:
                self.sheet(surface, low[a], high[a] - low[a], low[b] - low[a], color)
            else:
                self.polygon(surface, np.array([low[a], high[a], high[b], low[b]]), color)
        self.polygon(surface, low, color)
        self.polygon(surface, high[::-1], color)

    def polygon(self, surface: str, corners: Floats, color: Color | None = None) -> None:
        """A flat face of n corners, counter-clockwise, as a fan about its middle."""
        n = len(corners)
        vertices = np.concatenate([[corners.mean(axis=0)], corners])
        k = np.arange(n)
        faces = np.stack([np.zeros(n, int), 1 + k, 1 + (k + 1) % n], axis=1)
        spokes = vertices[1:] - vertices[0]
        normal = np.cross(spokes, np.roll(spokes, -1, axis=0)).sum(axis=0)
        normal = normal / max(float(np.linalg.norm(normal)), 1e-12)
        off = np.abs(normal).argmax()
        uvs = np.delete(vertices, off, axis=1)
        normals = np.tile(normal, (n + 1, 1))
        self._heap(surface, color).meshes.append((vertices, faces, normals, uvs))

    def disc(
        self,
        surface: str,
        middle: Point,
        radius: float,
        width: float,
        color: Color | None = None,
        sides: int = 14,
    ) -> None:
        """An upright wheel that turns about Y."""
        angles = np.arange(sides) * (2 * math.pi / sides)
        x, y, z = (float(v) for v in middle)
        outline = np.column_stack([radius * np.cos(angles), radius * np.sin(angles)])
        low, high = (
            np.column_stack([x + outline[:, 0], np.full(sides, y + s * width), z + outline[:, 1]])
            for s in (-0.5, 0.5)
        )
        for a in range(sides):
            b = (a + 1) % sides
            self.sheet(surface, low[a], high[a] - low[a], low[b] - low[a], color)
        self.polygon(surface, low, color)
        self.polygon(surface, high[::-1], color)

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
            radii: Along X, Y and Z, which it nowhere goes beyond.
            rough: How far its surface wanders, in radii.
            level: 1 has 80 triangles, 2 has 320.
        """
        unit, faces = _sphere(level)
        waves = self.rng.normal(size=(6, 3)) * 2.4
        phases = self.rng.uniform(0, 2 * math.pi, 6)
        swell = 1.0 + rough * np.sin(unit @ waves.T + phases).sum(1) / 2.0
        vertices = unit * (swell / swell.max())[:, None] * np.asarray(radii, float)
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
