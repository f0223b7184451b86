"""Strategies `fd`, `ad` and `hybrid`: Adam on gradients of the event losses (the paper's).

All start from the best of a coarse 20-point sample of theta. A step masks fixed entries, replaces
NaN and infinite entries by zero, clips by the global norm and projects theta back into its bounds.
Steps are taken in units of each variable's spread, so that one step size serves speeds, times and
angles.

`fd` takes central differences of the reference engine, all 2 |theta| perturbations as parallel
worlds of one model. `ad` differentiates the surrogate by reverse mode. `hybrid` does `ad` as long
as the dependency graph allows it and goes on with `fd` where a later event starts from a body that
an earlier one set in motion: the switch is decided before anything is simulated.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses import kind_of
from esg.dynamics.plan import Plan
from esg.dynamics.search import Panel, Simulator
from esg.dynamics.story.story import Story

Floats = NDArray[np.float64]
Slope = Callable[[Floats], tuple[float, Floats]]
"""theta [n] -> loss and gradient by the free variables, in spreads [n_free]."""

COARSE_POINTS = 20
STEP_SIZE = 0.35
"""Adam step in spreads."""
DIFFERENCE = 0.4
"""Half width of the central difference in spreads."""
CLIP_NORM = 10.0
BETA_1, BETA_2, EPSILON = 0.9, 0.99, 1e-8
CONVERGED_LOSS = 0.02


@dataclass
class Descent:
    """Where a descent ended.

    Args:
        theta: The best theta seen, shape [n].
        loss: Its loss.
        stopped: Why it ended.
    """

    theta: Floats
    loss: float
    stopped: str = "rounds spent"
    history: list[float] = field(default_factory=list)


def descend(
    plan: Plan, panel: Panel, rng: np.random.Generator, strategy: str, max_steps: int
) -> Descent:
    """Minimizes the event losses by Adam.

    Args:
        plan: Variables with bounds and mask.
        panel: Engines.
        rng: Source of the coarse sample.
        strategy: ad, fd or hybrid.
        max_steps: Adam steps of each kind.
    """
    coarse = panel.reference if strategy == "fd" else panel.surrogate
    theta, loss = coarse_start(plan, coarse, rng)
    name = "newton" if strategy == "fd" else panel.explorer
    panel.note("coarse", name, COARSE_POINTS, loss)
    found = Descent(theta, loss)
    if strategy in ("ad", "hybrid"):
        found = _adam(plan, panel, theta, _tape_slope(plan, panel), "surrogate", max_steps)
    if strategy == "fd" or (strategy == "hybrid" and needs_differences(plan.story)):
        slope = _difference_slope(plan, panel.reference)
        found = _adam(plan, panel, found.theta, slope, "newton", max_steps)
    return found


def descend_from(plan: Plan, panel: Panel, theta: Floats, engine: str, max_steps: int) -> Descent:
    """Adam from a known theta on central differences of the panel's reference engine.

    Args:
        plan: Variables with bounds and mask.
        panel: Engines; only the reference is asked.
        theta: Where it starts, shape [n].
        engine: Its name in the record of the search.
        max_steps: Adam steps.
    """
    return _adam(plan, panel, theta, _difference_slope(plan, panel.reference), engine, max_steps)


def needs_differences(story: Story) -> bool:
    """Whether a body that an event receives as passive initiates a later one (the paper's test)."""
    received: set[str] = set()
    for node in story.outcomes:
        first = node.participants[:1]
        if received.intersection(first) and not story.is_active(first[0]):
            return True
        if kind_of(node).sends:
            received.update(p for p in node.participants[1:] if not story.is_active(p))
    return False


def _adam(
    plan: Plan, panel: Panel, start: Floats, slope: Slope, engine: str, max_steps: int
) -> Descent:
    low, high = plan.lower(), plan.upper()
    spread = np.array([max(v.spread, 1e-9) for v in plan.variables])
    index = np.flatnonzero(plan.free())
    theta = start.copy()
    best = Descent(start.copy(), np.inf)
    first, second = np.zeros(len(index)), np.zeros(len(index))
    for step in range(1, max_steps + 1):
        loss, gradient = slope(theta)
        if loss < best.loss:
            best.theta, best.loss = theta.copy(), loss
        panel.note("descend", engine, 1, best.loss)
        if best.loss < CONVERGED_LOSS or not len(index):
            best.stopped = "converged"
            break
        gradient = np.nan_to_num(gradient, nan=0.0, posinf=0.0, neginf=0.0)
        norm = float(np.linalg.norm(gradient))
        gradient = gradient * min(1.0, CLIP_NORM / max(norm, 1e-12))
        first = BETA_1 * first + (1.0 - BETA_1) * gradient
        second = BETA_2 * second + (1.0 - BETA_2) * gradient**2
        update = first / (1.0 - BETA_1**step)
        update /= np.sqrt(second / (1.0 - BETA_2**step)) + EPSILON
        theta = theta.copy()
        theta[index] -= STEP_SIZE * spread[index] * update
        theta = np.clip(theta, low, high)
    return best


def _difference_slope(plan: Plan, simulator: Simulator) -> Slope:
    """Central differences; theta and all perturbations are one batch of worlds."""
    low, high = plan.lower(), plan.upper()
    spread = np.array([max(v.spread, 1e-9) for v in plan.variables])
    index = np.flatnonzero(plan.free())

    def slope(theta: Floats) -> tuple[float, Floats]:
        offsets = np.zeros((2 * len(index), len(theta)))
        for k, i in enumerate(index):
            offsets[2 * k, i], offsets[2 * k + 1, i] = DIFFERENCE, -DIFFERENCE
        probes = np.clip(theta + offsets * spread, low, high)
        losses = simulator.assess(np.concatenate([theta[None], probes])).total
        width = np.array([probes[2 * k, i] - probes[2 * k + 1, i] for k, i in enumerate(index)])
        width = width / np.maximum(spread[index], 1e-12)
        gradient = (losses[1::2] - losses[2::2]) / np.where(width > 1e-9, width, np.inf)
        return float(losses[0]), gradient

    return slope


def _tape_slope(plan: Plan, panel: Panel) -> Slope:
    """Reverse mode through the surrogate; the loss itself is the same as everywhere else."""
    from esg.dynamics.gradient.differentiate import gradient as differentiate

    spread = np.array([max(v.spread, 1e-9) for v in plan.variables])
    index = np.flatnonzero(plan.free())

    def slope(theta: Floats) -> tuple[float, Floats]:
        found = differentiate(plan, theta[None], device=panel.device, dt=panel.surrogate.dt)
        panel.surrogate.evaluations += 1
        loss = float(panel.surrogate.assess(theta[None]).total[0])
        return loss, found.gradient[0][index] * spread[index]

    return slope


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
