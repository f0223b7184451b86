"""The fast renderer: one ray tracer for previews, ground truth and many worlds at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from esg.view.camera import Camera
from esg.view.renderers.records import Kind, Poses, Quality, Scenery
from esg.view.worlds import Views, WorldRenderer

SAMPLES = 4
BATCH = 24


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
        """Pictures of F frames; instants of a frame are drawn one by one and averaged."""
        if self._worlds is None or self._worlds.worlds != len(poses):
            self._worlds = self._made(len(poses))
        worlds = self._worlds
        instants = poses.position.shape[1]
        middle = instants // 2
        total = np.zeros(0)
        exact = None
        for s in range(instants):
            angles = None if poses.angles is None else poses.angles[:, s]
            worlds.pose(poses.position[:, s], poses.quaternion[:, s], angles)
            worlds.draw(cameras)
            views = worlds.read()
            assert views.rgb is not None
            total = views.rgb.astype(np.float64) + (total if s else 0.0)
            exact = views if s == middle else exact
        assert exact is not None
        return replace(exact, rgb=np.rint(total / instants).astype(np.uint8))

    def _made(self, worlds: int) -> WorldRenderer:
        s, q = self._scenery, self._quality
        return WorldRenderer(s.everything, s.n_bodies, worlds, q.size, device=q.device)


def _version() -> str:
    from importlib.metadata import version

    return f"warp {version('warp-lang')}"


KIND = Kind("raster", SAMPLES, Raster, _version, BATCH)
