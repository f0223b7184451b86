"""What cameras see, for many worlds at once: colour, depth, normals and which body it is.

All views of a batch are one launch of Newton's camera sensor, on the CPU or a GPU. A world is one
instant of one scene: the frames of a scene, or many scenes, fill a batch equally well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.view.camera import Camera
from esg.view.render import SAMPLES, SKY, Movers, Part, merged, share_kernels

NOTHING, GROUND = -2, -1
"""Body indices of pixels that hit nothing, and the ground."""


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
        sun: Azimuth of the viewer that the sun stands behind [rad].
    """

    def __init__(
        self,
        parts: Sequence[Part],
        n_bodies: int,
        worlds: int,
        size: tuple[int, int],
        *,
        device: str = "cpu",
        sun: float = math.pi / 2,
    ) -> None:
        from esg.engines.newton import quiet_warp

        wp = quiet_warp()
        import newton
        from newton.sensors import SensorCamera

        self.worlds, self.size, self._device, self._wp = worlds, size, device, wp
        self._n_bodies = n_bodies
        pieces = merged(parts)
        inertia = wp.mat33(np.eye(3).flatten())
        shapes = [
            newton.Mesh(
                np.ascontiguousarray(p.vertices, np.float32),
                np.ascontiguousarray(p.faces, np.int32).reshape(-1),
                compute_inertia=False,
            )
            for p in pieces
        ]
        one = newton.ModelBuilder(gravity=(0.0, 0.0, 0.0))
        self.movers = Movers(pieces, n_bodies)
        for _ in range(len(self.movers)):
            one.add_body(mass=1.0, inertia=inertia, lock_inertia=True)
        builder = newton.ModelBuilder(gravity=(0.0, 0.0, 0.0))
        for part, mesh in zip(pieces, shapes, strict=True):
            if part.body >= 0:
                one.add_shape_mesh(self.movers.of(part), mesh=mesh, color=part.color)
        for _ in range(worlds):
            builder.add_world(one)
        # What belongs to no body is the same in every world: it is there once.
        for part, mesh in zip(pieces, shapes, strict=True):
            if part.body < 0:
                builder.add_shape_mesh(-1, mesh=mesh, color=part.color)
        self._model = builder.finalize(device=device)
        self._state = self._model.state()
        owned = [p for p in pieces if p.body >= 0] * worlds
        rest = [*(GROUND for p in pieces if p.body < 0), NOTHING]
        self._owner = np.array([*(p.body for p in owned), *rest], np.int32)
        self._mover = np.array([*(self.movers.of(p) for p in owned), *rest], np.int32)
        self._plain = SensorCamera.RenderConfig()
        self._fine = SensorCamera.RenderConfig(
            enable_shadows=True, anti_aliasing=SensorCamera.AntiAliasing.MSAA
        )
        self._camera: Any = SensorCamera(self._model, default_render_config=self._fine)
        share_kernels(self._camera)
        toward = sun - math.radians(42)
        light = np.array([-0.67 * math.cos(toward), -0.67 * math.sin(toward), -0.9])
        self._camera.create_default_light(
            enable_shadows=True,
            direction=wp.vec3f(*(light / np.linalg.norm(light))),
            color=(0.8, 0.78, 0.74),
        )
        self._camera.set_ambient_light((0.34, 0.36, 0.4), (0.16, 0.15, 0.14))
        red, green, blue = SKY
        self._clear = SensorCamera.ClearData(clear_color=red | green << 8 | blue << 16)
        self._rays: dict[tuple[float, int], Any] = {}
        allocate = self._camera
        self._images = {
            "color": allocate.allocate_image_color(worlds, *size),
            "depth": allocate.allocate_image_depth_forward(worlds, *size),
            "normal": allocate.allocate_image_normal(worlds, *size),
            "shape": allocate.allocate_image_shape_index(worlds, *size),
        }

    def pose(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None = None
    ) -> None:
        """Moves all bodies.

        Args:
            position: Body origins [m], shape [W, B, 3].
            quaternion: (x, y, z, w), shape [W, B, 4].
            angles: Of the wheels of a scene [rad], shape [W, wheels].
        """
        moved = self.movers.poses(position, quaternion, angles)
        poses = np.concatenate(moved, axis=-1).reshape(-1, 7)
        if self._state.body_q is not None:  # as it is without bodies
            self._state.body_q.assign(np.ascontiguousarray(poses, np.float32))
        self._model.bvh_refit_shapes(self._state)

    def draw(self, cameras: Sequence[Camera], *, rgb: bool = True, exact: bool = True) -> None:
        """Draws one view a world; the pictures stay on the device until `read`.

        Args:
            cameras: One a world; all of one field of view.
            rgb: Draw colours.
            exact: Draw depth, normals and bodies, from the ray through each pixel's centre.
        """
        wp = self._wp
        poses = np.array([[*c.eye, *c.quaternion()] for c in cameras], np.float32)
        transforms = wp.array(poses, dtype=wp.transformf, device=self._device)
        fov = cameras[0].fov
        if exact:
            self._camera.update(
                self._state,
                transforms,
                self._bundle(fov, 1),
                forward_depth_image=self._images["depth"],
                normal_image=self._images["normal"],
                shape_index_image=self._images["shape"],
                render_config=self._plain,
            )
        if rgb:
            self._camera.update(
                self._state,
                transforms,
                self._bundle(fov, SAMPLES),
                color_image=self._images["color"],
                clear_data=self._clear,
            )

    def read(self, *, rgb: bool = True) -> Views:
        """The pictures of the last `draw`, as copies."""
        shape = self._images["shape"].numpy()
        shape = np.minimum(shape, len(self._owner) - 1).astype(np.int64)
        color = None
        if rgb:
            packed = self._images["color"].numpy()
            color = np.stack([packed & 255, packed >> 8 & 255, packed >> 16 & 255], -1)
            color = color.astype(np.uint8)
        return Views(
            rgb=color,
            depth=self._images["depth"].numpy().copy(),
            normal=self._images["normal"].numpy().reshape(*shape.shape, 3).copy(),
            body=self._owner[shape],
            mover=self._mover[shape],
        )

    def _bundle(self, fov: float, samples: int) -> Any:
        from newton.sensors import SensorCamera

        if (fov, samples) not in self._rays:
            self._rays[fov, samples] = SensorCamera.compute_camera_rays_pinhole(
                *self.size, camera_fov=fov, device=self._device, sample_count=samples
            )
        return self._rays[fov, samples]
