"""The dataset flow against the private API: retries, deadly scenes, cached batches, artifacts."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from esg import stages
from esg.dataset import running as module
from esg.dataset.batch import make_batch
from esg.dataset.job import BatchJob, BatchResult
from esg.dataset.running import dead_scenes
from esg.outcomes import UserError
from esg.workers import WorkerDied, WorkerPool
from flows.session import session
from tasks.context import run_context
from tasks.dataset import run_job
from tests.dataset import fakes
from tests.dataset.test_batch import dataset as make_jobs


@pytest.fixture(autouse=True)
def quick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.delenv("PREFECT_API_URL", raising=False)
    for name in fakes.STAGES:
        monkeypatch.setitem(stages.SPECS, name, stages.SPECS[name])
    monkeypatch.setattr(stages, "conclude", stages.conclude)
    monkeypatch.setenv("ESG_TEST_CALLS", str(tmp_path / "calls"))
    monkeypatch.setattr(module, "_compile_together", lambda states: None)
    fakes.install()
    yield


class DyingPool(WorkerPool):
    """A pool whose worker dies whenever a deadly scene is run that nobody has marked yet."""

    def __init__(self) -> None:
        super().__init__(0)
        self.calls: list[str] = []

    def run(self, function: Callable[..., Any], *args: Any) -> Any:
        self.calls.append(function.__name__)
        job: BatchJob = args[0]
        scenes = job.scenes if len(args) == 1 else (job.scenes[args[1]],)
        dead = dead_scenes(job)
        if any("deadly" in s.request.prompt and s.index not in dead for s in scenes):
            raise WorkerDied("the worker process ended twice")
        return super().run(function, *args)


def test_a_dataset_survives_deadly_scenes_and_passing_errors(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Three batches: one with a deadly scene, one that cannot be written at first, one done."""
    texts = ["a", "deadly b", "c", "d", "e", "f", "g", "h", "i"]
    jobs = make_jobs(tmp_path / "set", texts)
    make_batch(jobs[2])
    real, failed = make_batch, []

    def flaky(job: BatchJob) -> Any:
        if job.number == 1 and not failed:
            failed.append(job.number)
            raise TimeoutError("the file server does not answer")
        return real(job)

    shown: dict[str, Any] = {}
    heard: list[int] = []
    with session(0) as call:
        from flows import artifacts
        from flows.dataset import with_runner
        from tasks import dataset as task_module

        flaky.__name__ = "make_batch"
        monkeypatch.setattr(task_module, "make_batch", flaky)
        monkeypatch.setattr(artifacts, "table", lambda n, rows, d: shown.update({n: (rows, d)}))
        pool = DyingPool()
        with run_context(pool):
            results = call(with_runner("process", 2), jobs, lambda r: heard.append(r.number))
    assert [r.number for r in results] == [0, 1, 2]
    assert sorted(heard) == [0, 1, 2]
    assert failed == [1]
    assert results[0].outcomes == {"solved": 3, "crashed": 1}
    assert "ended twice" in results[0].failures[0]["reason"]
    assert results[1].outcomes == {"solved": 4}
    assert pool.calls.count("try_scene") == 4
    rows, description = shown["dataset"]
    assert rows == [{"outcome": "crashed", "scenes": 1}, {"outcome": "solved", "scenes": 8}]
    assert description == "8 of 9 scenes verified"


def test_workers_that_end_whatever_they_run_are_told_and_no_scene_is_blamed(tmp_path: Path) -> None:
    """Too little memory for the libraries alone, for instance."""

    class Dead(WorkerPool):
        def run(self, function: Callable[..., Any], *args: Any) -> Any:
            raise WorkerDied("the worker process ended twice")

    (job,) = make_jobs(tmp_path / "set", ["a", "b"])
    with run_context(Dead(0)), pytest.raises(UserError, match=r"batch 0 .* ended twice") as told:
        run_job(job)
    assert told.value.exit_code == 1
    assert dead_scenes(job) == {}


def test_a_batch_that_cannot_be_written_does_not_stop_the_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    jobs = make_jobs(tmp_path / "set", list("abcdefgh"))
    real = make_batch

    def full(job: BatchJob) -> Any:
        if job.number == 0:
            raise OSError(28, "No space left on device", str(job.out))
        return real(job)

    with session(0) as call:
        from flows.dataset import with_runner
        from tasks import dataset as task_module

        monkeypatch.setattr(task_module, "make_batch", full)
        with pytest.raises(OSError, match="No space left"):
            call(with_runner("process", 1), jobs)
    assert [p.name for p in (tmp_path / "set" / "marks").iterdir()] == ["batch-000001.json"]


class KilledWorker(Exception):
    """As Dask names what it raises for a task that lost several machines."""


def test_batches_that_lose_their_machines_are_made_elsewhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One loses four machines; one every machine, which is told once all others are made."""
    jobs = make_jobs(tmp_path / "set", list("abcdefghijkl"))
    real, lost = make_batch, [0, 0, 0]

    def evicted(job: BatchJob) -> Any:
        if job.number == 0 or (job.number == 1 and lost[1] < 4):
            lost[job.number] += 1
            raise KilledWorker("node-3 is gone")
        return real(job)

    heard: list[int] = []
    with session(0) as call:
        from flows.dataset import MOST_LOST, with_runner
        from tasks import dataset as task_module

        evicted.__name__ = "make_batch"
        monkeypatch.setattr(task_module, "make_batch", evicted)
        told = f"batch 0 lost its machine {MOST_LOST + 1} times .node-3 is gone.; .*--resume"
        with pytest.raises(UserError, match=told):
            call(with_runner("process", 2), jobs, lambda r: heard.append(r.number))
    assert lost == [MOST_LOST + 1, 4, 0]
    assert sorted(heard) == [1, 2]


def test_workers_that_do_not_reach_the_api_are_told_of_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The private API listens on this machine only; workers elsewhere need one that they reach."""

    def elsewhere(job: BatchJob) -> Any:
        raise RuntimeError("Failed to reach API at http://127.0.0.1:4/api/")

    with session(0) as call:
        from flows.dataset import with_runner
        from tasks import dataset as task_module

        elsewhere.__name__ = "make_batch"
        monkeypatch.setattr(task_module, "make_batch", elsewhere)
        with pytest.raises(UserError, match=r"127\.0\.0\.1:4/api/.*PREFECT_API_URL="):
            call(with_runner("process", 1), make_jobs(tmp_path / "set", ["a"]))


@pytest.mark.parametrize(
    ("package", "names"),
    [
        ("distributed.scheduler", ["KilledWorker"]),
        ("ray.exceptions", ["WorkerCrashedError", "NodeDiedError", "OwnerDiedError"]),
        ("prefect.exceptions", ["CrashedRun"]),
    ],
)
def test_a_lost_machine_is_known_by_what_clusters_raise(package: str, names: list[str]) -> None:
    module = pytest.importorskip(package)
    from flows.dataset import lost_machine

    for name in names:
        kind = getattr(module, name)
        assert lost_machine(kind.__new__(kind)), name
    assert not lost_machine(OSError(28, "No space left on device"))


def test_thousands_of_scenes_are_no_parameters_of_the_flow(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A server refuses flow runs with more than 512 KiB of parameters."""
    monkeypatch.setenv("PREFECT_SERVER_API_MAX_PARAMETER_SIZE", "524288")
    jobs = make_jobs(tmp_path / "set", [f"{i} " + "long " * 10_000 for i in range(12)])
    assert sum(len(s.request.prompt) for j in jobs for s in j.scenes) > 524_288

    def quick(job: BatchJob) -> BatchResult:
        return BatchResult(job.number, len(job.scenes), 0, {"solved": len(job.scenes)})

    with session(0) as call:
        from flows.dataset import with_runner
        from tasks import dataset as task_module

        quick.__name__ = "make_batch"
        monkeypatch.setattr(task_module, "make_batch", quick)
        results = call(with_runner("process", 2), jobs)
    assert sum(r.scenes for r in results) == 12


def test_the_flow_travels_to_the_workers_of_a_cluster() -> None:
    """Dask and Ray send every task the run's context, with the flow and its function in it."""
    import cloudpickle

    with session(0):
        from flows.dataset import with_runner
        from tasks.dataset import dataset_batch

        run = with_runner("process", 1)
        flow = next(
            c.cell_contents for c in run.__closure__ or () if hasattr(c.cell_contents, "fn")
        )
        for what in (flow, dataset_batch):
            assert cloudpickle.loads(cloudpickle.dumps(what)).name == what.name
