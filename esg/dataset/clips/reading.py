"""Reading clips back: rows of table `clips`, and frames in the units of their meaning."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dataset.clips.encoding import decoded
from esg.dataset.clips.records import PLAIN_COLUMNS, ClipRecord
from esg.outcomes import UserError
from esg.store.tables import iter_rows, part_files
from esg.view.seeing import codes


@dataclass(frozen=True)
class Clip:
    """One clip of a dataset.

    Args:
        folder: Of the dataset.
        record: What is known of it.
    """

    folder: Path
    record: ClipRecord

    def path(self, channel: str) -> Path:
        """The file of a channel.

        Raises:
            UserError: If the clip has no such file.
        """
        for file in self.record.files:
            if file.channel == channel:
                return self.folder / file.path
        had = ", ".join(f.channel for f in self.record.files)
        raise UserError(f"clip {self.record.scene_id} has no file of {channel!r}, only of {had}")

    def frames(self, channel: str) -> NDArray[Any]:
        """All frames of a channel: n frames of height H and width L.

        Returns:
            `rgb` uint8 [n, H, L, 3]; `depth` [m], 0 nothing, [n, H, L]; `segmentation` uint16 ids
            [n, H, L]; `flow` and `backward_flow` [px], NaN where unknown, [n, H, L, 2]; `normal` in
            the world, 0 nothing, [n, H, L, 3]; `object_coordinates` in [0, 1], NaN where there is
            no body, [n, H, L, 3].

        Raises:
            UserError: If the clip has no such file, or it is damaged.
        """
        found = decoded(self.path(channel))
        if len(found) != self.record.n_frames:
            raise UserError(
                f"{self.path(channel)} holds {len(found)} frames, not {self.record.n_frames}; "
                "render it again"
            )
        return _MEANT[channel](self.record, found)


def read_clips(folder: Path, split: str | None = None) -> Iterator[Clip]:
    """Clips of a dataset, finished or not, in the order of their files.

    Args:
        folder: Of the dataset.
        split: Only those of train, validation or test.
    """
    files = part_files(folder, "clips") or part_files(folder / "parts", "clips")
    for row in iter_rows(files, PLAIN_COLUMNS):
        if split is None or row["split"] == split:
            yield Clip(Path(folder), ClipRecord.of(row))


def _depth(record: ClipRecord, found: NDArray[Any]) -> NDArray[Any]:
    rows = zip(found, record.depth_offset, record.depth_scale, strict=True)
    return np.stack([codes.depth_metres(c, o, s) for c, o, s in rows])


def _shift(scales: NDArray[Any], found: NDArray[Any]) -> NDArray[Any]:
    pairs = [codes.shift_pixels(c, s) for c, s in zip(found, scales, strict=True)]
    return np.stack([np.where(known[..., None], shift, np.nan) for shift, known in pairs])


def _places(_: ClipRecord, found: NDArray[Any]) -> NDArray[Any]:
    known = found.any(axis=-1, keepdims=True)
    return np.where(known, codes.place_shares(found), np.nan).astype(np.float32)


_MEANT: dict[str, Callable[[ClipRecord, NDArray[Any]], NDArray[Any]]] = {
    "rgb": lambda _, found: found,
    "depth": _depth,
    "segmentation": lambda _, found: found,
    "flow": lambda record, found: _shift(record.flow_scale, found),
    "backward_flow": lambda record, found: _shift(record.backward_flow_scale, found),
    "normal": lambda _, found: codes.normal_vectors(found),
    "object_coordinates": _places,
}
