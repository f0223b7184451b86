"""What is around the bodies of a scene: sky, sun, ground and what only dresses the place."""

from __future__ import annotations

from dataclasses import dataclass
import math
from typing import TYPE_CHECKING, Literal

from esg.assets.looks import Color, Look

if TYPE_CHECKING:
    from esg.view.pieces import Part

Vec = tuple[float, float, float]


@dataclass(frozen=True)
class Sky:
    """Light from above.

    Args:
        kind: What the sky shows, and what lights a room.
        sun: Unit vector toward the sun, or toward the main lamp of a room.
        sun_rgb: Linear irradiance of it on a surface that faces it; 1 is white paper in daylight.
        ambient_rgb: Linear irradiance of everything else.
        zenith, horizon: Linear colours of the sky straight up and at the horizon.
    """

    kind: Literal["plain", "clear", "cloudy", "dusk", "night", "indoor"] = "plain"
    sun: Vec = (0.5 / math.sqrt(2.0), 0.5 / math.sqrt(2.0), math.sqrt(0.75))
    sun_rgb: Color = (0.8, 0.78, 0.74)
    ambient_rgb: Color = (0.34, 0.36, 0.4)
    zenith: Color = (0.6, 0.7, 0.83)
    horizon: Color = (0.6, 0.7, 0.83)


@dataclass(frozen=True)
class Surroundings:
    """Everything one sees that is no body of the physics.

    Args:
        sky: Its light.
        ground: The endless plane at z = 0.
        parts: Meshes fixed to the world (body -1): walls, kerbs, facades, trees, lamps.
    """

    sky: Sky
    ground: Look
    parts: tuple[Part, ...] = ()
