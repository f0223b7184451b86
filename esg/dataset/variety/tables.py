"""The words of variety: places, lights, looks of nouns and bystanders (`esg/dataset/data`)."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

from esg.lexicon.cells import words

UNSAID = "unsaid"
"""The share of sentences that leave something open."""
CAMERAS = ("around", "auto", "static", "tracking", "dolly", "orbit", "dash")
"""Ways to film a scene, as of `esg render --camera`."""
COLORS = ("red", "blue", "green", "yellow", "orange", "white", "black", "purple", "brown", "gray")
SIZES = ("small", "large")


@dataclass(frozen=True)
class Setting:
    """A place that a sentence may name.

    Args:
        place: Row of `esg/lexicon/places.csv`.
        phrase: How sentences say it.
        suits: What a rule needs (`esg.dataset.rules.Rule.where`) and the place has.
        under: Which lights it has: outdoor or indoor.
    """

    place: str
    phrase: str
    suits: frozenset[str]
    under: str


@dataclass(frozen=True)
class Light:
    """A light that a sentence may name.

    Args:
        light: Row of `esg/lexicon/skies.csv`.
        phrase: How sentences say it.
        under: Where it can be seen: outdoor, indoor.
    """

    light: str
    phrase: str
    under: frozenset[str]


@dataclass(frozen=True)
class Bystander:
    """A thing that stands around and takes no part.

    Args:
        kind: Singular.
        plural: Plural.
        suits: Where it is at home: outdoor, indoor.
    """

    kind: str
    plural: str
    suits: frozenset[str]


@dataclass(frozen=True)
class Looks:
    """What may be said of how a noun looks.

    Args:
        head: The noun without its material.
        materials: Adjectives; they take the place of the noun's own.
        colors: Whether it may have a colour.
        sizes: Whether it may be small or large.
        variants: Other things that may take its place.
    """

    head: str
    materials: frozenset[str]
    colors: bool
    sizes: bool
    variants: tuple[str, ...]


def _rows(name: str) -> list[dict[str, str]]:
    text = files("esg.dataset").joinpath("data", name).read_text(encoding="utf-8")
    return list(csv.DictReader(text.splitlines()))


@cache
def settings() -> dict[str, Setting]:
    """Places by name."""
    return {
        r["place"]: Setting(r["place"], r["phrase"], frozenset(words(r["suits"])), r["lights"])
        for r in _rows("settings.csv")
    }


@cache
def lights() -> dict[str, Light]:
    """Lights by name."""
    return {
        r["light"]: Light(r["light"], r["phrase"], frozenset(words(r["under"])))
        for r in _rows("lights.csv")
    }


@cache
def bystanders() -> dict[str, Bystander]:
    """Bystanders by kind."""
    return {
        r["kind"]: Bystander(r["kind"], r["plural"], frozenset(words(r["suits"])))
        for r in _rows("bystanders.csv")
    }


@cache
def looks() -> dict[str, Looks]:
    """What may be said of nouns, by noun."""
    return {
        r["noun"]: Looks(
            r["head"],
            frozenset(words(r["materials"])),
            bool(r["colors"]),
            bool(r["sizes"]),
            words(r["variants"]),
        )
        for r in _rows("looks.csv")
    }


@cache
def materials() -> tuple[str, ...]:
    """All materials that some noun may have."""
    return tuple(sorted({m for row in looks().values() for m in row.materials}))
