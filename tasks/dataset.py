"""One batch of a dataset: all stages of its scenes, its Parquet parts, its mark."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
import contextlib
from functools import partial
from itertools import chain
import threading
from typing import Any, TypeVar

from prefect import task
from prefect.cache_policies import NO_CACHE
from prefect.client.schemas.objects import State, TaskRun
from prefect.states import Completed
from prefect.tasks import Task, exponential_backoff

from esg.dataset.batch import close_batch, make_batch
from esg.dataset.folder import read_mark
from esg.dataset.job import BatchJob, BatchResult
from esg.dataset.running import forget_dead, mark_dead, try_scene
from esg.dataset.shares import draft_share, make_share, prove_share, search_batch
from esg.outcomes import UserError
from esg.pipeline import SceneState, may_pass
from esg.workers import WorkerDied, WorkerPool
from tasks.context import Searchers, current, expendable_pool

Result = TypeVar("Result")
RETRIES = 3

DRAFTS, PROOFS = 0, 1
"""Ranks of calls that wait for a worker; of equals the earlier batch comes first."""


def _retry(_: Task[Any, Any], __: TaskRun, state: State[Any]) -> bool:
    failure = state.result(raise_on_failure=False)
    return isinstance(failure, BaseException) and may_pass(failure)


@task(
    name="dataset batch",
    task_run_name="batch {job.number}",
    # The marks in the dataset's folder say what is done.
    cache_policy=NO_CACHE,
    persist_result=False,
    retries=RETRIES,
    retry_delay_seconds=exponential_backoff(1),
    retry_condition_fn=_retry,
)
def dataset_batch(job: BatchJob) -> Any:
    """Makes a batch; where it runs is the task runner's business.

    Returns:
        A `BatchResult`, in a state called `Cached` if the batch was done before.
    """
    if (begun := current().begun.pop((job.out, job.number), None)) is not None:
        return begun.result()
    done = read_mark(job.out, job.number)
    if done is not None:
        return Completed(name="Cached", message="done before", data=done)
    return run_job(job)


def run_job(job: BatchJob) -> BatchResult:
    """Makes a batch in a worker, or in several: scenes that end theirs are found and left out.

    Raises:
        UserError: If workers end whatever scene they are given; no scene is blamed then.
    """
    searchers = current().searchers
    if searchers is not None and job.searches_together and job.source is None:
        return _in_shares(job, current().pool, searchers)
    if job.parted and job.source is None and not job.searches_together:
        return _by_all(job, expendable_pool())
    return _survived(expendable_pool().run, job, make_batch)


def _by_all(job: BatchJob, pool: WorkerPool) -> BatchResult:
    """Makes a batch by shares of scenes, in as many workers as have time."""
    shares = job.shares()

    def make(share: BatchJob) -> BatchResult:
        return _survived(pool.run, share, make_share)

    with ThreadPoolExecutor(len(shares)) as threads:
        results = list(threads.map(make, shares))
    return pool.run(close_batch, job, results)


def _in_shares(job: BatchJob, pool: WorkerPool, searchers: Searchers) -> BatchResult:
    """Makes a batch whose search is a call of its own, and all around it by shares of scenes."""
    shares = job.shares()
    with ThreadPoolExecutor(len(shares)) as threads:

        def begun(share: BatchJob) -> list[SceneState]:
            # Before all proofs: without a draft the device has nothing to do.
            return _survived(partial(pool.run, rank=(DRAFTS, job.number)), share, draft_share)

        def draft() -> list[SceneState]:
            return list(chain.from_iterable(threads.map(begun, shares)))

        def search(states: list[SceneState]) -> list[SceneState]:
            return _survived(searchers.pool.run, job, search_batch, states)

        def prove(share: BatchJob) -> BatchResult:
            mine = [found[scene.index] for scene in share.scenes]
            return _survived(partial(pool.run, rank=(PROOFS, job.number)), share, prove_share, mine)

        states = searchers.search(draft, search)
        found = {scene.index: state for scene, state in zip(job.scenes, states, strict=True)}
        results = list(threads.map(prove, shares))
    return pool.run(close_batch, job, results)


@contextlib.contextmanager
def begun_ahead(jobs: Sequence[BatchJob]) -> Generator[None]:
    """Begins the first batches; the tasks that make them, in the body, take up what has begun.

    A flow begins once its scheduler answers, which takes longer than workers need to be there:
    until then cores, and a device, would have nothing to do.

    Args:
        jobs: Batches that the flow is about to make, in order.
    """
    here = current()
    count = here.pool.processes if here.searchers is None else here.searchers.in_hand
    for job in jobs[:count] if here.pool.processes else ():
        if read_mark(job.out, job.number) is None:
            here.begun[job.out, job.number] = _in_thread(job)
    try:
        yield
    except BaseException:
        if here.begun:  # nobody will take them up
            here.pool.stop()
            if here.searchers is not None:
                here.searchers.pool.stop()
        raise


def _in_thread(job: BatchJob) -> Future[BatchResult]:
    future: Future[BatchResult] = Future()

    def make() -> None:
        try:
            future.set_result(run_job(job))
        except BaseException as error:  # whoever takes it up is told
            future.set_exception(error)

    threading.Thread(target=make, daemon=True).start()
    return future


def _survived(
    run: Callable[..., Result], job: BatchJob, function: Callable[..., Result], *args: Any
) -> Result:
    """Calls `function(job, *args)` in a worker; scenes that end it are found and left out."""
    try:
        return run(function, job, *args)
    except WorkerDied:
        for position, scene in enumerate(job.scenes):
            try:
                run(try_scene, job, position)
            except WorkerDied as error:
                mark_dead(job, scene.index, str(error))
    try:
        return run(function, job, *args)
    except WorkerDied as error:
        forget_dead(job)
        raise UserError(
            f"batch {job.number} of {job.out}: no worker lives to its end, whatever is left "
            f"out of it: {error}; raise the limit, or give fewer --workers more memory each",
            exit_code=1,
        ) from None
