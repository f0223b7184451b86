"""Billiard tables with six real pockets, and their cue.

Proportions follow the WPA equipment specification: cushion noses at 62.5-64.5 % of the ball's
diameter, corner mouths 11.4-11.7 cm, side mouths 12.7-13.0 cm for 5.715 cm balls.
"""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored
from esg.assets.geometry.rotations import turn
from esg.assets.geometry.sketch import DARK, DARK_WOOD, WHITE, WOOD, Color, Sketch, rgb

RAIL, OUTER = 10.0, 4.0
CUSHION_Z = 3.7
LEAN = 20.0
"""Undercut of a pocket's back [deg]."""
LEATHER = rgb(52, 34, 24)
DROP = 18.0
CORNER_MOUTH, SIDE_MOUTH = 8.6, 6.5
"""From a corner to a cushion's end; half width between the cushions of a side pocket [cm]."""


@builder("billiard_table")
def billiard_table(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Nine-foot table, drawn at 282 x 155 x 84.2; the bed is at 77, the rails rise 4 cm above.

    The bed is one box, so that no seam can kick a rolling ball; the pockets lie outside its edges,
    between blocks that carry the cushions.
    """
    length, width, height = 282.0, 155.0, 84.2
    a, b, bed = length / 2 - RAIL - OUTER, width / 2 - RAIL - OUTER, height - 7.2
    rail, low = bed + 4.0, bed - DROP
    ox, oy = a + RAIL, b + RAIL
    felt, side = _dark(c), SIDE_MOUTH

    s.slab((-a, a), (-b, b), (low, bed), c, solid=1.0, rough=0.9)
    for sx in (-1, 1):
        _cushion(s, mirrored(sx, a, ox), (-b + CORNER_MOUTH, b - CORNER_MOUTH), low, bed, felt)
        s.slab(
            mirrored(sx, ox, ox + OUTER),
            (-oy - OUTER, oy + OUTER),
            (low, rail),
            DARK_WOOD,
            solid=1.0,
            rough=0.3,
        )
        for sy in (-1, 1):
            _cushion(s, mirrored(sx, side, a - CORNER_MOUTH), mirrored(sy, b, oy), low, bed, felt)
            s.slab(
                mirrored(sx, length / 2 - 32, length / 2 - 12),
                mirrored(sy, width / 2 - 30, width / 2 - 10),
                (0, low - 15),
                DARK_WOOD,
                solid=0.6,
            )
    for sy in (-1, 1):
        s.slab(
            (-ox, ox), mirrored(sy, oy, oy + OUTER), (low, rail), DARK_WOOD, solid=1.0, rough=0.3
        )
        for k in (-3, -2, -1, 1, 2, 3):
            at = (k * a / 4, sy * (oy + OUTER / 2))
            s.rod(0.8, (*at, rail - 0.05), (*at, rail + 0.02), WHITE, sections=12)
    s.slab(
        (-length / 2 + 3, length / 2 - 3),
        (-width / 2 + 3, width / 2 - 3),
        (low - 15, low),
        WOOD,
        solid=1.0,
    )
    for end, sx in (("top", 1), ("middle", 0), ("bottom", -1)):
        for lateral, sy in (("left", 1), ("right", -1)):
            _pocket(s, f"{end} {lateral} pocket", sx, sy, (a, b, bed))
    s.surface("bed", bed, (a - 9.0, b - 4.0))


def _cushion(
    s: Sketch, x: tuple[float, float], y: tuple[float, float], low: float, bed: float, felt: Color
) -> None:
    """A block from the cabinet up to the cushion's nose, felt above, wood below."""
    s.slab(x, y, (low, bed), WOOD)
    s.slab(x, y, (bed, bed + CUSHION_Z), felt, rough=0.9)
    s.proxy_slab(x, y, (low, bed + CUSHION_Z))


def _pocket(s: Sketch, name: str, sx: int, sy: int, size: tuple[float, float, float]) -> None:
    """Region, dark floor, leather back and lid of one pocket."""
    a, b, bed = size
    ox, oy, low, reach = a + RAIL, b + RAIL, bed - DROP, CORNER_MOUTH
    if sx:
        x, y = mirrored(sx, a - reach, ox), mirrored(sy, b - reach, oy)
        floor = (mirrored(sx, a, ox), y)
        lid = mirrored(sx, ox - 6.0, ox + 1.5), mirrored(sy, oy - 6.0, oy + 1.5)
        width = RAIL + reach
        _liner(s, (sx * ox, sy * (oy - width / 2), bed), "x", sx, width)
        _liner(s, (sx * (ox - width / 2), sy * oy, bed), "y", sy, width)
    else:
        x, y = (-SIDE_MOUTH, SIDE_MOUTH), mirrored(sy, b, oy)
        floor = (x, y)
        lid = (-SIDE_MOUTH - 1.0, SIDE_MOUTH + 1.0), mirrored(sy, oy - 4.5, oy + 1.5)
        _liner(s, (0.0, sy * oy, bed), "y", sy, 2 * SIDE_MOUTH)
    s.region(name, x, y, (low, bed + 1.0), "pocket")
    s.slab(*floor, (low, low + 0.3), DARK)
    s.slab(*lid, (bed + 6.4, bed + 7.2), LEATHER, solid=0.3, rough=0.8, of="walnut")


def _liner(s: Sketch, at: tuple[float, float, float], axis: str, sign: int, width: float) -> None:
    """Leather back of a pocket, leaning inwards so that a fast ball is turned down, not out."""
    thick, tall = 2.4, 7.6
    quat = turn("y", -LEAN * sign) if axis == "x" else turn("x", LEAN * sign)
    # The foot stays outside the hole's edge; the top leans in over it.
    offset = sign * (thick / 2 - 0.2 - tall / 2 * math.sin(math.radians(LEAN)))
    center = (
        (at[0] + offset, at[1], at[2] + 1.6)
        if axis == "x"
        else (at[0], at[1] + offset, at[2] + 1.6)
    )
    size = (thick, width, tall) if axis == "x" else (width, thick, tall)
    s.box(size, center, LEATHER, solid=0.3, rough=0.9, quat=quat, of="walnut")


def _dark(c: Color) -> Color:
    return (c[0] * 0.78, c[1] * 0.78, c[2] * 0.78)
