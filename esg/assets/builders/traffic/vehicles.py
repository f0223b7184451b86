"""Motor vehicles. Proxies are two boxes: the body down to the ground, and the cabin.

The body box reaches the ground so that a vehicle stands firmly and hits what is low in front of it;
relative densities put the centre of mass at 0.5-0.7 m for cars, as measured cars have.
"""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored
from esg.assets.builders.traffic.coachwork import draw_coach
from esg.assets.builders.traffic.liveries import draw_livery, van_livery
from esg.assets.builders.traffic.lorries import draw_bus, draw_truck, draw_van
from esg.assets.builders.traffic.models import COUPE, HATCHBACK, JEEP, PICKUP, SEDAN, SUV
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    RUBBER,
    STEEL,
    Color,
    Sketch,
)
from esg.assets.lazy import forms


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
    draw_coach(s, SEDAN, c)
    draw_livery(s, SEDAN, s.appearance.livery)
    _box_proxies(s, (-227, 229), 176, 96, (-135, 90), 146)


@builder("hatchback")
def hatchback(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two-box small car, drawn at 400 x 176 x 150."""
    draw_coach(s, HATCHBACK, c)
    _box_proxies(s, (-201, 201), 170, 99, (-185, 80), 149)


@builder("sports_car")
def sports_car(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Low coupe with a rear wing, drawn at 450 x 190 x 124."""
    draw_coach(s, COUPE, c)
    wing = ((27, 168, 3.4), (-206, 0, 112))
    s.add(
        lambda: forms.cushion(*wing, plan=14, side=0.6, sections=28, levels=9), c, name="rear_wing"
    )
    for y, word in ((-60, "right"), (60, "left")):
        s.box((16, 4, 24), (-206, y, 100), DARK, name=f"wing_stay_{word}")
    _box_proxies(s, (-225, 226), 184, 84, (-130, 60), 123)


@builder("suv")
def suv(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Tall estate, drawn at 465 x 188 x 172."""
    draw_coach(s, SUV, c)
    for y, word in ((-62, "right"), (62, "left")):
        rail = [(24, y, 167), (12, y, 171.6), (-150, y, 171.8), (-166, y, 167)]
        s.add(lambda rail=rail: forms.tube(rail, 1.8, 12), CHROME, name=f"roof_rail_{word}")
    _box_proxies(s, (-231, 233), 182, 114, (-216, 90), 171)


@builder("jeep")
def jeep(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Boxy off-road car with a spare wheel, drawn at 408 x 180 x 182."""
    draw_coach(s, JEEP, c)
    spare = (-197.5, 0.0, 100.0)
    tread = [(16, -5), (31, -6), (34, -5), (35, -2), (35, 4), (31, 6.5), (16, 5)]
    s.add(
        lambda: forms.turned([(r, -x) for r, x in tread], spare, 36, "x"),
        RUBBER,
        name="spare_wheel",
    )
    s.add(
        lambda: forms.turned([(12, -6.4), (17, -5.2), (17, 0)], spare, 28, "x"),
        STEEL,
        name="spare_rim",
    )
    _box_proxies(s, (-200, 207), 174, 111, (-186, 82), 181)


@builder("pickup")
def pickup(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pickup truck with an open bed, drawn at 540 x 196 x 185."""
    draw_coach(s, PICKUP, c)
    w = 95
    for side, word in ((-1, "right"), (1, "left")):
        y = mirrored(side, w - 12, w - 3)
        s.slab((-262, -42), y, (86, 124), c, of="car_body", name=f"bed_wall_{word}")
        s.slab(
            (-264, -44),
            mirrored(side, w - 13, w - 2),
            (122.5, 125.5),
            DARK,
            name=f"bed_rail_{word}",
        )
    s.slab((-268, -260), (-w + 3, w - 3), (70, 124), c, of="car_body", name="tailgate")
    s.slab((-268.6, -267.6), (-16, 16), (108, 115), DARK, name="tailgate_handle")
    s.slab((-260, -44), (-w + 12, w - 12), (95.5, 96.6), DARK, of="rubber_floor", name="bed_liner")
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
    draw_van(s, c)
    van_livery(s, s.appearance.livery)
    s.proxy_slab((-268, 269), (-100, 100), (0, 115), 1.0)
    s.proxy_slab((-268, 170), (-100, 100), (115, 233), 0.3)
    s.surface("roof", 233, (180, 80), (-80, 0))


@builder("truck")
def truck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two-axle box truck, drawn at 760 x 250 x 340."""
    draw_truck(s, c)
    s.proxy_slab((-380, 379), (-120, 120), (0, 96), 1.0)
    s.proxy_slab((212, 379), (-120, 120), (96, 270), 0.35)
    s.proxy_slab((-380, 205), (-125, 125), (96, 340), 0.2)
    s.surface("roof", 340, (250, 100), (-88, 0))


@builder("bus")
def bus(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """City bus, drawn at 1200 x 255 x 310."""
    draw_bus(s, c)
    s.proxy_slab((-600, 599), (-123, 123), (0, 130), 1.0)
    s.proxy_slab((-600, 592), (-123, 123), (130, 308), 0.28)
    s.surface("roof", 308, (550, 100))
