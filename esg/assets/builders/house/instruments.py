"""Musical instruments and the microphone."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import shade, shift
from esg.assets.geometry.sketch import BRASS, CHROME, DARK, PALE_WOOD, STEEL, WHITE, Color, Sketch


@builder("guitar")
def guitar(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "guitar") -> None:
    """Guitar or violin lying on its back, head to +X."""
    k = 1.0 if kind == "guitar" else 0.58
    z1 = 10.0 if kind == "guitar" else 4.6
    outline = [
        (-50, 0),
        (-47, 12),
        (-38, 18.6),
        (-27, 19),
        (-17, 13.4),
        (-10, 12),
        (-2, 14),
        (4, 12.4),
        (7, 6),
        (7, 0),
    ]
    plan = [(x * k, y * k) for x, y in outline] + [(x * k, -y * k) for x, y in outline[-2:0:-1]]
    s.extrude(plan, (0, z1), shade(c, 0.7), plane="xy", soft=1.5 * k)
    s.extrude(
        [(x * 0.985 - 0.4 * k, y * 0.985) for x, y in plan],
        (z1, z1 + 0.3),
        c,
        plane="xy",
        soft=1.5 * k,
    )
    if kind == "guitar":
        s.rod(5, (-12, 0, z1 + 0.2), (-12, 0, z1 + 0.45), DARK)
    else:
        for side in (-1, 1):
            s.slab((-15, -9), (side * 4.4 - 0.4, side * 4.4 + 0.4), (z1 + 0.2, z1 + 0.45), DARK)
    s.slab((-8 * k, 44 * k), (-2.6 * k, 2.6 * k), (z1 - 1.2, z1 + 1.2), shade(c, 0.45))
    s.slab((43 * k, 57 * k), (-3.8 * k, 3.8 * k), (z1 - 1.6, z1 + 0.6), shade(c, 0.45))
    s.slab((-31 * k, -28 * k), (-7 * k, 7 * k), (z1, z1 + 1.3), DARK)
    for j in range(4):
        y = (-1.5 + j) * 1.2 * k
        s.rod(0.09, (-29 * k, y, z1 + 1.5), (44 * k, y, z1 + 1.4), CHROME, sections=6)
        for side in (-1, 1):
            if j < 3:
                s.rod(
                    0.6 * k,
                    ((46 + 4 * j) * k, side * 3.6 * k, z1 - 0.5),
                    ((46 + 4 * j) * k, side * 5.6 * k, z1 - 0.5),
                    CHROME,
                    sections=10,
                )
    s.proxy_slab((-50 * k, 7 * k), (-17 * k, 17 * k), (0, z1 + 0.3))
    s.proxy_slab((7 * k, 57 * k), (-3.4 * k, 3.4 * k), (z1 - 1.6, z1 + 1.2), 0.5)
    shift(s, -3.5 * k)


@builder("music_drum")
def music_drum(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "drum") -> None:
    """A drum on its head, or a drum kit with cymbals."""

    def shell(x: float, y: float, z: float, r: float, h: float) -> None:
        s.rod(r, (x, y, z), (x, y, z + h), c, rough=0.3, sections=40)
        for e in (z, z + h - 1.4):
            s.rod(r * 1.03, (x, y, e), (x, y, e + 1.4), CHROME, sections=40)
        s.rod(r * 0.96, (x, y, z + h), (x, y, z + h + 0.3), WHITE, sections=40)

    if kind == "drum":
        shell(0, 0, 0, 17, 27)
        for k in range(8):
            a = math.pi * k / 4
            s.rod(
                0.5,
                (17.4 * math.cos(a), 17.4 * math.sin(a), 1),
                (17.4 * math.cos(a), 17.4 * math.sin(a), 26),
                CHROME,
                sections=8,
            )
        for y in (-4, 4):
            s.rod(0.7, (-14, y, 28), (16, y * 0.2, 28), PALE_WOOD, sections=10)
        s.proxy_cylinder(17.5, (0, 27.3))
        s.surface("head", 27.3, (11, 11))
        return
    s.rod(28, (-4, 0, 28), (38, 0, 28), c, sections=44)
    s.rod(26, (38, 0, 28), (38.4, 0, 28), WHITE, sections=44)
    for e in (-4, 36):
        s.rod(28.6, (e, 0, 28), (e + 2, 0, 28), CHROME, sections=44)
    shell(-36, 38, 34, 20, 22)
    shell(-40, -36, 46, 17, 14)
    shell(8, 18, 60, 14, 18)
    shell(8, -18, 60, 14, 18)
    for x, y, r in ((-36, 38, 14), (-40, -36, 12)):
        for k in range(3):
            a = 2 * math.pi * k / 3
            s.rod(
                1,
                (x + r * math.cos(a), y + r * math.sin(a), 0),
                (x + r * 0.8 * math.cos(a), y + r * 0.8 * math.sin(a), 47 if y < 0 else 35),
                STEEL,
                sections=8,
            )
    for x, y, z in ((14, 58, 104), (14, -58, 104), (-26, -66, 84)):
        s.lathe(
            [(0, 0), (20, -2), (20, -1.6), (4, 1), (3, 3), (0, 3)],
            BRASS,
            center=(x, y, z),
            rough=0.25,
        )
        s.rod(1.1, (x, y, 0), (x, y, z), STEEL, sections=10)
        for k in range(3):
            a = 2 * math.pi * k / 3
            s.rod(1, (x, y, 16), (x + 15 * math.cos(a), y + 15 * math.sin(a), 1), STEEL, sections=8)
        s.proxy_slab((x - 13, x + 13), (y - 13, y + 13), (0, 3), 1.0)
        s.proxy_slab((x - 1.5, x + 1.5), (y - 1.5, y + 1.5), (3, z - 2), 0.5)
        s.proxy_slab((x - 15, x + 15), (y - 15, y + 15), (z - 2, z + 2), 0.3)
    s.proxy_slab((-4, 38), (-26, 26), (0, 56), 1.0)
    s.proxy_slab((-6, 22), (-32, 32), (60, 78), 0.5)
    for x, y, r, z in ((-36, 38, 18, 56), (-40, -36, 15, 60)):
        s.proxy_cylinder(r, (0, z), 0.5, (x, y))
    shift(s, 9.4, 4)
