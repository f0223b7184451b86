"""Writing clips: channels in the units of their meaning become files, a scene's files at once."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
import contextlib
from dataclasses import replace
import os
from pathlib import Path
import shutil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dataset.clips.encoding import PICTURES, ChannelFile, Pictures, codec_of
from esg.dataset.clips.records import ClipFile, ClipRecord
from esg.files import TEMPORARY, explained, sync_file, sync_folder, temporary_name
from esg.view.seeing import codes

Values = Mapping[str, NDArray[Any]]
"""Frames by channel: `rgb` uint8 [F, H, L, 3]; `depth` [m], 0 nothing, [F, H, L]; `segmentation`
ids [F, H, L]; `flow` and `backward_flow` [px], NaN where unknown, [F, H, L, 2]; `normal`
[F, H, L, 3]; `object_coordinates`, shares of the body's bounds, NaN where there is no body,
[F, H, L, 3]."""
Scales = dict[str, list[np.float32]]


class ClipWriter:
    """The files of one clip, frame after frame.

    Args:
        folder: Of the clip; made.
        channels: What to write; those that are no pictures are left out.
        size: Width and height [px].
        fps: Frames a second.
        lossless: Whether colours are kept as they are.
    """

    def __init__(
        self,
        folder: Path,
        channels: Sequence[str],
        size: tuple[int, int],
        fps: float,
        *,
        lossless: bool = False,
    ) -> None:
        self._paths: dict[str, Path] = {}
        self._files: dict[str, ChannelFile] = {}
        self.scales: Scales = {}
        for channel in (c for c in PICTURES if c in channels):
            codec = codec_of(channel, lossless=lossless)
            self._paths[channel] = folder / f"{channel}{codec.suffix}"
            self._files[channel] = ChannelFile(self._paths[channel], codec, size, fps)
            self.scales |= {name: [] for name in SCALES.get(channel, ())}

    @property
    def channels(self) -> tuple[str, ...]:
        """What is written."""
        return tuple(self._files)

    def add(self, values: Values) -> None:
        """Encodes the next frames of some channels; each may have a thread of its own.

        Raises:
            OSError: If the disk does not take them.
        """
        for channel, given in values.items():
            names = SCALES.get(channel, ())
            for value in given:  # one by one, while it is in the cache
                picture, scales = CODED[channel](value)
                for name, scale in zip(names, scales, strict=True):
                    self.scales[name].append(scale)
                self._files[channel].add(picture)

    def close(self) -> dict[str, Path]:
        """Writes what is left; returns the files by channel.

        Raises:
            OSError: If the disk does not take it.
        """
        with contextlib.ExitStack() as stack:
            for file in self._files.values():
                stack.callback(file.close)
        return self._paths


SCALES = {
    "depth": ("depth_offset", "depth_scale"),
    "flow": ("flow_scale",),
    "backward_flow": ("backward_flow_scale",),
}
"""Columns with a number a frame that a channel is read with."""

_Coded = tuple[Pictures, tuple[np.float32, ...]]


def _plain(value: NDArray[Any]) -> _Coded:
    return value, ()


def _ids(value: NDArray[Any]) -> _Coded:
    return value.astype(np.uint16), ()


def _depth(value: NDArray[Any]) -> _Coded:
    found, offset, scale = codes.depth_codes(value)
    return found, (offset, scale)


def _flow(value: NDArray[Any]) -> _Coded:
    found, scale = codes.shift_codes(value)
    return found, (scale,)


def _normal(value: NDArray[Any]) -> _Coded:
    return codes.normal_codes(value), ()


def _places(value: NDArray[Any]) -> _Coded:
    # By colour: numpy reduces over so short an axis seven times as slowly.
    x, y, z = (np.isfinite(value[..., k]) for k in range(3))
    return codes.place_codes(value, x & y & z), ()


CODED: dict[str, Callable[[NDArray[Any]], _Coded]] = {
    "rgb": _plain,
    "depth": _depth,
    "segmentation": _ids,
    "flow": _flow,
    "backward_flow": _flow,
    "normal": _normal,
    "object_coordinates": _places,
}
"""A frame as it is encoded, and the numbers it is read with, of the values of a channel."""


def clip_folder(scene_id: str, camera: int) -> str:
    """Where a clip's files are below the dataset's folder."""
    return f"clips/{scene_id}/camera_{camera}"


def write_clip(
    out: Path, record: ClipRecord, values: Values, *, lossless: bool = False
) -> ClipRecord:
    """Writes all frames of a clip at once.

    Args:
        out: Folder of the dataset.
        record: What is known of the clip; files and scales are filled in.
        values: All its frames.
        lossless: Whether colours are kept as they are.

    Returns:
        The record, complete.

    Raises:
        OSError: If the disk does not take them.
    """
    place = clip_folder(record.scene_id, record.camera)
    size = (record.width, record.height)
    with whole_folder(out / place) as folder:
        writer = ClipWriter(folder, record.channels, size, record.fps, lossless=lossless)
        writer.add({channel: values[channel] for channel in writer.channels})
        paths = writer.close()
        return filed(record, writer.scales, paths, place)


def filed(record: ClipRecord, scales: Scales, paths: Mapping[str, Path], place: str) -> ClipRecord:
    """The record of a clip with its files and scales.

    Args:
        record: Without them.
        scales: Of its writer.
        paths: Files by channel, complete.
        place: Folder that they will be in, below the dataset's.
    """
    files = tuple(
        ClipFile(channel, f"{place}/{path.name}", path.stat().st_size)
        for channel, path in paths.items()
    )
    arrays = {name: np.array(values, np.float32) for name, values in scales.items()}
    return replace(record, files=files, **arrays)


@contextlib.contextmanager
def whole_folder(path: Path) -> Generator[Path]:
    """A temporary folder that becomes `path` when the block ends, or vanishes if it fails.

    Raises:
        OSError: With the remedy in its text for a full, read-only or forbidden disk.
    """
    temporary = temporary_name(path)
    try:
        temporary.mkdir(parents=True)
        yield temporary
        for file in sorted(p for p in temporary.rglob("*") if p.is_file()):
            sync_file(file)
        if path.exists():
            shutil.rmtree(path)
        os.replace(temporary, path)
        sync_folder(path.parent)
    except OSError as error:
        raise explained(error, path) from error
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def sweep_clips(folder: Path) -> None:
    """Removes what killed writers left of scenes' folders."""
    for path in folder.glob(f".*{TEMPORARY}"):
        shutil.rmtree(path, ignore_errors=True)
