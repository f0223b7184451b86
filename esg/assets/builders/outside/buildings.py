"""Buildings that are told by their outline: church, barn, stone tower. Doors face +X."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored, prism, shade, shift
from esg.assets.geometry.rotations import turn
from esg.assets.geometry.sketch import (
    BRASS,
    DARK,
    DARK_WOOD,
    GLASS,
    WHITE,
    Color,
    Sketch,
    finish,
    rgb,
)
from esg.assets.lazy import forms, shapes

SLATE = finish("roof_tiles", rgb(72, 76, 86))
Outline = list[tuple[float, float]]


def _pointed(at: float, low: float, half: float, straight: float) -> Outline:
    """Outline of a window or door with a pointed arch about `at`."""
    top = low + straight
    return [
        (at - half, low),
        (at + half, low),
        (at + half, top),
        (at + 0.62 * half, top + 0.85 * half),
        (at, top + 1.5 * half),
        (at - 0.62 * half, top + 0.85 * half),
        (at - half, top),
    ]


@builder("church")
def church(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Village church: nave with pointed windows, tower with clock, belfry and spire."""
    s.slab((-770, 250), (-345, 345), (0, 560), c, name="nave")
    s.slab((-780, 706), (-356, 356), (0, 30), shade(c, 0.7), of="stone", name="plinth")
    roof = [(-385, 545), (385, 545), (0, 960)]
    s.extrude(roof, (-795, 250), SLATE, plane="yz", name="nave_roof")
    gable = [(-340, 556), (340, 556), (0, 925)]
    s.extrude(gable, (-799, -790), c, plane="yz", name="gable")
    s.slab((240, 700), (-230, 230), (0, 1180), c, name="tower")
    s.slab((228, 712), (-242, 242), (1160, 1200), shade(c, 0.85), of="stone", name="cornice")
    prism(
        s,
        [(x, y, 1200) for x in (228, 712) for y in (-242, 242)] + [(470, 0, 1900)],
        SLATE,
        name="spire",
    )
    s.slab((464, 476), (-6, 6), (1880, 2060), BRASS, name="cross")
    s.slab((464, 476), (-46, 46), (1980, 1994), BRASS, name="cross_bar")
    _church_openings(s, c)
    s.proxy_slab((-770, 250), (-350, 350), (0, 560), 1.0)
    s.proxy_hull([(x, y, z) for y, z in roof for x in (-795, 250)], 0.3)
    s.proxy_slab((240, 706), (-240, 240), (0, 1200), 1.0)
    s.proxy_hull([(x, y, 1200) for x in (228, 712) for y in (-242, 242)] + [(470, 0, 1980)], 0.2)
    shift(s, 43)


def _church_openings(s: Sketch, c: Color) -> None:
    s.extrude(_pointed(0, 0, 105, 210), (696, 706), shade(c, 0.6), plane="yz", name="door_frame")
    s.extrude(_pointed(0, 0, 84, 205), (700, 709), DARK_WOOD, plane="yz", name="door")
    s.slab((708, 710), (-2, 2), (0, 320), DARK, name="door_gap")
    s.rod(95, (696, 0, 760), (708, 0, 760), WHITE, sections=40, name="clock")
    s.torus(95, 8, (704, 0, 760), DARK, axis="x", name="clock_rim")
    s.slab((706, 711), (-5, 5), (755, 832), DARK, name="clock_hand")
    s.slab((706, 711), (-3, 54), (755, 765), DARK, name="clock_hand_short")
    s.extrude(_pointed(0, 440, 42, 130), (697, 704), GLASS, plane="yz", name="tower_window")
    for y in (-90, 90):
        belfry = _pointed(y, 930, 52, 120)
        s.extrude(belfry, (696, 705), DARK, plane="yz", name="belfry")
    for side in (-1, 1):
        for x in (380, 560):
            belfry = _pointed(x, 930, 52, 120)
            s.extrude(belfry, mirrored(side, 226, 235), DARK, name="belfry_side")
        for k in range(4):
            x = -640 + 250 * k
            frame, pane = _pointed(x, 150, 62, 210), _pointed(x, 160, 48, 200)
            s.extrude(frame, mirrored(side, 340, 352), shade(c, 0.65), name="window_frame")
            s.extrude(pane, mirrored(side, 344, 356), GLASS, name="window")
            at = x + 125
            buttress = [(345, 0), (410, 0), (410, 240), (345, 420)]
            if k < 3:
                s.extrude(
                    [(side * y, z) for y, z in buttress],
                    (at - 24, at + 24),
                    shade(c, 0.9),
                    plane="yz",
                    name="buttress",
                )


@builder("barn")
def barn(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wooden barn with a gambrel roof and a double door with crosses."""
    body = [(-470, 0), (470, 0), (470, 440), (335, 690), (0, 840), (-335, 690), (-470, 440)]
    s.extrude(body, (-640, 620), c, plane="yz", of="planks", name="walls")
    outer = [(520, 400), (372, 700), (0, 868), (-372, 700), (-520, 400)]
    inner = [(-492, 400), (-350, 684), (0, 838), (350, 684), (492, 400)]
    s.extrude(
        [*outer, *inner], (-670, 660), rgb(96, 100, 108), plane="yz", of="sheet_metal", name="roof"
    )
    for x in ((620, 626), (654, 663)):
        s.extrude(
            [(y, z - 1) for y, z in outer] + [(0.93 * y, z - 34) for y, z in outer[::-1]],
            x,
            WHITE,
            plane="yz",
            name="verge",
        )
    _barn_front(s, c)
    for side in (-1, 1):
        for x in (-430, -10, 400):
            s.slab((x - 62, x + 62), mirrored(side, 466, 476), (180, 320), WHITE, name="frame")
            s.slab((x - 52, x + 52), mirrored(side, 468, 478), (190, 310), GLASS, name="window")
            s.slab((x - 4, x + 4), mirrored(side, 470, 480), (190, 310), WHITE, name="bar")
    s.proxy_slab((-640, 620), (-475, 475), (0, 440), 1.0)
    s.proxy_hull([(x, y, z) for x in (-670, 660) for y, z in outer], 0.4)
    shift(s, 4)


def _barn_front(s: Sketch, c: Color) -> None:
    dark = shade(c, 0.72)
    for side in (-1, 1):
        low, high = mirrored(side, 4, 180)
        s.slab((620, 630), (low, high), (0, 350), dark, of="planks", name="door_leaf")
        for y in (mirrored(side, 4, 24), mirrored(side, 160, 180)):
            s.slab((629, 636), y, (0, 350), WHITE, name="door_stile")
        for z in ((0, 20), (165, 185), (330, 350)):
            s.slab((629, 636), (low, high), z, WHITE, name="door_rail")
        for start, end in (((14, 12), (170, 172)), ((14, 338), (170, 178))):
            (y0, z0), (y1, z1) = start, end
            dy, dz = y1 - y0, z1 - z0
            n = 9 / math.hypot(dy, dz)
            bar = [
                (y0 - dz * n, z0 + dy * n),
                (y0 + dz * n, z0 - dy * n),
                (y1 + dz * n, z1 - dy * n),
                (y1 - dz * n, z1 + dy * n),
            ]
            s.extrude([(side * y, z) for y, z in bar], (629, 635), WHITE, plane="yz", name="brace")
        s.slab((618, 627), mirrored(side, 452, 474), (0, 440), WHITE, name="corner")
    s.slab((620, 640), (-210, 210), (352, 374), WHITE, name="lintel")
    s.slab((620, 628), (-78, 78), (520, 690), WHITE, name="loft_frame")
    s.slab((624, 631), (-64, 64), (534, 676), dark, of="planks", name="loft_door")
    for sign in (-1, 1):
        bar = [
            (-64, sign * 62 - 7),
            (-64, sign * 62 + 7),
            (64, 7 - sign * 62),
            (64, -sign * 62 - 7),
        ]
        s.extrude([(y, 605 + z) for y, z in bar], (630, 634), WHITE, plane="yz", name="loft_brace")


@builder("tower")
def tower(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round stone tower with battlements, drawn at 60 x 60 x 200."""
    shaft = [(0, 0), (27, 0), (27, 6), (24.5, 9), (23, 152), (29.6, 164), (29.6, 184), (0, 184)]
    s.lathe(shaft, c, of="stone", name="shaft")

    def courses() -> Any:
        import numpy as np

        rng = np.random.default_rng(5)
        blocks = []
        for row in range(11):
            z = 14 + 13 * row
            r = 24.5 - 1.5 * row / 11
            for k in range(9):
                if rng.uniform() < 0.45:
                    a = 40 * k + (20 if row % 2 else 0) + rng.uniform(-3, 3)
                    at = (r * math.cos(math.radians(a)), r * math.sin(math.radians(a)), z)
                    blocks.append(shapes.box((1.6, rng.uniform(8, 13), 8), at, turn("z", a)))
        return forms.gather(blocks)

    s.add(courses, shade(c, 0.78), of="stone", name="stones")
    for k in range(9):
        a = 360 * k / 9
        at = (26.4 * math.cos(math.radians(a)), 26.4 * math.sin(math.radians(a)), 192)
        s.box((6.4, 11, 16), at, c, of="stone", quat=turn("z", a), name="merlon")
    s.rod(22, (0, 0, 184), (0, 0, 184.6), DARK, name="platform")
    s.extrude(_pointed(0, 0, 9, 22), (20, 26.6), shade(c, 0.6), plane="yz", name="door_frame")
    s.extrude(_pointed(0, 0, 7, 21), (20, 27.6), DARK_WOOD, plane="yz", name="door")
    for a, z in ((0, 78), (0, 128), (90, 60), (90, 108), (180, 84), (270, 64), (270, 112)):
        r = 23.6 - 0.6 * z / 100
        at = (r * math.cos(math.radians(a)), r * math.sin(math.radians(a)), z)
        s.box((2, 3.6, 15), at, DARK, quat=turn("z", a), name="slit")
    s.proxy_cylinder(25, (0, 160), 1.0)
    s.proxy_cylinder(29.6, (160, 200), 0.7)
    s.surface("top", 200, (20, 20))
