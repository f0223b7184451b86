"""A recorder for parametric assets: coloured mesh parts, and the collider with them.

Builders draw in the asset's local frame (cm, origin bottom centre, front +X, Z up). Proxies,
surfaces and regions are plain numbers and available at once; meshes are recorded as closures and
made only when somebody looks at them, so that resolving a scene never waits for geometry.

Every part is of a material of the table (`esg/assets/materials.csv`): the one it names (`of=`),
that of its colour (`RUBBER`, `STEEL`), or else that of the whole (`Sketch.material`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
import itertools
from typing import TYPE_CHECKING, Any, TypedDict, Unpack

from esg.assets.appearance import USUAL, Appearance
from esg.assets.geometry.collider import Collider
from esg.assets.geometry.rotations import IDENTITY, direction
from esg.assets.lazy import shapes
from esg.assets.looks import Color
from esg.assets.materials import MATERIALS
from esg.graph.models import ProxyKind, Quat, Vec3

if TYPE_CHECKING:
    import trimesh


class Finish(tuple[float, float, float]):
    """A colour that knows what it is the colour of."""

    material: str

    def __new__(cls, color: Color, material: str) -> Finish:
        out = super().__new__(cls, color)
        out.material = material
        return out

    def __getnewargs__(self) -> tuple[Color, str]:
        return (self[0], self[1], self[2]), self.material


def rgb(red: int, green: int, blue: int) -> Color:
    """A colour from bytes."""
    return (red / 255.0, green / 255.0, blue / 255.0)


def finish(material: str, color: Color | None = None) -> Finish:
    """A material in a colour, its own by default."""
    return Finish(MATERIALS[material].color if color is None else color, material)


STEEL, CHROME = finish("steel"), finish("chrome")
DARK, WHITE = finish("plastic", rgb(38, 38, 42)), finish("paint", rgb(244, 243, 238))
RUBBER, GLASS = finish("rubber"), finish("glass_dark")
WOOD, DARK_WOOD, PALE_WOOD = finish("oak"), finish("walnut"), finish("pine")
CONCRETE, ASPHALT, BRICK_RED = finish("concrete"), finish("asphalt"), finish("brick")
RED, GREEN = finish("paint", rgb(190, 28, 30)), finish("paint", rgb(40, 120, 62))
BLUE, YELLOW = finish("paint", rgb(40, 78, 150)), finish("paint", rgb(235, 190, 40))
ORANGE, CARDBOARD, BRASS = finish("paint", rgb(236, 104, 30)), finish("cardboard"), finish("brass")


@dataclass(frozen=True)
class Axle:
    """Where a wheel turns: a point of its axis, which lies along Y, and its radius [cm]."""

    point: Vec3
    radius: float


@dataclass(frozen=True)
class Limb:
    """A leg, an arm or the trunk: what swings about its first joint, and bends at its second.

    Args:
        name: leg_left, arm_right, leg_front_left, trunk.
        joints: From the top to the tip [cm]: hip, knee and ankle; pelvis, neck and crown.
        pitch: Of what is beyond the last joint, forwards and down [deg].
        reach: Share of its usual swing that what is worn allows.
    """

    name: str
    joints: tuple[Vec3, Vec3, Vec3]
    pitch: float = 0.0
    reach: float = 1.0


@dataclass(frozen=True)
class Part:
    """One closed mesh with one material; `mesh` makes it (cm, local frame).

    A part of a wheel knows its `axle`, an index into those of its sketch.

    Args:
        name: What it is ("seat"); its material if the builder does not say.
        mesh: Makes it.
        color: sRGB in [0, 1].
        material: Key of the table of materials.
        roughness, alpha: In [0, 1]; None for the material's own.
        axle: Of the wheel it belongs to.
        limb: Name of the limb it belongs to; empty for none.
        tip: Whether it is at the limb's end, beyond its last joint: a shoe.
    """

    name: str
    mesh: Callable[[], trimesh.Trimesh]
    color: Color
    material: str
    roughness: float | None = None
    alpha: float | None = None
    axle: int | None = None
    limb: str = ""
    tip: bool = False


class Style(TypedDict, total=False):
    """What else a builder may say of a part.

    `of` names its material, `name` says what it is; `rough` and `alpha` replace the material's own.
    """

    of: str
    name: str
    rough: float
    alpha: float


@dataclass
class Sketch(Collider):
    """What a builder fills. `solid` arguments are relative densities: 0 draws without a proxy.

    Args:
        material: Of what is drawn in a colour that names none.
        appearance: What the builder chooses details by.
    """

    parts: list[Part] = field(default_factory=list)
    axles: list[Axle] = field(default_factory=list)
    limbs: list[Limb] = field(default_factory=list)
    material: str = "plastic_hard"
    appearance: Appearance = USUAL

    def add(
        self,
        make: Callable[[], Any],
        color: Color,
        *,
        of: str = "",
        name: str = "",
        rough: float | None = None,
        alpha: float | None = None,
    ) -> None:
        """Records a closed mesh made by `make`."""
        material = of or (color.material if isinstance(color, Finish) else self.material)
        self.parts.append(Part(name or material, make, color, material, rough, alpha))

    def wheel(self, point: Vec3, radius: float, parts: int = 1) -> None:
        """Says that the last `parts` parts are a wheel that turns about Y through `point`."""
        self.axles.append(Axle(point, radius))
        number = len(self.axles) - 1
        self.parts[-parts:] = [replace(p, axle=number) for p in self.parts[-parts:]]

    def limb(self, limb: Limb, since: int, *, tip: int | None = None) -> None:
        """Says that the parts from number `since` on are a limb, those from `tip` on its end."""
        if limb not in self.limbs:
            self.limbs.append(limb)
        for k in range(since, len(self.parts)):
            end = tip is not None and k >= tip
            self.parts[k] = replace(self.parts[k], limb=limb.name, tip=end)

    def box(
        self,
        size: Vec3,
        center: Vec3,
        color: Color,
        *,
        solid: float = 0.0,
        quat: Quat = IDENTITY,
        **style: Unpack[Style],
    ) -> None:
        """Box of full extents `size` about `center`."""

        self.add(lambda: shapes.box(size, center, quat), color, **style)
        if solid:
            self.proxy_box((size[0] / 2, size[1] / 2, size[2] / 2), center, solid, quat)

    def slab(
        self,
        x: tuple[float, float],
        y: tuple[float, float],
        z: tuple[float, float],
        color: Color,
        *,
        solid: float = 0.0,
        **style: Unpack[Style],
    ) -> None:
        """Box between coordinate pairs."""
        self.box(
            (x[1] - x[0], y[1] - y[0], z[1] - z[0]),
            ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2),
            color,
            solid=solid,
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
        sections: int = 28,
        **style: Unpack[Style],
    ) -> None:
        """Cylinder from `start` to `end`."""

        self.add(lambda: shapes.rod(radius, start, end, sections), color, **style)
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
        **style: Unpack[Style],
    ) -> None:
        """Surface of revolution of a (radius, height) profile about `axis`."""

        self.add(lambda: shapes.lathe(profile, center, smooth, sections, axis), color, **style)

    def ball(
        self,
        radius: float,
        center: Vec3,
        color: Color,
        *,
        solid: float = 0.0,
        scale: Vec3 = (1, 1, 1),
        detail: int = 3,
        **style: Unpack[Style],
    ) -> None:
        """Sphere, or an ellipsoid if scaled (then without a proxy)."""

        self.add(lambda: shapes.ball(radius, center, scale, detail), color, **style)
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
        **style: Unpack[Style],
    ) -> None:
        """Prism of a polygon in plane xz (along y), yz (along x) or xy (along z)."""

        self.add(lambda: shapes.extrude(polygon, span, plane, soft, holes), color, **style)

    def torus(
        self,
        major: float,
        minor: float,
        center: Vec3,
        color: Color,
        *,
        axis: str = "z",
        **style: Unpack[Style],
    ) -> None:
        """Ring about `axis`."""

        self.add(lambda: shapes.torus(major, minor, center, axis), color, **style)

    def pipe(
        self,
        radius: float,
        path: Sequence[Vec3],
        color: Color,
        **style: Unpack[Style],
    ) -> None:
        """Rods along a polyline with ball joints."""
        for a, b in itertools.pairwise(path):
            self.rod(radius, a, b, color, sections=14, **style)
        for p in path[1:-1]:
            self.ball(radius, p, color, detail=2, **style)
