"""How a scene is shown where its prompt says how it is filmed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from esg.engines.scene import Rollout, SimScene
from esg.filming.ways import way_of
from esg.graph.filming import RATES, Shot, shot_of
from esg.graph.models import Filming, Predicate
from esg.metrics.binding import bind
from esg.metrics.statements.filmed import SIDES, VIEWERS
from esg.view.director.takes import Take

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument

KIND = "as_said"
"""Kind of a take that the prompt tells."""


def said_shot(doc: EsgDocument, scene: SimScene) -> Shot | None:
    """What the prompt says of the camera; None if nothing.

    Args:
        doc: The document.
        scene: Its bodies.
    """
    statements = doc.statements or ()
    told: list[tuple[Filming, tuple[int, ...]]] = [
        (s.filming, bind("=" + ",".join(s.object), scene).bodies if s.object else ())
        for s in statements
        if s.predicate is Predicate.FILMED and s.filming is not None
    ]
    sided = any(s.direction in VIEWERS or s.predicate in SIDES for s in statements)
    return shot_of(told, sided=sided)


def said_rate(doc: EsgDocument) -> float:
    """Seconds of the scene in a second of film, by the prompt."""
    words = [s.filming for s in doc.statements or () if s.filming is not None]
    return next((RATES[word] for word in words if word in RATES), 1.0)


def said_take(doc: EsgDocument, scene: SimScene, rollout: Rollout, aspect: float) -> Take | None:
    """The take of the whole replay that the prompt tells; None if it leaves the camera open.

    Args:
        doc: The document.
        scene: Its bodies.
        rollout: Their motion; its first world.
        aspect: Width over height of the pictures.
    """
    shot = said_shot(doc, scene)
    if shot is None or shot.open or not scene.bodies:
        return None
    time = np.asarray(rollout.time, float)
    way = way_of(shot, scene, time, rollout.position[0], rollout.quaternion[0], aspect)
    return None if way is None else Take(KIND, way.time_s, way.eye, way.target, way.fov)
