"""Progress events: from stages of this process and of workers, and never a reason to fail."""

from __future__ import annotations

import os
from pathlib import Path
import time

import pytest

from esg import pipeline, stages
from esg.pipeline import SceneRequest, SceneState, run_stage, scratch_store
from esg.progress import StageEvent, emit, listening
from esg.stages import Spec
from esg.workers import WorkerPool


def say(text: str) -> int:
    emit(StageEvent(text, "draft", "started"))
    return os.getpid()


def test_a_stage_tells_its_start_and_its_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def draft(state: SceneState, folder: Path) -> None:
        (folder / "violations.json").write_text("[]")

    monkeypatch.setitem(stages.SPECS, "draft", Spec(draft, (), ("prompt",)))
    heard: list[StageEvent] = []
    with scratch_store(tmp_path), listening(heard.append):
        state = run_stage("draft", SceneState(SceneRequest("a ball", seed=3, name="S1-run0")))
        run_stage("draft", SceneState(state.request))
    run_stage("draft", state)
    assert [(e.scene, e.stage, e.seed) for e in heard] == [("S1-run0", "draft", 3)] * 4
    assert [e.status for e in heard] == ["started", "finished"] * 2
    assert [e.cached for e in heard if e.status == "finished"] == [False, True]


def test_crashes_are_told_with_their_outcome(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def draft(state: SceneState, folder: Path) -> None:
        raise ZeroDivisionError("a defect")

    monkeypatch.setitem(stages.SPECS, "draft", Spec(draft, (), ("prompt",)))
    heard: list[StageEvent] = []
    with scratch_store(tmp_path), listening(heard.append):
        pipeline.run_stage("draft", SceneState(SceneRequest("x")))
    assert (heard[-1].outcome, heard[-1].reason) == ("crashed", "ZeroDivisionError: a defect")


def test_workers_are_heard_and_so_is_their_replacement() -> None:
    heard: list[str] = []
    with listening(lambda event: heard.append(event.scene)), WorkerPool(1, recycle_after=1) as pool:
        ids = {pool.run(say, "first"), pool.run(say, "second")}
        deadline = time.monotonic() + 10
        while len(heard) < 2 and time.monotonic() < deadline:
            time.sleep(0.02)
    assert heard == ["first", "second"]
    assert len(ids) == 2
    assert os.getpid() not in ids


def test_a_listener_that_raises_harms_nobody() -> None:
    heard: list[str] = []

    def bad(event: StageEvent) -> None:
        raise RuntimeError("a broken display")

    with listening(bad), listening(lambda event: heard.append(event.scene)):
        say("x")
    say("nobody listens")
    assert heard == ["x"]


def grow(mebibytes: int) -> int:
    global _kept
    _kept = bytearray(mebibytes * 2**20)
    return os.getpid()


def test_a_worker_that_has_grown_is_replaced() -> None:
    with WorkerPool(1, max_memory_bytes=200 * 2**20) as pool:
        first = pool.run(grow, 1)
        assert pool.run(grow, 300) == first
        assert pool.run(grow, 1) != first
