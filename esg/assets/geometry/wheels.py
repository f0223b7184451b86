"""Names of the wheels of a sketch, told from where their axles are: `wheel_front_left`."""

from __future__ import annotations

from collections.abc import Sequence

from esg.assets.geometry.sketch import Axle, Sketch
from esg.graph.models import Wheel

_SAME_AXLE = 0.5
"""Wheels whose axles lie nearer along X than this share of the smaller radius share one."""
_MIDDLE = 0.25
"""A wheel nearer to the middle plane than this share of its radius has no side."""


def wheels_of(sketch: Sketch) -> tuple[Wheel, ...] | None:
    """The wheels of a sketch in the order of its axles; None if nothing on it turns."""
    if not sketch.axles:
        return None
    return tuple(
        Wheel(name=name, axle_cm=axle.point, radius_cm=axle.radius)
        for name, axle in zip(wheel_names(sketch.axles), sketch.axles, strict=True)
    )


def wheel_names(axles: Sequence[Axle]) -> list[str]:
    """One name a wheel, unique: its row, counted from the front (+X), and its side (left is +Y).

    A single row has no name of its own, two are front and rear, those between are numbered from 2.
    """
    rows: list[list[int]] = []
    for k in sorted(range(len(axles)), key=lambda k: (-axles[k].point[0], k)):
        last = axles[rows[-1][0]] if rows else None
        here = axles[k]
        near = _SAME_AXLE * min(here.radius, last.radius) if last else 0.0
        if last and last.point[0] - here.point[0] < near:
            rows[-1].append(k)
        else:
            rows.append([k])
    names = [""] * len(axles)
    taken: dict[str, int] = {}
    for number, row in enumerate(rows, 1):
        place = {1: "front", len(rows): "rear"}.get(number, str(number)) if len(rows) > 1 else ""
        for k in sorted(row, key=lambda k: -abs(axles[k].point[1])):
            across = axles[k].point[1]
            middle = abs(across) < _MIDDLE * axles[k].radius
            side = "" if middle else "left" if across > 0 else "right"
            name = "_".join(filter(None, ("wheel", place, side)))
            count = taken[name] = taken.get(name, 0) + 1
            names[k] = name if count == 1 else f"{name}_{count}"
    return names
