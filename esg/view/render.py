"""Stills of a scene's real meshes on the CPU, from one camera after another."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
import copy
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.view.camera import Camera
from esg.view.pieces import Movers, Part, Turning
from esg.view.surroundings import Surroundings
from esg.view.worlds import SAMPLES, WorldRenderer

__all__ = ["SAMPLES", "Movers", "Part", "Renderer", "Turning"]


class Renderer:
    """Renders one set of parts in many poses from many cameras.

    Args:
        parts: Meshes.
        n_bodies: Number of bodies that `Part.body` refers to.
        width, height: Of the picture [px].
        surroundings: Sky, ground and what dresses the place; None for neither.
        seed: Of the clouds.
    """

    def __init__(
        self,
        parts: Sequence[Part],
        n_bodies: int,
        width: int,
        height: int,
        surroundings: Surroundings | None = None,
        seed: int = 0,
    ) -> None:
        self.width, self.height = width, height
        self._world = WorldRenderer(
            parts,
            n_bodies,
            1,
            (width, height),
            sun=math.pi / 2,
            surroundings=surroundings,
            seed=seed,
        )

    def twin(self) -> Renderer:
        """A renderer of the same scene that draws beside this one, in poses of its own."""
        other = copy.copy(self)
        other._world = self._world.twin()
        return other

    def light(self, azimuth: float) -> None:
        """Puts the sun of a plain sky behind the viewer's right shoulder, to light what one sees.

        Args:
            azimuth: Direction from the scene to the viewer, counter-clockwise from +X [rad].
        """
        self._world.light(azimuth)

    def pose(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None = None
    ) -> None:
        """Moves the bodies.

        Args:
            position: Body origins [m], shape [B, 3].
            quaternion: (x, y, z, w), shape [B, 4].
            angles: Of the scene's wheels [rad], shape [W].
        """
        turned = None if angles is None else angles[None]
        self._world.pose(position[None], quaternion[None], turned)

    def color(
        self, camera: Camera, size: tuple[int, int] | None = None, samples: int = SAMPLES
    ) -> NDArray[np.uint8]:
        """The picture from `camera`, shape [height, width, 3].

        Args:
            camera: Where to look from.
            size: Width and height [px]; default those of the renderer.
            samples: Rays a pixel where surfaces meet.
        """
        self._world.draw([camera], size=size or (self.width, self.height), samples=samples)
        rgb = self._world.read().rgb
        assert rgb is not None
        return rgb[0]

    def visible(self, camera: Camera, bodies: Iterable[int], width: int = 96) -> dict[int, int]:
        """How many pixels of a small picture each body covers.

        Args:
            camera: Where to look from.
            bodies: Body indices to count.
            width: Of the small picture [px].
        """
        height = max(1, round(width * self.height / self.width))
        self._world.draw([camera], rgb=False, size=(width, height))
        seen = self._world.read(rgb=False).body
        return {b: int((seen == b).sum()) for b in bodies}
