"""How bodies break in engines that step one world at a time.

Normal impulses that a body takes add up over `BREAK_WINDOW_S`. After the step in which their sum
exceeds its `break_impulse`, it is swapped: what the step gave beyond that is taken back from both
sides (nothing can press harder on a body than breaks it, so that a stone keeps what a pane cannot
take), and its fragments go on as its parts did. Mass, momentum and angular momentum stay the same.
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
from esg.units import quat_rotate


class BreakableWorld(BodyAccess, Protocol):
    """A world whose bodies can be taken out and put in."""

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
        self._scene, self._masses, self._world = scene, masses, world
        self._all = brittle(scene)
        self._left = list(self._all)
        steps = max(1, round(BREAK_WINDOW_S / dt))
        self._taken = {b.whole: deque([0.0] * steps, maxlen=steps) for b in self._all}
        self._gone: dict[int, tuple[Any, Any]] = {}
        for b in self._all:
            for piece in b.pieces:
                world.retire(piece)

    def after_step(self, touches: Sequence[Touch]) -> None:
        """Swaps what has broken in a step.

        Args:
            touches: Of its contact points, one by one, the ground's as well.
        """
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
            for piece, state in zip(b.pieces, zip(*rigid(b, *self._read(b.whole)), strict=True), strict=True):
                out[piece] = state
        return out

    def _read(self, body: int) -> tuple[Any, Any, Any, Any]:
        if self._masses.inverse[body] == 0.0:
            still = np.zeros(3)
            return self._masses.position[body], self._masses.quaternion[body], still, still
        return self._world.read(body)

    def _swap(self, b: Brittle, touches: Sequence[Touch], share: float) -> None:
        # Of several that break in one step each takes back its own; what is gone takes nothing.
        x, q, v, w = (np.asarray(a, float) for a in self._read(b.whole))
        for first, second, impulse, _, point, normal in touches:
            back = share * impulse * np.asarray(normal, float)
            for body, push in ((first, -back), (second, back)):
                if body == b.whole:
                    dv, dw = self._change(body, x, q, push, point)
                    v, w = v + dv, w + dw
                elif body >= 0 and body not in self._gone and self._masses.inverse[body] > 0.0:
                    at, turn, speed, spin = (np.asarray(a, float) for a in self._read(body))
                    dv, dw = self._change(body, at, turn, push, point)
                    self._world.set_linear(body, _vec(speed + dv))
                    self._world.set_angular(body, _vec(spin + dw))
        self._world.retire(b.whole)
        self._gone[b.whole] = (x, q)
        for piece, state in zip(b.pieces, zip(*rigid(b, x, q, v, w), strict=True), strict=True):
            self._world.release(piece, *state)

    def _change(self, body: int, at: Floats, turn: Floats, push: Floats, point: Any) -> tuple[Floats, Floats]:
        """What an impulse at a point does to both velocities of a body."""
        axes = quat_rotate(turn, np.eye(3)).T
        inverse = axes @ self._masses.inverse_inertia[body] @ axes.T
        return push * self._masses.inverse[body], inverse @ np.cross(np.asarray(point) - at, push)


def _vec(v: Floats) -> tuple[float, float, float]:
    return float(v[0]), float(v[1]), float(v[2])
