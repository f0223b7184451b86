"""Making one batch of scenes: all stages, then its Parquet parts, recordings and mark.

A batch is the unit of work, of resuming and of scheduling. It works in a folder of its own, where
finished stages are kept until the batch is done: a batch that was killed goes on where it stopped.
Its mark is written last; a batch with a mark is never made again.
"""

from __future__ import annotations

from dataclasses import replace
import shutil
import time
from typing import TYPE_CHECKING

from esg.costs.spent import core_time
from esg.dataset.folder import batch_lock, mark_name, read_mark, write_mark
from esg.dataset.job import CROSSCHECK, RENDER, BatchJob, BatchResult
from esg.dataset.meshes import BUFFERS
from esg.dataset.running import SCENE_STAGES, rendered_scenes, run_scenes
from esg.dataset.writing import write_batch
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
    start, core_start = time.perf_counter(), core_time()
    if job.source is not None:
        result, spent = _only_rendered(job)
        cores = {RENDER: core_time() - core_start} if RENDER in spent else {}
    else:
        with scratch_store(job.work / "artifacts", durable=False):
            states, together_s = run_scenes(job)
            marks = [core_time()]
            rendered = rendered_scenes(job, states)
            marks.append(core_time())
            result, recordings_s = write_batch(job, states, rendered)
        marks.append(core_time())
        result, checks_s = _checked(job, result, rendered)
        marks.append(core_time())
        spent = {s: 0.0 for s in SCENE_STAGES}
        cores = dict(spent)
        for state in states:
            for entry in state.log:
                name = entry["stage"]
                spent[name] = spent.get(name, 0.0) + float(entry["seconds"])
                cores[name] = cores.get(name, 0.0) + float(entry.get("core_seconds", 0.0))
        spent["replay"] += together_s[0]
        cores["replay"] += together_s[1]
        spent["recordings"] = recordings_s
        if job.spec.render:
            spent |= {RENDER: rendered.seconds, CROSSCHECK: checks_s}
            cores |= {RENDER: marks[1] - marks[0], CROSSCHECK: marks[3] - marks[2]}
    spent["batch"] = time.perf_counter() - start
    cores["batch"] = core_time() - core_start
    result = replace(
        result,
        seconds={k: round(v, 4) for k, v in spent.items()},
        core_seconds={k: round(v, 4) for k, v in cores.items()},
    )
    write_mark(job.out, result)
    if not job.keep_work:
        shutil.rmtree(job.work, ignore_errors=True)
    return result


def _only_rendered(job: BatchJob) -> tuple[BatchResult, dict[str, float]]:
    """Clips of scenes that a finished dataset holds."""
    rendered = rendered_scenes(job, [])
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
    result, checks_s = _checked(job, result, rendered)
    return result, {RENDER: rendered.seconds, CROSSCHECK: checks_s}


def _checked(job: BatchJob, result: BatchResult, rendered: Rendered) -> tuple[BatchResult, float]:
    """The result with the checks of a sample of its clips, and how long they took [s]."""
    from esg.dataset.crosscheck import check_batch

    start = time.perf_counter()
    rows = [row for found in rendered.rows.values() for row in found]
    told = {
        table: part_files(job.source, table)
        if job.source is not None
        else [job.out / "parts" / table / f"{job.name}.parquet"]
        for table in ("scenes", "trajectories")
    }
    part = check_batch(job.out, rows, job.name, told) if rows else None
    if part is None:
        return result, 0.0
    files = {**result.files, part.relative_to(job.out).as_posix(): part.stat().st_size}
    return replace(result, files=files), time.perf_counter() - start
