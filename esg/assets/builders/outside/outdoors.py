"""Plants, rocks and garden things."""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.sketch import (
    CONCRETE,
    STEEL,
    Color,
    Sketch,
)
from esg.assets.lazy import shapes


@builder("phone_booth")
def phone_booth(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Telephone kiosk, door at +X, drawn at 92 x 92 x 240."""
    s.slab((-46, 46), (-46, 46), (0, 8), CONCRETE, solid=1)
    s.slab((-44, 44), (-44, 44), (214, 232), c, solid=1)
    s.slab((-36, 36), (-36, 36), (232, 240), c, solid=1)
    s.slab((-40, 40), (-40, 40), (10, 214), (0.62, 0.72, 0.75), rough=0.05, alpha=0.5, of="glass")
    for x in (-41, 41):
        for y in (-41, 41):
            s.slab((x - 3, x + 3), (y - 3, y + 3), (8, 214), c)
    for k in range(1, 7):
        z = 8 + k * 30
        s.slab((-42, 42), (-42, 42), (z - 1, z + 1), c)
    s.proxy_slab((-43, 43), (-43, 43), (8, 214), 0.25)


@builder("bush", "free")
def bush(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Leafy shrub or hedge."""
    r = min(L, W, H) * 0.34
    n = max(2, round(max(L, W) / r))
    span_x, span_y = L / 2 - r, W / 2 - r
    for k in range(n):
        t = -1 + 2 * k / (n - 1)
        x, y = (
            (t * span_x, (k % 2 * 2 - 1) * span_y)
            if L >= W
            else ((k % 2 * 2 - 1) * span_x, t * span_y)
        )
        s.ball(r, (x, y, H - r if k % 2 else r), shade(c, 0.85 + 0.15 * (k % 3) / 2), rough=0.95)
        s.ball(r, (x, -y, r if k % 2 else H - r), shade(c, 0.8 + 0.15 * (k % 4) / 3), rough=0.95)
    s.ball(0.5, (0, 0, H * 0.46), shade(c, 0.8), scale=(L * 0.92, W * 0.92, H * 0.92), rough=1.0)
    s.proxy_slab((-L * 0.45, L * 0.45), (-W * 0.45, W * 0.45), (0, H * 0.95))


@builder("rock")
def rock(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Boulder with a flat underside and crown, drawn at 60 x 50 x 40."""
    import numpy as np

    rng = np.random.default_rng(7)
    p = rng.normal(size=(70, 3))
    p /= np.linalg.norm(p, axis=1, keepdims=True)
    p *= rng.uniform(0.9, 1.0, (70, 1))
    p = np.concatenate([p, np.eye(3), -np.eye(3)]) * np.array([30, 25, 24]) + [0, 0, 16]
    turn = 2 * np.pi * (np.arange(11) + rng.uniform(-0.3, 0.3, 11)) / 11
    crown = rng.uniform(0.92, 1.0, (11, 1)) * np.stack([18 * np.cos(turn), 15 * np.sin(turn)], 1)
    p = np.concatenate([p, np.pad(crown, ((0, 0), (0, 1)), constant_values=35)])
    p[:, 2] = np.clip(p[:, 2], 0, 35) * (40 / 35)
    points = [tuple(float(c) for c in v) for v in p]

    s.add(lambda: shapes.hull(points), c)
    s.proxy_hull([tuple(v) for v in shapes.hull(points).vertices])  # type: ignore[misc]
    s.surface("top", 40, (13, 10.5))


@builder("dumpster")
def dumpster(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Open skip with sloped ends, drawn at 180 x 360 x 140; hollow."""

    outer = [
        (x * 90, y * w, z) for z, w in ((0, 130), (140, 180)) for x in (-1, 1) for y in (-1, 1)
    ]
    inner = [
        (x * 84, y * w, z) for z, w in ((6, 124), (141, 174)) for x in (-1, 1) for y in (-1, 1)
    ]
    s.add(lambda: shapes.cut(shapes.hull(outer), [shapes.hull(inner)]), c)
    for y in (-110, -40, 40, 110):
        for x in (-1, 1):
            s.slab((88, 92) if x > 0 else (-92, -88), (y - 5, y + 5), (10, 134), shade(c, 0.8))
    s.walls((-90, 90), (-150, 150), (0, 140), 6)
    s.region("inside", (-82, 82), (-142, 142), (6, 138))
    s.surface("floor", 6, (78, 118))
    s.rod(3, (-90, -172, 118), (90, -172, 118), STEEL)
    s.rod(3, (-90, 172, 118), (90, 172, 118), STEEL)
