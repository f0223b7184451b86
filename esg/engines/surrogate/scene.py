"""A scene's own arrays in the form of the kernels' `Model`; all its rollouts share them."""

from __future__ import annotations

from collections.abc import MutableMapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.newton.setup import quiet_warp
from esg.engines.scene import Floats
from esg.engines.shapes import Hull, SceneShapes


class SceneArrays:
    """What of a scene is the same in all worlds: shapes and bodies.

    Args:
        shapes: The scene.
        device: Warp device.
        meshes: Hulls by their points; those of other scenes are used again, new ones are added.
    """

    def __init__(
        self, shapes: SceneShapes, device: str, meshes: MutableMapping[bytes, Any] | None = None
    ) -> None:
        self.shapes, self.device = shapes, device
        self._shared = {} if meshes is None else meshes
        self.meshes: list[Any] = []
        s, single = shapes, np.float32
        kinds = _kinds()
        kind = [kinds[k] for k in s.kind]
        reach = np.zeros(max(1, s.n_bodies))
        for b in range(s.n_bodies):
            for i in range(s.first[b], s.first[b + 1]):
                far = np.linalg.norm(s.centre[i]) + np.linalg.norm(s.half[i])
                reach[b] = max(reach[b], float(far))
        radius = [_radius(*shape) for shape in zip(s.kind, s.scale, s.half, strict=True)]
        mesh = [self._mesh(h, o) for h, o in zip(s.hulls, s.offset, strict=True)]
        n = len(kind)
        self.fields: dict[str, NDArray[Any]] = {
            "first": s.first.astype(np.int32),
            "kind": np.array(kind or [0], np.int32),
            "scale": (s.scale if n else np.zeros((1, 3))).astype(single),
            "mesh": np.array(mesh or [[0.0] * 3], single),
            "position": (s.centre if n else np.zeros((1, 3))).astype(single),
            "rotation": (s.rotation if n else np.array([[0, 0, 0, 1.0]])).astype(single),
            "half": (s.half if n else np.zeros((1, 3))).astype(single),
            "radius": np.array(radius or [0.0], single),
            "reach": reach.astype(single),
            "dynamic": s.dynamic.astype(np.int32),
            "wheeled": s.wheeled.astype(np.int32),
            "inertia": s.inertia.astype(single),
            "inverse_inertia": np.linalg.inv(s.inertia).astype(single),
        }

    def _mesh(self, hull: Hull | None, offset: Floats) -> list[float]:
        """The address of a hull in the three floats that Newton's support maps take."""
        if hull is None:
            return [0.0, 0.0, 0.0]
        vertices = (hull[0] - offset).astype(np.float32)
        # Support maps read the points only: hulls of equal points share a mesh.
        key = vertices.tobytes()
        mesh = self._shared.get(key)
        if mesh is None:
            wp = quiet_warp()
            mesh = self._shared[key] = wp.Mesh(
                points=wp.array(vertices, dtype=wp.vec3, device=self.device),
                indices=wp.array(hull[1].reshape(-1), dtype=int, device=self.device),
                **({} if self.device == "cpu" else {"bvh_constructor": "lbvh"}),
            )
        self.meshes.append(mesh)
        bits = int(mesh.id)
        return [float(bits & 0x3FFFFF), float((bits >> 22) & 0x3FFFFF), float(bits >> 44)]


def _kinds() -> dict[str, int]:
    """Newton's numbers of the kinds of shapes."""
    from newton import GeoType

    return {
        "sphere": int(GeoType.SPHERE),
        "box": int(GeoType.BOX),
        "capsule": int(GeoType.CAPSULE),
        "cylinder": int(GeoType.CYLINDER),
        "convex": int(GeoType.CONVEX_MESH),
    }


def _radius(kind: str, scale: Floats, half: Floats) -> float:
    """Of the sphere around a shape's centre that holds it [m]."""
    if kind == "sphere":
        return float(scale[0])
    if kind == "capsule":
        return float(scale[0] + scale[1])
    if kind == "cylinder":
        return float(np.hypot(scale[0], scale[1]))
    return float(np.linalg.norm(half))
