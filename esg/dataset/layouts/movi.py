"""MOVi: a NumPy archive a clip with the fields of a sample of Kubric's MOVi data sets.

Names, types and meanings are those of `challenges/movi/movi_e.py` of Kubric, folders for nested
fields: `metadata/depth_range`, `instances/positions`, `events/collisions/force`. MOVi itself is
TFRecords, which only TensorFlow reads; an archive is read by NumPy, and what `load` in
docs/dataset/movi.py returns is what `tfds.as_numpy` gives of a MOVi sample.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dataset.clips.records import FIRST_BODY, ClipRecord
from esg.dataset.layouts.building import LayoutFolder
from esg.dataset.layouts.described import archive
from esg.dataset.layouts.motion import velocities_of
from esg.dataset.layouts.source import Sample, Source, splits
from esg.outcomes import UserError
from esg.units import quat_multiply, quat_rotate

Arrays = dict[str, NDArray[Any]]

SENSOR_MM = 32.0
"""Width of MOVi's sensor; only its ratio to the focal length means anything."""
_MOST_INSTANCES = 254
_MOST = 65535
_NOBODY = 65535
"""Index of the ground in collisions."""
_CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
_FLIP = np.array([1.0, 0.0, 0.0, 0.0])
"""From a camera that looks along z with y down to Blender's, along -z with y up."""


def write(source: Source, folder: LayoutFolder) -> dict[str, Any]:
    """Writes all archives; returns how many every split has."""
    counts: dict[str, int] = {}
    for split in splits():
        counts[split] = 0
        for sample in source.samples(split, ("trajectories",)):
            folder.add(f"{split}/{sample.key}.npz", partial(_save, sample))
            counts[split] += 1
    return {"splits": counts}


def _save(sample: Sample, path: Path) -> None:
    path.write_bytes(archive(fields(sample), packed=True))


def fields(sample: Sample) -> Arrays:
    """All fields of a clip; those of channels that were not rendered are left out.

    Raises:
        UserError: If it has more bodies than MOVi's segmentation has numbers.
    """
    record = sample.clip.record
    if len(record.objects) > _MOST_INSTANCES:
        raise UserError(
            f"layout movi: scene {record.scene_id} has {len(record.objects)} bodies; MOVi's "
            f"segmentation tells {_MOST_INSTANCES} apart"
        )
    out: dict[str, Any] = {
        "metadata/video_name": np.array(sample.key),
        "metadata/width": np.int32(record.width),
        "metadata/height": np.int32(record.height),
        "metadata/num_frames": np.int32(record.n_frames),
        "metadata/num_instances": np.uint16(len(record.objects)),
        "metadata/prompt": np.array(record.prompt),
        "background": np.array(""),
        **{f"camera/{k}": v for k, v in _camera(record).items()},
        **{f"instances/{k}": v for k, v in _instances(sample).items()},
        **{f"events/collisions/{k}": v for k, v in _collisions(sample).items()},
    }
    for channel, coded in _CHANNELS.items():
        if any(file.channel == channel for file in record.files):
            out |= coded(record, sample.clip.frames(channel))
    return {name: np.asarray(value) for name, value in out.items()}


# Pictures, as MOVi codes them.


def _depth(record: ClipRecord, metres: NDArray[Any]) -> Arrays:
    """Distances from the camera's centre; ours are along its axis."""
    k = record.intrinsics
    x = (np.arange(record.width) + 0.5 - k.cx) / k.fx
    y = (np.arange(record.height) + 0.5 - k.cy) / k.fy
    far = metres * np.sqrt(1.0 + x[None, :] ** 2 + y[:, None] ** 2)
    codes, bounds = _ranged(far[..., None])
    return {"depth": codes, "metadata/depth_range": bounds}


def _flow(name: str, _: ClipRecord, pixels: NDArray[Any]) -> Arrays:
    """(row, column); what is not known, as the sky, stays where it is."""
    codes, bounds = _ranged(np.nan_to_num(pixels[..., ::-1]))
    return {name: codes, f"metadata/{name}_range": bounds}


def _ranged(values: NDArray[Any]) -> tuple[NDArray[np.uint16], NDArray[np.float32]]:
    """16 bits between the least and the most of a clip, and those two."""
    low, high = float(values.min()), float(values.max())
    codes = np.rint((values - low) / max(high - low, 1e-9) * _MOST)
    return codes.astype(np.uint16), np.array([low, high], np.float32)


def _ids(_: ClipRecord, ids: NDArray[Any]) -> Arrays:
    """0 where there is no body: the sky, and the ground, which is no instance."""
    codes = np.where(ids >= FIRST_BODY, ids.astype(np.int32) - FIRST_BODY + 1, 0)
    return {"segmentations": codes[..., None].astype(np.uint8)}


def _normal(_: ClipRecord, normals: NDArray[Any]) -> Arrays:
    return {"normal": ((normals.clip(-1.0, 1.0) + 1.0) * _MOST / 2).astype(np.uint16)}


def _places(_: ClipRecord, shares: NDArray[Any]) -> Arrays:
    codes = np.nan_to_num(shares).clip(0.0, 1.0) * _MOST
    return {"object_coordinates": codes.astype(np.uint16)}


_CHANNELS: dict[str, Callable[[ClipRecord, NDArray[Any]], Arrays]] = {
    "rgb": lambda _, frames: {"video": frames},
    "segmentation": _ids,
    "depth": _depth,
    "flow": partial(_flow, "forward_flow"),
    "backward_flow": partial(_flow, "backward_flow"),
    "normal": _normal,
    "object_coordinates": _places,
}


# Camera, bodies, collisions.


def _camera(record: ClipRecord) -> dict[str, Any]:
    focal = record.intrinsics.fx / record.width * SENSOR_MM
    turned = quat_multiply(record.camera_quaternion_xyzw.astype(float), _FLIP)
    return {
        "focal_length": np.float32(focal),
        "sensor_width": np.float32(SENSOR_MM),
        "field_of_view": np.float32(2.0 * math.atan2(SENSOR_MM / 2.0, focal)),
        "positions": record.camera_position_m.astype(np.float32),
        "quaternions": _wxyz(turned),
    }


def _wxyz(quaternions: NDArray[Any]) -> NDArray[np.float32]:
    """Blender's order."""
    return quaternions[..., [3, 0, 1, 2]].astype(np.float32)


def _instances(sample: Sample) -> Arrays:
    """A number a body along the first axis, as tfds batches a sequence of instances."""
    record = sample.clip.record
    bodies = {b["name"]: b for b in json.loads(sample.scene["manifest"])["bodies"]}
    own = [bodies[o.name] for o in record.objects]
    position = record.object_position_m.astype(float)
    turn = record.object_quaternion_xyzw.astype(float)
    linear, angular = velocities_of(sample)
    low, high = record.object_bounds_m[:, 0], record.object_bounds_m[:, 1]
    corners = low[:, None] + _CORNERS * (high - low)[:, None]
    world = position[:, :, None] + quat_rotate(turn[:, :, None], corners[None])
    return {
        **{
            k: np.array([b[k] for b in own], np.float32)
            for k in ("mass", "friction", "restitution")
        },
        "positions": _by_body(position),
        "quaternions": np.swapaxes(_wxyz(turn), 0, 1),
        "velocities": _by_body(linear),
        "angular_velocities": _by_body(angular),
        "bboxes_3d": _by_body(world),
        "image_positions": _by_body(_seen_at(record, position)),
        **_boxes(record),
        "asset_id": np.array([b["mesh"] or b["name"] for b in own]),
        "category": np.array([o.category for o in record.objects]),
        "name": np.array([o.name for o in record.objects]),
        "scale": np.ones(len(own), np.float32),
        "is_dynamic": np.array([not o.static for o in record.objects]),
    }


def _by_body(values: NDArray[Any]) -> NDArray[np.float32]:
    return np.swapaxes(values, 0, 1).astype(np.float32)


def _seen_at(record: ClipRecord, points: NDArray[Any]) -> NDArray[Any]:
    """Where world points [n, m, 3] are in the picture, in shares of its size: x right, y down."""
    back = record.camera_quaternion_xyzw.astype(float) * [-1, -1, -1, 1]
    local = quat_rotate(back[:, None], points - record.camera_position_m[:, None])
    k, ahead = record.intrinsics, local[..., 2]
    safe = np.where(np.abs(ahead) > 1e-9, ahead, 1e-9)
    x = (k.fx * local[..., 0] / safe + k.cx) / record.width
    y = (k.fy * local[..., 1] / safe + k.cy) / record.height
    return np.stack([x, y], axis=-1)


def _boxes(record: ClipRecord) -> Arrays:
    """Boxes of the frames in which a body is seen, padded to the body that is seen most.

    `bbox_frames` is -1 where a body has no more boxes; tfds has ragged sequences there.
    """
    place = {o.id: k for k, o in enumerate(record.objects)}
    found: list[list[Mapping[str, int]]] = [[] for _ in place]
    seen = np.zeros((len(place), record.n_frames), np.int64)
    for box in record.boxes2d:
        if box["id"] in place:
            found[place[box["id"]]].append(box)
            seen[place[box["id"]], box["frame"]] = box["visible_px"]
    most = max((len(boxes) for boxes in found), default=0)
    frames = np.full((len(place), most), -1, np.int32)
    bounds = np.zeros((len(place), most, 4), np.float32)
    width, height = record.width, record.height
    for k, boxes in enumerate(found):
        for j, b in enumerate(boxes):
            frames[k, j] = b["frame"]
            bounds[k, j] = (b["y0"] / height, b["x0"] / width, b["y1"] / height, b["x1"] / width)
    visibility = np.minimum(seen, _MOST).astype(np.uint16)
    return {"bboxes": bounds, "bbox_frames": frames, "visibility": visibility}


def _collisions(sample: Sample) -> Arrays:
    """Contacts while the camera films; force is impulse over the physics step."""
    record, engine = sample.clip.record, sample.scene["engine"]
    row = next(r for r in sample.more["trajectories"] if r["engine"] == engine)
    place = {o.name: k for k, o in enumerate(record.objects)}
    index = np.array([place.get(name, _NOBODY) for name in row["bodies"]] + [_NOBODY])
    time = np.asarray(row["contact_time_s"], float)
    half = 0.5 / record.fps
    kept = (time >= record.time_s[0] - half) & (time <= record.time_s[-1] + half)
    frame = np.abs(time[kept, None] - record.time_s[None]).argmin(axis=1)
    pair = [np.asarray(row[name], int)[kept] for name in ("contact_a", "contact_b")]
    point = _vectors(row, "contact_point_m", kept)
    seen = _seen_at(_at(record, frame), point[:, None])[:, 0]
    return {
        "instances": index[np.stack(pair, axis=-1)].astype(np.uint16),
        "frame": frame.astype(np.int32),
        "force": (np.asarray(row["contact_impulse_ns"])[kept] / row["dt_s"]).astype(np.float32),
        "position": point.astype(np.float32),
        "image_position": seen.astype(np.float32),
        "contact_normal": _vectors(row, "contact_normal", kept).astype(np.float32),
    }


def _vectors(row: Mapping[str, Any], column: str, kept: NDArray[Any]) -> NDArray[Any]:
    """Vectors of contacts; not a number in datasets that did not record them."""
    found: Sequence[float] | None = row[column]
    if found is None:
        return np.full((int(kept.sum()), 3), np.nan)
    return np.asarray(found, float).reshape(-1, 3)[kept]


def _at(record: ClipRecord, frames: NDArray[Any]) -> ClipRecord:
    """The record with the camera of some frames."""
    from dataclasses import replace

    return replace(
        record,
        camera_position_m=record.camera_position_m[frames],
        camera_quaternion_xyzw=record.camera_quaternion_xyzw[frames],
    )
