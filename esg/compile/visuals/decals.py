"""What lies on the ground and collides with nothing: roads, markings, the ground itself."""

from __future__ import annotations

from collections.abc import Collection

from esg.engines.scene import Body, SimScene

GROUND_HALF_EXTENT_M = 45.0
"""A surface without collision at least this wide is the ground."""
LAYER_M = 0.004
"""Height of a decal above what it lies on: more than depth resolves."""


def is_ground(body: Body) -> bool:
    """Whether a body is the ground itself, which is drawn as an endless plane."""
    return not body.collides and max(body.half_extents[:2]) > GROUND_HALF_EXTENT_M


def drawn_lifts(scene: SimScene, covered: Collection[str] = ()) -> dict[int, float]:
    """How much higher than it stands each decal is drawn [m], by the index of its body.

    Roads and markings lie on the ground, the smaller on the larger. Their thickness goes into the
    ground, or what stands at z = 0 would be sunk in them.

    Args:
        scene: The bodies.
        covered: Names of those that are not drawn.
    """
    decals = [
        (4 * b.half_extents[0] * b.half_extents[1], index)
        for index, b in enumerate(scene.bodies)
        if not b.collides and b.name not in covered
    ]
    return {
        index: LAYER_M * layer - 2 * scene.bodies[index].half_extents[2]
        for layer, (_, index) in enumerate(sorted(decals, key=lambda d: -d[0]), 1)
    }
