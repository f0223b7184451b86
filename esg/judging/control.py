"""What a thing did by itself, where a file has no control program: read from its motion.

The judge asks who launched, drove or braked a body. A file of poses does not say, so what begins or
slows while nothing but the ground touches the body is taken for its own doing.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.engines.program import AdjustProperties, Primitive, Program, SetVelocity
from esg.engines.scene import ContactLog
from esg.judging.bodies import Played
from esg.judging.recording import Floats
from esg.thresholds import MOVING_MPS

Bools = NDArray[np.bool_]
AROUND_S = 0.1
"""What changes so shortly after a touch is the touch's doing."""
STEADY_S = 0.2
"""What kept its speed for so long before it slows down was not just coasting to a halt."""
STEADY_SHARE = 0.05
"""A speed that changes by less of itself in that time is kept."""
BRAKING_MPS2 = 1.0
"""Slowing down by less is rolling resistance: of tyres it is 0.01 to 0.02 g."""
LIFT_MPS2 = 2.0
"""A vertical acceleration so far from free fall is told from falling."""


def program_of(played: Played, velocity: Floats, contacts: ContactLog, time: Floats) -> Program:
    """The program that a motion looks like: launches and brakings of bodies.

    Args:
        played: Bodies and motion.
        velocity: Of the centres of mass [m/s], shape [T, B, 3].
        contacts: Who touched whom.
        time: Of the frames [s], shape [T].
    """
    found: list[Primitive] = []
    for k, body in enumerate(played.scene.bodies):
        if body.static or not body.collides:
            continue
        touched = _touched(k, contacts, time)
        own = velocity[:, k]
        found += [
            SetVelocity(body.name, float(time[f]), _triple(own[f]))
            for f in launches(own, touched, played.scene.gravity[2], time)
        ]
        found += [
            AdjustProperties(body.name, float(time[f]), braking=rate)
            for f, rate in brakings(own, touched, time)
        ]
    found.sort(key=lambda p: (p.time, p.body))
    return Program(tuple(found), float(time[-1]))


def _touched(body: int, contacts: ContactLog, time: Floats) -> Bools:
    """Frames shortly after another body touched this one, shape [T]."""
    out = np.zeros(len(time), bool)
    for at in contacts.time[(contacts.a == body) | ((contacts.b == body) & (contacts.b >= 0))]:
        out |= (time >= at - 1e-9) & (time <= at + AROUND_S)
    return out


def launches(velocity: Floats, touched: Bools, gravity: float, time: Floats) -> list[int]:
    """Frames from which a body moves by itself: it was still, and no one had touched it.

    Args:
        velocity: Its own [m/s], shape [T, 3].
        touched: Frames shortly after a touch, shape [T].
        gravity: Along Z [m/s^2].
        time: [s], shape [T].
    """
    speed = np.linalg.norm(velocity, axis=-1)
    moving = speed > MOVING_MPS
    starts = np.flatnonzero(moving & ~np.append(False, moving[:-1]))
    out: list[int] = []
    for f in starts.tolist():
        if touched[f]:
            continue
        if f > 0 and _falls(velocity, gravity, time, f):
            continue
        out.append(f)
    return out


def _falls(velocity: Floats, gravity: float, time: Floats, f: int) -> bool:
    """Whether a body begins to fall in a frame: it moves down, and no faster than it would."""
    last = min(f + 2, len(time) - 1)
    across = float(np.linalg.norm(velocity[f, :2]))
    down = float(velocity[last, 2] - velocity[f - 1, 2]) / float(time[last] - time[f - 1])
    return velocity[f, 2] < 0.0 and across < MOVING_MPS and abs(down - gravity) < LIFT_MPS2


def brakings(velocity: Floats, touched: Bools, time: Floats) -> list[tuple[int, float]]:
    """Frames from which a body slows itself down, each with its deceleration [m/s^2].

    It kept its speed for `STEADY_S`, nothing touches it, and it then slows down.

    Args:
        velocity: Its own [m/s], shape [T, 3].
        touched: Frames shortly after a touch, shape [T].
        time: [s], shape [T].
    """
    speed = np.linalg.norm(velocity[:, :2], axis=-1)
    frame_s = float(np.median(np.diff(time)))
    window = max(2, round(AROUND_S / frame_s))
    before = max(2, round(STEADY_S / frame_s))
    if len(speed) <= window + 1:
        return []
    ahead = np.append(speed[window:], np.full(window, speed[-1]))
    rate = (speed - ahead) / (window * frame_s)
    slowing = (rate > BRAKING_MPS2) & (speed > MOVING_MPS)
    out: list[tuple[int, float]] = []
    for f in np.flatnonzero(slowing & ~np.append(False, slowing[:-1])).tolist():
        past = speed[max(f - before, 0) : f + 1]
        kept = np.ptp(past) <= STEADY_SHARE * past.max()
        if f >= before and kept and not touched[f : f + window].any():
            out.append((_onset(speed, f, window), float(rate[f])))
    return out


def _onset(speed: Floats, f: int, window: int) -> int:
    """Frame in which the slowing starts that a window from `f` on sees."""
    steady = speed[f]
    less = np.flatnonzero(speed[f : f + window + 1] < (1.0 - 0.5 * STEADY_SHARE) * steady)
    return f + max(int(less[0]) - 1, 0) if len(less) else f


def _triple(values: Floats) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in values)
    return x, y, z
