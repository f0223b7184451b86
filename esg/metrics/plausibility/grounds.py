"""The ground that is drawn: floors, lawns and roads, and how far something is beyond them."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from esg.engines.scene import Floats, SimScene
from esg.metrics.plausibility.limits import limit
from esg.units import quat_rotate

ROADS = ("road", "crossroad", "crossroads", "lane", "parking_lot", "crossing", "crosswalk")
_FLAT_M = 0.05


def flats(scene: SimScene) -> list[int]:
    """Bodies that are only drawn, flat on the ground."""
    return [i for i, b in enumerate(scene.bodies) if not b.collides and b.half_extents[2] < _FLAT_M]


def beyond(scene: SimScene, position: Floats, among: Iterable[int]) -> Floats:
    """How far places are outside of all outlines [m], 0 within.

    Where nothing flat is drawn it is the plane of exports that ends.

    Args:
        scene: The scene.
        position: Of something over time [m], shape [T, 3].
        among: Flat bodies.

    Returns:
        Shape [T].
    """
    away: list[Floats] = []
    for k in among:
        b = scene.bodies[k]
        inverse = np.array(b.quaternion) * np.array([-1.0, -1.0, -1.0, 1.0])
        local = quat_rotate(inverse, position - np.array(b.position))[:, :2]
        over = np.abs(local - np.array(b.origin_offset[:2])) - np.array(b.half_extents[:2])
        away.append(np.linalg.norm(np.maximum(over, 0.0), axis=1))
    if not away:
        over = np.abs(position[:, :2]) - limit("drawn ground")
        return np.linalg.norm(np.maximum(over, 0.0), axis=1)
    return np.min(away, axis=0)
