"""The table of kinds, `kinds.csv`: what a noun names, how large and heavy that is, how it is drawn.

A row with a `kind` is a noun that prompts are read with; a row with a `builder` is an entry of the
parametric library; most are both, and then have one size and one mass.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
import math
from pathlib import Path

TABLE = Path(__file__).parent / "kinds.csv"
Size = tuple[float, float, float]
NEAR = 1.12
"""Ratios of extents up to this are the same size."""


ROLLING = frozenset({"rolls", "rim", "axle", "across"})
"""Flags of what rolls: a ball, or a thing round about its height, its front axis or across it."""


@dataclass(frozen=True)
class Kind:
    """One row: a kind of object.

    Args:
        name: Singular noun as it is written ("trash bin"); unique.
        dimensions_cm: Usual length, width and height, as people tell them.
        mass_kg: Usual mass at that size.
        said_as: Other nouns that mean it in a prompt.
        kind: Class of objects that move and behave alike ("vehicle"); "" if prompts are not read
            with it.
        shape: sphere, box, cylinder, capsule or compound.
        traits: What the drafter has to know: wheeled, round, container, support, fixed ...
        material: Main material, as a word.
        request: What is asked of a library.
        parents: Chain of broader entries of the library, nearest first.
        builder: Parametric builder; "" if the library does not draw it.
        params: Arguments of the builder, "key=value".
        drawn_cm: Extents of a drawing that keeps its own proportions (front axis, across, up),
            where they are not `dimensions_cm`.
        front: "side" where the front faces across the length, as a desk's; else "".
        surface: Key of the table of materials.
        color: "#rrggbb".
        flags: What the library has to know: rolls, fixed, decal, any_size ...
        found_as: Other names under which the library is searched.
        description: One line for retrieval.
        reference: Source of size and mass.
    """

    name: str
    dimensions_cm: Size
    mass_kg: float
    said_as: tuple[str, ...]
    kind: str
    shape: str
    traits: frozenset[str]
    material: str
    request: str
    parents: tuple[str, ...]
    builder: str
    params: tuple[str, ...]
    drawn_cm: Size | None
    front: str
    surface: str
    color: str
    flags: frozenset[str]
    found_as: tuple[str, ...]
    description: str
    reference: str

    @property
    def rolls(self) -> bool:
        """Whether it is round about some axis, and rolls about it."""
        return bool(self.flags & ROLLING)

    @property
    def slug(self) -> str:
        """The name with underscores."""
        return self.name.replace(" ", "_").replace("-", "_")

    @property
    def local_cm(self) -> Size:
        """Extents [cm] of the usual drawing: along its front axis +X, across, up."""
        length, width, height = self.dimensions_cm
        if self.drawn_cm:
            return self.drawn_cm
        return (width, length, height) if self.front == "side" else self.dimensions_cm

    @property
    def local_kg(self) -> float:
        """Mass at `local_cm`: the usual one, by volume where the drawing is of another size."""
        ratio = math.prod(self.local_cm) / math.prod(self.dimensions_cm)
        same = NEAR**-3 <= ratio <= NEAR**3
        return self.mass_kg if same else self.mass_kg * ratio


@cache
def kinds() -> tuple[Kind, ...]:
    """Every row, in file order."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        return tuple(_kind(row) for row in csv.DictReader(file))


def _kind(row: dict[str, str]) -> Kind:
    def words(column: str) -> tuple[str, ...]:
        return tuple(w for w in row[column].split(";") if w)

    return Kind(
        name=row["name"],
        dimensions_cm=(
            float(row["length_cm"]),
            float(row["width_cm"]),
            float(row["height_cm"]),
        ),
        mass_kg=float(row["mass_kg"]),
        said_as=words("said_as"),
        kind=row["kind"],
        shape=row["shape"],
        traits=frozenset(words("traits")),
        material=row["material"],
        request=row["request"],
        parents=words("parents"),
        builder=row["builder"],
        params=words("params"),
        drawn_cm=_size(row["drawn_cm"]),
        front=row["front"],
        surface=row["surface"],
        color=row["color"],
        flags=frozenset(words("flags")),
        found_as=words("found_as"),
        description=row["description"],
        reference=row["reference"],
    )


def _size(text: str) -> Size | None:
    if not text:
        return None
    length, width, height = (float(x) for x in text.split("x"))
    return (length, width, height)
