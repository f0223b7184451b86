"""Boxes, crates, barrels and other containers; open ones are hollow."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import edge, shade
from esg.assets.geometry.sketch import CHROME, DARK, STEEL, WHITE, Color, Sketch, rgb
from esg.assets.lazy import forms, shapes


def _arrows(L: float, W: float, H: float, d: float) -> Any:
    """Two arrows that point up, printed on the side faces."""
    from shapely.geometry import Polygon

    u = 0.05 * min(L, H)
    out = []
    for x in (-L * 0.32, -L * 0.32 + 3 * u):
        shape = Polygon(
            [
                (x + a * u, H * 0.18 + b * u)
                for a, b in (
                    (-0.35, 0),
                    (0.35, 0),
                    (0.35, 2.2),
                    (1, 2.2),
                    (0, 3.6),
                    (-1, 2.2),
                    (-0.35, 2.2),
                )
            ]
        )
        for y in ((W / 2, W / 2 + d), (-W / 2 - d, -W / 2)):
            out += forms.prism(shape, y)
    return forms.gather(out)


@builder("carton", "free")
def carton(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Closed cardboard box with tape."""
    s.box((L, W, H), (0, 0, H / 2), c, solid=1, name="box")
    d = 0.0016 * max(L, W, H)
    gap = (-0.004 * W, 0.004 * W)
    s.slab((-L / 2, L / 2), gap, (H, H + 0.2 * d), shade(c, 0.45), of="cardboard", name="flap_gap")
    tape = rgb(206, 178, 128) if max(c) < 0.85 else rgb(190, 150, 96)
    wide, down = (-W * 0.07, W * 0.07), H * 0.22
    s.slab((-L / 2 - d, L / 2 + d), wide, (H, H + d), tape, of="plastic_hard", name="tape_top")
    for x, side in ((-1, "rear"), (1, "front")):
        span = (L / 2, L / 2 + d) if x > 0 else (-L / 2 - d, -L / 2)
        s.slab(span, wide, (H - down, H + d), tape, of="plastic_hard", name=f"tape_{side}")
    s.slab(
        (L / 2, L / 2 + d),
        (W * 0.14, W * 0.42),
        (H * 0.2, H * 0.5),
        WHITE,
        of="paper",
        name="label",
    )
    s.slab(
        (L / 2 + d, L / 2 + 1.3 * d),
        (W * 0.18, W * 0.38),
        (H * 0.25, H * 0.32),
        DARK,
        of="paper",
        name="barcode",
    )
    for k in (0.37, 0.42):
        s.slab(
            (L / 2 + d, L / 2 + 1.3 * d),
            (W * 0.18, W * 0.34),
            (H * k, H * (k + 0.018)),
            DARK,
            of="paper",
            name="address",
        )
    s.add(lambda: _arrows(L, W, H, d), shade(c, 0.32), of="paint", name="this_side_up")
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


def _planks(L: float, W: float, H: float, t: float, odd: int) -> Any:
    """Every second board of all six faces, a little apart."""
    out = []
    n = max(3, round(H / (0.2 * min(L, W, H))))
    for k in range(odd, n, 2):
        z0, z1 = H * k / n, H * (k + 1) / n
        z = ((z0 + z1) / 2, (z1 - z0) * 0.96)
        for x in (-1, 1):
            out.append(shapes.box((t, W - t, z[1]), (x * (L / 2 - t), 0, z[0])))
            out.append(shapes.box((L - t, t, z[1]), (0, x * (W / 2 - t), z[0])))
    m = max(3, round(W / (0.2 * min(L, W, H))))
    for k in range(odd, m, 2):
        y = -W / 2 + W * (k + 0.5) / m
        for z in (t, H - t):
            out.append(shapes.box((L - t, 0.96 * W / m, t), (0, y, z)))
    return forms.gather(out)


def _battens(L: float, W: float, H: float, b: float, t: float) -> Any:
    """Boards around the edges of a crate."""
    out = []
    for x in (-1, 1):
        for y in (-1, 1):
            out.append(shapes.box((t, b, H), (x * (L / 2 - t / 2), y * (W / 2 - b / 2), H / 2)))
            out.append(
                shapes.box((b, t, H), (x * (L / 2 - b / 2 - t * 0.02), y * (W / 2 - t / 2), H / 2))
            )
        for z in (b / 2, H - b / 2):
            out.append(shapes.box((t, W - 2 * b, b), (x * (L / 2 - t / 2), 0, z)))
            out.append(shapes.box((L - 2 * b, t, b), (0, x * (W / 2 - t / 2), z)))
        for z in (t / 2, H - t / 2):
            out.append(shapes.box((b, W - 2 * t, t), (x * (L / 2 - b / 2 - t), 0, z)))
    return forms.gather(out)


def _nails(L: float, W: float, H: float, b: float) -> Any:
    """Heads of nails in the corners of a crate's faces."""
    out, r = [], 0.09 * b
    for x in (-1, 1):
        for y in (-1, 1):
            for z in (0.3 * b, 0.7 * b, H - 0.7 * b, H - 0.3 * b):
                e = 0.12 * r
                out.append(
                    forms.turned([(r, -e), (r, e)], (x * L / 2, y * (W / 2 - b / 2), z), 8, "x")
                )
                out.append(
                    forms.turned([(r, -e), (r, e)], (x * (L / 2 - b / 2), y * W / 2, z), 8, "y")
                )
    return forms.gather(out)


@builder("crate", "free")
def crate(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Closed wooden crate with battens."""
    t = min(L, W, H) * 0.05
    batten, b = shade(c, 0.82), min(L, W, H) * 0.13
    s.slab(
        (-L / 2 + 1.6 * t, L / 2 - 1.6 * t),
        (-W / 2 + 1.6 * t, W / 2 - 1.6 * t),
        (1.6 * t, H - 1.6 * t),
        shade(c, 0.3),
        name="inside",
    )
    s.add(lambda: _planks(L, W, H, t, 0), c, name="planks")
    s.add(lambda: _planks(L, W, H, t, 1), shade(c, 0.92), name="planks_dark")
    s.add(lambda: _battens(L, W, H, b, t), batten, name="battens")
    for x, word in ((-1, "rear"), (1, "front")):
        face = edge(x, L, t)
        s.extrude(
            [(-W / 2 + b, b), (-W / 2 + b * 2.0, b), (W / 2 - b, H - b), (W / 2 - b * 2.0, H - b)],
            face,
            batten,
            plane="yz",
            name=f"brace_{word}",
        )
        face = edge(x, W, t)
        s.extrude(
            [(-L / 2 + b, b), (-L / 2 + b * 2.0, b), (L / 2 - b, H - b), (L / 2 - b * 2.0, H - b)],
            face,
            batten,
            name="brace_left" if x > 0 else "brace_right",
        )
    s.add(lambda: _nails(L, W, H, b), STEEL, name="nails")
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


def _belly(z: float) -> float:
    """Radius of a barrel of 88 cm at a height [cm]."""
    return 29.7 - 5.5 * ((z - 44) / 44) ** 2


def _staves() -> Any:
    """Twenty staves, each a little rounded, with grooves between them."""
    import numpy as np

    n, per = 20, 4
    turn = 2 * math.pi * np.arange(n * per) / (n * per)
    groove = np.where(np.arange(n * per) % per == 0, 0.55, 0.0)
    rings = []
    for z in np.linspace(0, 88, 13):
        r = _belly(float(z)) - groove
        rings.append(np.c_[r * np.cos(turn), r * np.sin(turn), np.full(len(turn), z)])
    inner = [(q * np.ones_like(turn), z) for q, z in ((22.6, 88.0), (22.4, 84.4))]
    top = [np.c_[r * np.cos(turn), r * np.sin(turn), np.full(len(turn), z)] for r, z in inner]
    low = [np.c_[r * np.cos(turn), r * np.sin(turn), np.full(len(turn), 88 - z)] for r, z in inner]
    return forms.loft(np.array([*low[::-1], *rings, *top]))


@builder("barrel")
def barrel(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wooden barrel with hoops, drawn at 60 x 60 x 88; two cylinders bound its belly."""
    s.add(_staves, c, name="staves")
    s.add(
        lambda: forms.gather(
            [forms.turned([(22.6, z), (22.6, z + 2.2)], sections=48) for z in (2.2, 83.6)]
        ),
        shade(c, 0.8),
        name="heads",
    )
    for k, z in enumerate((3, 16, 27, 57, 68, 80)):
        low, high = _belly(z), _belly(z + 5)
        hoop = [(low - 1, z), (low + 0.5, z), (high + 0.5, z + 5), (high - 1, z + 5), (low - 1, z)]
        s.add(
            lambda hoop=hoop: forms.turned(hoop, sections=56),
            rgb(70, 70, 74),
            of="steel",
            name=f"hoop_{k + 1}",
        )
    s.add(
        lambda: forms.turned([(2.0, 29.3), (2.0, 30.2)], (0, 0, 44), 16, "x"),
        shade(c, 0.6),
        of="cork",
        name="bung",
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
        s.rod(H * 0.008, (-L * 0.3, y, top), (-L * 0.3, y, H * 0.985), CHROME, sections=10)
    s.rod(H * 0.015, (-L * 0.3, -W * 0.2, H * 0.985), (-L * 0.3, W * 0.2, H * 0.985), DARK)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, top))
    s.surface("top", top, (L * 0.45, W * 0.45))


def _flank(r: float, H: float, z: float) -> float:
    """Radius of a basket at a height."""
    return r * (0.80 + 0.16 * (z / H) ** 0.8)


def _weave(r: float, H: float, odd: int) -> Any:
    """Every second withy, in and out of the stakes."""
    import numpy as np

    rows, stakes, count = 9, 22, 66
    thick = 0.46 * H / rows
    turn = 2 * math.pi * np.arange(count) / count
    out = []
    for k in range(odd, rows, 2):
        z = thick + k * (0.95 * H - 2 * thick) / (rows - 1)
        wave = (0.9 * thick) * np.cos(turn * stakes / 2 + (math.pi if odd else 0))
        q = _flank(r, H, z) - thick + wave * 0.7
        path = np.c_[q * np.cos(turn), q * np.sin(turn), np.full(count, z)]
        out.append(forms.tube(path, thick, 5, closed=True))
    return forms.gather(out)


def _stakes(r: float, H: float) -> Any:
    out = []
    for k in range(22):
        a = 2 * math.pi * (k + 0.5) / 22
        path = [
            (
                (_flank(r, H, z) - 0.04 * H) * math.cos(a),
                (_flank(r, H, z) - 0.04 * H) * math.sin(a),
                z,
            )
            for z in (0.01 * H, 0.5 * H, 0.95 * H)
        ]
        out.append(forms.tube(path, 0.018 * H, 6))
    return forms.gather(out)


def _braid(r: float, H: float) -> Any:
    import numpy as np

    turn = 2 * math.pi * np.arange(72) / 72
    out = []
    for phase in (0.0, 2 * math.pi / 3, 4 * math.pi / 3):
        q = r * 0.955 + 0.028 * r * np.cos(turn * 14 + phase)
        z = H * 0.962 + 0.02 * H * np.sin(turn * 14 + phase)
        out.append(
            forms.tube(np.c_[q * np.cos(turn), q * np.sin(turn), z], 0.019 * H, 5, closed=True)
        )
    return forms.gather(out)


@builder("basket", "free")
def basket(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Woven open basket; hollow."""
    r = min(L, W) / 2
    t = r * 0.08
    s.add(lambda: _weave(r, H, 0), c, name="weave")
    s.add(lambda: _weave(r, H, 1), shade(c, 0.84), name="weave_dark")
    s.add(lambda: _stakes(r, H), shade(c, 0.7), name="stakes")
    s.add(lambda: _braid(r, H), shade(c, 0.92), name="rim")
    s.add(
        lambda: forms.turned([(r * 0.8, 0), (r * 0.8, t)], sections=36), shade(c, 0.8), name="floor"
    )
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
        s.slab((L / 2, L / 2 + 0.4), (y - 2, y + 2), (top * 0.6, top * 0.8), CHROME)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, top * 0.78))
    s.proxy_slab((-L * 0.34, L * 0.34), (-W / 2, W / 2), (top * 0.78, top), 0.8)
    s.surface("top", top, (L * 0.3, W * 0.45))


@builder("shipping_container", "free")
def shipping_container(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Corrugated freight container along X, doors at +X."""
    s.slab((-L / 2 + 3, L / 2 - 3), (-W / 2 + 3, W / 2 - 3), (5, H - 2), c, rough=0.6)
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
        s.rod(2, (L / 2 - 2, y, 10), (L / 2 - 2, y, H - 8), STEEL)
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
        s.slab((-L / 2 - 0.3, L / 2 + 0.3), (y - W * 0.03, y + W * 0.03), (0, low), STEEL)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, low))
    s.proxy_hull([(x, y * W / 2, z) for x, z in lid[::2] for y in (-1, 1)], 0.7)
