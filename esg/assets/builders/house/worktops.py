"""What one works at standing: counters and benches. Fronts face +X."""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import edge, shade
from esg.assets.geometry.sketch import CHROME, DARK, Color, Sketch, finish, rgb

WORKTOP = finish("stone_polished", rgb(92, 88, 82))


@builder("counter", "free")
def counter(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Fitted counter: doors and drawers over a plinth, under a worktop; its front is +X."""
    top, rim = max(2.0, 0.042 * H), min(2.0, 0.03 * L)
    plinth = 0.11 * H
    s.slab((-L / 2, L / 2 - 5 * rim), (-W / 2 + 1, W / 2 - 1), (0, plinth), DARK, name="plinth")
    body = ((-L / 2, L / 2 - 2 * rim), (-W / 2, W / 2), (plinth, H - top))
    s.slab(*body, c, name="carcass")
    n = max(1, round(W / 55))
    front = (L / 2 - 2 * rim, L / 2 - rim)
    for k in range(n):
        y0, y1 = -W / 2 + W * k / n, -W / 2 + W * (k + 1) / n
        parts = ((plinth + 0.4, 0.76 * H, "door"), (0.77 * H, H - top - 0.4, "drawer"))
        for z0, z1, what in parts:
            pale = shade(c, 1.07)
            s.slab(front, (y0 + 0.4, y1 - 0.4), (z0, z1), pale, name=f"{what}_{k + 1}")
            z = z1 - 0.035 * H
            grip = (0.5 * (y0 + y1) - 0.13 * (y1 - y0), 0.5 * (y0 + y1) + 0.13 * (y1 - y0))
            s.slab(
                (L / 2 - rim, L / 2 - 0.3 * rim),
                grip,
                (z - 0.7, z + 0.7),
                CHROME,
                name=f"handle_{what}_{k + 1}",
            )
    board = ((-L / 2, L / 2), (-W / 2, W / 2), (H - top, H))
    s.slab(*board, WORKTOP, name="worktop")
    s.proxy_slab((-L / 2, L / 2 - 2 * rim), (-W / 2, W / 2), (0, H - top), 0.6)
    s.proxy_slab(*board, 1.6)
    s.surface("top", H, (L / 2, W / 2))


@builder("workbench", "free")
def workbench(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Joiner's bench: a thick top on stout legs, a shelf below it and a vice at its +X side."""
    t, leg = max(3.0, 0.09 * H), max(3.0, 0.13 * min(L, W))
    top = ((-L / 2, L / 2), (-W / 2, W / 2), (H - t, H))
    s.slab(*top, c, name="top")
    s.proxy_slab(*top, 1)
    inner = 0.02 * min(L, W) + leg
    for x, row in ((-1, "rear"), (1, "front")):
        for y, side in ((-1, "right"), (1, "left")):
            at = edge(x, L - 2 * (inner - leg), leg), edge(y, W - 2 * (inner - leg), leg)
            s.slab(*at, (0, H - t), shade(c, 0.8), solid=0.7, name=f"leg_{row}_{side}")
    for y in (-1, 1):
        rail = edge(y, W - inner, 0.4 * leg)
        s.slab(
            (-L / 2 + inner, L / 2 - inner),
            rail,
            (H - t - 0.14 * H, H - t),
            shade(c, 0.88),
            name="rail_left" if y > 0 else "rail_right",
        )
    low = ((-L / 2 + 0.5 * leg, L / 2 - 0.5 * leg), (-W / 2 + 0.5 * leg, W / 2 - 0.5 * leg))
    s.slab(*low, (0.2 * H, 0.2 * H + 0.35 * t), shade(c, 0.92), solid=0.6, name="shelf")
    jaw, y = 0.06 * L, 0.28 * W
    at = (L / 2 - jaw, L / 2), (y - 0.1 * W, y + 0.1 * W)
    s.slab(*at, (H - 2.6 * t, H - t), shade(c, 0.7), name="vice")
    s.surface("top", H, (L / 2, W / 2))
