"""Contacts from poses and shapes, where a file has none.

Between two frames nobody knows the motion. Whether a pair met there is asked of both sides: did the
motion before lead the one into the other, or does the motion after come from there? A touch counts
only with what it did: the change of velocity along its normal that gravity does not explain, times
the mass, is its impulse. So what passes close by is no contact, and what goes through something
without being slowed is none either.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
import itertools
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import ContactLog
from esg.judging.bodies import Played
from esg.judging.recording import Floats
from esg.metrics.geometry import Core, body_cores, core_depth, gjk_vector
from esg.units import quat_rotate

TOUCH_M = 0.005
"""So close is touching: engines keep bodies apart by margins of about this size."""
LEAST_CHANGE_MPS = 0.02
"""A change of velocity that is smaller is noise: poses in single precision, rounded times."""
SEEN_M = 0.05
"""What is farther apart is not measured."""
SAME = 1e-5
"""Coordinates of relative poses that differ by less are the same."""
_BACK_M = (0.01, 0.03, 0.1)
"""How far what overlaps is moved back to see where it came from."""
_ADVANCES = 24
"""Steps of a search between two frames."""


@dataclass(frozen=True)
class _Solid:
    """The collision shapes of a body.

    Args:
        points: Of all cores, in the body's frame [m], shape [n, 3].
        splits: Where in `points` a core ends and the next begins.
        radii: Of the cores' rounding [m].
        reach: Radius of the bounding sphere about the frame's origin [m].
    """

    points: Floats
    splits: NDArray[np.int64]
    radii: tuple[float, ...]
    reach: float

    def at(self, position: Floats, quaternion: Floats) -> tuple[Core, ...]:
        """The cores in a pose."""
        placed = quat_rotate(quaternion, self.points) + position
        parts = np.split(placed, self.splits)
        return tuple(Core(p, r) for p, r in zip(parts, self.radii, strict=True))


@dataclass(frozen=True)
class _Motion:
    """What a pair is asked about.

    Args:
        time: [s], shape [T].
        position, quaternion: Of all bodies, shapes [T, B, 3] and [T, B, 4].
        between: Mean velocity from each frame to the next [m/s], shape [T - 1, B, 3].
        turning: Angle from each frame to the next [rad], shape [T - 1, B].
        solids: Of the bodies; None for what nothing collides with.
        gravity: [m/s^2], shape [3].
        mass: [kg], infinite for what is fixed, shape [B].
    """

    time: Floats
    position: Floats
    quaternion: Floats
    between: Floats
    turning: Floats
    solids: tuple[_Solid | None, ...]
    gravity: Floats
    mass: Floats


@dataclass(frozen=True)
class _Pair:
    """Two bodies, of which the first has the smaller index."""

    motion: _Motion
    a: int
    b: int
    solids: tuple[_Solid, _Solid]

    @property
    def both(self) -> list[int]:
        return [self.a, self.b]

    @property
    def reach(self) -> float:
        """Sum of the radii of the bounding spheres [m]."""
        return self.solids[0].reach + self.solids[1].reach

    def placed(self, at: Floats, turns: Floats) -> tuple[tuple[Core, ...], tuple[Core, ...]]:
        """Cores of both in poses, shapes [2, 3] and [2, 4]."""
        first, second = self.solids
        return first.at(at[0], turns[0]), second.at(at[1], turns[1])

    def pose(self, frame: int) -> tuple[Floats, Floats]:
        """Recorded positions and quaternions of both, shapes [2, 3] and [2, 4]."""
        return self.motion.position[frame, self.both], self.motion.quaternion[frame, self.both]


@dataclass(frozen=True)
class _Touch:
    """One row of the log: see `ContactLog`."""

    frame: int
    a: int
    b: int
    time: float
    impulse: float
    depth: float
    point: Floats
    normal: Floats


def contacts_of(played: Played, time: Floats, about: Collection[int] | None = None) -> ContactLog:
    """The contact log of a motion; those with the ground are not in it.

    Args:
        played: Bodies and motion.
        time: Of the frames [s], shape [T].
        about: Bodies of which one has to be in a pair; None: any.
    """
    motion = _motion(played, time)
    rows: list[_Touch] = []
    bodies = played.scene.bodies
    for a, b in itertools.combinations(range(len(bodies)), 2):
        first, second = motion.solids[a], motion.solids[b]
        if first is None or second is None or (bodies[a].static and bodies[b].static):
            continue
        if about is not None and a not in about and b not in about:
            continue
        rows += _touches(_Pair(motion, a, b, (first, second)))
    rows.sort(key=lambda r: (r.frame, r.a, r.b))
    return _log(rows)


def _motion(played: Played, time: Floats) -> _Motion:
    position, quaternion = played.position, played.quaternion
    steps = np.diff(time)
    dots = np.abs(np.einsum("tbi,tbi->tb", quaternion[1:], quaternion[:-1]))
    return _Motion(
        time=time,
        position=position,
        quaternion=quaternion,
        between=np.diff(position, axis=0) / steps[:, None, None],
        turning=2.0 * np.arccos(np.clip(dots, 0.0, 1.0)),
        solids=tuple(_solid(body_cores(body)) for body in played.scene.bodies),
        gravity=np.array(played.scene.gravity, float),
        mass=np.array([math.inf if b.static else b.mass for b in played.scene.bodies]),
    )


def _solid(cores: tuple[Core, ...]) -> _Solid | None:
    if not cores:
        return None
    return _Solid(
        np.concatenate([c.points for c in cores]),
        np.cumsum([len(c.points) for c in cores])[:-1],
        tuple(c.radius for c in cores),
        max(float(np.linalg.norm(c.points, axis=1).max()) + c.radius for c in cores),
    )


@dataclass
class _Known:
    """What was measured of a pair that lies as it lay: its gap [m] and the normal, if asked for."""

    pose: Floats
    gap: float
    normal: Floats | None = None


def _touches(pair: _Pair) -> list[_Touch]:
    """Rows of one pair."""
    out: list[_Touch] = []
    near = _near(pair)
    known: dict[int, _Known] = {}
    last: _Known | None = None
    going_on = False
    for k in np.flatnonzero(near).tolist():
        for frame in (k, k + 1):
            if frame not in known:
                pose = _relative(pair, frame)
                # What rests against each other is measured once.
                if last is None or np.abs(pose - last.pose).max() > SAME:
                    last = _Known(pose, _nearest(*pair.placed(*pair.pose(frame)))[0])
                known[frame] = last
        met = _meeting(pair, k, known)
        touch = None if met is None else _touch(pair, k, met, going_on, known)
        if touch is not None:
            out.append(touch)
        going_on = touch is not None and k + 1 < len(near) and bool(near[k + 1])
    return out


def _near(pair: _Pair) -> NDArray[np.bool_]:
    """Steps in which the bounding spheres may meet, by any of the motions, shape [T - 1]."""
    motion, (a, b) = pair.motion, pair.both
    apart = np.linalg.norm(motion.position[:, a] - motion.position[:, b], axis=-1) - pair.reach
    speed = np.linalg.norm(motion.between[:, a] - motion.between[:, b], axis=-1)
    around = np.maximum(speed, np.maximum(np.append(speed[1:], 0.0), np.append(0.0, speed[:-1])))
    travel = around * np.diff(motion.time)
    return np.minimum(apart[:-1], apart[1:]) <= travel + TOUCH_M


def _relative(pair: _Pair, frame: int) -> Floats:
    (first, second), turns = pair.pose(frame)
    return np.concatenate([second - first, turns[0], turns[1]])


_Met = tuple[float, Floats]
"""When two met [s after a frame], and where both then were [m], shape [2, 3]."""


def _meeting(pair: _Pair, k: int, known: dict[int, _Known]) -> _Met | None:
    """When a pair met between frames k and k + 1, None if it did not."""
    step = float(pair.motion.time[k + 1] - pair.motion.time[k])
    here, there = pair.pose(k)[0], pair.pose(k + 1)[0]
    if known[k].gap <= TOUCH_M:
        return 0.0, here
    coming = _velocities(pair, k - 1)
    found = _advance(pair, k, k + 1, coming, step)
    if found is not None:
        return found, here + coming * found
    if known[k + 1].gap <= TOUCH_M:
        return step, there
    # They come from each other, unless they are still to meet: then that step has mixed motion.
    if k + 2 < len(pair.motion.time):
        after = float(pair.motion.time[k + 2] - pair.motion.time[k + 1])
        if _advance(pair, k + 1, k + 2, _velocities(pair, k), after) is not None:
            return None
    back = -_velocities(pair, k + 1)
    found = _advance(pair, k + 1, k, back, step)
    return None if found is None else (step - found, there + back * found)


def _velocities(pair: _Pair, step: int) -> Floats:
    """Mean velocities of both in a step, of the first or last where there is none [m/s], [2, 3]."""
    step = min(max(step, 0), len(pair.motion.between) - 1)
    return pair.motion.between[step, pair.both]


def _advance(pair: _Pair, frame: int, other: int, velocity: Floats, step: float) -> float | None:
    """Time [s] after which two bodies touch, that go on from a frame with what they have.

    Args:
        pair: The two.
        frame: From which they go.
        other: Towards whose orientations they turn.
        velocity: Theirs [m/s], shape [2, 3].
        step: Longest time [s].

    Returns:
        None if they do not touch within the step (conservative advancement).
    """
    at, turns = pair.pose(frame)
    last = pair.motion.quaternion[other, pair.both]
    reaches = np.array([s.reach for s in pair.solids])
    turning = pair.motion.turning[min(frame, other), pair.both] / step
    closing = float(np.linalg.norm(velocity[0] - velocity[1]) + turning @ reaches)
    if closing <= 1e-6:
        return None
    after = 0.0
    for _ in range(_ADVANCES):
        moved = at + velocity * after
        gap = float(np.linalg.norm(moved[0] - moved[1])) - pair.reach
        if gap <= TOUCH_M:
            gap, _ = _nearest(*pair.placed(moved, _between(turns, last, after / step)))
        if gap <= TOUCH_M:
            return after
        after += max(gap, 0.2 * TOUCH_M) / closing
        if after > step:
            return None
    return None


def _nearest(first: tuple[Core, ...], second: tuple[Core, ...]) -> tuple[float, Floats | None]:
    """Gap of two bodies [m] and the way from the second to the first, shape [3].

    What is clearly farther apart than `TOUCH_M` is measured short; the way is None where they
    overlap.
    """
    best, way = SEEN_M, None
    boxes = [_box(core) for core in second]
    for x in first:
        low, high = _box(x)
        for y, (base, top) in zip(second, boxes, strict=True):
            if float(np.linalg.norm(np.maximum(np.maximum(low - top, base - high), 0.0))) >= best:
                continue
            rounding = x.radius + y.radius
            v = gjk_vector(x.points, y.points, beyond=rounding + TOUCH_M)
            distance = float(np.linalg.norm(v))
            overlap = distance <= 1e-9
            gap = (-core_depth(x.points, y.points) if overlap else distance) - rounding
            if gap < best:
                best, way = gap, None if overlap else v
    return best, way


def _box(core: Core) -> tuple[Floats, Floats]:
    return core.points.min(axis=0) - core.radius, core.points.max(axis=0) + core.radius


def _between(first: Floats, last: Floats, share: float) -> Floats:
    """Orientations part of the way from some to others, shape [2, 4]."""
    same = np.where(np.einsum("ij,ij->i", first, last) >= 0.0, 1.0, -1.0)
    q = (1.0 - share) * first + share * same[:, None] * last
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def _touch(
    pair: _Pair, k: int, met: _Met, going_on: bool, known: dict[int, _Known]
) -> _Touch | None:
    """The row of a meeting in step k, None if it did nothing."""
    motion = pair.motion
    step = float(motion.time[k + 1] - motion.time[k])
    # A touch that goes on has already answered for what changed up to this step.
    before, after = max(k if going_on else k - 1, 0), min(k + 1, len(motion.between) - 1)
    change = motion.between[after, pair.both] - motion.between[before, pair.both]
    # What gravity did to both in that time is not the touch's doing.
    change = change - motion.gravity * step * (after - before)
    mass = motion.mass[pair.both]
    free = np.isfinite(mass)
    if float(np.linalg.norm(change[free], axis=1).max()) < LEAST_CHANGE_MPS:
        return None
    normal = _normal(pair, k, met, known)
    gains = np.array([change[0] @ normal, -(change[1] @ normal)])[free]
    impulse = float((mass[free] * gains).max())
    if float(gains.max()) < LEAST_CHANGE_MPS or impulse <= 0.0:
        return None
    return _Touch(
        frame=k + 1,
        a=pair.a,
        b=pair.b,
        time=float(motion.time[k]) + met[0],
        impulse=impulse,
        depth=max(0.0, -known[k + 1].gap),
        point=met[1].mean(axis=0),
        normal=normal,
    )


def _normal(pair: _Pair, k: int, met: _Met, known: dict[int, _Known]) -> Floats:
    """Unit normal from b to a where they met: along the shortest way between them."""
    resting = known[k] if met[0] == 0.0 else None
    if resting is not None and resting.normal is not None:
        return resting.normal
    motion = pair.motion
    share = met[0] / float(motion.time[k + 1] - motion.time[k])
    turns = _between(motion.quaternion[k, pair.both], motion.quaternion[k + 1, pair.both], share)
    first, second = pair.placed(met[1], turns)
    _, way = _nearest(first, second)
    for back in _BACK_M:
        if way is not None:
            break
        # They overlap: the way out is the one by which they came.
        away = met[1][0] - met[1][1]
        came = _velocities(pair, k - 1)
        way_in = came[1] - came[0]
        out = way_in if float(np.linalg.norm(way_in)) > 1e-3 else away
        out = back * out / max(float(np.linalg.norm(out)), 1e-9)
        moved = tuple(Core(c.points + out, c.radius) for c in first)
        _, way = _nearest(moved, second)
    if way is None:
        way = met[1][0] - met[1][1] + np.array([0.0, 0.0, 1e-9])
    normal = way / np.linalg.norm(way)
    if resting is not None:
        resting.normal = normal
    return normal


def _log(rows: list[_Touch]) -> ContactLog:
    if not rows:
        return ContactLog.empty()
    return ContactLog(
        world=np.zeros(len(rows), np.int32),
        frame=np.array([r.frame for r in rows], np.int32),
        a=np.array([r.a for r in rows], np.int32),
        b=np.array([r.b for r in rows], np.int32),
        time=np.array([r.time for r in rows]),
        impulse=np.array([r.impulse for r in rows]),
        depth=np.array([r.depth for r in rows]),
        point=np.array([r.point for r in rows]),
        normal=np.array([r.normal for r in rows]),
    )
