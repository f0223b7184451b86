"""Temporary folders of killed processes are removed, those of living ones never."""

from __future__ import annotations

import os
from pathlib import Path
import signal
import subprocess
import sys
import time

import pytest

from esg.leftovers import OWNER, owned_folder, sweep_leftovers

PREFIX = "esg-test-left-"


@pytest.fixture(autouse=True)
def own_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setenv("TMPDIR", str(tmp_path))


def test_a_killed_process_s_folder_goes_and_a_living_one_s_stays(tmp_path: Path) -> None:
    code = (
        "import sys, time\nfrom esg.leftovers import owned_folder\n"
        f"print(owned_folder({PREFIX!r}), flush=True)\ntime.sleep(60)\n"
    )
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert child.stdout is not None
    folder = Path(child.stdout.readline().strip())
    mine = owned_folder(PREFIX)
    assert sweep_leftovers(PREFIX) == 0
    child.send_signal(signal.SIGKILL)
    child.wait()
    assert sweep_leftovers(PREFIX) == 1
    assert mine.exists()
    assert not folder.exists()


def test_a_recycled_process_id_is_no_owner(tmp_path: Path) -> None:
    folder = owned_folder(PREFIX)
    (folder / OWNER).write_text(f"{os.getpid()} 12345\n")
    assert sweep_leftovers(PREFIX) == 1


def test_ownerless_folders_stay_for_a_day(tmp_path: Path) -> None:
    (tmp_path / f"{PREFIX}x").mkdir()
    (tmp_path / "others-x").mkdir()
    assert sweep_leftovers(PREFIX) == 0
    assert sweep_leftovers(PREFIX, now=time.time() + 90000) == 1
    assert (tmp_path / "others-x").exists()


@pytest.mark.parametrize("owner", [b"one two\n", b"\xff\xfe 1\n", b""])
def test_a_damaged_owner_s_folder_stays_for_a_day(tmp_path: Path, owner: bytes) -> None:
    folder = owned_folder(PREFIX)
    (folder / OWNER).write_bytes(owner)
    assert sweep_leftovers(PREFIX) == 0
    assert sweep_leftovers(PREFIX, now=time.time() + 90000) == 1
