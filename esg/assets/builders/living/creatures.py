"""Animals that do not stand on four legs, and toys in their shape; all face +X."""

from __future__ import annotations

import itertools
import math

from esg.assets.appearance import FLYING
from esg.assets.builders import builder
from esg.assets.builders.common import blob, bone, prism, shade, shift
from esg.assets.builders.living.headwear import Anchor, adorn
from esg.assets.geometry.sketch import DARK, RED, WHITE, YELLOW, Color, Sketch, rgb

_BEAK = rgb(232, 150, 40)


def _eyes(s: Sketch, x: float, y: float, z: float, r: float) -> None:
    for side in (-1, 1):
        s.ball(r, (x, side * y, z), DARK, rough=0.15, detail=2)


def _foot(s: Sketch, y: float, hip: float, size: float, c: Color) -> None:
    s.rod(0.16 * size, (0, y, 0.2 * size), (0, y, hip), c, sections=10, of="horn")
    for spread in (-0.45, 0, 0.45):
        tip = (size, y + spread * size, 0.12 * size)
        bone(s, (0, y, 0.16 * size), 0.14 * size, tip, 0.1 * size, c, detail=1, of="horn")


@builder("bird")
def bird(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "songbird") -> None:
    """A bird, standing or in flight: small and round, a hen with comb, or a duck."""
    hen, duck = kind == "hen", kind == "duck"
    k = {"songbird": 1.0, "hen": 2.3, "duck": 2.6}[kind]
    leg = {"songbird": 4.0, "hen": 4.6, "duck": 2.2}[kind] * k
    z = leg + 3.4 * k
    s.ball(1, (0, 0, z), c, scale=(6.4 * k, 4.1 * k, 3.9 * k), rough=0.9)
    head = (5.0 * k, 0.0, z + (4.4 if kind == "songbird" else 7.0) * k)
    bone(s, (3.6 * k, 0, z + 1.2 * k), 2.6 * k, head, 1.9 * k, c)
    s.ball(2.3 * k, head, rgb(38, 92, 56) if duck else c, rough=0.9)
    tip = (head[0] + (5.2 if duck else 4.0) * k, 0.0, head[2] - 0.4 * k)
    bone(
        s,
        (head[0] + 1.6 * k, 0, head[2] - 0.2 * k),
        0.9 * k,
        tip,
        (0.75 if duck else 0.2) * k,
        _BEAK,
        of="horn",
    )
    rise = 4.4 * k if hen else 1.2 * k
    prism(
        s,
        [(-4.6 * k, y, z + d) for y in (-2 * k, 2 * k) for d in (-0.6 * k, 1.4 * k)]
        + [(-10.0 * k, y, z + rise + d) for y in (-1.7 * k, 1.7 * k) for d in (0, 0.7 * k)],
        shade(c, 0.75),
        rough=0.9,
    )
    for side in (-1, 1):
        if s.appearance.pose == FLYING:
            _spread_wing(s, side, k, z + 1.4 * k, c)
            continue
        s.ball(
            1,
            (-1.2 * k, side * 3.5 * k, z + 0.5 * k),
            shade(c, 0.8),
            scale=(5.2 * k, 1.1 * k, 2.7 * k),
            rough=0.9,
        )
        _foot(s, side * 1.7 * k, z - 2.5 * k, 2.7 * k, _BEAK)
    _eyes(s, head[0] + 0.9 * k, 1.85 * k, head[2] + 0.6 * k, 0.42 * k)
    if hen:
        for j in range(3):
            s.ball(
                1,
                (head[0] + (1.2 - 1.2 * j) * k, 0, head[2] + 2.4 * k),
                RED,
                scale=(0.8 * k, 0.4 * k, 1.1 * k),
                detail=2,
            )
        s.ball(1, (head[0] + 2.2 * k, 0, head[2] - 1.9 * k), RED, scale=(0.6 * k, 0.4 * k, 1.1 * k))
    neck = (4.4 * k, 0.0, 0.5 * (z + 1.2 * k + head[2]))
    adorn(s, Anchor(head, 2.3 * k, neck, 2.3 * k, (1.2 * k, 1.85 * k, 0.6 * k), 14))
    s.proxy_slab((-3.4 * k, 4.2 * k), (-3 * k, 3 * k), (0, z - 2.4 * k), 0.6)
    s.proxy_slab((-5.4 * k, 5.4 * k), (-3.4 * k, 3.4 * k), (z - 2.4 * k, z + 2.8 * k), 1.0)
    s.proxy_slab((2.6 * k, 7.4 * k), (-2 * k, 2 * k), (z + 2.8 * k, head[2] + 2.1 * k), 0.8)
    shift(
        s, (0.5 if kind == "songbird" else 0.0) * k - (0.1 * k if hen else 0.2 * k if duck else 0)
    )


def _spread_wing(s: Sketch, side: int, k: float, z: float, c: Color) -> None:
    """One wing of a bird that flies, its legs tucked away: an arm, then a hand swept back."""
    root, wrist, tip = (2.6, 2.6, z), (3.0, 9.5, z + 2.2 * k), (-3.4, 18.0, z + 1.2 * k)
    for (x0, y0, z0), (x1, y1, z1), chords, dark in (
        (root, wrist, (6.4, 5.6), 0.8),
        (wrist, tip, (5.6, 1.2), 0.65),
    ):
        edges = [
            (x * k, side * y * k, h)
            for x, y, h in ((x0, y0, z0), (x0 - chords[0], y0, z0), (x1, y1, z1),
                            (x1 - chords[1], y1, z1))
        ]  # fmt: skip
        corners = [(x, y, h + d * k) for x, y, h in edges for d in (0, 0.45)]
        prism(s, corners, shade(c, dark), rough=0.9)


@builder("frog")
def frog(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Sitting frog, 10 cm long."""
    blob(s, [((-2.6, 0, 2.2), 2.0), ((1.6, 0, 3.8), 2.5)], c)
    blob(s, [((2.6, -1.4, 4.3), 1.5), ((2.6, 1.4, 4.3), 1.5), ((4.2, 0, 3.7), 1.4)], c)
    for side in (-1, 1):
        s.ball(0.95, (2.6, side * 1.7, 5.9), shade(c, 1.1))
        s.ball(0.55, (3.1, side * 2.05, 6.1), DARK)
        blob(s, [((-2.8, side * 2.6, 2.0), 1.5), ((0.4, side * 3.4, 1.2), 1.0)], shade(c, 0.9))
        bone(s, (0.4, side * 3.4, 0.6), 0.6, (-3.6, side * 3.8, 0.45), 0.45, shade(c, 0.9))
        bone(s, (2.4, side * 2, 2.4), 0.7, (3.6, side * 2.9, 0.5), 0.5, shade(c, 0.9))
    s.proxy_slab((-4.4, 4), (-3.8, 3.8), (0, 2), 0.8)
    s.proxy_slab((-4.2, 5), (-2.8, 2.8), (2, 6.4), 1.0)
    shift(s, -0.5)


@builder("snake")
def snake(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Snake on the ground in waves, head raised."""
    n = 26
    path = []
    for k in range(n + 1):
        t = k / n
        r = 0.8 + 2.2 * math.sin(math.pi * min(1.0, 0.12 + 0.9 * t)) ** 0.7
        path.append(((-70 + 124 * t, 11 * math.sin(4.2 * math.pi * t), r), r))
    for k, ((p, pr), (q, qr)) in enumerate(itertools.pairwise(path)):
        bone(s, p, pr, q, qr, shade(c, 1.0 if k % 4 < 2 else 0.6))
    end = (path[-1][0][0], path[-1][0][1], 1.9)
    neck = (end[0] + 8, end[1], 12.0)
    bone(s, end, 1.9, neck, 1.9, c)
    blob(s, [(neck, 2.4), ((neck[0] + 6, neck[1], 11.6), 1.6)], c)
    s.rod(0.2, (neck[0] + 7, neck[1], 11.4), (neck[0] + 10.5, neck[1], 11.2), RED, sections=6)
    _eyes(s, neck[0] + 3.4, 1.7, 13.3, 0.45)
    s.proxy_slab((-70, 56), (-11, 11), (0, 5))
    s.proxy_slab((56, 69), (-2.4, 2.4), (5, 14), 0.4)
    shift(s, -1)


@builder("bug")
def bug(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "spider") -> None:
    """Eight-legged spider, or a crab with claws."""
    crab = kind == "crab"
    s.ball(
        1, (-2 if not crab else 0, 0, 3.2), c, scale=(2.8, 2.3, 1.9) if not crab else (4.2, 6, 2)
    )
    if not crab:
        s.ball(1, (1.4, 0, 2.9), shade(c, 0.85), scale=(1.8, 1.5, 1.2))
    for side in (-1, 1):
        for k in range(4):
            a = math.radians(35 + 36 * k)
            reach = 5.4 if crab else 5.0
            base = 4.6 if crab else 1.2
            hip = (1.2 * math.cos(a) + (0 if crab else 0.6), side * base * math.sin(a) ** 0.5, 3.0)
            knee = (
                hip[0] + 0.55 * reach * math.cos(a),
                hip[1] + side * 0.55 * reach * math.sin(a),
                4.8,
            )
            foot = (hip[0] + reach * math.cos(a), hip[1] + side * reach * math.sin(a), 0.18)
            bone(s, hip, 0.35, knee, 0.32, shade(c, 0.8), detail=1)
            bone(s, knee, 0.32, foot, 0.18, shade(c, 0.8), detail=1)
        s.ball(0.34, ((2.7 if not crab else 3.6), side * 0.7, 3.9), DARK, detail=2)
        if crab:
            bone(s, (3, side * 4.5, 3), 0.8, (6.4, side * 5.6, 2.6), 0.7, c)
            blob(s, [((6.4, side * 5.4, 2.6), 1.2), ((9, side * 3.9, 2.6), 0.5)], shade(c, 1.1))
            blob(s, [((6.6, side * 6.2, 2.4), 0.8), ((9, side * 5.6, 2.4), 0.35)], shade(c, 1.1))
    half = 5.0 if crab else 3.4
    s.proxy_slab((-3.4, 3.4), (-half, half), (0, 2), 0.4)
    s.proxy_slab((-4, 3.4), (-min(half, 5), min(half, 5)), (2, 4.9), 1.0)
    shift(s, -2.4 if crab else -0.55)


@builder("dinosaur")
def dinosaur(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two-legged dinosaur with a long tail, about 4 m long."""
    bone(s, (-24, 0, 130), 44, (44, 0, 150), 34, c, detail=3)
    bone(s, (44, 0, 150), 32, (92, 0, 206), 20, c)
    blob(s, [((92, 0, 214), 22), ((146, 0, 204), 13), ((150, 0, 200), 10)], c)
    blob(s, [((96, 0, 196), 12), ((142, 0, 184), 8)], shade(c, 0.9))
    bone(s, (-40, 0, 130), 38, (-120, 0, 92), 20, c)
    bone(s, (-120, 0, 92), 20, (-212, 0, 62), 4, c)
    for k in range(7):
        s.ball(1, (-34 + 16 * k, 0, 170 + 3 * k), shade(c, 0.6), scale=(8, 4, 13), detail=2)
    for side in (-1, 1):
        bone(s, (-18, side * 30, 118), 30, (6, side * 38, 66), 18, c)
        bone(s, (6, side * 38, 66), 16, (-10, side * 38, 16), 11, c)
        s.ball(1, (12, side * 38, 9), shade(c, 0.85), scale=(34, 17, 9))
        bone(s, (58, side * 26, 140), 9, (84, side * 30, 116), 5, c)
        s.ball(3.4, (116, side * 16, 226), YELLOW, detail=2)
        for k in range(5):
            bone(
                s,
                (112 + 9 * k, side * 9, 194),
                2,
                (112 + 9 * k, side * 9, 184),
                0.4,
                WHITE,
                detail=1,
            )
    for side in (-1, 1):
        s.proxy_slab((-22, 44), (22, 54) if side > 0 else (-54, -22), (0, 18), 2.0)
        s.proxy_slab((-30, 14), (22, 54) if side > 0 else (-54, -22), (18, 92), 1.0)
    s.proxy_slab((-62, 68), (-36, 36), (92, 176), 1.0)
    s.proxy_slab((-140, -62), (-18, 18), (78, 140), 0.5)
    s.proxy_slab((68, 154), (-18, 18), (176, 234), 0.4)
    s.surface("back", 176, (30, 20), (3, 0))
    shift(s, 28)


@builder("monkey")
def monkey(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "monkey") -> None:
    """Sitting monkey, 60 cm; a kangaroo stands on hind legs and tail."""
    face = rgb(222, 184, 148)
    s.ball(1, (-2, 0, 22), c, scale=(12, 12, 19), rough=1.0)
    s.ball(1, (4, 0, 21), shade(c, 1.4), scale=(8, 8.6, 13), rough=1.0)
    s.ball(9.4, (3, 0, 47), c, rough=1.0)
    s.ball(1, (8, 0, 45), face, scale=(6, 7, 6.6), of="skin")
    s.ball(1, (12, 0, 42.6), face, scale=(4, 4.6, 3.2), of="skin")
    _eyes(s, 13, 2.8, 48, 1.0)
    for side in (-1, 1):
        s.ball(1, (2, side * 10, 48), face, scale=(2, 3, 4), of="skin")
        bone(s, (0, side * 11, 34), 3.6, (11, side * 13, 22), 3, c)
        bone(s, (11, side * 13, 22), 3, (17, side * 9, 14), 2.4, c)
        bone(s, (-2, side * 9, 9), 6.2, (13, side * 14, 12), 4.6, c)
        bone(s, (13, side * 14, 12), 4, (12, side * 12, 3), 2.6, c)
        s.ball(1, (17, side * 12, 2), face, scale=(7, 3.2, 2), of="skin")
    bone(s, (-11, 0, 6), 2.4, (-26, 0, 3), 2.2, c)
    bone(s, (-26, 0, 3), 2.2, (-34, 0, 16), 1.8, c)
    adorn(s, Anchor((3, 0, 47), 9.4, (1, 0, 38.6), 8.2, (11, 2.8, 1)))
    s.proxy_slab((-12, 20), (-14, 14), (0, 10), 1.0)
    s.proxy_slab((-13, 11), (-12, 12), (10, 38), 1.0)
    s.proxy_slab((-6, 14), (-9, 9), (38, 56), 0.8)
    shift(s, 6)


@builder("kangaroo")
def kangaroo(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Kangaroo upright on hind legs and tail, 140 cm."""
    bone(s, (-8, 0, 56), 22, (8, 0, 96), 14, c, detail=3)
    bone(s, (8, 0, 98), 11, (14, 0, 122), 7, c)
    blob(s, [((16, 0, 126), 8.4), ((32, 0, 120), 4.4)], c)
    _eyes(s, 22, 6.6, 129, 1.2)
    bone(s, (-20, 0, 40), 12, (-50, 0, 10), 7, c)
    bone(s, (-50, 0, 10), 7, (-86, 0, 4), 3.4, c)
    for side in (-1, 1):
        bone(s, (12, side * 4, 132), 2.4, (6, side * 7, 148), 1.2, shade(c, 0.85))
        bone(s, (-6, side * 16, 50), 15, (14, side * 18, 34), 9, c)
        bone(s, (14, side * 18, 34), 7, (-8, side * 18, 9), 5, c)
        bone(s, (-8, side * 18, 5), 5, (28, side * 18, 3.6), 3.6, c)
        bone(s, (14, side * 12, 92), 5, (28, side * 13, 76), 3, c)
    adorn(s, Anchor((16, 0, 126), 8.4, (11.6, 0, 112), 9.6, (7.5, 6.6, 3), 12))
    for side in (-1, 1):
        s.proxy_slab((-12, 31), (13, 23) if side > 0 else (-23, -13), (0, 9), 1.0)
    s.proxy_slab((-86, -40), (-4, 4), (0, 12), 0.8)
    s.proxy_slab((-28, 20), (-18, 18), (9, 76), 1.0)
    s.proxy_slab((-6, 22), (-13, 13), (76, 110), 0.9)
    s.proxy_slab((5, 35), (-8, 8), (110, 135), 0.5)
    shift(s, 26.5)


@builder("rubber_duck")
def rubber_duck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bath toy, 10 cm long."""
    blob(s, [((-1.2, 0, 3), 2.9), ((1.8, 0, 2.9), 2.8)], c, rough=0.3, detail=3)
    bone(s, (-3, 0, 3.6), 1.8, (-4.6, 0, 5.6), 0.6, c, rough=0.3)
    s.ball(2.5, (2.0, 0, 7.1), c, rough=0.3)
    s.ball(1, (4.7, 0, 6.7), _BEAK, scale=(1.3, 1.2, 0.5), of="plastic_hard")
    _eyes(s, 3.7, 1.4, 7.9, 0.4)
    for side in (-1, 1):
        s.ball(1, (-0.6, side * 2.6, 3.6), shade(c, 0.92), scale=(2.4, 0.7, 1.5))
    s.proxy_slab((-3.6, 4), (-2.6, 2.6), (0, 1), 1.0)
    s.proxy_slab((-4.2, 4.4), (-2.9, 2.9), (1, 5.2), 1.0)
    s.proxy_slab((-0.3, 4.4), (-2.2, 2.2), (5.2, 9.5), 0.6)
    shift(s, -0.4, 0, -0.1)
    s.proxies[:] = [
        p.model_copy(update={"position_cm": (*p.position_cm[:2], p.position_cm[2] + 0.1)})
        for p in s.proxies
    ]
