"""The fast renderer: one ray tracer for previews, ground truth and many worlds at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from esg.view.camera import Camera
from esg.view.renderers.records import Kind, Poses, Quality, Scenery
from esg.view.worlds import SAMPLES, Views, WorldRenderer

BATCH = 24
"""Frames drawn in one launch."""


class Raster:
    """Draws batches of frames; see `Drawer`.

    Args:
        scenery: What there is.
        quality: How to draw it.
    """

    def __init__(self, scenery: Scenery, quality: Quality) -> None:
        self._scenery, self._quality = scenery, quality
        self._worlds: WorldRenderer | None = None

    def draw(self, poses: Poses, cameras: Sequence[Camera]) -> Views:
        """Pictures of F frames; light of the instants of a frame is averaged."""
        count, instants = poses.position.shape[:2]
        if self._worlds is None or self._worlds.worlds < count:
            self._worlds = self._made(count)
        worlds = self._worlds
        # A last batch that is not full draws its last frame several times.
        filled = np.minimum(np.arange(worlds.worlds), count - 1)
        shown = [cameras[k] for k in filled]
        exact: Views | None = None
        rgb = None
        for s in range(instants):
            angles = None if poses.angles is None else poses.angles[filled, s]
            worlds.pose(poses.position[filled, s], poses.quaternion[filled, s], angles)
            worlds.draw(
                shown,
                rgb=self._quality.color,
                samples=self._quality.samples or SAMPLES,
                instant=(s, instants),
            )
            views = worlds.read(rgb=self._quality.color)
            exact = views if s == instants // 2 else exact
            rgb = views.rgb
        assert exact is not None
        return Views(
            None if rgb is None else rgb[:count],
            exact.depth[:count],
            exact.normal[:count],
            exact.body[:count],
            exact.mover[:count],
        )

    def _made(self, worlds: int) -> WorldRenderer:
        s, q = self._scenery, self._quality
        return WorldRenderer(
            s.parts,
            s.n_bodies,
            worlds,
            q.size,
            device=q.device,
            surroundings=s.surroundings,
            seed=q.seed,
        )


def _version() -> str:
    from importlib.metadata import version

    return f"warp {version('warp-lang')}"


KIND = Kind("raster", SAMPLES, Raster, _version, BATCH)
