"""Things that people name every day: an iron, a bar of chocolate, a girder."""

from __future__ import annotations

import itertools
import math

from esg.assets.builders import builder
from esg.assets.builders.common import blob, prism, shade
from esg.assets.builders.living.animals import quadruped
from esg.assets.geometry.sketch import DARK, WHITE, YELLOW, Color, Sketch, rgb

STICKERS = (
    rgb(196, 30, 58), rgb(0, 155, 72), rgb(255, 88, 0),
    rgb(0, 81, 186), rgb(255, 213, 0), rgb(245, 245, 245),
)  # fmt: skip


@builder("puzzle_cube")
def puzzle_cube(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Puzzle cube of 5.7 cm with nine coloured stickers a side."""
    a, cell, proud = 2.84, 1.9, 0.01
    s.slab((-a, a), (-a, a), (proud, 2 * a + proud), DARK, rough=0.4)
    for face, i, j in itertools.product(range(6), (-1, 0, 1), (-1, 0, 1)):
        colour = STICKERS[(2 * face + i + 3 * j + i * j) % 6]
        spans: list[tuple[float, float]] = []
        for k, middle in enumerate((0.0, 0.0, a + proud)):
            if k == face % 3:
                edge = middle + (a if face < 3 else -a)
                spans.append((edge - proud, edge + proud))
            else:
                at = middle + cell * (i if k == (face + 1) % 3 else j)
                spans.append((at - 0.82, at + 0.82))
        s.slab(spans[0], spans[1], spans[2], colour, rough=0.3)
    s.proxy_slab((-2.85, 2.85), (-2.85, 2.85), (0, 5.7))
    s.surface("top", 5.7, (2.85, 2.85))


@builder("ribbed_bar")
def ribbed_bar(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bar of chocolate: six by three squares, 16 x 8 x 1.2 cm."""
    s.slab((-8, 8), (-4, 4), (0, 0.6), c, rough=0.5)
    for i, j in itertools.product(range(6), range(3)):
        x, y = -6.67 + 2.667 * i, -2.667 + 2.667 * j
        low = [(x + 1.25 * p, y + 1.25 * q, 0.6) for p in (-1, 1) for q in (-1, 1)]
        top = [(x + 0.9 * p, y + 0.9 * q, 1.2) for p in (-1, 1) for q in (-1, 1)]
        prism(s, low + top, c, rough=0.4)
    s.proxy_slab((-8, 8), (-4, 4), (0, 1.2))
    s.surface("top", 1.2, (8, 4))


@builder("landing_pad", "free")
def landing_pad(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flat round pad with a ring and an H, read from +X."""
    r = min(L, W) / 2
    line = min(0.02 * H, 0.2)
    top = H - 3 * line
    s.lathe([(0, 0), (r, 0), (r, top), (0, top)], c, rough=0.9)
    for radius, z, colour in ((0.86, top + line, YELLOW), (0.8, top + 2 * line, c)):
        s.lathe([(0, top), (radius * r, top), (radius * r, z), (0, z)], colour, rough=0.9)
    high = (top, H)
    for y in (-0.28 * r, 0.28 * r):
        s.slab((-0.45 * r, 0.45 * r), (y - 0.07 * r, y + 0.07 * r), high, WHITE)
    s.slab((-0.07 * r, 0.07 * r), (-0.28 * r, 0.28 * r), high, WHITE)
    s.proxy_cylinder(r, (0, H))
    s.surface("top", H, (r / math.sqrt(2), r / math.sqrt(2)))


@builder("goal_post", "free")
def goal_post(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """One round post."""
    r = min(L, W) / 2
    s.lathe([(0, 0), (r, 0), (r, H), (0, H)], c, rough=0.3)
    s.proxy_cylinder(r, (0, H))


@builder("girder", "free")
def girder(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Rolled I-section lying along +X."""
    flange, web = 0.12 * H, max(0.08 * W, 0.02 * H)
    for y, z in (
        ((-W / 2, W / 2), (0, flange)),
        ((-web / 2, web / 2), (flange, H - flange)),
        ((-W / 2, W / 2), (H - flange, H)),
    ):
        s.slab((-L / 2, L / 2), y, z, c, rough=0.6)
        s.proxy_slab((-L / 2, L / 2), y, z)
    s.surface("top", H, (L / 2, W / 2))


@builder("stick_remote", "free")
def stick_remote(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flat remote control with rows of keys, pointing towards +X."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, 0.85 * H), c, rough=0.5)
    for i, j in itertools.product(range(6), (-1, 0, 1)):
        x, y = L * (-0.4 + 0.12 * i), 0.28 * W * j
        colour = rgb(179, 38, 46) if (i, j) == (5, -1) else shade(c, 2.5)
        s.slab((x - 0.03 * L, x + 0.03 * L), (y - 0.09 * W, y + 0.09 * W), (0, H), colour)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))


@builder("rocking_horse")
def rocking_horse(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A wooden horse on two runners, drawn as large as a horse."""
    quadruped(s, L, W, H, c, kind="horse")
    for y in (-20, 20):
        runner = [(-105, y, 24), (-55, y, 9), (0, y, 6), (55, y, 9), (105, y, 24)]
        s.pipe(5, runner, shade(c, 0.6))


@builder("toaster", "free")
def toaster(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two slots along X, a lever at the front."""
    s.slab((-0.46 * L, 0.46 * L), (-W / 2, W / 2), (0.04 * H, H), c, rough=0.25)
    s.slab((-0.47 * L, 0.44 * L), (-0.48 * W, 0.48 * W), (0, 0.1 * H), DARK)
    for y in (-0.2 * W, 0.2 * W):
        s.slab((-0.36 * L, 0.36 * L), (y - 0.08 * W, y + 0.08 * W), (0.9 * H, 1.002 * H), DARK)
    s.slab((0.46 * L, 0.5 * L), (-0.14 * W, 0.14 * W), (0.58 * H, 0.66 * H), DARK)
    s.proxy_slab((-0.48 * L, 0.5 * L), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (0.46 * L, 0.48 * W))


@builder("hedgehog")
def hedgehog(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Spiny back, bare snout towards +X, 25 x 16 x 14 cm."""
    s.ball(1, (-1.5, 0, 7), c, scale=(10.5, 7.2, 6.4))
    face = shade(c, 1.8)
    blob(s, [((6, 0, 5.4), 3.8), ((11.4, 0, 4.4), 1.2)], face)
    s.ball(0.8, (12.6, 0, 4.6), DARK)
    for y in (-1, 1):
        s.ball(0.5, (9.6, 1.8 * y, 6.0), DARK)
        for x in (-7, 4):
            s.ball(1.5, (x, 3.6 * y, 1.5), face)
    for i, j in itertools.product(range(7), range(-3, 4)):
        t, p = math.radians(-75 + 22 * i), math.radians(26 * j)
        out = (math.sin(t), math.sin(p) * math.cos(t), math.cos(p) * math.cos(t))
        if out[2] < 0.05:
            continue
        base = (-1.5 + 9.8 * out[0], 6.6 * out[1], 7 + 5.8 * out[2])
        tip = (-1.5 + 11.2 * out[0] - 0.8, 7.9 * out[1], 7 + 7.0 * out[2])
        s.rod(0.35, base, tip, shade(c, 0.6), sections=5)
    s.proxy_slab((-12, 6), (-6.5, 6.5), (0, 13))
    s.proxy_slab((6, 13), (-3, 3), (1, 8))
