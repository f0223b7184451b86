"""Trains, tractors and tracked work vehicles; proxies as for cars."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import bone, holes, mirrored, prism, shade, shift, wheel
from esg.assets.geometry.sketch import CHROME, DARK, GLASS, RED, STEEL, YELLOW, Color, Sketch

_LAMP = (0.98, 0.96, 0.86)


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
                holes(s, (x, side * (w * 0.72 + 6), r), r * 0.7, 12.6)
                s.wheel((x, side * (w * 0.72 + 6), r), r, parts=2)
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
            holes(s, (x, side * 3.6, r), r * 1.1, 1.3)
            s.wheel((x, side * 3.6, r), r, parts=3)
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
        wheel(s, -95, side * 78, 82, 44, YELLOW)
        wheel(s, 118, side * 76, 50, 30, YELLOW)
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
        wheel(s, 62, side * 46, 32, 24)
        wheel(s, -74, side * 42, 26, 20)
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
        holes(s, (px, y, r), r * 0.62, width * 1.09)
        s.wheel((px, y, r), r * 0.62, parts=2)


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
