"""Bevels: boxes and cylinders with an edge that catches the light, as all real ones have.

Only what is looked at is bevelled: colliders, masses and distance fields are those of the sharp
shape. A bevel is worked out from the corners of a finished mesh, so that one that was turned,
stretched or tapered has it, too, and everywhere of one width.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray
import trimesh

Floats = NDArray[np.float64]
Faces = NDArray[np.int64]

_SHARE = 0.12
"""Of the shortest edge of a box, or the radius or length of a rod: the widest bevel."""
_BASE_CM, _PER_CM = 0.25, 0.004
"""Width of the bevel of a large thing: so much, and this share of its longest edge."""
_THINNEST_CM = 0.25
"""Sheets and lines thinner than this stay sharp."""


def bevelled(mesh: trimesh.Trimesh, smallest_cm: float) -> tuple[Floats, Faces, bool]:
    """Vertices and faces of a mesh, bevelled if it is a box or a cylinder, and whether it is.

    Args:
        mesh: Any.
        smallest_cm: What is nowhere longer stays as it is.
    """
    vertices, faces = np.asarray(mesh.vertices, float), np.asarray(mesh.faces, np.int64)
    shape = mesh.metadata.get("shape")
    if float(np.ptp(vertices, axis=0).max()) > smallest_cm:
        if shape == "box" and len(vertices) == 8:
            return _box(vertices) or (vertices, faces, False)
        if shape == "cylinder" and len(faces) == 2 * (len(vertices) - 2):
            return _rod(vertices) or (vertices, faces, False)
    return vertices, faces, False


def _width(shortest: float, longest: float) -> float:
    return min(_SHARE * shortest, _BASE_CM + _PER_CM * longest)


@cache
def _box_faces() -> Faces:
    """Faces of a bevelled box whose vertex 3 i + d is corner i, drawn back on the face across d.

    Bits 4, 2 and 1 of a corner's number say where it is along x, y and z.
    """
    bits = np.array([[i >> 2 & 1, i >> 1 & 1, i & 1] for i in range(8)])
    place = (2.0 * bits - 1.0)[:, None, :] * (1.0 - 0.2 * (1.0 - np.eye(3)))
    points = place.reshape(-1, 3)
    loops: list[list[int]] = []
    for d in range(3):
        a, b = (1 << 2 - e for e in range(3) if e != d)
        for side in (0, 1 << 2 - d):
            loops.append([3 * i + d for i in (side, side + a, side + a + b, side + b)])
        for i in range(8):
            if not i & 1 << 2 - d:
                j, (p, q) = i + (1 << 2 - d), [e for e in range(3) if e != d]
                loops.append([3 * i + p, 3 * j + p, 3 * j + q, 3 * i + q])
    loops += [[3 * i, 3 * i + 1, 3 * i + 2] for i in range(8)]
    out: list[list[int]] = []
    for loop in loops:
        p, q, r = points[loop[:3]]
        if np.cross(q - p, r - p) @ points[loop].mean(0) < 0:
            loop = loop[::-1]
        out += [[loop[0], loop[k], loop[k + 1]] for k in range(1, len(loop) - 1)]
    return np.array(out)


def _box(corners: Floats) -> tuple[Floats, Faces, bool] | None:
    """A hexahedron with corners in the order of `trimesh.creation.box`."""
    edges = np.stack([corners[np.arange(8) ^ (1 << 2 - d)] - corners for d in range(3)], axis=1)
    lengths = np.linalg.norm(edges, axis=2)
    shortest = float(lengths.min())
    if shortest < _THINNEST_CM:
        return None
    back = edges / lengths[..., None] * _width(shortest, float(lengths.max()))
    points = corners[:, None, :] + back.sum(axis=1)[:, None, :] - back
    faces = _box_faces()
    x, y, z = edges[0]
    return points.reshape(-1, 3), faces if np.cross(x, y) @ z > 0 else faces[:, ::-1], True


def _rod(vertices: Floats) -> tuple[Floats, Faces, bool] | None:
    """A cylinder with vertices in the order of `trimesh.creation.cylinder`."""
    n = len(vertices) // 2 - 1
    low_middle, high_middle = vertices[0], vertices[3]
    index = np.r_[1, 4 + 2 * np.arange(n - 1)], np.r_[2, 5 + 2 * np.arange(n - 1)]
    low, high = vertices[index[0]], vertices[index[1]]
    axis = high_middle - low_middle
    length = float(np.linalg.norm(axis))
    radius = float(np.linalg.norm(low - low_middle, axis=1).min())
    if min(2.0 * radius, length) < 2.0 * _THINNEST_CM:
        return None
    width = _width(min(radius, length), max(2.0 * radius, length))
    along = axis / length * width
    caps = [
        rim + (middle - rim) * (width / np.linalg.norm(middle - rim, axis=1))[:, None]
        for rim, middle in ((low, low_middle), (high, high_middle))
    ]
    rings = [caps[0], low + along, high - along, caps[1]]
    points = np.concatenate([*rings, [low_middle, high_middle]])
    k = np.arange(n)
    after = (k + 1) % n
    faces = [np.stack([np.full(n, 4 * n), after, k], 1)]
    for r in range(3):
        a, b, c, d = r * n + k, r * n + after, (r + 1) * n + after, (r + 1) * n + k
        faces += [np.stack([a, b, c], 1), np.stack([a, c, d], 1)]
    faces.append(np.stack([np.full(n, 4 * n + 1), 3 * n + k, 3 * n + after], 1))
    out = np.concatenate(faces)
    turn = np.cross(low[0] - low_middle, low[1] - low_middle) @ axis
    return points, out if turn > 0 else out[:, ::-1], True
