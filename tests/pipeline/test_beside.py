"""Work beside a scene: in a fork where that is allowed, here where it is not or the fork dies."""

from __future__ import annotations

import os
from pathlib import Path
import signal
import time

import pytest

from esg.machine import beside as module
from esg.machine.beside import beside, forking


@pytest.fixture
def cores(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "usable_cores", lambda: 2)


def test_a_batch_does_it_here_when_its_result_is_asked_for() -> None:
    done: list[int] = []
    with beside(lambda: done.append(os.getpid())) as result:
        assert not done
        result()
    assert done == [os.getpid()]


def test_one_scene_has_it_done_in_a_fork(cores: None, tmp_path: Path) -> None:
    def work() -> list[str]:
        (tmp_path / "file").write_text(str(os.getpid()))
        return ["no film: because"]

    with forking(), beside(work) as result:
        assert result() == ["no film: because"]
    assert int((tmp_path / "file").read_text()) != os.getpid()


def test_a_fork_that_dies_is_made_up_for_here(cores: None) -> None:
    owner = os.getpid()

    def work() -> str:
        if os.getpid() != owner:
            os.kill(os.getpid(), signal.SIGKILL)
        return "here"

    with forking(), beside(work) as result:
        assert result() == "here"


def test_an_error_in_the_fork_is_raised_here(cores: None) -> None:
    def work() -> None:
        raise OSError("no room")

    with forking(), pytest.raises(OSError, match="no room"), beside(work) as result:
        result()


def test_who_fails_meanwhile_leaves_no_fork_behind(cores: None, tmp_path: Path) -> None:
    def work() -> None:
        (tmp_path / "pid").write_text(str(os.getpid()))
        time.sleep(60.0)

    with pytest.raises(ValueError), forking(), beside(work):
        while not (tmp_path / "pid").exists() or not (tmp_path / "pid").read_text():
            time.sleep(0.01)
        raise ValueError
    with pytest.raises(ProcessLookupError):
        os.kill(int((tmp_path / "pid").read_text()), 0)


def test_one_core_is_not_shared(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "usable_cores", lambda: 1)
    with forking(), beside(os.getpid) as result:
        assert result() == os.getpid()
