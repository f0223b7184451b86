"""Sports gear of ice, field, water and gymnasium."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import blob, prism, shade, shift
from esg.assets.geometry.sketch import (
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
        s.rod(4.5, (x, 0, 4), (x, 0, 90), STEEL)
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
