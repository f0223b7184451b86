"""Cameras that see a whole scene's action: fixed ones around it, and those of a director."""

from __future__ import annotations

from collections.abc import Sequence
import math
from typing import TYPE_CHECKING

from esg.engines.scene import Rollout, SimScene
from esg.view.camera import Camera, frame_points
from esg.view.director.review import Viewfinder
from esg.view.director.staging import azimuth_of, direct
from esg.view.director.takes import Take

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument
    from esg.metrics.models import SceneVerdict

TURNS_DEG = (0, 45, -45, 90, -90, 180, 135, -135)
"""Azimuths of the cameras, from the side of the motion that faces the viewer."""
ELEVATIONS_DEG = (24, 34, 34, 44, 44, 24, 34, 34)
_STEPS = 12
Takes = list[Take]


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


def directed(
    finder: Viewfinder, kinds: Sequence[str], count: int, seed: int, said: Take | None = None
) -> Takes:
    """Takes of the whole replay by the director, from places that are apart.

    Clips show it from its first picture to its last: who comes from afar is seen coming, and who
    goes on after the last event is followed.

    Args:
        finder: Of the scene.
        kinds: Kinds of camera to choose from for each.
        count: How many.
        seed: Of lenses, sides and angles.
        said: The first of them, where the prompt says how it is filmed.
    """
    start, stop = (float(finder.action.time[k]) for k in (0, -1))
    takes: Takes = [said] if said is not None else []
    for number in range(len(takes), count):
        apart = [azimuth_of(take) for take in takes]
        takes.append(direct(finder, start, stop, seed=seed + number, kinds=kinds, apart=apart))
    return takes
