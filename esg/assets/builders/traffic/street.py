"""Street furniture."""

from __future__ import annotations

from collections.abc import Callable
import math
from typing import Any

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
from esg.assets.lazy import forms, shapes
from esg.graph.models import ProxyKind


def _ribs() -> Any:
    """Upright slats around a litter bin."""
    out = []
    for k in range(24):
        a = 2 * math.pi * k / 24
        x, y = math.cos(a), math.sin(a)
        out.append(
            forms.tube(
                [(25.0 * x, 25.0 * y, 5), (26.6 * x, 26.6 * y, 78)], 1.25, 8, round_ends=False
            )
        )
    return forms.gather(out)


@builder("trash_bin")
def trash_bin(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round open litter bin, drawn at 56 x 56 x 95; weighs what the full cylinder would."""
    wall = [
        (22.6, 1.2),
        (23.4, 0),
        (24.2, 0.4),
        (25, 3),
        (26.6, 80),
        (26.8, 85),
        (25.6, 86),
        (23.8, 4.4),
        (22.6, 3.4),
    ]
    s.add(lambda: forms.turned(wall, sections=48), c, name="body")
    rim = [
        (25.4, 84),
        (27.3, 83.4),
        (28, 85),
        (28, 93.4),
        (27.4, 94.8),
        (26.6, 95),
        (26.0, 94.2),
        (25.8, 86),
        (25.4, 84),
    ]
    s.add(lambda: forms.turned(rim, sections=48), shade(c, 0.7), name="rim")
    s.add(_ribs, shade(c, 0.82), name="ribs")
    s.add(
        lambda: forms.turned(
            [(25.2, 78), (27.1, 78.4), (27.1, 80.6), (25.2, 81), (25.2, 78)], sections=48
        ),
        shade(c, 0.7),
        name="band",
    )
    s.add(
        lambda: forms.turned(
            [(24.6, 3), (25.9, 3.4), (26, 6), (24.8, 6.4), (24.6, 3)], sections=48
        ),
        shade(c, 0.7),
        name="foot_band",
    )
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
    wall = [
        (9.6, 0.6),
        (10.4, 0),
        (11, 0.2),
        (11.5, 3),
        (12.7, 13),
        (12.95, 13.4),
        (13.05, 14.4),
        (12.9, 15),
        (14.1, 26.6),
        (14.2, 28),
        (14.9, 28.2),
        (15, 29.4),
        (14.6, 30),
        (13.9, 29.8),
        (13.5, 28.6),
        (10.6, 1.6),
        (9.6, 1.1),
    ]
    s.add(lambda: forms.turned(wall, sections=48), c, name="bucket")
    ear = [(0.0, q * 14.3, 26.2) for q in (-1, 1)]
    s.add(
        lambda: forms.gather(
            [
                forms.cushion((4.4, 1.6, 3.4), p, plan=3, side=0.6, sections=16, levels=7)
                for p in ear
            ]
        ),
        shade(c, 0.85),
        name="ears",
    )
    arc = [
        (0.6 * math.sin(t), 14.6 * math.cos(t), 26.4 - 10.5 * math.sin(t))
        for t in (math.pi * k / 20 for k in range(21))
    ]
    s.add(
        lambda: forms.tube(
            [
                (
                    2.6 * math.sin(t) + 14.9 * 0 + p[0] + (1.4 if 0.2 < t < 2.9 else 0),
                    p[1] * 1.02,
                    p[2],
                )
                for t, p in ((math.pi * k / 20, q) for k, q in enumerate(arc))
            ],
            0.34,
            10,
        ),
        CHROME,
        of="steel",
        name="bail",
    )
    s.tub(13.4, (0, 30), 1.0)
    s.region("inside", (-9, 9), (-9, 9), (1, 28))
    s.surface("floor", 1, (7, 7))


@builder("traffic_cone")
def traffic_cone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Rubber cone with reflective bands, drawn at 38 x 38 x 71."""
    foot = DARK if sum(c) > 2.2 else shade(c, 0.9)
    s.add(
        lambda: forms.cushion((38, 38, 3.6), (0, 0, 1.8), plan=9, side=0.3, sections=40, levels=7),
        foot,
        of="rubber",
        name="base",
    )

    def r(z: float) -> float:
        return 14.0 - (z - 3.5) * (14.0 - 2.4) / 67.5

    shell = [
        (15.6, 3),
        (14.6, 4),
        (r(5), 5.4),
        (r(69.6), 69.6),
        (r(71) - 0.1, 70.6),
        (r(71) - 0.6, 71),
        (1.6, 70.6),
        (1.5, 66),
    ]
    s.add(lambda: forms.turned(shell, sections=44), c, of="rubber", name="cone")
    for k, (a, b) in enumerate(((26, 38), (47, 56))):
        band = [(r(a) - 0.4, a), (r(a) + 0.2, a), (r(b) + 0.2, b), (r(b) - 0.4, b), (r(a) - 0.4, a)]
        s.add(
            lambda band=band: forms.turned(band, sections=44),
            WHITE,
            of="paint",
            name=f"reflective_band_{k + 1}",
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


def _hydrant_bolts() -> Any:
    out = []
    for k in range(8):
        a = 2 * math.pi * (k + 0.5) / 8
        for radius, z, high in ((14.0, 4.0, 1.8), (12.4, 54.6, 1.6)):
            out.append(
                forms.turned(
                    [(0.95, z), (0.95, z + high)],
                    (radius * math.cos(a), radius * math.sin(a), 0),
                    6,
                )
            )
    return forms.gather(out)


def _chain() -> Any:
    """Links from an outlet's cap to the bonnet."""
    path = forms.smooth_path([(1, 17.4, 42), (5, 16, 36), (8.6, 9.6, 38), (9.8, 5.4, 46)], 15)
    out = []
    for k in range(14):
        a, b = path[k], path[k + 1]
        d = (b - a) * 0.22
        out.append(forms.tube([a - d, b + d], 0.42 if k % 2 else 0.6, 6))
    return forms.gather(out)


@builder("hydrant")
def hydrant(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Fire hydrant, drawn at 38 x 38 x 76."""
    barrel = [
        (15.4, 0),
        (16, 0.6),
        (16, 3.6),
        (15.2, 4.4),
        (11.6, 5.4),
        (10.6, 8),
        (10.6, 46),
        (11.4, 48.6),
        (13.2, 50),
        (13.6, 51),
        (13.6, 54),
        (12.8, 55),
        (11.6, 56),
        (11.2, 59),
        (9.8, 63.6),
        (7.2, 67),
        (4.0, 69),
        (2.6, 70),
    ]
    s.add(lambda: forms.turned(barrel, sections=48), c, of="paint", name="body")
    s.add(
        lambda: forms.turned([(3.0, 69), (3.0, 75.2), (2.6, 76)], sections=5),
        shade(c, 0.85),
        of="paint",
        name="operating_nut",
    )
    s.add(lambda: _hydrant_bolts(), shade(c, 0.75), of="paint", name="bolts")
    for at, axis, name in (((0, 0, 42), "y", "side_outlet"), ((0, 0, 38), "x", "front_outlet")):
        for sign, word in ((-1, "_1"), (1, "_2")):
            q = [(4.8, 8), (5.2, 11), (5.8, 12), (5.8, 15), (5.2, 15.8)]
            nut = [(2.6, 15.4), (2.9, 16.4), (2.9, 18.6), (2.4, 19)]
            turned = [[(a, sign * b) for a, b in z] for z in (q, nut)]
            s.add(
                lambda p=turned[0], at=at, axis=axis: forms.turned(p, at, 28, axis),
                c,
                of="paint",
                name=name + word,
            )
            s.add(
                lambda p=turned[1], at=at, axis=axis: forms.turned(p, at, 5, axis),
                shade(c, 0.7),
                of="paint",
                name=name + word + "_nut",
            )
    s.add(_chain, STEEL, name="chain")
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
    s.rod(3, (0, 0, 8), (0, 0, 236), STEEL, solid=1)
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

    def shell(grow: float, x: tuple[float, float]) -> Any:
        top = [
            ((26 + grow) * math.cos(t), 99 + (26 + grow) * math.sin(t))
            for t in (math.pi * k / 28 for k in range(29))
        ]
        return shapes.extrude([(26 + grow, 18 - grow), *top, (-26 - grow, 18 - grow)], x, "yz")

    s.add(lambda: shell(-0.8, (-24, 24)), c, of="paint", name="body")
    for x, word in ((-24.0, "rear"), (22.2, "front")):
        s.add(lambda x=x: shell(0.0, (x, x + 1.8)), shade(c, 0.92), of="paint", name=f"rim_{word}")
    for x in (-19, 19):
        for y in (-21, 21):
            s.add(
                lambda x=x, y=y: forms.turned([(2.2, 1.2), (2.2, 18.4)], (x, y, 0), 18),
                shade(c, 0.8),
                of="paint",
                name="leg",
            )
            s.add(
                lambda x=x, y=y: forms.turned([(3.6, 0), (3.6, 1.0), (2.4, 1.6)], (x, y, 0), 18),
                DARK,
                of="steel",
                name="foot_plate",
            )
            s.proxy_slab((x - 3, x + 3), (y - 3, y + 3), (0, 18), 1)
    s.add(
        lambda: forms.cushion((2.6, 37, 10), (24, 0, 101), plan=8, side=0.3, sections=28, levels=7),
        shade(c, 0.8),
        of="paint",
        name="chute",
    )
    s.add(
        lambda: forms.tube(
            [(25.4, -12, 98.4), (26.6, -11, 97.4), (26.6, 11, 97.4), (25.4, 12, 98.4)], 0.8, 10
        ),
        CHROME,
        name="chute_handle",
    )
    s.slab((23.8, 24.7), (-14, 14), (66, 82), WHITE, of="paint", name="notice")
    for k, z in enumerate((78, 74.5, 71)):
        s.slab(
            (24.6, 24.9),
            (-11, 11 - 4 * k),
            (z - 0.8, z + 0.8),
            DARK,
            of="paint",
            name="notice_line",
        )
    s.add(
        lambda: forms.turned([(1.7, 0), (1.7, 1.0), (0.9, 1.2)], (23.8, 14, 52), 18, "x"),
        CHROME,
        name="lock",
    )
    s.slab((23.9, 24.3), (-17, 17), (26, 60), shade(c, 0.9), of="paint", name="door")
    s.proxy_slab((-24, 24), (-26, 26), (18, 100))
    s.proxy_slab((-24, 24), (-20, 20), (100, 124), 0.8)


def _bench_end(y: float) -> Any:
    """Cast legs, back and arm of a bench at one end."""
    paths = (
        (
            [
                (27.4, y, 2.2),
                (25, y, 14),
                (27, y, 30),
                (26, y, 40),
                (10, y, 41.2),
                (-16, y, 41.2),
                (-20.5, y, 46),
                (-24, y, 62),
                (-28.4, y, 82.5),
            ],
            1.9,
        ),
        ([(-28.6, y, 2.2), (-24, y, 16), (-20, y, 30), (-16, y, 41)], 1.9),
        (
            [
                (26, y, 41),
                (28.6, y, 52),
                (25.6, y, 61.6),
                (12, y, 63.6),
                (-6, y, 63),
                (-23.4, y, 64.4),
            ],
            1.5,
        ),
        ([(24.6, y, 16), (6, y, 21), (-22, y, 17)], 1.1),
    )
    out = [forms.tube(forms.smooth_path(path, 20), r, 8, flat=1.25) for path, r in paths]
    out += [
        forms.cushion((7, 6, 2), (x, y, 1), plan=4, side=0.5, sections=18, levels=7)
        for x in (26.4, -28)
    ]
    out.append(
        forms.cushion((12, 5, 2.4), (20.5, y, 63.2), plan=3, side=0.6, sections=20, levels=7)
    )
    return forms.gather(out)


@builder("park_bench")
def park_bench(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Slatted bench with a backrest, drawn at 62 x 160 x 84; one sits facing +X."""
    for k in range(4):
        x = -11 + 11.5 * k
        s.add(
            lambda x=x: forms.cushion(
                (9.6, 160, 3.2), (x, 0, 43.4), plan=30, side=0.28, sections=20, levels=7
            ),
            c,
            of="wood",
            name=f"seat_slat_{k + 1}",
        )
    for k, z in enumerate((54, 66, 78)):
        x = -20 - (z - 45) * 0.22
        s.add(
            lambda x=x, z=z: forms.cushion(
                (3.0, 160, 9.6), (x, 0, z), plan=24, side=0.2, sections=20, levels=7
            ),
            c,
            of="wood",
            name=f"back_slat_{k + 1}",
        )
    for y, word in ((-66, "right"), (66, "left")):
        s.add(lambda y=y: _bench_end(y), DARK, of="cast_iron", name=f"end_{word}")
        s.proxy_slab((-31, 29), (y - 3, y + 3), (0, 41), 0.7)
    s.proxy_slab((-18, 30), (-80, 80), (41, 45))
    s.proxy_slab((-30, -20), (-80, 80), (49, 83), 0.5)
    s.surface("seat", 45, (21, 76), (5, 0))


@builder("picnic_table")
def picnic_table(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Picnic table with two benches, drawn at 180 x 158 x 74, long side along X."""
    frame = shade(c, 0.82)

    def plank(y: float, z: tuple[float, float]) -> Callable[[], Any]:
        size = (180.0, 13.6, z[1] - z[0])
        return lambda: forms.cushion(
            size, (0, y, (z[0] + z[1]) / 2), plan=26, side=0.16, sections=32, levels=7
        )

    for k in range(5):
        s.add(
            plank((k - 2) * 14.6, (70.2, 74)),
            shade(c, 1.0 - 0.05 * (k * 2 % 3)),
            name=f"top_plank_{k + 1}",
        )
    for y, word in ((-1, "right"), (1, "left")):
        for k in (0, 1):
            s.add(
                plank(y * (58 + k * 14.2), (42, 45.8)),
                shade(c, 1.0 - 0.05 * k),
                name=f"bench_plank_{word}_{k + 1}",
            )
    for x in (-64.8, 64.8):
        s.slab((x - 1.9, x + 1.9), (-36, 36), (61, 70.2), frame, name="top_beam")
        s.slab((x + 1.9, x + 5.7), (-78, 78), (33, 42), frame, name="bench_beam")
        for y in (-1, 1):
            s.extrude(
                [(y * 24, 70), (y * 32, 70), (y * 62, 0), (y * 53, 0)],
                (x - 5.7, x - 1.9),
                frame,
                plane="yz",
                name="leg",
            )
            s.add(
                lambda x=x, y=y: forms.gather(
                    [
                        forms.turned([(1.2, 5.6), (1.2, 6.6), (0.6, 7)], (x, y * q, z), 12, "x")
                        for q, z in ((42, 37.5), (31, 64))
                    ]
                ),
                STEEL,
                name="bolts",
            )
    s.add(
        lambda: forms.gather(
            [forms.tube([(q * 58, 0, 37), (q * 12, 0, 68)], 2.2, 10, flat=1.6) for q in (-1, 1)]
        ),
        frame,
        name="brace",
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
