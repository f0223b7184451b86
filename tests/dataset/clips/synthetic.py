"""Clips without a renderer: a square body that slides over a plane, every channel known exactly."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dataset.clips.encoding import CHANNELS
from esg.dataset.clips.records import ClipObject, ClipRecord, Intrinsics
from esg.dataset.clips.writing import write_clip
from esg.store.records import scene_key

SIZE = (32, 24)
FRAMES = 5
STEP_PX = 2
NEAR_M, FAR_M = 4.0, 300.0
FOCAL_PX = 40.0


def values(frames: int = FRAMES, size: tuple[int, int] = SIZE) -> dict[str, NDArray[Any]]:
    """All channels: a plane FAR_M ahead, a body of 8 x 8 px NEAR_M ahead that goes STEP_PX right
    a frame, nothing above row 4.
    """
    width, height = size
    out: dict[str, NDArray[Any]] = {
        "rgb": np.full((frames, height, width, 3), 90, np.uint8),
        "depth": np.full((frames, height, width), FAR_M, np.float32),
        "segmentation": np.ones((frames, height, width), np.uint16),
        "flow": np.zeros((frames, height, width, 2), np.float32),
        "backward_flow": np.zeros((frames, height, width, 2), np.float32),
        "normal": np.zeros((frames, height, width, 3), np.float32),
        "object_coordinates": np.full((frames, height, width, 3), np.nan, np.float32),
    }
    out["normal"][..., 2] = 1.0
    for name, nothing in (("depth", 0.0), ("segmentation", 0), ("normal", 0.0)):
        out[name][:, :4] = nothing
    for k in range(frames):
        box = (k, slice(8, 16), slice(4 + STEP_PX * k, 12 + STEP_PX * k))
        out["rgb"][box] = (220, 40, 30)
        out["depth"][box] = NEAR_M
        out["segmentation"][box] = 2
        out["flow"][box] = (STEP_PX, 0)
        out["backward_flow"][box] = (-STEP_PX, 0)
        out["normal"][box] = (0, -1, 0)
        ramp = (np.arange(8) + 0.5) / 8
        out["object_coordinates"][box] = np.stack(
            [*np.meshgrid(ramp, ramp), np.zeros((8, 8))], axis=-1
        )
    out["flow"][-1] = np.nan
    out["backward_flow"][0] = np.nan
    return out


def record(
    run_id: str = "run-1", scene_id: str = "S1", camera: int = 0, *, seed: int = 0,
    suite: str = "", split: str = "train", frames: int = FRAMES,
    size: tuple[int, int] = SIZE, prompt: str = "A box slides over the floor.",
) -> ClipRecord:  # fmt: skip
    """What is known of such a clip, before its files are written."""
    width, height = size
    place = np.zeros((frames, 1, 3), np.float32)
    place[:, 0, 0] = STEP_PX * np.arange(frames) * NEAR_M / FOCAL_PX
    still = np.tile(np.array([0, 0, 0, 1], np.float32), (frames, 1))
    return ClipRecord(
        run_id=run_id, scene_key=scene_key(run_id, suite, scene_id, seed), suite=suite,
        scene_id=scene_id, seed=seed, split=split, prompt=prompt, camera=camera,
        camera_kind="static", width=width, height=height, fps=24.0, n_frames=frames,
        time_s=(np.arange(frames) / 24.0).astype(np.float32), renderer="synthetic", samples=1,
        intrinsics=Intrinsics(FOCAL_PX, FOCAL_PX, width / 2, height / 2),
        camera_position_m=np.zeros((frames, 3), np.float32), camera_quaternion_xyzw=still,
        channels=CHANNELS, files=(),
        objects=(ClipObject(2, "box_1", "box", "box", False),),
        object_bounds_m=np.array([[[-0.4, -0.4, -0.4], [0.4, 0.4, 0.4]]], np.float32),
        object_position_m=place, object_quaternion_xyzw=still[:, None],
        boxes2d=tuple(
            {"frame": k, "id": 2, "x0": 4 + STEP_PX * k, "y0": 8, "x1": 12 + STEP_PX * k, "y1": 16,
             "visible_px": 64}
            for k in range(frames)
        ),
        boxes3d=tuple(
            {"frame": k, "id": 2, "x_m": float(place[k, 0, 0]), "y_m": 0.0, "z_m": 0.0,
             "half_x_m": 0.5, "half_y_m": 0.5, "half_z_m": 0.5,
             "qx": 0.0, "qy": 0.0, "qz": 0.0, "qw": 1.0}
            for k in range(frames)
        ),
        track_ids=np.array([2], np.int32), track_point_m=np.zeros((1, 3), np.float32),
        track_xy_px=np.stack(
            [8.0 + STEP_PX * np.arange(frames), np.full(frames, 12.0)], axis=-1
        ).astype(np.float32)[:, None],
        track_visible=np.ones((frames, 1), bool),
    )  # fmt: skip


def write_synthetic(out: Path, **more: Any) -> ClipRecord:
    """Writes such a clip below a dataset's folder; returns its complete record."""
    made = record(**more)
    return write_clip(out, made, values(made.n_frames, (made.width, made.height)))
