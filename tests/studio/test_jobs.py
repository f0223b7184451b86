"""The queue of the studio: order, cancelling, and what a killed server knows afterwards."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
import time

import pytest

from esg.outcomes import UserError
from esg.studio import jobs as module
from esg.studio.jobs import LOG, Job, Jobs
from tests.studio.fakes import Pool


@pytest.fixture
def opened() -> Iterator[Callable[..., Jobs]]:
    made: list[Jobs] = []

    def make(folder: Path, pool: Callable[[], Pool] = Pool) -> Jobs:
        made.append(Jobs(folder, pool))  # type: ignore[arg-type]  # stands for a WorkerPool
        return made[-1]

    yield make
    for jobs in made:
        jobs.close()


def ended(jobs: Jobs, number: int) -> Job:
    deadline = time.monotonic() + 10
    while jobs.get(number).status in ("waiting", "running"):
        assert time.monotonic() < deadline
        time.sleep(0.005)
    return jobs.get(number)


def test_a_scene_goes_through_its_stages_to_a_folder(opened: Callable, tmp_path: Path) -> None:
    jobs = opened(tmp_path)
    job = ended(jobs, jobs.ask("A ball rolls.", 3).id)
    assert (job.status, job.outcome, job.folder) == ("done", "solved", "scene-1")
    assert job.stages == (("draft", 0.5, False), ("resolve", 0.0, True))
    assert (tmp_path / "scene-1" / "prompt.txt").read_text() == "A ball rolls.\n"
    assert "document" not in job.to_json() and job.to_json()["edited"] is False


def test_one_at_a_time_in_order_and_the_queue_shows(opened: Callable, tmp_path: Path) -> None:
    pool = Pool(hold=True)
    jobs = opened(tmp_path, lambda: pool)
    for k in range(3):
        jobs.ask(f"prompt {k}", 0)
    while jobs.get(1).status != "running":
        time.sleep(0.005)
    assert [j.status for j in jobs.all()] == ["running", "waiting", "waiting"]
    assert jobs.cancel(2).status == "cancelled"
    pool.go.set()
    ended(jobs, 3)
    assert [j.status for j in jobs.all()] == ["done", "cancelled", "done"]
    assert [r.prompt for r in pool.asked] == ["prompt 0", "prompt 2"]


def test_what_runs_is_stopped_and_the_next_one_made(opened: Callable, tmp_path: Path) -> None:
    pools = [Pool(hold=True), Pool()]
    jobs = opened(tmp_path, lambda: pools.pop(0))
    first = pools[0] if len(pools) == 2 else None
    jobs.ask("long", 0)
    jobs.ask("next", 0)
    while jobs.get(1).status != "running":
        time.sleep(0.005)
    assert jobs.cancel(1).status == "cancelled"
    assert ended(jobs, 2).status == "done"
    assert jobs.get(1).folder == "" and not (tmp_path / "scene-1").exists()
    assert jobs.cancel(2).status == "done" and first is None


def test_a_crash_is_one_failed_job(opened: Callable, tmp_path: Path) -> None:
    jobs = opened(tmp_path)
    job = ended(jobs, jobs.ask("crash", 0).id)
    assert (job.status, job.reason) == ("failed", "the worker process ended twice")
    assert ended(jobs, jobs.ask("fine", 0).id).status == "done"


def test_a_killed_server_loses_nothing(opened: Callable, tmp_path: Path) -> None:
    jobs = opened(tmp_path)
    ended(jobs, jobs.ask("first", 1).id)
    held = Pool(hold=True)
    other = opened(tmp_path, lambda: held)
    other.ask("second", 2, '{"a": "graph"}')
    while other.get(2).status != "running":
        time.sleep(0.005)
    # As after a kill: the log as it is at this moment, its last line cut off.
    text = (tmp_path / LOG).read_text()
    again = tmp_path / "again"
    again.mkdir()
    (again / LOG).write_text(text + '{"id": 9, "prom')
    found = opened(again)
    assert [(j.prompt, j.seed, j.status) for j in found.all()] == [
        ("first", 1, "done"),
        ("second", 2, "interrupted"),
    ]
    assert found.get(2).document == '{"a": "graph"}'
    assert found.ask("third", 0).id == 3


def test_a_full_queue_refuses(
    opened: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "MOST_WAITING", 2)
    held = Pool(hold=True)
    jobs = opened(tmp_path, lambda: held)
    jobs.ask("a", 0)
    jobs.ask("b", 0)
    with pytest.raises(UserError, match="2 scenes wait already"):
        jobs.ask("c", 0)
    with pytest.raises(UserError, match="no job 7"):
        jobs.get(7)


def test_listeners_are_told_of_every_change(opened: Callable, tmp_path: Path) -> None:
    jobs = opened(tmp_path)
    seen = jobs.changed_since(-1, 5.0)
    assert seen is not None
    job = jobs.ask("A ball.", 0)
    later = jobs.changed_since(seen, 5.0)
    assert later is not None and later > seen
    ended(jobs, job.id)
    jobs.close()
    assert jobs.changed_since(later, 5.0) is None
