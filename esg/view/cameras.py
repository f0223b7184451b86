"""Fixed cameras that see a whole scene's action."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from esg.engines.scene import Rollout, SimScene
from esg.view.camera import Camera, frame_points

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument
    from esg.metrics.models import SceneVerdict

TURNS_DEG = (0, 45, -45, 90, -90, 180, 135, -135)
"""Azimuths of the cameras, from the side of the motion that faces the viewer."""
ELEVATIONS_DEG = (24, 34, 34, 44, 44, 24, 34, 34)
_STEPS = 12


def action_cameras(
    scene: SimScene,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    doc: EsgDocument,
    count: int,
    aspect: float,
) -> list[Camera]:
    """Cameras around the action that stand still and keep all of it in view.

    Args:
        scene: The bodies.
        rollout: Their motion.
        verdict: Events, whose participants are kept in view.
        doc: Relations, for what the participants stand on.
        count: At most eight.
        aspect: Width over height of the pictures.
    """
    from esg.view.framing import action_points, facing_side

    points = action_points(scene, rollout, verdict, doc, _STEPS)
    side = facing_side(scene, rollout, verdict, doc)
    return [
        frame_points(points, side + math.radians(turn), math.radians(elevation), aspect)
        for turn, elevation in list(zip(TURNS_DEG, ELEVATIONS_DEG, strict=True))[:count]
    ]
