"""A command's side: it asks a warm worker, if there is one, and lets it do the work."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
import contextlib
import os
from pathlib import Path
import select
import signal
import socket
import stat
import sys
from types import FrameType

from esg.notices import warn
from esg.up import wire
from esg.up.place import COMMANDS, OFF, private, socket_path, stamp

CONNECT_S = 5.0
"""A worker that says nothing for so long is left alone [s]."""
_POLL_S = 0.2


def delegated(arguments: Sequence[str]) -> int | None:
    """Lets a warm worker run a command.

    Args:
        arguments: Of the process, without its name.

    Returns:
        The exit code; None if there is no worker for it, or it did not come back: do it here.
    """
    if not _wanted(arguments):
        return None
    connection = connected()
    if connection is None:
        return None
    with connection:
        try:
            return _run(connection, arguments)
        except (OSError, wire.WireError):
            return None


def _wanted(arguments: Sequence[str]) -> bool:
    """Whether a worker may run this command at all."""
    if not arguments or arguments[0] not in COMMANDS or sys.platform != "linux":
        return False
    # A process that uses a GPU cannot be forked off one that does; a server wants to see its flow.
    if any("cuda" in argument for argument in arguments):
        return False
    return os.environ.get(OFF) != "0" and not os.environ.get("PREFECT_API_URL")


def connected(path: Path | None = None) -> socket.socket | None:
    """A connection to the worker of this user, code and settings; None without one.

    Args:
        path: Of its socket; default `socket_path()`.
    """
    path = path or socket_path()
    try:
        if not private(path.parent) or not _own_socket(path):
            return None
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    except OSError:
        return None
    connection.settimeout(CONNECT_S)
    try:
        connection.connect(str(path))
        if wire.peer(connection) == os.getuid() and wire.hear(connection)[0] == wire.HERE:
            return connection
    except (OSError, wire.WireError):  # one that was killed leaves its socket, or it is stopped
        pass
    connection.close()
    return None


def _own_socket(path: Path) -> bool:
    found = os.lstat(path)
    return stat.S_ISSOCK(found.st_mode) and found.st_uid == os.getuid()


def asked(kind: str, path: Path | None = None) -> str | None:
    """What a worker says to `status` or `stop`; None without a worker."""
    connection = connected(path)
    if connection is None:
        return None
    with connection:
        try:
            wire.send_request(connection, wire.Request(kind), [])
            return wire.hear(connection)[1]
        except (OSError, wire.WireError):
            return None


def _run(connection: socket.socket, arguments: Sequence[str]) -> int | None:
    here = os.open(".", os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    try:
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
        wire.send_request(connection, _request(arguments), [here, 0, 1, 2])
    finally:
        os.close(here)
    if wire.hear(connection)[0] != wire.TAKEN:
        return None
    connection.settimeout(None)
    with passed_on(lambda number: connection.send(wire.SIGNALS[number])) as passed:
        await_data(connection.fileno())
        try:
            word, value = wire.hear(connection)
        except wire.WireError:
            word, value = wire.LOST, ""
    if word == wire.ENDED:
        return int(value)
    if passed:  # who asked it to end does not want it begun again
        return 128 + passed[0]
    warn(["the warm worker ended before its work was done: doing it here"])
    return None


def _request(arguments: Sequence[str]) -> wire.Request:
    import resource

    umask = os.umask(0)
    os.umask(umask)
    kinds = [getattr(resource, name) for name in dir(resource) if name.startswith("RLIMIT_")]
    return wire.Request(
        "run",
        stamp(),
        tuple(arguments),
        dict(os.environ),
        umask,
        os.nice(0),
        tuple((kind, *resource.getrlimit(kind)) for kind in sorted(set(kinds))),
        tuple(n for n in wire.SIGNALS if signal.getsignal(n) == signal.SIG_IGN),
    )


def await_data(handle: int) -> None:
    """Waits until something can be read, or its end.

    Python answers a signal only once it runs: one that comes just before a wait would wait as long.

    Args:
        handle: Descriptor.
    """
    while not select.select([handle], [], [], _POLL_S)[0]:
        pass


@contextlib.contextmanager
def passed_on(send: Callable[[int], object]) -> Generator[list[int]]:
    """Passes SIGINT and SIGTERM on while the body waits; the process that does the work answers.

    Args:
        send: Sends a signal there.

    Yields:
        The signals that were passed on.
    """
    passed: list[int] = []

    def forward(number: int, frame: FrameType | None) -> None:
        passed.append(number)
        with contextlib.suppress(OSError):
            send(number)

    before = {n: signal.getsignal(n) for n in wire.SIGNALS}
    for number, handler in before.items():
        if handler != signal.SIG_IGN:
            signal.signal(number, forward)
    try:
        yield passed
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
