"""Where on a top its ends, edges and corners are."""

from __future__ import annotations

import math

from esg.draft.discourse.referents.entities import Entity
from esg.lexicon.parts import CORNER, EDGE, OTHER_END

SHARE, SPARE = 0.25, 1.3
"""How far a part reaches into a top: over its way across, and over the size of what is there."""
MIDDLE = 0.4
"""Half of the stretch of an edge that something is put on, over the edge: clear of its corners."""
_HIGH_CM = 1000.0

Corner = tuple[float, float, float]


def bounds_of(part: str, host: Entity, thing: Entity) -> tuple[Corner, Corner]:
    """The part of a top as bounds in the host's frame [cm]: lowest and highest corner.

    An end is one of the longer side, an edge the middle of the longer side towards the front.

    Args:
        part: Of `esg.lexicon.parts.PARTS`.
        host: What has the top.
        thing: What is put there.
    """
    sides = (host.dimensions_cm or host.noun.dimensions_cm)[:2]
    size = SPARE * math.hypot(*(thing.dimensions_cm or thing.noun.dimensions_cm)[:2])
    long = int(sides[1] > sides[0])
    low, high = [-0.5 * s for s in sides], [0.5 * s for s in sides]
    inner = [max(min(0.5 * s - max(SHARE * s, size), 0.5 * s - 1.0), -0.5 * s) for s in sides]
    if part == EDGE:
        low[1 - long] = inner[1 - long]
        low[long], high[long] = -MIDDLE * sides[long], MIDDLE * sides[long]
    elif part == CORNER:
        low = inner
    elif part == OTHER_END:
        high[long] = -inner[long]
    else:
        low[long] = inner[long]
    return (low[0], low[1], -_HIGH_CM), (high[0], high[1], _HIGH_CM)
