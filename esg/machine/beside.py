"""Work on files that goes on beside this process, in a fork of it, where that is allowed.

One scene that somebody waits for may use a second core; a batch keeps all cores busy with scenes.
The command that makes one scene says so (`forking`), because only it knows that its threads merely
wait: a fork of a process whose threads work may inherit a lock that nobody will ever release.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
from contextvars import ContextVar
import ctypes
import gc
import json
import os
import signal
import sys
from typing import TypeVar

from esg.machine.answering import can_go_on, let_go
from esg.workers import usable_cores

T = TypeVar("T")

_allowed: ContextVar[bool] = ContextVar("forking", default=False)
_PDEATHSIG = 1


@contextlib.contextmanager
def forking() -> Generator[None]:
    """Allows forks in the body, if this machine has a core for them."""
    token = _allowed.set(sys.platform == "linux" and usable_cores() > 1)
    try:
        yield
    finally:
        _allowed.reset(token)


def may_fork() -> bool:
    """Whether work may be done in a process beside this one."""
    return _allowed.get()


def end_with(owner: int) -> None:
    """In a fork: ends with the process that it was forked off, and not with its signals."""
    ctypes.CDLL(None).prctl(_PDEATHSIG, signal.SIGKILL)
    signal.set_wakeup_fd(-1)
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)  # the command ends it
    if os.getppid() != owner:
        os._exit(1)


@contextlib.contextmanager
def beside(work: Callable[[], T]) -> Generator[Callable[[], T]]:
    """Does work beside the body: in a fork, or without one where its result is asked for.

    Args:
        work: Writes files, changes nothing else, and returns what JSON can say. It may run twice: a
            fork that dies is made up for here.

    Yields:
        A function that waits for the work and returns its result; to be called in the body.
    """
    if not _allowed.get():
        yield work
        return
    reading, writing = os.pipe()
    owner = os.getpid()
    sys.stdout.flush()
    sys.stderr.flush()
    pid = os.fork()
    if pid == 0:
        os.close(reading)
        _in_fork(work, writing, owner)
    os.close(writing)
    over = False

    def result() -> T:
        nonlocal over
        with os.fdopen(os.dup(reading), "rb") as pipe:
            data = pipe.read()
        over = True
        if os.waitpid(pid, 0)[1] == 0:
            return json.loads(data)
        return work()

    try:
        yield result
    finally:
        os.close(reading)
        if not over:  # the body failed: nobody wants the work any more
            os.kill(pid, signal.SIGKILL)
            os.waitpid(pid, 0)


def _in_fork(work: Callable[[], object], out: int, owner: int) -> None:
    """In the fork: does the work, tells its result and ends."""
    code = 1
    try:
        gc.disable()  # it would touch, and so copy, all that there is
        end_with(owner)
        if can_go_on():
            let_go()
        data = memoryview(json.dumps(work()).encode())
        while data:
            data = data[os.write(out, data) :]
        code = 0
    finally:
        os._exit(code)
