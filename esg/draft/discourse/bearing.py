"""What takes along what is on it: a cart, a trailer that is towed, a turntable, a swing."""

from __future__ import annotations

from collections.abc import Iterator

from esg.draft.discourse.scene import Scene
from esg.graph.models import NodeEvent, Role

_LEAVES = (NodeEvent.FALL, NodeEvent.JUMP, NodeEvent.TOPPLE)
"""Events after which something is not where it was carried."""
_PARTS = (NodeEvent.COLLISION, *_LEAVES)
"""Events that may throw off what is carried."""


def bearers(scene: Scene, node: str) -> Iterator[str]:
    """What a thing is on, what that is on, and so forth down to the ground."""
    seen, host = {node}, scene.supported_by.get(node)
    while host is not None and host not in seen:
        yield host
        seen.add(host)
        host = scene.supported_by.get(host)


def bears(scene: Scene, bearer: str) -> bool:
    """Whether something moves of its own accord, or is towed, and takes along what is on it."""
    track = scene.timeline.tracks.get(bearer)
    goes = track is not None and track.role is Role.ACTIVE
    launched = any(
        x.params.elevation_deg is not None for x in scene.timeline.edges if x.actor == bearer
    )
    return (goes and not launched) or bearer in scene.tows


def comes_off(scene: Scene, rider: str) -> bool:
    """Whether something leaves what it is on in the course of the scene."""
    return any(n.event in _LEAVES and rider in n.participants for n in scene.timeline.nodes)


def borne_until(scene: Scene, rider: str, bearer: str) -> str | None:
    """The first event that may part two; None if they stay together throughout."""
    both = {rider, bearer}
    told = scene.timeline.nodes
    return next((n.id for n in told if n.event in _PARTS and both & {*n.participants}), None)
