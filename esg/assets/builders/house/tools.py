"""Tools, long and short, lying along X."""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import bone, prism, shift
from esg.assets.geometry.sketch import CHROME, DARK, RED, STEEL, WOOD, YELLOW, Color, Sketch, rgb


@builder("long_tool")
def long_tool(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "shovel") -> None:
    """A tool with a long handle lying along X, head to +X."""
    half = 60.0
    z = {"broom": 4.0, "rake": 4.0}.get(kind, 2.0)
    s.rod(1.5, (-half, 0, z), (half - 22, 0, z), WOOD if kind != "crutch" else c, sections=16)
    if kind == "shovel":
        s.rod(2.0, (half - 30, 0, z), (half - 18, 0, z), STEEL, sections=16)
        s.extrude(
            [(half - 20, -11), (half - 20, 11), (half + 2, 10), (half + 9, 0), (half + 2, -10)],
            (z - 1, z),
            c,
            plane="xy",
            soft=1,
            metal=0.5,
        )
        s.pipe(1.4, [(-half, -5, z), (-half - 2, -5, z), (-half - 2, 5, z), (-half, 5, z)], DARK)
        s.rod(1.4, (-half, -5, z), (-half, 5, z), DARK)
        s.proxy_slab((-half - 3, half - 20), (-1.6, 1.6), (0, 3.6), 1.0)
        s.proxy_slab((half - 20, half + 8), (-10, 10), (0, 3.2), 0.5)
        shift(s, -3.4)
    elif kind == "rake":
        s.slab((half - 24, half - 21), (-18, 18), (z - 1, z + 1), c)
        for k in range(9):
            y = -17 + 34 * k / 8
            s.rod(0.5, (half - 22.5, y, z), (half - 20, y, 0.3), c, sections=8)
        s.proxy_slab((-half, half - 24), (-1.5, 1.5), (z - 1.5, z + 1.5), 1.0)
        s.proxy_slab((half - 25, half - 19), (-18, 18), (0, z + 1), 1.0)
        s.proxy_slab((-half, -half + 3), (-1.5, 1.5), (0, z - 1.5), 0.3)
        shift(s, 9)
    elif kind == "broom":
        s.box((9, 30, 4), (half - 20, 0, z), c)
        prism(
            s,
            [(half - 16, y, z + d) for y in (-14, 14) for d in (-1.6, 1.6)]
            + [(half - 2, y, zz) for y in (-18, 18) for zz in (0, 8)],
            YELLOW,
            rough=1.0,
        )
        s.proxy_slab((-half, half - 24), (-1.5, 1.5), (z - 1.5, z + 1.5), 1.0)
        s.proxy_slab((half - 24, half - 2), (-16, 16), (0, 8), 0.3)
        s.proxy_slab((-half, -half + 3), (-1.5, 1.5), (0, z - 1.5), 0.3)
        shift(s, 1)
    else:
        s.pipe(
            1.5, [(half - 22, 0, z), (half - 12, 0, z), (half - 10, 9, z), (half - 14, 13, z)], c
        )
        s.proxy_slab((-half, half - 10), (-1.5, 1.5), (0, 3.5), 1.0)
        s.proxy_slab((half - 15, half - 8.5), (0, 14), (0, 3.5), 0.4)
        shift(s, 5.8, -6.4, -0.5)
        s.proxies[:] = [
            p.model_copy(update={"position_cm": (*p.position_cm[:2], p.position_cm[2] + 0.5)})
            for p in s.proxies
        ]


@builder("hand_tool")
def hand_tool(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "axe") -> None:
    """A hand tool lying flat, working end to +X."""
    if kind == "axe":
        s.extrude(
            [(-26, -1.6), (-27, 2), (-20, 1.6), (18, 1.4), (18, -1.4), (-20, -1.4)],
            (0.6, 2.6),
            WOOD,
            plane="xy",
            soft=0.3,
        )
        prism(
            s,
            [
                (14, 3, 0),
                (20, 3, 0),
                (14, 3, 3.2),
                (20, 3, 3.2),
                (12, -9, 1.4),
                (22.5, -9, 1.4),
                (12, -9, 1.8),
                (22.5, -9, 1.8),
            ],
            c,
            metal=0.6,
        )
        s.proxy_slab((-26, 14), (-1.5, 1.5), (0, 3), 0.4)
        s.proxy_slab((13, 21), (-8, 3), (0, 3.2), 3.0)
        shift(s, 2, 3)
    elif kind == "wrench":
        s.extrude(
            [(-9.5, -0.9), (7, -0.7), (7, 0.7), (-9.5, 0.9)], (0, 0.8), c, plane="xy", metal=0.7
        )
        s.extrude(
            [
                (6.5, -1.2),
                (8, -2.2),
                (11.5, -2),
                (11.5, -0.9),
                (9, -0.8),
                (9, 0.8),
                (11.5, 0.9),
                (11.5, 2),
                (8, 2.2),
                (6.5, 1.2),
            ],
            (0, 1),
            c,
            plane="xy",
            metal=0.7,
        )
        s.torus(1.7, 0.5, (-10.5, 0, 0.5), c, metal=0.7)
        s.proxy_slab((-12, 7), (-1, 1), (0, 0.9), 1.0)
        s.proxy_slab((6.5, 11.5), (-2, 2), (0, 1), 1.0)
        shift(s, 0.6)
    elif kind == "screwdriver":
        s.lathe(
            [(0, -12), (1.3, -11.5), (1.5, -6), (1.1, -2.4), (0, -2)],
            c,
            center=(0, 0, 1.5),
            axis="x",
            rough=0.3,
        )
        s.rod(0.35, (-2.5, 0, 1.5), (10, 0, 1.5), CHROME, metal=0.9, sections=12)
        prism(
            s,
            [(9.6, y, 1.5 + z) for y in (-0.35, 0.35) for z in (-0.35, 0.35)]
            + [(11.6, y, 1.5 + z) for y in (-0.5, 0.5) for z in (-0.08, 0.08)],
            CHROME,
        )
        s.proxy_slab((-12, -2), (-1.1, 1.1), (0, 2.9), 1.0)
        s.proxy_slab((-2, 11.5), (-0.4, 0.4), (1.0, 2.0), 1.5)
        shift(s, 0.2)
    elif kind == "saw":
        s.extrude(
            [(-14, -4), (28, -1.5), (28, 1.5), (-14, 7)], (0.6, 0.9), STEEL, plane="xy", metal=0.8
        )
        s.extrude(
            [(-13, -4.5), (-13, 8), (-22, 7.5), (-25, 3), (-24, -4), (-18, -6)],
            (0, 2),
            c,
            plane="xy",
            soft=0.8,
            holes=[[(-16, -0.5), (-16, 4.5), (-20, 4.5), (-21, 1), (-20, -1.5)]],
        )
        s.proxy_slab((-25, -13), (-6, 8), (0, 2), 1.0)
        s.proxy_slab((-13, 28), (-2.5, 4), (0, 1), 0.6)
        shift(s, -1.5, -1)
    elif kind == "drill":
        s.rod(3, (-7, 0, 17), (7, 0, 17), c, rough=0.4)
        s.lathe([(0, 7), (2.6, 7), (2, 12), (1.0, 13), (0, 13)], DARK, center=(0, 0, 17), axis="x")
        s.rod(0.4, (13, 0, 17), (21, 0, 17), STEEL, metal=0.8, sections=10)
        s.extrude([(-6, 15), (0, 15), (-1, 5), (-7, 5)], (-2, 2), DARK, soft=0.5)
        s.slab((-10, 4), (-3.6, 3.6), (0, 5.5), c)
        s.box((1, 1, 2.4), (0.4, 0, 12.6), RED)
        s.proxy_slab((-10, 4), (-3.6, 3.6), (0, 5.5), 1.5)
        s.proxy_slab((-7, 0), (-2, 2), (5.5, 14), 0.6)
        s.proxy_slab((-7, 13), (-3, 3), (14, 20), 1.0)
        shift(s, -5.5)
    elif kind == "scissors":
        for side in (-1, 1):
            prism(
                s,
                [
                    (-1, side * 0.2 - 0.5, 0.2),
                    (-1, side * 0.2 + 0.5, 0.2),
                    (-1, side * 0.2 - 0.5, 0.5),
                    (-1, side * 0.2 + 0.5, 0.5),
                    (10, side * 1.6, 0.2),
                    (10, side * 1.6, 0.45),
                ],
                STEEL,
                metal=0.8,
            )
            s.rod(0.4, (-1, 0, 0.5), (-6, -side * 2.2, 0.5), c, sections=10)
            s.torus(1.7, 0.45, (-7.6, -side * 2.7, 0.5), c)
        s.rod(0.5, (0, 0, 0), (0, 0, 0.9), CHROME, sections=14)
        s.proxy_slab((-9.6, 0), (-4.4, 4.4), (0, 0.9), 0.6)
        s.proxy_slab((0, 10), (-1.6, 1.6), (0, 0.6), 1.0)
    elif kind == "fork":
        s.slab((-10, 4), (-0.6, 0.6), (0.2, 0.6), c, metal=0.8)
        s.slab((-10, -2), (-0.9, 0.9), (0.1, 0.6), c, metal=0.8)
        s.slab((3.6, 6), (-1.2, 1.2), (0.2, 0.6), c, metal=0.8)
        for y in (-1.0, -0.33, 0.33, 1.0):
            prism(
                s,
                [
                    (5.8, y - 0.2, 0.2),
                    (5.8, y + 0.2, 0.2),
                    (5.8, y - 0.2, 0.6),
                    (5.8, y + 0.2, 0.6),
                    (10, y - 0.1, 1.0),
                    (10, y + 0.1, 1.0),
                    (10, y - 0.1, 1.2),
                    (10, y + 0.1, 1.2),
                ],
                c,
                metal=0.8,
            )
        s.proxy_slab((-10, 10), (-1, 1), (0, 0.9))
        shift(s, 0, 0, -0.1)
        s.proxies[:] = [
            p.model_copy(update={"position_cm": (*p.position_cm[:2], p.position_cm[2] + 0.1)})
            for p in s.proxies
        ]
    elif kind == "nail":
        s.rod(0.2, (-4, 0, 0.5), (3.2, 0, 0.5), c, metal=0.7, sections=12)
        bone(s, (3.2, 0, 0.5), 0.18, (3.9, 0, 0.5), 0.03, c, metal=0.7)
        s.rod(0.5, (-4.2, 0, 0.5), (-4, 0, 0.5), c, metal=0.7, sections=20)
        s.proxy_slab((-4.2, 3.8), (-0.3, 0.3), (0, 0.75))
    else:
        s.extrude([(-2.6, 0), (2.6, 0), (2.6, 1.4), (1.8, 1.6), (-2.6, 1.6)], (-1.1, 1.1), c)
        s.slab((-2.7, 0.2), (-1.15, 1.15), (0, 1.65), rgb(60, 90, 160))
        s.proxy_slab((-2.6, 2.6), (-1.1, 1.1), (0, 1.6))
