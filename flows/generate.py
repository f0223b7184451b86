"""The `generate` flow: prompts to scene folders."""

from __future__ import annotations

from collections.abc import Sequence

from prefect import flow

from esg.pipeline import SceneState
from esg.requests import generate_requests
from flows.naming import current_name
from flows.scenes import run_all, task_runner


@flow(
    name="generate",
    flow_run_name=current_name,
    task_runner=task_runner(),
    validate_parameters=False,
)
def generate(
    prompts: Sequence[str],
    seed: int = 0,
    drafter: str = "rules",
    strategy: str = "batched",
    device: str = "cpu",
    close_loop: bool = False,
    collision: str = "exact",
    traffic: str = "right",
) -> list[SceneState]:
    """Generates one scene a prompt.

    Args:
        prompts: English texts.
        seed: Of every random choice.
        drafter: rules or llm.
        strategy: Search strategy of the optimize stage.
        device: cpu or cuda:N.
        close_loop: Whether the verify engine's outcome error is fed back to the search.
        collision: What bodies collide with during the search: exact, proxy or sdf.
        traffic: Side of the road that vehicles keep to: right or left.

    Returns:
        Final states in the order of the prompts.
    """
    return run_all(
        generate_requests(prompts, seed, drafter, strategy, device, close_loop, collision, traffic)
    )
