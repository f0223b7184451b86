"""What folds, spins, tips and is let go: laptops, fans, wheels, bridges, levers, balances.

Their parts agree at their usual proportions; what lies level at 0 is raised about -Y.
"""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.rotations import turn
from esg.assets.geometry.sketch import BRASS, CHROME, DARK, DARK_WOOD, STEEL, WHITE, Color, Sketch

_ACROSS = (0.0, 1.0, 0.0)
_UP_IN_FRONT = (0.0, -1.0, 0.0)


@builder("laptop_base")
def laptop_base(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Keyboard half of a laptop, hinged at its back, drawn at 23 x 33 x 1.8."""
    s.slab((-11.5, 11.5), (-16.5, 16.5), (0, 1.7), c, solid=1, rough=0.4)
    s.slab((-8.5, 3), (-14.5, 14.5), (1.7, 1.8), DARK)
    s.slab((4.5, 10), (-5, 5), (1.7, 1.75), shade(c, 0.85))
    s.surface("top", 1.8, (11, 16))
    s.mount("hinge", (-11.5, 0.0, 1.85), _UP_IN_FRONT)


@builder("laptop_lid")
def laptop_lid(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Screen half of a laptop, face down, hinged at its back, drawn at 23 x 33 x 0.8."""
    s.slab((-11.5, 11.5), (-16.5, 16.5), (0.1, 0.8), c, solid=1, rough=0.4)
    s.slab((-10.5, 10.8), (-15.8, 15.8), (0, 0.1), DARK, rough=0.1)
    s.mount("hinge", (-11.5, 0.0, 0.0), _UP_IN_FRONT)


@builder("fan_rotor")
def fan_rotor(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Four blades below a motor on a rod, drawn at 130 x 130 x 42."""
    s.rod(11, (0, 0, 4), (0, 0, 16), BRASS, solid=3)
    s.ball(6, (0, 0, 6), WHITE, rough=0.3)
    s.rod(1.4, (0, 0, 16), (0, 0, 42), BRASS, solid=1, sections=16)
    for k in range(4):
        a = math.radians(90.0 * k)
        at = (38 * math.cos(a), 38 * math.sin(a), 10.0)
        s.box((54, 13, 1.2), at, c, solid=1, quat=turn("z", 90.0 * k))
    s.mount("spindle", (0.0, 0.0, 42.0))


@builder("ceiling_piece")
def ceiling_piece(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Piece of a ceiling on four posts, with a hook plate below it, drawn at 200 x 200 x 272."""
    s.slab((-100, 100), (-100, 100), (262.5, 272), c, solid=1)
    for x in (-96, 96):
        for y in (-96, 96):
            s.slab((x - 4, x + 4), (y - 4, y + 4), (0, 262.5), shade(c, 0.85), solid=1)
    s.mount("spindle", (0.0, 0.0, 262.0))


@builder("ferris_rotor")
def ferris_rotor(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two rims with eight round cabins between them, drawn at 80 x 1060 x 1060."""
    hub = 530.0
    s.rod(22, (-38, 0, hub), (38, 0, hub), DARK, solid=0.5)
    for x in (-34, 34):
        s.torus(470, 6, (x, 0, hub), c, axis="x")
    for k in range(4):
        for x in (-34, 34):
            s.box((6, 940, 6), (x, 0, hub), c, quat=turn("x", 45.0 * k))
        s.proxy_box((37, 470, 3), (0, 0, hub), 0.1, turn("x", 45.0 * k))
    for k in range(8):
        a = math.radians(45.0 * k)
        y, z = 470 * math.cos(a), hub + 470 * math.sin(a)
        s.rod(55, (-30, y, z), (30, y, z), shade(c, 0.6 + 0.05 * k), solid=0.2, sections=24)
    s.mount("hub", (0.0, 0.0, hub), (1.0, 0.0, 0.0))


@builder("ferris_stand")
def ferris_stand(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two trestles with an axle between them, drawn at 130 x 700 x 620."""
    for x in (-1, 1):
        span = (x * 55.0 - 10.0, x * 55.0 + 10.0)
        for y in (-1, 1):
            foot, head = y * 330.0, y * 6.0
            profile = ((foot - 15, 0), (foot + 15, 0), (head + 12, 615), (head - 12, 615))
            s.proxy_hull([(v, a, z) for a, z in profile for v in span])
            s.rod(9, (x * 55, foot, 6), (x * 55, head, 608), c)
        s.slab(span, (-350, 350), (0, 12), shade(c, 0.7), solid=1)
    s.rod(8, (-62, 0, 605), (62, 0, 605), STEEL)
    s.mount("hub", (0.0, 0.0, 605.0), (1.0, 0.0, 0.0))


@builder("bridge_deck")
def bridge_deck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Planked deck that is raised about its rear edge, drawn at 300 x 240 x 12."""
    for k in range(10):
        s.slab((-149 + 30 * k, -121 + 30 * k), (-120, 120), (5, 12), shade(c, 0.95 + 0.01 * k))
    for y in (-100, 0, 100):
        s.slab((-150, 150), (y - 8, y + 8), (0, 5), DARK_WOOD)
    s.proxy_slab((-150, 150), (-120, 120), (0, 12))
    s.surface("deck", 12, (145, 115))
    s.mount("sill", (-150.0, 0.0, 0.0), _UP_IN_FRONT)


@builder("gatehouse")
def gatehouse(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two towers and what spans them, with a way through along X, drawn at 120 x 420 x 440."""
    for y in ((-210, -125), (125, 210)):
        s.slab((-60, 60), y, (0, 400), c, solid=1)
        for x in ((-60, -25), (25, 60)):
            s.slab(x, y, (400, 440), shade(c, 0.9))
    s.slab((-60, 60), (-125, 125), (330, 400), c, solid=1)
    for y in (-110, 110):
        s.rod(6, (58, y, 322), (60.5, y, 322), DARK, sections=16)
    s.region("inside", (-60, 60), (-125, 125), (0, 330), "area")
    s.mount("sill", (60.5, 0.0, 4.0), _UP_IN_FRONT)


@builder("lever_arm")
def lever_arm(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Upright lever with a grip, drawn at 8 x 8 x 94."""
    s.slab((-1, 1), (-1.5, 1.5), (0, 78), c, solid=1)
    s.rod(2.4, (0, 0, 76), (0, 0, 90), DARK, solid=0.3)
    s.ball(3.6, (0, 0, 90.4), (0.75, 0.12, 0.1), solid=0.3)
    s.mount("pivot", (0.0, 0.0, 3.0), _ACROSS)


@builder("lever_foot")
def lever_foot(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Plate with two cheeks and a pin, drawn at 36 x 26 x 8."""
    s.slab((-18, 18), (-13, 13), (0, 1.5), c, solid=1)
    for y in ((-5, -3), (3, 5)):
        s.slab((-4, 4), y, (1.5, 8), shade(c, 0.8), solid=1)
    s.rod(0.8, (0, -5, 5), (0, 5, 5), CHROME, sections=12)
    s.mount("pivot", (0.0, 0.0, 5.0), _ACROSS)


@builder("balance_pans")
def balance_pans(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Beam with a pan below each end, drawn at 80 x 24 x 40.

    Pans turn with their beam but weigh little, as what hangs freely pulls at the beam's end.
    """
    s.slab((-29, 29), (-0.8, 0.8), (37, 39.5), c, solid=20)
    for x in (-1, 1):
        s.lathe(
            [(0, 0), (9, 0), (11.8, 2), (11.4, 2.2), (8.8, 0.6), (0, 0.6)], c, center=(x * 28, 0, 0)
        )
        s.proxy_cylinder(11, (0, 1.5), 0.1, (x * 28.0, 0.0))
        for k in range(3):
            a = 2.0 * math.pi * (k + 0.5) / 3
            rim = (x * 28 + 11 * math.cos(a), 11 * math.sin(a), 1.8)
            s.rod(0.15, rim, (x * 28, 0, 37), STEEL, sections=6)
    s.surface("front pan", 1.5, (7, 7), (28, 0))
    s.surface("rear pan", 1.5, (7, 7), (-28, 0))
    s.mount("pivot", (0.0, 0.0, 39.0), _ACROSS)
    s.mount("front end", (28.0, 0.0, 1.7), (0.0, 0.0, 1.0))
    s.mount("back end", (-28.0, 0.0, 1.7), (0.0, 0.0, 1.0))


@builder("balance_stand")
def balance_stand(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Column on a foot, with an edge for a beam, drawn at 36 x 20 x 54."""
    s.slab((-18, 18), (-10, 10), (0, 3), DARK_WOOD, solid=1)
    s.rod(1.4, (0, 0, 3), (0, 0, 50), c, solid=1, sections=20)
    for y in (-2.2, 2.2):
        s.slab((-1.4, 1.4), (y - 0.6, y + 0.6), (49, 54), c)
    s.mount("pivot", (0.0, 0.0, 51.0), _ACROSS)


@builder("clock_pendulum")
def clock_pendulum(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flat bob on a rod that swings along Y, drawn at 3 x 12 x 70."""
    s.rod(6, (-1.5, 0, 6), (1.5, 0, 6), c, solid=1, sections=40)
    s.slab((-0.3, 0.3), (-0.6, 0.6), (12, 70), DARK_WOOD, solid=0.5)
    s.mount("pivot", (0.0, 0.0, 70.0), (1.0, 0.0, 0.0))


@builder("clock_case")
def clock_case(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Tall case, open in front below its dial, drawn at 28 x 50 x 205."""
    s.slab((-14, 14), (-25, 25), (0, 45), c, solid=1)
    for y in ((-25, -23), (23, 25)):
        s.slab((-14, 14), y, (45, 155), c, solid=1)
    s.slab((-14, -12), (-23, 23), (45, 155), shade(c, 0.7), solid=1)
    s.slab((-14, 14), (-25, 25), (155, 198), c, solid=1)
    s.slab((-12, 12), (-22, 22), (198, 205), shade(c, 0.85))
    s.rod(18, (13.8, 0, 177), (14, 0, 177), WHITE, sections=40)
    for y, z in ((0, 189), (8, 181)):
        s.rod(0.5, (14, 0, 177), (14, y, z), DARK, sections=8)
    s.mount("pivot", (0.0, 0.0, 150.0), (1.0, 0.0, 0.0))


@builder("trebuchet_arm")
def trebuchet_arm(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Beam above its axle and counterweight below it, at rest, drawn at 70 x 60 x 400."""
    s.slab((-35, 35), (-30, 30), (0, 55), DARK_WOOD, solid=3)
    s.slab((-7, 7), (-6, 6), (55, 230), c, solid=1)
    s.slab((-4, 4), (-4, 4), (230, 385), c, solid=1)
    s.slab((-10, 10), (-10, 10), (385, 400), c, solid=1)
    s.mount("axle", (0.0, 0.0, 100.0), _ACROSS)


@builder("trebuchet_frame")
def trebuchet_frame(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two trestles on runners with an axle across, drawn at 300 x 170 x 270."""
    for y in (-1, 1):
        beside = (y * 72.0 - 12.0, y * 72.0 + 12.0)
        s.slab((-150, 150), beside, (0, 18), c, solid=1)
        for x in (-1, 1):
            s.rod(8, (x * 100, y * 72, 16), (x * 5, y * 72, 262), c)
            profile = ((x * 115, 18), (x * 88, 18), (x * 1, 262), (x * 12, 262))
            s.proxy_hull([(a, v, z) for a, z in profile for v in beside])
    for x in (-145, 125):
        s.slab((x, x + 20), (-60, 60), (0, 14), c, solid=1)
    s.rod(5, (0, -85, 255), (0, 85, 255), STEEL)
    s.mount("axle", (0.0, 0.0, 255.0), _ACROSS)


@builder("launcher_plunger")
def launcher_plunger(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Upright plate on a rod, pushed along X, drawn at 60 x 30 x 24."""
    s.slab((26, 30), (-15, 15), (0, 24), c, solid=1)
    s.rod(2, (-30, 0, 12), (26, 0, 12), CHROME, solid=1)
    s.mount("rail", (-30.0, 0.0, 12.0), (1.0, 0.0, 0.0))


@builder("bumper_plate")
def bumper_plate(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Upright plate on a rod that things run into, pushed back along X, drawn at 24 x 30 x 24."""
    s.slab((10, 12), (-15, 15), (0, 24), c, solid=1)
    s.rod(1.5, (-12, 0, 12), (10, 0, 12), CHROME, solid=1)
    s.mount("rail", (-12.0, 0.0, 12.0), (1.0, 0.0, 0.0))


@builder("bumper_block")
def bumper_block(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Block that the rod of a bumper slides into, a coil before it, drawn at 40 x 34 x 28."""
    s.slab((-20, 0), (-17, 17), (0, 28), c, solid=1)
    for k in range(7):
        s.torus(7, 0.9, (1 + 3 * k, 0, 14), STEEL, axis="x")
    s.mount("rail", (-2.0, 0.0, 14.0), (1.0, 0.0, 0.0))


@builder("launcher_rail")
def launcher_rail(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Block at the rear that a rod slides in, with a coil before it, drawn at 120 x 34 x 30."""
    s.slab((-60, -20), (-17, 17), (0, 30), c, solid=1)
    for y in ((-17, -15), (15, 17)):
        s.slab((-20, 60), y, (0, 3), shade(c, 0.8), solid=1)
    for k in range(6):
        s.torus(6, 0.8, (-17 + 4 * k, 0, 15), STEEL, axis="x")
    s.mount("rail", (-22.0, 0.0, 15.0), (1.0, 0.0, 0.0))
