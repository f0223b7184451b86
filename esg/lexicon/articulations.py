"""The table of jointed things, `articulations.csv`: of what parts they are and how these move.

A row turns what a prompt names into one part and adds another that it is joined to, each a row of
`kinds.csv` with the flag `part`; the mounts that a joint names are those of their drawings.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal

TABLE = Path(__file__).parent / "articulations.csv"
JointKind = Literal["hinge", "slider", "ball", "fixed", "rope", "spring"]


@dataclass(frozen=True)
class Articulation:
    """One row: a jointed thing.

    Args:
        nouns: Heads of phrases that name it.
        becomes: Part that the named node is; "" if it stays as it is drawn.
        with_part: Part that is added.
        carries: Which of them is the parent.
        count: How many are added.
        above_cm: Height of the named part above the ground, if it is the one that moves.
        serves: Nouns in the prompt that stand for the added part.
        kind: Of the joint.
        parent_mount: Of the parent; `{n}` counts the added parts from 1.
        child_mount: Of the child.
        lower, upper: Limits of the joint [deg or cm]; the length of a rope, at the usual size.
        start: Position at the start [deg or cm].
        opened: The same where the words say that it is open; None if nothing opens.
        drawn: The same where it is drawn back and let go; None if it does not hang.
        stiffness, damping, friction: As in the document (docs/joints.md).
        source: Where the figures come from.
    """

    nouns: tuple[str, ...]
    becomes: str
    with_part: str
    carries: Literal["becomes", "with"]
    count: int
    above_cm: float
    serves: tuple[str, ...]
    kind: JointKind
    parent_mount: str
    child_mount: str
    lower: float | None
    upper: float | None
    start: float
    opened: float | None
    drawn: float | None
    stiffness: float | None
    damping: float | None
    friction: float | None
    source: str

    @property
    def hangs(self) -> bool:
        """Whether it hangs by one point or bar, so that a ceiling does as well as its stand."""
        return self.drawn is not None and self.carries == "with" and self.kind in ("ball", "hinge")

    @property
    def hangs_anywhere(self) -> bool:
        """Whether it hangs from a ceiling as well as from its stand, or is drawn as it is."""
        return self.hangs or not self.becomes

    @property
    def tips(self) -> bool:
        """Whether it tips to one side or to the other: a seesaw."""
        free = self.opened is None and self.drawn is None
        return self.kind == "hinge" and free and (self.lower or 0.0) < 0.0 < (self.upper or 0.0)

    @property
    def turns(self) -> bool:
        """Whether it turns on and on, neither opening nor hanging; a wagon's wheels do, not it."""
        free = self.lower is None and self.upper is None and self.count == 1
        return self.kind == "hinge" and free and self.opened is None and self.drawn is None

    @property
    def rebounds(self) -> bool:
        """Whether it gives way on a spring to what runs into it, and throws that back: a bumper."""
        return self.kind == "slider" and self.stiffness is not None and self.drawn is None


def articulations() -> dict[str, Articulation]:
    """The rows of things with parts of their own, by each of their nouns."""
    return _rows()[0]


def hangers() -> dict[str, Articulation]:
    """The rows of things that hang as they are drawn: on a rope, on a spring."""
    return _rows()[1]


@cache
def _rows() -> tuple[dict[str, Articulation], dict[str, Articulation]]:
    drawn: dict[str, Articulation] = {}
    kept: dict[str, Articulation] = {}
    with open(TABLE, encoding="utf-8", newline="") as file:
        for line in csv.DictReader(file):
            row = _row(line)
            table = drawn if row.becomes else kept
            table |= dict.fromkeys(row.nouns, row)
    return drawn, kept


def _row(line: dict[str, str]) -> Articulation:
    def number(column: str) -> float | None:
        return float(line[column]) if line[column] else None

    return Articulation(
        nouns=tuple(line["nouns"].split(";")),
        becomes=line["becomes"],
        with_part=line["with"],
        carries=line["carries"],  # type: ignore[arg-type]  # tested
        count=int(line["count"]),
        above_cm=number("above_cm") or 0.0,
        serves=tuple(w for w in line["serves"].split(";") if w),
        kind=line["kind"],  # type: ignore[arg-type]  # tested
        parent_mount=line["parent_mount"],
        child_mount=line["child_mount"],
        lower=number("lower"),
        upper=number("upper"),
        start=number("start") or 0.0,
        opened=number("open"),
        drawn=number("drawn"),
        stiffness=number("stiffness"),
        damping=number("damping"),
        friction=number("friction"),
        source=line["source"],
    )
