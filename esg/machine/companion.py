"""A second process of one scene, which loads what its later stages need while earlier ones run.

Python imports on one core, whatever the number of threads. The companion is forked off a command
before it has loaded anything, loads what it was told to, and then does what it is handed. Nothing
depends on it: where there is none, or it dies or fails, work is done here.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
import contextlib
from contextvars import ContextVar
from dataclasses import dataclass, field
import os
import pickle
import signal
import sys
import time
from typing import TYPE_CHECKING, Any, TypeVar

from esg.machine.answering import can_go_on, let_go, lower
from esg.machine.beside import end_with, may_fork

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

T = TypeVar("T")
Work = Callable[[], object]

_POLL_S = 0.1
"""So often who waits runs Python, so that a stage that is out of time can be interrupted."""


@dataclass
class _Companion:
    """The process, the pipe to it, and what is loaded here while there is nothing else to do."""

    pid: int
    pipe: Connection
    meanwhile: list[Work]
    answers: list[tuple[bool, Any]] = field(default_factory=list)
    asked: int = 0
    spent_s: float = 0.0

    def load_next(self) -> None:
        """Loads the next of the things that are to be loaded here, if any are left."""
        if self.meanwhile:
            with contextlib.suppress(Exception):  # told by who needs it
                self.meanwhile.pop(0)()

    def ask(self, work: Work) -> int:
        """Hands work over; the number under which its answer is known."""
        self.pipe.send_bytes(pickle.dumps(work))
        self.asked += 1
        return self.asked - 1

    def answer(self, number: int) -> tuple[bool, Any]:
        """Whether a piece of work was done, and its result; waits for it."""
        while len(self.answers) <= number:
            while not self.pipe.poll(_POLL_S):
                pass
            self.spent_s, *answer = pickle.loads(self.pipe.recv_bytes())
            self.answers.append((answer[0], answer[1]))
        return self.answers[number]


_current: ContextVar[_Companion | None] = ContextVar("companion", default=None)


@contextlib.contextmanager
def companion(idle: Sequence[Work], meanwhile: Sequence[Work] = ()) -> Generator[None]:
    """Starts a companion for the body, where forks are allowed (`beside.forking`).

    Args:
        idle: What it loads: the first before anything is handed to it, the next one after the first
            work, and so on. What fails there is left to who needs it.
        meanwhile: What is loaded here, one after the other, while there is nothing to do but wait.
    """
    if not may_fork():
        yield
        return
    from multiprocessing import Pipe

    here, there = Pipe()
    owner = os.getpid()
    sys.stdout.flush()
    sys.stderr.flush()
    pid = os.fork()
    if pid == 0:
        here.close()
        _serve(there, idle, owner)
    there.close()
    token = _current.set(_Companion(pid, here, list(meanwhile)))
    try:
        yield
    finally:
        _current.reset(token)
        here.close()
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)


def spent_s() -> float:
    """Processor time of the companion, as far as it is known here [s]."""
    found = _current.get()
    return 0.0 if found is None else found.spent_s


@contextlib.contextmanager
def handed(work: Callable[[], T]) -> Generator[Callable[[], T] | None]:
    """Has a companion do work while the body runs.

    Args:
        work: A function of a module, or a partial one, that writes files and changes nothing else.
            It may run twice: what a companion fails at is done again here.

    Yields:
        A function that waits for the work and returns its result; None if there is no companion.
    """
    found = _current.get()
    number = None
    if found is not None:
        with contextlib.suppress(OSError):  # it has died
            number = found.ask(work)
    if found is None or number is None:
        yield None
        return

    def result() -> T:
        found.load_next()
        while found.meanwhile and not found.pipe.poll():
            found.load_next()
        try:
            done, value = found.answer(number)
        except (EOFError, OSError):
            return work()
        return value if done else work()

    yield result


def load_rest(over: Callable[[], bool]) -> None:
    """Loads what is left to be loaded here, for who waits for something else.

    Args:
        over: Whether that is there: what is still left then is loaded by who needs it.
    """
    found = _current.get()
    while found is not None and found.meanwhile and not over():
        found.load_next()


def accompanied() -> bool:
    """Whether there is a companion."""
    return _current.get() is not None


def done_elsewhere(work: Callable[[], T]) -> T:
    """The result of work that a companion does, where there is one; done here else."""
    with handed(work) as result:
        return work() if result is None else result()


def _serve(pipe: Connection, idle: Sequence[Work], owner: int) -> None:
    """In the fork: loads, does what it is handed, and ends with the command."""
    try:
        end_with(owner)
        if can_go_on():
            let_go()
        left = list(idle)
        while True:
            if left:
                with contextlib.suppress(Exception):
                    left.pop(0)()
            data = pipe.recv_bytes()
            try:
                answer = (True, pickle.loads(data)())
            except Exception:
                answer = (False, None)
            pipe.send_bytes(pickle.dumps((time.process_time(), *answer)))
            if can_go_on():
                lower()  # what comes now is for pictures, which nobody waits for
    except (EOFError, OSError):
        pass
    finally:
        os._exit(0)
