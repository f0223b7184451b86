"""Who draws what: builders of dressing by name."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from esg.assets.looks import Color
from esg.dressing.solids import Drawing


@dataclass(frozen=True)
class Wish:
    """What is asked of a builder.

    Args:
        depth, width, height: Extents along X, Y and Z [m].
        surface: Main surface; "" for the builder's own.
        color: Main colour, sRGB; None for the usual one.
    """

    depth: float
    width: float
    height: float
    surface: str = ""
    color: Color | None = None


Run = Callable[[Drawing, Wish], None]


@dataclass(frozen=True)
class Builder:
    """One kind of thing that only dressing needs.

    Args:
        run: Draws it.
        like: Categories of the library that one would call it, too.
        bare: A wall on which things may hang, and before which tall ones may stand.
        door: Where a wall has a door: its middle along Y, in widths; None if it has none.
    """

    run: Run
    like: tuple[str, ...] = ()
    bare: bool = False
    door: float | None = None


BUILDERS: dict[str, Builder] = {}


def builder(
    name: str, *like: str, bare: bool = False, door: float | None = None
) -> Callable[[Run], Run]:
    """Registers a builder of dressing; arguments as of `Builder`."""

    def register(run: Run) -> Run:
        BUILDERS[name] = Builder(run, like, bare, door)
        return run

    return register
