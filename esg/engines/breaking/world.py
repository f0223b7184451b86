"""How bodies break in engines that step one world at a time.

Normal impulses that a body takes add up over `BREAK_WINDOW_S`. After the step in which their sum
exceeds its `break_impulse`, it is swapped: of what the step's contacts did to it and to what
touched it the share beyond that is taken back (nothing can press harder on a body than breaks it,
so that a stone keeps what a pane cannot take), and its fragments go on as its parts did.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np

from esg.engines.breaking.swap import Brittle, brittle, rigid
from esg.engines.executor import BodyAccess, Touch
from esg.engines.joint_rules import BREAK_WINDOW_S, Masses
from esg.engines.joints import Floats
from esg.engines.scene import SimScene


class BreakableWorld(BodyAccess, Protocol):
    """A world whose bodies can be taken out and put in."""

    moving: list[int]

    def retire(self, body: int) -> None:
        """Takes a body out: it neither moves nor touches."""
        ...

    def release(self, body: int, at: Floats, turn: Floats, linear: Floats, angular: Floats) -> None:
        """Puts a body in, with a pose and velocities."""
        ...


class Breaks:
    """What of one world breaks, and has broken.

    Args:
        scene: Its bodies.
        masses: Of them.
        dt: The step [s].
        world: Its bodies; fragments are taken out of it.
    """

    def __init__(self, scene: SimScene, masses: Masses, dt: float, world: BreakableWorld) -> None:
        self._masses, self._world = masses, world
        self._all = brittle(scene)
        self._left = list(self._all)
        steps = max(1, round(BREAK_WINDOW_S / dt))
        self._taken = {b.whole: deque([0.0] * steps, maxlen=steps) for b in self._all}
        self._gone: dict[int, tuple[Any, ...]] = {}
        self._before: dict[int, tuple[Any, ...]] = {}
        self._pull = np.array(scene.gravity) * dt
        for b in self._all:
            for piece in b.pieces:
                world.retire(piece)

    def before_step(self) -> None:
        """Looks at the bodies once everything that acts before the step has acted."""
        if self._left:
            self._before = {i: self._world.read(i)[2:] for i in self._world.moving}

    def after_step(self, touches: Sequence[Touch]) -> None:
        """Swaps what has broken in a step; `touches` are the ground's as well."""
        for b in list(self._left):
            own = [t for t in touches if b.whole in t[:2]]
            step = sum(t[2] for t in own)
            taken = self._taken[b.whole]
            taken.append(step)
            if sum(taken) > b.impulse:
                self._left.remove(b)
                self._swap(b, own, min(1.0, (sum(taken) - b.impulse) / step))

    def states(self) -> dict[int, tuple[Any, Any, Any, Any]]:
        """Pose and velocities of what is not there, by body."""
        out: dict[int, tuple[Any, Any, Any, Any]] = {}
        still = np.zeros(3)
        for whole, pose in self._gone.items():
            out[whole] = (*pose, still, still)
        for b in self._left:
            for piece, state in zip(
                b.pieces, zip(*rigid(b, *self._read(b.whole)), strict=True), strict=True
            ):
                out[piece] = state
        return out

    def _read(self, body: int) -> tuple[Any, Any, Any, Any]:
        if self._masses.inverse[body] == 0.0:
            still = np.zeros(3)
            return self._masses.position[body], self._masses.quaternion[body], still, still
        return self._world.read(body)

    def _swap(self, b: Brittle, touches: Sequence[Touch], share: float) -> None:
        met = {i for t in touches for i in t[:2] if i >= 0 and i not in self._gone}
        for body in met & {*self._world.moving}:
            _, _, v, w = (np.asarray(a, float) for a in self._world.read(body))
            before, spin = (np.asarray(a, float) for a in self._before[body])
            v -= share * (v - before - self._pull)
            w -= share * (w - spin)
            self._world.set_linear(body, _vec(v))
            self._world.set_angular(body, _vec(w))
        state = self._read(b.whole)
        self._world.retire(b.whole)
        self._gone[b.whole] = tuple(np.asarray(a, float) for a in state[:2])
        for piece, own in zip(b.pieces, zip(*rigid(b, *state), strict=True), strict=True):
            self._world.release(piece, *own)


def _vec(v: Floats) -> tuple[float, float, float]:
    return float(v[0]), float(v[1]), float(v[2])
