"""Marks of wild animals and pets: plumes, masks, patches, horns and wings, to the beast's scale."""

from __future__ import annotations

from collections.abc import Callable
import itertools
import math

from esg.assets.builders.common import blob, bone, prism, shade
from esg.assets.builders.living.beasts import Beast
from esg.assets.geometry.sketch import Color, Sketch, rgb
from esg.assets.lazy import forms
from esg.graph.models import Vec3

Mark = Callable[[Sketch, Beast, Color], None]
BLACK, PALE = rgb(30, 28, 28), rgb(242, 238, 228)
_IVORY, _HORN = rgb(236, 228, 206), rgb(84, 74, 62)
_SIDES = (-1, 1)


def _head(b: Beast) -> tuple[float, float, float]:
    """x, z and radius of the head."""
    return b.neck[0], b.neck[1], b.head[0]


def _muzzle(b: Beast) -> Vec3:
    return (b.neck[0] + b.head[1], 0.0, b.neck[1] + b.head[2])


def _at(b: Beast, t: float) -> tuple[float, float, float]:
    """x, height of the axis and radius of the trunk from rear (0) to front (1)."""
    rear, front = b.legs[:2]
    zr, zf, rr, rf = b.trunk
    return rear + (front - rear) * t, zr + (zf - zr) * t, rr + (rf - rr) * t


def _plume(s: Sketch, b: Beast, c: Color) -> None:
    """A bushy tail, raised and curled back."""
    x, z, r = _at(b, 0)
    path = [
        (x - 0.6 * r, 0, z + 0.3 * r),
        (x - 1.9 * r, 0, z + 1.0 * r),
        (x - 1.9 * r, 0, z + 2.6 * r),
        (x - 1.5 * r, 0, z + 3.8 * r),
        (x - 2.3 * r, 0, z + 4.5 * r),
    ]
    radii = forms.profile([(0, 0.3 * r), (0.3, 0.8 * r), (0.7, 0.95 * r), (1, 0.35 * r)])
    s.add(
        lambda: forms.tube(
            forms.smooth_path(path, 16), radii([k / 15 for k in range(16)]), 12, flat=0.8
        ),
        PALE if "white_back" in b.marks else shade(c, 1.12),
        of="fur",
        name="plume",
    )
    s.proxy_slab((x - 2.6 * r, x - 1.2 * r), (-0.6 * r, 0.6 * r), (z, z + 4.5 * r), 0.08)


def _bib(s: Sketch, b: Beast, c: Color) -> None:
    """Pale chest and cheeks."""
    x, z, r = _at(b, 1)
    s.ball(1, (x + 0.3 * r, 0, z - 0.2 * r), PALE, scale=(0.8 * r, 0.72 * r, 0.84 * r), of="fur")
    mx, _, mz = _muzzle(b)
    hx, _, hr = _head(b)
    at = (0.5 * (hx + mx), 0.0, mz - 0.3 * hr)
    s.ball(1, at, PALE, scale=(0.72 * hr, 0.8 * hr, 0.5 * hr), of="fur")


def _saddle(s: Sketch, b: Beast, c: Color) -> None:
    """A white band about the middle, and a blaze."""
    x, z, r = _at(b, 0.55)
    s.ball(1, (x, 0, z), PALE, scale=(0.55 * r, 1.03 * r, 1.05 * r), of="fur")
    hx, hz, hr = _head(b)
    s.ball(1, (hx + 0.4 * hr, 0, hz + 0.3 * hr), PALE, scale=(hr, 0.24 * hr, 0.68 * hr), of="fur")


def _eye_patches(s: Sketch, b: Beast, c: Color) -> None:
    x, z, r = _head(b)
    for side in _SIDES:
        at = (x + 0.5 * r, side * 0.5 * r, z + 0.26 * r)
        s.ball(1, at, BLACK, scale=(0.34 * r, 0.3 * r, 0.36 * r), of="fur")


def _yoke(s: Sketch, b: Beast, c: Color) -> None:
    """A black band over the shoulders, down to the fore legs."""
    x, z, r = _at(b, 0.94)
    s.ball(1, (x, 0, z), BLACK, scale=(0.46 * r, 1.07 * r, 1.09 * r), of="fur")


def _swept_horns(s: Sketch, b: Beast, c: Color) -> None:
    x, z, r = _head(b)
    for side in _SIDES:
        path = [
            (x - 0.1 * r, side * 0.35 * r, z + 0.75 * r),
            (x - 0.5 * r, side * 0.55 * r, z + 2.0 * r),
            (x - 2.0 * r, side * 0.95 * r, z + 2.5 * r),
        ]
        s.add(
            lambda p=path: forms.tube(
                forms.smooth_path(p, 10), [0.28 * r * (1 - 0.085 * k) for k in range(10)], 10
            ),
            _HORN,
            of="horn",
            name="horn",
        )


def _lyre_horns(s: Sketch, b: Beast, c: Color) -> None:
    x, z, r = _head(b)
    for side in _SIDES:
        path = [
            (x - 0.1 * r, side * 0.35 * r, z + 0.8 * r),
            (x - 0.9 * r, side * 1.0 * r, z + 2.6 * r),
            (x - 0.7 * r, side * 0.7 * r, z + 4.6 * r),
        ]
        s.add(
            lambda p=path: forms.tube(
                forms.smooth_path(p, 10), [0.2 * r * (1 - 0.085 * k) for k in range(10)], 10
            ),
            BLACK,
            of="horn",
            name="horn",
        )


def _beard(s: Sketch, b: Beast, c: Color) -> None:
    x, _, z = _muzzle(b)
    m = b.head[3]
    bone(
        s,
        (x - 0.4 * m, 0, z - 0.8 * m),
        0.55 * m,
        (x - 0.7 * m, 0, z - 2.6 * m),
        0.12 * m,
        shade(c, 0.7),
        of="fur",
    )


def _pale_muzzle(s: Sketch, b: Beast, c: Color) -> None:
    x, _, z = _muzzle(b)
    m = b.head[3]
    s.ball(1, (x + 0.1 * m, 0, z), PALE, scale=(1.05 * m, 1.04 * m, 1.06 * m), of="fur")


def _shag(s: Sketch, b: Beast, c: Color) -> None:
    """Long dark hair over shoulders and head."""
    x, z, r = _at(b, 0.9)
    dark = shade(c, 0.6)
    s.ball(1, (x, 0, z + 0.12 * r), dark, scale=(0.95 * r, 1.06 * r, 1.1 * r), of="fur")
    hx, hz, hr = _head(b)
    s.ball(1, (hx - 0.2 * hr, 0, hz + 0.25 * hr), dark, scale=(hr, 1.05 * hr, 1.02 * hr), of="fur")


def _spot(s: Sketch, places: list[Vec3], r: float, c: Color, flat: float = 0.4) -> None:
    """Flat spots on the sides of a trunk, as one part."""
    s.add(
        lambda: forms.gather(
            [
                forms.cushion(
                    (2 * r, 2 * flat * r, 1.7 * r), p, plan=2, side=1, sections=10, levels=7
                )
                for p in places
            ]
        ),
        c,
        of="fur",
        name="spots",
    )


def _rosettes(s: Sketch, b: Beast, c: Color) -> None:
    """Dark spots over back, sides and haunches."""
    places: list[Vec3] = []
    for k in range(12):
        x, z, r = _at(b, -0.12 + 1.24 * k / 11)
        for j, turn in enumerate((8, 40, 72, 108, 140, 172)):
            a = math.radians(turn + (14 if k % 2 else 0) - 7)
            lean = 0.94 if 0 <= k - 1 <= 9 else 0.84
            places.append(
                (x + (j % 2) * 0.12 * r, lean * r * math.cos(a), z + lean * r * math.sin(a))
            )
    _spot(s, places, 0.15 * b.trunk[3], BLACK, 1.0)
    hx, hz, hr = _head(b)
    crown = [
        (hx - 0.3 * hr + 0.5 * hr * i, j * 0.4 * hr, hz + 0.86 * hr - 0.2 * hr * abs(j))
        for i in (0, 1)
        for j in (-1, 0, 1)
    ]
    _spot(s, crown, 0.1 * hr, BLACK, 1.0)


def _tears(s: Sketch, b: Beast, c: Color) -> None:
    x, z, r = _head(b)
    mx, _, mz = _muzzle(b)
    m = b.head[3]
    for side in _SIDES:
        start, end = (x + 0.72 * r, side * 0.5 * r, z + 0.16 * r), (mx, side * 0.8 * m, mz)
        bone(s, start, 0.1 * r, end, 0.1 * r, BLACK, of="fur")


def _side_band(s: Sketch, b: Beast, c: Color) -> None:
    """A dark band along each flank above a white belly."""
    (x0, z0, r0), (x1, z1, r1) = _at(b, 0), _at(b, 1)
    for side in _SIDES:
        bone(
            s,
            (x0, side * 0.84 * r0, z0 - 0.22 * r0),
            0.17 * r0,
            (x1, side * 0.84 * r1, z1 - 0.22 * r1),
            0.17 * r1,
            BLACK,
            of="fur",
        )
    bone(s, (x0, 0, z0 - 0.3 * r0), 0.75 * r0, (x1, 0, z1 - 0.3 * r1), 0.75 * r1, PALE, of="fur")


def _tusks(s: Sketch, b: Beast, c: Color) -> None:
    """Nostrils and two teeth on a broad muzzle."""
    x, _, z = _muzzle(b)
    m = b.head[3]
    for side in _SIDES:
        s.ball(0.16 * m, (x + 0.6 * m, side * 0.45 * m, z + 0.72 * m), shade(c, 0.6), detail=2)
        bone(
            s,
            (x + 0.66 * m, side * 0.5 * m, z - 0.5 * m),
            0.1 * m,
            (x + 0.78 * m, side * 0.5 * m, z - 0.1 * m),
            0.04 * m,
            _IVORY,
            of="horn",
        )


def _mammoth_trunk(s: Sketch, b: Beast, c: Color) -> None:
    """A trunk, and tusks that curl up."""
    x, z, r = _head(b)
    path = [
        (x + 0.6 * r, 0, z - 0.5 * r),
        (x + 1.2 * r, 0, z - 1.5 * r),
        (x + 1.2 * r, 0, z - 2.6 * r),
        (x + 1.6 * r, 0, z - 3.3 * r),
    ]
    radii = [0.46 * r * (1 - 0.05 * k) for k in range(14)]
    s.add(lambda: forms.tube(forms.smooth_path(path, 14), radii, 14), c, of="fur", name="trunk")
    for side in _SIDES:
        tusk = [
            (x + 0.5 * r, side * 0.45 * r, z - 0.8 * r),
            (x + 1.3 * r, side * 0.95 * r, z - 2.2 * r),
            (x + 2.4 * r, side * 0.9 * r, z - 2.4 * r),
            (x + 3.0 * r, side * 0.5 * r, z - 1.5 * r),
        ]
        thin = [0.16 * r * (1 - 0.05 * k) for k in range(14)]
        s.add(
            lambda p=tusk, t=thin: forms.tube(forms.smooth_path(p, 14), t, 10),
            _IVORY,
            of="horn",
            name="tusk",
        )


def _fringe(s: Sketch, b: Beast, c: Color) -> None:
    """Hair that hangs from the flanks."""
    tufts = []
    for k in range(9):
        x, z, r = _at(b, -0.1 + 1.2 * k / 8)
        tufts += [(x, side * 0.8 * r, z - 0.4 * r, r) for side in _SIDES]
    s.add(
        lambda: forms.gather(
            [
                forms.tube([(x, y, z), (x, y, z - 0.95 * r)], [0.26 * r, 0.05 * r], 8)
                for x, y, z, r in tufts
            ]
        ),
        shade(c, 0.8),
        of="fur",
        name="fringe",
    )


def _dome(s: Sketch, b: Beast, c: Color) -> None:
    """A high crown and a hump behind it."""
    x, z, r = _head(b)
    s.ball(1, (x - 0.1 * r, 0, z + 0.7 * r), c, scale=(0.7 * r, 0.7 * r, 0.75 * r), of="fur")
    tx, tz, tr = _at(b, 0.9)
    s.ball(1, (tx, 0, tz + 0.7 * tr), c, scale=(0.8 * tr, 0.6 * tr, 0.55 * tr), of="fur")


def _wool_neck(s: Sketch, b: Beast, c: Color) -> None:
    """Thick wool on trunk and neck, and a tuft on the head."""
    (x0, z0, r0), (x1, z1, r1) = _at(b, 0), _at(b, 1)
    bone(s, (x0 + 2, 0, z0), 1.1 * r0, (x1 - 2, 0, z1), 1.1 * r1, c, of="fur", detail=3)
    x, z, r = _head(b)
    low = (x1 + 0.2 * r1, 0.0, z1 + 0.5 * r1)
    bone(s, low, 1.25 * b.neck[2], (x - 0.3 * r, 0, z - 0.9 * r), 1.2 * b.neck[3], c, of="fur")
    s.ball(0.55 * r, (x - 0.2 * r, 0, z + 0.85 * r), c, of="fur")


def _face_stripes(s: Sketch, b: Beast, c: Color) -> None:
    """A white head with a black stripe through each eye."""
    x, z, r = _head(b)
    mx, _, mz = _muzzle(b)
    m = b.head[3]
    blob(s, [((x, 0, z), 1.03 * r), ((mx, 0, mz), 1.04 * m)], PALE, of="fur", detail=3)
    for side in _SIDES:
        bone(
            s,
            (x - 0.3 * r, side * 0.6 * r, z + 0.84 * r),
            0.26 * r,
            (mx, side * 0.8 * m, mz + 0.95 * m),
            0.32 * m,
            BLACK,
            of="fur",
        )


def _neck_rings(s: Sketch, b: Beast, c: Color) -> None:
    """Dark rings around the neck, and across the haunches and shoulders."""
    (x0, z0, r0), (x1, z1, _) = _at(b, 1), _head(b)
    for k in range(5):
        t = 0.3 + 0.14 * k
        x, z = x0 + t * (x1 - x0), z0 + 0.3 * r0 + t * (z1 - z0 - 0.3 * r0)
        thick = b.neck[2] + t * (b.neck[3] - b.neck[2])
        long = 1.4 / math.hypot(x1 - x0, z1 - z0)
        dx, dz = long * (x1 - x0), long * (z1 - z0)
        s.rod(1.02 * thick, (x - dx, 0, z - dz), (x + dx, 0, z + dz), BLACK, sections=32)
    rear, front, across, top, foot = b.legs
    for x, zt in ((rear, b.trunk[0]), (front, b.trunk[1])):
        for side in _SIDES:
            for k in range(4):
                z = (0.36 + 0.09 * k) * zt
                r = 0.5 * (top + foot) * (0.68 + 0.12 * k)
                at = (x, side * 0.95 * across)
                s.rod(r, (*at, z - 0.8), (*at, z + 0.8), BLACK, sections=20)


def _mask(s: Sketch, b: Beast, c: Color) -> None:
    x, z, r = _head(b)
    mx, _, mz = _muzzle(b)
    m = b.head[3]
    s.ball(1, (mx - 0.2 * m, 0, mz), PALE, scale=(1.1 * m, 1.1 * m, 1.04 * m), of="fur")
    for side in _SIDES:
        s.ball(
            1,
            (x + 0.5 * r, side * 0.5 * r, z + 0.2 * r),
            BLACK,
            scale=(0.42 * r, 0.42 * r, 0.3 * r),
            of="fur",
        )
        s.ball(
            1,
            (x + 0.52 * r, side * 0.48 * r, z + 0.6 * r),
            PALE,
            scale=(0.3 * r, 0.34 * r, 0.12 * r),
            of="fur",
        )


def _ringed(s: Sketch, b: Beast, c: Color) -> None:
    """Dark rings around the tail."""
    length, droop, root, _ = b.tail
    start = (b.legs[0] - 0.8 * b.trunk[2], b.trunk[0] + 0.5 * b.trunk[2])
    level = max(0.0, 1 - abs(droop))
    for k in range(4):
        t = 0.3 + 0.2 * k
        sag = 0.16 * length * 4 * t * (1 - t) * 0.5
        x, z = start[0] - t * (length * level + 2), start[1] - t * length * droop - sag
        s.rod(
            1.08 * root * (1 - 0.12 * t),
            (x - 0.045 * length, 0, z - 0.01 * length),
            (x + 0.045 * length, 0, z + 0.01 * length),
            BLACK,
            sections=24,
            of="fur",
        )


def _white_back(s: Sketch, b: Beast, c: Color) -> None:
    """Two white stripes from the crown along the back."""
    (x0, z0, r0), (x1, z1, r1) = _at(b, 0), _at(b, 1)
    x, z, r = _head(b)
    for side in _SIDES:
        bone(
            s,
            (x0, side * 0.4 * r0, z0 + 0.78 * r0),
            0.24 * r0,
            (x1, side * 0.36 * r1, z1 + 0.86 * r1),
            0.22 * r1,
            PALE,
            of="fur",
        )
    bone(
        s,
        (x1, 0, z1 + 0.86 * r1),
        0.22 * r1,
        (x + 0.3 * r, 0, z + 0.85 * r),
        0.2 * r,
        PALE,
        of="fur",
    )


def _crest(s: Sketch, b: Beast, c: Color) -> None:
    """A row of spines from neck to tail, and a dewlap."""
    r = b.trunk[3]
    (x0, z0, _), (x1, z1, _) = _at(b, -0.5), _at(b, 1.2)
    for k in range(14):
        t = k / 13
        x, z = x0 + (x1 - x0) * t, z0 + (z1 - z0) * t + 0.9 * r
        high = r * (0.3 + 0.5 * t)
        prism(
            s,
            [
                (x - 0.22 * r, -0.06 * r, z),
                (x - 0.22 * r, 0.06 * r, z),
                (x + 0.22 * r, -0.06 * r, z),
                (x + 0.22 * r, 0.06 * r, z),
                (x - 0.2 * r, 0, z + high),
            ],
            shade(c, 0.7),
        )
    hx, hz, hr = _head(b)
    s.ball(
        1, (hx + 0.2 * hr, 0, hz - 1.1 * hr), shade(c, 0.85), scale=(0.7 * hr, 0.16 * hr, 0.75 * hr)
    )


def _back_spikes(s: Sketch, b: Beast, c: Color) -> None:
    tone = shade(c, 0.6)
    for k in range(8):
        x, z, r = _at(b, -0.6 + 1.5 * k / 7)
        top = z + 0.9 * r - (0.25 * r if k < 3 else 0.0)
        bone(s, (x, 0, top), 0.18 * r, (x - 0.3 * r, 0, top + 0.55 * r), 0.03 * r, tone, detail=1)


def _dragon_horns(s: Sketch, b: Beast, c: Color) -> None:
    x, z, r = _head(b)
    for side in _SIDES:
        bone(
            s,
            (x - 0.3 * r, side * 0.5 * r, z + 0.6 * r),
            0.26 * r,
            (x - 1.9 * r, side * 0.9 * r, z + 1.7 * r),
            0.04 * r,
            _IVORY,
            of="horn",
        )
        s.ball(0.2 * r, (x + 0.62 * r, side * 0.58 * r, z + 0.4 * r), rgb(236, 176, 30), detail=2)


def _dragon_wings(s: Sketch, b: Beast, c: Color) -> None:
    """Wings of skin between fingers, raised."""
    x, z, r = _at(b, 0.8)
    skin = shade(c, 0.72)
    for side in _SIDES:
        root = (x, side * 0.6 * r, z + 0.7 * r)
        wrist = (x + 0.9 * r, side * 2.9 * r, z + 3.4 * r)
        tips = [
            (x - 0.5 * r, side * 5.4 * r, z + 3.2 * r),
            (x - 2.4 * r, side * 4.4 * r, z + 2.2 * r),
            (x - 3.4 * r, side * 2.6 * r, z + 1.3 * r),
            (x - 2.4 * r, side * 0.7 * r, z + 0.7 * r),
        ]
        bone(s, root, 0.2 * r, wrist, 0.14 * r, c)
        for a, e in itertools.pairwise(tips):
            bone(s, wrist, 0.12 * r, a, 0.04 * r, c, detail=1)
            flat = [(p[0], p[1], p[2] + d) for p in (wrist, a, e) for d in (-0.03 * r, 0.03 * r)]
            prism(s, flat, skin)
        inner = [
            (p[0], p[1], p[2] + d) for p in (wrist, tips[-1], root) for d in (-0.03 * r, 0.03 * r)
        ]
        prism(s, inner, skin)


def _brow_horn(s: Sketch, b: Beast, c: Color) -> None:
    x, z, r = _head(b)
    bone(
        s,
        (x + 0.55 * r, 0, z + 0.75 * r),
        0.2 * r,
        (x + 1.9 * r, 0, z + 3.3 * r),
        0.03 * r,
        rgb(232, 196, 96),
        of="horn",
    )


WILD_MARKS: dict[str, Mark] = {
    "plume": _plume,
    "bib": _bib,
    "saddle": _saddle,
    "eye_patches": _eye_patches,
    "yoke": _yoke,
    "swept_horns": _swept_horns,
    "lyre_horns": _lyre_horns,
    "beard": _beard,
    "pale_muzzle": _pale_muzzle,
    "shag": _shag,
    "rosettes": _rosettes,
    "tears": _tears,
    "side_band": _side_band,
    "tusks": _tusks,
    "mammoth_trunk": _mammoth_trunk,
    "fringe": _fringe,
    "dome": _dome,
    "wool_neck": _wool_neck,
    "face_stripes": _face_stripes,
    "mask": _mask,
    "neck_rings": _neck_rings,
    "ringed": _ringed,
    "white_back": _white_back,
    "crest": _crest,
    "back_spikes": _back_spikes,
    "dragon_horns": _dragon_horns,
    "dragon_wings": _dragon_wings,
    "brow_horn": _brow_horn,
}
"""Drawn in this order."""
