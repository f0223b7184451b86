"""Ray-traced stills of a scene's real meshes on the CPU (Newton's camera sensor)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.view.camera import Camera
from esg.view.pieces import Movers, Part, Turning

SKY = (205, 219, 235)
"""RGB of everything the rays miss."""
SAMPLES = 4
"""Rays a pixel. What they hit is shaded once a pixel and surface (MSAA)."""


def merged(parts: Sequence[Part]) -> list[Part]:
    """The same picture from fewer meshes: those of one body and colour become one.

    Every mesh costs the tracer a search of its own; a car of forty pieces in six colours is six.
    """
    groups: dict[tuple[int, Turning | None, tuple[float, float, float]], list[Part]] = {}
    for part in parts:
        groups.setdefault((part.body, part.wheel, part.color), []).append(part)
    out: list[Part] = []
    for (body, wheel, color), members in groups.items():
        starts = np.cumsum([0, *(len(m.vertices) for m in members[:-1])])
        faces = [m.faces + start for m, start in zip(members, starts, strict=True)]
        vertices = np.concatenate([m.vertices for m in members])
        out.append(Part(body, vertices, np.concatenate(faces), color, wheel))
    return out


_kernels: dict[Any, Any] = {}


def share_kernels(sensor: Any) -> None:
    """Lets all cameras of this process use one set of kernels.

    A kernel depends on what is rendered, not on the scene; each camera generates its own, which
    takes a third of a second.

    Args:
        sensor: A `newton.sensors.SensorCamera`; of one that keeps its kernels elsewhere, nothing
            is shared.
    """
    context: Any = getattr(sensor, "_render_context", None)
    if isinstance(getattr(context, "_kernel_cache", None), dict):
        context._kernel_cache = _kernels


class Renderer:
    """Renders one set of parts in many poses from many cameras.

    Args:
        parts: Meshes.
        n_bodies: Number of bodies that `Part.body` refers to.
        width, height: Of the picture [px].
    """

    def __init__(self, parts: list[Part], n_bodies: int, width: int, height: int) -> None:
        from esg.engines.newton import quiet_warp

        wp = quiet_warp()
        import newton
        from newton.sensors import SensorCamera

        self.width, self.height = width, height
        self._wp = wp
        parts = merged(parts)
        builder = newton.ModelBuilder(gravity=(0.0, 0.0, 0.0))
        inertia = wp.mat33(np.eye(3).flatten())
        self._movers = Movers(parts, n_bodies)
        for _ in range(len(self._movers)):
            builder.add_body(mass=1.0, inertia=inertia, lock_inertia=True)
        for part in parts:
            mesh = newton.Mesh(
                np.ascontiguousarray(part.vertices, np.float32),
                np.ascontiguousarray(part.faces, np.int32).reshape(-1),
                compute_inertia=False,
            )
            builder.add_shape_mesh(self._movers.of(part), mesh=mesh, color=part.color)
        self._model = builder.finalize(device="cpu")
        self._state = self._model.state()
        self._part_bodies = np.array([p.body for p in parts])
        config = SensorCamera.RenderConfig(
            enable_shadows=True, anti_aliasing=SensorCamera.AntiAliasing.MSAA
        )
        probe = SensorCamera.RenderConfig()
        red, green, blue = SKY
        self._clear = SensorCamera.ClearData(clear_color=red | green << 8 | blue << 16)
        self._config, self._probe_config = config, probe
        self._camera: Any = SensorCamera(self._model, default_render_config=config)
        share_kernels(self._camera)
        self.light(math.radians(90))
        self._camera.set_ambient_light((0.34, 0.36, 0.4), (0.16, 0.15, 0.14))
        self._rays: dict[tuple[int, int, float, int], Any] = {}

    def light(self, azimuth: float) -> None:
        """Puts the sun behind the viewer's right shoulder, so that what one sees is lit.

        Args:
            azimuth: Direction from the scene to the viewer, counter-clockwise from +X [rad].
        """
        toward = azimuth - math.radians(42)
        direction = np.array([-0.67 * math.cos(toward), -0.67 * math.sin(toward), -0.9])
        self._camera.create_default_light(
            enable_shadows=True,
            direction=self._wp.vec3f(*(direction / np.linalg.norm(direction))),
            color=(0.8, 0.78, 0.74),
        )

    def pose(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None = None
    ) -> None:
        """Moves the bodies.

        Args:
            position: Body origins [m], shape [B, 3].
            quaternion: (x, y, z, w), shape [B, 4].
            angles: Of the scene's wheels [rad], shape [W].
        """
        moved = self._movers.poses(position, quaternion, angles)
        poses = np.concatenate(moved, axis=1).astype(np.float32)
        if self._state.body_q is not None:  # as it is without bodies
            self._state.body_q.assign(poses)
        self._model.bvh_refit_shapes(self._state)

    def color(
        self, camera: Camera, size: tuple[int, int] | None = None, samples: int = SAMPLES
    ) -> NDArray[np.uint8]:
        """The picture from `camera`, shape [height, width, 3].

        Args:
            camera: Where to look from.
            size: Width and height [px]; default those of the renderer.
            samples: Rays a pixel.
        """
        width, height = size or (self.width, self.height)
        image = self._camera.allocate_image_color(1, width, height)
        self._camera.update(
            self._state,
            self._transform(camera),
            self._ray_bundle(width, height, camera.fov, samples),
            color_image=image,
            clear_data=self._clear,
        )
        packed = image.numpy().reshape(height, width)
        return np.stack([packed & 255, packed >> 8 & 255, packed >> 16 & 255], -1).astype(np.uint8)

    def visible(self, camera: Camera, bodies: Iterable[int], width: int = 96) -> dict[int, int]:
        """How many pixels of a small picture each body covers.

        Args:
            camera: Where to look from.
            bodies: Body indices to count.
            width: Of the small picture [px].
        """
        height = max(1, round(width * self.height / self.width))
        image = self._camera.allocate_image_shape_index(1, width, height)
        self._camera.update(
            self._state,
            self._transform(camera),
            self._ray_bundle(width, height, camera.fov, 1),
            shape_index_image=image,
            render_config=self._probe_config,
        )
        index = image.numpy().reshape(-1).astype(np.int64)
        index = index[index < len(self._part_bodies)]
        seen = self._part_bodies[index]
        return {b: int((seen == b).sum()) for b in bodies}

    def _transform(self, camera: Camera) -> Any:
        wp = self._wp
        pose = wp.transform(wp.vec3(*camera.eye), wp.quat(*camera.quaternion()))
        return wp.array([pose], dtype=wp.transformf, device="cpu")

    def _ray_bundle(self, width: int, height: int, fov: float, samples: int) -> Any:
        from newton.sensors import SensorCamera

        key = (width, height, fov, samples)
        if key not in self._rays:
            self._rays[key] = SensorCamera.compute_camera_rays_pinhole(
                width, height, camera_fov=fov, device="cpu", sample_count=samples
            )
        return self._rays[key]
