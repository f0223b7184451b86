"""What hangs and what it hangs on: pendulums, wrecking balls, cradles, swings, bags, lamps.

Things swing along X, about an axis along Y; stands leave that way open and reach up beside it.
"""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import LEAF, shade
from esg.assets.geometry.sketch import (
    BRASS,
    DARK,
    DARK_WOOD,
    PALE_WOOD,
    STEEL,
    YELLOW,
    Color,
    Sketch,
)

_ACROSS = (0.0, 1.0, 0.0)


@builder("bob")
def bob(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ball on a thin rod that it swings by, drawn at 10 x 10 x 80."""
    s.ball(5, (0, 0, 5), c, solid=1, rough=0.2)
    s.rod(0.4, (0, 0, 10), (0, 0, 80), STEEL, sections=12)
    s.proxy_slab((-0.4, 0.4), (-0.4, 0.4), (10, 80))
    s.mount("pivot", (0.0, 0.0, 80.0), _ACROSS)


@builder("bob_stand")
def bob_stand(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Portal across Y that a pendulum swings through, drawn at 60 x 60 x 90."""
    for y in (-1, 1):
        s.slab((-30, 30), (y * 27.5 - 2.5, y * 27.5 + 2.5), (0, 4), DARK_WOOD, solid=1)
        s.slab((-1.5, 1.5), (y * 27.5 - 1.5, y * 27.5 + 1.5), (4, 87), c, solid=1)
    s.slab((-1.5, 1.5), (-30, 30), (87, 90), c, solid=1)
    s.rod(1.0, (0, -2, 86.5), (0, 2, 86.5), BRASS, sections=14)
    s.mount("pivot", (0.0, 0.0, 86.0), _ACROSS)


@builder("demolition_ball")
def demolition_ball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Steel ball with an eye on top, drawn at 90 x 90 x 96."""
    s.ball(45, (0, 0, 45), c, solid=1, rough=0.4)
    s.rod(9, (0, 0, 88), (0, 0, 91), DARK, sections=20)
    s.torus(3.0, 1.0, (0, 0, 92), STEEL, axis="y")
    s.mount("eye", (0.0, 0.0, 92.0), _ACROSS)


@builder("demolition_crane")
def demolition_crane(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Crawler crane whose boom reaches across to +Y, drawn at 240 x 640 x 800.

    Its ball swings past the boom's tip along X, clear of the tracks.
    """
    for x in (-1, 1):
        s.slab((x * 95 - 25, x * 95 + 25), (-320, -60), (0, 70), DARK, solid=1)
    s.slab((-70, 70), (-290, -90), (40, 90), shade(c, 0.6), solid=1)
    s.slab((-100, 100), (-310, -70), (90, 210), c, solid=1)
    s.slab((20, 100), (-130, -65), (210, 300), shade(c, 1.1), solid=1)
    foot, tip = (0.0, -80.0, 200.0), (0.0, 292.0, 780.0)
    for x in (-1, 1):
        low, high = (x * 26.0, foot[1], foot[2]), (x * 9.0, tip[1], tip[2])
        s.rod(6, low, high, YELLOW, solid=0.2, sections=12)
    for k in range(9):
        f = k / 9
        at = tuple(a + f * (b - a) for a, b in zip(foot, tip, strict=True))
        half = 26 + f * (9 - 26)
        s.rod(3, (-half, at[1], at[2]), (half, at[1], at[2]), YELLOW, sections=8)
    s.rod(2, (0, -300, 210), tip, DARK, sections=8)
    s.rod(14, (-10, 300, 782), (10, 300, 782), STEEL, solid=0.2)
    s.mount("hook", (0.0, 300.0, 768.0), _ACROSS)


@builder("cradle_ball")
def cradle_ball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Steel ball on two strings that meet at it, drawn at 5 x 16 x 24."""
    s.ball(2.5, (0, 0, 2.5), c, solid=1, rough=0.1)
    for y in (-1, 1):
        s.rod(0.08, (0, 0, 4.9), (0, y * 7.9, 24), STEEL, sections=6)
    s.mount("pivot", (0.0, 0.0, 24.0), _ACROSS)


@builder("cradle_frame")
def cradle_frame(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Frame of a Newton's cradle: two bars along X on a plinth, drawn at 34 x 18 x 30."""
    s.slab((-17, 17), (-9, 9), (0, 2), DARK_WOOD, solid=1, rough=0.3)
    for y in (-1, 1):
        for x in (-1, 1):
            s.rod(0.6, (x * 16, y * 8, 2), (x * 16, y * 8, 29.4), c, solid=1)
        s.rod(0.6, (-16.6, y * 8, 29.4), (16.6, y * 8, 29.4), c, solid=1)
    for k in range(5):
        s.mount(f"pivot {k + 1}", (5.4 * (k - 2), 0.0, 29.0), _ACROSS)


@builder("swing_seat")
def swing_seat(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Board on two rods that it swings by, drawn at 18 x 46 x 170."""
    s.slab((-9, 9), (-23, 23), (0, 3), c, solid=1)
    for y in (-1, 1):
        s.rod(0.6, (0, y * 21, 3), (0, y * 21, 170), STEEL, sections=8)
        s.proxy_slab((-0.6, 0.6), (y * 21 - 0.6, y * 21 + 0.6), (3, 170), 2.0)
    s.surface("seat", 3, (9, 18))
    s.mount("pivot", (0.0, 0.0, 170.0), _ACROSS)


@builder("swing_posts")
def swing_posts(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Frame of a swing: two pairs of legs and a beam along Y, drawn at 160 x 240 x 220."""
    for y in (-1, 1):
        for x in (-1, 1):
            s.rod(3.5, (x * 76.5, y * 112, 0.5), (0, y * 108, 214), c)
            s.proxy_slab((x * 70 - 5, x * 70 + 5), (y * 112 - 5, y * 112 + 5), (0, 30))
        s.proxy_slab((-10, 10), (y * 109 - 4, y * 109 + 4), (150, 216), 0.5)
    s.rod(4, (0, -120, 216), (0, 120, 216), c, solid=0.6)
    s.mount("pivot", (0.0, 0.0, 212.0), _ACROSS)


@builder("hanging_bag")
def hanging_bag(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Heavy bag on four short chains, drawn at 35 x 35 x 150."""
    s.lathe([(0, 0), (16.5, 0), (17.5, 3), (17.5, 112), (16, 116), (0, 117)], c, rough=0.6)
    for z in (18, 60, 100):
        s.lathe([(17.3, z), (17.5, z + 0.5), (17.5, z + 4), (17.3, z + 4.5)], shade(c, 0.7))
    for x in (-1, 1):
        for y in (-1, 1):
            s.rod(0.5, (x * 10, y * 10, 115), (0, 0, 145), STEEL, sections=8)
    s.torus(2.5, 0.6, (0, 0, 147), STEEL, axis="y")
    s.proxy_cylinder(17.5, (0, 117))
    s.mount("chain", (0.0, 0.0, 150.0), (0.0, 0.0, -1.0))


@builder("gallows", "free")
def gallows(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Post with an arm to +Y that something hangs on: freely (hook), or about the arm (bar)."""
    t = 0.04 * min(W, H)
    post = (-W / 2, -W / 2 + 2 * t)
    s.slab((-L / 2, L / 2), post, (0, 1.4 * t), c, solid=1)
    s.slab((-t, t), (post[1], 0.26 * W), (0, t), c, solid=1)
    s.slab((-t, t), post, (1.4 * t, H), c, solid=1)
    s.slab((-0.8 * t, 0.8 * t), (post[1], W / 2), (H - 1.4 * t, H), c, solid=1)
    s.rod(0.35 * t, (0, post[1], 0.75 * H), (0, -0.13 * W, H - t), c, sections=12)
    y, z = 0.36 * W, H - 2 * t
    s.rod(0.14 * t, (0, y, z), (0, y, H - 1.4 * t), STEEL, sections=10)
    s.mount("hook", (0.0, y, z), (0.0, 0.0, -1.0))
    s.mount("bar", (0.0, y, z), _ACROSS)


@builder("beam_on_posts", "free")
def beam_on_posts(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Beam along Y on two braced posts; up to five things hang on it (hook), or about it (bar)."""
    t = 0.04 * min(120.0, H)
    for y in (t - W / 2, W / 2 - t):
        s.slab((-L / 2, L / 2), (y - t, y + t), (0, 1.4 * t), c, solid=1)
        s.slab((-t, t), (y - t, y + t), (1.4 * t, H - 1.6 * t), c, solid=1)
        for x in (-L / 2 + t, L / 2 - t):
            s.rod(0.5 * t, (x, y, 1.4 * t), (0, y, 0.35 * H), c, sections=12)
    s.slab((-t, t), (-W / 2, W / 2), (H - 1.6 * t, H), shade(c, 0.9), solid=1)
    z = H - 2 * t
    for many in range(1, 6):
        for k in range(1, many + 1):
            y = W * (k / (many + 1) - 0.5)
            which = f" {k} of {many}" if many > 1 else ""
            s.mount(f"hook{which}", (0.0, y, z), (0.0, 0.0, -1.0))
            s.mount(f"bar{which}", (0.0, y, z), _ACROSS)


@builder("sign_board")
def sign_board(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Painted board that faces X on two short rods, drawn at 4 x 60 x 50."""
    s.slab((-1.5, 1.5), (-30, 30), (0, 40), c, solid=1)
    for x in ((1.5, 1.7), (-1.7, -1.5)):
        s.slab(x, (-26, 26), (5, 35), PALE_WOOD)
    for y in (-20, 20):
        s.rod(0.6, (0, y, 40), (0, y, 50), STEEL, sections=10)
    s.mount("bar", (0.0, 0.0, 50.0), _ACROSS)


@builder("hanging_bell")
def hanging_bell(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bronze bell below a yoke, drawn at 44 x 44 x 60."""
    outer = [(0, 46), (6, 45), (11, 40), (13, 28), (15, 14), (19, 4), (22, 0)]
    inner = [(20, 0), (17.5, 4), (13.5, 14), (11.5, 28), (9, 40), (0, 43)]
    s.lathe([*outer, *inner], c, rough=0.3)
    s.ball(4, (0, 0, 4), DARK)
    s.rod(0.9, (0, 0, 6), (0, 0, 44), DARK, sections=10)
    s.slab((-3, 3), (-14, 14), (46, 54), DARK_WOOD)
    s.torus(3, 0.8, (0, 0, 56.2), STEEL, axis="x")
    s.proxy_cylinder(20, (0, 14))
    s.proxy_cylinder(14, (14, 54))
    s.mount("bar", (0.0, 0.0, 60.0), _ACROSS)


@builder("hanging_lamp")
def hanging_lamp(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Lamp with a shade on a cord, drawn at 40 x 40 x 90."""
    s.lathe([(0, 26), (5, 26), (20, 4), (20, 0), (19, 0), (4, 24), (0, 24)], c, rough=0.4)
    s.ball(5, (0, 0, 12), (1.0, 0.95, 0.8), rough=0.2)
    s.rod(2.5, (0, 0, 25), (0, 0, 31), DARK)
    s.rod(0.4, (0, 0, 31), (0, 0, 90), DARK, sections=8)
    s.proxy_cylinder(20, (0, 10))
    s.proxy_cylinder(12, (10, 28))
    s.mount("cord", (0.0, 0.0, 90.0), (0.0, 0.0, -1.0))


@builder("hanging_pot")
def hanging_pot(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flower pot on three cords, drawn at 28 x 28 x 65."""
    s.lathe([(0, 0), (9, 0), (13, 20), (14, 20), (14, 23), (12, 23), (12, 18), (0, 18)], c)
    for k in range(5):
        a = 2.0 * math.pi * k / 5
        s.ball(6, (6 * math.cos(a), 6 * math.sin(a), 25), LEAF, detail=2)
    for k in range(3):
        a = 2.0 * math.pi * k / 3
        s.rod(0.25, (13 * math.cos(a), 13 * math.sin(a), 22), (0, 0, 65), DARK_WOOD, sections=6)
    s.proxy_cylinder(12.5, (0, 23))
    s.mount("cord", (0.0, 0.0, 65.0), (0.0, 0.0, -1.0))


@builder("tether_ball")
def tether_ball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ball with an eye on top, drawn at 21 x 21 x 23."""
    s.ball(10.5, (0, 0, 10.5), c, solid=1, rough=0.5)
    s.torus(1.0, 0.3, (0, 0, 21.8), STEEL, axis="y")
    s.mount("eye", (0.0, 0.0, 22.0), _ACROSS)


@builder("tether_pole")
def tether_pole(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pole with a bracket at its top, drawn at 60 x 60 x 310."""
    s.rod(30, (0, 0, 0), (0, 0, 4), DARK, solid=1)
    s.rod(2.5, (0, 0, 4), (0, 0, 310), c, solid=1)
    s.rod(1, (0, 0, 306), (18, 0, 306), c, sections=12)
    s.mount("hook", (18.0, 0.0, 304.0), _ACROSS)
