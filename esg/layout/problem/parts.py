"""Where on a top its ends, edges and corners are."""

from __future__ import annotations

import math

from esg.lexicon.parts import CORNER, EDGE, OTHER_END, SIDE, kind_of, sides_of

SHARE, SPARE = 0.12, 1.3
"""How far a part reaches into a top: over its way across, and over the size of what is there."""
MIDDLE = 0.4
"""Half of the stretch of an edge that something is put on, over the edge: clear of its corners."""
BEYOND = 0.3
"""How far off the middle a side of a top begins, over half of the way across."""
_FACING = {"front": (0, 1), "back": (0, -1), "left": (1, -1), "right": (1, 1)}
"""The axis and the sign of each side in the frame of what turns its front to the viewer."""
_HIGH_CM = 1000.0

Corner = tuple[float, float, float]


def bounds_of(
    part: str, half: tuple[float, float], thing: tuple[float, float]
) -> tuple[Corner, Corner]:
    """The part of a top as bounds in its owner's frame [cm]: lowest and highest corner.

    An end is one of the longer side, an edge the middle of the longer side towards the front. Sides
    are the viewer's, to whom furniture turns its front; the judge sees whether it does.

    Args:
        part: Of `esg.lexicon.parts.PARTS`.
        half: Half of the owner's extents along x and y [cm].
        thing: The same of what is put there [cm].
    """
    size = 2.0 * SPARE * math.hypot(*thing)
    long = int(half[1] > half[0])
    low, high = [-h for h in half], [*half]
    inner = [max(min(h - max(2.0 * SHARE * h, size), h - 1.0), -h) for h in half]
    kind, sides = kind_of(part), sides_of(part)
    for side in sides:
        axis, sign = _FACING[side]
        reach = inner[axis] if kind != SIDE else min(BEYOND * half[axis], inner[axis])
        low[axis], high[axis] = (reach, half[axis]) if sign > 0 else (-half[axis], -reach)
    if sides:
        pass
    elif kind == EDGE:
        low[1 - long] = inner[1 - long]
        low[long], high[long] = -2.0 * MIDDLE * half[long], 2.0 * MIDDLE * half[long]
    elif kind == CORNER:
        low = inner
    elif part == OTHER_END:
        high[long] = -inner[long]
    else:
        low[long] = inner[long]
    return (low[0], low[1], -_HIGH_CM), (high[0], high[1], _HIGH_CM)
