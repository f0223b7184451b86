"""Bottles, tableware and what is cooked with."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.collider import lying_hull
from esg.assets.geometry.sketch import DARK, DARK_WOOD, STEEL, YELLOW, Color, Sketch, rgb
from esg.assets.lazy import forms

PAPER = rgb(240, 236, 224)


_WINE = [
    (1.2, 0.9),
    (2.6, 0.35),
    (3.1, 0.0),
    (3.5, 0.15),
    (3.7, 0.7),
    (3.7, 14.6),
    (3.62, 15.8),
    (3.3, 17.2),
    (2.7, 18.5),
    (2.05, 19.7),
    (1.62, 21.0),
    (1.45, 22.4),
    (1.38, 26.6),
]
_BEER = [
    (1.2, 0.7),
    (2.6, 0.3),
    (3.1, 0.0),
    (3.5, 0.15),
    (3.7, 0.7),
    (3.7, 13.4),
    (3.55, 15.0),
    (3.1, 16.8),
    (2.4, 19.0),
    (1.9, 21.4),
    (1.6, 23.6),
    (1.5, 25.6),
    (1.5, 26.6),
]


def _glass_bottle(s: Sketch, c: Color, style: str) -> None:
    """A bottle of tinted glass with its drink, a label, and a capsule or crown cap."""
    beer = style == "beer"
    outer = _BEER if beer else _WINE
    inner = [(max(r - 0.28, 0.9), z + (0.5 if z < 1 else 0)) for r, z in outer if z < 22]
    s.add(lambda: forms.turned(outer, sections=44), c, of="glass", alpha=0.78, name="bottle")
    s.add(
        lambda: forms.turned(inner, sections=32),
        shade(c, 0.35),
        of="water",
        alpha=1.0,
        name="drink",
    )
    low, high = (5.0, 11.6) if beer else (4.2, 12.2)
    label = [(3.66, low), (3.75, low), (3.75, high), (3.66, high), (3.66, low)]
    s.add(lambda: forms.turned(label, sections=44), PAPER, of="paper", name="label")
    band = [
        (3.7, low + 0.9),
        (3.77, low + 0.9),
        (3.77, low + 2.2),
        (3.7, low + 2.2),
        (3.7, low + 0.9),
    ]
    tone = rgb(176, 40, 36) if beer else rgb(120, 26, 40)
    s.add(lambda: forms.turned(band, sections=44), tone, of="paper", name="label_band")
    if beer:
        crimps = [(1.62, 26.4), (1.72, 26.7), (1.62, 27.4), (1.2, 28.0)]
        s.add(lambda: _fluted(crimps, 21, 0.06), YELLOW, of="steel", name="crown_cap")
        s.add(
            lambda: forms.turned(
                [(1.45, 25.4), (1.72, 25.7), (1.72, 26.3), (1.45, 26.5)], sections=28
            ),
            c,
            of="glass",
            alpha=0.9,
            name="lip",
        )
    else:
        s.add(
            lambda: forms.turned(
                [(1.46, 22.6), (1.5, 26.3), (1.66, 26.5), (1.66, 27.3), (1.55, 28.0)], sections=32
            ),
            rgb(90, 20, 30),
            of="aluminium",
            name="capsule",
        )


def _fluted(profile: list[tuple[float, float]], count: int, depth: float) -> Any:
    """A turned cap whose lower edge is crimped."""
    import numpy as np

    turn = 2 * math.pi * np.arange(4 * count) / (4 * count)
    rings = []
    for k, (r, z) in enumerate(profile):
        q = r + depth * np.cos(count * turn) * (1 - k / (len(profile) - 1))
        rings.append(np.c_[q * np.cos(turn), q * np.sin(turn), np.full(len(turn), z)])
    return forms.loft(np.array(rings))


def _plastic_bottle(s: Sketch, c: Color) -> None:
    """A ribbed bottle of clear plastic with a screw cap and a wrap-around label."""
    ribs = [(3.7 - (0.22 if k % 2 else 0.0), 2.4 + 0.62 * k) for k in range(6)]
    ribs += [(3.7 - (0.22 if k % 2 else 0.0), 14.2 + 0.62 * k) for k in range(6)]
    outer = [
        (1.4, 1.0),
        (2.2, 0.4),
        (2.9, 0.0),
        (3.4, 0.3),
        (3.7, 1.4),
        *ribs,
        (3.6, 18.6),
        (3.1, 21),
        (2.2, 23.4),
        (1.4, 24.6),
        (1.3, 25.6),
    ]
    s.add(lambda: forms.turned(outer, sections=40), c, of="glass", alpha=0.5, name="bottle")
    s.add(
        lambda: forms.turned(
            [(1.3, 1.2), (3.2, 1.0), (3.45, 2), (3.45, 18), (2.9, 20.6)], sections=28
        ),
        rgb(196, 222, 232),
        of="water",
        alpha=0.6,
        name="water",
    )
    s.add(
        lambda: forms.turned(
            [(3.72, 6.6), (3.78, 6.6), (3.78, 13.2), (3.72, 13.2), (3.72, 6.6)], sections=40
        ),
        rgb(40, 96, 176),
        of="paper",
        name="label",
    )
    s.add(
        lambda: forms.turned([(1.7, 24.7), (1.75, 25.2), (1.4, 25.3)], sections=28),
        c,
        of="plastic_hard",
        name="collar",
    )
    s.add(
        lambda: _fluted([(1.55, 25.4), (1.55, 27.4), (1.3, 28.0)], 24, 0.05),
        rgb(40, 96, 176),
        of="plastic_hard",
        name="cap",
    )


@builder("bottle", drawn=(7.4, 7.4, 28.0))
def bottle(s: Sketch, L: float, W: float, H: float, c: Color, style: str = "wine") -> None:
    """Bottle, drawn at 7.4 x 7.4 x 28; body, shoulder and neck are stacked cylinders."""
    if style == "plastic":
        _plastic_bottle(s, c)
    else:
        _glass_bottle(s, c, style)
    s.proxy_cylinder(3.7, (0, 16.5))
    s.proxy_cylinder(2.7, (16.5, 20.5), 0.8)
    s.proxy_cylinder(1.5, (20.5, 28), 0.8)


@builder("mug")
def mug(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Mug, handle at +Y, drawn at 8.4 x 11.8 x 9.5 and centred on its box."""
    y = -1.7
    cup = [
        (2.6, 0.35),
        (3.0, 0.0),
        (3.7, 0.1),
        (4.1, 0.6),
        (4.2, 1.4),
        (4.2, 9.0),
        (4.15, 9.4),
        (4.0, 9.5),
        (3.85, 9.35),
        (3.8, 8.8),
        (3.8, 1.6),
        (3.5, 1.0),
        (2.4, 0.9),
    ]
    s.add(lambda: forms.turned(cup, (0, y, 0), 44), c, of="ceramic", name="mug")
    arc = [
        (0, y + 3.9, 8.2),
        (0, y + 5.4, 8.3),
        (0, y + 6.9, 7.0),
        (0, y + 7.2, 5.0),
        (0, y + 6.5, 3.0),
        (0, y + 5.2, 1.9),
        (0, y + 3.9, 2.0),
    ]
    s.add(
        lambda: forms.tube(forms.smooth_path(arc, 26), 0.55, 14, round_ends=False),
        c,
        of="ceramic",
        name="handle",
    )
    s.tub(4.2, (0, 9.5), 0.5)
    s.proxies[:] = [
        p.model_copy(
            update={"position_cm": (p.position_cm[0], p.position_cm[1] + y, p.position_cm[2])}
        )
        for p in s.proxies
    ]
    s.proxy_slab((-0.6, 0.6), (y + 4.1, y + 7.4), (2, 8), 0.5)
    s.region("inside", (-2.4, 2.4), (y - 2.4, y + 2.4), (0.9, 9.5))


def _glaze(s: Sketch) -> str:
    """Ceramic, or what else the thing is of."""
    return "ceramic" if s.material in ("ceramic", "plastic_hard") else s.material


@builder("plate", "free")
def plate(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Dinner plate."""
    r = min(L, W) / 2
    dish = [
        (0.5 * r, H * 0.1),
        (0.54 * r, 0),
        (0.6 * r, 0),
        (0.63 * r, H * 0.1),
        (0.8 * r, H * 0.46),
        (0.985 * r, H * 0.84),
        (r, H * 0.93),
        (0.99 * r, H),
        (0.95 * r, H * 0.97),
        (0.72 * r, H * 0.66),
        (0.64 * r, H * 0.5),
        (0.58 * r, H * 0.41),
        (0.2 * r, H * 0.38),
    ]
    s.add(lambda: forms.turned(dish, sections=64), c, of=_glaze(s), name="plate")
    ring = [
        (0.9 * r, H * 0.9),
        (0.93 * r, H * 0.945),
        (0.928 * r, H * 0.98),
        (0.898 * r, H * 0.94),
        (0.9 * r, H * 0.9),
    ]
    s.add(lambda: forms.turned(ring, sections=64), shade(c, 0.62), of=_glaze(s), name="rim_line")
    s.proxy_cylinder(r * 0.62, (0, H * 0.45))
    s.proxy_cylinder(r * 0.95, (H * 0.45, H))
    s.surface("top", H, (r * 0.6, r * 0.6))


@builder("bowl")
def bowl(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bowl, drawn at 16 x 16 x 7; hollow."""
    wall = [
        (3.0, 0.5),
        (3.3, 0.0),
        (3.9, 0.0),
        (4.05, 0.7),
        (5.4, 1.5),
        (6.7, 2.9),
        (7.5, 4.8),
        (7.95, 6.8),
        (7.9, 7.0),
        (7.7, 6.98),
        (7.3, 5.1),
        (6.4, 3.4),
        (5.0, 2.1),
        (3.4, 1.35),
        (1.2, 1.1),
    ]
    s.add(lambda: forms.turned(wall, sections=56), c, of=_glaze(s), name="bowl")
    s.tub(6.0, (0, 4), 1.0)
    for k in range(8):
        angle = 2 * math.pi * k / 8
        from esg.assets.geometry.rotations import turn

        s.proxy_box(
            (0.5, 2.9, 1.5),
            (6.6 * math.cos(angle), 6.6 * math.sin(angle), 5.5),
            1.0,
            turn("z", 45.0 * k),
        )
    s.region("inside", (-4, 4), (-4, 4), (1, 7))


@builder("tray", "free")
def tray(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Serving tray with a rim."""
    t = H * 0.3
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, t), c, rough=0.4)
    for x in (-1, 1):
        s.slab(
            (L / 2 - t, L / 2) if x > 0 else (-L / 2, -L / 2 + t),
            (-W / 2, W / 2),
            (0, H),
            shade(c, 0.9),
        )
        s.slab(
            (-L / 2, L / 2),
            (W / 2 - t, W / 2) if x > 0 else (-W / 2, -W / 2 + t),
            (0, H),
            shade(c, 0.9),
        )
    s.walls((-L / 2, L / 2), (-W / 2, W / 2), (0, H), t)
    s.surface("floor", t, (L / 2 - 2 * t, W / 2 - 2 * t))
    s.region("inside", (-L / 2 + t, L / 2 - t), (-W / 2 + t, W / 2 - t), (t, H))


@builder("pan")
def pan(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Frying pan, handle at -X, drawn at 48 x 28 x 5 and centred on its box."""
    x = 10.0
    s.lathe([(0, 0), (11, 0), (14, 5), (13.6, 5), (10.8, 0.6), (0, 0.6)], c, center=(x, 0, 0))
    s.rod(1.0, (-24, 0, 4), (x - 13.4, 0, 3.6), DARK)
    s.proxy_cylinder(12.5, (0, 5), 1.0, (x, 0))
    s.proxy_slab((-24, x - 12.5), (-1, 1), (2.8, 4.8), 1.0)
    s.only_weighs()
    s.tub(12.9, (0, 5), 0.8, sides=12, xy=(x, 0))
    s.proxy_slab((-24, x - 12.5), (-1, 1), (2.8, 4.8))
    s.region("inside", (x - 8, x + 8), (-8, 8), (0.8, 5))
    s.surface("floor", 0.8, (7, 7), (x, 0))


@builder("knife", "free")
def knife(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flat cutlery along X: blade forward."""
    s.extrude(
        [(-0.05 * L, -0.4 * W), (0.5 * L, -0.4 * W), (0.42 * L, 0.3 * W), (-0.05 * L, 0.4 * W)],
        (H * 0.3, H * 0.7),
        STEEL,
        plane="xy",
        rough=0.2,
    )
    s.slab((-L / 2, -0.05 * L), (-W / 2, W / 2), (0, H), c)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))


@builder("fruit")
def fruit(s: Sketch, L: float, W: float, H: float, c: Color, stem: bool = True) -> None:
    """Round fruit; a sphere."""
    r = H / 2
    s.ball(r, (0, 0, r), c, solid=1, rough=0.4, detail=4)
    if stem:
        s.rod(r * 0.06, (0, 0, 1.9 * r), (0, 0, 2 * r + r * 0.02), DARK_WOOD, sections=8)


@builder("egg")
def egg(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Egg lying along X, drawn at 5.8 x 4.4 x 4.4."""
    profile = [
        (2.2 * math.cos(t) * (1 - 0.09 * math.sin(t)), 2.9 * math.sin(t))
        for t in (math.radians(v) for v in range(-90, 91, 10))
    ]
    s.lathe(profile, c, center=(0, 0, 2.2), axis="x", rough=0.5)
    s.proxy_hull(lying_hull([(x, q) for q, x in profile[::2]], 2.2, 12))
