"""Where on a top its ends, edges and corners are."""

from __future__ import annotations

import math

from esg.lexicon.parts import CORNER, EDGE, OTHER_END

SHARE, SPARE = 0.12, 1.3
"""How far a part reaches into a top: over its way across, and over the size of what is there."""
MIDDLE = 0.4
"""Half of the stretch of an edge that something is put on, over the edge: clear of its corners."""
_HIGH_CM = 1000.0

Corner = tuple[float, float, float]


def bounds_of(
    part: str, half: tuple[float, float], thing: tuple[float, float]
) -> tuple[Corner, Corner]:
    """The part of a top as bounds in its owner's frame [cm]: lowest and highest corner.

    An end is one of the longer side, an edge the middle of the longer side towards the front.

    Args:
        part: Of `esg.lexicon.parts.PARTS`.
        half: Half of the owner's extents along x and y [cm].
        thing: The same of what is put there [cm].
    """
    size = 2.0 * SPARE * math.hypot(*thing)
    long = int(half[1] > half[0])
    low, high = [-h for h in half], [*half]
    inner = [max(min(h - max(2.0 * SHARE * h, size), h - 1.0), -h) for h in half]
    if part == EDGE:
        low[1 - long] = inner[1 - long]
        low[long], high[long] = -2.0 * MIDDLE * half[long], 2.0 * MIDDLE * half[long]
    elif part == CORNER:
        low = inner
    elif part == OTHER_END:
        high[long] = -inner[long]
    else:
        low[long] = inner[long]
    return (low[0], low[1], -_HIGH_CM), (high[0], high[1], _HIGH_CM)
