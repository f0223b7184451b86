"""Things far away that close the view: blocks of a town, masts, a ship at its berth."""

from __future__ import annotations

from esg.dressing.builders.table import Wish, builder
from esg.dressing.solids import ALL_SIDES, Drawing


@builder("skyline")
def skyline(draw: Drawing, wish: Wish) -> None:
    """Blocks of a town on the horizon, without windows: too far to see any."""
    count = max(2, round(wish.width / 14.0))
    for k in range(count):
        y, wide = wish.width * (k / count - 0.5), wish.width / count
        tall = wish.height * float(draw.rng.uniform(0.35, 1.0))
        grey = 0.5 + 0.12 * float(draw.rng.integers(-2, 3)) / 2.0
        color = (grey, grey * 1.02, grey * 1.06)
        low, high = (-0.5 * wish.depth, y, 0.0), (0.5 * wish.depth, y + 0.94 * wide, tall)
        draw.box("plaster", low, high, color)


@builder("flood_mast")
def flood_mast(draw: Drawing, wish: Wish) -> None:
    """A mast with floodlights."""
    h = wish.height
    draw.tube("painted", (0, 0, 0), (0.16, 0.09), h, (0.5, 0.52, 0.54))
    low, high = (-0.05, -0.5 * wish.width, h - 0.7), (0.1, 0.5 * wish.width, h + 0.3)
    draw.box("painted", low, high, (0.3, 0.32, 0.34), ALL_SIDES)
    for k in range(4):
        for i in range(2):
            y = wish.width * ((k + 0.5) / 4 - 0.5)
            z = h - 0.45 + 0.5 * i
            lamp = (0.1, y - 0.12, z - 0.15), (0.16, y + 0.12, z + 0.15)
            draw.box("glow", *lamp, None, ALL_SIDES - {"-x"})


@builder("quay_wall")
def quay_wall(draw: Drawing, wish: Wish) -> None:
    """The edge of a quay: coping stones flush with the ground, and bollards to moor at."""
    x, half = 0.5 * wish.depth, 0.5 * wish.width
    draw.box("granite", (-x, -half, 0), (x, half, wish.height))
    draw.tube("cast_iron", (0, 0, wish.height), (0.14, 0.12), 0.35, (0.12, 0.12, 0.13))
    draw.tube("cast_iron", (0, 0, wish.height + 0.35), (0.2, 0.18), 0.12, (0.12, 0.12, 0.13))
