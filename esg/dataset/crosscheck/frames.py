"""Some frames of a clip, decoded by the formulas of docs/dataset/clips.md."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from esg.dataset.clips.records import FIRST_BODY, ClipRecord
from esg.outcomes import UserError

Floats = NDArray[np.floating]


def stored(path: Path, wanted: Collection[int]) -> dict[int, NDArray[np.uint16]]:
    """The wanted frames of a file as they are stored, one other frame in memory at a time.

    Raises:
        UserError: If the file is missing or damaged, or ends before one of them.
    """
    import av
    from av.error import FFmpegError

    out: dict[int, NDArray[np.uint16]] = {}
    try:
        with av.open(str(path)) as container:
            for number, frame in enumerate(container.decode(video=0)):
                if number in wanted:
                    out[number] = np.asarray(frame.to_ndarray(), np.uint16)
    except (FFmpegError, OSError, IndexError, ValueError) as error:
        raise UserError(f"{path} is missing or damaged ({error}); render it again") from None
    if len(out) < len(set(wanted)):
        raise UserError(f"{path} ends before frame {max(wanted)}; render it again")
    return out


@dataclass
class Seen:
    """What a clip shows in some of its frames.

    Args:
        folder: Of the dataset.
        record: The clip's row.
        frames: Numbers of the frames, ascending.
        wheels: By object id, of every wheel: centre in the object's axes [m] and radius [m].
    """

    folder: Path
    record: ClipRecord
    frames: tuple[int, ...]
    wheels: dict[int, list[tuple[Floats, float]]] = field(default_factory=dict)
    _kept: dict[str, dict[int, NDArray[Any]]] = field(default_factory=dict)

    def has(self, *channels: str) -> bool:
        """Whether the clip has files of all these channels."""
        return set(channels) <= {f.channel for f in self.record.files}

    def codes(self, channel: str, frame: int) -> NDArray[np.uint16]:
        """A frame as it is stored, shape [H, L] or [H, L, 3]."""
        if channel not in self._kept:
            path = next(f.path for f in self.record.files if f.channel == channel)
            self._kept[channel] = stored(self.folder / path, self.frames)
        return self._kept[channel][frame]

    def depth(self, frame: int) -> Floats:
        """Along the camera's axis [m], NaN where nothing is, shape [H, L]."""
        codes = self.codes("depth", frame).astype(float)
        offset, scale = self.record.depth_offset[frame], self.record.depth_scale[frame]
        return np.where(codes > 0, np.exp(float(offset) + float(scale) * codes), np.nan)

    def ids(self, frame: int) -> NDArray[np.uint16]:
        """Of what each pixel shows, shape [H, L]."""
        return self.codes("segmentation", frame)

    def shift(self, channel: str, frame: int) -> Floats:
        """Flow [px], NaN where it is not known, shape [H, L, 2]."""
        codes = self.codes(channel, frame).astype(float)
        scale = float(getattr(self.record, f"{channel}_scale")[frame])
        return np.where(codes[..., 2:] > 0, (codes[..., :2] - 32768.0) * scale, np.nan)

    def shares(self, frame: int) -> Floats:
        """Object coordinates as shares of the object's bounds, NaN where there is no object."""
        codes = self.codes("object_coordinates", frame).astype(float)
        return np.where(codes.any(axis=-1, keepdims=True), (codes - 1.0) / 65534.0, np.nan)

    def unprojected(self, frame: int, x: Floats, y: Floats, depth: Floats) -> Floats:
        """World points [m] of places in a picture [px] at their depths [m], shape [n, 3]."""
        k = self.record.intrinsics
        local = np.stack([(x - k.cx) / k.fx * depth, (y - k.cy) / k.fy * depth, depth], axis=-1)
        turn = Rotation.from_quat(self.record.camera_quaternion_xyzw[frame].astype(float))
        return turn.apply(local) + self.record.camera_position_m[frame].astype(float)

    def projected(self, frame: int, points: Floats) -> tuple[Floats, Floats]:
        """Places in a picture [px], shape [n, 2], and depths [m], shape [n], of world points."""
        k = self.record.intrinsics
        turn = Rotation.from_quat(self.record.camera_quaternion_xyzw[frame].astype(float))
        local = turn.inv().apply(points - self.record.camera_position_m[frame].astype(float))
        ahead = np.where(local[:, 2] > 1e-6, local[:, 2], np.nan)
        place = local[:, :2] / ahead[:, None] * (k.fx, k.fy) + (k.cx, k.cy)
        return place, local[:, 2]

    def into(self, frame: int, ids: NDArray[Any], points: Floats) -> Floats:
        """World points in the axes of the objects they are on [m]; of no object: as they are."""
        return self._by_object(frame, ids, points, inward=True)

    def out_of(self, frame: int, ids: NDArray[Any], points: Floats) -> Floats:
        """The inverse of `into`."""
        return self._by_object(frame, ids, points, inward=False)

    def _by_object(self, frame: int, ids: Any, points: Floats, *, inward: bool) -> Floats:
        out = np.array(points, float)
        for number in np.unique(ids[ids >= FIRST_BODY]):
            mine, k = ids == number, self.place_of(int(number))
            at = self.record.object_position_m[frame, k].astype(float)
            turn = Rotation.from_quat(self.record.object_quaternion_xyzw[frame, k].astype(float))
            if inward:
                out[mine] = turn.inv().apply(points[mine] - at)
            else:
                out[mine] = turn.apply(points[mine]) + at
        return out

    def place_of(self, number: int) -> int:
        """Where an object of an id stands in the clip's lists."""
        return [o.id for o in self.record.objects].index(number)

    def rigid(self, ids: NDArray[Any], local: Floats) -> NDArray[np.bool_]:
        """Which points move with their objects: not those on wheels that turn on them.

        Args:
            ids: Objects of the points, shape [n].
            local: The points in the axes of their objects [m], shape [n, 3].
        """
        out = np.ones(len(ids), bool)
        for number, wheels in self.wheels.items():
            mine = ids == number
            for center, radius in wheels:
                away = local[mine] - center
                near = np.hypot(away[:, 0], away[:, 2]) < 1.05 * radius + 0.01
                out[mine] &= ~(near & (np.abs(away[:, 1]) < radius))
        return out
