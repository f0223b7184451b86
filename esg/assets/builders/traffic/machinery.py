"""Trains, tractors and tracked work vehicles; proxies as for cars."""

from __future__ import annotations

from functools import lru_cache
import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import bone, holes, mirrored, prism, shade, shift, wheel
from esg.assets.builders.traffic.coachwork import hull
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    GLASS,
    RED,
    STEEL,
    YELLOW,
    Color,
    Sketch,
    rgb,
)
from esg.assets.lazy import forms, shapes

_LAMP = (0.98, 0.96, 0.86)


def _coach_body(
    s: Sketch, c: Color, size: tuple[float, float, float], floor: float, nose: float, tram: bool
) -> None:
    """Body of a locomotive or tram with two cabs: half length, half width and height in `size`."""
    half, w, top = size
    key = (half, w, top, floor, nose, tram)
    for name, tone, of in (
        ("body", c, "car_body"),
        ("stripe", rgb(236, 232, 220), "paint"),
        ("roof", shade(c, 0.55), "paint"),
        ("side_windows", GLASS, "glass_dark"),
        ("windscreens", GLASS, "glass_dark"),
        ("doors", shade(c, 0.72), "paint"),
        ("headlights", _LAMP, "lamp"),
        ("grilles", DARK, "plastic"),
    ):
        s.add(
            lambda name=name: forms.copied(_coach_meshes(*key)[name]),
            tone,
            alpha=1.0,
            of=of,
            name=name,
        )
    for end, word in ((-1, "rear"), (1, "front")):
        s.add(
            lambda end=end: _buffers(end * half, w, floor, tram),
            DARK,
            of="steel",
            name=f"buffers_{word}",
        )

    def fittings() -> Any:
        out = [
            forms.cushion(
                (190, 1.1 * w, 16), (x, 0, top - 6), plan=10, side=0.3, sections=28, levels=7
            )
            for x in (-0.4 * half, 0.1 * half, 0.45 * half)
        ]
        return forms.gather(out)

    s.add(fittings, shade(c, 0.42), of="steel", name="roof_equipment")


@lru_cache(maxsize=4)
def _coach_meshes(
    half: float, w: float, top: float, floor: float, nose: float, tram: bool
) -> dict[str, Any]:
    from shapely.geometry import box

    crown = top - 8
    line = [
        (half, floor + 84),
        (half - 0.3 * nose, floor + 116),
        (half - nose, crown - 18),
        (half - 1.5 * nose, crown - 2),
        (0.4 * half, crown),
    ]
    bottom = (
        (half, floor + 14),
        (half - 24, floor),
        (0.5 * half, floor - 2),
        (-0.5 * half, floor - 2),
        (-half + 24, floor),
        (-half, floor + 14),
    )
    body = hull(2 * w, bottom, tuple(line + [(-x, z) for x, z in reversed(line)]), 30.0, 9.0, 0.0)
    glass, proud = forms.fattened(body, 1.2), forms.fattened(body, 0.9)
    count = 9 if tram else 6
    step = (2 * half - 2 * nose - 240) / count
    start = -half + nose + 120
    wide = (-2 * w, 2 * w)

    def soft(x0: float, x1: float, z0: float, z1: float, by: float) -> Any:
        return box(x0, z0, x1, z1).buffer(-by).buffer(by, quad_segs=3)

    panes = [
        m
        for k in range(count)
        for m in forms.prism(
            soft(start + k * step, start + (k + 0.8) * step, floor + 112, floor + 204, 9), wide
        )
    ]
    doors = [
        m
        for x in (half - nose - 62, -half + nose + 20)
        for m in forms.prism(soft(x, x + 42, floor + 8, floor + 212, 5), wide)
    ]
    screens = []
    for x in ((half - 1.5 * nose, half + 60), (-half - 60, -half + 1.5 * nose)):
        for y0, y1 in ((-0.78 * w, -0.04 * w), (0.04 * w, 0.78 * w)):
            screens += forms.prism(soft(y0, y1, floor + 122, crown - 52, 8), x, "yz")
    lamps = [
        m
        for x in ((half - 60, half + 20), (-half - 20, -half + 60))
        for y in (-0.62 * w, 0.62 * w)
        for m in forms.prism(soft(y - 15, y + 15, floor + 44, floor + 64, 8), x, "yz")
    ]
    vents = [
        m
        for k in range(5)
        for m in forms.prism(
            soft(-0.08 * half + 30 * k, -0.08 * half + 30 * k + 22, floor + 14, floor + 50, 2), wide
        )
    ]
    return {
        "body": body,
        "stripe": forms.inlay(
            proud, forms.prism(box(-half - 20, floor + 66, half + 20, floor + 84), wide)
        ),
        "roof": forms.inlay(
            proud,
            forms.prism(box(-half + 1.3 * nose, crown - 34, half - 1.3 * nose, crown + 20), wide),
        ),
        "side_windows": forms.inlay(glass, panes),
        "windscreens": forms.inlay(glass, screens),
        "doors": forms.inlay(proud, doors),
        "headlights": forms.inlay(glass, lamps),
        "grilles": forms.inlay(proud, vents),
    }


def _bogie(x: float, w: float, r: float, floor: float) -> Any:
    out = [
        forms.cushion(
            (300, 14, 26), (x, y * (w * 0.72 - 9), r + 4), plan=12, side=0.3, sections=24, levels=7
        )
        for y in (-1, 1)
    ]
    out.append(
        forms.cushion(
            (90, 1.3 * w, max(floor - r * 0.7, 12)),
            (x, 0, (floor + r * 0.7) / 2),
            plan=10,
            side=0.25,
            sections=24,
            levels=7,
        )
    )
    for dx in (-95, 95):
        out.append(forms.turned([(7, -0.8 * w), (7, 0.8 * w)], (x + dx, 0, r), 14, "y"))
        out += [
            forms.turned([(8, r + 12), (8, r + 34)], (x + dx * 0.72, y * (w * 0.72 - 9), 0), 12)
            for y in (-1, 1)
        ]
    return forms.gather(out)


def _rail_wheel(at: tuple[float, float, float], r: float, side: int) -> Any:
    """A disc wheel with a flange inside and five holes' rims, so that one sees it turn."""
    x, y, z = at
    h = 6.0
    tread = [
        (0.3 * r, -h * 0.5),
        (0.8 * r, -h * 0.4),
        (0.86 * r, -h),
        (r, -h),
        (r, -0.6 * h),
        (0.95 * r, -0.3 * h),
        (0.93 * r, h),
        (0.84 * r, h),
        (0.8 * r, 0.4 * h),
        (0.34 * r, 0.5 * h),
        (0.3 * r, h),
        (0.1 * r, h),
    ]
    out = [forms.turned([(q, side * v) for q, v in tread], at, 26, "y")]
    for k in range(5):
        a = 2 * math.pi * k / 5
        p = (x + 0.57 * r * math.cos(a), z + 0.57 * r * math.sin(a))
        out.append(shapes.rod(0.11 * r, (p[0], y - 0.62 * h, p[1]), (p[0], y + 0.62 * h, p[1]), 8))
    return forms.gather(out)


def _buffers(x: float, w: float, floor: float, tram: bool) -> Any:
    end = 1 if x > 0 else -1
    out = [
        forms.tube(
            [(x - end * 24, 0, floor + 14), (x - end * 1.0, 0, floor + 12)], 7, 12, round_ends=False
        )
    ]
    if not tram:
        for y in (-0.6 * w, 0.6 * w):
            head = [
                (8, x - end * 30),
                (8, x - end * 6),
                (19, x - end * 4),
                (17, x),
                (8, x + end * 0.2),
            ]
            out.append(forms.turned(head, (0, y, floor + 10), 20, "x"))
    return forms.gather(out)


@builder("train")
def train(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "engine") -> None:
    """Diesel locomotive, 18 m, or a low-floor tram."""
    tram = kind == "tram"
    half, w, top = (750.0, 120.0, 330.0) if tram else (900.0, 140.0, 390.0)
    floor = 35.0 if tram else 110.0
    nose = 60.0 if tram else 110.0
    _coach_body(s, c, (half, w, top), floor, nose, tram)
    r = 30.0 if tram else 46.0
    for bogie, place in ((-0.62, "rear"), (0.62, "front")):
        s.add(
            lambda b=bogie: _bogie(b * half, w, r, floor), DARK, of="steel", name=f"bogie_{place}"
        )
        for dx in (-95, 95):
            for side in (-1, 1):
                x = bogie * half + dx
                at = (x, side * (w * 0.72 + 6), r)
                s.add(
                    lambda at=at, side=side: _rail_wheel(at, r, side), STEEL, name=f"wheel_{place}"
                )
                s.wheel(at, r)
    low = 20.0 if tram else 30.0
    s.add(
        lambda: forms.cushion(
            (0.6 * half, 1.4 * w, floor + 4 - low),
            (0, 0, (floor + 4 + low) / 2),
            plan=12,
            side=0.25,
            sections=32,
            levels=7,
        ),
        DARK,
        of="steel",
        name="equipment",
    )
    s.proxy_slab((-half, half), (-w, w), (0, floor + 110), 1.0)
    s.proxy_slab((-half + nose * 0.7, half - nose * 0.7), (-w, w), (floor + 110, top), 0.3)
    s.surface("roof", top, (half * 0.8, w * 0.75))


@builder("toy_train")
def toy_train(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Toy steam engine, 22 cm long."""
    s.slab((-11, 10.5), (-3.6, 3.6), (1.8, 3.2), DARK)
    s.rod(2.9, (-3, 0, 6.1), (9.5, 0, 6.1), c, rough=0.35)
    s.rod(3.1, (9.5, 0, 6.1), (10.3, 0, 6.1), YELLOW)
    s.slab((-10.5, -3), (-3.5, 3.5), (3.2, 11), shade(c, 0.85))
    s.slab((-11, -2.2), (-4.1, 4.1), (11, 11.8), DARK)
    for side in (-1, 1):
        s.slab((-8.6, -5), mirrored(side, 3.4, 3.7), (7, 10), _LAMP)
        for x, r in ((-7, 2.8), (-0.5, 2.0), (4, 2.0), (8, 2.0)):
            s.rod(r, (x, side * 3.0, r), (x, side * 4.2, r), RED, sections=24)
            s.rod(r * 0.35, (x, side * 3.0, r), (x, side * 4.5, r), YELLOW, sections=14)
            holes(s, (x, side * 3.6, r), r * 1.1, 1.3)
            s.wheel((x, side * 3.6, r), r, parts=3)
    s.lathe([(0, 8), (1.1, 8), (1.1, 10.6), (1.8, 12.6), (0, 12.6)], DARK, center=(7.2, 0, 0))
    s.ball(1.3, (2.4, 0, 9), YELLOW)
    s.extrude([(10.3, 0.4), (13, 0.4), (10.3, 3)], (-3.2, 3.2), shade(c, 0.6))
    s.proxy_slab((-11, 11), (-4.2, 4.2), (0, 3.2), 1.0)
    s.proxy_slab((-3, 10), (-2.8, 2.8), (3.2, 9), 0.8)
    s.proxy_slab((-10.8, -2.4), (-3.8, 3.8), (3.2, 11.8), 0.6)
    s.surface("roof", 11.8, (3.4, 3), (-6.6, 0))
    shift(s, -1)


@builder("tractor")
def tractor(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Farm tractor, 4 m long, large wheels behind."""
    for side in (-1, 1):
        wheel(s, -95, side * 78, 82, 44, YELLOW)
        wheel(s, 118, side * 76, 50, 30, YELLOW)
        s.slab((-178, -28), mirrored(side, 56, 96), (166, 172), c)
    s.slab((-120, 150), (-26, 26), (56, 98), DARK)
    s.extrude(
        [(-20, 96), (176, 92), (186, 120), (174, 148), (-20, 158)], (-34, 34), c, soft=5, rough=0.3
    )
    s.slab((174, 190), (-28, 28), (92, 138), DARK)
    s.slab((-110, -14), (-54, 54), (98, 160), shade(c, 0.8))
    s.slab((-106, -18), (-52, 52), (160, 244), GLASS, alpha=0.6, rough=0.1)
    s.slab((-118, -6), (-60, 60), (244, 256), c)
    for x in (-106, -18):
        for y in (-52, 52):
            s.slab((x - 3, x + 3), (y - 3, y + 3), (160, 244), DARK)
    s.rod(4, (60, 26, 150), (60, 26, 236), DARK, sections=16)
    s.proxy_slab((-176, -14), (-98, 98), (0, 160), 0.9)
    s.proxy_slab((-14, 190), (-40, 40), (40, 155), 1.0)
    s.proxy_slab((68, 168), (-91, 91), (0, 92), 0.6)
    s.proxy_slab((-116, -8), (-58, 58), (160, 256), 0.2)
    s.surface("roof", 256, (44, 46), (-62, 0))
    shift(s, -6)


@builder("forklift")
def forklift(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Counterbalance forklift, 3.4 m over the forks."""
    for side in (-1, 1):
        wheel(s, 62, side * 46, 32, 24)
        wheel(s, -74, side * 42, 26, 20)
        s.slab((96, 214), mirrored(side, 16, 30), (6, 11), STEEL)
        s.slab((90, 102), mirrored(side, 24, 34), (4, 205), DARK)
        for x in (-70, 56):
            s.rod(4, (x, side * 48, 100), (x * 0.86, side * 46, 206), DARK, sections=12)
    s.extrude(
        [(-118, 34), (-104, 108), (-30, 112), (-24, 62), (70, 62), (82, 34)], (-52, 52), c, soft=4
    )
    s.slab((-96, -34), (-40, 40), (34, 118), shade(c, 0.6))
    s.slab((98, 106), (-46, 46), (20, 64), DARK)
    s.slab((-66, 56), (-52, 52), (204, 211), DARK)
    s.slab((-34, 6), (-24, 24), (84, 96), DARK)
    s.slab((-40, -30), (-24, 24), (96, 140), DARK)
    s.rod(2, (50, 0, 70), (34, 0, 118), DARK, sections=12)
    s.torus(16, 1.6, (32, 0, 120), DARK)
    s.proxy_slab((-118, 90), (-56, 56), (0, 112), 1.0)
    s.proxy_slab((-66, 56), (-52, 52), (112, 211), 0.06)
    s.proxy_slab((90, 106), (-46, 46), (4, 205), 0.3)
    for side in (-1, 1):
        s.proxy_slab((106, 214), mirrored(side, 16, 30), (0, 11), 0.6)
    s.surface("forks", 11, (48, 30), (162, 0))
    shift(s, -48)


def _track(s: Sketch, x: tuple[float, float], y: float, r: float, width: float) -> None:
    lo, hi = x
    s.extrude(
        [(lo, r * 2)]
        + [
            (lo - r * math.sin(math.pi * k / 8), r + r * math.cos(math.pi * k / 8))
            for k in range(1, 8)
        ]
        + [(lo, 0), (hi, 0)]
        + [
            (hi + r * math.sin(math.pi * k / 8), r - r * math.cos(math.pi * k / 8))
            for k in range(1, 8)
        ]
        + [(hi, r * 2)],
        (y - width / 2, y + width / 2),
        DARK,
        rough=0.9,
    )
    n = 5
    for k in range(n):
        px = lo + (hi - lo) * k / (n - 1)
        s.rod(r * 0.62, (px, y - width * 0.54, r), (px, y + width * 0.54, r), STEEL)
        holes(s, (px, y, r), r * 0.62, width * 1.09)
        s.wheel((px, y, r), r * 0.62, parts=2)


@builder("tracked")
def tracked(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "tank") -> None:
    """Battle tank, excavator or bulldozer on tracks."""
    if kind == "tank":
        for side in (-1, 1):
            _track(s, (-270, 250), side * 146, 45, 56)
        s.extrude(
            [(-320, 70), (-310, 128), (250, 128), (330, 96), (290, 62)], (-160, 160), c, soft=4
        )
        prism(
            s,
            [(x, y, 128) for x in (-130, 140) for y in (-112, 112)]
            + [(x, y, 205) for x in (-110, 70) for y in (-84, 84)],
            c,
        )
        s.rod(9, (90, 0, 168), (470, 0, 174), shade(c, 0.85), sections=20)
        s.rod(13, (430, 0, 173.4), (470, 0, 174), shade(c, 0.7), sections=20)
        s.rod(30, (-30, 30, 204), (-30, 30, 222), shade(c, 0.8), sections=24)
        s.proxy_slab((-315, 300), (-174, 174), (0, 128), 1.0)
        s.proxy_slab((-120, 110), (-100, 100), (128, 205), 0.7)
        s.proxy_slab((90, 470), (-11, 11), (160, 182), 0.4)
        s.surface("turret", 205, (70, 60), (-20, 0))
        shift(s, -72)
        return
    for side in (-1, 1):
        _track(s, (-140, 140), side * 102, 42, 52)
    s.slab((-110, 110), (-80, 80), (50, 90), DARK)
    if kind == "bulldozer":
        s.extrude([(-150, 88), (-150, 170), (10, 170), (150, 158), (158, 88)], (-72, 72), c, soft=4)
        s.slab((-120, -10), (-62, 62), (170, 272), GLASS, rough=0.1)
        s.slab((-130, 0), (-70, 70), (272, 286), c)
        for x in (-120, -10):
            for y in (-62, 62):
                s.slab((x - 5, x + 5), (y - 5, y + 5), (170, 272), c)
        s.rod(6, (90, 30, 150), (90, 30, 230), DARK, sections=14)
        arc = [(214 + 20 * math.cos(a), 65 - 65 * math.sin(a)) for a in (-1.5, -0.8, 0.0, 0.8, 1.5)]
        s.extrude(
            [(p[0] - 10, max(p[1], 0)) for p in arc]
            + [(p[0] + 4, max(p[1], 0)) for p in arc[::-1]],
            (-150, 150),
            YELLOW,
        )
        for side in (-1, 1):
            bone(s, (0, side * 132, 44), 8, (206, side * 132, 50), 8, shade(c, 0.8))
        s.proxy_slab((-182, 182), (-128, 128), (0, 88), 1.0)
        s.proxy_slab((-150, 155), (-72, 72), (88, 170), 0.8)
        s.proxy_slab((-125, -5), (-66, 66), (170, 286), 0.12)
        s.proxy_slab((196, 232), (-150, 150), (0, 128), 0.6)
        s.surface("roof", 286, (50, 50), (-65, 0))
        shift(s, -27)
        return
    s.slab((-170, 70), (-110, 110), (92, 190), c, rough=0.4)
    s.slab((-10, 84), (8, 108), (110, 270), GLASS, rough=0.1)
    s.slab((-14, 88), (4, 112), (270, 280), c)
    elbow, wrist = (330.0, -30.0, 330.0), (420.0, -30.0, 150.0)
    bone(s, (60, -30, 160), 22, (230, -30, 370), 20, c)
    bone(s, (230, -30, 370), 20, elbow, 15, c)
    bone(s, elbow, 15, wrist, 12, c)
    s.rod(6, (90, -30, 150), (210, -30, 300), CHROME, sections=14)
    s.extrude(
        [(424, 158), (438, 96), (400, 50), (356, 44), (372, 80), (398, 100), (404, 150)],
        (-76, 16),
        DARK,
        rough=0.7,
    )
    s.proxy_slab((-182, 182), (-128, 128), (0, 92), 1.0)
    s.proxy_slab((-170, 84), (-110, 110), (92, 190), 1.0)
    s.proxy_slab((-10, 84), (8, 108), (190, 280), 0.1)
    s.proxy_slab((100, 330), (-50, -10), (240, 390), 0.15)
    s.proxy_slab((356, 438), (-76, 16), (44, 158), 0.15)
    shift(s, -128)
