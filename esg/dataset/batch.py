"""Making one batch of scenes: all stages, then its Parquet parts, recordings and mark.

A batch is the unit of work, of resuming and of scheduling. It works in a folder of its own, where
finished stages are kept until the batch is done: a batch that was killed goes on where it stopped.
Its mark is written last; a batch with a mark is never made again.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from esg.costs.spent import Meter
from esg.dataset.folder import batch_lock, mark_name, read_mark, write_mark
from esg.dataset.job import CROSSCHECK, BatchJob, BatchResult
from esg.dataset.meshes import BUFFERS
from esg.dataset.running import SCENE_STAGES, Made, batch_store, rendered_scenes, run_scenes
from esg.dataset.writing import write_batch
from esg.machine.memory import give_back
from esg.machine.removing import remove_beside
from esg.store.tables import TABLES, part_files, to_table, write_part

if TYPE_CHECKING:
    from esg.dataset.clips.batch import Rendered


def make_batch(job: BatchJob) -> BatchResult:
    """Makes all scenes of a batch and writes what they leave, or finds that it is done.

    A scene that fails leaves its reason and the others go on. Errors that may pass are retried;
    those that do not pass end the scene as crashed.

    Returns:
        What came of it.

    Raises:
        OSError: If the batch cannot be written; finished stages are kept.
    """
    with batch_lock(job.out, job.number):
        done = read_mark(job.out, job.number)
        result = _make(job) if done is None else done
        if done is None:
            give_back()
        if job.url:
            _deliver(job, result)
        return result


def _deliver(job: BatchJob, result: BatchResult) -> None:
    """Brings a batch to where the dataset is, its mark last."""
    from esg.dataset.remote import Remote, is_media

    whole, mark = Remote(job.url), mark_name(job.number)
    # Of a dataset that is only rendered, marks and parts are kept apart until all is done.
    remote = whole if job.source is None else whole.below(job.out.name)
    if not remote.has(mark):
        # A buffer's name is its content: what other batches brought is not brought again.
        there = {n for n in result.files if n.startswith(BUFFERS) and whole.has(n)}
        whole.push(job.out, [n for n in result.files if is_media(n)])
        rest = [n for n in result.files if not is_media(n) and n not in there]
        remote.push(job.out, [*rest, mark])


def _make(job: BatchJob) -> BatchResult:
    spent = Meter()
    with spent.on("batch"):
        result = _only_rendered(job, spent) if job.source is not None else whole(job, spent)
    return _marked(job, timed(result, spent))


def timed(result: BatchResult, spent: Meter) -> BatchResult:
    """The result with what it took."""
    return replace(
        result,
        seconds={k: round(v, 4) for k, v in spent.seconds.items()},
        core_seconds={k: round(v, 4) for k, v in spent.core_seconds.items()},
    )


def close_batch(job: BatchJob, shares: Sequence[BatchResult]) -> BatchResult:
    """Marks a batch that was made in shares, all of which are there.

    Args:
        job: The batch.
        shares: What came of them, in order.

    Raises:
        OSError: If the mark cannot be written.
    """
    with batch_lock(job.out, job.number):
        result = _marked(job, merged(job.number, shares))
        if job.url:
            _deliver(job, result)
        return result


def merged(number: int, shares: Sequence[BatchResult]) -> BatchResult:
    """The result of a batch that consists of these."""

    def total(parts: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
        out: Counter[str] = Counter()
        for part in parts:
            out.update(part)
        return dict(out)

    return BatchResult(
        number=number,
        scenes=sum(s.scenes for s in shares),
        verified=sum(s.verified for s in shares),
        outcomes=total(s.outcomes for s in shares),
        failures=[row for s in shares for row in s.failures],
        crashes={k: v for s in shares for k, v in s.crashes.items()},
        seconds={k: round(v, 4) for k, v in total(s.seconds for s in shares).items()},
        core_seconds={k: round(v, 4) for k, v in total(s.core_seconds for s in shares).items()},
        files={k: v for s in shares for k, v in s.files.items()},
    )


def _marked(job: BatchJob, result: BatchResult) -> BatchResult:
    """Says that a batch is done and removes what nobody needs any more."""
    # An attempt that was killed may have made it in shares, or not in shares.
    names = (job.name, *(share.name for share in job.shares()))
    for part in (f"parts/{table}/{name}.parquet" for table in TABLES for name in names):
        if part not in result.files:
            (job.out / part).unlink(missing_ok=True)
    write_mark(job.out, result)
    if not job.keep_work:
        remove_beside(job.work)
    return result


def whole(job: BatchJob, spent: Meter) -> BatchResult:
    """All stages of all scenes, with their clips if they are to have any."""
    with batch_store(job):
        return leave(job, run_scenes(job, spent), spent)


def leave(job: BatchJob, made: Made, spent: Meter) -> BatchResult:
    """Writes what a batch or a share of one leaves, with its clips if it is to have any.

    Args:
        job: The batch.
        made: Its scenes, whose results are in the current store.
        spent: What all that takes is added, and what the logs of the scenes tell.
    """
    for stage in SCENE_STAGES:
        spent.add(stage, 0.0, 0.0)
    rendered = rendered_scenes(job, made.states, spent)
    result = write_batch(job, made, rendered, spent)
    for state in made.states:
        for entry in state.log:
            seconds = float(entry["seconds"])
            spent.add(entry["stage"], seconds, float(entry.get("core_seconds", 0.0)))
    return _checked(job, result, rendered, spent) if job.spec.render else result


def _only_rendered(job: BatchJob, spent: Meter) -> BatchResult:
    """Clips of scenes that a finished dataset holds."""
    rendered = rendered_scenes(job, [], spent)
    rows = [row for found in rendered.rows.values() for row in found]
    files = list(rendered.files)
    if rows:
        part = job.out / "parts" / "clips" / f"{job.name}.parquet"
        write_part(to_table("clips", rows), part)
        files.append(part)
    result = BatchResult(
        number=job.number,
        scenes=len(job.scenes),
        verified=0,
        outcomes={},
        failures=rendered.failures,
        crashes=rendered.crashes,
        files={p.relative_to(job.out).as_posix(): p.stat().st_size for p in files},
    )
    return _checked(job, result, rendered, spent)


def _checked(job: BatchJob, result: BatchResult, rendered: Rendered, spent: Meter) -> BatchResult:
    """The result with the checks of a sample of its clips."""
    from esg.dataset.crosscheck import check_batch

    rows = [row for found in rendered.rows.values() for row in found]
    told = {
        table: part_files(job.source, table)
        if job.source is not None
        else [job.out / "parts" / table / f"{job.name}.parquet"]
        for table in ("scenes", "trajectories")
    }
    with spent.on(CROSSCHECK):
        part = check_batch(job.out, rows, job.name, told) if rows else None
    if part is None:
        return result
    files = {**result.files, part.relative_to(job.out).as_posix(): part.stat().st_size}
    return replace(result, files=files)
