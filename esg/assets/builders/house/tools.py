"""Tools, long and short, lying along X."""

from __future__ import annotations

from esg.assets.builders import builder
from esg.assets.builders.common import prism, shift
from esg.assets.geometry.sketch import DARK, STEEL, WOOD, YELLOW, Color, Sketch


@builder("long_tool")
def long_tool(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "shovel") -> None:
    """A tool with a long handle lying along X, head to +X."""
    half = 60.0
    z = {"broom": 4.0, "rake": 4.0}.get(kind, 2.0)
    s.rod(1.5, (-half, 0, z), (half - 22, 0, z), WOOD if kind != "crutch" else c, sections=16)
    if kind == "shovel":
        s.rod(2.0, (half - 30, 0, z), (half - 18, 0, z), STEEL, sections=16)
        s.extrude(
            [(half - 20, -11), (half - 20, 11), (half + 2, 10), (half + 9, 0), (half + 2, -10)],
            (z - 1, z),
            c,
            plane="xy",
            soft=1,
        )
        s.pipe(1.4, [(-half, -5, z), (-half - 2, -5, z), (-half - 2, 5, z), (-half, 5, z)], DARK)
        s.rod(1.4, (-half, -5, z), (-half, 5, z), DARK)
        s.proxy_slab((-half - 3, half - 20), (-1.6, 1.6), (0, 3.6), 1.0)
        s.proxy_slab((half - 20, half + 8), (-10, 10), (0, 3.2), 0.5)
        shift(s, -3.4)
    elif kind == "rake":
        s.slab((half - 24, half - 21), (-18, 18), (z - 1, z + 1), c)
        for k in range(9):
            y = -17 + 34 * k / 8
            s.rod(0.5, (half - 22.5, y, z), (half - 20, y, 0.3), c, sections=8)
        s.proxy_slab((-half, half - 24), (-1.5, 1.5), (z - 1.5, z + 1.5), 1.0)
        s.proxy_slab((half - 25, half - 19), (-18, 18), (0, z + 1), 1.0)
        s.proxy_slab((-half, -half + 3), (-1.5, 1.5), (0, z - 1.5), 0.3)
        shift(s, 9)
    elif kind == "broom":
        s.box((9, 30, 4), (half - 20, 0, z), c)
        prism(
            s,
            [(half - 16, y, z + d) for y in (-14, 14) for d in (-1.6, 1.6)]
            + [(half - 2, y, zz) for y in (-18, 18) for zz in (0, 8)],
            YELLOW,
            rough=1.0,
        )
        s.proxy_slab((-half, half - 24), (-1.5, 1.5), (z - 1.5, z + 1.5), 1.0)
        s.proxy_slab((half - 24, half - 2), (-16, 16), (0, 8), 0.3)
        s.proxy_slab((-half, -half + 3), (-1.5, 1.5), (0, z - 1.5), 0.3)
        shift(s, 1)
    else:
        s.pipe(
            1.5, [(half - 22, 0, z), (half - 12, 0, z), (half - 10, 9, z), (half - 14, 13, z)], c
        )
        s.proxy_slab((-half, half - 10), (-1.5, 1.5), (0, 3.5), 1.0)
        s.proxy_slab((half - 15, half - 8.5), (0, 14), (0, 3.5), 0.4)
        shift(s, 5.8, -6.4, -0.5)
        _raise_proxies(s, 0.5)


@builder("fork")
def fork(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Table fork, tines to +X."""
    for x, half, low in (((-10, 4), 0.6, 0.2), ((-10, -2), 0.9, 0.1), ((3.6, 6), 1.2, 0.2)):
        s.slab(x, (-half, half), (low, 0.6), c)
    for y in (-1.0, -0.33, 0.33, 1.0):
        root = [(5.8, y + d, z) for z in (0.2, 0.6) for d in (-0.2, 0.2)]
        tip = [(10, y + d, z) for z in (1.0, 1.2) for d in (-0.1, 0.1)]
        prism(s, root + tip, c)
    s.proxy_slab((-10, 10), (-1, 1), (0, 0.9))
    shift(s, 0, 0, -0.1)
    _raise_proxies(s, 0.1)


def _raise_proxies(s: Sketch, dz: float) -> None:
    """Lets the collider stand where it stood before the drawing was moved down."""
    s.proxies[:] = [
        p.model_copy(update={"position_cm": (*p.position_cm[:2], p.position_cm[2] + dz)})
        for p in s.proxies
    ]
