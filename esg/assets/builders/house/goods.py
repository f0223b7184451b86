"""Small things of the house: toys, clothes, bags, flags, things to write and play with."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import blob, mirrored, prism, shade, shift
from esg.assets.geometry.sketch import BRASS, DARK, STEEL, WHITE, WOOD, YELLOW, Color, Sketch, rgb
from esg.assets.lazy import shapes


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

    front = [(x + half, -y) for y, x in wave]
    back = [(x - half, -y) for y, x in wave[::-1]]
    return shapes.extrude(front + back, (z0, z1), "xy")


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
