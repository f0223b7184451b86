"""What lies on the ground and collides with nothing: roads, markings, the ground itself."""

from __future__ import annotations

from collections.abc import Collection
import math

from esg.engines.scene import Body, SimScene

GROUND_HALF_EXTENT_M = 45.0
"""A surface without collision at least this wide is the ground."""
LAYER_M = 0.004
"""Height of a decal above what it lies on: more than depth resolves."""
JUNCTIONS = ("crossroad", "crossroads")
"""Categories of what lies over the roads that lead to it, whose lines end there."""
ROAD_M = 8.0
"""Width of the roads of a junction, which is as large as where they cross."""


def is_ground(body: Body) -> bool:
    """Whether a body is the ground itself, which is drawn as an endless plane."""
    return not body.collides and max(body.half_extents[:2]) > GROUND_HALF_EXTENT_M


def drawn_lifts(scene: SimScene, covered: Collection[str] = ()) -> dict[int, float]:
    """How much higher than it stands each decal is drawn [m], by the index of its body.

    Roads and markings lie on the ground, the smaller on the larger; of a junction counts where its
    roads cross, not how far its arms reach. Their thickness goes into the ground, or what stands at
    z = 0 would be sunk in them.

    Args:
        scene: The bodies.
        covered: Names of those that are not drawn.
    """
    decals = [
        (_area(b), index)
        for index, b in enumerate(scene.bodies)
        if not b.collides and b.name not in covered
    ]
    return {
        index: LAYER_M * layer - 2 * scene.bodies[index].half_extents[2]
        for layer, (_, index) in enumerate(sorted(decals, key=lambda d: -d[0]), 1)
    }


def _area(body: Body) -> float:
    sides = (2 * half for half in body.half_extents[:2])
    if body.category in JUNCTIONS:
        sides = (min(ROAD_M, side) for side in sides)
    return math.prod(sides)
