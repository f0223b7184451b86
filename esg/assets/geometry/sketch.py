"""A recorder for parametric assets: coloured mesh parts, and the collider with them.

Builders draw in the asset's local frame (cm, origin bottom centre, front +X, Z up). Proxies,
surfaces and regions are plain numbers and available at once; meshes are recorded as closures and
made only when somebody looks at them, so that resolving a scene never waits for geometry.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
import itertools
from typing import TYPE_CHECKING, Any

from esg.assets.geometry.collider import Collider
from esg.assets.geometry.rotations import IDENTITY, direction
from esg.assets.lazy import shapes
from esg.graph.models import ProxyKind, Quat, Vec3

if TYPE_CHECKING:
    import trimesh

Color = tuple[float, float, float]


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
class Axle:
    """Where a wheel turns: a point of its axis, which lies along Y, and its radius [cm]."""

    point: Vec3
    radius: float


@dataclass(frozen=True)
class Part:
    """One closed mesh with one material; `mesh` makes it (cm, local frame).

    A part of a wheel knows its `axle`, an index into those of its sketch.
    """

    name: str
    mesh: Callable[[], trimesh.Trimesh]
    color: Color
    roughness: float = 0.6
    metallic: float = 0.0
    alpha: float = 1.0
    axle: int | None = None


@dataclass
class Sketch(Collider):
    """What a builder fills. `solid` arguments are relative densities: 0 draws without a proxy."""

    parts: list[Part] = field(default_factory=list)
    axles: list[Axle] = field(default_factory=list)

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

    def wheel(self, point: Vec3, radius: float, parts: int = 1) -> None:
        """Says that the last `parts` parts are a wheel that turns about Y through `point`."""
        self.axles.append(Axle(point, radius))
        number = len(self.axles) - 1
        self.parts[-parts:] = [replace(p, axle=number) for p in self.parts[-parts:]]

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
            quat, length = direction(start, end)
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
