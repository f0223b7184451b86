"""What turns on a stand: seesaws, turnstiles, roundabouts, sails, booms, the arms of catapults."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.geometry.rotations import turn
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    DARK_WOOD,
    GLASS,
    STEEL,
    WHITE,
    Color,
    Sketch,
)


@builder("seesaw_board")
def seesaw_board(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Board of a seesaw with two handles, level, drawn at 300 x 36 x 10."""
    s.slab((-150, 150), (-15, 15), (0, 5), c, solid=1)
    for x in (-1, 1):
        s.rod(1.5, (x * 110, -18, 8.5), (x * 110, 18, 8.5), DARK)
        s.rod(1.2, (x * 110, 0, 5), (x * 110, 0, 8.5), DARK)
    s.surface("front seat", 5, (18, 14), (130, 0))
    s.surface("rear seat", 5, (18, 14), (-130, 0))
    s.mount("pivot", (0.0, 0.0, 2.5), (0.0, 1.0, 0.0))
    s.mount("front end", (130.0, 0.0, 5.2), (0.0, 0.0, 1.0))
    s.mount("back end", (-130.0, 0.0, 5.2), (0.0, 0.0, 1.0))


@builder("seesaw_stand")
def seesaw_stand(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Fulcrum of a seesaw: two cheeks on a foot, drawn at 56 x 44 x 60."""
    profile = ((-28.0, 0.0), (28.0, 0.0), (6.0, 60.0), (-6.0, 60.0))
    for y in ((-22.0, -18.0), (18.0, 22.0)):
        s.extrude(profile, y, c)
        s.proxy_hull([(x, v, z) for x, z in profile for v in y])
    s.slab((-28, 28), (-18, 18), (0, 4), c, solid=1)
    s.rod(2, (0, -22, 56.5), (0, 22, 56.5), STEEL, sections=16)
    s.mount("pivot", (0.0, 0.0, 56.5), (0.0, 1.0, 0.0))


@builder("turnstile_rotor")
def turnstile_rotor(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Four arms on a hub that turns about the vertical, drawn at 130 x 130 x 20."""
    s.rod(9, (0, 0, 0), (0, 0, 20), c, solid=1)
    for k in range(4):
        a = math.pi * (k + 0.5) / 2
        x, y = math.cos(a), math.sin(a)
        s.rod(2.5, (8 * x, 8 * y, 10), (90 * x, 90 * y, 10), CHROME, sections=16)
        mid = (49 * x, 49 * y, 10)
        s.proxy_box((41, 2.5, 2.5), mid, 0.3, turn("z", 90.0 * (k + 0.5)))
    s.mount("spindle", (0.0, 0.0, 0.0))


@builder("turnstile_post")
def turnstile_post(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Post that a turnstile turns on, drawn at 40 x 40 x 82."""
    s.rod(20, (0, 0, 0), (0, 0, 3), DARK, solid=1)
    s.rod(8, (0, 0, 3), (0, 0, 82), c, solid=1)
    s.mount("spindle", (0.0, 0.0, 82.2))


@builder("roundabout_deck")
def roundabout_deck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Deck of a playground merry-go-round with six hoops, drawn at 240 x 240 x 85."""
    s.rod(120, (0, 0, 0), (0, 0, 8), c, solid=1, rough=0.5, sections=48)
    s.rod(6, (0, 0, 8), (0, 0, 60), STEEL, solid=1)
    for k in range(6):
        a = math.pi * k / 3
        x, y = 105 * math.cos(a), 105 * math.sin(a)
        s.rod(2, (x, y, 8), (x, y, 85), STEEL, solid=0.4, sections=12)
        s.rod(1.6, (x, y, 80), (6 * math.cos(a), 6 * math.sin(a), 58), STEEL)
    s.surface("deck", 8, (70, 70))
    s.mount("spindle", (0.0, 0.0, 0.0))


@builder("roundabout_foot")
def roundabout_foot(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Foot that a merry-go-round turns on, drawn at 80 x 80 x 14."""
    s.rod(40, (0, 0, 0), (0, 0, 4), c, solid=1)
    s.rod(20, (0, 0, 4), (0, 0, 14), c, solid=1)
    s.mount("spindle", (0.0, 0.0, 14.2))


@builder("mill_sails")
def mill_sails(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Four sails that turn about X, drawn at 20 x 740 x 740."""
    s.rod(22, (-10, 0, 370), (10, 0, 370), DARK, solid=1)
    for k in range(4):
        along, beside = ((0, 1), (1, 0)) if k % 2 else ((1, 0), (0, 1))
        sign = 1 if k < 2 else -1
        for low, high, left, right, tone in ((20, 370, -8, 8, 0.6), (90, 365, 8, 70, 1.0)):
            span = sorted((sign * low, sign * high))
            wide = sorted((sign * left, sign * right) if k % 2 else (-sign * left, -sign * right))
            y = [span[i] * along[0] + wide[i] * beside[0] for i in (0, 1)]
            z = [370 + span[i] * along[1] + wide[i] * beside[1] for i in (0, 1)]
            color = (c[0] * tone, c[1] * tone, c[2] * tone)
            s.slab((-3, 3), (y[0], y[1]), (z[0], z[1]), color, solid=1)
    s.mount("hub", (-10.0, 0.0, 370.0), (1.0, 0.0, 0.0))


@builder("mill_tower")
def mill_tower(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Tower of a windmill with its cap and shaft, drawn at 360 x 340 x 640."""
    s.lathe([(0, 0), (150, 0), (110, 520), (0, 520)], c, center=(-20, 0, 0), sections=8)
    s.lathe([(0, 520), (125, 520), (90, 600), (0, 640)], DARK_WOOD, center=(-20, 0, 0), sections=16)
    s.rod(12, (0, 0, 385), (168, 0, 385), DARK, solid=1)
    s.slab((125, 131), (-35, 35), (0, 150), DARK_WOOD)
    s.proxy_cylinder(145, (0, 260), xy=(-20.0, 0.0))
    s.proxy_cylinder(128, (260, 640), xy=(-20.0, 0.0))
    s.mount("hub", (172.0, 0.0, 385.0), (1.0, 0.0, 0.0))


@builder("boom_arm")
def boom_arm(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Striped boom along Y with a counterweight, drawn at 10 x 360 x 24."""
    n = 8
    for k in range(n):
        y = (-120 + 300 * k / n, -120 + 300 * (k + 1) / n)
        s.slab((-3, 3), y, (8, 16), WHITE if k % 2 else c)
    s.proxy_slab((-3, 3), (-120, 180), (8, 16))
    s.slab((-5, 5), (-180, -120), (0, 24), DARK, solid=2)
    s.mount("pivot", (-5.0, -110.0, 12.0), (1.0, 0.0, 0.0))


@builder("boom_post")
def boom_post(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Cabinet of a boom gate, drawn at 36 x 40 x 110."""
    s.slab((-18, 16), (-20, 20), (0, 110), c, solid=1, rough=0.4)
    s.rod(4, (16, 0, 95), (18, 0, 95), STEEL)
    s.mount("pivot", (18.5, 0.0, 95.0), (1.0, 0.0, 0.0))


@builder("swing_boom")
def swing_boom(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Boom along Y that swings about an upright pin, drawn at 14 x 260 x 14."""
    s.slab((-7, 7), (-130, -106), (0, 14), DARK, solid=1)
    s.slab((-5, 5), (-106, 130), (2, 12), c, solid=0.3)
    for k in range(3):
        y = 100 - 80 * k
        s.slab((-5.2, 5.2), (y - 10, y + 10), (1.8, 12.2), WHITE)
    s.mount("pin", (0.0, -118.0, 0.0))


@builder("boom_mast")
def boom_mast(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Mast that a boom swings on, drawn at 60 x 60 x 140."""
    s.rod(30, (0, 0, 0), (0, 0, 4), DARK, solid=1)
    s.rod(8, (0, 0, 4), (0, 0, 140), c, solid=1)
    s.mount("pin", (0.0, 0.0, 140.2))


@builder("catapult_arm")
def catapult_arm(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Arm along X with a cup at its rear end, drawn at 160 x 30 x 14."""
    s.slab((-52, 80), (-4, 4), (0, 7), c, solid=1)
    s.slab((-80, -50), (-15, 15), (0, 3), c, solid=1)
    for x in ((-80, -77), (-53, -50)):
        s.slab(x, (-15, 15), (3, 14), c, solid=1)
    for y in ((-15, -12), (12, 15)):
        s.slab((-77, -53), y, (3, 14), c, solid=1)
    s.surface("cup", 3, (12, 12), (-65, 0))
    s.region("cup", (-77, -53), (-12, 12), (3, 14))
    s.mount("axle", (60.0, 0.0, 3.5), (0.0, 1.0, 0.0))


@builder("catapult_frame")
def catapult_frame(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Frame of a catapult with an axle, drawn at 200 x 70 x 70."""
    for y in (-1, 1):
        s.slab((-100, 100), (y * 30 - 5, y * 30 + 5), (0, 12), c, solid=1)
        s.slab((50, 62), (y * 30 - 5, y * 30 + 5), (12, 70), c, solid=1)
        s.rod(3, (-10, y * 30, 12), (54, y * 30, 62), c)
    for x in (-95, 90):
        s.slab((x, x + 8), (-25, 25), (0, 10), c, solid=1)
    s.rod(3, (56, -35, 40), (56, 35, 40), STEEL)
    s.mount("axle", (56.0, 0.0, 40.0), (0.0, 1.0, 0.0))


@builder("revolving_leaves")
def revolving_leaves(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Four glazed leaves about a spindle, drawn at 190 x 190 x 210."""
    s.rod(4, (0, 0, 0), (0, 0, 210), STEEL, solid=1)
    for x, y in (
        ((4, 95), (-2, 2)),
        ((-95, -4), (-2, 2)),
        ((-2, 2), (4, 95)),
        ((-2, 2), (-95, -4)),
    ):
        s.slab(x, y, (0, 12), c)
        s.slab(x, y, (200, 210), c)
        s.slab(x, y, (12, 200), GLASS, alpha=0.4)
        s.proxy_slab(x, y, (0, 210))
    s.mount("spindle", (0.0, 0.0, 0.0))


@builder("revolving_drum")
def revolving_drum(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Canopy and two curved walls around a revolving door, drawn at 216 x 216 x 240."""
    s.rod(108, (0, 0, 216), (0, 0, 240), c, solid=0.3, sections=48)
    for k in range(-2, 3):
        for side in (90.0, 270.0):
            a = math.radians(side + 20.0 * k)
            at = (103 * math.cos(a), 103 * math.sin(a), 108.0)
            size = (3.0, 37.0, 216.0)
            s.box(size, at, GLASS, solid=1, alpha=0.4, quat=turn("z", side + 20.0 * k))
    s.mount("spindle", (0.0, 0.0, 2.0))
