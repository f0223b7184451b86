"""Wheels with tyres that have a tread, and rims that show that they turn."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.geometry.sketch import RUBBER, Sketch
from esg.assets.lazy import forms

ALLOY = (0.66, 0.67, 0.69)


def tyre(at: tuple[float, float, float], r: float, width: float, rim: float) -> Any:
    """A tyre about Y with a grooved tread: outer radius r, bead at `rim` [cm]."""
    h = width / 2
    deep = 0.025 * r
    crown = [(-0.72, 1.0), (-0.32, 1.0), (-0.30, -1), (-0.20, 1.0)]
    crown += [(-y, q) for y, q in reversed(crown)]
    outer = [(r - deep if q < 0 else r * q, h * y) for y, q in crown]
    wall = [(rim, -0.80 * h), (rim + 0.35 * (r - rim), -h), (r * 0.955, -0.9 * h)]
    loop = [*wall, *outer, *((q, -y) for q, y in reversed(wall)), (rim, -0.80 * h)]
    return forms.turned(loop, at, 22, "y")


def rim(at: tuple[float, float, float], r: float, width: float, side: int, spokes: int = 5) -> Any:
    """An alloy rim about Y: barrel, spokes in pairs and a hub; the face is at `side`."""
    x, y, z = at
    face = side * width * 0.40
    ring = [
        (r * 1.01, -0.46),
        (r * 1.01, 0.46),
        (r * 0.9, 0.44),
        (r * 0.88, -0.46),
        (r * 1.01, -0.46),
    ]
    parts = [forms.turned([(q, v * width) for q, v in ring], at, 24, "y")]
    parts.append(
        forms.turned(
            [(r * 0.24, -1.6), (r * 0.24, 0.6), (r * 0.17, 1.6)], (x, y + face * 0.95, z), 16, "y"
        )
    )
    for k in range(spokes):
        for off in (-0.16, 0.16):
            a, b = 2 * math.pi * k / spokes + off * 0.7, 2 * math.pi * k / spokes + off
            p = (x + 0.16 * r * math.cos(a), y + face, z + 0.16 * r * math.sin(a))
            q = (x + 0.93 * r * math.cos(b), y + face * 0.86, z + 0.93 * r * math.sin(b))
            parts.append(forms.tube([p, q], [0.085 * r, 0.065 * r], 6, flat=0.8, round_ends=False))
    return forms.gather(parts)


def car_wheel(
    s: Sketch, x: float, y: float, r: float, width: float, side: int, name: str, spokes: int = 5
) -> None:
    """A car's wheel; `y` is its outer face and `side` the sign of it."""
    at = (x, y - side * width / 2, r)
    size = 0.69 * r
    s.add(lambda: tyre(at, r, width, size), RUBBER, of="rubber", name=f"tyre_{name}")
    s.add(lambda: rim(at, size, width, side, spokes), ALLOY, of="aluminium", name=f"rim_{name}")

    def disc() -> Any:
        inner = at[1] + side * width * 0.12
        return forms.turned(
            [(size * 0.86, inner - 0.8), (size * 0.86, inner + 0.8)], (x, 0, r), 24, "y"
        )

    s.add(disc, (0.22, 0.22, 0.23), of="steel", name=f"brake_{name}")
    s.wheel((x, at[1], r), r, parts=3)
