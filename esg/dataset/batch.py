"""Making one batch of scenes: all stages, then its Parquet parts, recordings and mark.

A batch is the unit of work, of resuming and of scheduling. It works in a folder of its own, where
finished stages are kept until the batch is done: a batch that was killed goes on where it stopped.
Its mark is written last; a batch with a mark is never made again.
"""

from __future__ import annotations

from dataclasses import replace
import shutil
from typing import TYPE_CHECKING

from esg.costs.spent import Meter
from esg.dataset.folder import batch_lock, mark_name, read_mark, write_mark
from esg.dataset.job import CROSSCHECK, BatchJob, BatchResult
from esg.dataset.meshes import BUFFERS
from esg.dataset.running import SCENE_STAGES, rendered_scenes, run_scenes
from esg.dataset.writing import write_batch
from esg.machine.memory import give_back
from esg.pipeline import scratch_store
from esg.store.tables import part_files, to_table, write_part

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
        result = _only_rendered(job, spent) if job.source is not None else _whole(job, spent)
    result = replace(
        result,
        seconds={k: round(v, 4) for k, v in spent.seconds.items()},
        core_seconds={k: round(v, 4) for k, v in spent.core_seconds.items()},
    )
    write_mark(job.out, result)
    if not job.keep_work:
        shutil.rmtree(job.work, ignore_errors=True)
    return result


def _whole(job: BatchJob, spent: Meter) -> BatchResult:
    """All stages of all scenes, with their clips if they are to have any."""
    for stage in SCENE_STAGES:
        spent.add(stage, 0.0, 0.0)
    with scratch_store(job.work / "artifacts", durable=False):
        made = run_scenes(job, spent)
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
