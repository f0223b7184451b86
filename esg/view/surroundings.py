"""What is around the bodies of a scene: sky, sun, ground and what only dresses the place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
import math
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color, Look

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument
    from esg.view.render import Part

Vec = tuple[float, float, float]
Floats = NDArray[np.float64]


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
        parts: Meshes fixed to the world (body -1): walls, kerbs, facades, trees, lamps. Their names
            begin with the id of the thing they are of, before a "/"; markings are "ground/...".
    """

    sky: Sky
    ground: Look
    parts: tuple[Part, ...] = ()

    def seen_from(self, eyes: Floats, points: Floats) -> Surroundings:
        """Without the things that stand between cameras and what they are to show.

        Walls of a room and facades of a street are left out whole as soon as one looks through
        them from one of the eyes, as in a dollhouse, and so is what a camera stands in.

        Args:
            eyes: Of all cameras that draw it [m], shape [n, 3].
            points: What they look at: a few points of the action [m], shape [m, 3].
        """
        return self
