"""What is drawn: triangle meshes fixed to bodies, to wheels that turn on them, or to the world."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Look
from esg.engines.wheels import about_axle
from esg.units import quat_multiply, quat_rotate


@dataclass(frozen=True)
class Turning:
    """What turns on a body: wheel number `index` of the scene, about Y of the body through `axle`.

    Args:
        index: Among all wheels of the scene, in the order of their bodies.
        axle: In the body's frame [m], shape [3].
    """

    index: int
    axle: tuple[float, float, float]


@dataclass(frozen=True)
class Part:
    """One coloured triangle mesh, fixed to a body or (body -1) to the world.

    Args:
        body: Index of the body, -1 for the world.
        vertices: In the body's frame [m], shape [n, 3].
        faces: Vertex indices, counter-clockwise seen from outside, shape [m, 3].
        color: sRGB in [0, 1].
        wheel: The wheel it is a part of, which turns on the body.
        look: Its surface; None for a plain one in its colour.
        normals: Unit normals at the vertices, shape [n, 3]; None for flat faces.
        uvs: Texture coordinates at the vertices in tiles, v up, shape [n, 2]; None if untextured.
        name: Of the part in its asset.
    """

    body: int
    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    color: tuple[float, float, float]
    wheel: Turning | None = None
    look: Look | None = None
    normals: NDArray[np.float64] | None = None
    uvs: NDArray[np.float64] | None = None
    name: str = ""


class Movers:
    """What has a pose of its own: all bodies, and after them the wheels that turn on them.

    Args:
        parts: Meshes of the scene.
        n_bodies: Number of bodies B that `Part.body` refers to.
    """

    def __init__(self, parts: Iterable[Part], n_bodies: int) -> None:
        self._n_bodies = n_bodies
        turning = {p.wheel: p.body for p in parts if p.wheel is not None}
        self._wheels = sorted(turning, key=lambda w: w.index)
        self._carriers = [turning[w] for w in self._wheels]
        self._axles = np.array([w.axle for w in self._wheels]).reshape(-1, 3)
        self._indices = [w.index for w in self._wheels]

    def __len__(self) -> int:
        return self._n_bodies + len(self._wheels)

    @property
    def bodies(self) -> list[int]:
        """Body of everything that has a pose."""
        return [*range(self._n_bodies), *self._carriers]

    def of(self, part: Part) -> int:
        """Index of the pose that moves a part; -1 for the world."""
        if part.wheel is None:
            return part.body
        return self._n_bodies + self._wheels.index(part.wheel)

    def poses(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None = None
    ) -> tuple[NDArray[Any], NDArray[Any]]:
        """Poses of everything for poses of the bodies.

        Args:
            position: Body origins [m], shape [..., B, 3].
            quaternion: (x, y, z, w), shape [..., B, 4].
            angles: Of all wheels of the scene [rad], shape [..., W]; None for none turned.

        Returns:
            Positions and quaternions of bodies and wheels, both in the body's frame at angle 0.
        """
        if not self._wheels:
            return position, quaternion
        at, q = position[..., self._carriers, :], quaternion[..., self._carriers, :]
        turned = q
        if angles is not None:
            turned = quat_multiply(q, about_axle(angles[..., self._indices]))
        at = at + quat_rotate(q, self._axles) - quat_rotate(turned, self._axles)
        return (
            np.concatenate([position, at], axis=-2),
            np.concatenate([quaternion, turned], axis=-2),
        )
