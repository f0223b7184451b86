"""Ctrl-C during a dataset: one line, exit code 130, nobody left behind, and it goes on after."""

from __future__ import annotations

import os
from pathlib import Path
import signal
import subprocess
import sys
import time

import pytest

from benchmarks.resume import alive, descendants

ROOT = Path(__file__).parents[2]


@pytest.mark.slow
def test_ctrl_c_ends_everything_and_keeps_what_is_done(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "esg.cli", "dataset", "--sample", "8", "--workers", "2",
               "--previews", "none", "--out", str(tmp_path / "set"), "--resume"]  # fmt: skip
    process = subprocess.Popen(
        command, cwd=ROOT, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    deadline = time.monotonic() + 120
    while not list((tmp_path / "set").glob("work/*/artifacts/[0-9a-f][0-9a-f]/draft-*")):
        assert time.monotonic() < deadline, "no scene was begun"
        time.sleep(0.2)
    family = descendants(process.pid)
    assert family
    # A terminal sends the signal to the whole process group.
    os.killpg(process.pid, signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "run the same command again" in errors
    assert "Traceback" not in errors
    deadline = time.monotonic() + 10
    while any(alive(p) for p in family):
        assert time.monotonic() < deadline, "a process outlived the command"
        time.sleep(0.1)
    begun = len(list((tmp_path / "set").glob("work/*/artifacts/[0-9a-f][0-9a-f]/draft-*")))
    assert begun
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 3), done.stderr
