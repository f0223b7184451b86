"""Drawings of two-wheelers: spoked wheels, frames, saddles, engines."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders.common import shade
from esg.assets.geometry.sketch import CHROME, DARK, RUBBER, STEEL, Color, Sketch, rgb
from esg.assets.lazy import forms, shapes

LAMP, TAIL, AMBER = (0.95, 0.95, 0.92), (0.5, 0.02, 0.02), (0.92, 0.45, 0.06)
_SADDLE = rgb(34, 30, 30)


def _bend(path: Any, radius: float, count: int = 14, sections: int = 10) -> Any:
    return forms.tube(forms.smooth_path(path, count), radius, sections)


def spoked_wheel(s: Sketch, x: float, r: float, tyre: float, name: str, spokes: int = 28) -> None:
    """A bicycle's wheel about Y: tyre with a tread, rim, hub and crossed spokes."""
    at = (x, 0.0, r)
    rim = r - 1.9 * tyre
    turn = [math.radians(a) for a in range(0, 360, 30)]
    section = [(r - tyre + tyre * math.cos(a), 0.92 * tyre * math.sin(a)) for a in turn]
    s.add(lambda: forms.turned([*section, section[0]], at, 44, "y"), RUBBER, name=f"tyre_{name}")
    q = tyre * 0.62
    ring = [
        (rim - q, -0.5 * q),
        (rim + q, -q),
        (rim + q, q),
        (rim - q, 0.5 * q),
        (rim - q, -0.5 * q),
    ]
    s.add(lambda: forms.turned(ring, at, 44, "y"), STEEL, of="aluminium", name=f"rim_{name}")
    hub = 0.075 * r

    def laced() -> Any:
        out = [
            forms.turned(
                [
                    (hub * 0.6, -4.4),
                    (hub, -3.8),
                    (hub * 0.55, -3),
                    (hub * 0.55, 3),
                    (hub, 3.8),
                    (hub * 0.6, 4.4),
                ],
                at,
                16,
                "y",
            )
        ]
        ends = []
        for k in range(spokes):
            a = 2 * math.pi * k / spokes
            b = a + (0.42 if k % 4 < 2 else -0.42)
            start = (x + hub * math.cos(b), 3.4 if k % 2 else -3.4, r + hub * math.sin(b))
            ends.append((start, (x + rim * math.cos(a), 0.0, r + rim * math.sin(a))))
        out.append(forms.needles(ends, 0.16))
        return forms.gather(out)

    s.add(laced, CHROME, name=f"spokes_{name}")
    s.wheel(at, r, parts=3)


def saddle(at: tuple[float, float, float], length: float, width: float) -> Any:
    """A bicycle saddle, its nose to +X; `at` is its middle on top."""
    import numpy as np

    x, y, z = at
    t = np.linspace(0, 1, 14)
    half = (
        forms.profile([(0, 0.34), (0.12, 0.5), (0.3, 0.5), (0.5, 0.3), (0.75, 0.15), (1, 0.08)])(t)
        * width
    )
    top = forms.profile([(0, 0.6), (0.2, 0.0), (0.6, -0.9), (1, -0.5)])(t)
    deep = forms.profile([(0, 2.6), (0.2, 4.6), (0.6, 3.6), (1, 2.2)])(t)
    ring = forms.superellipse(16, 2.6)
    rings = [
        np.c_[
            np.full(16, x - 0.5 * length + length * v),
            y + ring[:, 0] * h,
            z + u - 0.5 * d + 0.5 * d * ring[:, 1],
        ]
        for v, h, u, d in zip(t, half, top, deep, strict=True)
    ]
    return forms.loft(np.array(rings))


def draw_bicycle(s: Sketch, c: Color) -> None:
    """City bicycle on its kickstand at 175 x 58 x 106."""
    r, xf, xr = 34.0, 53.5, -53.5
    spoked_wheel(s, xf, r, 2.0, "front")
    spoked_wheel(s, xr, r, 2.0, "rear")
    bb, seat = (-8.0, 0.0, 28.0), (-25.0, 0.0, 76.0)
    head, low_head = (33.0, 0.0, 84.0), (36.6, 0.0, 70.0)

    def frame() -> Any:
        out = [
            forms.tube([a, b], radius, 14)
            for a, b, radius in (
                (bb, seat, 1.7),
                (seat, head, 1.6),
                (bb, low_head, 2.1),
                ((32.4, 0, 86.4), (37.2, 0, 67.6), 2.3),
            )
        ]
        out.append(forms.turned([(2.6, -3.8), (2.6, 3.8)], bb, 18, "y"))
        for y in (-5.4, 5.4):
            out.append(
                _bend([(bb[0] - 2, y * 0.45, bb[2]), (-30, y * 0.9, 30.5), (xr, y, r)], 0.95, 8, 10)
            )
            out.append(
                _bend(
                    [(seat[0] - 0.6, y * 0.3, seat[2] - 3), (-36, y * 0.8, 57), (xr, y, r)],
                    0.8,
                    8,
                    10,
                )
            )
        return forms.gather(out)

    s.add(frame, c, of="car_body", name="frame")

    def fork() -> Any:
        out = [
            _bend([(37.2, y * 0.75, 67), (42, y, 54), (47.5, y, 42), (xf, y, r)], 1.05, 12, 10)
            for y in (-4.6, 4.6)
        ]
        out.append(
            forms.cushion((5, 12, 4), (37.6, 0, 67), plan=3, side=0.6, sections=16, levels=7)
        )
        return forms.gather(out)

    s.add(fork, c, of="car_body", name="fork")
    _cockpit(s, seat)
    _drive(s, bb, xr, r)
    for x, name, a0, a1 in ((xf, "front", 35, 165), (xr, "rear", 20, 200)):
        s.add(
            lambda x=x, a0=a0, a1=a1: _mudguard(x, r, a0, a1),
            shade(c, 0.9),
            of="car_body",
            name=f"mudguard_{name}",
        )
    s.add(lambda: forms.tube([(-20, 3, 24), (-21.6, 13.4, 0.9)], 0.85, 10), STEEL, name="kickstand")
    s.add(
        lambda: forms.turned([(1.0, 0), (3.2, 1), (3.6, 4.4), (3.3, 4.8)], (39.5, 0, 91), 20, "x"),
        CHROME,
        name="headlight_shell",
    )
    s.add(
        lambda: forms.turned([(3.3, 4.5), (2.4, 5.3), (0.6, 5.5)], (39.5, 0, 91), 20, "x"),
        LAMP,
        of="lamp",
        name="headlight",
    )
    s.add(
        lambda: forms.cushion(
            (2.4, 5.0, 3.4), (-87, 0, 48), plan=3, side=0.5, sections=16, levels=7
        ),
        TAIL,
        of="lamp",
        name="tail_light",
    )


def _cockpit(s: Sketch, seat: tuple[float, float, float]) -> None:
    """Handlebar and saddle."""
    bar = [
        (15, -28.6, 100.4),
        (24, -27.2, 101.2),
        (33, -16, 102.4),
        (35, -5, 102.8),
        (35, 5, 102.8),
        (33, 16, 102.4),
        (24, 27.2, 101.2),
        (15, 28.6, 100.4),
    ]
    s.add(lambda: _bend(bar, 1.15, 34, 12), CHROME, name="handlebar")
    s.add(
        lambda: forms.gather([forms.tube([(33, 0, 84), (31, 0, 97), (34.4, 0, 102)], 1.4, 14)]),
        CHROME,
        name="stem",
    )
    s.add(
        lambda: forms.gather(
            [forms.tube([(23, y * 27.4, 101.1), (14, y * 28.7, 100.3)], 1.75, 14) for y in (-1, 1)]
        ),
        RUBBER,
        name="grips",
    )
    s.add(
        lambda: forms.gather(
            [
                _bend([(30, y * 21, 101.2), (29, y * 24.5, 98.4), (19, y * 27.4, 97)], 0.5, 8, 8)
                for y in (-1, 1)
            ]
        ),
        CHROME,
        name="brake_levers",
    )
    s.add(
        lambda: forms.tube([(seat[0], 0, 74), (-28.2, 0, 93)], 1.35, 14), CHROME, name="seat_post"
    )
    s.add(lambda: saddle((-28, 0, 97.2), 28, 18), _SADDLE, of="leather", name="saddle")


def _mudguard(x: float, r: float, start: float, end: float) -> Any:
    import numpy as np

    around = np.radians(np.linspace(start, end, 22))
    y = np.linspace(-1, 1, 9)
    rings = []
    for a in around:
        out, inn = [], []
        for v in y:
            q = r + 1.9 - 0.9 * v * v
            out.append((x + q * math.cos(a), 2.9 * v, r + q * math.sin(a)))
            inn.append((x + (q - 0.35) * math.cos(a), 2.8 * v, r + (q - 0.35) * math.sin(a)))
        rings.append(out + inn[::-1])
    return forms.loft(np.array(rings))


def _drive(s: Sketch, bb: tuple[float, float, float], xr: float, r: float) -> None:
    """Chainring, chain, cranks and pedals."""

    def ring() -> Any:
        out = [
            forms.turned(
                [(7.4, 5.2), (9.0, 5.2), (9.0, 5.8), (7.4, 5.8), (7.4, 5.2)],
                (bb[0], 0, bb[2]),
                32,
                "y",
            )
        ]
        out += [forms.turned([(2.6, 4.0), (2.6, 6.2)], (bb[0], 0, bb[2]), 16, "y")]
        for k in range(5):
            a = 2 * math.pi * k / 5
            out.append(
                forms.tube(
                    [(bb[0], 5.5, bb[2]), (bb[0] + 8 * math.cos(a), 5.5, bb[2] + 8 * math.sin(a))],
                    0.6,
                    6,
                    round_ends=False,
                )
            )
        out.append(
            forms.turned([(1.2, 4.8), (3.4, 5.2), (3.4, 5.8), (1.2, 6)], (xr, 0, r), 18, "y")
        )
        return forms.gather(out)

    s.add(ring, STEEL, name="chainring")
    s.add(
        lambda: forms.gather(
            [
                forms.tube([(bb[0] + 1, 5.5, bb[2] + q * 9.2), (xr, 5.5, r + q * 3.6)], 0.45, 6)
                for q in (-1, 1)
            ]
        ),
        DARK,
        of="steel",
        name="chain",
    )
    ends = ((-1, (bb[0] + 12, -8.6, bb[2] - 11)), (1, (bb[0] - 12, 8.6, bb[2] + 11)))

    def cranks() -> Any:
        return forms.gather(
            [forms.tube([(bb[0], q * 6.8, bb[2]), end], [1.3, 0.95], 10) for q, end in ends]
        )

    s.add(cranks, STEEL, of="aluminium", name="cranks")
    s.add(
        lambda: forms.gather(
            [
                forms.cushion(
                    (9, 9, 2.2),
                    (end[0], end[1] + q * 4.6, end[2]),
                    plan=5,
                    side=0.4,
                    sections=16,
                    levels=5,
                )
                for q, end in ends
            ]
        ),
        DARK,
        of="rubber",
        name="pedals",
    )


def _motor_wheel(s: Sketch, x: float, r: float, t: float, name: str) -> None:
    at = (x, 0.0, r)
    turn = [math.radians(a) for a in range(-150, 151, 25)]
    section = [(r - t + t * math.cos(a), 1.05 * t * math.sin(a)) for a in turn]
    groove = [(q - (0.05 * t if k % 2 else 0), y) for k, (q, y) in enumerate(section)]
    s.add(lambda: forms.turned([*groove, groove[0]], at, 34, "y"), RUBBER, name=f"tyre_{name}")
    rim = r - 1.75 * t

    def alloy() -> Any:
        ring = [
            (rim - 2, -4.2),
            (rim + 1.6, -5.2),
            (rim + 1.6, 5.2),
            (rim - 2, 4.2),
            (rim - 2, -4.2),
        ]
        out = [
            forms.turned(ring, at, 36, "y"),
            forms.turned([(3.6, -6.5), (5, -5), (5, 5), (3.6, 6.5)], at, 18, "y"),
        ]
        for k in range(5):
            for off in (-0.2, 0.2):
                a, b = 2 * math.pi * k / 5, 2 * math.pi * k / 5 + off
                out.append(
                    forms.tube(
                        [
                            (x + 4 * math.cos(a), 0, r + 4 * math.sin(a)),
                            (x + rim * math.cos(b), 0, r + rim * math.sin(b)),
                        ],
                        [2.0, 1.3],
                        8,
                        round_ends=False,
                    )
                )
        return forms.gather(out)

    s.add(alloy, (0.2, 0.2, 0.21), of="aluminium", name=f"rim_{name}")
    s.add(
        lambda: forms.turned(
            [(7.5, 6.2), (13.5, 6.2), (13.5, 6.8), (7.5, 6.8), (7.5, 6.2)], at, 22, "y"
        ),
        STEEL,
        name=f"brake_{name}",
    )
    s.wheel(at, r, parts=3)


def _pod(stations: Any, sections: int = 18, power: float = 2.8) -> Any:
    """A smooth body along X: stations of x, height of its middle, half width, half height."""
    import numpy as np

    table = np.array(stations, float)
    x = np.linspace(table[0, 0], table[-1, 0], 20)
    z, wide, high = (forms.profile(table[:, [0, k]])(x) for k in (1, 2, 3))
    ring = forms.superellipse(sections, power)
    rings = [
        np.c_[np.full(sections, a), ring[:, 0] * w, b + ring[:, 1] * h]
        for a, b, w, h in zip(x, z, wide, high, strict=True)
    ]
    return forms.loft(np.array(rings))


def draw_motorcycle(s: Sketch, c: Color) -> None:
    """Naked motorcycle on its stand at 210 x 80 x 112."""
    r, xf, xr = 32.0, 73.0, -70.0
    _motor_wheel(s, xf, r, 6.0, "front")
    _motor_wheel(s, xr, r, 7.5, "rear")
    s.add(
        lambda: _pod(
            [
                (-14, 80, 6, 5),
                (-8, 80, 12, 9),
                (10, 82, 15.5, 11.5),
                (30, 85, 15, 12),
                (44, 84, 11, 9),
                (50, 80, 5, 5),
            ]
        ),
        c,
        of="car_body",
        name="tank",
    )
    s.add(
        lambda: forms.turned([(2.6, 0), (2.6, 1.4), (1.4, 1.8)], (20, 0, 96), 18),
        CHROME,
        name="filler_cap",
    )
    s.add(
        lambda: _pod(
            [
                (-62, 84, 9, 4),
                (-52, 83.5, 13, 5.4),
                (-32, 82, 13.5, 6),
                (-14, 82, 10, 6),
                (-6, 83, 7, 5),
            ],
            power=3.4,
        ),
        _SADDLE,
        of="leather",
        name="seat",
    )
    s.add(
        lambda: _pod(
            [
                (-96, 86, 2.5, 1.8),
                (-88, 84, 6, 4),
                (-66, 78, 9.5, 6),
                (-40, 73, 9, 5),
                (-24, 71, 6, 4),
            ]
        ),
        c,
        of="car_body",
        name="tail",
    )
    s.add(
        lambda: forms.cushion((5, 11, 5.4), (-94, 0, 83), plan=3, side=0.5, sections=18, levels=7),
        TAIL,
        of="lamp",
        name="tail_light",
    )
    s.add(
        lambda: forms.tube([(-84, 0, 80), (-96, 0, 66), (-100, 0, 56)], [1.6, 1.4, 1.2], 10),
        DARK,
        name="plate_holder",
    )
    s.add(
        lambda: shapes.box((0.8, 18, 12), (-100.6, 0, 58)),
        rgb(236, 236, 232),
        of="paint",
        name="number_plate",
    )
    _motor_sides(s, xf, xr, r)
    _motor_front(s)
    s.add(lambda: _guard(xf, r, 8.4, 1.6, 20, 140), c, of="car_body", name="mudguard_front")
    s.add(lambda: _guard(xr, r, 9.4, 2.4, 40, 135), DARK, name="mudguard_rear")
    _engine(s)


def _motor_sides(s: Sketch, xf: float, xr: float, r: float) -> None:
    """What a motorcycle has on either side."""
    for side, word in ((1, "left"), (-1, "right")):
        y = 9.5 * side
        s.add(
            lambda y=y: forms.tube([(xf, y, r), (58, y, 62)], 3.1, 10),
            rgb(40, 40, 44),
            of="aluminium",
            name=f"fork_leg_{word}",
        )
        s.add(
            lambda y=y: forms.tube([(59, y, 60), (46, y, 91)], 2.1, 10),
            CHROME,
            name=f"fork_tube_{word}",
        )
        s.add(
            lambda y=y: forms.tube([(xr, y, r), (-44, y, 36), (-20, y, 40)], [2.6, 2.8, 3.2], 12),
            rgb(58, 58, 62),
            of="aluminium",
            name=f"swing_arm_{word}",
        )
        s.add(
            lambda y=y: _spring((xr + 10, y, r + 8), (-42, y * 0.9, 70)),
            rgb(176, 30, 30),
            of="steel",
            name=f"shock_{word}",
        )
        s.add(lambda side=side: _indicators(side), AMBER, of="lamp", name=f"indicators_{word}")
        s.add(lambda side=side: _motor_mirror(side), DARK, name=f"mirror_{word}")
        s.add(
            lambda side=side: forms.tube([(33, 29 * side, 102.8), (21, 38 * side, 101.4)], 2.3, 14),
            RUBBER,
            name=f"grip_{word}",
        )


def _motor_front(s: Sketch) -> None:
    """Handlebar, headlight and dials."""
    s.add(
        lambda: _bend(
            [
                (21, -38.4, 101.4),
                (34, -28, 103),
                (46, -12, 101),
                (47, 0, 98),
                (46, 12, 101),
                (34, 28, 103),
                (21, 38.4, 101.4),
            ],
            1.5,
            28,
            12,
        ),
        CHROME,
        name="handlebar",
    )
    s.add(
        lambda: forms.gather(
            [
                forms.cushion((12, 26, 4), (49, 0, 91), plan=4, side=0.5, sections=20, levels=7),
                forms.cushion((12, 25, 4), (54, 0, 74), plan=4, side=0.5, sections=20, levels=7),
            ]
        ),
        rgb(60, 60, 64),
        of="aluminium",
        name="fork_bridges",
    )
    s.add(
        lambda: forms.turned(
            [(2, -9), (7, -7), (9.4, 0), (9.8, 2.4), (9.2, 2.8)], (60, 0, 87), 26, "x"
        ),
        CHROME,
        name="headlight_shell",
    )
    s.add(
        lambda: forms.turned([(9.2, 2.0), (8.6, 3.2), (5, 4.6), (1, 5.0)], (60, 0, 87), 26, "x"),
        LAMP,
        of="lamp",
        name="headlight",
    )
    s.add(
        lambda: forms.gather(
            [
                forms.turned([(1, -3.2), (4.4, -2.6), (4.8, 0.4), (4.2, 0.8)], (50, y, 99), 18, "x")
                for y in (-5.4, 5.4)
            ]
        ),
        DARK,
        name="dials",
    )


def _spring(a: Any, b: Any) -> Any:
    import numpy as np

    p, q = np.asarray(a, float), np.asarray(b, float)
    rings = []
    for k in range(1, 9):
        t = 0.18 + 0.72 * k / 9
        rings.append(
            forms.tube(
                [p + (q - p) * (t - 0.02), p + (q - p) * (t + 0.02)], 3.1, 10, round_ends=False
            )
        )
    return forms.gather([forms.tube([p, q], 1.7, 10), *rings])


def _indicators(side: int) -> Any:
    return forms.gather(
        [
            forms.cushion((5, 5, 4), at, plan=2.2, side=0.8, sections=8, levels=5)
            for at in ((57, side * 17, 84), (-88, side * 14, 80))
        ]
    )


def _motor_mirror(side: int) -> Any:
    return forms.gather(
        [
            forms.tube([(36, 24 * side, 103), (38, 25.5 * side, 108)], 0.6, 8),
            forms.cushion(
                (2.2, 11, 6.6), (38, 30 * side, 108.6), plan=2.6, side=0.5, sections=18, levels=7
            ),
        ]
    )


def _guard(x: float, r: float, half: float, gap: float, start: float, end: float) -> Any:
    import numpy as np

    around = np.radians(np.linspace(start, end, 13))
    y = np.linspace(-1, 1, 9)
    rings = []
    for a in around:
        q = r + gap - 3.0 * y**4
        out = np.c_[x + q * math.cos(a), half * y, r + q * math.sin(a)]
        inn = np.c_[x + (q - 0.7) * math.cos(a), half * 0.96 * y, r + (q - 0.7) * math.sin(a)]
        rings.append(np.concatenate([out, inn[::-1]]))
    return forms.loft(np.array(rings))


def _engine(s: Sketch) -> None:
    metal = rgb(120, 122, 126)
    s.add(
        lambda: _pod(
            [(-28, 36, 6, 7), (-22, 37, 13, 12), (8, 36, 14, 13), (24, 38, 12, 10), (30, 40, 6, 6)],
            power=4,
        ),
        metal,
        of="aluminium",
        name="crankcase",
    )

    def fins() -> Any:
        out = []
        for k in range(7):
            t = k / 6
            out.append(
                forms.cushion(
                    (25 - 3 * t, 27 - 2 * t, 1.7),
                    (13 + 8 * t, 0, 48 + 19 * t),
                    plan=6,
                    side=0.3,
                    sections=16,
                    levels=4,
                )
            )
        out.append(forms.tube([(12, 0, 45), (21, 0, 70)], 9, 18))
        return forms.gather(out)

    s.add(fins, metal, of="aluminium", name="cylinder")
    s.add(
        lambda: forms.gather(
            [
                forms.turned([(11, 0), (11.5, 2), (9.5, 4), (4, 4.6)], (2, y, 37), 26, "y")
                if y > 0
                else forms.turned([(4, -4.6), (9.5, -4), (11.5, -2), (11, 0)], (2, y, 37), 26, "y")
                for y in (-13, 13)
            ]
        ),
        rgb(70, 70, 74),
        of="aluminium",
        name="engine_covers",
    )
    _exhaust(s)


def _exhaust(s: Sketch) -> None:
    """Exhaust, frame, stand and pegs."""
    pipe = [
        (24, -6, 60),
        (32, -10, 50),
        (30, -14, 34),
        (14, -16, 24),
        (-30, -17, 24),
        (-52, -18, 28),
    ]
    s.add(lambda: _bend(pipe, 2.2, 30, 12), CHROME, name="exhaust_pipe")
    s.add(
        lambda: forms.tube(
            [(-44, -18, 27), (-54, -18.4, 28.6), (-84, -20, 34.5)],
            [2.6, 4.6, 4.9],
            18,
            round_ends=False,
        ),
        CHROME,
        name="silencer",
    )
    s.add(
        lambda: forms.gather(
            [
                forms.tube([(46, 0, 86), (30, 0, 76), (-20, 0, 74), (-30, 0, 68)], 2.4, 12),
                forms.tube(
                    [
                        (48, 0, 82),
                        (34, 0, 56),
                        (28, 0, 36),
                        (-10, 0, 24),
                        (-30, 0, 40),
                        (-24, 0, 72),
                    ],
                    2.2,
                    12,
                ),
            ]
        ),
        DARK,
        of="steel",
        name="frame",
    )
    s.add(lambda: forms.tube([(-8, 12, 24), (-11, 26, 1.5)], 1.3, 10), STEEL, name="side_stand")
    s.add(
        lambda: forms.gather(
            [forms.tube([(-12, q * 10, 30), (-13, q * 24, 30)], 1.7, 10) for q in (-1, 1)]
        ),
        RUBBER,
        name="foot_pegs",
    )


def draw_scooter(s: Sketch, c: Color) -> None:
    """Kick scooter, 100 x 45 x 100."""
    for x, name in ((41.0, "front"), (-41.0, "rear")):
        at = (x, 0.0, 9.0)
        turn = [math.radians(a) for a in range(0, 360, 30)]
        section = [(6.6 + 2.4 * math.cos(a), 2.4 * math.sin(a)) for a in turn]
        s.add(
            lambda at=at, section=section: forms.turned([*section, section[0]], at, 32, "y"),
            RUBBER,
            name=f"tyre_{name}",
        )
        s.add(lambda at=at: _small_rim(at, 5.2), STEEL, of="aluminium", name=f"rim_{name}")
        s.wheel(at, 9.0, parts=2)
    s.add(
        lambda: forms.cushion(
            (62, 14, 2.6), (-5, 0, 10.2), plan=10, side=0.35, sections=32, levels=7
        ),
        c,
        of="aluminium",
        name="deck",
    )
    s.add(
        lambda: forms.cushion(
            (52, 11, 0.6), (-7, 0, 11.6), plan=10, side=0.3, sections=28, levels=5
        ),
        DARK,
        of="rubber",
        name="grip_tape",
    )
    s.add(
        lambda: forms.gather(
            [
                _bend([(24, 0, 10.6), (31, 0, 13), (36, 0, 20.5)], 2.4, 8, 12),
                forms.tube([(37, 0, 16), (26.4, 0, 96)], 1.7, 14),
                *(forms.tube([(37, y, 18), (41, y, 9)], 1.1, 10) for y in (-3.4, 3.4)),
                forms.tube([(37, -3.4, 18.5), (37, 3.4, 18.5)], 1.1, 10),
            ]
        ),
        STEEL,
        of="aluminium",
        name="steering_column",
    )
    s.add(
        lambda: forms.tube([(26.2, -14, 97.5), (26.2, 14, 97.5)], 1.4, 14),
        STEEL,
        of="aluminium",
        name="handlebar",
    )
    s.add(
        lambda: forms.gather(
            [forms.tube([(26.2, q * 11, 97.5), (26.2, q * 21, 97.5)], 1.8, 14) for q in (-1, 1)]
        ),
        RUBBER,
        name="grips",
    )
    s.add(lambda: _guard(-41, 9, 3.4, 1.4, 55, 150), shade(c, 0.6), of="aluminium", name="brake")


def _small_rim(at: tuple[float, float, float], r: float) -> Any:
    x, y, z = at
    out = [
        forms.turned(
            [(r - 1, -1.4), (r, -1.8), (r, 1.8), (r - 1, 1.4), (r - 1, -1.4)], at, 28, "y"
        ),
        forms.turned([(1.6, -2.2), (1.6, 2.2)], at, 12, "y"),
    ]
    for k in range(5):
        a = 2 * math.pi * k / 5
        out.append(
            forms.tube(
                [(x, y, z), (x + r * math.cos(a), y, z + r * math.sin(a))], 0.8, 8, round_ends=False
            )
        )
    return forms.gather(out)
