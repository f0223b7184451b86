"""Bodies of people: heads, hair, trunks, limbs, hands and shoes as meshes (cm, front +X)."""

from __future__ import annotations

from functools import lru_cache
import math
from typing import Any

import numpy as np

from esg.assets.builders.living.poses import Point, Skeleton, turned_about
from esg.assets.lazy import forms

HEAD = np.array([-0.6, 0.0, 158.4])
"""Middle of an upright head [cm]."""
# Height, then where the middle lies, half depth and half width.
_SKULL = (
    (-12.3, 4.6, 1.6, 1.6),
    (-11.6, 4.2, 4.0, 3.4),
    (-9.6, 3.2, 5.8, 4.8),
    (-6.5, 2.0, 7.3, 5.9),
    (-3.0, 1.1, 8.4, 6.7),
    (0.5, 0.5, 9.1, 7.3),
    (4.0, 0.0, 9.5, 7.6),
    (7.0, -0.3, 9.2, 7.4),
    (9.8, -0.6, 7.9, 6.5),
    (11.8, -0.8, 5.6, 4.7),
    (12.9, -0.9, 2.6, 2.2),
)
_TRUNK = (
    (79.0, -1.0, 6.0, 9.0),
    (83.0, -1.2, 9.4, 13.6),
    (88.0, -1.8, 10.4, 16.0),
    (93.0, -1.8, 10.3, 16.4),
    (99.0, -1.4, 9.6, 15.4),
    (107.0, -1.0, 9.0, 14.2),
    (116.0, -0.8, 9.6, 15.2),
    (125.0, -0.8, 10.6, 17.2),
    (132.0, -1.2, 10.3, 18.6),
    (136.5, -1.8, 9.2, 18.6),
    (139.6, -2.2, 7.8, 16.6),
    (142.6, -2.4, 6.8, 11.6),
    (146.0, -2.4, 5.6, 6.8),
)


def trunk_ring(z: float, grow: float = 0.0, count: int = 36) -> Point:
    """Outline of the trunk at a height, `grow` larger all around, shape [count, 2]."""
    table = np.array(_TRUNK)
    middle, deep, wide = (np.interp(z, table[:, 0], table[:, k]) for k in (1, 2, 3))
    ring = forms.superellipse(count, 2.5)
    return ring * [deep + grow, wide + grow] + [middle, 0.0]


def trunk(low: float, high: float, grow: float = 0.0, flare: float = 0.0) -> Any:
    """The trunk between two heights; its hem stands off by `flare`."""
    table = np.array(_TRUNK)
    curves = [forms.profile(table[:, [0, k]]) for k in (1, 2, 3)]
    ring = forms.superellipse(36, 2.5)
    rings = []
    for z in np.linspace(low, high, max(4, round((high - low) / 4))):
        middle, deep, wide = (float(c(z)) for c in curves)
        more = grow + flare * max(0.0, 1 - (z - low) / 14)
        flat = ring * [deep + more, wide + more] + [middle, 0.0]
        rings.append(np.c_[flat, np.full(len(flat), z)])
    return forms.loft(np.array(rings))


def front_of(outline: Any, low: float, high: float, grow: float) -> Any:
    """What lies on the front of the trunk inside an outline of (y, z) points."""
    from shapely.geometry import Polygon

    return forms.inlay(trunk(low, high, grow), forms.prism(Polygon(outline), (0, 40), "yz"))


@lru_cache(maxsize=8)
def skull(grow: float) -> Any:
    """The head without neck, nose and ears, `grow` larger all around [cm]."""
    table = np.array(_SKULL)
    z = np.linspace(table[0, 0], table[-1, 0], 18)
    middle, deep, wide = (forms.profile(table[:, [0, k]])(z) for k in (1, 2, 3))
    ring = forms.superellipse(24, 2.25)
    rings = [
        np.c_[ring * [d + grow, w + grow] + [m, 0.0], np.full(len(ring), t + grow * t / 13)]
        for t, m, d, w in zip(z, middle, deep, wide, strict=True)
    ]
    return forms.loft(np.array(rings) + HEAD)


@lru_cache(maxsize=2)
def head() -> Any:
    """Head and neck, with nose, ears and lids."""
    x, _, z = HEAD
    parts = [skull(0.0)]
    parts.append(
        forms.tube(
            [(-3.4, 0, 139), (-3.0, 0, 146), (-1.6, 0, 153)], [6.4, 5.5, 5.4], 18, round_ends=False
        )
    )
    nose = [(x + 9.0, 0, z + 2.4), (x + 9.9, 0, z - 0.4), (x + 10.6, 0, z - 2.9)]
    parts.append(forms.tube(nose, [0.7, 0.95, 1.3], 8))
    for side in (-1, 1):
        parts.append(
            forms.cushion(
                (1.6, 1.5, 1.2),
                (x + 9.5, side * 1.1, z - 3.2),
                plan=2.2,
                side=0.8,
                sections=8,
                levels=5,
            )
        )
        ear = [
            (x - 0.6, side * 7.4, z + 2.2),
            (x - 1.2, side * 8.3, z - 0.2),
            (x - 0.5, side * 7.3, z - 3.4),
        ]
        parts.append(forms.tube(ear, [1.4, 1.6, 1.0], 8))
        parts.append(
            forms.cushion(
                (2.6, 3.6, 1.2),
                (x + 7.75, side * 3.15, z + 2.1),
                plan=2.2,
                side=0.8,
                sections=10,
                levels=5,
            )
        )
    return forms.gather(parts)


@lru_cache(maxsize=2)
def eyes() -> tuple[Any, Any]:
    """Whites and irises."""
    x, _, z = HEAD
    white, iris = [], []
    for side in (-1, 1):
        white.append(
            forms.cushion(
                (2.4, 3.0, 2.0),
                (x + 7.75, side * 3.15, z + 0.9),
                plan=2.2,
                side=0.8,
                sections=14,
                levels=9,
            )
        )
        iris.append(
            forms.cushion(
                (0.7, 1.5, 1.55),
                (x + 8.72, side * 3.2, z + 0.9),
                plan=2.0,
                side=0.9,
                sections=12,
                levels=7,
            )
        )
    return forms.gather(white), forms.gather(iris)


@lru_cache(maxsize=2)
def mouth() -> Any:
    """Lips."""
    x, _, z = HEAD
    return forms.tube(
        [
            (x + 7.9, -2.9, z - 6.1),
            (x + 9.0, -1.4, z - 6.5),
            (x + 9.3, 0, z - 6.5),
            (x + 9.0, 1.4, z - 6.5),
            (x + 7.9, 2.9, z - 6.1),
        ],
        [0.22, 0.55, 0.6, 0.55, 0.22],
        8,
        flat=0.9,
    )


@lru_cache(maxsize=2)
def brows() -> Any:
    """Both eyebrows."""
    x, _, z = HEAD
    out = [
        forms.tube(
            [(x + 9.0, s * 1.6, z + 3.3), (x + 8.8, s * 3.2, z + 3.8), (x + 7.6, s * 4.9, z + 3.2)],
            [0.4, 0.45, 0.25],
            6,
        )
        for s in (-1, 1)
    ]
    return forms.gather(out)


_FACE = (
    (9.6, 8.6),
    (5.6, 6.8),
    (3.4, 4.2),
    (1.6, 3.6),
    (0.9, -1.0),
    (-1.4, -1.6),
    (-2.6, -4.2),
    (-6.5, -6.4),
    (-20, -6.8),
    (-20, -30),
    (30, -30),
    (30, 8.6),
)
"""Where no short hair grows: outline in x and z about the head's middle, seen from the side."""


_OPENINGS = {
    "covered": (
        (4.6, 6.2),
        (3.0, 3.0),
        (2.6, -3.0),
        (3.4, -9.0),
        (5.0, -11.0),
        (30, -11.0),
        (30, 6.2),
    ),
    "hooded": ((6.6, 8.0), (5.2, 4.0), (4.8, -3.0), (5.4, -9.0), (30, -10.0), (30, 8.0)),
}
"""Where cloth over a head leaves the face free: outline as of `_FACE`."""


@lru_cache(maxsize=12)
def hair(style: str) -> Any:
    """Hair of a style: short, long (a tail), flowing, bun or bald (a fringe); or cloth instead."""
    from shapely.geometry import Polygon

    face = Polygon(_FACE)
    if style in _OPENINGS:
        face = Polygon(_OPENINGS[style])
    if style == "bald":
        face = face.union(Polygon([(-30, 4.5), (30, 4.5), (30, 40), (-30, 40)]))
    thick = {"short": 1.0, "bald": 0.4, "covered": 1.7, "hooded": 3.0}.get(style, 1.1)
    tool = forms.prism(face, (-30, 30))
    for mesh in tool:
        mesh.apply_translation([HEAD[0], 0, HEAD[2]])
    out = [forms.carved(skull(thick), tool)]
    x, _, z = HEAD
    if style == "long":
        spine = [
            (x - 5.4, 0, z + 3),
            (x - 7.4, 0, z - 6),
            (x - 8.6, 0, z - 16),
            (x - 8.8, 0, z - 24),
        ]
        out.append(
            forms.tube(
                forms.smooth_path(spine, 12),
                np.interp(np.linspace(0, 1, 12), [0, 0.4, 1], [5.2, 4.6, 2.6]),
                18,
                flat=1.75,
            )
        )
    if style == "flowing":
        out.append(
            forms.cushion((7.4, 17.6, 32), (x - 6.2, 0, z - 10.5), plan=2.6, side=0.5, sections=24)
        )
    if style == "bun":
        out.append(
            forms.cushion(
                (7, 8, 7.4), (x - 9.4, 0, z + 5), plan=2, side=1.0, sections=16, levels=11
            )
        )
    return forms.gather(out)


def limb(joints: Point, radii: tuple[float, ...], sections: int = 14) -> Any:
    """A sleeve, a trouser leg or a bare limb through three joints, or a part of it.

    Args:
        joints: Shape [3, 3].
        radii: At evenly spaced places from first to last joint [cm].
        sections: Points a ring.
    """
    a, b, c = joints
    path = np.array(
        [a, a + 0.5 * (b - a), b - 0.1 * (b - a), b + 0.1 * (c - b), b + 0.5 * (c - b), c]
    )
    fine = forms.smooth_path(path, 12)
    along = np.linspace(0, 1, len(radii))
    return forms.tube(fine, np.interp(np.linspace(0, 1, 12), along, radii), sections)


def between(joints: Point, start: float, end: float) -> Point:
    """Three joints of the part of a limb between two shares of its way."""

    def at(share: float) -> Point:
        k = 0 if share < 0.5 else 1
        return joints[k] + (2 * share - k) * (joints[k + 1] - joints[k])

    return np.array(
        [
            at(start),
            at(max(start, min(end, 0.5)) if start < 0.5 < end else (start + end) / 2),
            at(end),
        ]
    )


def hand(wrist: Point, elbow: Point, side: int, grip: bool) -> Any:
    """A hand that goes on from a forearm, its palm towards the body."""
    d = (wrist - elbow) / np.linalg.norm(wrist - elbow)
    n = np.array([0.0, -side, 0.0])
    n = n - d * (n @ d)
    n = n / np.linalg.norm(n) if np.linalg.norm(n) > 0.2 else np.array([0.0, 0.0, -1.0])
    t = np.cross(n, d) * -side  # towards the thumb
    frame = np.array([t, n, d])

    def place(p: Any) -> Point:
        return np.asarray(p, float) @ frame + wrist

    palm = [(0, 2.4, 1.6), (2.2, 3.2, 1.75), (5, 3.9, 1.6), (8, 3.9, 1.35), (9.4, 3.6, 1.1)]
    ring = forms.superellipse(12, 2.6)
    rings = np.array([place(np.c_[ring * [w, h], np.full(12, at)]) for at, w, h in palm])
    parts = [forms.loft(rings)]
    curl = 2.0 if grip else 0.5
    for k, length in enumerate((6.6, 7.6, 7.2, 5.8)):
        x = 2.85 - 1.9 * k
        path, at, bend = [(x, 0.0, 8.4)], np.array([x, 0.0, 8.4]), 0.12
        for share in (0.42, 0.33, 0.25):
            bend += curl * 0.55
            at = at + length * share * np.array([0, math.sin(bend), math.cos(bend)])
            path.append(tuple(at))
        parts.append(forms.tube(place(path), [0.95, 0.9, 0.8, 0.65], 6))
    thumb = [(2.4, 0.4, 2.4), (4.6, 1.4, 5.0), (5.0, 2.4, 7.6 if not grip else 6.4)]
    parts.append(forms.tube(place(thumb), [1.15, 1.0, 0.75], 6))
    return forms.gather(parts)


def _footed(mesh: Any, ankle: Point, pitch: float) -> Any:
    mesh.vertices = turned_about(np.asarray(mesh.vertices), np.zeros(3), pitch) + ankle
    return mesh


def shoe(ankle: Point, pitch: float, boot: float = 0.0) -> Any:
    """A shoe about an ankle; `boot` is how much higher than a shoe it reaches [cm]."""
    shape = (
        (-8.3, 2.4, -3.6),
        (-7.6, 3.3, -0.6),
        (-4.0, 3.9, 0.8),
        (0.5, 4.1, 0.6),
        (4.5, 4.4, -1.0),
        (8.5, 4.7, -3.2),
        (13, 4.7, -4.4),
        (17.0, 3.9, -5.3),
        (19.6, 2.4, -6.2),
        (20.6, 0.8, -7.0),
    )
    ring = forms.superellipse(20, 2.8)
    rings = []
    for x, wide, top in shape:
        low = -8.4
        z = np.where(
            ring[:, 1] > 0, low + 1.2 + ring[:, 1] * (top - low - 1.2), low + 1.2 + ring[:, 1] * 1.2
        )
        rings.append(np.c_[np.full(20, x), ring[:, 0] * wide, z])
    parts = [forms.loft(np.array(rings))]
    parts.append(
        forms.tube(
            [(0.2, 0, -3.5), (0, 0, 3.0 + boot)], [4.4, 4.2 + 0.05 * boot], 16, round_ends=False
        )
    )
    return _footed(forms.gather(parts), ankle, pitch)


def sole(ankle: Point, pitch: float) -> Any:
    """The sole of a shoe."""
    outline = (
        (-8.9, 2.3),
        (-7.0, 3.6),
        (-2, 3.9),
        (4, 4.3),
        (9, 5.0),
        (14, 4.9),
        (18.4, 3.7),
        (20.9, 1.5),
    )
    ring = np.array([*outline, *((x, -y) for x, y in reversed(outline))])
    rings = [
        np.c_[ring * q, np.full(len(ring), z)] for q, z in ((0.97, -9.2), (1.0, -8.7), (1.0, -7.6))
    ]
    return _footed(forms.loft(np.array(rings)), ankle, pitch)


def laces(ankle: Point, pitch: float) -> Any:
    """Laces across the instep."""
    lines = [
        forms.tube([(x, -1.9, z), (x + 0.3, 0, z + 0.9), (x, 1.9, z)], 0.32, 6)
        for x, z in ((5.0, -1.5), (7.0, -2.4), (9.0, -3.2))
    ]
    return _footed(forms.gather(lines), ankle, pitch)


def foot(ankle: Point, pitch: float) -> Any:
    """A bare foot."""
    shape = (
        (-8.6, 2.2, -4),
        (-7.2, 3.3, -0.6),
        (-1, 3.7, 1.0),
        (4, 4.0, -1.6),
        (9.6, 4.6, -4.6),
        (15.4, 4.7, -6.2),
        (18.8, 3.8, -7.0),
        (20.4, 1.7, -7.8),
    )
    ring = forms.superellipse(18, 2.4)
    rings = []
    for x, wide, top in shape:
        z = -9.2 + (ring[:, 1] + 1) / 2 * (top + 9.2)
        rings.append(np.c_[np.full(18, x), ring[:, 0] * wide, z])
    return _footed(forms.loft(np.array(rings)), ankle, pitch)


def posed(mesh: Any, move: Any) -> Any:
    """A mesh with its vertices led by a function."""
    import trimesh

    return trimesh.Trimesh(move(np.asarray(mesh.vertices, float)), mesh.faces, process=False)


_HALF, _BACK = 86.0, 10.9
"""Of somebody who lies on his back [cm]: half his length, and his middle above the ground."""


def raised(mesh: Any, skeleton: Skeleton) -> Any:
    """A mesh on the ground, or on the seat, that its body is on."""
    mesh.vertices = at_rest(np.asarray(mesh.vertices), skeleton)
    return mesh


def at_rest(points: Point, skeleton: Skeleton) -> Point:
    """Points on the ground, or on the seat, that their body is on, shape [n, 3]."""
    points = points + skeleton.lift
    if skeleton.pose.lies:
        x, y, z = points.T
        points = np.stack([z - _HALF, -y, x + _BACK], axis=1)
    return points


def on_ground(mesh: Any) -> Any:
    """A mesh of which nothing is below the ground: what hangs lies on it."""
    vertices = np.array(mesh.vertices)
    if vertices[:, 2].min() < 0.0:
        vertices[:, 2] = np.maximum(vertices[:, 2], 0.0)
        mesh.vertices = vertices
    return mesh


def scaled(mesh: Any, factor: float) -> Any:
    """A mesh scaled about the origin."""
    mesh.vertices = np.asarray(mesh.vertices) * factor
    return mesh
