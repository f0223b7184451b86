"""Sports gear, weapons of the fairground, musical instruments."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import blob, bone, mirrored, prism, shade, shift
from esg.assets.sketch import (
    BRASS,
    CHROME,
    DARK,
    PALE_WOOD,
    RED,
    RUBBER,
    STEEL,
    WHITE,
    WOOD,
    YELLOW,
    Color,
    Sketch,
    rgb,
    turn,
)

_RINGS = (WHITE, DARK, rgb(60, 140, 200), RED, YELLOW)


@builder("hockey_stick")
def hockey_stick(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ice-hockey stick lying flat, blade to +X; 150 cm."""
    s.slab((-66, 66), (-1.2, 1.2), (0.2, 2.2), c)
    s.slab((-66, -44), (-1.5, 1.5), (0, 2.4), DARK)
    s.extrude(
        [(62, -1.2), (62, 1.2), (67, 8), (78, 26), (84, 24), (74, 4), (69, -1.2)],
        (0.6, 1.8),
        DARK,
        plane="xy",
    )
    s.proxy_slab((-66, 66), (-1.4, 1.4), (0, 2.4))
    s.proxy_slab((66, 82), (-1, 26), (0, 2.2), 0.6)
    shift(s, -9, -12)


@builder("golf_club")
def golf_club(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Golf club lying flat, head to +X; 100 cm."""
    s.lathe([(0, -50), (1.4, -50), (1.0, -22), (0, -22)], DARK, center=(0, 0, 1.4), axis="x")
    s.rod(0.6, (-24, 0, 1.4), (46, 0, 1.4), CHROME, metal=0.9, sections=14)
    prism(
        s,
        [
            (44, 0.8, 0.2),
            (44, -0.8, 0.2),
            (44, 0.8, 2.4),
            (50, -1, 0),
            (52, 10, 0),
            (48, 10, 0),
            (46, 10, 3.4),
            (48.5, 10.4, 3.4),
            (50, 0, 3),
        ],
        CHROME,
        rough=0.3,
        metal=0.8,
    )
    s.proxy_slab((-50, 46), (-1.2, 1.2), (0, 2.6), 1.0)
    s.proxy_slab((45, 51.5), (-1, 10), (0, 3.4), 3.0)
    shift(s, -1, -4.5)


@builder("arrow")
def arrow(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "arrow") -> None:
    """Arrow, spear or dart lying along +X."""
    if kind == "dart":
        z = 0.9
        s.lathe(
            [(0, -3.4), (0.35, -3.4), (0.42, 2), (0.2, 3.2), (0, 3.2)],
            BRASS,
            center=(0, 0, z),
            axis="x",
        )
        s.rod(0.1, (3, 0, z), (7.5, 0, z), STEEL, sections=10)
        s.rod(0.22, (-7.5, 0, z), (-3, 0, z), DARK, sections=10)
        r0, r1, k = 0.15, 0.9, 2.6
        for a in (0, 90, 180, 270):
            u = (math.cos(math.radians(a + 45)), math.sin(math.radians(a + 45)))
            prism(
                s,
                [
                    (x, u[0] * r - u[1] * t, z + u[1] * r + u[0] * t)
                    for x, r in ((-7.5, r0), (-4.5, r0), (-7.8, r1), (-7.5 + k * 0.6, r1))
                    for t in (-0.03, 0.03)
                ],
                c,
            )
        s.proxy_slab((-7.6, 4), (-0.55, 0.55), (0, 1.4))
        s.proxy_slab((4, 7.4), (-0.2, 0.2), (0.6, 1.2), 0.4)
        shift(s, 0.1, 0, -0.25 + 0.0)
        s.proxies[:] = [
            p.model_copy(update={"position_cm": (*p.position_cm[:2], p.position_cm[2] + 0.25)})
            for p in s.proxies
        ]
        return
    half, r, z = (38.0, 0.4, 2.0) if kind == "arrow" else (110.0, 1.3, 3.4)
    s.rod(r, (-half, 0, z), (half * 0.92, 0, z), c, sections=14)
    tip = half * 0.08
    prism(
        s,
        [
            (half * 0.9, 0, z + 2.6 * r),
            (half * 0.9, 0, z - 2.6 * r),
            (half * 0.9, r, z),
            (half * 0.9, -r, z),
            (half * 0.9 + tip * 2, 0, z),
        ],
        STEEL,
        metal=0.7,
    )
    if kind == "arrow":
        for a in (90, 210, 330):
            u = (math.cos(math.radians(a)), math.sin(math.radians(a)))
            prism(
                s,
                [
                    (x, u[0] * q - u[1] * t, z + u[1] * q + u[0] * t)
                    for x, q in ((-half, 0.3), (-half + 9, 0.3), (-half - 1, 2.3), (-half + 5, 2.1))
                    for t in (-0.06, 0.06)
                ],
                RED,
            )
        s.proxy_slab((-half, half * 0.9), (-1.5, 1.5), (0, 3.6))
        s.proxy_slab((half * 0.9, half * 1.05), (-0.5, 0.5), (1, 3), 1.0)
        shift(s, -1.0, 0, -0.85)
        s.proxies[:] = [
            p.model_copy(update={"position_cm": (*p.position_cm[:2], p.position_cm[2] + 0.85)})
            for p in s.proxies
        ]
        return
    s.proxy_slab((-half, half), (-1.3, 1.3), (0, 5.4))
    shift(s, -2, 0, 0.0)


@builder("bow")
def bow(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Archery bow lying flat, string towards -X, 150 cm across."""
    path = [
        (26 * math.cos(math.radians(a)) - 10, 75 * math.sin(math.radians(a)), 1.4)
        for a in range(-90, 91, 15)
    ]
    s.pipe(1.4, path, c)
    s.rod(0.25, (-10, -74, 1.4), (-10, 74, 1.4), WHITE, sections=8)
    s.rod(2.0, (16, -8, 2), (16, 8, 2), DARK, sections=16)
    for (x0, y0, _), (x1, y1, _) in zip(path[::3], path[3::3], strict=False):
        m, d = ((x0 + x1) / 2, (y0 + y1) / 2), math.hypot(x1 - x0, y1 - y0) / 2
        s.proxy_box(
            (1.6, d, 1.4),
            (m[0] + 1.5, m[1], 1.4),
            1.0,
            turn("z", math.degrees(math.atan2(y1 - y0, x1 - x0)) - 90),
        )
    shift(s, -3.3)


@builder("target")
def target(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "stand") -> None:
    """Archery target on a stand facing +X, 122 cm face; or a dartboard."""
    board = kind == "board"
    r, z = (22.5, 22.5) if board else (61.0, 100.0)
    depth = 4.0 if board else 14.0
    s.rod(r, (-depth / 2, 0, z), (depth / 2, 0, z), c, rough=0.95, sections=48)
    for k, tone in enumerate(_RINGS):
        q = r * (0.98 - 0.19 * k)
        s.rod(q, (depth / 2, 0, z), (depth / 2 + 0.15 * (k + 1), 0, z), tone, sections=48)
    if board:
        for k in range(20):
            a = math.radians(18 * k + 9)
            s.rod(
                0.12, (2.9, 0, z), (2.9, 22 * math.cos(a), z + 22 * math.sin(a)), STEEL, sections=6
            )
        s.slab((-14, -2), (-16, 16), (0, 2), DARK)
        s.slab((-14, 8), (-16, -12), (0, 2), DARK)
        s.slab((-14, 8), (12, 16), (0, 2), DARK)
        s.proxy_slab((-14, 8), (-16, 16), (0, 2), 2.0)
        s.proxy_slab((-2, 2.9), (-20, 20), (2, 44), 1.0)
        shift(s, 3)
        return
    for side in (-1, 1):
        s.rod(3, (-10, side * 40, 0), (-10, side * 26, 150), WOOD, sections=12)
        s.rod(3, (-46, side * 10, 1), (-12, side * 8, 140), WOOD, sections=12)
    s.rod(2.5, (-10, -40, 40), (-10, 40, 40), WOOD, sections=12)
    for side in (-1, 1):
        s.proxy_slab((-49, 7), mirrored(side, 34, 42), (0, 4), 3.0)
        s.proxy_slab((-14, -6), mirrored(side, 30, 40), (4, 44), 0.6)
    s.proxy_slab((-7, 7), (-50, 50), (44, 150), 0.6)
    shift(s, 20)


@builder("shuttlecock")
def shuttlecock(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Badminton shuttlecock on its side, cork to +X; 8 cm."""
    z = 3.2
    s.ball(1.3, (3.0, 0, z), c)
    s.rod(1.3, (1.6, 0, z), (3.0, 0, z), c, sections=24)
    s.lathe(
        [(1.1, 1.7), (3.2, -4.2), (3.1, -4.3), (1.0, 1.6), (1.1, 1.7)],
        WHITE,
        center=(0, 0, z),
        axis="x",
    )
    for k in range(12):
        a = math.pi * k / 6
        s.rod(
            0.1,
            (1.7, 1.08 * math.cos(a), z + 1.08 * math.sin(a)),
            (-4.2, 3.15 * math.cos(a), z + 3.15 * math.sin(a)),
            WHITE,
            sections=6,
        )
    s.proxy_hull(
        [
            (
                -4.2,
                3.2 * math.cos(math.pi * k / 4 + math.pi / 8),
                z + 3.2 * math.sin(math.pi * k / 4 + math.pi / 8) * 1.0,
            )
            for k in range(8)
        ]
        + [(-4.2, -1.2, 0.0), (-4.2, 1.2, 0.0), (1.8, -0.6, 0.0), (1.8, 0.6, 0.0)]
        + [(4.2, 0, z), (3.4, 0, z + 1.2)]
    )


@builder("barbell")
def barbell(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "kettlebell") -> None:
    """Kettlebell, 28 cm; anvil; anchor by its kind."""
    if kind == "kettlebell":
        s.lathe([(0, 0), (7, 0), (10.4, 6), (10.4, 11), (7, 17), (0, 19)], c, smooth=30, rough=0.5)
        s.pipe(
            1.7,
            [(0, -5.6, 15), (0, -6.6, 22), (0, -4, 26.3), (0, 4, 26.3), (0, 6.6, 22), (0, 5.6, 15)],
            c,
        )
        s.proxy_cylinder(7, (0, 3), 1.0)
        s.proxy_cylinder(10, (3, 16), 1.0)
        s.proxy_slab((-1.7, 1.7), (-8, 8), (16, 28), 0.7)
        return
    s.extrude(
        [
            (-13, 0),
            (13, 0),
            (13, 4),
            (7, 7),
            (6, 14),
            (14, 19),
            (16, 26),
            (-16, 26),
            (-16, 20),
            (-6, 15),
            (-7, 7),
            (-13, 4),
        ],
        (-6.5, 6.5),
        c,
        rough=0.5,
        metal=0.6,
    )
    bone(s, (15, 0, 22), 4, (33, 0, 24.6), 1.2, c, metal=0.6)
    s.proxy_slab((-13, 13), (-9, 9), (0, 5), 1.0)
    s.proxy_slab((-7, 7), (-6.5, 6.5), (5, 16), 1.0)
    s.proxy_slab((-16, 16), (-6.5, 6.5), (16, 26), 1.0)
    s.proxy_slab((16, 33), (-3, 3), (19, 26), 0.5)
    s.slab((-13, 13), (-9, 9), (0, 3), c, metal=0.6)
    s.surface("face", 26, (15, 6))
    shift(s, -9)


@builder("anchor")
def anchor(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ship's anchor lying flat, crown to +X; 90 cm."""
    s.rod(4, (-38, 0, 4), (40, 0, 4), c, sections=16, metal=0.5)
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
    s.rod(3, (-28, -26, 4), (-28, 26, 4), c, sections=14, metal=0.5)
    s.torus(6, 1.6, (-43, 0, 4), c, metal=0.6)
    s.proxy_slab((-48, 42), (-4, 4), (0, 8), 1.0)
    s.proxy_slab((-31, -25), (-26, 26), (1, 7), 1.0)
    s.proxy_slab((4, 40), (-36, 36), (0.5, 7.5), 0.35)
    shift(s, 3)


@builder("curling_stone")
def curling_stone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Granite curling stone with a handle, 28 cm."""
    s.lathe(
        [(0, 0), (7, 0), (12.6, 3), (14, 6.5), (12.6, 10.4), (8, 12), (0, 12.2)],
        c,
        smooth=30,
        rough=0.35,
    )
    s.lathe([(14.0, 5.6), (14.3, 5.6), (14.3, 7.4), (14.0, 7.4), (14.0, 5.6)], shade(c, 0.6))
    s.pipe(1.2, [(-4, 0, 12), (-4, 0, 15.6), (0, 0, 16.2), (8, 0, 16.6)], RED)
    s.proxy_cylinder(9, (0, 1.5), 1.0)
    s.proxy_cylinder(14, (1.5, 12), 1.0)
    s.proxy_slab((-5, 8), (-1.4, 1.4), (12, 17), 0.1)


@builder("board_sport")
def board_sport(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "surfboard") -> None:
    """Surfboard, snowboard or a pair of skis, flat on the ground, nose to +X."""
    if kind == "skis":
        for side in (-1, 1):
            y = side * 8
            s.slab((-84, 70), (y - 4, y + 4), (0, 1.4), c)
            prism(
                s,
                [
                    (70, y - 4, 0),
                    (70, y + 4, 0),
                    (70, y - 4, 1.4),
                    (70, y + 4, 1.4),
                    (84, y, 6),
                    (84, y, 7),
                ],
                c,
            )
            s.slab((-16, 12), (y - 3, y + 3), (1.4, 5), DARK)
            s.proxy_slab((-84, 72), (y - 4, y + 4), (0, 1.6), 1.0)
            s.proxy_slab((-16, 12), (y - 3, y + 3), (1.6, 5.4), 0.6)
        return
    half, wide, thick = (92.0, 26.0, 7.0) if kind == "surfboard" else (76.0, 14.5, 2.4)
    n = 24
    plan = []
    for k in range(n):
        a = 2 * math.pi * k / n
        x, y = math.cos(a), math.sin(a)
        plan.append(
            (
                half * math.copysign(abs(x) ** 0.75, x),
                wide * math.copysign(abs(y) ** (0.9 if kind == "surfboard" else 0.5), y),
            )
        )
    s.extrude(plan, (0, thick), c, plane="xy", rough=0.25)
    if kind == "surfboard":
        s.slab((-half * 0.94, half * 0.94), (-1, 1), (thick - 0.2, thick + 0.2), RED)
        s.slab(
            (-half * 0.5, half * 0.5),
            (-wide * 0.93, wide * 0.93),
            (thick - 0.3, thick + 0.1),
            shade(c, 0.8),
        )
    else:
        for x in (-26, 26):
            s.slab((x - 8, x + 8), (-9, 9), (thick, thick + 2.4), DARK)
            s.proxy_slab((x - 8, x + 8), (-9, 9), (thick, thick + 2.4), 0.4)
    s.proxy_slab((-half * 0.8, half * 0.8), (-wide * 0.85, wide * 0.85), (0, thick))
    s.surface("deck", thick, (half * 0.6, wide * 0.6))


@builder("punching_bag")
def punching_bag(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Free-standing punching bag, 170 cm."""
    s.lathe([(0, 0), (28, 0), (28, 8), (18, 24), (12, 30), (0, 30)], DARK, smooth=0)
    s.rod(6, (0, 0, 30), (0, 0, 50), STEEL)
    s.lathe([(0, 48), (17, 48), (18, 54), (18, 164), (15, 170), (0, 170)], c, rough=0.5)
    for z in (70, 148):
        s.lathe([(18, z), (18.4, z), (18.4, z + 5), (18, z + 5), (18, z)], WHITE)
    s.proxy_cylinder(28, (0, 12), 4.0)
    s.proxy_cylinder(18, (12, 170), 0.5)


@builder("hurdle")
def hurdle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Athletics hurdle facing +X, 107 x 120 cm."""
    for side in (-1, 1):
        s.slab((-50, 20), (side * 56 - 2, side * 56 + 2), (0, 4), STEEL)
        s.slab((14, 18), (side * 56 - 2, side * 56 + 2), (4, 100), STEEL)
    s.slab((14, 18), (-60, 60), (97, 107), c)
    for y in (-44, 0, 44):
        s.slab((17.9, 18.3), (y - 9, y + 9), (97.2, 106.8), DARK)
    for side in (-1, 1):
        s.proxy_slab((-50, 20), (side * 56 - 2, side * 56 + 2), (0, 4), 3.0)
        s.proxy_slab((14, 18), (side * 56 - 2, side * 56 + 2), (4, 97), 1.0)
    s.proxy_slab((14, 18), (-60, 60), (97, 107), 0.6)
    shift(s, 15)


@builder("pommel_horse")
def pommel_horse(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Gymnastics pommel horse, 160 cm along X."""
    blob(s, [((-64, -6, 98), 13), ((64, -6, 98), 13), ((-64, 6, 98), 13), ((64, 6, 98), 13)], c)
    for x in (-22, 22):
        s.pipe(2, [(x, -11, 108), (x, -10, 121), (x, 10, 121), (x, 11, 108)], WOOD)
    for x in (-40, 40):
        s.rod(4.5, (x, 0, 4), (x, 0, 90), STEEL, metal=0.5)
        s.slab((x - 6, x + 6), (-38, 38), (0, 5), DARK)
        s.proxy_slab((x - 6, x + 6), (-38, 38), (0, 5), 3.0)
        s.proxy_slab((x - 4, x + 4), (-4, 4), (5, 86), 1.0)
    s.proxy_slab((-77, 77), (-18, 18), (86, 111), 0.5)
    s.surface("top", 111, (70, 15))


@builder("boomerang")
def boomerang(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Boomerang lying flat, 36 cm across."""
    s.extrude(
        [
            (10, 0),
            (4, 6),
            (-10, 18),
            (-13.5, 16),
            (-12, 12.5),
            (3.5, 0),
            (-12, -12.5),
            (-13.5, -16),
            (-10, -18),
            (4, -6),
        ],
        (0, 0.9),
        c,
        plane="xy",
        soft=0.6,
    )
    for side in (-1, 1):
        s.proxy_box((9.6, 2.2, 0.45), (-2.6, side * 8.6, 0.45), 1.0, turn("z", -45 * side))
    shift(s, 1.75)


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
            s.rod(r * 1.03, (x, y, e), (x, y, e + 1.4), CHROME, metal=0.8, sections=40)
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
        s.rod(28.6, (e, 0, 28), (e + 2, 0, 28), CHROME, metal=0.8, sections=44)
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
            metal=0.8,
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


@builder("trumpet")
def trumpet(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Trumpet lying on its side, bell to +X; 53 cm."""
    bell = [
        (0.6, -18),
        (0.7, 8),
        (1.2, 18),
        (2.6, 24),
        (6.1, 27),
        (6.2, 27.2),
        (2.2, 24.2),
        (0.4, 17),
        (0.4, -18),
        (0.6, -18),
    ]
    s.lathe(bell, c, center=(0, 0, 6.2), axis="x", metal=0.9, rough=0.2)
    s.rod(0.6, (-27, 7, 6.2), (10, 7, 6.2), c, metal=0.9, sections=14)
    s.pipe(0.6, [(10, 7, 6.2), (15, 5, 6.2), (15, 2, 6.2), (10, 0, 6.2)], c)
    s.pipe(0.6, [(-18, 0, 6.2), (-21, 3, 6.2), (-18, 6, 6.2)], c)
    s.lathe(
        [(0, -27.6), (1.4, -27.6), (0.6, -24.4), (0, -24.4)], CHROME, center=(0, 7, 6.2), axis="x"
    )
    for x in (-6, -2.4, 1.2):
        s.rod(1.3, (x, -3, 6.2), (x, 8, 6.2), c, metal=0.9, sections=18)
        s.rod(0.5, (x, 8, 6.2), (x, 10.4, 6.2), CHROME, sections=10)
    s.rod(1.6, (-8, 0, 0), (-8, 0, 6.2), c, sections=14)
    s.proxy_slab((-27, 16), (-2, 9), (0, 8), 1.0)
    s.proxy_slab((16, 27), (-4.5, 4.5), (0, 12), 0.5)
    shift(s, 0, -2.1)


@builder("bell")
def bell(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bronze bell standing on its rim, 44 cm."""
    s.lathe(
        [
            (15, 0),
            (20, 0),
            (19, 3),
            (14, 12),
            (11.6, 28),
            (8, 35),
            (0, 36),
            (0, 33),
            (7, 32),
            (10, 26),
            (12.4, 11),
            (15, 0),
        ],
        c,
        smooth=0,
        rough=0.3,
        metal=0.8,
    )
    s.torus(4, 1.4, (0, 0, 39.6), c, axis="y", metal=0.8)
    s.rod(0.8, (0, 0, 33), (0, 0, 8), STEEL, sections=10)
    s.ball(2.6, (0, 0, 7), STEEL, metal=0.7)
    s.proxy_cylinder(19.5, (0, 4), 1.0)
    s.proxy_cylinder(14, (4, 16), 0.8)
    s.proxy_cylinder(11, (16, 36), 0.7)
    s.proxy_slab((-5, 5), (-1.4, 1.4), (36, 45), 0.5)


@builder("microphone")
def microphone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Microphone on a floor stand, 150 cm."""
    s.rod(15, (0, 0, 0), (0, 0, 3), DARK)
    s.rod(1.1, (0, 0, 3), (0, 0, 138), STEEL, sections=14, metal=0.6)
    bone(s, (-2, 0, 138), 1.6, (10, 0, 144), 2.2, c)
    s.ball(3.2, (12, 0, 145), STEEL, metal=0.5)
    s.proxy_cylinder(15, (0, 3), 6.0)
    s.proxy_cylinder(1.4, (3, 138), 0.6)
    s.proxy_slab((-3, 14), (-3, 3), (138, 148), 0.5)


@builder("ice_skate")
def ice_skate(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "shoe") -> None:
    """A shoe, a boot, or a roller skate; toe to +X, 29 cm."""
    sole = 4.6 if kind == "skate" else 0.0
    s.extrude(
        [
            (-14, -3.4),
            (-14, 3.4),
            (-4, 3.6),
            (6, 5),
            (12, 4.4),
            (14.4, 0),
            (12, -4.4),
            (6, -5),
            (-4, -3.6),
        ],
        (sole, sole + 2.2),
        RUBBER if kind != "shoe" else WHITE,
        plane="xy",
        soft=1,
    )
    high = 22.0 if kind == "boot" else 13.0 if kind == "skate" else 8.6
    blob(
        s,
        [((-9, 0, sole + 4.6), 4.0), ((9.4, 0, sole + 4.2), 3.9), ((2, 0, sole + 5), 4.2)],
        c,
        rough=0.6,
    )
    blob(
        s,
        [
            ((-8.6, 0, sole + 5), 4.0),
            ((-8, 0, sole + high - 2), 3.8),
            ((-2.6, 0, sole + high - 3), 3.4),
        ],
        c,
        rough=0.6,
    )
    s.rod(3.2, (-6, 0, sole + high), (-6, 0, sole + high + 1.2), DARK)
    for k in range(4):
        s.rod(
            0.3,
            (1.6 + 2 * k, -2.6, sole + 9.2 - 0.2 * k),
            (1.6 + 2 * k, 2.6, sole + 9.2 - 0.2 * k),
            WHITE,
            sections=8,
        )
    if kind == "skate":
        for x in (-9, 9):
            for side in (-1, 1):
                s.rod(2.6, (x, side * 1.6, 2.6), (x, side * 3.8, 2.6), YELLOW, sections=20)
    s.proxy_slab((-14, 14), (-4.4, 4.4), (0, sole + 7.5))
    s.proxy_slab((-12.4, 0), (-3.8, 3.8), (sole + 7.5, sole + high + 1), 0.6)
