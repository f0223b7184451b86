"""Boxes, crates, barrels and other containers; open ones are hollow."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import edge, shade
from esg.assets.geometry.sketch import CARDBOARD, CHROME, DARK, STEEL, WHITE, Color, Sketch


@builder("carton", "free")
def carton(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Closed cardboard box with tape."""
    s.box((L, W, H), (0, 0, H / 2), c, solid=1, rough=0.9)
    s.slab(
        (-L / 2 - 0.05, L / 2 + 0.05),
        (-W * 0.08, W * 0.08),
        (H - H * 0.2, H + 0.05),
        shade(c, 1.15) if max(c) < 0.85 else CARDBOARD,
    )
    s.slab((L / 2, L / 2 + 0.06), (W * 0.15, W * 0.4), (H * 0.2, H * 0.5), WHITE)
    s.surface("top", H, (L / 2, W / 2))


@builder("open_box", "free")
def open_box(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Box without a lid; hollow."""
    t = max(0.4, min(L, W, H) * 0.03)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, t), c, rough=0.9)
    for x in ((-L / 2, -L / 2 + t), (L / 2 - t, L / 2)):
        s.slab(x, (-W / 2, W / 2), (0, H), c, rough=0.9)
    for y in ((-W / 2, -W / 2 + t), (W / 2 - t, W / 2)):
        s.slab((-L / 2, L / 2), y, (0, H), c, rough=0.9)
    s.walls((-L / 2, L / 2), (-W / 2, W / 2), (0, H), max(t, min(1.0, H * 0.05)))
    s.region("inside", (-L / 2 + t, L / 2 - t), (-W / 2 + t, W / 2 - t), (t, H))
    s.surface("floor", max(t, min(1.0, H * 0.05)), (L / 2 - 2 * t, W / 2 - 2 * t))


@builder("crate", "free")
def crate(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Closed wooden crate with battens."""
    t = min(L, W, H) * 0.05
    s.slab((-L / 2 + t, L / 2 - t), (-W / 2 + t, W / 2 - t), (t, H - t), c, rough=0.85)
    batten, b = shade(c, 0.8), min(L, W, H) * 0.14
    for x in (-1, 1):
        for y in (-1, 1):
            s.slab(edge(x, L, b), edge(y, W, b), (0, H), batten, rough=0.85)
        for z in ((0, b), (H - b, H)):
            s.slab(edge(x, L, b), (-W / 2 + b, W / 2 - b), z, batten, rough=0.85)
            s.slab((-L / 2 + b, L / 2 - b), edge(x, W, b), z, batten, rough=0.85)
    for x in (-1, 1):
        face = edge(x, L, t)
        s.extrude(
            [(-W / 2 + b, b), (-W / 2 + b * 2.1, b), (W / 2 - b, H - b), (W / 2 - b * 2.1, H - b)],
            face,
            batten,
            plane="yz",
        )
        face = edge(x, W, t)
        s.extrude(
            [(-L / 2 + b, b), (-L / 2 + b * 2.1, b), (L / 2 - b, H - b), (L / 2 - b * 2.1, H - b)],
            face,
            batten,
        )
    s.slab((-L / 2 + t, L / 2 - t), (-W / 2 + t, W / 2 - t), (H - t, H), c, rough=0.85)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("barrel")
def barrel(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wooden barrel with hoops, drawn at 60 x 60 x 88; two cylinders bound its belly."""
    s.lathe(
        [(0, 0), (24, 0), (28.5, 22), (30, 44), (28.5, 66), (24, 88), (0, 88)],
        c,
        smooth=40,
        rough=0.8,
    )
    for z in (8, 26, 60, 78):
        r = 30 - 6 * ((z - 44) / 44) ** 2
        s.lathe(
            [(r - 1, z), (r + 0.3, z), (r + 0.3, z + 4), (r - 1, z + 4), (r - 1, z)],
            STEEL,
            metal=0.6,
        )
    s.proxy_cylinder(25, (0, 12))
    s.proxy_cylinder(29.5, (12, 76))
    s.proxy_cylinder(25, (76, 88))
    s.surface("top", 88, (16, 16))


@builder("pallet")
def pallet(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Euro pallet, drawn at 120 x 80 x 14.4."""
    for k, w in enumerate((14.5, 10, 14.5, 10, 14.5)):
        y = (-32.75, -15, 0, 15, 32.75)[k]
        s.slab((-60, 60), (y - w / 2, y + w / 2), (12.2, 14.4), c, rough=0.9)
    for x in (-52.75, 0, 52.75):
        s.slab((x - 7.25, x + 7.25), (-40, 40), (10, 12.2), c, rough=0.9)
        for y in (-35, 0, 35):
            s.slab((x - 7.25, x + 7.25), (y - 5, y + 5), (2.2, 10), shade(c, 0.9), rough=0.9)
    for y in (-35, 0, 35):
        s.slab((-60, 60), (y - 5, y + 5), (0, 2.2), c, rough=0.9)
    # Solid to the bottom: it would sink between the tines of the fork that carries it.
    s.proxy_slab((-60, 60), (-40, 40), (0, 14.4))
    s.surface("top", 14.4, (60, 40))


@builder("suitcase", "free")
def suitcase(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Upright trolley case with ribs and a handle; thin along X."""
    wheel, top = H * 0.045, H * 0.91
    s.slab((-L / 2 + 0.5, L / 2 - 0.5), (-W / 2, W / 2), (wheel, top), c, rough=0.35)
    for k in range(7):
        y = -W * 0.42 + W * 0.84 * k / 6
        s.slab(
            (-L / 2, L / 2),
            (y - W * 0.02, y + W * 0.02),
            (wheel + H * 0.03, top - H * 0.03),
            shade(c, 0.85),
            rough=0.35,
        )
    for x in (-L * 0.34, L * 0.34):
        for y in (-W * 0.38, W * 0.38):
            s.box((wheel * 1.6, wheel * 1.2, wheel), (x, y, wheel / 2), DARK)
    for y in (-W * 0.18, W * 0.18):
        s.rod(
            H * 0.008, (-L * 0.3, y, top), (-L * 0.3, y, H * 0.985), CHROME, metal=0.8, sections=10
        )
    s.rod(H * 0.015, (-L * 0.3, -W * 0.2, H * 0.985), (-L * 0.3, W * 0.2, H * 0.985), DARK)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, top))
    s.surface("top", top, (L * 0.45, W * 0.45))


@builder("basket", "free")
def basket(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Woven open basket; hollow."""
    r = min(L, W) / 2
    t = r * 0.08
    for k in range(9):
        f = 0.82 + 0.18 * (k + 1) / 9
        z = H * (k + 0.5) / 9
        s.torus(r * f - H / 22, H / 20, (0, 0, z), c if k % 2 else shade(c, 0.85), rough=0.95)
    s.lathe([(0, 0), (r * 0.8, 0), (r * 0.8, t), (0, t)], shade(c, 0.8))
    s.tub(r * 0.95, (0, H), t)
    h = r * 0.6
    s.region("inside", (-h, h), (-h, h), (t, H))
    s.surface("floor", t, (h * 0.9, h * 0.9))


@builder("toolbox", "free")
def toolbox(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Closed tool box with a handle; long along Y."""
    top = H * 0.82
    s.extrude(
        [
            (-L / 2, 0),
            (L / 2, 0),
            (L / 2, top * 0.75),
            (L * 0.3, top),
            (-L * 0.3, top),
            (-L / 2, top * 0.75),
        ],
        (-W / 2, W / 2),
        c,
        rough=0.4,
    )
    s.pipe(
        H * 0.04,
        [(0, -W * 0.2, top), (0, -W * 0.18, H * 0.96), (0, W * 0.18, H * 0.96), (0, W * 0.2, top)],
        DARK,
    )
    for y in (-W * 0.25, W * 0.25):
        s.slab((L / 2, L / 2 + 0.4), (y - 2, y + 2), (top * 0.6, top * 0.8), CHROME, metal=0.7)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, top * 0.78))
    s.proxy_slab((-L * 0.34, L * 0.34), (-W / 2, W / 2), (top * 0.78, top), 0.8)
    s.surface("top", top, (L * 0.3, W * 0.45))


@builder("shipping_container", "free")
def shipping_container(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Corrugated freight container along X, doors at +X."""
    s.slab((-L / 2 + 3, L / 2 - 3), (-W / 2 + 3, W / 2 - 3), (5, H - 2), c, rough=0.6, metal=0.2)
    n = 24
    for k in range(n):
        x = -L / 2 + 12 + (L - 24) * (k + 0.25) / n
        for y in (-1, 1):
            s.slab((x, x + (L - 24) / n / 2), edge(y, W, 3.5), (14, H - 10), c, rough=0.6)
    for x in (-1, 1):
        for y in (-1, 1):
            s.slab(edge(x, L, 12), edge(y, W, 12), (0, H), shade(c, 0.8))
    for z in ((0, 14), (H - 10, H)):
        for y in (-1, 1):
            s.slab((-L / 2, L / 2), edge(y, W, 6), z, shade(c, 0.8))
    for y in (-W * 0.3, -W * 0.12, W * 0.12, W * 0.3):
        s.rod(2, (L / 2 - 2, y, 10), (L / 2 - 2, y, H - 8), STEEL, metal=0.6)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("trunk", "free")
def trunk(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Chest with a curved lid; long along Y."""
    low = H * 0.62
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, low), c, rough=0.7)
    lid = [
        (L / 2 * math.cos(t), low + (H - low) * math.sin(t))
        for t in (math.pi * k / 16 for k in range(17))
    ]
    s.extrude(lid, (-W / 2, W / 2), shade(c, 0.9), rough=0.7)
    for y in (-W * 0.4, 0, W * 0.4):
        s.slab(
            (-L / 2 - 0.3, L / 2 + 0.3), (y - W * 0.03, y + W * 0.03), (0, low), STEEL, metal=0.6
        )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, low))
    s.proxy_hull([(x, y * W / 2, z) for x, z in lid[::2] for y in (-1, 1)], 0.7)
