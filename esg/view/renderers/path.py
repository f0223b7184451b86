"""The faithful renderer: Mitsuba's path tracer, denoised, with motion blur."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.outcomes import UserError
from esg.view.camera import Camera
from esg.view.pieces import Movers
from esg.view.renderers import mitsuba
from esg.view.renderers.finish import denoiser, finished, view_directions
from esg.view.renderers.groups import groups, moved
from esg.view.renderers.raster import Raster
from esg.view.renderers.records import Kind, Poses, Quality, Scenery, blank
from esg.view.worlds import Views

SAMPLES = 64
DEPTH = 6
PASS_RAYS = 1 << 23
"""Rays a pass: more fill the memory, fewer waste time between passes."""
BRIGHTEST = 12.0
"""Light of a pixel in a pass is cut here: a lone sample of the sun would not average out."""


class PathTracer:
    """Traces frames one by one; see `Drawer`.

    Args:
        scenery: What there is.
        quality: How to draw it.

    Raises:
        UserError: If Mitsuba or its denoiser is not installed.
    """

    def __init__(self, scenery: Scenery, quality: Quality) -> None:
        self._mi = mi = mitsuba.loaded(quality.device)
        denoise = denoiser()
        if denoise is None:
            raise UserError(f"--renderer path needs its denoiser: {mitsuba.INSTALL}")
        self._denoise = denoise
        self._scenery, self._quality = scenery, quality
        parts = scenery.everything
        self._movers = Movers(parts, scenery.n_bodies)
        self._groups = groups(parts, self._movers)
        ground = scenery.ground
        bsdfs = {g.look: mitsuba.material(mi, g.look) for g in self._groups}
        made: dict[str, Any] = {
            "type": "scene",
            **mitsuba.lamps(mi, scenery.sky, ground, quality.seed),
        }
        if ground is not None:
            made["ground"] = mitsuba.ground_plane(mi, ground)
        for k, group in enumerate(self._groups):
            made[f"part{k}"] = mitsuba.shape(mi, f"part{k}", group, bsdfs[group.look])
        self._scene = mi.load_dict(made)
        self._params = mi.traverse(self._scene)
        self._integrator = mi.load_dict(
            {
                "type": "aov",
                "aovs": "albedo:albedo,normal:sh_normal,distance:depth",
                "image": {"type": "path", "max_depth": DEPTH, "hide_emitters": True},
            }
        )
        self._exact = Raster(scenery, quality) if quality.exact else None

    def draw(self, poses: Poses, cameras: Sequence[Camera]) -> Views:
        """Pictures of F frames; instants of a frame share its samples."""
        frames = [self._frame(poses.part(k, k + 1), c) for k, c in enumerate(cameras)]
        rgb = np.stack(frames)
        if self._exact is not None:
            return replace(self._exact.draw(poses.middle(), cameras), rgb=rgb)
        return blank(rgb)

    def channels(self, poses: Poses, camera: Camera) -> dict[str, NDArray[np.float32]]:
        """Mean radiance, albedo, normal, distance and coverage of one frame, not denoised.

        Args:
            poses: Of one frame.
            camera: That looks.

        Returns:
            `color`, `albedo`, `normal` of shape [H, L, 3]; `distance` [m] and `alpha`, [H, L].
        """
        mi, quality = self._mi, self._quality
        width, height = quality.size
        wanted = quality.samples or SAMPLES
        instants = poses.position.shape[1]
        passes = max(instants, math.ceil(wanted * width * height / PASS_RAYS))
        each = max(1, round(wanted / passes))
        sensor = mitsuba.sensor(mi, camera, quality.size)
        total: Any = 0.0
        shown = -1
        for k in range(passes):
            instant = k * instants // passes
            if instant != shown:
                self._pose(poses, instant)
                shown = instant
            seed = (quality.seed * 7919 + k) & 0x7FFFFFFF
            image = mi.render(
                self._scene, sensor=sensor, integrator=self._integrator, spp=each, seed=seed
            )
            found = np.nan_to_num(np.array(image), posinf=0.0, neginf=0.0)
            found[..., :3] = np.minimum(found[..., :3], BRIGHTEST)
            total = total + found.astype(np.float64)
        mean = (total / passes).astype(np.float32)
        # Mitsuba's rays begin at the near plane.
        ahead = view_directions(camera, quality.size) @ -camera.axes[:, 2]
        distance = mean[..., 10] + mean[..., 3] * (mitsuba.NEAR_M / ahead).astype(np.float32)
        return {
            "color": mean[..., :3],
            "alpha": np.clip(mean[..., 3], 0, 1),
            "albedo": np.clip(mean[..., 4:7], 0, 1),
            "normal": mean[..., 7:10],
            "distance": distance,
        }

    def _pose(self, poses: Poses, instant: int) -> None:
        angles = None if poses.angles is None else poses.angles[0, instant]
        at, turn = self._movers.poses(
            poses.position[0, instant].astype(float), poses.quaternion[0, instant].astype(float),
            angles,
        )  # fmt: skip
        changed = False
        for k, group in enumerate(self._groups):
            if group.mover >= 0:
                vertices, normals = moved(group, at, turn)
                self._params[f"part{k}.vertex_positions"] = vertices.ravel()
                if normals is not None:
                    self._params[f"part{k}.vertex_normals"] = normals.ravel()
                changed = True
        if changed:
            self._params.update()

    def _frame(self, poses: Poses, camera: Camera) -> NDArray[np.uint8]:
        """One picture, shape [H, L, 3]."""
        seen = self.channels(poses, camera)
        # The sky is put behind what is clean already, as sharp as it is.
        clean = self._denoise(seen["color"], seen["albedo"], seen["normal"])
        sky, seed = self._scenery.sky, self._quality.seed
        return finished(clean, seen["alpha"], seen["distance"], sky, seed, camera)


def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return f"mitsuba {version('mitsuba')}, mitsuba-oidn {version('mitsuba-oidn')}"
    except PackageNotFoundError as error:
        raise UserError(f"--renderer path needs {error.name}: {mitsuba.INSTALL}") from None


KIND = Kind("path", SAMPLES, PathTracer, _version, batch=1)
