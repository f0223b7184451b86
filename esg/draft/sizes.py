"""Stated sizes: which side of a thing a length is, and how large what holds two litres is."""

from __future__ import annotations

import math

from esg.draft.entities import Entity
from esg.draft.quantities import Amount

HOLLOW = frozenset({"tableware", "bottle", "container", "barrel", "box", "appliance"})
"""Kinds whose size a stated volume gives."""
_FILLED = 0.6
"""Share of its bounding box that a vessel holds."""
_MOST_INCLINED_DEG = 80.0


def _now(e: Entity) -> list[float]:
    return list(e.dimensions_cm or e.noun.dimensions_cm)


def sized(e: Entity, amount: Amount, word: str = "") -> list[float]:
    """Length, width and height [cm] of a thing of which a length is stated.

    Args:
        e: The thing.
        amount: The length, or the lengths of several sides.
        word: tall, wide, thick, diameter ... beside the number; "" means its largest side, and the
            height of a wall.
    """
    dims, x, word = _now(e), amount.middle, word or amount.measure
    if e.noun.shape == "sphere":
        x = 2.0 * x if word == "radius" else x
        return [x, x, x]
    if len(amount.sides) == 3:
        return list(amount.sides)
    if len(amount.sides) == 2:
        flat = min(dims) < 0.35 * max(dims)
        thinnest = dims.index(min(dims)) if flat else 2
        for i, side in zip([i for i in range(3) if i != thinnest], amount.sides, strict=True):
            dims[i] = side
        return dims
    long = 0 if dims[0] >= dims[1] else 1
    if word in ("tall", "high", "deep", "height"):
        dims[2] = x
    elif word in ("wide", "width"):
        dims[1] = x
    elif word in ("long", "length"):
        dims[long] = x
    elif word in ("thick", "thickness"):
        dims[dims.index(min(dims))] = x
    elif word in ("diameter", "radius", "in diameter"):
        dims[0] = dims[1] = 2.0 * x if word == "radius" else x
    elif word == "side" and e.noun.shape == "box":
        dims = [x, x, x]
    elif e.noun.kind == "wall":
        dims[2] = x  # "a 1.2 m fence"
    else:
        largest = max(dims)
        dims = [d * x / largest for d in dims]
    return dims


def holding(e: Entity, litres: float) -> list[float]:
    """The usual proportions at the size that holds a volume [l]."""
    dims = _now(e)
    usual = _FILLED * dims[0] * dims[1] * dims[2] * 1e-3
    factor = min(max((litres / usual) ** (1.0 / 3.0), 0.1), 10.0)
    return [factor * d for d in dims]


def inclined(e: Entity, degrees: float) -> list[float]:
    """A ramp of its usual length, as steep as stated."""
    dims = _now(e)
    angle = min(max(abs(degrees), 1.0), _MOST_INCLINED_DEG)
    dims[2] = max(2.0, dims[0] * math.tan(math.radians(angle)))
    return dims
