"""Light vehicles, and what children and patients ride in; proxies as for cars."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored, shade, shift, spokes, wheel
from esg.assets.geometry.sketch import CHROME, DARK, RED, STEEL, WOOD, Color, Sketch
from esg.assets.lazy import shapes


@builder("wheelbarrow")
def wheelbarrow(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Garden wheelbarrow with the wheel in front (+X), on its legs; hollow."""
    wheel(s, 54, 0, 19, 8)
    for side in (-1, 1):
        s.pipe(
            1.8,
            [(54, side * 6, 19), (30, side * 16, 28), (-10, side * 26, 34), (-72, side * 30, 60)],
            DARK,
        )
        s.rod(2.4, (-58, side * 29, 54), (-76, side * 30.4, 61.6), RED, sections=14)
        s.pipe(
            1.8,
            [
                (-10, side * 26, 33),
                (-22, side * 24, 1.8),
                (-34, side * 25, 1.8),
                (-36, side * 27, 44),
            ],
            STEEL,
        )

    def tray() -> object:

        outer = [
            (x, y * w, z)
            for z, x0, x1, w in ((28, -22, 30, 20), (64, -44, 62, 34))
            for x in (x0, x1)
            for y in (-1, 1)
        ]
        inner = [
            (x, y * w, z)
            for z, x0, x1, w in ((30, -20, 28, 18.4), (65, -42.4, 60.4, 32.4))
            for x in (x0, x1)
            for y in (-1, 1)
        ]
        return shapes.cut(shapes.hull(outer), [shapes.hull(inner)])

    s.add(tray, c)
    s.proxy_slab((-24, 34), (-20, 20), (26, 30), 1.0)
    for side in (-1, 1):
        s.proxy_slab((-40, 58), mirrored(side, 29, 32), (30, 64), 0.6)
        s.proxy_slab((-36, -20), mirrored(side, 22, 28), (0, 30), 1.2)
    s.proxy_slab((48, 52), (-29, 29), (30, 64), 0.6)
    s.proxy_slab((-40, -36), (-29, 29), (30, 64), 0.6)
    s.proxy_slab((45, 64), (-5, 5), (0, 30), 1.6)
    s.region("inside", (-34, 46), (-27, 27), (30, 66))
    s.surface("tray", 30, (26, 17), (5, 0))
    shift(s, 1.5)


@builder("stroller")
def stroller(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "stroller") -> None:
    """Baby stroller, or a wheelchair with large rear wheels."""
    if kind == "wheelchair":
        for side in (-1, 1):
            s.torus(26, 0.9, (-18, side * 33, 31), CHROME, axis="y")
            spokes(s, -18, side * 30, 31)
            wheel(s, 36, side * 24, 9, 4)
            s.pipe(1.2, [(-26, side * 24, 20), (-26, side * 24, 92), (-40, side * 24, 92)], CHROME)
            s.pipe(
                1.2,
                [
                    (-26, side * 24, 72),
                    (14, side * 24, 72),
                    (16, side * 24, 20),
                    (36, side * 24, 16),
                ],
                CHROME,
            )
            s.slab((-22, 12), mirrored(side, 22, 27), (72, 75), DARK)
            s.pipe(1.2, [(16, side * 18, 46), (38, side * 16, 12), (48, side * 16, 8)], CHROME)
            s.slab((40, 54), mirrored(side, 4, 20), (6, 8), DARK)
        s.slab((-24, 18), (-23, 23), (46, 51), c)
        s.slab((-28, -24), (-23, 23), (50, 88), c)
        s.proxy_slab((-49, 44), (-31, 31), (0, 51), 1.0)
        s.proxy_slab((-30, -23), (-24, 24), (51, 92), 0.4)
        s.surface("seat", 51, (17, 20), (-2, 0))
        shift(s, -2.5)
        return
    for x, y, r in ((34, 22, 10), (-34, 24, 13)):
        for side in (-1, 1):
            wheel(s, x, side * y, r, 5)
    for side in (-1, 1):
        s.pipe(1.3, [(34, side * 20, 10), (-8, side * 21, 58), (-46, side * 21, 100)], STEEL)
        s.pipe(1.3, [(-34, side * 21, 13), (2, side * 21, 50), (14, side * 21, 60)], STEEL)
    s.rod(1.8, (-46, -22, 100), (-46, 22, 100), DARK)
    s.extrude(
        [(-22, 88), (-28, 86), (-10, 44), (24, 40), (40, 22), (44, 24), (28, 46), (-6, 52)],
        (-19, 19),
        c,
        soft=1,
    )
    arc = [
        (-18 + 36 * math.cos(math.radians(a)), 66 + 36 * math.sin(math.radians(a)))
        for a in range(35, 146, 10)
    ]
    inner = [
        (-18 + 33 * math.cos(math.radians(a)), 66 + 33 * math.sin(math.radians(a)))
        for a in range(145, 34, -10)
    ]
    s.extrude(arc + inner, (-20, 20), shade(c, 0.7))
    s.slab((-30, 20), (-17, 17), (18, 32), DARK)
    s.proxy_slab((-46, 43), (-26, 26), (0, 34), 1.0)
    s.proxy_slab((-26, 30), (-19, 19), (34, 52), 0.8)
    s.proxy_slab((-48, -4), (-20, 20), (52, 102), 0.3)
    shift(s, 1.5)


@builder("carriage")
def carriage(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Open horse carriage with shafts towards +X, 320 cm."""
    for side in (-1, 1):
        spokes(s, -62, side * 66, 48, WOOD)
        spokes(s, 56, side * 62, 36, WOOD)
        s.rod(2.4, (76, side * 32, 40), (176, side * 36, 52), WOOD, sections=12)
    s.rod(3, (-62, -66, 48), (-62, 66, 48), DARK)
    s.rod(3, (56, -62, 36), (56, 62, 36), DARK)
    s.extrude(
        [
            (-110, 66),
            (-120, 118),
            (-96, 118),
            (-84, 88),
            (-30, 84),
            (-14, 110),
            (0, 110),
            (-4, 52),
            (-90, 50),
        ],
        (-54, 54),
        c,
        soft=3,
        rough=0.3,
    )
    s.slab((0, 84), (-34, 34), (48, 56), shade(c, 0.7))
    s.slab((34, 70), (-34, 34), (84, 96), RED)
    s.slab((38, 66), (-30, 30), (56, 84), shade(c, 0.8))
    s.slab((-84, -34), (-46, 46), (84, 94), RED)
    arc = [
        (-84 + 62 * math.cos(math.radians(a)), 112 + 62 * math.sin(math.radians(a)))
        for a in range(60, 181, 12)
    ]
    inner = [
        (-84 + 58 * math.cos(math.radians(a)), 112 + 58 * math.sin(math.radians(a)))
        for a in range(180, 59, -12)
    ]
    s.extrude(arc + inner, (-55, 55), DARK)
    s.proxy_slab((-112, 94), (-70, 70), (0, 60), 1.0)
    s.proxy_slab((-116, -4), (-54, 54), (60, 94), 0.7)
    s.proxy_slab((34, 70), (-34, 34), (60, 96), 0.6)
    s.proxy_slab((-146, -92), (-54, 54), (94, 172), 0.15)
    s.proxy_slab((94, 176), (-38, 38), (40, 54), 0.1)
    s.surface("seat", 94, (26, 44), (-50, 0))
    shift(s, -15)
