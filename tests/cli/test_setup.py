"""`esg setup` is never silent for long."""

from __future__ import annotations

import io
import time

from esg.commands.setup import _Clock, _show


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
