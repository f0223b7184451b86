"""Ctrl-C and SIGTERM are answered within two seconds, whatever the command is doing.

Python runs its signal handlers between two steps of its own: a search inside one launch of a kernel
hears nothing, and libraries take their time to unwind. A thread that the system wakes at once gives
the command `GRACE_S` to end by itself, then says what happened and ends the process. Nothing is
lost by that: results are renamed into place when they are whole, workers and the scheduler's API
end with the command, and what they left in the temporary folder goes at the next one's start.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from typing import NoReturn

GRACE_S = 1.5
KEPT = "finished stages are kept, run the same command again to go on"
_WORDS = {signal.SIGINT: "interrupted", signal.SIGTERM: "terminated (SIGTERM)"}
_received: list[int] = []
_heard = threading.Event()
_told = threading.Event()


def answer_signals(as_json: bool) -> None:
    """Takes care of both signals from here on; one that the caller ignores stays ignored.

    Args:
        as_json: Whether the command was asked for JSON.
    """
    if signal.getsignal(signal.SIGTERM) == signal.SIG_DFL:
        signal.signal(signal.SIGTERM, _interrupt)
    reading, writing = os.pipe()
    if hasattr(os, "set_blocking"):  # Windows asks for it of sockets only, and lacks it before 3.12
        os.set_blocking(writing, False)
    signal.set_wakeup_fd(writing, warn_on_full_buffer=False)
    threading.Thread(target=_watch, args=(reading, as_json), daemon=True).start()
    sys.unraisablehook = _unraised


def heard() -> bool:
    """Whether a signal has asked the command to end: what fails then fails of that.

    Libraries that look after signals by themselves (DuckDB) raise an error of their own.
    """
    return _heard.wait(0.1)  # the thread that watches may be a step behind


def stopped(as_json: bool) -> int:
    """Ends a command that was stopped by a signal; of one that only seems so, the exit code.

    At once: what Python does at its end (waiting for threads, taking libraries apart) takes
    seconds, in which no thread could keep watch.

    Args:
        as_json: Whether the command was asked for JSON.
    """
    code = _tell(as_json)
    if _received:
        _end(code)
    return code


def _end(code: int) -> NoReturn:
    """Ends this process and its workers, which in native code would not notice for a while."""
    if "multiprocessing" in sys.modules:
        import multiprocessing

        for worker in multiprocessing.active_children():
            worker.kill()
    os._exit(code)


def _tell(as_json: bool) -> int:
    """Says that the command was stopped, once; returns its exit code."""
    from esg.commands.console import fail

    number = next((n for n in _received if n in _WORDS), signal.SIGINT)
    code = 128 + number
    if _told.is_set():
        return code
    _told.set()
    return fail(f"{_WORDS[signal.Signals(number)]}; {KEPT}", code, as_json)


def _interrupt(number: int, frame: object) -> None:
    _received.append(number)
    raise KeyboardInterrupt


def _unraised(args: sys.UnraisableHookArgs) -> None:
    """Says nothing of a finalizer or a callback that was stopped by a signal: that passes nowhere,
    and the watching thread ends the command.
    """
    if issubclass(args.exc_type, Exception):
        sys.__unraisablehook__(args)


def _watch(pipe: int, as_json: bool) -> None:
    while True:
        byte = os.read(pipe, 1)
        if not byte:
            return
        if byte[0] in _WORDS:
            break
    _received.append(byte[0])
    _heard.set()
    time.sleep(GRACE_S)
    if sys.stderr.isatty():
        os.write(sys.stderr.fileno(), b"\x1b[?25h\n")  # a progress display hid the cursor
    _end(_tell(as_json))
