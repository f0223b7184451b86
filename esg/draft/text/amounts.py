"""Physical quantities of a prompt, in document units (cm, kg, s, degrees)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
import re
from typing import Literal

from esg.draft import lexicon as lex
from esg.draft.text.units import Dimension

Bound = Literal["min", "max"] | None
_SHARED = lex.word_set("shared")
_BETWEEN = re.compile(r"\s*(?:[,;/]|,?\s*(?:and|&)(?:\s+the\s+(?:other|last))?)\s*")


@dataclass(frozen=True)
class Amount:
    """A physical quantity of the prompt.

    Args:
        dimension: What it measures.
        low, high: Document units (cm, kg, s, degrees, cm/s, cm/s^2); equal for a point value.
        start, end: Character span in the prompt.
        text: The span's text.
        bound: "min" or "max" for one-sided statements ("at least 3 s"), else None.
        measure: What its words say it measures: diameter, side, start ("2 s after the start"),
            later (a delay), period (of what recurs).
        sides: Lengths of the sides where several are given ("20 x 30 x 40 cm").
        shares: The values of a list that is one quantity ("1 kg, 2 kg and 3 kg").
    """

    dimension: Dimension
    low: float
    high: float
    start: int
    end: int
    text: str
    bound: Bound = None
    measure: str = ""
    sides: tuple[float, ...] = ()
    shares: tuple[Amount, ...] = ()

    @property
    def value(self) -> float | tuple[float, float]:
        """A number, or the interval (low, high)."""
        return self.low if self.low == self.high else (self.low, self.high)

    @property
    def middle(self) -> float:
        return 0.5 * (self.low + self.high)


def overlaps(start: int, end: int, amounts: Iterable[Amount]) -> bool:
    """Whether a span shares characters with a quantity."""
    return any(start < a.end and a.start < end for a in amounts)


def joined(amounts: Sequence[Amount], text: str) -> list[Amount]:
    """Quantities of one kind with nothing but commas and "and" in between, as one each.

    Args:
        amounts: The quantities of the prompt, left to right.
        text: The prompt.

    Returns:
        The quantities; a list of them is one, whose `shares` are the parts.
    """
    runs: list[list[Amount]] = []
    for a in amounts:
        last = runs[-1][-1] if runs else None
        if (
            last is not None
            and a.dimension == last.dimension
            and a.dimension in _SHARED
            and not (a.sides or last.sides or a.bound or last.bound)
            and _BETWEEN.fullmatch(text, last.end, a.start)
        ):
            runs[-1].append(a)
        else:
            runs.append([a])
    return [r[0] if len(r) == 1 else _one(r, text) for r in runs]


def _one(run: list[Amount], text: str) -> Amount:
    return replace(
        run[-1],
        low=min(a.low for a in run),
        high=max(a.high for a in run),
        start=run[0].start,
        text=text[run[0].start : run[-1].end],
        shares=tuple(run),
    )
