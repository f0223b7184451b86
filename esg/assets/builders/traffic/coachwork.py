"""Bodies of cars: one lofted hull, a lofted cabin, and what follows their curves.

Windows, lamps, grilles and seams are cut from the same surfaces a little thicker
(`esg.assets.geometry.forms.inlay`), so that a car of any profile wears them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
import math
from typing import Any

from esg.assets.builders.common import shade
from esg.assets.builders.traffic.tyres import car_wheel
from esg.assets.geometry.sketch import CHROME, DARK, GLASS, WHITE, Color, Sketch, rgb
from esg.assets.lazy import forms, shapes

Curve = tuple[tuple[float, float], ...]
LAMP, TAIL = (0.66, 0.69, 0.72), (0.42, 0.01, 0.02)
TRIM = rgb(30, 31, 34)


@dataclass(frozen=True)
class Coach:
    """Shape of a passenger car, front = +X [cm].

    Args:
        width: Of the body, without mirrors.
        bottom, top: Heights of underside and of bonnet and boot along x.
        cabin: Height of its roof line along x; it starts and ends inside the body.
        sides: Half width of the cabin at the belt along x.
        belt: Height at which the glass starts, along x.
        axles: x of front and rear.
        radius: Of the wheels.
        screens: x from roof to foot of windscreen and of rear window.
        pillars: x and half width of what divides the side windows.
        doors: x of their seams, front to rear.
        lamps: Heights of head and tail lamps, (low, high) each, and how far in they reach (share).
        plan, edge, roof: Powers of the superellipses of the hull from above and in section, and of
            the cabin in section.
        gap: Between a wheel and its arch.
        lean: Share by which the cabin is narrower at the roof.
        cladding: Whether arches and sills are black plastic.
    """

    width: float
    bottom: Curve
    top: Curve
    cabin: Curve
    sides: Curve
    belt: Curve
    axles: tuple[float, float]
    radius: float
    screens: tuple[tuple[float, float], tuple[float, float]]
    pillars: Curve
    doors: tuple[float, ...]
    lamps: tuple[tuple[float, float], tuple[float, float]]
    grille: tuple[float, float, float]
    plan: float = 6.5
    edge: float = 4.0
    roof: float = 4.2
    gap: float = 4.5
    lean: float = 0.2
    cladding: bool = False


def _ends(b: Coach) -> tuple[float, float]:
    xs = [x for x, _ in b.bottom]
    return min(xs), max(xs)


def hull(
    width: float, bottom: Curve, top: Curve, plan: float, edge: float, waist: float = 1.0
) -> Any:
    """A body of full `width` between two curves along x, without wheel wells.

    Args:
        width: [cm].
        bottom, top: Heights along x [cm].
        plan, edge: Powers of its superellipses from above and in section.
        waist: How much of a shoulder line it has; 0 is smooth.
    """
    import numpy as np

    rear, front = bottom[-1][0], bottom[0][0]
    mid, half = (rear + front) / 2, (front - rear) / 2
    u = np.sin(np.radians(np.linspace(-86, 86, 30)))
    x = mid + half * u
    across = 0.5 * width * (1 - np.abs(u) ** plan) ** (1 / plan)
    low, high = forms.profile(bottom)(x), forms.profile(top)(x)
    ring = forms.superellipse(36, edge)
    middle = low + 0.52 * (high - low)
    rise = np.where(ring[:, 1] > 0, (high - middle)[:, None], (middle - low)[:, None])
    z = middle[:, None] + rise * ring[:, 1]
    # A shoulder that catches light, and doors that fall in below it.
    share = (z - low[:, None]) / (high - low)[:, None]
    swell = 0.022 * np.exp(-(((share - 0.70) / 0.07) ** 2))
    swell -= 0.02 * np.exp(-(((share - 0.36) / 0.13) ** 2))
    y = across[:, None] * ring[:, 0] * (1 + waist * swell) / (1 + 0.012 * waist)
    return forms.loft(np.stack([np.broadcast_to(x[:, None], y.shape), y, z], -1))


def _cabin_rings(b: Coach) -> Any:
    import numpy as np

    xs = [x for x, _ in b.cabin]
    # Ever denser where the line is steep: at the windscreen and at the rear.
    x = np.linspace(min(xs), max(xs), 28)
    roof = forms.smooth_path(sorted(b.cabin), 400)
    top = np.interp(x, roof[:, 0], roof[:, 1])
    low = forms.profile(b.belt)(x) - 9
    wide = forms.profile(b.sides)(x)
    ring = forms.superellipse(21, b.roof, 0.0, math.pi)
    high = np.maximum(top - low, 0.6)
    z = low[:, None] + high[:, None] * ring[:, 1]
    full = float(np.max(high))
    y = wide[:, None] * ring[:, 0] * (1 - b.lean * (z - low[:, None]) / full)
    return np.stack([np.broadcast_to(x[:, None], y.shape), y, z], -1)


def cabin(b: Coach) -> Any:
    """Roof, pillars and, under the glass, what the windows are set in."""
    return forms.loft(_cabin_rings(b))


def _side_windows(b: Coach) -> Any:
    import numpy as np
    from shapely.geometry import LineString, Polygon

    roof = forms.smooth_path(sorted(b.cabin), 120)
    belt = forms.profile(b.belt)
    base = belt(roof[:, 0])
    rail = base - 9 + 0.86 * (roof[:, 1] - base + 9)
    keep = rail > base
    line = np.c_[roof[keep, 0], rail[keep]]
    foot = np.c_[roof[keep, 0], base[keep]]
    area = Polygon(np.concatenate([line, foot[::-1]])).buffer(-5.6).buffer(3, quad_segs=3)
    for x, half in b.pillars:
        bar = LineString([(x + 4, 60), (x - 4, 260)]).buffer(half)
        area = area.difference(bar)
    return area.buffer(-1.6, join_style="mitre").buffer(1.6, quad_segs=2).simplify(0.25)


def _screens(b: Coach) -> list[Any]:
    import numpy as np
    from shapely.geometry import Polygon

    out = []
    wide = forms.profile(b.sides)
    for roof, foot in b.screens:
        x = np.linspace(roof, foot, 9)
        t = np.linspace(0, 1, 9)
        half = wide(x) * (0.80 + 0.06 * t) - (1 - t) * b.lean * 0.8 * wide(x)
        shape = Polygon(np.concatenate([np.c_[x, half], np.c_[x, -half][::-1]]))
        out.append(shape.buffer(-4).buffer(4, quad_segs=3).simplify(0.2))
    return out


def _seams(b: Coach) -> Any:
    """Gaps between the doors and around them, seen from the side."""
    from shapely.geometry import LineString
    from shapely.ops import unary_union

    low, belt = forms.profile(b.bottom), forms.profile(b.belt)
    lines = []
    for k, x in enumerate(b.doors):
        lean = 4.0 if k == 0 else -3.0 if k == len(b.doors) - 1 else 0.0
        lines.append(
            LineString([(x, belt(x) + 1), (x + lean, belt(x) * 0.62), (x, low(x) + 13)]).buffer(
                0.45, cap_style="flat"
            )
        )
    first, last = b.doors[0], b.doors[-1]
    lines.append(
        LineString([(first, low(first) + 13), (last, low(last) + 13)]).buffer(
            0.45, cap_style="flat"
        )
    )
    return unary_union(lines)


def _wells(b: Coach, deep: float = 30.0) -> list[Any]:
    out = []
    for x in b.axles:
        for side in (-1, 1):
            inner, outer = side * (b.width / 2 - deep), side * (b.width / 2 + 8)
            out.append(
                shapes.rod(b.radius + b.gap, (x, inner, b.radius + 1), (x, outer, b.radius + 1), 26)
            )
    return out


@lru_cache(maxsize=32)
def _meshes(b: Coach) -> dict[str, Any]:
    """The meshes of a car by name; painted, and drawn at several places, by others."""
    from shapely.geometry import Polygon, box
    from shapely.ops import unary_union

    rear, front = _ends(b)
    body = hull(b.width, b.bottom, b.top, b.plan, b.edge)
    house = cabin(b)
    wells = _wells(b)
    out = {"body": forms.carved(body, wells), "cabin": house}
    glass = forms.fattened(house, 0.35)
    sides, screens = _side_windows(b), _screens(b)
    out["side_windows"] = forms.inlay(glass, forms.prism(sides, (-b.width, b.width)))
    for name, shape in zip(("windscreen", "rear_window"), screens, strict=True):
        out[name] = forms.inlay(glass, forms.prism(shape, (0, 400), "xy"))
    frames = forms.prism(sides.buffer(1.7, quad_segs=1).simplify(0.5), (-b.width, b.width))
    for shape in screens:
        frames += forms.prism(shape.buffer(2.2, quad_segs=1).simplify(0.5), (0, 400), "xy")
    out["window_frames"] = forms.inlay(forms.fattened(house, 0.15), frames)
    proud = forms.fattened(body, 0.25)
    seam = forms.inlay(proud, forms.prism(_seams(b), (-b.width, b.width)))
    out["seams"] = seam
    (h0, h1), (t0, t1) = b.lamps
    w = b.width / 2
    lamps = []
    for sign in (-1, 1):
        shape = Polygon(
            [
                (sign * w * 0.52, h0 + 2),
                (sign * w * 1.1, h0 + 4),
                (sign * w * 1.1, h1 + 4),
                (sign * w * 0.6, h1),
            ]
        )
        lamps += forms.prism(
            shape.buffer(-1.5).buffer(1.5, quad_segs=3), (front - 34, front + 9), "yz"
        )
    out["headlights"] = forms.inlay(forms.fattened(body, 0.5), lamps)
    tails = []
    for sign in (-1, 1):
        shape = Polygon(
            [
                (sign * w * 0.45, t0 + 2),
                (sign * w * 1.1, t0),
                (sign * w * 1.1, t1),
                (sign * w * 0.5, t1),
            ]
        )
        tails += forms.prism(
            shape.buffer(-1.5).buffer(1.5, quad_segs=3), (rear - 9, rear + 26), "yz"
        )
    out["taillights"] = forms.inlay(forms.fattened(body, 0.5), tails)
    g0, g1, gw = b.grille
    mouth = unary_union(
        [
            box(-w * gw, g0, w * gw, g1).buffer(-3).buffer(3, quad_segs=3),
            box(-w * 0.72, g0 - 16, w * 0.72, g0 - 5).buffer(-2).buffer(2, quad_segs=3),
        ]
    )
    out["grille"] = forms.inlay(
        forms.fattened(body, 0.3), forms.prism(mouth, (front - 22, front + 9), "yz")
    )
    low = forms.profile(b.bottom)
    sill = box(rear + 6, 0, front - 6, low((rear + front) / 2) + 8.5)
    trim = [*forms.prism(sill, (-b.width, b.width))]
    plastic = forms.fattened(body, 0.4)
    if b.cladding:
        for x in b.axles:
            for y0, y1 in ((-b.width, -w * 0.6), (w * 0.6, b.width)):
                trim.append(
                    shapes.rod(b.radius + 10, (x, y0, b.radius + 1), (x, y1, b.radius + 1), 26)
                )
        plastic = forms.fattened(body, 1.0)
    out["trim"] = forms.carved(forms.inlay(plastic, trim), wells)
    return out


def handles(b: Coach) -> list[tuple[float, float]]:
    """x and z of the door handles: at the rear end of each door."""
    belt = forms.profile(b.belt)
    return [(x + 15, float(belt(x)) - 10) for x in b.doors[1:]]


def draw_coach(s: Sketch, b: Coach, c: Color) -> None:
    """Draws a passenger car without what its builder adds."""
    w = b.width / 2

    def mesh(name: str) -> Any:
        return lambda: forms.copied(_meshes(b)[name])

    s.add(mesh("body"), c, of="car_body", name="body")
    s.add(mesh("cabin"), c, of="car_body", name="cabin")
    s.add(mesh("window_frames"), TRIM, of="rubber", name="window_frames")
    for name in ("side_windows", "windscreen", "rear_window"):
        s.add(mesh(name), GLASS, alpha=1.0, of="glass_dark", name=name)
    s.add(mesh("seams"), shade(c, 0.18), of="plastic", name="seams")
    s.add(mesh("trim"), TRIM, of="plastic", name="trim")
    s.add(mesh("grille"), TRIM, of="plastic", name="grille")
    s.add(mesh("headlights"), LAMP, of="lamp", name="headlights")
    s.add(mesh("taillights"), TAIL, of="lamp", name="taillights")
    _fittings(s, b, c)
    for row, x in zip(("front", "rear"), b.axles, strict=True):
        for side, word in ((-1, "right"), (1, "left")):
            _liner(s, b, x, side, f"{row}_{word}")
            car_wheel(s, x, side * (w - 0.8), b.radius, 21, side, f"{row}_{word}")


def _liner(s: Sketch, b: Coach, x: float, side: int, name: str) -> None:
    """The dark inside of a wheel well."""
    r, w = b.radius + b.gap - 0.2, b.width / 2
    turn = [math.pi * k / 10 for k in range(11)]
    arch = [
        (x + q * math.cos(t), b.radius + 1 + q * math.sin(t))
        for q, t in [(r, t) for t in turn] + [(r - 1.5, t) for t in reversed(turn)]
    ]
    span = sorted((side * (w - 30), side * (w - 4)))
    plate = sorted((side * (w - 30.5), side * (w - 29)))

    def make() -> Any:
        return forms.gather(
            [
                shapes.extrude(arch, (span[0], span[1])),
                shapes.extrude(
                    [(x + r * math.cos(t), b.radius + 1 + r * math.sin(t)) for t in turn],
                    (plate[0], plate[1]),
                ),
            ]
        )

    s.add(make, TRIM, of="plastic", name=f"wheel_well_{name}")


def _fittings(s: Sketch, b: Coach, c: Color) -> None:
    """Mirrors, handles, plates and the exhaust."""
    rear, front = _ends(b)
    w = b.width / 2
    foot = b.screens[0][1]
    at = foot - 34
    near = w + 4.5 - 8.5

    def height() -> float:
        return float(forms.profile(b.belt)(at)) + 7

    for side, word in ((1, "left"), (-1, "right")):

        def shell(side: int = side) -> Any:
            z = height()
            return forms.gather(
                [
                    forms.cushion(
                        (10, 17, 11),
                        (at, side * near, z + 1),
                        plan=3.0,
                        side=0.6,
                        sections=12,
                        levels=6,
                    ),
                    forms.tube(
                        [(at + 3, side * (near - 16), z - 5), (at + 1, side * (near - 4), z)],
                        [3.4, 2.4],
                        10,
                    ),
                ]
            )

        s.add(shell, c, of="car_body", name=f"mirror_{word}")

        def face(side: int = side) -> Any:
            place = (at - 4.6, side * near, height() + 1)
            return forms.cushion((1.5, 14, 8.6), place, plan=3.5, sections=12, levels=5)

        s.add(face, CHROME, of="chrome", name=f"mirror_glass_{word}")

    def grips() -> Any:
        return forms.gather(
            [
                forms.cushion(
                    (17, 3.4, 3.0),
                    (x, side * (w - 1.2 + 0.4), hz),
                    plan=3.0,
                    side=0.6,
                    sections=8,
                    levels=5,
                )
                for x, hz in handles(b)
                for side in (-1, 1)
            ]
        )

    s.add(grips, shade(c, 0.9), of="chrome", name="door_handles")
    h = b.lamps[1][0] - 13

    def plates() -> Any:
        return forms.gather(
            [
                shapes.box((1.6, 46, 10.5), (rear + 0.8, 0, h)),
                shapes.box((1.6, 46, 10.5), (front - 0.8, 0, b.grille[0] - 1)),
            ]
        )

    s.add(plates, WHITE, of="plastic", name="number_plates")

    def pipe() -> Any:
        z0 = float(forms.profile(b.bottom)(rear + 20)) + 1
        return forms.tube(
            [(rear + 34, -w * 0.55, z0), (rear + 2, -w * 0.55, z0)], 3, 14, round_ends=False
        )

    s.add(pipe, DARK, of="steel", name="exhaust")
