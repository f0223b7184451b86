"""A recorder for parametric assets: coloured mesh parts, collision proxies, surfaces, regions.

Builders draw in the asset's local frame (cm, origin bottom centre, front +X, Z up). Proxies,
surfaces and regions are plain numbers and available at once; meshes are recorded as closures and
made only when somebody looks at them, so that resolving a scene never waits for geometry.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
import itertools
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from esg.assets.lazy import shapes
from esg.graph.models import NamedRegion, Proxy, ProxyKind, Quat, SupportSurface, Vec3

if TYPE_CHECKING:
    import trimesh

Color = tuple[float, float, float]
IDENTITY: Quat = (0.0, 0.0, 0.0, 1.0)


def rgb(red: int, green: int, blue: int) -> Color:
    """A colour from bytes."""
    return (red / 255.0, green / 255.0, blue / 255.0)


STEEL, CHROME, DARK = rgb(150, 153, 158), rgb(200, 203, 208), rgb(38, 38, 42)
RUBBER, WHITE, GLASS = rgb(28, 28, 30), rgb(244, 243, 238), rgb(40, 50, 62)
WOOD, DARK_WOOD, PALE_WOOD = rgb(176, 128, 78), rgb(110, 70, 40), rgb(214, 178, 128)
CONCRETE, ASPHALT, BRICK_RED = rgb(178, 176, 170), rgb(62, 63, 66), rgb(160, 76, 56)
RED, GREEN, BLUE, YELLOW = rgb(190, 28, 30), rgb(40, 120, 62), rgb(40, 78, 150), rgb(235, 190, 40)
ORANGE, CARDBOARD, BRASS = rgb(236, 104, 30), rgb(186, 146, 98), rgb(196, 160, 80)


@dataclass(frozen=True)
class Part:
    """One closed mesh with one material; `mesh` makes it (cm, local frame)."""

    name: str
    mesh: Callable[[], trimesh.Trimesh]
    color: Color
    roughness: float = 0.6
    metallic: float = 0.0
    alpha: float = 1.0


def turn(axis: str, degrees: float) -> Quat:
    """Quaternion (x, y, z, w) of a rotation about a coordinate axis."""
    half = math.radians(degrees) / 2
    return tuple(  # type: ignore[return-value]  # always four entries
        [math.sin(half) if axis == name else 0.0 for name in "xyz"] + [math.cos(half)]
    )


ALONG = {"x": turn("y", 90.0), "y": turn("x", -90.0), "z": IDENTITY}
"""Rotations that lead local Z to an axis."""


def _direction(start: Sequence[float], end: Sequence[float]) -> tuple[Quat, float]:
    d = np.asarray(end, float) - np.asarray(start, float)
    length = float(np.linalg.norm(d))
    d = d / length
    w = 1.0 + d[2]
    if w < 1e-9:
        return (1.0, 0.0, 0.0, 0.0), length
    q = np.array([-d[1], d[0], 0.0, w])
    q /= np.linalg.norm(q)
    return (float(q[0]), float(q[1]), float(q[2]), float(q[3])), length


@dataclass
class Sketch:
    """What a builder fills. `solid` arguments are relative densities: 0 draws without a proxy."""

    parts: list[Part] = field(default_factory=list)
    proxies: list[Proxy] = field(default_factory=list)
    densities: list[float] = field(default_factory=list)
    surfaces: list[SupportSurface] = field(default_factory=list)
    regions: list[NamedRegion] = field(default_factory=list)
    weighed: list[Proxy] | None = None
    """Shapes that mass and inertia come from where they are not the proxies; with `densities`."""

    # --- drawing -------------------------------------------------------------------------------
    def add(
        self,
        make: Callable[[], Any],
        color: Color,
        rough: float = 0.6,
        metal: float = 0.0,
        alpha: float = 1.0,
    ) -> None:
        """Records a closed mesh made by `make`."""
        name = f"part_{len(self.parts):03d}"
        self.parts.append(Part(name, make, color, rough, metal, alpha))

    def box(
        self,
        size: Vec3,
        center: Vec3,
        color: Color,
        *,
        solid: float = 0.0,
        rough: float = 0.6,
        metal: float = 0.0,
        alpha: float = 1.0,
        quat: Quat = IDENTITY,
    ) -> None:
        """Box of full extents `size` about `center`."""

        self.add(lambda: shapes.box(size, center, quat), color, rough, metal, alpha)
        if solid:
            self.proxy_box((size[0] / 2, size[1] / 2, size[2] / 2), center, solid, quat)

    def slab(
        self,
        x: tuple[float, float],
        y: tuple[float, float],
        z: tuple[float, float],
        color: Color,
        **style: Any,
    ) -> None:
        """Box between coordinate pairs."""
        self.box(
            (x[1] - x[0], y[1] - y[0], z[1] - z[0]),
            ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2),
            color,
            **style,
        )

    def rod(
        self,
        radius: float,
        start: Vec3,
        end: Vec3,
        color: Color,
        *,
        solid: float = 0.0,
        rough: float = 0.6,
        metal: float = 0.0,
        alpha: float = 1.0,
        sections: int = 28,
    ) -> None:
        """Cylinder from `start` to `end`."""

        self.add(lambda: shapes.rod(radius, start, end, sections), color, rough, metal, alpha)
        if solid:
            quat, length = _direction(start, end)
            mid = tuple((a + b) / 2 for a, b in zip(start, end, strict=True))
            self.proxy(ProxyKind.CYLINDER, (radius, radius, length / 2), mid, solid, quat)

    def lathe(
        self,
        profile: Sequence[tuple[float, float]],
        color: Color,
        *,
        center: Vec3 = (0, 0, 0),
        smooth: int = 0,
        sections: int = 48,
        axis: str = "z",
        rough: float = 0.6,
        metal: float = 0.0,
        alpha: float = 1.0,
    ) -> None:
        """Surface of revolution of a (radius, height) profile about `axis`."""

        self.add(
            lambda: shapes.lathe(profile, center, smooth, sections, axis),
            color,
            rough,
            metal,
            alpha,
        )

    def ball(
        self,
        radius: float,
        center: Vec3,
        color: Color,
        *,
        solid: float = 0.0,
        rough: float = 0.5,
        metal: float = 0.0,
        scale: Vec3 = (1, 1, 1),
        detail: int = 3,
    ) -> None:
        """Sphere, or an ellipsoid if scaled (then without a proxy)."""

        self.add(lambda: shapes.ball(radius, center, scale, detail), color, rough, metal)
        if solid:
            self.proxy(ProxyKind.SPHERE, (radius,) * 3, center, solid)

    def extrude(
        self,
        polygon: Sequence[tuple[float, float]],
        span: tuple[float, float],
        color: Color,
        *,
        plane: str = "xz",
        soft: float = 0.0,
        holes: Sequence[Sequence[tuple[float, float]]] = (),
        rough: float = 0.6,
        metal: float = 0.0,
        alpha: float = 1.0,
    ) -> None:
        """Prism of a polygon in plane xz (along y), yz (along x) or xy (along z)."""

        self.add(
            lambda: shapes.extrude(polygon, span, plane, soft, holes), color, rough, metal, alpha
        )

    def torus(
        self,
        major: float,
        minor: float,
        center: Vec3,
        color: Color,
        *,
        axis: str = "z",
        rough: float = 0.6,
        metal: float = 0.0,
    ) -> None:
        """Ring about `axis`."""

        self.add(lambda: shapes.torus(major, minor, center, axis), color, rough, metal)

    def pipe(
        self,
        radius: float,
        path: Sequence[Vec3],
        color: Color,
        *,
        rough: float = 0.4,
        metal: float = 0.0,
    ) -> None:
        """Rods along a polyline with ball joints."""
        for a, b in itertools.pairwise(path):
            self.rod(radius, a, b, color, rough=rough, metal=metal, sections=14)
        for p in path[1:-1]:
            self.ball(radius, p, color, rough=rough, metal=metal, detail=2)

    # --- physics -------------------------------------------------------------------------------
    def proxy(
        self,
        kind: ProxyKind,
        size: Any,
        center: Any,
        density: float = 1.0,
        quat: Quat = IDENTITY,
        vertices: Any = (),
    ) -> None:
        """Records a collision proxy with a relative density."""
        self.proxies.append(
            Proxy(
                kind=kind,
                size_cm=tuple(float(v) for v in size),  # type: ignore[arg-type]
                position_cm=tuple(float(v) for v in center),  # type: ignore[arg-type]
                orientation_xyzw=quat,
                vertices_cm=tuple(tuple(float(c) for c in v) for v in vertices),  # type: ignore[arg-type]
            )
        )
        if self.weighed is None:
            self.densities.append(density)

    def only_weighs(self) -> None:
        """What was solid so far gives mass and inertia only; what follows is what collides.

        So a vessel can be entered and keeps the mass properties it had as a solid.
        """
        self.weighed, self.proxies = list(self.proxies), []

    def proxy_box(
        self, half: Any, center: Any, density: float = 1.0, quat: Quat = IDENTITY
    ) -> None:
        self.proxy(ProxyKind.BOX, half, center, density, quat)

    def proxy_slab(
        self,
        x: tuple[float, float],
        y: tuple[float, float],
        z: tuple[float, float],
        density: float = 1.0,
    ) -> None:
        """Box proxy between coordinate pairs."""
        self.proxy_box(
            [(v[1] - v[0]) / 2 for v in (x, y, z)], [(v[0] + v[1]) / 2 for v in (x, y, z)], density
        )

    def proxy_cylinder(
        self,
        radius: float,
        z: tuple[float, float],
        density: float = 1.0,
        xy: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        """Upright cylinder proxy."""
        self.proxy(
            ProxyKind.CYLINDER,
            (radius, radius, (z[1] - z[0]) / 2),
            (*xy, (z[0] + z[1]) / 2),
            density,
        )

    def proxy_hull(self, points: Sequence[Vec3], density: float = 1.0) -> None:
        """Convex proxy of the given points; its position is the centre of their bounding box."""
        p = np.asarray(points, float)
        lo, hi = p.min(0), p.max(0)
        mid = (lo + hi) / 2
        self.proxy(ProxyKind.CONVEX, (hi - lo) / 2, mid, density, vertices=p - mid)

    def walls(
        self,
        x: tuple[float, float],
        y: tuple[float, float],
        z: tuple[float, float],
        thickness: float,
        density: float = 1.0,
    ) -> None:
        """Open box of five proxies: floor and four walls, outer extents given."""
        t = thickness
        self.proxy_slab(x, y, (z[0], z[0] + t), density)
        above = (z[0] + t, z[1])
        self.proxy_slab((x[0], x[0] + t), y, above, density)
        self.proxy_slab((x[1] - t, x[1]), y, above, density)
        self.proxy_slab((x[0] + t, x[1] - t), (y[0], y[0] + t), above, density)
        self.proxy_slab((x[0] + t, x[1] - t), (y[1] - t, y[1]), above, density)

    def tub(
        self,
        radius: float,
        z: tuple[float, float],
        thickness: float,
        density: float = 1.0,
        sides: int = 8,
        xy: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        """Open round container: a floor cylinder and a ring of wall boxes of outer `radius`."""
        floor = z[0] + thickness
        self.proxy_cylinder(radius, (z[0], floor), density, xy)
        self.ring(radius, (floor, z[1]), thickness, density, sides, xy)

    def ring(
        self,
        radius: float,
        z: tuple[float, float],
        thickness: float,
        density: float = 1.0,
        sides: int = 8,
        xy: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        """Round wall of boxes of outer `radius`."""
        t = thickness
        inner = (radius - t) * math.cos(math.pi / sides)
        width = (radius - t / 2) * math.tan(math.pi / sides)
        middle = inner + t / 2
        for k in range(sides):
            angle = 360.0 * k / sides
            c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
            self.proxy_box(
                (t / 2, width, (z[1] - z[0]) / 2),
                (xy[0] + middle * c, xy[1] + middle * s, (z[0] + z[1]) / 2),
                density,
                turn("z", angle),
            )

    def surface(
        self, name: str, z: float, half: tuple[float, float], xy: tuple[float, float] = (0.0, 0.0)
    ) -> None:
        """Records a support surface."""
        self.surfaces.append(
            SupportSurface(name=name, center_cm=(*xy, float(z)), half_extents_cm=half)
        )

    def region(
        self,
        name: str,
        x: tuple[float, float],
        y: tuple[float, float],
        z: tuple[float, float],
        kind: Any = "inside",
    ) -> None:
        """Records a named region between coordinate pairs."""
        self.regions.append(
            NamedRegion(
                name=name,
                center_cm=tuple((v[0] + v[1]) / 2 for v in (x, y, z)),  # type: ignore[arg-type]
                half_extents_cm=tuple((v[1] - v[0]) / 2 for v in (x, y, z)),  # type: ignore[arg-type]
                kind=kind,
            )
        )


def lying_hull(profile: Sequence[tuple[float, float]], axis_z: float, sides: int) -> list[Vec3]:
    """Hull points of a body of revolution that lies along X and stands on a flat underneath.

    Args:
        profile: (x, radius) pairs [cm].
        axis_z: Height of the axis [cm].
        sides: Points a ring.
    """
    points: list[Vec3] = []
    reach = max(x for x, _ in profile)
    for x, radius in profile:
        for k in range(sides):
            t = 2 * math.pi * (k + 0.5) / sides
            points.append((x, radius * math.cos(t), axis_z + radius * math.sin(t)))
        if abs(x) < 0.55 * reach or radius > 0.8 * axis_z:
            points += [(x, side * 0.25 * radius, 0.0) for side in (-1.0, 1.0)]
    return points


def scaled(sketch: Sketch, factor: float) -> Sketch:
    """The same sketch, uniformly scaled about the origin."""
    from esg.assets.stretch import stretched

    return stretched(sketch, (factor,) * 3)
