"""Crews in processes of their own: jobs travel through pipes, results lie in shared memory."""

from __future__ import annotations

from contextlib import suppress
import multiprocessing
import os
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.fleet_crew import Crew, Task
from esg.engines.fleet_jobs import Job, Played


def _crew_process(task: Task, indices: Any, memory: Any, pipe: Any) -> None:
    try:
        begin = time.process_time()
        crew = Crew(task, indices, memory)
        while True:
            jobs, finished = crew.gather()
            crew.parts["all"] = time.process_time() - begin
            pipe.send((jobs, finished, crew.parts))
            answer = pipe.recv()
            if answer is None:
                break
            crew.answer({n: _rebuild(p, memory) for n, p in answer.items()})
    finally:
        pipe.close()
        # Nothing of the parent's, such as a GPU's context, is to be torn down here.
        os._exit(0)


class Remote:
    """A crew in a process of its own."""

    def __init__(self, task: Task, indices: Any, memory: NDArray[np.uint8]) -> None:
        context = multiprocessing.get_context("fork")
        self.memory = memory
        self.pipe, there = context.Pipe()
        self.parts: dict[str, float] = {}
        self.process = context.Process(
            target=_crew_process, args=(task, indices, memory, there), daemon=True
        )
        self.process.start()
        there.close()

    def gather(self) -> tuple[list[tuple[int, Job]], list[tuple[int, Any]]]:
        jobs, finished, self.parts = self.pipe.recv()
        return jobs, finished

    def answer(self, played: dict[int, Played]) -> None:
        self.pipe.send({n: _located(p, self.memory) for n, p in played.items()})

    def close(self) -> None:
        with suppress(OSError):
            self.pipe.send(None)
        self.process.join(5.0)
        if self.process.is_alive():
            self.process.terminate()
        self.pipe.close()


_STATES = ("position", "quaternion", "linear", "angular")


def _located(p: Played, memory: NDArray[np.uint8]) -> Any:
    """A result whose states are named by where they lie in the shared memory."""
    base = memory.__array_interface__["data"][0]
    places = []
    for name in _STATES:
        a = getattr(p, name)
        places.append((a.__array_interface__["data"][0] - base, a.shape, a.strides))
    return places, p.end, p.deepest, p.log


def _rebuild(sent: Any, memory: NDArray[np.uint8]) -> Played:
    places, end, deepest, log = sent
    x, r, v, o = (
        np.ndarray(shape, np.float32, buffer=memory, offset=at if np.prod(shape) else 0,
                   strides=strides)
        for at, shape, strides in places
    )  # fmt: skip
    return Played(x, r, v, o, end, deepest, log)
