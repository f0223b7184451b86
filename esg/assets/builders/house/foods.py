"""Food as it lies on a table."""

from __future__ import annotations

import itertools
import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import blob, bone, mirrored, shade, shift
from esg.assets.geometry.sketch import DARK_WOOD, RED, WHITE, YELLOW, Color, Sketch, rgb
from esg.assets.lazy import forms

_LEAF = rgb(74, 140, 52)
_CRUST = rgb(196, 138, 74)


@builder("banana")
def banana(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Banana lying on its side, 19 cm across the bow."""
    path = []
    for k in range(9):
        a = math.radians(-62 + 15.5 * k)
        t = abs(k - 4) / 4
        path.append(((12 * math.cos(a) - 9.6, 10.6 * math.sin(a), 1.75), 1.75 - 0.75 * t**2))
    for (p, pr), (q, qr) in itertools.pairwise(path):
        bone(s, p, pr, q, qr, c)
    tip = path[-1][0]
    bone(s, tip, 0.6, (tip[0] - 1.6, tip[1] + 1.0, 1.75), 0.5, DARK_WOOD)
    s.proxy_slab((-1.2, 3.6), (-7.5, 7.5), (0, 3.3), 1.0)
    for side in (-1, 1):
        s.proxy_slab((-4.6, -1.2), mirrored(side, 5.5, 10), (0.5, 3), 0.8)
    shift(s, 1.0)


@builder("cake")
def cake(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Birthday cake with five candles."""
    s.rod(15, (0, 0, 0), (0, 0, 1), WHITE, sections=48)
    s.rod(13, (0, 0, 1), (0, 0, 9), c, sections=48)
    s.rod(13.2, (0, 0, 7.6), (0, 0, 9.6), WHITE, sections=48)
    for k in range(8):
        a = math.pi * k / 4
        s.ball(
            1.4,
            (10.4 * math.cos(a), 10.4 * math.sin(a), 9.8),
            rgb(236, 150, 170),
            detail=2,
            of="wax",
        )
    for k in range(5):
        a = 2 * math.pi * k / 5
        p = (5 * math.cos(a), 5 * math.sin(a))
        s.rod(0.4, (*p, 9.4), (*p, 15), YELLOW, sections=10)
        s.ball(1, (*p, 15.8), rgb(250, 160, 40), scale=(0.4, 0.4, 0.9), detail=2, of="lamp")
    s.proxy_cylinder(15, (0, 1), 1.0)
    s.proxy_cylinder(13, (1, 10), 1.0)
    s.proxy_cylinder(5.4, (10, 16), 0.02)
    s.surface("top", 10, (9, 9))


@builder("pizza")
def pizza(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pizza with tomatoes and basil."""
    s.rod(16, (0, 0, 0), (0, 0, 1.2), _CRUST, sections=48)
    s.torus(15, 1.0, (0, 0, 1.2), _CRUST)
    s.rod(14.4, (0, 0, 1.2), (0, 0, 1.6), c, sections=48)
    for k, (r, a) in enumerate(
        ((9, 0.4), (10, 1.5), (8, 2.7), (10, 3.8), (9, 5.0), (3, 2.0), (4, 5.6))
    ):
        s.rod(
            2,
            (r * math.cos(a), r * math.sin(a), 1.5),
            (r * math.cos(a), r * math.sin(a), 1.9),
            RED,
            sections=20,
        )
        s.ball(
            1,
            (6.4 * math.cos(a + 0.6 + k), 6.4 * math.sin(a + 0.6 + k), 1.7),
            _LEAF,
            scale=(1.2, 0.7, 0.4),
            detail=2,
            of="leaves",
        )
    s.proxy_cylinder(15.8, (0, 2))


@builder("cheese")
def cheese(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wedge of a cheese wheel, its edge to -X."""
    wedge = [(0, 0)] + [
        (16 * math.cos(math.radians(a)), 16 * math.sin(math.radians(a))) for a in range(-25, 26, 5)
    ]
    s.extrude(wedge, (0, 8), c, plane="xy", rough=0.5)
    s.extrude(
        [
            (15.8 * math.cos(math.radians(a)), 15.8 * math.sin(math.radians(a)))
            for a in range(-25, 26, 5)
        ]
        + [
            (16.4 * math.cos(math.radians(a)), 16.4 * math.sin(math.radians(a)))
            for a in range(25, -26, -5)
        ],
        (0, 8),
        shade(c, 0.75),
        plane="xy",
    )
    for x, y, r in ((11, 1.6, 1.1), (8, -1.6, 0.8), (13, -3, 1.0), (6, 0.6, 0.6)):
        s.rod(r, (x, y, 7.98), (x, y, 8.02), shade(c, 0.7), sections=18)
    s.proxy_hull([(x, y, z) for z in (0, 8) for x, y in ((0, 0), (15, -6.6), (15, 6.6), (16.2, 0))])
    s.surface("top", 8, (4, 2.6), (10, 0))
    shift(s, -8.2)


@builder("burger")
def burger(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Hamburger in its bun."""
    s.lathe([(0, 0), (5, 0), (5.4, 1), (5, 2), (0, 2)], _CRUST)
    s.rod(5.5, (0, 0, 2), (0, 0, 3.6), rgb(96, 56, 36), sections=36)
    s.extrude(
        [
            (
                (5.7 + 0.4 * (k % 2)) * math.cos(math.pi * k / 12),
                (5.7 + 0.4 * (k % 2)) * math.sin(math.pi * k / 12),
            )
            for k in range(24)
        ],
        (3.6, 4.1),
        _LEAF,
        plane="xy",
        of="leaves",
    )
    s.box((9, 9, 0.4), (0, 0, 4.2), YELLOW)
    s.lathe([(0, 4.4), (5.3, 4.4), (5.6, 5.4), (4.2, 7.4), (0, 8.3)], c, smooth=24)
    s.proxy_cylinder(5.2, (0, 6.2), 1.0)
    s.proxy_cylinder(3.6, (6.2, 8.2), 0.8)


@builder("donut")
def donut(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Doughnut with icing and sprinkles."""
    s.torus(3.4, 1.7, (0, 0, 1.7), _CRUST)
    s.torus(3.4, 1.62, (0, 0, 1.95), c, rough=0.3)
    for k in range(10):
        a = 2 * math.pi * k / 10
        s.ball(
            1,
            (3.4 * math.cos(a), 3.4 * math.sin(a) * 1.0, 3.55),
            (YELLOW, WHITE, _LEAF)[k % 3],
            scale=(0.35, 0.14, 0.12),
            detail=1,
            of="wax",
        )
    s.proxy_cylinder(5.0, (0, 3.5))


@builder("pumpkin")
def pumpkin(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ribbed pumpkin with its stem."""
    for k in range(10):
        a = 2 * math.pi * k / 10
        s.ball(
            1,
            (7.4 * math.cos(a), 7.4 * math.sin(a), 11),
            shade(c, 1.0 if k % 2 else 0.92),
            scale=(7.4, 7.4, 11),
            rough=0.5,
        )
    s.rod(1.8, (0, 0, 19), (0.8, 0, 26), rgb(96, 110, 52), sections=12, of="bark")
    s.proxy_cylinder(9, (0, 3), 1.0)
    s.proxy_cylinder(13.8, (3, 19), 1.0)
    s.proxy_cylinder(8, (19, 22), 1.0)


@builder("pineapple")
def pineapple(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pineapple standing upright, with leaves."""
    s.lathe(
        [(0, 0), (4, 0.2), (6, 4), (6.2, 10), (5, 15), (2.6, 17), (0, 17)],
        c,
        smooth=30,
        sections=16,
        rough=0.9,
    )
    for ring, (count, lean, top) in enumerate(((8, 6.0, 24), (6, 3.6, 28), (4, 1.4, 30))):
        for k in range(count):
            a = 2 * math.pi * (k + 0.5 * ring) / count
            bone(
                s,
                (1.4 * math.cos(a), 1.4 * math.sin(a), 16.6),
                0.9,
                (lean * math.cos(a), lean * math.sin(a), top),
                0.15,
                _LEAF,
                of="leaves",
            )
    s.proxy_cylinder(4, (0, 1), 1.0)
    s.proxy_cylinder(6, (1, 16), 1.0)
    s.proxy_cylinder(3.4, (16, 29), 0.15)


@builder("mushroom")
def mushroom(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Mushroom with dots on its cap."""
    s.lathe([(0, 0), (1.6, 0), (1.3, 2), (1.3, 5), (0, 5)], rgb(238, 230, 212))
    s.lathe([(0, 4.4), (4.2, 4.4), (4.0, 5.6), (2.4, 7.4), (0, 8)], c, smooth=30, rough=0.5)
    for r, a in ((2.6, 0.4), (2.4, 2.4), (2.8, 4.2), (1.2, 5.4)):
        s.ball(0.5, (r * math.cos(a), r * math.sin(a), 7.1 - 0.28 * r), WHITE, detail=2)
    s.proxy_cylinder(1.6, (0, 4.4), 1.0)
    s.proxy_cylinder(4.0, (4.4, 6.2), 1.0)
    s.proxy_cylinder(2.4, (6.2, 8), 0.8)


@builder("strawberry")
def strawberry(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Strawberry lying along X."""
    s.ball(1, (0, 0, 1.5), c, scale=(2.1, 1.5, 1.5), rough=0.35)
    bone(s, (0.4, 0, 1.5), 1.3, (2.4, 0, 1.2), 0.5, c)
    for k in range(5):
        a = 2 * math.pi * k / 5
        s.ball(
            1,
            (-1.9, 0.9 * math.cos(a), 1.5 + 0.9 * math.sin(a)),
            _LEAF,
            scale=(0.25, 0.6, 0.6),
            detail=2,
            of="leaves",
        )
    s.proxy_slab((-1.9, 2.4), (-1.0, 1.0), (0, 2.8))
    shift(s, -0.3)


@builder("pepper")
def pepper(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bell pepper with four lobes."""
    for k in range(4):
        a = math.pi / 4 + math.pi * k / 2
        blob(
            s,
            [
                ((1.9 * math.cos(a), 1.9 * math.sin(a), 2.0), 1.8),
                ((2.1 * math.cos(a), 2.1 * math.sin(a), 6.6), 2.1),
            ],
            c,
            rough=0.25,
        )
    s.rod(0.6, (0, 0, 8), (0.5, 0, 10.2), _LEAF, sections=10, of="leaves")
    s.proxy_cylinder(2.6, (0.2, 1.2), 1.0)
    s.proxy_cylinder(3.7, (1.2, 8.6), 1.0)
    shift(s, 0, 0, -0.2)


@builder("onion")
def onion(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Brown onion with its skin's lines, a dry neck and roots, drawn at 8.2 x 8.2 x 9.8."""
    outline = [(0.8, 0.3), (2.2, 0.8), (3.6, 2.2), (4.1, 4), (3.7, 5.8), (2.4, 7.2), (1.1, 8)]
    neck = [(0.6, 8.8), (0.75, 9.5), (0, 9.7)]
    s.lathe([(0, 0.3), *outline, *neck], c, smooth=50, name="bulb")

    def lines() -> Any:
        out = []
        for k in range(14):
            a = 2 * math.pi * k / 14
            path = [(r * math.cos(a), r * math.sin(a), z) for r, z in [*outline, neck[0]]]
            out.append(forms.tube(forms.smooth_path(path, 20), 0.07, 6))
        return forms.gather(out)

    s.add(lines, shade(c, 0.62), name="skin_lines")

    def roots() -> Any:
        ends = []
        for k in range(16):
            a, r = 2.4 * k, 0.5 + 0.05 * k
            tip = (1.5 * r * math.cos(a), 1.5 * r * math.sin(a), 0.03)
            ends.append(((0.4 * math.cos(a), 0.4 * math.sin(a), 0.5), tip))
        return forms.needles(ends, 0.06)

    s.add(roots, rgb(206, 184, 140), of="straw", name="roots")
    s.proxy_cylinder(1.6, (0, 0.6))
    s.proxy_cylinder(3.7, (0.6, 7.0))
    s.proxy_cylinder(1.2, (7.0, 9.6), 0.5)
