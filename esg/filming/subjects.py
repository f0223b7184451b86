"""What is filmed: its box, its middle and where it heads, at the instants of a plan."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
import itertools

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Body, SimScene
from esg.units import quat_rotate

Floats = NDArray[np.float64]

GONE_M = -100.0
"""What has broken, or is not yet there, is farther below the ground."""
STIRS_M = 0.02
"""What moves by less stands still."""
TRAVEL = 0.5
"""What travels by less than this part of its size has the heading of its own front."""
_CORNERS = np.array(list(itertools.product((-1, 1), (-1, 1), (0, 2))), float)


@dataclass(frozen=True)
class Poses:
    """Poses of all bodies at K instants.

    Args:
        scene: B bodies.
        time_s: Ascending [s], shape [K].
        position: Centres of mass [m], shape [K, B, 3].
        quaternion: (x, y, z, w), shape [K, B, 4].
    """

    scene: SimScene
    time_s: Floats
    position: Floats
    quaternion: Floats

    def corners(self, bodies: Sequence[int]) -> Floats:
        """Corners of their boxes [m], shape [K, n, 8, 3]."""
        rows = list(bodies)
        offsets = np.array([_local(self.scene.bodies[i]) for i in rows]).reshape(-1, 8, 3)
        turned = quat_rotate(
            np.repeat(self.quaternion[:, rows, None], 8, axis=2),
            np.repeat(offsets[None], len(self.time_s), axis=0),
        )
        return self.position[:, rows, None] + turned


def _local(body: Body) -> Floats:
    return _CORNERS * body.half_extents + np.asarray(body.origin_offset)


def poses_at(scene: SimScene, time: Floats, p: Floats, q: Floats, step_s: float) -> Poses:
    """Poses at equal steps from the first to the last instant of a recording.

    Args:
        scene: B bodies.
        time: Of the recording [s], shape [T].
        p: Centres of mass [m], shape [T, B, 3].
        q: (x, y, z, w), shape [T, B, 4].
        step_s: At most so far apart [s].
    """
    start, end = float(time[0]), float(time[-1])
    count = max(2, 1 + int(np.ceil((end - start) / step_s - 1e-9)))
    wanted = np.linspace(start, max(end, start + 1e-3), count)
    right = np.clip(np.searchsorted(time, wanted), 1, max(1, len(time) - 1))
    right = np.minimum(right, len(time) - 1)
    left = np.maximum(right - 1, 0)
    gap = np.maximum(time[right] - time[left], 1e-9)
    share = np.clip((wanted - time[left]) / gap, 0.0, 1.0)[:, None, None]
    p = _present(np.nan_to_num(np.asarray(p, float)))
    near = np.where(share[:, 0, 0] < 0.5, left, right)
    position = p[left] + share * (p[right] - p[left])
    return Poses(scene, wanted, position, np.nan_to_num(np.asarray(q, float))[near])


def _present(p: Floats) -> Floats:
    """Positions where what is not there stays at the nearest place where it was."""
    gone = p[:, :, 2] < GONE_M
    if not gone.any():
        return p
    out = p.copy()
    for body in np.flatnonzero(gone.any(axis=0)):
        here = np.flatnonzero(~gone[:, body])
        if len(here):
            nearest = np.abs(np.arange(len(p))[:, None] - here[None]).argmin(axis=1)
            out[:, body] = p[here[nearest], body]
    return out


@dataclass(frozen=True)
class Subject:
    """What is filmed, at K instants.

    Args:
        bodies: Its bodies.
        low, high: Corners of the box around it [m], shape [K, 3].
        front: Where it heads over the ground, unit, shape [K, 2].
        way: Its way from the first to the last instant over the ground [m], shape [2].
    """

    bodies: tuple[int, ...]
    low: Floats
    high: Floats
    front: Floats
    way: Floats

    @property
    def middle(self) -> Floats:
        """Middle of its box [m], shape [K, 3]."""
        return 0.5 * (self.low + self.high)

    @property
    def size(self) -> Floats:
        """Largest sides of its box at any instant [m], shape [3]."""
        return (self.high - self.low).max(axis=0)

    @property
    def sweep(self) -> Floats:
        """Sides of the box around all of its ways [m], shape [3]."""
        return self.high.max(axis=0) - self.low.min(axis=0)


def subject_of(poses: Poses, bodies: Sequence[int]) -> Subject | None:
    """What a camera films; None in a scene without bodies.

    Args:
        poses: Of the scene.
        bodies: That it is about; empty for those that move, could move, or are there.
    """
    chosen = tuple(bodies) or _acting(poses)
    if not chosen:
        return None
    corners = poses.corners(chosen).reshape(len(poses.time_s), -1, 3)
    low, high = corners.min(axis=1), corners.max(axis=1)
    middle = 0.5 * (low + high)
    way = middle[-1, :2] - middle[0, :2]
    return Subject(chosen, low, high, _front(poses, chosen[0], middle, high - low), way)


def movers(poses: Poses) -> tuple[int, ...]:
    """Bodies that move."""
    moved = np.ptp(poses.position, axis=0).max(axis=1)
    bodies = poses.scene.bodies
    return tuple(i for i, b in enumerate(bodies) if not b.static and moved[i] > STIRS_M)


def _acting(poses: Poses) -> tuple[int, ...]:
    bodies = poses.scene.bodies
    loose = tuple(i for i, b in enumerate(bodies) if not b.static)
    return movers(poses) or loose or tuple(range(len(bodies)))


def _front(poses: Poses, body: int, middle: Floats, sides: Floats) -> Floats:
    """Its own front of what has wheels or stays; else the way it goes, held where it is slow."""
    count = len(middle)
    own = quat_rotate(poses.quaternion[:, body], np.tile((1.0, 0.0, 0.0), (count, 1)))[:, :2]
    own = np.where(np.linalg.norm(own, axis=1, keepdims=True) > 0.2, own, (1.0, 0.0))
    travel = float(np.ptp(middle[:, :2], axis=0).max())
    stays = travel < TRAVEL * float(sides.max())
    if poses.scene.bodies[body].wheeled or stays:
        return _unit(own)
    step = float(poses.time_s[1] - poses.time_s[0])
    speed = np.gradient(soft(middle[:, :2], 0.4 / step), step, axis=0)
    pace = np.linalg.norm(speed, axis=1)
    fast = np.flatnonzero(pace > 0.2 * float(pace.max()))
    nearest = np.abs(np.arange(count)[:, None] - fast[None]).argmin(axis=1)
    return _unit(soft(_unit(speed[fast[nearest]]), 0.25 / step))


def _unit(v: Floats) -> Floats:
    return v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), 1e-9)


def soft(values: Floats, width: float, *, goes_on: bool = False) -> Floats:
    """Values smoothed by a bell along their first axis.

    Args:
        values: Shape [K, ...].
        width: Of the bell, in steps.
        goes_on: Whether what comes to an end goes on beyond it, rather than being held.
    """
    from scipy.ndimage import gaussian_filter1d

    reach = min(len(values) - 1, int(4.0 * width + 0.5))
    if goes_on and reach > 0:
        sides = [(reach, reach), *((0, 0) for _ in values.shape[1:])]
        padded = np.pad(values, sides, mode="reflect", reflect_type="odd")
        return gaussian_filter1d(padded, max(width, 1e-3), axis=0)[reach:-reach]
    return gaussian_filter1d(values, max(width, 1e-3), axis=0, mode="nearest")
