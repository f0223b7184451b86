"""What breaks, into which bodies, and who of them is there.

A body with a `break_impulse` has `fragments`: other bodies of the scene, which together are as
heavy as it, have the same centre of mass and, turning with it, the same inertia. Until it breaks
they are not there (no engine moves them, nothing touches them); recordings have them where they
ride in it. From then on it is not there itself; recordings have it where it broke, at rest.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.breaking.stances import absent, stances
from esg.engines.joints import Floats
from esg.engines.scene import FRAGMENT, Body, Rollout, SimScene
from esg.units import quat_inverse, quat_multiply, quat_rotate

PARTED_M = 1e-4
"""A fragment that is so far from its place in the whole has left it: half of what gravity does to
what is at rest within a step of 1/240 s."""

HIDDEN_M = 20.0
"""What is not there is drawn so far below its place."""
PARKED_M = 1000.0
"""Where engines that cannot take bodies out keep them, and higher [m]."""


@dataclass(frozen=True)
class Brittle:
    """A body that breaks, with its fragments by index.

    Args:
        whole: The body.
        pieces: Its fragments.
        impulse: That it takes at most within `BREAK_WINDOW_S` [N s].
        local: Centres of the fragments in its frame [m], shape [n, 3].
        turn: Their orientations there (x, y, z, w), shape [n, 4].
    """

    whole: int
    pieces: tuple[int, ...]
    impulse: float
    local: Floats
    turn: Floats


def brittle(scene: SimScene) -> tuple[Brittle, ...]:
    """What of a scene breaks, in the order of its bodies."""
    if not any(b.fragments for b in scene.bodies):
        return ()
    index = {name: i for i, name in enumerate(scene.names)}
    out: list[Brittle] = []
    for i, body in enumerate(scene.bodies):
        if not body.fragments or body.break_impulse is None:
            continue
        pieces = tuple(index[name] for name in body.fragments)
        back = quat_inverse(np.asarray(body.quaternion, float))
        at = np.array([scene.bodies[k].position for k in pieces]) - np.asarray(body.position)
        turns = np.array([scene.bodies[k].quaternion for k in pieces])
        local, turn = quat_rotate(back, at), quat_multiply(back, turns)
        out.append(Brittle(i, pieces, body.break_impulse, local, turn))
    return tuple(out)


def whole_of_fragments(scene: SimScene) -> dict[str, Body]:
    """What broke, by the name of each of its fragments."""
    return {name: body for body in scene.bodies for name in body.fragments}


def unbroken(scene: SimScene) -> SimScene:
    """The scene without fragments and postures: what breaks stays whole, who lies down stands."""
    if not brittle(scene) and not stances(scene):
        return scene
    whole = (replace(b, fragments=(), postures=()) for b in scene.bodies if b.category != FRAGMENT)
    return scene.with_bodies(tuple(whole))


def rigid(
    b: Brittle, position: Any, quaternion: Any, linear: Any, angular: Any
) -> tuple[Floats, Floats, Floats, Floats]:
    """Where its fragments are and how they move as parts of the whole, each [..., n, 3 or 4].

    Args:
        b: What breaks.
        position, quaternion, linear, angular: Of the whole, shape [..., 3 or 4].
    """
    p, q, v, w = (
        np.asarray(a, float)[..., None, :] for a in (position, quaternion, linear, angular)
    )
    arm = quat_rotate(q, b.local)
    spin = np.broadcast_to(w, arm.shape).copy()
    return p + arm, quat_multiply(q, b.turn), v + np.cross(w, arm), spin


def hidden(scene: SimScene, position: Any, quaternion: Any) -> NDArray[np.bool_]:
    """Who is not there in which frame of a recording: fragments before, wholes after.

    Args:
        scene: B bodies.
        position, quaternion: Of a recording, shape [..., T, B, 3 or 4].

    Returns:
        Shape [..., T, B].
    """
    out = absent(scene, position, quaternion)
    for b in brittle(scene):
        broken = broken_frames(b, position, quaternion)
        out[..., b.whole] = broken
        out[..., list(b.pieces)] = ~broken[..., None]
    return out


def shown(scene: SimScene, rollout: Rollout) -> Rollout:
    """A recording for drawing: what is not there lies below the ground."""
    if not brittle(scene) and not stances(scene):
        return rollout
    position = rollout.position.copy()
    position[..., 2] -= HIDDEN_M * hidden(scene, rollout.position, rollout.quaternion)
    return replace(rollout, position=position)


def broken_frames(b: Brittle, position: Any, quaternion: Any) -> NDArray[np.bool_]:
    """Frames at which something is broken: once a fragment has left it, shape [..., T]."""
    at, turn = (np.asarray(a, float)[..., b.whole, :] for a in (position, quaternion))
    there = rigid(b, at, turn, np.zeros_like(at), np.zeros_like(at))[0]
    pieces = np.asarray(position, float)[..., list(b.pieces), :]
    left = (np.linalg.norm(pieces - there, axis=-1) > PARTED_M).any(axis=-1)
    return np.logical_or.accumulate(left, axis=-1)


def ride(scene: SimScene, states: tuple[Any, Any, Any, Any], frames: Any) -> None:
    """Writes fragments into a recording as parts of their wholes, in place.

    Args:
        scene: B bodies.
        states: Positions, quaternions and both velocities, shape [W, T, B, 3 or 4].
        frames: Mask or slice of the worlds and frames to write, for `[W, T]`.
    """
    for b in brittle(scene):
        _ride(b, states, frames)


def _ride(b: Brittle, states: tuple[Any, Any, Any, Any], frames: Any) -> None:
    whole = [a[..., b.whole, :][frames] for a in states]
    for target, values in zip(states, rigid(b, *whole), strict=True):
        for n, piece in enumerate(b.pieces):
            column = target[..., piece, :]
            column[frames] = values[..., n, :]


def unpark(scene: SimScene, states: tuple[Any, Any, Any, Any]) -> None:
    """Writes into a recording where what was parked is, in place.

    Args:
        scene: B bodies.
        states: Positions, quaternions and both velocities, shape [W, T, B, 3 or 4], from frame 0.
    """
    position, quaternion = states[:2]
    for b in brittle(scene):
        first = b.pieces[0]
        gone = position[..., first, 2] < 0.5 * PARKED_M
        gone[:, 0] = False
        for w in np.flatnonzero(gone.any(axis=1)) if not scene.bodies[b.whole].static else ():
            k = int(gone[w].argmax())
            turn = quat_multiply(quaternion[w, k, first].astype(float), quat_inverse(b.turn[0]))
            # The frame before shows the whole; where it broke is where its first fragment began.
            position[w, k, b.whole] = position[w, k, first] - quat_rotate(turn, b.local[0])
            quaternion[w, k, b.whole] = turn
        settle(b, states, gone)


def settle(b: Brittle, states: tuple[Any, Any, Any, Any], gone: NDArray[np.bool_]) -> None:
    """Lets a whole stay where it broke and fragments ride in it before, in a recording, in place.

    Args:
        b: What breaks.
        states: Positions, quaternions and both velocities, shape [W, T, B, 3 or 4].
        gone: Frames at which it is broken, the last ones of each world, shape [W, T].
    """
    position, quaternion, linear, angular = states
    for w in np.flatnonzero(gone.any(axis=1)):
        k = int(gone[w].argmax())
        for target in (position, quaternion):
            target[w, k:, b.whole] = target[w, k, b.whole]
        linear[w, k:, b.whole] = angular[w, k:, b.whole] = 0.0
    _ride(b, states, ~gone)
