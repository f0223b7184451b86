"""Bottles, tableware and what is cooked with."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.collider import lying_hull
from esg.assets.geometry.sketch import DARK, DARK_WOOD, STEEL, YELLOW, Color, Sketch, rgb

PAPER = rgb(240, 236, 224)


@builder("bottle", drawn=(7.4, 7.4, 28.0))
def bottle(s: Sketch, L: float, W: float, H: float, c: Color, style: str = "wine") -> None:
    """Bottle, drawn at 7.4 x 7.4 x 28; body, shoulder and neck are stacked cylinders."""
    if style == "plastic":
        outer = [
            (0, 0),
            (3.3, 0),
            (3.7, 0.8),
            (3.7, 7),
            (3.4, 8),
            (3.7, 9),
            (3.7, 17),
            (3.3, 20),
            (1.6, 24),
            (1.3, 25.5),
            (0, 25.5),
        ]
        s.lathe(outer, c, rough=0.08, alpha=0.75)
        s.rod(1.5, (0, 0, 25), (0, 0, 28), (0.2, 0.4, 0.75))
    else:
        outer = [
            (0, 0),
            (3.3, 0),
            (3.7, 0.6),
            (3.7, 15),
            (3.4, 17),
            (2.3, 20),
            (1.55, 22.5),
            (1.4, 26),
            (0, 26),
        ]
        s.lathe(outer, c, rough=0.08, alpha=0.85)
        s.rod(1.55, (0, 0, 25.4), (0, 0, 28), YELLOW if style == "beer" else rgb(90, 20, 30))
    s.lathe([(3.5, 5), (3.74, 5), (3.74, 12), (3.5, 12), (3.5, 5)], PAPER)
    s.proxy_cylinder(3.7, (0, 16.5))
    s.proxy_cylinder(2.7, (16.5, 20.5), 0.8)
    s.proxy_cylinder(1.5, (20.5, 28), 0.8)


@builder("mug")
def mug(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Mug, handle at +Y, drawn at 8.4 x 11.8 x 9.5 and centred on its box."""
    y = -1.7
    s.lathe(
        [(0, 0), (3.8, 0), (4.2, 0.5), (4.2, 9.5), (3.8, 9.5), (3.8, 0.9), (0, 0.9)],
        c,
        center=(0, y, 0),
        rough=0.2,
    )
    n = 14
    arc = [
        (0.0, y + 4.0 + 2.9 * math.cos(t), 4.9 + 3.1 * math.sin(t))
        for t in (math.pi * (k / n - 0.5) for k in range(n + 1))
    ]
    s.pipe(0.6, arc, c, rough=0.2)
    s.tub(4.2, (0, 9.5), 0.5)
    s.proxies[:] = [
        p.model_copy(
            update={"position_cm": (p.position_cm[0], p.position_cm[1] + y, p.position_cm[2])}
        )
        for p in s.proxies
    ]
    s.proxy_slab((-0.6, 0.6), (y + 4.1, y + 7.4), (2, 8), 0.5)
    s.region("inside", (-2.4, 2.4), (y - 2.4, y + 2.4), (0.9, 9.5))


@builder("plate", "free")
def plate(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Dinner plate."""
    r = min(L, W) / 2
    s.lathe(
        [(0, 0), (r * 0.6, 0), (r, H * 0.8), (r, H), (r * 0.62, H * 0.45), (0, H * 0.4)],
        c,
        rough=0.1,
    )
    s.proxy_cylinder(r * 0.62, (0, H * 0.45))
    s.proxy_cylinder(r * 0.95, (H * 0.45, H))
    s.surface("top", H, (r * 0.6, r * 0.6))


@builder("bowl")
def bowl(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bowl, drawn at 16 x 16 x 7; hollow."""
    s.lathe(
        [(0, 0), (4, 0), (4, 0.6), (6.5, 2.6), (8, 7), (7.6, 7), (6.1, 3), (3.6, 1.2), (0, 1)],
        c,
        rough=0.15,
    )
    s.tub(6.0, (0, 4), 1.0)
    for k in range(8):
        angle = 2 * math.pi * k / 8
        from esg.assets.geometry.rotations import turn

        s.proxy_box(
            (0.5, 2.9, 1.5),
            (6.6 * math.cos(angle), 6.6 * math.sin(angle), 5.5),
            1.0,
            turn("z", 45.0 * k),
        )
    s.region("inside", (-4, 4), (-4, 4), (1, 7))


@builder("tray", "free")
def tray(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Serving tray with a rim."""
    t = H * 0.3
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, t), c, rough=0.4)
    for x in (-1, 1):
        s.slab(
            (L / 2 - t, L / 2) if x > 0 else (-L / 2, -L / 2 + t),
            (-W / 2, W / 2),
            (0, H),
            shade(c, 0.9),
        )
        s.slab(
            (-L / 2, L / 2),
            (W / 2 - t, W / 2) if x > 0 else (-W / 2, -W / 2 + t),
            (0, H),
            shade(c, 0.9),
        )
    s.walls((-L / 2, L / 2), (-W / 2, W / 2), (0, H), t)
    s.surface("floor", t, (L / 2 - 2 * t, W / 2 - 2 * t))
    s.region("inside", (-L / 2 + t, L / 2 - t), (-W / 2 + t, W / 2 - t), (t, H))


@builder("pan")
def pan(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Frying pan, handle at -X, drawn at 48 x 28 x 5 and centred on its box."""
    x = 10.0
    s.lathe(
        [(0, 0), (11, 0), (14, 5), (13.6, 5), (10.8, 0.6), (0, 0.6)], c, center=(x, 0, 0), metal=0.4
    )
    s.rod(1.0, (-24, 0, 4), (x - 13.4, 0, 3.6), DARK)
    s.proxy_cylinder(12.5, (0, 5), 1.0, (x, 0))
    s.proxy_slab((-24, x - 12.5), (-1, 1), (2.8, 4.8), 1.0)
    s.only_weighs()
    s.tub(12.9, (0, 5), 0.8, sides=12, xy=(x, 0))
    s.proxy_slab((-24, x - 12.5), (-1, 1), (2.8, 4.8))
    s.region("inside", (x - 8, x + 8), (-8, 8), (0.8, 5))
    s.surface("floor", 0.8, (7, 7), (x, 0))


@builder("knife", "free")
def knife(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flat cutlery along X: blade forward."""
    s.extrude(
        [(-0.05 * L, -0.4 * W), (0.5 * L, -0.4 * W), (0.42 * L, 0.3 * W), (-0.05 * L, 0.4 * W)],
        (H * 0.3, H * 0.7),
        STEEL,
        plane="xy",
        metal=0.9,
        rough=0.2,
    )
    s.slab((-L / 2, -0.05 * L), (-W / 2, W / 2), (0, H), c)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))


@builder("fruit")
def fruit(s: Sketch, L: float, W: float, H: float, c: Color, stem: bool = True) -> None:
    """Round fruit; a sphere."""
    r = H / 2
    s.ball(r, (0, 0, r), c, solid=1, rough=0.4, detail=4)
    if stem:
        s.rod(r * 0.06, (0, 0, 1.9 * r), (0, 0, 2 * r + r * 0.02), DARK_WOOD, sections=8)


@builder("egg")
def egg(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Egg lying along X, drawn at 5.8 x 4.4 x 4.4."""
    profile = [
        (2.2 * math.cos(t) * (1 - 0.09 * math.sin(t)), 2.9 * math.sin(t))
        for t in (math.radians(v) for v in range(-90, 91, 10))
    ]
    s.lathe(profile, c, center=(0, 0, 2.2), axis="x", rough=0.5)
    s.proxy_hull(lying_hull([(x, q) for q, x in profile[::2]], 2.2, 12))
