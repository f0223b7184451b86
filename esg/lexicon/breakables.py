"""The table of things that can break, `breakables.csv`: at which blow, and into how many pieces.

A thing breaks where a prompt says so. What it bears is told as a speed: that of a blow which
changes its own speed by so much. So it grows with the mass of a thing of another size.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path

TABLE = Path(__file__).parent / "breakables.csv"


@dataclass(frozen=True)
class Breakable:
    """One row: a thing that breaks.

    Args:
        nouns: Heads of phrases that name it.
        at_mps: Its break impulse over its mass [m/s].
        pieces: Number of cells that it is cut into.
        falls_apart: Whether what is knocked down or collapses has broken: it is made of many parts.
        source: Where the figures come from.
    """

    nouns: tuple[str, ...]
    at_mps: float
    pieces: int
    falls_apart: bool
    source: str


@cache
def breakables() -> dict[str, Breakable]:
    """Every row by each of its nouns; those of what does not break, though it is called alike, have
    no pieces."""
    out: dict[str, Breakable] = {}
    with open(TABLE, encoding="utf-8", newline="") as file:
        for line in csv.DictReader(file):
            nouns = tuple(line["nouns"].split(";"))
            at, pieces = float(line["at_mps"] or 0.0), int(line["pieces"])
            row = Breakable(nouns, at, pieces, line["falls_apart"] == "yes", line["source"])
            out |= dict.fromkeys(nouns, row)
    return out
