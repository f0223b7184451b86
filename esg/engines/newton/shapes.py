"""Collision shapes as Newton takes them."""

from __future__ import annotations

from typing import Any

import numpy as np

from esg.engines.shapes import Hull


def add_shape(
    builder: Any,
    body: int,
    kind: str,
    size: tuple[float, ...],
    position: tuple[float, ...],
    quaternion: tuple[float, ...],
    convex: Hull | None,
    config: Any,
    meshes: dict[bytes, Any],
) -> int:
    """Adds a shape to a body of a Newton builder and returns its number.

    Args:
        builder: `newton.ModelBuilder`.
        body: Its number, -1 for the world.
        kind: As `Shape.kind`.
        size: As `Shape.size` [m].
        position: In the body's frame [m].
        quaternion: Orientation (x, y, z, w) in the body's frame.
        convex: Of convex shapes.
        config: `newton.ModelBuilder.ShapeConfig`.
        meshes: Hulls met so far; shapes of equal vertices share one.
    """
    import newton
    import warp as wp

    pose = wp.transform(wp.vec3(*position), wp.quat(*quaternion))
    x, y, z = size
    if kind == "sphere":
        return builder.add_shape_sphere(body, xform=pose, radius=x, cfg=config)
    if kind == "box":
        return builder.add_shape_box(body, xform=pose, hx=x, hy=y, hz=z, cfg=config)
    if kind == "capsule":
        return builder.add_shape_capsule(body, xform=pose, radius=x, half_height=z, cfg=config)
    if kind == "cylinder":
        return builder.add_shape_cylinder(body, xform=pose, radius=x, half_height=z, cfg=config)
    assert convex is not None
    vertices, faces = convex[0].astype(np.float32), convex[1].reshape(-1).astype(np.int32)
    key = vertices.tobytes()
    if key not in meshes:
        # Masses and inertias are given; Newton's own would cost a kernel launch per hull.
        meshes[key] = newton.Mesh(vertices, faces, compute_inertia=False)
    return builder.add_shape_convex_hull(body, xform=pose, mesh=meshes[key], cfg=config)
