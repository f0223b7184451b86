"""What open vessels are filled with (`contents.csv`), and what sinks in it (`densities.csv`)."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal

from esg.lexicon.cells import words

TABLE = Path(__file__).parent / "contents.csv"
CONTENT = "content"
"""Kind of the region of a filled vessel that its content takes up; its name is the content's."""


@dataclass(frozen=True)
class Content:
    """One row.

    Args:
        name: Unique.
        said_as: Other words for it.
        form: A liquid bears things up as its density says; what is loose carries as firm ground.
        density: Of liquids; of what is loose, of the heap [kg/m^3].
        viscosity: Of liquids [Pa s], else 0.
        color: sRGB in [0, 1].
        alpha: 1 where nothing is seen through it.
        finish: Material that it is seen as.
        source: Where density and viscosity are from.
    """

    name: str
    said_as: tuple[str, ...]
    form: Literal["liquid", "loose"]
    density: float
    viscosity: float
    color: tuple[float, float, float]
    alpha: float
    finish: str
    source: str

    @property
    def liquid(self) -> bool:
        """Whether things float or sink in it."""
        return self.form == "liquid"


@cache
def contents() -> dict[str, Content]:
    """The rows by name."""
    out: dict[str, Content] = {}
    with open(TABLE, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            red, green, blue = (int(row["color"][i : i + 2], 16) / 255.0 for i in (1, 3, 5))
            out[row["name"]] = Content(
                name=row["name"],
                said_as=words(row["said_as"]),
                form="loose" if row["form"] == "loose" else "liquid",
                density=float(row["density"]),
                viscosity=float(row["viscosity"] or 0.0),
                color=(red, green, blue),
                alpha=float(row["alpha"]),
                finish=row["finish"],
                source=row["source"],
            )
    return out


@cache
def contents_said() -> dict[str, str]:
    """Names of contents by the words for them."""
    rows = contents().values()
    return {word: row.name for row in rows for word in (row.name, *row.said_as)}


@cache
def densities() -> dict[str, float]:
    """Densities [kg/m^3] of things whose shapes are wider than they are, by the words for them."""
    with open(TABLE.with_name("densities.csv"), encoding="utf-8", newline="") as file:
        rows = [*csv.DictReader(file)]
    return {
        word: float(row["density"])
        for row in rows
        for word in (row["name"], *words(row["said_as"]))
    }
