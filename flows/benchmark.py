"""The `benchmark` flow: every scene of a suite, K seeds each, judged against the suite."""

from __future__ import annotations

from pathlib import Path

from prefect import flow

from esg.pipeline import SceneState, failures
from esg.requests import bench_requests
from flows import artifacts
from flows.naming import current_name
from flows.scenes import run_all, task_runner


@flow(
    name="benchmark",
    flow_run_name=current_name,
    task_runner=task_runner(),
    validate_parameters=False,
)
def benchmark(
    suite: str,
    runs: int = 5,
    seed: int = 0,
    strategy: str = "batched",
    engine: str = "physx",
    device: str = "cpu",
    close_loop: bool = False,
    collision: str = "exact",
    drafter: str = "rules",
    without: str = "",
    only: tuple[str, ...] = (),
) -> list[SceneState]:
    """Runs a suite.

    Args:
        suite: Path of the suite's YAML file.
        runs: Seeds a scene: seed, seed + 1, ...
        seed: First seed.
        strategy: Search strategy of the optimize stage.
        engine: Engine of the replay.
        device: cpu or cuda:N.
        close_loop: Whether the verify engine's outcome error is fed back to the search.
        collision: What bodies collide with during the search: exact, proxy or sdf.
        drafter: rules, llm or auto.
        without: What an ablation leaves out: global, initial or generation.
        only: Ids of the scenes that are run; empty for all.

    Returns:
        Final states, all runs of the first scene first.
    """
    asked = bench_requests(
        suite, runs, seed, strategy, engine, device, close_loop, collision, drafter, without, only
    )
    states = run_all(asked)
    name = f"bench-{Path(suite).stem}"
    artifacts.table(name, [_row(s) for s in states], f"{suite}, {runs} runs, {strategy}, {engine}")
    artifacts.failures(name, failures(states))
    return states


def _row(state: SceneState) -> dict[str, object]:
    return {
        "scene": state.request.name,
        "seed": state.request.seed,
        "outcome": state.outcome.value if state.outcome else "unfinished",
        "seconds": round(state.seconds, 2),
    }
