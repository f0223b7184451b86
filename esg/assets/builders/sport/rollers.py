"""Round flat things that roll on their rim; drawn lying, with their axis upright."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.sketch import CHROME, DARK, PALE_WOOD, STEEL, Color, Sketch


def _ring(s: Sketch, outer: float, inner: float, height: float, n: int = 12) -> None:
    """Wedge boxes around a hole, so that a peg or a hand goes through a lying ring."""
    from esg.assets.geometry.rotations import turn

    thick = outer * math.cos(math.pi / n) - inner
    middle = inner + thick / 2
    for k in range(n):
        angle = 2 * math.pi * k / n
        s.proxy_box(
            (thick / 2, outer * math.sin(math.pi / n), height / 2),
            (middle * math.cos(angle), middle * math.sin(angle), height / 2),
            1.0,
            turn("z", math.degrees(angle)),
        )


def _tread(outer: float, inner: float, height: float) -> list[tuple[float, float]]:
    """Closed section of a tyre: straight tread, round shoulders, beads."""
    shoulder = 0.22 * height
    arc = [
        (
            outer - shoulder + shoulder * math.sin(a),
            height - shoulder + shoulder * math.cos(a),
        )
        for a in (math.radians(15 * k) for k in range(7))
    ]
    top = [(inner, height * 0.86), (inner + 0.3 * (outer - inner), height), *arc]
    bottom = [(r, height - z) for r, z in top]
    return [*bottom, *reversed(top), bottom[0]]


@builder("tyre", drawn=(64, 64, 20))
def tyre(s: Sketch, L: float, W: float, H: float, c: Color, hub: bool = False) -> None:
    """Car tyre with grooves, bare or on its rim, drawn at 64 x 64 x 20."""
    s.lathe(_tread(32, 20.5, 20), c, rough=0.95, sections=64)
    for z in (6.5, 13.0):
        s.lathe(
            [(31.6, z), (32.02, z), (32.02, z + 0.8), (31.6, z + 0.8), (31.6, z)],
            shade(c, 0.5),
            sections=64,
        )
    if not hub:
        _ring(s, 32, 20.5, 20)
        return
    s.lathe([(18.5, 3), (20.8, 3), (20.8, 17), (18.5, 17), (18.5, 3)], CHROME)
    for z in (2.0, 16.0):
        s.lathe([(18, z), (21.5, z), (21.5, z + 2), (18, z + 2), (18, z)], CHROME)
    s.rod(5, (0, 0, 6), (0, 0, 17), STEEL)
    for k in range(5):
        a = 2 * math.pi * k / 5
        x, y = math.cos(a), math.sin(a)
        s.rod(2.4, (4 * x, 4 * y, 14.5), (19 * x, 19 * y, 14.5), CHROME, sections=14)
    s.proxy_cylinder(32, (0, 20))


@builder("hula_hoop", drawn=(90, 90, 2.6))
def hula_hoop(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Thin hoop with stripes, drawn at 90 x 90 x 2.6."""
    s.torus(43.75, 1.22, (0, 0, 1.3), c, rough=0.35)
    for k in range(8):
        a = 2 * math.pi * k / 8
        p = (43.7 * math.cos(a), 43.7 * math.sin(a), 1.3)
        d = (-2.2 * math.sin(a), 2.2 * math.cos(a))
        s.rod(
            1.3, (p[0] - d[0], p[1] - d[1], 1.3), (p[0] + d[0], p[1] + d[1], 1.3),
            (0.97, 0.95, 0.9), sections=16,
        )  # fmt: skip
    _ring(s, 45, 42.4, 2.6, 16)


@builder("coin", drawn=(2.4, 2.4, 0.2))
def coin(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Coin with a raised rim and a head in relief, drawn at 2.4 x 2.4 x 0.2."""
    s.rod(1.14, (0, 0, 0.02), (0, 0, 0.18), c, rough=0.3, sections=64)
    s.lathe([(1.08, 0), (1.2, 0), (1.2, 0.2), (1.08, 0.2), (1.08, 0)], shade(c, 0.9))
    for z in (0.01, 0.17):
        s.rod(0.42, (0.12, 0, z), (0.12, 0, z + 0.02), shade(c, 1.15), sections=32)
        s.box((0.5, 0.3, 0.02), (-0.4, 0, z + 0.01), shade(c, 1.15))
    s.proxy_cylinder(1.2, (0, 0.2))


@builder("spool", drawn=(60, 60, 44))
def spool(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Cable reel: two wooden flanges, a core, cable wound on it, drawn at 60 x 60 x 44."""
    for z in (0.0, 40.0):
        s.lathe([(3, z), (30, z), (30, z + 4), (3, z + 4), (3, z)], PALE_WOOD, rough=0.9)
        for k in range(6):
            a = math.pi * k / 3
            x, y = 17 * math.cos(a), 17 * math.sin(a)
            s.rod(1.0, (x, y, z - 0.05), (x, y, z + 4.05), DARK, sections=10)
    s.rod(12, (0, 0, 4), (0, 0, 40), PALE_WOOD, rough=0.9)
    for k in range(9):
        s.torus(20.5, 2.2, (0, 0, 6.2 + 3.95 * k), c, rough=0.7)
    s.rod(20.5, (0, 0, 4), (0, 0, 40), shade(c, 0.8), rough=0.8)
    s.proxy_cylinder(30, (0, 4))
    s.proxy_cylinder(22.5, (4, 40))
    s.proxy_cylinder(30, (40, 44))
    s.surface("top", 44, (20, 20))


@builder("tape_roll", drawn=(10, 10, 5))
def tape_roll(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Roll of tape on a cardboard core, drawn at 10 x 10 x 5."""
    s.lathe([(3.9, 0), (5, 0), (5, 5), (3.9, 5), (3.9, 0)], c, rough=0.35, sections=64)
    s.lathe([(3.6, 0.1), (3.9, 0.1), (3.9, 4.9), (3.6, 4.9), (3.6, 0.1)], (0.73, 0.57, 0.38))
    s.box((0.12, 1.6, 5), (5.02, 0.5, 2.5), shade(c, 0.85), rough=0.35)
    _ring(s, 5, 3.6, 5)


@builder("cheese_wheel", drawn=(30, 30, 11))
def cheese_wheel(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """A whole cheese with rounded rim and a label, drawn at 30 x 30 x 11."""
    edge = [(14 + math.sin(a), 1 - math.cos(a)) for a in (math.radians(15 * k) for k in range(7))]
    profile = [(0, 0), *edge, *[(r, 11 - z) for r, z in reversed(edge)], (0, 11)]
    s.lathe(profile, c, rough=0.6, sections=64)
    s.rod(6, (0, 0, 10.9), (0, 0, 11.02), (0.72, 0.12, 0.1), sections=48)
    s.rod(4.4, (0, 0, 11.0), (0, 0, 11.06), (0.96, 0.92, 0.8), sections=48)
    s.proxy_cylinder(15, (0, 11))
    s.surface("top", 11, (10, 10))
