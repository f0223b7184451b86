"""What rolls on wheels that turn on hinges: a wagon with its tray, and a wheel."""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.sketch import CHROME, DARK, RUBBER, STEEL, Color, Sketch
from esg.graph.models import ProxyKind

_ACROSS = (0.0, 1.0, 0.0)
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


@builder("hinged_wheel")
def hinged_wheel(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wheel that turns about Y, drawn at 20 x 5 x 20; a ball touches the ground for it."""
    s.rod(10, (0, -2.4, 10), (0, 2.4, 10), RUBBER, sections=40)
    s.rod(6.5, (0, -2.5, 10), (0, 2.5, 10), c, sections=32)
    s.rod(1.6, (0, -2.5, 10), (0, 2.5, 10), CHROME, sections=16)
    s.proxy(ProxyKind.SPHERE, (10.0,) * 3, (0.0, 0.0, 10.0))
    s.mount("axle", (0.0, 0.0, 10.0), _ACROSS)
