"""Motor vehicles. Proxies are two boxes: the body down to the ground, and the cabin.

The body box reaches the ground so that a vehicle stands firmly and hits what is low in front of it;
relative densities put the centre of mass at 0.5-0.7 m for cars, as measured cars have.
"""

from __future__ import annotations

from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import holes, mirrored
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    GLASS,
    RUBBER,
    STEEL,
    WHITE,
    YELLOW,
    Color,
    Sketch,
)
from esg.assets.lazy import shapes

LAMP, TAIL = (0.98, 0.96, 0.86), (0.6, 0.04, 0.05)


def _wheel(s: Sketch, x: float, y: float, r: float, width: float, side: int) -> None:
    """A tyre with rim and hub; `y` is the outer face."""
    inner = y - side * width
    s.rod(r, (x, inner, r), (x, y, r), RUBBER, rough=0.9, sections=36)
    s.rod(r * 0.62, (x, y, r), (x, y + side * 0.8, r), CHROME, rough=0.3, metal=0.7)
    s.rod(r * 0.16, (x, y, r), (x, y + side * 1.2, r), CHROME, metal=0.6, sections=16)
    holes(s, (x, y + side * 0.45, r), r * 0.62, 0.9)
    s.wheel((x, y - side * width / 2, r), r, parts=4)


def _hull_with_wells(
    profile: Any, width: float, wells: list[tuple[float, float]], soft: float
) -> Any:
    body = shapes.extrude(profile, (-width / 2, width / 2), "xz", soft)
    tools = [
        shapes.rod(r + 4, (x, side * (width / 2 - 26), r), (x, side * (width / 2 + 4), r), 36)
        for x, r in wells
        for side in (-1, 1)
    ]
    return shapes.cut(body, tools)


def _taper(mesh: Any, z0: float, z1: float, amount: float) -> Any:
    v = mesh.vertices.copy()
    t = ((v[:, 2] - z0) / (z1 - z0)).clip(0, 1)
    v[:, 1] *= 1 - amount * t
    mesh.vertices = v
    return mesh


def _car(
    s: Sketch,
    c: Color,
    low: Any,
    cab: Any,
    W: float,
    H: float,
    r: float,
    xs: tuple[float, float],
    belt: float,
    taper: float,
    soft: float,
    roof: float = 6.0,
) -> None:
    """Common drawing of passenger cars: `low` and `cab` are side profiles, front = +X."""
    w = W - 6
    s.add(lambda: _hull_with_wells(low, w, [(x, r) for x in xs], soft), c, 0.28, 0.15)
    s.add(lambda: _taper(shapes.extrude(cab, (-w / 2 + 3, w / 2 - 3)), belt, H, taper), GLASS, 0.12)
    s.add(
        lambda: shapes.grown(
            _taper(shapes.extrude(cab, (-w / 2 + 3, w / 2 - 3)), belt, H, taper), H - roof, 1.025
        ),
        c,
        0.28,
        0.15,
    )
    back, front = min(p[0] for p in low), max(p[0] for p in low)
    for x in xs:
        for side in (-1, 1):
            _wheel(s, x, side * (w / 2 - 0.8), r, 21, side)
    z = (belt + r) * 0.56
    for side in (-1, 1):
        s.box((7, w * 0.18, 12), (front - 5, side * w * 0.35, z), LAMP, rough=0.1)
        s.box((7, w * 0.16, 13), (back + 5, side * w * 0.36, z + 4), TAIL, rough=0.15)
        mirror_x = max(p[0] for p in cab) - (max(p[0] for p in cab) - min(p[0] for p in cab)) * 0.2
        s.box((9, 5, 10), (mirror_x, side * (W / 2 - 2.5), belt + 6), c, rough=0.3)
    s.box((5, w * 0.45, 13), (front - 2.6, 0, z - 8), DARK)
    s.box((3, 46, 11), (back + 1.6, 0, z - 8), WHITE)


def _box_proxies(
    s: Sketch,
    x: tuple[float, float],
    w: float,
    belt: float,
    cab: tuple[float, float],
    top: float,
    light: float = 0.22,
) -> None:
    """Body in two layers (dense floor, lighter upper body) and a light cabin."""
    s.proxy_slab(x, (-w / 2, w / 2), (0, belt), 1.0)
    s.proxy_slab(cab, (-w * 0.44, w * 0.44), (belt, top), light)
    s.surface("roof", top, ((cab[1] - cab[0]) / 2 * 0.8, w * 0.36), ((cab[0] + cab[1]) / 2, 0))


@builder("sedan")
def sedan(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Three-box passenger car, drawn at 455 x 182 x 146."""
    low = [
        (227, 30),
        (229, 58),
        (222, 86),
        (150, 97),
        (70, 100),
        (-140, 99),
        (-216, 94),
        (-227, 68),
        (-224, 28),
    ]
    cab = [(112, 96), (58, 140), (20, 146), (-62, 145), (-110, 132), (-166, 96)]
    _car(s, c, low, cab, 182, 146, 33, (140, -135), 97, 0.17, 6)
    _box_proxies(s, (-227, 229), 176, 96, (-135, 90), 146)


@builder("hatchback")
def hatchback(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two-box small car, drawn at 400 x 176 x 150."""
    low = [
        (199, 30),
        (201, 60),
        (192, 88),
        (125, 99),
        (40, 101),
        (-150, 103),
        (-192, 100),
        (-201, 66),
        (-198, 28),
    ]
    cab = [(98, 97), (44, 142), (0, 150), (-120, 148), (-168, 134), (-190, 99)]
    _car(s, c, low, cab, 176, 150, 31, (122, -122), 99, 0.15, 6)
    _box_proxies(s, (-201, 201), 170, 99, (-185, 80), 149)


@builder("sports_car")
def sports_car(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Low coupe with a rear wing, drawn at 450 x 190 x 124."""
    low = [
        (224, 24),
        (226, 44),
        (205, 66),
        (120, 80),
        (40, 86),
        (-130, 92),
        (-210, 90),
        (-225, 62),
        (-220, 24),
    ]
    cab = [(90, 80), (20, 118), (-20, 124), (-70, 121), (-150, 90)]
    _car(s, c, low, cab, 190, 124, 34, (138, -132), 84, 0.2, 5, 5)
    s.box((26, 168, 3), (-206, 0, 112), c, rough=0.3)
    for y in (-60, 60):
        s.box((16, 4, 24), (-206, y, 100), DARK)
    _box_proxies(s, (-225, 226), 184, 84, (-130, 60), 123)


@builder("suv")
def suv(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Tall estate, drawn at 465 x 188 x 172."""
    low = [
        (232, 38),
        (233, 72),
        (222, 104),
        (140, 113),
        (60, 115),
        (-215, 116),
        (-230, 84),
        (-228, 38),
    ]
    cab = [(110, 112), (58, 165), (30, 172), (-180, 171), (-214, 158), (-222, 114)]
    _car(s, c, low, cab, 188, 172, 37, (142, -142), 114, 0.14, 5)
    for y in (-62, 62):
        s.pipe(2, [(20, y, 171), (-165, y, 171)], CHROME, metal=0.7)
    _box_proxies(s, (-231, 233), 182, 114, (-216, 90), 171)


@builder("jeep")
def jeep(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Boxy off-road car with a spare wheel, drawn at 408 x 180 x 182."""
    low = [(202, 45), (207, 70), (202, 105), (112, 112), (-180, 112), (-192, 105), (-194, 45)]
    cab = [(95, 110), (72, 180), (-182, 182), (-188, 110)]
    _car(s, c, low, cab, 180, 182, 39, (130, -125), 111, 0.05, 3, 9)
    s.rod(35, (-204, 0, 100), (-191, 0, 100), RUBBER, rough=0.9)
    s.box((12, 176, 16), (200, 0, 46), DARK)
    for y in (-30, -15, 0, 15, 30):
        s.box((3, 6, 34), (206, y, 84), DARK)
    for side in (-1, 1):
        for x in (130, -125):
            s.box((96, 10, 6), (x, side * 84, 86), DARK)
    _box_proxies(s, (-200, 207), 174, 111, (-186, 82), 181)


@builder("pickup")
def pickup(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pickup truck with an open bed, drawn at 540 x 196 x 185."""
    low = [
        (268, 46),
        (270, 80),
        (262, 112),
        (170, 122),
        (85, 124),
        (-40, 124),
        (-40, 88),
        (-262, 88),
        (-268, 50),
    ]
    cab = [(125, 120), (80, 178), (50, 185), (-30, 184), (-42, 122)]
    _car(s, c, low, cab, 196, 185, 39, (172, -160), 122, 0.12, 4)
    w = 95
    for side in (-1, 1):
        s.slab((-262, -42), mirrored(side, w - 12, w - 3), (86, 124), c, rough=0.3)
    s.slab((-268, -260), (-w + 3, w - 3), (70, 124), c, rough=0.3)
    s.proxy_slab((-40, 270), (-95, 95), (0, 122), 1.0)
    s.proxy_slab((-268, -40), (-95, 95), (0, 88), 0.8)
    s.proxy_slab((-42, 100), (-84, 84), (122, 185), 0.2)
    for side in (-1, 1):
        s.proxy_slab((-268, -40), mirrored(side, w - 9, w), (88, 124), 0.3)
    s.proxy_slab((-268, -260), (-86, 86), (88, 124), 0.3)
    s.surface("bed", 88, (104, 80), (-150, 0))
    s.region("inside", (-258, -44), (-82, 82), (88, 130))


@builder("van")
def van(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Panel van, drawn at 540 x 206 x 235."""
    body = [
        (266, 40),
        (269, 80),
        (250, 112),
        (190, 128),
        (150, 205),
        (110, 228),
        (-255, 232),
        (-268, 220),
        (-266, 40),
    ]
    s.add(lambda: _hull_with_wells(body, 200, [(175, 36), (-165, 36)], 5), c, 0.3, 0.1)
    s.extrude([(196, 131), (155, 203), (150, 203), (190, 129)], (-84, 84), GLASS, rough=0.1)
    for side in (-1, 1):
        s.extrude(
            [(178, 133), (148, 192), (90, 192), (90, 133)],
            mirrored(side, 99, 101),
            GLASS,
            rough=0.1,
        )
        for x in (175, -165):
            _wheel(s, x, side * 100, 36, 22, side)
        s.box((8, 30, 22), (263, side * 72, 88), LAMP, rough=0.1)
        s.box((5, 12, 40), (-266, side * 90, 110), TAIL)
        s.box((9, 3, 22), (160, side * 102, 140), DARK)
    s.box((5, 110, 16), (267, 0, 64), DARK)
    s.slab((-269, -266), (-1, 1), (60, 220), DARK)
    s.proxy_slab((-268, 269), (-100, 100), (0, 115), 1.0)
    s.proxy_slab((-268, 170), (-100, 100), (115, 233), 0.3)
    s.surface("roof", 233, (180, 80), (-80, 0))


@builder("truck")
def truck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two-axle box truck, drawn at 760 x 250 x 340."""
    s.slab((-378, 375), (-45, 45), (62, 92), DARK)
    cab = [(376, 50), (379, 120), (362, 190), (345, 268), (215, 270), (212, 50)]
    s.add(lambda: _hull_with_wells(cab, 240, [(285, 48)], 4), c, 0.3, 0.1)
    s.extrude([(367, 180), (349, 255), (345, 255), (362, 180)], (-105, 105), GLASS, rough=0.1)
    for side in (-1, 1):
        s.extrude(
            [(340, 175), (330, 248), (255, 248), (255, 175)], mirrored(side, 119, 121.5), GLASS
        )
        for x in (285, -235):
            _wheel(s, x, side * 119, 48, 30, side)
        s.box((8, 34, 18), (374, side * 90, 90), LAMP, rough=0.1)
        s.box((5, 28, 12), (-378, side * 95, 80), TAIL)
        s.box((12, 4, 44), (335, side * 123, 215), DARK)
        s.slab((-160, 190), mirrored(side, 100, 112), (52, 84), STEEL, metal=0.4)
    s.slab((-380, 205), (-125, 125), (96, 340), WHITE, rough=0.5)
    s.slab((-381, -379), (-1, 1), (100, 335), DARK)
    s.box((6, 150, 40), (377, 0, 118), DARK)
    s.proxy_slab((-380, 379), (-120, 120), (0, 96), 1.0)
    s.proxy_slab((212, 379), (-120, 120), (96, 270), 0.35)
    s.proxy_slab((-380, 205), (-125, 125), (96, 340), 0.2)
    s.surface("roof", 340, (250, 100), (-88, 0))


@builder("bus")
def bus(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """City bus, drawn at 1200 x 255 x 310."""
    body = [(596, 38), (599, 120), (590, 285), (575, 308), (-590, 308), (-600, 295), (-600, 38)]
    s.add(lambda: _hull_with_wells(body, 246, [(330, 48), (-290, 48)], 6), c, 0.3)
    s.extrude([(600, 128), (592, 270), (588, 270), (594, 128)], (-112, 112), GLASS, rough=0.1)
    for side in (-1, 1):
        for k in range(7):
            x = 430 - k * 155
            s.slab((x - 70, x + 70), mirrored(side, 122, 124.5), (140, 255), GLASS, rough=0.1)
        for x in (330, -290):
            _wheel(s, x, side * 123, 48, 30, side)
        s.box((6, 34, 20), (597, side * 92, 75), LAMP, rough=0.1)
        s.box((5, 20, 34), (-600, side * 100, 90), TAIL)
    s.slab((500, 580), (-126, -123), (45, 255), GLASS, rough=0.1)
    s.box((6, 130, 26), (594, 0, 290), YELLOW, rough=0.4)
    s.proxy_slab((-600, 599), (-123, 123), (0, 130), 1.0)
    s.proxy_slab((-600, 592), (-123, 123), (130, 308), 0.28)
    s.surface("roof", 308, (550, 100))
