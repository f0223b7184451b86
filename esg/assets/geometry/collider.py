"""What an asset is to physics and layout: collision proxies, support surfaces, named regions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
import math
from typing import Any

import numpy as np

from esg.assets.geometry.rotations import IDENTITY, turn
from esg.graph.models import Mount, NamedRegion, Proxy, ProxyKind, Quat, SupportSurface, Vec3


@dataclass
class Collider:
    """What of an asset others touch, rest on and enter, in its local frame [cm]."""

    proxies: list[Proxy] = field(default_factory=list)
    densities: list[float] = field(default_factory=list)
    surfaces: list[SupportSurface] = field(default_factory=list)
    regions: list[NamedRegion] = field(default_factory=list)
    mounts: list[Mount] = field(default_factory=list[Mount])
    weighed: list[Proxy] | None = None
    """Shapes that mass and inertia come from where they are not the proxies; with `densities`."""

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

    def mount(self, name: str, at: Vec3, axis: Vec3 = (0.0, 0.0, 1.0)) -> None:
        """Records where a joint takes hold, and the axis it turns about or slides along."""
        self.mounts.append(Mount(name=name, position_cm=at, axis=axis))


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
