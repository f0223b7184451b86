"""What stands and lies along roads: bus stops, signs, bumps, parking."""

from __future__ import annotations

from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored, shade, shift
from esg.assets.geometry.rotations import direction
from esg.assets.geometry.sketch import CONCRETE, DARK, STEEL, WHITE, WOOD, YELLOW, Color, Sketch
from esg.assets.lazy import forms
from esg.graph.models import ProxyKind


@builder("bus_stop")
def bus_stop(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bus shelter open towards +X, 150 x 320 x 250; with bench and sign."""
    s.slab((-70, 70), (-155, 155), (238, 246), c)
    for y in (-150, 0, 150):
        s.slab((-68, -60), (y - 4, y + 4), (0, 238), c)
    s.slab((-66, -64), (-146, 146), (18, 226), (0.7, 0.82, 0.86), rough=0.05, alpha=0.4)
    for side in (-1, 1):
        s.slab(
            (-60, 30), mirrored(side, 149, 151), (18, 226), (0.7, 0.82, 0.86), rough=0.05, alpha=0.4
        )
        s.slab((26, 34), mirrored(side, 147, 153), (0, 238), c)
    s.slab((-56, -22), (-100, 60), (42, 47), WOOD)
    for y in (-90, 50):
        s.slab((-50, -28), (y - 3, y + 3), (0, 42), STEEL)
    s.rod(3, (62, 168, 0), (62, 168, 236), STEEL)
    s.slab((60, 64), (152, 184), (206, 250), YELLOW)
    s.proxy_slab((-68, -60), (-154, 154), (0, 238), 1.0)
    for side in (-1, 1):
        s.proxy_slab((-60, 34), mirrored(side, 147, 153), (0, 238), 0.6)
    s.proxy_slab((-70, 70), (-155, 155), (238, 246), 0.6)
    s.proxy_slab((-56, -22), (-100, 60), (0, 47), 0.3)
    s.proxy_slab((58, 66), (164, 172), (0, 206), 1.0)
    s.surface("bench", 47, (15, 74), (-39, -20))
    shift(s, 0, -14)


@builder("road_sign")
def road_sign(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "sign") -> None:
    """Direction sign or billboard facing +X."""
    if kind == "billboard":
        s.slab((-4, 8), (-180, 180), (180, 380), WHITE)
        s.slab((8, 9), (-172, 172), (188, 372), c)
        s.slab((9, 9.6), (-120, 40), (300, 340), WHITE)
        s.slab((9, 9.6), (-120, 110), (230, 262), YELLOW)
        for y in (-120, 120):
            s.slab((-14, -4), (y - 8, y + 8), (0, 360), STEEL)
            s.slab((-50, 20), (y - 20, y + 20), (0, 10), CONCRETE)
            s.proxy_slab((-50, 20), (y - 20, y + 20), (0, 10), 4.0)
            s.proxy_slab((-14, -4), (y - 8, y + 8), (10, 180), 1.0)
        s.proxy_slab((-14, 8), (-180, 180), (180, 380), 0.3)
        shift(s, 15)
        return
    s.rod(18, (0, 0, 0), (0, 0, 10), CONCRETE)
    s.rod(3, (0, 0, 8), (0, 0, 236), STEEL)
    s.extrude([(-46, 186), (40, 186), (58, 203), (40, 220), (-46, 220)], (3, 5), c, plane="yz")
    s.extrude(
        [(-41, 190), (38, 190), (52, 203), (38, 216), (-41, 216)], (5, 5.4), WHITE, plane="yz"
    )
    s.slab((5.4, 5.8), (-34, 30), (199, 207), c)
    s.proxy_cylinder(18, (0, 10), 14.0)
    s.proxy_cylinder(3.4, (10, 236), 1.0)
    s.proxy_slab((3, 6), (-46, 50), (186, 220), 0.5)
    shift(s, 0, -5)


@builder("parking")
def parking(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Car park with painted bays of 250 x 500; a decal."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.7), c, rough=1.0)
    n = max(1, int(L / 250))
    depth = min(500.0, W * 0.4)
    for k in range(n + 1):
        x = -L / 2 + 5 + (L - 10) * k / n
        for side in (-1, 1):
            s.slab((x - 5, x + 5), mirrored(side, W / 2 - depth, W / 2), (0, H), WHITE)
    s.surface("surface", 0.0, (L / 2, W / 2))


@builder("street_lamp")
def street_lamp(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Road lamp, the arm reaching forward, drawn at 160 x 36 x 600."""
    foot = (-62.0, 0.0, 0.0)
    base = [(17.4, 0), (18, 1), (18, 3), (12, 4.4), (11.4, 6), (11.4, 92), (10.6, 96), (8.6, 99)]
    s.add(lambda: forms.turned(base, foot, 32), c, of="paint", name="base")
    s.proxy(ProxyKind.CYLINDER, (18, 18, 15), (-62.0, 0, 15), 4, direction(foot, (-62.0, 0, 30))[0])
    s.add(
        lambda: forms.gather(
            [
                forms.turned([(1.5, 2.6), (1.5, 6.4)], (-62 + 14.6 * x, 14.6 * y, 0), 6)
                for x, y in ((0.71, 0.71), (-0.71, 0.71), (0.71, -0.71), (-0.71, -0.71))
            ]
        ),
        STEEL,
        name="anchor_bolts",
    )
    s.add(
        lambda: forms.cushion((2, 13, 34), (-51, 0, 58), plan=6, side=0.3, sections=20, levels=7),
        shade(c, 0.85),
        of="paint",
        name="door",
    )
    s.proxy_cylinder(7.5, (30, 585), 1.0, (-62.0, 0))

    def pole() -> Any:
        path = [
            (-62, 0, 90),
            (-62, 0, 300),
            (-62, 0, 500),
            (-60, 0, 548),
            (-48, 0, 580),
            (-20, 0, 591),
            (26, 0, 595),
        ]
        fine = forms.smooth_path(path, 40)
        reach = [0.0, 0.5, 0.8, 1.0]
        import numpy as np

        return forms.tube(fine, np.interp(np.linspace(0, 1, 40), reach, [8.0, 6.2, 4.4, 3.4]), 18)

    s.add(pole, c, of="paint", name="pole")
    s.add(
        lambda: forms.cushion(
            (62, 27, 8.4), (49, 0, 595.6), plan=3.4, side=0.6, sections=36, levels=11
        ),
        shade(c, 0.92),
        of="paint",
        name="luminaire",
    )
    s.add(
        lambda: forms.cushion((46, 20, 4), (53, 0, 591.8), plan=4, side=0.6, sections=30, levels=9),
        (1.0, 0.96, 0.82),
        of="lamp",
        name="lens",
    )
    s.proxy_slab((-62.0, 80), (-12, 12), (588, 600), 0.2)


@builder("traffic_light")
def traffic_light(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Signal on a pole, lights facing +X, drawn at 40 x 40 x 340."""
    s.add(
        lambda: forms.turned([(19, 0), (20, 1.4), (20, 10), (18.6, 12)], sections=40),
        CONCRETE,
        name="foot",
    )
    s.proxy(ProxyKind.CYLINDER, (20, 20, 6.0), (0, 0, 6.0), 5, direction((0, 0, 0), (0, 0, 12))[0])
    s.add(
        lambda: forms.turned(
            [(8, 12), (8, 13.6), (5.2, 14.6), (5, 16), (5, 334), (4, 336)], (-6, 0, 0), 28
        ),
        c,
        of="paint",
        name="pole",
    )
    s.proxy(
        ProxyKind.CYLINDER,
        (5, 5, 161.5),
        (-6.0, 0.0, 173.5),
        1,
        direction((-6, 0, 12), (-6, 0, 335))[0],
    )
    s.add(
        lambda: forms.cushion(
            (2, 39, 106), (-1.4, 0, 287), plan=14, side=0.3, sections=32, levels=7
        ),
        DARK,
        of="paint",
        name="backboard",
    )
    s.proxy_slab((-2, 16), (-16, 16), (240, 340), 0.5)
    s.add(
        lambda: forms.gather([forms.tube([(-6, 0, z), (1, 0, z)], 2.2, 12) for z in (254, 326)]),
        DARK,
        of="steel",
        name="brackets",
    )
    for z, tone, word in (
        (322, (0.86, 0.08, 0.07), "red"),
        (290, (0.95, 0.70, 0.08), "amber"),
        (258, (0.10, 0.62, 0.28), "green"),
    ):
        s.add(
            lambda z=z: forms.cushion(
                (15, 31, 31), (6.2, 0, z), plan=9, side=0.2, sections=32, levels=9
            ),
            DARK,
            of="plastic",
            name=f"housing_{word}",
        )
        s.add(
            lambda z=z: forms.turned(
                [(11, 13), (10.8, 15.4), (8, 16.8), (3, 17.4)], (0, 0, z), 32, "x"
            ),
            tone,
            of="lamp",
            name=f"light_{word}",
        )
        s.add(lambda z=z: _visor(z), DARK, of="plastic", name=f"visor_{word}")


def _visor(z: float) -> Any:
    """A hood over a light, open below."""
    import numpy as np

    around = np.radians(np.linspace(-20, 200, 24))
    rings = []
    for x, q in ((12.5, 12.4), (20.0, 12.0)):
        flat = np.full(24, x)
        out = np.c_[flat, q * np.cos(around), z + q * np.sin(around)]
        inn = np.c_[flat, (q - 0.7) * np.cos(around), z + (q - 0.7) * np.sin(around)]
        rings.append(np.concatenate([out, inn[::-1]]))
    return forms.loft(np.array(rings))
