"""Trees, shrubs and hedges of few triangles, hills and treelines far away."""

from __future__ import annotations

import math

from esg.assets.looks import Color
from esg.dressing.builders.table import Wish, builder
from esg.dressing.solids import ALL_SIDES, Drawing

LEAVES: Color = (0.33, 0.45, 0.2)
NEEDLES: Color = (0.2, 0.34, 0.2)


def _tone(draw: Drawing, color: Color, by: float = 0.12) -> Color:
    """A colour a little lighter or darker, one of five steps so that meshes merge."""
    factor = 1.0 + by * (float(draw.rng.integers(-2, 3)) / 2.0)
    r, g, b = (min(1.0, c * factor) for c in color)
    return (r, g, b)


@builder("broadleaf", "tree")
def broadleaf(draw: Drawing, wish: Wish) -> None:
    """A tree with a round crown of clumps on a trunk."""
    color = _tone(draw, wish.color or LEAVES)
    h, r = wish.height, 0.5 * min(wish.depth, wish.width)
    bare = h * draw.rng.uniform(0.26, 0.36)
    stem = 0.028 * h
    draw.tube("bark", (0, 0, 0), (1.25 * stem, 0.75 * stem), bare + 0.25 * h)
    crown = h - bare
    middle, size = (0, 0, bare + 0.55 * crown), (0.72 * r, 0.72 * r, 0.46 * crown)
    draw.clump("leaves", middle, size, color, rough=0.16)
    turn = draw.rng.uniform(0, 2 * math.pi)
    for k in range(5):
        a = turn + 2 * math.pi * k / 5
        reach, size = 0.5 * r, draw.rng.uniform(0.4, 0.5) * r
        z = bare + crown * draw.rng.uniform(0.28, 0.56)
        at = (reach * math.cos(a), reach * math.sin(a), z)
        draw.clump("leaves", at, (size, size, 0.26 * crown), color, rough=0.16)


@builder("conifer", "tree")
def conifer(draw: Drawing, wish: Wish) -> None:
    """A fir: skirts of branches around a stem, each narrower than the one below."""
    color = _tone(draw, wish.color or NEEDLES)
    h, r = wish.height, 0.5 * min(wish.depth, wish.width)
    draw.tube("bark", (0, 0, 0), (0.03 * h, 0.012 * h), 0.4 * h)
    skirts, foot = 5, 0.1 * h
    step = (h - foot) / (skirts + 0.9)
    for k in range(skirts):
        wide = r * (1.0 - 0.82 * k / skirts) * draw.rng.uniform(0.88, 1.0)
        top = 0.12 * wide if k < skirts - 1 else 0.0
        draw.tube("leaves", (0, 0, foot + k * step), (wide, top), 1.9 * step, color, sides=14)


@builder("shrub", "bush")
def shrub(draw: Drawing, wish: Wish) -> None:
    """A bush of three clumps that reach the ground."""
    color = _tone(draw, wish.color or LEAVES)
    x, y, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    for k in range(3):
        at = (0.3 * x * draw.rng.uniform(-1, 1), 0.44 * y * (k - 1), 0.44 * h)
        draw.clump("leaves", at, (0.7 * x, 0.56 * y, 0.56 * h), color, rough=0.16)


@builder("hedge", "bush")
def hedge(draw: Drawing, wish: Wish) -> None:
    """A clipped hedge."""
    x, y, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    color = wish.color or LEAVES
    draw.box("leaves", (-x, -y, 0), (x, y, h), color)
    lumps = max(1, round(wish.width / 1.2))
    for k in range(lumps):
        at = (0, -y + wish.width * (k + 0.5) / lumps, 0.8 * h)
        draw.clump("leaves", at, (0.94 * x, 0.5 * wish.width / lumps, 0.21 * h), color, level=1)


@builder("treeline")
def treeline(draw: Drawing, wish: Wish) -> None:
    """The edge of a wood, from afar."""
    count = max(4, round(wish.width / (0.4 * wish.height)))
    for k in range(count):
        x = 0.5 * wish.depth * draw.rng.uniform(-0.3, 0.3)
        h = wish.height * draw.rng.uniform(0.6, 1.0)
        reach = wish.width / count * draw.rng.uniform(0.6, 0.85)
        y = (wish.width - 2 * reach) * ((k + draw.rng.uniform(0.2, 0.8)) / count - 0.5)
        color = _tone(draw, wish.color or LEAVES, 0.2)
        size = (0.36 * wish.depth, reach, 0.55 * h)
        draw.clump("leaves", (x, y, 0.42 * h), size, color, rough=0.3, level=1)


@builder("hill")
def hill(draw: Drawing, wish: Wish) -> None:
    """A rounded height on the horizon."""
    radii = (0.5 * wish.depth, 0.5 * wish.width, wish.height)
    draw.clump(wish.surface or "grass", (0, 0, -0.08 * wish.height), radii, wish.color, rough=0.08)


@builder("dune")
def dune(draw: Drawing, wish: Wish) -> None:
    """A low swell of sand or snow."""
    radii = (0.5 * wish.depth, 0.5 * wish.width, 1.2 * wish.height)
    draw.clump(wish.surface or "sand", (0, 0, -0.2 * wish.height), radii, wish.color, rough=0.05)


@builder("saguaro", "cactus")
def saguaro(draw: Drawing, wish: Wish) -> None:
    """A tall cactus with two arms."""
    h, reach = wish.height, 0.5 * wish.width
    color = wish.color or (0.3, 0.42, 0.24)
    r = 0.075 * h
    draw.tube("leaves", (0, 0, 0), (0.9 * r, r), 0.93 * h, color, sides=12)
    draw.clump("leaves", (0, 0, 0.92 * h), (r, r, 0.08 * h), color, rough=0.0, level=1)
    for side in (-1.0, 1.0):
        low, high = draw.rng.uniform(0.3, 0.5) * h, draw.rng.uniform(0.62, 0.85) * h
        y = side * (reach - 0.65 * r)
        inner, outer = sorted((0.0, y))
        draw.box("leaves", (-0.5 * r, inner, low - 0.5 * r), (0.5 * r, outer, low + 0.5 * r), color,
                 ALL_SIDES)  # fmt: skip
        draw.tube("leaves", (0, y, low - 0.5 * r), (0.6 * r, 0.6 * r), high - low, color, sides=10)
