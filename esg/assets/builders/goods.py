"""Small things of the house: tools, toys, clothes, things to write, play and clean with."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import blob, bone, mirrored, prism, shade, shift
from esg.assets.sketch import (
    BRASS,
    CHROME,
    DARK,
    RED,
    STEEL,
    WHITE,
    WOOD,
    YELLOW,
    Color,
    Sketch,
    rgb,
)


@builder("long_tool")
def long_tool(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "shovel") -> None:
    """A tool with a long handle lying along X, head to +X."""
    half = 60.0
    z = {"broom": 4.0, "rake": 4.0}.get(kind, 2.0)
    s.rod(1.5, (-half, 0, z), (half - 22, 0, z), WOOD if kind != "crutch" else c, sections=16)
    if kind == "shovel":
        s.rod(2.0, (half - 30, 0, z), (half - 18, 0, z), STEEL, sections=16)
        s.extrude(
            [(half - 20, -11), (half - 20, 11), (half + 2, 10), (half + 9, 0), (half + 2, -10)],
            (z - 1, z),
            c,
            plane="xy",
            soft=1,
            metal=0.5,
        )
        s.pipe(1.4, [(-half, -5, z), (-half - 2, -5, z), (-half - 2, 5, z), (-half, 5, z)], DARK)
        s.rod(1.4, (-half, -5, z), (-half, 5, z), DARK)
        s.proxy_slab((-half - 3, half - 20), (-1.6, 1.6), (0, 3.6), 1.0)
        s.proxy_slab((half - 20, half + 8), (-10, 10), (0, 3.2), 0.5)
        shift(s, -3.4)
    elif kind == "rake":
        s.slab((half - 24, half - 21), (-18, 18), (z - 1, z + 1), c)
        for k in range(9):
            y = -17 + 34 * k / 8
            s.rod(0.5, (half - 22.5, y, z), (half - 20, y, 0.3), c, sections=8)
        s.proxy_slab((-half, half - 24), (-1.5, 1.5), (z - 1.5, z + 1.5), 1.0)
        s.proxy_slab((half - 25, half - 19), (-18, 18), (0, z + 1), 1.0)
        s.proxy_slab((-half, -half + 3), (-1.5, 1.5), (0, z - 1.5), 0.3)
        shift(s, 9)
    elif kind == "broom":
        s.box((9, 30, 4), (half - 20, 0, z), c)
        prism(
            s,
            [(half - 16, y, z + d) for y in (-14, 14) for d in (-1.6, 1.6)]
            + [(half - 2, y, zz) for y in (-18, 18) for zz in (0, 8)],
            YELLOW,
            rough=1.0,
        )
        s.proxy_slab((-half, half - 24), (-1.5, 1.5), (z - 1.5, z + 1.5), 1.0)
        s.proxy_slab((half - 24, half - 2), (-16, 16), (0, 8), 0.3)
        s.proxy_slab((-half, -half + 3), (-1.5, 1.5), (0, z - 1.5), 0.3)
        shift(s, 1)
    else:
        s.pipe(
            1.5, [(half - 22, 0, z), (half - 12, 0, z), (half - 10, 9, z), (half - 14, 13, z)], c
        )
        s.proxy_slab((-half, half - 10), (-1.5, 1.5), (0, 3.5), 1.0)
        s.proxy_slab((half - 15, half - 8.5), (0, 14), (0, 3.5), 0.4)
        shift(s, 5.8, -6.4, -0.5)
        s.proxies[:] = [
            p.model_copy(update={"position_cm": (*p.position_cm[:2], p.position_cm[2] + 0.5)})
            for p in s.proxies
        ]


@builder("hand_tool")
def hand_tool(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "axe") -> None:
    """A hand tool lying flat, working end to +X."""
    if kind == "axe":
        s.extrude(
            [(-26, -1.6), (-27, 2), (-20, 1.6), (18, 1.4), (18, -1.4), (-20, -1.4)],
            (0.6, 2.6),
            WOOD,
            plane="xy",
            soft=0.3,
        )
        prism(
            s,
            [
                (14, 3, 0),
                (20, 3, 0),
                (14, 3, 3.2),
                (20, 3, 3.2),
                (12, -9, 1.4),
                (22.5, -9, 1.4),
                (12, -9, 1.8),
                (22.5, -9, 1.8),
            ],
            c,
            metal=0.6,
        )
        s.proxy_slab((-26, 14), (-1.5, 1.5), (0, 3), 0.4)
        s.proxy_slab((13, 21), (-8, 3), (0, 3.2), 3.0)
        shift(s, 2, 3)
    elif kind == "wrench":
        s.extrude(
            [(-9.5, -0.9), (7, -0.7), (7, 0.7), (-9.5, 0.9)], (0, 0.8), c, plane="xy", metal=0.7
        )
        s.extrude(
            [
                (6.5, -1.2),
                (8, -2.2),
                (11.5, -2),
                (11.5, -0.9),
                (9, -0.8),
                (9, 0.8),
                (11.5, 0.9),
                (11.5, 2),
                (8, 2.2),
                (6.5, 1.2),
            ],
            (0, 1),
            c,
            plane="xy",
            metal=0.7,
        )
        s.torus(1.7, 0.5, (-10.5, 0, 0.5), c, metal=0.7)
        s.proxy_slab((-12, 7), (-1, 1), (0, 0.9), 1.0)
        s.proxy_slab((6.5, 11.5), (-2, 2), (0, 1), 1.0)
        shift(s, 0.6)
    elif kind == "screwdriver":
        s.lathe(
            [(0, -12), (1.3, -11.5), (1.5, -6), (1.1, -2.4), (0, -2)],
            c,
            center=(0, 0, 1.5),
            axis="x",
            rough=0.3,
        )
        s.rod(0.35, (-2.5, 0, 1.5), (10, 0, 1.5), CHROME, metal=0.9, sections=12)
        prism(
            s,
            [(9.6, y, 1.5 + z) for y in (-0.35, 0.35) for z in (-0.35, 0.35)]
            + [(11.6, y, 1.5 + z) for y in (-0.5, 0.5) for z in (-0.08, 0.08)],
            CHROME,
        )
        s.proxy_slab((-12, -2), (-1.1, 1.1), (0, 2.9), 1.0)
        s.proxy_slab((-2, 11.5), (-0.4, 0.4), (1.0, 2.0), 1.5)
        shift(s, 0.2)
    elif kind == "saw":
        s.extrude(
            [(-14, -4), (28, -1.5), (28, 1.5), (-14, 7)], (0.6, 0.9), STEEL, plane="xy", metal=0.8
        )
        s.extrude(
            [(-13, -4.5), (-13, 8), (-22, 7.5), (-25, 3), (-24, -4), (-18, -6)],
            (0, 2),
            c,
            plane="xy",
            soft=0.8,
            holes=[[(-16, -0.5), (-16, 4.5), (-20, 4.5), (-21, 1), (-20, -1.5)]],
        )
        s.proxy_slab((-25, -13), (-6, 8), (0, 2), 1.0)
        s.proxy_slab((-13, 28), (-2.5, 4), (0, 1), 0.6)
        shift(s, -1.5, -1)
    elif kind == "drill":
        s.rod(3, (-7, 0, 17), (7, 0, 17), c, rough=0.4)
        s.lathe([(0, 7), (2.6, 7), (2, 12), (1.0, 13), (0, 13)], DARK, center=(0, 0, 17), axis="x")
        s.rod(0.4, (13, 0, 17), (21, 0, 17), STEEL, metal=0.8, sections=10)
        s.extrude([(-6, 15), (0, 15), (-1, 5), (-7, 5)], (-2, 2), DARK, soft=0.5)
        s.slab((-10, 4), (-3.6, 3.6), (0, 5.5), c)
        s.box((1, 1, 2.4), (0.4, 0, 12.6), RED)
        s.proxy_slab((-10, 4), (-3.6, 3.6), (0, 5.5), 1.5)
        s.proxy_slab((-7, 0), (-2, 2), (5.5, 14), 0.6)
        s.proxy_slab((-7, 13), (-3, 3), (14, 20), 1.0)
        shift(s, -5.5)
    elif kind == "scissors":
        for side in (-1, 1):
            prism(
                s,
                [
                    (-1, side * 0.2 - 0.5, 0.2),
                    (-1, side * 0.2 + 0.5, 0.2),
                    (-1, side * 0.2 - 0.5, 0.5),
                    (-1, side * 0.2 + 0.5, 0.5),
                    (10, side * 1.6, 0.2),
                    (10, side * 1.6, 0.45),
                ],
                STEEL,
                metal=0.8,
            )
            s.rod(0.4, (-1, 0, 0.5), (-6, -side * 2.2, 0.5), c, sections=10)
            s.torus(1.7, 0.45, (-7.6, -side * 2.7, 0.5), c)
        s.rod(0.5, (0, 0, 0), (0, 0, 0.9), CHROME, sections=14)
        s.proxy_slab((-9.6, 0), (-4.4, 4.4), (0, 0.9), 0.6)
        s.proxy_slab((0, 10), (-1.6, 1.6), (0, 0.6), 1.0)
    elif kind == "fork":
        s.slab((-10, 4), (-0.6, 0.6), (0.2, 0.6), c, metal=0.8)
        s.slab((-10, -2), (-0.9, 0.9), (0.1, 0.6), c, metal=0.8)
        s.slab((3.6, 6), (-1.2, 1.2), (0.2, 0.6), c, metal=0.8)
        for y in (-1.0, -0.33, 0.33, 1.0):
            prism(
                s,
                [
                    (5.8, y - 0.2, 0.2),
                    (5.8, y + 0.2, 0.2),
                    (5.8, y - 0.2, 0.6),
                    (5.8, y + 0.2, 0.6),
                    (10, y - 0.1, 1.0),
                    (10, y + 0.1, 1.0),
                    (10, y - 0.1, 1.2),
                    (10, y + 0.1, 1.2),
                ],
                c,
                metal=0.8,
            )
        s.proxy_slab((-10, 10), (-1, 1), (0, 0.9))
        shift(s, 0, 0, -0.1)
        s.proxies[:] = [
            p.model_copy(update={"position_cm": (*p.position_cm[:2], p.position_cm[2] + 0.1)})
            for p in s.proxies
        ]
    elif kind == "nail":
        s.rod(0.2, (-4, 0, 0.5), (3.2, 0, 0.5), c, metal=0.7, sections=12)
        bone(s, (3.2, 0, 0.5), 0.18, (3.9, 0, 0.5), 0.03, c, metal=0.7)
        s.rod(0.5, (-4.2, 0, 0.5), (-4, 0, 0.5), c, metal=0.7, sections=20)
        s.proxy_slab((-4.2, 3.8), (-0.3, 0.3), (0, 0.75))
    else:
        s.extrude([(-2.6, 0), (2.6, 0), (2.6, 1.4), (1.8, 1.6), (-2.6, 1.6)], (-1.1, 1.1), c)
        s.slab((-2.7, 0.2), (-1.15, 1.15), (0, 1.65), rgb(60, 90, 160))
        s.proxy_slab((-2.6, 2.6), (-1.1, 1.1), (0, 1.6))


@builder("umbrella_folded")
def umbrella_folded(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Closed umbrella lying along +X with a crook handle, 88 cm."""
    s.lathe(
        [(0, -22), (2.6, -22), (3.6, -18), (2.2, 30), (0.6, 38), (0, 38)],
        c,
        center=(0, 0, 4.0),
        axis="x",
        rough=0.9,
    )
    s.rod(0.6, (-34, 0, 4.0), (44, 0, 4.0), STEEL, sections=10)
    s.pipe(
        1.1, [(-30, 0, 4.0), (-39, 0, 4.0), (-43, 2.4, 4.0), (-43, 6, 4.0), (-40, 7.6, 4.0)], WOOD
    )
    s.lathe(
        [(3.7, -8), (4.0, -8), (3.9, -5.6), (3.6, -5.6), (3.7, -8)],
        shade(c, 0.6),
        center=(0, 0, 4.0),
        axis="x",
    )
    s.proxy_slab((-22, 32), (-2.6, 2.6), (0, 7.4))
    s.proxy_slab((-44, -22), (-1, 1), (2.8, 5.2), 0.6)
    s.proxy_slab((-44, -38), (-1, 8.4), (2.8, 5.2), 0.4)
    shift(s, 0, -2.3)


@builder("fan")
def fan(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pedestal fan blowing towards +X, 118 cm."""
    s.rod(19, (0, 0, 0), (0, 0, 3), c)
    s.rod(1.6, (0, 0, 3), (0, 0, 92), STEEL, metal=0.6, sections=16)
    s.rod(5.5, (-11, 0, 96), (3, 0, 96), c)
    for x, r in ((2, 21), (8, 22), (14, 20)):
        s.torus(r, 0.5, (x, 0, 96), CHROME, axis="x", metal=0.8)
    for k in range(16):
        a = 2 * math.pi * k / 16
        u = (math.cos(a), math.sin(a))
        s.pipe(
            0.25,
            [
                (14.6, 4 * u[0], 96 + 4 * u[1]),
                (14, 20 * u[0], 96 + 20 * u[1]),
                (2, 21 * u[0], 96 + 21 * u[1]),
            ],
            CHROME,
        )
    for k in range(4):
        a = 90 * k
        ca, sa = math.cos(math.radians(a)), math.sin(math.radians(a))
        pts = [
            (6 + dx, r * ca - w * sa, 96 + r * sa + w * ca)
            for r, ws in ((3, (-2, 2)), (17, (-6, 6)))
            for w in ws
            for dx in ((-1.2, -0.8) if w < 0 else (0.8, 1.2))
        ]
        prism(s, pts, rgb(90, 150, 190))
    s.rod(4, (12, 0, 96), (15, 0, 96), c)
    s.proxy_cylinder(19, (0, 3), 5.0)
    s.proxy_cylinder(2.2, (3, 74), 1.0)
    s.proxy_slab((-11, 15), (-20, 20), (76, 117), 0.2)


@builder("vacuum_cleaner")
def vacuum_cleaner(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Canister vacuum cleaner with hose and floor nozzle, 100 cm."""
    blob(s, [((-34, 0, 12), 11), ((-12, 0, 11), 10), ((-34, 0, 16), 11)], c, rough=0.3)
    for side in (-1, 1):
        s.rod(7.5, (-38, side * 11, 7.5), (-38, side * 13, 7.5), DARK)
    s.pipe(1.2, [(-24, 0, 24), (-22, 0, 28), (-38, 0, 29), (-42, 0, 25)], DARK)
    s.pipe(2.0, [(-4, 0, 14), (6, 4, 30), (14, 6, 52), (10, 2, 74), (18, 0, 78)], DARK)
    s.rod(1.6, (18, 0, 78), (44, 0, 5), STEEL, metal=0.7, sections=14)
    s.slab((40, 54), (-14, 14), (0, 5), DARK)
    s.proxy_slab((-48, -2), (-12, 12), (0, 24), 1.0)
    s.proxy_slab((40, 54), (-14, 14), (0, 5), 0.4)
    s.proxy_slab((28, 40), (-2, 2), (16, 48), 0.05)
    s.proxy_slab((8, 26), (-3, 3), (48, 78), 0.05)
    shift(s, -4.2)


@builder("mirror")
def mirror(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "mirror") -> None:
    """Standing mirror, framed picture, window or whiteboard facing +X."""
    if kind == "window":
        for y in (-1, 0, 1):
            s.slab((-3, 3), (y * 57 - 3, y * 57 + 3), (0, 140), c)
        for z in (0, 68, 134):
            s.slab((-3, 3), (-60, 60), (z, z + 6), c)
        s.slab((-0.6, 0.6), (-57, 57), (4, 136), rgb(150, 190, 205), rough=0.05, alpha=0.45)
        s.slab((-4, 4), (-62, 62), (0, 4), c)
        s.proxy_slab((-4, 4), (-62, 62), (0, 4), 2.0)
        s.proxy_slab((-3, 3), (-60, 60), (4, 140))
        return
    if kind == "easel":
        for side in (-1, 1):
            s.rod(1.6, (18, side * 34, 0), (-6, side * 8, 168), WOOD, sections=12)
        s.rod(1.6, (-46, 0, 0), (-8, 0, 160), WOOD, sections=12)
        s.slab((8, 18), (-38, 38), (58, 62), WOOD)
        prism(
            s,
            [(12 + d, y, 62) for d in (0, 2.4) for y in (-36, 36)]
            + [(2 + d, y, 132) for d in (0, 2.4) for y in (-36, 36)],
            WHITE,
        )
        prism(
            s,
            [(13 + d, y, 76) for d in (0, 1.0) for y in (-26, 26)]
            + [(9.6 + d, y, 100) for d in (0, 1.0) for y in (-26, 20)],
            c,
        )
        for side in (-1, 1):
            s.proxy_slab((14, 22), mirrored(side, 30, 36), (0, 3), 3.0)
        s.proxy_slab((-50, -42), (-3, 3), (0, 3), 3.0)
        s.proxy_slab((-46, 18), (-34, 34), (3, 5), 0.5)
        s.proxy_slab((2, 12), (-36, 36), (5, 134), 0.3)
        s.proxy_slab((-9, -3), (-8, 8), (134, 166), 0.3)
        shift(s, 13)
        return
    if kind == "picture":
        s.slab((-1.5, 1), (-40, 40), (0, 60), rgb(216, 208, 190))
        for y in (-1, 1):
            s.slab((-2, 2.4), mirrored(y, 35, 40), (0, 60), c)
        for z in (0, 55):
            s.slab((-2, 2.4), (-40, 40), (z, z + 5), c)
        s.slab((1, 1.3), (-34, 34), (5, 24), rgb(70, 120, 70))
        s.slab((1, 1.2), (-34, 34), (24, 55), rgb(140, 185, 215))
        prism(
            s,
            [
                (1.4, -26, 22),
                (1.4, 4, 22),
                (1.4, -10, 44),
                (1.0, -26, 22),
                (1.0, 4, 22),
                (1.0, -10, 44),
            ],
            rgb(110, 105, 110),
        )
        s.slab((-6, 4), (-30, -24), (0, 2), DARK)
        s.slab((-6, 4), (24, 30), (0, 2), DARK)
        s.proxy_slab((-6, 4), (-30, 30), (0, 2), 2.0)
        s.proxy_slab((-2, 2.4), (-40, 40), (2, 60), 1.0)
        shift(s, 1)
        return
    for side in (-1, 1):
        s.slab((-22, 22), (side * 27 - 2, side * 27 + 2), (0, 4), c)
        s.slab((-2, 2), (side * 27 - 2, side * 27 + 2), (4, 110), c)
    s.extrude(
        [
            (
                26 * math.cos(math.pi * k / 12),
                88 + 72 * math.sin(math.pi * k / 12),
            )
            for k in range(24)
        ],
        (-1.6, 1.6),
        c,
        plane="yz",
    )
    s.extrude(
        [
            (23 * math.cos(math.pi * k / 12), 88 + 68 * math.sin(math.pi * k / 12))
            for k in range(24)
        ],
        (1.5, 2.0),
        rgb(176, 204, 214),
        plane="yz",
        rough=0.03,
        metal=0.6,
    )
    for side in (-1, 1):
        s.proxy_slab((-22, 22), (side * 27 - 2, side * 27 + 2), (0, 4), 2.0)
        s.proxy_slab((-2, 2), (side * 27 - 2, side * 27 + 2), (4, 110), 0.6)
    s.proxy_slab((-1.6, 2), (-22, 22), (18, 158), 0.8)


@builder("game_piece")
def game_piece(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "pawn") -> None:
    """Chess pawn, die, spinning top, playing card, coin."""
    if kind == "pawn":
        s.lathe(
            [
                (0, 0),
                (1.9, 0),
                (1.9, 0.8),
                (1.2, 1.4),
                (0.7, 3.2),
                (1.2, 3.5),
                (0.7, 3.8),
                (0, 3.9),
            ],
            c,
            smooth=0,
            rough=0.3,
        )
        s.ball(1.05, (0, 0, 4.6), c, rough=0.3)
        s.proxy_cylinder(1.9, (0, 0.9), 1.5)
        s.proxy_cylinder(0.9, (0.9, 3.6), 1.0)
        s.proxy_cylinder(1.0, (3.6, 5.6), 0.8)
        return
    if kind == "die":
        s.box((1.6, 1.6, 1.6), (0, 0, 0.8), c, solid=1, rough=0.3)
        dots = {
            1: [(0, 0)],
            2: [(-1, -1), (1, 1)],
            3: [(-1, -1), (0, 0), (1, 1)],
            5: [(-1, -1), (1, 1), (-1, 1), (1, -1), (0, 0)],
        }
        for y, z in dots[2]:
            s.rod(
                0.16,
                (0.79, y * 0.4, 0.8 + z * 0.4),
                (0.81, y * 0.4, 0.8 + z * 0.4),
                DARK,
                sections=14,
            )
        for x, z in dots[3]:
            s.rod(
                0.16,
                (x * 0.4, 0.79, 0.8 + z * 0.4),
                (x * 0.4, 0.81, 0.8 + z * 0.4),
                DARK,
                sections=14,
            )
            s.rod(
                0.16,
                (x * 0.4, -0.81, 0.8 + z * 0.4),
                (x * 0.4, -0.79, 0.8 + z * 0.4),
                DARK,
                sections=14,
            )
        for x, y in dots[5]:
            s.rod(0.16, (x * 0.4, y * 0.4, 1.59), (x * 0.4, y * 0.4, 1.61), DARK, sections=14)
        return
    if kind == "top":
        s.lathe(
            [(0, 0), (0.5, 0), (0.6, 0.8), (3, 2.6), (3, 3.4), (0.6, 4), (0.45, 6.4), (0, 6.6)],
            c,
            rough=0.3,
        )
        s.lathe([(2.95, 2.7), (3.06, 2.7), (3.06, 3.3), (2.95, 3.3), (2.95, 2.7)], YELLOW)
        s.proxy_cylinder(1.3, (0, 1.4), 1.0)
        s.proxy_cylinder(2.9, (1.4, 3.6), 1.0)
        s.proxy_cylinder(0.6, (3.6, 6.6), 0.4)
        return
    s.slab((-4.4, 4.4), (-3.15, 3.15), (0, 0.06), WHITE, solid=1)
    s.slab((-3.9, 3.9), (-2.7, 2.7), (0.06, 0.07), c)
    s.slab((-3.4, 3.4), (-2.2, 2.2), (0.07, 0.08), WHITE)


@builder("balloon")
def balloon(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Toy balloon with its knot, 30 cm."""
    s.lathe(
        [
            (0, 0),
            (1.2, 0),
            (0.8, 1.4),
            (3, 4),
            (10, 12),
            (13.4, 22),
            (10.6, 31),
            (5, 34.4),
            (0, 35),
        ],
        c,
        smooth=50,
        rough=0.15,
    )
    s.proxy_cylinder(6.0, (0, 8), 1.0)
    s.proxy_cylinder(12.5, (8, 32), 1.0)
    s.proxy_cylinder(5, (32, 35), 0.6)


@builder("kite")
def kite(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Diamond kite lying flat with a tail, 80 cm."""
    for sign, tone in ((1, c), (-1, shade(c, 0.8))):
        s.extrude([(40, 0), (10, sign * 34), (-44, 0)], (0.8, 1.0), tone, plane="xy")
    s.rod(0.5, (-44, 0, 1.2), (40, 0, 1.2), WOOD, sections=8)
    s.rod(0.5, (10, -34, 1.2), (10, 34, 1.2), WOOD, sections=8)
    for k in range(4):
        s.box((6, 3, 0.5), (-52 - 12 * k, 2.4 * math.sin(2 * k), 0.3), YELLOW)
    s.pipe(0.3, [(-44, 0, 0.3), (-60, 2, 0.3), (-76, -2, 0.3), (-90, 0, 0.3)], DARK)
    s.proxy_hull(
        [
            (40, 0, 0),
            (10, 34, 0),
            (10, -34, 0),
            (-44, 0, 0),
            (40, 0, 1.7),
            (10, 34, 1.7),
            (10, -34, 1.7),
            (-44, 0, 1.7),
        ]
    )
    shift(s, 25)


@builder("hat")
def hat(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "hat") -> None:
    """Brimmed hat, or a safety helmet."""
    if kind == "helmet":
        s.lathe(
            [(0, 0), (12.8, 0), (12.6, 5), (10.4, 10), (6, 13.2), (0, 14)], c, smooth=30, rough=0.3
        )
        s.lathe([(0, 0), (13, 0), (13, 0.8), (0, 0.8)], DARK)
        blob(s, [((-6, 0, 12), 1.2), ((6, 0, 12), 1.2), ((0, 0, 13.2), 1.2)], shade(c, 0.8))
        s.extrude(
            [(8, -8), (16.5, -6), (18, 0), (16.5, 6), (8, 8)], (0, 1.2), c, plane="xy", soft=1
        )
        s.proxy_cylinder(12, (0, 6), 1.0)
        s.proxy_cylinder(8.5, (6, 14), 0.8)
        shift(s, -2)
        return
    s.extrude(
        [(16 * math.cos(math.pi * k / 16), 14 * math.sin(math.pi * k / 16)) for k in range(32)],
        (0, 0.8),
        c,
        plane="xy",
    )
    s.lathe([(0, 0.6), (9.6, 0.6), (9.2, 8), (7.6, 11.4), (0, 11)], c, smooth=30, rough=0.95)
    s.lathe([(9.5, 1), (9.8, 1), (9.7, 3.6), (9.4, 3.6), (9.5, 1)], DARK)
    s.proxy_cylinder(13, (0, 0.8), 1.0)
    s.proxy_cylinder(9, (0.8, 11.2), 0.8)


@builder("watch_glasses")
def watch_glasses(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A pair of glasses, opened, lying as worn; facing +X."""
    for side in (-1, 1):
        s.torus(2.6, 0.28, (6.4, side * 3.4, 2.9), c, axis="x")
        s.rod(2.5, (6.36, side * 3.4, 2.9), (6.44, side * 3.4, 2.9), DARK, rough=0.05, alpha=0.7)
        s.pipe(0.25, [(6.4, side * 6.0, 3.6), (-5, side * 6.6, 3.8), (-7.4, side * 6.4, 0.25)], c)
    s.rod(0.26, (6.4, -0.9, 3.4), (6.4, 0.9, 3.4), c, sections=10)
    s.proxy_slab((5.8, 7), (-6.4, 6.4), (0, 5.8), 1.0)
    for side in (-1, 1):
        s.proxy_slab((-7.6, 5.8), mirrored(side, 6.0, 6.8), (0, 4), 0.5)
    shift(s, 0.4, 0, -0.0)


@builder("paper_stack", "free")
def paper_stack(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "paper") -> None:
    """A sheet of paper, an envelope or a folded newspaper, flat, at any size."""
    base = 0.8 * H
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, base), c)
    if kind == "envelope":
        flap = [(L / 2, -W / 2), (L / 2, W / 2), (-0.06 * L, 0)]
        s.extrude(flap, (base, H), shade(c, 0.85), plane="xy")
    else:
        dark, rows = (DARK, 6) if kind == "newspaper" else (rgb(90, 92, 98), 10)
        for k in range(rows):
            x = L * (0.4 - 0.8 * k / (rows - 1))
            end = W * (0.4 - (0.4 if kind == "newspaper" else 0.12) * (k % 3) / 2)
            s.slab((x - 0.012 * L, x + 0.012 * L), (-0.4 * W, end), (base, H), dark)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, base))


@builder("standing_flag")
def standing_flag(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "flag") -> None:
    """Flag on a pole with a foot, tripod, or coat stand."""
    if kind == "flag":
        s.rod(20, (0, 0, 0), (0, 0, 4), DARK)
        s.rod(1.6, (0, 0, 4), (0, 0, 220), STEEL, metal=0.5, sections=14)
        s.ball(3.2, (0, 0, 222), YELLOW)
        wave = [(y, 2.6 * math.sin(0.12 * y)) for y in range(0, 91, 6)]
        s.add(lambda: _cloth(wave, 152.0, 214.0), c, 0.9)
        s.add(lambda: _cloth(wave, 172.0, 194.0, 0.7), WHITE, 0.9)
        s.proxy_cylinder(20, (0, 4), 8.0)
        s.proxy_cylinder(2, (4, 222), 0.6)
        s.proxy_slab((-2, 2), (-88, -2), (152, 214), 0.02)
        shift(s, 0, 35)
        return
    spread = 26 if kind == "tripod" else 20
    top = 130 if kind == "tripod" else 40
    for k in range(3):
        a = 2 * math.pi * k / 3
        s.rod(
            1.5,
            (spread * 1.2 * math.cos(a), spread * 1.2 * math.sin(a), 1),
            (0, 0, top),
            DARK,
            sections=12,
        )
        s.proxy_slab(
            (spread * 1.2 * math.cos(a) - 2, spread * 1.2 * math.cos(a) + 2),
            (spread * 1.2 * math.sin(a) - 2, spread * 1.2 * math.sin(a) + 2),
            (0, top * 0.12),
            3.0,
        )
    if kind == "tripod":
        s.rod(2.4, (0, 0, 128), (0, 0, 142), DARK)
        s.slab((-6, 7), (-6, 6), (142, 152), c)
        s.rod(3, (7, 0, 147), (13, 0, 147), c)
        s.proxy_slab((-14, 14), (-14, 14), (top * 0.12, 60), 0.3)
        s.proxy_slab((-6, 6), (-6, 6), (60, 152), 0.4)
        shift(s, -7.8)
        return
    s.rod(2.2, (0, 0, 20), (0, 0, 178), c, sections=16)
    s.ball(3.4, (0, 0, 178), c)
    for k in range(6):
        a = math.pi * k / 3
        u = (math.cos(a), math.sin(a))
        s.pipe(1.0, [(0, 0, 160), (13 * u[0], 13 * u[1], 160), (17 * u[0], 17 * u[1], 172)], c)
    s.proxy_slab((-14, 14), (-14, 14), (4.8, 30), 0.3)
    s.proxy_cylinder(2.2, (30, 160), 0.6)
    s.proxy_cylinder(16, (156, 174), 0.2)
    shift(s, -4)


def _cloth(wave: list[tuple[float, float]], z0: float, z1: float, half: float = 0.4) -> object:
    from esg.assets.lazy import shapes

    front = [(x + half, -y) for y, x in wave]
    back = [(x - half, -y) for y, x in wave[::-1]]
    return shapes.extrude(front + back, (z0, z1), "xy")


@builder("chandelier")
def chandelier(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "chandelier") -> None:
    """Chandelier resting on its lowest knob ring, 60 cm; or a hand lantern."""
    if kind == "lantern":
        s.rod(8, (0, 0, 0), (0, 0, 4), c)
        s.rod(6.6, (0, 0, 4), (0, 0, 19), (0.98, 0.9, 0.62), rough=0.1, alpha=0.6)
        s.rod(1.2, (0, 0, 4), (0, 0, 12), WHITE)
        for k in range(4):
            a = math.pi / 4 + math.pi * k / 2
            s.rod(
                0.5,
                (7 * math.cos(a), 7 * math.sin(a), 4),
                (7 * math.cos(a), 7 * math.sin(a), 19),
                c,
                sections=8,
            )
        s.lathe([(0, 19), (8.4, 19), (5, 24), (0, 25)], c)
        s.pipe(0.5, [(0, -7, 21), (0, -8, 28), (0, 0, 33), (0, 8, 28), (0, 7, 21)], c)
        s.proxy_cylinder(8, (0, 24), 1.0)
        s.proxy_slab((-0.6, 0.6), (-8, 8), (24, 33), 0.1)
        return
    s.lathe(
        [(0, 0), (9, 0), (12, 4), (4, 10), (3, 30), (6, 36), (2, 42), (2, 56), (0, 58)],
        c,
        smooth=40,
        metal=0.8,
        rough=0.3,
    )
    for k in range(8):
        a = math.pi * k / 4
        u = (math.cos(a), math.sin(a))
        s.pipe(
            0.9,
            [(4 * u[0], 4 * u[1], 16), (16 * u[0], 16 * u[1], 9), (27 * u[0], 27 * u[1], 18)],
            c,
        )
        s.rod(3, (27 * u[0], 27 * u[1], 18), (27 * u[0], 27 * u[1], 19.5), c, sections=18)
        s.rod(1.1, (27 * u[0], 27 * u[1], 19.5), (27 * u[0], 27 * u[1], 27), WHITE, sections=14)
        s.ball(1, (27 * u[0], 27 * u[1], 29), (0.98, 0.86, 0.5), scale=(0.9, 0.9, 2), detail=2)
    s.proxy_cylinder(11, (0, 10), 2.0)
    s.proxy_cylinder(29, (10, 28), 0.4)
    s.proxy_cylinder(5, (28, 57), 0.5)


@builder("bag")
def bag(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "sack") -> None:
    """Sack, paper bag, gym bag, handbag or briefcase."""
    if kind == "sack":
        s.lathe(
            [(0, 0), (18, 0), (22, 6), (22, 30), (17, 44), (6, 50), (5, 53), (9, 60), (0, 58)],
            c,
            smooth=40,
            rough=1.0,
        )
        s.torus(5.4, 1.0, (0, 0, 51.5), shade(c, 0.6))
        s.proxy_cylinder(21, (0, 36), 1.0)
        s.proxy_cylinder(15, (36, 46), 0.8)
        s.proxy_cylinder(7, (46, 60), 0.5)
    elif kind == "paper":
        s.slab((-8, 8), (-13, 13), (0, 32), c, rough=1.0)
        for x in (-6, 6):
            s.pipe(0.5, [(x, -5, 31.5), (x, -5, 38), (x, 5, 38), (x, 5, 31.5)], shade(c, 0.7))
        s.slab((8, 8.2), (-6, 6), (12, 22), shade(c, 0.7))
        s.proxy_slab((-8, 8), (-13, 13), (0, 32))
        s.proxy_slab((-6, 6), (-5, 5), (32, 38), 0.05)
    elif kind == "gym":
        s.rod(14, (0, -27, 14.4), (0, 27, 14.4), c, rough=0.9)
        s.slab((-13, 13), (-26, 26), (0, 10), c, rough=0.9)
        for y in (-27, 27):
            s.rod(14.4, (0, y - 0.6, 14.4), (0, y + 0.6, 14.4), shade(c, 0.6))
        for side in (-1, 1):
            s.pipe(
                1.0,
                [(side * 9, -10, 24), (side * 3, -8, 34), (side * 3, 8, 34), (side * 9, 10, 24)],
                DARK,
            )
        s.proxy_slab((-13, 13), (-27, 27), (0, 27))
        s.proxy_slab((-4, 4), (-9, 9), (27, 35), 0.05)
    elif kind == "handbag":
        prism(
            s,
            [(x * 6, y * 15, 0) for x in (-1, 1) for y in (-1, 1)]
            + [(x * 3, y * 12, 20) for x in (-1, 1) for y in (-1, 1)],
            c,
            rough=0.5,
        )
        s.pipe(0.9, [(0, -9, 19), (0, -8, 30), (0, 8, 30), (0, 9, 19)], shade(c, 0.7))
        s.box((1, 4, 2), (3.6, 0, 17), BRASS, metal=0.8)
        s.proxy_slab((-5.6, 5.6), (-14, 14), (0, 20))
        s.proxy_slab((-0.9, 0.9), (-9, 9), (20, 31), 0.1)
    else:
        s.slab((-5, 5), (-21, 21), (0, 31), c, rough=0.5)
        s.slab((-5.2, 5.2), (-21.2, 21.2), (20, 21), shade(c, 0.5))
        s.pipe(1.0, [(0, -6, 31), (0, -6, 35), (0, 6, 35), (0, 6, 31)], DARK)
        for y in (-13, 13):
            s.box((1, 3, 3), (5.2, y, 21), BRASS, metal=0.8)
        s.proxy_slab((-5, 5), (-21, 21), (0, 31))
        s.proxy_slab((-1, 1), (-7, 7), (31, 36), 0.1)


@builder("aquarium")
def aquarium(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Filled aquarium with gravel, plants and fish, 40 x 80 x 46."""
    s.slab((-20, 20), (-40, 40), (0, 2), DARK)
    s.slab((-19.6, 19.6), (-39.6, 39.6), (2, 42), rgb(120, 190, 220), rough=0.02, alpha=0.35)
    s.slab((-19, 19), (-39, 39), (2, 7), rgb(196, 172, 126))
    s.slab((-20, 20), (-40, 40), (42, 46), DARK)
    for y, x, h in ((-28, 4, 26), (-22, -8, 32), (24, 0, 28), (30, 8, 18)):
        for k in range(3):
            bone(
                s,
                (x, y + k * 1.6, 6),
                0.9,
                (x + 3 * math.sin(k), y + k * 2.4, h),
                0.4,
                rgb(46, 130, 60),
            )
    for x, y, z in ((6, -8, 24), (-4, 10, 30), (8, 14, 17)):
        s.ball(1, (x, y, z), rgb(236, 120, 40), scale=(1.2, 3.4, 1.8))
        prism(
            s,
            [
                (x, y - 3, z),
                (x + 0.3, y - 3, z),
                (x, y - 5.4, z + 1.8),
                (x, y - 5.4, z - 1.8),
                (x + 0.3, y - 5.4, z + 1.8),
                (x + 0.3, y - 5.4, z - 1.8),
            ],
            rgb(236, 120, 40),
        )
    s.proxy_slab((-20, 20), (-40, 40), (0, 46))
    s.surface("lid", 46, (18, 38))


@builder("safe")
def safe(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Steel safe with a dial facing +X, 50 x 50 x 60."""
    s.slab((-25, 24), (-25, 25), (2, 60), c, rough=0.5, metal=0.3)
    s.slab((24, 26), (-22, 22), (5, 57), shade(c, 0.8), metal=0.3)
    s.rod(5, (26, 6, 34), (28.6, 6, 34), CHROME, metal=0.9)
    s.rod(0.9, (27.4, -12, 34), (27.4, -2, 34), CHROME, metal=0.9)
    for x in (-20, 18):
        for y in (-20, 20):
            s.slab((x - 3, x + 3), (y - 3, y + 3), (0, 2), DARK)
    s.proxy_slab((-25, 25), (-25, 25), (0, 60))
    s.surface("top", 60, (23, 23))
    shift(s, -1.6)


@builder("gift")
def gift(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "gift") -> None:
    """Wrapped gift with a bow, ingot, bar of soap or a washing sponge."""
    if kind == "ingot":
        prism(
            s,
            [(x * 12.5, y * 3.6, 0) for x in (-1, 1) for y in (-1, 1)]
            + [(x * 11.6, y * 2.7, 3.7) for x in (-1, 1) for y in (-1, 1)],
            c,
            metal=0.9,
            rough=0.25,
        )
        s.proxy_slab((-12, 12), (-3.2, 3.2), (0, 3.7))
        return
    s.slab((-12, 12), (-12, 12), (0, 17), c, rough=0.5)
    s.slab((-12.6, 12.6), (-12.6, 12.6), (15, 20), shade(c, 1.1), rough=0.5)
    for a in (0, 1):
        x, y = ((-1.6, 1.6), (-12.8, 12.8)) if a else ((-12.8, 12.8), (-1.6, 1.6))
        s.slab(x, y, (0, 20.3), YELLOW)
    for side in (-1, 1):
        s.ball(1, (0, side * 3.6, 22.4), YELLOW, scale=(2, 3.6, 2.2))
    s.ball(1.6, (0, 0, 21.6), YELLOW)
    s.proxy_slab((-12, 12), (-12, 12), (0, 20))
    s.proxy_slab((-2, 2), (-6, 6), (20, 24), 0.1)
    s.surface("top", 20, (11, 11))
