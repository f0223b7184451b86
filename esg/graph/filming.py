"""What a prompt says of the camera, as one record."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import get_args

from esg.graph.models import Filming

ABOUT = (
    "first_person",
    "over_shoulder",
    "follows",
    "extreme_close_up",
    "close_up",
    "orbits",
    "from_front",
    "from_behind",
    "from_side",
)
"""Words whose objects the camera is about, before those of all others."""
RATES: dict[str, float] = {"slow_motion": 0.25, "time_lapse": 4.0}
"""Seconds of the scene in a second of film."""


@dataclass(frozen=True)
class Row:
    """One way to film.

    Args:
        filming: Its name.
        axes: What it decides, and how: two words that decide the same otherwise are two shots.
        elevations_deg: Where the camera stands above what it films [deg], the usual one first.
        fill: How far what is filmed reaches from the middle of the picture to its edge; None for
            the usual.
    """

    filming: Filming
    axes: dict[str, str]
    elevations_deg: tuple[float, ...]
    fill: float | None


@cache
def rows() -> dict[Filming, Row]:
    """The table, by name."""
    with open(Path(__file__).parent / "filming.csv", encoding="utf-8", newline="") as file:
        found = list(csv.DictReader(file, delimiter=";"))
    named: dict[str, Filming] = {name: name for name in get_args(Filming)}
    return {
        named[r["filming"]]: Row(
            named[r["filming"]],
            dict(axis.split("=") for axis in r["axes"].split("|") if axis),
            tuple(float(v) for v in r["elevations_deg"].split("|") if v),
            float(r["fills"]) if r["fills"] else None,
        )
        for r in found
    }


def agree(a: Filming, b: Filming) -> bool:
    """Whether one shot can be both: a close-up from behind, but not a close-up and a wide shot."""
    mine, other = rows()[a].axes, rows()[b].axes
    return all(other.get(axis, how) == how for axis, how in mine.items())


@dataclass(frozen=True)
class Shot:
    """How a scene is filmed.

    Args:
        words: All that is said, in order.
        subjects: Bodies that the camera is about; empty for whatever moves.
        sided: Whether left, right, front and back are said of the scene: those are the viewer's,
            who stands at +Y.
    """

    words: tuple[Filming, ...]
    subjects: tuple[int, ...] = ()
    sided: bool = False

    @property
    def rate(self) -> float:
        """Seconds of the scene in a second of film."""
        return next((RATES[word] for word in self.words if word in RATES), 1.0)

    @property
    def open(self) -> bool:
        """Whether nothing is said of the camera itself, only of the pace of the film."""
        return all(word in RATES for word in self.words)

    def says(self, *words: str) -> bool:
        """Whether one of some words is said."""
        return any(word in words for word in self.words)


def shot_of(told: Iterable[tuple[Filming, Sequence[int]]], *, sided: bool = False) -> Shot | None:
    """The shot that statements tell together; None if none tells anything.

    Args:
        told: What each says, and the bodies that it is said of.
        sided: Whether left, right, front and back are said of the scene.
    """
    said = list(told)
    if not said:
        return None
    first = {word: k for k, word in enumerate(ABOUT)}
    ordered = sorted(said, key=lambda one: first.get(one[0], len(first)))
    subjects = next((tuple(bodies) for _, bodies in ordered if len(bodies)), ())
    words: dict[Filming, None] = {word: None for word, _ in said}
    return Shot(tuple(words), subjects, sided)
