"""One scene without a scheduler: limits, retries and crashes are those of every run."""

from __future__ import annotations

from dataclasses import replace
import errno

import pytest

from esg.alone import guarded
from esg.outcomes import Outcome
from esg.pipeline import STAGES, SceneRequest, SceneState


def runs(monkeypatch: pytest.MonkeyPatch, trouble: list[BaseException]) -> list[str]:
    """Stages that log themselves; the troubles are raised by the layout, one a try."""
    seen: list[str] = []

    def run(stage: str, state: SceneState) -> SceneState:
        seen.append(stage)
        if stage == "layout" and trouble:
            raise trouble.pop(0)
        return replace(state, log=(*state.log, {"stage": stage, "seconds": 0.0}))

    monkeypatch.setattr(guarded, "run_stage", run)
    return seen


def test_all_stages_run_in_order(monkeypatch: pytest.MonkeyPatch) -> None:
    seen = runs(monkeypatch, [])
    guarded.run_guarded(SceneRequest("a ball"))
    assert seen == list(STAGES)


def test_what_may_pass_is_tried_twice_more(monkeypatch: pytest.MonkeyPatch) -> None:
    seen = runs(monkeypatch, [TimeoutError("busy"), ConnectionResetError("reset")])
    waits: list[float] = []
    monkeypatch.setattr("time.sleep", waits.append)
    state = guarded.run_guarded(SceneRequest("a ball"))
    assert state.outcome is None
    assert seen.count("layout") == 3
    assert waits == [1.0, 2.0]


def test_what_does_not_pass_ends_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    runs(monkeypatch, [TimeoutError("busy")] * 3)
    state = guarded.run_guarded(SceneRequest("a ball"), (0.0, 0.0))
    assert state.outcome is Outcome.CRASHED
    assert state.log[-1] != {}
    assert "busy" in state.reason


def test_a_disk_that_cannot_be_written_ends_no_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    runs(monkeypatch, [OSError(errno.ENOSPC, "No space left on device", "/cache")])
    with pytest.raises(OSError, match="No space left"):
        guarded.run_guarded(SceneRequest("a ball"))


def test_a_stage_has_its_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    def hang(stage: str, state: SceneState) -> SceneState:
        while True:
            pass

    monkeypatch.setenv("ESG_STAGE_SECONDS", "0.3")
    monkeypatch.setattr(guarded, "run_stage", hang)
    state = guarded.guarded_stage("draft", SceneState(SceneRequest("a ball")))
    assert state.outcome is Outcome.CRASHED
    assert "ESG_STAGE_SECONDS" in state.reason
