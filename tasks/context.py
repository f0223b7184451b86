"""What tasks of one run share in this process: workers and whoever watches the progress."""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
from dataclasses import dataclass
from functools import cache
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


_ALONE = RunContext(WorkerPool(0))
_current: RunContext | None = None


def current() -> RunContext:
    """The context of the run in progress; without one, calls run in this process."""
    return _current or _ALONE


def expendable_pool() -> WorkerPool:
    """Workers whose death this process survives.

    Those of the run in progress; in a process of a cluster, which is told of no run, a worker of
    its own: what ends it is found and left out, and the cluster does not lose a process for it.
    """
    return _own() if _current is None else _current.pool


@cache
def _own() -> WorkerPool:
    return WorkerPool(1)


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
