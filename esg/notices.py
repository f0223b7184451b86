"""What users are told beside the results."""

from __future__ import annotations

from collections.abc import Iterable
import os
import sys

UNPRINTABLE = {
    code: f"\\u{code:04x}"
    for code in (*range(0x20), *range(0x7F, 0xA0), *range(0x202A, 0x202F), *range(0x2066, 0x206A))
    if chr(code) not in "\t\n"
}
"""What moves a terminal's cursor, colours or directions, and its escape in JSON: texts of documents
and suites are strangers'."""


def warn(problems: Iterable[str]) -> None:
    """Says on stderr, a line each, what the command had to do without.

    A stderr that is closed or full takes nothing, which changes no exit code.
    """
    try:
        for problem in problems:
            print(f"esg: {problem.translate(UNPRINTABLE)}", file=sys.stderr, flush=True)
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stderr.fileno())
