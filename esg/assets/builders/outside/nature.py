"""Leaf, branch, iceberg and snowbank: what lies about outside and has no two sides alike."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import LEAF, shade, shift
from esg.assets.geometry.rotations import ALONG
from esg.assets.geometry.sketch import Color, Sketch, finish, rgb
from esg.assets.lazy import forms, shapes
from esg.graph.models import ProxyKind, Vec3


def _outline(t: float) -> float:
    """Half width along a leaf from stalk to tip, as a share of its widest."""
    return 2.75 * t**0.6 * (1 - t) ** 0.9


def _blade(length: float, width: float, thick: float, lift: float) -> Any:
    """A pointed leaf along X from the origin, its tip and its rims lifted."""
    import numpy as np

    rings = []
    for t in np.linspace(0.02, 0.985, 18):
        half = 0.5 * width * _outline(t) * (1 + 0.04 * math.sin(21 * t))
        mid = lift * (0.25 + (2 * t - 0.9) ** 2 * 0.6)
        y = np.array([-1, -0.5, 0, 0.5, 1, 0.5, 0, -0.5]) * max(half, 0.03)
        z = mid + 0.5 * lift * np.abs(y / (0.5 * width)) ** 1.4
        z += thick * np.array([0.5, 1, 1, 1, 0.5, 0, 0, 0])
        rings.append(np.c_[np.full(8, t * length), y, z])
    return forms.loft(np.array(rings))


@builder("leaf")
def leaf(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A green leaf with veins and a stalk, drawn at 10 x 6 x 0.9."""
    shift_x = -4.2
    s.add(
        lambda: _blade(8.6, 6.0, 0.09, 0.5).apply_translation((shift_x + 0.6, 0, 0.03)),
        c,
        of="leaves",
        name="blade",
    )

    def veins() -> Any:
        def height(x: float, y: float) -> float:
            t = (x - shift_x - 0.6) / 8.6
            rise = 0.5 * (0.25 + (2 * t - 0.9) ** 2 * 0.6)
            return 0.03 + rise + 0.25 * abs(y / 3.0) ** 1.4 + 0.09

        spine = [(x, 0.0, height(x, 0)) for x in (-3.4, -2, -0.5, 1, 2.5, 4, 4.8)]
        out = [forms.tube(spine, [0.13, 0.12, 0.11, 0.1, 0.08, 0.06, 0.04], 8)]
        for k in range(5):
            x = -2.6 + 1.25 * k
            reach = 0.72 * 3.0 * _outline((x + 1.0 - shift_x) / 8.6)
            for side in (-1, 1):
                path = [
                    (
                        x + f * 0.62 * reach,
                        side * f * reach,
                        height(x + f * 0.62 * reach, f * reach),
                    )
                    for f in (0.0, 0.5, 1.0)
                ]
                out.append(forms.tube(path, [0.07, 0.06, 0.035], 6))
        return forms.gather(out)

    s.add(veins, shade(c, 1.7), of="leaves", name="veins")
    stalk: list[Vec3] = [(shift_x - 0.8, 0.25, 0.12), (shift_x, 0.1, 0.2), (shift_x + 0.9, 0, 0.38)]
    s.add(lambda: forms.tube(stalk, 0.12, 8), shade(c, 0.8), of="leaves", name="stalk")
    s.proxy_slab((-4.6, 4.9), (-2.4, 2.4), (0, 0.7))


TWIGS = (
    (((-28, 0, 6), (-16, 9, 9), (-4, 18, 13), (6, 22, 17)), 1.5),
    (((-4, 1, 6.5), (10, -8, 8), (22, -17, 10), (30, -21, 15)), 1.3),
    (((18, 1, 8), (28, 8, 12), (38, 16, 15)), 1.0),
    (((34, 0, 9), (42, -7, 12), (50, -13, 16)), 0.9),
)
FOLIAGE = (
    (6, 22, 17), (-4, 18, 13), (30, -21, 15), (22, -17, 10), (38, 16, 15), (28, 8, 12),
    (50, -13, 16), (58, 2, 12), (46, 1, 10.5), (42, -7, 12),
)  # fmt: skip


@builder("branch")
def branch(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A branch broken off a tree, with twigs and leaves, drawn at 123 x 59 x 25."""
    bough = [
        (-60, -2, 4.2),
        (-44, 1, 4.4),
        (-28, 0, 5.4),
        (-10, 2, 5.8),
        (10, 0, 7),
        (34, 1, 9),
        (58, 2, 12),
    ]
    s.add(
        lambda: forms.tube(
            forms.smooth_path(bough, 36),
            [4.2 - 3.1 * k / 35 for k in range(36)],
            14,
            round_ends=False,
        ),
        c,
        of="bark",
        name="bough",
    )
    s.rod(3.6, (-60.6, -2.1, 4.2), (-59.8, -2, 4.2), rgb(222, 190, 140), of="wood", name="break")
    for k, (path, r) in enumerate(TWIGS):
        s.add(
            lambda path=path, r=r: forms.tube(
                forms.smooth_path(path, 14), [r * (1 - 0.05 * j) for j in range(14)], 10
            ),
            c,
            of="bark",
            name=f"twig_{k}",
        )
    s.add(_foliage, LEAF, name="leaves")
    s.proxy(ProxyKind.CYLINDER, (4.2, 4.2, 36), (-24, 0, 4.2), 1.0, ALONG["x"])
    s.proxy_hull([(12, -3, 4), (12, 3, 4), (12, 0, 9), (60, -2, 8), (60, 2, 8), (60, 0, 13)], 0.7)
    s.proxy_hull([(-28, -1, 4), (-28, 2, 4), (-28, 0, 8), (8, 20, 0), (8, 24, 0), (6, 22, 20)], 0.2)
    s.proxy_hull(
        [(-4, 2, 4), (-4, -2, 4), (-4, 0, 8), (30, -19, 0), (30, -23, 0), (30, -21, 18)], 0.2
    )


def _foliage() -> Any:
    import numpy as np

    rng = np.random.default_rng(3)
    leaves = []
    for x, y, z in FOLIAGE:
        for _ in range(5):
            blade = _blade(10.0, 5.2, 0.25, 0.8)
            a, tilt = rng.uniform(-2.2, 2.2), rng.uniform(-0.3, 0.7)
            c, n, ct, nt = math.cos(a), math.sin(a), math.cos(tilt), math.sin(tilt)
            turn = [[c * ct, -n, -c * nt, x], [n * ct, c, -n * nt, y], [nt, 0, ct, z], [0, 0, 0, 1]]
            leaves.append(blade.apply_transform(turn))
    return forms.gather(leaves)


ICE: dict[str, tuple[Vec3, ...]] = {
    "shelf": (
        (-700, -160, 0), (-640, 300, 0), (-420, -470, 0), (-260, 500, 0), (140, -540, 0),
        (330, 520, 0), (640, -330, 0), (740, 120, 0), (-640, -130, 90), (-560, 260, 110),
        (-360, -400, 70), (-200, 430, 120), (120, -470, 80), (300, 450, 90), (560, -260, 110),
        (640, 120, 130),
    ),
    "peak": (
        (-420, -260, 60), (-380, 260, 60), (0, -380, 60), (40, 360, 60), (330, -220, 60),
        (300, 240, 60), (-330, -120, 330), (-300, 150, 420), (-40, -280, 390), (60, 260, 350),
        (230, -120, 430), (210, 130, 520), (-160, -60, 690), (-110, 90, 760), (10, 10, 800),
        (110, 40, 660),
    ),
    "spire": (
        (200, -300, 60), (640, -240, 60), (660, 120, 60), (260, 160, 60), (300, -220, 330),
        (560, -190, 260), (560, 60, 300), (340, 100, 380), (400, -110, 540), (450, -40, 500),
    ),
    "table": (
        (-640, -120, 60), (-580, 250, 60), (-330, -380, 60), (-200, 300, 60), (-560, -100, 300),
        (-510, 210, 250), (-360, -290, 270), (-260, 240, 310), (-470, -40, 350),
    ),
    "block": (
        (-160, -470, 60), (200, -480, 60), (-120, -250, 60), (240, -250, 60), (-120, -400, 190),
        (130, -410, 240), (-90, -250, 260), (180, -240, 250),
    ),
}  # fmt: skip


@builder("iceberg", drawn=(1440, 1060, 800))
def iceberg(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A jagged iceberg of several crags, drawn at 1440 x 1060 x 800."""
    tones = (0.8, 1.0, 0.95, 0.91, 0.97)
    for (name, points), tone in zip(ICE.items(), tones, strict=True):
        color = shade(c, tone)
        s.add(
            lambda points=points: shapes.hull(points),
            finish("ice", (color[0] if tone > 0.9 else 0.9 * color[0], color[1], color[2])),
            rough=0.5,
            name=name,
        )
        s.proxy_hull(points, 1.0)
    shift(s, -20, 20)


@builder("snowbank")
def snowbank(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A long heap of snow, drawn at 300 x 160 x 80."""

    def heap() -> Any:
        import numpy as np

        rings = []
        for t in np.linspace(-0.995, 0.995, 34):
            span = (1 - abs(t) ** 2.6) ** 0.55
            wide = 78 * span * (1 + 0.07 * math.sin(7 * t + 1))
            high = 72 * span * (1 + 0.14 * math.sin(9 * t) + 0.07 * math.sin(17 * t + 2))
            a = np.linspace(0, math.pi, 25)
            lumps = 1 + 0.05 * np.sin(5 * a + 8 * t) + 0.03 * np.sin(11 * a - 13 * t)
            y, z = wide * np.cos(a) * lumps, high * np.sin(a) ** 0.9 * lumps
            rings.append(np.c_[np.full(25, 150 * t), y, np.maximum(z, 0)])
        return forms.loft(np.array(rings))

    s.add(heap, c, of="snow", name="heap")

    def clods() -> Any:
        import numpy as np

        rng = np.random.default_rng(4)
        lumps = []
        for _ in range(26):
            x, side = rng.uniform(-125, 125), rng.choice((-1, 1))
            r = rng.uniform(4, 10)
            y = side * 80 * (1 - abs(x / 150) ** 2.6) ** 0.55 * rng.uniform(0.82, 0.93)
            lumps.append(shapes.ball(r, (x, y, 0.5 * r + 4), (1.1, 1, 0.8), 2))
        return forms.gather(lumps)

    s.add(clods, shade(c, 0.95), of="snow", name="clods")
    points = []
    for t in (-0.97, -0.7, -0.3, 0.1, 0.5, 0.8, 0.97):
        span = (1 - abs(t) ** 2.6) ** 0.55
        points += [(150 * t, y * 78 * span, 0) for y in (-1, 1)]
        points += [(150 * t, y * 66 * span, 40 * span) for y in (-1, 1)]
        points.append((150 * t, 0, 74 * span))
    s.proxy_hull(points)
