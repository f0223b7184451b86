"""Outdoor things: camps, farms, towers, street and fair equipment, machines, monuments."""

from __future__ import annotations

import itertools
import math

from esg.assets.builders import builder
from esg.assets.builders.common import bone, mirrored, prism, shade, shift
from esg.assets.lazy import shapes
from esg.assets.sketch import (
    ALONG,
    BRICK_RED,
    CHROME,
    CONCRETE,
    DARK,
    DARK_WOOD,
    GLASS,
    PALE_WOOD,
    RED,
    STEEL,
    WHITE,
    WOOD,
    YELLOW,
    Color,
    Sketch,
    rgb,
    turn,
)
from esg.graph.models import ProxyKind

_LEAF = rgb(66, 130, 56)


@builder("tent")
def tent(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ridge tent, entrance at +X, 220 x 200 x 130."""
    s.extrude([(-100, 0), (100, 0), (0, 126)], (-108, 108), c, plane="yz", rough=0.95)
    s.extrude([(-34, 0), (34, 0), (0, 92)], (108, 109), DARK, plane="yz")
    s.extrude(
        [(-60, 0), (-34, 0), (0, 92), (0, 96), (-12, 92)], (108, 110), shade(c, 1.2), plane="yz"
    )
    s.rod(2, (-110, 0, 127), (110, 0, 127), shade(c, 0.6), sections=12)
    for side in (-1, 1):
        s.slab((-108, 108), mirrored(side, 97, 100), (0, 3), shade(c, 0.6))
    s.proxy_hull([(x, y, z) for x in (-108, 108) for y, z in ((-100, 0), (100, 0), (0, 126))])


@builder("hay_bale")
def hay_bale(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "square") -> None:
    """Bound hay bale; a round bale lies on its side, axis along Y."""
    if kind == "round":
        s.rod(62, (0, -60, 62), (0, 60, 62), c, rough=1.0, sections=40)
        for y in (-60.3, 60.3):
            for r in (20, 40, 56):
                s.torus(r, 1.4, (0, y, 62), shade(c, 0.8), axis="y")
        for y in (-30, 0, 30):
            s.torus(62.2, 0.8, (0, y, 62), shade(c, 0.7), axis="y")
        s.proxy(ProxyKind.CYLINDER, (62, 62, 60), (0, 0, 62), 1.0, ALONG["y"])
        # Straw yields under its own weight: the bale rests on a flat instead of rolling away.
        s.proxy_slab((-22, 22), (-58, 58), (0, 6), 1.0)
        return
    s.slab((-50, 50), (-23, 23), (0, 38), c, rough=1.0)
    for k in range(26):
        x = -48 + 3.84 * k
        y = 23 if k % 2 else -23
        s.rod(0.5, (x, y * 0.9, 38), (x + 6 * (-1) ** k, y * 0.3, 38.3), shade(c, 1.15), sections=6)
        s.rod(
            0.5,
            (x, y, 8 + (k * 7) % 26),
            (min(x + 8, 50), y * 1.01, 10 + (k * 5) % 24),
            shade(c, 1.15),
            sections=6,
        )
    for x in (-22, 22):
        s.slab((x - 0.8, x + 0.8), (-23.4, 23.4), (0, 38.5), rgb(180, 90, 50))
    s.proxy_slab((-50, 50), (-23, 23), (0, 38))
    s.surface("top", 38, (47, 20))


@builder("plant_form")
def plant_form(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "stump") -> None:
    """Tree stump, cactus in a pot, flower in a pot, palm tree."""
    if kind == "stump":
        s.lathe([(0, 0), (26, 0), (21, 6), (19, 36), (0, 36)], c, sections=20, rough=1.0)
        s.rod(18.6, (0, 0, 36), (0, 0, 37), PALE_WOOD, sections=32)
        for r in (5, 10, 15):
            s.torus(r, 0.3, (0, 0, 37), DARK_WOOD)
        for k in range(6):
            a = 2 * math.pi * k / 6
            bone(
                s,
                (16 * math.cos(a), 16 * math.sin(a), 6),
                6,
                (29 * math.cos(a), 29 * math.sin(a), 2),
                2,
                c,
            )
        s.proxy_cylinder(24, (0, 5), 1.0)
        s.proxy_cylinder(19, (5, 37), 1.0)
        s.surface("top", 37, (12, 12))
        return
    if kind == "palm":
        path = [(0, 0, 22), (6, 0, 150), (18, 0, 290), (38, 0, 420)]
        for k, (p, q) in enumerate(itertools.pairwise(path)):
            bone(s, p, 22 - 3 * k if k else 22, q, 18 - 3 * k, c)
        for k in range(9):
            a = 2 * math.pi * k / 9
            u, n = (math.cos(a), math.sin(a)), (-math.sin(a), math.cos(a))
            top = (38, 0, 432)
            mid = (top[0] + 90 * u[0], 90 * u[1], 462)
            end = (top[0] + 170 * u[0], 170 * u[1], 380)
            for p, q, w0, w1 in ((top, mid, 6, 22), (mid, end, 22, 3)):
                prism(
                    s,
                    [
                        (v[0] + n[0] * w * e, v[1] + n[1] * w * e, v[2] + dz)
                        for v, w in ((p, w0), (q, w1))
                        for e in (-1, 1)
                        for dz in (0, 2)
                    ]
                    + [(v[0], v[1], v[2] + 6) for v in (p, q)],
                    _LEAF,
                )
        for k in range(3):
            a = 2 * math.pi * k / 3
            s.ball(11, (38 + 16 * math.cos(a), 16 * math.sin(a), 416), rgb(96, 70, 40))
        s.proxy_cylinder(28, (0, 20), 3.0)
        s.proxy_cylinder(18, (20, 420), 1.0, (12, 0))
        s.proxy_cylinder(120, (420, 462), 0.02, (38, 0))
        shift(s, -38)
        return
    s.lathe(
        [(0, 0), (7, 0), (9.6, 14), (10.4, 14), (10.4, 17), (0, 17)], rgb(180, 92, 58), sections=32
    )
    s.rod(9, (0, 0, 16), (0, 0, 17.3), rgb(70, 50, 36))
    s.proxy_cylinder(7.2, (0, 4), 2.0)
    s.proxy_cylinder(9.6, (4, 17), 1.6)
    if kind == "cactus":
        bone(s, (0, 0, 18), 6, (0, 0, 48), 5.4, c)
        for side, z in ((1, 28), (-1, 34)):
            bone(s, (0, 0, z), 3.4, (0, side * 12, z + 1), 3.4, c)
            bone(s, (0, side * 12, z + 1), 3.4, (0, side * 12.4, z + 13), 3.0, c)
        s.ball(2.2, (0, 0, 54), rgb(230, 90, 140), detail=2)
        s.proxy_cylinder(6, (17, 53), 0.6)
        s.proxy_slab((-3, 3), (-15, 15), (26, 47), 0.2)
        return
    s.rod(0.7, (0, 0, 17), (0, 0, 44), _LEAF, sections=10)
    for side in (-1, 1):
        s.ball(1, (0, side * 5, 27), _LEAF, scale=(2.4, 5.4, 1.2))
    for k in range(9):
        a = 2 * math.pi * k / 9
        s.ball(1, (1.2, 5 * math.cos(a), 46 + 5 * math.sin(a)), c, scale=(0.8, 2.6, 2.6), detail=2)
    s.ball(1, (1.8, 0, 46), rgb(110, 70, 30), scale=(1.4, 3, 3))
    s.proxy_slab((-1.5, 1.5), (-5, 5), (17, 53), 0.05)


@builder("tower")
def tower(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "blocks") -> None:
    """A stack of wooden blocks, lighthouse, windmill, castle, silo or well."""
    if kind == "blocks":
        for k in range(12):
            for j in (-1, 0, 1):
                z = (k * 2.5, k * 2.5 + 2.44)
                across = (j * 4.2 - 2.05, j * 4.2 + 2.05)
                x, y = ((-6.25, 6.25), across) if k % 2 else (across, (-6.25, 6.25))
                s.slab(x, y, z, shade(c, 0.92 + 0.05 * ((k + j) % 3)))
        s.proxy_slab((-6.2, 6.2), (-6.2, 6.2), (0, 30))
        s.surface("top", 30, (5.5, 5.5))
    elif kind == "lighthouse":
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
    elif kind == "windmill":
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
    elif kind == "castle":
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
    elif kind == "silo":
        s.rod(150, (0, 0, 0), (0, 0, 700), c, rough=0.4, metal=0.4, sections=40)
        for z in range(60, 700, 70):
            s.torus(150, 4, (0, 0, z), shade(c, 0.8))
        s.lathe([(0, 700), (152, 700), (110, 790), (40, 830), (0, 835)], shade(c, 0.9), smooth=30)
        s.rod(4, (152, -20, 0), (152, -20, 700), STEEL, sections=10)
        s.rod(4, (152, 20, 0), (152, 20, 700), STEEL, sections=10)
        s.proxy_cylinder(150, (0, 700), 1.0)
        s.proxy_cylinder(100, (700, 820), 0.5)
    else:
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


@builder("bus_stop")
def bus_stop(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bus shelter open towards +X, 150 x 320 x 250; with bench and sign."""
    s.slab((-70, 70), (-155, 155), (238, 246), c)
    for y in (-150, 0, 150):
        s.slab((-68, -60), (y - 4, y + 4), (0, 238), c)
    s.slab((-66, -64), (-146, 146), (18, 226), (0.7, 0.82, 0.86), rough=0.05, alpha=0.4)
    for side in (-1, 1):
        s.slab(
            (-60, 30), mirrored(side, 149, 151), (18, 226), (0.7, 0.82, 0.86), rough=0.05, alpha=0.4
        )
        s.slab((26, 34), mirrored(side, 147, 153), (0, 238), c)
    s.slab((-56, -22), (-100, 60), (42, 47), WOOD)
    for y in (-90, 50):
        s.slab((-50, -28), (y - 3, y + 3), (0, 42), STEEL)
    s.rod(3, (62, 168, 0), (62, 168, 236), STEEL)
    s.slab((60, 64), (152, 184), (206, 250), YELLOW)
    s.proxy_slab((-68, -60), (-154, 154), (0, 238), 1.0)
    for side in (-1, 1):
        s.proxy_slab((-60, 34), mirrored(side, 147, 153), (0, 238), 0.6)
    s.proxy_slab((-70, 70), (-155, 155), (238, 246), 0.6)
    s.proxy_slab((-56, -22), (-100, 60), (0, 47), 0.3)
    s.proxy_slab((58, 66), (164, 172), (0, 206), 1.0)
    s.surface("bench", 47, (15, 74), (-39, -20))
    shift(s, 0, -14)


@builder("road_sign")
def road_sign(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "sign") -> None:
    """Direction sign or billboard facing +X."""
    if kind == "billboard":
        s.slab((-4, 8), (-180, 180), (180, 380), WHITE)
        s.slab((8, 9), (-172, 172), (188, 372), c)
        s.slab((9, 9.6), (-120, 40), (300, 340), WHITE)
        s.slab((9, 9.6), (-120, 110), (230, 262), YELLOW)
        for y in (-120, 120):
            s.slab((-14, -4), (y - 8, y + 8), (0, 360), STEEL)
            s.slab((-50, 20), (y - 20, y + 20), (0, 10), CONCRETE)
            s.proxy_slab((-50, 20), (y - 20, y + 20), (0, 10), 4.0)
            s.proxy_slab((-14, -4), (y - 8, y + 8), (10, 180), 1.0)
        s.proxy_slab((-14, 8), (-180, 180), (180, 380), 0.3)
        shift(s, 15)
        return
    s.rod(18, (0, 0, 0), (0, 0, 10), CONCRETE)
    s.rod(3, (0, 0, 8), (0, 0, 236), STEEL, metal=0.6)
    s.extrude([(-46, 186), (40, 186), (58, 203), (40, 220), (-46, 220)], (3, 5), c, plane="yz")
    s.extrude(
        [(-41, 190), (38, 190), (52, 203), (38, 216), (-41, 216)], (5, 5.4), WHITE, plane="yz"
    )
    s.slab((5.4, 5.8), (-34, 30), (199, 207), c)
    s.proxy_cylinder(18, (0, 10), 14.0)
    s.proxy_cylinder(3.4, (10, 236), 1.0)
    s.proxy_slab((3, 6), (-46, 50), (186, 220), 0.5)
    shift(s, 0, -5)


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


@builder("artillery")
def artillery(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "cannon") -> None:
    """Old cannon on wheels, or a catapult."""

    def wheel(x: float, y: float, r: float) -> None:
        s.torus(r - 4, 4, (x, y, r), DARK_WOOD, axis="y")
        s.rod(8, (x, y - 6, r), (x, y + 6, r), DARK, sections=18)
        for k in range(6):
            a = math.pi * k / 6
            s.rod(
                2.2,
                (x - (r - 4) * math.cos(a), y, r - (r - 4) * math.sin(a)),
                (x + (r - 4) * math.cos(a), y, r + (r - 4) * math.sin(a)),
                WOOD,
                sections=8,
            )

    if kind == "cannon":
        for side in (-1, 1):
            wheel(10, side * 46, 48)
            s.extrude(
                [(-104, 0), (-88, 0), (30, 50), (30, 72), (-6, 72)], mirrored(side, 20, 27), WOOD
            )
        s.rod(4, (10, -46, 48), (10, 46, 48), DARK)

        def barrel() -> object:
            return shapes.lathe(
                [
                    (0, -60),
                    (15, -58),
                    (18, -40),
                    (13, 70),
                    (17, 80),
                    (17, 90),
                    (8, 90),
                    (8, 30),
                    (0, 30),
                ],
                (0, 0, 0),
                0,
                36,
                "x",
            )

        def aimed() -> object:
            from trimesh.transformations import rotation_matrix

            mesh = barrel()
            mesh.apply_transform(rotation_matrix(math.radians(-8), [0, 1, 0]))
            mesh.apply_translation([14, 0, 76])
            return mesh

        s.add(aimed, c, 0.4, 0.7)
        s.ball(6, (-48, 0, 67), c, metal=0.7)
        s.proxy_slab((-38, 58), (-50, 50), (0, 60), 0.3)
        s.proxy_slab((-104, -38), (-27, 27), (0, 40), 0.4)
        s.proxy_slab((-46, 104), (-16, 16), (60, 94), 2.0)
        return
    for side in (-1, 1):
        s.slab((-110, 100), mirrored(side, 44, 56), (20, 36), WOOD)
        for x in (-80, 76):
            wheel(x, side * 66, 26)
        s.rod(6, (-20, side * 50, 36), (20, side * 44, 124), WOOD, sections=12)
        s.rod(6, (60, side * 50, 36), (20, side * 44, 124), WOOD, sections=12)
    for x in (-100, 0, 92):
        s.slab((x - 6, x + 6), (-56, 56), (22, 34), DARK_WOOD)
    s.rod(7, (20, -52, 124), (20, 52, 124), DARK_WOOD)
    s.rod(5, (36, 0, 40), (-112, 0, 104), WOOD, sections=14)
    s.lathe(
        [(0, -4), (14, 0), (19, 10), (17, 10), (12, 2), (0, 0)], DARK_WOOD, center=(-118, 0, 106)
    )
    s.proxy_slab((-110, 102), (-72, 72), (0, 36), 1.0)
    for side in (-1, 1):
        s.proxy_slab((-6, 46), mirrored(side, 42, 54), (36, 130), 0.3)
    s.proxy_slab((-134, -100), (-18, 18), (98, 108), 0.1)
    shift(s, 16)


@builder("speed_bump")
def speed_bump(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Rubber speed bump across the road, 40 x 300 x 6."""
    s.extrude([(-20, 0), (20, 0), (10, 5.4), (0, 6), (-10, 5.4)], (-150, 150), c)
    for k in range(6):
        y = -125 + 50 * k
        prism(
            s,
            [
                (x, yy, z)
                for yy in (y - 12, y + 12)
                for x, z in (
                    (-18, 1.4),
                    (18, 1.4),
                    (10, 5.8),
                    (-10, 5.8),
                    (0, 6.2),
                    (-17, 1.2),
                    (17, 1.2),
                )
            ],
            YELLOW,
        )
    s.proxy_hull(
        [
            (x, y, z)
            for y in (-150, 150)
            for x, z in ((-20, 0), (20, 0), (10, 5.4), (-10, 5.4), (0, 6.0))
        ]
    )


@builder("machine")
def machine(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "conveyor") -> None:
    """Conveyor belt, treadmill, press, generator, tower crane, vending machine."""
    if kind == "conveyor":
        s.slab((-145, 145), (-28, 28), (66, 74), DARK)
        for x in (-145, 145):
            s.rod(7, (x, -28, 68), (x, 28, 68), STEEL, metal=0.6)
        s.slab((-145, 145), (-26, 26), (74, 75), DARK, rough=0.9)
        for side in (-1, 1):
            s.slab((-150, 150), mirrored(side, 28, 31), (60, 80), c)
            for x in (-120, 0, 120):
                s.slab((x - 4, x + 4), mirrored(side, 25, 31), (0, 60), STEEL)
        for x in (-120, 0, 120):
            s.proxy_slab((x - 4, x + 4), (-31, 31), (0, 60), 0.6)
        s.proxy_slab((-150, 150), (-31, 31), (60, 75), 1.0)
        s.surface("belt", 75, (140, 24))
    elif kind == "treadmill":
        s.slab((-88, 70), (-38, 38), (6, 18), DARK)
        s.slab((-84, 56), (-26, 26), (18, 19), rgb(50, 50, 54))
        s.slab((44, 84), (-38, 38), (0, 26), c)
        s.slab((-88, -76), (-36, 36), (0, 6), DARK)
        for side in (-1, 1):
            s.pipe(2.6, [(60, side * 36, 24), (40, side * 36, 118), (4, side * 36, 108)], STEEL)
        prism(
            s,
            [(46 + d, y, 108) for d in (0, 6) for y in (-38, 38)]
            + [(34 + d, y, 134) for d in (0, 6) for y in (-34, 34)],
            c,
        )
        s.proxy_slab((-88, 84), (-38, 38), (0, 19), 1.0)
        for side in (-1, 1):
            s.proxy_slab((36, 62), mirrored(side, 33, 39), (19, 108), 0.2)
        s.proxy_slab((34, 52), (-38, 38), (108, 134), 0.2)
        s.surface("belt", 19, (60, 24), (-20, 0))
        shift(s, 2)
    elif kind == "press":
        s.slab((-35, 35), (-45, 45), (0, 10), c)
        for side in (-1, 1):
            s.slab((-16, 16), mirrored(side, 34, 44), (10, 170), c)
        s.slab((-18, 18), (-46, 46), (150, 176), c)
        s.rod(9, (0, 0, 92), (0, 0, 150), CHROME, metal=0.9)
        s.slab((-22, 22), (-24, 24), (82, 92), STEEL)
        s.slab((-26, 26), (-34, 34), (50, 58), STEEL)
        s.rod(6, (0, 56, 120), (0, 56, 150), RED)
        s.proxy_slab((-35, 35), (-45, 45), (0, 10), 1.0)
        for side in (-1, 1):
            s.proxy_slab((-16, 16), mirrored(side, 34, 44), (10, 150), 1.0)
        s.proxy_slab((-26, 26), (-34, 34), (48, 58), 0.8)
        s.proxy_slab((-22, 22), (-24, 24), (82, 150), 0.3)
        s.proxy_slab((-18, 18), (-46, 46), (150, 176), 1.0)
        s.surface("bed", 58, (22, 28))
        shift(s, 0, -5)
    elif kind == "generator":
        s.slab((-28, 28), (-20, 20), (10, 42), DARK)
        for side in (-1, 1):
            s.pipe(
                1.8,
                [
                    (-30, side * 22, 1.8),
                    (-30, side * 22, 48),
                    (30, side * 22, 48),
                    (30, side * 22, 1.8),
                ],
                c,
            )
            s.pipe(1.8, [(-30, side * 22, 1.8), (30, side * 22, 1.8)], c)
        for x in (-30, 30):
            s.rod(1.8, (x, -22, 48), (x, 22, 48), c, sections=12)
        s.slab((-26, 26), (-18, 18), (42, 52), c)
        s.rod(4, (10, 0, 52), (10, 0, 54), DARK)
        s.rod(8, (28, 0, 26), (32, 0, 26), STEEL)
        s.slab((-32, -28), (-14, 14), (16, 36), YELLOW)
        s.proxy_slab((-31, 31), (-23, 23), (0, 48))
        s.proxy_slab((-26, 26), (-18, 18), (48, 52), 0.5)
    elif kind == "crane":
        for x in (-50, 50):
            for y in (-50, 50):
                s.slab((x - 6, x + 6), (y - 6, y + 6), (40, 1000), c)
        s.slab((-150, 150), (-150, 150), (0, 40), CONCRETE)
        for k in range(12):
            z0, z1 = 40 + 80 * k, 120 + 80 * k
            for a, b in (
                ((-50, -50), (50, -50)),
                ((50, -50), (50, 50)),
                ((50, 50), (-50, 50)),
                ((-50, 50), (-50, -50)),
            ):
                s.rod(3, (*a, z0), (*b, z1), c, sections=6)
        s.slab((-60, 60), (-60, 60), (1000, 1020), DARK)
        s.slab((10, 90), (-45, 45), (920, 1000), GLASS)
        s.slab((-380, 900), (-24, 24), (1020, 1034), c)
        s.slab((-380, 900), (-5, 5), (1080, 1090), c)
        for k in range(16):
            x = -380 + 80 * k
            s.rod(3, (x, -20, 1030), (x + 40, 0, 1084), c, sections=6)
            s.rod(3, (x + 40, 0, 1084), (x + 80, 20, 1030), c, sections=6)
        prism(s, [(x, y, 1020) for x in (-40, 40) for y in (-24, 24)] + [(0, 0, 1200)], c)
        s.rod(3, (0, 0, 1195), (700, 0, 1088), DARK, sections=8)
        s.rod(3, (0, 0, 1195), (-340, 0, 1040), DARK, sections=8)
        s.slab((-380, -280), (-40, 40), (960, 1020), CONCRETE)
        s.rod(1.5, (600, 0, 1020), (600, 0, 640), DARK, sections=8)
        s.slab((585, 615), (-15, 15), (600, 640), RED)
        s.proxy_slab((-150, 150), (-150, 150), (0, 40), 20)
        s.proxy_slab((-56, 56), (-56, 56), (40, 1020), 0.3)
        s.proxy_slab((-380, 900), (-24, 24), (1020, 1090), 0.05)
        s.proxy_slab((-380, -280), (-40, 40), (960, 1020), 2.5)
        shift(s, -260)
    else:
        s.slab((-38, 36), (-46, 46), (0, 183), c, rough=0.4)
        s.slab((36, 38), (-42, 20), (50, 176), GLASS, rough=0.05)
        for k in range(4):
            for j in range(4):
                s.rod(
                    5,
                    (37, -34 + 15 * j, 66 + 28 * k),
                    (39.4, -34 + 15 * j, 66 + 28 * k),
                    (RED, YELLOW, rgb(60, 130, 200), _LEAF)[(k + j) % 4],
                    sections=18,
                )
        s.slab((36, 38.4), (24, 42), (90, 150), DARK)
        s.slab((36, 38.4), (-36, 14), (14, 34), DARK)
        s.proxy_slab((-38, 38), (-46, 46), (0, 183))


@builder("crib")
def crib(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Baby's crib, 70 x 130 x 95; open above."""
    for x in (-33, 33):
        for y in (-63, 63):
            s.slab((x - 2.4, x + 2.4), (y - 2.4, y + 2.4), (0, 95), c)
    for z in (28, 88):
        for side in (-1, 1):
            s.slab((-33, 33), mirrored(side, 61.6, 64.4), (z, z + 5), c)
            s.slab(mirrored(side, 31.6, 34.4), (-63, 63), (z, z + 5), c)
    for side in (-1, 1):
        for k in range(12):
            s.rod(0.9, (side * 33, -55 + 10 * k, 32), (side * 33, -55 + 10 * k, 89), c, sections=10)
        for k in range(6):
            s.rod(0.9, (-25 + 10 * k, side * 63, 32), (-25 + 10 * k, side * 63, 89), c, sections=10)
    s.slab((-31, 31), (-61, 61), (33, 43), WHITE)
    s.walls((-35, 35), (-65, 65), (28, 93), 3)
    for x in (-33, 33):
        for y in (-63, 63):
            s.proxy_slab((x - 2, x + 2), (y - 2, y + 2), (0, 28), 2.0)
    s.proxy_slab((-31, 31), (-61, 61), (31, 43), 0.4)
    s.surface("mattress", 43, (29, 58))
    s.region("inside", (-31, 31), (-61, 61), (43, 93))


@builder("gravestone")
def gravestone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Gravestone with a round head facing +X, 30 x 60 x 95."""
    s.slab((-15, 15), (-30, 30), (0, 12), shade(c, 0.85), rough=0.95)
    s.extrude(
        [
            (-24, 12),
            (24, 12),
            (24, 70),
            *[
                (24 * math.cos(math.pi * k / 12), 70 + 24 * math.sin(math.pi * k / 12))
                for k in range(1, 12)
            ],
            (-24, 70),
        ],
        (-7, 7),
        c,
        plane="yz",
        rough=0.9,
    )
    s.slab((7, 7.6), (-2, 2), (46, 80), shade(c, 0.6))
    s.slab((7, 7.6), (-10, 10), (66, 70), shade(c, 0.6))
    s.proxy_slab((-15, 15), (-30, 30), (0, 12))
    s.proxy_slab((-7, 7), (-24, 24), (12, 80))
    s.proxy_slab((-7, 7), (-16, 16), (80, 92))


@builder("campfire")
def campfire(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Campfire of logs in a ring of stones, 90 cm."""
    for k in range(10):
        a = 2 * math.pi * k / 10
        s.ball(
            1,
            (38 * math.cos(a), 38 * math.sin(a), 6),
            shade(CONCRETE, 0.7 + 0.05 * (k % 3)),
            scale=(9, 9, 6),
            detail=2,
        )
    for k in range(6):
        a = 2 * math.pi * k / 6
        s.rod(
            4,
            (26 * math.cos(a), 26 * math.sin(a), 3.5),
            (3 * math.cos(a), 3 * math.sin(a), 40),
            DARK_WOOD,
            sections=12,
        )
    for k, (r, h) in enumerate(((13, 46), (9, 54))):
        s.lathe([(0, 8), (r, 14), (r * 0.7, 28), (0, h)], (c, YELLOW)[k], sections=7, rough=0.4)
    s.proxy_cylinder(44, (0, 11), 1.0)
    s.proxy_cylinder(14, (11, 50), 0.2)


@builder("small_round")
def small_round(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "bomb") -> None:
    """Cartoon bomb with a fuse, bullet, seashell."""
    if kind == "bomb":
        s.ball(9, (0, 0, 9), c, rough=0.3)
        s.rod(2.6, (0, 0, 17), (0, 0, 20), DARK)
        s.pipe(0.5, [(0, 0, 20), (1.5, 0, 23), (4, 0, 24.6)], PALE_WOOD)
        s.ball(1.0, (4.4, 0, 24.8), YELLOW, detail=2)
        s.proxy_cylinder(4.5, (0, 2), 1.0)
        s.proxy_cylinder(8.6, (2, 16), 1.0)
        s.proxy_cylinder(2.6, (16, 20), 0.3)
    elif kind == "bullet":
        s.lathe(
            [(0, -1.4), (0.5, -1.4), (0.5, 0.3), (0, 0.3)],
            c,
            center=(0, 0, 0.5),
            axis="x",
            metal=0.9,
        )
        s.lathe(
            [(0, 0.3), (0.46, 0.3), (0.3, 1.1), (0, 1.5)],
            rgb(180, 110, 70),
            center=(0, 0, 0.5),
            axis="x",
            smooth=20,
            metal=0.8,
        )
        s.proxy_slab((-1.4, 1.2), (-0.36, 0.36), (0, 0.94))
    else:
        for k in range(7):
            a = math.radians(-54 + 18 * k)
            s.ball(
                1,
                (3.4 * math.cos(a), 3.4 * math.sin(a), 1.6),
                shade(c, 0.9 + 0.1 * (k % 2)),
                scale=(2.6, 1.1, 1.6),
                detail=2,
            )
        s.ball(1, (0.4, 0, 1.3), c, scale=(1.8, 2.2, 1.3), detail=2)
        s.proxy_slab((-0.8, 5.4), (-3.4, 3.4), (0, 2.8))
        shift(s, -2.4)


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
        s.ball(9, (40, -60 + 40 * k, 111), (RED, YELLOW, _LEAF, rgb(230, 120, 40))[k])
    s.proxy_slab((-70, 84), (-105, 105), (0, 102), 1.0)
    for y in (-1, 1):
        s.proxy_slab((-70, -62), mirrored(y, 96, 104), (102, 205), 0.3)
    s.proxy_slab((-80, 108), (-119, 119), (205, 238), 0.1)
    s.surface("counter", 102, (60, 90), (10, 0))
    shift(s, -15)


@builder("parking")
def parking(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Car park with painted bays of 250 x 500; a decal."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.7), c, rough=1.0)
    n = max(1, int(L / 250))
    depth = min(500.0, W * 0.4)
    for k in range(n + 1):
        x = -L / 2 + 5 + (L - 10) * k / n
        for side in (-1, 1):
            s.slab((x - 5, x + 5), mirrored(side, W / 2 - depth, W / 2), (0, H), WHITE)
    s.surface("surface", 0.0, (L / 2, W / 2))
