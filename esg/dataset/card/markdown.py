"""Tables of a card."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

Lines = list[str]


def table(names: Sequence[str], rows: Iterable[Sequence[Any]], right: str = "") -> Lines:
    """A table.

    Args:
        names: Of the columns.
        rows: Their values; texts may hold anything.
        right: A letter a column: r for numbers, l for texts; what is not said is a text.
    """
    marks = ["---:" if letter == "r" else "---" for letter in right.ljust(len(names), "l")]
    return [_line(names), _line(marks), *(_line([cell(v) for v in row]) for row in rows)]


def cell(value: Any) -> str:
    """A value on one line."""
    text = f"{value:g}" if isinstance(value, float) else str(value)
    return " ".join(text.split()).replace("|", "\\|")


def cut(text: str, length: int = 160) -> str:
    """A text that is not longer than so many letters."""
    text = " ".join(text.split())
    return text if len(text) <= length else f"{text[: length - 1]}…"


def share(part: float, whole: float) -> str:
    """A part in per cent."""
    return f"{100 * part / whole:.1f}%" if whole else "none"


def listed(counts: Mapping[str, Any]) -> str:
    """Counts in a sentence."""
    return ", ".join(f"{k.replace('_', ' ')} {v}" for k, v in counts.items()) or "none"


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
