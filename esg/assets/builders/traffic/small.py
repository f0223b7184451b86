"""Small things on wheels: toy cars and handcarts."""

from __future__ import annotations

from functools import lru_cache
import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.builders.traffic.coachwork import hull
from esg.assets.geometry.sketch import CHROME, DARK, RUBBER, STEEL, YELLOW, Color, Sketch, rgb
from esg.assets.lazy import forms, shapes


@lru_cache(maxsize=1)
def _toy() -> dict[str, Any]:
    from shapely.geometry import box

    bottom = ((8.0, 1.7), (7.4, 1.1), (6, 1.0), (-6, 1.0), (-7.4, 1.1), (-8.0, 1.7))
    top = (
        (8.0, 2.7),
        (7.4, 3.5),
        (6, 3.9),
        (4, 4.1),
        (0, 4.2),
        (-5, 4.2),
        (-7.2, 3.9),
        (-8.0, 2.9),
    )
    low = hull(6.8, bottom, top, 5.0, 4.0, 0.0)
    cab_top = (
        (4.4, 3.9),
        (3.6, 4.7),
        (2.4, 6.2),
        (1.2, 6.9),
        (-2.4, 7.0),
        (-4.0, 6.7),
        (-5.6, 5.2),
        (-6.2, 3.9),
    )
    cab = hull(6.0, tuple((x, 2.6) for x, _ in cab_top), cab_top, 7.0, 5.0, 0.0)
    side = [
        box(-4.6, 4.5, -1.0, 6.1).buffer(-0.3).buffer(0.3, quad_segs=3),
        box(-0.3, 4.5, 2.6, 6.1).buffer(-0.3).buffer(0.3, quad_segs=3),
    ]
    front = box(-2.2, 4.55, 2.2, 6.2).buffer(-0.35).buffer(0.35, quad_segs=3)
    glass = forms.fattened(cab, 0.06)
    panes = [m for shape in side for m in forms.prism(shape, (-5, 5))]
    panes += forms.prism(front, (2.0, 6), "yz") + forms.prism(front, (-8, -3.2), "yz")
    wells = [
        shapes.rod(2.0, (x, y0, 1.7), (x, y1, 1.7), 28)
        for x in (-5, 5)
        for y0, y1 in ((-5, -2.5), (2.5, 5))
    ]
    lamps = [
        m
        for y in (-2.2, 2.2)
        for m in forms.prism(
            box(y - 0.7, 2.1, y + 0.7, 3.3).buffer(-0.4).buffer(0.4, quad_segs=4), (6.5, 9), "yz"
        )
    ]
    return {
        "body": forms.carved(low, wells),
        "cabin": cab,
        "windows": forms.inlay(glass, panes),
        "headlights": forms.inlay(forms.fattened(low, 0.1), lamps),
        "grille": forms.inlay(
            forms.fattened(low, 0.06),
            forms.prism(
                box(-1.2, 1.9, 1.2, 2.7).buffer(-0.2).buffer(0.2, quad_segs=3), (7, 9), "yz"
            ),
        ),
    }


@builder("toy_car")
def toy_car(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Toy car, drawn at 16 x 8 x 7."""
    for name, tone, of in (
        ("body", c, "plastic_hard"),
        ("cabin", c, "plastic_hard"),
        ("windows", rgb(60, 84, 104), "plastic_hard"),
        ("headlights", YELLOW, "plastic_hard"),
        ("grille", DARK, "plastic_hard"),
    ):
        s.add(lambda name=name: forms.copied(_toy()[name]), tone, of=of, name=name)
    s.add(
        lambda: forms.gather(
            [
                forms.cushion((1.2, 6.4, 0.8), (x, 0, 1.6), plan=6, side=0.5, sections=20, levels=7)
                for x in (7.6, -7.6)
            ]
        ),
        shade(c, 0.5),
        of="plastic_hard",
        name="bumpers",
    )
    for x, row in ((-5, "rear"), (5, "front")):
        for y, side in ((-3.3, "right"), (3.3, "left")):
            _toy_wheel(s, (float(x), y, 1.7), f"{row}_{side}")
    s.proxy_slab((-8, 8), (-4, 4), (0, 4), 1.0)
    s.proxy_slab((-5, 3.6), (-3.2, 3.2), (4, 7), 0.5)


def _toy_wheel(s: Sketch, at: tuple[float, float, float], name: str) -> None:
    r, h = 1.7, 0.7
    tread = [(0.9, -h), (1.55, -h), (r, -0.72 * h), (r, 0.72 * h), (1.55, h), (0.9, h), (0.9, -h)]
    s.add(lambda: forms.turned(tread, at, 30, "y"), RUBBER, name=f"tyre_{name}")

    def hub() -> Any:
        out = [
            forms.turned([(0.95, -0.8 * h), (0.95, 0.8 * h), (0.5, 1.05 * h)], at, 24, "y"),
            forms.turned([(0.5, -1.05 * h), (0.95, -0.8 * h), (0.95, 0)], at, 24, "y"),
        ]
        for k in range(5):
            a = 2 * math.pi * k / 5
            p = (at[0] + 0.62 * math.cos(a), 0.0, at[2] + 0.62 * math.sin(a))
            out.append(
                shapes.rod(0.16, (p[0], at[1] - 1.12 * h, p[2]), (p[0], at[1] + 1.12 * h, p[2]), 10)
            )
        return forms.gather(out)

    s.add(hub, YELLOW, of="plastic_hard", name=f"hub_{name}")
    s.wheel(at, r, parts=2)


@builder("cart")
def cart(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flat handcart (dolly), drawn at 100 x 60 x 95."""
    for x, row in ((-38, "rear"), (38, "front")):
        for y, side in ((-22, "right"), (22, "left")):
            at = (float(x), float(y), 6.0)
            tread = [(1.6, -1.8), (5.2, -1.9), (6, -1.2), (6, 1.2), (5.2, 1.9), (1.6, 1.8)]
            s.add(
                lambda at=at, tread=tread: forms.turned(tread, at, 28, "y"),
                RUBBER,
                name=f"castor_{row}_{side}",
            )
            s.wheel(at, 6)
            s.add(lambda at=at: _bracket(at), STEEL, name=f"bracket_{row}_{side}")
    s.add(
        lambda: forms.cushion(
            (100, 60, 4.2), (0, 0, 14.2), plan=40, side=0.16, sections=40, levels=7
        ),
        c,
        of="paint",
        name="deck",
    )
    s.add(
        lambda: forms.cushion(
            (96, 56, 0.8), (0, 0, 16.6), plan=60, side=0.2, sections=40, levels=5
        ),
        shade(c, 0.55),
        of="rubber_floor",
        name="mat",
    )
    side = [(-46.6, 17.0), (-47.2, 36.0), (-47.9, 55.0), (-48.6, 72.0)]
    corner = [(-49.2, 25.6, 82.0), (-49.6, 23.2, 89.4), (-49.9, 17.0, 93.0), (-50.0, 8.0, 93.6)]
    half = [*((x, 26.0, z) for x, z in side), *corner]
    rail = [*half, *((x, -y, z) for x, y, z in reversed(half))]
    s.add(
        lambda: forms.tube(forms.smooth_path(rail, 60), 1.5, 14), CHROME, of="chrome", name="handle"
    )
    s.add(
        lambda: forms.gather(
            [forms.tube([(-48.3, -26, z), (-48.3, 26, z)], 1.0, 10) for z in (42, 66)]
        ),
        CHROME,
        name="cross_bars",
    )
    s.add(lambda: forms.tube([(-50, -14, 93.7), (-50, 14, 93.7)], 1.9, 14), RUBBER, name="grip")
    s.proxy_slab((-50, 50), (-30, 30), (12, 17))
    s.proxy_slab((-44, -32), (-24, 24), (0, 12), 0.6)
    s.proxy_slab((32, 44), (-24, 24), (0, 12), 0.6)
    s.proxy_slab((-50, -47), (-28, 28), (17, 95), 0.15)
    s.surface("deck", 17, (46, 28))


def _bracket(at: tuple[float, float, float]) -> Any:
    x, y, z = at
    out = [
        forms.cushion(
            (5, 0.6, 9), (x, y + q * 2.5, z + 2.6), plan=3, side=0.4, sections=12, levels=5
        )
        for q in (-1, 1)
    ]
    out.append(forms.cushion((10, 8, 0.9), (x, y, 12.0), plan=6, side=0.4, sections=20, levels=5))
    out.append(forms.turned([(0.8, -3.2), (0.8, 3.2)], at, 10, "y"))
    return forms.gather(out)
