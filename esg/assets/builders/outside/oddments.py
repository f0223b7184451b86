"""Things whose nearest kind was no likeness: seal, hang glider, waterfall, pine cone, pistol."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import blob, bone, prism, shade
from esg.assets.geometry.collider import lying_hull
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    RUBBER,
    STEEL,
    WHITE,
    Color,
    Sketch,
    rgb,
)
from esg.assets.lazy import shapes

_WATER = rgb(150, 196, 214)


@builder("unicycle")
def unicycle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Unicycle in its floor stand, drawn at 52 x 36 x 98."""
    r = 25.0
    s.torus(r - 2.2, 2.2, (0, 0, r + 1), RUBBER, axis="y", rough=0.9)
    s.torus(r - 4.8, 0.8, (0, 0, r + 1), CHROME, axis="y")
    for k in range(8):
        a = math.radians(22.5 * k)
        d = ((r - 5) * math.cos(a), 0.0, (r - 5) * math.sin(a))
        s.rod(0.3, (-d[0], 0, r + 1 - d[2]), (d[0], 0, r + 1 + d[2]), STEEL, sections=6)
    s.rod(2.4, (0, -5, r + 1), (0, 5, r + 1), CHROME)
    s.wheel((0, 0, r + 1), r, parts=11)
    for y, k in ((-7, 1), (7, -1)):
        s.pipe(1.1, [(0, y * 0.7, r + 1), (11 * k, y, r - 8)], STEEL)
        s.box((9, 9, 2.2), (11 * k, y * 1.7, r - 8), DARK)
        s.pipe(1.5, [(0, y * 0.75, r + 1), (0, y * 0.75, 50), (0, y * 0.3, 56)], c)
    s.rod(1.7, (0, 0, 54), (0, 0, 90), CHROME)
    blob(s, [((-11, 0, 94), 4), ((11, 0, 94), 3.2), ((-8, 5, 93), 3.4), ((-8, -5, 93), 3.4)], DARK)
    for y in (-16, 16):
        s.pipe(0.9, [(-20, y, 1), (20, y, 1)], c)
        s.rod(0.9, (-14, y, 1), (0, y * 0.42, r + 1), c, sections=10)
        s.rod(0.9, (14, y, 1), (0, y * 0.42, r + 1), c, sections=10)
    for x in (-20, 20):
        s.rod(0.9, (x, -17, 1), (x, 17, 1), c, sections=10)
    s.proxy_slab((-21, 21), (-17, 17), (0, 4), 2.0)
    s.proxy_slab((-25, 25), (-4, 4), (4, 51), 1.0)
    s.proxy_slab((-3, 3), (-5, 5), (51, 90), 0.6)
    s.proxy_slab((-15, 14), (-8, 8), (90, 98), 0.4)


@builder("seal")
def seal(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Seal resting on its belly with its head up, drawn at 164 x 74 x 62."""
    blob(s, [((-52, 0, 12), 10), ((-14, 0, 22), 21), ((18, 0, 23), 21)], c, rough=0.35)
    blob(s, [((14, 0, 24), 19), ((42, 0, 38), 13), ((52, 0, 48), 11)], c, rough=0.35)
    s.ball(1, (60, 0, 50), c, scale=(15, 11.5, 11.4), rough=0.35)
    s.ball(1, (72, 0, 46), shade(c, 1.35), scale=(8.4, 8, 6.4), rough=0.4)
    s.ball(2.2, (80, 0, 48.4), DARK, detail=2)
    for side in (-1, 1):
        s.ball(2.4, (69, side * 6.4, 54), DARK, detail=2, rough=0.1)
        for k in (-2, 0, 2):
            s.rod(0.25, (75, side * 4, 45), (77, side * 14, 44 + k), WHITE, sections=6)
        blob(
            s,
            [((24, side * 17, 12), 5), ((6, side * 34, 3), 3), ((22, side * 31, 2.6), 2.6)],
            shade(c, 0.8),
            rough=0.4,
        )
        blob(
            s,
            [((-54, side * 3, 10), 6), ((-80, side * 15, 5), 2.6), ((-76, side * 5, 5), 2.4)],
            shade(c, 0.8),
            rough=0.4,
        )
    for x, y, z in ((-20, 15, 35), (4, -14, 38), (-34, -8, 28), (10, 16, 36), (-6, 4, 43)):
        s.ball(3, (x, y, z), shade(c, 0.7), detail=2, rough=0.4)
    s.proxy_slab((-66, 40), (-22, 22), (0, 14), 1.0)
    s.proxy_slab((-36, 38), (-19, 19), (14, 42), 1.0)
    s.proxy_slab((36, 78), (-11, 11), (34, 62), 0.6)
    s.proxy_slab((-82, -66), (-16, 16), (2, 12), 0.6)


@builder("waterfall", "free")
def waterfall(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Water over a rock face into a pool; it falls on the side of +X."""
    back = (-L / 2, -L * 0.12)
    for y, w, h, tone in (
        (-0.36, 0.14, 0.94, 0.9),
        (-0.12, 0.12, 0.9, 0.8),
        (0.12, 0.12, 0.88, 0.86),
        (0.36, 0.14, 1.0, 1.0),
    ):
        s.slab(back, (W * (y - w), W * (y + w)), (0, H * h), shade(c, tone), rough=1.0)
    for y, x, h in ((-0.42, 0.1, 0.5), (0.42, 0.16, 0.36), (-0.38, 0.24, 0.16), (0.4, 0.3, 0.14)):
        s.slab(
            (-L * 0.14, L * x),
            (W * max(y - 0.1, -0.5), W * min(y + 0.1, 0.5)),
            (0, H * h),
            shade(c, 0.92),
            rough=1.0,
        )
    drop = H * 0.9
    steps = [math.radians(a) for a in range(0, 91, 15)]
    lip = [(-L * 0.12 + L * 0.08 * math.sin(a), drop - H * 0.06 * (1 - math.cos(a))) for a in steps]
    sheet = [(-L * 0.3, drop), *lip, (-L * 0.02, H * 0.02), (-L * 0.14, H * 0.02)]
    sheet.append((-L * 0.3, drop - H * 0.03))
    s.extrude(sheet, (-W * 0.22, W * 0.22), _WATER, rough=0.15)
    for y in (-0.15, -0.04, 0.07, 0.17):
        s.slab(
            (-L * 0.1, -L * 0.005),
            (W * (y - 0.012), W * (y + 0.02)),
            (H * 0.02, drop * 0.92),
            WHITE,
        )
    s.slab((-L * 0.14, L / 2), (-W * 0.4, W * 0.4), (0, H * 0.02), shade(_WATER, 0.75), rough=0.1)
    for y, x in ((-0.18, 0.02), (-0.06, 0.05), (0.06, 0.02), (0.18, 0.05)):
        s.ball(1, (L * x, W * y, H * 0.02), WHITE, scale=(L * 0.07, W * 0.07, H * 0.03), detail=2)
    s.proxy_slab(back, (-W / 2, W / 2), (0, H), 1.0)
    s.proxy_slab((-L * 0.12, L / 2), (-W / 2, W / 2), (0, H * 0.02), 1.0)


@builder("pine_cone")
def pine_cone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pine cone lying along X, drawn at 8.6 x 6 x 6."""
    core = [(0.4, -4.0), (2.1, -2.8), (2.3, -0.8), (1.5, 2.0), (0.4, 4.2)]
    s.lathe(core, shade(c, 0.7), center=(0, 0, 3), axis="x", rough=1.0)
    for k in range(46):
        x = -3.3 + 6.9 * k / 45
        radius = 2.35 * math.sqrt(max(0.0, 1 - ((x + 0.8) / 5.2) ** 2))
        a = 2.39996 * k
        y, z = radius * math.cos(a), 3 + radius * math.sin(a)
        out = (x + 0.5, y * 1.12, 3 + (z - 3) * 1.12)
        bone(s, (x - 0.5, y * 0.8, 3 + (z - 3) * 0.8), 0.5, out, 0.34, c, detail=1)
    s.rod(0.35, (-4.3, 0, 3), (-3.4, 0, 3), rgb(90, 66, 40), sections=8)
    profile = [(-4.2, 1.0), (-3.0, 2.6), (-0.8, 3.0), (2.0, 2.2), (4.2, 0.7)]
    s.proxy_hull(lying_hull(profile, 3.0, 12))


@builder("snack_bag", "free")
def snack_bag(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Puffed bag lying on its back, with crimped ends along X and a printed front."""
    s.add(lambda: shapes.pillow((L * 0.9, W, H)), c, rough=0.25)
    for side in (-1, 1):
        for k in range(5):
            x = side * L * (0.42 + 0.016 * k)
            s.slab(
                (x - L * 0.007, x + L * 0.007),
                (-W * 0.47, W * 0.47),
                (H * (0.44 if k % 2 else 0.4), H * (0.56 if k % 2 else 0.52)),
                shade(c, 0.8 if k % 2 else 1.25),
            )
    s.ball(1, (L * 0.04, 0, H * 0.82), WHITE, scale=(L * 0.24, W * 0.3, H * 0.2), rough=0.3)
    s.ball(1, (L * 0.02, 0, H * 0.86), rgb(240, 196, 60), scale=(L * 0.13, W * 0.2, H * 0.19))
    s.proxy_slab((-L * 0.45, L * 0.45), (-W * 0.45, W * 0.45), (0, H * 0.95))


@builder("xylophone", "free")
def xylophone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bars of many colours over a frame, the long ones at the left; played from +X."""
    tones = [
        (196, 40, 44),
        (232, 120, 36),
        (236, 196, 52),
        (72, 156, 70),
        (58, 120, 196),
        (110, 70, 160),
    ]
    for x in (-0.34, 0.34):
        prism(
            s,
            [
                (L * x * f + L * d, y * W, z)
                for y, f in ((-0.49, 1.0), (0.49, 0.55))
                for d in (-0.04, 0.04)
                for z in (0, H * 0.7)
            ],
            c,
        )
    for y, f in ((-0.47, 1.0), (0.47, 0.6)):
        s.slab((-L * 0.36 * f, L * 0.36 * f), (W * (y - 0.02), W * (y + 0.02)), (0, H * 0.6), c)
    n = 12
    for k in range(n):
        y = -W / 2 + W * (k + 0.5) / n
        half = L * (0.5 - 0.2 * k / (n - 1))
        s.slab(
            (-half, half),
            (y - W * 0.032, y + W * 0.032),
            (H * 0.7, H),
            rgb(*tones[k % 6]),
            rough=0.3,
        )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L * 0.35, W * 0.45))
