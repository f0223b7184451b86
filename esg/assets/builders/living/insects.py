"""Small animals without bones: insects, snails and worms, a lobster, a starfish, an octopus."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import itertools
import math
from typing import Any

from esg.assets.appearance import FLYING
from esg.assets.builders import builder
from esg.assets.builders.common import blob, bone, prism, shade, shift
from esg.assets.geometry.sketch import DARK, Color, Sketch, rgb
from esg.assets.geometry.stretch import scaled
from esg.assets.lazy import forms, shapes
from esg.graph.models import Vec3

_SIDES = (-1, 1)
_BLACK, _WHITE = rgb(28, 26, 26), rgb(240, 238, 232)
_CLEAR = rgb(206, 218, 226)


@dataclass(frozen=True)
class Insect:
    """An insect that is 10 long from head to tail, whatever its size.

    Args:
        head: Radius.
        thorax: Half its length, width and height.
        abdomen: The same.
        stand: Height of the trunk's axis.
        reach: Of the legs to the side.
        horns: Length of the antennae.
        marks: What else is drawn.
        length: Of the drawing with antennae and wings; the row of the kind has its own.
        move: Offset that centres the drawing on the origin.
    """

    head: float
    thorax: Vec3
    abdomen: Vec3
    stand: float
    reach: float
    horns: float = 2.0
    marks: frozenset[str] = frozenset()
    length: float = 10.0
    move: float = 0.0


INSECTS: dict[str, Insect] = {
    "butterfly": Insect(
        0.75, (1.6, 0.85, 0.85), (3.0, 0.6, 0.65), 1.7, 1.6, 3.2, frozenset({"scaled"}), 12.0, -2.2
    ),
    "moth": Insect(
        0.9, (1.8, 1.2, 1.1), (2.8, 0.9, 0.85), 1.7, 1.6, 2.0, frozenset({"scaled"}), 11.8, -1.9
    ),
    "bee": Insect(
        1.35,
        (1.8, 1.9, 1.8),
        (2.9, 1.9, 1.75),
        2.7,
        2.8,
        1.6,
        frozenset({"banded", "clear", "fuzzy"}),
        10.5,
        -0.4,
    ),
    "wasp": Insect(
        1.1,
        (1.7, 1.3, 1.4),
        (3.3, 1.35, 1.3),
        2.6,
        3.0,
        2.0,
        frozenset({"banded", "clear", "waist"}),
        12.1,
    ),
    "fly": Insect(
        1.5, (1.9, 1.7, 1.6), (2.7, 1.7, 1.5), 2.4, 3.0, 0.7, frozenset({"clear", "red_eyes"}), 9.9
    ),
    "dragonfly": Insect(
        0.75,
        (1.25, 0.75, 0.8),
        (4.1, 0.3, 0.3),
        1.6,
        1.4,
        0.5,
        frozenset({"long_wings", "big_eyes"}),
        10.6,
        -0.2,
    ),
    "ladybug": Insect(
        1.7,
        (1.2, 2.6, 1.5),
        (4.2, 4.0, 3.4),
        1.6,
        4.4,
        1.4,
        frozenset({"shell", "spotted"}),
        11.7,
        0.6,
    ),
    "beetle": Insect(
        1.3,
        (1.6, 2.3, 1.4),
        (3.7, 2.7, 1.9),
        1.8,
        4.2,
        2.2,
        frozenset({"shell", "jaws"}),
        11.6,
        -0.3,
    ),
    "cockroach": Insect(
        0.9, (1.4, 1.9, 0.8), (4.2, 2.0, 0.9), 1.3, 3.4, 6.0, frozenset({"shell"}), 14.6, -1.8
    ),
    "ant": Insect(
        1.35,
        (1.7, 0.85, 0.95),
        (2.5, 1.5, 1.5),
        2.3,
        3.4,
        2.8,
        frozenset({"waist", "jaws"}),
        11.5,
        -0.8,
    ),
    "grasshopper": Insect(
        1.0, (1.7, 1.0, 1.15), (4.0, 0.9, 0.95), 2.4, 2.2, 2.6, frozenset({"jumper"}), 12.6, -0.2
    ),
}


def _leg(s: Sketch, x: float, side: int, b: Insect, foot: float, c: Color) -> None:
    hip = (x, side * 0.6 * b.thorax[1], b.stand - 0.3)
    knee = (
        x + 0.45 * foot,
        side * (0.6 * b.thorax[1] + 0.6 * (b.reach - 0.6 * b.thorax[1])),
        b.stand + 0.55,
    )
    end = (x + foot, side * b.reach, 0.1)
    bone(s, hip, 0.2, knee, 0.16, c, detail=1, of="horn")
    bone(s, knee, 0.16, end, 0.1, c, detail=1, of="horn")


def _trunk(s: Sketch, b: Insect, c: Color) -> tuple[Vec3, Vec3, Vec3]:
    """Draws head, thorax and abdomen; returns their middles."""
    t, a = b.thorax, b.abdomen
    lapped = 0.94 if "waist" in b.marks else 0.72
    head = (5 - b.head, 0.0, b.stand + 0.1)
    thorax = (head[0] - 0.6 * b.head - 0.8 * t[0], 0.0, b.stand + 0.15)
    tail = (thorax[0] - lapped * (t[0] + a[0]), 0.0, b.stand)
    dark = _BLACK if b.marks & {"banded", "scaled", "spotted"} else shade(c, 0.85)
    s.ball(1, head, dark, scale=(b.head, 1.05 * b.head, 0.95 * b.head))
    fuzz = rgb(150, 96, 30) if "fuzzy" in b.marks else dark
    s.ball(1, thorax, fuzz, scale=t, of="fur" if "fuzzy" in b.marks else "")
    if "shell" not in b.marks:
        s.ball(1, tail, dark if "scaled" in b.marks else c, scale=a)
    if "waist" in b.marks:
        bone(s, thorax, 0.3, tail, 0.3, dark)
    return head, thorax, tail


def _wing(
    s: Sketch,
    root: Vec3,
    side: int,
    along: tuple[float, float],
    wide: float,
    up: float,
    c: Color,
    *,
    alpha: float | None = None,
    name: str = "wing",
    thick: float = 0.06,
) -> None:
    """A flat oval wing from its root to a point `along` (forwards, out), raised by `up` [deg]."""
    rise = math.tan(math.radians(up))
    length = math.hypot(*along)
    ux, uy = along[0] / length, along[1] / length
    points: list[Vec3] = []
    for k in range(16):
        a = 2 * math.pi * k / 16
        d, q = 0.5 * length * (1 - math.cos(a)), wide * math.sin(a) * (0.75 - 0.25 * math.cos(a))
        x, y = root[0] + ux * d - uy * q, uy * d + ux * q
        points += [(x, root[1] + side * y, root[2] + rise * y + e) for e in (-thick, thick)]
    style = {} if alpha is None else {"alpha": alpha}
    prism(s, points, c, rough=0.5, name=name, **style)  # type: ignore[arg-type]


def _scaled_wings(s: Sketch, b: Insect, thorax: Vec3, c: Color) -> None:
    """Broad coloured wings with a black rim and pale dots: wide in flight, else half raised."""
    up = 14.0 if s.appearance.pose == FLYING else 30.0
    for side in _SIDES:
        root = (thorax[0], side * 0.4, thorax[2] + 0.4)
        for along, wide in (((4.6, 8.6), 3.1), ((-4.0, 6.2), 3.0)):
            _wing(s, root, side, along, wide, up, _BLACK, name="wing_rim")
            inner = (0.86 * along[0], 0.86 * along[1])
            _wing(
                s,
                (root[0] + 0.04 * along[0], root[1], root[2]),
                side,
                inner,
                0.8 * wide,
                up,
                c,
                thick=0.12,
            )
            for k in (-0.5, 0.0, 0.5):
                x, y = along[0] * (0.94 - 0.14 * abs(k)), along[1] * (0.94 - 0.14 * abs(k))
                x, y = x - k * 0.5 * wide, y + k * 0.3 * wide
                z = root[2] + math.tan(math.radians(up)) * y + 0.08
                s.ball(
                    1,
                    (root[0] + x, root[1] + side * y, z),
                    _WHITE,
                    scale=(0.26, 0.26, 0.1),
                    detail=2,
                )


def _clear_wings(s: Sketch, b: Insect, thorax: Vec3, c: Color) -> None:
    out = s.appearance.pose == FLYING
    for side in _SIDES:
        root = (thorax[0], side * 0.5 * b.thorax[1], thorax[2] + 0.8 * b.thorax[2])
        for along, wide in (
            ((0.2, 6.4) if out else (-4.6, 3.4), 1.2),
            ((-2.0, 4.6) if out else (-4.4, 2.0), 0.9),
        ):
            _wing(s, root, side, along, wide, 16, _CLEAR, alpha=0.55)


def _long_wings(s: Sketch, b: Insect, thorax: Vec3, c: Color) -> None:
    for side in _SIDES:
        for x, along in ((0.5, (0.9, 6.6)), (-0.6, (-1.1, 6.2))):
            root = (thorax[0] + x, side * 0.4, thorax[2] + 0.5)
            _wing(s, root, side, along, 0.62, 4, _CLEAR, alpha=0.6)


def _dome(s: Sketch, at: Vec3, size: Vec3, c: Color) -> None:
    """The upper half of an ellipsoid."""

    def make() -> Any:
        points = shapes.ball(1, at, size, 4).vertices
        return shapes.hull(points[points[:, 2] >= at[2] - 1e-6])

    s.add(make, c, rough=0.2, of="paint", name="shell")


def _shell(s: Sketch, b: Insect, tail: Vec3, c: Color) -> None:
    """Wing cases that meet in a seam, and the spots of a ladybird."""
    length, wide, high = b.abdomen
    middle = (tail[0] + 0.4, 0.0, b.stand)
    _dome(s, middle, (length, wide, high), c)
    _dome(s, middle, (1.01 * length, 0.035 * wide, 1.012 * high), _BLACK)
    s.ball(1, middle, _BLACK, scale=(0.97 * length, 0.97 * wide, 0.9 * b.stand))
    if "spotted" not in b.marks:
        return
    for side in _SIDES:
        for u, v in ((0.5, 0.42), (0.05, 0.62), (-0.45, 0.45)):
            up = math.sqrt(1 - u * u - v * v)
            at = (middle[0] + 0.9 * u * length, side * 0.9 * v * wide, b.stand + 0.9 * up * high)
            s.ball(0.72, at, _BLACK, detail=2)
        s.ball(0.5, (4.1 - 1.6, side * 1.5, b.stand + 1.1), _WHITE, detail=2)


def _bands(s: Sketch, b: Insect, tail: Vec3, c: Color) -> None:
    length, wide, high = b.abdomen
    for u in (-0.6, -0.12, 0.36):
        q = math.sqrt(1 - u * u) * 1.04
        s.ball(
            1, (tail[0] + u * length, 0, tail[2]), _BLACK, scale=(0.12 * length, q * wide, q * high)
        )


def _jumping(s: Sketch, b: Insect, thorax: Vec3, c: Color) -> None:
    """Long hind legs, folded, and wings that lie along the back."""
    for side in _SIDES:
        hip, knee = (
            (thorax[0] - 1.2, side * 0.9, b.stand),
            (thorax[0] - 4.4, side * 1.7, b.stand + 3.0),
        )
        bone(s, hip, 0.5, knee, 0.22, c, detail=1)
        bone(s, knee, 0.18, (thorax[0] - 5.0, side * 2.0, 0.12), 0.12, shade(c, 0.8), detail=1)
    bone(s, (thorax[0], 0, b.stand + 0.8), 0.6, (-4.9, 0, b.stand + 0.5), 0.35, shade(c, 0.8))


@builder("insect")
def insect(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "beetle") -> None:
    """A six-legged animal facing +X, drawn ten long; what flies spreads its wings in flight."""
    b = INSECTS[kind]
    head, thorax, tail = _trunk(s, b, c)
    tone = _BLACK if b.marks & {"banded", "spotted", "scaled"} else shade(c, 0.7)
    for side in _SIDES:
        for x, foot in ((0.7, 1.7), (-0.2, 0.0), (-0.9, -2.0)):
            if not ("jumper" in b.marks and foot < 0):
                _leg(s, thorax[0] + x * b.thorax[0], side, b, foot, tone)
        start = (head[0] + 0.5 * b.head, side * 0.35 * b.head, head[2] + 0.5 * b.head)
        end = (
            start[0] + 0.75 * b.horns,
            side * (0.35 * b.head + 0.45 * b.horns),
            start[2] + min(0.35 * b.horns, 1.0),
        )
        bone(s, start, 0.1, end, 0.07 if "scaled" not in b.marks else 0.16, tone, detail=1)
        eye = 0.52 if "big_eyes" in b.marks else 0.5 if "red_eyes" in b.marks else 0.3
        at = (head[0] + 0.35 * b.head, side * 0.75 * b.head, head[2] + 0.3 * b.head)
        s.ball(
            eye * b.head,
            at,
            rgb(150, 30, 26) if "red_eyes" in b.marks else DARK,
            detail=2,
            rough=0.15,
        )
        if "jaws" in b.marks:
            bone(
                s,
                (head[0] + 0.6 * b.head, side * 0.5, head[2] - 0.3),
                0.22,
                (head[0] + 1.5 * b.head, side * 0.15, head[2] - 0.4),
                0.08,
                tone,
                detail=1,
            )
    for mark, draw, at in (
        ("scaled", _scaled_wings, thorax),
        ("clear", _clear_wings, thorax),
        ("long_wings", _long_wings, thorax),
        ("shell", _shell, tail),
        ("banded", _bands, tail),
        ("jumper", _jumping, thorax),
    ):
        if mark in b.marks:
            draw(s, b, at, c)
    half = max(0.8 * b.reach, b.abdomen[1])
    low = max(b.stand - 0.6 * max(b.thorax[2], b.abdomen[2]), 0.3)
    s.proxy_slab((-4.2, 4.2), (-half, half), (0, low), 0.4)
    wide, top = max(b.thorax[1], b.abdomen[1]), b.stand + 0.9 * max(b.thorax[2], b.abdomen[2])
    s.proxy_slab((-4.2, 4.6), (-0.9 * wide, 0.9 * wide), (low, top), 1.0)
    if "jumper" in b.marks:
        s.proxy_slab((-4.2, -1.2), (-1.6, 1.6), (top, 4.6), 0.1)
    if "scaled" in b.marks:
        s.proxy_slab((-2.4, 4.6), (-5, 5), (top, 5.6), 0.05)
    shift(s, b.move)
    small = scaled(s, L / b.length)
    s.parts[:], s.proxies[:] = small.parts, small.proxies


def _snail(s: Sketch, c: Color) -> None:
    """A snail with a coiled shell, 7 cm long."""
    _slug(s, rgb(176, 150, 112))
    turns: list[tuple[Vec3, float]] = []
    for k in range(48):
        t = k / 47
        a, r = 0.4 + 5.0 * math.pi * t, 1.6 * (1 - t) ** 0.9
        at = (-0.86 + r * math.cos(a), 0.3 * t, 2.35 + r * math.sin(a))
        turns.append((at, 0.85 * (1 - 0.8 * t)))
    for (p, pr), (q, qr) in itertools.pairwise(turns):
        bone(s, p, pr, q, qr, c, detail=2, of="horn")
    for side in _SIDES:
        seam = [(p[0], side * (0.9 * r + 0.25), p[2]) for p, r in turns]
        s.add(lambda p=seam: forms.tube(p, 0.1, 8), shade(c, 0.5), of="horn", name="seam")
    s.proxy_slab((-2.5, 1.0), (-1.1, 1.1), (0.9, 4.4), 1.0)


def _slug(s: Sketch, c: Color) -> None:
    blob(s, [((-3.2, 0, 0.25), 0.25), ((0, 0, 0.75), 0.75), ((2.2, 0, 0.9), 0.7)], c, of="skin")
    bone(s, (2.2, 0, 0.95), 0.68, (3.2, 0, 1.5), 0.5, c, of="skin")
    for side in _SIDES:
        bone(s, (3.2, side * 0.25, 1.7), 0.14, (3.9, side * 0.6, 2.9), 0.1, c, detail=1, of="skin")
        s.ball(0.18, (3.9, side * 0.6, 2.95), DARK, detail=2)
        bone(s, (3.5, side * 0.2, 1.3), 0.1, (4.1, side * 0.35, 1.2), 0.07, c, detail=1, of="skin")
    s.proxy_slab((-3.2, 3.2), (-0.7, 0.7), (0, 0.9), 1.0)
    s.proxy_slab((2.6, 4.0), (-0.7, 0.7), (0.9, 2.6), 0.2)
    shift(s, -0.36)


def _caterpillar(s: Sketch, c: Color) -> None:
    for k in range(9):
        x = -3.6 + 0.85 * k
        z = 0.75 + (0.5 * math.sin(math.pi * (k - 2) / 4) if 2 < k < 6 else 0.0)
        s.ball(0.66, (x, 0, z), c if k % 2 else shade(c, 1.3), detail=3)
        for side in _SIDES:
            s.ball(0.17, (x, side * 0.45, max(z - 0.6, 0.17)), _BLACK, detail=1)
    s.ball(0.74, (3.85, 0, 0.95), rgb(150, 60, 34))
    for side in _SIDES:
        s.ball(0.15, (4.4, side * 0.34, 1.15), _BLACK, detail=2)
        bone(s, (4.0, side * 0.3, 1.5), 0.07, (4.3, side * 0.6, 2.2), 0.09, _BLACK, detail=1)
    s.proxy_slab((-4.1, 4.4), (-0.62, 0.62), (0, 1.5), 1.0)
    s.proxy_slab((3.2, 4.5), (-0.6, 0.6), (1.5, 2.1), 0.1)


def _worm(s: Sketch, c: Color) -> None:
    path = [(-7 + 14 * k / 40, 1.1 * math.sin(2.6 * math.pi * k / 40), 0.42) for k in range(41)]
    radii = [0.42 * min(1.0, 0.35 + 0.09 * k, 0.3 + 0.09 * (40 - k)) for k in range(41)]
    s.add(lambda: forms.tube(path, radii, 12), c, of="skin", name="body")
    s.add(lambda: forms.tube(path[26:31], 0.47, 12), shade(c, 1.25), of="skin", name="saddle")
    s.proxy_slab((-7, 7), (-1.1, 1.1), (0, 0.84), 1.0)


def _lobster(s: Sketch, c: Color) -> None:
    """A lobster with a fan of a tail, 40 cm long."""
    blob(s, [((-3, 0, 4), 3), ((6, 0, 4), 2.6), ((9, 0, 4.2), 1.2)], c, of="horn")
    for k in range(6):
        s.ball(
            1,
            (-5 - 2.2 * k, 0, 3.7 - 0.3 * k),
            shade(c, 0.9 + 0.12 * (k % 2)),
            scale=(1.7, 2.9 - 0.2 * k, 2.2 - 0.15 * k),
            of="horn",
        )
    for a in (-40, -20, 0, 20, 40):
        turn = math.radians(a)
        end = (-17.6 - 4.2 * math.cos(turn), 4.2 * math.sin(turn), 1.0)
        bone(s, (-17, 0, 1.6), 0.8, end, 0.9, shade(c, 0.85), of="horn")
    for side in _SIDES:
        bone(s, (5, side * 2.2, 3.4), 0.8, (9, side * 5.4, 3), 0.9, c, of="horn")
        bone(s, (9, side * 5.4, 3), 0.9, (12, side * 5.2, 2.6), 1.2, c, of="horn")
        blob(
            s,
            [
                ((13, side * 5.2, 2.5), 1.7),
                ((16.5, side * 5.6, 2.4), 1.5),
                ((20, side * 4.2, 2.4), 0.4),
            ],
            c,
            of="horn",
        )
        blob(
            s,
            [((14, side * 3.8, 2.4), 0.8), ((19, side * 2.9, 2.4), 0.35)],
            shade(c, 1.1),
            of="horn",
        )
        for x in (3.5, 1.2, -1.2, -3.2):
            bone(s, (x, side * 2, 3), 0.4, (x, side * 5, 3.8), 0.35, shade(c, 0.85), detail=1)
            bone(
                s,
                (x, side * 5, 3.8),
                0.35,
                (x - 0.6, side * 6.8, 0.25),
                0.2,
                shade(c, 0.85),
                detail=1,
            )
        s.ball(0.42, (9, side * 0.9, 5), DARK, detail=2)
        bone(s, (9.6, side * 0.6, 4.6), 0.2, (17, side * 8, 8), 0.08, shade(c, 0.8), detail=1)
    s.proxy_slab((-20, 18), (-5.4, 5.4), (0, 2), 0.5)
    s.proxy_slab((-18, 9), (-2.8, 2.8), (2, 6), 1.0)
    shift(s, 1)


def _scorpion(s: Sketch, c: Color) -> None:
    """A scorpion with its sting raised, 9 cm long."""
    blob(s, [((-1.4, 0, 1.1), 0.8), ((1.4, 0, 1.1), 0.75)], c, of="horn")
    path = [(-2, 0, 1.2), (-3.6, 0, 1.6), (-4.2, 0, 3.0), (-3.2, 0, 4.2), (-1.8, 0, 4.3)]
    for (p, q), r in zip(itertools.pairwise(path), (0.5, 0.46, 0.42, 0.4), strict=True):
        bone(s, p, r, q, r, c, detail=2, of="horn")
    bone(s, (-1.8, 0, 4.3), 0.46, (-0.8, 0, 3.6), 0.06, shade(c, 0.6), of="horn")
    for side in _SIDES:
        bone(s, (1.6, side * 0.5, 1), 0.28, (2.8, side * 1.9, 1), 0.28, c, of="horn")
        blob(s, [((3.0, side * 1.9, 1), 0.5), ((4.6, side * 1.5, 1), 0.12)], c, of="horn")
        bone(s, (3.2, side * 1.2, 1), 0.26, (4.5, side * 0.9, 1), 0.1, shade(c, 1.1), of="horn")
        for x, foot in ((1.0, 0.8), (0.3, 0.2), (-0.5, -0.6), (-1.2, -1.4)):
            bone(s, (x, side * 0.5, 1), 0.16, (x + 0.5 * foot, side * 1.6, 1.5), 0.13, c, detail=1)
            bone(
                s,
                (x + 0.5 * foot, side * 1.6, 1.5),
                0.13,
                (x + foot, side * 2.4, 0.1),
                0.08,
                c,
                detail=1,
            )
    s.proxy_slab((-2.2, 2.8), (-2.0, 2.0), (0, 1.0), 0.6)
    s.proxy_slab((-2.8, 2.2), (-0.8, 0.8), (1.0, 1.9), 1.0)
    s.proxy_slab((-4.4, -1.0), (-0.4, 0.4), (1.9, 4.4), 0.15)


def _starfish(s: Sketch, c: Color) -> None:
    for k in range(5):
        a = 2 * math.pi * k / 5
        x, y = math.cos(a), math.sin(a)
        bone(s, (2 * x, 2 * y, 1.2), 1.2, (9.2 * x, 9.2 * y, 0.5), 0.5, c, of="leather")
        bone(
            s,
            (2 * x, 2 * y, 0.9),
            2.1 * 0.45,
            (6 * x, 6 * y, 1.1),
            0.75,
            shade(c, 1.15),
            of="leather",
        )
    s.ball(1, (0, 0, 1.1), c, scale=(2.8, 2.8, 1.1), of="leather")
    s.proxy_cylinder(6.5, (0, 2.0), 1.0)
    shift(s, -0.88)


def _octopus(s: Sketch, c: Color) -> None:
    """An octopus on its arms, 60 cm across."""
    blob(s, [((-5, 0, 15), 9), ((4, 0, 8.5), 6.5)], c, detail=3, of="skin")
    for side in _SIDES:
        s.ball(1.9, (7.4, side * 4.2, 11.6), _WHITE, detail=2)
        s.ball(1.1, (8.6, side * 4.7, 12), DARK, detail=2)
    for k in range(8):
        a = math.pi * (2 * k + 1) / 8
        x, y = math.cos(a), math.sin(a)
        path = [
            (2 + 3 * x, 3 * y, 6),
            (2 + 12 * x - 2 * y, 12 * y + 2 * x, 2.6),
            (2 + 20 * x + 2 * y, 20 * y - 2 * x, 1.5),
            (2 + 27 * x - 3 * y, 27 * y + 3 * x, 0.6),
        ]
        radii = [3.2 - 2.6 * j / 15 for j in range(16)]
        s.add(
            lambda p=path, r=radii: forms.tube(forms.smooth_path(p, 16), r, 10),
            c,
            of="skin",
            name="arm",
        )
    s.proxy_cylinder(20, (0, 4), 0.5, (2, 0))
    s.proxy_slab((-13, 9), (-8, 8), (4, 23), 1.0)
    shift(s, -2)


CRAWLERS: dict[str, Callable[[Sketch, Color], None]] = {
    "snail": _snail,
    "slug": _slug,
    "caterpillar": _caterpillar,
    "worm": _worm,
    "lobster": _lobster,
    "scorpion": _scorpion,
    "starfish": _starfish,
    "octopus": _octopus,
}


@builder("crawler")
def crawler(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "snail") -> None:
    """A small animal without bones that creeps, facing +X."""
    CRAWLERS[kind](s, c)
