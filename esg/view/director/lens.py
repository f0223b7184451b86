"""How large what acts is in a picture, and where in it."""

from __future__ import annotations

from dataclasses import dataclass, replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.view.camera import Camera, frame_points

Floats = NDArray[np.float64]

FILL_LEAST, FILL_MOST = 0.15, 0.50
"""Who acts fills so much of a picture; see `Extent.fill`."""
FILL_WANTED = 0.42
SAFE = 0.86
"""Nothing that acts comes closer to the picture's edge than this part of its half."""
EYE_M = 1.6
"""Eye height of somebody who stands by."""
LOWEST_M = 0.12
"""A camera is never lower above the ground."""
THIRD = 1.0 / 3.0
"""What acts is so far from the middle, in halves of the picture, on a line of the thirds."""


@dataclass(frozen=True)
class View:
    """A direction to look from.

    Args:
        azimuth: From what acts to the camera, counter-clockwise from +X [rad].
        elevation: Above the horizon [rad]; None for eye height.
        fov: Vertical field of view [rad].
        aspect: Width over height of the picture.
        lead: Where the way of what acts points in the picture: 1 right, -1 left, 0 neither. It
            stands on the other third, so that it has room ahead.
    """

    azimuth: float
    elevation: float | None
    fov: float
    aspect: float
    lead: float = 0.0


@dataclass(frozen=True)
class Extent:
    """The rectangle around points in a picture.

    Args:
        low, high: Its corners in halves of the picture from the middle, x right, y up; -1 and 1
            are the picture's edges.
        ahead: Whether all points are in front of the camera.
    """

    low: tuple[float, float]
    high: tuple[float, float]
    ahead: bool

    @property
    def fill(self) -> float:
        """Geometric mean of the shares of width and height that it takes inside the picture."""
        if not self.ahead:
            return 0.0
        sides = [
            max(0.0, min(1.0, b) - max(-1.0, a)) / 2
            for a, b in zip(self.low, self.high, strict=True)
        ]
        return math.sqrt(sides[0] * sides[1])

    @property
    def overflow(self) -> float:
        """How far the farthest corner is from the middle: above 1 it is outside of the picture."""
        if not self.ahead:
            return math.inf
        return max(*(abs(v) for v in self.low), *(abs(v) for v in self.high))

    @property
    def inside(self) -> float:
        """Share of the rectangle's area that is inside the picture."""
        if not self.ahead:
            return 0.0
        whole = math.prod(max(b - a, 1e-9) for a, b in zip(self.low, self.high, strict=True))
        return min(1.0, 4 * self.fill**2 / whole)


def extent(camera: Camera, points: Floats, aspect: float) -> Extent:
    """The rectangle around points in a camera's picture.

    Args:
        camera: Where to look from.
        points: World points [m], shape [n, 3].
        aspect: Width over height of the picture.
    """
    local = (points - np.asarray(camera.eye)) @ camera.axes
    depth = -local[:, 2]
    if float(depth.min()) < 1e-3:
        return Extent((-math.inf, -math.inf), (math.inf, math.inf), False)
    tan = math.tan(camera.fov / 2)
    x, y = local[:, 0] / (depth * tan * aspect), local[:, 1] / (depth * tan)
    return Extent((float(x.min()), float(y.min())), (float(x.max()), float(y.max())), ahead=True)


def framed(points: Floats, view: View, wanted: float = FILL_WANTED) -> Camera:
    """The camera in a direction from which points have the wanted fill, all well inside.

    Args:
        points: World points [m], shape [n, 3].
        view: From where, and through which lens.
        wanted: Fill, reached unless something would leave the picture.
    """
    elevation = view.elevation
    camera = _at_distance(points, view, elevation if elevation is not None else 0.12, wanted)
    if elevation is None:
        for _ in range(2):
            flat = math.dist(camera.eye[:2], camera.target[:2])
            rise = EYE_M - camera.target[2]
            angle = max(math.atan2(rise, max(flat, 0.3)), math.radians(2.0))
            camera = _at_distance(points, view, min(angle, math.radians(40.0)), wanted)
    return on_thirds(camera, points, view)


def _at_distance(points: Floats, view: View, elevation: float, wanted: float) -> Camera:
    camera = frame_points(points, view.azimuth, elevation, view.aspect, SAFE - 0.1, view.fov)
    for _ in range(3):
        fill = extent(camera, points, view.aspect).fill
        if fill <= wanted:
            break
        camera = farther(camera, fill / wanted)
    eye = np.asarray(camera.eye)
    if eye[2] < LOWEST_M:
        eye = np.array([eye[0], eye[1], LOWEST_M])
    return replace(camera, eye=_vec(eye))


def farther(camera: Camera, times: float) -> Camera:
    """The same camera, so many times as far from its target."""
    target = np.asarray(camera.target)
    return replace(camera, eye=_vec(target + times * (np.asarray(camera.eye) - target)))


def on_thirds(camera: Camera, points: Floats, view: View) -> Camera:
    """Turns a camera so that what acts moves toward the lower third and leaves room ahead.

    As far as everything stays inside.

    Args:
        camera: It has what acts in the middle.
        points: What acts [m], shape [n, 3].
        view: Says which way it moves.
    """
    tan = math.tan(camera.fov / 2)
    away = float(np.linalg.norm(np.subtract(camera.target, camera.eye)))
    right, up, _ = camera.axes.T
    for part in (1.0, 0.6, 0.3):
        shift = part * THIRD * away * tan
        moved = np.asarray(camera.target) + shift * (up + view.lead * view.aspect * right)
        turned = replace(camera, target=_vec(moved))
        if extent(turned, points, view.aspect).overflow <= SAFE:
            return turned
    return camera


def _vec(values: Floats) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in values)
    return x, y, z
