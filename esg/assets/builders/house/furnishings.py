"""What a room is fitted with: fans, mirrors, chandeliers, aquaria, safes, cribs."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import bone, mirrored, prism, shade
from esg.assets.geometry.sketch import BRASS, CHROME, DARK, STEEL, WHITE, Color, Sketch, rgb
from esg.assets.lazy import forms


@builder("fan")
def fan(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pedestal fan blowing towards +X, 118 cm."""
    s.rod(19, (0, 0, 0), (0, 0, 3), c)
    s.rod(1.6, (0, 0, 3), (0, 0, 92), STEEL, sections=16)
    s.rod(5.5, (-11, 0, 96), (3, 0, 96), c)
    for x, r in ((2, 21), (8, 22), (14, 20)):
        s.torus(r, 0.5, (x, 0, 96), CHROME, axis="x")
    for k in range(16):
        a = 2 * math.pi * k / 16
        u = (math.cos(a), math.sin(a))
        s.pipe(
            0.25,
            [
                (14.6, 4 * u[0], 96 + 4 * u[1]),
                (14, 20 * u[0], 96 + 20 * u[1]),
                (2, 21 * u[0], 96 + 21 * u[1]),
            ],
            CHROME,
        )
    for k in range(4):
        a = 90 * k
        ca, sa = math.cos(math.radians(a)), math.sin(math.radians(a))
        pts = [
            (6 + dx, r * ca - w * sa, 96 + r * sa + w * ca)
            for r, ws in ((3, (-2, 2)), (17, (-6, 6)))
            for w in ws
            for dx in ((-1.2, -0.8) if w < 0 else (0.8, 1.2))
        ]
        prism(s, pts, rgb(90, 150, 190))
    s.rod(4, (12, 0, 96), (15, 0, 96), c)
    s.proxy_cylinder(19, (0, 3), 5.0)
    s.proxy_cylinder(2.2, (3, 74), 1.0)
    s.proxy_slab((-11, 15), (-20, 20), (76, 117), 0.2)


@builder("mirror")
def mirror(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Oval mirror standing on two feet, facing +X."""
    for side in (-1, 1):
        s.slab((-22, 22), (side * 27 - 2, side * 27 + 2), (0, 4), c)
        s.slab((-2, 2), (side * 27 - 2, side * 27 + 2), (4, 110), c)
    s.extrude(
        [
            (
                26 * math.cos(math.pi * k / 12),
                88 + 72 * math.sin(math.pi * k / 12),
            )
            for k in range(24)
        ],
        (-1.6, 1.6),
        c,
        plane="yz",
    )
    s.extrude(
        [
            (23 * math.cos(math.pi * k / 12), 88 + 68 * math.sin(math.pi * k / 12))
            for k in range(24)
        ],
        (1.5, 2.0),
        rgb(176, 204, 214),
        plane="yz",
        rough=0.03,
    )
    for side in (-1, 1):
        s.proxy_slab((-22, 22), (side * 27 - 2, side * 27 + 2), (0, 4), 2.0)
        s.proxy_slab((-2, 2), (side * 27 - 2, side * 27 + 2), (4, 110), 0.6)
    s.proxy_slab((-1.6, 2), (-22, 22), (18, 158), 0.8)


@builder("chandelier")
def chandelier(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "chandelier") -> None:
    """Chandelier resting on its lowest knob ring, 60 cm; or a hand lantern."""
    if kind == "lantern":
        s.rod(8, (0, 0, 0), (0, 0, 4), c)
        s.rod(6.6, (0, 0, 4), (0, 0, 19), (0.98, 0.9, 0.62), rough=0.1, alpha=0.6)
        s.rod(1.2, (0, 0, 4), (0, 0, 12), WHITE)
        for k in range(4):
            a = math.pi / 4 + math.pi * k / 2
            s.rod(
                0.5,
                (7 * math.cos(a), 7 * math.sin(a), 4),
                (7 * math.cos(a), 7 * math.sin(a), 19),
                c,
                sections=8,
            )
        s.lathe([(0, 19), (8.4, 19), (5, 24), (0, 25)], c)
        s.pipe(0.5, [(0, -7, 21), (0, -8, 28), (0, 0, 33), (0, 8, 28), (0, 7, 21)], c)
        s.proxy_cylinder(8, (0, 24), 1.0)
        s.proxy_slab((-0.6, 0.6), (-8, 8), (24, 33), 0.1)
        return
    s.lathe(
        [(0, 0), (9, 0), (12, 4), (4, 10), (3, 30), (6, 36), (2, 42), (2, 56), (0, 58)],
        c,
        smooth=40,
        rough=0.3,
    )
    for k in range(8):
        a = math.pi * k / 4
        u = (math.cos(a), math.sin(a))
        s.pipe(
            0.9,
            [(4 * u[0], 4 * u[1], 16), (16 * u[0], 16 * u[1], 9), (27 * u[0], 27 * u[1], 18)],
            c,
        )
        s.rod(3, (27 * u[0], 27 * u[1], 18), (27 * u[0], 27 * u[1], 19.5), c, sections=18)
        s.rod(1.1, (27 * u[0], 27 * u[1], 19.5), (27 * u[0], 27 * u[1], 27), WHITE, sections=14)
        s.ball(1, (27 * u[0], 27 * u[1], 29), (0.98, 0.86, 0.5), scale=(0.9, 0.9, 2), detail=2)
    s.proxy_cylinder(11, (0, 10), 2.0)
    s.proxy_cylinder(29, (10, 28), 0.4)
    s.proxy_cylinder(5, (28, 57), 0.5)


@builder("aquarium")
def aquarium(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Filled aquarium with gravel, plants and fish, 40 x 80 x 46."""
    s.slab((-20, 20), (-40, 40), (0, 2), DARK)
    s.slab((-19.6, 19.6), (-39.6, 39.6), (2, 42), rgb(120, 190, 220), rough=0.02, alpha=0.35)
    s.slab((-19, 19), (-39, 39), (2, 7), rgb(196, 172, 126))
    s.slab((-20, 20), (-40, 40), (42, 46), DARK)
    for y, x, h in ((-28, 4, 26), (-22, -8, 32), (24, 0, 28), (30, 8, 18)):
        for k in range(3):
            bone(
                s,
                (x, y + k * 1.6, 6),
                0.9,
                (x + 3 * math.sin(k), y + k * 2.4, h),
                0.4,
                rgb(46, 130, 60),
            )
    for x, y, z in ((6, -8, 24), (-4, 10, 30), (8, 14, 17)):
        s.ball(1, (x, y, z), rgb(236, 120, 40), scale=(1.2, 3.4, 1.8))
        prism(
            s,
            [
                (x, y - 3, z),
                (x + 0.3, y - 3, z),
                (x, y - 5.4, z + 1.8),
                (x, y - 5.4, z - 1.8),
                (x + 0.3, y - 5.4, z + 1.8),
                (x + 0.3, y - 5.4, z - 1.8),
            ],
            rgb(236, 120, 40),
        )
    s.proxy_slab((-20, 20), (-40, 40), (0, 46))
    s.surface("lid", 46, (18, 38))


@builder("crib")
def crib(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Baby's crib, 70 x 130 x 95; open above."""
    for x in (-33, 33):
        for y in (-63, 63):
            s.slab((x - 2.4, x + 2.4), (y - 2.4, y + 2.4), (0, 95), c)
    for z in (28, 88):
        for side in (-1, 1):
            s.slab((-33, 33), mirrored(side, 61.6, 64.4), (z, z + 5), c)
            s.slab(mirrored(side, 31.6, 34.4), (-63, 63), (z, z + 5), c)
    for side in (-1, 1):
        for k in range(12):
            s.rod(0.9, (side * 33, -55 + 10 * k, 32), (side * 33, -55 + 10 * k, 89), c, sections=10)
        for k in range(6):
            s.rod(0.9, (-25 + 10 * k, side * 63, 32), (-25 + 10 * k, side * 63, 89), c, sections=10)
    s.slab((-31, 31), (-61, 61), (33, 43), WHITE)
    s.walls((-35, 35), (-65, 65), (28, 93), 3)
    for x in (-33, 33):
        for y in (-63, 63):
            s.proxy_slab((x - 2, x + 2), (y - 2, y + 2), (0, 28), 2.0)
    s.proxy_slab((-31, 31), (-61, 61), (31, 43), 0.4)
    s.surface("mattress", 43, (29, 58))
    s.region("inside", (-31, 31), (-61, 61), (43, 93))


@builder("floor_lamp")
def floor_lamp(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Standard lamp, drawn at 40 x 40 x 155."""
    foot = [(14.2, 0), (15, 0.5), (15, 1.6), (13.4, 2.4), (3.4, 3.6), (1.9, 4.6), (1.3, 6)]
    s.add(lambda: forms.turned(foot, sections=44), DARK, of="cast_iron", name="foot")
    s.add(
        lambda: forms.turned(
            [(1.2, 5), (1.2, 66), (1.9, 66.6), (1.9, 68.4), (1.1, 69), (1.1, 126)], sections=20
        ),
        BRASS,
        name="pole",
    )
    s.add(
        lambda: forms.turned([(2.0, 124), (2.3, 125), (2.3, 130), (1.7, 131)], sections=20),
        DARK,
        of="plastic_hard",
        name="socket",
    )
    shade_ = [
        (19.7, 122),
        (20, 122.3),
        (12, 154.8),
        (11.8, 155),
        (11.6, 154.7),
        (19.4, 122.3),
        (19.7, 122),
    ]
    s.add(lambda: forms.turned(shade_, sections=56), c, of="linen", name="shade")
    for k, (r, z) in enumerate(((20.1, 122.6), (12.1, 154.4))):
        s.add(
            lambda r=r, z=z: forms.turned(
                [
                    (r - 0.7, z - 0.7),
                    (r + 0.1, z - 0.7),
                    (r, z + 0.7),
                    (r - 0.8, z + 0.7),
                    (r - 0.7, z - 0.7),
                ],
                sections=56,
            ),
            shade(c, 0.7),
            of="textile",
            name=f"trim_{k + 1}",
        )
    s.add(
        lambda: forms.turned(
            [(1.4, 130.6), (1.8, 132), (3.2, 135), (3.3, 137), (2.6, 139.4), (1.2, 140.4)],
            sections=24,
        ),
        (1.0, 0.95, 0.8),
        of="lamp",
        name="bulb",
    )
    s.add(
        lambda: forms.gather(
            [
                forms.tube(
                    [(0, 0, 152.5), (11.9 * math.cos(a), 11.9 * math.sin(a), 152.5)], 0.22, 6
                )
                for a in (0.3, 2.4, 4.5)
            ]
            + [forms.tube([(0, 0, 130), (0, 0, 153)], 0.3, 8)]
        ),
        BRASS,
        name="harp",
    )
    s.add(
        lambda: forms.gather(
            [
                forms.tube([(3, 0, 129), (5, 0, 128), (5.2, 0, 114)], 0.12, 6),
                forms.turned([(0.3, 112.4), (0.7, 113), (0.5, 114.2)], (5.2, 0, 0), 12),
            ]
        ),
        BRASS,
        name="pull_chain",
    )
    s.proxy_cylinder(15, (0, 4), 16.0)
    s.proxy_cylinder(1.5, (4, 122), 2.0)
    s.proxy_cylinder(18, (122, 155), 0.05)
