"""The `nightly` flow: benchmark suites, compare with history, write the reports."""

from __future__ import annotations

from collections.abc import Generator, Sequence
import contextlib
from pathlib import Path
import shutil
from typing import Any

from prefect import flow

from esg.leftovers import owned_folder, sweep_leftovers
from esg.nightly import NightlyResult, conclude_suite
from esg.pipeline import SceneState, failures, scratch_store
from esg.requests import bench_requests
from esg.workers import WorkerPool, default_processes
from flows import artifacts
from flows.naming import current_name
from flows.scenes import run_all, task_runner
from tasks.context import current, run_context


class Regression(RuntimeError):
    """A suite got worse, or nobody can tell; the flow run is shown as failed."""


@flow(
    name="nightly",
    flow_run_name=current_name,
    task_runner=task_runner(),
    validate_parameters=False,
)
def nightly(
    suites: Sequence[str],
    out: str = "runs/nightly",
    database: str = "",
    runs: int = 3,
    seed: int = 0,
    strategy: str = "batched",
    engine: str = "physx",
    device: str = "cpu",
    workers: int = -1,
    cached: bool = False,
    raise_on_regression: bool = True,
) -> list[dict[str, Any]]:
    """Runs suites, ingests, compares with the last good run and writes the reports.

    Args:
        suites: Paths of suite files, or names of those that come with the package.
        out: Folder; every suite gets `SUITE/DATE` below it.
        database: The run database; default that of the command line.
        runs: Seeds a scene.
        seed: First seed.
        strategy: Search strategy.
        engine: Engine of the replay.
        device: cpu or cuda:N.
        workers: Worker processes; -1: one a core.
        cached: Whether finished stages of earlier runs count; a night usually makes everything
            anew, because that is what it is to prove.
        raise_on_regression: Whether a regression, or a run that is not in the database, ends the
            flow as failed.

    Returns:
        One `NightlyResult` a suite, as a dictionary.

    Raises:
        Regression: If a suite got worse or was not recorded, after all suites have been run.
    """
    results: list[NightlyResult] = []
    for suite in suites:
        requests = bench_requests(suite, runs, seed, strategy, engine, device)
        count = default_processes(len(requests)) if workers < 0 else workers
        with _own_store(cached) as store, _workers(count, store):
            states = run_all(requests)
            found = conclude_suite(
                states, suite, runs, Path(out), Path(database) if database else None
            )
        results.append(found)
        _show(found, states, Path(out))
    bad = [r.suite for r in results if r.regressed]
    lost = [r.suite for r in results if not r.run_id]
    if bad and raise_on_regression:
        raise Regression(f"worse than the last good run: {', '.join(bad)}")
    if lost and raise_on_regression:
        raise Regression(f"not recorded, so not compared: {', '.join(lost)}")
    return [r.to_json() for r in results]


@contextlib.contextmanager
def _own_store(cached: bool) -> Generator[Path | None]:
    """A store that is empty and goes with the run, or None for the usual one."""
    if cached:
        yield None
        return
    sweep_leftovers("esg-nightly-")
    folder = owned_folder("esg-nightly-")
    try:
        with scratch_store(folder):
            yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


@contextlib.contextmanager
def _workers(count: int, store: Path | None) -> Generator[None]:
    """Workers of this flow run; those of the command, if it has some."""
    if current().pool.processes:
        with run_context(current().pool, current().watch, store):
            yield
        return
    with WorkerPool(count) as pool, run_context(pool, current().watch, store):
        yield


def _show(result: NightlyResult, states: Sequence[SceneState], out: Path) -> None:
    name = f"nightly-{result.suite}"
    artifacts.table(name, [result.summary], f"{result.suite}: {result.verdict}")
    artifacts.failures(name, failures(states))
    if result.not_represented:
        what = f"{result.partial} partial scene runs; words that are most often not shown"
        artifacts.table(f"{name}-words", result.not_represented, what)
    if result.report:
        artifacts.report_link(name, Path(result.report), out)
