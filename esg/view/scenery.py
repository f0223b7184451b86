"""Everything that can be seen of a replayed scene, for any renderer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
import math

import numpy as np

from esg.engines.scene import Rollout, SimScene
from esg.graph.models import EsgDocument
from esg.view.camera import Camera
from esg.view.parts import body_parts
from esg.view.renderers.records import Scenery
from esg.view.skies import sun_behind
from esg.view.surroundings import surroundings_of

INSTANTS = 8
"""Instants of the motion at which nothing may stand between a camera and what moves."""


def scenery_of(scene: SimScene, rollout: Rollout, doc: EsgDocument) -> Scenery:
    """Meshes of the bodies and what surrounds them.

    Args:
        scene: The bodies.
        rollout: Their motion.
        doc: Asset configurations (meshes) and dressing.
    """
    around = surroundings_of(doc, scene, rollout)
    return Scenery(tuple(body_parts(scene, doc)), len(scene.bodies), around)


def seen_from(
    whole: Scenery, cameras: Sequence[Camera], scene: SimScene, rollout: Rollout
) -> Scenery:
    """Without what stands between cameras and the action; a plain sky's sun behind the first.

    Args:
        whole: Everything.
        cameras: At least one.
        scene: The bodies.
        rollout: Their motion.
    """
    around = whole.surroundings
    if around is None:
        return whole
    first = cameras[0]
    if around.sky.kind == "plain":
        azimuth = math.atan2(first.eye[1] - first.target[1], first.eye[0] - first.target[0])
        around = replace(around, sky=replace(around.sky, sun=sun_behind(azimuth)))
    movers = [k for k, b in enumerate(scene.bodies) if not b.static]
    frames = np.linspace(0, len(rollout.time) - 1, INSTANTS).astype(int)
    points = rollout.position[0][frames][:, movers].reshape(-1, 3).astype(float)
    points = points[np.isfinite(points).all(axis=1)]
    targets = np.array([c.target for c in cameras], float)
    eyes = np.array([c.eye for c in cameras], float)
    return replace(whole, surroundings=around.seen_from(eyes, np.concatenate([points, targets])))
