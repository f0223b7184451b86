"""`esg setup`: everything that would otherwise stall a first scene, done once per machine."""

from __future__ import annotations

from collections.abc import Callable
import sys
import time

SAMPLES = (
    ("A red ball rolls across the floor and hits a wooden box.", "exact"),
    ("A table with a vase on it.", "exact"),
    ("A wooden box slides across the floor and hits another wooden box.", "sdf"),
)
"""Prompts whose whole way through the stages loads and compiles what scenes need, each with what
bodies collide with in its search; the last one compiles the kernels of signed distance fields."""


def setup() -> int:
    """Compile and cache all kernels (a few minutes the first time, seconds afterwards)."""
    from pathlib import Path
    import tempfile

    from esg.engines import warmup
    from esg.paths import cache_dir

    _step("scheduler database", _prefect)
    _step("engine kernels", lambda: warmup(progress=_line))
    _step("surrogate kernels", _surrogate)
    with tempfile.TemporaryDirectory(prefix="esg-setup-") as folder:
        for number, sample in enumerate(SAMPLES, 1):
            name = f"sample scene {number} of {len(SAMPLES)}"
            _step(name, lambda s=sample: _sample(*s, Path(folder)))
    print(f"ready; caches are in {cache_dir()} and in warp's kernel cache")
    return 0


def _step(name: str, work: Callable[[], object]) -> None:
    start = time.perf_counter()
    _show(f"{name} ...")
    work()
    _show("")
    print(f"{name}: {time.perf_counter() - start:.1f} s", flush=True)


def _show(text: str) -> None:
    """The line that is overwritten: only on a terminal."""
    if sys.stderr.isatty():
        print(f"\r\x1b[K{text}", end="", file=sys.stderr, flush=True)


def _line(name: str, done: int, total: int) -> None:
    _show(f"engine kernels {done}/{total}: {name}")


def _prefect() -> None:
    from flows.embedded import prepare_template

    prepare_template()


def _surrogate() -> None:
    from esg.engines.surrogate_tape import warmup

    warmup()


def _sample(prompt: str, collision: str, root: object) -> None:
    from pathlib import Path

    from esg.outcomes import UserError
    from esg.pipeline import STAGES, SceneRequest, SceneState, run_stage, scratch_store

    assert isinstance(root, Path)
    with scratch_store(root):
        state = SceneState(SceneRequest(prompt, collision=collision))
        for stage in STAGES:
            _show(f"sample scene: {stage}")
            state = run_stage(stage, state)
    if len(state.artifacts) < len(STAGES):
        raise UserError(f"the sample scene {prompt!r} failed: {state.reason}", exit_code=1)
