"""A warm worker passes everything on, both ways, and a command never depends on it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
import contextlib
import json
import os
from pathlib import Path
import signal
import socket
import stat
import subprocess
import sys
import tempfile
import time
from typing import Any

import pytest

from esg.up import client, place, server

ROOT = Path(__file__).parents[2]
ASK = (
    "import sys; from esg.up.client import delegated; "
    "code = delegated(['generate', *sys.argv[1:]]); sys.exit(99 if code is None else code)"
)
"""A command that only asks; 99 stands for doing it here."""

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="workers need Linux")


@pytest.fixture
def environment(monkeypatch: pytest.MonkeyPatch) -> Iterator[dict[str, str]]:
    """Of the worker and its callers; sockets lie in a folder of this test."""
    with tempfile.TemporaryDirectory(prefix="esg-t") as folder:  # a socket's path is short
        monkeypatch.setenv("XDG_RUNTIME_DIR", folder)
        monkeypatch.setenv("PYTHONPATH", str(ROOT))
        monkeypatch.delenv("ESG_UP", raising=False)
        monkeypatch.delenv("PREFECT_API_URL", raising=False)
        yield dict(os.environ)


Start = Callable[..., subprocess.Popen[bytes]]


@pytest.fixture
def start(environment: dict[str, str]) -> Iterator[Start]:
    """Starts a stub worker and waits until it answers."""
    running: list[subprocess.Popen[bytes]] = []

    def go(idle_s: float = 60.0) -> subprocess.Popen[bytes]:
        path = place.socket_path(environment)
        command = [sys.executable, "-m", "tests.up.stub", str(path), str(idle_s)]
        worker = subprocess.Popen(command, cwd=ROOT, env=environment)
        running.append(worker)
        until(lambda: client.asked("status", path) is not None)
        return worker

    yield go
    for worker in running:
        with contextlib.suppress(ProcessLookupError):
            worker.kill()
        worker.wait()


def until(holds: Callable[[], bool], seconds: float = 60.0) -> None:
    """Waits for something."""
    deadline = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < deadline, "it never came"
        time.sleep(0.02)


def ask(
    *arguments: str,
    input: str | None = None,
    cwd: Path | None = None,
    env: dict[str, str] | None = None,
) -> subprocess.CompletedProcess[str]:
    """A command that asks the worker."""
    return subprocess.run(
        [sys.executable, "-c", ASK, *arguments], input=input, cwd=cwd, env=env,
        text=True, capture_output=True, check=False, timeout=120,
    )  # fmt: skip


def asking(*arguments: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-c", ASK, *arguments], text=True, stdout=subprocess.PIPE
    )


def gone(pid: int) -> bool:
    try:
        os.kill(pid, 0)
        stat = Path(f"/proc/{pid}/stat").read_text()
    except (ProcessLookupError, FileNotFoundError):  # between the two it may end
        return True
    return stat.rpartition(")")[2].split()[0] == "Z"


def test_arguments_folder_environment_and_streams_are_the_callers(
    start: Start, tmp_path: Path, environment: dict[str, str]
) -> None:
    start()
    done = ask("echo", "zwölf", input="read me", cwd=tmp_path,
               env={**environment, "NAME": "caller"})  # fmt: skip
    assert done.returncode == 0, done.stderr
    heard = json.loads(done.stdout)
    assert heard["arguments"] == ["generate", "echo", "zwölf"]
    assert heard["cwd"] == str(tmp_path.resolve())
    assert heard["name"] == "caller"
    assert heard["input"] == "read me"
    assert heard["alone"]


def test_exit_codes_are_the_commands(start: Start) -> None:
    start()
    assert ask("fail").returncode == 3
    assert ask("echo", input="").returncode == 0


def test_only_its_user_can_open_the_socket(start: Start, environment: dict[str, str]) -> None:
    start()
    path = place.socket_path(environment)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700


def test_a_worker_that_is_stopped_is_handed_no_streams(
    start: Start, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nobody who reads the caller's output would ever see its end."""
    worker = start()
    monkeypatch.setattr(client, "CONNECT_S", 0.2)
    sent: list[object] = []

    def send(connection: socket.socket, request: object, handles: object) -> None:
        sent.append(request)

    monkeypatch.setattr("esg.up.wire.send_request", send)
    worker.send_signal(signal.SIGSTOP)
    try:
        assert client.delegated(["generate", "fail"]) is None
    finally:
        worker.send_signal(signal.SIGCONT)
    assert not sent


def test_another_user_is_not_answered(start: Start, monkeypatch: pytest.MonkeyPatch) -> None:
    """The caller, too, looks who listens before it hands over its environment."""
    start()
    other = os.getuid() + 1

    def peer(connection: socket.socket) -> int:
        return other

    monkeypatch.setattr("esg.up.wire.peer", peer)
    assert client.connected() is None


def test_ctrl_c_reaches_the_command_and_its_answer_comes_back(start: Start, tmp_path: Path) -> None:
    start()
    mark = tmp_path / "pid"
    caller = asking("wait", str(mark))
    until(lambda: mark.exists() and bool(mark.read_text()))
    caller.send_signal(signal.SIGINT)
    assert caller.communicate(timeout=60)[0] == "interrupted\n"
    assert caller.returncode == 130


def test_a_caller_that_is_killed_takes_its_command_along(start: Start, tmp_path: Path) -> None:
    start()
    mark = tmp_path / "pid"
    caller = asking("wait", str(mark))
    until(lambda: mark.exists() and bool(mark.read_text()))
    caller.kill()
    caller.communicate()
    until(lambda: gone(int(mark.read_text())))


def test_a_killed_worker_takes_its_command_along_and_the_caller_does_it(
    start: Start, tmp_path: Path
) -> None:
    worker = start()
    mark = tmp_path / "pid"
    caller = asking("wait", str(mark))
    until(lambda: mark.exists() and bool(mark.read_text()))
    worker.kill()
    caller.communicate(timeout=60)
    assert caller.returncode == 99
    until(lambda: gone(int(mark.read_text())))
    assert ask("fail").returncode == 99  # its socket is still there
    start()  # and in no other worker's way
    assert ask("fail").returncode == 3


def test_a_command_that_crashes_is_done_by_the_caller(start: Start) -> None:
    start()
    done = ask("crash")
    assert done.returncode == 99
    assert "doing it here" in done.stderr
    assert ask("fail").returncode == 3  # the worker lives on


def test_a_worker_of_other_code_is_left_alone_and_ends(
    start: Start, monkeypatch: pytest.MonkeyPatch
) -> None:
    worker = start()
    monkeypatch.setattr(client, "stamp", lambda: "changed since")
    assert client.delegated(["generate", "fail"]) is None
    assert worker.wait(timeout=60) == 0


def test_it_ends_after_idleness_and_leaves_no_socket(
    start: Start, environment: dict[str, str]
) -> None:
    worker = start(1.0)
    assert worker.wait(timeout=60) == 0
    assert not place.socket_path(environment).exists()


def test_to_stop_lets_what_runs_finish(
    start: Start, tmp_path: Path, environment: dict[str, str]
) -> None:
    worker = start()
    mark = tmp_path / "pid"
    caller = asking("wait", str(mark))
    until(lambda: mark.exists() and bool(mark.read_text()))
    assert json.loads(client.asked("stop") or "{}")["running"] == 1
    assert ask("fail").returncode == 99
    assert worker.poll() is None
    caller.send_signal(signal.SIGINT)
    assert caller.wait(timeout=60) == 130
    assert worker.wait(timeout=60) == 0


def answered(mark: Path) -> int:
    """The process of a command that has answered and goes on until its mark is taken away."""
    done = ask("answer", str(mark))
    assert (done.returncode, done.stdout) == (3, "answered\n")
    return int(mark.read_text())


def facts(mark: Path) -> dict[str, Any]:
    """What a process that was let finish says of itself."""
    mark.unlink()
    told = mark.with_suffix(".facts")
    until(lambda: told.exists() and bool(told.read_text()))
    return json.loads(told.read_text())


def test_a_command_that_has_answered_goes_on_as_nobodys(start: Start, tmp_path: Path) -> None:
    """Its caller has the exit code and the end of its output, and the next command is served."""
    start()
    mark = tmp_path / "goes on"
    process = answered(mark)
    assert not gone(process)
    told = json.loads(client.asked("status") or "{}")
    assert (told["running"], told["finishing"]) == (0, 1)
    assert ask("fail").returncode == 3
    found = facts(mark)
    assert found["nice"] >= min(os.nice(0) + 10, 19)
    assert found["streams"] == ["/dev/null"] * 3
    until(lambda: gone(process))
    until(lambda: json.loads(client.asked("status") or "{}")["finishing"] == 0)


def test_to_stop_waits_for_what_goes_on(start: Start, tmp_path: Path) -> None:
    worker = start()
    mark = tmp_path / "goes on"
    answered(mark)
    assert json.loads(client.asked("stop") or "{}")["finishing"] == 1
    assert ask("fail").returncode == 99
    assert worker.poll() is None
    assert facts(mark)
    assert worker.wait(timeout=60) == 0


def test_a_worker_is_not_idle_while_something_goes_on(tmp_path: Path) -> None:
    with socket.socket() as one, socket.socket() as two:
        worker = server.Worker(one, tmp_path, lambda: None, 0.0, "")
        assert server._patience(worker) is not None
        worker.runs[1] = server.Run(1, two, -1, answered=True)
        assert server._patience(worker) is None


def test_what_goes_on_survives_a_killed_worker(start: Start, tmp_path: Path) -> None:
    worker = start()
    mark = tmp_path / "goes on"
    process = answered(mark)
    worker.kill()
    worker.wait()
    assert not gone(process)
    assert facts(mark)
    until(lambda: gone(process))


def test_a_second_worker_yields_to_the_first(start: Start, environment: dict[str, str]) -> None:
    start()
    path = place.socket_path(environment)
    second = subprocess.run([sys.executable, "-m", "tests.up.stub", str(path), "60"], cwd=ROOT,
                            env=environment, check=False, timeout=60)  # fmt: skip
    assert second.returncode == 75
    assert ask("fail").returncode == 3


def test_what_is_no_request_is_hung_up_on(start: Start, environment: dict[str, str]) -> None:
    start()
    for said in (b"", b"\xff\xff\xff\xff", b"\0\0\0\2{}", b"GET / HTTP/1.1\r\n\r\n"):
        connection = client.connected()
        assert connection is not None
        with connection:
            connection.sendall(said)
            connection.shutdown(1)
            with contextlib.suppress(ConnectionResetError):  # it was not even read to its end
                assert connection.recv(10) == b""
    assert ask("fail").returncode == 3
