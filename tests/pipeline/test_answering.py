"""A process that answers before it ends: in what order, and what becomes of its work."""

from __future__ import annotations

import atexit
from collections.abc import Callable
import os
from pathlib import Path
import sys
import time

import pytest

from esg.machine import answering
from esg.machine.answering import afterwards, can_go_on, conclude, lowly
from esg.machine.beside import beside, forking

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="forks need Linux")


def concluded(main: Callable[[], None], tell: Callable[[int], object]) -> int:
    """The exit code of a fork that runs a command."""
    pid = os.fork()
    if pid == 0:
        os.setsid()
        # What libraries of this test run would do at its end, some with threads that are not here.
        atexit._clear()
        conclude(main, tell)
    return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])


def test_a_usual_process_cannot_go_on() -> None:
    assert not can_go_on()


def test_the_answer_comes_before_the_work(tmp_path: Path) -> None:
    log = tmp_path / "log"

    def note(word: object) -> None:
        with log.open("a") as file:
            file.write(f"{word}\n")

    def main() -> None:
        afterwards(lambda: note("work"))
        note(can_go_on())
        raise SystemExit(3)

    assert concluded(main, note) == 3
    assert log.read_text().split() == ["True", "3", "work"]


def test_without_work_the_end_is_the_answer(tmp_path: Path) -> None:
    def main() -> None:
        raise SystemExit("no")

    assert concluded(main, lambda code: (tmp_path / "told").touch()) == 1
    assert not (tmp_path / "told").exists()


def test_work_that_fails_changes_no_answer(tmp_path: Path) -> None:
    def fail() -> None:
        raise RuntimeError("no")

    def main() -> None:
        afterwards(fail)
        afterwards(lambda: (tmp_path / "next").touch())
        raise SystemExit(0)

    assert concluded(main, lambda code: None) == 0
    assert (tmp_path / "next").exists()


def test_what_is_done_beside_holds_no_streams(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whoever reads the output of a command to its end has it once the command has answered."""
    monkeypatch.setattr("esg.machine.beside.usable_cores", lambda: 2)
    monkeypatch.setattr(answering._here, "possible", True)

    def streams() -> list[str]:
        return [os.readlink(f"/proc/self/fd/{n}") for n in range(3)]

    with forking(), beside(streams) as result:
        assert result() == ["/dev/null"] * 3
    assert streams() != ["/dev/null"] * 3


def test_only_what_is_done_elsewhere_has_low_priority() -> None:
    before = os.nice(0)
    assert lowly(lambda: os.nice(0), os.getpid()) == before
    pid = os.fork()
    if pid == 0:
        os._exit(lowly(lambda: os.nice(0), os.getppid()))
    assert os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == min(before + 10, 19)


def test_a_lock_of_the_callers_is_let_go(tmp_path: Path) -> None:
    import fcntl

    with (tmp_path / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        pid = os.fork()
        if pid == 0:
            os.setsid()

            def main() -> None:
                afterwards(lambda: time.sleep(60.0))
                raise SystemExit(0)

            conclude(main, lambda _: (tmp_path / "told").touch(), frozenset({lock.fileno()}))
        while not (tmp_path / "told").exists():
            time.sleep(0.01)
    with (tmp_path / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    os.kill(pid, 9)
    os.waitpid(pid, 0)
