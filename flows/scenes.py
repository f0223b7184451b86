"""Scenes through all stages: batches in parallel, stages in order. Shared by every flow."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from prefect import task
from prefect.cache_policies import NO_CACHE
from prefect.task_runners import ThreadPoolTaskRunner

from esg.pipeline import STAGES, SceneRequest, SceneState
from flows.naming import scene_names
from tasks import stage_task
from tasks.context import current

BATCH = 100
"""Scenes a batch at most: Prefect's bookkeeping costs tens of milliseconds a task, not a scene."""


def task_runner() -> Any:
    """A Prefect task runner with as many threads as scenes can run at once.

    The threads only wait: the work happens in the worker processes of `tasks.context`.
    """
    return ThreadPoolTaskRunner(max_workers=16)


def run_all(requests: Sequence[SceneRequest]) -> list[SceneState]:
    """Runs every stage of every scene; call it inside a flow.

    Returns:
        Final states in the order of the requests.
    """
    states = [SceneState(r) for r in requests]
    lanes = max(1, current().pool.processes)
    if lanes == 1 or len(states) == 1:
        return run_stages(states, scene_names(states))
    # Several batches a lane, because scenes differ in length; dealt out like cards, because
    # neighbours (the runs of one scene) take equally long.
    count = max(lanes, min(len(states), 2 * lanes), -(-len(states) // BATCH))
    dealt = [list(range(k, len(states), count)) for k in range(count)]
    runs = [
        _batch.with_options(task_run_name=f"batch {k + 1} of {count}").submit(
            [states[i] for i in indices], scene_names([states[i] for i in indices])
        )
        for k, indices in enumerate(dealt)
    ]
    for indices, run in zip(dealt, runs, strict=True):
        for i, done in zip(indices, run.result(), strict=True):
            states[i] = done
    return states


def run_stages(states: list[SceneState], label: str) -> list[SceneState]:
    """All stages of one batch, one Prefect task each."""
    for stage in STAGES:
        # A task that returns a state of its own making hands it over as it is.
        states = stage_task(stage)(states, label, return_state=True).result()
    return states


@task(name="batch", cache_policy=NO_CACHE, persist_result=False)
def _batch(states: list[SceneState], label: str) -> list[SceneState]:
    return run_stages(states, label)
