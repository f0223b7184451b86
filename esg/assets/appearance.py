"""How one particular thing looks where its kind leaves it open; nothing physical depends on it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
import hashlib

from esg.assets.looks import Color


@dataclass(frozen=True)
class Wear:
    """Something that somebody wears, or how his hair is.

    Args:
        kind: Of the table of garments (`esg.lexicon.garments`).
        color: That is stated, sRGB in [0, 1]; None for the usual one.
        surface: Row of the table of materials that is stated; "" for the usual one.
        striped: Whether it has stripes.
    """

    kind: str
    color: Color | None = None
    surface: str = ""
    striped: bool = False


@dataclass(frozen=True)
class Appearance:
    """What a builder may choose by, beyond kind, size and colour.

    Args:
        pose: How a person holds himself (`builders.living.poses`); "" as the builder likes.
        livery: What a vehicle serves as: police, taxi, ambulance.
        seed: Of details that nobody states (hair, patterns, wear); None for the usual ones.
        color: Takes the place of the kind's usual colour; None where the colour is stated.
        material: Takes the place of what the kind is seen as, where another is stated; else "".
        wears: What is stated that he wears, and how his hair is.
    """

    pose: str = ""
    livery: str = ""
    seed: int | None = None
    color: Color | None = None
    material: str = ""
    wears: tuple[Wear, ...] = ()

    def pick(self, what: str, choices: int) -> int:
        """One of so many choices for a detail; 0, the usual one, without a seed."""
        return 0 if self.seed is None else _drawn(self.seed, what) % choices

    def share(self, what: str) -> float:
        """A number in [0, 1) for a detail; 0.5 without a seed."""
        return 0.5 if self.seed is None else (_drawn(self.seed, what) % 4096) / 4096


USUAL = Appearance()
RIDDEN = "ridden"
"""The pose of a vehicle on which somebody is drawn."""
FLYING = "fly"
"""The pose of a bird with its wings spread."""


@lru_cache(maxsize=4096)
def _drawn(seed: int, what: str) -> int:
    digest = hashlib.sha256(f"{seed}/{what}".encode()).digest()
    return int.from_bytes(digest[:6], "big")
