"""What marks a kind of four-legged animal, from horns to spots: a drawing a mark."""

from __future__ import annotations

from collections.abc import Callable
import itertools
from typing import Any

from esg.assets.builders.common import bone, shade
from esg.assets.builders.living.beasts import Beast
from esg.assets.geometry.sketch import Color, Sketch, rgb
from esg.assets.lazy import forms
from esg.graph.models import Vec3

HAIR = rgb(42, 32, 28)
_IVORY = rgb(236, 228, 206)


def _horns(s: Sketch, b: Beast, c: Color) -> None:
    x, z = b.neck[:2]
    r = b.head[0]
    for side in (-1, 1):
        a = (x - 0.2 * r, side * 0.6 * r, z + 0.75 * r)
        m = (x, side * 1.45 * r, z + 1.0 * r)
        bone(s, a, 0.16 * r, m, 0.13 * r, _IVORY)
        bone(s, m, 0.13 * r, (x + 0.3 * r, side * 1.55 * r, z + 1.75 * r), 0.03 * r, _IVORY)


def _ossicones(s: Sketch, b: Beast, c: Color) -> None:
    x, z = b.neck[:2]
    r = b.head[0]
    for side in (-1, 1):
        a = (x - 0.2 * r, side * 0.4 * r, z + 0.7 * r)
        bone(s, a, 2.4, (a[0] - 2, a[1], a[2] + 16), 2.8, rgb(90, 64, 40))


def _antlers(s: Sketch, b: Beast, c: Color) -> None:
    x, z = b.neck[:2]
    r = b.head[0]
    for side in (-1, 1):
        a = (x - 0.3 * r, side * 0.45 * r, z + 0.8 * r)
        m = (x - 10, side * 18, z + 26)
        t = (x + 2, side * 24, z + 50)
        low = (m[0] + 5, m[1] + side * 3, m[2] + 11)
        bone(s, a, 1.6, m, 1.4, _IVORY)
        bone(s, m, 1.4, t, 0.7, _IVORY)
        bone(s, m, 1.2, (m[0] + 14, m[1] + side * 2, m[2] + 12), 0.6, _IVORY)
        bone(s, low, 1.1, (m[0] - 6, m[1] + side * 8, m[2] + 24), 0.5, _IVORY)


def _muzzle(b: Beast) -> Vec3:
    return (b.neck[0] + b.head[1], 0.0, b.neck[1] + b.head[2])


def _nose_horn(s: Sketch, b: Beast, c: Color) -> None:
    x, _, z = _muzzle(b)
    bone(s, (x + 6, 0, z + 12), 8, (x + 20, 0, z + 62), 1.5, _IVORY)


def _mane(s: Sketch, b: Beast, c: Color) -> None:
    x, z = b.neck[:2]
    r, rf = b.head[0], b.trunk[3]
    start, end = (b.legs[1] - 0.1 * rf, 0.0, b.trunk[1] + rf), (x - 0.8 * r, 0.0, z + 0.7 * r)
    bone(s, start, 5, end, 5.5, HAIR)


def _forelock(s: Sketch, b: Beast, c: Color) -> None:
    x, z = b.neck[:2]
    r = b.head[0]
    bone(s, (x - 2, 0, z + r), 3.5, (x + 0.8 * r, 0, z + 0.5 * r), 2, HAIR)


def _collar(s: Sketch, b: Beast, c: Color) -> None:
    x, z = b.neck[:2]
    front, zf = b.legs[1], b.trunk[1]
    t = 0.45
    p = (front + t * (x - front), 0.0, zf + t * (z - zf) + 1)
    q = (p[0] + 2.2, 0.0, p[2] + 1.6)
    s.rod(0.99 * b.neck[2], p, q, rgb(178, 34, 40), sections=28, of="leather", name="collar")


def _whiskers(s: Sketch, b: Beast, c: Color) -> None:
    x, _, z = _muzzle(b)
    muzzle = b.head[3]

    def make() -> Any:
        out = []
        for side in (-1, 1):
            for k in (-1, 0, 1):
                start = (x + 0.3 * muzzle, side * 0.6 * muzzle, z + (0.06 * k - 0.1) * muzzle)
                end = (
                    x + (0.1 + 0.5 * k) * muzzle,
                    side * 2.68 * muzzle,
                    z + (0.35 * k + 0.1) * muzzle,
                )
                out.append(forms.tube([start, end], [0.05, 0.02], 5, round_ends=False))
        return forms.gather(out)

    s.add(make, rgb(240, 240, 235), of="hair", name="whiskers")


def _patches(s: Sketch, b: Beast, c: Color) -> None:
    z = b.trunk[0]
    for px, pz, pr in ((-48, 10, 20), (2, -2, 24), (46, 12, 18)):
        for side in (-1, 1):
            s.ball(1, (px, side * 24, z + pz), rgb(44, 38, 36), scale=(pr, 11, pr * 0.8))


def _udder(s: Sketch, b: Beast, c: Color) -> None:
    place = (b.legs[0] + 16, 0, b.trunk[0] - b.trunk[2])
    s.ball(1, place, rgb(226, 168, 158), scale=(13, 10, 8))


def _wool(s: Sketch, b: Beast, c: Color) -> None:
    rear, front = b.legs[:2]
    z, r = b.trunk[0], b.trunk[2]

    def make() -> Any:
        out = []
        for k in range(5):
            for side in (-0.55, 0.55):
                x = rear + (front - rear) * (k / 4)
                for q, y, up in ((0.7, side * r, 0.3), (0.62, side * 1.3 * r, -0.3)):
                    size = (2 * q * r, 2 * q * r, 2 * q * r)
                    at = (x, y, z + up * r)
                    out.append(forms.cushion(size, at, plan=2, side=1, sections=14, levels=9))
        return forms.gather(out)

    s.add(make, c, of="fur", name="fleece")


def _snout(s: Sketch, b: Beast, c: Color) -> None:
    tip = _muzzle(b)
    s.rod(6.6, tip, (tip[0] + 7.4, 0, tip[2] - 1), shade(c, 0.85), sections=20)


def _trunk(s: Sketch, b: Beast, c: Color) -> None:
    x, z = b.neck[:2]
    path = [
        ((x + 34.0, 0.0, z - 30.0), 26.0),
        ((x + 66, 0, z - 80), 18.0),
        ((x + 68, 0, z - 140), 13.0),
        ((x + 84, 0, z - 186), 9.0),
    ]
    for (p, pr), (q, qr) in itertools.pairwise(path):
        bone(s, p, pr, q, qr, c)
    for side in (-1, 1):
        bone(s, (x + 34, side * 24, z - 44), 7, (x + 92, side * 30, z - 76), 2.5, _IVORY)


def _ruff(s: Sketch, b: Beast, c: Color) -> None:
    place = (b.neck[0] - 12, 0, b.neck[1] - 4)
    s.ball(1, place, rgb(112, 66, 30), scale=(17, 27, 30), rough=1.0)


def _hump(s: Sketch, b: Beast, c: Color) -> None:
    top = b.trunk[0] + b.trunk[2]
    bone(s, (-22, 0, top - 4), 20, (-16, 0, top + 14), 13, shade(c, 0.9))


def _scutes(s: Sketch, b: Beast, c: Color) -> None:
    rear, front = b.legs[:2]
    for k in range(9):
        x = rear - 30 + (front - rear + 60) * k / 8
        s.ball(1, (x, 0, b.trunk[0] + 16), shade(c, 0.7), scale=(6, 9, 6), detail=2)


def _along(b: Beast, t: float) -> tuple[float, float, float]:
    """Place along X, height and radius of the trunk from rear (0) to front (1)."""
    rear, front = b.legs[:2]
    zr, zf, rr, rf = b.trunk
    return rear + (front - rear) * t, zr + (zf - zr) * t, rr + (rf - rr) * t


def _rings(s: Sketch, b: Beast, count: int, tone: Color) -> None:
    for k in range(count):
        x, z, r = _along(b, (k + 0.5) / count)
        s.rod(r * 1.015, (x - 1.4, 0, z), (x + 1.4, 0, z), tone, sections=36)


def _stripes(s: Sketch, b: Beast, c: Color) -> None:
    _rings(s, b, 9, rgb(34, 32, 32))


def _bands(s: Sketch, b: Beast, c: Color) -> None:
    _rings(s, b, 8, rgb(40, 30, 24))


def _spots(s: Sketch, b: Beast, c: Color) -> None:
    for k in range(9):
        for side in (-1, 1):
            x, z, _ = _along(b, k / 8)
            place = (x, side * 0.86 * b.trunk[3], z + 14 * (k % 3 - 1))
            s.ball(1, place, rgb(122, 74, 36), scale=(8, 7, 8), detail=2)


MARKS: dict[str, Callable[[Sketch, Beast, Color], None]] = {
    "horns": _horns,
    "ossicones": _ossicones,
    "antlers": _antlers,
    "nose_horn": _nose_horn,
    "mane": _mane,
    "forelock": _forelock,
    "collar": _collar,
    "whiskers": _whiskers,
    "patches": _patches,
    "udder": _udder,
    "wool": _wool,
    "snout": _snout,
    "trunk": _trunk,
    "ruff": _ruff,
    "hump": _hump,
    "scutes": _scutes,
    "stripes": _stripes,
    "bands": _bands,
    "spots": _spots,
}
"""Drawn in this order."""
