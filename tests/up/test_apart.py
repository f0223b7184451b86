"""A command that answers first without a worker: a process of its own session does the work."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path
import signal
import subprocess
import sys

import pytest

from tests.up.test_worker import ROOT, facts, gone, until

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="forks need Linux")
RUN = (
    "import sys; from esg.up.apart import apart; from tests.up.stub import main; "
    "code = apart(main, sys.argv[1:]); sys.exit(99 if code is None else code)"
)
"""A command that only does its work apart; 99 stands for doing it here."""


def run(*arguments: str, handles: tuple[int, ...] = ()) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-c", RUN, "generate", *arguments], text=True, pass_fds=handles,
        cwd=ROOT, stdout=subprocess.PIPE, env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip


def test_the_answer_is_the_end_of_the_command(tmp_path: Path) -> None:
    """Its output has ended and its locks are free, while its work goes on."""
    mark = tmp_path / "goes on"
    with (tmp_path / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        command = run("answer", str(mark), "--no-wait", handles=(lock.fileno(),))
    assert command.communicate(timeout=60)[0] == "answered\n"
    assert command.returncode == 3
    with (tmp_path / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    process = int(mark.read_text())
    assert not gone(process)
    assert facts(mark)["streams"] == ["/dev/null"] * 3
    until(lambda: gone(process))


def test_without_the_option_it_is_done_here(tmp_path: Path) -> None:
    assert run("fail").wait(timeout=60) == 99


def test_exit_codes_and_crashes_come_back() -> None:
    assert run("fail", "--no-wait").wait(timeout=60) == 3
    assert run("crash", "--no-wait").wait(timeout=60) == 128 + signal.SIGSEGV


def test_until_it_has_answered_it_hangs_on_its_caller(tmp_path: Path) -> None:
    mark = tmp_path / "pid"
    caller = run("wait", str(mark), "--no-wait")
    until(lambda: mark.exists() and bool(mark.read_text()))
    caller.send_signal(signal.SIGINT)
    assert caller.communicate(timeout=60)[0] == "interrupted\n"
    assert caller.returncode == 130

    mark.unlink()
    caller = run("wait", str(mark), "--no-wait")
    until(lambda: mark.exists() and bool(mark.read_text()))
    caller.kill()
    caller.communicate()
    until(lambda: gone(int(mark.read_text())))
