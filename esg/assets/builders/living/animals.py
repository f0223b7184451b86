"""Four-legged animals, all from one plan: trunk, neck, head, legs, tail and what marks the kind.

They stand on four boxes, carry a box for the trunk and one for the head; the trunk's top is the
surface "back", so that something can ride on it.
"""

from __future__ import annotations

import itertools

from esg.assets.builders import builder
from esg.assets.builders.common import bone, mirrored, shade, shift
from esg.assets.builders.living.beasts import BEASTS, Beast
from esg.assets.geometry.sketch import DARK, Color, Sketch, rgb

_IVORY = rgb(236, 228, 206)


def _legs(s: Sketch, b: Beast, c: Color) -> None:
    rear, front, across, top, foot = b.legs
    for x, z in ((rear, b.trunk[0]), (front, b.trunk[1])):
        for side in (-1, 1):
            y = side * across
            hip = (x, y * 0.8, z - 0.25 * b.trunk[2])
            if "sprawl" in b.marks:
                bone(s, (x, y * 0.5, z * 0.8), top, (x + 4, y, foot), foot, c)
            else:
                knee = (x + (0.5 if x > 0 else -0.5) * top, y, z * 0.45)
                low = 0.5 * (top + foot)
                bone(s, hip, top, knee, low * 0.8, c)
                bone(s, knee, low * 0.8, (x, y, foot), foot, c)
            if "hooves" in b.marks or "socks" in b.marks:
                tone = DARK if "hooves" in b.marks else shade(c, 0.35)
                s.rod(foot * 1.12, (x, y, 0), (x, y, foot * 1.7), tone, sections=16)


def _ears(s: Sketch, b: Beast, c: Color) -> None:
    kind, length = b.ears
    x, z = b.neck[:2]
    r = b.head[0]
    for side in (-1, 1):
        root = (x - 0.35 * r, side * 0.62 * r, z + 0.72 * r)
        if kind == "point":
            tip = (x - 0.5 * r, side * 0.85 * r, z + 0.6 * r + length)
            bone(s, root, length * 0.26, tip, length * 0.05, shade(c, 0.85))
        elif kind == "long":
            tip = (x - 0.8 * r, side * 0.75 * r, z + 0.8 * r + length)
            bone(s, root, length * 0.13, tip, length * 0.1, shade(c, 0.92))
        elif kind == "flop":
            tip = (x - 0.3 * r, side * 1.2 * r, z + 0.6 * r - 0.75 * length)
            bone(s, root, length * 0.22, tip, length * 0.24, shade(c, 0.7))
        elif kind == "fan":
            s.ball(
                1,
                (x - 0.7 * r, side * (0.75 * r + 0.3 * length), z + 0.1 * r),
                shade(c, 0.9),
                scale=(0.12 * length, 0.5 * length, 0.62 * length),
            )
        elif kind == "disc":
            s.ball(
                1,
                (root[0], root[1] * 1.2, root[2] + 0.4 * length),
                shade(c, 1.2),
                scale=(0.25 * length, 0.6 * length, 0.7 * length),
            )
        elif kind == "round":
            s.ball(length, root, shade(c, 0.85), detail=2)


def _horns(s: Sketch, b: Beast) -> None:
    x, z = b.neck[:2]
    r = b.head[0]
    for side in (-1, 1):
        if "horns" in b.marks:
            a = (x - 0.2 * r, side * 0.6 * r, z + 0.75 * r)
            m = (x, side * 1.45 * r, z + 1.0 * r)
            bone(s, a, 0.16 * r, m, 0.13 * r, _IVORY)
            bone(s, m, 0.13 * r, (x + 0.3 * r, side * 1.55 * r, z + 1.75 * r), 0.03 * r, _IVORY)
        if "ossicones" in b.marks:
            a = (x - 0.2 * r, side * 0.4 * r, z + 0.7 * r)
            bone(s, a, 2.4, (a[0] - 2, a[1], a[2] + 16), 2.8, rgb(90, 64, 40))
        if "antlers" in b.marks:
            a = (x - 0.3 * r, side * 0.45 * r, z + 0.8 * r)
            m = (x - 10, side * 18, z + 26)
            t = (x + 2, side * 24, z + 50)
            bone(s, a, 1.6, m, 1.4, _IVORY)
            bone(s, m, 1.4, t, 0.7, _IVORY)
            bone(s, m, 1.2, (m[0] + 14, m[1] + side * 2, m[2] + 12), 0.6, _IVORY)
            bone(
                s,
                (m[0] + 5, m[1] + side * 3, m[2] + 11),
                1.1,
                (m[0] - 6, m[1] + side * 8, m[2] + 24),
                0.5,
                _IVORY,
            )
    if "nose_horn" in b.marks:
        tip = (x + b.head[1], 0.0, z + b.head[2])
        bone(s, (tip[0] + 6, 0, tip[2] + 12), 8, (tip[0] + 20, 0, tip[2] + 62), 1.5, _IVORY)


def _marks(s: Sketch, b: Beast, c: Color) -> None:
    rear, front = b.legs[:2]
    zr, zf, rr, rf = b.trunk
    x, z = b.neck[:2]
    r = b.head[0]
    marks = b.marks
    if "mane" in marks:
        start, end = (front - 0.1 * rf, 0.0, zf + rf), (x - 0.8 * r, 0.0, z + 0.7 * r)
        bone(s, start, 5, end, 5.5, rgb(42, 32, 28))
    if "forelock" in marks:
        bone(s, (x - 2, 0, z + r), 3.5, (x + 0.8 * r, 0, z + 0.5 * r), 2, rgb(42, 32, 28))
    if "collar" in marks:
        t = 0.45
        p = (front + t * (x - front), 0.0, zf + t * (z - zf) + 1)
        q = (p[0] + 2.2, 0.0, p[2] + 1.6)
        s.rod(0.99 * b.neck[2], p, q, rgb(178, 34, 40), sections=24)
    if "whiskers" in marks:
        for side in (-1, 1):
            s.rod(
                0.12,
                (x + 6, side * 1.5, z - 2),
                (x + 6, side * 7, z - 1),
                rgb(240, 240, 235),
                sections=6,
            )
    if "patches" in marks:
        for px, pz, pr in ((-48, 10, 20), (2, -2, 24), (46, 12, 18)):
            for side in (-1, 1):
                s.ball(1, (px, side * 24, zr + pz), rgb(44, 38, 36), scale=(pr, 11, pr * 0.8))
    if "udder" in marks:
        s.ball(1, (rear + 16, 0, zr - rr), rgb(226, 168, 158), scale=(13, 10, 8))
    if "wool" in marks:
        n = 5
        for k in range(n):
            for side in (-0.55, 0.55):
                t = k / (n - 1)
                px = rear + (front - rear) * t
                s.ball(0.7 * rr, (px, side * rr, zr + 0.3 * rr), c, rough=1.0, detail=2)
                s.ball(0.62 * rr, (px, side * 1.3 * rr, zr - 0.3 * rr), c, rough=1.0, detail=2)
    if "snout" in marks:
        tip = (x + b.head[1], 0.0, z + b.head[2])
        s.rod(6.6, tip, (tip[0] + 7.4, 0, tip[2] - 1), shade(c, 0.85), sections=20)
    if "trunk" in marks:
        tip = (x + 34.0, 0.0, z - 30.0)
        path = [
            (tip, 26.0),
            ((x + 66, 0, z - 80), 18.0),
            ((x + 68, 0, z - 140), 13.0),
            ((x + 84, 0, z - 186), 9.0),
        ]
        for (p, pr), (q, qr) in itertools.pairwise(path):
            bone(s, p, pr, q, qr, c)
        for side in (-1, 1):
            bone(s, (x + 34, side * 24, z - 44), 7, (x + 92, side * 30, z - 76), 2.5, _IVORY)
    if "ruff" in marks:
        s.ball(1, (x - 12, 0, z - 4), rgb(112, 66, 30), scale=(17, 27, 30), rough=1.0)
    if "hump" in marks:
        bone(s, (-22, 0, zr + rr - 4), 20, (-16, 0, zr + rr + 14), 13, shade(c, 0.9))
    if "scutes" in marks:
        for k in range(9):
            px = rear - 30 + (front - rear + 60) * k / 8
            s.ball(1, (px, 0, zr + 16), shade(c, 0.7), scale=(6, 9, 6), detail=2)
    bands = {"stripes": (9, rgb(34, 32, 32)), "bands": (8, rgb(40, 30, 24))}
    for mark, (count, tone) in bands.items():
        if mark in marks:
            for k in range(count):
                t = (k + 0.5) / count
                px, pr = rear + (front - rear) * t, rr + (rf - rr) * t
                pz = zr + (zf - zr) * t
                s.rod(pr * 1.015, (px - 1.4, 0, pz), (px + 1.4, 0, pz), tone, sections=36)
    if "spots" in marks:
        for k in range(9):
            for side in (-1, 1):
                t = k / 8
                px, pz = rear + (front - rear) * t, zr + (zf - zr) * t
                up = 14 * (k % 3 - 1)
                s.ball(
                    1, (px, side * 0.86 * rf, pz + up), rgb(122, 74, 36), scale=(8, 7, 8), detail=2
                )


def _tail(s: Sketch, b: Beast, c: Color) -> None:
    length, droop, root, tip = b.tail
    level = max(0.0, 1 - abs(droop))
    start = (b.legs[0] - 0.8 * b.trunk[2], 0.0, b.trunk[0] + 0.5 * b.trunk[2])
    end = (start[0] - length * level - 2, 0.0, start[2] - length * droop)
    if end[2] < tip:
        end = (end[0], 0.0, tip)
    bone(s, start, root, end, tip, c)
    if b.marks & {"tip", "tuft"}:
        tone = rgb(240, 236, 228) if "tip" in b.marks else rgb(96, 58, 28)
        s.ball(1.3 * tip, end, tone, detail=2)


def _body(s: Sketch, b: Beast, c: Color) -> None:
    rear, front = b.legs[:2]
    zr, zf, rr, rf = b.trunk
    x, z, thick, thin = b.neck
    r, reach, drop, muzzle = b.head
    bone(s, (rear, 0, zr), rr, (front, 0, zf), rf, c, detail=3)
    bone(s, (front, 0, zf + 0.3 * (rf - thick)), thick, (x - 0.3 * r, 0, z), thin, c)
    bone(s, (x, 0, z), r, (x + reach, 0, z + drop), muzzle, c, detail=3)
    s.ball(
        1,
        (x + reach + 0.75 * muzzle, 0, z + drop + 0.3 * muzzle),
        DARK,
        scale=(0.34 * muzzle, 0.5 * muzzle, 0.34 * muzzle),
        detail=2,
    )
    for side in (-1, 1):
        s.ball(0.13 * r, (x + 0.5 * r, side * 0.78 * r, z + 0.42 * r), DARK, rough=0.15, detail=2)


def _proxies(s: Sketch, b: Beast) -> None:
    rear, front, across, top, _ = b.legs
    zr, zf, rr, rf = b.trunk
    x, z = b.neck[:2]
    r, reach, drop, muzzle = b.head
    low = max(min(zr - 0.7 * rr, zf - 0.7 * rf), 0.2 * zr)
    high = max(zr + 0.85 * rr, zf + 0.85 * rf)
    half = max(0.8 * top, 0.35 * across)
    for px in (rear, front):
        for side in (-1, 1):
            s.proxy_slab(
                (px - half, px + half),
                mirrored(side, across - half, across + half),
                (0, low),
                0.8,
            )
    back = (rear - 0.8 * rr, front + 0.8 * rf)
    wide = 0.88 * max(rr, rf)
    s.proxy_slab(back, (-wide, wide), (low, high), 1.0)
    top_z = z + 0.9 * r
    face = min(low if z - 1.2 * r < high else high, z - 0.9 * r)
    near = max(back[1], x - 0.9 * r)
    s.proxy_slab(
        (near, max(x + reach + 0.8 * muzzle, near + r)),
        (-0.75 * r, 0.75 * r),
        (max(face, z + drop - 1.2 * muzzle), top_z),
        0.7,
    )
    if top_z - 1.8 * r > high:
        s.proxy_slab((front - 0.4 * rf, x + 0.6 * r), (-0.6 * r, 0.6 * r), (high, top_z), 0.4)
    s.surface(
        "back", high, (0.32 * (back[1] - back[0]), 0.6 * wide), (0.5 * (back[0] + back[1]), 0)
    )


@builder("quadruped")
def quadruped(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "dog") -> None:
    """A four-legged animal facing +X, drawn in the proportions of its kind."""
    b = BEASTS[kind]
    limb = rgb(58, 50, 46) if kind == "sheep" else c
    _legs(s, b, limb)
    _tail(s, b, rgb(42, 32, 28) if kind == "horse" else c)
    _body(s, b, c)
    _ears(s, b, c)
    _horns(s, b)
    _marks(s, b, c)
    _proxies(s, b)
    shift(s, b.move)
