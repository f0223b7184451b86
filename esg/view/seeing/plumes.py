"""Meshes of smoke, steam, dust and sparks: every puff in two sizes, one after the other."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Look
from esg.filming.plumes import Puff, puffs, row_of
from esg.view.pieces import Act, Part

if TYPE_CHECKING:
    from esg.engines.scene import Rollout, SimScene
    from esg.lexicon.plumes import Plume

STAGES = 2
"""Sizes in which a puff is drawn: it grows and thins."""
LONG_S = 1e4
"""Period of what goes on in one direction as long as it is there [s]."""
BALLS = 4
"""Of which a puff is made."""
SHARDS = 10
"""Of which a shower of sparks is."""


def plume_parts(
    scene: SimScene, rollout: Rollout, events: Mapping[str, float | None]
) -> list[Part]:
    """What all bodies give off, in the world.

    Args:
        scene: The bodies.
        rollout: Their motion.
        events: Times of the events [s].
    """
    out: list[Part] = []
    time = np.asarray(rollout.time, float)
    for index, body in enumerate(scene.bodies):
        for gives in body.gives_off:
            row = row_of(gives)
            way = (
                rollout.position[0, :, index].astype(float),
                rollout.quaternion[0, :, index].astype(float),
            )
            for k, puff in enumerate(puffs(gives, body, time, *way, events)):
                out += _drawn(row, puff, k)
    return out


def _drawn(row: Plume, puff: Puff, k: int) -> list[Part]:
    shape, normals, faces = _cloud(k) if row.glow < 1.0 else _shards(k)
    out: list[Part] = []
    for stage in range(STAGES):
        share = (stage + 0.5) / STAGES
        radius = puff.first + (puff.last - puff.first) * share
        begins, ends = (
            puff.begins + (puff.ends - puff.begins) * (stage + d) / STAGES for d in (0, 1)
        )
        alpha = 1.0 if row.glow >= 1.0 else row.alpha * (1.0 - 0.5 * share)
        look = Look("", row.color, 1.0, alpha=alpha, glow=row.glow)
        velocity = np.asarray(puff.velocity)
        start = np.asarray(puff.at) - puff.begins * velocity
        out.append(
            Part(
                -1,
                radius * shape + start,
                faces,
                row.color,
                None,
                look,
                normals,
                name=f"plume/{row.name}",
                act=Act(there=((begins, ends),), period_s=LONG_S, drift=puff.velocity),
            )
        )
    return out


_Balls = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.int64]]
"""Corners, their normals, and faces."""


def _cloud(k: int) -> _Balls:
    """A cloud of balls about the origin, of radius 1."""
    rng = np.random.default_rng([17, k])
    radii = rng.uniform(0.4, 0.65, BALLS)
    return _balls(radii, rng.uniform(-0.6, 0.6, (BALLS, 3)), 1)


def _shards(k: int) -> _Balls:
    """Small bright pieces apart from each other."""
    rng = np.random.default_rng([19, k])
    return _balls(rng.uniform(0.3, 0.7, SHARDS), rng.uniform(-4.0, 4.0, (SHARDS, 3)), 0)


def _balls(radii: NDArray[np.float64], at: NDArray[np.float64], fine: int) -> _Balls:
    import trimesh

    ball = trimesh.creation.icosphere(subdivisions=fine)
    normals = np.asarray(ball.vertices, float)
    vertices = np.concatenate([r * normals + p for r, p in zip(radii, at, strict=True)])
    count = len(normals) * np.arange(len(radii))[:, None, None]
    faces = (np.asarray(ball.faces)[None] + count).reshape(-1, 3)
    return vertices, np.tile(normals, (len(radii), 1)), faces
