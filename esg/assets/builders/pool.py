"""Billiard tables with six real pockets, and their cue.

Proportions follow the WPA equipment specification: cushion noses at 62.5-64.5 % of the ball's
diameter, corner mouths 11.4-11.7 cm, side mouths 12.7-13.0 cm for 5.715 cm balls.
"""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.sketch import BRASS, DARK, DARK_WOOD, PALE_WOOD, WHITE, WOOD, Color, Sketch

RAIL, OUTER = 8.5, 5.0
CUSHION_Z = 3.7
DROP = 18.0


@builder("billiard_table")
def billiard_table(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Nine-foot table, drawn at 281 x 154 x 81; the bed is 4 cm below the rail's top."""
    L, W, H = 281.0, 154.0, 81.0
    a, b, bed = L / 2 - RAIL - OUTER, W / 2 - RAIL - OUTER, H - 4.0
    low = bed - DROP
    xc, yc = a - 5.5, b - 5.5  # inner edges of the corner pockets
    ys, side = b - 1.5, 6.5  # inner edge and half mouth of the side pockets
    mouth = 8.6  # distance of a cushion's end from the corner
    ox, oy = a + RAIL, b + RAIL

    def both(
        x: tuple[float, float],
        y: tuple[float, float],
        z: tuple[float, float],
        color: Color,
        rough: float = 0.9,
    ) -> None:
        s.slab(x, y, z, color, solid=1.0, rough=rough)

    both((-xc, xc), (-ys, ys), (low, bed), c)
    for sx in (-1, 1):
        both(_pair(sx, xc, ox), (-yc, yc), (low, bed), c)
        both(_pair(sx, a, ox), (-b + mouth, b - mouth), (bed, bed + CUSHION_Z), _dark(c))
        both(_pair(sx, ox, ox + OUTER), (-oy - OUTER, oy + OUTER), (low, H), DARK_WOOD, 0.3)
        for sy in (-1, 1):
            both(_pair(sx, side, xc), _pair(sy, ys, oy), (low, bed), c)
            both(_pair(sx, side, a - mouth), _pair(sy, b, oy), (bed, bed + CUSHION_Z), _dark(c))
            s.slab(
                _pair(sx, L / 2 - 32, L / 2 - 12),
                _pair(sy, W / 2 - 30, W / 2 - 10),
                (0, low - 15),
                DARK_WOOD,
                solid=0.6,
            )
    for sy in (-1, 1):
        both((-ox, ox), _pair(sy, oy, oy + OUTER), (low, H), DARK_WOOD, 0.3)
        for x in (-a * 0.75, -a * 0.5, -a * 0.25, a * 0.25, a * 0.5, a * 0.75):
            s.rod(
                0.8,
                (x, sy * (oy + OUTER / 2), H - 0.05),
                (x, sy * (oy + OUTER / 2), H + 0.02),
                WHITE,
                sections=12,
            )
    both((-L / 2 + 3, L / 2 - 3), (-W / 2 + 3, W / 2 - 3), (low - 15, low), WOOD, 0.4)
    ends = {"top": 1, "middle": 0, "bottom": -1}
    sides = {"left": 1, "right": -1}
    for end, sx in ends.items():
        for lateral, sy in sides.items():
            if sx:
                x, y = _pair(sx, xc, ox), _pair(sy, yc, oy)
            else:
                x, y = (-side, side), _pair(sy, ys, oy)
            s.region(f"{end} {lateral} pocket", x, y, (low, bed + 1.0), "pocket")
            s.slab((x[0] + 0.2, x[1] - 0.2), (y[0] + 0.2, y[1] - 0.2), (low, low + 0.3), DARK)
            px = sx * (ox - 1.0)
            s.box(
                (3.0, 14, 0.6) if sx else (14, 3.0, 0.6),
                (px if sx else 0.0, sy * (oy - (8 if sx else 1)), H - 0.3),
                BRASS,
                metal=0.8,
            )
    s.surface("bed", bed, (a - 9.0, b - 4.0))


def _pair(sign: int, lo: float, hi: float) -> tuple[float, float]:
    return (lo, hi) if sign > 0 else (-hi, -lo)


def _dark(c: Color) -> Color:
    return (c[0] * 0.78, c[1] * 0.78, c[2] * 0.78)


@builder("cue")
def cue(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Cue stick lying along the front axis, tip forward, drawn at 147 x 2.9 x 2.9."""
    r = 1.45
    tip = [(0, 73.5), (0.45, 73.5), (0.62, 72), (0.64, 70)]
    shaft = [(0, 70), (0.64, 70), (1.0, 10), (0, 10)]
    butt = [(0, 10), (1.0, 10), (1.4, -70), (1.45, -73), (1.2, -73.5), (0, -73.5)]
    for profile, color in ((tip, (0.2, 0.4, 0.7)), (shaft, PALE_WOOD), (butt, DARK_WOOD)):
        s.lathe(list(reversed(profile)), color, center=(0, 0, r), axis="x", sections=24, rough=0.25)
    s.proxy_hull(
        [
            (x, y * q, z)
            for x, q, lift in ((-73.5, r, 0.0), (73.5, 0.62, 0.0))
            for y, z in ((-0.7, lift), (0.7, lift), (-1, r), (1, r), (0.0, r + q))
        ]
    )
