"""What readers of lights, weather, wind and smoke find in a text, and put in its place."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from esg.draft.text.alternatives import Places
from esg.graph.models import Predicate

SCENE, BEFORE = -1, -2
"""What words may be said of: the scene, or what is named last before them."""


@dataclass(frozen=True)
class Shown:
    """Something that is said of how things look in time.

    Args:
        says: `lit`, `weather`, `sways` or `gives_off`.
        start, end: Words that say so.
        noun: As of the statement: "turned off", "flashing red", "heavy rain".
        about: Where the noun of what it is said of begins; `SCENE` or `BEFORE`.
        light: How the light is called, of those of its owner.
        lacks: Words about it that nothing shows.
        act: Words of an act by which it is brought about; None where it changes by itself.
    """

    says: Predicate
    start: int
    end: int
    noun: str
    about: int = SCENE
    light: str = ""
    act: tuple[int, int] | None = None
    lacks: tuple[int, int] | None = None


Read = Iterator[tuple[Shown, Places]]
"""What is found, with what takes the place of its words."""
