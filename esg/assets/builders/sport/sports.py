"""Sports equipment that is not a ball."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored
from esg.assets.geometry.collider import lying_hull
from esg.assets.geometry.sketch import (
    BLUE,
    CHROME,
    DARK,
    ORANGE,
    PALE_WOOD,
    RED,
    STEEL,
    WHITE,
    WOOD,
    Color,
    Sketch,
)

# USBC bowling pin specification: (height, diameter) in inches.
PIN = [
    (0, 2.03),
    (0.75, 2.83),
    (2.25, 3.906),
    (3.375, 4.51),
    (4.5, 4.766),
    (5.875, 4.563),
    (7.25, 3.703),
    (8.625, 2.472),
    (9.375, 1.965),
    (10, 1.797),
    (10.875, 1.87),
    (11.75, 2.094),
    (12.625, 2.406),
    (13.5, 2.547),
    (14.2, 2.35),
    (14.7, 1.75),
    (14.93, 0.9),
    (15, 0.0),
]


@builder("bowling_pin")
def bowling_pin(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Regulation pin, drawn at 12.1 x 12.1 x 38.1; it stands on its flat 5.2 cm base."""
    profile = [(d * 1.27, h * 2.54) for h, d in PIN]
    s.lathe([(0, 0), *profile], c, smooth=60, sections=40, rough=0.25, name="pin")
    for k, z in enumerate((24.2, 26.6)):
        r = 2.36 if z < 25 else 2.33
        s.lathe(
            [(r - 0.3, z), (r, z), (r + 0.05, z + 1.1), (r - 0.3, z + 1.1), (r - 0.3, z)],
            RED,
            name=f"stripe_{k + 1}",
        )
    s.proxy_cylinder(2.58, (0, 5.0))
    s.proxy_cylinder(5.7, (5.0, 18.0))
    s.proxy_cylinder(2.75, (18.0, 38.1))


@builder("goal", "free")
def goal(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Goal with posts, crossbar and net; the mouth faces +X."""
    r = 6.0 if W > 300 else 2.5
    x = L / 2 - r
    for y in (-1, 1):
        s.rod(r, (x, y * (W / 2 - r), 0), (x, y * (W / 2 - r), H - 2 * r), c, solid=1)
        s.pipe(
            r * 0.4,
            [
                (x, y * (W / 2 - r), H - r),
                (-L / 2 + L * 0.35, y * (W / 2 - r), H - r),
                (-L / 2 + r, y * (W / 2 - r), r),
            ],
            c,
        )
        s.rod(r * 0.4, (x, y * (W / 2 - r), r * 0.4), (-L / 2 + r, y * (W / 2 - r), r * 0.4), c)
        s.proxy_slab(
            (-L / 2 + 3, x - r), mirrored(y, W / 2 - r - 1, W / 2 - r + 1), (0, H - 2 * r), 0.1
        )
    s.rod(r, (x, -W / 2, H - r), (x, W / 2, H - r), c, solid=1)
    s.rod(r * 0.4, (-L / 2 + r, -W / 2 + r, r * 0.4), (-L / 2 + r, W / 2 - r, r * 0.4), c)
    # Net: a thin wall behind, side walls above and a roof.
    s.proxy_slab((-L / 2, -L / 2 + 3), (-W / 2 + r, W / 2 - r), (0, H - 2 * r), 0.1)
    s.proxy_slab((-L / 2, x - r), (-W / 2 + r, W / 2 - r), (H - 2 * r, H - 2 * r + 2), 0.1)
    n = max(6, round(W / 45))
    back = (-L / 2 + r, r)
    up = (-L / 2 + L * 0.35, H - r)
    for k in range(n + 1):
        y = -W / 2 + r + (W - 2 * r) * k / n
        s.pipe(0.5, [(x, y, H - r), (up[0], y, up[1]), (back[0], y, back[1])], WHITE)
    m = 6
    for k in range(1, m):
        t = k / m
        p = (up[0] + (back[0] - up[0]) * t, up[1] + (back[1] - up[1]) * t)
        s.rod(0.5, (p[0], -W / 2 + r, p[1]), (p[0], W / 2 - r, p[1]), WHITE, sections=8)
        for y in (-W / 2 + r, W / 2 - r):
            s.rod(0.4, (x, y, p[1]), (p[0], y, p[1]), WHITE, sections=8)
    s.region("goal", (-L / 2 + 3, x - r), (-W / 2 + r + 1, W / 2 - r - 1), (0, H - 2 * r), "goal")
    s.region(
        "inside", (-L / 2 + 3, x - r), (-W / 2 + r + 1, W / 2 - r - 1), (0, H - 2 * r), "inside"
    )


@builder("hoop")
def hoop(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Free-standing basketball hoop, drawn at 260 x 180 x 395; rim at 305, the court is at +X."""
    rim_x, rim_z, rim_r = 107.0, 305.0, 22.5
    s.slab((-130, -20), (-55, 55), (0, 22), c, solid=3.0)
    s.rod(8, (-75, 0, 22), (-75, 0, 300), STEEL, solid=1)
    s.pipe(6, [(-75, 0, 296), (20, 0, 340), (66, 0, 340)], STEEL)
    s.slab((66, 70), (-90, 90), (290, 395), WHITE, solid=0.6, rough=0.2)
    for z in (320, 365):
        s.slab((70, 70.4), (-30, 30), (z - 2.5, z + 2.5), RED)
    for y in (-30, 30):
        s.slab((70, 70.4), (y - 2.5, y + 2.5), (320, 365), RED)
    s.torus(rim_r, 1.0, (rim_x, 0, rim_z), ORANGE)
    s.slab((70, rim_x - rim_r), (-6, 6), (rim_z - 4, rim_z), ORANGE)
    for k in range(12):
        a, b = 2 * math.pi * k / 12, 2 * math.pi * (k + 0.5) / 12
        top = (rim_x + rim_r * math.cos(a), rim_r * math.sin(a), rim_z)
        for t in (b, b - math.pi / 6):
            low = (rim_x + 13 * math.cos(t), 13 * math.sin(t), rim_z - 40)
            s.rod(0.35, top, low, WHITE, sections=6)
    from esg.assets.geometry.rotations import turn
    from esg.graph.models import ProxyKind

    n = 10
    half = rim_r * math.tan(math.pi / n)
    for k in range(n):
        angle = 360.0 * k / n
        a = math.radians(angle)
        s.proxy(
            ProxyKind.BOX,
            (1.0, half, 1.0),
            (rim_x + rim_r * math.cos(a), rim_r * math.sin(a), rim_z),
            0.3,
            turn("z", angle),
        )
    h = rim_r * 0.7
    s.region("hoop", (rim_x - h, rim_x + h), (-h, h), (rim_z - 45, rim_z - 5), "goal")
    s.region("inside", (rim_x - h, rim_x + h), (-h, h), (rim_z - 45, rim_z - 5), "inside")


@builder("net", "free")
def net(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Net between two posts across Y (tennis, volleyball)."""
    r = 4.0
    low = H - 100 if H > 150 else 4.0
    for y in (-1, 1):
        s.rod(r, (0, y * (W / 2 - r), 0), (0, y * (W / 2 - r), H), STEEL, solid=1)
        s.rod(L / 2, (0, y * (W / 2 - L / 2), 0), (0, y * (W / 2 - L / 2), 3), DARK, solid=1)
    span = (-W / 2 + 2 * r, W / 2 - 2 * r)
    s.slab((-0.8, 0.8), span, (H - 6, H), WHITE)
    n, m = round(W / 25), round((H - low) / 20)
    for k in range(n + 1):
        y = span[0] + (span[1] - span[0]) * k / n
        s.rod(0.3, (0, y, low), (0, y, H - 5), c, sections=6)
    for k in range(m):
        z = low + (H - 6 - low) * k / m
        s.rod(0.3, (0, span[0], z), (0, span[1], z), c, sections=6)
    s.proxy_slab((-1, 1), span, (low, H), 0.1)


@builder("bat")
def bat(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Baseball bat lying along the front axis, drawn at 84 x 6.6 x 6.6."""
    r = 3.3
    profile = [
        (0, -42),
        (2.4, -42),
        (2.5, -41),
        (1.3, -39),
        (1.25, -20),
        (1.7, 0),
        (3.0, 22),
        (3.3, 32),
        (3.2, 39),
        (2.4, 41.5),
        (0, 42),
    ]
    s.lathe(profile, c, center=(0, 0, r), axis="x", rough=0.35)
    s.proxy_hull(lying_hull([(-42, 2.4), (-20, 2.2), (20, 3.0), (32, 3.3), (42, 2.4)], r, 8))


@builder("racket")
def racket(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Tennis racket lying flat, drawn at 68 x 26 x 3."""
    n = 28
    head = [
        (17 + 17 * math.cos(2 * math.pi * k / n), 12.2 * math.sin(2 * math.pi * k / n), 1.5)
        for k in range(n + 1)
    ]
    s.pipe(0.9, head, c, rough=0.3)
    for k in range(-5, 6):
        y = k * 2.1
        q = 16.5 * math.sqrt(1 - (y / 12.2) ** 2)
        s.rod(0.12, (17 - q, y, 1.5), (17 + q, y, 1.5), WHITE, sections=6)
    for k in range(-6, 7):
        x = k * 2.4
        q = 11.7 * math.sqrt(1 - (x / 17) ** 2)
        s.rod(0.12, (17 + x, -q, 1.5), (17 + x, q, 1.5), WHITE, sections=6)
    for y in (-1, 1):
        s.pipe(0.9, [(1.5, 5.5 * y, 1.5), (-8, 1.2 * y, 1.5)], c)
    s.rod(1.5, (-34, 0, 1.5), (-8, 0, 1.5), DARK, sections=16)
    s.proxy_slab((0, 34), (-13, 13), (0, 3), 0.5)
    s.proxy_slab((-34, 0), (-1.5, 1.5), (0, 3), 1.5)


@builder("pingpong_table")
def pingpong_table(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Table-tennis table with a net across its middle, drawn at 274 x 152.5 x 91; top at 76."""
    s.slab((-137, 137), (-76.2, 76.2), (73.5, 76), c, solid=1, rough=0.5)
    for y in (-75.2, 0, 75.2):
        w = 1.0 if y else 0.3
        s.slab((-137, 137), (y - w, y + w), (76, 76.05), WHITE)
    for x in (-136, 136):
        s.slab((x - 1, x + 1), (-76.2, 76.2), (76, 76.05), WHITE)
    s.slab((-0.3, 0.3), (-76.2, 76.2), (76, 91), (0.25, 0.27, 0.3), alpha=0.8)
    s.slab((-0.6, 0.6), (-76.2, 76.2), (90, 91.2), WHITE)
    s.proxy_slab((-0.5, 0.5), (-76.2, 76.2), (76, 91), 0.1)
    for x in (-100, 100):
        for y in (-60, 60):
            s.slab((x - 3, x + 3), (y - 3, y + 3), (0, 73.5), DARK, solid=0.6)
        s.slab((x - 2, x + 2), (-60, 60), (30, 35), DARK)
    s.surface("top", 76, (67, 74), (69, 0))
    s.surface("far top", 76, (67, 74), (-69, 0))


@builder("dumbbell")
def dumbbell(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Hexagonal dumbbell along the front axis, drawn at 32 x 14 x 12.1."""
    z = 7 * math.sqrt(3) / 2
    hexagon = [
        (7 * math.cos(math.radians(k * 60)), z + 7 * math.sin(math.radians(k * 60)))
        for k in range(6)
    ]
    for x in (-16, 6):
        s.extrude(hexagon, (x, x + 10), c, plane="yz", rough=0.7)
        s.proxy_hull([(q, *p) for q in (x, x + 10) for p in hexagon])
    s.rod(1.6, (-6, 0, z), (6, 0, z), CHROME, solid=1)


@builder("trampoline")
def trampoline(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round trampoline, drawn at 244 x 244 x 60."""
    s.torus(116, 4, (0, 0, 56), STEEL)
    s.lathe([(0, 54), (104, 54), (104, 55), (0, 55)], DARK)
    s.lathe([(100, 56), (121, 56), (121, 59), (100, 59), (100, 56)], BLUE if sum(c) < 0.6 else c)
    for k in range(6):
        a = math.radians(60 * k)
        x, y = 112 * math.cos(a), 112 * math.sin(a)
        s.rod(3, (x, y, 0), (x, y, 55), STEEL, solid=1)
    s.proxy_cylinder(121, (54, 59), 0.3)
    s.surface("mat", 59, (75, 75))


@builder("chessboard", "free")
def chessboard(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Chequered board."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.9), WOOD, rough=0.3)
    p, q = L * 0.9 / 8, W * 0.9 / 8
    for i in range(8):
        for j in range(8):
            if (i + j) % 2 == 0:
                x, y = (i - 4) * p, (j - 4) * q
                s.slab((x, x + p), (y, y + q), (H * 0.88, H), DARK if i < 9 else PALE_WOOD)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L * 0.45, W * 0.45))


@builder("golf_hole")
def golf_hole(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Putting hole on the ground with a flag, entered over a low lip from +X, 26 x 18 x 45."""
    from esg.assets.geometry.rotations import turn

    x0 = -4.0
    inner, outer, wall, lip = 7.0, 9.0, 6.0, 1.2
    s.lathe([(0, 0), (outer, 0), (outer, 0.05), (0, 0.05)], DARK, center=(x0, 0, 0), rough=1.0)
    for k in range(12):
        angle = 60.0 + 240.0 * (k + 0.5) / 12
        a = math.radians(angle)
        middle = (inner + outer) / 2
        center = (x0 + middle * math.cos(a), middle * math.sin(a), wall / 2)
        size = (outer - inner, 2 * outer * math.sin(math.radians(10.2)), wall)
        s.box(size, center, c, rough=0.9, quat=turn("z", angle), solid=1.0)
    corners = [(x0 + 17.0, 0.0), (x0 + 6.2, 0.0), (x0 + 6.2, lip), (x0 + 7.2, lip)]
    s.extrude(corners, (-7.4, 7.4), c, rough=0.9)
    s.proxy_hull([(x, y, z) for x, z in corners for y in (-7.4, 7.4)])
    s.rod(0.35, (x0 - 8, 0, wall), (x0 - 8, 0, 45), (0.95, 0.95, 0.93), solid=0.3, sections=14)
    s.extrude([(x0 - 7.8, 45), (x0 - 7.8, 35), (x0 + 5, 40)], (-0.15, 0.15), (0.78, 0.1, 0.1))
    s.region("inside", (x0 - 6, x0 + 6), (-6, 6), (0, wall), "hole")
