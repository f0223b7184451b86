"""Wheels of a recording, how far each has turned; and what shines and sways, by the time alone.

Engines simulate a vehicle as one body; its wheels are drawn. A wheel turns by the distance that its
axle goes along the body's heading (+X) over its radius: backwards the other way, sideways not at
all, and in a bend the inner wheel less than the outer. That holds while the body stands upright on
something. In the air, or lying on its side, a wheel keeps the rate it had and runs down.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Body, Gesture, Rollout, Shine, SimScene
from esg.lexicon.gestures import states_at
from esg.lexicon.shown import Sway
from esg.units import quat_rotate

Floats = NDArray[np.float64]
Path = NDArray[np.float32] | Floats
"""Positions or quaternions at the frames, as recordings keep them or as computed."""

UPRIGHT = 0.5
"""A body whose up axis rises less than this (60 degrees of tilt) does not stand on its wheels."""
FALLS = 0.5
"""What gains this share of gravity's speed downwards is carried by nothing."""
RUNS_DOWN_S = 2.0
"""Time in which a wheel that touches nothing loses 63% of its rate [s]: bearings of a bicycle."""
TURN_S = 0.6
"""What changes at no event of the scene does so this long after its start [s]."""
LIT_SHARE = 0.5
"""Of the time of a flash, in which it shines."""
STEADY = 0.3
"""What bends in the wind leans by this share of its largest angle, and swings by the rest."""


def wheel_angles(
    body: Body, time: Floats, position: Path, quaternion: Path, gravity: Sequence[float]
) -> Floats:
    """Angles [rad] of a body's wheels about its Y axis, from 0 at the start, shape [T, wheels].

    Args:
        body: With W wheels, maybe none.
        time: Of the frames [s], shape [T].
        position: Of its centre of mass [m], shape [T, 3].
        quaternion: (x, y, z, w), shape [T, 4].
        gravity: Of the scene [m/s^2], shape [3].
    """
    out = np.zeros((len(time), len(body.wheels)))
    if not body.wheels or len(time) < 2:
        return out
    at, q = np.asarray(position, float), np.asarray(quaternion, float)
    span = np.maximum(np.diff(np.asarray(time, float)), 1e-9)
    forward = quat_rotate(q, np.array([1.0, 0.0, 0.0]))
    heading = forward[1:] + forward[:-1]
    heading /= np.maximum(np.linalg.norm(heading, axis=1, keepdims=True), 1e-9)
    carried = _carried(at, q, span, np.asarray(gravity, float))
    for k, wheel in enumerate(body.wheels):
        axle = at + quat_rotate(q, np.asarray(wheel.axle, float))
        rolled = np.einsum("ti,ti->t", np.diff(axle, axis=0), heading) / wheel.radius
        rate = 0.0
        for t, step in enumerate(span):
            rate = rolled[t] / step if carried[t] else rate * np.exp(-step / RUNS_DOWN_S)
            out[t + 1, k] = out[t, k] + rate * step
    return out


def _carried(at: Floats, q: Floats, span: Floats, gravity: Floats) -> NDArray[np.bool_]:
    """Whether a body stands upright on something in the steps between frames, shape [T - 1]."""
    strength = float(np.linalg.norm(gravity))
    up = -gravity / strength if strength else np.array([0.0, 0.0, 1.0])
    standing = quat_rotate(q, np.array([0.0, 0.0, 1.0])) @ up >= UPRIGHT
    rise = (np.diff(at, axis=0) / span[:, None]) @ up
    gained = np.diff(rise, prepend=rise[:1]) / span
    falls = (gained < -FALLS * strength) & (strength > 0.0)
    return standing[1:] & ~falls


def scene_angles(scene: SimScene, rollout: Rollout, *, world: int = 0) -> Floats:
    """Angles [rad] of all wheels in the order of their bodies, shape [T, W]."""
    found = [
        wheel_angles(
            body,
            rollout.time,
            rollout.position[world, :, i],
            rollout.quaternion[world, :, i],
            scene.gravity,
        )
        for i, body in enumerate(scene.bodies)
    ]
    return np.concatenate([np.zeros((len(rollout.time), 0)), *found], axis=1)


def about_axle(angle: Floats) -> Floats:
    """Rotations by angles [rad], shape [T], about Y, as quaternions (x, y, z, w), shape [T, 4]."""
    half, nothing = 0.5 * np.asarray(angle, float), np.zeros(np.shape(angle))
    return np.stack([nothing, np.sin(half), nothing, np.cos(half)], axis=-1)


def turns_at(shine: Shine, events: Mapping[str, float | None]) -> float:
    """When a light changes [s]; never if its event did not happen."""
    if not shine.event:
        return TURN_S
    at = events.get(shine.event)
    return math.inf if at is None else at


def shining(shine: Shine, time: Floats, events: Mapping[str, float | None]) -> NDArray[np.bool_]:
    """Whether a light shines at times [s], shape [T].

    Args:
        shine: The light.
        time: [s], shape [T].
        events: Times of the events [s], None for those that did not happen.
    """
    time = np.asarray(time, float)
    on = np.where(time < turns_at(shine, events), shine.before, shine.after)
    if shine.period_s > 0.0:
        on = on & (np.mod(time + 1e-9, shine.period_s) < LIT_SHARE * shine.period_s)
    return on.astype(bool)


def gesturing(
    gesture: Gesture, time: Floats, events: Mapping[str, float | None]
) -> NDArray[np.int64]:
    """States of a gesture (`esg.lexicon.gestures.states_at`) at times [s], shape [T, 2].

    Args:
        gesture: The gesture.
        time: [s], shape [T].
        events: Times of the events [s], None for those that did not happen.
    """
    time = np.asarray(time, float)
    begins = TURN_S if not gesture.begins else events.get(gesture.begins)
    ends = events.get(gesture.ends) if gesture.ends else None
    since = time - (math.inf if begins is None else begins)
    out = states_at(gesture.period_s, gesture.times, np.maximum(since, -1.0))
    out[time >= (math.inf if ends is None else ends)] = 0
    return out


def phase_of(body: Body) -> float:
    """Of what sways [rad], another for each body, the same in every run."""
    return 2.399963 * sum(body.name.encode())


def bent_by(sway: Sway, time: Floats, phase: float) -> Floats:
    """By what angle it is bent at times [rad], shape [T]; of what waves, along its length."""
    turn = 2.0 * math.pi * np.asarray(time, float) / sway.period_s + phase
    steady = STEADY if sway.how == "bends" else 0.0
    return math.radians(sway.degrees) * (steady + (1.0 - steady) * np.sin(turn))
