"""Everything that can be seen of a replayed scene, for any renderer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
import math

import numpy as np

from esg.engines.scene import Rollout, SimScene
from esg.graph.models import EsgDocument
from esg.view.camera import Camera
from esg.view.framing import corners_of
from esg.view.parts import body_parts
from esg.view.renderers.records import Scenery
from esg.view.ropes import rope_parts
from esg.view.seeing.limbs import with_limbs
from esg.view.seeing.shows import with_shows
from esg.view.skies import sun_behind
from esg.view.surroundings import GROUND, surroundings_of, thing_of

INSTANTS = 8
"""Instants of the motion at which nothing may stand between a camera and what moves."""
FLATTER = 0.1
"""Heights of what dresses the ground are multiplied with it: rays tell a tenth of a millimetre."""
MOST_MOVERS = 6
"""Of a crowd, the first are enough to tell what is in the way."""


def scenery_of(scene: SimScene, rollout: Rollout, doc: EsgDocument) -> Scenery:
    """Meshes of the bodies, of ropes and springs, and what surrounds them.

    Args:
        scene: The bodies.
        rollout: Their motion.
        doc: Asset configurations (meshes) and dressing.
    """
    around = surroundings_of(doc, scene, rollout)
    # What dresses the ground lies below the roads and floors that are bodies, some at z = 0.001.
    flat = np.array([1.0, 1.0, FLATTER])
    parts = tuple(
        replace(p, vertices=p.vertices * flat) if thing_of(p) == GROUND else p for p in around.parts
    )
    around = replace(around, parts=parts)
    bodies = with_limbs(body_parts(scene, doc), scene, rollout, doc)
    bodies = with_shows(bodies, scene, rollout, doc)
    bodies += rope_parts(scene, rollout)
    return Scenery(tuple(bodies), len(scene.bodies), around)


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
    movers = [k for k, b in enumerate(scene.bodies) if not b.static][:MOST_MOVERS]
    frames = np.linspace(0, len(rollout.time) - 1, INSTANTS).astype(int)
    corners = [corners_of(scene, rollout, int(f), k) for f in np.unique(frames) for k in movers]
    points = np.concatenate([np.array([c.target for c in cameras], float), *corners])
    seen = around.seen_from(cameras, points[np.isfinite(points).all(1)])
    return replace(whole, surroundings=seen)
