"""What people wear: hats, coats and trimmings over a straight trunk, which poses bend along."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders.common import shade
from esg.assets.builders.living import bodies
from esg.assets.geometry.sketch import (
    BRASS,
    DARK,
    GREEN,
    RED,
    WHITE,
    Color,
    Sketch,
    rgb,
)
from esg.assets.lazy import forms

SHIRT = rgb(236, 236, 232)
_BRIGHT, _LEATHER = rgb(214, 232, 80), rgb(70, 46, 28)


def _dome(s: Sketch, z: float, c: Color, of: str, radius: float, rise: float, name: str) -> None:
    turn = [math.radians(a) for a in range(0, 91, 9)]
    profile = [(radius * math.cos(a), rise * math.sin(a)) for a in turn]
    ring = [(radius - 1.2, 0), *profile]
    s.add(lambda: forms.turned(ring, (-0.6, 0, z), 32), c, of=of, name=name)


def _brim(
    s: Sketch, at: tuple[float, float, float], half: tuple[float, float], c: Color, of: str
) -> None:
    size = (2 * half[0], 2 * half[1], 1.0)
    s.add(lambda: forms.cushion(size, at, plan=2.2, side=0.6, levels=7), c, of=of, name="brim")


def _turned(
    s: Sketch, profile: Any, at: tuple[float, float, float], c: Color, of: str, name: str
) -> None:
    s.add(lambda: forms.turned(profile, at, 36), c, of=of, name=name)


def hats(s: Sketch, marks: frozenset[str], hat: Color, c: Color) -> None:
    """Draws what is on an upright head."""
    _helmets(s, marks, hat, c)
    _caps(s, marks, hat, c)
    if "crown" in marks:
        crown(s, BRASS)
    if "great_helm" in marks:
        _turned(
            s,
            [(9.4, 0), (10.6, 1), (10.9, 12), (10.2, 20), (6, 24), (2, 24.6)],
            (0, 0, 148.6),
            hat,
            "steel",
            "helm",
        )
        s.slab((9.9, 11.2), (-6.4, 6.4), (159.6, 161.4), DARK, name="eye_slit")
        s.slab((10.2, 11.3), (-0.8, 0.8), (150, 171), BRASS, name="helm_cross")
    if "space_helmet" in marks:
        s.ball(14, (-0.5, 0, 159.5), shade(c, 1.1), of="plastic_hard", detail=4, name="helmet")
        s.add(
            lambda: forms.cushion(
                (23.5, 24.4, 19.4), (3.0, 0, 159.5), plan=2, side=1, sections=32, levels=17
            ),
            rgb(206, 158, 60),
            of="gold",
            name="visor",
        )
        _turned(
            s,
            [(11.5, 0), (12.6, 1.2), (11.5, 2.6), (10.5, 1.2), (11.5, 0)],
            (-1.4, 0, 144.6),
            shade(c, 0.7),
            "aluminium",
            "collar_ring",
        )


def _helmets(s: Sketch, marks: frozenset[str], hat: Color, c: Color) -> None:
    if "hard_hat" in marks or "brim_helmet" in marks:
        _dome(s, 162.5, hat, "plastic_hard", 10.8, 11.4, "helmet")
        back = 0.0 if "hard_hat" in marks else -2.0
        _brim(s, (1.4 + back, 0, 162.9), (13.6, 12.2), hat, "plastic_hard")
        s.add(
            lambda: forms.tube(
                [(-9.6, 0, 169), (-5, 0, 173.2), (0, 0, 174.2), (5, 0, 173.2), (8.4, 0, 169)],
                0.9,
                10,
            ),
            shade(hat, 0.9),
            of="plastic_hard",
            name="helmet_ridge",
        )
    if "helmet" in marks:
        _dome(s, 160.0, shade(c, 0.8), "paint", 11.4, 13, "helmet")
        s.add(
            lambda: forms.tube(
                [
                    (4, 9.6, 160),
                    (4.5, 6.0, 149.5),
                    (4.6, 0, 146.6),
                    (4.5, -6, 149.5),
                    (4, -9.6, 160),
                ],
                0.5,
                8,
            ),
            _LEATHER,
            of="leather",
            name="chin_strap",
        )
    if "sport_helmet" in marks:
        _dome(s, 161.5, hat, "plastic_hard", 10.9, 12.5, "helmet")
        for y in (-5.2, 0.0, 5.2):
            s.add(
                lambda y=y: forms.cushion(
                    (15, 1.7, 3.0),
                    (-0.6, y, 172.6 - 0.09 * y * y),
                    plan=3,
                    side=0.6,
                    sections=14,
                    levels=7,
                ),
                DARK,
                name="helmet_vent",
            )
        s.add(
            lambda: forms.tube(
                [(1, 9.4, 161), (3.4, 6.2, 150), (4.2, 0, 146.2), (3.4, -6.2, 150), (1, -9.4, 161)],
                0.4,
                8,
            ),
            DARK,
            of="textile",
            name="chin_strap",
        )


def _caps(s: Sketch, marks: frozenset[str], hat: Color, c: Color) -> None:
    if "peaked_cap" in marks:
        profile = [(9.6, 0), (9.9, 3), (12.2, 6.6), (11.2, 8.6), (4, 9.4)]
        _turned(s, profile, (-0.6, 0, 164.2), c, "textile", "cap")
        _turned(
            s,
            [(9.8, 0.2), (10.1, 3.0), (9.6, 3.0), (9.6, 0.2), (9.8, 0.2)],
            (-0.6, 0, 164.2),
            DARK,
            "leather",
            "cap_band",
        )
        _brim(s, (8.6, 0, 164.6), (7, 7), DARK, "plastic_hard")
        s.ball(1.5, (9.9, 0, 169.0), BRASS, detail=2, name="cap_badge")
    if "cap" in marks:
        _dome(s, 163.2, hat, "textile", 10.2, 9.4, "cap")
        _brim(s, (8.0, 0, 163.8), (6.4, 6.8), shade(hat, 0.85), "textile")
        s.ball(0.7, (-0.6, 0, 172.7), shade(hat, 0.8), detail=2, of="textile", name="cap_button")
    if "toque" in marks:
        _turned(
            s,
            [(9.8, 0), (9.9, 5.2), (11.4, 7), (12.6, 10.5), (11.6, 13.6), (7, 15)],
            (-0.8, 0, 162.5),
            hat,
            "linen",
            "toque",
        )
    if "wide_hat" in marks:
        _turned(
            s,
            [(9, 0.4), (13.5, 0.2), (15.0, 1.6), (14.6, 2.0), (13.0, 1.0), (9, 1.2)],
            (-0.6, 0, 164.8),
            hat,
            "felt",
            "brim",
        )
        _turned(
            s, [(9.9, 0), (9.6, 4), (8.6, 7.6), (6, 9.4)], (-0.6, 0, 165.4), hat, "felt", "crown"
        )
        _turned(
            s,
            [(10.1, 0.2), (10.0, 2.2), (9.4, 2.2), (9.4, 0.2), (10.1, 0.2)],
            (-0.6, 0, 165.6),
            shade(hat, 0.5),
            "leather",
            "hat_band",
        )
    if "cone_hat" in marks:
        _turned(
            s,
            [(9, 0), (14.4, 0), (14.6, 0.8), (9.6, 1.4), (5, 9), (0.5, 15)],
            (-0.8, 0, 163.4),
            c,
            "felt",
            "hat",
        )


def crown(s: Sketch, c: Color) -> None:
    """A ring with points on an upright head."""
    _turned(
        s,
        [(9.4, 0), (10.2, 0), (10.8, 5), (9.9, 5), (9.4, 0)],
        (-0.6, 0, 165),
        c,
        "gold",
        "crown",
    )

    def points() -> Any:
        out = []
        for k in range(8):
            a = math.radians(45 * k + 22.5)
            x, y = math.cos(a), math.sin(a)
            out.append(
                forms.tube(
                    [(10.2 * x - 0.6, 10.2 * y, 169.4), (10.9 * x - 0.6, 10.9 * y, 172.6)],
                    [1.7, 0.5],
                    10,
                )
            )
        return forms.gather(out)

    s.add(points, c, of="gold", name="crown_points")


def face_marks(s: Sketch, marks: frozenset[str], hair: Color) -> None:
    """Draws beards, noses, goggles and wigs on an upright head."""
    if "beard" in marks:
        s.add(
            lambda: forms.gather(
                [
                    forms.tube(
                        [(6.2, 0, 150.4), (6.8, 0, 145), (5.6, 0, 138)], [4.9, 4.2, 1.6], 16
                    ),
                    forms.tube(
                        [(7.9, -3.4, 151.6), (9.0, 0, 152.8), (7.9, 3.4, 151.6)], [0.7, 0.9, 0.7], 8
                    ),
                ]
            ),
            hair,
            of="hair",
            name="beard",
        )
    if "moustache" in marks:
        s.add(
            lambda: forms.tube(
                [(8.0, -4.2, 151.8), (9.6, -1.8, 153.6), (9.9, 0, 153.4), (9.6, 1.8, 153.6),
                 (8.0, 4.2, 151.8)],
                [0.5, 1.1, 0.8, 1.1, 0.5],
                10,
            ),
            hair,
            of="hair",
            name="moustache",
        )  # fmt: skip
    if "red_nose" in marks:
        s.ball(2.1, (10.4, 0, 156.0), RED, detail=3, name="red_nose")
    if "goggles" in marks:
        s.add(
            lambda: forms.cushion(
                (5.2, 14.6, 5.0), (6.2, 0, 159.4), plan=2.6, side=0.5, sections=28, levels=9
            ),
            rgb(36, 40, 48),
            of="mirror",
            name="goggles",
        )
    if "wig" in marks:

        def curls() -> Any:
            out = [
                forms.cushion((11, 10, 11), (-2, y, 162.5), plan=2, side=1, sections=14, levels=9)
                for y in (-8.2, 8.2)
            ]
            out += [
                forms.cushion((12, 12, 8), (-2.4, y, 168.4), plan=2, side=1, sections=14, levels=9)
                for y in (-4, 4)
            ]
            return forms.gather(
                [
                    *out,
                    forms.cushion(
                        (11, 14, 14), (-6.4, 0, 162), plan=2, side=1, sections=14, levels=9
                    ),
                ]
            )

        s.add(curls, hair, of="hair", name="wig")


def hang(
    s: Sketch,
    top: float,
    hem: float,
    half: tuple[float, float],
    c: Color,
    name: str,
    of: str = "textile",
) -> None:
    """Cloth that hangs from the trunk at height `top` to an oval hem of half extents `half`."""

    def make() -> Any:
        import numpy as np

        upper = bodies.trunk_ring(top, 0.9)
        turn = 2 * math.pi * np.arange(36) / 36
        folds = 1 + 0.035 * np.cos(turn * 9)
        ring = forms.superellipse(36, 2.2) * half
        rings = []
        for t in np.linspace(0, 1, 12):
            z = hem + (top - hem) * (1 - t)
            least = bodies.trunk_ring(max(z, 86.0), 0.9) if z > 84 else None
            flat = upper * (1 - t**0.8) + (ring * (1 + (folds - 1)[:, None] * t)) * t**0.8
            if least is not None:
                grown = np.linalg.norm(flat, axis=1) < np.linalg.norm(least, axis=1)
                flat[grown] = least[grown]
            rings.append(np.c_[flat, np.full(36, z)])
        return forms.loft(np.array(rings[::-1]))

    s.add(make, c, of=of, name=name)


def band(
    s: Sketch, low: float, high: float, c: Color, of: str, name: str, grow: float = 0.8
) -> None:
    """A strip around the trunk."""
    s.add(lambda: bodies.trunk(low, high, grow), c, of=of, name=name)


def front(
    s: Sketch, outline: Any, low: float, high: float, grow: float, c: Color, of: str, name: str
) -> None:
    s.add(lambda: bodies.front_of(outline, low, high, grow), c, of=of, name=name)


def coats(s: Sketch, marks: frozenset[str], c: Color, seated: bool) -> None:
    """Draws what hangs from the trunk; on those who sit it ends at the hip."""
    if "coat" in marks:
        hang(s, 122, 84 if seated else 54, (13.6, 19), c, "coat")
    if "skirt" in marks:
        hang(s, 104, 80 if seated else 47, (15, 20), c, "skirt")
    if "robe" in marks:
        hang(s, 122, 78 if seated else 3, (14.6, 20), c, "robe")
    if "tabard" in marks:
        outline = [(-8, 66), (8, 66), (9, 134), (-9, 134)]
        front(s, outline, 80, 140, 1.2, RED, "textile", "tabard")
        if not seated:
            s.slab((8.6, 9.6), (-8, 8), (62, 82), RED, of="textile", name="tabard_hem")
    if "apron" in marks:
        apron(s, WHITE, seated)
    if "bib" in marks:
        front(
            s,
            [(-9, 92), (9, 92), (8, 124), (-8, 124)],
            90,
            128,
            1.4,
            shade(c, 1.25),
            "textile",
            "bib",
        )
        for y in (-8.6, 8.6):
            front(
                s,
                [
                    (y - 1.4, 120),
                    (y + 1.4, 120),
                    (y + 2.2 * (y > 0) - 0.4, 141),
                    (y - 2.2 * (y < 0) - 1.4 * (y > 0), 141),
                ],
                118,
                142,
                1.2,
                shade(c, 0.8),
                "textile",
                "strap",
            )
    if "cape" in marks:
        cape(s, rgb(232, 226, 214), seated)


def apron(s: Sketch, c: Color, seated: bool) -> None:
    """Cloth over the lap, without what hangs down where somebody sits."""
    front(
        s,
        [(-13, 82), (13, 82), (12, 103), (7, 108), (-7, 108), (-12, 103)],
        80,
        112,
        1.6,
        c,
        "linen",
        "apron",
    )
    if not seated:
        s.add(
            lambda: forms.cushion(
                (2.0, 26, 26), (10.0, 0, 72), plan=8, side=0.2, sections=20, levels=7
            ),
            c,
            of="linen",
            name="apron_skirt",
        )
    band(s, 100, 102.6, c, "linen", "apron_strings", 1.3)


def cape(s: Sketch, c: Color, seated: bool) -> None:
    """Cloth that hangs from the shoulders down the back."""

    def make() -> Any:
        import numpy as np

        rings = []
        for t in np.linspace(0, 1, 9):
            z = 140 - (140 - (82 if seated else 8)) * t
            y = np.linspace(-1, 1, 19) * (15 + 7 * t)
            fold = 0.9 * np.cos(np.linspace(0, 9, 19) * math.pi) * t
            back = -10.5 - 2.4 * t + fold + 0.012 * y**2
            rings.append(
                np.concatenate(
                    [np.c_[back, y, np.full(19, z)], np.c_[back - 1.0, y, np.full(19, z)][::-1]]
                )
            )
        return forms.loft(np.array(rings))

    s.add(make, c, of="textile", name="cape")


def trimmings(s: Sketch, marks: frozenset[str], c: Color) -> None:
    """Draws belts, bands, ties, badges, buttons and packs."""
    over = 2.2 if "coat" in marks else 0.9
    if "belt" in marks:
        band(s, 96.5, 100.5, _LEATHER, "leather", "belt", 2.0 if "robe" in marks else 1.3)
        s.add(
            lambda: forms.cushion(
                (1.4, 5.4, 4.6),
                (9.9 if "robe" not in marks else 10.8, 0, 98.5),
                plan=5,
                side=0.3,
                sections=16,
                levels=5,
            ),
            BRASS,
            of="brass",
            name="buckle",
        )
    if "bands" in marks:
        for z in (106, 120):
            band(s, z, z + 4, _BRIGHT, "paint", "reflective_band", over)
    if "bands_thin" in marks:
        band(s, 122, 126, SHIRT, "textile", "chest_band")
    if "chest_band" in marks:
        band(s, 112, 120, SHIRT, "textile", "chest_band")
    _fastenings(s, marks, c)
    if "ruff" in marks:
        _turned(
            s,
            [
                (8 + 3.6 * math.cos(a), 142.5 + 2.4 * math.sin(a))
                for a in (math.pi * k / 6 for k in range(12))
            ]
            + [(11.6, 142.5)],
            (-2, 0, 0),
            WHITE,
            "linen",
            "ruff",
        )
    if "pack" in marks:
        s.add(
            lambda: forms.cushion((7, 22, 32), (-12.6, 0, 119), plan=5, side=0.35),
            shade(c, 0.72),
            of="textile",
            name="backpack",
        )
        straps(s, shade(c, 0.5))
    if "big_pack" in marks:
        s.add(
            lambda: forms.cushion((7, 26, 46), (-12.6, 0, 118), plan=4.5, side=0.4),
            rgb(190, 70, 36),
            of="textile",
            name="backpack",
        )
        s.add(
            lambda: forms.cushion((2.4, 18, 18), (-14.6, 0, 110), plan=4.5, side=0.4),
            rgb(166, 58, 30),
            of="textile",
            name="pack_pocket",
        )
        s.add(
            lambda: forms.turned(
                [(2, -14), (4.6, -14), (4.8, 0), (4.6, 14), (2, 14)], (-11.6, 0, 145), 20, "y"
            ),
            rgb(70, 92, 70),
            of="foam",
            name="bedroll",
        )
        straps(s, rgb(60, 44, 34))


def _fastenings(s: Sketch, marks: frozenset[str], c: Color) -> None:
    if "shirt" in marks:
        front(
            s,
            [(-5.2, 144), (5.2, 144), (0.8, 112), (-0.8, 112)],
            108,
            145,
            1.15,
            SHIRT,
            "linen",
            "shirt_front",
        )
        for side in (-1, 1):
            lapel = [(side * 5.0, 143), (side * 8.6, 139), (side * 8.0, 130), (side * 1.0, 111.5)]
            front(s, lapel, 108, 144, 1.5, shade(c, 0.86), "textile", "lapel")
    if "tie" in marks:
        tie(s, rgb(140, 30, 40) if "shirt" in marks else DARK)
    if "badge" in marks:
        front(
            s,
            [(5.4, 126), (7.2, 124), (9.0, 126), (9.0, 129.4), (5.4, 129.4)],
            120,
            134,
            1.7,
            BRASS,
            "brass",
            "badge",
        )
    for mark, radius, tone in (("buttons", 1.0, DARK), ("buttons_large", 2.4, GREEN)):
        if mark in marks:
            for z in (111, 119, 127):
                for y in (-3.4, 3.4) if mark == "buttons" else (0.0,):
                    s.add(
                        lambda z=z, y=y, r=radius: forms.cushion(
                            (1.2, 2 * r, 2 * r),
                            (9.6 + (z - 108) * 0.06, y, z),
                            plan=2,
                            side=0.7,
                            sections=12,
                            levels=7,
                        ),
                        tone,
                        of="plastic_hard",
                        name="button",
                    )


def tie(s: Sketch, c: Color) -> None:
    """A tie from the collar to the belt."""
    outline = [
        (-1.4, 142),
        (1.4, 142),
        (0.9, 139),
        (2.2, 117),
        (0, 113.5),
        (-2.2, 117),
        (-0.9, 139),
    ]
    front(s, outline, 110, 144, 1.8, c, "textile", "tie")


def straps(s: Sketch, c: Color) -> None:
    """Both straps of what is on the back."""

    def make() -> Any:
        out = []
        for y in (-10.5, 10.5):
            path = [
                (-11, y, 136),
                (-4, y, 142.6),
                (6, y, 137),
                (9.6, y, 126),
                (7.4, y * 1.2, 112),
                (-3, y * 1.42, 106),
            ]
            out.append(forms.tube(forms.smooth_path(path, 16), 1.5, 8, flat=1.0))
        return forms.gather(out)

    s.add(make, c, of="textile", name="straps")
