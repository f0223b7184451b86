"""`esg setup` is never silent for long."""

from __future__ import annotations

import importlib
import io
from pathlib import Path
import sys
import time

import pytest

from esg.commands import setup
from esg.commands.setup import _bytecode, _Clock, _show


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_a_log_is_told_what_a_long_step_does() -> None:
    """Seconds into a step a line says which kernel, in whole lines without control characters."""
    log = io.StringIO()
    with _Clock("engine kernels", log, 0.05):
        _show("engine kernels 3/9: contacts")
        time.sleep(0.2)
    lines = log.getvalue().splitlines()
    assert lines and set(lines) <= {
        "engine kernels 3/9: contacts ... 0 s",
        "engine kernels ... 0 s",
    }
    assert lines[-1].startswith("engine kernels 3/9: contacts")


def test_a_short_step_leaves_no_line_in_a_log() -> None:
    log = io.StringIO()
    with _Clock("surrogate kernels", log, 30.0):
        pass
    assert log.getvalue() == ""


def test_a_terminal_has_one_line_that_is_cleared() -> None:
    terminal = Terminal()
    with _Clock("engine kernels", terminal, 0.05):
        time.sleep(0.12)
    assert "\n" not in terminal.getvalue()
    assert terminal.getvalue().endswith("\r\x1b[K")


def test_modules_are_compiled_where_python_writes_no_bytecode(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Those that nothing has imported yet, too."""
    package = tmp_path / "somewhere"
    (package / "below").mkdir(parents=True)
    for file in ("__init__.py", "seen.py", "below/unseen.py"):
        (package / file).write_text("VALUE = 1\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setattr(setup, "PACKAGES", ("somewhere",))
    assert importlib.import_module("somewhere.seen").VALUE == 1
    assert not [*package.rglob("*.pyc")]
    _bytecode()
    assert {p.name.partition(".")[0] for p in package.rglob("*.pyc")} == {
        "__init__",
        "seen",
        "unseen",
    }
