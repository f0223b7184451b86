"""Small things of kitchen, office and playroom."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import edge, shade
from esg.assets.geometry.sketch import (
    DARK,
    PALE_WOOD,
    Color,
    Sketch,
    rgb,
)
from esg.assets.lazy import shapes

PAPER = rgb(240, 236, 224)


@builder("plant")
def plant(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Potted plant, drawn at 50 x 50 x 80."""
    s.lathe(
        [(0, 0), (12, 0), (16, 26), (17, 26), (17, 30), (15, 30), (14, 26), (0, 26)],
        rgb(178, 96, 62),
        rough=0.9,
        of="ceramic",
    )
    s.rod(1.2, (0, 0, 26), (0, 0, 55), rgb(96, 70, 46), of="soil")
    for k in range(9):
        a = 2 * math.pi * k / 9 * 2
        r, z = 13 - 0.7 * k, 44 + 3.6 * k
        s.ball(
            1.0,
            (r * math.cos(a), r * math.sin(a), z),
            shade(c, 0.8 + 0.05 * (k % 4)),
            scale=(10, 10, 6.5),
            rough=0.9,
        )
    s.proxy_cylinder(14, (0, 30), 6)
    s.proxy_cylinder(2, (30, 44), 1)
    s.proxy_cylinder(19, (44, 80), 0.15)


@builder("candle", "free")
def candle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pillar candle with a wick."""
    r = min(L, W) / 2
    s.lathe([(0, 0), (r, 0), (r, H * 0.9), (r * 0.92, H * 0.92), (0, H * 0.91)], c, rough=0.5)
    s.rod(r * 0.05, (0, 0, H * 0.9), (0, 0, H), DARK, sections=8)
    s.proxy_cylinder(r, (0, H * 0.92))


def _spine(L: float, W: float, H: float, t: float) -> Any:
    """The rounded back of a book whose covers are `t` thick."""
    turn = [math.radians(a) for a in range(-90, 91, 15)]
    bow = min(0.05 * W, 0.5 * H)
    outer = [(-W / 2 + bow - bow * math.cos(a), H / 2 + H / 2 * math.sin(a)) for a in turn]
    inner = [(y + 0.9 * t, H / 2 + (z - H / 2) * (1 - 1.6 * t / H)) for y, z in outer]
    return shapes.extrude([*outer, *reversed(inner)], (-L / 2, L / 2), "yz")


@builder("book", "free")
def book(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Closed hardback lying flat, spine at -Y."""
    t = H * 0.08
    cover = s.appearance.pick("cover", 3)
    for z, word in ((0.0, "back"), (H - t, "front")):
        s.slab(
            (-L / 2, L / 2),
            (-W / 2 + 0.5 * t, W / 2),
            (z, z + t),
            c,
            of="linen",
            name=f"cover_{word}",
        )

    s.add(lambda: _spine(L, W, H, t), shade(c, 0.9), of="linen", name="spine")
    gap = 0.012 * min(L, W)

    def pages() -> Any:
        bow = min(0.02 * W, 0.3 * H)
        turn = [math.radians(a) for a in range(-90, 91, 15)]
        edge_ = [
            (W / 2 - 2 * gap - bow * math.cos(a), H / 2 + (H / 2 - t) * math.sin(a)) for a in turn
        ]
        return shapes.extrude(
            [(-W / 2 + 1.4 * t, t), *edge_, (-W / 2 + 1.4 * t, H - t)],
            (-L / 2 + gap, L / 2 - gap),
            "yz",
        )

    s.add(pages, PAPER, of="paper", name="pages")
    thin = 0.004 * min(L, W)
    tone = shade(c, 1.5) if max(c) < 0.6 else shade(c, 0.5)
    s.slab(
        (-L / 2, L / 2),
        (-W * 0.43, -W * 0.415),
        (H, H + 0.4 * thin),
        shade(c, 0.5),
        of="paint",
        name="hinge",
    )
    if cover == 1:
        s.slab(
            (-L * 0.3, L * 0.3),
            (-W * 0.3, W * 0.36),
            (H, H + thin),
            tone,
            of="paper",
            name="picture",
        )
    else:
        s.slab(
            (-L * 0.3, -L * 0.22),
            (-W * 0.28, W * 0.34),
            (H, H + thin),
            tone,
            of="paint",
            name="title",
        )
        s.slab(
            (-L * 0.17, -L * 0.13),
            (-W * 0.16, W * 0.22),
            (H, H + thin),
            tone,
            of="paint",
            name="subtitle",
        )
        s.slab(
            (L * 0.34, L * 0.37),
            (-W * 0.14, W * 0.2),
            (H, H + thin),
            tone,
            of="paint",
            name="author",
        )
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
    s.rod(0.36, (-9, 0, 0.3464), (-8, 0, 0.3464), rgb(220, 120, 130), sections=16, of="rubber")
    s.proxy_slab((-9, 8), (-0.3, 0.3), (0, 0.69))


@builder("plank", "free")
def plank(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Sawn plank along X."""
    s.box((L, W, H), (0, 0, H / 2), c, solid=1, rough=0.85)
    for y in (-0.3, 0.05, 0.33):
        s.slab(
            (-L / 2 + 1, L / 2 - 1),
            (W * y - W * 0.008, W * y + W * 0.008),
            (H, H + 0.02),
            shade(c, 0.8),
        )
    s.surface("top", H, (L / 2, W / 2))


@builder("toy_block", "free")
def toy_block(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Painted block with framed faces."""
    t = min(L, W, H) * 0.1
    s.box((L - 0.1, W - 0.1, H - 0.1), (0, 0, H / 2), c)
    c = shade(c, 0.72)
    for x in (-1, 1):
        for y in (-1, 1):
            s.slab(edge(x, L, t), edge(y, W, t), (0, H), c)
        for z in ((0, t), (H - t, H)):
            s.slab(edge(x, L, t), (-W / 2, W / 2), z, c)
            s.slab((-L / 2, L / 2), edge(x, W, t), z, c)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("teddy")
def teddy(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Sitting teddy bear facing +X, drawn at 24 x 26 x 32."""
    s.ball(1, (-1.6, 0, 10), c, scale=(10, 9, 10), rough=1.0)
    s.ball(7, (0, 0, 23), c, rough=1.0)
    s.ball(1, (5.6, 0, 21.6), shade(c, 1.25), scale=(3, 3.4, 2.6), rough=1.0)
    s.ball(0.8, (8.4, 0, 22.4), DARK)
    for y in (-1, 1):
        s.ball(2.6, (-0.5, 5.2 * y, 29.3), c, rough=1.0)
        s.ball(0.8, (6.4, 2.4 * y, 24.8), DARK)
        s.ball(1, (1, 9.6 * y, 13), c, scale=(3, 3.2, 6), rough=1.0)
        s.ball(1, (5, 6 * y, 3.2), c, scale=(6.6, 3.6, 3.2), rough=1.0)
    s.proxy_slab((-11, 11), (-9.4, 9.4), (0, 6))
    s.proxy_cylinder(9, (6, 18))
    s.proxy_cylinder(7, (18, 31))


@builder("cushion", "free")
def cushion(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pillow."""

    s.add(lambda: shapes.pillow((L, W, H)), c)
    s.proxy_slab((-L * 0.45, L * 0.45), (-W * 0.45, W * 0.45), (0, H * 0.95))


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
        (L * 0.26, L / 2), (-W * 0.34, W * 0.34), (H * 0.06, H * 0.5), shade(c, 0.85), rough=0.95
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
