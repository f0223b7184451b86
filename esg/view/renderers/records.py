"""What every renderer is asked: scenery, poses of frames, one camera a frame, and how well."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Look
from esg.view.camera import Camera
from esg.view.pieces import Part
from esg.view.surroundings import Sky, Surroundings
from esg.view.worlds import NOTHING, Views


@dataclass(frozen=True)
class Scenery:
    """Everything that can be seen.

    Args:
        parts: Meshes of the bodies, and of the world (body -1) beside the surroundings' own.
        n_bodies: Number of bodies that `Part.body` refers to.
        surroundings: Sky, ground and what dresses the place; None for a plain studio.
    """

    parts: tuple[Part, ...]
    n_bodies: int
    surroundings: Surroundings | None = None

    @property
    def everything(self) -> tuple[Part, ...]:
        """All meshes, those of the surroundings last."""
        return (*self.parts, *(self.surroundings.parts if self.surroundings else ()))

    @property
    def sky(self) -> Sky:
        """Light from above."""
        return self.surroundings.sky if self.surroundings else Sky()

    @property
    def ground(self) -> Look | None:
        """The endless plane."""
        return self.surroundings.ground if self.surroundings else None


@dataclass(frozen=True)
class Poses:
    """Where everything is in F frames, at S instants of each while the shutter is open.

    Args:
        position: Body origins [m], shape [F, S, B, 3]; S is 1 without motion blur.
        quaternion: (x, y, z, w), shape [F, S, B, 4].
        angles: Of all wheels of the scene [rad], shape [F, S, W]; None for none turned.
    """

    position: NDArray[Any]
    quaternion: NDArray[Any]
    angles: NDArray[Any] | None = None

    def __len__(self) -> int:
        return len(self.position)

    def part(self, first: int, last: int) -> Poses:
        """Frames from `first` to before `last`."""
        angles = None if self.angles is None else self.angles[first:last]
        return Poses(self.position[first:last], self.quaternion[first:last], angles)

    def middle(self) -> Poses:
        """The instant in the middle of every frame: what exact channels show."""
        k = self.position.shape[1] // 2
        angles = None if self.angles is None else self.angles[:, k : k + 1]
        return Poses(self.position[:, k : k + 1], self.quaternion[:, k : k + 1], angles)


@dataclass(frozen=True)
class Quality:
    """How pictures are drawn.

    Args:
        size: Width and height [px].
        samples: Rays a pixel; None for what the renderer takes by itself.
        seed: Of noise and clouds.
        device: cpu or cuda:N.
        exact: Also draw depth, normals and bodies.
        color: Draw colours.
    """

    size: tuple[int, int]
    samples: int | None = None
    seed: int = 0
    device: str = "cpu"
    exact: bool = False
    color: bool = True


class Drawer(Protocol):
    """A renderer that has loaded one scenery."""

    def draw(self, poses: Poses, cameras: Sequence[Camera]) -> Views:
        """Pictures of F frames.

        Args:
            poses: Of F frames.
            cameras: One a frame; all of one field of view.
        """
        ...


@dataclass(frozen=True)
class Kind:
    """One way to draw.

    Args:
        name: As on the command line.
        samples: Rays a pixel that it takes by itself.
        load: Loads a scenery; raises `UserError` where the renderer is not there.
        version: Of the program that draws.
        batch: Frames it likes to draw at once.
    """

    name: str
    samples: int
    load: Callable[[Scenery, Quality], Drawer]
    version: Callable[[], str]
    batch: int = 24


def blank(rgb: NDArray[np.uint8]) -> Views:
    """Pictures without exact channels."""
    shape = rgb.shape[:3]
    nothing = np.full(shape, NOTHING, np.int32)
    zero = np.zeros(shape, np.float32)
    return Views(rgb, zero, np.zeros((*shape, 3), np.float32), nothing, nothing)
