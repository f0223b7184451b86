"""Sports gear of ice, field, water and gymnasium."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import blob, bone, prism, shade, shift
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    RED,
    RUBBER,
    STEEL,
    WHITE,
    WOOD,
    YELLOW,
    Color,
    Sketch,
)


@builder("hockey_stick")
def hockey_stick(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ice-hockey stick lying flat, blade to +X; 150 cm."""
    s.slab((-66, 66), (-1.2, 1.2), (0.2, 2.2), c)
    s.slab((-66, -44), (-1.5, 1.5), (0, 2.4), DARK)
    s.extrude(
        [(62, -1.2), (62, 1.2), (67, 8), (78, 26), (84, 24), (74, 4), (69, -1.2)],
        (0.6, 1.8),
        DARK,
        plane="xy",
    )
    s.proxy_slab((-66, 66), (-1.4, 1.4), (0, 2.4))
    s.proxy_slab((66, 82), (-1, 26), (0, 2.2), 0.6)
    shift(s, -9, -12)


@builder("golf_club")
def golf_club(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Golf club lying flat, head to +X; 100 cm."""
    s.lathe([(0, -50), (1.4, -50), (1.0, -22), (0, -22)], DARK, center=(0, 0, 1.4), axis="x")
    s.rod(0.6, (-24, 0, 1.4), (46, 0, 1.4), CHROME, metal=0.9, sections=14)
    prism(
        s,
        [
            (44, 0.8, 0.2),
            (44, -0.8, 0.2),
            (44, 0.8, 2.4),
            (50, -1, 0),
            (52, 10, 0),
            (48, 10, 0),
            (46, 10, 3.4),
            (48.5, 10.4, 3.4),
            (50, 0, 3),
        ],
        CHROME,
        rough=0.3,
        metal=0.8,
    )
    s.proxy_slab((-50, 46), (-1.2, 1.2), (0, 2.6), 1.0)
    s.proxy_slab((45, 51.5), (-1, 10), (0, 3.4), 3.0)
    shift(s, -1, -4.5)


@builder("shuttlecock")
def shuttlecock(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Badminton shuttlecock on its side, cork to +X; 8 cm."""
    z = 3.2
    s.ball(1.3, (3.0, 0, z), c)
    s.rod(1.3, (1.6, 0, z), (3.0, 0, z), c, sections=24)
    s.lathe(
        [(1.1, 1.7), (3.2, -4.2), (3.1, -4.3), (1.0, 1.6), (1.1, 1.7)],
        WHITE,
        center=(0, 0, z),
        axis="x",
    )
    for k in range(12):
        a = math.pi * k / 6
        s.rod(
            0.1,
            (1.7, 1.08 * math.cos(a), z + 1.08 * math.sin(a)),
            (-4.2, 3.15 * math.cos(a), z + 3.15 * math.sin(a)),
            WHITE,
            sections=6,
        )
    s.proxy_hull(
        [
            (
                -4.2,
                3.2 * math.cos(math.pi * k / 4 + math.pi / 8),
                z + 3.2 * math.sin(math.pi * k / 4 + math.pi / 8) * 1.0,
            )
            for k in range(8)
        ]
        + [(-4.2, -1.2, 0.0), (-4.2, 1.2, 0.0), (1.8, -0.6, 0.0), (1.8, 0.6, 0.0)]
        + [(4.2, 0, z), (3.4, 0, z + 1.2)]
    )


@builder("barbell")
def barbell(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "kettlebell") -> None:
    """Kettlebell, 28 cm; anvil; anchor by its kind."""
    if kind == "kettlebell":
        s.lathe([(0, 0), (7, 0), (10.4, 6), (10.4, 11), (7, 17), (0, 19)], c, smooth=30, rough=0.5)
        s.pipe(
            1.7,
            [(0, -5.6, 15), (0, -6.6, 22), (0, -4, 26.3), (0, 4, 26.3), (0, 6.6, 22), (0, 5.6, 15)],
            c,
        )
        s.proxy_cylinder(7, (0, 3), 1.0)
        s.proxy_cylinder(10, (3, 16), 1.0)
        s.proxy_slab((-1.7, 1.7), (-8, 8), (16, 28), 0.7)
        return
    s.extrude(
        [
            (-13, 0),
            (13, 0),
            (13, 4),
            (7, 7),
            (6, 14),
            (14, 19),
            (16, 26),
            (-16, 26),
            (-16, 20),
            (-6, 15),
            (-7, 7),
            (-13, 4),
        ],
        (-6.5, 6.5),
        c,
        rough=0.5,
        metal=0.6,
    )
    bone(s, (15, 0, 22), 4, (33, 0, 24.6), 1.2, c, metal=0.6)
    s.proxy_slab((-13, 13), (-9, 9), (0, 5), 1.0)
    s.proxy_slab((-7, 7), (-6.5, 6.5), (5, 16), 1.0)
    s.proxy_slab((-16, 16), (-6.5, 6.5), (16, 26), 1.0)
    s.proxy_slab((16, 33), (-3, 3), (19, 26), 0.5)
    s.slab((-13, 13), (-9, 9), (0, 3), c, metal=0.6)
    s.surface("face", 26, (15, 6))
    shift(s, -9)


@builder("curling_stone")
def curling_stone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Granite curling stone with a handle, 28 cm."""
    s.lathe(
        [(0, 0), (7, 0), (12.6, 3), (14, 6.5), (12.6, 10.4), (8, 12), (0, 12.2)],
        c,
        smooth=30,
        rough=0.35,
    )
    s.lathe([(14.0, 5.6), (14.3, 5.6), (14.3, 7.4), (14.0, 7.4), (14.0, 5.6)], shade(c, 0.6))
    s.pipe(1.2, [(-4, 0, 12), (-4, 0, 15.6), (0, 0, 16.2), (8, 0, 16.6)], RED)
    s.proxy_cylinder(9, (0, 1.5), 1.0)
    s.proxy_cylinder(14, (1.5, 12), 1.0)
    s.proxy_slab((-5, 8), (-1.4, 1.4), (12, 17), 0.1)


@builder("board_sport")
def board_sport(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "surfboard") -> None:
    """Surfboard, snowboard or a pair of skis, flat on the ground, nose to +X."""
    if kind == "skis":
        for side in (-1, 1):
            y = side * 8
            s.slab((-84, 70), (y - 4, y + 4), (0, 1.4), c)
            prism(
                s,
                [
                    (70, y - 4, 0),
                    (70, y + 4, 0),
                    (70, y - 4, 1.4),
                    (70, y + 4, 1.4),
                    (84, y, 6),
                    (84, y, 7),
                ],
                c,
            )
            s.slab((-16, 12), (y - 3, y + 3), (1.4, 5), DARK)
            s.proxy_slab((-84, 72), (y - 4, y + 4), (0, 1.6), 1.0)
            s.proxy_slab((-16, 12), (y - 3, y + 3), (1.6, 5.4), 0.6)
        return
    half, wide, thick = (92.0, 26.0, 7.0) if kind == "surfboard" else (76.0, 14.5, 2.4)
    n = 24
    plan = []
    for k in range(n):
        a = 2 * math.pi * k / n
        x, y = math.cos(a), math.sin(a)
        plan.append(
            (
                half * math.copysign(abs(x) ** 0.75, x),
                wide * math.copysign(abs(y) ** (0.9 if kind == "surfboard" else 0.5), y),
            )
        )
    s.extrude(plan, (0, thick), c, plane="xy", rough=0.25)
    if kind == "surfboard":
        s.slab((-half * 0.94, half * 0.94), (-1, 1), (thick - 0.2, thick + 0.2), RED)
        s.slab(
            (-half * 0.5, half * 0.5),
            (-wide * 0.93, wide * 0.93),
            (thick - 0.3, thick + 0.1),
            shade(c, 0.8),
        )
    else:
        for x in (-26, 26):
            s.slab((x - 8, x + 8), (-9, 9), (thick, thick + 2.4), DARK)
            s.proxy_slab((x - 8, x + 8), (-9, 9), (thick, thick + 2.4), 0.4)
    s.proxy_slab((-half * 0.8, half * 0.8), (-wide * 0.85, wide * 0.85), (0, thick))
    s.surface("deck", thick, (half * 0.6, wide * 0.6))


@builder("punching_bag")
def punching_bag(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Free-standing punching bag, 170 cm."""
    s.lathe([(0, 0), (28, 0), (28, 8), (18, 24), (12, 30), (0, 30)], DARK, smooth=0)
    s.rod(6, (0, 0, 30), (0, 0, 50), STEEL)
    s.lathe([(0, 48), (17, 48), (18, 54), (18, 164), (15, 170), (0, 170)], c, rough=0.5)
    for z in (70, 148):
        s.lathe([(18, z), (18.4, z), (18.4, z + 5), (18, z + 5), (18, z)], WHITE)
    s.proxy_cylinder(28, (0, 12), 4.0)
    s.proxy_cylinder(18, (12, 170), 0.5)


@builder("hurdle")
def hurdle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Athletics hurdle facing +X, 107 x 120 cm."""
    for side in (-1, 1):
        s.slab((-50, 20), (side * 56 - 2, side * 56 + 2), (0, 4), STEEL)
        s.slab((14, 18), (side * 56 - 2, side * 56 + 2), (4, 100), STEEL)
    s.slab((14, 18), (-60, 60), (97, 107), c)
    for y in (-44, 0, 44):
        s.slab((17.9, 18.3), (y - 9, y + 9), (97.2, 106.8), DARK)
    for side in (-1, 1):
        s.proxy_slab((-50, 20), (side * 56 - 2, side * 56 + 2), (0, 4), 3.0)
        s.proxy_slab((14, 18), (side * 56 - 2, side * 56 + 2), (4, 97), 1.0)
    s.proxy_slab((14, 18), (-60, 60), (97, 107), 0.6)
    shift(s, 15)


@builder("pommel_horse")
def pommel_horse(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Gymnastics pommel horse, 160 cm along X."""
    blob(s, [((-64, -6, 98), 13), ((64, -6, 98), 13), ((-64, 6, 98), 13), ((64, 6, 98), 13)], c)
    for x in (-22, 22):
        s.pipe(2, [(x, -11, 108), (x, -10, 121), (x, 10, 121), (x, 11, 108)], WOOD)
    for x in (-40, 40):
        s.rod(4.5, (x, 0, 4), (x, 0, 90), STEEL, metal=0.5)
        s.slab((x - 6, x + 6), (-38, 38), (0, 5), DARK)
        s.proxy_slab((x - 6, x + 6), (-38, 38), (0, 5), 3.0)
        s.proxy_slab((x - 4, x + 4), (-4, 4), (5, 86), 1.0)
    s.proxy_slab((-77, 77), (-18, 18), (86, 111), 0.5)
    s.surface("top", 111, (70, 15))


@builder("ice_skate")
def ice_skate(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "shoe") -> None:
    """A shoe, a boot, or a roller skate; toe to +X, 29 cm."""
    sole = 4.6 if kind == "skate" else 0.0
    s.extrude(
        [
            (-14, -3.4),
            (-14, 3.4),
            (-4, 3.6),
            (6, 5),
            (12, 4.4),
            (14.4, 0),
            (12, -4.4),
            (6, -5),
            (-4, -3.6),
        ],
        (sole, sole + 2.2),
        RUBBER if kind != "shoe" else WHITE,
        plane="xy",
        soft=1,
    )
    high = 22.0 if kind == "boot" else 13.0 if kind == "skate" else 8.6
    blob(
        s,
        [((-9, 0, sole + 4.6), 4.0), ((9.4, 0, sole + 4.2), 3.9), ((2, 0, sole + 5), 4.2)],
        c,
        rough=0.6,
    )
    blob(
        s,
        [
            ((-8.6, 0, sole + 5), 4.0),
            ((-8, 0, sole + high - 2), 3.8),
            ((-2.6, 0, sole + high - 3), 3.4),
        ],
        c,
        rough=0.6,
    )
    s.rod(3.2, (-6, 0, sole + high), (-6, 0, sole + high + 1.2), DARK)
    for k in range(4):
        s.rod(
            0.3,
            (1.6 + 2 * k, -2.6, sole + 9.2 - 0.2 * k),
            (1.6 + 2 * k, 2.6, sole + 9.2 - 0.2 * k),
            WHITE,
            sections=8,
        )
    if kind == "skate":
        for x in (-9, 9):
            for side in (-1, 1):
                s.rod(2.6, (x, side * 1.6, 2.6), (x, side * 3.8, 2.6), YELLOW, sections=20)
    s.proxy_slab((-14, 14), (-4.4, 4.4), (0, sole + 7.5))
    s.proxy_slab((-12.4, 0), (-3.8, 3.8), (sole + 7.5, sole + high + 1), 0.6)
