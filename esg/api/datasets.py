"""Reading datasets that `esg dataset` made."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from esg.outcomes import UserError

if TYPE_CHECKING:
    import pyarrow as pa

    from esg.dataset.clips.reading import Clip


@dataclass(frozen=True)
class Dataset:
    """A finished dataset (docs/dataset.md).

    Args:
        folder: Where it lies.
        info: Of its `meta/info.json`: format version, counts, splits.
    """

    folder: Path
    info: dict[str, Any]

    @property
    def tables(self) -> tuple[str, ...]:
        """Names of its tables."""
        return tuple(
            sorted(p.name for p in self.folder.iterdir() if p.is_dir() and any(p.glob("*.parquet")))
        )

    def table(self, name: str = "scenes", split: str | None = None) -> pa.Table:
        """One table, whole.

        Args:
            name: One of `tables`.
            split: train, validation or test; None for all.

        Raises:
            UserError: If there is no such table or split.
        """
        import pyarrow.parquet as pq

        return pq.ParquetDataset(self._files(name, split)).read()

    def rows(self, name: str = "scenes", split: str | None = None) -> Iterator[dict[str, Any]]:
        """The rows of a table one by one, a few at a time in memory.

        Args:
            name: One of `tables`.
            split: train, validation or test; None for all.

        Raises:
            UserError: If there is no such table or split.
        """
        import pyarrow.parquet as pq

        for path in self._files(name, split):
            with pq.ParquetFile(path) as file:
                for batch in file.iter_batches(batch_size=64):
                    yield from batch.to_pylist()

    def clips(self, split: str | None = None) -> Iterator[Clip]:
        """What cameras saw of its scenes, one clip a scene and camera (docs/dataset/clips.md).

        Args:
            split: train, validation or test; None for all.

        Raises:
            UserError: If it was not rendered, or there is no such split.
        """
        from esg.dataset.clips.reading import read_clips

        self._files("clips", split)
        yield from read_clips(self.folder, split)

    def __len__(self) -> int:
        """Number of scenes."""
        import pyarrow.parquet as pq

        return sum(pq.read_metadata(p).num_rows for p in self._files("scenes", None))

    def _files(self, name: str, split: str | None) -> list[Path]:
        if name not in self.tables:
            raise UserError(f"{self.folder} has no table {name!r}; it has {', '.join(self.tables)}")
        found = sorted((self.folder / name).glob("*.parquet"))
        splits = sorted({p.name.split("-")[0] for p in found})
        chosen = [p for p in found if split is None or p.name.startswith(f"{split}-")]
        if not chosen:
            raise UserError(
                f"{self.folder / name} has no split {split!r}; it has {', '.join(splits)}"
            )
        return chosen


def load_dataset(folder: str | Path) -> Dataset:
    """A finished dataset.

    Args:
        folder: That `esg dataset --out` named.

    Raises:
        UserError: If there is none, or it is not finished.
    """
    from esg.dataset.folder import INFO, DatasetFolder
    from esg.scenereading import read_object

    path = Path(folder)
    found = DatasetFolder(path)
    if found.spec() is None:
        raise UserError(f"{path} holds no dataset")
    if not found.finished():
        raise UserError(f"the dataset in {path} is not finished; esg dataset --resume goes on")
    return Dataset(path, read_object(path / INFO))
