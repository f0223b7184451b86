"""Balls of all sports; the proxy is always the exact sphere."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.collider import lying_hull
from esg.assets.geometry.sketch import BLUE, DARK, RED, WHITE, Color, Sketch
from esg.assets.lazy import forms, shapes

PHI = (1 + math.sqrt(5)) / 2
ICOSAHEDRON = [
    v for a in (-1, 1) for b in (-PHI, PHI) for v in ((0.0, a, b), (a, b, 0.0), (b, 0.0, a))
]


def _sphere(s: Sketch, r: float, c: Color, rough: float = 0.5) -> None:
    s.ball(r, (0, 0, r), c, solid=1, rough=rough, detail=4, name="ball")


def _band(s: Sketch, r: float, c: Color, axis: str, offset: float, width: float) -> None:
    """A seam: a thin belt on the ball at `offset` along `axis`."""
    at = {"x": (offset, 0.0, r), "y": (0.0, offset, r), "z": (0.0, 0.0, r + offset)}[axis]
    s.torus(
        math.sqrt(r * r - offset * offset) - width * 0.25,
        width,
        at,
        c,
        axis=axis,
        rough=0.7,
        name=f"seam_{axis}_{round(offset / r * 10)}",
    )


def _pentagons() -> list[tuple[tuple[float, float, float], float]]:
    """Middles of the dark panels, and the turn [deg] that points their corners at each other."""
    import numpy as np

    corners = np.array(ICOSAHEDRON) / math.sqrt(1 + PHI * PHI)
    out = []
    for n in corners:
        near = corners[np.argsort(-(corners @ n))[1]]
        helper = np.array([0.0, 0, 1]) if abs(n[2]) < 0.9 else np.array([1.0, 0, 0])
        u = np.cross(n, helper)
        u /= np.linalg.norm(u)
        w = np.cross(n, u)
        out.append(((n[0], n[1], n[2]), math.degrees(math.atan2(near @ w, near @ u))))
    return out


def _hexagon_seams(r: float) -> Any:
    """Seams between white panels: along the edges of an icosahedron, between its pentagons."""
    import numpy as np

    corners = np.array(ICOSAHEDRON) / math.sqrt(1 + PHI * PHI)
    out = []
    for i, a in enumerate(corners):
        for b in corners[:i]:
            if a @ b > 0.4:
                path = np.array([a + (b - a) * u for u in np.linspace(0.32, 0.68, 6)])
                path *= 0.9975 * r / np.linalg.norm(path, axis=1, keepdims=True)
                out.append(forms.tube(np.add(path, (0, 0, r)), 0.011 * r, 5, round_ends=False))
    return forms.gather(out)


@builder("soccer_ball")
def soccer_ball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """White ball with twelve dark pentagons."""
    r = H / 2
    _sphere(s, r, WHITE if sum(c) > 2.4 else c, 0.4)
    s.add(
        lambda: forms.gather(
            [
                shapes.shell_patch(n, 20.5, r * 1.003, r * 0.03, 5, (0, 0, r), a)
                for n, a in _pentagons()
            ]
        ),
        DARK,
        of="leather_ball",
        name="pentagons",
    )
    s.add(lambda: _hexagon_seams(r), shade(WHITE, 0.55), of="leather_ball", name="seams")


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
    a, b, n = 0.75, 0.25, 96
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
    s.add(lambda: forms.tube(path[:-1], r * 0.028, 8, closed=True), seam, of="rubber", name="seam")


@builder("bowling_ball")
def bowling_ball(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Polished ball with three finger holes."""
    r = H / 2
    s.add(lambda: _drilled(r), c, name="ball")
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


_DIGITS = (
    ((-0.5, 0.9), (0.5, 0.9), (0.0, 0.15), (0.5, -0.3), (0.25, -0.85), (-0.3, -0.9), (-0.5, -0.6)),
    ((-0.3, 0.6), (0.1, 0.95), (0.1, -0.95)),
    ((-0.5, 0.6), (-0.1, 0.95), (0.4, 0.75), (0.4, 0.3), (-0.5, -0.9), (0.5, -0.9)),
    ((0.3, -0.95), (0.3, 0.95), (-0.5, -0.3), (0.55, -0.3)),
    ((0.45, 0.9), (-0.35, 0.9), (-0.4, 0.1), (0.2, 0.2), (0.5, -0.3), (0.2, -0.9), (-0.45, -0.8)),
    (
        (0.4, 0.9),
        (-0.2, 0.4),
        (-0.45, -0.4),
        (-0.1, -0.9),
        (0.35, -0.7),
        (0.4, -0.2),
        (0.0, 0.05),
        (-0.4, -0.2),
    ),
    ((-0.5, 0.9), (0.5, 0.9), (-0.1, -0.95)),
)
"""Strokes of the numbers 3, 1, 2, 4, 5, 6, 7, in a square of side 2."""


def _number(r: float, digit: int) -> Any:
    """The number of a ball on both of its spots."""
    import numpy as np
    from shapely.geometry import LineString

    shape = LineString([(0.16 * r * y, 0.18 * r * z) for y, z in _DIGITS[digit]]).buffer(
        0.042 * r, quad_segs=3
    )
    out = []
    skin = shapes.ball(r * 1.009, (0, 0, 0), detail=5)
    for n in ((1, 0.15, 0.5), (-1, -0.15, -0.5)):
        d = np.array(n) / np.linalg.norm(n)
        left = np.cross([0, 0, 1.0], d)
        left /= np.linalg.norm(left)
        frame = np.array([d, left, np.cross(d, left)])
        mesh = forms.inlay(skin, forms.prism(shape, (0.9 * r, 1.1 * r), "yz"))
        mesh.vertices = np.asarray(mesh.vertices) @ frame + [0, 0, r]
        out.append(mesh)
    return forms.gather(out)


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
                of="phenolic_ball",
            )
            for z in (-0.13, 0.13):
                s.torus(0.11 * r, 0.03 * r, (side * 0.998 * r, 0, r + z * r), DARK, axis="x")
        return
    spots = ((1, 0.15, 0.5), (-1, -0.15, -0.5))
    s.add(
        lambda: forms.gather(
            [shapes.shell_patch(n, 24, r * 1.004, r * 0.03, 32, (0, 0, r)) for n in spots]
        ),
        WHITE,
        of="phenolic_ball",
        name="spots",
    )
    digit = s.appearance.pick("number", len(_DIGITS))
    s.add(lambda: _number(r, digit), DARK, of="phenolic_ball", name="number")


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
            lambda a=a: shapes.lune(a, math.pi / 3, r * 1.003, r * 0.03, (0, 0, r)),
            colors[k],
            of="inflatable",
            name=f"gore_{k + 1}",
        )
    for z, word in ((-1, "low"), (1, "high")):
        n = (0.0, 0.0, float(z))
        s.add(
            lambda n=n: shapes.shell_patch(n, 13, r * 1.006, r * 0.03, 32, (0, 0, r)),
            WHITE,
            name=f"cap_{word}",
        )
    s.add(
        lambda: forms.turned(
            [(0.05 * r, 1.99 * r), (0.05 * r, 2.012 * r), (0.03 * r, 2.02 * r)], sections=16
        ),
        WHITE,
        of="plastic_hard",
        name="valve",
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
