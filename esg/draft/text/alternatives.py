"""Words as the alternatives of a pattern, and readers that take turns with a text."""

from __future__ import annotations

from collections.abc import Callable, Iterable
import re
from typing import Protocol, TypeVar

Blank = Callable[[int, int, str], None]
"""Puts other words, no longer than they are, in the place of those between two offsets."""
Places = list[tuple[int, int, str]]
"""What takes the place of words: start, end, other words."""


class Stretch(Protocol):
    """Something that stands between two offsets of a text."""

    @property
    def start(self) -> int:
        """Where it begins."""
        ...

    @property
    def end(self) -> int:
        """Where it is over."""
        ...


S = TypeVar("S", bound=Stretch)


def any_of(words: Iterable[str]) -> str:
    """The words as alternatives of a regular expression, the longest first."""
    return "|".join(re.escape(w) for w in sorted({*words}, key=lambda w: (-len(w), w)))


def taken(read: Iterable[tuple[S, Places]], blank: Blank) -> list[S]:
    """What readers find, the first of what overlaps, in the order of the text.

    Args:
        read: What they find in turn, and what takes the place of its words.
        blank: Puts that there.
    """
    found: list[S] = []
    for one, places in read:
        if any(o.start < one.end and one.start < o.end for o in found):
            continue
        found.append(one)
        for start, end, instead in places:
            blank(start, end, instead)
    return sorted(found, key=lambda o: o.start)
