"""Doors, gates and drawers: what opens, and what it opens in.

A leaf hangs on its right edge (-Y) and opens backwards (-X), away from who comes from the front.
What it hangs in is drawn in proportion to its own extents, so that both fit at any size.
"""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.sketch import CHROME, DARK, STEEL, Color, Sketch, rgb

_SHELF = 0.42
"""Height of the shelf of a cupboard over the cupboard's."""
PAGES = rgb(239, 233, 216)
"""Colour of paper."""
_JAMB, _GAP = 6.0 / 93.0, 0.5 / 93.0
"""Jambs of a door frame and the air beside a leaf, over the frame's width."""
_LINTEL, _SILL = 6.0 / 206.0, 0.8 / 206.0
"""Lintel of a door frame and the air below a leaf, over the frame's height."""
_POST, _AIR = 10.0 / 174.0, 2.0 / 174.0
"""Posts of a gate and the air beside its leaf, over its width."""
_TRAP = 104.0 / 220.0
"""Hole of a platform over its length, with 2 cm of air about the flap."""
_LIFT = 8.0 / 130.0
"""Air below a gate's leaf over the height of its posts."""


@builder("door_leaf", "free")
def door_leaf(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Leaf of a door with a handle on either side; it hangs on the edge of its back."""
    t = L / 3
    s.slab((-t, t), (-W / 2, W / 2), (0, H), c, solid=1)
    for z0, z1 in ((0.08, 0.42), (0.52, 0.92)):
        for x in ((t, t + 0.1 * L), (-t - 0.1 * L, -t)):
            s.slab(x, (-W * 0.38, W * 0.38), (H * z0, H * z1), shade(c, 0.9))
    at, z = W * 0.42, H * 0.5
    for x in (-1, 1):
        s.rod(0.018 * W, (x * t, at, z), (x * 0.47 * L, at, z), CHROME)
        lever = ((x * 0.46 * L, at + 1, z), (x * 0.46 * L, at - W * 0.14, z))
        s.rod(0.04 * L, *lever, CHROME, sections=12)
    s.mount("hinge", (-t, -W / 2, 0.0))


@builder("door_frame", "free")
def door_frame(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two jambs and a lintel; the leaf closes flush with their back."""
    jamb, top = _JAMB * W, H - _LINTEL * H
    inner = (-W / 2 + jamb, W / 2 - jamb)
    for y in ((-W / 2, inner[0]), (inner[1], W / 2)):
        s.slab((-L / 2, L / 2), y, (0, H), c, solid=1)
    s.slab((-L / 2, L / 2), inner, (top, H), c, solid=1)
    s.region("inside", (-L / 2, L / 2), inner, (0, top), "area")
    s.mount("hinge", (-L / 2, inner[0] + _GAP * W, _SILL * H))


@builder("gate_leaf", "free")
def gate_leaf(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Barred leaf of a gate, hung in the middle of its edge."""
    bar = 0.3 * L
    for z in (0.05, 0.5, 0.95):
        s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H * z - bar, H * z + bar), c)
    n = max(3, round(W / 14))
    for k in range(n + 1):
        y = -W / 2 + bar + (W - 2 * bar) * k / n
        s.slab((-0.3 * L, 0.3 * L), (y - bar, y + bar), (0, H), shade(c, 0.92))
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.mount("hinge", (0.0, -W / 2, 0.0))


@builder("gate_posts", "free")
def gate_posts(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two posts with a gap between them, a hinge on the right one."""
    post, cap, air = _POST * W, 0.98 * H, _AIR * W
    inner = (-W / 2 + post, W / 2 - post)
    for y in ((-W / 2, inner[0]), (inner[1], W / 2)):
        s.slab((-0.36 * L, 0.36 * L), y, (0, cap), c, solid=1)
        s.slab((-L / 2, L / 2), y, (cap, H), shade(c, 0.8))
    for z in (0.2, 0.8):
        ends = ((0, inner[0], H * z), (0, inner[0] + air, H * z))
        s.rod(0.1 * L, *ends, STEEL, sections=12)
    s.region("inside", (-L / 2, L / 2), inner, (0, H), "area")
    s.mount("hinge", (0.0, inner[0] + air, _LIFT * H))


@builder("sliding_drawer", "free")
def sliding_drawer(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Open box with a front panel (+X) and a knob; it slides along X."""
    t = 0.03 * (L + W) / 2
    knob = 2 * t
    front = (L / 2 - knob - t, L / 2 - knob)
    back, side = -L / 2, (W / 2 - 2 * t)
    s.slab(front, (-W / 2, W / 2), (0, H), c, solid=1)
    box = shade(c, 1.15)
    s.slab((back, front[0]), (-side, side), (t, 2 * t), box, solid=1)
    for y in ((-side, -side + t), (side - t, side)):
        s.slab((back, front[0]), y, (2 * t, 0.8 * H), box, solid=1)
    s.slab((back, back + t), (-side + t, side - t), (2 * t, 0.8 * H), box, solid=1)
    s.rod(t, (front[1], 0, H / 2), (L / 2, 0, H / 2), CHROME)
    s.region("inside", (back + t, front[0]), (-side + t, side - t), (2 * t, 0.8 * H))
    s.mount("runner", (front[1], 0.0, 0.0), (1.0, 0.0, 0.0))


@builder("drawer_chest", "free")
def drawer_chest(s: Sketch, L: float, W: float, H: float, c: Color, bay_at: str = "bottom") -> None:
    """Chest with a bay for one drawer at the bottom or the top, and a closed front elsewhere."""
    t = 0.045 * W
    high = bay_at == "top"
    bay = (0.62 * H, 0.96 * H) if high else (0.02 * H, 0.36 * H)
    foot, top = (bay[0], H) if high else (0.0, bay[1])
    closed = (0.0, bay[0]) if high else (bay[1], H)
    inner = (-W / 2 + t, W / 2 - t)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), closed, c, solid=1)
    s.slab((L / 2 - 0.1, L / 2 + 0.1), inner, (closed[0] + t, closed[1] - t), shade(c, 1.06))
    for y in ((-W / 2, -W / 2 + t), (W / 2 - t, W / 2)):
        s.slab((-L / 2, L / 2), y, (foot, top), c, solid=1)
    s.slab((-L / 2, -L / 2 + t), inner, (foot, top), c, solid=1)
    if high:
        s.slab((-L / 2, L / 2), (-W / 2, W / 2), (bay[1], H), c, solid=1)
    else:
        s.slab((-L / 2 + t, L / 2), inner, (0, bay[0]), DARK, solid=1)
    s.surface("top", H, (L / 2, W / 2))
    s.mount("runner", (L / 2, 0.0, bay[0] + 0.3), (1.0, 0.0, 0.0))


@builder("cupboard_body", "free")
def cupboard_body(s: Sketch, L: float, W: float, H: float, c: Color, shelf: str = "one") -> None:
    """Cupboard that is open in front (+X), with a shelf or none; its door closes before it.

    The shelf is below the middle of the inside, so that what is put in stands on it.
    """
    t, foot = 0.04 * W, 0.05 * H
    inner = (-W / 2 + t, W / 2 - t)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, foot), shade(c, 0.8), solid=1)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H), c, solid=1)
    s.slab((-L / 2, -L / 2 + t), inner, (foot, H - t), c, solid=1)
    for y in ((-W / 2, inner[0]), (inner[1], W / 2)):
        s.slab((-L / 2, L / 2), y, (foot, H - t), c, solid=1)
    if shelf == "one":
        s.slab((-L / 2 + t, 0.4 * L), inner, (_SHELF * H, _SHELF * H + t), shade(c, 1.1), solid=1)
    s.surface("top", H, (L / 2, W / 2))
    s.region("inside", (-L / 2 + t, L / 2), inner, (foot, H - t))
    s.mount("side", (L / 2, -W / 2, foot), (0.0, 0.0, -1.0))
    s.mount("bottom", (L / 2, 0.0, foot), (0.0, 1.0, 0.0))


@builder("cupboard_door", "free")
def cupboard_door(s: Sketch, L: float, W: float, H: float, c: Color, hung: str = "side") -> None:
    """Flat door with a bar to pull, hung on its right edge (-Y) or on its lower one."""
    t = 0.2 * L
    s.slab((-L / 2, t), (-W / 2, W / 2), (0, H), c, solid=1)
    if hung == "side":
        pull = ((0.44 * L, 0.42 * W, 0.4 * H), (0.44 * L, 0.42 * W, 0.65 * H))
        s.mount("side", (-L / 2, -W / 2, 0.0), (0.0, 0.0, -1.0))
    else:
        pull = ((0.44 * L, -0.4 * W, 0.92 * H), (0.44 * L, 0.4 * W, 0.92 * H))
        s.mount("bottom", (-L / 2, 0.0, 0.0), (0.0, 1.0, 0.0))
    s.rod(0.05 * L, *pull, CHROME, sections=12)
    for x, y, z in pull:
        s.rod(0.04 * L, (t, y, z), (x, y, z), CHROME, sections=10)


@builder("chest_body", "free")
def chest_body(s: Sketch, L: float, W: float, H: float, c: Color, fittings: str = "iron") -> None:
    """Open box across Y; its lid hangs on the upper edge of its back."""
    t = 0.05 * L
    s.walls((-L / 2, L / 2), (-W / 2, W / 2), (0, H), t)
    inner = (-W / 2 + t, W / 2 - t)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, t), c)
    for x in ((-L / 2, -L / 2 + t), (L / 2 - t, L / 2)):
        s.slab(x, (-W / 2, W / 2), (t, H), c)
    for y in ((-W / 2, inner[0]), (inner[1], W / 2)):
        s.slab((-L / 2 + t, L / 2 - t), y, (t, H), c)
    for y in (-0.3 * W, 0.3 * W) if fittings == "iron" else ():
        s.slab((L / 2, L / 2 + 0.01 * L), (y - t, y + t), (0, H), DARK)
    s.surface("lid", 1.302 * H, (L / 2, W / 2))
    s.region("inside", (-L / 2 + t, L / 2 - t), inner, (t, H))
    s.mount("hinge", (-L / 2, 0.0, 1.002 * H), (0.0, -1.0, 0.0))


@builder("chest_lid", "free")
def chest_lid(s: Sketch, L: float, W: float, H: float, c: Color, fittings: str = "iron") -> None:
    """Flat lid with a rim, hung on its rear lower edge."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H), shade(c, 0.95), solid=1)
    s.mount("hinge", (-L / 2, 0.0, 0.0), (0.0, -1.0, 0.0))
    if fittings != "iron":
        return
    for y in (-0.3 * W, 0.3 * W):
        s.slab((-L / 2, L / 2 + 0.01 * L), (y - 0.05 * L, y + 0.05 * L), (0, 1.01 * H), DARK)
    s.slab((L / 2, L / 2 + 0.02 * L), (-0.06 * W, 0.06 * W), (0, 0.6 * H), CHROME)


@builder("trapdoor_flap", "free")
def trapdoor_flap(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Boards that lie level, hung on their rear edge (-X), with a ring to pull."""
    rim = 0.02 * W
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H), c, solid=1)
    for k in range(1, 5):
        y = -W / 2 + k * W / 5
        s.slab((-0.49 * L, 0.49 * L), (y - 0.1 * rim, y + 0.1 * rim), (H, 1.002 * H), shade(c, 0.7))
    s.surface("top", H, (L / 2, W / 2))
    s.mount("hinge", (-L / 2, 0.0, H), (0.0, 1.0, 0.0))


@builder("trap_platform", "free")
def trap_platform(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Platform on four legs with a square hole in its middle, in which a flap hangs."""
    board, leg = 0.05 * H, 0.05 * L
    hole = _TRAP * L / 2, _TRAP * W / 2
    for x in ((-L / 2, -hole[0]), (hole[0], L / 2)):
        s.slab(x, (-W / 2, W / 2), (H - board, H), c, solid=1)
    for y in ((-W / 2, -hole[1]), (hole[1], W / 2)):
        s.slab((-hole[0], hole[0]), y, (H - board, H), c, solid=1)
    for x in (-L / 2, L / 2 - leg):
        for y in (-W / 2, W / 2 - leg):
            s.slab((x, x + leg), (y, y + leg), (0, H - board), shade(c, 0.8), solid=1)
    s.mount("hinge", (-hole[0] + 0.01 * L, 0.0, H), (0.0, 1.0, 0.0))


@builder("book_block", "free")
def book_block(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pages and back cover of a book that lies, its spine behind (-X)."""
    board, rim = 0.1 * H, 0.03 * L
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, board), c, solid=1)
    s.slab((-L / 2, -L / 2 + 0.4 * board), (-W / 2, W / 2), (board, H), c)
    s.slab((-L / 2 + board, L / 2 - rim), (-W / 2 + rim, W / 2 - rim), (board, H), PAGES, solid=1)
    s.surface("top", 1.11 * H, (L / 2, W / 2))
    s.mount("spine", (-L / 2, 0.0, H), (0.0, -1.0, 0.0))


@builder("book_cover", "free")
def book_cover(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Front cover of a book that lies, hung on its spine."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H), c, solid=1)
    s.slab((-0.3 * L, 0.3 * L), (-0.3 * W, 0.3 * W), (H, 1.05 * H), shade(c, 1.25))
    s.mount("spine", (-L / 2, 0.0, 0.0), (0.0, -1.0, 0.0))


@builder("shutter_leaf", "free")
def shutter_leaf(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Louvred leaf of a window shutter, hung on its right edge (-Y)."""
    rim = 0.1 * W
    for y in ((-W / 2, -W / 2 + rim), (W / 2 - rim, W / 2)):
        s.slab((-L / 2, L / 2), y, (0, H), c)
    for z in ((0, rim), (H - rim, H)):
        s.slab((-L / 2, L / 2), (-W / 2 + rim, W / 2 - rim), z, c)
    n = max(4, round((H - 2 * rim) / 6))
    for k in range(n):
        z = rim + (H - 2 * rim) * (k + 0.5) / n
        slat = (0.4 * (H - 2 * rim) / n) / 2
        s.slab((-L / 4, L / 4), (-W / 2 + rim, W / 2 - rim), (z - slat, z + slat), shade(c, 0.9))
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.mount("hinge", (-L / 2, -W / 2, 0.0), (0.0, 0.0, -1.0))


@builder("shutter_wall", "free")
def shutter_wall(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Piece of a wall with a window that a shutter closes, flush with its front (+X)."""
    side, sill, head = 0.2 * W, 0.4 * H, 0.9 * H
    inner = (-W / 2 + side, W / 2 - side)
    for y in ((-W / 2, inner[0]), (inner[1], W / 2)):
        s.slab((-L / 2, L / 2), y, (0, H), c, solid=1)
    s.slab((-L / 2, L / 2), inner, (0, sill), c, solid=1)
    s.slab((-L / 2, L / 2), inner, (head, H), c, solid=1)
    s.mount("hinge", (L / 2, inner[0], sill), (0.0, 0.0, -1.0))
