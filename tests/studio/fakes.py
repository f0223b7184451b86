"""A pool that makes scenes at once, or as a test lets it."""

from __future__ import annotations

from collections.abc import Callable
import threading
from typing import Any

from esg.outcomes import Outcome
from esg.pipeline import SceneRequest, SceneState
from esg.progress import StageEvent, emit


class Pool:
    """Stands for `WorkerPool(1)`.

    Args:
        hold: Whether a call waits until it is let go or the pool is stopped.
        slow: Word of the prompts whose call waits until the pool is stopped.
    """

    def __init__(self, *, hold: bool = False, slow: str = "") -> None:
        self.go = threading.Event()
        self.slow = slow
        self.ended = threading.Event()
        self.asked: list[SceneRequest] = []
        self.stopped = False
        if not hold:
            self.go.set()

    def run(self, _: Callable[..., Any], request: SceneRequest) -> SceneState:
        self.asked.append(request)
        name = request.name
        emit(StageEvent(name, "draft", "started"))
        emit(StageEvent(name, "draft", "finished", seconds=0.5))
        emit(StageEvent(name, "resolve", "finished", cached=True))
        if "crash" in request.prompt:
            raise RuntimeError("the worker process ended twice")
        if self.slow and self.slow in request.prompt:
            emit(StageEvent(name, "optimize", "started"))
            self.ended.wait(60)
        self.go.wait(10)
        if self.stopped:
            raise KeyboardInterrupt
        log = ({"stage": "draft", "cached": False, "seconds": 0.5},)
        return SceneState(request, log=log, outcome=Outcome.SOLVED)

    def stop(self) -> None:
        self.stopped = True
        self.ended.set()
        self.go.set()

    def close(self) -> None:
        pass
