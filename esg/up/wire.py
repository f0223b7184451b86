"""What a command and a warm worker say to each other over a Unix socket.

The worker says `here` to whoever connects: only one that lives is handed anything, since streams on
the way to one that does not would stay open. The command sends one message, with its folder and its
three streams as file descriptors, then a letter for every signal that it gets. The worker answers
with lines: `taken`, or `refused` and why; at the end `ended` and the exit code, or `lost` if the
process that ran the command died.
"""

from __future__ import annotations

import array
from dataclasses import asdict, dataclass
import json
import os
import socket
import struct

SIGNALS = {2: b"i", 15: b"t"}
"""SIGINT and SIGTERM as they are passed on."""
HERE, TAKEN, REFUSED, ENDED, LOST = "here", "taken", "refused", "ended", "lost"
_LENGTH = struct.Struct("!I")
_MOST_BYTES = 16 * 2**20
_HANDLES = 4


class WireError(Exception):
    """What came is not what was agreed on, or nothing came any more."""


@dataclass(frozen=True)
class Request:
    """What a command asks of a worker.

    Args:
        kind: run, status or stop.
        stamp: Of the caller's code.
        arguments: Of the command, without the program's name.
        environment: The caller's.
        umask: The caller's.
        nice: The caller's.
        limits: The caller's resource limits: number of the resource, soft and hard.
        ignored: Signals that the caller ignores.
    """

    kind: str
    stamp: str = ""
    arguments: tuple[str, ...] = ()
    environment: dict[str, str] | None = None
    umask: int = 0o022
    nice: int = 0
    limits: tuple[tuple[int, int, int], ...] = ()
    ignored: tuple[int, ...] = ()


def send_request(connection: socket.socket, request: Request, handles: list[int]) -> None:
    """Sends a request; file descriptors travel with its first bytes.

    Args:
        connection: To the worker.
        request: What is asked.
        handles: Folder, standard input, output and error; none for what runs nothing.
    """
    data = json.dumps(asdict(request)).encode("utf-8")
    extra = [(socket.SOL_SOCKET, socket.SCM_RIGHTS, array.array("i", handles))] if handles else []
    connection.sendmsg([_LENGTH.pack(len(data))], extra)
    connection.sendall(data)


def receive_request(connection: socket.socket) -> tuple[Request, list[int]]:
    """A request and its file descriptors.

    Raises:
        WireError: If it is none.
    """
    handles = array.array("i")
    head, extra, _, _ = connection.recvmsg(
        _LENGTH.size, socket.CMSG_SPACE(_HANDLES * handles.itemsize)
    )
    for level, kind, data in extra:
        if (level, kind) == (socket.SOL_SOCKET, socket.SCM_RIGHTS):
            handles.frombytes(data[: len(data) - len(data) % handles.itemsize])
    try:
        if len(head) != _LENGTH.size:
            raise WireError("no request")
        (size,) = _LENGTH.unpack(head)
        if size > _MOST_BYTES:
            raise WireError("too long")
        fields = json.loads(_exactly(connection, size))
        fields["arguments"] = tuple(fields["arguments"])
        fields["limits"] = tuple(tuple(row) for row in fields["limits"])
        fields["ignored"] = tuple(fields["ignored"])
        request = Request(**fields)
        if len(handles) != (_HANDLES if request.kind == "run" else 0):
            raise WireError("streams are missing")
    except (WireError, ValueError, TypeError, KeyError) as error:
        close_all(list(handles))
        raise WireError(str(error)) from None
    return request, list(handles)


def close_all(handles: list[int]) -> None:
    """Closes file descriptors."""
    for handle in handles:
        os.close(handle)


def _exactly(connection: socket.socket, size: int) -> bytes:
    out = bytearray()
    while len(out) < size:
        data = connection.recv(min(65536, size - len(out)))
        if not data:
            raise WireError("cut off")
        out += data
    return bytes(out)


def tell(connection: socket.socket, word: str, value: str = "") -> bool:
    """Sends a line; whether somebody took it."""
    try:
        connection.sendall(f"{word} {value}\n".encode())
    except OSError:
        return False
    return True


def hear(connection: socket.socket) -> tuple[str, str]:
    """The next line: its word and what follows.

    Raises:
        WireError: If there is none.
    """
    line = bytearray()
    while not line.endswith(b"\n"):
        try:
            data = connection.recv(1)
        except OSError as error:
            raise WireError(str(error)) from None
        if not data or len(line) > _MOST_BYTES:
            raise WireError("the worker is gone")
        line += data
    word, _, value = line.decode().strip().partition(" ")
    return word, value


def peer(connection: socket.socket) -> int:
    """User id of who is at the other end."""
    data = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i"))
    return struct.unpack("3i", data)[1]
