"""Bows, arrows and other things thrown, and what is aimed at."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored, prism, shift
from esg.assets.geometry.rotations import turn
from esg.assets.geometry.sketch import (
    BRASS,
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

_RINGS = (WHITE, DARK, rgb(60, 140, 200), RED, YELLOW)


@builder("arrow")
def arrow(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "arrow") -> None:
    """Arrow, spear or dart lying along +X."""
    if kind == "dart":
        z = 0.9
        s.lathe(
            [(0, -3.4), (0.35, -3.4), (0.42, 2), (0.2, 3.2), (0, 3.2)],
            BRASS,
            center=(0, 0, z),
            axis="x",
        )
        s.rod(0.1, (3, 0, z), (7.5, 0, z), STEEL, sections=10)
        s.rod(0.22, (-7.5, 0, z), (-3, 0, z), DARK, sections=10)
        r0, r1, k = 0.15, 0.9, 2.6
        for a in (0, 90, 180, 270):
            u = (math.cos(math.radians(a + 45)), math.sin(math.radians(a + 45)))
            prism(
                s,
                [
                    (x, u[0] * r - u[1] * t, z + u[1] * r + u[0] * t)
                    for x, r in ((-7.5, r0), (-4.5, r0), (-7.8, r1), (-7.5 + k * 0.6, r1))
                    for t in (-0.03, 0.03)
                ],
                c,
            )
        s.proxy_slab((-7.6, 4), (-0.55, 0.55), (0, 1.4))
        s.proxy_slab((4, 7.4), (-0.2, 0.2), (0.6, 1.2), 0.4)
        shift(s, 0.1, 0, -0.25 + 0.0)
        s.proxies[:] = [
            p.model_copy(update={"position_cm": (*p.position_cm[:2], p.position_cm[2] + 0.25)})
            for p in s.proxies
        ]
        return
    half, r, z = (38.0, 0.4, 2.0) if kind == "arrow" else (110.0, 1.3, 3.4)
    s.rod(r, (-half, 0, z), (half * 0.92, 0, z), c, sections=14)
    tip = half * 0.08
    prism(
        s,
        [
            (half * 0.9, 0, z + 2.6 * r),
            (half * 0.9, 0, z - 2.6 * r),
            (half * 0.9, r, z),
            (half * 0.9, -r, z),
            (half * 0.9 + tip * 2, 0, z),
        ],
        STEEL,
    )
    if kind == "arrow":
        for a in (90, 210, 330):
            u = (math.cos(math.radians(a)), math.sin(math.radians(a)))
            prism(
                s,
                [
                    (x, u[0] * q - u[1] * t, z + u[1] * q + u[0] * t)
                    for x, q in ((-half, 0.3), (-half + 9, 0.3), (-half - 1, 2.3), (-half + 5, 2.1))
                    for t in (-0.06, 0.06)
                ],
                RED,
            )
        s.proxy_slab((-half, half * 0.9), (-1.5, 1.5), (0, 3.6))
        s.proxy_slab((half * 0.9, half * 1.05), (-0.5, 0.5), (1, 3), 1.0)
        shift(s, -1.0, 0, -0.85)
        s.proxies[:] = [
            p.model_copy(update={"position_cm": (*p.position_cm[:2], p.position_cm[2] + 0.85)})
            for p in s.proxies
        ]
        return
    s.proxy_slab((-half, half), (-1.3, 1.3), (0, 5.4))
    shift(s, -2, 0, 0.0)


@builder("bow")
def bow(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Archery bow lying flat, string towards -X, 150 cm across."""
    path = [
        (26 * math.cos(math.radians(a)) - 10, 75 * math.sin(math.radians(a)), 1.4)
        for a in range(-90, 91, 15)
    ]
    s.pipe(1.4, path, c)
    s.rod(0.25, (-10, -74, 1.4), (-10, 74, 1.4), WHITE, sections=8)
    s.rod(2.0, (16, -8, 2), (16, 8, 2), DARK, sections=16)
    for (x0, y0, _), (x1, y1, _) in zip(path[::3], path[3::3], strict=False):
        m, d = ((x0 + x1) / 2, (y0 + y1) / 2), math.hypot(x1 - x0, y1 - y0) / 2
        s.proxy_box(
            (1.6, d, 1.4),
            (m[0] + 1.5, m[1], 1.4),
            1.0,
            turn("z", math.degrees(math.atan2(y1 - y0, x1 - x0)) - 90),
        )
    shift(s, -3.3)


@builder("target")
def target(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "stand") -> None:
    """Archery target on a stand facing +X, 122 cm face; or a dartboard."""
    board = kind == "board"
    r, z = (22.5, 22.5) if board else (61.0, 100.0)
    depth = 4.0 if board else 14.0
    s.rod(r, (-depth / 2, 0, z), (depth / 2, 0, z), c, rough=0.95, sections=48)
    for k, tone in enumerate(_RINGS):
        q = r * (0.98 - 0.19 * k)
        s.rod(q, (depth / 2, 0, z), (depth / 2 + 0.15 * (k + 1), 0, z), tone, sections=48)
    if board:
        for k in range(20):
            a = math.radians(18 * k + 9)
            s.rod(
                0.12, (2.9, 0, z), (2.9, 22 * math.cos(a), z + 22 * math.sin(a)), STEEL, sections=6
            )
        s.slab((-14, -2), (-16, 16), (0, 2), DARK)
        s.slab((-14, 8), (-16, -12), (0, 2), DARK)
        s.slab((-14, 8), (12, 16), (0, 2), DARK)
        s.proxy_slab((-14, 8), (-16, 16), (0, 2), 2.0)
        s.proxy_slab((-2, 2.9), (-20, 20), (2, 44), 1.0)
        shift(s, 3)
        return
    for side in (-1, 1):
        s.rod(3, (-10, side * 40, 0), (-10, side * 26, 150), WOOD, sections=12)
        s.rod(3, (-46, side * 10, 1), (-12, side * 8, 140), WOOD, sections=12)
    s.rod(2.5, (-10, -40, 40), (-10, 40, 40), WOOD, sections=12)
    for side in (-1, 1):
        s.proxy_slab((-49, 7), mirrored(side, 34, 42), (0, 4), 3.0)
        s.proxy_slab((-14, -6), mirrored(side, 30, 40), (4, 44), 0.6)
    s.proxy_slab((-7, 7), (-50, 50), (44, 150), 0.6)
    shift(s, 20)


@builder("boomerang")
def boomerang(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Boomerang lying flat, 36 cm across."""
    s.extrude(
        [
            (10, 0),
            (4, 6),
            (-10, 18),
            (-13.5, 16),
            (-12, 12.5),
            (3.5, 0),
            (-12, -12.5),
            (-13.5, -16),
            (-10, -18),
            (4, -6),
        ],
        (0, 0.9),
        c,
        plane="xy",
        soft=0.6,
    )
    for side in (-1, 1):
        s.proxy_box((9.6, 2.2, 0.45), (-2.6, side * 8.6, 0.45), 1.0, turn("z", -45 * side))
    shift(s, 1.75)
