"""What layouts are written from: the clips of a finished dataset with all that is known of them.

Tables are sorted by scene, so that they are joined as they are read: memory holds one scene.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
import hashlib
from itertools import groupby
from pathlib import Path
from typing import Any

from esg.dataset.clips.reading import Clip
from esg.dataset.clips.records import PLAIN_COLUMNS, ClipRecord
from esg.store.assembling import SPLITS
from esg.store.checking import DIGEST_KEY
from esg.store.tables import COLUMNS, iter_rows, part_files

Row = Mapping[str, Any]

_NOT_DATA = ("runs", "timings")
"""Tables that tell when and how long, not what."""


@dataclass(frozen=True)
class Sample:
    """One clip and its scene.

    Args:
        clip: What the camera saw.
        scene: Row of table `scenes`, without the documents of its stages.
        more: Rows of the scene in other tables, by table; none where there is no such table.
    """

    clip: Clip
    scene: Row
    more: Mapping[str, Sequence[Row]] = field(default_factory=dict[str, Sequence[Row]])

    @property
    def key(self) -> str:
        """Unique in the dataset, of letters that no format takes for its own."""
        plain = self.clip.record.scene_id.replace(".", "_")
        return f"{plain}_camera_{self.clip.record.camera}"


@dataclass(frozen=True)
class Source:
    """A finished dataset.

    Args:
        folder: Of the dataset.
    """

    folder: Path

    def samples(self, split: str, tables: Sequence[str] = ()) -> Iterator[Sample]:
        """All clips of a split in the order of scenes and cameras.

        Args:
            split: train, validation or test.
            tables: Others whose rows of the scene are wanted.
        """
        scenes = _scenes(self.folder, "scenes", split, _SCENE_COLUMNS)
        others = {t: _Joined(_scenes(self.folder, t, split)) for t in tables}
        others["clips"] = _Joined(_scenes(self.folder, "clips", split, PLAIN_COLUMNS))
        for key, rows in scenes:
            found = {table: joined.of(key) for table, joined in others.items()}
            for row in found.pop("clips"):
                yield Sample(Clip(self.folder, ClipRecord.of(row)), rows[0], found)

    def clips(self, split: str, columns: Sequence[str]) -> Iterator[Row]:
        """Some columns of the clips of a split, in the same order."""
        for _, rows in _scenes(self.folder, "clips", split, ("scene_key", *columns)):
            yield from rows

    @property
    def has_clips(self) -> bool:
        """Whether anything of it was rendered."""
        return bool(part_files(self.folder, "clips"))

    def digest(self) -> str:
        """What changes when the data change: 64 hex digits."""
        import pyarrow.parquet as pq

        digest = hashlib.sha256()
        for path in part_files(self.folder):
            if path.parent.name not in _NOT_DATA:
                facts = pq.read_schema(path.absolute()).metadata or {}
                name = path.relative_to(self.folder).as_posix()
                digest.update(f"{name} {facts.get(DIGEST_KEY, b'').decode()}\n".encode())
        return digest.hexdigest()


_SCENE_COLUMNS = tuple(
    name
    for name in COLUMNS["scenes"]
    if not name.startswith("esg_") and name not in ("artifacts", "preview")
)


class _Joined:
    """Rows of a table by scene, asked for in order."""

    def __init__(self, groups: Iterator[tuple[str, list[Row]]]) -> None:
        self._groups = groups
        self._next = next(groups, None)

    def of(self, key: str) -> list[Row]:
        """Rows of a scene; those of scenes before it are left behind."""
        while self._next is not None and self._next[0] < key:
            self._next = next(self._groups, None)
        if self._next is None or self._next[0] != key:
            return []
        return self._next[1]


def _scenes(
    folder: Path, table: str, split: str, columns: Sequence[str] | None = None
) -> Iterator[tuple[str, list[Row]]]:
    """Scene keys of a table in order, each with its rows."""
    rows = _rows(folder, table, split, columns)
    for key, group in groupby(rows, key=lambda row: str(row["scene_key"])):
        yield key, list(group)


def _rows(
    folder: Path, table: str, split: str, columns: Sequence[str] | None
) -> Iterator[dict[str, Any]]:
    files = [p for p in part_files(folder, table) if p.name.startswith(f"{split}-")]
    return iter_rows(files, columns, rows=16)


def splits() -> tuple[str, ...]:
    """Names of the splits in the order in which layouts have them."""
    return SPLITS
