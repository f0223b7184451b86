"""What a command or a flow asks for, as scene requests."""

from __future__ import annotations

from collections.abc import Sequence

from esg.pipeline import SceneRequest


def generate_requests(
    prompts: Sequence[str],
    seed: int,
    drafter: str,
    strategy: str,
    device: str,
    close_loop: bool = False,
    collision: str = "exact",
    traffic: str = "right",
) -> list[SceneRequest]:
    """The scenes of a `generate` run; arguments as of `flows.generate`."""
    return [
        SceneRequest(
            p,
            seed,
            drafter,
            strategy,
            device,
            close_loop=close_loop,
            collision=collision,
            traffic=traffic,
        )
        for p in prompts
    ]


def bench_requests(
    suite: str,
    runs: int,
    seed: int,
    strategy: str,
    engine: str,
    device: str,
    close_loop: bool = False,
    collision: str = "exact",
    drafter: str = "rules",
    without: str = "",
    only: Sequence[str] = (),
) -> list[SceneRequest]:
    """The scene runs of a benchmark; arguments as of `flows.benchmark`.

    `without` is what an ablation leaves out, `only` ids of the scenes that are run (empty: all).
    """
    from esg.metrics import load_suite

    return [
        SceneRequest(
            prompt=scene.prompt,
            seed=seed + run,
            drafter=drafter,
            strategy=strategy,
            engine=engine,
            device=device,
            suite_scene=scene.model_dump_json(by_alias=True),
            name=f"{scene.id}-run{run}",
            close_loop=close_loop,
            collision=collision,
            without=without,
        )
        for scene in load_suite(suite).scenes
        if not only or scene.id in only
        for run in range(runs)
    ]
