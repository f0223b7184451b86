"""What a run is doing right now: small events that anyone may listen to.

Every stage of every scene says when it starts and when it has finished, in whichever process it
runs; listeners are called in the command's own process, one event at a time:

    from esg.progress import StageEvent, listening

    def show(event: StageEvent) -> None:
        if event.status == "finished":
            print(event.scene, event.stage, event.seconds, event.outcome)

    with listening(show):
        ...  # run a flow, `esg.pipeline.run_scene`, a dataset

A worker process forwards its events through a pipe that its pool hands it (`forward_to`). Tasks
that a Dask or Ray cluster runs are silent until their batch has finished. Listeners must be quick
and must not raise: what one raises is dropped, because a display is no reason to fail a run.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
from dataclasses import dataclass
import pickle
import threading
from typing import Any, Literal

Status = Literal["started", "finished"]


@dataclass(frozen=True)
class StageEvent:
    """One step of one scene.

    Args:
        scene: Name of the scene run: the request's name, else its prompt.
        stage: One of `esg.pipeline.STAGES`.
        status: started or finished.
        seed: The scene run's seed.
        seconds: Duration of a finished stage [s].
        cached: Whether a finished stage's result was found instead of computed.
        outcome: Value of the Outcome enum if the stage ended the scene, else empty.
        reason: Why the scene ended like that.
    """

    scene: str
    stage: str
    status: Status
    seed: int = 0
    seconds: float = 0.0
    cached: bool = False
    outcome: str = ""
    reason: str = ""


Listener = Callable[[StageEvent], None]

_listeners: list[Listener] = []
_lock = threading.Lock()
_pipe: Any = None


@contextlib.contextmanager
def listening(listener: Listener) -> Generator[None]:
    """Calls `listener` with every event of all threads and workers while the body runs."""
    _listeners.append(listener)
    try:
        yield
    finally:
        _listeners.remove(listener)


def emit(event: StageEvent) -> None:
    """Tells the listeners, or in a worker process the command."""
    if _pipe is not None:
        with contextlib.suppress(OSError, ValueError):
            _pipe.send(event)
        return
    with _lock:
        for listener in tuple(_listeners):
            with contextlib.suppress(Exception):
                listener(event)


def forward_to(pipe: Any) -> None:
    """In a worker process: sends all events through the writing end of a pipe (see `relay`)."""
    global _pipe
    _pipe = pipe


def relay(pipe: Any) -> threading.Thread:
    """In the command: a started thread that emits what comes out of a pipe until it ends."""

    def pump() -> None:
        # A process that dies mid-message leaves the end of the pipe, or half a message.
        with contextlib.suppress(EOFError, OSError, pickle.UnpicklingError), pipe:
            while True:
                emit(pipe.recv())

    thread = threading.Thread(target=pump, name="esg-progress", daemon=True)
    thread.start()
    return thread
