"""A gorilla on its knuckles, and a koala that sits."""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import blob, bone, mirrored, shade, shift
from esg.assets.builders.living.headwear import Anchor, adorn
from esg.assets.geometry.sketch import DARK, Color, Sketch, rgb

_SIDES = (-1, 1)


@builder("gorilla")
def gorilla(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Gorilla on all fours, its knuckles on the ground: 120 cm to the crown."""
    face, silver = rgb(92, 84, 80), rgb(128, 128, 130)
    bone(s, (-30, 0, 58), 24, (16, 0, 86), 30, c, detail=3)
    s.ball(1, (-22, 0, 68), silver, scale=(19, 22.5, 18), detail=3)
    blob(s, [((44, 0, 106), 15), ((36, 0, 116), 11), ((24, 0, 98), 18)], c, detail=3)
    blob(s, [((54, 0, 101), 8.5), ((52, 0, 108), 7.5)], face, of="skin")
    bone(s, (54, -6, 112.5), 3.4, (54, 6, 112.5), 3.4, shade(face, 0.85), of="skin")
    s.ball(1, (62, 0, 103), shade(face, 0.6), scale=(2.4, 4.2, 2.2), of="skin")
    for side in _SIDES:
        s.ball(1.5, (59.4, side * 4.2, 108.6), DARK, rough=0.15, detail=2)
        s.ball(1, (42, side * 14.6, 106), face, scale=(3, 1.6, 4), of="skin")
        bone(s, (20, side * 27, 88), 15, (22, side * 35, 52), 11, c)
        bone(s, (22, side * 35, 52), 11, (36, side * 31, 12), 8.4, c)
        blob(s, [((38, side * 31, 6.5), 6.5), ((45, side * 30, 5), 5)], face, of="skin")
        bone(s, (-30, side * 19, 50), 18, (-20, side * 27, 26), 11, c)
        bone(s, (-20, side * 27, 26), 10, (-30, side * 26, 8), 7.5, c)
        bone(s, (-32, side * 26, 5), 5, (-15, side * 27, 4), 4, face, of="skin")
    adorn(s, Anchor((43, 0, 109), 14, (32, 0, 98), 17, (16.5, 4.2, -0.4), 40))
    for side in _SIDES:
        s.proxy_slab((28, 48), mirrored(side, 24, 40), (0, 40), 0.8)
        s.proxy_slab((-36, -12), mirrored(side, 16, 32), (0, 40), 0.8)
    s.proxy_slab((-50, 44), (-30, 30), (40, 100), 1.0)
    s.proxy_slab((24, 60), (-13, 13), (100, 124), 0.6)
    s.surface("back", 100, (18, 18), (-12, 0))
    shift(s, -4)


@builder("koala")
def koala(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Koala that sits, 65 cm."""
    pale = rgb(232, 228, 222)
    s.ball(1, (-2, 0, 21), c, scale=(15, 15, 20))
    s.ball(1, (6, 0, 20), pale, scale=(9, 10.5, 14))
    s.ball(1, (4, 0, 50), c, scale=(12, 13.5, 12))
    s.ball(1, (16, 0, 47.5), rgb(44, 42, 44), scale=(3.4, 3.4, 5.2), of="leather")
    s.ball(1, (11, 0, 41), pale, scale=(5, 6, 4))
    for side in _SIDES:
        s.ball(1.5, (14.4, side * 6, 53), DARK, rough=0.15, detail=2)
        s.ball(1, (1, side * 15, 60), c, scale=(4, 7.5, 8))
        s.ball(1, (3.4, side * 15.5, 59.6), pale, scale=(2.6, 5, 5.6))
        bone(s, (3, side * 12, 32), 5, (15, side * 9, 25), 4, c)
        bone(s, (-2, side * 11, 8), 8, (13, side * 12, 6), 5.6, c)
        s.ball(1, (18, side * 12, 5), shade(c, 0.7), scale=(4.4, 4, 5))
    adorn(s, Anchor((4, 0, 50), 12, (2, 0, 38), 10.5, (11.4, 6, 3)))
    s.proxy_slab((-16, 20), (-16, 16), (0, 12), 1.0)
    s.proxy_slab((-15, 13), (-14, 14), (12, 40), 1.0)
    s.proxy_slab((-8, 17), (-13, 13), (40, 62), 0.6)
    shift(s, -3)
