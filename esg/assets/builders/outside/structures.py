"""Ground, roads, lanes (decals without collision), and solid structures.

Slopes descend towards the front (+X): what stands on top of a ramp or a staircase and moves forward
goes down.
"""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.sketch import (
    ASPHALT,
    BRICK_RED,
    DARK,
    STEEL,
    WHITE,
    YELLOW,
    Color,
    Sketch,
    rgb,
)
from esg.assets.lazy import forms, shapes


def _decal(s: Sketch, L: float, W: float, H: float) -> None:
    s.surface("top", 0.0, (L / 2, W / 2))


@builder("ground", "free")
def ground(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """The visible ground or floor; the engine's half-space carries the load."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H), c)
    _decal(s, L, W, H)


@builder("road", "free")
def road(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two-lane road along X with edge lines and a dashed middle."""
    t = H * 0.7
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, t), c, rough=1.0)
    for y in (-1, 1):
        mid = y * (W / 2 - 30)
        s.slab((-L / 2, L / 2), (mid - 6, mid + 6), (0, H), WHITE)
    n = max(1, round(L / 600))
    for k in range(n):
        x = -L / 2 + L * (k + 0.5) / n
        s.slab((x - L / n * 0.25, x + L / n * 0.25), (-6, 6), (0, H), YELLOW)
    _decal(s, L, W, H)
    s.region("left lane", (-L / 2, L / 2), (0, W / 2), (0, 200), "lane")
    s.region("right lane", (-L / 2, L / 2), (-W / 2, 0), (0, 200), "lane")


@builder("crossroads", "free")
def crossroads(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Two roads that cross at right angles; each is 800 wide, as roads are, or half the extent."""
    # Drawn a layer over the roads that lead to it, whose lines its asphalt must cover.
    t, top, w = H * 0.85, H, min(800.0, L / 2, W / 2)
    s.slab((-L / 2, L / 2), (-w / 2, w / 2), (0, t), c, rough=1.0)
    for y in ((-W / 2, -w / 2), (w / 2, W / 2)):
        s.slab((-w / 2, w / 2), y, (0, t), c, rough=1.0)
    for axis, extent in (("x", L), ("y", W)):
        for sign in (-1, 1):
            start, stop = w / 2 + 60, extent / 2
            n = max(1, round((stop - start) / 600))
            for k in range(n):
                mid = sign * (start + (stop - start) * (k + 0.5) / n)
                half = (stop - start) / n * 0.25
                a, b = (mid - half, mid + half), (-6.0, 6.0)
                s.slab(a if axis == "x" else b, b if axis == "x" else a, (0, top), YELLOW)
            for edge in (-1, 1):
                a = (start - 60, stop) if sign > 0 else (-stop, -start + 60)
                b = (edge * (w / 2 - 30) - 6, edge * (w / 2 - 30) + 6)
                s.slab(a if axis == "x" else b, b if axis == "x" else a, (0, top), WHITE)
    _decal(s, L, W, H)
    half = min(350.0, L / 6, W / 6)
    s.region("crossing", (-half, half), (-half, half), (0, 200), "area")


@builder("crossing", "free")
def crossing(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Zebra crossing; pedestrians walk along X, bars follow the traffic along Y."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.6), ASPHALT, rough=1.0)
    n = max(2, round(L / 100))
    for k in range(n):
        x = -L / 2 + L * (k + 0.5) / n
        s.slab((x - L / n / 4, x + L / n / 4), (-W / 2 + 10, W / 2 - 10), (0, H), c)
    _decal(s, L, W, H)


@builder("pavement", "free")
def pavement(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flagged pavement."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.6), shade(c, 0.8), rough=1.0)
    nx, ny = max(1, round(L / 60)), max(1, round(W / 60))
    nx, ny = min(nx, 40), min(ny, 10)
    for i in range(nx):
        for j in range(ny):
            x, y = -L / 2 + L * i / nx, -W / 2 + W * j / ny
            s.slab((x + 1, x + L / nx - 1), (y + 1, y + W / ny - 1), (0, H), c, rough=0.95)
    _decal(s, L, W, H)


@builder("lane", "free")
def lane(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Bowling lane along X, the pin deck at +X, with boards, arrows and gutters."""
    n, board = 13, W * 0.8 / 13
    for k in range(n):
        y = -W * 0.4 + k * board
        f = 0.94 + 0.06 * (k % 2)
        s.slab((-L / 2, L / 2), (y, y + board), (0, H), (c[0] * f, c[1] * f, c[2] * f), rough=0.15)
    for y in ((-W / 2, -W * 0.4), (W * 0.4, W / 2)):
        s.slab((-L / 2, L / 2), y, (0, H * 0.5), DARK, rough=0.4)
    s.slab((-L / 2, -L / 2 + 2), (-W * 0.4, W * 0.4), (0, H * 1.0), DARK)
    for k in range(-3, 4):
        x = -L / 2 + L * 0.25 - abs(k) * 15
        y = k * W * 0.1
        s.extrude(
            [(x + 12, y), (x - 4, y + 2.5), (x - 4, y - 2.5)], (H * 0.5, H * 1.02), DARK, plane="xy"
        )
    _decal(s, L, W, H)
    s.region("lane", (-L / 2, L / 2), (-W * 0.4, W * 0.4), (0, 50), "lane")


@builder("field", "free")
def field(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Sports pitch with border, halfway line and centre circle."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.7), c, rough=1.0)
    line = max(5.0, min(L, W) * 0.004)
    x, y = L / 2 - 2 * line, W / 2 - 2 * line
    for sign in (-1, 1):
        s.slab((sign * x - line / 2, sign * x + line / 2), (-y, y), (0, H), WHITE)
        s.slab((-x, x), (sign * y - line / 2, sign * y + line / 2), (0, H), WHITE)
    s.slab((-line / 2, line / 2), (-y, y), (0, H), WHITE)
    r = min(x, y) * 0.27
    s.lathe([(r - line, 0), (r, 0), (r, H), (r - line, H), (r - line, 0)], WHITE)
    _decal(s, L, W, H)


@builder("rug", "free")
def rug(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flat rug or mat; too thin to collide with."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.8), c, rough=1.0)
    b = min(L, W) * 0.06
    s.slab(
        (-L / 2 + b, L / 2 - b),
        (-W / 2 + b, W / 2 - b),
        (0, H),
        (c[0] * 0.7, c[1] * 0.7, c[2] * 0.7),
        rough=1.0,
    )
    _decal(s, L, W, H)


@builder("kerb", "free")
def kerb(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Kerb stones along X."""
    n = max(1, round(L / 100))
    for k in range(n):
        x = -L / 2 + L * k / n
        s.slab((x + 0.3, x + L / n - 0.3), (-W / 2, W / 2), (0, H), c, rough=0.95)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("platform", "free")
def platform(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Raised platform or stage with boards."""
    n = max(2, round(W / 25))
    for k in range(n):
        y = -W / 2 + W * k / n
        s.slab((-L / 2, L / 2), (y + 0.2, y + W / n - 0.2), (H * 0.85, H), c)
    s.slab((-L / 2 + 1, L / 2 - 1), (-W / 2 + 1, W / 2 - 1), (0, H * 0.85), shade(c, 0.7))
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("ramp", "free")
def ramp(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wedge with a level landing on its high end (-X), descending to +X."""
    landing = -L / 2 + min(L * 0.22, 120.0)
    side = [(-L / 2, 0.0), (L / 2, 0.0), (L / 2, H * 0.004), (landing, H), (-L / 2, H)]
    s.extrude(side, (-W / 2, W / 2), c, rough=0.8)
    # One piece: what goes down would catch on the seam of two, which its collisions know of.
    s.proxy_hull([(x, y * W / 2, z) for x, z in side for y in (-1, 1)])
    s.surface("top", H, ((landing + L / 2) / 2, W / 2), ((landing - L / 2) / 2, 0))


@builder("raised_chute", "free")
def raised_chute(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Trough on legs from a landing on its high end (-X) down to a lip at 0.6 of its height."""
    lip, t = 0.6 * H, 0.05 * H
    landing, rim = -L / 2 + 0.22 * L, 0.08 * W
    floor = [(-L / 2, H), (landing, H), (L / 2, lip), (L / 2, lip - t), (-L / 2, H - t)]
    s.extrude(floor, (-W / 2 + rim, W / 2 - rim), c, rough=0.6)
    # One piece: what goes down would catch on the seam of two, which its collisions know of.
    s.proxy_hull([(x, y * (W / 2 - rim), z) for x, z in floor for y in (-1, 1)])
    high = min(0.25 * W, 0.8 * (H - lip))
    level = landing + high * (L / 2 - landing) / (H - lip)
    wall = [(landing, H - t), (L / 2, lip - t), (L / 2, lip + high), (level, H), (landing, H)]
    for y in ((-W / 2, -W / 2 + rim), (W / 2 - rim, W / 2)):
        s.extrude(wall, y, shade(c, 0.85))
        s.proxy_hull([(x, q, z) for x, z in wall for q in y])
    leg = max(0.12 * W, 0.025 * L)
    for x in (-L / 2 + leg, 0.22 * L):
        top = H - t - (x + L / 2) / L * (H - lip) - 0.002 * H
        for y in (-1, 1):
            side = sorted((y * W / 2, y * (W / 2 - leg)))
            s.slab((x - leg / 2, x + leg / 2), (side[0], side[1]), (0, top), shade(c, 0.7), solid=1)
    s.surface("top", H, ((landing + L / 2) / 2, W / 2 - rim), ((landing - L / 2) / 2, 0))


@builder("stairs", "free")
def stairs(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Straight staircase descending from -X to +X; the number of steps follows the height."""
    n = max(2, round(H / 17))
    rise = H / n
    landing = L * 0.24 if L / n > 30 else L / n
    tread = (L - landing) / (n - 1)
    points = [(-L / 2, 0.0), (L / 2, 0.0)]
    for k in range(1, n):
        x = L / 2 - tread * (k - 1)
        points += [(x, rise * k), (x - tread, rise * k)]
    points += [(-L / 2 + landing, H), (-L / 2, H)]
    s.extrude(points, (-W / 2, W / 2), c, rough=0.9)
    for k in range(1, n):
        x1 = L / 2 - tread * (k - 1)
        s.proxy_slab((x1 - tread, x1), (-W / 2, W / 2), (0, rise * k))
        s.surface(f"step {k}", rise * k, (tread / 2, W / 2), (x1 - tread / 2, 0))
    s.proxy_slab((-L / 2, -L / 2 + landing), (-W / 2, W / 2), (0, H))
    s.surfaces.insert(
        0,
        s.surfaces[0].model_copy(
            update={
                "name": "top",
                "center_cm": (-L / 2 + landing / 2, 0.0, H),
                "half_extents_cm": (landing / 2, W / 2),
            }
        ),
    )


@builder("wall", "free")
def wall(s: Sketch, L: float, W: float, H: float, c: Color, bricks: bool = False) -> None:
    """Wall across Y, thickness along X, of bare bricks or in its own material."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H), c, of="brick" if bricks else "")
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("fence", "free")
def fence(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Picket fence across Y."""
    n = max(3, round(W / 14))
    m = max(2, round(W / 120) + 1)
    p = W / n * 0.34

    def pickets() -> Any:
        out = []
        for k in range(n):
            y = -W / 2 + W * (k + 0.5) / n
            top = [
                (y + p * math.cos(a), H - 1.15 * p + 1.15 * p * math.sin(a) ** 0.8)
                for a in (math.pi * j / 8 for j in range(9))
            ]
            out.append(
                shapes.extrude(
                    [(y - p, 0.04 * H), (y + p, 0.04 * H), *top], (-L * 0.04, L * 0.2), "yz"
                )
            )
        return forms.gather(out)

    s.add(pickets, c, of="paint" if s.material == "wood" else s.material, name="pickets")
    for z, word in ((H * 0.25, "low"), (H * 0.75, "high")):
        s.slab(
            (-L * 0.3, -L * 0.04),
            (-W / 2, W / 2),
            (z - 0.034 * H, z + 0.034 * H),
            shade(c, 0.94),
            name=f"rail_{word}",
        )
    for k in range(m):
        y = -W / 2 + 4 + (W - 8) * k / (m - 1)
        s.slab(
            (-L / 2, L * 0.1), (y - 4, y + 4), (0, H * 0.95), shade(c, 0.94), name=f"post_{k + 1}"
        )
        s.slab((-L / 2, L / 2), (y - 4.2, y + 4.2), (H * 0.95, H * 0.975), c, name=f"cap_{k + 1}")

    def nails() -> Any:
        heads = []
        for k in range(n):
            y = -W / 2 + W * (k + 0.5) / n
            for z in (H * 0.235, H * 0.265, H * 0.735, H * 0.765):
                heads.append(
                    forms.turned(
                        [(0.08 * p, L * 0.19), (0.08 * p, L * 0.2 + 0.02 * p)], (0, y, z), 6, "x"
                    )
                )
        return forms.gather(heads)

    s.add(nails, STEEL, name="nails")
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))


@builder("gate", "free")
def gate(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Closed double gate between two posts across Y."""
    post = min(L, W * 0.12)
    for y in (-1, 1):
        mid = y * (W / 2 - post / 2)
        s.slab((-post / 2, post / 2), (mid - post / 2, mid + post / 2), (0, H), c, solid=1)
        leaf = (2.0, W / 2 - post - 1) if y > 0 else (-W / 2 + post + 1, -2.0)
        for z in (H * 0.12, H * 0.5, H * 0.86):
            s.slab((-2, 2), leaf, (z - 3, z + 3), c)
        n = max(3, round((leaf[1] - leaf[0]) / 12))
        for k in range(n + 1):
            at = leaf[0] + 1.5 + (leaf[1] - leaf[0] - 3) * k / n
            s.rod(1.3, (0, at, 6), (0, at, H * 0.93), c, sections=10)
        s.proxy_slab((-2, 2), leaf, (5, H * 0.93), 0.3)


@builder("arch", "free")
def arch(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Open doorway or arch across Y: two piers and a lintel."""
    p = W * 0.14
    top = min(H * 0.16, 60.0)
    for y in ((-W / 2, -W / 2 + p), (W / 2 - p, W / 2)):
        s.slab((-L / 2, L / 2), y, (0, H - top), c, solid=1)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H - top, H), c, solid=1)
    s.region("inside", (-L / 2, L / 2), (-W / 2 + p, W / 2 - p), (0, H - top), "area")


@builder("door", "free")
def door(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Closed panel door in its frame, facing +X."""
    f = 6.0
    s.slab((-L / 2, L / 2), (-W / 2, -W / 2 + f), (0, H), WHITE, solid=1)
    s.slab((-L / 2, L / 2), (W / 2 - f, W / 2), (0, H), WHITE, solid=1)
    s.slab((-L / 2, L / 2), (-W / 2 + f, W / 2 - f), (H - f, H), WHITE, solid=1)
    s.slab((-L * 0.25, L * 0.25), (-W / 2 + f, W / 2 - f), (0.5, H - f), c, solid=1)
    for z0, z1 in ((0.08, 0.4), (0.5, 0.9)):
        for y in (-1, 1):
            a = (W * 0.05, W / 2 - f - W * 0.08)
            s.slab(
                (L * 0.25, L * 0.33),
                a if y > 0 else (-a[1], -a[0]),
                (H * z0, H * z1),
                shade(c, 0.9),
            )
    s.rod(
        2,
        (L * 0.25, W / 2 - f - 9, H * 0.48),
        (L * 0.49, W / 2 - f - 9, H * 0.48),
        STEEL,
    )


@builder("column", "free")
def column(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round pillar on a square plinth."""
    r = min(L, W) / 2
    p = min(H * 0.08, r * 0.6)
    s.slab((-r, r), (-r, r), (0, p), c, solid=1, rough=0.8)
    s.slab((-r, r), (-r, r), (H - p, H), c, solid=1, rough=0.8)
    s.lathe(
        [
            (0, p),
            (r * 0.86, p),
            (r * 0.7, p + r * 0.3),
            (r * 0.64, H - p - r * 0.3),
            (r * 0.82, H - p),
            (0, H - p),
        ],
        c,
        rough=0.8,
    )
    s.proxy_cylinder(r * 0.72, (p, H - p))
    s.surface("top", H, (r, r))


@builder("house", "free")
def house(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Gabled house, door facing +X."""
    e = H * 0.6
    s.slab((-L / 2 + 20, L / 2 - 20), (-W / 2 + 20, W / 2 - 20), (0, e), c, rough=0.9, solid=1)
    roof = [(-W / 2, e), (W / 2, e), (0, H)]
    s.extrude(roof, (-L / 2, L / 2), BRICK_RED, plane="yz", of="roof_tiles")
    s.proxy_hull([(x * L / 2, y, z) for y, z in roof for x in (-1, 1)], 0.3)
    f = L / 2 - 20
    s.slab((f, f + 4), (-45, 45), (0, 205), rgb(110, 60, 40), of="paint")
    for y in (-1, 1):
        at = y * W * 0.3
        s.slab((f, f + 3), (at - 50, at + 50), (90, 205), WHITE)
        s.slab(
            (f + 2, f + 4),
            (at - 44, at + 44),
            (96, 199),
            (0.3, 0.4, 0.5),
            rough=0.1,
            of="glass_dark",
        )
