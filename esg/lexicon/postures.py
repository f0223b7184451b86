"""The table of postures, `postures.csv`: how large a body is in each of them, by its plan.

Sizes of people are shares of their height; those of four-legged animals of their own length, width
and height as they stand. Legs and arms that reach out of the place where somebody stands do not
collide, but for who lies. `least` and `most` are what the judge takes for the posture.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from esg.lexicon.kinds import kinds

TABLE = Path(__file__).parent / "postures.csv"
PLANS = {"figure": "people", "child_figure": "people", "quadruped": "beasts"}
"""Plan of a body by what draws it."""
STANDS = "stands"


@dataclass(frozen=True)
class Posture:
    """One row.

    Args:
        plan: people or beasts.
        posture: What a statement says: stands, sits, lies, kneels, crouches, bends.
        on: ground, or seat for who sits on something.
        pose: How the model is drawn; empty as ever.
        length, width, height: Of what collides, as shares.
        ahead: How far before the middle of who stands its middle is, as a share.
        least, most: Height of the body over that of who stands.
        source: Where the figures come from.
    """

    plan: str
    posture: str
    on: str
    pose: str
    length: float
    width: float
    height: float
    ahead: float
    least: float
    most: float
    source: str

    def size(self, standing: tuple[float, float, float]) -> tuple[float, float, float]:
        """Length, width and height of a body, by those of it as it stands, in the same unit."""
        x, y, z = standing
        x, y = (z, z) if self.plan == "people" else (x, y)
        return self.length * x, self.width * y, self.height * z

    def middle(self, standing: tuple[float, float, float]) -> float:
        """How far ahead of the middle of who stands its own is, in the same unit."""
        return self.ahead * (standing[2] if self.plan == "people" else standing[0])


@cache
def postures() -> tuple[Posture, ...]:
    """Every row, in the order of the table."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        return tuple(
            Posture(
                line["plan"],
                line["posture"],
                line["on"],
                line["pose"],
                float(line["length"]),
                float(line["width"]),
                float(line["height"]),
                float(line["ahead"]),
                float(line["least"]),
                float(line["most"]),
                line["source"],
            )
            for line in csv.DictReader(file)
        )


@cache
def plan_of(noun: str, *, person: bool) -> str | None:
    """The plan of the body that is drawn for a noun; None for a body without postures.

    Args:
        noun: Head of its phrase.
        person: Whether it names a person: those are drawn as people unless they have a row.
    """
    for kind in kinds():
        if kind.builder and noun in (kind.name, *kind.said_as, *kind.found_as):
            return PLANS.get(kind.builder)
    return "people" if person else None


def posture_of(plan: str, posture: str, on: str = "ground") -> Posture | None:
    """The row of a posture; None where such a body has none."""
    own = [r for r in postures() if r.plan == plan and r.posture == posture]
    return next((r for r in own if r.on == on), own[0] if own else None)
