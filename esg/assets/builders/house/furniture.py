"""Furniture. Fronts face +X: one sits at a desk or opens a cabinet from +X."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import edge, shade
from esg.assets.geometry.rotations import direction
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    DARK_WOOD,
    WHITE,
    Color,
    Sketch,
)
from esg.assets.lazy import forms, shapes
from esg.graph.models import ProxyKind


def _leg(foot: tuple[float, float], top: tuple[float, float], z: float, t: float) -> Any:
    """A square leg that tapers towards its foot, its corners rounded."""
    import numpy as np

    ring = forms.superellipse(16, 7.0) * 0.5
    rings = []
    for u, w in ((0.0, 0.62), (0.02, 0.66), (0.72, 0.98), (1.0, 1.0)):
        x, y = (a + (b - a) * u for a, b in zip(foot, top, strict=True))
        rings.append(np.c_[ring * w * t + [x, y], np.full(16, z * u)])
    return forms.loft(np.array(rings))


def _legs(
    s: Sketch,
    L: float,
    W: float,
    z: float,
    t: float,
    c: Color,
    inset: float = 0.0,
    density: float = 0.7,
) -> None:
    for x, row in ((-1, "rear"), (1, "front")):
        for y, side in ((-1, "right"), (1, "left")):
            across, along = edge(x, L - 2 * inset, t), edge(y, W - 2 * inset, t)
            at = ((across[0] + across[1]) / 2, (along[0] + along[1]) / 2)
            s.add(lambda at=at: _leg(at, at, z, t), c, name=f"leg_{row}_{side}")
            s.proxy_slab(across, along, (0, z), density)


def _board(
    x: tuple[float, float],
    y: tuple[float, float],
    z: tuple[float, float],
    corner: float = 9.0,
    side: float = 0.14,
) -> Any:
    """A flat board with rounded corners and rims."""
    size = (x[1] - x[0], y[1] - y[0], z[1] - z[0])
    at = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2)
    return forms.cushion(size, at, plan=corner, side=side, sections=40, levels=7)


@builder("table", "free")
def table(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Rectangular table on four legs with an apron."""
    t = max(1.5, H * 0.045)
    leg = max(2.0, min(L, W) * 0.07)
    top = ((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H))
    s.add(lambda: _board(*top, corner=40.0), c, name="top")
    s.proxy_slab(*top, 1)
    _legs(s, L, W, H - t, leg, shade(c, 0.85), inset=min(L, W) * 0.03)
    a = min(L, W) * 0.06
    for y in (-1, 1):
        s.slab(
            (-L / 2 + 2 * a, L / 2 - 2 * a),
            edge(y, W - 2 * a, 2),
            (H - t - H * 0.09, H - t),
            shade(c, 0.9),
            name="apron_left" if y > 0 else "apron_right",
        )
    for x in (-1, 1):
        s.slab(
            edge(x, L - 2 * a, 2),
            (-W / 2 + 2 * a, W / 2 - 2 * a),
            (H - t - H * 0.09, H - t),
            shade(c, 0.9),
            name="apron_front" if x > 0 else "apron_rear",
        )
    s.surface("top", H, (L / 2, W / 2))


def _disc(s: Sketch, r: float, z: tuple[float, float], density: float) -> None:
    """The proxy of an upright rod: stored scenes have the quaternion of one, signs of zeros too."""
    quat, length = direction((0, 0, z[0]), (0, 0, z[1]))
    s.proxy(ProxyKind.CYLINDER, (r, r, length / 2), (0.0, 0.0, (z[0] + z[1]) / 2), density, quat)


@builder("round_table", "free")
def round_table(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round table on a central column."""
    r = min(L, W) / 2
    t = max(1.5, H * 0.04)
    rim = [
        (r * 0.9, H - t),
        (r - 0.2 * t, H - 0.94 * t),
        (r, H - 0.6 * t),
        (r, H - 0.3 * t),
        (r - 0.2 * t, H),
    ]
    s.add(lambda: forms.turned(rim, sections=64), c, name="top")
    _disc(s, r, (H - t, H), 1)
    column = [
        (r * 0.2, 2.6),
        (r * 0.15, 5),
        (r * 0.085, H * 0.2),
        (r * 0.11, H * 0.36),
        (r * 0.12, H * 0.44),
        (r * 0.08, H * 0.56),
        (r * 0.085, H * 0.8),
        (r * 0.2, H - t),
    ]
    s.add(
        lambda: forms.turned(forms.smooth_path(column, 30), sections=36),
        shade(c, 0.85),
        name="column",
    )
    foot = [(r * 0.62, 0), (r * 0.62, 1.6), (r * 0.58, 2.6), (r * 0.2, 3.2)]
    s.add(lambda: forms.turned(foot, sections=48), shade(c, 0.8), name="foot")
    _disc(s, r * 0.62, (0, 3), 2)
    s.proxy_cylinder(r * 0.11, (3, H - t), 1.0)
    s.surface("top", H, (r * 0.7, r * 0.7))


@builder("desk", "free")
def desk(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Office desk with a drawer pedestal; the knee side faces +X."""
    t = 2.8
    top = ((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H))
    s.add(lambda: _board(*top, corner=60.0), c, name="top")
    s.proxy_slab(*top, 1)
    side = min(3.0, W * 0.03)
    pale = shade(c, 0.9)
    s.slab(
        (-L / 2 + 2, L / 2 - 2), (-W / 2, -W / 2 + side), (0, H - t), pale, solid=0.8, name="side"
    )
    ped = min(42.0, W * 0.3)
    y0 = W / 2 - ped
    s.slab((-L / 2 + 2, L / 2 - 4), (y0, W / 2), (0, H - t), pale, solid=0.5, name="pedestal")
    back = (-L / 2 + 2, -L / 2 + 4)
    s.slab(back, (-W / 2 + side, y0), (H * 0.35, H - t), shade(c, 0.85), solid=0.8, name="back")
    front = L / 2 - 2.4
    for k in range(3):
        z0, z1 = H * (0.06 + 0.3 * k), H * (0.34 + 0.3 * k)
        s.slab((front - 1.6, front), (y0 + 1, W / 2 - 1), (z0, z1), c, name=f"drawer_{3 - k}")
        ends = (y0 + ped * 0.28, y0 + ped * 0.72)
        z = z1 - 0.055 * H
        grip = [(front - 0.5, ends[0], z), (front + 1.6, ends[0], z), (front + 1.6, ends[1], z)]
        grip.append((front - 0.5, ends[1], z))
        s.add(lambda p=grip: forms.tube(p, 0.55, 12), CHROME, name=f"handle_{3 - k}")
    s.add(
        lambda: forms.turned(
            [(2.6, H - 0.2), (3.0, H), (3.0, H + 0.06)], (-0.3 * L, 0.1 * W, 0), 24
        ),
        DARK,
        name="cable_outlet",
    )
    s.surface("top", H, (L / 2, W / 2))


def _back_post(y: float) -> Any:
    import numpy as np

    path = forms.smooth_path(
        [(-24.6, y, 0), (-21.6, y, 22), (-20.6, y, 44), (-21.8, y, 66), (-24.4, y, 87.6)], 14
    )
    ring = forms.superellipse(14, 5.0) * 1.9
    wide = np.interp(np.linspace(0, 1, 14), [0, 0.45, 1], [0.85, 1.1, 0.75])
    return forms.loft(
        np.array(
            [np.c_[ring * w + p[:2], np.full(14, p[2])] for p, w in zip(path, wide, strict=True)]
        )
    )


def _slat(x: float, z: float, width: float, high: float) -> Any:
    """A slat of a back, bowed backwards across Y."""
    import numpy as np

    across = np.linspace(-0.5, 0.5, 13)
    ring = forms.superellipse(14, 4.0) * [0.8, high / 2]
    return forms.loft(
        np.array(
            [
                np.c_[
                    ring[:, 0] + x - 1.8 * (1 - 4 * v * v), np.full(14, v * width), ring[:, 1] + z
                ]
                for v in across
            ]
        )
    )


@builder("chair")
def chair(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Dining chair, drawn at 50 x 44 x 88; one sits facing +X."""
    s.add(
        lambda: forms.cushion((46, 44, 3.4), (2, 0, 44.3), plan=7, side=0.3, sections=36, levels=9),
        c,
        name="seat",
    )
    s.proxy_slab((-21, 25), (-22, 22), (43, 46), 1)
    for y, side in ((-20, "right"), (20, "left")):
        s.add(lambda y=y: _leg((22.6, y * 1.02), (21.5, y), 43, 4.2), c, name=f"leg_front_{side}")
        s.proxy_slab((20, 24), (y - 2, y + 2), (0, 43), 1)
        s.add(lambda y=y: _back_post(y), c, name=f"post_{side}")
        s.proxy_slab((-24, -20), (y - 2, y + 2), (0, 43))
        s.add(
            lambda y=y: forms.tube([(-21, y, 21), (22, y, 21)], 1.1, 12),
            shade(c, 0.92),
            name=f"stretcher_{side}",
        )
    s.add(
        lambda: forms.tube([(0, -19.6, 21), (0, 19.6, 21)], 1.1, 12),
        shade(c, 0.92),
        name="stretcher",
    )
    for k, z in enumerate((60, 70, 81)):
        s.add(
            lambda z=z, k=k: _slat(-22.4 - 0.07 * (z - 60), z, 36.6, 6.4 if k < 2 else 9.0),
            c,
            name=f"slat_{k + 1}",
        )
    s.proxy_slab((-25, -21), (-22, 22), (46, 88), 0.5)
    s.surface("seat", 46, (20, 20), (2, 0))


def _star() -> Any:
    out = [forms.turned([(4.6, 7.5), (5.2, 10), (4, 13)], sections=24)]
    for k in range(5):
        a = 2 * math.pi * k / 5
        x, y = math.cos(a), math.sin(a)
        out.append(
            forms.tube(
                [(2 * x, 2 * y, 10.6), (14 * x, 14 * y, 10.2), (28.4 * x, 28.4 * y, 7.2)],
                [3.0, 2.4, 1.7],
                12,
            )
        )
    return forms.gather(out)


def _castors() -> Any:
    out = []
    for k in range(5):
        a = 2 * math.pi * k / 5
        x, y = 28 * math.cos(a), 28 * math.sin(a)
        for q in (-1.5, 1.5):
            out.append(
                forms.turned(
                    [(1, -0.9), (2.7, -0.9), (3, -0.4), (3, 0.4), (2.7, 0.9), (1, 0.9)],
                    (x, y + q, 3),
                    14,
                    "y",
                )
            )
        out.append(forms.cushion((4.6, 5, 3.2), (x, y, 5), plan=3, side=0.6, sections=10, levels=5))
    return forms.gather(out)


def _back_rest() -> Any:
    """A padded back that follows a spine and wraps around a little."""
    import numpy as np

    z = np.linspace(56, 110, 15)
    x = np.interp(z, [56, 66, 80, 96, 110], [-24.4, -22.8, -24.2, -26.8, -29.4])
    wide = forms.profile([(56, 15), (62, 20), (76, 22.4), (96, 21.6), (106, 18.6), (110, 12)])(z)
    ring = forms.superellipse(32, 3.4)
    rings = []
    for u, v, w in zip(x, z, wide, strict=True):
        y = ring[:, 0] * w
        rings.append(np.c_[u + ring[:, 1] * 2.6 + 0.006 * y**2, y, np.full(32, v)])
    return forms.loft(np.array(rings))


@builder("office_chair")
def office_chair(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Swivel chair on five castors, drawn at 64 x 64 x 110."""
    s.add(_star, DARK, of="plastic", name="base")
    s.add(_castors, DARK, of="plastic_hard", name="castors")
    s.add(
        lambda: forms.turned([(3.6, 9), (3.6, 26), (3.0, 27), (1.8, 27.4), (1.8, 47)], sections=24),
        CHROME,
        name="gas_spring",
    )
    s.proxy(ProxyKind.CYLINDER, (3, 3, 19.0), (0, 0, 27.0), 1, direction((0, 0, 8), (0, 0, 46))[0])
    s.add(
        lambda: forms.cushion((22, 20, 3), (0, 0, 46.4), plan=5, side=0.4, sections=20, levels=7),
        DARK,
        name="mechanism",
    )
    s.add(
        lambda: forms.cushion(
            (53, 50, 8), (0.5, 0, 50.2), plan=4.2, side=0.42, sections=40, levels=13
        ),
        c,
        of="textile",
        name="seat",
    )
    s.add(_back_rest, c, of="textile", name="backrest")
    s.add(
        lambda: forms.tube(
            forms.smooth_path([(-14, 0, 46.5), (-26, 0, 48), (-29.5, 0, 58), (-28.5, 0, 74)], 14),
            2.4,
            14,
            flat=1.8,
        ),
        DARK,
        name="spine",
    )
    for y, side in ((-27, "right"), (27, "left")):
        s.add(
            lambda y=y: forms.tube(
                forms.smooth_path(
                    [(0, y * 0.7, 47.5), (1, y * 0.92, 48.5), (2, y, 54), (2, y, 67)], 14
                ),
                1.7,
                12,
            ),
            DARK,
            name=f"arm_{side}",
        )
        s.add(
            lambda y=y: forms.cushion(
                (27, 8, 3.4), (2, y, 68.4), plan=4, side=0.5, sections=24, levels=9
            ),
            DARK,
            of="foam",
            name=f"armrest_{side}",
        )
    s.proxy_cylinder(30, (0, 9), 1.5)
    s.proxy_slab((-26, 26), (-25, 25), (46, 54), 1.0)
    s.proxy_slab((-31, -23), (-22, 22), (56, 110), 0.4)
    s.surface("seat", 54, (22, 20))


def _pad(
    x: tuple[float, float], y: tuple[float, float], z: tuple[float, float], plan: float, side: float
) -> Any:
    """An upholstered block."""
    size = (x[1] - x[0], y[1] - y[0], z[1] - z[0])
    at = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2)
    return forms.cushion(size, at, plan=plan, side=side, sections=28, levels=9)


def _lean_pad(x: float, y: tuple[float, float], z: tuple[float, float], thick: float) -> Any:
    """A loose cushion that leans on the back at `x`."""
    import numpy as np

    high = z[1] - z[0]
    mesh = forms.cushion(
        (high, y[1] - y[0], thick), (0, 0, 0), plan=5, side=0.6, sections=32, levels=11
    )
    a = math.radians(78)
    v = np.asarray(mesh.vertices)
    out = np.c_[
        v[:, 0] * -math.cos(a) + v[:, 2] * math.sin(a),
        -v[:, 1],
        v[:, 0] * math.sin(a) + v[:, 2] * math.cos(a),
    ]
    place = (x + 0.32 * thick + 0.1 * high, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2)
    mesh.vertices = np.add(out, place)
    return mesh


@builder("armchair", "free")
def armchair(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Upholstered seat with arms for one or more; faces +X."""
    arm, back, seat = min(20.0, W * 0.18), L * 0.24, H * 0.5
    t = max(min(L, W) * 0.06, 1e-3)
    for x, row in ((-1, "rear"), (1, "front")):
        for y, word in ((-1, "right"), (1, "left")):
            at = (x * (L * 0.47 - t), y * (W * 0.47 - t))
            s.add(lambda at=at: _leg(at, at, H * 0.12, t), DARK_WOOD, name=f"foot_{row}_{word}")
    s.add(
        lambda: _pad((-L / 2, L / 2), (-W / 2, W / 2), (H * 0.1, H * 0.34), 24, 0.12),
        shade(c, 0.9),
        name="frame",
    )
    for y, word in ((-1, "right"), (1, "left")):
        across = edge(y, W, arm)
        s.add(
            lambda across=across: _pad(
                (-L / 2, L / 2 - 0.01 * L), across, (H * 0.3, H * 0.68), 6, 0.3
            ),
            c,
            name=f"arm_{word}",
        )
    s.add(
        lambda: _pad(
            (-L / 2, -L / 2 + back), (-W / 2 + 0.6 * arm, W / 2 - 0.6 * arm), (H * 0.3, H), 9, 0.25
        ),
        c,
        name="back",
    )
    n = max(1, round((W - 2 * arm) / 65))
    step = (W - 2 * arm) / n
    for k in range(n):
        y = -W / 2 + arm + k * step
        gap = 0.008 * step
        s.add(
            lambda y=y, gap=gap: _pad(
                (-L / 2 + back, L / 2), (y + gap, y + step - gap), (H * 0.31, seat), 7, 0.38
            ),
            shade(c, 1.06),
            name=f"seat_cushion_{k + 1}",
        )
        s.add(
            lambda y=y, gap=gap: _lean_pad(
                -L / 2 + back, (y + gap, y + step - gap), (seat, H * 0.95), 0.16 * L
            ),
            shade(c, 1.06),
            name=f"back_cushion_{k + 1}",
        )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.34))
    s.proxy_slab((-L / 2 + back, L / 2), (-W / 2 + arm, W / 2 - arm), (H * 0.34, seat), 0.6)
    for y in (-1, 1):
        s.proxy_slab((-L / 2, L / 2), edge(y, W, arm), (H * 0.34, H * 0.68), 0.8)
    s.proxy_slab((-L / 2, -L / 2 + back), (-W / 2 + arm, W / 2 - arm), (H * 0.34, H), 0.8)
    s.surface("seat", seat, ((L - back) / 2 - 6, (W - 2 * arm) / 2), (back / 2 + 4, 0))


@builder("stool")
def stool(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round stool, drawn at 38 x 38 x 46."""
    s.add(
        lambda: forms.turned(
            [(16.4, 43), (17.8, 43.6), (18, 44.6), (17.4, 45.6), (15, 46), (8, 45.6)], sections=44
        ),
        c,
        name="seat",
    )
    s.proxy(
        ProxyKind.CYLINDER, (18, 18, 1.5), (0, 0, 44.5), 1, direction((0, 0, 43), (0, 0, 46))[0]
    )
    for x, row in ((-1, "rear"), (1, "front")):
        for y, side in ((-1, "right"), (1, "left")):
            path = [(x * 13.4, y * 13.4, 0.2), (x * 11.6, y * 11.6, 18), (x * 8.6, y * 8.6, 43.5)]
            s.add(
                lambda path=path: forms.tube(path, [1.35, 2.0, 1.5], 14, round_ends=False),
                shade(c, 0.85),
                name=f"leg_{row}_{side}",
            )
            s.proxy_slab((x * 12.5 - 2, x * 12.5 + 2), (y * 12.5 - 2, y * 12.5 + 2), (0, 43), 0.8)
    for z, r in ((15, 12.0), (22, 11.2)):
        for k in (0, 1):
            ends = [(r, -r, z), (r, r, z)] if (k == 0) == (z < 20) else [(-r, r, z), (r, r, z)]
            s.add(
                lambda e=ends: forms.gather(
                    [forms.tube(e, 0.9, 10), forms.tube([(-x, -y, q) for x, y, q in e], 0.9, 10)]
                ),
                shade(c, 0.85),
                name="rung",
            )
    s.surface("seat", 46, (12, 12))


@builder("bench", "free")
def bench(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Plain bench across Y without a back."""
    t = max(3.0, H * 0.09)
    n = 3
    for k in range(n):
        x = -L / 2 + L * k / n
        s.slab((x + 0.4, x + L / n - 0.4), (-W / 2, W / 2), (H - t, H), c)
    for y in (-1, 1):
        leg = (W * 0.36, W * 0.36 + 6) if y > 0 else (-W * 0.36 - 6, -W * 0.36)
        s.slab((-L / 2 + 1, L / 2 - 1), leg, (0, H - t), shade(c, 0.85), solid=0.8)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H))
    s.surface("top", H, (L / 2, W / 2))


_BINDINGS = (
    (0.6, 0.2, 0.18),
    (0.2, 0.3, 0.5),
    (0.25, 0.42, 0.3),
    (0.8, 0.7, 0.45),
    (0.35, 0.25, 0.4),
    (0.86, 0.84, 0.78),
    (0.16, 0.17, 0.2),
)


def _books(s: Sketch, L: float, W: float, H: float, t: float, n: int) -> None:
    """Rows of books of all heights, here and there one that leans, with bands on their spines."""
    import random

    rng = random.Random(11 + s.appearance.pick("books", 50))
    gap = (H - 4 - t) / n
    shelves: dict[int, list[Any]] = {}
    bands: list[Any] = []
    for k in range(n):
        z = 4 + gap * k + t
        y = -W / 2 + t + 1
        while y < W / 2 - t - 8:
            w = rng.uniform(1.9, 4.6)
            h = min(gap * 0.9 - t, rng.uniform(18, 27))
            d = min(L * 0.75, rng.uniform(13, 18))
            x = -L / 2 + 2 + d / 2 + min(L * 0.12, 2.5)
            if rng.random() < 0.1:
                y += rng.uniform(2.0, 5.0)
                continue
            shelves.setdefault(rng.randrange(len(_BINDINGS)), []).append(
                ((d, 0.94 * w, h), (x, y + w / 2, z + h / 2))
            )
            bands.append(((0.3, 0.95 * w, 0.05 * h), (x + d / 2, y + w / 2, z + 0.82 * h)))
            y += w
    for tone, boxes in sorted(shelves.items()):
        s.add(
            lambda boxes=boxes: forms.gather(
                [
                    forms.cushion(size, at, plan=9, side=0.08, sections=8, levels=3)
                    for size, at in boxes
                ]
            ),
            _BINDINGS[tone],
            of="linen",
            name=f"books_{tone + 1}",
        )
    s.add(
        lambda: forms.gather([shapes.box(*b) for b in bands]),
        (0.78, 0.66, 0.36),
        of="paint",
        name="spine_bands",
    )


@builder("shelf", "free")
def shelf(s: Sketch, L: float, W: float, H: float, c: Color, books: bool = False) -> None:
    """Open shelving unit with a back panel; faces +X."""
    t = 2.0
    for y in (-1, 1):
        word = "left" if y > 0 else "right"
        s.slab((-L / 2, L / 2), edge(y, W, t), (0, H), c, solid=1, name=f"side_{word}")
    rear = (-L / 2, -L / 2 + 1)
    s.slab(rear, (-W / 2 + t, W / 2 - t), (0, H), shade(c, 0.85), solid=1, name="back")
    n = max(2, round(H / 36))
    for k in range(n + 1):
        z = 4 + (H - 4 - t) * k / n
        s.slab(
            (-L / 2 + 1, L / 2),
            (-W / 2 + t, W / 2 - t),
            (z, z + t),
            c,
            solid=1,
            name=f"board_{k + 1}",
        )
        name = "top" if k == n else f"shelf {k + 1}"
        s.surface(name, z + t, ((L - 1) / 2 - 0.5, W / 2 - t), (0.5, 0))
    s.slab(
        (L / 2 - 2.4, L / 2 - 0.8), (-W / 2 + t, W / 2 - t), (0, 4), shade(c, 0.8), name="plinth"
    )
    if books:
        _books(s, L, W, H, t, n)
    s.surfaces.insert(0, s.surfaces.pop())


@builder("cabinet", "free")
def cabinet(s: Sketch, L: float, W: float, H: float, c: Color, style: str = "doors") -> None:
    """Closed cabinet with doors or drawers on its +X face."""
    s.slab((-L / 2 + 1, L / 2 - 5), (-W / 2 + 2, W / 2 - 2), (0, 6), DARK)
    s.slab((-L / 2, L / 2 - 2), (-W / 2, W / 2), (6, H), c, rough=0.5)
    front = (L / 2 - 2, L / 2 - 0.8)
    if style == "drawers":
        n = max(2, round(H / 32))
        for k in range(n):
            z0, z1 = 7 + (H - 8) * k / n, 7 + (H - 8) * (k + 1) / n
            s.slab(front, (-W / 2 + 1, W / 2 - 1), (z0 + 0.5, z1 - 0.5), shade(c, 1.06))
            z = z1 - (z1 - z0) * 0.3
            s.slab((L / 2 - 0.8, L / 2), (-W * 0.12, W * 0.12), (z - 0.7, z + 0.7), CHROME)
    else:
        n = max(1, round(W / 50))
        for k in range(n):
            y0, y1 = -W / 2 + 1 + (W - 2) * k / n, -W / 2 + 1 + (W - 2) * (k + 1) / n
            s.slab(front, (y0 + 0.4, y1 - 0.4), (7, H - 1), shade(c, 1.06))
            hinge = y1 - 4 if k % 2 == 0 else y0 + 4
            s.slab(
                (L / 2 - 0.8, L / 2),
                (hinge - 0.6, hinge + 0.6),
                (H * 0.45, H * 0.58),
                CHROME,
            )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("bed", "free")
def bed(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bed with a headboard at -X, mattress, pillows and a blanket."""
    frame, m = DARK_WOOD, H * 0.55
    s.slab((-L / 2, -L / 2 + 5), (-W / 2, W / 2), (0, H), frame, solid=0.8)
    s.slab((L / 2 - 4, L / 2), (-W / 2, W / 2), (0, m * 0.8), frame)
    s.slab((-L / 2 + 5, L / 2 - 4), (-W / 2 + 1, W / 2 - 1), (H * 0.1, m * 0.6), frame)
    for x in (-1, 1):
        for y in (-1, 1):
            s.slab(edge(x, L * 0.96, 6), edge(y, W * 0.96, 6), (0, H * 0.12), frame)
    s.slab((-L / 2 + 5, L / 2 - 4), (-W / 2 + 2, W / 2 - 2), (m * 0.6, m), WHITE, rough=0.95)
    s.slab(
        (-L / 2 + L * 0.32, L / 2 - 3), (-W / 2 + 0.5, W / 2 - 0.5), (m * 0.66, m + 2), c, rough=1.0
    )
    n = 2 if W > 120 else 1
    for k in range(n):
        y = (k - (n - 1) / 2) * W * 0.46
        s.slab(
            (-L / 2 + 9, -L / 2 + 50), (y - W * 0.21, y + W * 0.21), (m, m + 9), WHITE, rough=1.0
        )
    s.proxy_slab((-L / 2 + 5, L / 2), (-W / 2, W / 2), (0, m + 2))
    s.surface("mattress", m + 2, (L * 0.33, W / 2 - 2), (L * 0.15, 0))
