"""Making scenes from prompts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from esg.api.scene import Engine, Scene

if TYPE_CHECKING:
    from esg.pipeline import SceneRequest, SceneState


def generate(
    prompt: str,
    seed: int = 0,
    *,
    out: str | Path = "runs",
    drafter: Literal["rules", "llm", "auto"] = "rules",
    strategy: Literal["batched", "hybrid", "fd", "ad", "none"] = "batched",
    device: str = "cpu",
    engine: Engine = "physx",
    close_loop: bool = False,
    collision: Literal["exact", "proxy", "sdf"] = "exact",
    traffic: Literal["right", "left"] = "right",
) -> Scene:
    """Makes one scene and proves it by replaying what was emitted.

    It runs in this process; stages that are in the cache are not run again. Nothing is written to
    the run database (`esg generate` and `esg bench` do that).

    Args:
        prompt: English description of the scene.
        seed: Of every random choice: the same prompt and seed give the same scene.
        out: Folder that receives the scene folder.
        drafter: rules needs nothing; llm needs an OpenAI-compatible endpoint; auto asks the model
            if one is configured and answers, else the rules.
        strategy: How the physics is searched; none keeps the first guess.
        device: cpu or cuda:N.
        engine: Of the replay: physx runs the emitted class, rapier and newton its program.
        close_loop: Feed the replay's outcome error back to the search, three rounds at most.
        collision: What bodies collide with during the search: exact (their parts), proxy (one
            sphere or box each), or sdf (that first, then signed distance fields).
        traffic: Side of the road that vehicles keep to.

    Returns:
        The scene, whatever its outcome.

    Raises:
        UserError: With everything that is wrong with the arguments or the prompt.
    """
    options: dict[str, Any] = {
        "out": out, "drafter": drafter, "strategy": strategy, "device": device, "engine": engine,
        "close_loop": close_loop, "collision": collision, "traffic": traffic,
    }  # fmt: skip
    return next(generate_many([prompt], seed, **options))


def generate_many(
    prompts: Sequence[str],
    seed: int = 0,
    *,
    out: str | Path = "runs",
    workers: int = 0,
    drafter: Literal["rules", "llm", "auto"] = "rules",
    strategy: Literal["batched", "hybrid", "fd", "ad", "none"] = "batched",
    device: str = "cpu",
    engine: Engine = "physx",
    close_loop: bool = False,
    collision: Literal["exact", "proxy", "sdf"] = "exact",
    traffic: Literal["right", "left"] = "right",
) -> Iterator[Scene]:
    """Makes many scenes, each as it is done, in the order of the prompts.

    Args:
        prompts: English descriptions.
        seed: Of every random choice in each of them.
        out: Folder that receives the scene folders.
        workers: Processes that work at once; 0 makes one scene after the other in this process.
        drafter: As of `generate`, like all that follow.
        strategy: How the physics is searched.
        device: cpu or cuda:N.
        engine: Of the replay.
        close_loop: Feed the replay's outcome error back to the search.
        collision: What bodies collide with during the search.
        traffic: Side of the road that vehicles keep to.

    Yields:
        One scene a prompt, whatever its outcome.

    Raises:
        UserError: With everything that is wrong with the arguments and the prompts, before any
            work; or, as its turn comes, for a prompt from which no scene can be made.
    """
    from esg.api.inputs import (
        check_cache,
        check_device,
        check_seed,
        check_workers,
        checked,
        clean_prompt,
    )
    from esg.pipeline import SceneRequest
    from esg.scenefolder import check_writable

    folder = Path(out)
    chosen, *_ = checked(
        lambda: check_device(device),
        lambda: check_seed(seed),
        lambda: check_workers(workers),
        lambda: check_writable(folder),
        check_cache,
        *(lambda p=p: clean_prompt(p) for p in prompts),
    )
    requests = [
        SceneRequest(
            prompt.strip(),
            seed,
            drafter,
            strategy,
            chosen,
            engine,
            close_loop=close_loop,
            collision=collision,
            traffic=traffic,
        )
        for prompt in prompts
    ]
    return _made(requests, folder, workers)


def _made(requests: Sequence[SceneRequest], out: Path, workers: int) -> Iterator[Scene]:
    from concurrent.futures import ThreadPoolExecutor
    from functools import partial

    from esg.pipeline import run_scene
    from esg.workers import WorkerPool

    if workers == 0 or len(requests) < 2:
        for request in requests:
            yield _published(run_scene(request), out)
        return
    size = min(workers, len(requests))
    with WorkerPool(size) as pool, ThreadPoolExecutor(size) as threads:
        for state in threads.map(partial(pool.run, run_scene), requests):
            yield _published(state, out)


def _published(state: SceneState, out: Path) -> Scene:
    from esg.outcomes import UserError
    from esg.scenefolder import publish

    if state.user_error:
        raise UserError(state.reason)
    return Scene(publish(state, out))
