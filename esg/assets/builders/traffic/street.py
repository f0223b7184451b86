"""Street furniture."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.rotations import ALONG
from esg.assets.geometry.sketch import (
    CHROME,
    CONCRETE,
    DARK,
    RUBBER,
    STEEL,
    WHITE,
    Color,
    Sketch,
)
from esg.assets.lazy import shapes
from esg.graph.models import ProxyKind


@builder("trash_bin")
def trash_bin(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round open litter bin, drawn at 56 x 56 x 95; weighs what the full cylinder would."""
    s.lathe([(0, 0), (24, 0), (25, 3), (27, 85), (26, 85), (24, 4), (23, 3), (0, 3)], c, rough=0.5)
    s.lathe(
        [(26, 83), (27.2, 83), (28, 86), (28, 95), (26.4, 95), (25.5, 86), (26, 83)],
        shade(c, 0.7),
        rough=0.4,
    )
    for k in range(20):
        a = 2 * math.pi * k / 20
        x, y = math.cos(a), math.sin(a)
        s.rod(0.7, (25.1 * x, 25.1 * y, 6), (26.9 * x, 26.9 * y, 72), shade(c, 0.8), sections=8)
    s.proxy_cylinder(27.5, (0, 80))
    s.proxy_cylinder(24, (80, 95), 0.6)
    s.only_weighs()
    s.tub(27.5, (0, 95), 2.0, sides=12)
    s.region("inside", (-18, 18), (-18, 18), (2, 94))
    s.surface("floor", 2.0, (14, 14))


@builder("wheelie_bin")
def wheelie_bin(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two-wheeled refuse bin, lid swung open behind it, drawn at 73 x 58 x 107 (240 l)."""

    def corners(t: float, low: float, high: float) -> list[tuple[float, float, float]]:
        return [
            (x, y * (w - t), z)
            for z, x0, x1, w in ((low, -24, 22, 22), (high, -32, 36, 29))
            for x in (x0 + t, x1 - t)
            for y in (-1, 1)
        ]

    s.add(
        lambda: shapes.cut(shapes.hull(corners(0, 4, 107)), [shapes.hull(corners(2, 8, 111))]),
        c,
        0.6,
    )
    s.slab((-36.5, -34.5), (-28, 28), (36, 102), shade(c, 0.85))
    s.rod(2, (-35, -24, 101), (-35, 24, 101), shade(c, 0.7), sections=14)
    for y in (-1, 1):
        s.rod(10, (-24, 20 * y, 10), (-24, 26 * y, 10), RUBBER)
        s.wheel((-24, 23 * y, 10), 10)
    s.slab((14, 22), (-18, 18), (0, 5), shade(c, 0.8))
    s.proxy_slab((-34, 22), (-26, 26), (0, 12), 1.4)
    s.proxy_slab((-29, 28), (-26, 26), (12, 60), 1.0)
    s.proxy_slab((-33, 34), (-28, 28), (60, 107), 1.0)
    s.only_weighs()
    s.proxy_slab((-34, 22), (-26, 26), (0, 8))
    s.walls((-30, 31), (-27, 27), (8, 107), 3.0)
    s.region("inside", (-22, 22), (-20, 20), (11, 106))
    s.surface("floor", 11, (18, 16))


@builder("bucket")
def bucket(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Open pail with a bail handle, drawn at 30 x 30 x 30; hollow."""
    s.lathe([(0, 0), (11, 0), (14.2, 28), (15, 28), (15, 30), (13.6, 30), (10.4, 1), (0, 1)], c)
    n = 14
    arc = [
        (0.0, 14.6 * math.cos(t), 27 - 9 * math.sin(t))
        for t in (math.pi * k / n for k in range(n + 1))
    ]
    s.pipe(0.35, arc, CHROME, metal=0.8)
    s.tub(13.4, (0, 30), 1.0)
    s.region("inside", (-9, 9), (-9, 9), (1, 28))
    s.surface("floor", 1, (7, 7))


@builder("traffic_cone")
def traffic_cone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Rubber cone with reflective bands, drawn at 38 x 38 x 71."""
    s.slab((-19, 19), (-19, 19), (0, 3.5), DARK if sum(c) > 2.2 else shade(c, 0.9), rough=0.8)

    def r(z: float) -> float:
        return 14.0 - (z - 3.5) * (14.0 - 2.4) / 67.5

    s.lathe([(0, 3), (r(3.5), 3.5), (r(71), 71), (0, 71)], c, rough=0.6)
    for a, b in ((28, 38), (48, 55)):
        s.lathe(
            [(r(a) - 0.3, a), (r(a) + 0.2, a), (r(b) + 0.2, b), (r(b) - 0.3, b), (r(a) - 0.3, a)],
            WHITE,
            rough=0.3,
        )
    s.proxy_slab((-19, 19), (-19, 19), (0, 3.5), 2.0)
    points = [
        (r(z) * math.cos(t), r(z) * math.sin(t), z)
        for z in (3.5, 71.0)
        for t in (2 * math.pi * k / 12 for k in range(12))
    ]
    s.proxy_hull(points, 0.5)


@builder("barrier", "free")
def barrier(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Striped road barrier across Y on two feet."""
    for y in (-1, 1):
        at = y * W * 0.36
        s.slab((-L / 2, L / 2), (at - 4, at + 4), (0, 7), DARK, solid=1.5)
        s.slab((-3, 3), (at - 3, at + 3), (7, H), STEEL, solid=0.8)
    z0, z1 = H * 0.66, H * 0.94
    s.slab((-1.5, 1.5), (-W / 2, W / 2), (z0, z1), WHITE, solid=0.7)
    s.slab((-1.5, 1.5), (-W / 2, W / 2), (H * 0.3, H * 0.44), WHITE, solid=0.7)
    n = max(3, round(W / 26))
    step, lean = W / n, (z1 - z0) * 0.7
    for k in range(n):
        y = -W / 2 + step * k
        right = min(y + step * 0.5 + lean, W / 2)
        s.extrude(
            [
                (y, z0 + 0.1),
                (min(y + step * 0.5, W / 2), z0 + 0.1),
                (right, z1 - 0.1),
                (min(y + lean, W / 2 - 0.1), z1 - 0.1),
            ],
            (-1.7, 1.7),
            c,
            plane="yz",
        )


@builder("jersey_barrier", "free")
def jersey_barrier(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Concrete road barrier running along Y."""
    p = [
        (-0.5, 0),
        (0.5, 0),
        (0.5, 0.09),
        (0.27, 0.4),
        (0.17, 1),
        (-0.17, 1),
        (-0.27, 0.4),
        (-0.5, 0.09),
    ]
    s.extrude([(x * L, z * H) for x, z in p], (-W / 2, W / 2), c, rough=0.95)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.09))
    s.proxy_hull(
        [
            (x * L, y * W / 2, z * H)
            for x, z in ((-0.5, 0.09), (0.5, 0.09), (0.27, 0.4), (-0.27, 0.4))
            for y in (-1, 1)
        ]
    )
    s.proxy_hull(
        [
            (x * L, y * W / 2, z * H)
            for x, z in ((-0.27, 0.4), (0.27, 0.4), (0.17, 1), (-0.17, 1))
            for y in (-1, 1)
        ]
    )
    s.surface("top", H, (L * 0.15, W / 2))


@builder("hydrant")
def hydrant(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Fire hydrant, drawn at 38 x 38 x 76."""
    s.lathe(
        [
            (0, 0),
            (16, 0),
            (16, 4),
            (11, 5),
            (11, 50),
            (13.5, 51),
            (13.5, 55),
            (11.5, 56),
            (10, 64),
            (5, 69),
            (0, 70),
        ],
        c,
        rough=0.4,
        metal=0.2,
    )
    s.rod(2.5, (0, 0, 69), (0, 0, 76), c, sections=6)
    for y in (-1, 1):
        s.rod(5.5, (0, 9 * y, 42), (0, 16 * y, 42), c)
        s.rod(3, (0, 15 * y, 42), (0, 19 * y, 42), shade(c, 0.7), sections=6)
    for x in (-1, 1):
        s.rod(6, (9 * x, 0, 38), (16 * x, 0, 38), c)
        s.rod(3, (15 * x, 0, 38), (19 * x, 0, 38), shade(c, 0.7), sections=6)
    s.proxy_cylinder(16, (0, 5), 1.2)
    s.proxy_cylinder(13, (5, 76), 0.9)
    for a, b in (((0, -19, 42), (0, 19, 42)), ((-19, 0, 38), (19, 0, 38))):
        half = math.dist(a, b) / 2
        mid = [(p + q) / 2 for p, q in zip(a, b, strict=True)]
        s.proxy(ProxyKind.CYLINDER, (5, 5, half), mid, 0.2, ALONG["y" if b[1] else "x"])


@builder("sign")
def sign(s: Sketch, L: float, W: float, H: float, c: Color, face: str = "octagon") -> None:
    """Traffic sign facing +X, drawn at 44 x 70 x 240."""
    s.rod(22, (0, 0, 0), (0, 0, 8), CONCRETE, solid=4)
    s.rod(3, (0, 0, 8), (0, 0, 236), STEEL, solid=1, metal=0.6)
    n, spin = {"octagon": (8, 22.5), "triangle": (3, 90.0), "round": (40, 0.0)}[face]

    def outline(r: float) -> list[tuple[float, float]]:
        return [
            (
                r * math.cos(math.radians(spin + 360 * k / n)),
                203 + r * math.sin(math.radians(spin + 360 * k / n)),
            )
            for k in range(n)
        ]

    s.extrude(outline(37), (3, 4), WHITE if face == "octagon" else c, plane="yz")
    s.extrude(
        outline(34 if face == "octagon" else 28),
        (4, 4.4),
        c if face == "octagon" else WHITE,
        plane="yz",
    )
    s.slab((4.4, 4.6), (-18, 18), (200, 206), WHITE if face == "octagon" else DARK)
    s.proxy_slab((1.5, 4.5), (-34, 34), (170, 237), 1.0)


@builder("mailbox")
def mailbox(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round-topped street mailbox, slot facing +X, drawn at 50 x 52 x 125."""
    top = [(26 * math.cos(t), 99 + 26 * math.sin(t)) for t in (math.pi * k / 20 for k in range(21))]
    s.extrude([(26, 18), *top, (-26, 18)], (-24, 24), c, plane="yz", rough=0.35)
    for x in (-19, 19):
        for y in (-21, 21):
            s.slab((x - 3, x + 3), (y - 3, y + 3), (0, 18), c, solid=1)
    s.slab((24, 25), (-17, 17), (92, 98), CHROME, metal=0.7)
    s.slab((24, 24.8), (-15, 15), (62, 78), WHITE)
    s.proxy_slab((-24, 24), (-26, 26), (18, 100))
    s.proxy_slab((-24, 24), (-20, 20), (100, 124), 0.8)


@builder("park_bench")
def park_bench(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Slatted bench with a backrest, drawn at 62 x 160 x 84; one sits facing +X."""
    for k in range(4):
        s.slab((-16 + 11.5 * k, -6 + 11.5 * k), (-80, 80), (42, 45), c)
    for z in (54, 66, 78):
        x = -20 - (z - 45) * 0.22
        s.slab((x - 1.5, x + 1.5), (-80, 80), (z - 4.5, z + 4.5), c)
    for y in (-66, 66):
        s.pipe(2.2, [(26, y, 0), (26, y, 41), (-18, y, 41), (-28, y, 82)], DARK, metal=0.4)
        s.pipe(2.2, [(-18, y, 41), (-28, y, 0)], DARK, metal=0.4)
        s.pipe(1.6, [(27, y, 41), (27, y, 62), (-24, y, 64)], DARK, metal=0.4)
        s.slab((-31, 29), (y - 3, y + 3), (0, 2), DARK)
        s.proxy_slab((-31, 29), (y - 3, y + 3), (0, 41), 0.7)
    s.proxy_slab((-18, 30), (-80, 80), (41, 45))
    s.proxy_slab((-30, -20), (-80, 80), (49, 83), 0.5)
    s.surface("seat", 45, (21, 76), (5, 0))


@builder("picnic_table")
def picnic_table(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Picnic table with two benches, drawn at 180 x 158 x 74, long side along X."""
    frame = shade(c, 0.82)
    for k in range(5):
        s.slab((-90, 90), ((k - 2) * 14.6 - 6.8, (k - 2) * 14.6 + 6.8), (70.2, 74), c)
    for y in (-1, 1):
        for k in (0, 1):
            mid = y * (58 + k * 14.2)
            s.slab((-90, 90), (mid - 6.8, mid + 6.8), (42, 45.8), c)
    for x in (-64.8, 64.8):
        s.slab((x - 1.9, x + 1.9), (-36, 36), (61, 70.2), frame)
        s.slab((x + 1.9, x + 5.7), (-78, 78), (33, 42), frame)
        for y in (-1, 1):
            s.extrude(
                [(y * 24, 70), (y * 32, 70), (y * 62, 0), (y * 53, 0)],
                (x - 5.7, x - 1.9),
                frame,
                plane="yz",
            )
    s.proxy_slab((-90, 90), (-36, 36), (66, 74))
    for y in (-1, 1):
        s.proxy_slab((-90, 90), (51, 79) if y > 0 else (-79, -51), (38, 45.8), 1.0)
        for x in (-64.8, 64.8):
            s.proxy_slab((x - 6, x + 6), (48, 62) if y > 0 else (-62, -48), (0, 38), 0.7)
    for x in (-64.8, 64.8):
        s.proxy_slab((x - 6, x + 6), (-34, 34), (38, 66), 0.3)
    s.surface("top", 74, (87, 34))
    s.surface("left bench", 45.8, (87, 12), (0, 65))
    s.surface("right bench", 45.8, (87, 12), (0, -65))
