"""Rail, farm and work vehicles, and what children and patients ride in; proxies as for cars."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import bone, mirrored, prism, shade, shift
from esg.assets.sketch import (
    CHROME,
    DARK,
    GLASS,
    RED,
    RUBBER,
    STEEL,
    WOOD,
    YELLOW,
    Color,
    Sketch,
)

_LAMP = (0.98, 0.96, 0.86)


def _wheel(s: Sketch, x: float, y: float, r: float, width: float, hub: Color = CHROME) -> None:
    """A wheel about Y whose middle is at `y`."""
    s.rod(r, (x, y - width / 2, r), (x, y + width / 2, r), RUBBER, rough=0.9, sections=32)
    s.rod(r * 0.58, (x, y - width * 0.55, r), (x, y + width * 0.55, r), hub, rough=0.4, metal=0.4)


def _spokes(s: Sketch, x: float, y: float, r: float, c: Color = CHROME) -> None:
    """A spoked wheel about Y."""
    s.torus(r - 0.06 * r, 0.06 * r, (x, y, r), RUBBER, axis="y", rough=0.9)
    s.rod(0.1 * r, (x, y - 0.1 * r, r), (x, y + 0.1 * r, r), STEEL, metal=0.6, sections=14)
    for k in range(6):
        a = math.pi * k / 6
        d = (0.9 * r * math.cos(a), 0.9 * r * math.sin(a))
        s.rod(0.025 * r, (x - d[0], y, r - d[1]), (x + d[0], y, r + d[1]), c, sections=6)


@builder("train")
def train(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "engine") -> None:
    """Diesel locomotive, 18 m, or a low-floor tram."""
    tram = kind == "tram"
    half, w, top = (750.0, 120.0, 330.0) if tram else (900.0, 140.0, 390.0)
    floor = 35.0 if tram else 110.0
    nose = 60.0 if tram else 110.0
    s.extrude(
        [
            (-half + nose * 0.5, floor),
            (half - 8, floor),
            (half, floor + 70),
            (half - nose, top - 20),
            (half - nose - 30, top - 12),
            (-half + nose, top - 12),
            (-half, floor + 70),
            (-half + 8, floor),
        ],
        (-w, w),
        c,
        soft=6,
        rough=0.3,
    )
    s.slab((-half + nose, half - nose - 30), (-w * 0.8, w * 0.8), (top - 12, top), shade(c, 0.6))
    s.slab((-half + 12, half - 12), (-w - 1, w + 1), (floor + 62, floor + 82), (0.92, 0.9, 0.84))
    band = (floor + 110, floor + 205)
    for side in (-1, 1):
        y = mirrored(side, w - 2, w + 1.5)
        count = 9 if tram else 6
        step = (2 * half - 2 * nose - 140) / count
        for k in range(count):
            x = -half + nose + 90 + k * step
            s.slab((x, x + step * 0.78), y, band, GLASS, rough=0.1)
        s.slab((half - nose - 56, half - nose - 26), y, (floor + 8, floor + 205), shade(c, 0.7))
    for end in (-1, 1):
        lo, hi = half - 4 - nose * 0.36, half - nose * 0.94
        prism(
            s,
            [(end * (lo + d), y, floor + 118) for d in (0, 5) for y in (-w * 0.8, w * 0.8)]
            + [(end * (hi + d), y, top - 48) for d in (0, 7) for y in (-w * 0.72, w * 0.72)],
            GLASS,
            rough=0.1,
        )
        for side in (-1, 1):
            s.rod(
                11,
                (end * (half - 12), side * w * 0.62, floor + 52),
                (end * (half - 2), side * w * 0.62, floor + 52),
                _LAMP,
            )
    r = 30.0 if tram else 46.0
    for bogie in (-0.62, 0.62):
        s.slab(
            (bogie * half - 150, bogie * half + 150),
            (-w * 0.72, w * 0.72),
            (r * 0.6, floor + 4),
            DARK,
        )
        for dx in (-95, 95):
            for side in (-1, 1):
                x = bogie * half + dx
                s.rod(
                    r, (x, side * (w * 0.72), r), (x, side * (w * 0.72 + 12), r), STEEL, metal=0.6
                )
    s.slab(
        (-0.3 * half, 0.3 * half), (-w * 0.7, w * 0.7), (30 if not tram else 20, floor + 4), DARK
    )
    s.proxy_slab((-half, half), (-w, w), (0, floor + 110), 1.0)
    s.proxy_slab((-half + nose * 0.7, half - nose * 0.7), (-w, w), (floor + 110, top), 0.3)
    s.surface("roof", top, (half * 0.8, w * 0.75))


@builder("toy_train")
def toy_train(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Toy steam engine, 22 cm long."""
    s.slab((-11, 10.5), (-3.6, 3.6), (1.8, 3.2), DARK)
    s.rod(2.9, (-3, 0, 6.1), (9.5, 0, 6.1), c, rough=0.35)
    s.rod(3.1, (9.5, 0, 6.1), (10.3, 0, 6.1), YELLOW)
    s.slab((-10.5, -3), (-3.5, 3.5), (3.2, 11), shade(c, 0.85))
    s.slab((-11, -2.2), (-4.1, 4.1), (11, 11.8), DARK)
    for side in (-1, 1):
        s.slab((-8.6, -5), mirrored(side, 3.4, 3.7), (7, 10), _LAMP)
        for x, r in ((-7, 2.8), (-0.5, 2.0), (4, 2.0), (8, 2.0)):
            s.rod(r, (x, side * 3.0, r), (x, side * 4.2, r), RED, sections=24)
            s.rod(r * 0.35, (x, side * 3.0, r), (x, side * 4.5, r), YELLOW, sections=14)
    s.lathe([(0, 8), (1.1, 8), (1.1, 10.6), (1.8, 12.6), (0, 12.6)], DARK, center=(7.2, 0, 0))
    s.ball(1.3, (2.4, 0, 9), YELLOW)
    s.extrude([(10.3, 0.4), (13, 0.4), (10.3, 3)], (-3.2, 3.2), shade(c, 0.6))
    s.proxy_slab((-11, 11), (-4.2, 4.2), (0, 3.2), 1.0)
    s.proxy_slab((-3, 10), (-2.8, 2.8), (3.2, 9), 0.8)
    s.proxy_slab((-10.8, -2.4), (-3.8, 3.8), (3.2, 11.8), 0.6)
    s.surface("roof", 11.8, (3.4, 3), (-6.6, 0))
    shift(s, -1)


@builder("tractor")
def tractor(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Farm tractor, 4 m long, large wheels behind."""
    for side in (-1, 1):
        _wheel(s, -95, side * 78, 82, 44, YELLOW)
        _wheel(s, 118, side * 76, 50, 30, YELLOW)
        s.slab((-178, -28), mirrored(side, 56, 96), (166, 172), c)
    s.slab((-120, 150), (-26, 26), (56, 98), DARK)
    s.extrude(
        [(-20, 96), (176, 92), (186, 120), (174, 148), (-20, 158)], (-34, 34), c, soft=5, rough=0.3
    )
    s.slab((174, 190), (-28, 28), (92, 138), DARK)
    s.slab((-110, -14), (-54, 54), (98, 160), shade(c, 0.8))
    s.slab((-106, -18), (-52, 52), (160, 244), GLASS, alpha=0.6, rough=0.1)
    s.slab((-118, -6), (-60, 60), (244, 256), c)
    for x in (-106, -18):
        for y in (-52, 52):
            s.slab((x - 3, x + 3), (y - 3, y + 3), (160, 244), DARK)
    s.rod(4, (60, 26, 150), (60, 26, 236), DARK, sections=16)
    s.proxy_slab((-176, -14), (-98, 98), (0, 160), 0.9)
    s.proxy_slab((-14, 190), (-40, 40), (40, 155), 1.0)
    s.proxy_slab((68, 168), (-91, 91), (0, 92), 0.6)
    s.proxy_slab((-116, -8), (-58, 58), (160, 256), 0.2)
    s.surface("roof", 256, (44, 46), (-62, 0))
    shift(s, -6)


@builder("forklift")
def forklift(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Counterbalance forklift, 3.4 m over the forks."""
    for side in (-1, 1):
        _wheel(s, 62, side * 46, 32, 24)
        _wheel(s, -74, side * 42, 26, 20)
        s.slab((96, 214), mirrored(side, 16, 30), (6, 11), STEEL, metal=0.7)
        s.slab((90, 102), mirrored(side, 24, 34), (4, 205), DARK)
        for x in (-70, 56):
            s.rod(4, (x, side * 48, 100), (x * 0.86, side * 46, 206), DARK, sections=12)
    s.extrude(
        [(-118, 34), (-104, 108), (-30, 112), (-24, 62), (70, 62), (82, 34)], (-52, 52), c, soft=4
    )
    s.slab((-96, -34), (-40, 40), (34, 118), shade(c, 0.6))
    s.slab((98, 106), (-46, 46), (20, 64), DARK)
    s.slab((-66, 56), (-52, 52), (204, 211), DARK)
    s.slab((-34, 6), (-24, 24), (84, 96), DARK)
    s.slab((-40, -30), (-24, 24), (96, 140), DARK)
    s.rod(2, (50, 0, 70), (34, 0, 118), DARK, sections=12)
    s.torus(16, 1.6, (32, 0, 120), DARK)
    s.proxy_slab((-118, 90), (-56, 56), (0, 112), 1.0)
    s.proxy_slab((-66, 56), (-52, 52), (112, 211), 0.06)
    s.proxy_slab((90, 106), (-46, 46), (4, 205), 0.3)
    for side in (-1, 1):
        s.proxy_slab((106, 214), mirrored(side, 16, 30), (0, 11), 0.6)
    s.surface("forks", 11, (48, 30), (162, 0))
    shift(s, -48)


def _track(s: Sketch, x: tuple[float, float], y: float, r: float, width: float) -> None:
    lo, hi = x
    s.extrude(
        [(lo, r * 2)]
        + [
            (lo - r * math.sin(math.pi * k / 8), r + r * math.cos(math.pi * k / 8))
            for k in range(1, 8)
        ]
        + [(lo, 0), (hi, 0)]
        + [
            (hi + r * math.sin(math.pi * k / 8), r - r * math.cos(math.pi * k / 8))
            for k in range(1, 8)
        ]
        + [(hi, r * 2)],
        (y - width / 2, y + width / 2),
        DARK,
        rough=0.9,
    )
    n = 5
    for k in range(n):
        px = lo + (hi - lo) * k / (n - 1)
        s.rod(r * 0.62, (px, y - width * 0.54, r), (px, y + width * 0.54, r), STEEL, metal=0.4)


@builder("tracked")
def tracked(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "tank") -> None:
    """Battle tank, excavator or bulldozer on tracks."""
    if kind == "tank":
        for side in (-1, 1):
            _track(s, (-270, 250), side * 146, 45, 56)
        s.extrude(
            [(-320, 70), (-310, 128), (250, 128), (330, 96), (290, 62)], (-160, 160), c, soft=4
        )
        prism(
            s,
            [(x, y, 128) for x in (-130, 140) for y in (-112, 112)]
            + [(x, y, 205) for x in (-110, 70) for y in (-84, 84)],
            c,
        )
        s.rod(9, (90, 0, 168), (470, 0, 174), shade(c, 0.85), sections=20)
        s.rod(13, (430, 0, 173.4), (470, 0, 174), shade(c, 0.7), sections=20)
        s.rod(30, (-30, 30, 204), (-30, 30, 222), shade(c, 0.8), sections=24)
        s.proxy_slab((-315, 300), (-174, 174), (0, 128), 1.0)
        s.proxy_slab((-120, 110), (-100, 100), (128, 205), 0.7)
        s.proxy_slab((90, 470), (-11, 11), (160, 182), 0.4)
        s.surface("turret", 205, (70, 60), (-20, 0))
        shift(s, -72)
        return
    for side in (-1, 1):
        _track(s, (-140, 140), side * 102, 42, 52)
    s.slab((-110, 110), (-80, 80), (50, 90), DARK)
    if kind == "bulldozer":
        s.extrude([(-150, 88), (-150, 170), (10, 170), (150, 158), (158, 88)], (-72, 72), c, soft=4)
        s.slab((-120, -10), (-62, 62), (170, 272), GLASS, rough=0.1)
        s.slab((-130, 0), (-70, 70), (272, 286), c)
        for x in (-120, -10):
            for y in (-62, 62):
                s.slab((x - 5, x + 5), (y - 5, y + 5), (170, 272), c)
        s.rod(6, (90, 30, 150), (90, 30, 230), DARK, sections=14)
        arc = [(214 + 20 * math.cos(a), 65 - 65 * math.sin(a)) for a in (-1.5, -0.8, 0.0, 0.8, 1.5)]
        s.extrude(
            [(p[0] - 10, max(p[1], 0)) for p in arc]
            + [(p[0] + 4, max(p[1], 0)) for p in arc[::-1]],
            (-150, 150),
            YELLOW,
        )
        for side in (-1, 1):
            bone(s, (0, side * 132, 44), 8, (206, side * 132, 50), 8, shade(c, 0.8))
        s.proxy_slab((-182, 182), (-128, 128), (0, 88), 1.0)
        s.proxy_slab((-150, 155), (-72, 72), (88, 170), 0.8)
        s.proxy_slab((-125, -5), (-66, 66), (170, 286), 0.12)
        s.proxy_slab((196, 232), (-150, 150), (0, 128), 0.6)
        s.surface("roof", 286, (50, 50), (-65, 0))
        shift(s, -27)
        return
    s.slab((-170, 70), (-110, 110), (92, 190), c, rough=0.4)
    s.slab((-10, 84), (8, 108), (110, 270), GLASS, rough=0.1)
    s.slab((-14, 88), (4, 112), (270, 280), c)
    elbow, wrist = (330.0, -30.0, 330.0), (420.0, -30.0, 150.0)
    bone(s, (60, -30, 160), 22, (230, -30, 370), 20, c)
    bone(s, (230, -30, 370), 20, elbow, 15, c)
    bone(s, elbow, 15, wrist, 12, c)
    s.rod(6, (90, -30, 150), (210, -30, 300), CHROME, sections=14, metal=0.8)
    s.extrude(
        [(424, 158), (438, 96), (400, 50), (356, 44), (372, 80), (398, 100), (404, 150)],
        (-76, 16),
        DARK,
        rough=0.7,
    )
    s.proxy_slab((-182, 182), (-128, 128), (0, 92), 1.0)
    s.proxy_slab((-170, 84), (-110, 110), (92, 190), 1.0)
    s.proxy_slab((-10, 84), (8, 108), (190, 280), 0.1)
    s.proxy_slab((100, 330), (-50, -10), (240, 390), 0.15)
    s.proxy_slab((356, 438), (-76, 16), (44, 158), 0.15)
    shift(s, -128)


@builder("go_kart")
def go_kart(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Racing kart, 180 cm."""
    for x, r, y in ((60, 13, 54), (-58, 14, 56)):
        for side in (-1, 1):
            _wheel(s, x, side * y, r, 18)
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
        _wheel(s, -10, side * 94, 33, 20)
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
    _wheel(s, 54, 0, 19, 8)
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
        from esg.assets.lazy import shapes

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
            _spokes(s, -18, side * 30, 31)
            s.torus(26, 0.9, (-18, side * 33, 31), CHROME, axis="y")
            _wheel(s, 36, side * 24, 9, 4)
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
            _wheel(s, x, side * y, r, 5)
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
    _spokes(s, 26, 0, 16)
    for side in (-1, 1):
        _wheel(s, -28, side * 20, 11, 5)
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
        _spokes(s, -62, side * 66, 48, WOOD)
        _spokes(s, 56, side * 62, 36, WOOD)
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
        _wheel(s, 0, side * 28, 22, 9)
    s.slab((-18, 18), (-23, 23), (14, 22), c)
    s.slab((-3, 3), (-3, 3), (0, 14), DARK)
    s.rod(2, (12, 0, 20), (8, 0, 108), STEEL, sections=14, metal=0.6)
    s.rod(1.8, (8, -24, 108), (8, 24, 108), DARK, sections=12)
    s.proxy_slab((-21, 21), (-32, 32), (0, 22), 1.0)
    s.proxy_slab((6, 14), (-4, 4), (22, 106), 0.2)
    s.proxy_slab((5, 11), (-24, 24), (106, 110), 0.2)
    s.surface("deck", 22, (12, 20), (-6, 0))
