"""Sizes and masses of things: stated, or by their kind; which side of a thing a length is."""

from __future__ import annotations

import math

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.text.quantities import Amount

HOLLOW = lex.word_set("hollow")
_FILLED = 0.6
"""Share of its bounding box that a vessel holds."""
_MOST_INCLINED_DEG = 80.0
_OPEN_WATER = {"river": (6000.0, 1500.0), "canal": (6000.0, 1200.0), "sea": (8000.0, 6000.0)} | {
    w: (6000.0, 4000.0) for w in ("lake", "ocean", "harbor", "harbour", "bay", "lagoon", "loch")
}
"""Length and width [cm] of waters that boats are on."""
_MAX_SIZE_CM, _MIN_SIZE_CM = 9000.0, 0.1


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


def dimensions_of(e: Entity) -> tuple[float, float, float]:
    """Length, width and height [cm] of a thing as it is asked for."""
    if e.dimensions_cm is not None:
        d = list(e.dimensions_cm)
    else:
        d = list(e.noun.dimensions_cm)
        if e.noun.kind == "water":
            d[:2] = _OPEN_WATER.get(e.head.split()[-1], d[:2])
        for a in e.adjectives:
            if a in lex.SIZES:
                d = [x * lex.SIZES[a] for x in d]
            elif a in lex.STRETCHES and e.noun.shape != "sphere":
                d = [x * s for x, s in zip(d, lex.STRETCHES[a], strict=True)]
    limit = 1e5 if "structural" in e.noun.traits else _MAX_SIZE_CM
    low = max(_MIN_SIZE_CM, 0.11)
    return tuple(round(min(max(x, low), limit), 3) for x in d)  # type: ignore[return-value]


def mass_of(e: Entity, size: tuple[float, float, float]) -> float:
    """Mass [kg] of a thing of a size: stated, or by its kind, material and adjectives."""
    if e.mass_kg is not None:
        return e.mass_kg
    base = e.noun.dimensions_cm
    ratio = (size[0] * size[1] * size[2]) / (base[0] * base[1] * base[2])
    mass = e.noun.mass_kg * ratio
    if e.material is not None:
        own = next((d for n, d in lex.MATERIALS.values() if n == e.noun.material), 900.0)
        mass *= min(max(lex.MATERIALS[e.material][1] / own, 0.05), 15.0)
    for a in e.adjectives:
        mass *= lex.WEIGHTS.get(a, 1.0)
    volume = size[0] * size[1] * size[2] * 1e-6
    mass = min(max(mass * e.mass_factor, volume * 1.5), volume * 20_000.0)
    return round(min(max(mass, 0.0011), 99_000.0), 5)


def grows(vessel: Entity) -> bool:
    """Whether a vessel is as wide as whom it holds asks for: a box of no told size."""
    box = vessel.noun.kind == "box" and "container" in vessel.noun.traits
    return box and not vessel.dimensions_prescribed
