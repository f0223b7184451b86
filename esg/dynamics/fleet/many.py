"""Many scenes at once: their searches run side by side and share every launch of the engines.

Each scene is searched by the very code that searches a single one (`search`, `batched`). Only its
engines differ: a rollout is a job that is handed in, and the search waits until all scenes that are
still searching have handed in theirs. Then one launch of the surrogate plays all candidates of all
scenes; when no scene asks for the surrogate any more, one Newton model plays what is left to
confirm. Python's share (plans, programs, losses) is spread over processes.
"""

from __future__ import annotations

from collections.abc import Sequence
import mmap
from threading import Thread
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.fleet.crew import Crew, Task
from esg.dynamics.fleet.remote import Remote
from esg.dynamics.fleet.server import Clock, Server
from esg.dynamics.search.baselines import BASELINES
from esg.dynamics.strategies import MAX_ROUNDS
from esg.engines.base import breadth
from esg.graph.models import EsgDocument
from esg.outcomes import UserError

STRATEGIES = ("batched", "fd", "none", *BASELINES)
BUFFER_BYTES = {"cpu": 1_000_000_000, "cuda": 16_000_000_000}
TOUCHED_BYTES = 2_000_000
"""Usual size of the first results of a scene."""
SHIFT_SCENES = 250
"""Scenes that begin together: enough to fill a GPU, while others are still planned."""


def optimize_many(
    docs: Sequence[EsgDocument],
    seeds: Sequence[int],
    *,
    device: str = "cpu",
    strategy: str = "batched",
    max_rounds: int = MAX_ROUNDS,
    processes: int = 1,
    clock: Clock | None = None,
) -> list[EsgDocument]:
    """Grounds the timelines of many documents together; see `esg.dynamics.optimize`.

    Args:
        docs: Documents with assets and layout.
        seeds: One per document.
        device: Where the engines run.
        strategy: As for single scenes, except those that differentiate the surrogate.
        max_rounds: As for single scenes.
        processes: That plan, compile and measure beside the one that simulates; 1 for none.
        clock: Is told where the time went.

    Returns:
        The documents with `dynamics_result`, in order: found by the same decisions as if each had
        been optimized alone. The surrogate gives the same bytes; Newton does, too, on the CPU,
        unless a more crowded scene in the batch makes its solver add up in another order.

    Raises:
        UserError: For an unknown strategy, or as many seeds as documents are not given.
    """
    if strategy not in STRATEGIES:
        raise UserError(f"unknown strategy {strategy!r}; many at once: {', '.join(STRATEGIES)}")
    if len(seeds) != len(docs):
        raise UserError(f"{len(docs)} documents need as many seeds, not {len(seeds)}")
    if not docs:
        return []
    kind = "cpu" if device == "cpu" else "cuda"
    task = Task(
        tuple(docs), tuple(seeds), strategy, max_rounds,
        hold=device == "cpu", breadth=breadth(device),
    )  # fmt: skip
    memory = _memory(BUFFER_BYTES[kind], shared=processes > 1)
    shifts = np.array_split(np.arange(len(docs)), max(1, round(len(docs) / SHIFT_SCENES)))
    n = max(1, min(processes, len(docs)))
    parts = [[shift[k::n] for shift in shifts] for k in range(n)]
    crews: list[Any]
    if processes > 1:
        crews = [Remote(task, part, memory) for part in parts]
    else:
        crews = [Crew(task, parts[0], memory)]
    if processes > 1:
        size = min(len(memory), TOUCHED_BYTES * len(docs))
        Thread(target=_touch, args=(memory[:size],), daemon=True).start()
    try:
        return Server(device, memory, clock or Clock()).run(crews, len(docs), len(shifts))
    finally:
        for crew in crews:
            crew.close()


def _memory(size: int, *, shared: bool) -> NDArray[np.uint8]:
    """Memory for results; pages exist from their first use on."""
    if not shared:
        return np.zeros(size, np.uint8)
    return np.frombuffer(mmap.mmap(-1, size), np.uint8)


def _touch(memory: NDArray[np.uint8]) -> None:
    """Lets pages exist before they are needed, while the processes plan their scenes."""
    # Reading is enough, and harmless to what has been written already.
    np.add.reduce(memory[:: mmap.PAGESIZE], dtype=np.int64)
