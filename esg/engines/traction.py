"""What the ground does to a body beyond its contacts: brakes (`esg.engines.program`).

The plain arithmetic that PhysX and Rapier execute; the kernels of the others are tested against it.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import IntEnum
import math
from typing import Any, Protocol

import numpy as np

from esg.engines.program import Action, Column, ProgramBatch, Vec
from esg.engines.scene import Floats, SimScene
from esg.engines.worlds import moving

FALLING = 0.5
"""Nothing carries what has lost more than this share of g dt of its vertical velocity in a step."""


class Feature(IntEnum):
    """Columns of what the ground has to know about a body (`features`)."""

    ROUND = 0
    """1 if it rolls."""


FEATURES = len(Feature)


def features(scene: SimScene) -> Floats:
    """What the ground has to know about B bodies, shape [B, FEATURES]; NaN for what stays put."""
    out = np.full((len(scene.bodies), FEATURES), np.nan)
    for i in np.nonzero(moving(scene))[0]:
        out[i, Feature.ROUND] = scene.bodies[i].roll_radius > 0.0
    return out


class Bodies(Protocol):
    """Access to bodies by index."""

    def read(self, body: int) -> tuple[Any, Any, Any, Any]: ...
    def set_linear(self, body: int, velocity: Vec) -> None: ...
    def set_angular(self, body: int, velocity: Vec) -> None: ...


class Traction:
    """Brakes of one world.

    Args:
        batch: W programs.
        world: Which of them.
        rows: `features` of the bodies; None if all move and none is round.
        gravity_z: [m/s^2].
    """

    def __init__(
        self, batch: ProgramBatch, world: int, rows: Floats | None, gravity_z: float
    ) -> None:
        self._gravity_z = gravity_z
        adjusts = np.nonzero(batch.kind == Action.ADJUST)[0]
        brakes = np.isfinite(batch.table[world, adjusts, Column.BRAKING])
        watched = sorted({int(b) for b in batch.body[adjusts[brakes]]})
        self._round = {
            b: rows is not None and rows[b, Feature.ROUND] > 0.0
            for b in watched
            if rows is None or not math.isnan(rows[b, Feature.ROUND])
        }
        self._braking = dict.fromkeys(self._round, 0.0)
        self._rise = dict.fromkeys(self._round, math.nan)

    def set_braking(self, body: int, braking: float) -> None:
        """Deceleration of a body by its brakes from now on [m/s^2]."""
        if body in self._braking:
            self._braking[body] = braking

    def act(self, dt: float, driven: Mapping[int, float], bodies: Bodies) -> None:
        """Acts after the primitives, before the step.

        Args:
            dt: Physics step [s].
            driven: Bodies whose velocity a hold or a guide has set in this step, and the vertical
                velocity that they start it with [m/s].
            bodies: The world's.
        """
        for body, braking in self._braking.items():
            before = self._rise[body]
            if body in driven:
                self._rise[body] = driven[body]
                continue
            _, _, linear, angular = bodies.read(body)
            vx, vy, vz = (float(v) for v in linear)
            self._rise[body] = vz
            falls = before - vz > -FALLING * self._gravity_z * dt
            speed = math.hypot(vx, vy)
            if falls or braking <= 0.0 or speed == 0.0:
                continue
            kept = max(0.0, 1.0 - braking * dt / speed)
            bodies.set_linear(body, (vx * kept, vy * kept, vz))
            if self._round[body]:
                x, y, z = (float(v) for v in angular)
                bodies.set_angular(body, (x * kept, y * kept, z))
