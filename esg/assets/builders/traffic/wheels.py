"""Two-wheelers and small things on wheels."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.builders.living.riders import ridden
from esg.assets.builders.traffic.cycles import draw_bicycle, draw_motorcycle, draw_scooter
from esg.assets.geometry.sketch import CHROME, RUBBER, STEEL, Color, Sketch
from esg.assets.lazy import forms, shapes


@builder("bicycle")
def bicycle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """City bicycle on its kickstand, drawn at 175 x 58 x 106."""
    draw_bicycle(s, c)
    ridden(s, "bicycle")
    s.proxy_slab((-87.5, 87.5), (-4, 4), (12, 66), 1.0)
    s.proxy_slab((-42, 40), (-4, 4), (66, 97), 0.7)
    s.proxy_slab((16, 38), (-29, 29), (97, 104), 0.5)
    # Wheels' contact points and the kickstand span this foot.
    s.proxy_slab((-58, 58), (-13, 13), (0, 12), 0.4)
    s.surface("saddle", 97, (8, 8), (-28, 0))


@builder("motorcycle")
def motorcycle(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Naked motorcycle on its stand, drawn at 210 x 80 x 112."""
    draw_motorcycle(s, c)
    ridden(s, "motorcycle")
    s.proxy_slab((-104, 104), (-9, 9), (14, 64), 1.0)
    s.proxy_slab((-92, 50), (-14, 14), (64, 92), 0.8)
    s.proxy_slab((20, 48), (-39, 39), (92, 106), 0.2)
    s.proxy_slab((-76, 78), (-22, 22), (0, 14), 0.5)
    s.surface("seat", 92, (22, 10), (-34, 0))


def _truck(x: float) -> Any:
    out = [forms.cushion((8.6, 5.6, 1.0), (x, 0, 7.7), plan=6, side=0.3, sections=16, levels=5)]
    out.append(forms.tube([(x - 2.4, 0, 7.4), (x, 0, 4.4)], [2.0, 1.5], 12))
    out.append(forms.tube([(x, -5.2, 3.2), (x, 0, 3.8), (x, 5.2, 3.2)], [1.0, 1.6, 1.0], 12))
    out.append(forms.tube([(x, -9, 3), (x, 9, 3)], 0.5, 10))
    return forms.gather(out)


def _bearing(at: tuple[float, float, float]) -> Any:
    """A hub with five balls, so that one sees it turn."""
    x, y, z = at
    out = [forms.turned([(0.9, -1.95), (0.9, 1.95)], at, 16, "y")]
    for k in range(5):
        a = 2 * math.pi * k / 5
        p = (x + 1.7 * math.cos(a), z + 1.7 * math.sin(a))
        out.append(shapes.rod(0.42, (p[0], y - 1.86, p[1]), (p[0], y + 1.86, p[1]), 8))
    return forms.gather(out)


@builder("skateboard")
def skateboard(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Skateboard, drawn at 80 x 20 x 12."""

    def board(low: float, high: float, inset: float) -> Any:
        """The deck between two heights above its underside, nose and tail turned up."""
        import numpy as np

        x = np.linspace(-1, 1, 41)
        half = (10 - inset) * (1 - np.abs(x) ** 9) ** (1 / 3)
        half = np.maximum(half, 1.6)
        rise = 9.0 + 2.6 * np.clip((np.abs(x) - 0.66) / 0.34, 0, 1) ** 1.6
        across = np.linspace(-1, 1, 9)
        rings = []
        for u, w, z in zip(x * (40 - inset), half, rise, strict=True):
            dish = z + 0.35 * across**2
            under = np.c_[np.full(9, u), across * w, dish + low]
            rings.append(np.concatenate([under, np.c_[under[:, :2], dish + high][::-1]]))
        return forms.loft(np.array(rings))

    s.add(lambda: board(-1.0, 0.0, 0), c, of="plywood", name="deck")
    s.add(lambda: board(-0.1, 0.12, 0.4), shade(c, 0.72), of="rubber_floor", name="grip_tape")
    for x, row in ((-21, "rear"), (21, "front")):
        s.add(lambda x=x: _truck(x), STEEL, of="aluminium", name=f"truck_{row}")
        for y, side in ((-9.4, "right"), (5.8, "left")):
            at = (x, y + 1.8, 3.0)
            tread = [(1.0, -1.6), (2.6, -1.8), (3, -1.2), (3, 1.2), (2.6, 1.8), (1.0, 1.6)]
            s.add(
                lambda at=at, tread=tread: forms.turned(tread, at, 26, "y"),
                (0.93, 0.9, 0.8),
                of="rubber_hard",
                name=f"wheel_{row}_{side}",
            )
            s.add(lambda at=at: _bearing(at), STEEL, name=f"bearing_{row}_{side}")
            s.wheel(at, 3, parts=2)
    s.proxy_slab((-40, 40), (-10, 10), (7, 10))
    for x in (-21, 21):
        s.proxy_slab((x - 3, x + 3), (-9.4, 9.4), (0, 7))
    s.surface("deck", 10, (28, 9))


def _fork(at: tuple[float, float, float]) -> Any:
    x, y, z = at
    out = [
        forms.cushion(
            (3.4, 0.5, 10), (x + 0.4, y + q * 2.0, z + 3.2), plan=3, side=0.5, sections=10, levels=5
        )
        for q in (-1, 1)
    ]
    out.append(
        forms.turned([(1.3, z + 7.6), (2.4, z + 8.2), (2.4, z + 9.2), (1.3, z + 11)], (x, y, 0), 14)
    )
    return forms.gather(out)


def _wires() -> Any:
    """The mesh of a trolley's basket: wider and longer at its rim."""
    z0, z1 = 42.0, 84.0
    out = []

    def corner(t: float, x: int, y: int) -> tuple[float, float, float]:
        front, back, half = 38 + 7 * t, -34 - 7 * t, 19 + 6 * t
        return (front if x > 0 else back, half * y, z0 + (z1 - z0) * t)

    for t, radius in (
        (0.0, 0.6),
        (0.17, 0.3),
        (0.34, 0.3),
        (0.5, 0.3),
        (0.67, 0.3),
        (0.84, 0.3),
        (1.0, 0.8),
    ):
        loop = [corner(t, x, y) for x, y in ((1, -1), (1, 1), (-1, 1), (-1, -1))]
        for a, b in zip(loop, loop[1:] + loop[:1], strict=True):
            out.append(forms.tube([a, b], radius, 6))
    for k in range(1, 15):
        u = k / 15
        for y in (-1, 1):
            low, high = (
                [p + (q - p) * u for p, q in zip(corner(t, 1, y), corner(t, -1, y), strict=True)]
                for t in (0.0, 1.0)
            )
            out.append(forms.tube([low, high], 0.26, 5, round_ends=False))
        low = [p + (q - p) * u for p, q in zip(corner(0, 1, -1), corner(0, -1, -1), strict=True)]
        out.append(forms.tube([low, (low[0], -low[1], low[2])], 0.26, 5, round_ends=False))
    for k in range(1, 9):
        u = k / 9
        for x in (-1, 1):
            low, high = (
                [p + (q - p) * u for p, q in zip(corner(t, x, -1), corner(t, x, 1), strict=True)]
                for t in (0.0, 1.0)
            )
            out.append(forms.tube([low, high], 0.26, 5, round_ends=False))
        a, b = (
            [p + (q - p) * u for p, q in zip(corner(0, x, -1), corner(0, x, 1), strict=True)]
            for x in (-1, 1)
        )
        out.append(forms.tube([a, b], 0.26, 5, round_ends=False))
    return forms.gather(out)


@builder("shopping_cart")
def shopping_cart(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wire trolley with an open basket, drawn at 95 x 58 x 102."""
    for x, w, row in ((36, 14, "front"), (-38, 26, "rear")):
        for y, side in ((-w, "right"), (w, "left")):
            at = (x, y, 6.0)
            tread = [(1.2, -1.4), (5.2, -1.5), (6, -0.9), (6, 0.9), (5.2, 1.5), (1.2, 1.4)]
            s.add(
                lambda at=at, tread=tread: forms.turned(tread, at, 26, "y"),
                RUBBER,
                name=f"castor_{row}_{side}",
            )
            s.wheel(at, 6)
            s.add(lambda at=at: _fork(at), STEEL, name=f"castor_fork_{row}_{side}")
    for y, side in ((-1, "right"), (1, "left")):
        rail = [
            (42, 14 * y, 17),
            (36, 15 * y, 16.4),
            (-34, 25.6 * y, 16.4),
            (-39, 26 * y, 20),
            (-40, 26 * y, 60),
            (-44, 26 * y, 92),
            (-47, 26 * y, 99),
        ]
        s.add(
            lambda rail=rail: forms.tube(forms.smooth_path(rail, 40), 1.25, 12),
            CHROME,
            name=f"frame_{side}",
        )
    s.add(
        lambda: forms.tube([(-46.5, -28, 99.6), (-46.5, 28, 99.6)], 1.9, 16),
        c,
        of="plastic_hard",
        name="handle",
    )
    s.add(
        lambda: forms.gather(
            [forms.tube([(x, -w, 16.6), (x, w, 16.6)], 0.9, 10) for x, w in ((30, 16), (-30, 25))]
        ),
        CHROME,
        name="cross_bars",
    )
    s.add(_wires, CHROME, name="basket")
    s.add(
        lambda: forms.cushion(
            (1.4, 40, 17), (-39.4, 0, 74), plan=6, side=0.3, sections=20, levels=5
        ),
        c,
        of="plastic_hard",
        name="child_seat",
    )
    z0, z1 = 42.0, 84.0
    s.walls((-42, 46), (-26, 26), (z0 - 1, z1), 2.0, 1.0)
    s.proxy_slab((-46, 44), (-28, 28), (0, 18), 1.4)
    s.proxy_slab((-40, 38), (-6, 6), (18, z0 - 1), 0.3)
    s.proxy_slab((-48, -44), (-28, 28), (96, 102), 0.5)
    s.surface("basket floor", z0 + 1, (30, 17))
    s.region("inside", (-40, 44), (-24, 24), (z0 + 1, z1))


@builder("scooter")
def scooter(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Kick scooter, drawn at 100 x 45 x 100."""
    draw_scooter(s, c)
    ridden(s, "scooter")
    s.proxy_slab((-48, 50), (-11, 11), (0, 12), 1.0)
    s.proxy_slab((24, 40), (-3, 3), (12, 95), 0.4)
    s.proxy_slab((23, 29), (-22, 22), (95, 100), 0.4)
    s.surface("deck", 12, (20, 7), (-8, 0))
