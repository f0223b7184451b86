"""How a body lies in a liquid: its volume, how deep it floats, what slows it down there."""

from __future__ import annotations

from dataclasses import dataclass
import math

from esg.graph.models import AssetConfiguration, NamedRegion, ProxyKind
from esg.lexicon.contents import CONTENT, Content, contents, densities
from esg.units import GRAVITY_MPS2

MOST = 20.0
"""Density of a liquid over that of a body, at most: what is lighter bobs no faster."""
SHAPE_DRAG = 0.8
"""Drag coefficient: between a ball's 0.47 and a cube's 1.05 (Hoerner, Fluid-Dynamic Drag, 1965)."""
WAVES = 0.25
"""Damping of what bobs on a level, as a share of the critical one: an estimate."""
STOKES = 6.0 * math.pi
ROUND = math.sqrt(2.0)
"""Radius of a round vessel over half the side of the square that its region `inside` is."""
_THIN = 0.96
"""A region that reaches less far than this towards the outside is the square in a round vessel."""
TURNING = 3.0
"""How fast what turns in a liquid comes to rest, at least [1/s]: an estimate."""


@dataclass(frozen=True)
class Afloat:
    """What a liquid does to a body that is all of it in the liquid.

    Args:
        lift: Velocity that it adds [m/s^2].
        linear: Drag that grows with the speed [1/s].
        quadratic: Drag that grows with its square [1/m].
        turning: Of the angular velocity [1/s].
        ball: Whether its volume is in its middle.
    """

    lift: float
    linear: float
    quadratic: float
    turning: float
    ball: bool

    @property
    def share(self) -> float:
        """Share of its height that is in the liquid where it floats; 1 of what sinks."""
        wet = min(1.0, GRAVITY_MPS2 / self.lift)
        if not self.ball or wet >= 1.0:
            return wet
        low, high = 0.0, 1.0
        for _ in range(40):
            middle = 0.5 * (low + high)
            low, high = (
                (middle, high) if middle * middle * (3 - 2 * middle) < wet else (low, middle)
            )
        return low


def liquid_of(config: AssetConfiguration) -> tuple[NamedRegion, Content] | None:
    """Where the liquid is in a vessel, and which it is; None of what has none."""
    for region in config.regions:
        row = contents().get(region.name) if region.kind == CONTENT else None
        if row is not None and row.liquid:
            return region, row
    return None


def afloat(config: AssetConfiguration, row: Content) -> Afloat:
    """What a liquid does to a body.

    What is hollow (a cup, a boat) keeps the liquid out: its inside counts as its own.
    """
    mass = max(config.mass_kg, 1e-9)
    volume = displaced_m3(config)
    ratio = min(row.density * volume / mass, MOST)
    length, width, height = (0.01 * d for d in config.dimensions_cm)
    across = (length * width * height) ** (2.0 / 3.0)
    radius = 0.5 * (length * width * height) ** (1.0 / 3.0)
    linear = STOKES * row.viscosity * radius / mass
    if ratio > 1.0:
        linear += 2.0 * WAVES * math.sqrt(ratio * GRAVITY_MPS2 / height)
    quadratic = 0.5 * SHAPE_DRAG * row.density * across / mass
    return Afloat(
        lift=ratio * GRAVITY_MPS2,
        linear=linear,
        quadratic=quadratic,
        turning=max(linear, TURNING),
        ball=len(config.proxies) == 1 and config.proxies[0].kind is ProxyKind.SPHERE,
    )


def displaced_m3(config: AssetConfiguration) -> float:
    """Volume that a body takes up when all of it is under water [m^3]."""
    known = densities().get(config.category.replace("_", " "))
    if known is not None:
        return config.mass_kg / known
    box = math.prod(config.dimensions_cm)
    solid = sum(_volume(p.kind, p.size_cm, p.vertices_cm) for p in config.proxies)
    hollow = sum(
        hollow_area_cm2(config, r) * 2.0 * r.half_extents_cm[2]
        for r in config.regions
        if r.kind == "inside"
    )
    return 1e-6 * min(solid + hollow, box)


def is_round(config: AssetConfiguration, mouth: NamedRegion) -> bool:
    """Whether a region is the square within a round wall."""
    return ROUND * max(mouth.half_extents_cm[:2]) < _THIN * 0.5 * max(config.dimensions_cm[:2])


def hollow_area_cm2(config: AssetConfiguration, mouth: NamedRegion) -> float:
    """Area of the inside of a vessel seen from above [cm^2]."""
    hx, hy, _ = mouth.half_extents_cm
    return math.pi * (ROUND * min(hx, hy)) ** 2 if is_round(config, mouth) else 4.0 * hx * hy


def _volume(
    kind: ProxyKind, size: tuple[float, float, float], points: tuple[tuple[float, ...], ...]
) -> float:
    a, b, c = size
    if kind is ProxyKind.SPHERE:
        return 4.0 / 3.0 * math.pi * a**3
    if kind is ProxyKind.CYLINDER:
        return 2.0 * math.pi * a * a * c
    if kind is ProxyKind.CAPSULE:
        return math.pi * a * a * (2.0 * c + 4.0 / 3.0 * a)
    if kind is ProxyKind.CONVEX and points:
        from scipy.spatial import ConvexHull

        return float(ConvexHull([list(p) for p in points]).volume)
    return 8.0 * a * b * c
