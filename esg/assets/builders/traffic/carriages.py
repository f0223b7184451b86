"""Light vehicles, and what children and patients ride in; proxies as for cars."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored, prism, shade, shift, spokes, wheel
from esg.assets.geometry.sketch import CHROME, DARK, GLASS, RED, STEEL, WOOD, Color, Sketch
from esg.assets.lazy import shapes


@builder("go_kart")
def go_kart(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Racing kart, 180 cm."""
    for x, r, y in ((60, 13, 54), (-58, 14, 56)):
        for side in (-1, 1):
            wheel(s, x, side * y, r, 18)
    s.slab((-80, 70), (-34, 34), (6, 10), DARK)
    s.extrude([(52, 6), (92, 6), (90, 22), (62, 34), (50, 20)], (-44, 44), c, soft=2)
    for side in (-1, 1):
        s.slab((-38, 40), mirrored(side, 36, 60), (6, 24), c)
    s.extrude(
        [(-40, 10), (-8, 10), (-6, 16), (-30, 20), (-42, 56), (-50, 54)], (-19, 19), DARK, soft=1
    )
    s.slab((-84, -52), (8, 36), (10, 38), STEEL)
    s.rod(1.6, (48, 0, 12), (26, 0, 44), STEEL, sections=12)
    s.torus(13, 1.4, (24, 0, 46), DARK)
    s.slab((-92, -84), (-60, 60), (6, 22), DARK)
    s.proxy_slab((-92, 92), (-62, 62), (0, 24), 1.0)
    s.proxy_slab((-50, -6), (-19, 19), (24, 56), 0.2)
    s.surface("seat", 24, (16, 16), (10, 0))


@builder("trailer")
def trailer(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Caravan with a drawbar towards +X, 4.8 m."""
    s.extrude(
        [(-200, 40), (-206, 130), (-180, 225), (120, 232), (178, 200), (190, 100), (180, 40)],
        (-105, 105),
        c,
        soft=14,
        rough=0.35,
    )
    s.slab((-204, 188), (-106, 106), (88, 104), RED)
    for side in (-1, 1):
        y = mirrored(side, 104, 106)
        s.slab((-150, -60), y, (120, 180), GLASS, rough=0.1)
        s.slab((30, 120), y, (120, 180), GLASS, rough=0.1)
        wheel(s, -10, side * 94, 33, 20)
    s.slab((-52, 12), (105, 107), (50, 200), shade(c, 0.85))
    prism(
        s,
        [
            (180, -40, 40),
            (180, 40, 40),
            (180, -40, 48),
            (180, 40, 48),
            (262, -4, 44),
            (262, 4, 44),
            (262, -4, 50),
            (262, 4, 50),
        ],
        DARK,
    )
    s.rod(4, (240, 0, 0), (240, 0, 60), STEEL, sections=14)
    s.proxy_slab((-204, 188), (-105, 105), (0, 120), 1.0)
    s.proxy_slab((-190, 170), (-105, 105), (120, 231), 0.4)
    s.proxy_slab((188, 262), (-6, 6), (0, 56), 0.4)
    s.surface("roof", 231, (130, 80), (-20, 0))
    shift(s, -28)


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

    s.add(tray, c, 0.5, 0.2)
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
            spokes(s, -18, side * 30, 31)
            s.torus(26, 0.9, (-18, side * 33, 31), CHROME, axis="y")
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


@builder("tricycle")
def tricycle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Child's tricycle, 80 cm."""
    spokes(s, 26, 0, 16)
    for side in (-1, 1):
        wheel(s, -28, side * 20, 11, 5)
        s.rod(1.6, (22, side * 15, 56), (18, side * 20, 57), DARK, sections=12)
        s.slab((22, 30), mirrored(side, 6, 14), (14, 17), RED)
    s.rod(1.6, (26, 0, 16), (22, 0, 56), c, sections=14)
    s.rod(1.4, (22, -18, 56), (22, 18, 56), CHROME, sections=12)
    s.pipe(2.0, [(23, 0, 44), (-6, 0, 26), (-28, 0, 12)], c)
    s.rod(1.4, (-28, -20, 11), (-28, 20, 11), STEEL, sections=12)
    s.rod(1.6, (-12, 0, 24), (-12, 0, 36), STEEL, sections=12)
    s.extrude(
        [(2, -4), (2, 4), (-16, 10), (-22, 8), (-22, -8), (-16, -10)],
        (35, 39),
        DARK,
        plane="xy",
        soft=1,
    )
    s.proxy_slab((-39, 42), (-21, 21), (0, 28), 1.0)
    s.proxy_slab((-22, 2), (-9, 9), (28, 39), 0.4)
    s.proxy_slab((16, 28), (-18, 18), (28, 58), 0.3)
    s.surface("seat", 39, (9, 7), (-10, 0))
    shift(s, -1.5)


@builder("sled")
def sled(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "sled") -> None:
    """Wooden sled with upturned runners, or a snowmobile."""
    if kind == "snowmobile":
        for side in (-1, 1):
            s.extrude(
                [(30, 0), (120, 0), (146, 16), (140, 18), (116, 5), (30, 5)],
                mirrored(side, 38, 54),
                DARK,
            )
            s.rod(3, (84, side * 44, 5), (62, side * 24, 36), STEEL, sections=12)
        s.extrude(
            [(-140, 8), (-128, 0), (20, 0), (34, 22), (-130, 30), (-142, 18)], (-22, 22), DARK
        )
        s.extrude(
            [(-10, 28), (118, 30), (128, 44), (60, 76), (20, 84), (-10, 66)],
            (-40, 40),
            c,
            soft=6,
            rough=0.3,
        )
        s.extrude([(-136, 34), (-10, 34), (-6, 58), (-60, 64), (-136, 66)], (-18, 18), DARK, soft=4)
        s.extrude([(56, 76), (26, 118), (22, 116), (48, 76)], (-26, 26), GLASS, rough=0.1)
        s.rod(2, (12, -34, 92), (12, 34, 92), DARK, sections=12)
        s.rod(3, (24, 0, 70), (12, 0, 92), DARK, sections=12)
        s.proxy_slab((-140, 20), (-22, 22), (0, 34), 1.0)
        s.proxy_slab((20, 140), (-54, 54), (0, 30), 0.6)
        s.proxy_slab((-136, 120), (-34, 34), (34, 66), 0.7)
        s.proxy_slab((0, 50), (-32, 32), (66, 112), 0.1)
        s.surface("seat", 66, (50, 16), (-70, 0))
        shift(s, -2)
        return
    for side in (-1, 1):
        s.extrude(
            [(-58, 0), (40, 0), (56, 12), (56, 24), (52, 24), (51, 14), (38, 4), (-58, 4)],
            mirrored(side, 18, 21),
            STEEL,
        )
        for x in (-44, -4, 34):
            s.slab((x - 2, x + 2), mirrored(side, 18, 21), (4, 19), WOOD)
    for y in (-19, -9.5, 0, 9.5, 19):
        s.slab((-60, 48), (y - 3.4, y + 3.4), (20, 22), c)
    for x in (-44, -4, 34):
        s.slab((x - 3, x + 3), (-21, 21), (18, 20), shade(c, 0.8))
    s.rod(1.4, (54, -21, 23), (54, 21, 23), c, sections=12)
    for side in (-1, 1):
        s.proxy_slab((-58, 46), mirrored(side, 18, 21), (0, 18), 1.0)
    s.proxy_slab((-60, 50), (-22.4, 22.4), (18, 22), 1.2)
    s.surface("deck", 22, (50, 20), (-5, 0))
    shift(s, 2)


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


@builder("segway")
def segway(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two-wheeled self-balancing rider, on its stand."""
    for side in (-1, 1):
        wheel(s, 0, side * 28, 22, 9)
    s.slab((-18, 18), (-23, 23), (14, 22), c)
    s.slab((-3, 3), (-3, 3), (0, 14), DARK)
    s.rod(2, (12, 0, 20), (8, 0, 108), STEEL, sections=14, metal=0.6)
    s.rod(1.8, (8, -24, 108), (8, 24, 108), DARK, sections=12)
    s.proxy_slab((-21, 21), (-32, 32), (0, 22), 1.0)
    s.proxy_slab((6, 14), (-4, 4), (22, 106), 0.2)
    s.proxy_slab((5, 11), (-24, 24), (106, 110), 0.2)
    s.surface("deck", 22, (12, 20), (-6, 0))
