"""Searches that share launches, stages that hang, and workers that are killed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
import json
import os
from pathlib import Path
import signal
import threading
import time
from types import SimpleNamespace
from typing import Any

import pytest

from esg import stages
from esg.dataset import running
from esg.dataset.batch import make_batch
from esg.dataset.folder import read_mark
from esg.machine.removing import wait_removed
from esg.pipeline import SceneState
from esg.workers import WorkerPool
from tasks import context
from tasks.context import run_context
from tasks.dataset import run_job
from tests.dataset import fakes
from tests.dataset.test_batch import dataset


class FakePool(WorkerPool):
    """Real worker processes with the fake stages."""

    def run(self, function: Callable[..., Any], *args: Any) -> Any:
        return super().run(fakes.in_worker, function, *args)


@pytest.fixture(autouse=True)
def quick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    for name in fakes.STAGES:
        monkeypatch.setitem(stages.SPECS, name, stages.SPECS[name])
    monkeypatch.setattr(stages, "conclude", stages.conclude)
    monkeypatch.setattr(running, "_compile_together", lambda states: None)
    monkeypatch.setenv("ESG_TEST_CALLS", str(tmp_path / "calls"))
    fakes.install()
    yield


class Fleet:
    """Stands in for `optimize_many`: notes who searched together, fails with a `broken` prompt."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.launches: list[list[str]] = []
        self.options: dict[str, Any] = {}
        monkeypatch.setattr("esg.dynamics.fleet.optimize_many", self)
        monkeypatch.setattr(stages, "load_doc", self.load)
        monkeypatch.setattr(stages, "write_doc", self.write)

    @staticmethod
    def load(state: SceneState, stage: str = "optimize") -> Any:
        prompt = state.request.prompt
        return SimpleNamespace(prompt=prompt, timeline_system=None if "still" in prompt else ())

    @staticmethod
    def write(doc: Any, folder: Path) -> None:
        text = {"scene_definition": {"scene_id": "fleet"}, "prompt": doc.prompt,
                "coverage": {"items": []}}  # fmt: skip
        (folder / "esg.json").write_text(json.dumps(text))

    def __call__(self, docs: list[Any], seeds: list[int], **options: Any) -> list[Any]:
        self.launches.append([d.prompt for d in docs])
        self.options = options
        assert len(seeds) == len(docs)
        if any("broken" in d.prompt for d in docs):
            raise ValueError("no layout")
        return docs


def test_scenes_of_a_gpu_batch_are_searched_together(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fleet = Fleet(monkeypatch)
    job, *_ = dataset(tmp_path / "a", ["a", "b", "still", "c bug"], device="cuda:0")
    assert job.searches_together
    result = make_batch(job)
    assert fleet.launches == [["a", "b"]]
    assert fleet.options == {"device": "cuda:0", "strategy": "batched", "processes": 1}
    assert result.outcomes == {"solved": 3, "crashed": 1}
    # Their own stage found the results; only the still scene ran it.
    assert [c for c in fakes.calls() if c.startswith("optimize")] == ["optimize still"]


def test_on_the_cpu_scenes_are_searched_one_by_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fleet = Fleet(monkeypatch)
    job, *_ = dataset(tmp_path / "a", ["a", "b"])
    make_batch(job)
    assert fleet.launches == []
    assert len([c for c in fakes.calls() if c.startswith("optimize")]) == 2


def test_a_broken_scene_leaves_the_others_their_search(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fleet = Fleet(monkeypatch)
    job, *_ = dataset(tmp_path / "a", ["a", "b", "broken c", "d"], device="cuda:0")
    make_batch(job)
    assert fleet.launches == [
        ["a", "b", "broken c", "d"], ["a", "b"], ["broken c", "d"], ["broken c"], ["d"],
    ]  # fmt: skip
    assert [c for c in fakes.calls() if c.startswith("optimize")] == ["optimize broken c"]


def test_an_interrupted_batch_searches_all_its_scenes_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Who shares a launch may change its last digits: always the whole batch, or nobody."""
    fleet = Fleet(monkeypatch)
    job, *_ = dataset(tmp_path / "a", ["a", "b", "c"], device="cuda:0")
    real, written = stages.write_doc, []

    def cut(doc: Any, folder: Path) -> None:
        if written:
            raise KeyboardInterrupt
        written.append(doc.prompt)
        real(doc, folder)

    with monkeypatch.context() as patch:
        patch.setattr(stages, "write_doc", cut)
        with pytest.raises(KeyboardInterrupt):
            make_batch(job)
    make_batch(job)
    assert fleet.launches == [["a", "b", "c"]] * 2


def test_a_stage_that_hangs_costs_its_scene_and_nobody_else(tmp_path: Path) -> None:
    from dataclasses import replace

    job, *_ = dataset(tmp_path / "a", ["a", "b hangs", "c"])
    start = time.monotonic()
    with FakePool(1) as pool, run_context(pool):
        result = run_job(replace(job, stage_limit_s=6.0))
    assert time.monotonic() - start < 58
    assert result.outcomes == {"solved": 2, "crashed": 1}
    (row,) = result.failures
    assert (row["prompt"], row["stage"]) == ("b hangs", "layout")
    assert row["reason"].endswith("layout ran longer than its limit of 6 s")


def test_a_scene_that_kills_its_worker_is_left_out(tmp_path: Path) -> None:
    job, *_ = dataset(tmp_path / "a", ["a", "deadly b", "c"])
    with FakePool(1) as pool, run_context(pool):
        result = run_job(job)
    assert result.outcomes == {"solved": 2, "crashed": 1}
    assert [(row["prompt"], row["stage"]) for row in result.failures] == [("deadly b", "layout")]


def test_a_cluster_does_not_lose_a_process_for_a_deadly_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A process that no command told of a run, as those of Dask and Ray, has a worker beside it."""
    job, *_ = dataset(tmp_path / "a", ["a", "deadly b", "c"])
    assert context._own().processes == 1
    with FakePool(1) as pool:
        monkeypatch.setattr(context, "_own", lambda: pool)
        assert run_job(job).outcomes == {"solved": 2, "crashed": 1}


def test_a_worker_killed_from_outside_costs_nothing(tmp_path: Path) -> None:
    """SIGKILL while a stage sleeps: the batch goes on in a fresh process."""
    job, *_ = dataset(tmp_path / "a", ["a", "b pauses", "c"])
    killed: list[int] = []
    with FakePool(1) as pool, run_context(pool):

        def kill() -> None:
            deadline = time.monotonic() + 30
            while "layout b pauses" not in fakes.calls() and time.monotonic() < deadline:
                time.sleep(0.02)
            executor = pool._all[0]._executor
            assert executor is not None
            for pid in tuple(executor._processes):
                killed.append(pid)
                os.kill(pid, signal.SIGKILL)

        thread = threading.Thread(target=kill)
        thread.start()
        result = run_job(job)
        thread.join()
    assert killed
    assert result.outcomes == {"solved": 3}
    assert fakes.calls().count("layout a") == 1
    assert fakes.calls().count("layout b pauses") == 2


def test_a_clock_that_jumps_changes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The wall clock goes back a year between two batches; marks and bytes do not care."""
    plain = dataset(tmp_path / "plain", list("abcdefgh"))
    jumped = dataset(tmp_path / "jumped", list("abcdefgh"))
    for job in plain:
        make_batch(job)
    make_batch(jumped[0])
    back = time.time() - 365 * 86400
    with monkeypatch.context() as patch:
        patch.setattr(time, "time", lambda: back)
        make_batch(jumped[1])
    wait_removed()
    for path in (tmp_path / "jumped").rglob("*"):
        os.utime(path, (back, back))
    for job, other in zip(plain, jumped, strict=True):
        mine, theirs = read_mark(job.out, job.number), read_mark(other.out, other.number)
        assert mine is not None and theirs is not None
        assert mine.outcomes == theirs.outcomes
        for name in mine.files:
            if not name.startswith("parts/timings/"):
                assert (job.out / name).read_bytes() == (other.out / name).read_bytes(), name
