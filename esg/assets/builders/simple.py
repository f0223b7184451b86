"""Plain bodies: also what an unknown noun falls back to."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import edge, shade
from esg.assets.geometry.rotations import ALONG
from esg.assets.geometry.sketch import BRASS, DARK, Color, Sketch
from esg.assets.lazy import forms, shapes
from esg.graph.models import ProxyKind

BEAM = (0.48, 0.33, 0.2)
"""Colour of a timber frame."""


@builder("box", "free")
def box(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A solid cuboid."""
    s.box((L, W, H), (0, 0, H / 2), c, solid=1)
    s.surface("top", H, (L / 2, W / 2))


@builder("sphere")
def sphere(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A plain ball."""
    s.ball(H / 2, (0, 0, H / 2), c, solid=1, detail=4)


@builder("bead")
def bead(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A drop that lies on something: round above, flat below; it slides and does not roll."""
    r = L / 2
    dome = [(r * math.cos(a), 0.25 * H + 0.75 * H * math.sin(a)) for a in _angles(0, 90, 12)]
    s.lathe([(0, 0), (0.8 * r, 0), *dome], c, rough=0.05, of="water", alpha=0.7)
    s.proxy_cylinder(0.85 * r, (0, H))


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
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.8), c)
    t = min(L, W) * 0.16
    for x in (-1, 1):
        s.slab(edge(x, L, t), (-W / 2, W / 2), (H * 0.8, H), c)
    for y in (-1, 1):
        s.slab((-L / 2 + t, L / 2 - t), edge(y, W, t), (H * 0.8, H), c)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))


PIPS = {
    1: ((0, 0),),
    2: ((-1, 1), (1, -1)),
    3: ((-1, -1), (1, 1), (0, 0)),
    4: ((-1, -1), (-1, 1), (1, -1), (1, 1)),
    5: ((-1, -1), (-1, 1), (1, -1), (1, 1), (0, 0)),
    6: ((-1, -1), (-1, 0), (-1, 1), (1, -1), (1, 0), (1, 1)),
}
_UPRIGHT = ((0, 0, 1, 0), (0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 0, 1))


@builder("domino", "free")
def domino(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A standing domino tile: thin along the front axis, pips on both faces."""
    s.add(
        lambda: (
            forms.cushion((H, W, L), (0, 0, 0), plan=16, side=0.16, sections=36, levels=7)
            .apply_transform(_UPRIGHT)
            .apply_translation((0, 0, H / 2))
        ),
        c,
        of="ceramic",
        name="tile",
    )
    s.proxy_box((L / 2, W / 2, H / 2), (0, 0, H / 2), 1)
    ink = (0.95, 0.95, 0.92) if sum(c) < 1.5 else (0.1, 0.1, 0.1)
    d = 0.012 * min(W, H)
    s.slab(
        (-L / 2 - d, L / 2 + d),
        (-W * 0.42, W * 0.42),
        (H * 0.495, H * 0.505),
        ink,
        of="paint",
        name="line",
    )
    r = min(W, H / 2) * 0.085
    halves = (
        1 + s.appearance.pick("low", 6) if s.appearance.seed is not None else 3,
        1 + s.appearance.pick("high", 6) if s.appearance.seed is not None else 2,
    )
    for z, count, word in ((H * 0.25, halves[0], "low"), (H * 0.75, halves[1], "high")):
        spots = [(y * W * 0.25, z + up * H * 0.13) for y, up in PIPS[count]]
        s.add(
            lambda spots=spots: forms.gather(
                [
                    forms.turned(
                        [
                            (0.6 * r, -L / 2 - d),
                            (r, -L / 2 - 0.4 * d),
                            (r, L / 2 + 0.4 * d),
                            (0.6 * r, L / 2 + d),
                        ],
                        (0, y, at),
                        18,
                        "x",
                    )
                    for y, at in spots
                ]
            ),
            ink,
            of="paint",
            name=f"pips_{word}",
        )
    s.add(
        lambda: forms.turned(
            [(0.5 * r, -L / 2 - 1.4 * d), (0.5 * r, L / 2 + 1.4 * d)], (0, 0, H / 2), 14, "x"
        ),
        BRASS,
        name="pin",
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
        s.lathe(profile, c, center=(0, 0, r), axis="x", rough=0.4)
    else:
        s.rod(r, (-L / 2 + 0.3, 0, r), (L / 2 - 0.3, 0, r), c, rough=0.95, sections=36)
        for x in (-1, 1):
            ends = sorted((x * L / 2, x * (L / 2 - 0.4)))
            s.rod(r * 0.93, (ends[0], 0, r), (ends[1], 0, r), rim, rough=0.9, sections=36)
    s.proxy(ProxyKind.CYLINDER, (r, r, L / 2), (0, 0, r), 1.0, ALONG["x"])


@builder("climbing_rope", "free")
def climbing_rope(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A knotted rope that hangs from the beam of a frame across Y."""
    post, r, low = min(L, 0.06 * W), 2.2, 12.0
    for y in (-W / 2 + post / 2, W / 2 - post / 2):
        s.slab((-post / 2, post / 2), (y - post / 2, y + post / 2), (0, H), BEAM, of="wood",
               solid=1.0, name="post")  # fmt: skip
        s.slab((-L / 2, L / 2), (y - post / 2, y + post / 2), (0, 5), BEAM, of="wood", solid=1.0,
               name="foot")  # fmt: skip
    half = W / 2 - post
    s.slab((-r, r), (-half, half), (H - 12, H), BEAM, of="wood", solid=1.0, name="beam")
    s.rod(r, (0, 0, low), (0, 0, H - 12), c, solid=1.0, rough=0.95, sections=12, name="rope")
    for k in range(max(2, round((H - 40) / 45))):
        s.ball(1.5 * r, (0, 0, low + 8 + 45 * k), c, rough=0.95)


@builder("ladder", "free")
def ladder(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Folding step ladder, climbed from +X."""
    t = min(4.0, W * 0.1)
    for y in (-W / 2 + t / 2, W / 2 - t / 2):
        for sign in (-1, 1):
            foot, top = sign * L / 2, sign * t * 0.8
            points = [(foot, 0), (foot - sign * t, 0), (top - sign * t, H), (top, H)]
            s.extrude(points, (y - t / 2, y + t / 2), c, name="rail")
            inner = min(foot, foot - sign * 1.1 * t), max(foot, foot - sign * 1.1 * t)
            s.slab(
                inner,
                (y - 0.6 * t, y + 0.6 * t),
                (0, min(0.025 * H, 1.4 * t)),
                DARK,
                of="rubber",
                name="foot",
            )
            s.proxy_hull([(x, q, z) for x, z in points for q in (y - t / 2, y + t / 2)])
    n = max(2, round(H / 28))
    for k in range(1, n):
        z = H * k / n
        x = L / 2 + (t * 0.8 - L / 2) * k / n
        deep = 9 if x > 10 else 5
        s.slab(
            (x - deep, x),
            (-W / 2 + 0.6 * t, W / 2 - 0.6 * t),
            (z - 1.5, z + 1.5),
            c,
            name=f"step_{k}",
        )
        s.slab(
            (x - deep, x),
            (-W / 2 + t, W / 2 - t),
            (z + 1.5, z + 1.9),
            DARK,
            of="rubber",
            name=f"tread_{k}",
        )
        s.proxy_slab((x - 5, x), (-W / 2 + t, W / 2 - t), (z - 1.5, z + 1.5))
    for y in (-W / 2 + t / 2, W / 2 - t / 2):
        z, reach = 0.42 * H, L / 2 - (L / 2 - 0.8 * t) * 0.42
        s.rod(
            0.12 * t,
            (-reach + 0.5 * t, y, z),
            (reach - 0.5 * t, y, z),
            DARK,
            of="steel",
            sections=8,
            name="spreader",
        )
    s.slab((-L * 0.12, L * 0.12), (-W / 2, W / 2), (H - 3, H), c, solid=1.0, name="platform")
    s.surface("top", H, (L * 0.12, W / 2))
