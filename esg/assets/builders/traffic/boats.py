"""What floats, and its anchor. Bow towards +X."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored, prism, shade, shift
from esg.assets.geometry.sketch import (
    DARK,
    GLASS,
    RED,
    STEEL,
    WHITE,
    WOOD,
    YELLOW,
    Color,
    Sketch,
    rgb,
)
from esg.assets.lazy import shapes


def _hull(
    s: Sketch, half: float, beam: float, depth: float, wall: float, c: Color, blunt: bool = False
) -> None:
    """An open boat hull: full stern at -X, pointed bow at +X."""

    def make() -> object:
        def ring(z: float, f: float, inset: float) -> list[tuple[float, float, float]]:
            b = beam * f - inset
            stern, bow = -half * (0.86 + 0.14 * f) + inset, half * (0.8 + 0.2 * f) - inset * 2
            tail = 0.3 if not blunt else 0.85
            return [
                (stern, -b * tail, z),
                (stern, b * tail, z),
                (-half * 0.35, -b, z),
                (-half * 0.35, b, z),
                (half * 0.3, -b * 0.9, z),
                (half * 0.3, b * 0.9, z),
                (bow, 0, z),
            ]

        outer = ring(0, 0.55, 0) + ring(depth * 0.3, 0.84, 0) + ring(depth, 1.0, 0)
        inner = (
            ring(wall * 1.5, 0.5, wall) + ring(depth * 0.3, 0.84, wall) + ring(depth + 1, 1.0, wall)
        )
        return shapes.cut(shapes.hull(outer), [shapes.hull(inner)])

    s.add(make, c, rough=0.45)


def _hull_proxies(s: Sketch, half: float, beam: float, depth: float, wall: float) -> None:
    s.proxy_slab((-half * 0.9, half * 0.78), (-beam * 0.5, beam * 0.5), (0, wall * 1.5), 2.0)
    side = wall * 2
    for k in (-1, 1):
        s.proxy_slab(
            (-half * 0.8, half * 0.4),
            mirrored(k, beam * 0.9 - side, beam * 0.92),
            (wall * 1.5, depth),
            0.5,
        )
    s.proxy_slab((-half * 0.98, -half * 0.9), (-beam * 0.6, beam * 0.6), (wall * 1.5, depth), 0.5)
    s.proxy_slab((half * 0.72, half * 0.95), (-beam * 0.25, beam * 0.25), (wall * 1.5, depth), 0.5)
    s.region("inside", (-half * 0.88, half * 0.6), (-beam * 0.7, beam * 0.7), (wall * 1.5, depth))
    s.surface("floor", wall * 1.5, (half * 0.55, beam * 0.4), (-half * 0.1, 0))


@builder("boat")
def boat(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "rowboat") -> None:
    """Rowing boat, canoe, sailing dinghy or motorboat; hollow."""
    if kind == "canoe":
        _hull(s, 240, 42, 36, 2, c)
        for x in (-110, 90):
            s.slab((x - 12, x + 12), (-30, 30), (24, 26), WOOD)
        _hull_proxies(s, 240, 42, 36, 2)
        return
    half, beam, depth = {
        "rowboat": (190.0, 72.0, 62.0),
        "sailboat": (220.0, 80.0, 70.0),
        "motorboat": (270.0, 105.0, 105.0),
    }[kind]
    _hull(s, half, beam, depth, 3, c, blunt=kind == "motorboat")
    _hull_proxies(s, half, beam, depth, 3)
    for x in (-0.6, -0.1, 0.35):
        w = beam * (0.76 if x < 0.2 else 0.62)
        s.slab((x * half - 12, x * half + 12), (-w, w), (depth * 0.58, depth * 0.64), WOOD)
    if kind == "rowboat":
        for side in (-1, 1):
            s.pipe(2, [(-40, side * 20, depth + 4), (-20, side * 70, depth + 3)], WOOD)
            prism(
                s,
                [
                    (-20 + dx, side * 70 + dy, depth + 2 + dz)
                    for dx in (-1, 14)
                    for dy in (-5, 5)
                    for dz in (0, 2)
                ],
                WOOD,
            )
    elif kind == "sailboat":
        s.rod(4, (30, 0, 4), (30, 0, 560), STEEL, sections=16)
        s.rod(3, (30, 0, 110), (-190, 0, 105), STEEL, sections=12)
        s.extrude([(24, 116), (24, 548), (-184, 112)], (-1, 1), WHITE, rough=0.9)
        s.extrude([(38, 110), (38, 460), (200, 84)], (-1, 1), WHITE, rough=0.9)
        s.proxy_slab((-6, 66), (-5, 5), (4.5, 110), 0.2)
        s.proxy_slab((-150, 40), (-2, 2), (110, 400), 0.02)
        s.proxy_slab((-30, 34), (-2, 2), (400, 550), 0.02)
    else:
        s.slab(
            (half * 0.1, half * 0.6), (-beam * 0.7, beam * 0.7), (depth * 0.9, depth), shade(c, 0.9)
        )
        s.extrude(
            [(60, depth), (20, depth + 40), (16, depth + 40), (44, depth)],
            (-beam * 0.6, beam * 0.6),
            GLASS,
            rough=0.1,
        )
        s.slab((-half - 26, -half + 2), (-14, 14), (30, 128), DARK)
        s.slab((-half - 14, -half - 6), (-4, 4), (2, 30), DARK)
        s.proxy_slab((-half - 20, -half + 2), (-13, 13), (30, 128), 0.4)
        s.proxy_slab((16, 60), (-beam * 0.6, beam * 0.6), (depth, depth + 40), 0.05)
        shift(s, 13)


@builder("ship")
def ship(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Coastal ship with a bridge and funnel, 20 m."""

    def ring(z: float, f: float) -> list[tuple[float, float, float]]:
        return [
            (-960 * (0.9 + 0.1 * f), -230 * f, z),
            (-960 * (0.9 + 0.1 * f), 230 * f, z),
            (450, -250 * f, z),
            (450, 250 * f, z),
            (820 + 180 * f, 0, z),
            (700, -150 * f, z),
            (700, 150 * f, z),
        ]

    prism(s, ring(0, 0.72) + ring(120, 0.9), rgb(150, 40, 36), rough=0.5)
    prism(s, ring(118, 0.9) + ring(300, 1.0), c, rough=0.4)
    s.slab((-820, -100), (-190, 190), (300, 430), WHITE)
    s.slab((-560, -160), (-170, 170), (430, 560), WHITE)
    s.slab((-164, -156), (-150, 150), (470, 530), GLASS)
    for side in (-1, 1):
        s.slab((-540, -180), mirrored(side, 168, 172), (470, 530), GLASS)
        for k in range(6):
            s.rod(16, (-760 + 110 * k, side * 188, 370), (-760 + 110 * k, side * 192, 370), GLASS)
        s.rod(3, (-900, side * 200, 350), (600, side * 170, 350), STEEL, sections=8)
    s.rod(60, (-440, 0, 560), (-450, 0, 690), RED)
    s.rod(61, (-448, 0, 660), (-450, 0, 692), DARK)
    s.rod(8, (-230, 0, 560), (-230, 0, 700), STEEL)
    s.slab((80, 380), (-120, 120), (300, 340), shade(c, 0.7))
    s.proxy_slab((-960, 620), (-170, 170), (0, 120), 1.0)
    s.proxy_slab((-960, 560), (-240, 240), (120, 300), 0.6)
    s.proxy_slab((560, 900), (-90, 90), (120, 300), 0.6)
    s.proxy_slab((-820, -100), (-190, 190), (300, 560), 0.15)
    s.proxy_cylinder(60, (560, 690), 0.1, (-445, 0))
    s.surface("deck", 300, (240, 150), (200, 0))
    shift(s, -20)


@builder("buoy")
def buoy(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Navigation buoy with a lattice top, 150 cm."""
    s.lathe([(0, 0), (20, 0), (44, 14), (44, 40), (34, 50), (0, 52)], c, smooth=0, rough=0.5)
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        s.rod(
            2,
            (28 * math.cos(a), 28 * math.sin(a), 50),
            (10 * math.cos(a), 10 * math.sin(a), 132),
            c,
            sections=10,
        )
    s.rod(14, (0, 0, 130), (0, 0, 136), c)
    s.rod(5, (0, 0, 136), (0, 0, 150), YELLOW)
    s.rod(18, (0, 0, 92), (0, 0, 96), c)
    s.proxy_cylinder(36, (0, 12), 3.0)
    s.proxy_cylinder(44, (12, 50), 1.0)
    s.proxy_cylinder(18, (50, 136), 0.2)
    s.proxy_cylinder(5, (136, 150), 0.2)


@builder("anchor")
def anchor(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ship's anchor lying flat, crown to +X; 90 cm."""
    s.rod(4, (-38, 0, 4), (40, 0, 4), c, sections=16)
    path = [
        (40 - 30 * (1 - math.cos(math.radians(a))), 36 * math.sin(math.radians(a)), 4)
        for a in range(-85, 86, 17)
    ]
    s.pipe(4, path, c)
    for side in (-1, 1):
        x, y = path[-1][0] if side > 0 else path[0][0], 36 * side
        prism(
            s,
            [
                (x - 14, y, 2),
                (x - 14, y, 6),
                (x + 4, y - 9, 2),
                (x + 4, y + 9, 2),
                (x + 4, y - 9, 6),
                (x + 4, y + 9, 6),
            ],
            c,
        )
    s.rod(3, (-28, -26, 4), (-28, 26, 4), c, sections=14)
    s.torus(6, 1.6, (-43, 0, 4), c)
    s.proxy_slab((-48, 42), (-4, 4), (0, 8), 1.0)
    s.proxy_slab((-31, -25), (-26, 26), (1, 7), 1.0)
    s.proxy_slab((4, 40), (-36, 36), (0.5, 7.5), 0.35)
    shift(s, 3)
