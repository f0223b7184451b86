"""Closed meshes of curved things (cm): lofts, tubes, cuts that follow a surface.

A body is drawn as one lofted solid; its windows, lamps and seams are the same solid a little
thicker, met with prisms (`inlay`): so they follow every curve of it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline, PchipInterpolator
import trimesh

Points = NDArray[np.float64]


def gather(meshes: Sequence[trimesh.Trimesh]) -> trimesh.Trimesh:
    """Closed meshes side by side as one; they may overlap, as nothing is cut."""
    starts = np.cumsum([0, *(len(m.vertices) for m in meshes[:-1])])
    faces = [np.asarray(m.faces) + k for m, k in zip(meshes, starts, strict=True)]
    vertices = np.concatenate([np.asarray(m.vertices) for m in meshes])
    return trimesh.Trimesh(vertices, np.concatenate(faces), process=False)


def loft(rings: Any) -> trimesh.Trimesh:
    """Closed skin over rings of equally many points; the ends are closed by fans.

    Args:
        rings: Shape [k, n, 3], along the body; a ring of no size makes a tip.
    """
    rings = np.asarray(rings, float)
    k, n, _ = rings.shape
    index = np.arange(k * n).reshape(k, n)
    a, b = index[:-1], index[1:]
    a1, b1 = np.roll(a, -1, 1), np.roll(b, -1, 1)
    sides = np.concatenate(
        [np.stack([a, a1, b1], -1).reshape(-1, 3), np.stack([a, b1, b], -1).reshape(-1, 3)]
    )
    first, last = np.full(n, k * n), np.full(n, k * n + 1)
    ends = np.concatenate(
        [
            np.stack([first, np.roll(index[0], -1), index[0]], -1),
            np.stack([last, index[-1], np.roll(index[-1], -1)], -1),
        ]
    )
    vertices = np.concatenate([rings.reshape(-1, 3), rings[[0, -1]].mean(1)])
    faces = np.concatenate([sides, ends])
    return _outward(vertices, faces)


def _outward(vertices: Points, faces: NDArray[np.int64]) -> trimesh.Trimesh:
    """A mesh whose faces look outwards, whichever way they were given."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    six_volumes = float(np.einsum("ij,ij->", a, np.cross(b, c)))
    return trimesh.Trimesh(vertices, faces if six_volumes > 0 else faces[:, ::-1], process=False)


def copied(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """A mesh of its own that may be moved; for those that are kept to be drawn again."""
    out = trimesh.Trimesh(np.array(mesh.vertices), mesh.faces, process=False)
    out.metadata.update(mesh.metadata)
    return out


def turned(
    profile: Any, at: Any = (0, 0, 0), sections: int = 32, axis: str = "z"
) -> trimesh.Trimesh:
    """Surface of revolution of (radius, height) points about an axis through `at`.

    A profile that ends where it starts makes a ring; any other is closed on the axis.
    """
    points = np.asarray(profile, float)
    turn = 2 * math.pi * np.arange(sections) / sections
    c, s = np.cos(turn), np.sin(turn)
    r, h = points[:, :1], np.repeat(points[:, 1:], sections, 1)
    rings = np.stack(
        {"z": (r * c, r * s, h), "x": (h, r * c, r * s), "y": (r * s, h, r * c)}[axis], -1
    ) + np.asarray(at, float)
    if np.allclose(points[0], points[-1]):
        mesh = _torus(rings[:-1])
    else:
        mesh = loft(rings[points[:, 0] > 1e-9])
    mesh.metadata["shape"] = "lathe"
    return mesh


def smooth_path(points: Any, count: int) -> Points:
    """`count` points of a cubic spline through points of any dimension, shape [n, d]."""
    p = np.asarray(points, float)
    t = np.r_[0, np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1))]
    return np.asarray(CubicSpline(t, p)(np.linspace(0, t[-1], count)))


def profile(points: Any) -> Callable[[Any], Points]:
    """A monotone curve through (position, value) pairs, constant beyond them."""
    p = np.asarray(points, float)
    p = p[np.argsort(p[:, 0])]
    curve = PchipInterpolator(p[:, 0], p[:, 1])
    return lambda at: np.asarray(curve(np.clip(at, p[0, 0], p[-1, 0])))


def _frames(path: Points) -> tuple[Points, Points]:
    """Two normals at each point of a path, turned as little as possible along it."""
    tangent = np.gradient(path, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    helper = np.array([0.0, 1, 0]) if abs(tangent[0, 1]) < 0.9 else np.array([1.0, 0, 0])
    u = helper - tangent[0] * (helper @ tangent[0])
    us = []
    for t in tangent:
        u = u - t * (u @ t)
        u /= np.linalg.norm(u)
        us.append(u)
    first = np.array(us)
    return first, np.cross(tangent, first)


def tube(
    path: Any,
    radii: Any,
    sections: int = 14,
    *,
    flat: float = 1.0,
    closed: bool = False,
    round_ends: bool = True,
) -> trimesh.Trimesh:
    """A round or oval rod along a path.

    Args:
        path: Points [cm], shape [n, 3], no two neighbours alike.
        radii: One radius, or one a point [cm].
        sections: Points a ring.
        flat: The radius across Y is multiplied with it.
        closed: The path ends where it starts (its first point is not repeated).
        round_ends: Ends are half balls; otherwise flat.
    """
    path = np.asarray(path, float)
    radius = np.broadcast_to(np.asarray(radii, float), len(path))
    if not closed and round_ends:
        path, radius = _with_round_ends(path, radius)
    loop = np.concatenate([path[-1:], path, path[:1]]) if closed else path
    u, w = _frames(loop)
    if closed:
        u, w = u[1:-1], w[1:-1]
    turn = 2 * math.pi * np.arange(sections) / sections
    across = np.cos(turn)[None, :, None] * u[:, None] * flat
    rings = path[:, None] + radius[:, None, None] * (
        across + np.sin(turn)[None, :, None] * w[:, None]
    )
    return _torus(rings) if closed else loft(rings)


def needles(ends: Any, radius: float, sections: int = 4) -> trimesh.Trimesh:
    """Many straight thin rods as one mesh: spokes, wires.

    Args:
        ends: Start and end of each [cm], shape [n, 2, 3].
        radius: [cm].
        sections: Points a ring.
    """
    start, end = np.moveaxis(np.asarray(ends, float), 1, 0)
    along = (end - start) / np.linalg.norm(end - start, axis=1, keepdims=True)
    helper = np.where(np.abs(along[:, 1:2]) < 0.9, [0.0, 1.0, 0.0], [1.0, 0.0, 0.0])
    u = np.cross(helper, along)
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    turn = 2 * math.pi * np.arange(sections) / sections
    ring = radius * (
        np.cos(turn)[:, None] * u[:, None] + np.sin(turn)[:, None] * np.cross(along, u)[:, None]
    )
    vertices = np.concatenate([start[:, None] + ring, end[:, None] + ring], axis=1)
    k = np.arange(sections)
    after = (k + 1) % sections
    caps = k[1:-1]
    faces = np.concatenate(
        [
            np.stack([k, after, after + sections], 1),
            np.stack([k, after + sections, k + sections], 1),
            np.stack([np.zeros_like(caps), caps + 1, caps], 1),
            np.stack([np.zeros_like(caps), caps, caps + 1], 1) + sections,
        ]
    )
    every = faces[None] + 2 * sections * np.arange(len(start))[:, None, None]
    return _outward(vertices.reshape(-1, 3), every.reshape(-1, 3))


def _with_round_ends(path: Points, radius: Points) -> tuple[Points, Points]:
    start, end = path[0] - path[1], path[-1] - path[-2]
    start, end = start / np.linalg.norm(start), end / np.linalg.norm(end)
    tilt = np.radians([80, 55, 28])
    head = path[0] + radius[0] * np.sin(tilt)[:, None] * start
    tail = path[-1] + radius[-1] * np.sin(tilt)[::-1, None] * end
    return (
        np.concatenate([head, path, tail]),
        np.concatenate([radius[0] * np.cos(tilt), radius, radius[-1] * np.cos(tilt)[::-1]]),
    )


def _torus(rings: Points) -> trimesh.Trimesh:
    k, n, _ = rings.shape
    a = np.arange(k * n).reshape(k, n)
    b, a1 = np.roll(a, -1, 0), np.roll(a, -1, 1)
    b1 = np.roll(b, -1, 1)
    faces = np.concatenate(
        [np.stack([a, a1, b1], -1).reshape(-1, 3), np.stack([a, b1, b], -1).reshape(-1, 3)]
    )
    return _outward(rings.reshape(-1, 3), faces)


def superellipse(count: int, power: float, start: float = 0.0, end: float = 2 * math.pi) -> Points:
    """Points of |x|^p + |y|^p = 1 at evenly spaced angles, shape [count, 2]; 2 is a circle."""
    turn = np.linspace(start, end, count, endpoint=abs(end - start - 2 * math.pi) > 1e-9)
    c, s = np.cos(turn), np.sin(turn)
    r = (np.abs(c) ** power + np.abs(s) ** power) ** (-1 / power)
    return np.stack([r * c, r * s], -1)


def _cornered(count: int, power: float) -> Points:
    """A superellipse with its points where it bends: for nearly square ones."""
    turn = 2 * math.pi * (np.arange(count) + 0.5) / count
    c, s = np.cos(turn), np.sin(turn)
    return np.stack(
        [np.sign(c) * np.abs(c) ** (2 / power), np.sign(s) * np.abs(s) ** (2 / power)], -1
    )


def cushion(
    size: Any,
    center: Any,
    *,
    plan: float = 5.0,
    side: float = 0.3,
    sections: int = 32,
    levels: int = 13,
) -> trimesh.Trimesh:
    """A padded block of full extents `size` [cm] about `center`.

    Args:
        size: Length, width, height [cm].
        center: Of the block [cm].
        plan: Power of its superellipse seen from above; higher is squarer, 2 is round.
        side: 1 is an ellipsoid, towards 0 a block with ever sharper rims.
        sections, levels: Points around it, and from bottom to top.
    """
    half = 0.5 * np.asarray(size, float)
    around = (superellipse if plan <= 5 else _cornered)(sections, plan) * half[:2]
    tilt = np.radians(np.linspace(-87, 87, levels))
    wide, high = np.cos(tilt) ** side, np.sign(tilt) * np.abs(np.sin(tilt)) ** side
    rings = [
        np.c_[around * q, np.full(sections, z * half[2])] for q, z in zip(wide, high, strict=True)
    ]
    return loft(np.array(rings) + np.asarray(center, float))


def fattened(mesh: trimesh.Trimesh, by: float) -> trimesh.Trimesh:
    """The mesh with every vertex moved outwards by so much [cm]."""
    return trimesh.Trimesh(mesh.vertices + by * mesh.vertex_normals, mesh.faces, process=False)


def _solid(mesh: trimesh.Trimesh) -> Any:
    import manifold3d

    return manifold3d.Manifold(
        manifold3d.Mesh(
            np.ascontiguousarray(mesh.vertices, np.float32),
            np.ascontiguousarray(mesh.faces, np.uint32),
        )
    )


def _mesh(solid: Any) -> trimesh.Trimesh:
    out = solid.to_mesh()
    return trimesh.Trimesh(out.vert_properties[:, :3], out.tri_verts, process=False)


def inlay(skin: trimesh.Trimesh, tools: Sequence[trimesh.Trimesh]) -> trimesh.Trimesh:
    """What a solid and any of some tools have in common: a window, a lamp, a seam."""
    return _mesh(_solid(skin) ^ _union(tools))


def carved(body: trimesh.Trimesh, tools: Sequence[trimesh.Trimesh]) -> trimesh.Trimesh:
    """A solid without what lies in any of the tools."""
    return _mesh(_solid(body) - _union(tools))


def _union(tools: Sequence[trimesh.Trimesh]) -> Any:
    import manifold3d

    if len(tools) == 1:
        return _solid(tools[0])
    return manifold3d.Manifold.batch_boolean([_solid(t) for t in tools], manifold3d.OpType.Add)


def prism(shape: Any, span: tuple[float, float], plane: str = "xz") -> list[trimesh.Trimesh]:
    """Prisms of a shapely polygon, or of several, in a plane across `span` of the other axis."""
    import shapely

    pieces = [g for g in getattr(shape, "geoms", [shape]) if not g.is_empty]
    out = []
    for piece in pieces:
        piece = shapely.set_precision(piece, 1e-3)
        mesh = trimesh.creation.extrude_polygon(piece, span[1] - span[0], engine="manifold")
        v = np.asarray(mesh.vertices)
        depth = v[:, 2] + span[0]
        columns = {
            "xy": (v[:, 0], v[:, 1], depth),
            "xz": (v[:, 0], depth, v[:, 1]),
            "yz": (depth, v[:, 0], v[:, 1]),
        }[plane]
        faces = np.asarray(mesh.faces)
        out.append(
            trimesh.Trimesh(
                np.stack(columns, 1), faces[:, ::-1] if plane == "xz" else faces, process=False
            )
        )
    return out
