"""Small things with many alike parts: whisk, gear wheel, brushes, magnet, hand."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import shade, shift
from esg.assets.geometry.rotations import ALONG
from esg.assets.geometry.sketch import DARK, RED, STEEL, WHITE, Color, Sketch, finish, rgb
from esg.assets.lazy import forms, shapes
from esg.graph.models import ProxyKind, Vec3

SLOPE = 0.08
"""By how much a whisk that lies rises from the end of its handle to its wires."""


def _lying(mesh: Any) -> Any:
    """What is drawn along X at the height of 0, as it lies: on its end and on its wires."""
    c, n = math.cos(SLOPE), math.sin(SLOPE)
    mesh.apply_transform([[c, 0, -n, 0], [0, 1, 0, 0], [n, 0, c, 2.4], [0, 0, 0, 1]])
    return mesh


@builder("whisk")
def whisk(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Balloon whisk lying flat, wires to +X, drawn at 32 x 6.7 x 6.7."""

    def wires() -> Any:
        loops = []
        for k in range(5):
            a = math.pi * k / 5
            half = [(0, 0.7), (4, 1.6), (9, 2.9), (13, 3.2), (15.6, 2.5), (16.9, 1.2), (17.2, 0)]
            path = [*half, *((x, -r) for x, r in half[-2::-1])]
            points = [(-2.2 + x, r * math.cos(a), r * math.sin(a)) for x, r in path]
            loops.append(forms.tube(forms.smooth_path(points, 40), 0.13, 8))
        return _lying(forms.gather(loops))

    s.add(wires, STEEL, name="wires")
    grip = [(0, -15), (0.9, -14.8), (1.25, -13), (1.0, -8), (1.15, -4), (0.95, -2), (0, -2)]
    s.add(lambda: _lying(shapes.lathe(grip, axis="x")), c, name="grip")
    cap = [(0, -2.4), (1.0, -2.4), (1.0, -0.6), (0, -0.6)]
    s.add(lambda: _lying(shapes.lathe(cap, axis="x")), DARK, name="cap")
    corners = ((-15, 0), (-15, 2.4), (-2, 1.2), (-2, 3.4))
    s.proxy_hull([(x, y, z) for x, z in corners for y in (-1.2, 1.2)], 1.6)
    ends = ((-2, 2.2, 0.9), (4, 2.7, 2.2), (8, 3.1, 3.1), (11, 3.2, 3.2), (14.8, 3.5, 1.0))
    s.proxy_hull(
        [
            (x, r * math.cos(a), z + r * math.sin(a))
            for x, z, r in ends
            for a in (math.pi * k / 4 for k in range(8))
        ],
        0.06,
    )


@builder("gear")
def gear(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Gear wheel standing on its teeth, its axle along Y, drawn at 20 x 4 x 20."""
    teeth, root, tip = 12, 7.6, 10.0

    def body() -> Any:
        outline = []
        for k in range(teeth):
            middle = 2 * math.pi * (k + 0.5) / teeth
            for turn, r in ((-0.17, root), (-0.10, tip), (0.10, tip), (0.17, root)):
                a = middle + turn
                outline.append((r * math.sin(a), 10 + r * math.cos(a)))
        bore = [
            (1.7 * math.cos(t), 10 + 1.7 * math.sin(t))
            for t in (2 * math.pi * k / 20 for k in range(20))
        ]
        windows = []
        for k in range(5):
            a = 2 * math.pi * k / 5
            x, z = 4.4 * math.cos(a), 10 + 4.4 * math.sin(a)
            windows.append(
                [
                    (x + 1.35 * math.cos(t), z + 1.35 * math.sin(t))
                    for t in (2 * math.pi * j / 16 for j in range(16))
                ]
            )
        return shapes.extrude(outline, (-1.6, 1.6), "xz", 0.0, [bore, *windows])

    s.add(body, c, name="gear")
    hub = [(1.7, -2), (3.0, -2), (3.0, 2), (1.7, 2), (1.7, -2)]
    s.lathe(hub, shade(c, 0.8), center=(0, 0, 10), axis="y", name="hub")
    s.proxy(ProxyKind.CYLINDER, (10, 10, 1.9), (0, 0, 10), 1.0, ALONG["y"])
    s.wheel((0, 0, 10), 10, parts=2)


@builder("paintbrush")
def paintbrush(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Flat brush lying down with paint on its bristles, which point to +X, 25 x 5 x 1.6."""
    handle = [(-12.5, 0.5), (-12.5, -0.5), (-11.5, -1.2), (-9, -1.2), (-5, -0.8), (-1, -1.2)]
    handle += [(1.2, -2.3), (2.4, -2.4), (2.4, 2.4), (1.2, 2.3)]
    handle += [(-1, 1.2), (-5, 0.8), (-9, 1.2), (-11.5, 1.2)]
    s.extrude(handle, (0.35, 1.25), c, plane="xy", of="wood_lacquered", name="handle")
    s.rod(0.35, (-11.2, 0, 0.3), (-11.2, 0, 1.3), DARK, sections=16, name="hole")
    s.slab((2.2, 5.6), (-2.5, 2.5), (0.05, 1.55), STEEL, name="ferrule")
    for x in (2.8, 5.0):
        s.slab((x - 0.15, x + 0.15), (-2.53, 2.53), (0.02, 1.58), shade(STEEL, 0.7), name="crimp")

    def bristles() -> Any:
        tufts = []
        for k in range(12):
            y = -2.2 + 0.4 * k
            reach = 12.5 - 0.5 * (k % 3) - 0.12 * abs(k - 5.5)
            low = [(5.4, y + d, z) for d in (-0.19, 0.19) for z in (0.15, 1.45)]
            tip = [(reach, 0.94 * y + d, z) for d in (-0.14, 0.14) for z in (0.45, 1.1)]
            tufts.append(shapes.hull([*low, *tip]))
        return forms.gather(tufts)

    s.add(bristles, rgb(226, 205, 160), of="hair", name="bristles")
    paint = [(9.2, y, z) for y in (-2.42, 2.42) for z in (0.2, 1.4)]
    paint += [(11.9, y, z) for y in (-2.2, 2.2) for z in (0.35, 1.2)]
    s.add(lambda: shapes.hull(paint), rgb(40, 96, 190), of="paint", name="paint")
    s.proxy_slab((-12.5, 2.2), (-1.4, 1.4), (0, 1.3), 1.0)
    s.proxy_slab((2.2, 12.4), (-2.5, 2.5), (0, 1.55), 0.8)


@builder("toothbrush")
def toothbrush(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Toothbrush lying on its back, its head to +X, drawn at 19 x 1.4 x 1.9."""
    path = [(-9.2, 0, 0.45), (-5, 0, 0.55), (0, 0, 0.45), (4, 0, 0.5), (6, 0, 0.45), (9.2, 0, 0.4)]
    s.add(
        lambda: forms.tube(forms.smooth_path(path, 30), [0.42] * 20 + [0.3] * 10, 14),
        c,
        name="handle",
    )
    s.add(
        lambda: forms.cushion((5.5, 1.35, 0.8), (-5.5, 0, 0.5), plan=3, sections=24, levels=7),
        WHITE,
        of="rubber",
        name="grip",
    )
    s.add(
        lambda: forms.cushion((3.4, 1.3, 0.6), (7.8, 0, 0.45), plan=3, sections=24, levels=7),
        c,
        name="head",
    )
    for row in range(6):
        tuft = finish("plastic", rgb(236, 240, 244) if row % 2 else rgb(90, 170, 230))
        for y in (-0.36, 0, 0.36):
            x = 6.6 + 0.48 * row
            s.rod(0.19, (x, y, 0.6), (x, y, 1.9), tuft, sections=8, name="tuft")
    s.proxy_slab((-9.5, 6), (-0.6, 0.6), (0, 0.95), 1.0)
    s.proxy_slab((6, 9.5), (-0.65, 0.65), (0, 1.9), 0.8)


def _horseshoe(start: float, end: float) -> Any:
    """Outline of a bent bar between two ways along it; 0 and 1 are its poles [in half turns]."""

    def at(t: float, r: float) -> tuple[float, float]:
        if t < 0:
            return (-t * 3.4, r)
        if t > 1:
            return ((t - 1) * 3.4, -r)
        a = math.pi / 2 + math.pi * t
        return (r * math.cos(a), r * math.sin(a))

    ways = [start + (end - start) * k / 40 for k in range(41)]
    ways = sorted({*ways, *(t for t in (0.0, 1.0) if start < t < end)})
    return [*(at(t, 4.0) for t in ways), *(at(t, 2.1) for t in ways[::-1])]


@builder("magnet")
def magnet(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "horseshoe") -> None:
    """Magnet lying flat: a red horseshoe with bare poles to +X (9.6 x 8 x 2), or a bar."""
    if kind == "bar":
        s.slab((-4, 0), (-1, 1), (0, 1.2), RED, name="north")
        s.slab((0, 4), (-1, 1), (0, 1.2), rgb(40, 78, 170), of="paint", name="south")
        for x in (-3.1, 3.1):
            s.slab((x - 0.45, x + 0.45), (-0.1, 0.1), (1.19, 1.23), WHITE, name="letter")
        s.slab((-3.2, -3.0), (-0.55, 0.55), (1.19, 1.23), WHITE, name="letter_n")
        s.proxy_slab((-4, 4), (-1, 1), (0, 1.2))
        return
    s.extrude(_horseshoe(-1.0, 2.0), (0, 2), c, plane="xy", of="paint", name="bow")
    for start, end, word in ((-1.65, -1.0, "left"), (2.0, 2.65, "right")):
        s.extrude(_horseshoe(start, end), (0, 2), STEEL, plane="xy", name=f"pole_{word}")
    for sign in (-1, 1):
        s.proxy_slab((0, 5.6), (2.1, 4.0) if sign > 0 else (-4.0, -2.1), (0, 2), 1.0)
        s.proxy_hull(
            [
                (r * math.cos(a), sign * r * math.sin(a), z)
                for r in (2.1, 4.0)
                for a in (math.pi / 2, 0.66 * math.pi, 0.83 * math.pi, math.pi)
                for z in (0, 2)
            ],
            1.0,
        )
    shift(s, -0.8)


FINGERS = ((3.3, 0.95), (1.15, 1.0), (-1.05, 0.95), (-3.1, 0.85))
"""Middle across the palm and thickness of index to little finger."""


def _finger(s: Sketch, points: list[Vec3], r: float, c: Color, name: str) -> None:
    radii = [r * (1.0 - 0.09 * k) for k in range(len(points))]
    s.add(lambda: forms.tube(points, radii, 12), c, name=name)


@builder("hand")
def hand(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "pointing") -> None:
    """Forearm in a sleeve with a hand: a pointing finger, or a fist; to +X, palm down."""
    skin = finish("skin", (c[0], c[1], c[2]))
    sleeve = finish("textile", rgb(52, 86, 140))
    z = 4.3
    s.add(
        lambda: forms.tube(
            [(-16, 0, z), (-9, 0, z), (-3, 0, z)], [4.3, 4.1, 3.6], 24, round_ends=False
        ),
        sleeve,
        name="sleeve",
    )
    s.torus(3.5, 0.75, (-3, 0, z), shade(sleeve, 0.8), axis="x", name="cuff")
    s.add(
        lambda: forms.tube([(-4, 0, z), (0, 0, z), (2.5, 0, z)], [2.7, 2.6, 2.9], 20, flat=1.1),
        skin,
        name="wrist",
    )
    s.add(
        lambda: forms.cushion(
            (9.6, 8.6, 3.8 if kind == "pointing" else 5.2),
            (5.4, 0, z + (0.3 if kind == "pointing" else -0.1)),
            plan=3,
            side=0.6,
            sections=28,
            levels=11,
        ),
        skin,
        name="palm",
    )
    for k, (y, r) in enumerate(FINGERS):
        if kind == "pointing" and k == 0:
            straight = [(8.5, y, z + 0.6), (12, y, z + 0.9), (15, y, z + 0.7), (17.6, y, z + 0.4)]
            _finger(s, straight, r, skin, "index")
            s.add(
                lambda y=y: forms.cushion(
                    (1.2, 1.1, 0.4), (17.6, y, z + 1.05), sections=14, levels=5
                ),
                rgb(244, 214, 200),
                of="skin",
                name="nail",
            )
            continue
        if kind == "pointing":
            reach = 12.2 if k < 3 else 11.4
            curled = [
                (8.4, y, z + 1.0),
                (reach - 0.4, y, z + 1.1),
                (reach + 0.3, y, z - 1.5),
                (reach - 3.0, y, z - 2.6),
            ]
        else:
            reach = 11.0 if k < 3 else 10.4
            curled = [
                (8.0, y, z + 1.3),
                (reach, y, z + 1.2),
                (reach + 0.5, y, z - 2.0),
                (reach - 2.6, y, z - 2.7),
                (reach - 3.4, y, z - 1.0),
            ]
        _finger(s, curled, r * (1.05 if kind == "pointing" else 1.22), skin, f"finger_{k}")
    thumb: list[Vec3] = [(2.8, 3.6, z - 0.2), (6.2, 5.2, z - 0.9), (9.6, 4.2, z - 1.8)]
    if kind != "pointing":
        thumb = [
            (2.8, 3.4, z - 0.6),
            (7.6, 4.6, z - 1.6),
            (11.6, 3.4, z - 2.2),
            (12.0, 1.0, z - 2.4),
        ]
    _finger(s, thumb, 1.15, skin, "thumb")
    s.proxy_slab((-16, -2), (-4, 4), (0, z + 4.1), 1.0)
    s.proxy_slab((-2, 11.6), (-4.2, 4.4), (0, z + 2.1), 0.8)
    if kind == "pointing":
        s.proxy(ProxyKind.CAPSULE, (0.95, 0.95, 4.2), (13.4, 3.3, z + 0.7), 1.0, ALONG["x"])
    shift(s, -1.25 if kind == "pointing" else 1.6, -0.4)
