"""What is known of one clip: a row of table `clips` as typed arrays with their shapes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]

NOTHING, GROUND, FIRST_BODY = 0, 1, 2
"""Ids of segmentation; body k of the replay has id k + 2."""


@dataclass(frozen=True)
class Intrinsics:
    """Of a pinhole camera [px]; the centre of the first pixel lies at (0.5, 0.5)."""

    fx: float
    fy: float
    cx: float
    cy: float


@dataclass(frozen=True)
class ClipFile:
    """One file of a clip.

    Args:
        channel: What it holds.
        path: Below the dataset's folder.
        bytes: Its size.
    """

    channel: str
    path: str
    bytes: int


@dataclass(frozen=True)
class ClipObject:
    """One body of the scene.

    Args:
        id: In segmentation, boxes and tracks.
        name: Of the body, as in table `trajectories`.
        label: What the prompt calls it.
        category: Of its asset.
        static: Whether it never moves.
    """

    id: int
    name: str
    label: str
    category: str
    static: bool


def _none() -> Any:
    return np.zeros(0, np.float32)


@dataclass(frozen=True)
class ClipRecord:
    """What one camera saw of one scene; n frames, m objects, p tracked points.

    Args:
        run_id, scene_key, suite, scene_id, seed, split, prompt: Of the scene.
        camera: Number of the camera.
        camera_kind: static, tracking, dolly, orbit or dash.
        width, height: Of the pictures [px].
        fps: Frames a second.
        n_frames: n.
        time_s: Of the frames in the replay [s], shape [n].
        renderer: Of the colours.
        samples: Rays a pixel.
        intrinsics: Of the camera, the same in all frames.
        camera_position_m: In the world [m], shape [n, 3].
        camera_quaternion_xyzw: From the camera's axes (x right, y down, z ahead) to the world's,
            shape [n, 4].
        channels: What was rendered.
        files: Of the channels that are pictures.
        objects: All bodies.
        object_bounds_m: Lower and upper corner of each body's surface in its own axes from its
            centre of mass [m], shape [m, 2, 3].
        object_position_m: Centres of mass [m], shape [n, m, 3].
        object_quaternion_xyzw: Shape [n, m, 4].
        depth_offset, depth_scale: Of every frame: metres are exp(offset + scale * code), code 0 is
            nothing; shape [n], empty without depth.
        flow_scale, backward_flow_scale: Of every frame [px]: (u, v) is (code - 32768) * scale,
            shape [n], empty without flow.
        boxes2d: Of what is visible: frame, id, x0, y0, x1, y1 [px] (ends exclusive), visible_px.
        boxes3d: Oriented boxes: frame, id, centre x_m, y_m, z_m, half extents half_x_m, half_y_m,
            half_z_m, quaternion qx, qy, qz, qw.
        track_ids: Object of each tracked point, shape [p].
        track_point_m: In the object's axes from its centre of mass [m], shape [p, 3].
        track_xy_px: Where they are [px], shape [n, p, 2].
        track_visible: Whether they are seen, shape [n, p].
        place, sky: Rows of the tables of places and skies that dress the scene; empty for none.
    """

    run_id: str
    scene_key: str
    suite: str
    scene_id: str
    seed: int
    split: str
    prompt: str
    camera: int
    camera_kind: str
    width: int
    height: int
    fps: float
    n_frames: int
    time_s: Floats
    renderer: str
    samples: int
    intrinsics: Intrinsics
    camera_position_m: Floats
    camera_quaternion_xyzw: Floats
    channels: tuple[str, ...]
    files: tuple[ClipFile, ...]
    objects: tuple[ClipObject, ...]
    object_bounds_m: Floats
    object_position_m: Floats
    object_quaternion_xyzw: Floats
    depth_offset: Floats = field(default_factory=_none)
    depth_scale: Floats = field(default_factory=_none)
    flow_scale: Floats = field(default_factory=_none)
    backward_flow_scale: Floats = field(default_factory=_none)
    boxes2d: tuple[Mapping[str, int], ...] = ()
    boxes3d: tuple[Mapping[str, float], ...] = ()
    track_ids: NDArray[np.int32] = field(default_factory=_none)
    track_point_m: Floats = field(default_factory=_none)
    track_xy_px: Floats = field(default_factory=_none)
    track_visible: NDArray[np.bool_] = field(default_factory=_none)
    place: str = ""
    sky: str = ""

    def row(self, out: Path | None = None) -> dict[str, Any]:
        """The row of table `clips`: flat lists, in C order.

        Args:
            out: Folder of the dataset, for the bytes of the film; without it, the row has none.

        Raises:
            OSError: If the film cannot be read.
        """
        row: dict[str, Any] = {}
        for name in (f.name for f in fields(self)):
            value = getattr(self, name)
            if name in _KINDS:
                value = np.ascontiguousarray(value, _KINDS[name]).ravel()
            elif name in ("channels", "boxes2d", "boxes3d"):
                value = list(value)
            elif name in ("files", "objects"):
                value = [vars(v) for v in value]
            row[name] = vars(value) if isinstance(value, Intrinsics) else value
        film = next((f.path for f in self.files if f.channel == "rgb"), None)
        if film is not None:
            data = None if out is None else (out / film).read_bytes()
            row["video"] = {"bytes": data, "path": film}
        return row

    @staticmethod
    def of(row: Mapping[str, Any]) -> ClipRecord:
        """The inverse of `row`, of a row as Arrow gives it, with or without its film."""
        n, m, p = row["n_frames"], len(row["objects"]), len(row["track_ids"])
        shapes = {
            "camera_position_m": (n, 3),
            "camera_quaternion_xyzw": (n, 4),
            "object_bounds_m": (m, 2, 3),
            "object_position_m": (n, m, 3),
            "object_quaternion_xyzw": (n, m, 4),
            "track_point_m": (p, 3),
            "track_xy_px": (n, p, 2),
            "track_visible": (n, p),
        }
        arrays = {k: np.asarray(row[k], kind) for k, kind in _KINDS.items()}
        typed: dict[str, Any] = {
            **arrays,
            **{k: arrays[k].reshape(shape) for k, shape in shapes.items()},
            "intrinsics": Intrinsics(**row["intrinsics"]),
            "files": tuple(ClipFile(**f) for f in row["files"]),
            "objects": tuple(ClipObject(**o) for o in row["objects"]),
            **{k: tuple(row[k]) for k in ("channels", "boxes2d", "boxes3d")},
        }
        return ClipRecord(**{**{f.name: row[f.name] for f in fields(ClipRecord)}, **typed})


PLAIN_COLUMNS = tuple(f.name for f in fields(ClipRecord))
"""All columns of table `clips` but the film itself, `video`."""

_KINDS: dict[str, Any] = {
    **dict.fromkeys(
        [
            "time_s", "camera_position_m", "camera_quaternion_xyzw", "object_bounds_m",
            "object_position_m", "object_quaternion_xyzw", "depth_offset", "depth_scale",
            "flow_scale", "backward_flow_scale", "track_point_m", "track_xy_px",
        ],
        np.float32,
    ),
    "track_ids": np.int32,
    "track_visible": np.bool_,
}  # fmt: skip
"""Columns that are arrays, and what of."""
