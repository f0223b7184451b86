"""Small helpers that builders share."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
import math
from typing import Any, Unpack

from esg.assets.geometry.sketch import CHROME, RUBBER, STEEL, Color, Finish, Sketch, Style, rgb
from esg.assets.lazy import shapes
from esg.graph.models import Vec3

Span = tuple[float, float]
LEAF = Finish(rgb(66, 130, 56), "leaves")


def shade(c: Color, factor: float) -> Color:
    """A lighter or darker tone of the same material."""
    tone = (min(c[0] * factor, 1.0), min(c[1] * factor, 1.0), min(c[2] * factor, 1.0))
    return Finish(tone, c.material) if isinstance(c, Finish) else tone


def mirrored(sign: int, low: float, high: float) -> Span:
    """The span [low, high], mirrored at 0 for a negative sign."""
    return (low, high) if sign > 0 else (-high, -low)


def edge(sign: int, extent: float, thickness: float) -> Span:
    """The outermost `thickness` of a centred extent, on the side of `sign`."""
    return mirrored(sign, extent / 2 - thickness, extent / 2)


def bone(
    s: Sketch,
    a: Vec3,
    ra: float,
    b: Vec3,
    rb: float,
    c: Color,
    *,
    detail: int = 2,
    **style: Unpack[Style],
) -> None:
    """Draws the hull of two balls: limbs, necks, horns, petals."""
    blob(s, [(a, ra), (b, rb)], c, detail=detail, **style)


def blob(
    s: Sketch,
    balls: Sequence[tuple[Vec3, float]],
    c: Color,
    *,
    detail: int = 2,
    **style: Unpack[Style],
) -> None:
    """Draws the hull of some balls."""

    def make() -> Any:
        import numpy as np

        points = [shapes.ball(r, p, detail=detail).vertices for p, r in balls]
        return shapes.hull(np.concatenate(points))

    s.add(make, c, **style)


def prism(s: Sketch, points: Sequence[Vec3], c: Color, **style: Unpack[Style]) -> None:
    """Draws the convex hull of corner points."""
    s.add(lambda: shapes.hull(points), c, **style)


def shift(s: Sketch, dx: float = 0.0, dy: float = 0.0, dz: float = 0.0) -> None:
    """Moves everything drawn so far."""
    offset = (dx, dy, dz)

    def moved(make: Callable[[], Any]) -> Callable[[], Any]:
        def mesh() -> Any:
            out = make()
            out.apply_translation(offset)
            return out

        return mesh

    def at(v: Vec3) -> Vec3:
        return (v[0] + dx, v[1] + dy, v[2] + dz)

    s.parts[:] = [replace(p, mesh=moved(p.mesh)) for p in s.parts]
    s.axles[:] = [replace(a, point=at(a.point)) for a in s.axles]
    s.limbs[:] = [
        replace(m, joints=(at(m.joints[0]), at(m.joints[1]), at(m.joints[2]))) for m in s.limbs
    ]
    s.proxies[:] = [p.model_copy(update={"position_cm": at(p.position_cm)}) for p in s.proxies]
    if s.weighed is not None:
        s.weighed = [p.model_copy(update={"position_cm": at(p.position_cm)}) for p in s.weighed]
    s.surfaces[:] = [p.model_copy(update={"center_cm": at(p.center_cm)}) for p in s.surfaces]
    s.mounts[:] = [m.model_copy(update={"position_cm": at(m.position_cm)}) for m in s.mounts]
    s.regions[:] = [p.model_copy(update={"center_cm": at(p.center_cm)}) for p in s.regions]


def wheel(s: Sketch, x: float, y: float, r: float, width: float, hub: Color = CHROME) -> None:
    """A wheel about Y whose middle is at `y`."""
    s.rod(r, (x, y - width / 2, r), (x, y + width / 2, r), RUBBER, sections=32)
    s.rod(r * 0.58, (x, y - width * 0.55, r), (x, y + width * 0.55, r), hub)
    holes(s, (x, y, r), r * 0.58, width * 1.16)
    s.wheel((x, y, r), r, parts=3)


def holes(s: Sketch, at: Vec3, rim: float, width: float) -> None:
    """Five dark spots on the faces of a rim about Y: without them one does not see it turn."""
    x, y, z = at
    turns = [2 * math.pi * k / 5 for k in range(5)]

    def make() -> Any:
        spots = [(x + 0.58 * rim * math.cos(a), z + 0.58 * rim * math.sin(a)) for a in turns]
        ends = [((u, y - width / 2, v), (u, y + width / 2, v)) for u, v in spots]
        return shapes.join([shapes.rod(0.24 * rim, a, b, 12) for a, b in ends])

    s.add(make, RUBBER)


def spokes(s: Sketch, x: float, y: float, r: float, c: Color = CHROME) -> None:
    """A spoked wheel about Y."""
    s.torus(r - 0.06 * r, 0.06 * r, (x, y, r), RUBBER, axis="y")
    s.rod(0.1 * r, (x, y - 0.1 * r, r), (x, y + 0.1 * r, r), STEEL, sections=14)
    for k in range(6):
        a = math.pi * k / 6
        d = (0.9 * r * math.cos(a), 0.9 * r * math.sin(a))
        s.rod(0.025 * r, (x - d[0], y, r - d[1]), (x + d[0], y, r + d[1]), c, sections=6)
    s.wheel((x, y, r), r, parts=8)
