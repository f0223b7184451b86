"""Small things of kitchen, office and playroom."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.lazy import shapes
from esg.assets.sketch import (
    BRASS,
    CHROME,
    DARK,
    DARK_WOOD,
    GLASS,
    PALE_WOOD,
    STEEL,
    WHITE,
    YELLOW,
    Color,
    Sketch,
    lying_hull,
    rgb,
)

PAPER = rgb(240, 236, 224)


def _shade(c: Color, f: float) -> Color:
    return (min(c[0] * f, 1.0), min(c[1] * f, 1.0), min(c[2] * f, 1.0))


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


@builder("can")
def can(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Drinks can, drawn at 6.6 x 6.6 x 12."""
    s.lathe(
        [
            (0, 0.4),
            (2.4, 0),
            (2.6, 0.1),
            (3.3, 1.2),
            (3.3, 10.6),
            (2.7, 11.9),
            (2.5, 12),
            (2.4, 11.6),
            (0, 11.6),
        ],
        c,
        rough=0.25,
        metal=0.4,
    )
    s.lathe([(0, 11.5), (2.4, 11.5), (2.4, 11.7), (0, 11.7)], CHROME, metal=0.8)
    s.slab((-0.4, 1.2), (-0.6, 0.6), (11.7, 11.85), STEEL, metal=0.8)
    s.proxy_cylinder(3.1, (0, 12))
    s.surface("top", 12, (1.8, 1.8))


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


@builder("cup")
def cup(s: Sketch, L: float, W: float, H: float, c: Color, style: str = "cup") -> None:
    """Handleless cup or drinking glass, drawn at 8 x 8 x 10; hollow."""
    glass = style == "glass"
    s.lathe(
        [(0, 0), (2.9, 0), (4, 10), (3.8, 10), (2.75, 0.7), (0, 0.7)],
        c,
        rough=0.05 if glass else 0.6,
        alpha=0.45 if glass else 1.0,
    )
    s.tub(3.6, (0, 10), 0.5)
    s.region("inside", (-2.1, 2.1), (-2.1, 2.1), (0.7, 10))


@builder("wine_glass")
def wine_glass(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Stemmed glass, drawn at 8 x 8 x 20."""
    s.lathe(
        [
            (0, 0),
            (3.5, 0),
            (3.5, 0.3),
            (0.5, 0.8),
            (0.4, 9),
            (2.4, 10.5),
            (4, 14),
            (3.4, 20),
            (3.2, 20),
            (3.8, 14),
            (2.3, 10.9),
            (0, 9.8),
        ],
        c,
        rough=0.05,
        alpha=0.45,
    )
    s.proxy_cylinder(3.5, (0, 0.6), 3)
    s.proxy_cylinder(0.6, (0.6, 10), 3)
    s.proxy_cylinder(3.8, (10, 20), 0.2)


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
        from esg.assets.sketch import turn

        s.proxy_box(
            (0.5, 2.9, 1.5),
            (6.6 * math.cos(angle), 6.6 * math.sin(angle), 5.5),
            1.0,
            turn("z", 45.0 * k),
        )
    s.region("inside", (-4, 4), (-4, 4), (1, 7))


@builder("vase")
def vase(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ceramic vase, drawn at 16 x 16 x 30."""
    s.lathe(
        [
            (0, 0),
            (5, 0),
            (5.4, 1),
            (7.9, 12),
            (7, 19),
            (3.4, 25),
            (3.6, 28),
            (4.8, 30),
            (4.3, 30),
            (3.1, 28),
            (2.9, 25),
            (4, 22),
            (0, 20),
        ],
        c,
        smooth=70,
        rough=0.15,
    )
    s.proxy_cylinder(5.2, (0, 3))
    s.proxy_cylinder(7.5, (3, 19))
    s.proxy_cylinder(4.2, (19, 30), 0.7)
    s.region("inside", (-2.5, 2.5), (-2.5, 2.5), (20, 30))


@builder("plant")
def plant(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Potted plant, drawn at 50 x 50 x 80."""
    s.lathe(
        [(0, 0), (12, 0), (16, 26), (17, 26), (17, 30), (15, 30), (14, 26), (0, 26)],
        rgb(178, 96, 62),
        rough=0.9,
    )
    s.rod(1.2, (0, 0, 26), (0, 0, 55), rgb(96, 70, 46))
    for k in range(9):
        a = 2 * math.pi * k / 9 * 2
        r, z = 13 - 0.7 * k, 44 + 3.6 * k
        s.ball(
            1.0,
            (r * math.cos(a), r * math.sin(a), z),
            _shade(c, 0.8 + 0.05 * (k % 4)),
            scale=(10, 10, 6.5),
            rough=0.9,
        )
    s.proxy_cylinder(14, (0, 30), 6)
    s.proxy_cylinder(2, (30, 44), 1)
    s.proxy_cylinder(19, (44, 80), 0.15)


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
            _shade(c, 0.9),
        )
        s.slab(
            (-L / 2, L / 2),
            (W / 2 - t, W / 2) if x > 0 else (-W / 2, -W / 2 + t),
            (0, H),
            _shade(c, 0.9),
        )
    s.walls((-L / 2, L / 2), (-W / 2, W / 2), (0, H), t)
    s.surface("floor", t, (L / 2 - 2 * t, W / 2 - 2 * t))
    s.region("inside", (-L / 2 + t, L / 2 - t), (-W / 2 + t, W / 2 - t), (t, H))


@builder("candle", "free")
def candle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pillar candle with a wick."""
    r = min(L, W) / 2
    s.lathe([(0, 0), (r, 0), (r, H * 0.9), (r * 0.92, H * 0.92), (0, H * 0.91)], c, rough=0.5)
    s.rod(r * 0.05, (0, 0, H * 0.9), (0, 0, H), DARK, sections=8)
    s.proxy_cylinder(r, (0, H * 0.92))


@builder("candlestick")
def candlestick(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Brass candlestick with a candle, drawn at 11 x 11 x 30."""
    s.lathe(
        [
            (0, 0),
            (5.5, 0),
            (5, 1.2),
            (1.4, 3),
            (1, 6),
            (1.8, 7),
            (0.9, 8),
            (0.9, 11),
            (2.6, 12),
            (2.6, 13),
            (0, 13),
        ],
        BRASS,
        metal=0.8,
        rough=0.3,
    )
    s.rod(1.1, (0, 0, 13), (0, 0, 28.5), c)
    s.rod(0.1, (0, 0, 28.5), (0, 0, 30), DARK, sections=8)
    s.proxy_cylinder(5.5, (0, 1.5), 4)
    s.proxy_cylinder(1.8, (1.5, 28.5), 1)


@builder("laptop")
def laptop(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Open laptop, screen facing +X, drawn at 32 x 33 x 22."""
    s.slab((-8, 16), (-16.5, 16.5), (0, 1.6), c, solid=3, metal=0.5, rough=0.4)
    s.slab((-6, 5), (-15, 15), (1.6, 1.75), DARK)
    for i in range(4):
        for j in range(11):
            x, y = -5.4 + i * 2.6, -14.3 + j * 2.6
            s.slab((x, x + 2.1), (y, y + 2.2), (1.75, 1.9), rgb(60, 60, 64))
    s.slab((7, 14), (-5, 5), (1.6, 1.68), _shade(c, 0.85))
    s.extrude(
        [(-8, 1.0), (-7, 1.6), (-14.8, 22), (-15.9, 21.6)], (-16.5, 16.5), c, metal=0.5, rough=0.4
    )
    s.extrude(
        [(-7.2, 2.6), (-7.1, 2.6), (-14.4, 21.2), (-14.5, 21.2)],
        (-15.7, 15.7),
        (0.05, 0.1, 0.2),
        rough=0.05,
    )
    points = [
        (x, y * 16.5, z)
        for x, z in ((-8.6, 1.6), (-7, 1.6), (-14.8, 22), (-15.9, 21.6))
        for y in (-1, 1)
    ]
    s.proxy_hull(points, 0.9)


@builder("monitor")
def monitor(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Desktop screen facing +X, drawn at 20 x 55 x 45."""
    s.slab((-10, 10), (-13, 13), (0, 1.2), c, solid=8, metal=0.4)
    s.slab((-5, -2), (-3, 3), (1.2, 20), c, solid=1.5)
    s.slab((-2, 2), (-27.5, 27.5), (11, 45), c, solid=0.6, rough=0.4)
    s.slab((2, 2.2), (-26.5, 26.5), (12.5, 44), (0.04, 0.06, 0.1), rough=0.05)


@builder("keyboard", "free")
def keyboard(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Computer keyboard, long along Y."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.7), c)
    for i in range(5):
        for j in range(16):
            x, y = -L * 0.46 + i * L * 0.185, -W * 0.48 + j * W * 0.06
            s.slab((x, x + L * 0.16), (y, y + W * 0.05), (H * 0.65, H), _shade(c, 1.5))
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))


@builder("phone", "free")
def phone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Smartphone or tablet lying flat."""
    s.extrude(
        [(-L / 2, -W / 2), (L / 2, -W / 2), (L / 2, W / 2), (-L / 2, W / 2)],
        (0, H * 0.9),
        c,
        plane="xy",
        soft=W * 0.1,
        rough=0.3,
    )
    s.slab(
        (-L * 0.47, L * 0.47), (-W * 0.45, W * 0.45), (H * 0.85, H), (0.03, 0.04, 0.06), rough=0.05
    )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))


@builder("book", "free")
def book(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Closed hardback lying flat, spine at -Y."""
    t = H * 0.08
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, t), c)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H), c)
    s.slab((-L / 2, L / 2), (-W / 2, -W / 2 + t), (t, H - t), c)
    s.slab((-L / 2 + 0.4, L / 2 - 0.4), (-W / 2 + t, W / 2 - 0.4), (t, H - t), PAPER, rough=0.95)
    s.slab((-L * 0.2, L * 0.25), (-W * 0.3, W * 0.3), (H, H + 0.01), _shade(c, 1.5))
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("pen")
def pen(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Hexagonal pencil lying along X, drawn at 18 x 0.8 x 0.7."""
    hexagon = [
        (0.4 * math.cos(math.radians(60 * k)), 0.3464 + 0.4 * math.sin(math.radians(60 * k)))
        for k in range(6)
    ]
    s.extrude(hexagon, (-8, 7), c, plane="yz")
    s.lathe(
        [(0, 7), (0.36, 7), (0.05, 9), (0, 9)],
        PALE_WOOD,
        center=(0, 0, 0.3464),
        axis="x",
        sections=12,
    )
    s.rod(0.36, (-9, 0, 0.3464), (-8, 0, 0.3464), rgb(220, 120, 130), sections=16)
    s.proxy_slab((-9, 8), (-0.3, 0.3), (0, 0.69))


@builder("clock", "free")
def clock(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Standing alarm clock, dial facing +X."""
    foot = H * 0.1
    r = (H - foot) / 2
    s.rod(r, (-L / 2, 0, foot + r), (L / 2 - 0.3, 0, foot + r), c, sections=40)
    s.rod(r * 0.88, (L / 2 - 0.3, 0, foot + r), (L / 2, 0, foot + r), WHITE, sections=40)
    s.slab((L / 2, L / 2 + 0.05), (-r * 0.03, r * 0.03), (foot + r, foot + r * 1.7), DARK)
    s.slab((L / 2, L / 2 + 0.05), (0, r * 0.5), (foot + r * 0.97, foot + r * 1.03), DARK)
    s.slab((-L / 2, L / 2 - 0.3), (-r * 0.7, r * 0.7), (0, foot * 2), _shade(c, 0.8), solid=1.5)
    s.proxy_slab((-L / 2, L / 2), (-r * 0.85, r * 0.85), (foot * 2, H), 1.0)


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


@builder("pot")
def pot(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Cooking pot with a lid, drawn at 26 x 34 x 20."""
    s.lathe([(0, 0), (12.6, 0), (13, 0.5), (13, 15), (0, 15)], c, metal=0.6, rough=0.25)
    s.lathe(
        [(0, 15), (13, 15), (12, 16.2), (5, 17.6), (0, 17.8)], _shade(c, 0.9), metal=0.6, rough=0.2
    )
    s.rod(1.8, (0, 0, 17.5), (0, 0, 20), DARK)
    for y in (-1, 1):
        s.pipe(
            0.7,
            [(-4, 12.6 * y, 12), (-4, 16 * y, 12.5), (4, 16 * y, 12.5), (4, 12.6 * y, 12)],
            DARK,
        )
    s.proxy_cylinder(13, (0, 17))
    s.proxy_cylinder(2, (17, 20))


@builder("teapot")
def teapot(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Teapot, spout at +X, drawn at 26 x 16 x 16."""
    x0 = 0.4
    s.lathe(
        [(0, 0), (5, 0), (8, 6), (6.4, 11), (3.5, 13), (0, 14)],
        c,
        center=(x0, 0, 0),
        smooth=40,
        rough=0.15,
    )
    s.ball(1.1, (x0, 0, 14.9), c, rough=0.15)
    s.pipe(1.3, [(6, 0, 5), (10, 0, 8), (11.7, 0, 12.4)], c, rough=0.15)
    s.pipe(
        0.7, [(-5.5, 0, 11), (-10, 0, 11.5), (-12.2, 0, 9), (-11, 0, 5), (-7, 0, 4)], c, rough=0.15
    )
    s.proxy_cylinder(6, (0, 3), 1.0, (x0, 0))
    s.proxy_cylinder(7.6, (3, 11), 1.0, (x0, 0))
    s.proxy_cylinder(3.4, (11, 16), 0.5, (x0, 0))
    s.proxy_slab((7.5, 12.5), (-1.2, 1.2), (5, 13), 0.6)
    s.proxy_slab((-12.8, -7), (-0.8, 0.8), (4, 12), 0.6)


@builder("plank", "free")
def plank(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Sawn plank along X."""
    s.box((L, W, H), (0, 0, H / 2), c, solid=1, rough=0.85)
    for y in (-0.3, 0.05, 0.33):
        s.slab(
            (-L / 2 + 1, L / 2 - 1),
            (W * y - W * 0.008, W * y + W * 0.008),
            (H, H + 0.02),
            _shade(c, 0.8),
        )
    s.surface("top", H, (L / 2, W / 2))


@builder("toy_block", "free")
def toy_block(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Letter block with framed faces."""
    t = min(L, W, H) * 0.1
    s.box((L - 0.1, W - 0.1, H - 0.1), (0, 0, H / 2), PALE_WOOD)
    for x in (-1, 1):
        for y in (-1, 1):
            s.slab(_pair(x, L, t), _pair(y, W, t), (0, H), c)
        for z in ((0, t), (H - t, H)):
            s.slab(_pair(x, L, t), (-W / 2, W / 2), z, c)
            s.slab((-L / 2, L / 2), _pair(x, W, t), z, c)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


def _pair(sign: int, extent: float, t: float) -> tuple[float, float]:
    return (extent / 2 - t, extent / 2) if sign > 0 else (-extent / 2, -extent / 2 + t)


@builder("pendulum_bob")
def pendulum_bob(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Metal bob with an eyelet, drawn at 10 x 10 x 12; a sphere on a small flat."""
    s.ball(5, (0, 0, 5), c, metal=0.8, rough=0.2, solid=1, detail=4)
    s.torus(1.0, 0.3, (0, 0, 10.7), STEEL, axis="y", metal=0.8)


@builder("toy_car")
def toy_car(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wooden toy car, drawn at 16 x 8 x 7."""
    s.extrude(
        [(-8, 1.4), (8, 1.4), (8, 3.6), (4.5, 4), (2.5, 7), (-4, 7), (-6, 4.2), (-8, 4)],
        (-3.2, 3.2),
        c,
        soft=0.4,
        rough=0.3,
    )
    s.extrude([(3.4, 4.4), (2.1, 6.3), (-3.6, 6.3), (-5, 4.4)], (-3.25, 3.25), GLASS, rough=0.1)
    for x in (-5, 5):
        for y in (-4, 2.6):
            s.rod(1.7, (x, y, 1.7), (x, y + 1.4, 1.7), DARK)
    s.proxy_slab((-8, 8), (-4, 4), (0, 4), 1.0)
    s.proxy_slab((-5, 3.6), (-3.2, 3.2), (4, 7), 0.5)


@builder("teddy")
def teddy(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Sitting teddy bear facing +X, drawn at 24 x 26 x 32."""
    s.ball(1, (-1.6, 0, 10), c, scale=(10, 9, 10), rough=1.0)
    s.ball(7, (0, 0, 23), c, rough=1.0)
    s.ball(1, (5.6, 0, 21.6), _shade(c, 1.25), scale=(3, 3.4, 2.6), rough=1.0)
    s.ball(0.8, (8.4, 0, 22.4), DARK)
    for y in (-1, 1):
        s.ball(2.6, (-0.5, 5.2 * y, 29.3), c, rough=1.0)
        s.ball(0.8, (6.4, 2.4 * y, 24.8), DARK)
        s.ball(1, (1, 9.6 * y, 13), c, scale=(3, 3.2, 6), rough=1.0)
        s.ball(1, (5, 6 * y, 3.2), c, scale=(6.6, 3.6, 3.2), rough=1.0)
    s.proxy_slab((-11, 11), (-9.4, 9.4), (0, 6))
    s.proxy_cylinder(9, (6, 18))
    s.proxy_cylinder(7, (18, 31))


@builder("hammer")
def hammer(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Claw hammer lying flat, drawn at 33 x 13 x 3."""
    s.rod(1.2, (-16.5, 0, 1.5), (13, 0, 1.5), c, sections=16)
    s.rod(1.5, (14, -6.5, 1.5), (14, 2, 1.5), STEEL, metal=0.8)
    s.extrude(
        [(12.6, 2), (15.4, 2), (16.5, 6.5), (14.6, 5), (13, 6.5)],
        (0.4, 2.6),
        STEEL,
        plane="xy",
        metal=0.8,
    )
    s.proxy_slab((-16.5, 12.5), (-1.1, 1.1), (0, 2.7), 0.3)
    s.proxy_slab((12.5, 15.5), (-6.5, 6.5), (0, 3), 3.0)


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


@builder("spoon")
def spoon(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Spoon lying flat, drawn at 19 x 4 x 1.6."""
    s.ball(1, (6.7, 0, 0.8), c, scale=(2.8, 2.0, 0.8), metal=0.9)
    s.rod(0.3, (-9.5, 0, 0.5), (4.2, 0, 0.9), c, metal=0.9, sections=12)
    s.proxy_slab((-9.5, 9.5), (-1.2, 1.2), (0, 1.2))


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


@builder("cushion", "free")
def cushion(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pillow."""

    s.add(lambda: shapes.pillow((L, W, H)), c, 1.0)
    s.proxy_slab((-L * 0.45, L * 0.45), (-W * 0.45, W * 0.45), (0, H * 0.95))


@builder("radio", "free")
def radio(s: Sketch, L: float, W: float, H: float, c: Color, style: str = "speaker") -> None:
    """Loudspeaker or electronic box with its face at +X."""
    s.slab((-L / 2, L / 2 - 0.6), (-W / 2, W / 2), (0, H), c, rough=0.4)
    if style == "speaker":
        for z, f in ((0.34, 0.36), (0.78, 0.18)):
            s.rod(min(W, H) * f, (L / 2 - 1, 0, H * z), (L / 2, 0, H * z), DARK, sections=36)
            s.rod(min(W, H) * f * 0.35, (L / 2 - 1, 0, H * z), (L / 2 + 0.01, 0, H * z), STEEL)
    elif style == "camera":
        s.rod(H * 0.36, (L / 2 - 2, 0, H * 0.47), (L / 2, 0, H * 0.47), STEEL, sections=36)
        s.rod(
            H * 0.26,
            (L / 2 - 2, 0, H * 0.47),
            (L / 2 + 0.01, 0, H * 0.47),
            (0.05, 0.06, 0.1),
            rough=0.05,
        )
    else:
        s.slab((L / 2 - 0.6, L / 2), (-W * 0.4, W * 0.4), (H * 0.15, H * 0.85), _shade(c, 0.6))
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("backpack", "free")
def backpack(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Upright rucksack, pocket facing +X."""
    s.extrude(
        [
            (-W / 2, 0),
            (W / 2, 0),
            (W / 2, H * 0.75),
            (W * 0.3, H * 0.96),
            (-W * 0.3, H * 0.96),
            (-W / 2, H * 0.75),
        ],
        (-L * 0.42, L * 0.26),
        c,
        plane="yz",
        soft=2,
        rough=0.95,
    )
    s.slab(
        (L * 0.26, L / 2), (-W * 0.34, W * 0.34), (H * 0.06, H * 0.5), _shade(c, 0.85), rough=0.95
    )
    for y in (-W * 0.22, W * 0.22):
        s.pipe(
            0.9, [(-L * 0.4, y, H * 0.85), (-L * 0.48, y, H * 0.6), (-L * 0.4, y, H * 0.1)], DARK
        )
    s.pipe(
        0.6,
        [
            (-L * 0.3, -4, H * 0.94),
            (-L * 0.3, -3, H * 0.99),
            (-L * 0.3, 3, H * 0.99),
            (-L * 0.3, 4, H * 0.94),
        ],
        DARK,
    )
    s.proxy_slab((-L / 2, L * 0.45), (-W / 2, W / 2), (0, H * 0.78))
    s.proxy_slab((-L * 0.42, L * 0.26), (-W * 0.4, W * 0.4), (H * 0.78, H * 0.96), 0.7)


@builder("figure")
def figure(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Standing person (mannequin) facing +X, drawn at 30 x 50 x 172 on a base plate."""
    skin = rgb(214, 172, 140)
    s.slab((-15, 15), (-20, 20), (0, 2), DARK)
    for y in (-1, 1):
        s.lathe(
            [(0, 2), (6, 2), (6.5, 40), (9, 82), (0, 86)], rgb(50, 60, 90), center=(0, 9 * y, 0)
        )
        s.slab((-8, 14), (9 * y - 5, 9 * y + 5), (2, 9), DARK)
        s.rod(4.2, (0, 20.5 * y, 136), (2, 20.8 * y, 92), c)
        s.ball(4.2, (2, 20.8 * y, 88), skin)
    s.ball(1, (0, 0, 112), c, scale=(12, 19, 33), rough=0.9)
    s.rod(5, (0, 0, 140), (0, 0, 152), skin)
    s.ball(1, (1, 0, 160), skin, scale=(9.5, 8, 12))
    s.proxy_slab((-15, 15), (-20, 20), (0, 2), 4)
    s.proxy_slab((-9, 9), (-18, 18), (2, 86), 0.8)
    s.proxy_slab((-12, 12), (-25, 25), (86, 142), 0.9)
    s.proxy_cylinder(9, (142, 172), 0.8)
