"""One batch of a dataset: what is to be made, and what came of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
import hashlib
from itertools import pairwise
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from esg.dataset.plan import DatasetSpec, PlannedScene

if TYPE_CHECKING:
    from esg.store.records import RunInfo


RENDER = "render"
"""What failures and timings call the pictures of a batch's scenes."""
SHARE = 16
"""Scenes that a worker makes at once of a batch that several make: as many classes as share a unit
of the compiler."""
CROSSCHECK = "crosscheck"
"""What timings call the checks of a sample of them."""


@dataclass(frozen=True)
class BatchJob:
    """One batch; small, so that it can travel to any machine.

    Args:
        number: Of the batch in the dataset.
        spec: Of the dataset.
        run: Of the dataset.
        scenes: Of the batch.
        out: Local folder of the dataset (parts, recordings, marks).
        work: Local folder for the stages of this batch; deleted when it is done.
        stage_limit_s: A stage that runs longer ends the worker; 0: no limit.
        keep_work: Whether to leave the stages' results in `work`.
        processes: That plan and measure beside the one that simulates, where searches run together.
        together: Whether the searches of the batch share launches; None: on a GPU.
        url: Where finished batches go (esg.dataset.remote); empty: they stay in `out`.
        source: A finished dataset that holds the scenes, which are only rendered; None: they are
            made.
        share: Which of its shares this is (`shares`); None: all of it.
        parted: Whether several workers make it, each some shares: there is no other work for them.
    """

    number: int
    spec: DatasetSpec
    run: RunInfo
    scenes: tuple[PlannedScene, ...]
    out: Path
    work: Path
    stage_limit_s: float = 0.0
    keep_work: bool = False
    processes: int = 1
    together: bool | None = None
    url: str = ""
    source: Path | None = None
    share: int | None = None
    parted: bool = False

    @property
    def searches_together(self) -> bool:
        """Whether the optimize stage is one search of all scenes."""
        return self.spec.device != "cpu" if self.together is None else self.together

    @property
    def name(self) -> str:
        """File name of its parts, and of a whole batch's mark."""
        name = batch_name(self.number)
        return name if self.share is None else f"{name}-{self.share:02d}"

    def shares(self) -> list[BatchJob]:
        """The batch in shares of some 16 scenes, where several workers make it."""
        count = -(-len(self.scenes) // SHARE)
        cuts = [len(self.scenes) * k // count for k in range(count + 1)]
        return [
            replace(self, scenes=self.scenes[a:b], share=k)
            for k, (a, b) in enumerate(pairwise(cuts))
        ]


@dataclass(frozen=True)
class BatchResult:
    """What came of a batch; the content of its mark.

    Args:
        number: Of the batch.
        scenes: Number of scenes.
        verified: Number of verified scenes: solved, as expected and as stated (docs/dataset.md).
        outcomes: Number of scenes by outcome.
        failures: Rows of `failures.jsonl`.
        crashes: Traceback by scene id.
        seconds: Time spent [s], by stage, for `recordings` and for the `batch` in all; no part of
            the dataset.
        core_seconds: Processor time by the same names [s], likewise.
        files: Size in bytes of every file written, by path below the dataset's folder.
    """

    number: int
    scenes: int
    verified: int
    outcomes: Mapping[str, int]
    failures: Sequence[Mapping[str, Any]] = ()
    crashes: Mapping[str, str] = field(default_factory=dict)
    seconds: Mapping[str, float] = field(default_factory=dict)
    core_seconds: Mapping[str, float] = field(default_factory=dict)
    files: Mapping[str, int] = field(default_factory=dict)

    def to_json(self) -> str:
        """Text of the mark, with its own hash."""
        told = vars(self) | {"sha256": _hash(vars(self))}
        return json.dumps(told, indent=1, sort_keys=True, ensure_ascii=False) + "\n"

    @staticmethod
    def from_json(text: str) -> BatchResult:
        """The inverse of `to_json`.

        Raises:
            ValueError, TypeError: If the text is no mark, or a damaged one.
        """
        fields = dict(json.loads(text))
        if fields.pop("sha256", None) != _hash(fields):
            raise ValueError("the mark is damaged")
        return BatchResult(**fields)


def _hash(fields: Mapping[str, Any]) -> str:
    text = json.dumps(fields, sort_keys=True, ensure_ascii=False)
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()


def batch_name(number: int) -> str:
    """File name of a batch's parts and mark."""
    return f"batch-{number:06d}"
