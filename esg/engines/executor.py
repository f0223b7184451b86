"""The reference executor of control programs, for engines that step one world at a time.

It implements the semantics stated in `esg.engines.program` word for word in double precision; the
Warp kernel of the Newton engine is tested against it.
"""

from __future__ import annotations

from collections.abc import Iterable
import math
from typing import Protocol

import numpy as np

from esg.engines.program import ProgramBatch

SET_VELOCITY, APPLY_IMPULSE, ADJUST, HOLD = range(4)
"""Indices into `esg.engines.program.KINDS`."""

Vec = tuple[float, float, float]


class BodyAccess(Protocol):
    """What the executor needs from a world: velocities and properties by body index."""

    def linear(self, body: int) -> Vec: ...
    def set_linear(self, body: int, velocity: Vec) -> None: ...
    def set_angular(self, body: int, velocity: Vec) -> None: ...
    def mass(self, body: int) -> float: ...
    def set_linear_damping(self, body: int, damping: float) -> None: ...
    def set_angular_damping(self, body: int, damping: float) -> None: ...
    def set_friction(self, body: int, friction: float) -> None: ...


class Executor:
    """Executes one world's program step by step.

    Args:
        batch: W programs.
        world: Which of them.
    """

    def __init__(self, batch: ProgramBatch, world: int) -> None:
        self._kind = [int(k) for k in batch.kind]
        self._body = [int(b) for b in batch.body]
        self._rows = [[float(v) for v in row] for row in batch.table[world]]
        self._until = [frozenset(np.nonzero(u)[0].tolist()) for u in batch.until]
        n = len(self._kind)
        self._done = [False] * n
        self._active = [False] * n
        self._pending = list(range(n))

    @property
    def watched(self) -> frozenset[tuple[int, int]]:
        """Pairs (a < b) whose touch ends a hold."""
        pairs = {
            (min(self._body[k], other), max(self._body[k], other))
            for k in range(len(self._kind))
            for other in self._until[k]
        }
        return frozenset(pairs)

    def before_step(
        self, t: float, dt: float, touched: Iterable[tuple[int, int]], world: BodyAccess
    ) -> None:
        """Does what the program asks for before the step from t to t + dt.

        Args:
            t: Time of the state [s].
            dt: Physics step [s].
            touched: Body pairs (a < b) with a normal impulse > 0 in the step before this one.
            world: The bodies.
        """
        if not self._pending:
            return
        now = t + 0.5 * dt
        hits = set(touched)
        for k in self._pending:
            row, body = self._rows[k], self._body[k]
            if self._kind[k] == HOLD:
                if self._hold_is_active(k, now, hits):
                    _hold(row, body, t, world)
            elif row[0] <= now:
                self._done[k] = True
                _fire(self._kind[k], row, body, world)
        self._pending = [k for k in self._pending if not self._done[k]]

    def _hold_is_active(self, k: int, now: float, hits: set[tuple[int, int]]) -> bool:
        body, row = self._body[k], self._rows[k]
        if self._active[k] and any(
            (min(body, other), max(body, other)) in hits for other in self._until[k]
        ):
            self._done[k] = True
        if now > row[1]:
            self._done[k] = True
        if not self._done[k] and row[0] <= now:
            self._active[k] = True
        return self._active[k] and not self._done[k]


def _fire(kind: int, row: list[float], body: int, world: BodyAccess) -> None:
    if kind == SET_VELOCITY:
        world.set_linear(body, (row[2], row[3], row[4]))
        if not math.isnan(row[5]):
            world.set_angular(body, (row[5], row[6], row[7]))
    elif kind == APPLY_IMPULSE:
        v, m = world.linear(body), world.mass(body)
        world.set_linear(body, (v[0] + row[2] / m, v[1] + row[3] / m, v[2] + row[4] / m))
    elif kind == ADJUST:
        if not math.isnan(row[2]):
            world.set_linear_damping(body, row[2])
        if not math.isnan(row[3]):
            world.set_angular_damping(body, row[3])
        if not math.isnan(row[4]):
            world.set_friction(body, row[4])


def _hold(row: list[float], body: int, t: float, world: BodyAccess) -> None:
    s = t - row[0]
    speed = max(0.0, row[2] + row[4] * s)
    if row[4] > 0.0:
        speed = min(speed, row[5])
    heading = row[3] + row[6] * s
    vx, vy = speed * math.cos(heading), speed * math.sin(heading)
    world.set_linear(body, (vx, vy, world.linear(body)[2]))
    if row[7] == 0.0:
        world.set_angular(body, (0.0, 0.0, row[6]))
    else:
        world.set_angular(body, (-vy / row[7], vx / row[7], 0.0))
