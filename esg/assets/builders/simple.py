"""Plain bodies: also what an unknown noun falls back to."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import edge, shade
from esg.assets.geometry.rotations import ALONG
from esg.assets.geometry.sketch import Color, Sketch
from esg.assets.lazy import shapes
from esg.graph.models import ProxyKind


@builder("box", "free")
def box(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A solid cuboid."""
    s.box((L, W, H), (0, 0, H / 2), c, solid=1)
    s.surface("top", H, (L / 2, W / 2))


@builder("sphere")
def sphere(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A plain ball."""
    s.ball(H / 2, (0, 0, H / 2), c, solid=1, detail=4)


@builder("cylinder", "free")
def cylinder(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """An upright solid cylinder."""
    r = min(L, W) / 2
    s.rod(r, (0, 0, 0), (0, 0, H), c, solid=1, sections=48)
    s.surface("top", H, (r * 0.7, r * 0.7))


@builder("capsule")
def capsule(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A capsule lying along the front axis."""
    r = H / 2
    half = max(L / 2 - r, 0.0)
    n = 12
    arc = [(r * math.cos(a), -half + r * math.sin(a)) for a in _angles(-90, 0, n)]
    arc += [(r * math.cos(a), half + r * math.sin(a)) for a in _angles(0, 90, n)]
    s.lathe(arc, c, center=(0, 0, r), axis="x")
    s.proxy(ProxyKind.CAPSULE, (r, r, half), (0, 0, r), 1.0, ALONG["x"])


def _angles(start: float, end: float, n: int) -> list[float]:
    return [math.radians(start + (end - start) * k / n) for k in range(n + 1)]


@builder("brick", "free")
def brick(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A masonry brick with a frog."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.8), c, rough=0.95)
    t = min(L, W) * 0.16
    for x in (-1, 1):
        s.slab(edge(x, L, t), (-W / 2, W / 2), (H * 0.8, H), c, rough=0.95)
    for y in (-1, 1):
        s.slab((-L / 2 + t, L / 2 - t), edge(y, W, t), (H * 0.8, H), c, rough=0.95)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


@builder("domino", "free")
def domino(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A standing domino tile: thin along the front axis, pips on both faces."""
    s.box((L, W, H), (0, 0, H / 2), c, solid=1, rough=0.3)
    ink = (0.95, 0.95, 0.92) if sum(c) < 1.5 else (0.1, 0.1, 0.1)
    s.slab((-L / 2 - 0.02, L / 2 + 0.02), (-W * 0.42, W * 0.42), (H * 0.495, H * 0.505), ink)
    r = min(W, H / 2) * 0.08
    for z, spots in ((H * 0.25, ((-1, -1), (1, 1), (0, 0))), (H * 0.75, ((-1, 1), (1, -1)))):
        for y, up in spots:
            at = z + up * H * 0.13
            s.rod(
                r,
                (-L / 2 - 0.02, y * W * 0.25, at),
                (L / 2 + 0.02, y * W * 0.25, at),
                ink,
                sections=16,
            )
    s.surface("top", H, (L / 2, W / 2))


@builder("ring")
def ring(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A flat-lying ring (hoop, quoit, tyre); its proxy is twelve capsule segments."""
    minor = H / 2
    major = L / 2 - minor
    s.torus(major, minor, (0, 0, minor), c, rough=0.5)
    n = 12
    half = major * math.sin(math.pi / n)
    middle = major * math.cos(math.pi / n)
    from esg.assets.geometry.rotations import turn
    from esg.units import quat_multiply

    for k in range(n):
        angle = 360.0 * k / n
        a = math.radians(angle)
        q = quat_multiply(turn("z", angle), ALONG["y"])
        center = (middle * math.cos(a), middle * math.sin(a), minor)
        x, y, z, w = (float(v) for v in q)
        s.proxy(ProxyKind.CAPSULE, (minor, minor, half), center, 1.0, (x, y, z, w))


@builder("cone", "free")
def cone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A solid cone with a slightly blunt tip."""
    r = min(L, W) / 2
    s.lathe([(0, 0), (r, 0), (r * 0.06, H), (0, H)], c)
    ring_points = [
        (q * math.cos(a), q * math.sin(a), z)
        for q, z in ((r, 0.0), (r * 0.06, H))
        for a in _angles(0, 345, 23)
    ]
    s.proxy_hull(ring_points)


@builder("pyramid", "free")
def pyramid(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A square pyramid."""
    points = [(x * L / 2, y * W / 2, 0.0) for x in (-1, 1) for y in (-1, 1)] + [(0.0, 0.0, H)]

    s.add(lambda: shapes.hull(points), c)
    s.proxy_hull(points)


@builder("roller", "free")
def roller(s: Sketch, L: float, W: float, H: float, c: Color, hollow: bool = False) -> None:
    """Cylinder lying along X: a log, or a pipe with its bore drawn."""
    r = min(W, H) / 2
    rim = shade(c, 1.35)
    if hollow:
        q = r * 0.88
        profile = [(q, -L / 2), (r, -L / 2), (r, L / 2), (q, L / 2), (q, -L / 2)]
        s.lathe(profile, c, center=(0, 0, r), axis="x", rough=0.4, metal=0.5)
    else:
        s.rod(r, (-L / 2 + 0.3, 0, r), (L / 2 - 0.3, 0, r), c, rough=0.95, sections=36)
        for x in (-1, 1):
            ends = sorted((x * L / 2, x * (L / 2 - 0.4)))
            s.rod(r * 0.93, (ends[0], 0, r), (ends[1], 0, r), rim, rough=0.9, sections=36)
    s.proxy(ProxyKind.CYLINDER, (r, r, L / 2), (0, 0, r), 1.0, ALONG["x"])


@builder("ladder", "free")
def ladder(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Folding step ladder, climbed from +X."""
    t = min(4.0, W * 0.1)
    for y in (-W / 2 + t / 2, W / 2 - t / 2):
        for sign in (-1, 1):
            foot, top = sign * L / 2, sign * t * 0.8
            points = [(foot, 0), (foot - sign * t, 0), (top - sign * t, H), (top, H)]
            s.extrude(points, (y - t / 2, y + t / 2), c, metal=0.5)
            s.proxy_hull([(x, q, z) for x, z in points for q in (y - t / 2, y + t / 2)])
    n = max(2, round(H / 28))
    for k in range(1, n):
        z = H * k / n
        x = L / 2 + (t * 0.8 - L / 2) * k / n
        s.slab((x - 9 if x > 10 else x - 5, x), (-W / 2 + t, W / 2 - t), (z - 1.5, z + 1.5), c)
        s.proxy_slab((x - 5, x), (-W / 2 + t, W / 2 - t), (z - 1.5, z + 1.5))
    s.slab((-L * 0.12, L * 0.12), (-W / 2, W / 2), (H - 3, H), c, solid=1.0)
    s.surface("top", H, (L * 0.12, W / 2))
