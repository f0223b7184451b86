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


@dataclass
class _Heap:
    vertices: list[Floats] = field(default_factory=list[Floats])
    faces: list[Ints] = field(default_factory=list[Ints])
    normals: list[Floats] = field(default_factory=list[Floats])
    uvs: list[Floats] = field(default_factory=list[Floats])
    count: int = 0

    def add(self, vertices: Floats, faces: Ints, normals: Floats, uvs: Floats) -> None:
        self.vertices.append(vertices)
        self.faces.append(faces + self.count)
        self.normals.append(normals)
        self.uvs.append(uvs)
        self.count += len(vertices)


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
        return [
            Solid(
                surface,
                color,
                np.concatenate(heap.vertices),
                np.concatenate(heap.faces),
                np.concatenate(heap.normals),
                np.concatenate(heap.uvs),
            )
            for (surface, color), heap in self._heaps.items()
        ]

    def sheet(
        self, surface: str, corner: Point, along: Point, up: Point, color: Color | None = None
    ) -> None:
        """A parallelogram, seen from where `along`, then `up` turn counter-clockwise."""
        o, a, b = (np.asarray(p, float) for p in (corner, along, up))
        width, height = float(np.linalg.norm(a)), float(np.linalg.norm(b))
        if width < 1e-6 or height < 1e-6:
            return
        normal = np.cross(a, b)
        normal = normal / np.linalg.norm(normal)
        self._heap(surface, color).add(
            np.array([o, o + a, o + a + b, o + b]),
            np.array([[0, 1, 2], [0, 2, 3]]),
            np.tile(normal, (4, 1)),
            np.array([[0, 0], [width, 0], [width, height], [0, height]]) + _start(o, a, b),
        )

    def box(
        self,
        surface: str,
        low: Point,
        high: Point,
        color: Color | None = None,
        sides: frozenset[str] = STANDING,
    ) -> None:
        """A box between two corners, of which some sides are seen."""
        lo, hi = np.asarray(low, float), np.asarray(high, float)
        size = hi - lo
        for name, corner, along, up in _BOX_SIDES:
            if name in sides:
                self.sheet(surface, lo + size * corner, size * along, size * up, color)

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
        faces = np.concatenate([np.stack([k, k + 1, k + 1 + n], 1), np.stack([k, k + 1 + n, k + n], 1)])  # fmt: skip
        around = angles * max(radii)
        lean = (radii[0] - radii[1]) / max(height, 1e-6)
        normals = np.column_stack([ring, np.full(n, lean)])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        self._heap(surface, color).add(
            np.concatenate([low, high]),
            faces,
            np.concatenate([normals, normals]),
            np.concatenate(
                [np.stack([around, np.zeros(n)], 1), np.stack([around, np.full(n, height)], 1)]
            ),
        )
        cap = np.concatenate([[base + [0, 0, height]], high])
        self._heap(surface, color).add(
            cap,
            np.stack([np.zeros(sides, int), k + 1, k + 2], 1),
            np.tile([0.0, 0.0, 1.0], (len(cap), 1)),
            cap[:, :2],
        )

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
        self._heap(surface, color).add(vertices + np.asarray(middle, float), faces, normals, uvs)

    def _heap(self, surface: str, color: Color | None) -> _Heap:
        return self._heaps.setdefault((surface, color), _Heap())


def _start(corner: Floats, along: Floats, up: Floats) -> Floats:
    """Where a sheet's texture begins, so that neighbours in one plane continue each other's."""
    return np.array(
        [corner @ along / np.linalg.norm(along), corner @ up / np.linalg.norm(up)], dtype=float
    )


@cache
def _sphere(level: int) -> tuple[Floats, Ints]:
    from trimesh.creation import icosphere

    ball = icosphere(subdivisions=level)
    return np.array(ball.vertices, float), np.array(ball.faces, np.int64)
