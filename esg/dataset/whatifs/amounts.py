"""What is changed by how much: rows of data, of which the seed of a scene picks one."""

from __future__ import annotations

from collections.abc import Sequence
import csv
from dataclasses import dataclass
from functools import cache
import hashlib
from pathlib import Path
from typing import Literal, TypeVar, get_args

TABLE = Path(__file__).parent / "amounts.csv"

Variable = Literal["mass", "friction", "speed", "gravity", "remove", "direction"]
VARIABLES: tuple[Variable, ...] = get_args(Variable)
ENGINES = ("physx", "rapier", "newton")
"""Those that every changed scene is played in."""

_T = TypeVar("_T")


@dataclass(frozen=True)
class Amount:
    """One row of the table.

    Args:
        variable: What is changed.
        amount: Name of the change.
        value: Factor on mass, friction or speed; gravity [m/s^2]; turn to the left [deg].
        unit: Of `value`.
        words: What follows "if it ...".
        source: Why so much.
    """

    variable: Variable
    amount: str
    value: float
    unit: str
    words: str
    source: str


@cache
def amounts() -> dict[str, tuple[Amount, ...]]:
    """Rows of the table by variable."""
    out: dict[str, tuple[Amount, ...]] = {}
    with open(TABLE, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            name = row["variable"]
            assert name in VARIABLES
            values = {k: row[k] for k in ("amount", "unit", "words", "source")}
            item = Amount(variable=name, value=float(row["value"]), **values)
            out[name] = (*out.get(name, ()), item)
    return out


def amount_named(variable: str, amount: str) -> Amount:
    """The row of a change.

    Raises:
        KeyError: If there is none.
    """
    for row in amounts().get(variable, ()):
        if row.amount == amount:
            return row
    raise KeyError(f"no amount {amount!r} of {variable!r}")


def picked(choices: Sequence[_T], *seed: object) -> _T:
    """One of some choices, by a hash: equal seeds pick equally on every machine."""
    digest = hashlib.sha256("/".join(map(str, seed)).encode()).digest()
    return choices[int.from_bytes(digest[:8], "big") % len(choices)]
