"""Shapes and bodies of a scene as plain arrays, as the simulations of this project take them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.breaking.stances import Stance, stances
from esg.engines.breaking.swap import Brittle, brittle
from esg.engines.joints import WORLD, Joint
from esg.engines.scene import Floats, Shape, SimScene
from esg.engines.worlds import moving
from esg.units import quat_rotate

Ints = NDArray[np.int32]

Hull = tuple[Floats, Ints]
"""Vertices, shape [n, 3], and outward triangles, shape [m, 3]."""


@dataclass(frozen=True)
class SceneShapes:
    """What of a scene is the same in all its worlds (S shapes).

    Args:
        gravity: [m/s^2], shape [3].
        first: Body b owns the shapes first[b] .. first[b + 1] - 1, shape [B + 1].
        kind: Shape kinds, length S.
        size: As `Shape.size` [m], shape [S, 3].
        scale: In the convention of Newton's support maps [m], shape [S, 3].
        half: Half extents around the shape's centre [m], shape [S, 3].
        origin: Shape frame in the body frame [m], shape [S, 3].
        centre: Shape centre in the body frame [m], shape [S, 3].
        offset: Shape centre in the shape frame [m], shape [S, 3].
        rotation: Orientation (x, y, z, w) in the body frame, shape [S, 4].
        hulls: Vertices [n, 3] and triangles [m, 3] of convex shapes, None for others.
        dynamic: Bodies that move, shape [B]; so `static`, `collides` and `wheeled`.
        inertia: Body axes [kg m^2], shape [B, 3, 3]; the unit tensor for what does not move.
        mass: [kg], 1 where the scene gives none, shape [B].
        joints: Of the scene.
        ends: Body of each joint's parent, -1 for the world, and of its child.
        brittle: What breaks.
        stances: Who changes his posture.
    """

    gravity: tuple[float, float, float]
    first: Ints
    kind: tuple[str, ...]
    size: Floats
    scale: Floats
    half: Floats
    origin: Floats
    centre: Floats
    offset: Floats
    rotation: Floats
    hulls: tuple[Hull | None, ...]
    dynamic: NDArray[np.bool_]
    static: NDArray[np.bool_]
    collides: NDArray[np.bool_]
    wheeled: NDArray[np.bool_]
    inertia: Floats
    mass: Floats
    joints: tuple[Joint, ...] = ()
    ends: tuple[tuple[int, int], ...] = ()
    brittle: tuple[Brittle, ...] = ()
    stances: tuple[Stance, ...] = ()

    @staticmethod
    def of(scene: SimScene) -> SceneShapes:
        first, kind, hulls = [0], [], []
        rows: dict[str, list[Any]] = {
            n: [] for n in ("size", "scale", "half", "origin", "centre", "offset", "rotation")
        }
        for body in scene.bodies:
            for shape in body.shapes:
                scale, offset, half = _dimensions(shape)
                kind.append(shape.kind)
                origin = np.array(shape.position)
                turned = quat_rotate(np.array(shape.quaternion, float), offset)
                values = (shape.size, scale, half, origin, origin + turned, offset,
                          shape.quaternion)  # fmt: skip
                for row, value in zip(rows.values(), values, strict=True):
                    row.append(value)
                hulls.append(hull(np.array(shape.vertices)) if shape.kind == "convex" else None)
            first.append(len(kind))
        bodies = scene.bodies
        dynamic = moving(scene)
        inertia = [
            np.array(b.inertia, float) if m else np.eye(3)
            for b, m in zip(bodies, dynamic, strict=True)
        ]
        return SceneShapes(
            gravity=scene.gravity,
            first=np.array(first, np.int32),
            kind=tuple(kind),
            **{
                n: np.array(v, float).reshape(len(kind), 4 if n == "rotation" else 3)
                for n, v in rows.items()
            },
            hulls=tuple(hulls),
            dynamic=dynamic,
            static=np.array([b.static for b in bodies], bool),
            collides=np.array([b.collides for b in bodies], bool),
            wheeled=np.array([b.wheeled for b in bodies], bool),
            inertia=np.array(inertia, float).reshape(-1, 3, 3),
            mass=np.array([b.mass if b.mass > 0.0 else 1.0 for b in bodies]),
            joints=scene.joints,
            ends=tuple(
                (-1 if j.parent == WORLD else scene.index(j.parent), scene.index(j.child))
                for j in scene.joints
            ),
            brittle=brittle(scene),
            stances=stances(scene),
        )

    @property
    def n_bodies(self) -> int:
        return len(self.dynamic)


def _dimensions(shape: Shape) -> tuple[tuple[float, float, float], Floats, Floats]:
    """Newton's scale, the centre in the shape's frame [m], and half extents around it [m]."""
    x, y, z = shape.size
    zero = np.zeros(3)
    if shape.kind == "sphere":
        return (x, x, x), zero, np.array([x, x, x])
    if shape.kind == "box":
        return (x, y, z), zero, np.array([x, y, z])
    if shape.kind == "capsule":
        return (x, z, 0.0), zero, np.array([x, x, z + x])
    if shape.kind == "cylinder":
        return (x, z, 0.0), zero, np.array([x, x, z])
    points = np.array(shape.vertices)
    centre = points.mean(axis=0)
    return (1.0, 1.0, 1.0), centre, np.abs(points - centre).max(axis=0)


def hull(points: Floats) -> Hull:
    """Convex hull: its vertices, shape [n, 3], and outward triangles, shape [m, 3]."""
    from scipy.spatial import ConvexHull

    found = ConvexHull(points)
    used = found.vertices
    index = np.full(len(points), -1, np.int32)
    index[used] = np.arange(len(used))
    vertices = points[used]
    faces = index[found.simplices]
    corners = vertices[faces]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = np.einsum("ij,ij->i", cross, found.equations[:, :3]) < 0.0
    faces[inward] = faces[inward][:, [0, 2, 1]]
    return vertices, faces
