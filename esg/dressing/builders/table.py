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


Builder = Callable[[Drawing, Wish], None]
BUILDERS: dict[str, Builder] = {}


def builder(name: str) -> Callable[[Builder], Builder]:
    """Registers a builder of dressing."""

    def register(run: Builder) -> Builder:
        BUILDERS[name] = run
        return run

    return register
