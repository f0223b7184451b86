"""Playground equipment, towards +X where it descends."""

from __future__ import annotations

import itertools

from esg.assets.builders import builder
from esg.assets.geometry.sketch import (
    DARK,
    STEEL,
    Color,
    Sketch,
)


@builder("seesaw")
def seesaw(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Playground seesaw at rest, level on a wide fulcrum, drawn at 300 x 40 x 62."""
    s.extrude([(-28, 0), (28, 0), (8, 52), (-8, 52)], (-18, 18), STEEL)
    s.proxy_hull(
        [(x, y * 18, z) for x, z in ((-28, 0), (28, 0), (8, 52), (-8, 52)) for y in (-1, 1)], 4
    )
    s.slab((-150, 150), (-15, 15), (52, 57), c, solid=1)
    for x in (-1, 1):
        s.rod(1.5, (x * 110, -18, 60.4), (x * 110, 18, 60.4), DARK)
        s.rod(1.2, (x * 110, 0, 57), (x * 110, 0, 60.4), DARK)
    s.surface("left seat", 57, (18, 14), (130, 0))
    s.surface("right seat", 57, (18, 14), (-130, 0))


@builder("slide")
def slide(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Playground slide descending to +X, drawn at 300 x 60 x 200."""
    run = [(-90.0, 150.0), (110.0, 22.0), (150.0, 18.0)]
    for (x0, z0), (x1, z1) in itertools.pairwise(run):
        s.extrude([(x0, z0 - 4), (x1, z1 - 4), (x1, z1), (x0, z0)], (-25, 25), c, rough=0.15)
        s.proxy_hull(
            [(x, y * 25, z + d) for x, z in ((x0, z0), (x1, z1)) for d in (-4, 0) for y in (-1, 1)]
        )
        for y in ((-28, -25), (25, 28)):
            s.extrude([(x0, z0 - 4), (x1, z1 - 4), (x1, z1 + 12), (x0, z0 + 12)], y, c, rough=0.3)
            s.proxy_hull(
                [
                    (x, q, z)
                    for x, z in ((x0, z0 - 4), (x0, z0 + 12), (x1, z1 - 4), (x1, z1 + 12))
                    for q in y
                ]
            )
    s.slab((-130, -90), (-28, 28), (146, 150), STEEL, solid=1)
    for y in (-26, 26):
        s.rod(2.5, (-92, y, 0), (-92, y, 200), STEEL, solid=1)
        s.rod(2.5, (-147, y, 0), (-128, y, 200), STEEL)
        s.rod(2, (142, y, 0), (142, y, 16), STEEL)
        s.proxy_slab((-150, -144), (y - 3, y + 3), (0, 20))
        s.proxy_slab((-133, -127), (y - 3, y + 3), (20, 198), 0.5)
        s.proxy_slab((139, 145), (y - 3, y + 3), (0, 14))
    for k in range(1, 6):
        x = -146 + k * 2.4
        s.rod(1.5, (x, -26, k * 25), (x, 26, k * 25), STEEL)
    s.surface("top", 150, (19, 26), (-110, 0))


@builder("swing_frame")
def swing_frame(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Swing set with a seat at rest, drawn at 160 x 240 x 220."""
    for y in (-1, 1):
        for x in (-1, 1):
            s.rod(3.5, (x * 76.5, y * 112, 0.5), (0, y * 104, 214), c)
            s.proxy_slab((x * 70 - 5, x * 70 + 5), (y * 112 - 5, y * 112 + 5), (0, 30))
        s.proxy_slab((-10, 10), (y * 105 - 4, y * 105 + 4), (150, 216), 0.5)
    s.rod(4, (0, -118, 215), (0, 118, 215), c, solid=0.6)
    for y in (-20, 20):
        s.rod(0.5, (0, y, 45), (0, y, 212), STEEL, sections=8)
    s.slab((-8, 8), (-23, 23), (43, 46), DARK, solid=0.4)
    s.surface("seat", 46, (8, 20))


@builder("tunnel", "free")
def tunnel(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Straight square tunnel along X."""
    t = min(W, H) * 0.08
    for y in ((-W / 2, -W / 2 + t), (W / 2 - t, W / 2)):
        s.slab((-L / 2, L / 2), y, (0, H - t), c, solid=1)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H), c, solid=1)
    s.region("inside", (-L / 2, L / 2), (-W / 2 + t, W / 2 - t), (0, H - t))
