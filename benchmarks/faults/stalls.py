"""Servers that take a connection and then say nothing: a command goes on without, or says so."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
import contextlib
from dataclasses import dataclass
from pathlib import Path
import shutil
import socket
import tempfile

from benchmarks.faults.ground import PATIENCE_S, PROMPT, environment, esg

HEADS = ("server", "command", "exit code", "seconds", "wrong")


@dataclass(frozen=True)
class Server:
    """A server that commands may ask, and one of them.

    Args:
        arguments: Of the command.
        variables: Of its environment, given the port at which nobody answers.
        codes: Exit codes that are right.
        local: Whether it is a socket of this user instead (a warm worker).
        within_s: How long it may take. Arrow asks an object store for a minute and a half, and a
            collector gets what is left of a run's spans for half a minute more.
    """

    arguments: Sequence[str]
    variables: Callable[[int], Mapping[str, str]]
    codes: tuple[int, ...]
    local: bool = False
    within_s: float = PATIENCE_S


def _model(port: int) -> dict[str, str]:
    return {
        "ESG_LLM_BASE_URL": f"http://127.0.0.1:{port}/v1",
        "ESG_LLM_MODEL": "silent",
        "ESG_LLM_TIMEOUT_S": "2",
        "ESG_LLM_ATTEMPTS": "2",
    }


SERVERS = {
    "warm worker": Server(["draft", "--json", PROMPT], lambda port: {"ESG_UP": "1"}, (0,), True),
    "language model": Server(["draft", "--drafter", "llm", PROMPT], _model, (1, 2, 3)),
    "language model, or rules": Server(["draft", "--drafter", "auto", PROMPT], _model, (0,)),
    "collector of traces": Server(
        ["generate", PROMPT, "--out", "k"],
        lambda port: {
            "ESG_TRACES": "otlp",
            "OTEL_EXPORTER_OTLP_ENDPOINT": f"http://127.0.0.1:{port}",
        },
        (0,),
        within_s=60.0,
    ),
    "flow server": Server(
        ["bench", "faults.yaml", "--runs", "2", "--out", "k"],
        lambda port: {"PREFECT_API_URL": f"http://127.0.0.1:{port}/api"},
        (1, 2),
    ),
    "object store": Server(
        ["dataset", "--sample", "1", "--out",
         "s3://bucket/d?endpoint_override=127.0.0.1:PORT&scheme=http&region=x"],
        lambda port: {"AWS_ACCESS_KEY_ID": "x", "AWS_SECRET_ACCESS_KEY": "y"},
        (1, 2),
        within_s=150.0,
    ),
}  # fmt: skip
"""Servers, and a command that asks each."""


@contextlib.contextmanager
def _silent_port() -> Generator[int]:
    """A port whose connections are taken and never answered."""
    with socket.create_server(("127.0.0.1", 0), backlog=64) as server:
        yield server.getsockname()[1]


@contextlib.contextmanager
def _silent_worker(variables: Mapping[str, str]) -> Generator[dict[str, str]]:
    """A socket where a warm worker would listen."""
    from esg.up import place

    with tempfile.TemporaryDirectory(prefix="esg-s") as folder:  # a socket's path is short
        mine = dict(variables) | {"XDG_RUNTIME_DIR": folder}
        (Path(folder) / "esg").mkdir(mode=0o700)
        path = Path(folder) / "esg" / place.socket_path(mine).name
        with socket.socket(socket.AF_UNIX) as server:
            server.bind(str(path))
            server.listen(64)
            yield {"XDG_RUNTIME_DIR": folder}


def stalled(ground: Path, folder: Path, name: str) -> list[tuple[tuple[object, ...], str]]:
    """A command whose server says nothing.

    Args:
        ground: A prepared folder.
        folder: Where it happens.
        name: Of `SERVERS`.

    Returns:
        A row for `HEADS`, with what is wrong.
    """
    server = SERVERS[name]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    shutil.copyfile(ground / "faults.yaml", folder / "faults.yaml")
    shutil.copytree(ground / "cache", folder / "cache")
    with contextlib.ExitStack() as stack:
        port = stack.enter_context(_silent_port())
        more = dict(server.variables(port))
        if server.local:
            whole = environment(folder, folder / "cache") | more
            more |= stack.enter_context(_silent_worker(whole))
        line = [a.replace("PORT", str(port)) for a in server.arguments]
        ended = esg(line, folder, folder / "cache", 2 * server.within_s, **more)
    wrong = ended.wrong(server.codes)
    if not wrong and ended.seconds > server.within_s:
        wrong = f"waited for {ended.seconds:.0f} s"
    cells = (name, server.arguments[0], ended.code, f"{ended.seconds:.1f}", int(bool(wrong)))
    return [(cells, wrong)]
