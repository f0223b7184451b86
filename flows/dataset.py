"""The `dataset` flow: batches of scenes, in any number of processes or machines."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
import contextlib
from contextvars import ContextVar
from dataclasses import dataclass
import os
from pathlib import Path
from typing import Any, Literal

from prefect import flow, tags
from prefect.task_runners import ThreadPoolTaskRunner

from esg.dataset.job import BatchJob, BatchResult
from esg.outcomes import UserError
from flows import artifacts
from flows.naming import current_name, run_tags
from tasks.context import current
from tasks.dataset import begun_ahead, dataset_batch

__all__ = ["begun_ahead", "dataset", "lost_machine", "with_runner"]

LOST = frozenset(
    {"KilledWorker", "WorkerCrashedError", "NodeDiedError", "ObjectLostError", "CrashedRun"}
)
"""Names of what Dask, Ray and Prefect raise for a task whose machine is gone, or of its bases.

Both clusters run such a task again, but give up when it has lost three or four machines, which a
long batch on machines that are evicted every hour may well.
"""
MOST_LOST = 10
"""A batch is handed to the cluster again so often; a scene that ends its worker is no reason for it
(`tasks.dataset.run_job` finds it), so that only machines are counted."""

AHEAD = 1
"""Batches that are begun beside those that workers make, and wait for one: Prefect takes about a
second to begin a batch, in which a worker would have nothing to do."""

Runner = Literal["process", "dask", "ray"]
Done = Callable[[BatchResult], None]


@dataclass(frozen=True)
class Work:
    """What a run of the flow makes.

    Args:
        jobs: Batches.
        on_batch: Called with every result as soon as it is there.
    """

    jobs: Sequence[BatchJob]
    on_batch: Done | None = None


_WORK: ContextVar[Work] = ContextVar("work")
"""Not a parameter of the flow: Prefect sends those to its API, which refuses more than 512 KiB (the
jobs of some 500 scenes), and to every worker of a cluster with every task."""


def _work() -> Work:
    """This run's work. Clusters are sent the flow's function with the globals it names: it must not
    name the variable itself, which cannot be pickled.
    """
    return _WORK.get()


@flow(name="dataset", flow_run_name=current_name, validate_parameters=False)
def dataset(out: str, scenes: int) -> list[BatchResult]:
    """Makes all batches of a shard that are not done yet.

    Args:
        out: Where to, for whoever looks at the run.
        scenes: How many, likewise.

    Returns:
        Results in the order of the jobs.

    Raises:
        BaseException: The first error of a batch that could not be written, or that lost its
            machine too often; the other batches are made first.
    """
    jobs, on_batch = _work().jobs, _work().on_batch
    results: dict[int, BatchResult] = {}
    errors: dict[int, BaseException] = {}
    ahead: dict[Any, BatchJob] = {dataset_batch.submit(job): job for job in jobs}
    lost = 0
    while ahead:
        ahead = _gather(ahead, lost < MOST_LOST, results, errors, on_batch)
        lost += 1
    _show(list(results.values()))
    if errors:
        raise errors[min(errors)]
    return [results[job.number] for job in jobs]


def _gather(
    futures: dict[Any, BatchJob],
    again: bool,
    results: dict[int, BatchResult],
    errors: dict[int, BaseException],
    on_batch: Done | None,
) -> dict[Any, BatchJob]:
    """Takes what comes of batches as it comes; hands in those that lost their machine once more.

    Returns:
        Those, while `again`.
    """
    from prefect.futures import as_completed

    more: dict[Any, BatchJob] = {}
    for future in as_completed(list(futures)):
        job = futures[future]
        try:
            results[job.number] = future.result()
        except Exception as error:
            if not lost_machine(error):
                errors[job.number] = _explained(error)
            elif again:
                more[dataset_batch.submit(job)] = job
            else:
                errors[job.number] = UserError(
                    f"batch {job.number} lost its machine {MOST_LOST + 1} times ({error}); "
                    "finished batches are kept, run the same command with --resume to go on",
                    exit_code=1,
                )
            continue
        if on_batch is not None:
            with contextlib.suppress(Exception):
                on_batch(results[job.number])
    return more


def _explained(error: Exception) -> Exception:
    """What to do about workers on machines that do not reach the private API of this command."""
    if "Failed to reach API" not in str(error):
        return error
    return UserError(
        f"a worker of the cluster says: {error}. That is Prefect's API, by default a private one "
        "that only this machine reaches: run `prefect server start --host 0.0.0.0` here and set "
        "PREFECT_API_URL=http://THIS-MACHINE:4200/api for this command; finished batches are kept",
        exit_code=1,
    )


def lost_machine(error: BaseException) -> bool:
    """Whether a cluster tells by an error that the machine of a task is gone."""
    return any(kind.__name__ in LOST for kind in type(error).__mro__)


def _show(results: Sequence[BatchResult]) -> None:
    """What Prefect's UI shows of the run."""
    outcomes: Counter[str] = Counter()
    for result in results:
        outcomes.update(result.outcomes)
    rows = [{"outcome": name, "scenes": n} for name, n in sorted(outcomes.items())]
    verified = sum(r.verified for r in results)
    artifacts.table("dataset", rows, f"{verified} of {outcomes.total()} scenes verified")
    artifacts.failures("dataset", [row for r in results for row in r.failures])


def with_runner(
    runner: Runner, workers: int
) -> Callable[[Sequence[BatchJob], Done | None], list[BatchResult]]:
    """The flow with a task runner, as a function of batches and of who is told of their results.

    Args:
        runner: process (worker processes of this command), dask or ray.
        workers: Batches at once.

    Raises:
        UserError: If the runner's package is not installed.
    """
    chosen = dataset.with_options(task_runner=_task_runner(runner, workers))

    def run(jobs: Sequence[BatchJob], on_batch: Done | None = None) -> list[BatchResult]:
        token = _WORK.set(Work(jobs, on_batch))
        try:
            out = str(jobs[0].out) if jobs else ""
            how = jobs[0].spec.model_dump(include={"strategy", "engine", "device"}) if jobs else {}
            with tags(*run_tags("dataset", how), Path(out).name):
                return chosen(out=out, scenes=sum(len(job.scenes) for job in jobs))
        finally:
            _WORK.reset(token)

    return run


def _task_runner(runner: Runner, workers: int) -> Any:
    if runner == "process":
        apart = current().searchers
        in_hand = max(1, workers) + AHEAD if apart is None else apart.in_hand
        return ThreadPoolTaskRunner(max_workers=in_hand)
    # For the processes of a cluster that starts on this machine: they share its cores.
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    os.environ.setdefault("ESG_THREADS", "1")
    # Both packages are extras, which type checkers need not find.
    if runner == "dask":
        os.environ.setdefault("DASK_LOGGING__DISTRIBUTED", "error")
        try:
            from prefect_dask.task_runners import DaskTaskRunner  # pyright: ignore[reportMissingImports]
        except ImportError:
            raise UserError(
                '--runner dask needs its package: pip install "esg-scenes[dask]"'
            ) from None
        return _dask(DaskTaskRunner, workers)
    try:
        from prefect_ray import RayTaskRunner  # pyright: ignore[reportMissingImports]
    except ImportError:
        raise UserError('--runner ray needs its package: pip install "esg-scenes[ray]"') from None
    return _ray(RayTaskRunner, workers)


def _dask(runner: Any, workers: int) -> Any:
    """A running scheduler (`ESG_DASK_ADDRESS`), else a cluster of processes on this machine."""
    address = os.environ.get("ESG_DASK_ADDRESS")
    if address:
        return runner(address=address)
    # One thread each: engines hold state of their process.
    cluster = {"n_workers": max(1, workers), "threads_per_worker": 1, "processes": True,
               "dashboard_address": None}  # fmt: skip
    return runner(cluster_kwargs=cluster)


def _ray(runner: Any, workers: int) -> Any:
    """A running cluster (`RAY_ADDRESS`), else one on this machine."""
    address = os.environ.get("RAY_ADDRESS")
    quiet = {"log_to_driver": False}  # every task's log, twice, on the terminal
    if address:
        return runner(address=address, init_kwargs=quiet)
    here = {"num_cpus": max(1, workers), "include_dashboard": False}
    return runner(init_kwargs={**quiet, **here})
