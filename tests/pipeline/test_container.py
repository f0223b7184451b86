"""The Dockerfile: its linter, and that what it copies is there."""

from __future__ import annotations

from pathlib import Path
import re
import subprocess
import sys

import pytest

ROOT = Path(__file__).parents[2]
LINTER = Path(sys.executable).parent / "hadolint"


@pytest.mark.skipif(not LINTER.exists(), reason="hadolint is not installed")
def test_the_linter_finds_nothing() -> None:
    done = subprocess.run(
        [str(LINTER), "--no-color", str(ROOT / "Dockerfile")],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (0, "")


def test_what_it_copies_is_there_and_let_through() -> None:
    text = (ROOT / "Dockerfile").read_text()
    copied = [name for line in re.findall(r"^COPY (.+) \S+$", text, re.M) for name in line.split()]
    let_through = (ROOT / ".dockerignore").read_text().splitlines()
    assert len(copied) >= 7
    for name in copied:
        assert (ROOT / name).exists(), name
        assert f"!{name}" in let_through, name
