"""Ponds and cliffs, things that hang on stands, and a few one-offs: bean bag, shield, harp."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import prism, shade
from esg.assets.geometry.sketch import BRASS, DARK, DARK_WOOD, STEEL, WHITE, Color, Sketch, rgb

WATER = rgb(64, 134, 178)


@builder("pond", "free")
def pond(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Shallow basin on the ground behind a low bank that slopes gently outside, steeply inside."""
    n, crest, foot, floor = 16, 0.86, 0.8, 0.1 * H
    s.extrude(
        [(L / 2 * crest * math.cos(a), W / 2 * crest * math.sin(a)) for a in _turns(n)],
        (0, 0.45 * H),
        WATER,
        plane="xy",
        rough=0.05,
    )
    for k, a in enumerate(_turns(n)):
        b = a + 2 * math.pi / n
        wedge = [
            (f * L / 2 * math.cos(t), f * W / 2 * math.sin(t), z)
            for t in (a, b)
            for f, z in ((1.0, 0.0), (crest, H), (crest - 0.02, H), (foot, 0.0))
        ]
        prism(s, wedge, shade(c, 1.0 if k % 2 else 0.93), rough=1.0)
        s.proxy_hull(wedge)
    x, y = 0.62 * L / 2, 0.62 * W / 2
    s.proxy_slab((-x, x), (-y, y), (0, floor))
    s.surface("water", floor, (0.9 * x, 0.9 * y))
    s.region("inside", (-x, x), (-y, y), (0, 8 * H))


def _turns(n: int) -> list[float]:
    return [2 * math.pi * k / n for k in range(n)]


@builder("cliff", "free")
def cliff(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Rock with a flat top and sheer sides in uneven layers; the edge is at +X."""
    n = 7
    for k in range(n):
        low, high = H * k / n, H * (k + 1) / n
        s.slab(
            (-L / 2, L / 2 - L * (0.0, 0.03, 0.012, 0.04, 0.02, 0.035, 0.0)[k]),
            (-W / 2 + W * (0.0, 0.02, 0.03, 0.01, 0.025, 0.015, 0.0)[k], W / 2),
            (low, high if k == n - 1 else high + 0.004 * H),
            shade(c, (0.82, 0.95, 0.88, 1.0, 0.9, 0.97, 1.05)[k]),
            rough=1.0,
        )
    for y in (-0.3, 0.05, 0.36):
        s.slab(
            (L * 0.45, L / 2),
            (W * (y - 0.04), W * (y + 0.05)),
            (H * 0.1, H * (0.7 + y)) if y < 0.2 else (H * 0.2, H * 0.8),
            shade(c, 0.78),
            rough=1.0,
        )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("hanging", drawn=(50, 30, 120))
def hanging(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "lantern") -> None:
    """A lantern or a pendulum bob on the arm of a stand, drawn at 50 x 30 x 120."""
    s.slab((-25, 5), (-15, 15), (0, 4), DARK_WOOD, solid=6.0)
    s.rod(1.6, (-18, 0, 4), (-18, 0, 119), c)
    s.rod(1.2, (-18, 0, 118.8), (16, 0, 118.8), c, sections=18)
    s.rod(1.0, (-18, 0, 100), (-4, 0, 118), c, sections=14)
    s.proxy_slab((-19.6, -16.4), (-1.6, 1.6), (4, 120), 1.0)
    s.proxy_slab((-16.4, 16), (-1.2, 1.2), (117.6, 120), 1.0)
    if kind == "pendulum":
        s.rod(0.25, (14, 0, 54), (14, 0, 118), STEEL, sections=8)
        s.ball(7, (14, 0, 48), BRASS, rough=0.2, solid=0.5, detail=3)
        s.torus(1.2, 0.4, (14, 0, 55.2), STEEL, axis="y")
        s.box((22, 0.6, 1.2), (14, 0, 30), WHITE)
        s.rod(0.8, (-18, 0, 30), (3, 0, 30), c, sections=10)
        s.slab((24.4, 25), (-0.3, 0.3), (29, 31), DARK)
        return
    s.rod(0.35, (14, 0, 100), (14, 0, 118), STEEL, sections=8)
    s.lathe([(0, 92), (9, 92), (5, 98), (1, 101), (0, 101)], c, center=(14, 0, 0))
    s.rod(7, (14, 0, 76), (14, 0, 92), (0.98, 0.9, 0.62), rough=0.1, alpha=0.7)
    s.rod(8, (14, 0, 73), (14, 0, 76), c)
    for k in range(6):
        a = math.pi * k / 3
        x, y = 14 + 7.3 * math.cos(a), 7.3 * math.sin(a)
        s.rod(0.4, (x, y, 76), (x, y, 92), c, sections=8)
    s.slab((24, 25), (-0.5, 0.5), (74, 75), c)
    s.proxy_cylinder(8, (73, 100), 0.2, (14, 0))


@builder("bean_bag")
def bean_bag(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bean bag dented from sitting, drawn at 90 x 90 x 48."""
    s.lathe(
        [(0, 0), (36, 0), (44, 8), (45, 20), (41, 33), (32, 43), (20, 48), (9, 46), (0, 45)],
        c,
        smooth=60,
        rough=0.95,
    )
    for k in range(6):
        a = math.pi * k / 3
        path = [
            (r * math.cos(a), r * math.sin(a), z)
            for r, z in ((37, 3), (44, 9), (45, 20), (41, 33), (32, 42.6), (20, 47.4))
        ]
        s.pipe(0.5, path, shade(c, 0.7))
    s.proxy_cylinder(39, (0, 6))
    s.proxy_cylinder(44, (6, 32))
    s.proxy_cylinder(34, (32, 46), 0.8)
    s.surface("seat", 46, (22, 22))


@builder("shield")
def shield(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round wooden shield with a steel rim and boss lying on its back, drawn at 80 x 80 x 9."""
    s.lathe([(0, 0), (38.5, 0), (38.5, 2.2), (20, 4.2), (0, 4.6)], c, rough=0.7)
    s.lathe([(37.5, 0), (40, 0), (40, 3), (37.5, 3), (37.5, 0)], STEEL, rough=0.3)
    s.lathe([(0, 3), (11, 3), (10, 5.4), (6, 8.2), (0, 9)], STEEL, rough=0.3)
    for k in range(12):
        a = math.pi * k / 6
        s.rod(
            0.9,
            (38.7 * math.cos(a), 38.7 * math.sin(a), 2.6),
            (38.7 * math.cos(a), 38.7 * math.sin(a), 3.4),
            BRASS,
            sections=10,
        )
    for k in range(4):
        a = math.pi * k / 2
        u, v = (math.cos(a), math.sin(a)), (-math.sin(a), math.cos(a))
        corners = [
            (r * u[0] + q * v[0], r * u[1] + q * v[1], z)
            for r, z in ((11, 4.2), (36, 2.3))
            for q in (-1.6, 1.6)
        ]
        prism(s, [(x, y, z + d) for x, y, z in corners for d in (0, 0.6)], shade(c, 0.6))
    s.proxy_cylinder(40, (0, 3))
    s.proxy_cylinder(20, (3, 4.8))
    s.proxy_cylinder(9, (4.8, 9))


@builder("harp")
def harp(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Concert harp, column at +X, drawn at 100 x 44 x 180."""
    s.slab((-30, 50), (-22, 22), (0, 12), c, rough=0.3)
    s.lathe(
        [(0, 12), (6, 12), (4, 20), (3.4, 150), (5, 160), (6.5, 172), (4, 180), (0, 180)],
        c,
        center=(41, 0, 0),
        rough=0.3,
    )
    board = [(-30, 12), (-8, 12), (-36, 150), (-50, 150)]
    s.extrude(board, (-11, 11), shade(c, 0.85), rough=0.35)
    neck = [(-44, 0, 150), (-34, 0, 160), (-14, 0, 154), (8, 0, 148), (26, 0, 158), (41, 0, 170)]
    s.pipe(4.2, neck, c, rough=0.3)
    for k in range(22):
        x = -30 + 3 * k
        foot = 12 + max(0.0, (-8 - x) / 28 * 138)
        top = min(158.0, 150 + 0.2 * abs(x))
        if top - foot > 8:
            s.rod(0.18, (x, 0, foot), (x, 0, top), BRASS, sections=6)
    s.proxy_slab((-30, 50), (-22, 22), (0, 12), 1.5)
    s.proxy_slab((37, 45), (-4, 4), (12, 180))
    s.proxy_hull([(x, y, z) for x, z in board for y in (-11, 11)], 0.6)
    s.proxy_slab((-44, 37), (-4, 4), (150, 164))
