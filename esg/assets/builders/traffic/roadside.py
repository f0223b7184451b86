"""What stands and lies along roads: bus stops, signs, bumps, parking."""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored, shift
from esg.assets.geometry.sketch import CONCRETE, STEEL, WHITE, WOOD, YELLOW, Color, Sketch


@builder("bus_stop")
def bus_stop(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bus shelter open towards +X, 150 x 320 x 250; with bench and sign."""
    s.slab((-70, 70), (-155, 155), (238, 246), c)
    for y in (-150, 0, 150):
        s.slab((-68, -60), (y - 4, y + 4), (0, 238), c)
    s.slab((-66, -64), (-146, 146), (18, 226), (0.7, 0.82, 0.86), rough=0.05, alpha=0.4)
    for side in (-1, 1):
        s.slab(
            (-60, 30), mirrored(side, 149, 151), (18, 226), (0.7, 0.82, 0.86), rough=0.05, alpha=0.4
        )
        s.slab((26, 34), mirrored(side, 147, 153), (0, 238), c)
    s.slab((-56, -22), (-100, 60), (42, 47), WOOD)
    for y in (-90, 50):
        s.slab((-50, -28), (y - 3, y + 3), (0, 42), STEEL)
    s.rod(3, (62, 168, 0), (62, 168, 236), STEEL)
    s.slab((60, 64), (152, 184), (206, 250), YELLOW)
    s.proxy_slab((-68, -60), (-154, 154), (0, 238), 1.0)
    for side in (-1, 1):
        s.proxy_slab((-60, 34), mirrored(side, 147, 153), (0, 238), 0.6)
    s.proxy_slab((-70, 70), (-155, 155), (238, 246), 0.6)
    s.proxy_slab((-56, -22), (-100, 60), (0, 47), 0.3)
    s.proxy_slab((58, 66), (164, 172), (0, 206), 1.0)
    s.surface("bench", 47, (15, 74), (-39, -20))
    shift(s, 0, -14)


@builder("road_sign")
def road_sign(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "sign") -> None:
    """Direction sign or billboard facing +X."""
    if kind == "billboard":
        s.slab((-4, 8), (-180, 180), (180, 380), WHITE)
        s.slab((8, 9), (-172, 172), (188, 372), c)
        s.slab((9, 9.6), (-120, 40), (300, 340), WHITE)
        s.slab((9, 9.6), (-120, 110), (230, 262), YELLOW)
        for y in (-120, 120):
            s.slab((-14, -4), (y - 8, y + 8), (0, 360), STEEL)
            s.slab((-50, 20), (y - 20, y + 20), (0, 10), CONCRETE)
            s.proxy_slab((-50, 20), (y - 20, y + 20), (0, 10), 4.0)
            s.proxy_slab((-14, -4), (y - 8, y + 8), (10, 180), 1.0)
        s.proxy_slab((-14, 8), (-180, 180), (180, 380), 0.3)
        shift(s, 15)
        return
    s.rod(18, (0, 0, 0), (0, 0, 10), CONCRETE)
    s.rod(3, (0, 0, 8), (0, 0, 236), STEEL, metal=0.6)
    s.extrude([(-46, 186), (40, 186), (58, 203), (40, 220), (-46, 220)], (3, 5), c, plane="yz")
    s.extrude(
        [(-41, 190), (38, 190), (52, 203), (38, 216), (-41, 216)], (5, 5.4), WHITE, plane="yz"
    )
    s.slab((5.4, 5.8), (-34, 30), (199, 207), c)
    s.proxy_cylinder(18, (0, 10), 14.0)
    s.proxy_cylinder(3.4, (10, 236), 1.0)
    s.proxy_slab((3, 6), (-46, 50), (186, 220), 0.5)
    shift(s, 0, -5)


@builder("parking")
def parking(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Car park with painted bays of 250 x 500; a decal."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.7), c, rough=1.0)
    n = max(1, int(L / 250))
    depth = min(500.0, W * 0.4)
    for k in range(n + 1):
        x = -L / 2 + 5 + (L - 10) * k / n
        for side in (-1, 1):
            s.slab((x - 5, x + 5), mirrored(side, W / 2 - depth, W / 2), (0, H), WHITE)
    s.surface("surface", 0.0, (L / 2, W / 2))
