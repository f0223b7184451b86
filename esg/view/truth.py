"""Exact answers to what a picture shows: flow, boxes and tracks, from poses and depth.

Pixels are counted as in the pictures: x right, y down, the centre of the first pixel at
(0.5, 0.5). A camera's own frame is that of OpenCV: x right, y down, z ahead.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.units import quat_rotate
from esg.view.camera import Camera, box_corners
from esg.view.worlds import GROUND, NOTHING

Floats = NDArray[np.float64]
Poses = tuple[Floats, Floats]
TRACKS_PER_BODY = 16


@dataclass(frozen=True)
class Pinhole:
    """Intrinsics [px] and extrinsics of a camera for pictures of one size.

    Args:
        matrix: K, shape [3, 3].
        world_to_camera: Rigid transform into the camera's frame (OpenCV axes) [m], shape [4, 4].
        size: Width and height [px].
    """

    matrix: Floats
    world_to_camera: Floats
    size: tuple[int, int]

    @staticmethod
    def of(camera: Camera, size: tuple[int, int]) -> Pinhole:
        """Of a camera and a picture size."""
        width, height = size
        focal = 0.5 * height / math.tan(camera.fov / 2)
        k = np.array([[focal, 0, width / 2], [0, focal, height / 2], [0, 0, 1.0]])
        rotation = camera.axes.T * np.array([[1.0], [-1.0], [-1.0]])
        pose = np.eye(4)
        pose[:3, :3] = rotation
        pose[:3, 3] = -rotation @ np.asarray(camera.eye)
        return Pinhole(k, pose, size)

    def project(self, points: Floats) -> tuple[Floats, Floats]:
        """Pixels, shape [..., 2], and depths [m], shape [...], of world points, shape [..., 3]."""
        local = points @ self.world_to_camera[:3, :3].T + self.world_to_camera[:3, 3]
        depth = local[..., 2]
        safe = np.where(np.abs(depth) > 1e-9, depth, 1e-9)
        focal = np.array([self.matrix[0, 0], self.matrix[1, 1]])
        center = self.matrix[:2, 2]
        return local[..., :2] / safe[..., None] * focal + center, depth

    def unproject(self, depth: NDArray[Any]) -> Floats:
        """World points [m] of all pixel centres at their depths, shape [H, L, 3]."""
        width, height = self.size
        x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
        local = np.stack(
            [
                (x - self.matrix[0, 2]) / self.matrix[0, 0] * depth,
                (y - self.matrix[1, 2]) / self.matrix[1, 1] * depth,
                np.asarray(depth, float),
            ],
            axis=-1,
        )
        return (local - self.world_to_camera[:3, 3]) @ self.world_to_camera[:3, :3]


def flow(
    camera: Pinhole,
    depth: NDArray[Any],
    mover: NDArray[Any],
    now: Poses,
    later: Poses,
    camera_later: Pinhole | None = None,
) -> NDArray[np.float32]:
    """Where each pixel's surface is in another picture, as a shift [px], shape [H, L, 2].

    Args:
        camera: Of the first picture.
        depth: Of the first picture [m], 0 for the sky, which is endlessly far, shape [H, L].
        mover: What moves as one in the first picture, negative for the world, shape [H, L].
        now: Positions [m] and quaternions of all movers, shapes [B, 3] and [B, 4].
        later: The same at the other picture.
        camera_later: Of the other picture; None if the camera stands still.

    Returns:
        NaN for what is then behind the camera.
    """
    out = np.zeros((*depth.shape, 2), np.float32)
    other = camera_later or camera
    unproject = np.linalg.inv(camera.matrix)
    back, shift = _inverse(camera.world_to_camera)
    ahead_of, ahead_by = other.world_to_camera[:3, :3], other.world_to_camera[:3, 3]
    for index, mask in _masks(mover):
        turn, move = np.eye(3), np.zeros(3)
        if index >= 0:
            before, after = _matrix(now[1][index]), _matrix(later[1][index])
            turn = after @ before.T
            move = later[0][index] - turn @ now[0][index]
        rests = np.abs(turn - np.eye(3)).max() < 1e-12 and np.abs(move).max() < 1e-12
        if rests and camera_later is None:
            continue
        # Of a pixel u with depth z, z * (a u + b / z) is its place in the other picture.
        a = other.matrix @ ahead_of @ turn @ back @ unproject
        b = other.matrix @ (ahead_of @ (turn @ shift + move) + ahead_by)
        rays = _pixels(depth.shape)[mask]
        z = depth[mask].astype(float)
        inverse = np.divide(1.0, z, out=np.zeros_like(z), where=z > 0)
        place = rays @ a.T + inverse[:, None] * b
        ahead = place[:, 2:] > 0
        found = place[:, :2] / np.where(ahead, place[:, 2:], 1.0) - rays[:, :2]
        out[mask] = np.where(ahead, found, np.nan)
    return out


def body_points(
    camera: Pinhole, depth: NDArray[Any], mover: NDArray[Any], now: Poses
) -> NDArray[np.float32]:
    """Points of all pixels in the axes of what they are on [m], 0 in the world, shape [H, L, 3].

    Args:
        camera: Of the picture.
        depth: Of the picture [m], shape [H, L].
        mover: What moves as one, negative for the world, shape [H, L].
        now: Positions [m] and quaternions of all movers, shapes [B, 3] and [B, 4].
    """
    out = np.zeros((*depth.shape, 3), np.float32)
    unproject = np.linalg.inv(camera.matrix)
    back, shift = _inverse(camera.world_to_camera)
    for index, mask in _masks(mover):
        if index < 0:
            continue
        turn = _matrix(now[1][index]).T
        rays = _pixels(depth.shape)[mask] * depth[mask][:, None]
        out[mask] = rays @ (turn @ back @ unproject).T + turn @ (shift - now[0][index])
    return out


def _masks(mover: NDArray[Any]) -> Iterator[tuple[int, NDArray[np.bool_]]]:
    """What is in a picture: -1 for all of the world, then every mover, and where."""
    counts = np.bincount(np.maximum(mover, -1).ravel() + 1)
    for index in np.flatnonzero(counts) - 1:
        yield int(index), mover == index if index >= 0 else mover < 0


@lru_cache(maxsize=4)
def _pixels(shape: tuple[int, int]) -> Floats:
    """Homogeneous centres of all pixels, shape [H, L, 3]."""
    x, y = np.meshgrid(np.arange(shape[1]) + 0.5, np.arange(shape[0]) + 0.5)
    return np.stack([x, y, np.ones(shape)], axis=-1, dtype=np.float64)


def _matrix(quaternion: Floats) -> Floats:
    return np.asarray(quat_rotate(np.tile(quaternion, (3, 1)), np.eye(3)).T, np.float64)


def _inverse(rigid: Floats) -> tuple[Floats, Floats]:
    """Rotation and translation of the inverse of a rigid transform."""
    back = rigid[:3, :3].T
    return back, -back @ rigid[:3, 3]


def boxes_2d(body: NDArray[Any]) -> list[dict[str, Any]]:
    """Tight boxes around what is visible of each body: x0, y0, x1, y1 [px], ends exclusive.

    Args:
        body: Bodies of a picture, shape [H, L].
    """
    out: list[dict[str, Any]] = []
    for index in np.unique(body[body >= 0]):
        y, x = np.nonzero(body == index)
        box = [int(x.min()), int(y.min()), int(x.max()) + 1, int(y.max()) + 1]
        out.append({"body": int(index), "box_px": box, "visible_px": len(x)})
    return out


def boxes_3d(
    camera: Pinhole,
    half_extents: Floats,
    offsets: Floats,
    position: Floats,
    quaternion: Floats,
) -> list[dict[str, Any]]:
    """The oriented bounding box of every body, in the world and as seen.

    Args:
        camera: For the corners' pixels.
        half_extents: Of the assets' boxes [m], shape [B, 3].
        offsets: From centres of mass to bottom centres, body axes [m], shape [B, 3].
        position: Centres of mass [m], shape [B, 3].
        quaternion: (x, y, z, w), shape [B, 4].
    """
    out: list[dict[str, Any]] = []
    centers = box_centers(half_extents, offsets, position, quaternion)
    for index, (half, offset) in enumerate(zip(half_extents, offsets, strict=True)):
        corners = box_corners(position[index], quaternion[index], tuple(half), offset)
        pixels, depth = camera.project(corners)
        out.append(
            {
                "body": index,
                "center_m": _list(centers[index]),
                "half_extents_m": _list(half),
                "quaternion_xyzw": _list(quaternion[index]),
                "corners_px": [_list(p, 2) for p in pixels] if (depth > 0).all() else [],
            }
        )
    return out


def box_centers(
    half_extents: Floats, offsets: Floats, position: Floats, quaternion: Floats
) -> Floats:
    """Centres of the bodies' boxes in the world [m], shape [B, 3]; arguments as of `boxes_3d`."""
    local = offsets + half_extents * np.array([0.0, 0.0, 1.0])
    return position + quat_rotate(quaternion, local)


def sample_points(
    vertices: Floats, faces: NDArray[Any], count: int, rng: np.random.Generator
) -> Floats:
    """Points spread over a surface by area, shape [count, 3]."""
    corners = vertices[faces]
    area = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    if not area.sum() > 0:
        return np.repeat(vertices[:1], count, axis=0)
    chosen = corners[rng.choice(len(faces), count, p=area / area.sum())]
    u, v = rng.random((2, count, 1))
    flip = u + v > 1
    u, v = np.where(flip, 1 - u, u), np.where(flip, 1 - v, v)
    return chosen[:, 0] + u * (chosen[:, 1] - chosen[:, 0]) + v * (chosen[:, 2] - chosen[:, 0])


def track(
    camera: Pinhole,
    depth: NDArray[Any],
    body: NDArray[Any],
    owner: NDArray[Any],
    points: Floats,
    position: Floats,
    quaternion: Floats,
) -> tuple[Floats, NDArray[np.bool_]]:
    """Pixels of points on the bodies, shape [n, 2], and whether each is visible, shape [n].

    Args:
        camera: That took the picture.
        depth: Of the picture [m], shape [H, L].
        body: Bodies of the picture, shape [H, L].
        owner: Body of each point, shape [n].
        points: In body axes from the centre of mass [m], shape [n, 3].
        position: Centres of mass [m], shape [B, 3].
        quaternion: (x, y, z, w), shape [B, 4].
    """
    world = quat_rotate(quaternion[owner], points) + position[owner]
    pixels, ahead = camera.project(world)
    width, height = camera.size
    x, y = np.floor(pixels).astype(np.int64).T
    inside = (ahead > 0) & (x >= 0) & (y >= 0) & (x < width) & (y < height)
    x, y = np.where(inside, x, 0), np.where(inside, y, 0)
    # A pixel's centre lies up to half a pixel from the point: on a slope its depth differs.
    slack = 0.01 + 0.01 * ahead
    near = np.abs(depth[y, x] - ahead) < slack
    return pixels, inside & near & (body[y, x] == owner)


def segment_ids(body: NDArray[Any]) -> NDArray[np.uint16]:
    """Ids for a mask: 0 nothing, 1 the ground, body k is k + 2."""
    return np.where(body == NOTHING, 0, np.where(body == GROUND, 1, body + 2)).astype(np.uint16)


def _list(values: Any, digits: int = 5) -> list[float]:
    return [round(float(v), digits) for v in values]
