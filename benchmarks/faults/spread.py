"""Faults spread over processes, each with places of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import partial
import multiprocessing
import os
from pathlib import Path
from typing import TypeVar

T = TypeVar("T")
R = TypeVar("R")


def spread(
    work: Callable[[Path, T], R], items: Iterable[T], folder: Path, jobs: int
) -> Iterator[R]:
    """Does work on every item; results come in the items' order.

    Args:
        work: Takes a place that no other process uses, and the item; defined at module level.
        items: To be worked on.
        folder: Receives the places.
        jobs: Processes; 1: this one alone.
    """
    if jobs == 1:
        yield from map(partial(_placed, work, folder), items)
        return
    # Forked: libraries that are loaded are loaded in all of them.
    context = multiprocessing.get_context("fork")
    with ProcessPoolExecutor(jobs, mp_context=context) as pool:
        yield from pool.map(partial(_placed, work, folder), items)


def _placed(work: Callable[[Path, T], R], folder: Path, item: T) -> R:
    return work(folder / f"place{os.getpid()}" / "it", item)
