"""What cameras see, for many worlds at once: colour, depth, normals and which body it is.

All views of a batch are one launch of the tracer, on the CPU or a GPU. A world is one instant of
one scene: the frames of a scene, or many scenes, fill a batch equally well.
"""

from __future__ import annotations

from collections.abc import Sequence
import copy
from dataclasses import dataclass
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.view.camera import Camera
from esg.view.pieces import Movers, Part
from esg.view.skies import sun_behind
from esg.view.surroundings import Surroundings
from esg.view.tracer.stage import Stage

NOTHING, GROUND = -2, -1
"""Body indices of pixels that hit nothing, and the ground."""
SEEN = ("depth", "normal", "mover", "paint", "point", "albedo", "light", "mirror", "shine", "rest")
"""Pictures that the first ray of every pixel makes; most are vectors."""
SURFACES = SEEN[:5]
"""Those by which surfaces are told apart."""
SAMPLES = 4
"""Rays a pixel where surfaces meet; elsewhere there is one."""


@dataclass(frozen=True)
class Views:
    """Pictures of W worlds, each of height H and width L [px].

    Args:
        rgb: Shape [W, H, L, 3], uint8; None if not asked for.
        depth: Along the camera's axis [m], 0 where nothing is hit, shape [W, H, L], float32.
        normal: Unit normals in the world's frame, 0 where nothing is hit, shape [W, H, L, 3].
        body: Index of the body, `GROUND` or `NOTHING`, shape [W, H, L], int32.
        mover: The same with wheels told from their bodies (`Movers`), shape [W, H, L], int32.
    """

    rgb: NDArray[np.uint8] | None
    depth: NDArray[np.float32]
    normal: NDArray[np.float32]
    body: NDArray[np.int32]
    mover: NDArray[np.int32]


class WorldRenderer:
    """Renders a fixed number of worlds of one kind of scene.

    Args:
        parts: Meshes of the scene.
        n_bodies: Number of bodies that `Part.body` refers to.
        worlds: Number of worlds W.
        size: Width and height [px].
        device: cpu or cuda:N.
        sun: Azimuth of the viewer that the sun of a plain sky stands behind [rad]; None leaves it.
        surroundings: Sky, ground and what dresses the place; None for neither.
        seed: Of the clouds.
    """

    def __init__(
        self,
        parts: Sequence[Part],
        n_bodies: int,
        worlds: int,
        size: tuple[int, int],
        *,
        device: str = "cpu",
        sun: float | None = None,
        surroundings: Surroundings | None = None,
        seed: int = 0,
    ) -> None:
        self.worlds, self.size, self._device = worlds, size, device
        dressing = surroundings.parts if surroundings else ()
        self._stage = Stage(
            [*parts, *dressing], n_bodies, worlds, surroundings, device=device, seed=seed
        )
        self._plain = surroundings is None or surroundings.sky.kind == "plain"
        self._images: dict[tuple[int, int], dict[str, Any]] = {}
        self._held: dict[tuple[int, int], dict[str, Any]] = {}
        self._last = size
        # Of the kernels' owners, -3 are meshes of the world, -2 nothing and -1 the ground plane.
        rest = [GROUND, NOTHING, GROUND]
        self._body = np.array([*self.movers.bodies, *rest], np.int32)
        self._mover = np.array([*range(len(self.movers)), *rest], np.int32)
        if sun is not None:
            self.light(sun)

    def twin(self) -> WorldRenderer:
        """A renderer of the same scene that draws beside this one, in poses of its own."""
        other = copy.copy(self)
        other._stage, other._images, other._held = self._stage.twin(), {}, {}
        return other

    @property
    def movers(self) -> Movers:
        """What has a pose of its own."""
        return self._stage.movers

    def light(self, azimuth: float) -> None:
        """Puts the sun of a plain sky behind the viewer's right shoulder, to light what one sees.

        Args:
            azimuth: Direction from the scene to the viewer, counter-clockwise from +X [rad].
        """
        if self._plain:
            self._stage.turn_sun(sun_behind(azimuth))

    def pose(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None = None
    ) -> None:
        """Moves all bodies.

        Args:
            position: Body origins [m], shape [W, B, 3].
            quaternion: (x, y, z, w), shape [W, B, 4].
            angles: Of the wheels of a scene [rad], shape [W, wheels].
        """
        self._stage.pose(position, quaternion, angles)

    def draw(
        self,
        cameras: Sequence[Camera],
        *,
        rgb: bool = True,
        size: tuple[int, int] | None = None,
        samples: int = SAMPLES,
        instant: tuple[int, int] = (0, 1),
    ) -> None:
        """Draws one view a world; the pictures stay on the device until `read`.

        Depth, normals and bodies come from the ray through each pixel's centre.

        Args:
            cameras: One a world.
            rgb: Draw colours, too.
            size: Width and height [px]; default those of the renderer.
            samples: Rays a pixel where surfaces meet.
            instant: Which of how many instants this is, whose colours are averaged.
        """
        wp, kernels, scene = self._stage.tools
        images = self._allocated(size or self.size)
        views: Any = np.zeros(self.worlds, kernels.View.numpy_dtype())
        views["pose"] = np.array([[*c.eye, *c.quaternion()] for c in cameras], np.float32)
        views["tangent"] = [math.tan(c.fov / 2) for c in cameras]
        shown = wp.array(views, dtype=kernels.View, device=self._device)
        dim = images["depth"].shape
        spots = (
            dim[0],
            -(-dim[1] // kernels.TILE_ROWS) * -(-dim[2] // kernels.TILE) * kernels.TILE_PX,
        )
        seen = [images[k] for k in SEEN]
        rays = (2 if samples >= SAMPLES else 1) if rgb else 0
        how: Any = {"device": self._device, "block_dim": kernels.THREADS}
        wp.launch(kernels.look, spots, inputs=[scene, shown, rays, *seen], **how)
        if rgb:
            edges = [images["edge"], images["is_edge"]]
            k, count = instant
            images["is_edge"].zero_()
            if samples > 1:
                listed = [images["edges"], images["count"]]
                images["count"].zero_()
                surfaces = [images[k] for k in SURFACES]
                inputs = [*surfaces, images["is_edge"], *listed]
                wp.launch(kernels.outline, spots, inputs=inputs, **how)
                inputs = [scene, shown, samples, *seen, images["edge"], *listed]
                wp.launch(kernels.refine, math.prod(dim), inputs=inputs, **how)
            light = [int(k == 0), 1.0 / count, images["radiance"], images["packed"]]
            inputs = [scene, *seen, *edges, *light]
            wp.launch(kernels.develop, dim, inputs=inputs, **how)

    def read(self, *, rgb: bool = True) -> Views:
        """The pictures of the last `draw`, as copies."""
        owner, depth, normal, *colors = self._fetched(
            ["mover", "depth", "normal", *(["packed"] if rgb else [])]
        )
        color = None
        if colors:
            packed = colors[0].astype("<u4", copy=False)
            color = packed.view(np.uint8).reshape(*owner.shape, 4)[..., :3].copy()
        return Views(
            rgb=color,
            depth=depth.copy(),
            normal=normal.reshape(*owner.shape, 3).copy(),
            body=self._body[owner],
            mover=self._mover[owner],
        )

    def _fetched(self, names: Sequence[str]) -> list[NDArray[Any]]:
        """Pictures of the last `draw`, good until the next.

        Those of a GPU come by way of page-locked memory that is kept: into fresh memory a copy
        waits for its pages, and takes several times as long.
        """
        images = self._images[self._last]
        if self._device != "cpu":
            wp = self._stage.tools[0]
            held = self._held.setdefault(self._last, {})
            for name in names:
                if name not in held:
                    held[name] = wp.empty_like(images[name], device="cpu", pinned=True)
                wp.copy(held[name], images[name])
            wp.synchronize_device(self._device)
            images = held
        return [images[name].numpy() for name in names]

    def _allocated(self, size: tuple[int, int]) -> dict[str, Any]:
        """Pictures of a size, made once."""
        self._last = size
        if size not in self._images:
            wp = self._stage.tools[0]
            types = dict.fromkeys((*SEEN, "edge", "radiance"), wp.vec3) | {
                "depth": wp.float32,
                "mover": wp.int32,
                "paint": wp.int32,
                "is_edge": wp.int32,
                "packed": wp.uint32,
            }
            shape = (self.worlds, size[1], size[0])
            self._images[size] = {
                name: wp.zeros(shape, dtype=kind, device=self._device)
                for name, kind in types.items()
            }
            self._images[size]["edges"] = wp.empty(
                math.prod(shape), dtype=wp.vec3i, device=self._device
            )
            self._images[size]["count"] = wp.zeros(1, dtype=wp.int32, device=self._device)
        return self._images[size]
