"""What tasks of one run share in this process: workers and whoever watches the progress."""

from __future__ import annotations

from collections.abc import Callable, Generator
from concurrent.futures import Future
import contextlib
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
import threading
from typing import Any, TypeVar

from esg.pipeline import SceneState
from esg.workers import WorkerPool

_Draft = TypeVar("_Draft")
_Found = TypeVar("_Found")

Watcher = Callable[[str, SceneState], None]
"""Called with a stage's name and the scene's new state after every stage of every scene."""


def _ignore(stage: str, state: SceneState) -> None:
    return None


class Searchers:
    """Processes that do nothing but search whole batches, beside those that do all else.

    Args:
        pool: The processes. With two, one plans while the other's launches run.
    """

    def __init__(self, pool: WorkerPool) -> None:
        self.pool = pool
        ahead = 2 * pool.processes
        self.in_hand = 2 * pool.processes + ahead
        """Batches that are begun: as many are proved as searched, and so many drafted ahead that
        cores have enough to do until the first are searched; further drafts would fill the disk."""
        self._free = threading.BoundedSemaphore(pool.processes)
        self._ready = threading.BoundedSemaphore(ahead)

    def search(self, draft: Callable[[], _Draft], search: Callable[[_Draft], _Found]) -> _Found:
        """What `search` finds for what `draft` makes; drafts wait until few others are ready."""
        with contextlib.ExitStack() as ready:
            ready.enter_context(self._ready)
            drafted = draft()
            with self._free:
                ready.close()
                return search(drafted)


@dataclass(frozen=True)
class RunContext:
    """What tasks find.

    Args:
        pool: Where work is done.
        watch: Called after every stage of every scene (esg.progress tells more).
        store: Artifact store of the run; None is the usual one.
        searchers: Processes that only search; None: searches are done where all else is.
        begun: What will come of batches that were begun before their tasks, by the folder of the
            dataset and number; whoever takes one up takes it out.
    """

    pool: WorkerPool
    watch: Watcher = _ignore
    store: Path | None = None
    searchers: Searchers | None = None
    begun: dict[tuple[Path, int], Future[Any]] = field(default_factory=dict)


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
    pool: WorkerPool,
    watch: Watcher | None = None,
    store: Path | None = None,
    searchers: WorkerPool | None = None,
) -> Generator[RunContext]:
    """Makes a pool and a watcher current for all threads (a context variable would not be)."""
    global _current
    before = _current
    apart = Searchers(searchers) if searchers is not None and searchers.processes else None
    _current = RunContext(pool, watch or _ignore, store, apart)
    try:
        yield _current
    finally:
        _current = before
