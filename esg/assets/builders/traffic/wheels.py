"""Two-wheelers and small things on wheels."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import holes
from esg.assets.geometry.sketch import CHROME, DARK, RED, RUBBER, STEEL, Color, Sketch


def _spoked(s: Sketch, x: float, r: float, tyre: float) -> None:
    s.torus(r - tyre, tyre, (x, 0, r), RUBBER, axis="y", rough=0.9)
    s.torus(r - 2.2 * tyre, tyre * 0.35, (x, 0, r), CHROME, axis="y", rough=0.3, metal=0.8)
    s.rod(2.2, (x, -4, r), (x, 4, r), STEEL, metal=0.7, sections=14)
    for k in range(8):
        a = math.pi * k / 8
        d = (r - 2.2 * tyre) * math.cos(a), (r - 2.2 * tyre) * math.sin(a)
        s.rod(0.25, (x - d[0], 0, r - d[1]), (x + d[0], 0, r + d[1]), CHROME, sections=6, metal=0.8)
    s.wheel((x, 0, r), r, parts=11)


@builder("bicycle")
def bicycle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """City bicycle on its kickstand, drawn at 175 x 58 x 106."""
    r, xf, xr = 34.0, 53.5, -53.5
    for x in (xf, xr):
        _spoked(s, x, r, 2.0)
    bb, seat, head, low_head = (
        (-8.0, 0.0, 28.0),
        (-25.0, 0.0, 76.0),
        (33.0, 0.0, 84.0),
        (36.0, 0.0, 70.0),
    )
    for a, b in ((bb, seat), (seat, head), (bb, low_head), (head, low_head)):
        s.rod(1.8, a, b, c, rough=0.3, sections=14)
    for y in (-5.0, 5.0):
        s.rod(0.9, (bb[0], y * 0.6, bb[2]), (xr, y, r), c, sections=10)
        s.rod(0.8, (seat[0], y * 0.4, seat[2] - 6), (xr, y, r), c, sections=10)
        s.rod(1.0, (37, y * 0.8, 68), (xf, y, r), c, sections=10)
    s.pipe(1.3, [(33, 0, 83), (30, 0, 99), (36, 0, 103)], CHROME, metal=0.8)
    s.pipe(1.2, [(24, -28, 101), (36, -14, 103), (36, 14, 103), (24, 28, 101)], CHROME, metal=0.8)
    for y in (-28.5, 28.5):
        s.rod(1.8, (27, y * 0.93, 101.5), (16, y, 100.5), DARK, sections=12)
    s.rod(1.4, (seat[0], 0, 74), (-28, 0, 93), CHROME, sections=12, metal=0.8)
    s.extrude(
        [(-14, 0), (-18, 4), (-34, 9), (-42, 8), (-42, -8), (-34, -9), (-18, -4)],
        (92, 97),
        DARK,
        plane="xy",
        soft=1.0,
    )
    s.rod(9, (bb[0], 5.2, 28), (bb[0], 6, 28), STEEL, metal=0.6)
    for y, k in ((-10, 1), (10, -1)):
        s.pipe(1.0, [(bb[0], 0, 28), (bb[0], y * 0.8, 28), (bb[0] + 12 * k, y, 28 - 11 * k)], STEEL)
        s.box((9, 8, 2), (bb[0] + 12 * k, y * 1.35, 28 - 11 * k), DARK)
    s.rod(0.9, (-20, 3, 22), (-22, 13, 0.9), STEEL, sections=10, metal=0.6)
    s.proxy_slab((-87.5, 87.5), (-4, 4), (12, 66), 1.0)
    s.proxy_slab((-42, 40), (-4, 4), (66, 97), 0.7)
    s.proxy_slab((16, 38), (-29, 29), (97, 104), 0.5)
    # Wheels' contact points and the kickstand span this foot.
    s.proxy_slab((-58, 58), (-13, 13), (0, 12), 0.4)


@builder("motorcycle")
def motorcycle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Naked motorcycle on its stand, drawn at 210 x 80 x 112."""
    r, xf, xr = 32.0, 73.0, -70.0
    for x, t in ((xf, 6.0), (xr, 7.5)):
        s.torus(r - t, t, (x, 0, r), RUBBER, axis="y", rough=0.9)
        s.rod(r - 1.6 * t, (x, -2.5, r), (x, 2.5, r), STEEL, metal=0.6)
        s.rod(9, (x, -4.5, r), (x, 4.5, r), CHROME, metal=0.8)
        holes(s, (x, 0, r), r - 1.6 * t, 6)
        s.wheel((x, 0, r), r, parts=4)
    for y in (-9.0, 9.0):
        s.rod(2.4, (xf, y, r), (46, y, 88), CHROME, metal=0.8, sections=14)
        s.rod(2.8, (xr, y, r), (-20, y, 36), DARK, sections=12)
        s.rod(1.8, (xr + 8, y * 0.9, r + 4), (-44, y * 0.9, 66), RED, sections=12)
    s.box((56, 26, 34), (4, 0, 42), STEEL, rough=0.4, metal=0.6)
    s.rod(13, (6, -17, 45), (6, 17, 45), DARK, metal=0.4)
    s.extrude([(44, 62), (48, 82), (30, 92), (-8, 84), (-12, 64)], (-15, 15), c, soft=4, rough=0.2)
    s.extrude(
        [(-8, 66), (-8, 78), (-60, 82), (-88, 90), (-92, 82), (-60, 68)], (-13, 13), DARK, soft=2
    )
    s.pipe(
        1.6, [(26, -38, 102), (44, -18, 104), (46, 0, 100), (44, 18, 104), (26, 38, 102)], CHROME
    )
    for y in (-36, 36):
        s.rod(2.4, (32, y * 0.94, 102.6), (20, y * 1.06, 101.4), DARK, sections=12)
        s.rod(4.5, (38, y * 0.75, 111), (40, y * 0.75, 111), DARK, sections=16)
    s.rod(9, (52, 0, 88), (64, 0, 88), CHROME, rough=0.1, metal=0.8)
    s.pipe(4, [(18, 16, 32), (-20, 18, 24), (-84, 19, 34)], CHROME, metal=0.8)
    s.rod(1.4, (-8, 12, 24), (-10, 26, 1.4), STEEL, sections=10)
    s.proxy_slab((-104, 104), (-9, 9), (14, 64), 1.0)
    s.proxy_slab((-92, 50), (-14, 14), (64, 92), 0.8)
    s.proxy_slab((20, 48), (-39, 39), (92, 106), 0.2)
    s.proxy_slab((-76, 78), (-22, 22), (0, 14), 0.5)
    s.surface("seat", 92, (22, 10), (-34, 0))


@builder("skateboard")
def skateboard(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Skateboard, drawn at 80 x 20 x 12."""
    profile = [
        (-40, 10.8),
        (-30, 8.2),
        (30, 8.2),
        (40, 10.8),
        (39.4, 12),
        (29.6, 9.6),
        (-29.6, 9.6),
        (-39.4, 12),
    ]
    s.extrude(profile, (-10, 10), c, rough=0.9)
    for x in (-21, 21):
        s.box((7, 6, 3), (x, 0, 6.8), STEEL, metal=0.6)
        s.rod(0.9, (x, -8, 3), (x, 8, 3), STEEL, metal=0.6)
        for y in (-9.4, 5.8):
            s.rod(3, (x, y, 3), (x, y + 3.6, 3), (0.93, 0.9, 0.8), sections=24)
            holes(s, (x, y + 1.8, 3), 3, 3.8)
            s.wheel((x, y + 1.8, 3), 3, parts=2)
    s.proxy_slab((-40, 40), (-10, 10), (7, 10))
    for x in (-21, 21):
        s.proxy_slab((x - 3, x + 3), (-9.4, 9.4), (0, 7))
    s.surface("deck", 10, (28, 9))


@builder("shopping_cart")
def shopping_cart(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wire trolley with an open basket, drawn at 95 x 58 x 102."""
    for x, w in ((36, 14), (-38, 26)):
        for y in (-w, w):
            s.rod(6, (x, y - 1.5, 6), (x, y + 1.5, 6), RUBBER, sections=24)
            s.wheel((x, y, 6), 6)
            s.rod(1.2, (x, y, 9), (x, y, 18), STEEL, metal=0.7, sections=10)
    for y in (-1, 1):
        s.pipe(
            1.3,
            [(40, 14 * y, 18), (-40, 26 * y, 18), (-40, 26 * y, 60), (-47, 26 * y, 100)],
            CHROME,
            metal=0.8,
        )
    s.rod(1.8, (-46, -28, 100), (-46, 28, 100), c)
    z0, z1 = 42.0, 84.0
    rails = {z0: (38, -34, 19), (z0 + z1) / 2: (41, -37, 22), z1: (45, -41, 25)}
    for z, (f, b, w) in rails.items():
        s.pipe(0.9, [(f, -w, z), (f, w, z), (b, w, z), (b, -w, z), (f, -w, z)], CHROME, metal=0.8)
    for k in range(9):
        t = k / 8
        x0, x1 = 38 - 72 * t, 45 - 86 * t
        for y in (-1, 1):
            s.rod(0.4, (x0, 19 * y, z0), (x1, 25 * y, z1), CHROME, metal=0.8, sections=6)
        s.rod(0.4, (x0, -19, z0), (x0, 19, z0), CHROME, metal=0.8, sections=6)
    for k in range(7):
        t = -1 + 2 * k / 6
        s.rod(0.4, (38, 19 * t, z0), (45, 25 * t, z1), CHROME, metal=0.8, sections=6)
        s.rod(0.4, (-34, 19 * t, z0), (-41, 25 * t, z1), CHROME, metal=0.8, sections=6)
        s.rod(0.4, (38, 19 * t, z0), (-34, 19 * t, z0), CHROME, metal=0.8, sections=6)
    s.walls((-42, 46), (-26, 26), (z0 - 1, z1), 2.0, 1.0)
    s.proxy_slab((-46, 44), (-28, 28), (0, 18), 1.4)
    s.proxy_slab((-40, 38), (-6, 6), (18, z0 - 1), 0.3)
    s.proxy_slab((-48, -44), (-28, 28), (96, 102), 0.5)
    s.surface("basket floor", z0 + 1, (30, 17))
    s.region("inside", (-40, 44), (-24, 24), (z0 + 1, z1))
