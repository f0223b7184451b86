"""The limits of plausibility: tables with a source in every row, loaded once."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
import math
from pathlib import Path
from typing import Literal

from esg.lexicon.grounds import grounds
from esg.lexicon.kinds import Kind, kinds
from esg.thresholds import BRAKING_ICY_G, BRAKING_WET_G

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
        reverse_mps: No faster backwards; as fast as ahead where a row has no figure.
        accelerate_mps2: Gains no more speed than this.
        grip: Friction of its tyres, soles or hull; NaN for what has only its material's.
        source: Where the numbers are from.
    """

    moves: Moves
    speed_mps: float
    reverse_mps: float
    accelerate_mps2: float
    grip: float
    source: str

    @property
    def own_power(self) -> bool:
        """Whether it moves by itself."""
        return self.moves in _OWN

    @property
    def flies(self) -> bool:
        """Whether air or water carries it, so that the ground does not matter."""
        return self.moves in ("air", "water")


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


def surface_grip(said: str, ground_friction: float) -> float:
    """Most friction that tyres, soles and hulls find on a scene's ground.

    Args:
        said: What the prompt says of the ground: dry, or a row of the table of grounds.
        ground_friction: Of the simulated ground.
    """
    if said in grounds():
        return grounds()[said].grip
    if ground_friction < limit("icy ground"):
        return BRAKING_ICY_G
    if ground_friction < limit("wet ground"):
        return BRAKING_WET_G
    return math.inf


@cache
def motion_of(*names: str) -> Motion:
    """The row of the first name of which one is known: its own, or that of a broader kind or class.

    Args:
        names: What a thing is called, the most telling first: its label, its category. Of several
            words the last ones count too ("red tow truck", "tow truck", "truck").
    """
    for name in names:
        words = name.lower().replace("_", " ").split()
        parts = [" ".join(words[k:]) for k in range(len(words))]
        for kinds_ in _kinds():
            for part in parts:
                if (row := _row(part, kinds_.get(part))) is not None:
                    return row
    return _rows()["/"]


def _row(name: str, kind: Kind | None) -> Motion | None:
    own = (name,) if kind is None else (kind.name, *kind.parents)
    plain = _kinds()[0]
    classes = [f"/{k.kind}" for n in own if (k := plain.get(n)) is not None and k.kind]
    keys = (*own, *classes, *(f"/{n}" for n in own if n))
    return next((_rows()[key] for key in keys if key in _rows()), None)


@cache
def _kinds() -> tuple[dict[str, Kind], dict[str, Kind]]:
    """Kinds by their names, and by what else they are called: a tow truck is a truck first."""
    called: dict[str, Kind] = {}
    for kind in kinds():
        for name in kind.said_as:
            called.setdefault(name, kind)
    return {kind.name: kind for kind in reversed(kinds())}, called


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
                float(row["reverse_mps"] or row["speed_mps"]),
                float(row["accelerate_mps2"]),
                grip,
                row["source"],
            )
            for name in row["names"].split(";") if row["names"] else (f"/{row['kinds']}",):
                out[name] = motion
    return out
