"""Standing people: one body, dressed by what they are; all face +X.

Every dress is drawn on the same body with the same proxies, so that a cook falls as a guard does:
who somebody is changes the picture and nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass
import math

from esg.assets.builders import builder
from esg.assets.builders.common import blob, bone, prism, shade
from esg.assets.geometry.sketch import (
    BRASS,
    CHROME,
    DARK,
    GREEN,
    ORANGE,
    RED,
    STEEL,
    WHITE,
    YELLOW,
    Color,
    Sketch,
    rgb,
)

_PALE, _FAIR, _TAN, _BROWN = (
    rgb(228, 190, 162),
    rgb(214, 172, 140),
    rgb(176, 126, 90),
    rgb(118, 78, 54),
)
_BLACK_HAIR, _BROWN_HAIR, _FAIR_HAIR, _GREY_HAIR = (
    rgb(36, 30, 28),
    rgb(84, 56, 36),
    rgb(196, 156, 88),
    rgb(168, 166, 162),
)
_JEANS, _NAVY, _SHIRT = rgb(50, 60, 90), rgb(34, 42, 68), rgb(236, 236, 232)
_BRIGHT = rgb(226, 236, 120)


@dataclass(frozen=True)
class Dress:
    """What somebody wears over a coat of the asset's own colour.

    Args:
        skin: Of face and hands.
        hair: Of the head.
        legs: Trousers, stockings or shorts; None takes the asset's colour.
        marks: Hats, coats and what else is drawn; see `_HATS` and `_GARMENTS`.
        shoes: Of both feet.
        hat: Of whatever is on the head; None takes the asset's colour.
    """

    skin: Color
    hair: Color
    legs: Color | None
    marks: frozenset[str]
    shoes: Color = DARK
    hat: Color | None = None


def _dress(
    skin: Color,
    hair: Color,
    legs: Color | None,
    marks: str = "",
    shoes: Color = DARK,
    hat: Color | None = None,
) -> Dress:
    return Dress(skin, hair, legs, frozenset(marks.split()), shoes, hat)


DRESSES: dict[str, Dress] = {
    "plain": _dress(_FAIR, _BROWN_HAIR, _JEANS, "belt"),
    "worker": _dress(_TAN, _BLACK_HAIR, _JEANS, "hard_hat bands", rgb(110, 78, 44), YELLOW),
    "mechanic": _dress(_FAIR, _BLACK_HAIR, None, "cap bib", DARK),
    "chef": _dress(_PALE, _BROWN_HAIR, rgb(60, 62, 66), "toque apron buttons", DARK, WHITE),
    "officer": _dress(_BROWN, _BLACK_HAIR, _NAVY, "peaked_cap belt badge tie"),
    "soldier": _dress(_FAIR, _BROWN_HAIR, None, "helmet belt pack", rgb(58, 44, 30)),
    "firefighter": _dress(_FAIR, _BROWN_HAIR, rgb(46, 46, 50), "coat brim_helmet bands", DARK, RED),
    "knight": _dress(
        _PALE, _BROWN_HAIR, rgb(150, 153, 158), "great_helm belt tabard", STEEL, STEEL
    ),
    "astronaut": _dress(_FAIR, _BROWN_HAIR, None, "space_helmet pack badge", rgb(150, 153, 158)),
    "athlete": _dress(_BROWN, _BLACK_HAIR, _SHIRT, "shorts chest_band", _SHIRT),
    "sportsman": _dress(
        _PALE, _FAIR_HAIR, rgb(40, 42, 50), "sport_helmet goggles bands_thin", DARK
    ),
    "woman": _dress(_TAN, _BROWN_HAIR, _TAN, "skirt long_hair", rgb(150, 40, 44)),
    "robe": _dress(_PALE, _GREY_HAIR, None, "robe belt beard"),
    "royal": _dress(_PALE, _GREY_HAIR, None, "robe crown beard cape"),
    "wizard": _dress(_PALE, _GREY_HAIR, None, "robe cone_hat beard belt"),
    "doctor": _dress(_TAN, _BLACK_HAIR, rgb(92, 150, 160), "coat shirt", rgb(230, 230, 226)),
    "suit": _dress(_FAIR, _BLACK_HAIR, None, "shirt tie"),
    "countryman": _dress(
        _TAN, _BROWN_HAIR, _JEANS, "wide_hat belt", rgb(96, 60, 34), rgb(150, 108, 62)
    ),
    "hiker": _dress(_PALE, _FAIR_HAIR, rgb(132, 112, 76), "cap belt big_pack", rgb(96, 60, 34)),
    "clown": _dress(_PALE, ORANGE, rgb(44, 98, 190), "wig ruff red_nose buttons_large", RED),
    "bather": _dress(_FAIR, _BROWN_HAIR, _FAIR, "bare shorts_own", _FAIR),
}


def _section(z: float, grow: float) -> list[tuple[float, float]]:
    """Outline of the torso at a height, `grow` larger all around [cm]."""
    t = min(max((z - 90) / 44, 0.0), 1.0)
    r, half = 8.6 + t * (7.4 - 8.6) + grow, 7 + t * 5
    turn = [math.radians(a) for a in range(0, 181, 18)]
    right = [(r * math.cos(a), half + r * math.sin(a)) for a in turn]
    return right + [(-x, -y) for x, y in right]


def _band(s: Sketch, low: float, high: float, c: Color, grow: float = 0.8) -> None:
    """A strip of cloth around the torso."""
    s.extrude(_section((low + high) / 2, grow), (low, high), c, plane="xy", rough=0.9)


def _hang(s: Sketch, top: float, hem: float, half: tuple[float, float], c: Color) -> None:
    """Cloth that hangs from the torso at height `top` to an oval hem of half extents `half`."""
    ring = [math.radians(a) for a in range(0, 360, 15)]
    low = [(half[0] * math.cos(a), half[1] * math.sin(a), hem) for a in ring]
    prism(s, [*((x, y, top) for x, y in _section(top, 0.6)), *low], c, rough=0.95)


def _dome(
    s: Sketch, z: float, c: Color, rough: float = 0.4, radius: float = 10.6, rise: float = 11.5
) -> None:
    profile = [
        (radius * math.cos(math.radians(a)), rise * math.sin(math.radians(a)))
        for a in range(0, 91, 15)
    ]
    s.lathe([(0, 0), *profile], c, center=(0.3, 0, z), rough=rough)


def _hats(s: Sketch, marks: frozenset[str], d: Dress, c: Color) -> None:
    hat = d.hat or c
    if "hard_hat" in marks or "brim_helmet" in marks:
        _dome(s, 163, hat)
        back = 0.0 if "hard_hat" in marks else -2.0
        s.ball(1, (1.5 + back, 0, 163.4), hat, scale=(13.6, 12.2, 1.1), rough=0.4)
        s.slab((-9.5, 9.5), (-1.1, 1.1), (170, 175.4), shade(hat, 0.9), rough=0.4)
    if "helmet" in marks:
        _dome(s, 160.5, shade(c, 0.8), 0.7, radius=11.2, rise=13)
    if "sport_helmet" in marks:
        _dome(s, 161.5, hat, 0.25, radius=10.9, rise=12.5)
        s.slab((-9, 9), (-1.4, 1.4), (170, 174.6), DARK, rough=0.4)
    if "peaked_cap" in marks:
        s.lathe(
            [(0, 0), (9.7, 0), (9.9, 3), (12, 6.6), (11, 8.4), (0, 9.2)], c, center=(0, 0, 164.5)
        )
        s.ball(1, (8.4, 0, 164.8), DARK, scale=(7, 7, 0.9), rough=0.2)
        s.ball(1.5, (10.7, 0, 169.4), BRASS, detail=2, metal=0.7)
    if "cap" in marks:
        _dome(s, 163.5, hat, 0.9, radius=9.9, rise=9.6)
        s.ball(1, (8.4, 0, 164.2), shade(hat, 0.8), scale=(7, 7, 0.9), rough=0.9)
    if "toque" in marks:
        s.lathe(
            [(0, 0), (9.7, 0), (9.7, 5), (12, 9), (12.2, 12.5), (8, 15), (0, 15.2)],
            hat,
            center=(-0.3, 0, 162.5),
            rough=0.95,
        )
    if "wide_hat" in marks:
        s.lathe([(0, 0), (14.6, 1.2), (14.8, 2.2), (0, 1.4)], hat, center=(0, 0, 165), rough=0.95)
        s.lathe([(0, 0), (10, 0), (8.8, 7), (6, 9.6), (0, 9)], hat, center=(0, 0, 166), rough=0.95)
        s.lathe([(0, 0), (10.2, 0), (9.9, 2), (0, 2)], shade(hat, 0.5), center=(0, 0, 166.2))
    if "cone_hat" in marks:
        s.lathe([(0, 0), (14.4, 0), (14.4, 1), (0, 1)], c, center=(0, 0, 163.5), rough=0.95)
        s.lathe([(0, 0), (9.8, 0), (0, 14.5)], c, center=(-0.5, 0, 163.8), rough=0.95)
    if "crown" in marks:
        s.lathe(
            [(9.4, 0), (10.2, 0), (10.8, 5), (9.8, 5), (9.4, 0)],
            BRASS,
            center=(0, 0, 165),
            metal=0.8,
        )
        for k in range(8):
            a = math.radians(45 * k + 22.5)
            s.ball(1.5, (10.3 * math.cos(a), 10.3 * math.sin(a), 171), BRASS, detail=2, metal=0.8)
    if "great_helm" in marks:
        s.lathe(
            [(0, 0), (10.2, 0), (10.6, 12), (9.6, 20), (5, 24), (0, 24.4)],
            hat,
            center=(0.4, 0, 149),
            metal=0.7,
            rough=0.35,
        )
        s.slab((9.6, 11.4), (-6.4, 6.4), (159.6, 161.6), DARK)
        s.slab((10, 11.6), (-0.8, 0.8), (150, 172), BRASS, metal=0.7)
    if "space_helmet" in marks:
        s.ball(14, (0, 0, 159.5), shade(c, 1.1), rough=0.3)
        s.ball(1, (3.6, 0, 159.5), rgb(206, 158, 60), scale=(11.6, 12, 9.6), rough=0.1, metal=0.8)
    if "wig" in marks:
        for side in (-1, 1):
            s.ball(6.6, (-1, side * 8.4, 163), d.hair, rough=0.95, detail=2)
        s.ball(1, (-2, 0, 167), d.hair, scale=(8.6, 8.6, 5.4), rough=0.95)


def _head(s: Sketch, marks: frozenset[str], d: Dress) -> None:
    s.rod(4.8, (0, 0, 138), (0, 0, 151), d.skin)
    s.ball(1, (0.5, 0, 158.4), d.skin, scale=(9.2, 7.9, 11.6), rough=0.8)
    covered = marks & {"great_helm", "space_helmet", "wig"}
    if not covered:
        s.ball(1, (-1.6, 0, 161), d.hair, scale=(9.2, 8.4, 11), rough=0.95)
    for side in (-1, 1):
        s.ball(1.1, (8.7, side * 3.1, 159.6), DARK, detail=2)
    bone(s, (9.2, 0, 159), 0.8, (10.2, 0, 155.6), 1.3, shade(d.skin, 0.94), detail=1)
    if "long_hair" in marks:
        bone(s, (-3.4, 0, 160), 8.7, (-5.4, 0, 141), 7, d.hair, rough=0.95)
    if "beard" in marks:
        bone(s, (6.4, 0, 151), 4.8, (7.6, 0, 138), 2.2, d.hair, rough=0.95)
    if "red_nose" in marks:
        s.ball(2.4, (10.6, 0, 157), RED, detail=2)
    if "goggles" in marks:
        s.ball(1, (5.6, 0, 160), rgb(60, 90, 130), scale=(5, 7.6, 3), rough=0.1)


def _coats(s: Sketch, marks: frozenset[str], c: Color) -> None:
    if "coat" in marks:
        _hang(s, 124, 56, (13, 18), c)
    if "skirt" in marks:
        _hang(s, 106, 46, (14.4, 20), c)
    if "robe" in marks:
        _hang(s, 124, 3, (14.4, 19.4), c)
    if "tabard" in marks:
        for x in ((7.4, 9.6), (-9.6, -7.4)):
            s.slab(x, (-8, 8), (66, 130), RED, rough=0.95)
    if "apron" in marks:
        s.slab((8.4, 10), (-10, 10), (58, 104), WHITE, rough=0.95)
        _band(s, 101, 104, WHITE)
    if "bib" in marks:
        s.slab((7.6, 9.4), (-7.5, 7.5), (98, 124), shade(c, 1.25), rough=0.95)
        _band(s, 94, 99, shade(c, 0.7))
    if "cape" in marks:
        prism(
            s,
            [
                *((-7, y, z) for y in (-16, 16) for z in (138, 134)),
                *((-15, y, 6) for y in (-19, 19)),
                *((-11, y, 6) for y in (-19, 19)),
                *((-4, y, 137) for y in (-15, 15)),
            ],
            rgb(232, 226, 214),
            rough=0.95,
        )


def _trimmings(s: Sketch, marks: frozenset[str], c: Color) -> None:
    over = 3.4 if "coat" in marks else 0.8
    if "belt" in marks:
        _band(s, 95, 99, rgb(70, 46, 28), 3.6 if "robe" in marks else 0.9)
    if "bands" in marks:
        for z in (104, 118):
            _band(s, z, z + 4, _BRIGHT, over if z < 110 else min(over, 1.6))
    if "bands_thin" in marks:
        _band(s, 122, 126, _SHIRT)
    if "chest_band" in marks:
        _band(s, 112, 120, _SHIRT)
    if "shirt" in marks:
        prism(
            s,
            [(x, y, z) for x in (4, 8.5) for y, z in ((-5.4, 139), (5.4, 139), (0, 110))],
            _SHIRT,
            rough=0.9,
        )
    if "tie" in marks:
        tone = rgb(140, 30, 40) if "shirt" in marks else DARK
        s.slab((7.6, 9.2), (-1.4, 1.4), (112, 137), tone, rough=0.8)
    if "badge" in marks:
        s.ball(1.7, (8.2, 7.5, 127), BRASS, detail=2, metal=0.7)
    for mark, radius, tone in (("buttons", 1.0, DARK), ("buttons_large", 2.6, GREEN)):
        if mark in marks:
            for z in (112, 120, 128):
                s.ball(radius, (8.3 - (z - 112) * 0.03, 0, z), tone, detail=2)
    if "ruff" in marks:
        s.torus(9, 3, (0, 0, 141), WHITE, rough=0.95)
    if "pack" in marks:
        s.slab((-15.6, -7), (-10, 10), (104, 134), shade(c, 0.72), rough=0.9)
    if "big_pack" in marks:
        s.slab((-15.4, -6), (-12, 12), (96, 140), rgb(190, 70, 36), rough=0.9)
        s.rod(4.4, (-10.5, -13, 143), (-10.5, 13, 143), rgb(70, 92, 70), sections=18)


def _legs(s: Sketch, marks: frozenset[str], d: Dress, c: Color) -> None:
    legs = d.legs or c
    bare = marks & {"shorts", "skirt", "shorts_own"}
    tone = d.skin if bare else legs
    for side in (-1, 1):
        bone(s, (0, side * 8.2, 88), 8.2, (0.4, side * 8.8, 48), 6.2, tone, rough=0.9)
        bone(s, (0.4, side * 8.8, 48), 6.1, (0, side * 9, 10), 4.6, tone, rough=0.9)
        s.ball(1, (3.4, side * 9, 5.4), d.shoes, scale=(10.6, 5, 4), rough=0.7)
        if marks & {"shorts", "shorts_own"}:
            short = legs if "shorts" in marks else c
            bone(s, (0, side * 8.2, 88), 8.8, (0.2, side * 8.8, 64), 7.9, short, rough=0.9)
        if "shorts" in marks:
            bone(s, (0.2, side * 8.9, 30), 5.5, (0, side * 9, 10), 5, c, rough=0.9)


@builder("figure")
def figure(s: Sketch, L: float, W: float, H: float, c: Color, dress: str = "plain") -> None:
    """Standing person on a base plate, drawn at 30 x 50 x 172 and dressed as `DRESSES` say."""
    d = DRESSES[dress]
    marks = d.marks
    s.slab((-15, 15), (-20, 20), (0, 2), DARK)
    _legs(s, marks, d, c)
    top = d.skin if "bare" in marks else c
    hips = d.legs or c if not marks & {"skirt", "shorts_own"} else c
    for balls, tone in (
        (((7, 90, 8.5), (7, 100, 8.4)), hips),
        (((7, 104, 8.6), (12, 134, 7.4)), top),
    ):
        both = [((0.0, side * y, z), r) for side in (-1.0, 1.0) for y, z, r in balls]
        blob(s, both, tone, rough=0.9)
    sleeve = d.skin if marks & {"bare", "skirt"} else top
    for side in (-1, 1):
        bone(s, (0, side * 18.6, 134.5), 5.4, (0, side * 20.4, 112), 4.4, top, rough=0.9)
        fore = d.skin if "shorts" in marks else sleeve
        bone(s, (0, side * 20.4, 112), 4.3, (3, side * 20.9, 92), 3.6, fore, rough=0.9)
        hand = CHROME if "great_helm" in marks else d.skin
        s.ball(1, (3.6, side * 20.9, 86), hand, scale=(4.2, 3.2, 5.2), rough=0.8)
    _coats(s, marks, c)
    _trimmings(s, marks, c)
    _head(s, marks, d)
    _hats(s, marks, d, c)
    s.proxy_slab((-15, 15), (-20, 20), (0, 2), 4)
    s.proxy_slab((-9, 9), (-18, 18), (2, 86), 0.8)
    s.proxy_slab((-12, 12), (-25, 25), (86, 142), 0.9)
    s.proxy_cylinder(9, (142, 172), 0.8)
