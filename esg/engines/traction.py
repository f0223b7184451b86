"""What the ground does to a body beyond its contacts: brakes and tyres (`esg.engines.program`).

The plain arithmetic that PhysX and Rapier execute; the kernels of the others are tested against it.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import IntEnum
import math
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from esg.engines.program import Action, Column, ProgramBatch, Vec
from esg.engines.scene import Body, Floats, SimScene
from esg.engines.worlds import moving
from esg.units import quat_rotate

FALLING = 0.5
"""Nothing carries what has lost more than this share of g dt of its vertical velocity in a step."""
ON_WHEELS = math.sqrt(0.5)
"""A body stands on its wheels while the cosine of its tilt is larger than this (45 degrees)."""

BLOW_MPS = 1.0
"""What changes the horizontal velocity of a two-wheeler by more within a step costs its balance."""
TIPPING_S = 0.5
"""How long it then leans on, if nothing stops it [s]."""
TIPPING_RAD_S = 2.5
"""How fast it leans then, at least: over 45 degrees within a third of a second."""
LEAST_LEAN_RAD_S = 0.05
LEAST_TILT = 1e-3
"""What leans more slowly leans to where it is tilted, if it is by more than that [rad]."""


class Feature(IntEnum):
    """Columns of what the ground has to know about a body (`features`)."""

    ROUND = 0
    """1 if it rolls."""
    GRIP = 1
    """Side friction coefficient of its tyres, 0 without any."""
    AXLE = 2
    """Distance of the axles from the centre of mass [m]: the radius of gyration about its up axis,
    at which a push on one axle does not move the other."""
    DROP = 3
    """`Body.tyre_drop` [m]."""
    LEAN = 4
    """Angular velocity about its forward axis by the side velocity that a push on the tyres gives
    [rad/m]."""


FEATURES = len(Feature)


def features(scene: SimScene, friction_scale: float = 1.0) -> Floats:
    """What the ground has to know about B bodies, shape [B, FEATURES]; NaN for what stays put.

    Args:
        scene: The bodies.
        friction_scale: Factor on the grip of tyres.
    """
    out = np.full((len(scene.bodies), FEATURES), np.nan)
    for i in np.nonzero(moving(scene))[0]:
        out[i] = _features(scene.bodies[i])
    out[:, Feature.GRIP] *= friction_scale
    return out


def _features(body: Body) -> tuple[float, ...]:
    rolls = float(body.roll_radius > 0.0)
    if not body.wheeled or body.tyre_friction <= 0.0:
        return rolls, 0.0, 0.0, 0.0, 0.0
    axle = math.sqrt(body.inertia[2][2] / body.mass)
    lean = body.mass * body.tyre_drop / body.inertia[0][0]
    return rolls, body.tyre_friction, axle, body.tyre_drop, lean


def has_tyres(rows: NDArray[np.floating]) -> bool:
    """Whether any of these bodies has tyres."""
    return bool((rows[:, Feature.GRIP] > 0.0).any())


class Bodies(Protocol):
    """Access to bodies by index."""

    def read(self, body: int) -> tuple[Any, Any, Any, Any]: ...
    def linear(self, body: int) -> Vec: ...
    def set_linear(self, body: int, velocity: Vec) -> None: ...
    def set_angular(self, body: int, velocity: Vec) -> None: ...


class Traction:
    """Brakes and tyres of one world.

    Args:
        batch: W programs.
        world: Which of them.
        rows: `features` of the bodies; None if all move and none is round or has tyres.
        gravity_z: [m/s^2].
    """

    def __init__(
        self, batch: ProgramBatch, world: int, rows: Floats | None, gravity_z: float
    ) -> None:
        self._gravity_z = gravity_z
        if rows is None:
            rows = np.zeros((int(batch.until.shape[1]), FEATURES))
        adjusts = np.nonzero(batch.kind == Action.ADJUST)[0]
        brakes = np.isfinite(batch.table[world, adjusts, Column.BRAKING])
        watched = {int(b) for b in batch.body[adjusts[brakes]] if not math.isnan(rows[b, 0])}
        watched |= {int(b) for b in np.nonzero(rows[:, Feature.GRIP] > 0.0)[0]}
        self._rows = {b: [float(v) for v in rows[b]] for b in sorted(watched)}
        self._braking = dict.fromkeys(self._rows, 0.0)
        self._before = dict.fromkeys(self._rows, (math.nan, math.nan, math.nan))
        self._tips = dict.fromkeys(self._rows, 0.0)
        self._falls: set[int] = set()

    def set_braking(self, body: int, braking: float) -> None:
        """Deceleration of a body by its brakes from now on [m/s^2]."""
        if body in self._braking:
            self._braking[body] = braking

    def look(self, dt: float, bodies: Bodies) -> None:
        """Finds out what nothing carries and what has lost its balance, before the primitives.

        Args:
            dt: Physics step [s].
            bodies: The world's.
        """
        least = -FALLING * self._gravity_z * dt
        self._falls.clear()
        for body, (x, y, z) in self._before.items():
            now = bodies.linear(body)
            if z - now[2] > least:
                self._falls.add(body)
            if (
                self._rows[body][Feature.DROP] > 0.0
                and math.hypot(now[0] - x, now[1] - y) > BLOW_MPS
            ):
                self._tips[body] = TIPPING_S

    def act(self, dt: float, driven: Mapping[int, float], bodies: Bodies) -> None:
        """Acts after the primitives, before the step.

        Args:
            dt: Physics step [s].
            driven: Bodies whose velocity a hold or a guide has set in this step, and the vertical
                velocity that they start it with [m/s].
            bodies: The world's.
        """
        pull = self._gravity_z * dt
        for body, row in self._rows.items():
            _, turn, linear, angular = bodies.read(body)
            v, o = [float(x) for x in linear], [float(x) for x in angular]
            if body in driven:
                self._tips[body] = 0.0
                self._before[body] = v[0], v[1], driven[body]
                continue
            self._before[body] = v[0], v[1], v[2]
            if body in self._falls:
                continue
            slow, turned = grounded(row, self._braking[body] * dt, -pull, v, o, turn)
            if self._tips[body] > 0.0:
                self._tips[body] -= dt
                turned = tipped(turned, turn)
            self._before[body] = slow[0], slow[1], slow[2]
            if slow != v:
                bodies.set_linear(body, (slow[0], slow[1], slow[2]))
            if turned != o:
                bodies.set_angular(body, (turned[0], turned[1], turned[2]))


def grounded(
    row: list[float], loss: float, weight: float, v: list[float], o: list[float], turn: Any
) -> tuple[list[float], list[float]]:
    """Linear and angular velocity of a body that stands on something, after brakes and tyres.

    Args:
        row: Its `features`.
        loss: What the brakes take of its horizontal velocity, at most [m/s].
        weight: Velocity that gravity gives within a step [m/s].
        v, o: Linear [m/s] and angular [rad/s] velocity.
        turn: Quaternion (x, y, z, w).
    """
    speed = math.hypot(v[0], v[1])
    taken = min(loss, speed)
    if taken > 0.0:
        kept = 1.0 - taken / speed
        v = [v[0] * kept, v[1] * kept, v[2]]
        if row[Feature.ROUND] > 0.0:
            o = [o[0] * kept, o[1] * kept, o[2]]
    limit = row[Feature.GRIP] * weight
    if limit <= taken:
        return v, o
    ahead, up = quat_rotate(turn, np.eye(3)[0]), quat_rotate(turn, np.eye(3)[2])
    if up[2] <= ON_WHEELS:
        return v, o
    # What the brakes have taken, the tyres cannot give to the side.
    return _gripped(row, math.sqrt(limit**2 - taken**2), v, o, float(ahead[0]), float(ahead[1]))


def tipped(o: list[float], turn: Any) -> list[float]:
    """Angular velocity [rad/s] of what has lost its balance: it leans on the way it does.

    Args:
        o: Before [rad/s].
        turn: Quaternion (x, y, z, w).
    """
    ahead, up = quat_rotate(turn, np.eye(3)[0]), quat_rotate(turn, np.eye(3)[2])
    if up[2] <= ON_WHEELS:
        return o
    length = math.hypot(ahead[0], ahead[1])
    fx, fy = float(ahead[0]) / length, float(ahead[1]) / length
    lean, right = fx * o[0] + fy * o[1], fy * up[0] - fx * up[1]
    if abs(lean) >= TIPPING_RAD_S:
        return o
    left = lean < 0.0 if abs(lean) > LEAST_LEAN_RAD_S else right < -LEAST_TILT
    more = (-TIPPING_RAD_S if left else TIPPING_RAD_S) - lean
    return [o[0] + fx * more, o[1] + fy * more, o[2]]


def _gripped(
    row: list[float], limit: float, v: list[float], o: list[float], fx: float, fy: float
) -> tuple[list[float], list[float]]:
    """Two axles, each with half the grip, against sliding to the side."""
    length = math.hypot(fx, fy)
    fx, fy = fx / length, fy / length
    axle, drop, lean = row[Feature.AXLE], row[Feature.DROP], row[Feature.LEAN]
    slip = (fx * v[1] - fy * v[0] + drop * (fx * o[0] + fy * o[1])) / (1.0 + drop * lean)
    yaw = axle * o[2]
    front = max(-limit, min(limit, slip + yaw))
    rear = max(-limit, min(limit, slip - yaw))
    side, turn = 0.5 * (front + rear), 0.5 * (front - rear)
    return (
        [v[0] + fy * side, v[1] - fx * side, v[2]],
        [o[0] - fx * lean * side, o[1] - fy * lean * side, o[2] - turn / axle],
    )
