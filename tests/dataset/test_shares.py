"""Batches whose search is a call of its own: who does what, and that the dataset is the same."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
import threading
from typing import Any

import pytest

from esg import stages
from esg.dataset import job as jobs_module
from esg.dataset import running
from esg.dataset.batch import make_batch
from esg.dataset.finish import finish
from esg.dataset.folder import DatasetFolder, read_mark
from esg.dataset.job import BatchJob
from esg.dataset.running import dead_scenes
from esg.outcomes import UserError
from esg.workers import WorkerDied, WorkerPool
from tasks.context import Searchers, run_context
from tasks.dataset import DRAFTS, begun_ahead, dataset_batch, run_job
from tests.dataset import fakes
from tests.dataset.test_batch import below, dataset
from tests.dataset.test_running import Fleet

TEXTS = ["a", "b", "still", "c bug", "d wrong", "e", "f half", "g", "h"]


def _nothing(*_: object) -> None:
    return None


class Noting(WorkerPool):
    """Runs calls in this process; notes them, and dies of scenes nobody has marked as deadly."""

    def __init__(self) -> None:
        super().__init__(0)
        self.processes = 1
        self.calls: list[str] = []

    def run(self, function: Callable[..., Any], *args: Any, rank: tuple[int, ...] = ()) -> Any:
        job: BatchJob = args[0]
        share = "" if job.share is None else f" {job.share}"
        self.calls.append(f"{function.__name__}{share}{' first' if rank[:1] == (DRAFTS,) else ''}")
        one = function.__name__ == "try_scene"
        scenes = (job.scenes[args[1]],) if one else job.scenes
        dead = dead_scenes(job)
        if any("deadly" in s.request.prompt and s.index not in dead for s in scenes):
            raise WorkerDied("the worker process ended twice")
        with self._local:
            return function(*args)


@pytest.fixture(autouse=True)
def quick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    for name in fakes.STAGES:
        monkeypatch.setitem(stages.SPECS, name, stages.SPECS[name])
    monkeypatch.setattr(stages, "conclude", stages.conclude)
    monkeypatch.setattr(running, "_compile_together", _nothing)
    monkeypatch.setattr(running, "PAUSES_S", (0.0, 0.0))
    monkeypatch.setattr(jobs_module, "SHARE", 2)
    monkeypatch.setenv("ESG_TEST_CALLS", str(tmp_path / "calls"))
    fakes.install()
    yield


def shared(jobs: list[BatchJob], pool: Noting, searching: Noting) -> None:
    """Makes a dataset in shares, in a folder where `jobs` make it."""
    with run_context(pool, searchers=searching):
        results = {job.number: run_job(job) for job in jobs}
    finish(DatasetFolder(jobs[0].out), jobs[0].spec, results)


def test_a_batch_in_shares_leaves_what_one_in_one_piece_leaves(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fleet = Fleet(monkeypatch)
    whole = dataset(tmp_path / "whole", TEXTS, device="cuda:0")
    finish(DatasetFolder(whole[0].out), whole[0].spec, {j.number: make_batch(j) for j in whole})
    alone = list(fleet.launches)
    fleet.launches.clear()
    pool, searching = Noting(), Noting()
    shared(dataset(tmp_path / "shares", TEXTS, device="cuda:0"), pool, searching)
    assert fleet.launches == alone
    assert below(tmp_path / "shares") == below(tmp_path / "whole")
    assert searching.calls == ["search_batch"] * 3
    first = sorted(pool.calls[: pool.calls.index("close_batch")])
    assert first == ["draft_share 0 first", "draft_share 1 first", "prove_share 0", "prove_share 1"]


def test_batches_begin_before_the_scheduler_answers_and_are_made_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Tasks take up what has begun, its errors too; what is done is not begun."""
    Fleet(monkeypatch)
    usual = Noting()
    shared(dataset(tmp_path / "whole", TEXTS, device="cuda:0"), usual, Noting())
    jobs = dataset(tmp_path / "ahead", TEXTS, device="cuda:0")
    pool, searching = Noting(), Noting()
    searching._local = pool._local  # all in this process, where one store is current at a time
    with run_context(pool, searchers=searching) as here, begun_ahead(jobs):
        begun = dict(here.begun)
        assert [number for _, number in begun] == [job.number for job in jobs]
        results = {job.number: dataset_batch.fn(job) for job in jobs}
        assert not here.begun
        assert all(results[number] is future.result() for (_, number), future in begun.items())
        with begun_ahead(jobs):
            assert not here.begun
    assert searching.calls == ["search_batch"] * len(jobs)
    assert sorted(pool.calls) == sorted(usual.calls)
    finish(DatasetFolder(jobs[0].out), jobs[0].spec, results)
    assert below(tmp_path / "ahead") == below(tmp_path / "whole")


def test_what_was_begun_ends_with_a_flow_that_never_begins(tmp_path: Path) -> None:
    jobs = dataset(tmp_path, TEXTS, device="cuda:0")
    pool, searching = Noting(), Noting()
    searching._local = pool._local
    with run_context(pool, searchers=searching) as here:
        with pytest.raises(UserError), begun_ahead(jobs):
            raise UserError("the scheduler does not answer")
        for future in here.begun.values():
            future.exception(timeout=60)
    assert pool._stopped.is_set() and searching._stopped.is_set()


def test_the_last_batches_are_made_by_all_workers_and_stay_the_same(tmp_path: Path) -> None:
    """Each scene searched by itself, in one piece and in shares."""
    whole = dataset(tmp_path / "whole", TEXTS)
    finish(DatasetFolder(whole[0].out), whole[0].spec, {j.number: make_batch(j) for j in whole})
    jobs = dataset(tmp_path / "shares", TEXTS)
    pool = Noting()
    with run_context(pool):
        results = {j.number: run_job(replace(j, parted=j.number > 0)) for j in jobs}
    finish(DatasetFolder(jobs[0].out), jobs[0].spec, results)
    assert sorted(pool.calls[1:4]) == ["close_batch", "make_share 0", "make_share 1"]
    assert pool.calls[0] == "make_batch"
    assert below(tmp_path / "shares") == below(tmp_path / "whole")


def test_a_scene_that_ends_a_worker_costs_itself_in_whatever_share(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    Fleet(monkeypatch)
    (job,) = dataset(tmp_path / "set", ["a", "b", "c", "deadly d"], device="cuda:0")
    pool, searching = Noting(), Noting()
    with run_context(pool, searchers=searching):
        result = run_job(job)
    assert result.outcomes == {"solved": 3, "crashed": 1}
    assert [row["prompt"] for row in result.failures] == ["deadly d"]
    # Only the share that died looked for who did it.
    assert pool.calls.count("try_scene 1 first") == 2
    assert "try_scene 0 first" not in pool.calls


def test_parts_of_an_attempt_that_was_made_otherwise_are_removed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A batch that was killed before its mark may have been made in one piece, or in shares."""
    Fleet(monkeypatch)
    (job,) = dataset(tmp_path / "set", ["a", "b", "c", "d"], device="cuda:0")
    with run_context(Noting(), searchers=Noting()):
        run_job(job)
    scenes = job.out / "parts" / "scenes"
    assert sorted(p.name for p in scenes.iterdir()) == [
        "batch-000000-00.parquet",
        "batch-000000-01.parquet",
    ]
    (job.out / "marks" / "batch-000000.json").unlink()
    make_batch(job)
    assert [p.name for p in scenes.iterdir()] == ["batch-000000.parquet"]
    assert read_mark(job.out, 0) is not None
    (job.out / "marks" / "batch-000000.json").unlink()
    with run_context(Noting(), searchers=Noting()):
        run_job(job)
    assert len(list(scenes.iterdir())) == 2


def test_shares_are_of_all_scenes_and_none_is_much_larger(tmp_path: Path) -> None:
    (job, *_) = dataset(tmp_path / "set", ["a", "b", "c"])
    for n in (1, 2, 3, 4, 5, 64, 65):
        many = replace(job, scenes=job.scenes[:1] * n)
        sizes = [len(share.scenes) for share in many.shares()]
        assert sum(sizes) == n
        assert max(sizes) <= 2
        assert max(sizes) - min(sizes) <= 1
        assert [s.share for s in many.shares()] == list(range(len(sizes)))


def test_no_more_is_drafted_than_waits_for_a_search() -> None:
    """While both processes search, four batches are drafted; the next waits until one is searched."""
    searchers = Searchers(WorkerPool(2))
    try:
        go = [threading.Event() for _ in range(8)]
        drafted: list[int] = []
        found: list[int] = []

        def run(k: int) -> None:
            def draft() -> int:
                drafted.append(k)
                return k

            def search(made: int) -> int:
                go[made].wait(10)
                return made

            found.append(searchers.search(draft, search))

        threads = [threading.Thread(target=run, args=(k,), daemon=True) for k in range(8)]
        for k, thread in enumerate(threads):
            thread.start()
            thread.join(0.05)
            assert len(drafted) == min(k + 1, 6)
        go[drafted[0]].set()
        threads[drafted[0]].join(5)
        threads[7].join(0.1)
        assert len(drafted) == 7
        for event in go:
            event.set()
        for thread in threads:
            thread.join(5)
        assert sorted(found) == list(range(8))
    finally:
        searchers.pool.close()
