"""Large structures: towers, bridges, fair rides, pavilions."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import LEAF, bone, mirrored, prism, shade, shift
from esg.assets.geometry.rotations import turn
from esg.assets.geometry.sketch import (
    BRICK_RED,
    CONCRETE,
    DARK,
    DARK_WOOD,
    PALE_WOOD,
    RED,
    STEEL,
    WHITE,
    WOOD,
    YELLOW,
    Color,
    Sketch,
    rgb,
)


@builder("jenga_tower")
def jenga_tower(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Stack of wooden blocks, twelve layers of three."""
    for k in range(12):
        for j in (-1, 0, 1):
            z = (k * 2.5, k * 2.5 + 2.44)
            across = (j * 4.2 - 2.05, j * 4.2 + 2.05)
            x, y = ((-6.25, 6.25), across) if k % 2 else (across, (-6.25, 6.25))
            s.slab(x, y, z, shade(c, 0.92 + 0.05 * ((k + j) % 3)))
    s.proxy_slab((-6.2, 6.2), (-6.2, 6.2), (0, 30))
    s.surface("top", 30, (5.5, 5.5))


@builder("lighthouse")
def lighthouse(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Lighthouse with two bands, 14 m."""
    s.lathe([(0, 0), (260, 0), (250, 60), (190, 1100), (0, 1100)], WHITE)
    for z0, z1 in ((200, 420), (640, 860)):
        r0, r1 = 250 - 60 * (z0 - 60) / 1040, 250 - 60 * (z1 - 60) / 1040
        s.lathe([(r0 - 8, z0), (r0 + 3, z0), (r1 + 3, z1), (r1 - 8, z1), (r0 - 8, z0)], c)
    s.rod(230, (0, 0, 1100), (0, 0, 1125), DARK)
    s.torus(222, 5, (0, 0, 1210), DARK)
    s.rod(120, (0, 0, 1125), (0, 0, 1290), (0.98, 0.92, 0.6), rough=0.05, alpha=0.6)
    s.lathe([(0, 1290), (150, 1290), (20, 1400), (0, 1420)], c)
    s.slab((230, 262), (-55, 55), (0, 210), DARK_WOOD)
    s.proxy_cylinder(255, (0, 400), 1.0)
    s.proxy_cylinder(215, (400, 1120), 1.0)
    s.proxy_cylinder(125, (1120, 1400), 0.3)


@builder("windmill")
def windmill(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Windmill with four sails towards +X."""
    s.lathe([(0, 0), (250, 0), (165, 640), (0, 640)], c, sections=8, rough=0.9)
    s.lathe([(0, 640), (180, 640), (120, 760), (0, 790)], DARK_WOOD, sections=8)
    s.rod(22, (120, 0, 690), (250, 0, 690), DARK)
    for k in range(4):
        a = math.radians(45 + 90 * k)
        u, n = (math.cos(a), math.sin(a)), (-math.sin(a), math.cos(a))
        s.rod(9, (238, 0, 690), (238, 420 * u[0], 690 + 420 * u[1]), DARK_WOOD, sections=10)
        prism(
            s,
            [
                (236 + d, r * u[0] + w * n[0], 690 + r * u[1] + w * n[1])
                for r in (90, 410)
                for w in (6, 92)
                for d in (0, 4)
            ],
            rgb(228, 220, 200),
        )
    s.slab((210, 252), (-50, 50), (0, 190), DARK_WOOD)
    s.proxy_cylinder(235, (0, 300), 1.0)
    s.proxy_cylinder(180, (300, 780), 1.0)
    s.proxy_slab((226, 250), (-300, 300), (400, 990), 0.02)


@builder("castle")
def castle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Castle with four towers and a keep."""
    for x in (-260, 260):
        for y in (-260, 260):
            s.rod(90, (x, y, 0), (x, y, 560), c, rough=0.95)
            for k in range(6):
                a = math.pi * k / 3
                s.box(
                    (34, 34, 60),
                    (x + 80 * math.cos(a), y + 80 * math.sin(a), 590),
                    shade(c, 0.9),
                )
            s.proxy_cylinder(90, (0, 620), 1.0, (x, y))
    for side in (-1, 1):
        s.slab((-260, 260), mirrored(side, 235, 285), (0, 400), c, rough=0.95)
        s.slab(mirrored(side, 235, 285), (-260, 260), (0, 400), c, rough=0.95)
        for k in range(5):
            t = -160 + 80 * k
            s.slab((t - 20, t + 20), mirrored(side, 236, 284), (400, 445), shade(c, 0.9))
            s.slab(mirrored(side, 236, 284), (t - 20, t + 20), (400, 445), shade(c, 0.9))
        s.proxy_slab((-260, 260), mirrored(side, 235, 285), (0, 400), 1.0)
        s.proxy_slab(mirrored(side, 235, 285), (-260, 260), (0, 400), 1.0)
    s.slab((284, 290), (-70, 70), (0, 200), DARK_WOOD)
    s.slab((-120, 120), (-120, 120), (0, 640), shade(c, 1.05))
    prism(
        s,
        [(x, y, 640) for x in (-140, 140) for y in (-140, 140)] + [(0, 0, 860)],
        rgb(150, 56, 44),
    )
    s.proxy_slab((-120, 120), (-120, 120), (0, 700), 1.0)


@builder("silo")
def silo(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Steel silo with a ladder."""
    s.rod(150, (0, 0, 0), (0, 0, 700), c, rough=0.4, sections=40)
    for z in range(60, 700, 70):
        s.torus(150, 4, (0, 0, z), shade(c, 0.8))
    s.lathe([(0, 700), (152, 700), (110, 790), (40, 830), (0, 835)], shade(c, 0.9), smooth=30)
    s.rod(4, (152, -20, 0), (152, -20, 700), STEEL, sections=10)
    s.rod(4, (152, 20, 0), (152, 20, 700), STEEL, sections=10)
    s.proxy_cylinder(150, (0, 700), 1.0)
    s.proxy_cylinder(100, (700, 820), 0.5)


@builder("well")
def well(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Stone well with a roof on posts."""
    for k in range(16):
        a = 2 * math.pi * k / 16
        for j in range(4):
            t = a + (math.pi / 16 if j % 2 else 0)
            s.box(
                (16, 21, 17),
                (54 * math.cos(t), 54 * math.sin(t), 9 + 18 * j),
                shade(c, 0.85 + 0.08 * ((k + j) % 3)),
                quat=turn("z", math.degrees(t)),
                rough=0.95,
            )
    s.rod(46, (0, 0, 0), (0, 0, 30), rgb(60, 90, 110), rough=0.05)
    for side in (-1, 1):
        s.slab((-5, 5), (side * 54 - 5, side * 54 + 5), (72, 190), WOOD)
    s.rod(5, (0, -54, 140), (0, 54, 140), WOOD, sections=16)
    s.extrude(
        [(-56, 176), (0, 224), (56, 176), (50, 176), (0, 216), (-50, 176)], (-74, 74), BRICK_RED
    )
    s.rod(0.8, (0, 0, 104), (0, 0, 138), PALE_WOOD, sections=8)
    s.lathe([(0, 84), (8, 84), (10, 104), (0, 104)], DARK_WOOD, sections=20)
    s.tub(62, (0, 72), 14)
    s.proxy_slab((-50, 50), (-74, 74), (178, 220), 0.1)
    for side in (-1, 1):
        s.proxy_slab((-5, 5), mirrored(side, 49, 59), (72, 178), 0.3)
    s.region("inside", (-32, 32), (-32, 32), (14, 72))


@builder("bridge")
def bridge(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Stone arch bridge along X with parapets; drawn 1200 x 400 x 260, deck at 180."""
    n = 20
    arch = [
        (420 * math.cos(math.pi * k / n), 150 * math.sin(math.pi * k / n)) for k in range(n + 1)
    ]
    outline = [(600, 0), (600, 60), (430, 180), (-430, 180), (-600, 60), (-600, 0), *arch[::-1]]
    s.extrude(outline, (-200, 200), c, rough=0.95)
    for side in (-1, 1):
        s.extrude(
            [
                (600, 60),
                (600, 120),
                (430, 240),
                (-430, 240),
                (-600, 120),
                (-600, 60),
                (-430, 180),
                (430, 180),
            ],
            mirrored(side, 180, 200),
            shade(c, 0.88),
            rough=0.95,
        )
    s.slab((-430, 430), (-178, 178), (180, 182), rgb(92, 92, 96))
    s.proxy_slab((-430, 430), (-200, 200), (150, 180), 1.0)
    for side in (-1, 1):
        s.proxy_hull(
            [
                (side * x, y, z)
                for y in (-200, 200)
                for x, z in ((600, 0), (600, 60), (430, 180), (420, 0), (400, 150))
            ]
        )
        s.proxy_slab((-430, 430), mirrored(side, 180, 200), (180, 240), 0.6)
    s.surface("deck", 180, (400, 170))


@builder("fair_ride")
def fair_ride(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "carousel") -> None:
    """Carousel or Ferris wheel (in the plane of X and Z)."""
    if kind == "carousel":
        s.rod(290, (0, 0, 0), (0, 0, 30), shade(c, 0.8), sections=32)
        s.rod(40, (0, 0, 30), (0, 0, 340), rgb(236, 214, 150))
        s.lathe([(0, 330), (300, 330), (300, 360), (60, 450), (0, 460)], c, sections=16)
        for k in range(8):
            a = 2 * math.pi * k / 8
            x, y = 210 * math.cos(a), 210 * math.sin(a)
            s.rod(3, (x, y, 30), (x, y, 335), YELLOW, sections=10)
            u = (-math.sin(a), math.cos(a))
            z = 110 + 20 * (k % 2)
            tone = (WHITE, rgb(120, 78, 52), rgb(70, 70, 80))[k % 3]
            bone(
                s,
                (x - 26 * u[0], y - 26 * u[1], z),
                17,
                (x + 24 * u[0], y + 24 * u[1], z + 4),
                18,
                tone,
            )
            bone(
                s,
                (x + 26 * u[0], y + 26 * u[1], z + 8),
                12,
                (x + 44 * u[0], y + 44 * u[1], z + 44),
                8,
                tone,
            )
            bone(
                s,
                (x + 44 * u[0], y + 44 * u[1], z + 44),
                9,
                (x + 62 * u[0], y + 62 * u[1], z + 34),
                6,
                tone,
            )
            for d in (-24, 22):
                s.rod(
                    5,
                    (x + d * u[0], y + d * u[1], z),
                    (x + (d + 6) * u[0], y + (d + 6) * u[1], z - 44),
                    tone,
                    sections=8,
                )
        s.proxy_cylinder(290, (0, 30), 1.0)
        s.proxy_cylinder(40, (30, 330), 0.5)
        s.proxy_cylinder(300, (330, 400), 0.2)
        s.proxy_cylinder(120, (400, 455), 0.1)
        return
    for y in (-40, 40):
        s.torus(560, 9, (0, y, 640), c, axis="y")
        for k in range(8):
            a = math.pi * k / 8
            s.rod(
                5,
                (-560 * math.cos(a), y, 640 - 560 * math.sin(a)),
                (560 * math.cos(a), y, 640 + 560 * math.sin(a)),
                WHITE,
                sections=8,
            )
        for x in (-280, 280):
            s.rod(14, (x, y * 2, 0), (0, y * 1.4, 640), STEEL, sections=14)
    s.rod(28, (0, -90, 640), (0, 90, 640), DARK)
    for k in range(12):
        a = 2 * math.pi * k / 12
        x, z = 560 * math.cos(a), 640 + 560 * math.sin(a)
        s.slab(
            (x - 32, x + 32), (-34, 34), (z - 70, z - 20), (RED, YELLOW, rgb(60, 130, 200))[k % 3]
        )
        s.slab((x - 36, x + 36), (-38, 38), (z + 6, z + 12), WHITE)
        s.rod(2, (x, 0, z - 20), (x, 0, z + 8), STEEL, sections=8)
    s.slab((-330, 330), (-120, 120), (0, 12), CONCRETE)
    s.proxy_slab((-330, 330), (-120, 120), (0, 12), 8.0)
    for x in (-1, 1):
        s.proxy_slab(mirrored(x, 120, 300), (-90, 90), (12, 70), 0.3)
    s.proxy_slab((-400, 400), (-50, 50), (70, 1000), 0.2)
    s.proxy_slab((-200, 200), (-50, 50), (1000, 1190), 0.1)


@builder("pavilion")
def pavilion(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "kiosk") -> None:
    """Market stall with an awning, towards +X; or a gym mat."""
    if kind == "mat":
        s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H), c, solid=1, rough=0.9)
        for x in (-1, 1):
            s.slab(
                (x * L * 0.25 - 1, x * L * 0.25 + 1),
                (-W / 2, W / 2),
                (H * 0.99, H * 1.0),
                shade(c, 0.7),
            )
        s.surface("top", H, (L / 2, W / 2))
        return
    s.slab((-70, 60), (-100, 100), (0, 96), c)
    s.slab((-70, 84), (-105, 105), (96, 102), WOOD)
    for x in (-66, 78):
        for y in (-100, 100):
            s.slab((x - 4, x + 4), (y - 4, y + 4), (0 if x < 0 else 102, 220), WOOD)
    for k in range(7):
        y = -119 + 34 * k
        prism(
            s,
            [(-80, yy, 236 + d) for yy in (y, y + 34) for d in (0, 4)]
            + [(110, yy, 200 + d) for yy in (y, y + 34) for d in (0, 4)],
            RED if k % 2 == 0 else WHITE,
        )
    for k in range(4):
        s.ball(9, (40, -60 + 40 * k, 111), (RED, YELLOW, LEAF, rgb(230, 120, 40))[k])
    s.proxy_slab((-70, 84), (-105, 105), (0, 102), 1.0)
    for y in (-1, 1):
        s.proxy_slab((-70, -62), mirrored(y, 96, 104), (102, 205), 0.3)
    s.proxy_slab((-80, 108), (-119, 119), (205, 238), 0.1)
    s.surface("counter", 102, (60, 90), (10, 0))
    shift(s, -15)
