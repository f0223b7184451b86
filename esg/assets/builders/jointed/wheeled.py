"""What rolls on wheels that turn on hinges: wagons, skateboards, and their wheels."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.builders.traffic.wheels import draw_skateboard
from esg.assets.geometry.sketch import CHROME, DARK, RUBBER, STEEL, Color, Sketch
from esg.graph.models import ProxyKind

_ACROSS = (0.0, 1.0, 0.0)
_BOARD = ((21.0, 7.6), (21.0, -7.6), (-21.0, 7.6), (-21.0, -7.6))
_WHEELS = ((34.0, 22.0), (34.0, -22.0), (-34.0, 22.0), (-34.0, -22.0))


@builder("wagon_tray")
def wagon_tray(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Open tray on two axles with a drawbar, clear of the ground, drawn at 110 x 50 x 75."""
    for x, y, z in (
        ((-48, 48), (-24, 24), (21, 23)),
        ((-48, -46), (-24, 24), (23, 40)),
        ((46, 48), (-24, 24), (23, 40)),
        ((-46, 46), (-24, -22), (23, 40)),
        ((-46, 46), (22, 24), (23, 40)),
    ):
        s.slab(x, y, z, c, solid=1)
    for x in (-34, 34):
        s.rod(1.2, (x, -20, 10), (x, 20, 10), STEEL, sections=12)
        for y in (-8, 8):
            s.slab((x - 3, x + 3), (y - 1, y + 1), (9, 21), shade(c, 0.6))
    s.rod(1.2, (47, 0, 22), (52, 0, 72), DARK, sections=12)
    s.rod(1.4, (52, -8, 73), (52, 8, 73), DARK, sections=12)
    s.surface("tray", 23, (44, 20))
    s.region("inside", (-46, 46), (-22, 22), (23, 40))
    for n, (x, y) in enumerate(_WHEELS, start=1):
        s.mount(f"axle {n}", (x, y, 10.0), _ACROSS)


@builder("skateboard_deck")
def skateboard_deck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Skateboard without its wheels, drawn at 80 x 20 x 12."""
    draw_skateboard(s, c, wheels=False)
    for n, (x, y) in enumerate(_BOARD, start=1):
        s.mount(f"axle {n}", (x, y, 3.0), _ACROSS)


@builder("skateboard_wheel", "free")
def skateboard_wheel(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wheel of a skateboard, of any size; a ball touches the ground for it."""
    radius, half = 0.5 * H, 0.5 * W
    s.rod(radius, (0, 0.1 * W - half, radius), (0, half - 0.1 * W, radius), RUBBER, sections=32)
    s.rod(0.8 * radius, (0, 0.02 * W - half, radius), (0, half - 0.02 * W, radius), c, sections=28)
    for k in range(5):
        a = 0.4 * math.pi * k
        at = (0.5 * radius * math.cos(a), radius + 0.5 * radius * math.sin(a))
        ends = (at[0], -half, at[1]), (at[0], half, at[1])
        s.rod(0.14 * radius, *ends, STEEL, sections=8)
    s.proxy(ProxyKind.SPHERE, (radius,) * 3, (0.0, 0.0, radius))
    s.mount("axle", (0.0, 0.0, radius), _ACROSS)


@builder("hinged_wheel")
def hinged_wheel(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wheel that turns about Y, drawn at 20 x 5 x 20; a ball touches the ground for it."""
    s.rod(10, (0, -2.4, 10), (0, 2.4, 10), RUBBER, sections=40)
    s.rod(6.5, (0, -2.5, 10), (0, 2.5, 10), c, sections=32)
    s.rod(1.6, (0, -2.5, 10), (0, 2.5, 10), CHROME, sections=16)
    s.proxy(ProxyKind.SPHERE, (10.0,) * 3, (0.0, 0.0, 10.0))
    s.mount("axle", (0.0, 0.0, 10.0), _ACROSS)
