"""What flies: aeroplanes, helicopters, rockets, balloons. Nose towards +X."""

from __future__ import annotations

import itertools
import math

from esg.assets.builders import builder
from esg.assets.builders.common import blob, bone, mirrored, prism, shade, shift
from esg.assets.geometry.sketch import (
    DARK,
    GLASS,
    RED,
    RUBBER,
    STEEL,
    WOOD,
    YELLOW,
    Color,
    Sketch,
    rgb,
)
from esg.graph.models import ProxyKind


def _wing(
    s: Sketch,
    root: tuple[float, float],
    tip: tuple[float, float],
    y: tuple[float, float],
    z: tuple[float, float],
    thick: float,
    c: Color,
) -> None:
    """A wing half between root and tip chords (x pairs) at two distances across."""
    points = [
        (x, yy, zz + d)
        for chord, yy, zz, t in ((root, y[0], z[0], thick), (tip, y[1], z[1], thick * 0.6))
        for x in chord
        for d in (-t / 2, t / 2)
    ]
    prism(s, points, c, rough=0.35)


@builder("airliner")
def airliner(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Twin-engine airliner, 38 m."""
    body = [
        (0, -1900),
        (60, -1850),
        (150, -1400),
        (195, -900),
        (200, 1400),
        (180, 1650),
        (110, 1820),
        (0, 1900),
    ]
    s.lathe(body, c, center=(0, 0, 420), axis="x", smooth=60, rough=0.3)
    for side in (-1, 1):
        _wing(
            s,
            (-200, 480),
            (-560, -330),
            (side * 150, side * 1700),
            (370, 470),
            60,
            shade(c, 0.85),
        )
        _wing(
            s,
            (-1780, -1420),
            (-1860, -1690),
            (side * 60, side * 620),
            (500, 540),
            30,
            shade(c, 0.85),
        )
        s.lathe(
            [(0, -190), (60, -180), (105, 0), (108, 150), (90, 170), (0, 160)],
            STEEL,
            center=(300, side * 580, 250),
            axis="x",
        )
        for k in range(22):
            x = -1150 + 110 * k
            s.slab((x, x + 34), mirrored(side, 192, 200.5), (460, 505), GLASS)
        s.rod(60, (-120, side * 260, 60), (-120, side * 320, 60), RUBBER, sections=28)
        s.wheel((-120, side * 290, 60), 60)
        s.rod(18, (-120, side * 290, 60), (-60, side * 290, 330), STEEL, sections=14)
    s.extrude(
        [(-1400, 560), (-1880, 1180), (-1680, 1180), (-1240, 590)], (-14, 14), rgb(40, 78, 150)
    )
    s.rod(45, (1450, -30, 45), (1450, 30, 45), RUBBER, sections=28)
    s.wheel((1450, 0, 45), 45)
    s.rod(14, (1450, 0, 45), (1450, 0, 260), STEEL, sections=14)
    s.extrude([(1700, 470), (1812, 440), (1760, 505), (1690, 530)], (-110, 110), GLASS)
    s.proxy_slab((-160, 1500), (-120, 120), (0, 220), 1.0)
    s.proxy_slab((-1800, 1800), (-195, 195), (220, 620), 1.0)
    s.proxy_slab((-420, 300), (-1650, 1650), (360, 440), 0.4)
    s.proxy_slab((-1860, -1400), (-40, 40), (620, 1170), 0.2)


@builder("airplane")
def airplane(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """High-wing light aircraft on three wheels, 8.3 m."""
    body = [
        (0, -430),
        (10, -420),
        (34, -260),
        (58, -90),
        (62, 40),
        (56, 180),
        (48, 320),
        (34, 352),
        (0, 360),
    ]
    s.lathe(body, c, center=(0, 0, 128), axis="x", smooth=50, rough=0.3)
    blob(s, [((100, 0, 178), 44), ((-40, 0, 176), 44), ((-150, 0, 150), 26)], GLASS, rough=0.1)
    for side in (-1, 1):
        _wing(s, (-40, 115), (-20, 95), (0, side * 545), (222, 238), 17, c)
        _wing(s, (-418, -330), (-412, -350), (0, side * 165), (146, 150), 9, c)
        s.rod(3, (50, side * 50, 110), (52, side * 260, 222), STEEL, sections=10)
        s.rod(20, (-10, side * 112, 20), (-10, side * 126, 20), RUBBER, sections=28)
        s.wheel((-10, side * 119, 20), 20)
        s.rod(4, (-10, side * 112, 22), (0, side * 34, 84), c, sections=12)
    s.extrude([(-340, 150), (-398, 268), (-434, 268), (-430, 140)], (-5, 5), RED)
    s.rod(17, (250, -6, 17), (250, 6, 17), RUBBER, sections=28)
    s.wheel((250, 0, 17), 17)
    s.rod(4, (250, 0, 17), (250, 0, 96), STEEL, sections=12)
    s.lathe([(0, 352), (15, 352), (8, 384), (0, 390)], DARK, center=(0, 0, 128), axis="x")
    for side in (-1, 1):
        s.box((5, 12, 88), (374, 0, 128 + side * 50), DARK)
    s.proxy_slab((-60, 270), (-120, 120), (0, 66), 1.0)
    s.proxy_slab((-420, 360), (-52, 52), (66, 190), 1.0)
    s.proxy_slab((-40, 110), (-540, 540), (216, 242), 0.4)
    s.proxy_slab((-40, 100), (-44, 44), (190, 216), 0.4)
    s.proxy_slab((-430, -330), (-165, 165), (142, 154), 0.3)
    s.proxy_slab((-432, -360), (-6, 6), (154, 266), 0.2)
    shift(s, 22)


@builder("toy_plane")
def toy_plane(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "model") -> None:
    """Folded paper plane, 24 cm, or a balsa glider."""
    if kind == "paper":
        for side in (-1, 1):
            prism(
                s,
                [
                    (12, 0, 3.0),
                    (12, 0, 3.2),
                    (-12, side * 0.4, 3.0),
                    (-12, side * 0.4, 3.2),
                    (-12, side * 7.5, 4.2),
                    (-12, side * 7.5, 4.4),
                ],
                c,
                rough=0.9,
            )
            prism(
                s,
                [
                    (12, 0, 3),
                    (12, side * 0.3, 3),
                    (-12, side * 0.4, 3.1),
                    (-12, side * 0.7, 3.1),
                    (-11, 0, 0),
                    (-11, side * 0.2, 0),
                    (4, 0, 0.6),
                    (4, side * 0.2, 0.6),
                ],
                c,
                rough=0.9,
            )
        s.proxy_hull(
            [
                (12, 0, 3),
                (-12, -7.5, 4.2),
                (-12, 7.5, 4.2),
                (-11, -1.2, 0),
                (-11, 1.2, 0),
                (4, -1.2, 0),
                (4, 1.2, 0),
                (-12, 0, 4.4),
            ]
        )
        return
    s.slab((-16, 14), (-0.6, 0.6), (1.6, 3.2), c)
    s.box((3, 1.6, 2.4), (14.4, 0, 2.2), DARK)
    for side in (-1, 1):
        _wing(s, (-2, 7), (0, 5), (0, side * 20), (3.6, 5.4), 0.5, c)
        _wing(s, (-16, -12), (-15.6, -13), (0, side * 7), (3.2, 3.4), 0.4, c)
    s.extrude([(-12, 3), (-15, 7), (-16.6, 7), (-16, 3)], (-0.2, 0.2), RED)
    s.rod(1.2, (3, -2.5, 1.2), (3, 2.5, 1.2), RUBBER, sections=16)
    s.rod(0.3, (3, 0, 1.2), (3, 0, 2.4), STEEL, sections=8)
    s.slab((-15.6, -15), (-0.3, 0.3), (0, 1.8), STEEL)
    s.proxy_slab((-16, 15), (-2.4, 2.4), (0, 3.4), 1.0)
    s.proxy_slab((-1, 6), (-19, 19), (3.4, 5.2), 0.4)
    s.proxy_slab((-16.4, -13), (-0.4, 0.4), (3.4, 7), 0.3)
    shift(s, 0.5)


@builder("helicopter")
def helicopter(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Light helicopter on skids; rotor 9 m."""
    blob(s, [((70, 0, 130), 66), ((-60, 0, 140), 62), ((120, 0, 112), 46)], c, rough=0.3, detail=3)
    blob(s, [((112, 0, 132), 54), ((80, 0, 150), 54)], GLASS, rough=0.08, detail=3)
    bone(s, (-100, 0, 160), 28, (-500, 0, 200), 9, c)
    s.extrude([(-470, 190), (-530, 280), (-556, 280), (-520, 150)], (-5, 5), c)
    s.slab((-470, -430), (-70, 70), (196, 202), c)
    s.rod(9, (-20, 0, 195), (-20, 0, 262), DARK, sections=20)
    for side in (-1, 1):
        s.box((450, 16, 4), (-20 + side * 225, 0, 262), DARK)
        s.box((16, 450, 4), (-20, side * 225, 266), DARK)
        s.pipe(4.5, [(-140, side * 92, 4.5), (130, side * 92, 4.5), (154, side * 92, 18)], STEEL)
        for x in (-70, 80):
            s.rod(4, (x, side * 92, 5), (x, side * 44, 86), STEEL, sections=12)
    s.rod(62, (-528, 12, 205), (-528, 15, 205), shade(STEEL, 0.8), alpha=0.5)
    for side in (-1, 1):
        s.proxy_slab((-140, 150), mirrored(side, 86, 98), (0, 16), 3.0)
    s.proxy_slab((-140, 150), (-62, 62), (16, 200), 1.0)
    s.proxy_slab((-520, -140), (-14, 14), (150, 205), 0.3)
    s.proxy_slab((-540, -480), (-10, 10), (205, 278), 0.2)
    s.proxy_cylinder(225, (260, 268), 0.02, (-20, 0))
    s.proxy_cylinder(9, (200, 260), 0.5, (-20, 0))
    shift(s, 80)


@builder("drone")
def drone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Quadcopter with a camera, 42 cm over the rotors."""
    blob(s, [((5, 0, 8), 3.2), ((-6, 0, 8), 3.4)], c, rough=0.3)
    s.slab((-9, 8), (-4.4, 4.4), (6.6, 9.4), c, rough=0.3)
    s.ball(1.7, (8.4, 0, 5.6), DARK, rough=0.1)
    for x in (-13, 13):
        for y in (-13, 13):
            s.rod(1.0, (x * 0.3, y * 0.25, 8), (x, y, 9.4), c, sections=12)
            s.rod(1.5, (x, y, 7.6), (x, y, 11.2), DARK, sections=16)
            s.rod(8, (x, y, 11.2), (x, y, 11.5), shade(STEEL, 0.8), alpha=0.4)
            a = math.radians(35 if x * y > 0 else -35)
            s.rod(
                0.45,
                (x - 7.8 * math.cos(a), y - 7.8 * math.sin(a), 11.7),
                (x + 7.8 * math.cos(a), y + 7.8 * math.sin(a), 11.7),
                DARK,
                sections=8,
            )
    for y in (-7, 7):
        s.pipe(0.5, [(-7, y, 0.5), (7, y, 0.5)], DARK)
        for x in (-5, 5):
            s.rod(0.5, (x, y, 0.5), (x * 0.8, y * 0.5, 7), DARK, sections=8)
    s.proxy_slab((-7.5, 7.5), (-7.5, 7.5), (0, 5), 0.5)
    s.proxy_slab((-10, 10), (-5, 5), (5, 11), 1.5)
    for x in (-13, 13):
        for y in (-13, 13):
            s.proxy_cylinder(8, (9, 12), 0.15, (x, y))


@builder("rocket")
def rocket(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Standing rocket with fins, drawn 200 cm tall; it points up."""
    s.lathe([(0, 18), (17, 18), (20, 60), (20, 130), (13, 172), (0, 200)], c, smooth=60, rough=0.3)
    s.lathe([(20.2, 122), (20.4, 122), (19, 138), (18.8, 138), (20.2, 122)], RED)
    s.lathe([(0, 4), (13, 4), (9, 18), (0, 18)], DARK)
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        u = (math.cos(a), math.sin(a))
        n = (-u[1], u[0])
        prism(
            s,
            [
                (u[0] * r + n[0] * t, u[1] * r + n[1] * t, z)
                for r, z in ((15, 70), (15, 22), (38, 0), (38, 22))
                for t in (-1.2, 1.2)
            ],
            RED,
        )
    s.rod(7, (19, 0, 104), (20.8, 0, 104), GLASS, rough=0.1)
    s.torus(7.4, 1.2, (20.2, 0, 104), STEEL, axis="x")
    s.proxy_slab((-26, 26), (-26, 26), (0, 22), 1.0)
    s.proxy_cylinder(20, (22, 138), 1.0)
    s.proxy_cylinder(12, (138, 188), 0.6)


@builder("missile")
def missile(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Missile or torpedo lying along +X, 180 cm."""
    s.lathe(
        [(0, -88), (9, -88), (11, -78), (11, 60), (8, 78), (0, 92)],
        c,
        center=(0, 0, 14),
        axis="x",
        smooth=50,
        rough=0.3,
    )
    s.lathe(
        [(11.1, 46), (11.3, 46), (11.3, 52), (11.1, 52), (11.1, 46)],
        RED,
        center=(0, 0, 14),
        axis="x",
    )
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        u = (math.cos(a), math.sin(a))
        prism(
            s,
            [
                (x, u[0] * r - u[1] * t, 14 + u[1] * r + u[0] * t)
                for x, r in ((-86, 8), (-60, 8), (-90, 19), (-78, 19))
                for t in (-0.6, 0.6)
            ],
            DARK,
        )
    s.proxy_slab((-88, 74), (-10, 10), (0, 25))
    s.proxy_slab((74, 90), (-5, 5), (9, 20), 0.6)
    s.surface("top", 25, (60, 8), (0, 0))
    shift(s, -1)


@builder("ufo")
def ufo(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flying saucer on three legs, 8 m."""
    s.lathe(
        [(0, 110), (120, 112), (390, 170), (400, 180), (390, 190), (160, 240), (0, 250)],
        c,
        rough=0.25,
    )
    s.ball(1, (0, 0, 236), rgb(120, 200, 190), scale=(135, 135, 110), rough=0.05)
    for k in range(12):
        a = 2 * math.pi * k / 12
        s.ball(16, (330 * math.cos(a), 330 * math.sin(a), 200), YELLOW, detail=2)
    for k in range(3):
        a = 2 * math.pi * k / 3
        p = (math.cos(a), math.sin(a))
        s.rod(9, (150 * p[0], 150 * p[1], 125), (240 * p[0], 240 * p[1], 8), STEEL, sections=14)
        s.rod(28, (240 * p[0], 240 * p[1], 0), (240 * p[0], 240 * p[1], 9), DARK)
        s.proxy_cylinder(28, (0, 112), 0.2, (235 * p[0], 235 * p[1]))
    s.proxy_cylinder(300, (112, 240), 1.0)
    s.proxy_cylinder(395, (165, 195), 0.5)
    s.proxy_cylinder(125, (240, 340), 0.3)


@builder("hot_air_balloon")
def hot_air_balloon(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Hot-air balloon with its basket on the ground, drawn 18 m tall."""
    profile = [
        (0, 560),
        (110, 562),
        (320, 780),
        (560, 1080),
        (640, 1330),
        (560, 1600),
        (320, 1760),
        (0, 1800),
    ]
    tones = (c, YELLOW)
    s.lathe(profile, c, smooth=60, rough=0.8)
    for k in range(12):
        a = 2 * math.pi * k / 12
        tone = shade(tones[1], 1.0)
        pts = [(p[0] * 1.02, p[1]) for p in profile[1:-1]]
        for (r0, z0), (r1, z1) in itertools.pairwise(pts):
            s.rod(
                9,
                (r0 * math.cos(a), r0 * math.sin(a), z0),
                (r1 * math.cos(a), r1 * math.sin(a), z1),
                tone,
                sections=8,
            )
    s.slab((-75, 75), (-60, 60), (0, 110), WOOD, rough=0.95)
    s.slab((-80, 80), (-65, 65), (104, 116), rgb(96, 62, 34))
    for x in (-70, 70):
        for y in (-55, 55):
            s.rod(3, (x, y, 110), (x * 1.2, y * 1.4, 580), DARK, sections=8)
    s.rod(16, (0, 0, 250), (0, 0, 310), STEEL)
    s.proxy_slab((-80, 80), (-65, 65), (0, 116), 3.0)
    s.proxy_cylinder(70, (116, 560), 0.002)
    s.proxy(ProxyKind.SPHERE, (600, 600, 600), (0, 0, 1200), 0.001)
