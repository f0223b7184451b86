"""A command that answers first without a warm worker: the work is done by a process of its own."""

from __future__ import annotations

import atexit
from collections.abc import Callable, Sequence
import ctypes
import os
import signal
import sys
from typing import NoReturn

from esg.machine.answering import can_go_on, conclude
from esg.up.client import await_data, passed_on
from esg.up.place import OFF
from esg.up.wire import SIGNALS

NO_WAIT = "--no-wait"
_PDEATHSIG = 1


def apart(main: Callable[[], None], arguments: Sequence[str]) -> int | None:
    """Does a command that asks for it in a process of its own session, which may outlive this one.

    It is forked off before anything is loaded. Until it has answered it ends with this process.

    Args:
        main: The command line: runs `sys.argv` and raises SystemExit.
        arguments: Of the process, without its name.

    Returns:
        The exit code; None if the command is to be done here.
    """
    wanted = list(arguments[:1]) == ["generate"] and NO_WAIT in arguments
    if not wanted or can_go_on() or sys.platform != "linux":
        return None
    inherited = frozenset(int(n) for n in os.listdir("/proc/self/fd") if int(n) > 2)
    reading, writing = os.pipe()
    owner = os.getpid()
    sys.stdout.flush()
    sys.stderr.flush()
    blocked = signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS)
    pid = os.fork()
    if pid == 0:
        signal.pthread_sigmask(signal.SIG_SETMASK, blocked)
        os.close(reading)
        _become(main, writing, owner, inherited)
    os.close(writing)
    with passed_on(lambda number: os.kill(pid, number)):
        signal.pthread_sigmask(signal.SIG_SETMASK, blocked)
        await_data(reading)
        told = os.read(reading, 64)  # or its end, without an answer
    if told:
        return int(told)
    code = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    return code if code >= 0 else 128 - code


def _become(
    main: Callable[[], None], answer: int, owner: int, inherited: frozenset[int]
) -> NoReturn:
    """In the fork: does the command, and never returns."""
    try:
        ctypes.CDLL(None).prctl(_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != owner:
            os._exit(1)
        os.setsid()
        os.environ[OFF] = "0"  # a worker has been asked
        os.environ.setdefault("PXR_WORK_THREAD_LIMIT", "1")  # USD's threads do not survive forks
        atexit._clear()  # what the process that waits does at its end

        conclude(main, lambda code: os.write(answer, b"%d" % code), inherited - {answer})
    finally:
        os._exit(1)
