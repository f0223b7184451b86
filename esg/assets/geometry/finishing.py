"""What a closed mesh needs to be looked at: bevels, normals and texture coordinates.

Normals are smooth where faces meet at less than a crease angle, and split elsewhere. Texture
coordinates are a projection along the axes of the part, around its axis if it is round about one;
they count tiles, and grain runs along the part's length.
"""

from __future__ import annotations

from collections.abc import Callable
import hashlib
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
import trimesh
from trimesh.visual import TextureVisuals

from esg.assets.geometry.bevels import bevelled
from esg.assets.geometry.closures import Key, key_of
from esg.machine.recent import Recent

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

CREASE_DEG = 40.0
"""Faces that meet at less are one smooth surface."""
_BEVEL_CREASE_DEG = 57.0
"""On what is bevelled: edges and corners stand at 45 and 55 degrees to its faces, and are shaded
into them."""
_ROUND = frozenset({"cylinder", "lathe", "torus"})
_KEPT_BYTES = 8 * 2**20
"""Of surfaces that a process keeps: things share parts; whole meshes are kept as files hold them. A
part takes 34 kB on average, and some many times as much."""
_KEPT_OUTLINES = 8192
"""Of parts, a few hundred bytes each."""
_EVEN = 0.02
"""Relative difference up to which two moments are those of a thing that is round about an axis."""


class Surface(NamedTuple):
    """A mesh with what a renderer asks of its vertices.

    Args:
        vertices: [cm], shape [n, 3].
        faces: Shape [m, 3].
        normals: Of unit length, shape [n, 3].
        uvs: In tiles, v up, shape [n, 2].
    """

    vertices: Floats
    faces: Ints
    normals: Floats
    uvs: Floats


def _bytes(surface: Surface) -> int:
    return sum(array.nbytes for array in surface)


_surfaces: Recent[bytes, Surface] = Recent(_KEPT_BYTES, _bytes)


class Outline(NamedTuple):
    """What is known of a part without drawing it again.

    Args:
        extent_cm: The longest along an axis.
        digest: Of its vertices, faces and shape.
    """

    extent_cm: float
    digest: bytes


_outlines: Recent[Key, Outline] = Recent(_KEPT_OUTLINES, lambda _: 1)


class Drawing:
    """A part that is drawn once, or not at all where its surface is kept.

    Args:
        make: Draws it, in its asset's frame.
    """

    def __init__(self, make: Callable[[], trimesh.Trimesh]) -> None:
        self._make = make
        self._mesh: trimesh.Trimesh | None = None
        key = key_of(make)
        self.outline = self._outlined() if key is None else _outlines.get(key, self._outlined)

    def _outlined(self) -> Outline:
        mesh = self.mesh()
        digest = hashlib.blake2b(repr(mesh.metadata.get("shape")).encode(), digest_size=16)
        for array in (mesh.vertices, mesh.faces):
            digest.update(np.ascontiguousarray(array).data)
        return Outline(float(np.ptp(mesh.vertices, axis=0).max()), digest.digest())

    def mesh(self) -> trimesh.Trimesh:
        """The mesh."""
        if self._mesh is None:
            self._mesh = self._make()
        return self._mesh

    def drop(self) -> None:
        """Forgets the mesh; it is drawn again for who asks again."""
        self._mesh = None


def finished(
    drawing: Drawing, tile_cm: float, *, grain: bool = False, smallest_cm: float = np.inf
) -> Surface:
    """A part with normals and texture coordinates.

    Args:
        drawing: Of the part.
        tile_cm: Edge of one tile of its texture.
        grain: Whether the texture's u runs along the part's length.
        smallest_cm: Parts that are longer are bevelled.

    Returns:
        Arrays that cannot be written to: the same part gives the same ones.
    """
    key = finished_key(drawing, tile_cm, grain=grain, smallest_cm=smallest_cm)
    return _surfaces.get(key, lambda: _fixed(drawing.mesh(), tile_cm, grain, smallest_cm))


def finished_key(
    drawing: Drawing, tile_cm: float, *, grain: bool = False, smallest_cm: float = np.inf
) -> bytes:
    """What tells a finished part from others, without finishing it; arguments as of `finished`."""
    how = (float(tile_cm), bool(grain), float(smallest_cm))
    return drawing.outline.digest + repr(how).encode()


def _fixed(mesh: trimesh.Trimesh, tile_cm: float, grain: bool, smallest_cm: float) -> Surface:
    surface = _finished(mesh, tile_cm, grain, smallest_cm)
    for array in surface:
        array.setflags(write=False)
    return surface


def _finished(mesh: trimesh.Trimesh, tile_cm: float, grain: bool, smallest_cm: float) -> Surface:
    vertices, faces, soft = bevelled(mesh, smallest_cm)
    corner_normals = split_normals(vertices, faces, _BEVEL_CREASE_DEG if soft else CREASE_DEG)
    uvs, chart = _projected(mesh, vertices, faces, tile_cm, grain)
    return _merged(vertices, faces, corner_normals, uvs, chart)


def _merged(vertices: Floats, faces: Ints, normals: Floats, uvs: Floats, chart: Ints) -> Surface:
    """Corners as vertices; those of a vertex that agree in normal and chart stay one."""
    steps = np.rint(511.0 * normals).astype(np.int64) + 512
    key = faces.reshape(-1)
    for direction in range(3):
        key = key * 1024 + steps[:, direction]
    _, first, index = np.unique(key * 16 + chart, return_index=True, return_inverse=True)
    corners = faces.reshape(-1)[first]
    return Surface(vertices[corners], index.reshape(-1, 3), normals[first], uvs[first])


def completed(mesh: trimesh.Trimesh, tile_cm: float) -> trimesh.Trimesh:
    """A foreign mesh with the normals and texture coordinates it lacks.

    The same one if it lacks none, or has a colour for every vertex.

    Args:
        mesh: Its visual keeps its material, and its texture coordinates if it has any.
        tile_cm: Edge of one tile of the coordinates that are made.
    """
    visual: Any = mesh.visual
    uv = getattr(visual, "uv", None)
    has_normals = "vertex_normals" in mesh._cache
    if (has_normals and uv is not None) or visual.kind == "vertex":
        return mesh
    vertices, faces = np.asarray(mesh.vertices, float), np.asarray(mesh.faces, np.int64)
    corners = faces.reshape(-1)
    if has_normals:
        normals = np.asarray(mesh.vertex_normals)[corners]
    else:
        normals = split_normals(vertices, faces, CREASE_DEG)
    if uv is None:
        uvs, chart = _projected(mesh, vertices, faces, tile_cm, False)
    else:
        uvs, chart = np.asarray(uv)[corners], np.zeros(len(corners), np.int64)
    surface = _merged(vertices, faces, normals, uvs, chart)
    if isinstance(visual, TextureVisuals):
        visual = TextureVisuals(uv=surface.uvs, material=visual.material)
    return trimesh.Trimesh(
        surface.vertices,
        surface.faces,
        vertex_normals=surface.normals,
        visual=visual,
        metadata=mesh.metadata,
        process=False,
    )


def joined(surfaces: list[Surface]) -> Surface:
    """Several as one."""
    starts = np.cumsum([0, *(len(s.vertices) for s in surfaces[:-1])])
    return Surface(
        np.concatenate([s.vertices for s in surfaces]),
        np.concatenate([s.faces + start for s, start in zip(surfaces, starts, strict=True)]),
        np.concatenate([s.normals for s in surfaces]),
        np.concatenate([s.uvs for s in surfaces]),
    )


def split_normals(vertices: Floats, faces: Ints, crease_deg: float) -> Floats:
    """A normal for every corner, shape [3 m, 3], split where faces meet at a crease.

    A corner takes the mean of the faces around its vertex that lean away from its own face by less
    than the crease, weighted by area and by their angle there.
    """
    tri = vertices[faces]
    sides = np.roll(tri, -1, axis=1) - tri
    cross = np.cross(sides[:, 0], -sides[:, 2])
    twice = np.linalg.norm(cross, axis=1)
    unit = cross / np.maximum(twice, 1e-12)[:, None]
    edges = sides / np.maximum(np.linalg.norm(sides, axis=2), 1e-12)[..., None]
    angle = np.arccos(np.clip(-(edges * np.roll(edges, 1, axis=1)).sum(2), -1.0, 1.0))
    weight = (angle * twice[:, None]).reshape(-1)

    number = _places(vertices)[faces].reshape(-1)
    order = np.argsort(number, kind="stable")
    counts = np.bincount(number)
    starts = np.cumsum(counts) - counts
    around = counts[number[order]]
    first = np.repeat(order, around)
    offset = np.arange(len(first)) - np.repeat(np.cumsum(around) - around, around)
    second = order[np.repeat(starts[number[order]], around) + offset]

    face = np.repeat(np.arange(len(faces)), 3)
    near = (unit[face[first]] * unit[face[second]]).sum(1) > np.cos(np.radians(crease_deg))
    first, second = first[near], second[near]
    pull = unit[face[second]] * weight[second][:, None]
    total = np.stack([np.bincount(first, pull[:, k], len(face)) for k in range(3)], axis=1)
    length = np.linalg.norm(total, axis=1)
    lost = length < 1e-9 * max(float(weight.max(initial=0.0)), 1e-12)
    total[lost], length[lost] = unit[face[lost]], 1.0
    flat = np.linalg.norm(total, axis=1) == 0.0
    total[flat], length[flat] = (0.0, 0.0, 1.0), 1.0
    return total / length[:, None]


def _places(vertices: Floats) -> Ints:
    """The same number for vertices at the same place."""
    scale = 1e5 / max(float(np.abs(vertices).max(initial=0.0)), 1e-9)
    steps = np.rint(vertices * scale).astype(np.int64) + 200_000
    key = (steps[:, 0] * 400_001 + steps[:, 1]) * 400_001 + steps[:, 2]
    return np.unique(key, return_inverse=True)[1].reshape(-1)


def _projected(
    mesh: trimesh.Trimesh, vertices: Floats, faces: Ints, tile_cm: float, grain: bool
) -> tuple[Floats, Ints]:
    """Coordinates [tiles] of every corner, shape [3 m, 2], and the number of its chart below 16."""
    shape = mesh.metadata.get("shape")
    axis = _axis_of(np.asarray(mesh.vertices)) if shape in _ROUND else None
    if axis is not None:
        return _around(vertices, faces, axis, tile_cm, grain)
    frame = np.eye(3)
    if shape == "box" and len(mesh.vertices) == 8:
        corners = np.asarray(mesh.vertices)
        edges = corners[[4, 2, 1]] - corners[0]
        edges = edges / np.linalg.norm(edges, axis=1)[:, None]
        if np.abs(edges @ edges.T - np.eye(3)).max() < 0.2 and np.linalg.det(edges) > 0:
            frame = edges
    return _boxed(vertices, faces, frame, tile_cm, grain)


def _boxed(
    vertices: Floats, faces: Ints, frame: Floats, tile_cm: float, grain: bool
) -> tuple[Floats, Ints]:
    """Along the axis of `frame` (its rows) that each face looks along most."""
    at = vertices @ frame.T
    tri = at[faces]
    normal = np.cross(tri[:, 1] - tri[:, 0], tri[:, 2] - tri[:, 0])
    across = np.abs(normal).argmax(axis=1)
    ahead = np.take_along_axis(normal, across[:, None], axis=1)[:, 0] >= 0
    extents = np.ptp(at, axis=0)
    flat = np.zeros((len(faces), 3, 2))
    for d in range(3):
        if grain:
            u = max((e for e in range(3) if e != d), key=lambda e: (round(extents[e], 3), -e))
        else:
            u = (1, 0, 0)[d]
        v = 3 - d - u
        # v = n x u: the texture is never mirrored
        sign = 1.0 if (d, u) in ((0, 1), (1, 2), (2, 0)) else -1.0
        for side in (False, True):
            here = (across == d) & (ahead == side)
            turned = sign if side else -sign
            part = tri[here]
            if grain:
                flat[here] = np.stack([part[:, :, u], turned * part[:, :, v]], axis=2)
            else:
                flat[here] = np.stack([turned * part[:, :, u], part[:, :, v]], axis=2)
    chart = np.repeat(2 * across + ahead, 3)
    return flat.reshape(-1, 2) / tile_cm, chart.astype(np.int64)


def _axis_of(vertices: Floats) -> Floats | None:
    """Unit axis about which points lie evenly; None if there is none, or any would do."""
    middle = vertices - vertices.mean(0)
    moments, axes = np.linalg.eigh(middle.T @ middle)
    low, mid, high = moments
    if high - low < _EVEN * high:
        return None
    if mid - low < _EVEN * high:
        axis = axes[:, 2]
    elif high - mid < _EVEN * high:
        axis = axes[:, 0]
    else:
        return None
    return axis * np.sign(axis[np.abs(axis).argmax()])


def _around(
    vertices: Floats, faces: Ints, axis: Floats, tile_cm: float, grain: bool
) -> tuple[Floats, Ints]:
    """Around an axis where faces look away from it, along it elsewhere."""
    middle = vertices.mean(0)
    helper = np.eye(3)[np.abs(axis).argmin()]
    x = np.cross(helper, axis)
    x /= np.linalg.norm(x)
    y = np.cross(axis, x)
    at = np.stack([(vertices - middle) @ x, (vertices - middle) @ y, vertices @ axis], axis=1)
    tri = at[faces]
    normal = np.cross(tri[:, 1] - tri[:, 0], tri[:, 2] - tri[:, 0])
    end = np.abs(normal[:, 2]) > 0.75 * np.linalg.norm(normal, axis=1)
    radius = np.hypot(tri[..., 0], tri[..., 1])
    centre = tri.mean(axis=1)
    facing = np.arctan2(centre[:, 1], centre[:, 0])[:, None]
    # On the axis an angle says nothing: its corner stands in the middle of its face.
    turn = np.where(radius > 1e-6, np.arctan2(tri[..., 1], tri[..., 0]) - facing, 0.0)
    turn = (turn + np.pi) % (2.0 * np.pi) - np.pi + facing
    round_cm = 2.0 * np.pi * float(np.median(radius[radius > 1e-6])) if radius.any() else tile_cm
    tiles = round_cm / tile_cm
    around = turn / (2.0 * np.pi) * (round(tiles) if tiles > 0.75 else tiles)
    along = tri[..., 2] / tile_cm
    shell = np.stack([along, -around] if grain else [around, along], axis=2)
    side = np.sign(normal[:, 2])[:, None]
    cap = np.stack([tri[..., 0] * side, tri[..., 1]], axis=2) / tile_cm
    uvs = np.where(end[:, None, None], cap, shell)
    # The seam, where the angle jumps, is a chart of its own.
    over = (turn > np.pi - 1e-6) * 1 + (turn < 1e-6 - np.pi) * 2
    chart = np.where(end[:, None], 4 + (side > 0), over)
    return uvs.reshape(-1, 2), np.broadcast_to(chart, (len(faces), 3)).reshape(-1).astype(np.int64)
