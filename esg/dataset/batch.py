"""Making one batch of scenes: all stages, then its Parquet parts, recordings and mark.

A batch is the unit of work, of resuming and of scheduling. It works in a folder of its own, where
finished stages are kept until the batch is done: a batch that was killed goes on where it stopped.
Its mark is written last; a batch with a mark is never made again.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
import json
from pathlib import Path
import shutil
import time
from typing import TYPE_CHECKING, Any

from esg.dataset.plan import DatasetSpec, PlannedScene
from esg.dataset.running import SCENE_STAGES, run_scenes
from esg.dataset.writing import write_batch
from esg.pipeline import scratch_store

if TYPE_CHECKING:
    from esg.store.records import RunInfo


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

    @property
    def searches_together(self) -> bool:
        """Whether the optimize stage is one search of all scenes."""
        return self.spec.device != "cpu" if self.together is None else self.together

    @property
    def name(self) -> str:
        """File name of its parts and its mark."""
        return batch_name(self.number)


@dataclass(frozen=True)
class BatchResult:
    """What came of a batch; the content of its mark.

    Args:
        number: Of the batch.
        scenes: Number of scenes.
        verified: Number of verified scenes.
        outcomes: Number of scenes by outcome.
        failures: Rows of `failures.jsonl`.
        crashes: Traceback by scene id.
        seconds: Time spent [s], by stage, for `recordings` and for the `batch` in all; no part of
            the dataset.
        files: Size in bytes of every file written, by path below the dataset's folder.
    """

    number: int
    scenes: int
    verified: int
    outcomes: Mapping[str, int]
    failures: Sequence[Mapping[str, Any]] = ()
    crashes: Mapping[str, str] = field(default_factory=dict)
    seconds: Mapping[str, float] = field(default_factory=dict)
    files: Mapping[str, int] = field(default_factory=dict)

    def to_json(self) -> str:
        """Text of the mark."""
        return json.dumps(vars(self), indent=1, sort_keys=True, ensure_ascii=False) + "\n"

    @staticmethod
    def from_json(text: str) -> BatchResult:
        """The inverse of `to_json`.

        Raises:
            ValueError, TypeError: If the text is no mark.
        """
        return BatchResult(**json.loads(text))


def batch_name(number: int) -> str:
    """File name of a batch's parts and mark."""
    return f"batch-{number:06d}"


def make_batch(job: BatchJob) -> BatchResult:
    """Makes all scenes of a batch and writes what they leave, or finds that it is done.

    A scene that fails leaves its reason and the others go on. Errors that may pass are retried;
    those that do not pass end the scene as crashed.

    Returns:
        What came of it.

    Raises:
        OSError: If the batch cannot be written; finished stages are kept.
    """
    from esg.dataset.folder import batch_lock, read_mark

    with batch_lock(job.out, job.number):
        done = read_mark(job.out, job.number)
        result = _make(job) if done is None else done
        if job.url:
            _deliver(job, result)
        return result


def _deliver(job: BatchJob, result: BatchResult) -> None:
    """Brings a batch to where the dataset is, its mark last."""
    from esg.dataset.folder import mark_name
    from esg.dataset.remote import Remote

    remote, mark = Remote(job.url), mark_name(job.number)
    if not remote.has(mark):
        remote.push(job.out, [*result.files, mark])


def _make(job: BatchJob) -> BatchResult:
    from esg.dataset.folder import write_mark

    start = time.perf_counter()
    with scratch_store(job.work / "artifacts", durable=False):
        states, together_s = run_scenes(job)
        result, recordings_s = write_batch(job, states)
    spent = {s: 0.0 for s in SCENE_STAGES}
    for state in states:
        for entry in state.log:
            spent[entry["stage"]] += float(entry["seconds"])
    spent["replay"] += together_s
    spent["recordings"] = recordings_s
    spent["batch"] = time.perf_counter() - start
    result = replace(result, seconds={k: round(v, 4) for k, v in spent.items()})
    write_mark(job.out, result)
    if not job.keep_work:
        shutil.rmtree(job.work, ignore_errors=True)
    return result
