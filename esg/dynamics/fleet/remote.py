"""Crews in processes of their own: jobs travel through pipes, results lie in shared memory."""

from __future__ import annotations

from contextlib import suppress
import gc
import multiprocessing
import os
from threading import Semaphore, Thread
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.fleet.crew import Crew, Task
from esg.engines.jobs import Job, Played


def _crew_process(task: Task, shifts: Any, memory: Any, pipe: Any) -> None:
    gc.freeze()  # no search for garbage need touch, and copy, what the parent has
    crew = Crew(task, shifts, memory)
    begin = time.process_time()
    answered = Semaphore(0)

    def listen() -> None:
        try:
            while (answer := pipe.recv()) is not None:
                crew.answer({n: _rebuild(p, memory) for n, p in answer.items()})
                answered.release()
        finally:
            # Nothing of the parent's, such as a GPU's context, is to be torn down here.
            os._exit(0)

    Thread(target=listen, daemon=True).start()
    try:
        # Shifts hand in without waiting for the answers to those before them.
        reports = len(shifts)
        for _ in range(reports):
            _report(crew, pipe, begin)
        while True:
            for _ in range(reports):
                answered.acquire()
            reports = 1
            _report(crew, pipe, begin)
    finally:
        os._exit(0)


def _report(crew: Crew, pipe: Any, begin: float) -> None:
    jobs, finished = crew.gather()
    crew.parts["all"] = time.process_time() - begin
    pipe.send((jobs, finished, crew.parts))


class Remote:
    """A crew in a process of its own."""

    def __init__(self, task: Task, shifts: Any, memory: NDArray[np.uint8]) -> None:
        context = multiprocessing.get_context("fork")
        self.memory = memory
        self.pipe, there = context.Pipe()
        self.parts: dict[str, float] = {}
        self.process = context.Process(
            target=_crew_process, args=(task, shifts, memory, there), daemon=True
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
