"""A clip whose truth is known on paper: a box that tumbles over a floor, seen by a moving camera."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from esg.dataset.clips.encoding import CHANNELS
from esg.dataset.clips.reading import Clip
from esg.dataset.clips.records import ClipRecord, Intrinsics
from esg.dataset.clips.writing import write_clip
from tests.dataset.clips.synthetic import record, values

SIZE, FOCAL, FRAMES = (96, 64), 80.0, 4
HALF = np.array([0.5, 0.4, 0.3])
TRACKED = np.array([[0.5, 0.1, 0.2], [-0.2, 0.4, -0.1], [0.3, -0.4, 0.25]])
Channels = dict[str, Any]


def turned(axis: tuple[float, float, float], angle: float) -> tuple[np.ndarray, np.ndarray]:
    """A rotation as a matrix (Rodrigues) and as a quaternion (x, y, z, w)."""
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix = np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k
    half = 0.5 * angle
    return matrix, np.array([x, y, z, 0]) * np.sin(half) + np.array([0, 0, 0, np.cos(half)])


def box_pose(frame: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    matrix, quaternion = turned((0.2, 1.0, 0.3), 0.3 + 0.1 * frame)
    return np.array([0.1 * frame, 4.0 - 0.05 * frame, 0.8]), matrix, quaternion


def camera_pose(frame: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Looks along +Y and a little down, drifting and turning: columns are its x, y and z axes."""
    # x right = +X, y down = -Z, z ahead = +Y: a turn by -90 degrees about X, then by the frame.
    base, _ = turned((1, 0, 0), -np.pi / 2)
    down, _ = turned((1, 0, 0), -0.15)
    pan, _ = turned((0, 0, 1), 0.02 * frame)
    matrix = pan @ base @ np.linalg.inv(down)
    w = 0.5 * np.sqrt(1 + np.trace(matrix))
    m = matrix
    axis = np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / (4 * w)
    return np.array([0.05 * frame, 0.0, 1.2]), matrix, np.append(axis, w)


def seen(frame: int) -> Channels:
    """Depth, ids and points of one picture by intersecting rays."""
    width, height = SIZE
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    local = np.stack([(x - width / 2) / FOCAL, (y - height / 2) / FOCAL, np.ones_like(x)], -1)
    eye, turn, _ = camera_pose(frame)
    rays = local @ turn.T
    floor = np.where(rays[..., 2] < -1e-9, -eye[2] / np.minimum(rays[..., 2], -1e-9), np.inf)
    at, box, _ = box_pose(frame)
    start, way = (eye - at) @ box, rays @ box
    with np.errstate(divide="ignore"):
        one, two = (-HALF - start) / way, (HALF - start) / way
    enter, leave = np.minimum(one, two).max(-1), np.maximum(one, two).min(-1)
    hit = (enter < leave) & (enter > 0) & (enter < floor)
    depth = np.where(hit, enter, floor)
    ids = np.where(hit, 2, np.where(np.isfinite(floor), 1, 0)).astype(np.uint16)
    depth = np.where(ids > 0, depth, 0.0)
    points = eye + rays * depth[..., None]
    return {"depth": depth, "ids": ids, "points": points, "inside": (points - at) @ box}


def shifts(frame: int, other: int, view: Channels) -> np.ndarray:
    """Where everything of one picture is in another, as a shift."""
    width, height = SIZE
    at, box, _ = box_pose(other)
    moved = np.where((view["ids"] == 2)[..., None], view["inside"] @ box.T + at, view["points"])
    eye, turn, _ = camera_pose(other)
    local = (moved - eye) @ turn
    ahead = np.where(view["ids"] > 0, local[..., 2], np.nan)[..., None]
    place = local[..., :2] / ahead * FOCAL + (width / 2, height / 2)
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    return np.where((view["ids"] > 0)[..., None], place - np.stack([x, y], -1), np.nan)


def clip_values() -> Channels:
    """All channels of the clip."""
    out = values(FRAMES, SIZE)
    for k in range(FRAMES):
        view = seen(k)
        out["depth"][k], out["segmentation"][k] = view["depth"], view["ids"]
        out["flow"][k] = shifts(k, k + 1, view) if k + 1 < FRAMES else np.nan
        out["backward_flow"][k] = shifts(k, k - 1, view) if k else np.nan
        share = (view["inside"] + HALF) / (2 * HALF)
        out["object_coordinates"][k] = np.where((view["ids"] == 2)[..., None], share, np.nan)
    return out


def clip_record() -> ClipRecord:
    """Everything else that is known of it."""
    width, height = SIZE
    eyes, camera_turns = zip(*[(p, q) for p, _, q in map(camera_pose, range(FRAMES))], strict=True)
    places, turns = zip(*[(p, q) for p, _, q in map(box_pose, range(FRAMES))], strict=True)
    tracks, boxes2d, boxes3d, shown = [], [], [], []
    for k in range(FRAMES):
        view = seen(k)
        at, box, quaternion = box_pose(k)
        eye, turn, _ = camera_pose(k)
        local = (TRACKED @ box.T + at - eye) @ turn
        pixels = local[:, :2] / local[:, 2:] * FOCAL + (width / 2, height / 2)
        tracks.append(pixels)
        x, y = np.floor(pixels).astype(int).T
        shown.append((view["ids"][y, x] == 2) & (abs(view["depth"][y, x] / local[:, 2] - 1) < 0.02))
        rows, columns = np.nonzero(view["ids"] == 2)
        boxes2d.append(
            {"frame": k, "id": 2, "x0": int(columns.min()), "y0": int(rows.min()),
             "x1": int(columns.max()) + 1, "y1": int(rows.max()) + 1, "visible_px": len(rows)}
        )  # fmt: skip
        boxes3d.append(
            {"frame": k, "id": 2, "x_m": at[0], "y_m": at[1], "z_m": at[2], "half_x_m": HALF[0],
             "half_y_m": HALF[1], "half_z_m": HALF[2],
             **dict(zip(("qx", "qy", "qz", "qw"), map(float, quaternion), strict=True))}
        )  # fmt: skip
    return replace(
        record(frames=FRAMES, size=SIZE),
        intrinsics=Intrinsics(FOCAL, FOCAL, width / 2, height / 2),
        camera_position_m=np.array(eyes, np.float32),
        camera_quaternion_xyzw=np.array(camera_turns, np.float32),
        channels=CHANNELS,
        object_bounds_m=np.array([[-HALF, HALF]], np.float32),
        object_position_m=np.array(places, np.float32)[:, None],
        object_quaternion_xyzw=np.array(turns, np.float32)[:, None],
        boxes2d=tuple(boxes2d),
        boxes3d=tuple(boxes3d),
        track_ids=np.full(len(TRACKED), 2, np.int32),
        track_point_m=TRACKED.astype(np.float32),
        track_xy_px=np.array(tracks, np.float32),
        track_visible=np.array(shown),
    )


def written(out: Path, made: ClipRecord, found: Channels) -> Clip:
    """The clip on disk."""
    return Clip(out, write_clip(out, made, found))
