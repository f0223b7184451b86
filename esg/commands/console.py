"""What every command shares: where output goes, progress lines, JSON documents."""

from __future__ import annotations

from collections.abc import Generator
import contextlib
import io
import json
import os
import sys
from typing import Any, TextIO
import warnings

from esg.notices import UNPRINTABLE, warn
from esg.strangers.scrubbing import scrub_all


class Plain(io.TextIOWrapper):
    """A stream that a terminal takes as text and nothing else, whatever is printed.

    No command colours its stdout; progress displays write to stderr.
    """

    def write(self, text: str, /) -> int:
        return super().write(text.translate(UNPRINTABLE))


def quiet_native_output() -> None:
    """Keeps libraries that write to the file descriptors themselves off stdout and stderr.

    Python's `sys.stdout` and `sys.stderr` go on to the real ones. `ESG_DEBUG=1` leaves everything
    as it is. A stream that was closed by who started us leads nowhere: without that the next file
    to be opened would get its number, and with it what libraries print.
    """
    for number, name in ((0, "stdin"), (1, "stdout"), (2, "stderr")):
        if getattr(sys, name) is None:
            handle = os.open(os.devnull, os.O_RDWR)
            if handle != number:
                os.dup2(handle, number)
                os.close(handle)
            setattr(sys, name, open(number, "r+", encoding="utf-8", closefd=False))  # noqa: SIM115
    if os.environ.get("ESG_DEBUG"):
        return
    warnings.simplefilter("ignore")
    os.environ.setdefault("PYTHONWARNINGS", "ignore")  # for worker processes
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for number, name in ((1, "stdout"), (2, "stderr")):
        before: TextIO = getattr(sys, name)
        with contextlib.suppress(OSError, ValueError):
            before.flush()
            real = os.dup(number)
            os.dup2(nowhere, number)
            kind = Plain if name == "stdout" else io.TextIOWrapper
            binary = open(real, "wb")  # noqa: SIM115
            stream = kind(binary, encoding="utf-8", errors="replace", line_buffering=True)
            setattr(sys, name, stream)
    os.close(nowhere)


def emit(document: Any) -> None:
    """Prints one JSON document on stdout."""
    print(json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False))


def flush() -> None:
    """Sends on what was printed, if anybody takes it."""
    sys.stdout.flush()


def silence() -> None:
    """Drops what is printed from here on: the reader of stdout is gone, or its disk is full."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def fail(message: str, exit_code: int, as_json: bool) -> int:
    """Says what went wrong: on stderr, and with `--json` as the one document on stdout.

    Args:
        message: For people, one or several lines.
        exit_code: Of the process.
        as_json: Whether the command was asked for JSON.

    Returns:
        The exit code.
    """
    message = scrub_all(message)
    if as_json:
        emit({"error": message, "exit_code": exit_code})
        flush()
    warn([message])
    return exit_code


def note_first_use() -> None:
    """Tells, once and before the wait, that kernels have to be compiled first."""
    from esg.paths import kernels_compiled

    if not kernels_compiled():
        warn(
            [
                "kernels are not compiled on this machine yet: the first scene takes minutes "
                "longer (`esg setup` does it ahead)"
            ]
        )


class Progress:
    """A bar on stderr over a number of steps; silent when stderr is no terminal.

    Args:
        total: Number of steps.
        title: First words of the line.
    """

    def __init__(self, total: int, title: str) -> None:
        self._bar: Any = None
        if not sys.stderr.isatty():
            return
        from rich.console import Console
        from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

        self._bar = Progress(
            SpinnerColumn(),
            TextColumn("{task.description}"),
            BarColumn(bar_width=30),
            TextColumn("{task.completed}/{task.total}"),
            TimeElapsedColumn(),
            console=Console(file=sys.stderr),
            transient=True,
        )
        self._task = self._bar.add_task(title, total=total)
        self._bar.start()

    def step(self, description: str, count: int = 1) -> None:
        """Advances by `count` steps."""
        if self._bar is not None:
            self._bar.update(self._task, advance=count, description=description)

    def show(self, description: str) -> None:
        """Changes the words without advancing."""
        self.step(description, 0)

    def note(self, message: str) -> None:
        """A line that stays, above the bar."""
        if self._bar is not None:
            self._bar.console.print(message, markup=False, highlight=False)

    def close(self) -> None:
        """Takes the bar away."""
        if self._bar is not None:
            self._bar.stop()
            self._bar = None


@contextlib.contextmanager
def progress(total: int, title: str) -> Generator[Progress]:
    """A progress bar for the body."""
    bar = Progress(total, title)
    try:
        yield bar
    finally:
        bar.close()


def table(columns: list[str], rows: list[list[str]], title: str = "") -> str:
    """Aligned text columns; numbers-looking cells to the right."""

    def numeric(cell: str) -> bool:
        return cell[:1].isdigit() or cell[:1] in "-+." or cell == ""

    widths = [max(len(str(r[k])) for r in [columns, *rows]) for k in range(len(columns))]
    right = [bool(rows) and all(numeric(r[k]) for r in rows) for k in range(len(columns))]

    def line(cells: list[str]) -> str:
        parts = [
            c.rjust(w) if r else c.ljust(w) for c, w, r in zip(cells, widths, right, strict=True)
        ]
        return "  ".join(parts).rstrip()

    body = [line(columns), "  ".join("-" * w for w in widths), *(line(r) for r in rows)]
    return "\n".join(([title] if title else []) + body)
