"""Closed triangle meshes of the primitives that builders draw with (cm)."""

from __future__ import annotations

from collections.abc import Sequence
import math
from typing import Any

import numpy as np
from scipy.interpolate import PchipInterpolator
import shapely
from shapely.geometry import Polygon
import trimesh
from trimesh.transformations import quaternion_matrix, rotation_matrix


def _rotate(mesh: trimesh.Trimesh, quat_xyzw: Sequence[float]) -> None:
    x, y, z, w = quat_xyzw
    if abs(w) < 1.0 - 1e-12:
        mesh.apply_transform(quaternion_matrix([w, x, y, z]))


def box(size: Any, center: Any, quat: Any = (0, 0, 0, 1)) -> trimesh.Trimesh:
    """Box of full extents `size`."""
    mesh = trimesh.creation.box(extents=size)
    _rotate(mesh, quat)
    mesh.apply_translation(center)
    return mesh


def rod(radius: float, start: Any, end: Any, sections: int = 28) -> trimesh.Trimesh:
    """Cylinder between two points."""
    return trimesh.creation.cylinder(
        radius, segment=np.array([start, end], float), sections=sections
    )


def ball(radius: float, center: Any, scale: Any = (1, 1, 1), detail: int = 3) -> trimesh.Trimesh:
    """Sphere or axis-aligned ellipsoid."""
    mesh = trimesh.creation.icosphere(subdivisions=detail, radius=radius)
    mesh.apply_scale(np.asarray(scale, float))
    mesh.apply_translation(center)
    return mesh


def _axis_matrix(axis: str) -> np.ndarray | None:
    if axis == "x":
        return np.asarray(rotation_matrix(math.pi / 2, [0, 1, 0]))
    if axis == "y":
        return np.asarray(rotation_matrix(-math.pi / 2, [1, 0, 0]))
    return None


def lathe(
    profile: Any, center: Any = (0, 0, 0), smooth: int = 0, sections: int = 48, axis: str = "z"
) -> trimesh.Trimesh:
    """Surface of revolution of (radius, height) points; ends are closed on the axis.

    Args:
        profile: Points from bottom to top [cm], shape [n, 2].
        center: Translation after the revolution, shape [3].
        smooth: Number of resampled points of a monotone spline; 0 keeps the polyline.
        sections: Sides.
        axis: Axis of revolution.
    """
    points = np.asarray(profile, float)
    if smooth:
        t = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
        fine = np.linspace(0, t[-1], smooth)
        points = np.c_[
            PchipInterpolator(t, points[:, 0])(fine), PchipInterpolator(t, points[:, 1])(fine)
        ]
        points[:, 0] = np.maximum(points[:, 0], 0.0)
    if not np.allclose(points[0], points[-1]):
        points[0, 0] = points[-1, 0] = 0.0
    mesh = trimesh.creation.revolve(points, sections=sections)
    if mesh.volume < 0:
        mesh.invert()
    matrix = _axis_matrix(axis)
    if matrix is not None:
        mesh.apply_transform(matrix)
    mesh.apply_translation(center)
    mesh.metadata["shape"] = "lathe"
    return mesh


def extrude(
    polygon: Any, span: tuple[float, float], plane: str = "xz", soft: float = 0.0, holes: Any = ()
) -> trimesh.Trimesh:
    """Prism of a polygon in the named plane across `span` of the remaining axis."""
    shape = Polygon(polygon, [list(h) for h in holes])
    if soft:
        shape = shape.buffer(-soft).buffer(soft, quad_segs=6)
    shape = shapely.set_precision(shape, 1e-4)
    mesh = trimesh.creation.extrude_polygon(shape, span[1] - span[0], engine="manifold")
    v = np.asarray(mesh.vertices)
    depth = v[:, 2] + span[0]
    columns = {
        "xy": (v[:, 0], v[:, 1], depth),
        "xz": (v[:, 0], depth, v[:, 1]),
        "yz": (depth, v[:, 0], v[:, 1]),
    }[plane]
    mesh = trimesh.Trimesh(np.stack(columns, 1), mesh.faces, process=False)
    if mesh.volume < 0:
        mesh.invert()
    return mesh


def torus(major: float, minor: float, center: Any, axis: str = "z") -> trimesh.Trimesh:
    """Ring of the given radii."""
    mesh = trimesh.creation.torus(major, minor, major_sections=40, minor_sections=14)
    matrix = _axis_matrix(axis)
    if matrix is not None:
        mesh.apply_transform(matrix)
    mesh.apply_translation(center)
    return mesh


def cut(mesh: trimesh.Trimesh, tools: Sequence[trimesh.Trimesh]) -> trimesh.Trimesh:
    """Boolean difference."""
    return trimesh.boolean.difference([mesh, *tools], engine="manifold")


def join(meshes: Sequence[trimesh.Trimesh]) -> trimesh.Trimesh:
    """Boolean union."""
    return trimesh.boolean.union(list(meshes), engine="manifold")


def hull(points: Any) -> trimesh.Trimesh:
    """Convex hull of points, shape [n, 3]."""
    return trimesh.convex.convex_hull(np.asarray(points, float))


def lune(
    start: float, width: float, radius: float, thickness: float, center: Any
) -> trimesh.Trimesh:
    """A closed slice of a ball's cover between two meridians (angles in rad)."""
    n, m = 12, 24
    azimuth = start + np.linspace(0, width, n + 1)
    polar = np.linspace(0.02, math.pi - 0.02, m + 1)
    a, p = np.meshgrid(azimuth, polar, indexing="ij")
    d = np.stack([np.sin(p) * np.cos(a), np.sin(p) * np.sin(a), np.cos(p)], -1).reshape(-1, 3)
    count = len(d)
    vertices = np.concatenate([d * radius, d * (radius - thickness)]) + center
    index = np.arange(count).reshape(n + 1, m + 1)
    q = np.stack([index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]], -1)
    q = q.reshape(-1, 4)
    outer = np.concatenate([q[:, [0, 1, 2]], q[:, [0, 2, 3]]])
    border = np.concatenate([index[:, 0], index[-1, 1:], index[-2::-1, -1], index[0, -2:0:-1]])
    after = np.roll(border, -1)
    rim = np.concatenate(
        [
            np.stack([border, after + count, after], 1),
            np.stack([border, border + count, after + count], 1),
        ]
    )
    mesh = trimesh.Trimesh(
        vertices, np.concatenate([outer, outer[:, ::-1] + count, rim]), process=False
    )
    if mesh.volume < 0:
        mesh.invert()
    return mesh


def shell_patch(
    normal: Any,
    angle: float,
    radius: float,
    thickness: float,
    sides: int,
    center: Any,
    spin: float = 0.0,
) -> trimesh.Trimesh:
    """A closed regular spherical polygon lying on a ball (a panel of its cover).

    Args:
        normal: Direction of the panel's middle, shape [3].
        angle: Angular radius of its corners [deg].
        radius: Outer radius of the panel [cm].
        thickness: [cm].
        sides: Number of corners; 3 to 64.
        center: Centre of the ball [cm], shape [3].
        spin: Rotation about the normal [deg].
    """
    n = np.asarray(normal, float) / np.linalg.norm(normal)
    helper = np.array([0.0, 0, 1]) if abs(n[2]) < 0.9 else np.array([1.0, 0, 0])
    u = np.cross(n, helper)
    u /= np.linalg.norm(u)
    w = np.cross(n, u)
    per_side = max(1, 32 // sides)
    corners = np.radians(spin) + np.arange(sides + 1) * 2 * math.pi / sides
    a = math.radians(angle)
    ring = []
    for k in range(sides):
        p, q = (
            n * math.cos(a) + math.sin(a) * (u * math.cos(t) + w * math.sin(t))
            for t in corners[k : k + 2]
        )
        for f in np.arange(per_side) / per_side:
            d = p * (1 - f) + q * f
            ring.append(d / np.linalg.norm(d))
    ring = np.array(ring)
    m = len(ring)
    middle = [n]
    mids = [ring]
    for f in (0.66, 0.33):
        d = n * (1 - f) + ring * f
        mids.append(d / np.linalg.norm(d, axis=1, keepdims=True))
    outer = np.concatenate([*mids, middle])
    count = len(outer)
    vertices = np.concatenate([outer * radius, outer * (radius - thickness)]) + center
    faces = []
    for level in range(2):
        for k in range(m):
            a0, a1 = level * m + k, level * m + (k + 1) % m
            b0, b1 = a0 + m, a1 + m
            faces += [[a0, a1, b1], [a0, b1, b0]]
    tip = count - 1
    faces += [[2 * m + k, 2 * m + (k + 1) % m, tip] for k in range(m)]
    bottom = [[f[0] + count, f[2] + count, f[1] + count] for f in faces]
    rim = []
    for k in range(m):
        j = (k + 1) % m
        rim += [[k, k + count, j + count], [k, j + count, j]]
    mesh = trimesh.Trimesh(vertices, faces + bottom + rim, process=False)
    if mesh.volume < 0:
        mesh.invert()
    return mesh


def grown(mesh: trimesh.Trimesh, z: float, factor: float) -> trimesh.Trimesh:
    """The part of a mesh above height z, closed, a little larger in plan (a roof over glass)."""
    top = mesh.slice_plane([0, 0, z], [0, 0, 1], cap=True, engine="manifold")
    mid = top.bounds.mean(0)
    v = top.vertices.copy()
    v[:, :2] = (v[:, :2] - mid[:2]) * factor + mid[:2]
    v[:, 2] += 0.5
    top.vertices = v
    return top


def pillow(size: Any) -> trimesh.Trimesh:
    """Superellipsoid cushion standing on z = 0: nearly square in plan, thin at its rim."""
    mesh = trimesh.creation.icosphere(subdivisions=4)
    v = np.asarray(mesh.vertices)
    plan = (np.abs(v[:, 0]) ** 5 + np.abs(v[:, 1]) ** 5) ** 0.2
    flat = np.hypot(v[:, 0], v[:, 1])
    stretch = np.where(plan > 1e-9, flat / np.maximum(plan, 1e-9), 1.0)
    v = np.column_stack([v[:, 0] * stretch, v[:, 1] * stretch, v[:, 2]])
    mesh.vertices = v * (np.asarray(size) / 2) + [0, 0, size[2] / 2]
    return mesh
