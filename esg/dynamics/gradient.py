"""Strategy `fd`: Adam on finite differences of the reference engine (paper, FD-only).

A coarse 20-point sample of theta gives the start. Each step simulates 2 |theta| perturbed worlds of
one model, masks fixed entries, replaces NaN and infinite entries by zero, clips by the global norm
and projects theta back into its bounds (paper, implementation and parameter update). Steps are
taken in units of each variable's spread, so that one step size serves speeds, times and angles.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.plan import Plan
from esg.dynamics.simulate import Simulator

Floats = NDArray[np.float64]

COARSE_POINTS = 20
MAX_STEPS = 30
STEP_SIZE = 0.35
"""Adam step in spreads."""
DIFFERENCE = 0.4
"""Half width of the central difference in spreads."""
CLIP_NORM = 10.0
BETA_1, BETA_2, EPSILON = 0.9, 0.99, 1e-8
CONVERGED_LOSS = 0.02


@dataclass(frozen=True)
class Descent:
    """Where the descent ended.

    Args:
        theta: The best theta seen, shape [n].
        loss: Its loss.
        history: Best loss after the coarse sample and after every step.
    """

    theta: Floats
    loss: float
    history: tuple[float, ...]


def descend(
    plan: Plan, simulator: Simulator, rng: np.random.Generator, *, max_steps: int = MAX_STEPS
) -> Descent:
    """Minimizes the event losses by finite-difference Adam.

    Args:
        plan: Variables with bounds and mask.
        simulator: Of the reference engine.
        rng: Source of the coarse sample.
        max_steps: Adam steps.
    """
    low, high, free = plan.lower(), plan.upper(), plan.free()
    spread = np.array([max(v.spread, 1e-9) for v in plan.variables])
    index = np.flatnonzero(free)
    theta, best = coarse_start(plan, simulator, rng)
    best_theta, history = theta.copy(), [best]
    first, second = np.zeros(len(index)), np.zeros(len(index))
    for step in range(1, max_steps + 1):
        if best < CONVERGED_LOSS or not len(index):
            break
        offsets = np.zeros((2 * len(index), len(theta)))
        for k, i in enumerate(index):
            offsets[2 * k, i], offsets[2 * k + 1, i] = DIFFERENCE, -DIFFERENCE
        probes = np.clip(theta + offsets * spread, low, high)
        losses = simulator.assess(np.concatenate([theta[None], probes])).total
        if losses[0] < best:
            best, best_theta = float(losses[0]), theta.copy()
        history.append(best)
        width = np.array(
            [probes[2 * k, i] - probes[2 * k + 1, i] for k, i in enumerate(index)]
        ) / np.maximum(spread[index], 1e-12)
        gradient = (losses[1::2] - losses[2::2]) / np.where(width > 1e-9, width, np.inf)
        gradient = np.nan_to_num(gradient, nan=0.0, posinf=0.0, neginf=0.0)
        norm = float(np.linalg.norm(gradient))
        gradient *= min(1.0, CLIP_NORM / max(norm, 1e-12))
        first = BETA_1 * first + (1.0 - BETA_1) * gradient
        second = BETA_2 * second + (1.0 - BETA_2) * gradient**2
        update = first / (1.0 - BETA_1**step)
        update /= np.sqrt(second / (1.0 - BETA_2**step)) + EPSILON
        theta = theta.copy()
        theta[index] -= STEP_SIZE * spread[index] * update
        theta = np.clip(theta, low, high)
    return Descent(best_theta, best, tuple(history))


def coarse_start(
    plan: Plan, simulator: Simulator, rng: np.random.Generator
) -> tuple[Floats, float]:
    """The best of the initial theta and a stratified sample between the bounds."""
    low, high, free = plan.lower(), plan.upper(), plan.free()
    n = len(low)
    strata = np.stack([rng.permutation(COARSE_POINTS) for _ in range(n)], axis=1)
    unit = (strata + rng.random((COARSE_POINTS, n))) / COARSE_POINTS
    thetas = np.where(free, low + unit * (high - low), plan.initial())
    thetas[0] = plan.initial()
    losses = simulator.assess(thetas).total
    k = int(np.argmin(losses))
    return thetas[k], float(losses[k])
