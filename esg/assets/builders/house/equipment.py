"""Equipment of houses, kitchens and wards: cylinders, clocks, radiators, machines, stretchers."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import prism, shade
from esg.assets.geometry.sketch import (
    BRASS,
    CHROME,
    DARK,
    RUBBER,
    STEEL,
    WHITE,
    Color,
    Sketch,
)


@builder("pressure_cylinder", "free")
def pressure_cylinder(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "gas") -> None:
    """Gas cylinder or fire extinguisher with its valve; collides as one upright cylinder."""
    r = min(L, W) / 2
    top = H * (0.8 if kind == "gas" else 0.78)
    dome = [
        (r * math.cos(math.radians(a)), top - 0.0 + (H * 0.9 - top) * math.sin(math.radians(a)))
        for a in range(0, 91, 15)
    ]
    s.lathe([(0, 0), (r * 0.94, 0), (r, H * 0.02), *dome], c, rough=0.35)
    s.rod(r * 0.2, (0, 0, H * 0.88), (0, 0, H * 0.95), BRASS, sections=20)
    if kind == "gas":
        wall = [
            (r * 0.66, 0),
            (r * 0.72, 0),
            (r * 0.66, H * 0.14),
            (r * 0.6, H * 0.14),
            (r * 0.66, 0),
        ]
        s.lathe(wall, shade(c, 0.85), center=(0, 0, H * 0.86), rough=0.4)
        s.rod(r * 0.3, (0, 0, H * 0.95), (0, 0, H * 0.975), DARK, sections=20)
        s.lathe(
            [(r * 0.98, 0), (r * 1.0, 0), (r * 1.0, H * 0.02), (r * 0.98, H * 0.02), (r * 0.98, 0)],
            shade(c, 0.6),
            center=(0, 0, H * 0.4),
        )
    else:
        s.rod(r * 0.16, (0, 0, H * 0.95), (0, 0, H), DARK, sections=16)
        s.slab((-r * 0.2, r * 0.95), (-r * 0.14, r * 0.14), (H * 0.965, H), DARK)
        s.slab((-r * 0.2, r * 0.9), (-r * 0.14, r * 0.14), (H * 0.91, H * 0.935), DARK)
        s.rod(
            r * 0.24, (r * 0.1, r * 0.16, H * 0.9), (r * 0.1, r * 0.42, H * 0.9), WHITE, sections=18
        )
        s.pipe(
            r * 0.12,
            [
                (0, 0, H * 0.92),
                (-r * 0.7, 0, H * 0.88),
                (-r * 0.86, 0, H * 0.6),
                (-r * 0.86, 0, H * 0.2),
            ],
            DARK,
        )
        s.slab((r * 0.9, r * 0.995), (-r * 0.4, r * 0.4), (H * 0.3, H * 0.6), WHITE)
    s.proxy_cylinder(r, (0, H))
    s.surface("top", H, (r * 0.7, r * 0.7))


@builder("longcase_clock", "free")
def longcase_clock(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Grandfather clock: plinth, glazed trunk with pendulum, hood with dial; faces +X."""
    x = (-L / 2, L / 2)
    s.slab(x, (-W / 2, W / 2), (0, H * 0.24), c)
    s.slab((-L / 2, L * 0.42), (-W * 0.38, W * 0.38), (H * 0.24, H * 0.68), shade(c, 0.9))
    s.slab((L * 0.42, L * 0.45), (-W * 0.24, W * 0.24), (H * 0.28, H * 0.64), DARK, rough=0.1)
    s.rod(W * 0.015, (L * 0.46, 0, H * 0.38), (L * 0.46, 0, H * 0.63), BRASS, sections=10)
    s.rod(W * 0.1, (L * 0.45, 0, H * 0.36), (L * 0.48, 0, H * 0.36), BRASS)
    s.slab(x, (-W * 0.46, W * 0.46), (H * 0.68, H * 0.94), c)
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H * 0.66, H * 0.69), shade(c, 0.75))
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (H * 0.93, H * 0.955), shade(c, 0.75))
    s.extrude(
        [(-W * 0.44, H * 0.955), (W * 0.44, H * 0.955), (0, H)], (-L * 0.4, L * 0.4), c, plane="yz"
    )
    z = H * 0.81
    radius = min(W * 0.34, H * 0.1)
    s.rod(radius, (L * 0.48, 0, z), (L * 0.505, 0, z), WHITE, sections=40)
    s.torus(radius, radius * 0.07, (L * 0.5, 0, z), BRASS, axis="x")
    s.rod(
        radius * 0.04,
        (L * 0.51, 0, z),
        (L * 0.51, radius * 0.2, z + radius * 0.75),
        DARK,
        sections=8,
    )
    s.rod(
        radius * 0.05,
        (L * 0.51, 0, z),
        (L * 0.51, -radius * 0.45, z + radius * 0.2),
        DARK,
        sections=8,
    )
    s.proxy_slab(x, (-W / 2, W / 2), (0, H * 0.96))
    s.surface("top", H * 0.96, (L * 0.4, W * 0.4))


@builder("jerry_can", "free")
def jerry_can(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Fuel can with three handles, a spout and a pressed cross; thin along X."""
    top = H * 0.84
    s.extrude(
        [
            (-W / 2, 0),
            (W / 2, 0),
            (W / 2, top * 0.94),
            (W * 0.3, top),
            (-W * 0.4, top),
            (-W / 2, top * 0.94),
        ],
        (-L / 2, L / 2),
        c,
        plane="yz",
        soft=min(L, W) * 0.08,
        rough=0.5,
    )
    for side in (-1, 1):
        for k in (-1, 1):
            prism(
                s,
                [
                    (side * x, y * W + d * W * 0.03, z * H)
                    for x in (L * 0.48, L * 0.515)
                    for y, z in ((-0.36 * k, 0.08), (0.36 * k, 0.74))
                    for d in (-1, 1)
                ],
                shade(c, 0.75),
            )
        s.rod(
            H * 0.014,
            (side * L * 0.28, -W * 0.3, H * 0.94),
            (side * L * 0.28, W * 0.12, H * 0.94),
            c,
            sections=12,
        )
        for y in (-0.3, 0.12):
            s.rod(
                H * 0.014,
                (side * L * 0.28, W * y, top * 0.98),
                (side * L * 0.28, W * y, H * 0.95),
                c,
                sections=12,
            )
    s.rod(H * 0.014, (0, -W * 0.3, H * 0.94), (0, W * 0.12, H * 0.94), c, sections=12)
    s.rod(
        min(L * 0.3, W * 0.12),
        (0, W * 0.34, top * 0.95),
        (0, W * 0.42, H * 0.985),
        DARK,
        sections=20,
    )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, top))
    s.surface("top", top, (L * 0.4, W * 0.4))


@builder("coffee_machine", "free")
def coffee_machine(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Espresso machine with a portafilter, a cup and a drip tray; faces +X."""
    s.slab((-L / 2, 0), (-W / 2, W / 2), (0, H), c, rough=0.3)
    s.slab((0, L / 2), (-W / 2, W / 2), (H * 0.66, H), shade(c, 0.92), rough=0.3)
    s.slab((0, L / 2), (-W / 2, W / 2), (0, H * 0.1), DARK, rough=0.5)
    s.slab((0, L * 0.001 + L * 0.01), (-W * 0.46, W * 0.46), (H * 0.1, H * 0.66), DARK)
    s.slab((L * 0.485, L * 0.505), (-W * 0.3, W * 0.3), (H * 0.76, H * 0.92), DARK, rough=0.1)
    s.rod(W * 0.1, (L * 0.2, 0, H * 0.54), (L * 0.2, 0, H * 0.66), CHROME, sections=24)
    s.rod(W * 0.03, (L * 0.2, 0, H * 0.57), (L * 0.48, 0, H * 0.55), DARK, sections=14)
    s.lathe(
        [(0, 0), (W * 0.06, 0), (W * 0.09, H * 0.16), (W * 0.075, H * 0.16), (0, H * 0.03)],
        WHITE,
        center=(L * 0.22, 0, H * 0.1),
    )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L * 0.45, W * 0.45))


@builder("coffin", "free")
def coffin(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Coffin lying along X, widest at the shoulders, with handles and a lid."""
    plan = [(-0.5, 0.3), (0.2, 0.5), (0.5, 0.32)]
    outline = [(L * x, W * y) for x, y in plan] + [(L * x, -W * y) for x, y in reversed(plan)]
    s.extrude(outline, (0, H * 0.72), c, plane="xy", rough=0.4)
    s.extrude(
        [(x * 0.985, y * 0.96) for x, y in outline],
        (H * 0.72, H * 0.86),
        shade(c, 1.15),
        plane="xy",
        rough=0.4,
    )
    s.extrude(
        [(x * 0.94, y * 0.7) for x, y in outline],
        (H * 0.86, H),
        shade(c, 1.05),
        plane="xy",
        rough=0.4,
    )
    for side in (-1, 1):
        for x, y in ((-0.28, 0.37), (0.06, 0.47)):
            s.rod(
                H * 0.03,
                (L * (x - 0.07), side * W * (y + 0.01), H * 0.45),
                (L * (x + 0.07), side * W * (y + 0.03), H * 0.45),
                BRASS,
                sections=10,
            )
    s.slab((L * 0.0, L * 0.24), (-W * 0.025, W * 0.025), (H, H * 1.005), BRASS)
    s.slab((L * 0.14, L * 0.17), (-W * 0.1, W * 0.1), (H, H * 1.005), BRASS)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H * 0.86), 1.0)
    s.proxy_slab((-L * 0.46, L * 0.46), (-W * 0.33, W * 0.33), (H * 0.86, H), 0.6)
    s.surface("top", H, (L * 0.4, W * 0.25))


@builder("radiator", "free")
def radiator(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Column radiator on two feet, broad along Y."""
    count = max(4, min(24, round(W / max(L * 0.7, 1e-6))))
    pitch = W / count
    for k in range(count):
        y = -W / 2 + pitch * (k + 0.5)
        s.slab(
            (-L * 0.5, L * 0.5), (y - pitch * 0.38, y + pitch * 0.38), (H * 0.1, H), c, rough=0.4
        )
    for z in (0.16, 0.92):
        s.rod(L * 0.22, (0, -W / 2, H * z), (0, W / 2, H * z), shade(c, 0.92), sections=16)
    for y in (-0.36, 0.36):
        s.slab(
            (-L / 2, L / 2),
            (W * y - pitch * 0.2, W * y + pitch * 0.2),
            (0, H * 0.12),
            shade(c, 0.7),
        )
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (0, H))
    s.surface("top", H, (L * 0.45, W * 0.45))


@builder("trolley_bed", "free")
def trolley_bed(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Patient's trolley along Y: mattress, frame, side rails, four castors."""
    deck = H * 0.78
    s.slab((-L / 2, L / 2), (-W / 2, W / 2), (deck, H * 0.84), STEEL)
    s.slab((-L * 0.46, L * 0.46), (-W * 0.49, W * 0.49), (H * 0.84, H * 0.96), c, rough=0.9)
    s.slab((-L * 0.36, L * 0.36), (W * 0.3, W * 0.46), (H * 0.96, H), WHITE, rough=0.95)
    for side in (-1, 1):
        for y in (-0.38, 0.38):
            s.rod(
                L * 0.03,
                (side * L * 0.4, W * y, H * 0.1),
                (side * L * 0.36, W * y, deck),
                STEEL,
            )
            s.rod(
                H * 0.06,
                (side * L * 0.4 - L * 0.03, W * y, H * 0.06),
                (side * L * 0.4 + L * 0.03, W * y, H * 0.06),
                RUBBER,
            )
        s.rod(
            L * 0.02,
            (side * L * 0.38, -W * 0.38, H * 0.25),
            (side * L * 0.38, W * 0.38, H * 0.25),
            STEEL,
        )
        s.rod(
            L * 0.015,
            (side * L * 0.47, -W * 0.2, H * 0.985),
            (side * L * 0.47, W * 0.24, H * 0.985),
            CHROME,
        )
        for y in (-0.18, 0.22):
            s.rod(
                L * 0.015,
                (side * L * 0.47, W * y, H * 0.84),
                (side * L * 0.47, W * y, H * 0.985),
                CHROME,
            )
    for y in (-0.38, 0.38):
        s.proxy_slab((-L * 0.44, L * 0.44), (W * (y - 0.06), W * (y + 0.06)), (0, deck), 0.5)
    s.proxy_slab((-L / 2, L / 2), (-W / 2, W / 2), (deck, H * 0.96), 1.0)
    s.surface("top", H * 0.96, (L * 0.42, W * 0.45))
