"""Bodies of vans, lorries and buses: one hull each, with windows that follow it."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

from esg.assets.builders.common import mirrored, shade
from esg.assets.builders.traffic.coachwork import LAMP, TAIL, TRIM, Curve, hull
from esg.assets.builders.traffic.tyres import car_wheel
from esg.assets.geometry.sketch import DARK, GLASS, STEEL, WHITE, Color, Sketch, rgb
from esg.assets.lazy import forms, shapes

SIDES = ((1, "left"), (-1, "right"))


def _rounded(x: tuple[float, float], z: tuple[float, float], by: float) -> Any:
    from shapely.geometry import box

    return box(x[0], z[0], x[1], z[1]).buffer(-by).buffer(by, quad_segs=3)


def _lean(points: list[tuple[float, float]], by: float) -> Any:
    from shapely.geometry import Polygon

    return Polygon(points).buffer(-by).buffer(by, quad_segs=3)


def _cut(body: Any, axles: tuple[float, ...], r: float, width: float) -> Any:
    tools = [
        shapes.rod(
            r + 4, (x, side * (width / 2 - 34), r + 1), (x, side * (width / 2 + 9), r + 1), 32
        )
        for x in axles
        for side in (-1, 1)
    ]
    return forms.carved(body, tools)


def _wheels(
    s: Sketch, axles: tuple[float, ...], y: float, r: float, width: float, spokes: int = 5
) -> None:
    rows = ("front", "rear") if len(axles) == 2 else ("front", "middle", "rear")
    for side, word in SIDES[::-1]:
        for row, x in zip(rows, axles, strict=True):
            name = f"{row}_{word}"
            car_wheel(s, x, side * y, r, width, side, name, spokes)


def _glazing(
    s: Sketch, meshes: Any, names: tuple[str, ...], c: Color = GLASS, material: str = "glass_dark"
) -> None:
    for name in names:
        s.add(lambda name=name: forms.copied(meshes()[name]), c, alpha=1.0, of=material, name=name)


def _mirrors(s: Sketch, at: tuple[float, float, float], size: tuple[float, float, float]) -> None:
    x, y, z = at
    for side, word in SIDES:

        def mesh(side: int = side) -> Any:
            return forms.gather(
                [
                    forms.cushion(
                        size, (x, side * y, z), plan=4.0, side=0.5, sections=16, levels=7
                    ),
                    forms.tube(
                        [
                            (x - 4, side * (y - size[1]), z + size[2] * 0.6),
                            (x, side * y, z + size[2] * 0.5),
                        ],
                        1.4,
                        8,
                    ),
                ]
            )

        s.add(mesh, DARK, of="plastic", name=f"mirror_{word}")


VAN_BOTTOM: Curve = ((268, 44), (258, 32), (220, 28), (-220, 28), (-258, 32), (-267, 44))
VAN_TOP: Curve = (
    (268, 86),
    (262, 98),
    (246, 108),
    (215, 120),
    (196, 130),
    (176, 164),
    (156, 198),
    (138, 216),
    (110, 228),
    (60, 232),
    (-220, 235),
    (-255, 231),
    (-264, 220),
    (-267, 205),
)


@lru_cache(maxsize=1)
def _van() -> dict[str, Any]:
    body = hull(200, VAN_BOTTOM, VAN_TOP, 16.0, 9.0, 0.6)
    glass, proud = forms.fattened(body, 0.4), forms.fattened(body, 0.25)
    screen = _lean([(-88, 136), (88, 136), (76, 204), (-76, 204)], 5)
    side = _lean([(182, 138), (152, 196), (96, 196), (96, 132), (170, 132)], 5)
    low = [*forms.prism(_rounded((-262, 262), (20, 58), 2), (-150, 150))]
    lines = [_rounded((x - 0.5, x + 0.5), (46, 222), 0.1) for x in (88, -40)]
    gaps = [p for line in lines for p in forms.prism(line, (-150, 150))]
    gaps += forms.prism(_rounded((-0.5, 0.5), (46, 225), 0.1), (-280, -250), "yz")
    lamps = [
        p
        for sign in (-1, 1)
        for p in forms.prism(
            _lean([(sign * 48, 84), (sign * 110, 88), (sign * 110, 104), (sign * 58, 98)], 2),
            (220, 290),
            "yz",
        )
    ]
    tails = [
        p
        for sign in (-1, 1)
        for p in forms.prism(_rounded(mirrored(sign, 88, 115), (84, 150), 2), (-290, -255), "yz")
    ]
    return {
        "body": _cut(body, (175, -165), 36, 200),
        "windscreen": forms.inlay(glass, forms.prism(screen, (130, 270), "yz")),
        "side_windows": forms.inlay(glass, forms.prism(side, (-150, 150))),
        "bumper": _cut(forms.inlay(forms.fattened(body, 0.8), low), (175, -165), 36, 200),
        "seams": forms.inlay(proud, gaps),
        "headlights": forms.inlay(glass, lamps),
        "taillights": forms.inlay(glass, tails),
        "grille": forms.inlay(
            proud, forms.prism(_rounded((-46, 46), (70, 90), 3), (240, 290), "yz")
        ),
    }


def draw_van(s: Sketch, c: Color) -> None:
    """Panel van at 540 x 206 x 235."""
    s.add(lambda: forms.copied(_van()["body"]), c, of="car_body", name="body")
    _glazing(s, _van, ("windscreen", "side_windows"))
    _glazing(s, _van, ("bumper", "grille"), TRIM, "plastic")
    _glazing(s, _van, ("seams",), shade(c, 0.2), "plastic")
    _glazing(s, _van, ("headlights",), LAMP, "lamp")
    _glazing(s, _van, ("taillights",), TAIL, "lamp")
    _mirrors(s, (158, 100, 150), (12, 8, 24))
    s.add(
        lambda: forms.gather(
            [shapes.box((2, 50, 11), (267.4, 0, 56)), shapes.box((2, 50, 11), (-267.2, 0, 66))]
        ),
        WHITE,
        of="plastic",
        name="number_plates",
    )
    for side, word in SIDES:
        s.add(
            lambda side=side: shapes.box((150, 1.6, 2.4), (-118, side * 100.2, 128)),
            shade(c, 0.45),
            of="plastic",
            name=f"slide_rail_{word}",
        )
        s.add(
            lambda side=side: forms.cushion(
                (16, 4, 4), (80, side * 100, 118), sections=12, levels=5
            ),
            DARK,
            of="plastic",
            name=f"handle_{word}",
        )
    _wheels(s, (175, -165), 100, 36, 22)


CAB_BOTTOM: Curve = ((378, 52), (370, 44), (340, 42), (240, 42), (216, 44), (211, 50))
CAB_TOP: Curve = (
    (378, 236),
    (372, 258),
    (362, 267),
    (340, 272),
    (230, 273),
    (216, 268),
    (211, 258),
)


@lru_cache(maxsize=1)
def _cab() -> dict[str, Any]:
    body = hull(240, CAB_BOTTOM, CAB_TOP, 9.0, 11.0, 0.0)
    glass = forms.fattened(body, 0.5)
    screen = _rounded((-104, 104), (172, 250), 9)
    side = _lean([(352, 168), (346, 248), (256, 248), (256, 168)], 7)
    lamps = [
        p
        for sign in (-1, 1)
        for p in forms.prism(_rounded(mirrored(sign, 66, 130), (76, 94), 3), (330, 390), "yz")
    ]
    seam = [
        p
        for x in (244, 358)
        for p in forms.prism(_rounded((x - 0.6, x + 0.6), (64, 256), 0.1), (-140, 140))
    ]
    return {
        "cab": _cut(body, (285,), 48, 240),
        "windscreen": forms.inlay(glass, forms.prism(screen, (330, 400), "yz")),
        "side_windows": forms.inlay(glass, forms.prism(side, (-140, 140))),
        "grille": forms.inlay(
            forms.fattened(body, 0.4),
            [
                p
                for z in (104, 122, 140)
                for p in forms.prism(_rounded((-78, 78), (z, z + 13), 2), (340, 390), "yz")
            ],
        ),
        "bumper": _cut(
            forms.inlay(
                forms.fattened(body, 1.5),
                forms.prism(_rounded((200, 390), (30, 74), 3), (-140, 140)),
            ),
            (285,),
            48,
            240,
        ),
        "headlights": forms.inlay(forms.fattened(body, 1.9), lamps),
        "seams": forms.inlay(forms.fattened(body, 0.25), seam),
    }


def draw_truck(s: Sketch, c: Color) -> None:
    """Two-axle box truck at 760 x 250 x 340."""
    draw_lorry(s, c, _cargo_box)


def draw_lorry(
    s: Sketch,
    c: Color,
    load: Callable[[Sketch], None],
    rear: tuple[float, ...] = (-235,),
    guard: tuple[float, float] = (-150, 180),
) -> None:
    """Cab and chassis of a lorry with what it carries, x from -379 to 379, the cab in front of 205.

    Args:
        s: Drawn into.
        c: Of the cab.
        load: Draws the body, which stands on the frame at a height of 90.
        rear: x of the axles behind the front one, one or two [cm].
        guard: x between which its sides are guarded [cm].
    """
    s.add(
        lambda: forms.gather(
            [shapes.box((753, 12, 24), (-1.5, y, 78)) for y in (-38, 38)]
            + [shapes.box((10, 76, 20), (x, 0, 78)) for x in (-300, -150, 0, 150)]
        ),
        TRIM,
        of="steel",
        name="chassis",
    )
    s.add(lambda: forms.copied(_cab()["cab"]), c, of="car_body", name="cab")
    _glazing(s, _cab, ("windscreen", "side_windows"))
    _glazing(s, _cab, ("grille", "bumper", "seams"), TRIM, "plastic")
    _glazing(s, _cab, ("headlights",), LAMP, "lamp")
    _mirrors(s, (352, 123, 222), (12, 9, 44))
    load(s)
    _fittings(s, guard, min(rear) - 57)
    _wheels(s, (285, *rear), 119, 48, 30, 8)


def _fittings(s: Sketch, guard: tuple[float, float], flaps: float) -> None:
    """Lamps, guards, steps, tank, plates and flaps along the frame."""
    middle, span = (guard[0] + guard[1]) / 2, guard[1] - guard[0]
    for side, word in SIDES:
        s.add(
            lambda side=side: shapes.box((5, 34, 12), (-378, side * 92, 82)),
            TAIL,
            of="lamp",
            name=f"taillight_{word}",
        )
        s.add(
            lambda side=side: forms.gather(
                [shapes.box((span, 4, 9), (middle, side * 112, z)) for z in (56, 76)]
                + [
                    shapes.box((5, 3, 40), (x, side * 110, 76))
                    for x in (guard[0] + 20, middle, guard[1] - 20)
                ]
            ),
            STEEL,
            of="aluminium",
            name=f"side_guard_{word}",
        )
        s.add(
            lambda side=side: shapes.box((44, 10, 5), (285, side * 0 + side * 100, 40)),
            STEEL,
            of="aluminium",
            name=f"step_{word}",
        )
    s.add(
        lambda: forms.turned(
            [(0, -70), (27, -70), (28, -66), (28, 66), (27, 70), (0, 70)], (70, -82, 66), 24, "x"
        ),
        STEEL,
        of="aluminium",
        name="fuel_tank",
    )
    s.add(
        lambda: forms.gather(
            [shapes.box((2, 52, 11), (379, 0, 58)), shapes.box((2, 52, 11), (-378.5, 0, 66))]
        ),
        WHITE,
        of="plastic",
        name="number_plates",
    )
    s.add(
        lambda: forms.gather([shapes.box((2, 34, 44), (flaps, y, 50)) for y in (-102, 102)]),
        TRIM,
        of="rubber",
        name="mud_flaps",
    )


def _cargo_box(s: Sketch) -> None:
    panel = rgb(238, 239, 240)
    s.add(
        lambda: forms.cushion(
            (583, 248, 243), (-87.5, 0, 218.5), plan=60, side=0.035, sections=20, levels=5
        ),
        panel,
        of="paint",
        name="cargo_box",
    )

    def rails() -> Any:
        edges = [shapes.box((585, 6, 7), (-87.5, y, z)) for y in (-122, 122) for z in (99.5, 336.5)]
        edges += [shapes.box((6, 6, 244), (x, y, 218)) for x in (-377, 202) for y in (-122, 122)]
        edges += [shapes.box((6, 250, 7), (x, 0, z)) for x in (-377, 202) for z in (99.5, 336.5)]
        return forms.gather(edges)

    s.add(rails, STEEL, of="aluminium", name="cargo_frame")
    s.add(
        lambda: forms.gather(
            [shapes.rod(1.6, (-381, y, 104), (-381, y, 332), 10) for y in (-70, -22, 22, 70)]
        ),
        STEEL,
        of="steel",
        name="door_bars",
    )
    s.add(lambda: shapes.box((1, 1.4, 226), (-379.9, 0, 218)), DARK, of="plastic", name="door_gap")


BUS_BOTTOM: Curve = ((599, 44), (588, 34), (540, 32), (-540, 32), (-590, 34), (-600, 44))
BUS_TOP: Curve = (
    (599, 272),
    (594, 292),
    (582, 304),
    (550, 309),
    (-560, 309),
    (-590, 305),
    (-600, 290),
)


@lru_cache(maxsize=1)
def _bus() -> dict[str, Any]:
    body = hull(246, BUS_BOTTOM, BUS_TOP, 26.0, 12.0, 0.0)
    glass, proud = forms.fattened(body, 0.6), forms.fattened(body, 0.3)
    band = forms.prism(_rounded((-560, 500), (134, 258), 6), (-140, 140))
    posts = [
        p
        for k in range(8)
        for p in forms.prism(_rounded((372 - 155 * k, 378 - 155 * k), (120, 270), 0.5), (-140, 140))
    ]
    doors = [
        p
        for x in (-90, 540)
        for p in forms.prism(_rounded((x - 44, x + 44), (46, 258), 3), (-140, 0))
    ]
    lamps = [
        p
        for sign in (-1, 1)
        for p in forms.prism(_rounded(mirrored(sign, 76, 140), (66, 86), 4), (560, 620), "yz")
    ]
    tails = [
        p
        for sign in (-1, 1)
        for p in forms.prism(_rounded(mirrored(sign, 96, 140), (80, 128), 3), (-620, -585), "yz")
    ]
    split = [
        *forms.prism(_rounded((-91, -89), (48, 256), 0.1), (-140, 0)),
        *forms.prism(_rounded((539, 541), (48, 256), 0.1), (-140, 0)),
    ]
    skirts = forms.prism(_rounded((-590, 590), (26, 50), 2), (-140, 140))
    return {
        "body": _cut(body, (330, -290), 48, 246),
        "side_windows": forms.inlay(proud, band),
        "window_posts": forms.inlay(forms.fattened(body, 0.5), posts),
        "doors": forms.inlay(glass, doors),
        "door_gaps": forms.inlay(forms.fattened(body, 0.9), split),
        "windscreen": forms.inlay(
            glass, forms.prism(_rounded((-113, 113), (116, 262), 10), (560, 620), "yz")
        ),
        "rear_window": forms.inlay(
            glass, forms.prism(_rounded((-95, 95), (170, 256), 8), (-620, -580), "yz")
        ),
        "headlights": forms.inlay(glass, lamps),
        "taillights": forms.inlay(glass, tails),
        "skirt": _cut(forms.inlay(forms.fattened(body, 0.4), skirts), (330, -290), 48, 246),
    }


def draw_bus(s: Sketch, c: Color) -> None:
    """City bus at 1200 x 255 x 310."""
    s.add(lambda: forms.copied(_bus()["body"]), c, of="car_body", name="body")
    _glazing(s, _bus, ("side_windows", "windscreen", "rear_window", "doors"))
    _glazing(s, _bus, ("window_posts", "door_gaps", "skirt"), TRIM, "plastic")
    _glazing(s, _bus, ("headlights",), LAMP, "lamp")
    _glazing(s, _bus, ("taillights",), TAIL, "lamp")
    s.add(
        lambda: forms.cushion(
            (6, 150, 24), (595, 0, 280), plan=12, side=0.12, sections=24, levels=5
        ),
        rgb(20, 20, 22),
        of="screen",
        name="destination_board",
    )
    s.add(
        lambda: forms.gather(
            [
                shapes.box((0.6, w, 11), (598.3, y, 280))
                for y, w in ((-44, 22), (-14, 26), (18, 20), (44, 18))
            ]
        ),
        rgb(250, 176, 40),
        of="lamp",
        name="destination_text",
    )
    _mirrors(s, (596, 122, 238), (10, 11, 34))
    s.add(
        lambda: forms.gather(
            [forms.tube([(600, y, 116), (599.6, y + 46, 138)], 1.2, 6) for y in (-70, 10)]
        ),
        DARK,
        of="plastic",
        name="wipers",
    )
    s.add(
        lambda: forms.cushion(
            (210, 150, 14), (-60, 0, 304), plan=8, side=0.3, sections=24, levels=7
        ),
        WHITE,
        of="plastic",
        name="roof_unit",
    )
    s.add(
        lambda: forms.gather(
            [shapes.box((2, 52, 11), (599.5, 0, 58)), shapes.box((2, 52, 11), (-600, 0, 66))]
        ),
        WHITE,
        of="plastic",
        name="number_plates",
    )
    _wheels(s, (330, -290), 123, 48, 30, 8)
