"""Furniture. Fronts face +X: one sits at a desk or opens a cabinet from +X."""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.lazy import shapes
from esg.assets.sketch import (
    CHROME,
    DARK,
    DARK_WOOD,
    STEEL,
    WHITE,
    Color,
    Sketch,
)


def _shade(c: Color, f: float) -> Color:
    return (min(c[0] * f, 1.0), min(c[1] * f, 1.0), min(c[2] * f, 1.0))


def _ends(sign: int, extent: float, t: float) -> tuple[float, float]:
    return (extent / 2 - t, extent / 2) if sign > 0 else (-extent / 2, -extent / 2 + t)


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
    for x in (-1, 1):
        for y in (-1, 1):
            s.slab(_ends(x, L - 2 * inset, t), _ends(y, W - 2 * inset, t), (0, z), c, solid=density)


@builder("table", "free")
def table(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Rectangular table on four legs with an apron."""
    t = max(1.5, H * 0.045)
    leg = max(2.0, min(L, W) * 0.07)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H), c, solid=1, rough=0.4)
    _legs(s, L, W, H - t, leg, _shade(c, 0.85), inset=min(L, W) * 0.03)
    a = min(L, W) * 0.06
    for y in (-1, 1):
        s.slab(
            (-L / 2 + 2 * a, L / 2 - 2 * a),
            _ends(y, W - 2 * a, 2),
            (H - t - H * 0.09, H - t),
            _shade(c, 0.9),
        )
    for x in (-1, 1):
        s.slab(
            _ends(x, L - 2 * a, 2),
            (-W / 2 + 2 * a, W / 2 - 2 * a),
            (H - t - H * 0.09, H - t),
            _shade(c, 0.9),
        )
    s.surface("top", H, (L / 2, W / 2))


@builder("round_table", "free")
def round_table(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round table on a central column."""
    r = min(L, W) / 2
    t = max(1.5, H * 0.04)
    s.rod(r, (0, 0, H - t), (0, 0, H), c, solid=1, rough=0.35, sections=56)
    s.lathe(
        [
            (0, 3),
            (r * 0.14, 3),
            (r * 0.09, H * 0.3),
            (r * 0.09, H * 0.8),
            (r * 0.2, H - t),
            (0, H - t),
        ],
        _shade(c, 0.85),
    )
    s.rod(r * 0.62, (0, 0, 0), (0, 0, 3), _shade(c, 0.8), solid=2)
    s.proxy_cylinder(r * 0.11, (3, H - t), 1.0)
    s.surface("top", H, (r * 0.7, r * 0.7))


@builder("desk", "free")
def desk(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Office desk with a drawer pedestal; the knee side faces +X."""
    t = 2.8
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H), c, solid=1, rough=0.35)
    side = min(3.0, W * 0.03)
    s.slab((-L / 2 + 2, L / 2 - 2), (-W / 2, -W / 2 + side), (0, H - t), _shade(c, 0.9), solid=0.8)
    ped = min(42.0, W * 0.3)
    y0 = W / 2 - ped
    s.slab((-L / 2 + 2, L / 2 - 4), (y0, W / 2), (0, H - t), _shade(c, 0.9), solid=0.5)
    s.slab(
        (-L / 2 + 2, -L / 2 + 4), (-W / 2 + side, y0), (H * 0.35, H - t), _shade(c, 0.85), solid=0.8
    )
    for k in range(3):
        z0, z1 = H * (0.06 + 0.3 * k), H * (0.34 + 0.3 * k)
        s.slab((L / 2 - 4, L / 2 - 2.4), (y0 + 1, W / 2 - 1), (z0, z1), c)
        s.rod(
            0.7,
            (L / 2 - 1.8, y0 + ped * 0.3, z1 - 5),
            (L / 2 - 1.8, y0 + ped * 0.7, z1 - 5),
            CHROME,
            metal=0.8,
            sections=12,
        )
    s.surface("top", H, (L / 2, W / 2))


@builder("chair")
def chair(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Dining chair, drawn at 50 x 44 x 88; one sits facing +X."""
    s.slab((-21, 25), (-22, 22), (43, 46), c, solid=1)
    for y in (-20, 20):
        s.slab((20, 24), (y - 2, y + 2), (0, 43), c, solid=1)
        s.extrude(
            [(-24, 0), (-20, 0), (-19, 44), (-22, 88), (-25, 88), (-23, 44)], (y - 2, y + 2), c
        )
        s.proxy_slab((-24, -20), (y - 2, y + 2), (0, 43))
        s.slab((-20, 20), (y - 1, y + 1), (20, 23), c)
    for z in (62, 72, 82):
        s.slab((-23.5, -22), (-18, 18), (z - 3, z + 3), c)
    s.proxy_slab((-25, -21), (-22, 22), (46, 88), 0.5)
    s.surface("seat", 46, (20, 20), (2, 0))


@builder("office_chair")
def office_chair(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Swivel chair on five castors, drawn at 64 x 64 x 110."""
    import math

    for k in range(5):
        a = 2 * math.pi * k / 5
        x, y = 28 * math.cos(a), 28 * math.sin(a)
        s.rod(2, (0, 0, 10), (x, y, 7), DARK, sections=12)
        s.rod(3, (x, y - 1.8, 3), (x, y + 1.8, 3), DARK, sections=20)
    s.rod(3, (0, 0, 8), (0, 0, 46), CHROME, metal=0.8, solid=1)
    s.extrude(
        [(-25, -23), (23, -25), (27, -18), (27, 18), (23, 25), (-25, 23)],
        (46, 54),
        c,
        plane="xy",
        soft=3,
    )
    s.extrude([(-26, 56), (-21, 56), (-24, 90), (-30, 110), (-32, 109), (-29, 88)], (-22, 22), c)
    for y in (-27, 27):
        s.pipe(1.6, [(0, y * 0.75, 48), (2, y, 50), (2, y, 68)], DARK)
        s.slab((-11, 15), (y - 3.5, y + 3.5), (67, 70), DARK)
    s.proxy_cylinder(30, (0, 9), 1.5)
    s.proxy_slab((-26, 26), (-25, 25), (46, 54), 1.0)
    s.proxy_slab((-31, -23), (-22, 22), (56, 110), 0.4)
    s.surface("seat", 54, (22, 20))


@builder("armchair", "free")
def armchair(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Upholstered seat with arms for one or more; faces +X."""
    arm, back, seat = min(20.0, W * 0.18), L * 0.24, H * 0.5
    for x in (-1, 1):
        for y in (-1, 1):
            s.slab(_ends(x, L * 0.94, 5), _ends(y, W * 0.94, 5), (0, H * 0.12), DARK_WOOD)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H * 0.1, H * 0.32), _shade(c, 0.85), rough=0.95)
    for y in (-1, 1):
        s.slab((-L / 2, L / 2 - 1), _ends(y, W, arm), (H * 0.3, H * 0.68), c, rough=0.95)
    s.slab((-L / 2, -L / 2 + back), (-W / 2 + arm, W / 2 - arm), (H * 0.3, H), c, rough=0.95)
    n = max(1, round((W - 2 * arm) / 65))
    step = (W - 2 * arm) / n
    for k in range(n):
        y = -W / 2 + arm + k * step
        s.slab(
            (-L / 2 + back, L / 2),
            (y + 0.6, y + step - 0.6),
            (H * 0.32, seat),
            _shade(c, 1.08),
            rough=0.95,
        )
        s.slab(
            (-L / 2 + back, -L / 2 + back + 10),
            (y + 2, y + step - 2),
            (seat, H * 0.92),
            _shade(c, 1.08),
            rough=0.95,
        )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.34))
    s.proxy_slab((-L / 2 + back, L / 2), (-W / 2 + arm, W / 2 - arm), (H * 0.34, seat), 0.6)
    for y in (-1, 1):
        s.proxy_slab((-L / 2, L / 2), _ends(y, W, arm), (H * 0.34, H * 0.68), 0.8)
    s.proxy_slab((-L / 2, -L / 2 + back), (-W / 2 + arm, W / 2 - arm), (H * 0.34, H), 0.8)
    s.surface("seat", seat, ((L - back) / 2 - 6, (W - 2 * arm) / 2), (back / 2 + 4, 0))


@builder("stool")
def stool(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round stool, drawn at 38 x 38 x 46."""
    s.rod(18, (0, 0, 43), (0, 0, 46), c, solid=1, sections=40)
    for x in (-1, 1):
        for y in (-1, 1):
            s.rod(1.8, (x * 13.5, y * 13.5, 0.4), (x * 9, y * 9, 43), _shade(c, 0.85), sections=14)
            s.proxy_slab((x * 12.5 - 2, x * 12.5 + 2), (y * 12.5 - 2, y * 12.5 + 2), (0, 43), 0.8)
    s.torus(16, 1, (0, 0, 18), _shade(c, 0.85))
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
        s.slab((-L / 2 + 1, L / 2 - 1), leg, (0, H - t), _shade(c, 0.85), solid=0.8)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("shelf", "free")
def shelf(s: Sketch, L: float, W: float, H: float, c: Color, books: bool = False) -> None:
    """Open shelving unit with a back panel; faces +X."""
    t = 2.0
    for y in (-1, 1):
        s.slab((-L / 2, L / 2), _ends(y, W, t), (0, H), c, solid=1)
    s.slab((-L / 2, -L / 2 + 1), (-W / 2 + t, W / 2 - t), (0, H), _shade(c, 0.85), solid=1)
    n = max(2, round(H / 36))
    palette = [
        (0.6, 0.2, 0.18),
        (0.2, 0.3, 0.5),
        (0.25, 0.42, 0.3),
        (0.8, 0.7, 0.45),
        (0.35, 0.25, 0.4),
    ]
    for k in range(n + 1):
        z = 4 + (H - 4 - t) * k / n
        s.slab((-L / 2 + 1, L / 2), (-W / 2 + t, W / 2 - t), (z, z + t), c, solid=1)
        name = "top" if k == n else f"shelf {k + 1}"
        s.surface(name, z + t, ((L - 1) / 2 - 0.5, W / 2 - t), (0.5, 0))
        if books and k < n:
            y = -W / 2 + t + 1
            i = k
            gap = (H - 4 - t) / n
            while y < W / 2 - t - 8:
                w = 2.2 + (i * 7 % 5) * 0.6
                h = min(gap * 0.9 - t, 19 + (i * 5 % 4) * 2.5)
                s.slab(
                    (-L / 2 + 2, -L / 2 + 2 + min(L * 0.7, 17)),
                    (y, y + w - 0.2),
                    (z + t, z + t + h),
                    palette[i % 5],
                )
                y += w
                i += 1
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
            s.slab(front, (-W / 2 + 1, W / 2 - 1), (z0 + 0.5, z1 - 0.5), _shade(c, 1.06))
            z = z1 - (z1 - z0) * 0.3
            s.slab(
                (L / 2 - 0.8, L / 2), (-W * 0.12, W * 0.12), (z - 0.7, z + 0.7), CHROME, metal=0.8
            )
    else:
        n = max(1, round(W / 50))
        for k in range(n):
            y0, y1 = -W / 2 + 1 + (W - 2) * k / n, -W / 2 + 1 + (W - 2) * (k + 1) / n
            s.slab(front, (y0 + 0.4, y1 - 0.4), (7, H - 1), _shade(c, 1.06))
            hinge = y1 - 4 if k % 2 == 0 else y0 + 4
            s.slab(
                (L / 2 - 0.8, L / 2),
                (hinge - 0.6, hinge + 0.6),
                (H * 0.45, H * 0.58),
                CHROME,
                metal=0.8,
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
            s.slab(_ends(x, L * 0.96, 6), _ends(y, W * 0.96, 6), (0, H * 0.12), frame)
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


@builder("floor_lamp")
def floor_lamp(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Standard lamp, drawn at 40 x 40 x 155."""
    s.lathe([(0, 0), (15, 0), (15, 2), (3, 4), (0, 4)], DARK, metal=0.4)
    s.rod(1.2, (0, 0, 3), (0, 0, 128), CHROME, metal=0.8)
    s.lathe([(12, 155), (20, 122), (19.6, 122), (11.6, 155), (12, 155)], c, rough=0.9)
    s.ball(5, (0, 0, 134), (1.0, 0.95, 0.8), rough=0.2)
    s.proxy_cylinder(15, (0, 4), 16.0)
    s.proxy_cylinder(1.5, (4, 122), 2.0)
    s.proxy_cylinder(18, (122, 155), 0.05)


@builder("desk_lamp")
def desk_lamp(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Table lamp with a shade, drawn at 28 x 28 x 46."""
    s.lathe(
        [(0, 0), (8, 0), (8, 1.5), (2.5, 4), (4.5, 12), (3, 22), (1, 26), (0, 26)],
        _shade(c, 0.6),
        smooth=30,
    )
    s.lathe([(9, 46), (14, 25), (13.6, 25), (8.6, 46), (9, 46)], c, rough=0.9)
    s.rod(0.5, (0, 0, 25), (0, 0, 40), CHROME)
    s.proxy_cylinder(8, (0, 3), 8)
    s.proxy_cylinder(4, (3, 25), 1.5)
    s.proxy_cylinder(12, (25, 46), 0.08)


@builder("appliance", "free")
def appliance(s: Sketch, L: float, W: float, H: float, c: Color, style: str = "fridge") -> None:
    """White goods, door facing +X."""
    s.slab((-L / 2, L / 2 - 3), (-W / 2, W / 2), (2, H), c, rough=0.3)
    s.slab((-L / 2 + 2, L / 2 - 6), (-W / 2 + 2, W / 2 - 2), (0, 2), DARK)
    f = (L / 2 - 3, L / 2 - 0.6)
    if style == "fridge":
        for z in ((3, H * 0.36), (H * 0.37, H - 0.5)):
            s.slab(f, (-W / 2 + 0.5, W / 2 - 0.5), z, _shade(c, 0.97), rough=0.25)
            s.slab(
                (L / 2 - 0.6, L / 2),
                (W / 2 - 7, W / 2 - 5),
                (z[0] + 6, min(z[1] - 4, z[0] + 50)),
                CHROME,
                metal=0.8,
            )
    elif style == "washer":
        s.slab(f, (-W / 2 + 0.5, W / 2 - 0.5), (3, H - 0.5), _shade(c, 0.97), rough=0.25)
        s.rod(W * 0.3, (L / 2 - 3, 0, H * 0.46), (L / 2 - 0.3, 0, H * 0.46), STEEL, metal=0.6)
        s.rod(
            W * 0.23, (L / 2 - 3, 0, H * 0.46), (L / 2, 0, H * 0.46), (0.12, 0.15, 0.2), rough=0.1
        )
        s.rod(W * 0.05, (L / 2 - 3, W * 0.3, H * 0.9), (L / 2, W * 0.3, H * 0.9), STEEL)
    elif style == "stove":
        s.slab(f, (-W / 2 + 0.5, W / 2 - 0.5), (H * 0.12, H * 0.8), DARK, rough=0.1)
        s.rod(1, (L / 2 - 1, -W * 0.4, H * 0.76), (L / 2 - 1, W * 0.4, H * 0.76), CHROME, metal=0.8)
        for x in (-L * 0.2, L * 0.18):
            for y in (-W * 0.22, W * 0.22):
                s.rod(W * 0.14, (x, y, H - 1), (x, y, H + 0.01), DARK)
        for k in range(5):
            y = -W * 0.36 + W * 0.18 * k
            s.rod(1.6, (L / 2 - 3, y, H * 0.9), (L / 2, y, H * 0.9), DARK, sections=16)
    elif style == "microwave":
        s.slab(f, (-W / 2 + 0.5, W * 0.26), (2.5, H - 0.5), DARK, rough=0.1)
        s.slab(f, (W * 0.27, W / 2 - 0.5), (2.5, H - 0.5), _shade(c, 0.8))
        s.slab((L / 2 - 0.6, L / 2), (W * 0.22, W * 0.25), (H * 0.2, H * 0.85), CHROME, metal=0.8)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("television", "free")
def television(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flat screen on a foot, facing +X."""
    foot = H * 0.1
    t = min(6.0, L * 0.3)
    s.slab((-L / 2, L / 2), (-W * 0.22, W * 0.22), (0, 1.5), c, solid=6, metal=0.3)
    s.slab((-t / 2, t / 2), (-W * 0.06, W * 0.06), (1.5, foot + 3), c, solid=1)
    s.slab((-t / 2, t / 2), (-W / 2, W / 2), (foot, H), c, solid=1, rough=0.3)
    s.slab(
        (t / 2, t / 2 + 0.2),
        (-W * 0.485, W * 0.485),
        (foot + H * 0.02, H * 0.98),
        (0.03, 0.04, 0.06),
        rough=0.05,
    )


@builder("piano", "free")
def piano(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Upright piano, keys facing +X."""
    s.slab((-L / 2, L * 0.02), (-W / 2, W / 2), (0, H), c, solid=1, rough=0.15)
    s.slab((L * 0.02, L / 2), (-W / 2, W / 2), (H * 0.5, H * 0.58), c, solid=1, rough=0.15)
    for y in (-1, 1):
        s.slab((L * 0.3, L / 2 - 2), _ends(y, W, 6), (0, H * 0.5), c, solid=0.7, rough=0.15)
        s.slab((L * 0.02, L / 2), _ends(y, W, 6), (H * 0.58, H * 0.66), c, rough=0.15)
    s.slab((L * 0.16, L / 2 - 2), (-W / 2 + 7, W / 2 - 7), (H * 0.58, H * 0.595), WHITE)
    n = 36
    for k in range(n):
        if k % 7 in (2, 6):
            continue
        y = -W / 2 + 8 + (W - 16) * (k + 1) / n
        s.slab((L * 0.16, L * 0.34), (y - 0.6, y + 0.6), (H * 0.595, H * 0.607), DARK)
    s.surface("top", H, (L * 0.25, W / 2), (-L * 0.24, 0))


@builder("bathtub", "free")
def bathtub(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bathtub along X; hollow."""

    s.add(
        lambda: shapes.cut(
            shapes.extrude(
                [(-L / 2, -W / 2), (L / 2, -W / 2), (L / 2, W / 2), (-L / 2, W / 2)],
                (0, H),
                "xy",
                min(L, W) * 0.12,
            ),
            [
                shapes.extrude(
                    [
                        (-L / 2 + 7, -W / 2 + 7),
                        (L / 2 - 7, -W / 2 + 7),
                        (L / 2 - 7, W / 2 - 7),
                        (-L / 2 + 7, W / 2 - 7),
                    ],
                    (10, H + 1),
                    "xy",
                    min(L, W) * 0.14,
                )
            ],
        ),
        c,
        0.1,
    )
    s.rod(1.5, (-L / 2 + 4, 0, H - 2), (-L / 2 + 4, 0, H), CHROME, metal=0.9)
    s.walls((-L / 2, L / 2), (-W / 2, W / 2), (0, H), 7)
    s.region("inside", (-L / 2 + 8, L / 2 - 8), (-W / 2 + 8, W / 2 - 8), (10, H))
    s.surface("floor", 7, (L / 2 - 16, W / 2 - 14))


@builder("toilet")
def toilet(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Close-coupled toilet, drawn at 68 x 38 x 78."""
    s.lathe(
        [(0, 0), (11, 0), (9, 12), (15, 34), (18.5, 38), (18.5, 40), (0, 40)],
        c,
        center=(12, 0, 0),
        rough=0.1,
    )
    s.slab((-32, 12), (-10, 10), (0, 38), c, rough=0.1)
    s.extrude(
        [(-12, -18), (14, -19), (30, -11), (34, 0), (30, 11), (14, 19), (-12, 18)],
        (40, 43),
        WHITE,
        plane="xy",
        soft=3,
        rough=0.1,
    )
    s.slab((-34, -14), (-19, 19), (40, 78), c, rough=0.1)
    s.rod(1.8, (-24, 0, 77.5), (-24, 0, 78.4), CHROME, metal=0.9)
    s.proxy_slab((-32, 24), (-11, 11), (0, 30))
    s.proxy_slab((-14, 33), (-18, 18), (30, 43), 0.8)
    s.proxy_slab((-34, -14), (-19, 19), (30, 78), 0.8)
    s.surface("cistern", 78, (9, 17), (-24, 0))


@builder("sink", "free")
def sink(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Pedestal washbasin."""

    s.add(
        lambda: shapes.cut(
            shapes.box((L, W, H * 0.2), (0, 0, H * 0.86)),
            [shapes.ball(1.0, (L * 0.06, 0, H * 0.96), (L * 0.34, W * 0.38, H * 0.16))],
        ),
        c,
        0.1,
    )
    s.lathe(
        [(0, 0), (W * 0.2, 0), (W * 0.13, H * 0.2), (W * 0.16, H * 0.77), (0, H * 0.77)],
        c,
        rough=0.1,
    )
    s.pipe(
        1.2,
        [(-L * 0.4, 0, H * 0.95), (-L * 0.4, 0, H - 1.2), (-L * 0.1, 0, H - 1.2)],
        CHROME,
        metal=0.9,
    )
    s.proxy_cylinder(min(W * 0.2, L * 0.4), (0, H * 0.76))
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (H * 0.76, H * 0.96))
