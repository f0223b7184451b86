"""Where a warm worker listens: only its user can open it, and each setting has its own."""

from __future__ import annotations

import os
from pathlib import Path
import socket

import pytest

from esg.outcomes import UserError
from esg.up import client, place


@pytest.fixture
def runtime(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder for sockets of this test; its path is short enough for one."""
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    return tmp_path / "esg"


def test_the_folder_is_made_for_its_user_alone(runtime: Path) -> None:
    assert place.make_private(place.folder()) == runtime
    assert runtime.stat().st_mode & 0o777 == 0o700
    assert place.private(runtime)


@pytest.mark.parametrize("mode", [0o755, 0o770, 0o701])
def test_a_folder_that_others_may_open_is_refused(runtime: Path, mode: int) -> None:
    runtime.mkdir()
    runtime.chmod(mode)
    with pytest.raises(UserError, match="only you can open"):
        place.make_private(runtime)
    assert client.connected() is None


def test_a_link_in_the_folders_place_is_refused(runtime: Path, tmp_path: Path) -> None:
    """Who links it to a folder of yours would choose where your socket lies."""
    (tmp_path / "mine").mkdir(mode=0o700)
    runtime.symlink_to(tmp_path / "mine")
    with pytest.raises(UserError):
        place.make_private(runtime)
    assert not place.private(runtime)


def test_a_folder_of_another_user_is_refused(
    runtime: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    runtime.mkdir(mode=0o700)
    own = os.getuid()
    monkeypatch.setattr(os, "getuid", lambda: own + 1)
    assert not place.private(runtime)
    assert client.connected(runtime / "up-x.sock") is None


def test_checkouts_interpreters_and_settings_have_workers_of_their_own(
    runtime: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    usual = place.socket_path({})
    assert usual == place.socket_path({"EDITOR": "vi", "ESG_DB": "x", "PYTHONWARNINGS": "ignore"})
    others = [place.socket_path({"ESG_CACHE_DIR": "/a"}), place.socket_path({"HOME": "/b"})]
    with monkeypatch.context() as context:
        context.setattr("sys.executable", "/other/python")
        others.append(place.socket_path({}))
    monkeypatch.setattr(place, "root", lambda: tmp_path)
    others.append(place.socket_path({}))
    assert len({usual, *others}) == 5


def test_the_stamp_changes_with_any_file_of_the_code(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(place, "root", lambda: tmp_path)
    (tmp_path / "esg" / "view").mkdir(parents=True)
    table = tmp_path / "esg" / "view" / "table.csv"
    table.write_text("a,b")
    before = place.stamp()
    assert place.stamp() == before
    (tmp_path / "esg" / "__pycache__").mkdir()
    (tmp_path / "esg" / "__pycache__" / "x.pyc").write_text("compiled")
    assert place.stamp() == before
    table.write_text("a,c,d")
    assert place.stamp() != before


def test_a_stale_socket_is_nobody(runtime: Path) -> None:
    """A worker that was killed leaves its socket behind."""
    place.make_private(runtime)
    path = runtime / "up-x.sock"
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(path))
    assert path.exists()
    assert client.connected(path) is None
    assert client.asked("status", path) is None


def test_a_file_in_the_sockets_place_is_nobody(runtime: Path) -> None:
    place.make_private(runtime)
    (runtime / "up-x.sock").write_text("no socket")
    assert client.connected(runtime / "up-x.sock") is None


@pytest.mark.parametrize(
    "arguments",
    [[], ["bench", "x"], ["generate", "a ball", "--device", "cuda:0"], ["--help"]],
)
def test_what_a_worker_is_not_for_is_done_here(
    arguments: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def unwanted() -> None:
        raise AssertionError("a worker was asked")

    monkeypatch.setattr(client, "connected", unwanted)
    assert client.delegated(arguments) is None


@pytest.mark.parametrize("name", ["ESG_UP", "PREFECT_API_URL"])
def test_who_wants_no_worker_asks_none(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def unwanted() -> None:
        raise AssertionError("a worker was asked")

    monkeypatch.setattr(client, "connected", unwanted)
    monkeypatch.setenv(name, "0")
    assert client.delegated(["generate", "a ball"]) is None
