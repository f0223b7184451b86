"""How mistakes in a suite are collected and worded."""

from __future__ import annotations

import difflib
import math
from typing import Any

_NOTES = ("note", "notes", "comment", "description", "text", "source", "tags")
"""Annotations that may stand anywhere and mean nothing to the judge."""


MAX_LINES = 200
"""Mistakes that are told of one suite."""
MAX_FIELDS = 50
"""Fields of one mapping; what has more is no mistake of spelling."""
MAX_PHRASE = 300
"""Characters of a noun phrase."""


class Problems:
    """Collects mistakes with their place."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def add(self, place: str, what: str, remedy: str) -> None:
        """Takes in one mistake: its place, what is wrong there and what to write."""
        self.lines.append(f"{place}: {what}; {remedy}")

    def told(self, name: str) -> str:
        """All mistakes of a file, for people; of very many the first.

        Args:
            name: How the message calls the file.
        """
        n = len(self.lines)
        shown = [*self.lines[:MAX_LINES], *([f"{n - MAX_LINES} more"] if n > MAX_LINES else [])]
        lines = "\n".join(f"  {line}" for line in shown)
        return f"{name}: {n} problem{'s' if n != 1 else ''}\n{lines}"


def read_number(value: Any, place: str, problems: Problems) -> float | None:
    """A finite number; anything else is added to `problems` and gives None."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        problems.add(place, f"is {show(value)}", "write a plain number, with the unit in `unit`")
        return None
    if not math.isfinite(value):
        problems.add(place, f"is {value}", "write a finite number")
        return None
    return float(value)


def read_phrase(value: Any, place: str, problems: Problems) -> str | None:
    """A noun phrase; anything else is added to `problems` and gives None."""
    if isinstance(value, str | int) and not isinstance(value, bool):
        text = str(value).strip()
        if 0 < len(text) <= MAX_PHRASE:
            return text
    problems.add(place, f"is {show(value)}", "write a noun phrase")
    return None


def report_unknown(
    place: str,
    item: dict[Any, Any],
    known: tuple[str, ...],
    problems: Problems,
    *,
    strict: bool = True,
) -> None:
    """Reports fields that would be ignored; where free metadata is allowed, only misspelt ones."""
    if len(item) > MAX_FIELDS:
        problems.add(place, f"has {len(item)} fields", f"fields are {', '.join(known)}")
        return
    for key in item:
        if key in known or str(key) in _NOTES or len(str(key)) > MAX_PHRASE:
            continue
        close = difflib.get_close_matches(str(key), known, n=1, cutoff=0.75)
        if close:
            problems.add(f"{place}/{key}", "is not a field", f"did you mean {close[0]!r}?")
        elif strict:
            problems.add(f"{place}/{key}", "is not a field", f"fields are {', '.join(known)}")


def closest(value: Any, known: tuple[str, ...]) -> str:
    """The known word that was probably meant, as a question; nothing if none is near."""
    match = difflib.get_close_matches(str(value), known, n=1, cutoff=0.6)
    return f"did you mean {match[0]!r}? " if match else ""


def kind_of(value: Any) -> str:
    """What a YAML value is, in words for people."""
    return {"list": "list", "str": "text", "int": "number", "float": "number"}.get(
        type(value).__name__, type(value).__name__
    )


def show(value: Any) -> str:
    """A value as a message shows it: cut to one line."""
    if value is None:
        return "missing"
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."
