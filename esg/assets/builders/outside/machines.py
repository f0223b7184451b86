"""Machines, artillery and what it fires."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import LEAF, mirrored, prism, shade, shift
from esg.assets.geometry.sketch import (
    CONCRETE,
    DARK,
    DARK_WOOD,
    GLASS,
    PALE_WOOD,
    RED,
    WOOD,
    YELLOW,
    Color,
    Sketch,
    rgb,
)
from esg.assets.lazy import shapes


@builder("artillery")
def artillery(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "cannon") -> None:
    """Old cannon on wheels, or a catapult."""

    def wheel(x: float, y: float, r: float) -> None:
        s.torus(r - 4, 4, (x, y, r), DARK_WOOD, axis="y")
        s.rod(8, (x, y - 6, r), (x, y + 6, r), DARK, sections=18)
        for k in range(6):
            a = math.pi * k / 6
            s.rod(
                2.2,
                (x - (r - 4) * math.cos(a), y, r - (r - 4) * math.sin(a)),
                (x + (r - 4) * math.cos(a), y, r + (r - 4) * math.sin(a)),
                WOOD,
                sections=8,
            )
        s.wheel((x, y, r), r, parts=8)

    if kind == "cannon":
        for side in (-1, 1):
            wheel(10, side * 46, 48)
            s.extrude(
                [(-104, 0), (-88, 0), (30, 50), (30, 72), (-6, 72)], mirrored(side, 20, 27), WOOD
            )
        s.rod(4, (10, -46, 48), (10, 46, 48), DARK)

        def barrel() -> object:
            return shapes.lathe(
                [
                    (0, -60),
                    (15, -58),
                    (18, -40),
                    (13, 70),
                    (17, 80),
                    (17, 90),
                    (8, 90),
                    (8, 30),
                    (0, 30),
                ],
                (0, 0, 0),
                0,
                36,
                "x",
            )

        def aimed() -> Any:
            from trimesh.transformations import rotation_matrix

            mesh: Any = barrel()
            mesh.apply_transform(rotation_matrix(math.radians(-8), [0, 1, 0]))
            mesh.apply_translation([14, 0, 76])
            return mesh

        s.add(aimed, c)
        s.ball(6, (-48, 0, 67), c)
        s.proxy_slab((-38, 58), (-50, 50), (0, 60), 0.3)
        s.proxy_slab((-104, -38), (-27, 27), (0, 40), 0.4)
        s.proxy_slab((-46, 104), (-16, 16), (60, 94), 2.0)
        return
    for side in (-1, 1):
        s.slab((-110, 100), mirrored(side, 44, 56), (20, 36), WOOD)
        for x in (-80, 76):
            wheel(x, side * 66, 26)
        s.rod(6, (-20, side * 50, 36), (20, side * 44, 124), WOOD, sections=12)
        s.rod(6, (60, side * 50, 36), (20, side * 44, 124), WOOD, sections=12)
    for x in (-100, 0, 92):
        s.slab((x - 6, x + 6), (-56, 56), (22, 34), DARK_WOOD)
    s.rod(7, (20, -52, 124), (20, 52, 124), DARK_WOOD)
    s.rod(5, (36, 0, 40), (-112, 0, 104), WOOD, sections=14)
    s.lathe(
        [(0, -4), (14, 0), (19, 10), (17, 10), (12, 2), (0, 0)], DARK_WOOD, center=(-118, 0, 106)
    )
    s.proxy_slab((-110, 102), (-72, 72), (0, 36), 1.0)
    for side in (-1, 1):
        s.proxy_slab((-6, 46), mirrored(side, 42, 54), (36, 130), 0.3)
    s.proxy_slab((-134, -100), (-18, 18), (98, 108), 0.1)
    shift(s, 16)


@builder("tower_crane")
def tower_crane(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Tower crane with its jib along +X."""
    for x in (-50, 50):
        for y in (-50, 50):
            s.slab((x - 6, x + 6), (y - 6, y + 6), (40, 1000), c)
    s.slab((-150, 150), (-150, 150), (0, 40), CONCRETE)
    for k in range(12):
        z0, z1 = 40 + 80 * k, 120 + 80 * k
        for a, b in (
            ((-50, -50), (50, -50)),
            ((50, -50), (50, 50)),
            ((50, 50), (-50, 50)),
            ((-50, 50), (-50, -50)),
        ):
            s.rod(3, (*a, z0), (*b, z1), c, sections=6)
    s.slab((-60, 60), (-60, 60), (1000, 1020), DARK)
    s.slab((10, 90), (-45, 45), (920, 1000), GLASS)
    s.slab((-380, 900), (-24, 24), (1020, 1034), c)
    s.slab((-380, 900), (-5, 5), (1080, 1090), c)
    for k in range(16):
        x = -380 + 80 * k
        s.rod(3, (x, -20, 1030), (x + 40, 0, 1084), c, sections=6)
        s.rod(3, (x + 40, 0, 1084), (x + 80, 20, 1030), c, sections=6)
    prism(s, [(x, y, 1020) for x in (-40, 40) for y in (-24, 24)] + [(0, 0, 1200)], c)
    s.rod(3, (0, 0, 1195), (700, 0, 1088), DARK, sections=8)
    s.rod(3, (0, 0, 1195), (-340, 0, 1040), DARK, sections=8)
    s.slab((-380, -280), (-40, 40), (960, 1020), CONCRETE)
    s.rod(1.5, (600, 0, 1020), (600, 0, 640), DARK, sections=8)
    s.slab((585, 615), (-15, 15), (600, 640), RED)
    s.proxy_slab((-150, 150), (-150, 150), (0, 40), 20)
    s.proxy_slab((-56, 56), (-56, 56), (40, 1020), 0.3)
    s.proxy_slab((-380, 900), (-24, 24), (1020, 1090), 0.05)
    s.proxy_slab((-380, -280), (-40, 40), (960, 1020), 2.5)
    shift(s, -260)


@builder("vending_machine")
def vending_machine(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Vending machine facing +X."""
    s.slab((-38, 36), (-46, 46), (0, 183), c, rough=0.4)
    s.slab((36, 38), (-42, 20), (50, 176), GLASS, rough=0.05)
    for k in range(4):
        for j in range(4):
            s.rod(
                5,
                (37, -34 + 15 * j, 66 + 28 * k),
                (39.4, -34 + 15 * j, 66 + 28 * k),
                (RED, YELLOW, rgb(60, 130, 200), LEAF)[(k + j) % 4],
                sections=18,
            )
    s.slab((36, 38.4), (24, 42), (90, 150), DARK)
    s.slab((36, 38.4), (-36, 14), (14, 34), DARK)
    s.proxy_slab((-38, 38), (-46, 46), (0, 183))


@builder("small_round")
def small_round(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "bomb") -> None:
    """Cartoon bomb with a fuse, bullet, seashell."""
    if kind == "bomb":
        s.ball(9, (0, 0, 9), c, rough=0.3)
        s.rod(2.6, (0, 0, 17), (0, 0, 20), DARK)
        s.pipe(0.5, [(0, 0, 20), (1.5, 0, 23), (4, 0, 24.6)], PALE_WOOD)
        s.ball(1.0, (4.4, 0, 24.8), YELLOW, detail=2)
        s.proxy_cylinder(4.5, (0, 2), 1.0)
        s.proxy_cylinder(8.6, (2, 16), 1.0)
        s.proxy_cylinder(2.6, (16, 20), 0.3)
    elif kind == "bullet":
        s.lathe(
            [(0, -1.4), (0.5, -1.4), (0.5, 0.3), (0, 0.3)],
            c,
            center=(0, 0, 0.5),
            axis="x",
        )
        s.lathe(
            [(0, 0.3), (0.46, 0.3), (0.3, 1.1), (0, 1.5)],
            rgb(180, 110, 70),
            center=(0, 0, 0.5),
            axis="x",
            smooth=20,
        )
        s.proxy_slab((-1.4, 1.2), (-0.36, 0.36), (0, 0.94))
    else:
        for k in range(7):
            a = math.radians(-54 + 18 * k)
            s.ball(
                1,
                (3.4 * math.cos(a), 3.4 * math.sin(a), 1.6),
                shade(c, 0.9 + 0.1 * (k % 2)),
                scale=(2.6, 1.1, 1.6),
                detail=2,
            )
        s.ball(1, (0.4, 0, 1.3), c, scale=(1.8, 2.2, 1.3), detail=2)
        s.proxy_slab((-0.8, 5.4), (-3.4, 3.4), (0, 2.8))
        shift(s, -2.4)
