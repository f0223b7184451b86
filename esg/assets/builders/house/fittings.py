"""Appliances, bathroom fittings and a piano. Fronts face +X."""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import edge, shade
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    STEEL,
    WHITE,
    Color,
    Sketch,
)
from esg.assets.lazy import shapes


@builder("appliance", "free")
def appliance(s: Sketch, L: float, W: float, H: float, c: Color, style: str = "fridge") -> None:
    """White goods, door facing +X."""
    s.slab((-L / 2, L / 2 - 3), (-W / 2, W / 2), (2, H), c, rough=0.3)
    s.slab((-L / 2 + 2, L / 2 - 6), (-W / 2 + 2, W / 2 - 2), (0, 2), DARK)
    f = (L / 2 - 3, L / 2 - 0.6)
    if style == "fridge":
        for z in ((3, H * 0.36), (H * 0.37, H - 0.5)):
            s.slab(f, (-W / 2 + 0.5, W / 2 - 0.5), z, shade(c, 0.97), rough=0.25)
            s.slab(
                (L / 2 - 0.6, L / 2),
                (W / 2 - 7, W / 2 - 5),
                (z[0] + 6, min(z[1] - 4, z[0] + 50)),
                CHROME,
            )
    elif style == "washer":
        s.slab(f, (-W / 2 + 0.5, W / 2 - 0.5), (3, H - 0.5), shade(c, 0.97), rough=0.25)
        s.rod(W * 0.3, (L / 2 - 3, 0, H * 0.46), (L / 2 - 0.3, 0, H * 0.46), STEEL)
        s.rod(
            W * 0.23, (L / 2 - 3, 0, H * 0.46), (L / 2, 0, H * 0.46), (0.12, 0.15, 0.2), rough=0.1
        )
        s.rod(W * 0.05, (L / 2 - 3, W * 0.3, H * 0.9), (L / 2, W * 0.3, H * 0.9), STEEL)
    elif style == "stove":
        s.slab(f, (-W / 2 + 0.5, W / 2 - 0.5), (H * 0.12, H * 0.8), DARK, rough=0.1)
        s.rod(1, (L / 2 - 1, -W * 0.4, H * 0.76), (L / 2 - 1, W * 0.4, H * 0.76), CHROME)
        for x in (-L * 0.2, L * 0.18):
            for y in (-W * 0.22, W * 0.22):
                s.rod(W * 0.14, (x, y, H - 1), (x, y, H + 0.01), DARK)
        for k in range(5):
            y = -W * 0.36 + W * 0.18 * k
            s.rod(1.6, (L / 2 - 3, y, H * 0.9), (L / 2, y, H * 0.9), DARK, sections=16)
    elif style == "microwave":
        s.slab(f, (-W / 2 + 0.5, W * 0.26), (2.5, H - 0.5), DARK, rough=0.1)
        s.slab(f, (W * 0.27, W / 2 - 0.5), (2.5, H - 0.5), shade(c, 0.8))
        s.slab((L / 2 - 0.6, L / 2), (W * 0.22, W * 0.25), (H * 0.2, H * 0.85), CHROME)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("television", "free")
def television(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flat screen on a foot, facing +X."""
    foot = H * 0.1
    t = min(6.0, L * 0.3)
    s.slab((-L / 2, L / 2), (-W * 0.22, W * 0.22), (0, 1.5), c, solid=6)
    s.slab((-t / 2, t / 2), (-W * 0.06, W * 0.06), (1.5, foot + 3), c, solid=1)
    s.slab((-t / 2, t / 2), (-W / 2, W / 2), (foot, H), c, solid=1, rough=0.3)
    s.slab(
        (t / 2, t / 2 + 0.2),
        (-W * 0.485, W * 0.485),
        (foot + H * 0.02, H * 0.98),
        (0.03, 0.04, 0.06),
        rough=0.05,
    )


@builder("piano", "free")
def piano(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Upright piano, keys facing +X."""
    s.slab((-L / 2, L * 0.02), (-W / 2, W / 2), (0, H), c, solid=1, rough=0.15)
    s.slab((L * 0.02, L / 2), (-W / 2, W / 2), (H * 0.5, H * 0.58), c, solid=1, rough=0.15)
    for y in (-1, 1):
        s.slab((L * 0.3, L / 2 - 2), edge(y, W, 6), (0, H * 0.5), c, solid=0.7, rough=0.15)
        s.slab((L * 0.02, L / 2), edge(y, W, 6), (H * 0.58, H * 0.66), c, rough=0.15)
    s.slab((L * 0.16, L / 2 - 2), (-W / 2 + 7, W / 2 - 7), (H * 0.58, H * 0.595), WHITE)
    n = 36
    for k in range(n):
        if k % 7 in (2, 6):
            continue
        y = -W / 2 + 8 + (W - 16) * (k + 1) / n
        s.slab((L * 0.16, L * 0.34), (y - 0.6, y + 0.6), (H * 0.595, H * 0.607), DARK)
    s.surface("top", H, (L * 0.25, W / 2), (-L * 0.24, 0))


@builder("bathtub", "free")
def bathtub(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bathtub along X; hollow."""

    s.add(
        lambda: shapes.cut(
            shapes.extrude(
                [(-L / 2, -W / 2), (L / 2, -W / 2), (L / 2, W / 2), (-L / 2, W / 2)],
                (0, H),
                "xy",
                min(L, W) * 0.12,
            ),
            [
                shapes.extrude(
                    [
                        (-L / 2 + 7, -W / 2 + 7),
                        (L / 2 - 7, -W / 2 + 7),
                        (L / 2 - 7, W / 2 - 7),
                        (-L / 2 + 7, W / 2 - 7),
                    ],
                    (10, H + 1),
                    "xy",
                    min(L, W) * 0.14,
                )
            ],
        ),
        c,
        rough=0.1,
    )
    s.rod(1.5, (-L / 2 + 4, 0, H - 2), (-L / 2 + 4, 0, H), CHROME)
    s.walls((-L / 2, L / 2), (-W / 2, W / 2), (0, H), 7)
    s.region("inside", (-L / 2 + 8, L / 2 - 8), (-W / 2 + 8, W / 2 - 8), (10, H))
    s.surface("floor", 7, (L / 2 - 16, W / 2 - 14))


@builder("sink", "free")
def sink(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pedestal washbasin."""

    s.add(
        lambda: shapes.cut(
            shapes.box((L, W, H * 0.2), (0, 0, H * 0.86)),
            [shapes.ball(1.0, (L * 0.06, 0, H * 0.96), (L * 0.34, W * 0.38, H * 0.16))],
        ),
        c,
        rough=0.1,
    )
    s.lathe(
        [(0, 0), (W * 0.2, 0), (W * 0.13, H * 0.2), (W * 0.16, H * 0.77), (0, H * 0.77)],
        c,
        rough=0.1,
    )
    s.pipe(
        1.2,
        [(-L * 0.4, 0, H * 0.95), (-L * 0.4, 0, H - 1.2), (-L * 0.1, 0, H - 1.2)],
        CHROME,
    )
    s.proxy_cylinder(min(W * 0.2, L * 0.4), (0, H * 0.76))
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (H * 0.76, H * 0.96))
    s.only_weighs()
    t = min(L, W, H) * 0.07
    s.proxy_cylinder(min(W * 0.2, L * 0.4), (0, H * 0.76))
    s.walls((-L / 2, L / 2), (-W / 2, W / 2), (H * 0.76, H * 0.96), t)
    x = (-L / 2 + t, L / 2 - t)
    s.region("inside", x, (-W / 2 + t, W / 2 - t), (H * 0.76 + t, H * 0.96))
    s.surface("floor", H * 0.76 + t, (L / 2 - 2 * t, W / 2 - 2 * t))
