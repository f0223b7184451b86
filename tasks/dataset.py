"""One batch of a dataset: all stages of its scenes, its Parquet parts, its mark."""

from __future__ import annotations

from typing import Any

from prefect import task
from prefect.cache_policies import NO_CACHE
from prefect.client.schemas.objects import State, TaskRun
from prefect.states import Completed
from prefect.tasks import Task, exponential_backoff

from esg.dataset.batch import make_batch
from esg.dataset.job import BatchJob, BatchResult
from esg.dataset.running import forget_dead, mark_dead, try_scene
from esg.outcomes import UserError
from esg.pipeline import may_pass
from esg.workers import WorkerDied
from tasks.context import expendable_pool

RETRIES = 3


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
    from esg.dataset.folder import read_mark

    done = read_mark(job.out, job.number)
    if done is not None:
        return Completed(name="Cached", message="done before", data=done)
    return run_job(job)


def run_job(job: BatchJob) -> BatchResult:
    """Makes a batch in a worker; scenes that end their worker are found and left out.

    Raises:
        UserError: If workers end whatever scene they are given; no scene is blamed then.
    """
    pool = expendable_pool()
    try:
        return pool.run(make_batch, job)
    except WorkerDied:
        for position, scene in enumerate(job.scenes):
            try:
                pool.run(try_scene, job, position)
            except WorkerDied as error:
                mark_dead(job, scene.index, str(error))
    try:
        return pool.run(make_batch, job)
    except WorkerDied as error:
        forget_dead(job)
        raise UserError(
            f"batch {job.number} of {job.out}: no worker lives to its end, whatever is left "
            f"out of it: {error}; raise the limit, or give fewer --workers more memory each",
            exit_code=1,
        ) from None
