"""Limits of stages: how many scenes may be in one at a time on this machine, and how long.

`ESG_STAGE_LIMITS="optimize=1,replay=4"`: whatever the number of workers and commands, at most one
search runs at a time (one GPU), and four replays. A place in a stage is a locked file, so that it
is free again the moment its process ends, however it ends. `ESG_STAGE_SECONDS=900` is what one
stage of one scene may take.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping
import contextlib
import ctypes
import faulthandler
import multiprocessing
import os
import threading
import time

from esg.notices import warn
from esg.outcomes import UserError
from esg.paths import cache_dir
from esg.pipeline import STAGES
from esg.settings import STAGE_S
from esg.workers import OUT_OF_TIME

VARIABLE = "ESG_STAGE_LIMITS"
LIMITED = (*STAGES, "render")
"""Stages of scenes, and the pictures of a dataset's scenes."""
_WAIT_S = 0.05
_INTERRUPTS = 10
"""So many times, once a second, a stage that ran out of time is asked to end."""


class StageTimeout(BaseException):
    """A stage ran longer than it may. Not an `Exception`: no handler of a stage may swallow it."""


def stage_limits(text: str | None = None) -> Mapping[str, int]:
    """The limits that are set.

    Args:
        text: `stage=number` pairs with commas between; default the environment variable.

    Raises:
        UserError: Naming every pair that is none.
    """
    text = os.environ.get(VARIABLE, "") if text is None else text
    out: dict[str, int] = {}
    problems: list[str] = []
    for pair in filter(None, (p.strip() for p in text.split(","))):
        stage, _, number = (p.strip() for p in pair.partition("="))
        if stage not in LIMITED:
            problems.append(f"{pair!r}: no stage {stage!r}; stages are {', '.join(LIMITED)}")
        elif not number.isdecimal() or len(number) > 4 or not 1 <= int(number) <= 1024:
            problems.append(f"{pair!r}: give a number from 1 to 1024, e.g. {stage}=2")
        else:
            out[stage] = int(number)
    if problems:
        raise UserError("\n".join(f"{VARIABLE} {p}" for p in problems))
    return out


@contextlib.contextmanager
def place_in(stage: str, *, where: str = "", most: int | None = None) -> Generator[None]:
    """Waits for a place in a stage and keeps it for the body; without a limit, at once.

    Args:
        stage: What the body does.
        where: Places that are apart, such as devices.
        most: The limit if none is set.
    """
    limit = stage_limits().get(stage, most)
    if limit is None:
        yield
        return
    with contextlib.ExitStack() as held:
        while not taken(f"{stage}{where}", limit, held):
            time.sleep(_WAIT_S)
        yield


def taken(name: str, limit: int, held: contextlib.ExitStack) -> bool:
    """Takes one of a number of places on this machine, if one is free.

    Args:
        name: Of the places.
        limit: How many there are.
        held: Gives the place back.

    Returns:
        Whether one was free.
    """
    from filelock import FileLock, Timeout

    folder = cache_dir() / "limits"
    folder.mkdir(parents=True, exist_ok=True)
    for k in range(limit):
        place = FileLock(folder / f"{name}-{k}.lock", timeout=0)
        try:
            place.acquire()
        except Timeout:
            continue
        held.callback(place.release)
        return True
    return False


@contextlib.contextmanager
def limited(stage: str, seconds: float | None = None) -> Generator[None]:
    """Ends the body once it takes too long.

    The body is interrupted wherever Python runs next, so that its scene ends and the others go on.
    Native code that never comes back ends the process: a worker with `OUT_OF_TIME`, the command
    with 1 and a message. Code that also keeps Python's lock is ended without one, a minute later.

    Args:
        stage: What runs, for messages.
        seconds: Limit [s]; default `ESG_STAGE_SECONDS`, 0: none.

    Raises:
        StageTimeout: In the body.
    """
    limit = STAGE_S.value if seconds is None else seconds
    if limit <= 0.0:
        yield
        return
    told = f"{stage} ran longer than its limit of {limit:g} s (ESG_STAGE_SECONDS)"
    thread, ended, lock = threading.get_ident(), threading.Event(), threading.Lock()

    def watch() -> None:
        wait = limit
        for _ in range(_INTERRUPTS):
            if ended.wait(wait):
                return
            with lock:
                if not ended.is_set():
                    _raise_in(thread, StageTimeout)
            wait = 1.0
        if not ended.wait(wait):
            warn([told])
            os._exit(1 if multiprocessing.parent_process() is None else OUT_OF_TIME)

    with open(os.devnull, "w") as nowhere:
        faulthandler.dump_traceback_later(limit + 60.0, exit=True, file=nowhere)
        threading.Thread(target=watch, daemon=True).start()
        try:
            yield
        except StageTimeout:
            raise StageTimeout(told) from None
        finally:
            with lock:
                ended.set()
                _raise_in(thread, None)  # one that has not been raised yet must not be later
            faulthandler.cancel_dump_traceback_later()


def _raise_in(thread: int, error: type[BaseException] | None) -> None:
    """Raises an exception in a thread at its next step of Python, or takes it back."""
    what = None if error is None else ctypes.py_object(error)
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), what)
