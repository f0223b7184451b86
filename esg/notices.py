"""What users are told beside the results."""

from __future__ import annotations

from collections.abc import Iterable
import os
import sys


def warn(problems: Iterable[str]) -> None:
    """Says on stderr, a line each, what the command had to do without.

    A stderr that is closed or full takes nothing, which changes no exit code.
    """
    try:
        for problem in problems:
            print(f"esg: {problem}", file=sys.stderr, flush=True)
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stderr.fileno())
