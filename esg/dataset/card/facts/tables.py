"""The tables of a dataset, as facts are drawn from them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
import math
from pathlib import Path
from typing import Any

from esg.store.tables import iter_rows, part_files

SCENE_COLUMNS = (
    "scene_key", "scene_id", "prompt", "family", "level", "rule", "pair", "changed", "parameters",
    "outcome", "verified", "slr", "n_events", "n_completed", "ppa", "proof", "fully_understood",
    "plausible",
)  # fmt: skip


@dataclass(frozen=True)
class Tables:
    """A finished dataset.

    Args:
        out: Its folder.
    """

    out: Path

    def has(self, table: str) -> bool:
        """Whether there is such a table."""
        return bool(part_files(self.out, table))

    def rows(self, table: str, columns: Sequence[str]) -> Iterator[dict[str, Any]]:
        """Rows with some columns; the others (documents, trajectories) are not even read."""
        return iter_rows(part_files(self.out, table), columns)

    @cached_property
    def scenes(self) -> list[dict[str, Any]]:
        """All scenes, without what is large."""
        return list(self.rows("scenes", SCENE_COLUMNS))


def counted(values: Iterable[Any]) -> dict[str, int]:
    """How often each value occurs, by its text."""
    return dict(sorted(Counter(str(v) for v in values).items()))


def spread(values: Sequence[float]) -> dict[str, float]:
    """Least, median, mean and most of at least one number."""
    ordered = sorted(values)
    middle = len(ordered) // 2
    median = ordered[middle] if len(ordered) % 2 else (ordered[middle - 1] + ordered[middle]) / 2
    numbers = (ordered[0], median, math.fsum(ordered) / len(ordered), ordered[-1])
    return dict(zip(("min", "median", "mean", "max"), (round(v, 2) for v in numbers), strict=True))
