"""Balls of all sports; the proxy is always the exact sphere."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.collider import lying_hull
from esg.assets.geometry.sketch import BLUE, DARK, RED, WHITE, Color, Sketch
from esg.assets.lazy import shapes

PHI = (1 + math.sqrt(5)) / 2
ICOSAHEDRON = [
    v for a in (-1, 1) for b in (-PHI, PHI) for v in ((0.0, a, b), (a, b, 0.0), (b, 0.0, a))
]


def _sphere(s: Sketch, r: float, c: Color, rough: float = 0.5) -> None:
    s.ball(r, (0, 0, r), c, solid=1, rough=rough, detail=4)


def _band(s: Sketch, r: float, c: Color, axis: str, offset: float, width: float) -> None:
    """A seam: a thin belt on the ball at `offset` along `axis`."""
    at = {"x": (offset, 0.0, r), "y": (0.0, offset, r), "z": (0.0, 0.0, r + offset)}[axis]
    s.torus(math.sqrt(r * r - offset * offset) - width * 0.25, width, at, c, axis=axis, rough=0.7)


@builder("soccer_ball")
def soccer_ball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """White ball with twelve dark pentagons."""
    r = H / 2
    _sphere(s, r, WHITE if sum(c) > 2.4 else c, 0.4)
    for n in ICOSAHEDRON:
        s.add(lambda n=n: shapes.shell_patch(n, 20.5, r * 1.003, r * 0.03, 5, (0, 0, r)), DARK, 0.4)


@builder("basketball")
def basketball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Orange ball with eight-panel seams."""
    r = H / 2
    _sphere(s, r, c, 0.8)
    w = r * 0.018
    _band(s, r, DARK, "z", 0, w)
    _band(s, r, DARK, "x", 0, w)
    for y in (-0.62, 0.62):
        _band(s, r, DARK, "y", y * r, w)


@builder("volleyball")
def volleyball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ball with three pairs of coloured belts."""
    r = H / 2
    _sphere(s, r, WHITE, 0.5)
    for axis, color in (("x", BLUE), ("y", (0.93, 0.75, 0.2)), ("z", (0.85, 0.86, 0.86))):
        for k in (-0.3, 0.3):
            _band(s, r, color, axis, k * r, r * 0.03)


@builder("tennis_ball")
def tennis_ball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Felt ball with the curved seam (also baseball and softball)."""
    r = H / 2
    _sphere(s, r, c, 0.95)
    seam = RED if sum(c) > 2.4 else WHITE
    a, b, n = 0.75, 0.25, 40
    path = []
    for k in range(n + 1):
        t = 2 * math.pi * k / n
        p = (
            a * math.cos(t) + b * math.cos(3 * t),
            a * math.sin(t) - b * math.sin(3 * t),
            2 * math.sqrt(a * b) * math.sin(2 * t),
        )
        q = r * 1.0 / math.sqrt(sum(v * v for v in p))
        path.append((p[0] * q, p[1] * q, r + p[2] * q))
    s.pipe(r * 0.025, path, seam, rough=0.9)


@builder("bowling_ball")
def bowling_ball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Polished ball with three finger holes."""
    r = H / 2
    s.add(lambda: _drilled(r), c, 0.12)
    from esg.graph.models import ProxyKind

    s.proxy(ProxyKind.SPHERE, (r, r, r), (0, 0, r))


def _drilled(r: float) -> Any:
    holes = []
    for dx, dy, q in ((0.22, 0.13, 0.1), (0.22, -0.13, 0.1), (-0.18, 0.0, 0.12)):
        z = math.sqrt(1 - dx * dx - dy * dy)
        d = (dx, dy, z)
        holes.append(shapes.rod(q * r, [0.72 * v * r for v in d], [1.2 * v * r for v in d], 20))
    for h in holes:
        h.apply_translation((0, 0, r))
    return shapes.cut(shapes.ball(r, (0, 0, r), detail=4), holes)


@builder("billiard_ball")
def billiard_ball(
    s: Sketch, L: float, W: float, H: float, c: Color, plain: bool = False, eight: bool = False
) -> None:
    """Glossy ball; numbered ones carry a white spot on either side."""
    r = H / 2
    _sphere(s, r, c, 0.08)
    if plain:
        return
    if eight:
        for side in (-1, 1):
            n = (float(side), 0.0, 0.0)
            s.add(
                lambda n=n: shapes.shell_patch(n, 26, r * 1.004, r * 0.03, 32, (0, 0, r)),
                WHITE,
                0.1,
            )
            for z in (-0.13, 0.13):
                s.torus(0.11 * r, 0.03 * r, (side * 0.998 * r, 0, r + z * r), DARK, axis="x")
        return
    for n in ((1, 0.15, 0.5), (-1, -0.15, -0.5)):
        s.add(lambda n=n: shapes.shell_patch(n, 24, r * 1.004, r * 0.03, 32, (0, 0, r)), WHITE, 0.1)
        s.add(lambda n=n: shapes.shell_patch(n, 9, r * 1.007, r * 0.03, 4, (0, 0, r)), DARK, 0.1)


@builder("golf_ball")
def golf_ball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Ball with dimples drawn as shaded dots."""
    r = H / 2
    _sphere(s, r, c, 0.25)
    n = 90
    dimple = shade(c, 0.86)
    for k in range(n):
        z = 1 - 2 * (k + 0.5) / n
        a = k * math.pi * (3 - math.sqrt(5))
        q = math.sqrt(1 - z * z)
        d = (q * math.cos(a), q * math.sin(a), z)
        s.add(
            lambda d=d: shapes.shell_patch(d, 5.2, r * 1.002, r * 0.02, 8, (0, 0, r)),
            dimple,
            0.3,
        )


@builder("beach_ball")
def beach_ball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Striped inflatable ball."""
    r = H / 2
    _sphere(s, r, WHITE, 0.3)
    colors = (RED, (0.95, 0.8, 0.15), BLUE)
    for k in range(3):
        a = 2 * math.pi * k / 3
        s.add(
            lambda a=a: shapes.lune(a, math.pi / 3, r * 1.003, r * 0.03, (0, 0, r)), colors[k], 0.3
        )


@builder("american_football")
def american_football(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Prolate ball lying along the front axis on a small flat; the proxy is a convex hull."""
    r, a = H / 2, L / 2
    profile = [
        (r * math.cos(t) ** 1.35, a * math.sin(t))
        for t in (math.radians(v) for v in range(-90, 91, 9))
    ]
    s.lathe(profile, c, center=(0, 0, r), axis="x", rough=0.7)
    for x in (-0.55, 0.55):
        q = next(p[0] for p in profile if p[1] >= x * a)
        s.torus(q * 0.98, r * 0.03, (x * a, 0, r), WHITE, axis="x")
    s.rod(r * 0.04, (-a * 0.3, 0, 2 * r), (a * 0.3, 0, 2 * r), WHITE, sections=10)
    s.proxy_hull(lying_hull([(x, q) for q, x in profile[::2]], r, 12))


@builder("puck", "free")
def puck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A flat disc."""
    r = min(L, W) / 2
    s.lathe(
        [(0, 0), (r * 0.97, 0), (r, H * 0.15), (r, H * 0.85), (r * 0.97, H), (0, H)], c, rough=0.5
    )
    s.proxy_cylinder(r, (0, H))
    s.surface("top", H, (r * 0.7, r * 0.7))
