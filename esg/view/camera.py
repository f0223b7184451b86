"""Where to stand: cameras that frame the action, and projection of points onto the picture."""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

EDGE = 0.97
"""Points spread over a picture reach so far out from its middle."""
FOV_RAD = 0.62
"""Vertical field of view: about a 60 mm lens, little distortion at the edges."""


@dataclass(frozen=True)
class Camera:
    """A pinhole camera that looks from `eye` to `target`, world Z up.

    Args:
        eye: Position [m], shape [3].
        target: Point in the middle of the picture [m], shape [3].
        fov: Vertical field of view [rad].
    """

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    fov: float = FOV_RAD

    @property
    def axes(self) -> Floats:
        """Columns right, up, backward in the world, shape [3, 3]."""
        # Written out: directors ask thousands of times, and np.cross is slow for single vectors.
        x, y, z = (t - e for t, e in zip(self.target, self.eye, strict=True))
        length = math.sqrt(x * x + y * y + z * z)
        x, y, z = x / length, y / length, z / length
        flat = math.sqrt(x * x + y * y)
        u, v = y / flat, -x / flat
        return np.array([[u, v * z, -x], [v, -u * z, -y], [0.0, u * y - v * x, -z]])

    def spread(self, rays: tuple[int, int], share: float, aspect: float = 1.5) -> Floats:
        """Points all over the picture, at a share of the target's depth [m], shape [n, 3].

        Args:
            rays: Points along its width and height.
            share: Of the way to the target.
            aspect: Width over height.
        """
        depth = share * float(np.linalg.norm(np.subtract(self.target, self.eye)))
        high = depth * math.tan(self.fov / 2)
        x, y = np.meshgrid(*(np.linspace(-EDGE, EDGE, n) for n in rays))
        local = np.stack([aspect * high * x, high * y, np.full(x.shape, -depth)], axis=-1)
        return np.asarray(self.eye) + local.reshape(-1, 3) @ self.axes.T

    def quaternion(self) -> Floats:
        """Orientation (x, y, z, w) of a camera that looks along its -Z with +Y up, shape [4]."""
        from scipy.spatial.transform import Rotation

        return Rotation.from_matrix(self.axes).as_quat()

    def project(self, points: Floats, width: int, height: int) -> tuple[Floats, NDArray[np.bool_]]:
        """Pixel positions of world points.

        Args:
            points: World points [m], shape [n, 3].
            width, height: Of the picture [px].

        Returns:
            Pixels (x right, y down), shape [n, 2], and whether each point is in front of the
            camera, shape [n].
        """
        local = (np.asarray(points, float) - np.asarray(self.eye)) @ self.axes
        depth = -local[:, 2]
        ahead = depth > 1e-3
        focal = 0.5 * height / math.tan(self.fov / 2)
        safe = np.where(ahead, depth, 1.0)
        x = 0.5 * width + focal * local[:, 0] / safe
        y = 0.5 * height - focal * local[:, 1] / safe
        return np.stack([x, y], axis=1), ahead


def frame_points(
    points: Floats,
    azimuth: float,
    elevation: float,
    aspect: float,
    fill: float = 0.86,
    fov: float = FOV_RAD,
) -> Camera:
    """The camera in a given direction that just contains all points.

    Args:
        points: World points [m], shape [n, 3].
        azimuth: Direction from the points to the camera, counter-clockwise from +X [rad].
        elevation: Of the camera above the horizon [rad].
        aspect: Width over height.
        fill: Part of the picture's half size that the points may use.
        fov: Vertical field of view [rad].
    """
    points = np.asarray(points, float)
    direction = np.array(
        [
            math.cos(elevation) * math.cos(azimuth),
            math.cos(elevation) * math.sin(azimuth),
            math.sin(elevation),
        ]
    )
    center = 0.5 * (points.min(axis=0) + points.max(axis=0))
    tan_y = math.tan(fov / 2) * fill
    tan_x = tan_y * aspect
    camera = Camera(tuple(center + direction), tuple(center), fov)  # type: ignore[arg-type]  # three floats
    for _ in range(3):
        axes = camera.axes
        local = (points - center) @ axes
        # A point at depth d - z is inside when |x| <= tan_x (d - z); the largest d decides.
        need = np.maximum(np.abs(local[:, 0]) / tan_x, np.abs(local[:, 1]) / tan_y) + local[:, 2]
        distance = max(float(need.max()), 0.3)
        eye = center + direction * distance
        camera = Camera(tuple(eye), tuple(center), fov)  # type: ignore[arg-type]  # three floats
        # Perspective shifts the centre of what is seen: re-centre on the projected bounding box.
        depth = distance - local[:, 2]
        offset_x = local[:, 0] / depth
        offset_y = local[:, 1] / depth
        shift = (
            axes[:, 0] * 0.5 * (offset_x.min() + offset_x.max()) * distance
            + axes[:, 1] * 0.5 * (offset_y.min() + offset_y.max()) * distance
        )
        center = center + shift
    return camera


def box_corners(
    position: Floats, quaternion: Floats, half: tuple[float, float, float], offset: Floats
) -> Floats:
    """World corners of a body's bounding box, shape [8, 3].

    Args:
        position: Centre of mass [m], shape [3].
        quaternion: (x, y, z, w), shape [4].
        half: Half extents of the asset's box [m].
        offset: From the centre of mass to the asset's bottom centre, body axes [m], shape [3].
    """
    from esg.units import quat_rotate

    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (0, 2)], float)
    local = signs * np.asarray(half) + np.asarray(offset)
    return np.asarray(position, float) + quat_rotate(np.asarray(quaternion, float), local)
