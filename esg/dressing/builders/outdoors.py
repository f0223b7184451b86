"""What stands outdoors: parked cars, benches and pots, plainer than what takes part in a scene."""

from __future__ import annotations

import numpy as np

from esg.assets.looks import Color
from esg.dressing.builders.table import Wish, builder
from esg.dressing.solids import ALL_SIDES, Drawing

_BODY = (
    # x and z in lengths and heights of the car, half width in widths
    (0.5, 0.22, 0.46), (0.495, 0.42, 0.47), (0.46, 0.49, 0.49), (0.2, 0.58, 0.49),
    (-0.36, 0.62, 0.49), (-0.47, 0.6, 0.48), (-0.5, 0.45, 0.46), (-0.495, 0.2, 0.46),
    (-0.45, 0.14, 0.48), (0.45, 0.14, 0.48),
)  # fmt: skip
_GLASS = ((0.2, 0.58, 0.46), (0.02, 0.93, 0.38), (-0.28, 0.95, 0.38), (-0.41, 0.61, 0.45))
_ROOF = ((0.03, 0.925, 0.385), (0.0, 0.965, 0.36), (-0.26, 0.985, 0.36), (-0.3, 0.94, 0.385))
_AXLES = (0.305, -0.29)


@builder("parked_car", "car", "hatchback", "suv", "taxi", "sports_car")
def parked_car(draw: Drawing, wish: Wish) -> None:
    """A car in the background."""
    length, width, h = wish.depth, wish.width, wish.height

    def part(
        surface: str, rows: tuple[tuple[float, float, float], ...], color: Color | None
    ) -> None:
        table = np.array(rows)
        draw.prism(surface, table[:, :2] * (length, h), table[:, 2] * width, color)

    paint = wish.color or (0.7, 0.71, 0.72)
    part("varnish", _BODY, paint)
    part("pane", _GLASS, (0.12, 0.14, 0.16))
    part("varnish", _ROOF, paint)
    radius = 0.22 * h
    for x in _AXLES:
        for side in (-1.0, 1.0):
            y = side * (0.5 * width - 0.1)
            draw.disc("tyre", (x * length, y, radius), radius, 0.2)
            draw.disc("steel", (x * length, y + side * 0.06, radius), 0.6 * radius, 0.1, None, 10)
    for side in (-1.0, 1.0):
        y = side * 0.34 * width
        low, high = (0.475 * length, y - 0.14, 0.43 * h), (0.497 * length, y + 0.14, 0.49 * h)
        draw.box("pane", low, high, (0.9, 0.9, 0.86), ALL_SIDES)
        low, high = (-0.502 * length, y - 0.14, 0.47 * h), (-0.48 * length, y + 0.14, 0.55 * h)
        draw.box("pane", low, high, (0.5, 0.06, 0.05), ALL_SIDES)


@builder("park_bench", "bench", "plain_bench")
def park_bench(draw: Drawing, wish: Wish) -> None:
    """A bench of slats on iron legs; front +X."""
    x, half, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    seat = 0.52 * h
    for y in (-half + 0.12, half - 0.18):
        draw.box("cast_iron", (-x + 0.05, y, 0), (-x + 0.1, y + 0.06, h))
        draw.box("cast_iron", (x - 0.12, y, 0), (x - 0.06, y + 0.06, seat))
        draw.box("cast_iron", (-x + 0.05, y, seat - 0.06), (x - 0.06, y + 0.06, seat - 0.02), None,
                 ALL_SIDES)  # fmt: skip
    slats = 4
    for k in range(slats):
        at = -x + 0.12 + (wish.depth - 0.22) * k / slats
        low, high = (at, -half, seat - 0.02), (at + 0.1, half, seat + 0.02)
        draw.box("boards", low, high, wish.color, ALL_SIDES)
    for k in range(3):
        z = seat + 0.1 + (h - seat - 0.1) * k / 3
        low, high = (-x + 0.08, -half, z), (-x + 0.12, half, z + 0.09)
        draw.box("boards", low, high, wish.color, ALL_SIDES)


@builder("pot_plant", "potted_plant", "flowerpot")
def pot_plant(draw: Drawing, wish: Wish) -> None:
    """A plant in a pot."""
    r, h = 0.5 * min(wish.depth, wish.width), wish.height
    pot = 0.32 * h
    draw.tube("terracotta", (0, 0, 0), (0.42 * r, 0.6 * r), pot, wish.color, sides=14)
    draw.tube("forest_floor", (0, 0, pot - 0.005), (0.5 * r, 0.5 * r), 0.008, sides=14)
    draw.tube("bark", (0, 0, pot), (0.05 * r, 0.04 * r), 0.3 * h, sides=6)
    for k in range(5):
        turn = draw.rng.uniform(-0.5, 0.5, 2)
        at = (turn[0] * r, turn[1] * r, h * (0.55 + 0.08 * k))
        size = r * draw.rng.uniform(0.42, 0.58)
        draw.clump("leaves", at, (size, size, 0.13 * h), (0.25, 0.42, 0.18), rough=0.16, level=1)


@builder("bookcase", "bookshelf", "shelf")
def bookcase(draw: Drawing, wish: Wish) -> None:
    """Shelves full of books; front +X."""
    x, half, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    spines: tuple[Color, ...] = (
        (0.42, 0.16, 0.14),
        (0.16, 0.24, 0.36),
        (0.2, 0.32, 0.22),
        (0.6, 0.52, 0.38),
        (0.3, 0.22, 0.18),
    )
    for y in (-half, half - 0.025):
        draw.box("varnished", (-x, y, 0), (x, y + 0.025, h), wish.color)
    draw.sheet("varnished", (-x + 0.01, -half, 0), (0, wish.width, 0), (0, 0, h), wish.color)
    levels = max(3, round(h / 0.36))
    for k in range(levels + 1):
        z = 0.06 + (h - 0.085) * k / levels
        draw.box("varnished", (-x, -half, z), (x, half, z + 0.022), wish.color, ALL_SIDES)
        if k == levels:
            break
        at = -half + 0.04
        room = (h - 0.085) / levels
        while at < half - 0.1:
            wide = float(draw.rng.uniform(0.08, 0.26))
            end = min(at + wide, half - 0.04)
            if draw.rng.random() < 0.85:
                tall = room * float(draw.rng.uniform(0.6, 0.86))
                low, high = (-0.6 * x, at, z + 0.022), (0.62 * x, end, z + tall)
                draw.box("paper", low, high, spines[int(draw.rng.integers(5))])
            at = end + 0.004
