"""Baselines: random search, cross-entropy and CMA-ES on the reference engine at a fixed budget.

They see the nominal loss only, as published optimizers of this kind do. The initial theta counts
as one of the rollouts.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.plan import Plan
from esg.dynamics.search.cloud import Cloud, spreads
from esg.dynamics.search.panel import Panel
from esg.outcomes import UserError

Floats = NDArray[np.float64]

BASELINES = ("random", "cem", "cma")
BATCH = 32


def minimize(
    plan: Plan, panel: Panel, rng: np.random.Generator, method: str, budget: int
) -> Floats:
    """The best theta of `budget` rollouts of the reference engine.

    Args:
        plan: Variables with bounds.
        panel: Engines; only the reference is used.
        rng: Source of all draws.
        method: random, cem or cma.
        budget: Rollouts.
    """
    method_of = {"random": _random, "cem": _cem, "cma": _cma}
    return method_of[method](plan, panel, rng, budget)


class _Best:
    """Keeps the best theta of all that were played."""

    def __init__(self, plan: Plan, panel: Panel) -> None:
        self.panel, self.theta, self.loss = panel, plan.initial(), np.inf

    def play(self, thetas: Floats) -> Floats:
        losses = self.panel.reference.assess(thetas).total
        k = int(np.argmin(losses))
        if losses[k] < self.loss:
            self.theta, self.loss = thetas[k].copy(), float(losses[k])
        self.panel.note("sample", "newton", len(thetas), self.loss)
        return losses


def _random(plan: Plan, panel: Panel, rng: np.random.Generator, budget: int) -> Floats:
    best = _Best(plan, panel)
    low, high, free = plan.lower(), plan.upper(), plan.free()
    for done in range(0, budget, BATCH):
        n = min(BATCH, budget - done)
        unit = rng.random((n, len(low)))
        thetas = np.where(free, low + unit * (high - low), plan.initial())
        if done == 0:
            thetas[0] = plan.initial()
        best.play(thetas)
    return best.theta


def _cem(plan: Plan, panel: Panel, rng: np.random.Generator, budget: int) -> Floats:
    best = _Best(plan, panel)
    cloud = Cloud(plan, spreads(plan))
    for done in range(0, budget, BATCH):
        thetas = cloud.draw(rng, min(BATCH, budget - done))
        cloud.learn(thetas, best.play(thetas), None)
    return best.theta


def _cma(plan: Plan, panel: Panel, rng: np.random.Generator, budget: int) -> Floats:
    try:
        import cma
    except ImportError as error:
        raise UserError("strategy 'cma' needs the package cma: pip install cma") from error
    best = _Best(plan, panel)
    index = np.flatnonzero(plan.free())
    scale = spreads(plan)[index]
    low, high = plan.lower()[index], plan.upper()[index]
    start = plan.initial()

    def full(points: list[Floats]) -> Floats:
        thetas = np.tile(start, (len(points), 1))
        thetas[:, index] = np.clip(start[index] + np.array(points) * scale, low, high)
        return thetas

    best.play(start[None])
    done = 1
    if not len(index):
        return best.theta
    options = {
        "popsize": BATCH, "seed": int(rng.integers(1, 2**31)), "verbose": -9,
        "bounds": [list((low - start[index]) / scale), list((high - start[index]) / scale)],
        # A single variable needs the diagonal form.
        "CMA_diagonal": len(index) == 1,
    }  # fmt: skip
    strategy = cma.CMAEvolutionStrategy(np.zeros(len(index)), 1.0, options)
    while done < budget and not strategy.stop():
        points = strategy.ask()[: budget - done]
        losses = best.play(full(points))
        done += len(points)
        if len(points) < BATCH:
            break
        strategy.tell(points, list(losses))
    return best.theta
