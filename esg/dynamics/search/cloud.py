"""Where candidates are drawn from: near a theta, and nearer with every round (cross-entropy)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses.shapes import MISSED
from esg.dynamics.plan import Plan

Floats = NDArray[np.float64]

ELITES = 6


class Cloud:
    """The distribution candidates are drawn from: a diagonal Gaussian within the bounds.

    Its spread never falls below a decaying floor, and is widened while an event never happened.

    Args:
        plan: Variables.
        scale: Spread of each variable at the start, shape [n].
        center: Where it starts; the choreographed theta if None.
    """

    def __init__(self, plan: Plan, scale: Floats, center: Floats | None = None) -> None:
        self.plan, self.scale, self.spread = plan, scale, scale
        self.mean = plan.initial() if center is None else center
        self.rounds = 0
        self.elites: Floats = np.zeros((0, len(scale)))
        self.kept: Floats = np.zeros(0)

    def draw(self, rng: np.random.Generator, n: int) -> Floats:
        """Candidates, the mean first, shape [n, variables]."""
        return around(self.plan, self.mean, self.spread, rng, n)

    def learn(self, thetas: Floats, losses: Floats, anchor: Floats | None) -> Floats:
        """Moves towards the best; returns all known elites, the best first.

        Args:
            thetas: Shape [W, n].
            losses: Shape [W].
            anchor: A theta that counts among the elites, None for none.
        """
        pool, scores = np.concatenate([self.elites, thetas]), np.concatenate([self.kept, losses])
        order = np.argsort(scores, kind="stable")[:ELITES]
        self.elites, self.kept = pool[order], scores[order]
        members = self.elites if anchor is None else np.concatenate([self.elites, anchor[None]])
        self.mean = members.mean(axis=0)
        floor = 0.35 * 0.8**self.rounds * self.scale
        self.spread = np.maximum(1.3 * self.elites.std(axis=0), floor)
        if self.kept[0] > 0.8 * MISSED:
            # An event never happened yet: look further afield instead of closing in.
            self.spread = np.maximum(self.spread, 1.6 * self.scale)
        self.rounds += 1
        return self.elites


def spreads(plan: Plan) -> Floats:
    """Usual change of each variable, zero for fixed ones, shape [n]."""
    return np.array([v.spread for v in plan.variables]) * plan.free()


def around(plan: Plan, mean: Floats, spread: Floats, rng: np.random.Generator, n: int) -> Floats:
    """Gaussian candidates within the bounds, the mean itself first, shape [n, variables]."""
    thetas = np.clip(
        mean + spread * rng.standard_normal((n, len(mean))), plan.lower(), plan.upper()
    )
    thetas[0] = np.clip(mean, plan.lower(), plan.upper())
    return thetas
