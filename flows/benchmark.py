"""The `benchmark` flow: every scene of a suite, K seeds each, judged against the suite."""

from __future__ import annotations

from prefect import flow

from esg.pipeline import SceneState
from esg.requests import bench_requests
from flows.scenes import run_all, task_runner


@flow(name="benchmark", task_runner=task_runner(), validate_parameters=False)
def benchmark(
    suite: str,
    runs: int = 5,
    seed: int = 0,
    strategy: str = "batched",
    engine: str = "physx",
    device: str = "cpu",
) -> list[SceneState]:
    """Runs a suite.

    Args:
        suite: Path of the suite's YAML file.
        runs: Seeds a scene: seed, seed + 1, ...
        seed: First seed.
        strategy: Search strategy of the optimize stage.
        engine: Engine of the replay.
        device: cpu or cuda:N.

    Returns:
        Final states, all runs of the first scene first.
    """
    return run_all(bench_requests(suite, runs, seed, strategy, engine, device))
