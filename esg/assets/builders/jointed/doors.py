"""Doors, gates and drawers: what opens, and what it opens in.

A leaf hangs on its right edge (-Y) and opens backwards (-X), away from who comes from the front.
"""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.sketch import CHROME, DARK, STEEL, Color, Sketch

_JAMB = 6.0
"""Width of a door frame's jambs and lintel [cm]."""
_GAP = 0.5
"""Air between a leaf and what it hangs in [cm]."""
_SILL = 0.8
"""Air below a door's leaf [cm]."""
_POST = 10.0
_LIFT = 8.0
"""Air below a gate's leaf [cm]."""


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
        s.rod(0.018 * W, (x * t, at, z), (x * 0.47 * L, at, z), CHROME, metal=0.8)
        lever = ((x * 0.46 * L, at + 1, z), (x * 0.46 * L, at - W * 0.14, z))
        s.rod(0.04 * L, *lever, CHROME, metal=0.8, sections=12)
    s.mount("hinge", (-t, -W / 2, 0.0))


@builder("door_frame", "free")
def door_frame(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two jambs and a lintel; the leaf closes flush with their back."""
    for y in ((-W / 2, -W / 2 + _JAMB), (W / 2 - _JAMB, W / 2)):
        s.slab((-L / 2, L / 2), y, (0, H), c, solid=1)
    s.slab((-L / 2, L / 2), (-W / 2 + _JAMB, W / 2 - _JAMB), (H - _JAMB, H), c, solid=1)
    inner = (-W / 2 + _JAMB, W / 2 - _JAMB)
    s.region("inside", (-L / 2, L / 2), inner, (0, H - _JAMB), "area")
    s.mount("hinge", (-L / 2, -W / 2 + _JAMB + _GAP, _SILL))


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
    post = min(L, _POST)
    for y in ((-W / 2, -W / 2 + post), (W / 2 - post, W / 2)):
        s.slab((-post / 2, post / 2), y, (0, H - 3), c, solid=1)
        s.slab((-L / 2, L / 2), y, (H - 3, H), shade(c, 0.8))
    for z in (0.2, 0.8):
        y = -W / 2 + post
        s.rod(1.2, (0, y, H * z), (0, y + 4 * _GAP, H * z), STEEL, metal=0.6, sections=12)
    inner = (-W / 2 + post, W / 2 - post)
    s.region("inside", (-L / 2, L / 2), inner, (0, H), "area")
    s.mount("hinge", (0.0, -W / 2 + post + 4 * _GAP, _LIFT))


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
    s.rod(t, (front[1], 0, H / 2), (L / 2, 0, H / 2), CHROME, metal=0.8)
    s.region("inside", (back + t, front[0]), (-side + t, side - t), (2 * t, 0.8 * H))
    s.mount("runner", (front[1], 0.0, 0.0), (1.0, 0.0, 0.0))


@builder("drawer_chest", "free")
def drawer_chest(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Chest with a bay for one drawer below its top, and a closed front under it."""
    t = 0.045 * W
    bay = (0.62 * H, 0.95 * H)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (bay[1], H), c, solid=1)
    s.slab((-L / 2, L / 2 - t), (-W / 2 + t, W / 2 - t), (0, bay[0] - t), shade(c, 0.9), solid=0.4)
    s.slab((-L / 2, L / 2 - t), (-W / 2 + t, W / 2 - t), (bay[0] - t, bay[0]), DARK, solid=1)
    for y in ((-W / 2, -W / 2 + t), (W / 2 - t, W / 2)):
        s.slab((-L / 2, L / 2), y, (0, bay[1]), c, solid=1)
    s.slab((-L / 2, -L / 2 + t), (-W / 2 + t, W / 2 - t), bay, c, solid=1)
    s.slab((L / 2 - t, L / 2), (-W / 2 + t, W / 2 - t), (0.06 * H, bay[0] - t), shade(c, 1.06))
    s.surface("top", H, (L / 2, W / 2))
    s.mount("runner", (L / 2, 0.0, bay[0] + 0.3), (1.0, 0.0, 0.0))
