"""How every stage task works: the scenes of a batch one after the other, retries, cached state."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from prefect import task
from prefect.cache_policies import NO_CACHE
from prefect.client.schemas.objects import State, TaskRun
from prefect.runtime import task_run
from prefect.states import Completed
from prefect.tasks import Task

from esg.alone.guarded import PAUSES_S, guarded_stage
from esg.files import unwritable
from esg.pipeline import SceneState, crashed, may_pass
from esg.workers import OutOfTime, WorkerDied
from tasks.context import current


def _retry(_: Task[Any, Any], __: TaskRun, state: State[Any]) -> bool:
    failure = state.result(raise_on_failure=False)
    return isinstance(failure, BaseException) and may_pass(failure)


def make_stage_task(stage: str) -> Callable[[list[SceneState]], list[SceneState]]:
    """A Prefect task that runs `stage` for a batch of scenes.

    Finished results come from the artifact store, keyed by content and code version; a batch that
    computed nothing ends in a state called `Cached`. Only errors that may pass are retried, with
    back-off; a scene for which they do not pass ends as crashed and the others go on.

    Args:
        stage: One of `esg.pipeline.STAGES`.
    """

    @task(
        name=stage,
        # For limits of a server: `prefect concurrency-limit create esg-optimize 1`.
        tags=[f"esg-{stage}"],
        task_run_name=f"{stage} of {{label}}",
        # Prefect's own cache would remember keys whose artifacts may be gone: the store decides.
        cache_policy=NO_CACHE,
        persist_result=False,
        retries=len(PAUSES_S),
        retry_delay_seconds=list(PAUSES_S),
        retry_condition_fn=_retry,
    )
    def run(states: list[SceneState], label: str = "batch") -> Any:
        out = run_batch(stage, states, last_attempt=task_run.run_count > len(PAUSES_S))
        if out and all(s.log and s.log[-1].get("cached") for s in out):
            return Completed(name="Cached", message=f"{len(out)} of {len(out)}", data=out)
        return out

    return run


def run_batch(stage: str, states: list[SceneState], last_attempt: bool) -> list[SceneState]:
    """Runs one stage for every scene of a batch.

    Args:
        stage: One of `esg.pipeline.STAGES`.
        states: Scenes, each ready for the stage or ended.
        last_attempt: Whether errors that may pass end a scene instead of raising.

    Raises:
        OSError: If a scene met an error that may pass and this was not the last attempt, or the
            disk cannot be written. Scenes that finished are in the artifact store by then.
    """
    context = current()
    out: list[SceneState] = []
    busy: BaseException | None = None
    for state in states:
        try:
            done = context.pool.run(guarded_stage, stage, state, context.store)
        except OutOfTime as error:
            done = crashed(state, TimeoutError(f"{stage}: {error}"), stage)
        except WorkerDied as error:
            done = crashed(state, error, stage)
        except OSError as error:
            if unwritable(error):
                raise  # so would the other scenes; what is finished is kept
            if not last_attempt:
                busy = error
                continue
            done = crashed(state, error, stage)
        out.append(done)
        if busy is None or last_attempt:
            context.watch(stage, done)
    if busy is not None:
        raise busy
    return out
