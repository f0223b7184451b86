"""Batches: one scene's trouble stays its own, and only what may pass is tried again."""

from __future__ import annotations

from dataclasses import replace
import errno

import pytest

from esg import guarded
from esg.outcomes import Outcome
from esg.pipeline import STAGES, SceneRequest, SceneState
from esg.workers import WorkerDied, WorkerPool
from tasks import batch, stage_task
from tasks.context import run_context


def states(*prompts: str) -> list[SceneState]:
    return [SceneState(SceneRequest(p)) for p in prompts]


@pytest.fixture
def stage(monkeypatch: pytest.MonkeyPatch) -> dict[str, BaseException]:
    """A stage that logs one entry a scene; prompts in the returned dictionary raise instead."""
    trouble: dict[str, BaseException] = {}

    def run(name: str, state: SceneState) -> SceneState:
        if state.request.prompt in trouble:
            raise trouble[state.request.prompt]
        return replace(state, log=(*state.log, {"stage": name, "cached": False, "seconds": 0.0}))

    monkeypatch.setattr(guarded, "run_stage", run)
    return trouble


def test_order_is_kept_and_the_watcher_hears_every_scene(stage: dict[str, BaseException]) -> None:
    heard: list[str] = []
    with run_context(WorkerPool(0), lambda s, state: heard.append(f"{s} {state.request.prompt}")):
        out = batch.run_batch("layout", states("a", "b"), last_attempt=False)
    assert [s.request.prompt for s in out] == ["a", "b"]
    assert heard == ["layout a", "layout b"]


def test_a_dead_worker_crashes_its_scene_only(stage: dict[str, BaseException]) -> None:
    stage["a"] = WorkerDied("segmentation fault")
    out = batch.run_batch("layout", states("a", "b"), last_attempt=False)
    assert [s.outcome for s in out] == [Outcome.CRASHED, None]
    assert out[0].log[-1]["stage"] == "layout"


def test_errors_that_may_pass_are_raised_until_the_last_attempt(
    stage: dict[str, BaseException],
) -> None:
    stage["a"] = ConnectionResetError("reset")
    with pytest.raises(ConnectionResetError):
        batch.run_batch("draft", states("a", "b"), last_attempt=False)
    out = batch.run_batch("draft", states("a", "b"), last_attempt=True)
    assert [s.outcome for s in out] == [Outcome.CRASHED, None]


def test_a_disk_that_cannot_be_written_ends_the_run_and_no_scene(
    stage: dict[str, BaseException],
) -> None:
    """The scenes are made when the command runs again: none of them may count as crashed."""
    stage["b"] = OSError(errno.ENOSPC, "No space left on device", "/cache")
    for last in (False, True):
        with pytest.raises(OSError, match="No space left"):
            batch.run_batch("layout", states("a", "b"), last_attempt=last)


def test_every_stage_has_a_task() -> None:
    assert [stage_task(s).name for s in STAGES] == list(STAGES)
    with pytest.raises(ValueError, match="unknown stage"):
        stage_task("paint")
