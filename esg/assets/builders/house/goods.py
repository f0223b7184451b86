"""Small things of the house: toys, clothes, bags, flags, things to write and play with."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import blob, mirrored, shade, shift
from esg.assets.geometry.sketch import DARK, STEEL, WHITE, WOOD, YELLOW, Color, Sketch, rgb
from esg.assets.lazy import shapes


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
        s.rod(1.6, (0, 0, 4), (0, 0, 220), STEEL, sections=14)
        s.ball(3.2, (0, 0, 222), YELLOW)
        wave: list[tuple[float, float]] = [(y, 2.6 * math.sin(0.12 * y)) for y in range(0, 91, 6)]
        s.add(lambda: _cloth(wave, 152.0, 214.0), c)
        s.add(lambda: _cloth(wave, 172.0, 194.0, 0.7), WHITE, of="linen")
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
