"""What tasks of one run share in this process: workers and whoever watches the progress."""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
from dataclasses import dataclass
from pathlib import Path

from esg.pipeline import SceneState
from esg.workers import WorkerPool

Watcher = Callable[[str, SceneState], None]
"""Called with a stage's name and the scene's new state after every stage of every scene."""


def _ignore(stage: str, state: SceneState) -> None:
    return None


@dataclass(frozen=True)
class RunContext:
    """What tasks find.

    Args:
        pool: Where work is done.
        watch: Called after every stage of every scene (esg.progress tells more).
        store: Artifact store of the run; None is the usual one.
    """

    pool: WorkerPool
    watch: Watcher = _ignore
    store: Path | None = None


_current = RunContext(WorkerPool(0))


def current() -> RunContext:
    """The context of the run in progress; without one, calls run in this process."""
    return _current


@contextlib.contextmanager
def run_context(
    pool: WorkerPool, watch: Watcher | None = None, store: Path | None = None
) -> Generator[RunContext]:
    """Makes a pool and a watcher current for all threads (a context variable would not be)."""
    global _current
    before = _current
    _current = RunContext(pool, watch or _ignore, store)
    try:
        yield _current
    finally:
        _current = before
