"""Computers, phones and other boxes with a screen or a dial."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.sketch import (
    DARK,
    STEEL,
    WHITE,
    Color,
    Sketch,
    rgb,
)
from esg.assets.lazy import forms, shapes

PAPER = rgb(240, 236, 224)


_A = math.radians(20.0)
_LID = (
    (-math.sin(_A), 0, math.cos(_A), -8.0 - 10.95 * math.sin(_A) - 0.5 * math.cos(_A)),
    (0, 1, 0, 0),
    (math.cos(_A), 0, math.sin(_A), 1.5 + 10.95 * math.cos(_A) - 0.5 * math.sin(_A)),
    (0, 0, 0, 1),
)
"""Where an emblem lies on the back of a laptop's lid."""


@builder("laptop")
def laptop(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Open laptop, screen facing +X, drawn at 32 x 33 x 22."""
    s.add(
        lambda: forms.cushion(
            (24, 33, 1.6), (4, 0, 0.8), plan=24, side=0.35, sections=48, levels=9
        ),
        c,
        of="aluminium",
        name="base",
    )
    s.proxy_slab((-8, 16), (-16.5, 16.5), (0, 1.6), 3)
    s.slab(
        (-6.6, 4.9), (-15, 15), (1.54, 1.66), shade(c, 0.55), of="aluminium", name="keyboard_well"
    )

    def keys() -> Any:
        out = []
        for i, row in enumerate((14, 14, 13, 12, 9)):
            x = -5.5 + i * 2.25
            wide = 29.4 / row
            for j in range(row):
                out.append(
                    shapes.box((1.9, 0.86 * wide, 0.26), (x, -14.7 + (j + 0.5) * wide, 1.74))
                )
        return forms.gather(out)

    s.add(keys, DARK, of="plastic", name="keys")
    s.slab((6.2, 14.2), (-5.6, 5.6), (1.56, 1.64), shade(c, 0.9), of="aluminium", name="touchpad")
    s.add(
        lambda: forms.gather([forms.turned([(0.55, -13), (0.55, 13)], (-8.0, 0, 1.5), 14, "y")]),
        DARK,
        of="plastic",
        name="hinge",
    )

    def lid(inset: float, near: float, far: float, corner: float) -> Any:
        import numpy as np

        mesh = forms.cushion(
            (21.9 - 2 * inset, 33 - 2 * inset, far - near),
            (10.95, 0, (near + far) / 2),
            plan=corner,
            side=0.3,
            sections=48,
            levels=7,
        )
        v = np.asarray(mesh.vertices)
        lean = math.radians(110.0)
        along, out = v[:, 0], v[:, 2]
        mesh.vertices = np.c_[
            -8.0 + along * math.cos(lean) + out * math.sin(lean),
            -v[:, 1],
            1.5 + along * math.sin(lean) - out * math.cos(lean),
        ]
        return mesh

    s.add(lambda: lid(0.0, -0.45, 0.35, 24.0), c, of="aluminium", name="lid")
    s.add(lambda: lid(0.5, 0.2, 0.5, 24.0), DARK, of="plastic_hard", name="bezel")
    s.add(lambda: lid(1.3, 0.4, 0.56, 60.0), (0.16, 0.3, 0.5), of="screen", name="display")
    s.add(
        lambda: forms.cushion(
            (3.6, 3.6, 0.2), (0, 0, 0), plan=3, side=0.5, sections=20, levels=5
        ).apply_transform(_LID),
        shade(c, 1.25),
        of="mirror",
        name="emblem",
    )
    points = [
        (x, y * 16.5, z)
        for x, z in ((-8.6, 1.6), (-7, 1.6), (-14.8, 22), (-15.9, 21.6))
        for y in (-1, 1)
    ]
    s.proxy_hull(points, 0.9)


@builder("keyboard", "free")
def keyboard(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Computer keyboard, long along Y."""
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.7), c)
    for i in range(5):
        for j in range(16):
            x, y = -L * 0.46 + i * L * 0.185, -W * 0.48 + j * W * 0.06
            s.slab((x, x + L * 0.16), (y, y + W * 0.05), (H * 0.65, H), shade(c, 1.5))
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))


@builder("phone", "free")
def phone(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Smartphone or tablet lying flat."""
    s.extrude(
        [(-L / 2, -W / 2), (L / 2, -W / 2), (L / 2, W / 2), (-L / 2, W / 2)],
        (0, H * 0.9),
        c,
        plane="xy",
        soft=W * 0.1,
        rough=0.3,
    )
    s.slab(
        (-L * 0.47, L * 0.47), (-W * 0.45, W * 0.45), (H * 0.85, H), (0.03, 0.04, 0.06), rough=0.05
    )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))


@builder("clock", "free")
def clock(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Standing alarm clock, dial facing +X."""
    foot = H * 0.1
    r = (H - foot) / 2
    s.rod(r, (-L / 2, 0, foot + r), (L / 2 - 0.3, 0, foot + r), c, sections=40)
    s.rod(r * 0.88, (L / 2 - 0.3, 0, foot + r), (L / 2, 0, foot + r), WHITE, sections=40)
    s.slab((L / 2, L / 2 + 0.05), (-r * 0.03, r * 0.03), (foot + r, foot + r * 1.7), DARK)
    s.slab((L / 2, L / 2 + 0.05), (0, r * 0.5), (foot + r * 0.97, foot + r * 1.03), DARK)
    s.slab((-L / 2, L / 2 - 0.3), (-r * 0.7, r * 0.7), (0, foot * 2), shade(c, 0.8), solid=1.5)
    s.proxy_slab((-L / 2, L / 2), (-r * 0.85, r * 0.85), (foot * 2, H), 1.0)


@builder("radio", "free")
def radio(s: Sketch, L: float, W: float, H: float, c: Color, style: str = "speaker") -> None:
    """Loudspeaker or electronic box with its face at +X."""
    s.slab((-L / 2, L / 2 - 0.6), (-W / 2, W / 2), (0, H), c, rough=0.4)
    if style == "speaker":
        for z, f in ((0.34, 0.36), (0.78, 0.18)):
            s.rod(min(W, H) * f, (L / 2 - 1, 0, H * z), (L / 2, 0, H * z), DARK, sections=36)
            s.rod(min(W, H) * f * 0.35, (L / 2 - 1, 0, H * z), (L / 2 + 0.01, 0, H * z), STEEL)
    elif style == "camera":
        s.rod(H * 0.36, (L / 2 - 2, 0, H * 0.47), (L / 2, 0, H * 0.47), STEEL, sections=36)
        s.rod(
            H * 0.26,
            (L / 2 - 2, 0, H * 0.47),
            (L / 2 + 0.01, 0, H * 0.47),
            (0.05, 0.06, 0.1),
            rough=0.05,
        )
    else:
        s.slab((L / 2 - 0.6, L / 2), (-W * 0.4, W * 0.4), (H * 0.15, H * 0.85), shade(c, 0.6))
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L / 2, W / 2))
