"""What turns on a stand: seesaws and turnstiles."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.geometry.rotations import turn
from esg.assets.geometry.sketch import CHROME, DARK, STEEL, Color, Sketch


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


@builder("seesaw_stand")
def seesaw_stand(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Fulcrum of a seesaw: two cheeks on a foot, drawn at 56 x 44 x 60."""
    profile = ((-28.0, 0.0), (28.0, 0.0), (6.0, 60.0), (-6.0, 60.0))
    for y in ((-22.0, -18.0), (18.0, 22.0)):
        s.extrude(profile, y, c, metal=0.4)
        s.proxy_hull([(x, v, z) for x, z in profile for v in y])
    s.slab((-28, 28), (-18, 18), (0, 4), c, solid=1, metal=0.4)
    s.rod(2, (0, -22, 56.5), (0, 22, 56.5), STEEL, metal=0.6, sections=16)
    s.mount("pivot", (0.0, 0.0, 56.5), (0.0, 1.0, 0.0))


@builder("turnstile_rotor")
def turnstile_rotor(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Four arms on a hub that turns about the vertical, drawn at 130 x 130 x 20."""
    s.rod(9, (0, 0, 0), (0, 0, 20), c, solid=1, metal=0.5)
    for k in range(4):
        a = math.pi * (k + 0.5) / 2
        x, y = math.cos(a), math.sin(a)
        s.rod(2.5, (8 * x, 8 * y, 10), (90 * x, 90 * y, 10), CHROME, metal=0.8, sections=16)
        mid = (49 * x, 49 * y, 10)
        s.proxy_box((41, 2.5, 2.5), mid, 0.3, turn("z", 90.0 * (k + 0.5)))
    s.mount("spindle", (0.0, 0.0, 0.0))


@builder("turnstile_post")
def turnstile_post(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Post that a turnstile turns on, drawn at 40 x 40 x 82."""
    s.rod(20, (0, 0, 0), (0, 0, 3), DARK, solid=1)
    s.rod(8, (0, 0, 3), (0, 0, 82), c, solid=1, metal=0.5)
    s.mount("spindle", (0.0, 0.0, 82.2))
