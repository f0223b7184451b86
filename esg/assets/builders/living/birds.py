"""Birds from one plan: body, neck, head, beak, wings, tail and legs in the proportions of a kind.

They stand on a box of their feet's size, or fly: the pose of the appearance spreads the drawn wings
and tucks the legs away. What collides stands.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import math
from typing import Any

from esg.assets.appearance import FLYING
from esg.assets.builders import builder
from esg.assets.builders.common import bone, prism, shade, shift
from esg.assets.builders.living.headwear import Anchor, adorn
from esg.assets.geometry.sketch import DARK, Color, Sketch, rgb
from esg.assets.lazy import forms
from esg.graph.models import Vec3

_SIDES = (-1, 1)
_YELLOW, _ORANGE = rgb(236, 178, 36), rgb(226, 118, 36)
_BLACK, _WHITE = rgb(30, 30, 33), rgb(244, 243, 238)
_RED, _BLUE = rgb(196, 38, 34), rgb(36, 84, 168)
_GREY, _PINK = rgb(142, 150, 158), rgb(236, 143, 160)


@dataclass(frozen=True)
class Bird:
    """Proportions and colours of a bird [cm]; a colour of None is that of the whole.

    Args:
        body: Half its length, width and height.
        stand: Height of the body's middle above the ground.
        pitch: Of the body, head up [deg].
        head: x and z of its middle against the body's, and its radius.
        neck: Radius at the body and at the head.
        beak: Kind (cone, hook, bill, spear), length and thickness.
        legs: Half their distance and radius.
        tail: Length, width at its end and rise of its end.
        wing: Half the span and width.
        coat: Colours of head, belly, wings, tail and wing tips.
        bare: Colours of beak and legs.
        marks: What else is drawn.
        move: Offset that centres the drawing on the origin.
    """

    body: Vec3
    stand: float
    pitch: float
    head: Vec3
    neck: tuple[float, float]
    beak: tuple[str, float, float]
    legs: tuple[float, float]
    tail: Vec3
    wing: tuple[float, float]
    coat: tuple[Color | None, Color | None, Color | None, Color | None, Color | None]
    bare: tuple[Color, Color] = (_YELLOW, _YELLOW)
    marks: frozenset[str] = frozenset()
    move: float = 0.0


BIRDS: dict[str, Bird] = {
    "parrot": Bird(
        (9.5, 5.4, 5.6), 11, 42, (8.0, 10.5, 5.0), (4.8, 4.4), ("hook", 4.6, 2.5), (2.4, 0.8),
        (26, 4.4, -8), (42, 13), (None, None, _YELLOW, _BLUE, _BLUE), (rgb(228, 220, 200), _GREY),
        frozenset({"cheeks", "short_legs"}), 8,
    ),
    "eagle": Bird(
        (24, 12, 12.5), 32, 32, (23, 21, 8.0), (10, 7.4), ("hook", 9.5, 3.6), (6, 2.2),
        (26, 17, -12), (102, 32), (_WHITE, None, None, _WHITE, None),
        marks=frozenset({"brows", "trousers"}), move=4,
    ),
    "hawk": Bird(
        (15, 7.6, 8), 21, 34, (13.5, 13, 5.2), (6.6, 4.8), ("hook", 4.6, 2.0), (4, 1.2),
        (22, 10, -7), (60, 20), (None, rgb(226, 208, 180), None, None, _BLACK), (_BLACK, _YELLOW),
        frozenset({"brows", "trousers"}), 4,
    ),
    "owl": Bird(
        (15, 10, 10), 19, 68, (6.5, 17.5, 9.6), (9.6, 8.6), ("hook", 3.6, 1.6), (4.2, 1.4),
        (10, 9, -6), (48, 19), (None, rgb(214, 190, 150), None, None, None), (_BLACK, _GREY),
        frozenset({"face_disc", "tufts", "short_legs"}), -2,
    ),
    "seagull": Bird(
        (15, 6.4, 6.4), 15, 12, (14.5, 8.5, 4.9), (5.4, 4.4), ("cone", 6.4, 1.7), (3, 0.7),
        (12, 6.4, 0.5), (64, 15), (_WHITE, _WHITE, _GREY, _WHITE, _BLACK), (_YELLOW, _PINK),
        frozenset({"webbed"}), -3,
    ),
    "crow": Bird(
        (13.5, 6.2, 6.2), 14, 24, (13, 9.5, 4.8), (5.4, 4.4), ("cone", 6.6, 1.9), (2.8, 0.8),
        (16, 7, -3), (46, 16), (None, None, None, None, None), (_BLACK, _BLACK), move=0,
    ),
    "dove": Bird(
        (10, 5, 5), 8.6, 22, (9, 7.5, 3.5), (4.2, 3.2), ("cone", 2.6, 0.8), (2, 0.6),
        (12, 8, -1), (32, 11), (None, None, None, None, None), (_PINK, _PINK), move=1.8,
    ),
    "robin": Bird(
        (4.4, 2.9, 2.9), 5.2, 32, (3.4, 3.2, 2.3), (2.5, 2.2), ("cone", 1.4, 0.5), (1.1, 0.24),
        (4.6, 1.6, 0.6), (11, 5), (None, rgb(214, 92, 36), None, None, None),
        (rgb(70, 54, 44), rgb(120, 84, 66)), frozenset({"red_face"}), 0,
    ),
    "sparrow": Bird(
        (4.6, 2.9, 2.9), 5.0, 24, (3.8, 3.1, 2.2), (2.5, 2.1), ("cone", 1.4, 0.8), (1.1, 0.24),
        (4.8, 1.8, 0.6), (11.5, 5), (rgb(116, 92, 74), rgb(214, 204, 188), None, None, _BLACK),
        (rgb(60, 50, 44), rgb(170, 124, 100)), frozenset({"throat"}), 0,
    ),
    "toucan": Bird(
        (11, 6, 6), 10.5, 36, (9, 9.5, 4.8), (5, 4.4), ("bill", 18, 3.0), (2.6, 0.8),
        (18, 5, -3), (30, 13), (None, _WHITE, None, None, None), (_ORANGE, _BLUE),
        frozenset({"short_legs", "black_tip"}), -3,
    ),
    "flamingo": Bird(
        (19, 10, 10.5), 84, 14, (25, 46, 5.2), (4.4, 3.4), ("bent", 10, 2.8), (3, 1.2),
        (9, 9, -3), (72, 22), (None, None, None, None, _BLACK), (rgb(244, 214, 208), _PINK),
        frozenset({"swan_neck", "black_tip"}), -9,
    ),
    "heron": Bird(
        (21, 8.6, 9), 58, 22, (28, 34, 4.6), (4.4, 2.8), ("spear", 14, 1.7), (3, 0.9),
        (12, 7, -5), (86, 24), (_WHITE, _WHITE, None, None, _BLACK), (_YELLOW, rgb(150, 130, 96)),
        frozenset({"swan_neck", "plumes"}), -12,
    ),
    "stork": Bird(
        (22, 10.5, 11), 62, 18, (28, 34, 5), (5, 3.4), ("spear", 19, 2.0), (3.4, 1.0),
        (12, 8, -4), (92, 26), (_WHITE, _WHITE, None, None, _BLACK), (_RED, _RED),
        frozenset({"dark_quills"}), -14,
    ),
    "pelican": Bird(
        (34, 18, 18), 32, 14, (38, 36, 8), (10, 7), ("pouch", 36, 4.4), (8, 2.0),
        (14, 13, 0), (120, 32), (None, None, None, None, _BLACK), (_ORANGE, _ORANGE),
        frozenset({"swan_neck", "webbed"}), -26,
    ),
    "swan": Bird(
        (40, 20, 19), 23, 6, (50, 56, 7.4), (9, 5.4), ("bill", 12, 3.4), (9, 2),
        (16, 14, 6), (110, 34), (None, None, None, None, None), (_ORANGE, _BLACK),
        frozenset({"swan_neck", "webbed", "knob", "short_legs"}), -12,
    ),
    "goose": Bird(
        (26, 13.5, 13), 24, 10, (30, 33, 6.2), (8, 5.4), ("bill", 9, 2.8), (6, 1.6),
        (12, 9, 1), (72, 22), (None, rgb(226, 220, 208), None, None, _BLACK), (_ORANGE, _ORANGE),
        frozenset({"webbed"}), -8,
    ),
    "turkey": Bird(
        (25, 17, 17), 38, 20, (25, 30, 5), (8, 4.2), ("cone", 5, 1.5), (6.4, 1.8),
        (8, 8, 10), (62, 24), (rgb(120, 150, 190), None, None, None, _BLACK),
        (rgb(222, 200, 160), rgb(196, 120, 110)), frozenset({"fan", "wattle"}), -1.7,
    ),
    "peacock": Bird(
        (21, 10.5, 10.5), 38, 18, (25, 32, 4.2), (7, 3.4), ("cone", 4.4, 1.3), (5, 1.3),
        (8, 8, 8), (70, 20), (None, None, rgb(150, 120, 88), rgb(40, 108, 70), None),
        (rgb(200, 190, 170), _GREY), frozenset({"train", "crown"}), 2,
    ),
    "ostrich": Bird(
        (50, 30, 29), 112, 10, (58, 108, 9), (13, 6.4), ("bill", 13, 4.4), (15, 5),
        (22, 26, 6), (90, 34), (rgb(206, 172, 150), None, None, _WHITE, _WHITE),
        (rgb(196, 150, 120), rgb(206, 172, 150)), frozenset({"bare_neck", "thighs"}), -14,
    ),
}  # fmt: skip
"""Sizes of one bird that stands, in the middle of the range that the table of kinds names."""


def _turned(b: Bird, point: Vec3) -> Vec3:
    """A point of a level body where its pitch takes it, above the ground."""
    a = math.radians(b.pitch)
    x, y, z = point
    return x * math.cos(a) - z * math.sin(a), y, b.stand + x * math.sin(a) + z * math.cos(a)


def _egg(b: Bird, share: float, at: Vec3) -> Callable[[], Any]:
    """A tapering body: full at the breast, thin towards the tail."""

    def make() -> Any:
        import numpy as np

        length, wide, high = (v * share for v in b.body)
        u = np.sin(np.radians(np.linspace(-88, 88, 18)))
        full = np.sqrt(np.clip(1 - u * u, 0, 1)) * (0.86 + 0.22 * u)
        ring = forms.superellipse(20, 2.0)
        a = math.radians(b.pitch)
        x = np.broadcast_to((u * length)[:, None], (18, 20))
        y, z = full[:, None] * ring[:, 0] * wide, full[:, None] * ring[:, 1] * high
        px, pz = x * math.cos(a) - z * math.sin(a), x * math.sin(a) + z * math.cos(a)
        return forms.loft(np.stack([px + at[0], y + at[1], pz + at[2]], -1))

    return make


def _neck(s: Sketch, b: Bird, c: Color) -> None:
    start, head = _turned(b, (0.62 * b.body[0], 0, 0)), (b.head[0], 0.0, b.stand + b.head[1])
    low, high = b.neck
    if "swan_neck" in b.marks:
        path = [
            start,
            (start[0] + 0.42 * b.body[0], 0, start[2] + 0.3 * (head[2] - start[2])),
            (
                0.5 * (start[0] + head[0]) - 0.12 * b.body[0],
                0,
                start[2] + 0.75 * (head[2] - start[2]),
            ),
            head,
        ]
        if "dark_quills" not in b.marks:
            radii = [low + (high - low) * k / 17 for k in range(18)]
            s.add(lambda: forms.tube(forms.smooth_path(path, 18), radii, 14), c, name="neck")
            return
    bone(s, start, low, head, high, c)


def _beak(s: Sketch, b: Bird, c: Color) -> None:
    kind, length, thick = b.beak
    x, z, r = b.head[0], b.stand + b.head[1], b.head[2]
    root, tip = (x + 0.7 * r, 0.0, z - 0.12 * r), (x + r + length, 0.0, z - 0.35 * r)
    dark = _BLACK if "black_tip" in b.marks else c
    if kind == "hook":
        bend = (x + 0.72 * r + 0.75 * length, 0.0, z)
        bone(s, root, thick, bend, 0.72 * thick, c, of="horn")
        bone(
            s,
            bend,
            0.72 * thick,
            (bend[0] + 0.25 * thick, 0, z - 1.35 * thick),
            0.12 * thick,
            c,
            of="horn",
        )
    elif kind == "bent":
        bend = (x + r + 0.55 * length, 0.0, z - 0.5 * r)
        bone(s, root, thick, bend, 0.85 * thick, c, of="horn")
        bone(
            s,
            bend,
            0.86 * thick,
            (bend[0] + 0.3 * length, 0, bend[2] - 0.6 * length),
            0.3 * thick,
            dark,
            of="horn",
        )
    elif kind in ("bill", "pouch"):
        mid = (root[0] + 0.62 * (tip[0] - root[0]), 0.0, root[2] + 0.62 * (tip[2] - root[2]))
        bone(s, root, thick, mid, 0.8 * thick, c, of="horn")
        bone(s, mid, 0.8 * thick, tip, 0.36 * thick, dark, of="horn")
        if kind == "pouch":
            low = (x + 0.45 * length + r, 0.0, z - 0.9 * r - thick)
            s.ball(
                1, low, shade(c, 1.15), scale=(0.48 * length, 0.7 * thick, 1.3 * thick), of="skin"
            )
    else:
        bone(s, root, thick, tip, 0.12 * thick, c, of="horn")


def _eyes(s: Sketch, b: Bird) -> None:
    x, z, r = b.head[0], b.stand + b.head[1], b.head[2]
    for side in _SIDES:
        if "face_disc" in b.marks:
            at = (x + 0.78 * r, side * 0.42 * r, z + 0.14 * r)
            s.ball(1, at, rgb(222, 202, 166), scale=(0.24 * r, 0.5 * r, 0.54 * r))
            s.ball(
                0.27 * r,
                (at[0] + 0.14 * r, at[1], at[2]),
                rgb(240, 176, 30),
                of="glass_dark",
                alpha=1.0,
            )
            s.ball(0.17 * r, (at[0] + 0.28 * r, at[1], at[2]), DARK, detail=2)
            continue
        at = (x + 0.5 * r, side * 0.78 * r, z + 0.26 * r)
        s.ball(0.2 * r, at, DARK, rough=0.15, detail=2)
        if "brows" in b.marks:
            bone(
                s,
                (at[0] - 0.2 * r, at[1], at[2] + 0.2 * r),
                0.12 * r,
                (at[0] + 0.3 * r, side * 0.6 * r, at[2] + 0.12 * r),
                0.08 * r,
                b.coat[0] or rgb(70, 52, 40),
            )


def _tail(s: Sketch, b: Bird, c: Color) -> None:
    length, wide, rise = b.tail
    root = _turned(b, (-0.72 * b.body[0], 0, 0.1 * b.body[2]))
    thick = 0.14 * b.body[2]
    end = (root[0] - length, root[2] + rise)
    if "short_legs" in b.marks or b.pitch > 25:
        end = (end[0], max(end[1], 0.4 * thick))
    prism(
        s,
        [
            (root[0], side * 0.36 * b.body[1], root[2] + d)
            for side in _SIDES
            for d in (-thick, thick)
        ]
        + [
            (end[0], side * wide, end[1] + d)
            for side in _SIDES
            for d in (-0.3 * thick, 0.3 * thick)
        ],
        c,
        rough=0.9,
        name="tail",
    )


def _folded(s: Sketch, b: Bird, side: int, c: Color, tip: Color) -> None:
    length, wide, high = b.body
    start = _turned(b, (0.42 * length, side * 0.74 * wide, 0.34 * high))
    mid = _turned(b, (-0.3 * length, side * 0.86 * wide, 0.2 * high))
    end = _turned(b, (-1.06 * length, side * 0.5 * wide, 0.22 * high))

    def make() -> Any:
        path = forms.smooth_path([start, mid, end], 12)
        radii = forms.profile([(0, 0.34 * high), (0.35, 0.62 * high), (1, 0.12 * high)])
        return forms.tube(path, radii([k / 11 for k in range(12)]), 12, flat=0.45)

    s.add(make, c, rough=0.9, name="wing")
    bone(
        s,
        (0.7 * mid[0] + 0.3 * end[0], mid[1], 0.7 * mid[2] + 0.3 * end[2] - 0.06 * high),
        0.26 * high,
        end,
        0.12 * high,
        tip,
    )


def _spread(s: Sketch, b: Bird, side: int, c: Color, tip: Color) -> None:
    """A wing in flight: an arm, a hand swept back, and fingers of the tip's colour."""
    half, wide = b.wing
    x, z, t = 0.3 * b.body[0], b.stand + 0.5 * b.body[2], 0.04 * wide
    y0 = 0.5 * b.body[1]
    stations = [
        (y0, x + 0.42 * wide, wide, z),
        (y0 + 0.42 * (half - y0), x + 0.58 * wide, 0.98 * wide, z + 0.12 * half),
        (y0 + 0.78 * (half - y0), x + 0.2 * wide, 0.72 * wide, z + 0.13 * half),
        (half, x - 0.45 * wide, 0.16 * wide, z + 0.1 * half),
    ]
    for k, (tone, name) in enumerate(((c, "wing"), (shade(c, 0.92), "wing"), (tip, "wing_tip"))):
        corners = [
            (px, side * y, h + d)
            for y, fore, chord, h in stations[k : k + 2]
            for px in (fore, fore - chord)
            for d in (-t, t)
        ]
        prism(s, corners, tone, rough=0.9, name=name)


def _legs(s: Sketch, b: Bird, c: Color) -> None:
    across, r = b.legs
    hip = b.stand - 0.5 * b.body[2]
    size = max(4.2 * r, 0.3 * b.body[1])
    for side in _SIDES:
        y = side * across
        if "trousers" in b.marks:
            bone(
                s,
                (0, y, hip),
                0.34 * b.body[2],
                (0, y, 0.42 * hip),
                0.16 * b.body[2],
                b.coat[1] or shade(c, 1),
            )
        if "thighs" in b.marks:
            bone(s, (-4, y, hip), 3.0 * r, (4, y, 0.55 * hip), 1.5 * r, c, of="skin")
        s.rod(r, (0, y, 0.4 * r), (0, y, hip), c, sections=10, of="horn")
        if "webbed" in b.marks:
            prism(
                s,
                [
                    (-0.4 * size, y, 0),
                    (-0.4 * size, y, 0.7 * r),
                    (1.1 * size, y - 0.6 * size, 0),
                    (1.1 * size, y + 0.6 * size, 0),
                    (1.1 * size, y, 0.5 * r),
                ],
                c,
                of="horn",
            )
            continue
        for turn in (-0.5, 0, 0.5):
            bone(
                s,
                (0, y, 0.7 * r),
                0.7 * r,
                (size, y + turn * size, 0.5 * r),
                0.5 * r,
                c,
                detail=1,
                of="horn",
            )
        bone(
            s, (0, y, 0.7 * r), 0.7 * r, (-0.6 * size, y, 0.5 * r), 0.5 * r, c, detail=1, of="horn"
        )


def _tufts(s: Sketch, b: Bird, c: Color) -> None:
    x, z, r = b.head[0], b.stand + b.head[1], b.head[2]
    for side in _SIDES:
        bone(
            s,
            (x + 0.2 * r, side * 0.6 * r, z + 0.6 * r),
            0.26 * r,
            (x, side * 0.85 * r, z + 1.45 * r),
            0.05 * r,
            shade(c, 0.75),
        )


def _cheeks(s: Sketch, b: Bird, c: Color) -> None:
    x, z, r = b.head[0], b.stand + b.head[1], b.head[2]
    for side in _SIDES:
        s.ball(
            1,
            (x + 0.42 * r, side * 0.6 * r, z + 0.02 * r),
            _WHITE,
            scale=(0.46 * r, 0.36 * r, 0.46 * r),
        )


def _red_face(s: Sketch, b: Bird, c: Color) -> None:
    x, z, r = b.head[0], b.stand + b.head[1], b.head[2]
    s.ball(1, (x + 0.28 * r, 0, z - 0.24 * r), b.coat[1] or c, scale=(0.84 * r, 0.86 * r, 0.8 * r))


def _throat(s: Sketch, b: Bird, c: Color) -> None:
    x, z, r = b.head[0], b.stand + b.head[1], b.head[2]
    s.ball(1, (x + 0.5 * r, 0, z - 0.6 * r), _BLACK, scale=(0.46 * r, 0.5 * r, 0.5 * r))


def _knob(s: Sketch, b: Bird, c: Color) -> None:
    x, z, r = b.head[0], b.stand + b.head[1], b.head[2]
    s.ball(0.36 * r, (x + 0.95 * r, 0, z + 0.2 * r), _BLACK, detail=2)


def _plumes(s: Sketch, b: Bird, c: Color) -> None:
    x, z, r = b.head[0], b.stand + b.head[1], b.head[2]
    bone(s, (x, 0, z + 0.75 * r), 0.4 * r, (x - 3.6 * r, 0, z - 0.2 * r), 0.06 * r, _BLACK)


def _dark_quills(s: Sketch, b: Bird, c: Color) -> None:
    length, wide, high = b.body
    if s.appearance.pose != FLYING:
        for side in _SIDES:
            bone(
                s,
                _turned(b, (-0.2 * length, side * 0.84 * wide, -0.1 * high)),
                0.3 * high,
                _turned(b, (-1.12 * length, side * 0.5 * wide, 0.1 * high)),
                0.1 * high,
                _BLACK,
            )


def _wattle(s: Sketch, b: Bird, c: Color) -> None:
    x, z, r = b.head[0], b.stand + b.head[1], b.head[2]
    bone(
        s,
        (x + 0.8 * r, 0, z - 0.6 * r),
        0.36 * r,
        (x + 0.7 * r, 0, z - 2.2 * r),
        0.3 * r,
        _RED,
        of="skin",
    )
    bone(
        s,
        (x - 0.3 * r, 0, z - 1.4 * r),
        0.95 * r,
        (x - 1.0 * r, 0, z - 2.8 * r),
        1.0 * r,
        _RED,
        of="skin",
    )


def _feathers(
    s: Sketch, b: Bird, reach: float, count: int, tones: tuple[Color, ...], lean: float
) -> None:
    """Feathers in a half circle behind the body, in rings of colours from the root to the tip."""
    root = _turned(b, (-0.7 * b.body[0], 0, 0.2 * b.body[2]))
    for ring, tone in enumerate(tones):
        near, far = reach * ring / len(tones), reach * (ring + 1) / len(tones)

        def make(near: float = near, far: float = far) -> Any:
            out = []
            for k in range(count):
                a = math.radians(8 + 164 * k / (count - 1))
                y, z = math.cos(a), math.sin(a)
                ends = [(root[0] - lean * d, root[1] + y * d, root[2] + z * d) for d in (near, far)]
                wide = 1.5 * far / count
                out.append(forms.tube(ends, [0.8 * wide, wide], 8))
            return forms.gather(out)

        s.add(make, tone, rough=0.9, name="fan")
    deep = (root[0] - lean * reach, root[0])
    s.proxy_slab(deep, (-0.6 * reach, 0.6 * reach), (root[2], root[2] + 0.9 * reach), 0.02)


def _fan(s: Sketch, b: Bird, c: Color) -> None:
    _feathers(s, b, 34, 13, (shade(c, 0.8), c, rgb(150, 92, 50), rgb(226, 206, 174)), 0.3)


def _train(s: Sketch, b: Bird, c: Color) -> None:
    green = rgb(34, 116, 72)
    _feathers(
        s, b, 82, 17, (green, shade(green, 1.2), green, rgb(30, 70, 150), rgb(176, 148, 54)), 0.3
    )


def _crown(s: Sketch, b: Bird, c: Color) -> None:
    x, z, r = b.head[0], b.stand + b.head[1], b.head[2]
    for k in (-1, 0, 1):
        tip = (x - 0.3 * r + 0.5 * k * r, 0.0, z + 2.2 * r)
        bone(s, (x, 0, z + 0.8 * r), 0.1 * r, tip, 0.1 * r, c, detail=1)
        s.ball(0.26 * r, tip, c, detail=2)


MARKS: dict[str, Callable[[Sketch, Bird, Color], None]] = {
    "tufts": _tufts,
    "cheeks": _cheeks,
    "red_face": _red_face,
    "throat": _throat,
    "knob": _knob,
    "plumes": _plumes,
    "dark_quills": _dark_quills,
    "wattle": _wattle,
    "fan": _fan,
    "train": _train,
    "crown": _crown,
}
"""Drawn in this order."""


@builder("plumed")
def plumed(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "crow") -> None:
    """A bird facing +X, standing or in flight, drawn in the proportions and colours of its kind."""
    b = BIRDS[kind]
    head, belly, wings, tail, tips = b.coat
    s.add(_egg(b, 1.0, (0, 0, b.stand)), c, rough=0.9, name="body")
    if belly is not None:
        low = _turned(b, (0.16 * b.body[0], 0, -0.16 * b.body[2]))
        s.add(_egg(b, 0.9, low), belly, rough=0.9, name="belly")
    naked = "bare_neck" in b.marks
    _neck(s, b, head if head is not None else c)
    at = (b.head[0], 0.0, b.stand + b.head[1])
    s.ball(
        b.head[2],
        at,
        c if head is None else head,
        rough=0.9,
        of="skin" if naked else "",
        name="head",
    )
    _beak(s, b, b.bare[0])
    _tail(s, b, shade(c, 0.85) if tail is None else tail)
    wing = shade(c, 0.82) if wings is None else wings
    flying = s.appearance.pose == FLYING
    for side in _SIDES:
        (_spread if flying else _folded)(
            s, b, side, wing, shade(wing, 0.8) if tips is None else tips
        )
    if not flying:
        _legs(s, b, b.bare[1])
    for mark, draw in MARKS.items():
        if mark in b.marks:
            draw(s, b, c)
    _eyes(s, b)
    adorn(s, _anchor(b))
    _collides(s, b)
    shift(s, b.move)


def _anchor(b: Bird) -> Anchor:
    """Where a bird wears a hat, glasses and a scarf."""
    r, head = b.head[2], (b.head[0], 0.0, b.stand + b.head[1])
    x, _, z = _turned(b, (0.62 * b.body[0], 0, 0))
    dx, dz = head[0] - x, head[2] - z
    neck = (x + 0.6 * dx, 0.0, z + 0.6 * dz)
    girth = 0.4 * b.neck[0] + 0.6 * b.neck[1]
    lean = math.degrees(math.atan2(dx, max(dz, 1e-6)))
    return Anchor(head, r, neck, girth, (0.7 * r, 0.75 * r, 0.15 * r), lean)


def _collides(s: Sketch, b: Bird) -> None:
    """Legs, trunk and head as boxes."""
    length, wide, high = b.body
    a = math.radians(b.pitch)
    reach = math.hypot(length * math.cos(a), high * math.sin(a))
    rise = math.hypot(length * math.sin(a), high * math.cos(a))
    low, top = max(b.stand - 0.85 * rise, 0.12 * b.stand), b.stand + 0.8 * rise
    foot = max(b.legs[0] + 2 * b.legs[1], 0.72 * wide)
    x = 0.62 * reach
    s.proxy_slab((-x, x), (-foot, foot), (0, low), 0.5)
    s.proxy_slab((-0.88 * reach, 0.88 * reach), (-0.85 * wide, 0.85 * wide), (low, top), 1.0)
    r, z = b.head[2], b.stand + b.head[1]
    if z + 0.9 * r > top:
        s.proxy_slab(
            (b.head[0] - 0.9 * r, b.head[0] + r), (-0.9 * r, 0.9 * r), (top, z + 0.9 * r), 0.25
        )
