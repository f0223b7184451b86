"""Computers, phones and other boxes with a screen or a dial."""

from __future__ import annotations

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

PAPER = rgb(240, 236, 224)


@builder("laptop")
def laptop(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Open laptop, screen facing +X, drawn at 32 x 33 x 22."""
    s.slab((-8, 16), (-16.5, 16.5), (0, 1.6), c, solid=3, metal=0.5, rough=0.4)
    s.slab((-6, 5), (-15, 15), (1.6, 1.75), DARK)
    for i in range(4):
        for j in range(11):
            x, y = -5.4 + i * 2.6, -14.3 + j * 2.6
            s.slab((x, x + 2.1), (y, y + 2.2), (1.75, 1.9), rgb(60, 60, 64))
    s.slab((7, 14), (-5, 5), (1.6, 1.68), shade(c, 0.85))
    s.extrude(
        [(-8, 1.0), (-7, 1.6), (-14.8, 22), (-15.9, 21.6)], (-16.5, 16.5), c, metal=0.5, rough=0.4
    )
    s.extrude(
        [(-7.2, 2.6), (-7.1, 2.6), (-14.4, 21.2), (-14.5, 21.2)],
        (-15.7, 15.7),
        (0.05, 0.1, 0.2),
        rough=0.05,
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
