"""Furniture. Fronts face +X: one sits at a desk or opens a cabinet from +X."""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import edge, shade
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    DARK_WOOD,
    WHITE,
    Color,
    Sketch,
)


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
            s.slab(edge(x, L - 2 * inset, t), edge(y, W - 2 * inset, t), (0, z), c, solid=density)


@builder("table", "free")
def table(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Rectangular table on four legs with an apron."""
    t = max(1.5, H * 0.045)
    leg = max(2.0, min(L, W) * 0.07)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H), c, solid=1, rough=0.4)
    _legs(s, L, W, H - t, leg, shade(c, 0.85), inset=min(L, W) * 0.03)
    a = min(L, W) * 0.06
    for y in (-1, 1):
        s.slab(
            (-L / 2 + 2 * a, L / 2 - 2 * a),
            edge(y, W - 2 * a, 2),
            (H - t - H * 0.09, H - t),
            shade(c, 0.9),
        )
    for x in (-1, 1):
        s.slab(
            edge(x, L - 2 * a, 2),
            (-W / 2 + 2 * a, W / 2 - 2 * a),
            (H - t - H * 0.09, H - t),
            shade(c, 0.9),
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
        shade(c, 0.85),
    )
    s.rod(r * 0.62, (0, 0, 0), (0, 0, 3), shade(c, 0.8), solid=2)
    s.proxy_cylinder(r * 0.11, (3, H - t), 1.0)
    s.surface("top", H, (r * 0.7, r * 0.7))


@builder("desk", "free")
def desk(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Office desk with a drawer pedestal; the knee side faces +X."""
    t = 2.8
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H), c, solid=1, rough=0.35)
    side = min(3.0, W * 0.03)
    s.slab((-L / 2 + 2, L / 2 - 2), (-W / 2, -W / 2 + side), (0, H - t), shade(c, 0.9), solid=0.8)
    ped = min(42.0, W * 0.3)
    y0 = W / 2 - ped
    s.slab((-L / 2 + 2, L / 2 - 4), (y0, W / 2), (0, H - t), shade(c, 0.9), solid=0.5)
    s.slab(
        (-L / 2 + 2, -L / 2 + 4), (-W / 2 + side, y0), (H * 0.35, H - t), shade(c, 0.85), solid=0.8
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
            s.slab(edge(x, L * 0.94, 5), edge(y, W * 0.94, 5), (0, H * 0.12), DARK_WOOD)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H * 0.1, H * 0.32), shade(c, 0.85), rough=0.95)
    for y in (-1, 1):
        s.slab((-L / 2, L / 2 - 1), edge(y, W, arm), (H * 0.3, H * 0.68), c, rough=0.95)
    s.slab((-L / 2, -L / 2 + back), (-W / 2 + arm, W / 2 - arm), (H * 0.3, H), c, rough=0.95)
    n = max(1, round((W - 2 * arm) / 65))
    step = (W - 2 * arm) / n
    for k in range(n):
        y = -W / 2 + arm + k * step
        s.slab(
            (-L / 2 + back, L / 2),
            (y + 0.6, y + step - 0.6),
            (H * 0.32, seat),
            shade(c, 1.08),
            rough=0.95,
        )
        s.slab(
            (-L / 2 + back, -L / 2 + back + 10),
            (y + 2, y + step - 2),
            (seat, H * 0.92),
            shade(c, 1.08),
            rough=0.95,
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
    s.rod(18, (0, 0, 43), (0, 0, 46), c, solid=1, sections=40)
    for x in (-1, 1):
        for y in (-1, 1):
            s.rod(1.8, (x * 13.5, y * 13.5, 0.4), (x * 9, y * 9, 43), shade(c, 0.85), sections=14)
            s.proxy_slab((x * 12.5 - 2, x * 12.5 + 2), (y * 12.5 - 2, y * 12.5 + 2), (0, 43), 0.8)
    s.torus(16, 1, (0, 0, 18), shade(c, 0.85))
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


@builder("shelf", "free")
def shelf(s: Sketch, L: float, W: float, H: float, c: Color, books: bool = False) -> None:
    """Open shelving unit with a back panel; faces +X."""
    t = 2.0
    for y in (-1, 1):
        s.slab((-L / 2, L / 2), edge(y, W, t), (0, H), c, solid=1)
    s.slab((-L / 2, -L / 2 + 1), (-W / 2 + t, W / 2 - t), (0, H), shade(c, 0.85), solid=1)
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
            s.slab(front, (-W / 2 + 1, W / 2 - 1), (z0 + 0.5, z1 - 0.5), shade(c, 1.06))
            z = z1 - (z1 - z0) * 0.3
            s.slab(
                (L / 2 - 0.8, L / 2), (-W * 0.12, W * 0.12), (z - 0.7, z + 0.7), CHROME, metal=0.8
            )
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
