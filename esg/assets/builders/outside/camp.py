"""Camp, farm and churchyard: tents, bales, plants, fires, gravestones."""

from __future__ import annotations

import itertools
import math

from esg.assets.builders import builder
from esg.assets.builders.common import LEAF, bone, prism, shade, shift
from esg.assets.geometry.rotations import ALONG
from esg.assets.geometry.sketch import (
    CONCRETE,
    DARK_WOOD,
    PALE_WOOD,
    YELLOW,
    Color,
    Sketch,
    rgb,
)
from esg.graph.models import ProxyKind


@builder("hay_bale")
def hay_bale(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "square") -> None:
    """Bound hay bale; a round bale lies on its side, axis along Y."""
    if kind == "round":
        s.rod(62, (0, -60, 62), (0, 60, 62), c, rough=1.0, sections=40)
        for y in (-60.3, 60.3):
            for r in (20, 40, 56):
                s.torus(r, 1.4, (0, y, 62), shade(c, 0.8), axis="y")
        for y in (-30, 0, 30):
            s.torus(62.2, 0.8, (0, y, 62), shade(c, 0.7), axis="y")
        s.proxy(ProxyKind.CYLINDER, (62, 62, 60), (0, 0, 62), 1.0, ALONG["y"])
        # Straw yields under its own weight: the bale rests on a flat instead of rolling away.
        s.proxy_slab((-22, 22), (-58, 58), (0, 6), 1.0)
        return
    s.slab((-50, 50), (-23, 23), (0, 38), c, rough=1.0)
    for k in range(26):
        x = -48 + 3.84 * k
        y = 23 if k % 2 else -23
        s.rod(0.5, (x, y * 0.9, 38), (x + 6 * (-1) ** k, y * 0.3, 38.3), shade(c, 1.15), sections=6)
        s.rod(
            0.5,
            (x, y, 8 + (k * 7) % 26),
            (min(x + 8, 50), y * 1.01, 10 + (k * 5) % 24),
            shade(c, 1.15),
            sections=6,
        )
    for x in (-22, 22):
        s.slab((x - 0.8, x + 0.8), (-23.4, 23.4), (0, 38.5), rgb(180, 90, 50), of="rope")
    s.proxy_slab((-50, 50), (-23, 23), (0, 38))
    s.surface("top", 38, (47, 20))


@builder("plant_form")
def plant_form(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "stump") -> None:
    """Tree stump, cactus in a pot, flower in a pot, palm tree."""
    if kind == "stump":
        s.lathe([(0, 0), (26, 0), (21, 6), (19, 36), (0, 36)], c, sections=20, rough=1.0)
        s.rod(18.6, (0, 0, 36), (0, 0, 37), PALE_WOOD, sections=32)
        for r in (5, 10, 15):
            s.torus(r, 0.3, (0, 0, 37), DARK_WOOD)
        for k in range(6):
            a = 2 * math.pi * k / 6
            bone(
                s,
                (16 * math.cos(a), 16 * math.sin(a), 6),
                6,
                (29 * math.cos(a), 29 * math.sin(a), 2),
                2,
                c,
            )
        s.proxy_cylinder(24, (0, 5), 1.0)
        s.proxy_cylinder(19, (5, 37), 1.0)
        s.surface("top", 37, (12, 12))
        return
    if kind == "palm":
        path = [(0, 0, 22), (6, 0, 150), (18, 0, 290), (38, 0, 420)]
        for k, (p, q) in enumerate(itertools.pairwise(path)):
            bone(s, p, 22 - 3 * k if k else 22, q, 18 - 3 * k, c)
        for k in range(9):
            a = 2 * math.pi * k / 9
            u, n = (math.cos(a), math.sin(a)), (-math.sin(a), math.cos(a))
            top = (38, 0, 432)
            mid = (top[0] + 90 * u[0], 90 * u[1], 462)
            end = (top[0] + 170 * u[0], 170 * u[1], 380)
            for p, q, w0, w1 in ((top, mid, 6, 22), (mid, end, 22, 3)):
                prism(
                    s,
                    [
                        (v[0] + n[0] * w * e, v[1] + n[1] * w * e, v[2] + dz)
                        for v, w in ((p, w0), (q, w1))
                        for e in (-1, 1)
                        for dz in (0, 2)
                    ]
                    + [(v[0], v[1], v[2] + 6) for v in (p, q)],
                    LEAF,
                )
        for k in range(3):
            a = 2 * math.pi * k / 3
            s.ball(11, (38 + 16 * math.cos(a), 16 * math.sin(a), 416), rgb(96, 70, 40))
        s.proxy_cylinder(28, (0, 20), 3.0)
        s.proxy_cylinder(18, (20, 420), 1.0, (12, 0))
        s.proxy_cylinder(120, (420, 462), 0.02, (38, 0))
        shift(s, -38)
        return
    s.lathe(
        [(0, 0), (7, 0), (9.6, 14), (10.4, 14), (10.4, 17), (0, 17)],
        rgb(180, 92, 58),
        sections=32,
        of="ceramic",
    )
    s.rod(9, (0, 0, 16), (0, 0, 17.3), rgb(70, 50, 36), of="soil")
    s.proxy_cylinder(7.2, (0, 4), 2.0)
    s.proxy_cylinder(9.6, (4, 17), 1.6)
    if kind == "cactus":
        bone(s, (0, 0, 18), 6, (0, 0, 48), 5.4, c)
        for side, z in ((1, 28), (-1, 34)):
            bone(s, (0, 0, z), 3.4, (0, side * 12, z + 1), 3.4, c)
            bone(s, (0, side * 12, z + 1), 3.4, (0, side * 12.4, z + 13), 3.0, c)
        s.ball(2.2, (0, 0, 54), rgb(230, 90, 140), detail=2)
        s.proxy_cylinder(6, (17, 53), 0.6)
        s.proxy_slab((-3, 3), (-15, 15), (26, 47), 0.2)
        return
    s.rod(0.7, (0, 0, 17), (0, 0, 44), LEAF, sections=10)
    for side in (-1, 1):
        s.ball(1, (0, side * 5, 27), LEAF, scale=(2.4, 5.4, 1.2))
    for k in range(9):
        a = 2 * math.pi * k / 9
        s.ball(1, (1.2, 5 * math.cos(a), 46 + 5 * math.sin(a)), c, scale=(0.8, 2.6, 2.6), detail=2)
    s.ball(1, (1.8, 0, 46), rgb(110, 70, 30), scale=(1.4, 3, 3))
    s.proxy_slab((-1.5, 1.5), (-5, 5), (17, 53), 0.05)


@builder("gravestone")
def gravestone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Gravestone with a round head facing +X, 30 x 60 x 95."""
    s.slab((-15, 15), (-30, 30), (0, 12), shade(c, 0.85))
    s.extrude(
        [
            (-24, 12),
            (24, 12),
            (24, 70),
            *[
                (24 * math.cos(math.pi * k / 12), 70 + 24 * math.sin(math.pi * k / 12))
                for k in range(1, 12)
            ],
            (-24, 70),
        ],
        (-7, 7),
        c,
        plane="yz",
    )
    s.slab((7, 7.6), (-2, 2), (46, 80), shade(c, 0.6))
    s.slab((7, 7.6), (-10, 10), (66, 70), shade(c, 0.6))
    s.proxy_slab((-15, 15), (-30, 30), (0, 12))
    s.proxy_slab((-7, 7), (-24, 24), (12, 80))
    s.proxy_slab((-7, 7), (-16, 16), (80, 92))


@builder("campfire")
def campfire(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Campfire of logs in a ring of stones, 90 cm."""
    for k in range(10):
        a = 2 * math.pi * k / 10
        s.ball(
            1,
            (38 * math.cos(a), 38 * math.sin(a), 6),
            shade(CONCRETE, 0.7 + 0.05 * (k % 3)),
            scale=(9, 9, 6),
            detail=2,
        )
    for k in range(6):
        a = 2 * math.pi * k / 6
        s.rod(
            4,
            (26 * math.cos(a), 26 * math.sin(a), 3.5),
            (3 * math.cos(a), 3 * math.sin(a), 40),
            DARK_WOOD,
            sections=12,
        )
    for k, (r, h) in enumerate(((13, 46), (9, 54))):
        s.lathe([(0, 8), (r, 14), (r * 0.7, 28), (0, h)], (c, YELLOW)[k], sections=7, rough=0.4)
    s.proxy_cylinder(44, (0, 11), 1.0)
    s.proxy_cylinder(14, (11, 50), 0.2)
