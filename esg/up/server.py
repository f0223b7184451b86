"""The warm worker: it loads what scenes need, then forks for every command it is asked to run.

Its own process runs no command and starts no thread: a fork of it is a process in which everything
is loaded and nothing has happened. Each command runs in a fork of its own, in a session of its own,
with the caller's folder, streams, environment, limits and signals, and ends with it.
"""

from __future__ import annotations

from collections.abc import Callable
import contextlib
import ctypes
from dataclasses import dataclass, field
import gc
import json
import os
from pathlib import Path
import resource
import selectors
import signal
import socket
import sys
import tempfile
import time
from typing import NoReturn

from filelock import FileLock, Timeout

from esg.machine.answering import conclude
from esg.up import wire
from esg.up.place import OFF, make_private, stamp

REQUEST_S = 5.0
"""Whoever connects and says nothing for so long is hung up on."""
KILL_AFTER_S = 5.0
"""From asking the process of a command whose caller is gone to end, to killing it."""
TAKEN_PLACE = 75
"""Exit code of a worker where another one serves."""
_PDEATHSIG = 1


@dataclass
class Run:
    """A command that is being run.

    Args:
        pid: Of its process, which leads its own group.
        connection: To its caller.
        answer: Pipe on which it tells its exit code, if it goes on after it.
        answered: Whether it has: its caller is gone, and it finishes what it left.
        kill_at: When it is killed, if its caller is gone (monotonic) [s].
    """

    pid: int
    connection: socket.socket
    answer: int
    answered: bool = False
    kill_at: float | None = None


@dataclass
class Worker:
    """A warm worker's state.

    Args:
        listener: Its socket.
        path: Where that lies.
        main: The command line: runs `sys.argv` and raises SystemExit.
        idle_s: It ends after so long without a command [s].
        stamp: Of the code that it loaded.
    """

    listener: socket.socket
    path: Path
    main: Callable[[], None]
    idle_s: float
    stamp: str
    pid: int = field(default_factory=os.getpid)
    runs: dict[int, Run] = field(default_factory=dict)
    served: int = 0
    open: bool = True
    started: float = field(default_factory=time.monotonic)
    last: float = field(default_factory=time.monotonic)


def serve(main: Callable[[], None], path: Path, idle_s: float) -> int:
    """Serves until nobody has asked for long, or somebody stops it.

    Args:
        main: The command line: runs `sys.argv` and raises SystemExit.
        path: Of the socket.
        idle_s: Without a command, it ends after so long [s].

    Returns:
        0; `TAKEN_PLACE` if another worker serves there.
    """
    make_private(path.parent)
    with contextlib.ExitStack() as alone:
        try:
            alone.enter_context(FileLock(path.with_suffix(".lock"), blocking=False))
        except Timeout:
            return TAKEN_PLACE
        own = stamp()  # before anything is loaded: a file changed meanwhile makes it stale
        warm()
        path.unlink(missing_ok=True)  # of a worker that was killed: the lock is ours
        listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        before = os.umask(0o177)
        try:
            listener.bind(str(path))
        finally:
            os.umask(before)
        listener.listen(16)
        worker = Worker(listener, path, main, idle_s, own)
        try:
            _loop(worker)
        finally:
            _close(worker)
    return 0


def warm() -> None:
    """Loads what scenes need and runs sample scenes, whose results are thrown away."""
    from esg.api.warming import SAMPLES, warm_up
    from esg.pipeline import SceneRequest, run_scene, scratch_store
    from esg.runs import record_run

    warm_up()
    with contextlib.suppress(Exception), tempfile.TemporaryDirectory(prefix="esg-up-") as folder:
        for prompt in SAMPLES:
            with scratch_store(Path(folder), durable=False):
                state = run_scene(SceneRequest(prompt))
                record_run([state], "generate", database=Path(folder) / "esg.duckdb")
    gc.collect()
    gc.freeze()  # what is loaded stays: no search for garbage in a fork need touch, and copy, it


def _loop(worker: Worker) -> None:
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    os.set_blocking(reading, False)
    signal.set_wakeup_fd(writing, warn_on_full_buffer=False)
    signal.signal(signal.SIGCHLD, lambda number, frame: None)
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda number, frame: _shut(worker))
    with selectors.DefaultSelector() as waiting:
        waiting.register(reading, selectors.EVENT_READ)
        waiting.register(worker.listener, selectors.EVENT_READ)
        while worker.open or worker.runs:
            for key, _ in waiting.select(_patience(worker)):
                if key.fileobj is worker.listener:
                    _accept(worker, waiting)
                elif key.fileobj == reading:
                    with contextlib.suppress(BlockingIOError):
                        os.read(reading, 4096)
                elif (run := worker.runs.get(key.data)) is not None:
                    if key.fileobj == run.answer:
                        _relay(worker, run, waiting)
                    else:
                        _listen(run, waiting)
            _reap(worker, waiting)
            _kill_late(worker)
            if not worker.runs and time.monotonic() - worker.last >= worker.idle_s:
                _shut(worker)
            if not worker.open and worker.listener.fileno() >= 0:
                waiting.unregister(worker.listener)
                worker.listener.close()


def _patience(worker: Worker) -> float | None:
    """Seconds until something is due without anybody asking; None if nothing is."""
    due = [r.kill_at for r in worker.runs.values() if r.kill_at is not None]
    due += [] if worker.runs else [worker.last + worker.idle_s]
    return max(0.0, min(due) - time.monotonic()) + 0.01 if due else None


def _shut(worker: Worker) -> None:
    """Takes no more commands; those that run finish."""
    if worker.open:
        worker.open = False
        worker.path.unlink(missing_ok=True)


def _close(worker: Worker) -> None:
    _shut(worker)
    for run in worker.runs.values():
        if not run.answered:
            _signal(run, signal.SIGTERM)


def _accept(worker: Worker, waiting: selectors.BaseSelector) -> None:
    try:
        connection, _ = worker.listener.accept()
    except OSError:
        return
    connection.settimeout(REQUEST_S)
    try:
        if wire.peer(connection) != os.getuid():
            raise wire.WireError("another user")
        wire.tell(connection, wire.HERE)
        request, handles = wire.receive_request(connection)
    except (OSError, wire.WireError):
        connection.close()
        return
    if request.kind != "run":
        _answer(worker, request.kind, connection)
        return
    worker.last = time.monotonic()
    if request.stamp != worker.stamp or not worker.open:
        wire.close_all(handles)
        wire.tell(connection, wire.REFUSED, "other code")
        connection.close()
        _shut(worker)  # nobody with this code is left to ask
        return
    if not wire.tell(connection, wire.TAKEN):
        wire.close_all(handles)
        connection.close()
        return
    worker.served += 1
    sys.stdout.flush()
    sys.stderr.flush()
    reading, writing = os.pipe()
    os.set_blocking(reading, False)
    pid = os.fork()
    if pid == 0:
        os.close(reading)
        _become(worker, waiting, connection, request, handles, writing)
    os.close(writing)
    wire.close_all(handles)
    worker.runs[pid] = Run(pid, connection, reading)
    waiting.register(connection, selectors.EVENT_READ, pid)
    waiting.register(reading, selectors.EVENT_READ, pid)


def _answer(worker: Worker, kind: str, connection: socket.socket) -> None:
    with connection:
        now = time.monotonic()
        facts = {
            "pid": os.getpid(),
            "up_s": round(now - worker.started, 1),
            "idle_s": 0.0 if worker.runs else round(now - worker.last, 1),
            "ends_after_s": worker.idle_s,
            "running": sum(not run.answered for run in worker.runs.values()),
            "finishing": sum(run.answered for run in worker.runs.values()),
            "served": worker.served,
            "current": worker.stamp == stamp(),
        }
        if kind == "stop":
            _shut(worker)
        wire.tell(connection, "status", json.dumps(facts))


def _relay(worker: Worker, run: Run, waiting: selectors.BaseSelector) -> None:
    """Tells a caller what its command has answered, which goes on without it."""
    told = b""
    with contextlib.suppress(BlockingIOError):
        told = os.read(run.answer, 64)
    with contextlib.suppress(KeyError):
        waiting.unregister(run.answer)
    if not told:
        return
    if run.kill_at is None:
        waiting.unregister(run.connection)
    run.answered, run.kill_at = True, None
    worker.last = time.monotonic()
    wire.tell(run.connection, wire.ENDED, told.decode())
    run.connection.close()


def _listen(run: Run, waiting: selectors.BaseSelector) -> None:
    """What a caller says while its command runs: signals, or by hanging up that it is gone."""
    if run.answered:
        return
    try:
        heard = run.connection.recv(64)
    except OSError:
        heard = b""
    for number, letter in wire.SIGNALS.items():
        if letter in heard:
            _signal(run, number)
    if not heard:
        waiting.unregister(run.connection)
        run.kill_at = time.monotonic() + KILL_AFTER_S
        _signal(run, signal.SIGTERM)


def _signal(run: Run, number: int) -> None:
    """To the command itself, which decides what becomes of what it started."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.kill(run.pid, number)


def _reap(worker: Worker, waiting: selectors.BaseSelector) -> None:
    while worker.runs:
        try:
            pid, status = os.waitpid(-1, os.WNOHANG)
        except ChildProcessError:
            return
        if pid == 0:
            return
        run = worker.runs.pop(pid, None)
        if run is None:
            continue
        _relay(worker, run, waiting)  # it may have answered just before it ended
        os.close(run.answer)
        worker.last = time.monotonic()
        if run.answered:
            continue
        if run.kill_at is None:
            waiting.unregister(run.connection)
        code = os.waitstatus_to_exitcode(status)
        wire.tell(run.connection, *((wire.ENDED, str(code)) if code >= 0 else (wire.LOST,)))
        run.connection.close()


def _kill_late(worker: Worker) -> None:
    for run in worker.runs.values():
        if run.kill_at is not None and time.monotonic() >= run.kill_at:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(run.pid, signal.SIGKILL)


def _become(
    worker: Worker,
    waiting: selectors.BaseSelector,
    connection: socket.socket,
    request: wire.Request,
    handles: list[int],
    answer: int,
) -> NoReturn:
    """In the fork: becomes the caller's command, and never returns."""
    try:
        signal.set_wakeup_fd(-1)
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.signal(signal.SIGINT, signal.default_int_handler)
        for number in request.ignored:
            signal.signal(number, signal.SIG_IGN)
        ctypes.CDLL(None).prctl(_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != worker.pid:
            os._exit(1)
        os.setsid()
        waiting.close()
        worker.listener.close()
        connection.close()
        for run in worker.runs.values():
            run.connection.close()
            os.close(run.answer)
        _dress(request, handles)
        conclude(worker.main, lambda code: os.write(answer, b"%d" % code))
    finally:
        os._exit(1)


def _dress(request: wire.Request, handles: list[int]) -> None:
    """Takes on the caller's folder, streams, environment and limits."""
    here, *streams = handles
    os.fchdir(here)
    for number, handle in enumerate(streams):
        os.dup2(handle, number)
    wire.close_all(handles)
    sys.stdin = open(0, encoding="utf-8", closefd=False)  # noqa: SIM115
    sys.stdout = open(1, "w", encoding="utf-8", closefd=False)  # noqa: SIM115
    sys.stderr = open(2, "w", encoding="utf-8", errors="backslashreplace", closefd=False)  # noqa: SIM115
    os.environ.clear()
    os.environ.update(request.environment or {})
    os.environ[OFF] = "0"  # it is the worker that was asked
    time.tzset()
    tempfile.tempdir = None
    os.umask(request.umask)
    for kind, soft, hard in request.limits:
        with contextlib.suppress(OSError, ValueError):
            resource.setrlimit(kind, (soft, hard))
    with contextlib.suppress(OSError):
        os.nice(request.nice - os.nice(0))
    sys.argv = ["esg", *request.arguments]
