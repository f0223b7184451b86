"""What is under way when a scene begins: the velocities that the first step of a program gives."""

from __future__ import annotations

import numpy as np

from esg.engines.program import KNOT_FIELDS, Action, Column, ProgramBatch
from esg.engines.scene import Floats

_KNOT_VELOCITY = Column.KNOT + KNOT_FIELDS - 3


def start_velocities(batch: ProgramBatch, mass: Floats, dt: float) -> tuple[Floats, Floats]:
    """Velocities of all bodies at t = 0.

    What is due in the first step acts on the initial state: a car that drives from the start on is
    under way in it, and whoever records, exports or judges a rollout sees it so. The primitives
    say the same again in the first step; this adds nothing to what they mean.

    Args:
        batch: W programs of B bodies.
        mass: [kg], shape [W, B].
        dt: Physics step [s].

    Returns:
        Linear [m/s] and angular [rad/s] velocities, shape [W, B, 3] each.
    """
    linear = np.zeros((*mass.shape, 3))
    angular = np.zeros_like(linear)
    for k, (kind, body) in enumerate(zip(batch.kind, batch.body, strict=True)):
        w = np.flatnonzero(batch.table[:, k, Column.START] <= 0.5 * dt)
        row = batch.table[w, k]
        action = Action(kind)
        if action is Action.SET_VELOCITY:
            spin = row[:, Column.ANGULAR : Column.ANGULAR + 3]
            linear[w, body] = row[:, Column.LINEAR : Column.LINEAR + 3]
            angular[w, body] = np.where(np.isnan(spin), angular[w, body], spin)
        elif action is Action.APPLY_IMPULSE:
            push = row[:, Column.IMPULSE : Column.IMPULSE + 3]
            linear[w, body] += push / mass[w, body][:, None]
        elif action is Action.HOLD:
            # What takes its time has not moved yet.
            w = w[np.isnan(row[:, Column.GAINS])]
            row = batch.table[w, k]
            climb = row[:, Column.CLIMB]
            flies = ~np.isnan(climb)
            speed = np.maximum(row[:, Column.SPEED], 0.0)
            gains = row[:, Column.ACCELERATION] > 0.0
            speed = np.where(gains, np.minimum(speed, row[:, Column.MAX_SPEED]), speed)
            vx, vy = (speed * f(row[:, Column.HEADING]) for f in (np.cos, np.sin))
            radius = np.where(flies, 0.0, row[:, Column.ROLL_RADIUS])
            rolls, radius = radius > 0.0, np.where(radius > 0.0, radius, 1.0)
            linear[w, body] = np.stack(
                [vx, vy, np.where(flies, climb, linear[w, body, 2])], axis=-1
            )
            turns = np.where(rolls, 0.0, row[:, Column.TURN_RATE])
            angular[w, body] = np.stack(
                [np.where(rolls, -vy / radius, 0.0), np.where(rolls, vx / radius, 0.0), turns], -1
            )
        elif action is Action.GUIDE:
            linear[w, body] = row[:, _KNOT_VELOCITY : _KNOT_VELOCITY + 3]
            angular[w, body] = 0.0
            angular[w, body, 2] = row[:, Column.GUIDE_TURN_RATE]
        elif action is Action.SPIN:
            angular[w, body] = row[:, Column.SPIN : Column.SPIN + 3]
    return linear, angular
