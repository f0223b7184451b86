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
from esg.units import GRAVITY_MPS2, quat_rotate

FALLING = 0.5
"""Nothing carries what has lost more than this share of g dt of its vertical velocity in a step."""
ON_WHEELS = math.sqrt(0.5)
"""A body stands on its wheels while the cosine of its tilt is larger than this (45 degrees)."""

BLOW_MPS = 1.0
"""What changes the horizontal velocity of a two-wheeler by more within a step costs its balance."""
TIPPING_RAD_S = 2.0
"""How fast it then still leans when its weight is over the edge of its foot: from there it falls
by itself, in a quarter of a second."""
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
    """Mass over inertia about the forward axis [1/m^2]: a push to the side at a height below the
    centre of mass turns it by so much times that height and the velocity that it gives."""
    FOOT = 5
    """`Body.tyre_foot` [m]."""
    TIP = 6
    """How fast it leans once it has lost its balance [rad/s]."""


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
        return (rolls, *(0.0,) * (FEATURES - 1))
    axle = math.sqrt(body.inertia[2][2] / body.mass)
    lean = body.mass / body.inertia[0][0]
    tip = tipping_rate(body.mass, body.inertia[0][0], body.tyre_drop, body.tyre_foot)
    return rolls, body.tyre_friction, axle, body.tyre_drop, lean, body.tyre_foot, tip


def tipping_rate(mass: float, inertia: float, drop: float, foot: float) -> float:
    """How fast a body has to turn about the edge of its foot to fall over it [rad/s].

    Its centre of mass rises to its distance from that edge, and turns at TIPPING_RAD_S up there.

    Args:
        mass: [kg].
        inertia: About its forward axis through the centre of mass [kg m^2].
        drop, foot: Of the edge below and beside the centre of mass [m].
    """
    reach = math.hypot(drop, foot)
    uphill = 2.0 * mass * GRAVITY_MPS2 * (reach - drop) / (inertia + mass * reach**2)
    return math.sqrt(TIPPING_RAD_S**2 + uphill)


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
        self._tips: set[int] = set()
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
                self._tips.add(body)

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
                self._tips.discard(body)
                self._before[body] = v[0], v[1], driven[body]
                continue
            self._before[body] = v[0], v[1], v[2]
            if body in self._falls:
                continue
            slow, turned = grounded(row, self._braking[body] * dt, -pull, v, o, turn)
            if body in self._tips:
                self._tips.discard(body)
                slow, turned = tipped(row, slow, turned, turn)
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
    ahead, up = np.eye(3)[[0, 2]]
    if row[Feature.GRIP] > 0.0:  # only tyres ask how it stands
        ahead, up = quat_rotate(turn, ahead), quat_rotate(turn, up)
    x, y = v[0], v[1]
    if row[Feature.DROP] > 0.0 and up[2] > ON_WHEELS:
        # Its brakes leave to its tyres what it leans to the side with.
        share = (x * ahead[0] + y * ahead[1]) / (ahead[0] ** 2 + ahead[1] ** 2)
        x, y = float(share * ahead[0]), float(share * ahead[1])
    speed = math.hypot(x, y)
    taken = min(loss, speed)
    if taken > 0.0:
        lost = taken / speed
        v = [v[0] - lost * x, v[1] - lost * y, v[2]]
        if row[Feature.ROUND] > 0.0:
            o = [o[0] * (1.0 - lost), o[1] * (1.0 - lost), o[2]]
    limit = row[Feature.GRIP] * weight
    if limit <= taken or up[2] <= ON_WHEELS:
        return v, o
    # What the brakes have taken, the tyres cannot give to the side.
    return _gripped(row, math.sqrt(limit**2 - taken**2), v, o, ahead, up)


def tipped(
    row: list[float], v: list[float], o: list[float], turn: Any
) -> tuple[list[float], list[float]]:
    """Linear and angular velocity of what has lost its balance: it leans on the way it does.

    It turns about the edge of its foot, as a blow that meets it off its centre would turn it.

    Args:
        row: Its `features`.
        v, o: Linear [m/s] and angular [rad/s] velocity.
        turn: Quaternion (x, y, z, w).
    """
    ahead, up = quat_rotate(turn, np.eye(3)[0]), quat_rotate(turn, np.eye(3)[2])
    if up[2] <= ON_WHEELS:
        return v, o
    length = math.hypot(ahead[0], ahead[1])
    fx, fy = float(ahead[0]) / length, float(ahead[1]) / length
    lean, right = fx * o[0] + fy * o[1], fy * up[0] - fx * up[1]
    rate, foot = row[Feature.TIP], row[Feature.FOOT]
    if abs(lean) >= rate:
        return v, o
    left = lean < 0.0 if abs(lean) > LEAST_LEAN_RAD_S else right < -LEAST_TILT
    more = (-rate if left else rate) - lean
    x, y, z = quat_rotate(turn, np.array([0.0, -foot if left else foot, row[Feature.DROP]]))
    return (
        [v[0] + fy * more * z, v[1] - fx * more * z, v[2] + more * (fx * y - fy * x)],
        [o[0] + fx * more, o[1] + fy * more, o[2]],
    )


def _height(row: list[float], fx: float, fy: float, up: Any) -> float:
    """Height [m] at which the centre of mass is over the edge that what leans stands on."""
    tilt = abs(fy * float(up[0]) - fx * float(up[1]))
    return row[Feature.DROP] * float(up[2]) + row[Feature.FOOT] * tilt


def _gripped(
    row: list[float], limit: float, v: list[float], o: list[float], ahead: Any, up: Any
) -> tuple[list[float], list[float]]:
    """Two axles, each with half the grip, against sliding to the side."""
    length = math.hypot(ahead[0], ahead[1])
    fx, fy = float(ahead[0]) / length, float(ahead[1]) / length
    axle, height = row[Feature.AXLE], _height(row, fx, fy, up)
    lean = row[Feature.LEAN] * height
    slip = (fx * v[1] - fy * v[0] + height * (fx * o[0] + fy * o[1])) / (1.0 + height * lean)
    yaw = axle * o[2]
    front = max(-limit, min(limit, slip + yaw))
    rear = max(-limit, min(limit, slip - yaw))
    side, turn = 0.5 * (front + rear), 0.5 * (front - rear)
    return (
        [v[0] + fy * side, v[1] - fx * side, v[2]],
        [o[0] - fx * lean * side, o[1] - fy * lean * side, o[2] - turn / axle],
    )
