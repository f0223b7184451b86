"""The limits of plausibility: tables with a source in every row, loaded once."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal

from esg.lexicon.kinds import Kind, kinds

_HERE = Path(__file__).parent
MOTION, LIMITS = _HERE / "motion.csv", _HERE / "limits.csv"

Moves = Literal["road", "track", "rail", "legs", "air", "water", "pushed", "casters", "thrown"]
_OWN = ("road", "track", "rail", "legs", "air", "water")


@dataclass(frozen=True)
class Motion:
    """How fast a kind of thing may be and become: a row of `motion.csv`.

    Args:
        moves: What it moves on, or by: what is pushed or thrown has no power of its own.
        speed_mps: No faster by itself, or when it is let go.
        accelerate_mps2: Gains no more speed than this.
        grip: Friction of its tyres, soles or hull; NaN for what has only its material's.
        source: Where the numbers are from.
    """

    moves: Moves
    speed_mps: float
    accelerate_mps2: float
    grip: float
    source: str

    @property
    def own_power(self) -> bool:
        """Whether it moves by itself."""
        return self.moves in _OWN


@cache
def limit(name: str) -> float:
    """A value of `limits.csv`, in the unit that stands there.

    Raises:
        KeyError: For a name that the table lacks.
    """
    return _limits()[name]


@cache
def _limits() -> dict[str, float]:
    with open(LIMITS, encoding="utf-8", newline="") as file:
        return {r["name"]: float(r["value"]) for r in csv.DictReader(file) if r["value"]}


def surface_grip(surface: str) -> float:
    """Most friction that a surface (dry, wet, ice) gives; infinite where the kind's own decides."""
    return _limits().get(f"surface {surface}", float("inf"))


@cache
def motion_of(category: str) -> Motion:
    """The row of a kind: its own, else its broader kinds', else its class's, else of any thing.

    Args:
        category: Of a body: the slug of a kind's name.
    """
    rows = _rows()
    found = _kinds_by_slug().get(category)
    names = [category.replace("_", " ")]
    if found is not None:
        names = [found.name, *found.parents]
    for name in names:
        if name in rows:
            return rows[name]
    classes = [found.kind] if found is not None and found.kind else []
    classes += [k.kind for n in names if (k := _kinds_by_slug().get(n.replace(" ", "_")))]
    for kind in (*classes, *names):
        if f"/{kind}" in rows:
            return rows[f"/{kind}"]
    return rows["/"]


@cache
def _kinds_by_slug() -> dict[str, Kind]:
    return {k.slug: k for k in reversed(kinds())}


@cache
def _rows() -> dict[str, Motion]:
    """Rows by name; those of a class by "/" and the class, the one of all things by "/"."""
    out: dict[str, Motion] = {}
    with open(MOTION, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            grip = float(row["grip"] or "nan")
            motion = Motion(
                row["moves"],  # type: ignore[arg-type]  # a test holds the table to the literals
                float(row["speed_mps"]),
                float(row["accelerate_mps2"]),
                grip,
                row["source"],
            )
            for name in row["names"].split(";") if row["names"] else (f"/{row['kinds']}",):
                out[name] = motion
    return out
