"""What police cars, taxis and ambulances wear; nothing of it collides."""

from __future__ import annotations

from typing import Any

from esg.assets.builders.traffic.coachwork import Coach, hull
from esg.assets.builders.traffic.lorries import VAN_BOTTOM, VAN_TOP
from esg.assets.geometry.sketch import DARK, Color, Sketch, rgb
from esg.assets.lazy import forms

_BLUE, _RED, _NAVY = rgb(30, 80, 220), rgb(200, 24, 28), rgb(24, 40, 92)


def draw_livery(s: Sketch, b: Coach, livery: str) -> None:
    """Draws what a passenger car serves as onto it."""
    x, top = max(b.cabin, key=lambda p: p[1])
    if livery == "police_car":
        _light_bar(s, (x, 0.0, top + 4.5), 104)
        s.add(lambda: _band(b, 56, 76), _NAVY, of="paint", name="stripe")
        s.add(lambda: _band(b, 78, 81), _RED, of="paint", name="stripe_thin")
    elif livery == "taxi":
        s.add(
            lambda: forms.cushion(
                (16, 52, 13), (x, 0, top + 5.5), plan=4, side=0.5, sections=24, levels=9
            ),
            rgb(250, 236, 190),
            of="lamp",
            name="roof_sign",
        )
        s.add(
            lambda: forms.gather(
                [
                    forms.cushion(
                        (0.8, 7.2, 6),
                        (x + q * 7.6, y, top + 6),
                        plan=6,
                        side=0.3,
                        sections=12,
                        levels=4,
                    )
                    for q in (-1, 1)
                    for y in (-15, -5, 5, 15)
                ]
            ),
            DARK,
            of="paint",
            name="letters",
        )
        s.add(lambda: _checks(b, 66, 5.2), DARK, of="paint", name="checks")


def van_livery(s: Sketch, livery: str) -> None:
    """Draws what a van serves as onto it."""
    if livery != "ambulance":
        return
    _light_bar(s, (96, 0.0, 233.5), 150, (_BLUE, _BLUE))
    skin = forms.fattened

    def stripe() -> Any:
        from shapely.geometry import box

        body = hull(200, VAN_BOTTOM, VAN_TOP, 16.0, 9.0, 0.6)
        return forms.inlay(skin(body, 0.3), forms.prism(box(-258, 86, 240, 116), (-150, 150)))

    s.add(stripe, _RED, of="paint", name="stripe")

    def cross() -> Any:
        from shapely.geometry import box

        body = hull(200, VAN_BOTTOM, VAN_TOP, 16.0, 9.0, 0.6)
        shape = box(-128, 150, -112, 206).union(box(-148, 170, -92, 186))
        return forms.inlay(skin(body, 0.35), forms.prism(shape, (-150, 150)))

    s.add(cross, _RED, of="paint", name="cross")


def _light_bar(
    s: Sketch,
    at: tuple[float, float, float],
    width: float,
    colors: tuple[Color, Color] = (_RED, _BLUE),
) -> None:
    x, y, z = at
    s.add(
        lambda: forms.cushion(
            (26, width, 4), (x, y, z - 2.6), plan=8, side=0.4, sections=24, levels=7
        ),
        DARK,
        of="plastic",
        name="light_bar",
    )
    for side, tone, word in ((-1, colors[0], "right"), (1, colors[1], "left")):
        size = (22.0, 0.36 * width, 9.0)
        place = (x, side * 0.29 * width, z + 2.2)
        s.add(
            lambda size=size, place=place: forms.cushion(
                size, place, plan=5, side=0.5, sections=20, levels=9
            ),
            tone,
            of="lamp",
            name=f"beacon_{word}",
        )
    s.add(
        lambda: forms.cushion(
            (20, 0.2 * width, 7.4), (x, y, z + 1.4), plan=6, side=0.4, sections=16, levels=7
        ),
        rgb(226, 228, 230),
        of="aluminium",
        name="siren",
    )


def _skin(b: Coach, grow: float) -> Any:
    return forms.fattened(hull(b.width, b.bottom, b.top, b.plan, b.edge), grow)


def _band(b: Coach, low: float, high: float) -> Any:
    """A stripe along both sides, between the wheels."""
    from shapely.geometry import box

    front, rear = b.axles[0] - b.radius - 8, b.axles[1] + b.radius + 8
    return forms.inlay(
        _skin(b, 0.32), forms.prism(box(rear, low, front, high), (-b.width, b.width))
    )


def _checks(b: Coach, low: float, size: float) -> Any:
    from shapely.geometry import box
    from shapely.ops import unary_union

    front, rear = b.axles[0] - b.radius - 8, b.axles[1] + b.radius + 8
    squares = []
    for row in (0, 1):
        x = rear + row * size
        while x < front - size:
            squares.append(box(x, low + row * size, x + 0.98 * size, low + (row + 0.98) * size))
            x += 2 * size
    return forms.inlay(
        _skin(b, 0.32),
        [m for q in [unary_union(squares)] for m in forms.prism(q, (-b.width, b.width))],
    )
