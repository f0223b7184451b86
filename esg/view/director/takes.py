"""What a director decides: one camera's way through a scene."""

from __future__ import annotations

from dataclasses import dataclass, replace
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.view.camera import Camera
from esg.view.truth import Pinhole

Floats = NDArray[np.float64]

SENSOR_HEIGHT_MM = 24.0
"""Of the film that focal lengths are told for."""


@dataclass(frozen=True)
class Take:
    """One camera's way through a scene, at F instants.

    Args:
        kind: One of `esg.view.director.paths.KINDS`.
        time_s: Instants of the scene, ascending [s], shape [F].
        eye: Positions [m], shape [F, 3].
        target: Points in the middle of the picture [m], shape [F, 3].
        fov: Vertical field of view [rad]; a lens is not changed while it films.
    """

    kind: str
    time_s: Floats
    eye: Floats
    target: Floats
    fov: float

    def __len__(self) -> int:
        return len(self.time_s)

    @property
    def lens_mm(self) -> float:
        """Focal length on film of 36 x 24 mm."""
        return 0.5 * SENSOR_HEIGHT_MM / math.tan(self.fov / 2)

    def camera(self, index: int) -> Camera:
        """The camera at an instant."""
        return Camera(_vec(self.eye[index]), _vec(self.target[index]), self.fov)

    @property
    def cameras(self) -> list[Camera]:
        """The camera at every instant."""
        return [self.camera(k) for k in range(len(self))]

    def at(self, times: Any) -> Take:
        """The same way at other instants; before the first and after the last one it stands still.

        Args:
            times: Of the scene [s], shape [n].
        """
        from scipy.interpolate import CubicSpline

        wanted = np.asarray(times, float)
        inside = np.clip(wanted, self.time_s[0], self.time_s[-1])
        # A spline, or slow motion would show every knot as a jerk.
        eye, target = (CubicSpline(self.time_s, v)(inside) for v in (self.eye, self.target))
        return replace(self, time_s=wanted, eye=eye, target=target)

    def record(self, size: tuple[int, int]) -> dict[str, Any]:
        """Kind, lens, intrinsics and the extrinsics of every instant, for a manifest.

        Args:
            size: Width and height of the pictures [px].

        Returns:
            `world_to_camera` are 4 x 4 matrices to OpenCV's axes: x right, y down, z ahead; one
            for all instants where the camera stands still.
        """
        holes = [Pinhole.of(camera, size) for camera in self.cameras]
        still = bool(np.ptp(self.eye, axis=0).max() + np.ptp(self.target, axis=0).max() < 1e-9)
        moves = [hole.world_to_camera.tolist() for hole in holes]
        return {
            "kind": self.kind,
            "intrinsics_px": holes[0].matrix.tolist(),
            "vertical_fov_deg": math.degrees(self.fov),
            "lens_mm": round(self.lens_mm, 3),
            **({"world_to_camera": moves[0]} if still else {"world_to_camera_by_frame": moves}),
        }


def standing(camera: Camera, times: Any) -> Take:
    """A take of a camera that does not move.

    Args:
        camera: Where it stands.
        times: Instants of the scene [s], shape [n].
    """
    time = np.asarray(times, float)
    return Take(
        "static",
        time,
        np.tile(np.asarray(camera.eye, float), (len(time), 1)),
        np.tile(np.asarray(camera.target, float), (len(time), 1)),
        camera.fov,
    )


def _vec(values: Floats) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in values)
    return x, y, z
