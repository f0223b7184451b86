"""Four-legged animals, all from one plan: trunk, neck, head, legs, tail and what marks the kind.

They stand on four boxes, carry a box for the trunk and one for the head; the trunk's top is the
surface "back", so that something can ride on it.
"""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import bone, mirrored, shade, shift
from esg.assets.builders.living.beasts import BEASTS, Beast
from esg.assets.builders.living.marks import HAIR, MARKS
from esg.assets.geometry.sketch import DARK, Color, Sketch, rgb


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
    _tail(s, b, HAIR if kind == "horse" else c)
    _body(s, b, c)
    _ears(s, b, c)
    for mark, draw in MARKS.items():
        if mark in b.marks:
            draw(s, b, c)
    _proxies(s, b)
    shift(s, b.move)
