"""Answering before a process ends: who waits is told how a command came out, and work goes on.

A warm worker's fork and a command that was detached (esg.up) are not the process that their caller
waits for. They can say how they came out, let go of all that is the caller's, and finish beside
what only takes time.
"""

from __future__ import annotations

import atexit
from collections.abc import Callable
import contextlib
import ctypes
from dataclasses import dataclass, field
import os
from pathlib import Path
import signal
import sys
import threading
from typing import NoReturn, TypeVar

T = TypeVar("T")

LESS = 10
"""Steps of niceness below the caller: a command beside it gets nine tenths of a core, and work that
nobody waits for still ends on a machine that is never idle."""
_PDEATHSIG = 1


@dataclass
class _Answering:
    """Whether this process can answer before it ends, and what it then goes on with."""

    possible: bool = False
    inherited: frozenset[int] = frozenset()
    left: list[Callable[[], object]] = field(default_factory=list)


_here = _Answering()
_low: set[int] = set()
"""The process that has low priority, if it is this one."""


def can_go_on() -> bool:
    """Whether this process can go on after its command has been answered."""
    return _here.possible


def afterwards(work: Callable[[], object]) -> None:
    """Leaves work for after the answer; only where `can_go_on`.

    Args:
        work: Tells whoever needs to know how it came out; what it raises is dropped.
    """
    _here.left.append(work)


def conclude(
    main: Callable[[], None],
    tell: Callable[[int], object],
    inherited: frozenset[int] = frozenset(),
) -> NoReturn:
    """Runs a command, and ends this process with its exit code once nothing is left to be done.

    Args:
        main: The command line: runs `sys.argv` and raises SystemExit.
        tell: Answers the caller; called if something is left for afterwards.
        inherited: Descriptors of the caller's beside its streams; locks, for example.
    """
    code = 1
    try:
        _here.possible, _here.inherited = True, inherited
        try:
            main()
        except SystemExit as error:
            code = error.code if isinstance(error.code, int) else int(error.code is not None)
        _flush()
        if _here.left:
            _to_the_background()  # before the caller may end, which ends what hangs on it
            tell(code)
            for work in _here.left:
                with contextlib.suppress(Exception):
                    work()
        threading._shutdown()  # pyright: ignore[reportAttributeAccessIssue]  # as Python's own end does
        atexit._run_exitfuncs()
        _flush()
    finally:
        os._exit(code)


def let_go() -> None:
    """Lets go of the caller's streams and locks: who waits for their end does not wait for this."""
    for number in _here.inherited:
        with contextlib.suppress(OSError):
            os.close(number)
    nowhere = os.open(os.devnull, os.O_RDWR)
    held = {0, 1, 2}
    for stream in (sys.stdin, sys.stdout, sys.stderr):
        with contextlib.suppress(AttributeError, OSError, ValueError):
            held.add(stream.fileno())
    for number in held - {nowhere}:
        os.dup2(nowhere, number, inheritable=number < 3)
    if nowhere not in held:
        os.close(nowhere)


def lowly(work: Callable[[], T], owner: int) -> T:
    """Does work at low priority, if that is done in another process.

    Args:
        work: What to do.
        owner: The process that goes on meanwhile.
    """
    if os.getpid() != owner:
        lower()
    return work()


def lower() -> None:
    """Gives this process low priority, for all that it still does."""
    if _low != {os.getpid()}:
        _low.clear()
        _low.add(os.getpid())
        with contextlib.suppress(OSError):
            os.nice(LESS)


def _to_the_background() -> None:
    """Becomes a process of nobody: it lives on without its worker and its caller's terminal."""
    ctypes.CDLL(None).prctl(_PDEATHSIG, 0)
    for number in (signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    let_go()
    lower()
    # Where each session is a group of its own to the scheduler, the group's niceness counts.
    if os.getsid(0) == os.getpid():
        with contextlib.suppress(OSError):
            Path("/proc/self/autogroup").write_text(str(LESS))


def _flush() -> None:
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError, ValueError):
            stream.flush()
