"""Several searches at once in different basins, each a small CMA-ES within the bounds.

A cloud around one point finds what is near. Where the first sample of all theta's box shows several
places that may do, or where what counts is a combination of variables (the faster a car, the
earlier it has to turn), a search per place that learns the variables' correlations gets there with
a tenth of the rollouts (N. Hansen, The CMA Evolution Strategy: A Tutorial, 2016).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.plan import Plan

Floats = NDArray[np.float64]

WIDE, BROADEST = 0.12, 10.0
"""First spread of a niche as a share of the box, at most so many usual spreads."""
APART = 0.12
"""Root mean square distance of two niches' centres, as a share of the box."""
ELITES = 2
"""The best so far that a niche learns from beside its new candidates: it gets there sooner."""
MANY = 9
"""Free variables beyond which first spreads shrink, so that a candidate goes no farther."""
WIDEST = 4.0
"""Largest factor on the first spread."""
GAIN = 0.02
"""What a generation has to gain, or the niche is idle."""
COLLAPSED = 1e-3
"""Standard deviation, in first spreads, below which a niche has nothing left to find."""


class Niche:
    """A CMA-ES of the free variables in units of their first spread.

    Args:
        plan: Variables with bounds and mask.
        center: Where it starts, shape [n].
        loss: The center's.
        scale: First spread of each variable, zero for those that stay, some above it, shape [n].
    """

    def __init__(self, plan: Plan, center: Floats, loss: float, scale: Floats) -> None:
        self.plan, self.center, self.best = plan, center.copy(), loss
        self.index = np.flatnonzero(scale > 0.0)
        self.scale = scale[self.index]
        n = len(self.index)
        self.sigma, self.covariance = 1.0, np.eye(n)
        self._path, self._push = np.zeros(n), np.zeros(n)
        self._elites, self._kept = self.center[None], np.array([loss])
        self._asked = self._elites
        self.rounds, self.idle = 0, 0

    def ask(self, rng: np.random.Generator, count: int) -> Floats:
        """Candidates, shape [count, n]."""
        values, vectors = np.linalg.eigh(self.covariance)
        self._root = vectors * np.sqrt(np.maximum(values, 1e-12))
        self._inverse = (vectors / np.sqrt(np.maximum(values, 1e-12))) @ vectors.T
        steps = rng.standard_normal((count, len(self.index))) @ self._root.T
        low, high = self.plan.lower()[self.index], self.plan.upper()[self.index]
        middle = self.center[self.index]
        thetas = np.tile(self.center, (count, 1))
        thetas[:, self.index] = np.clip(middle + self.sigma * self.scale * steps, low, high)
        self._asked = thetas
        return thetas

    def tell(self, losses: Floats) -> None:
        """Learns from the losses of the last candidates, shape [count], and the elites' before."""
        n, half = len(self.index), len(losses) // 2
        pool = np.concatenate([self._elites, self._asked])
        scores = np.concatenate([self._kept, losses])
        order = np.argsort(scores, kind="stable")[:half]
        gained = self.best - float(scores[order[0]])
        self.idle = 0 if gained > GAIN else self.idle + 1
        self.best = min(self.best, float(scores[order[0]]))
        chosen = (pool[order] - self.center)[:, self.index] / (self.sigma * self.scale)
        self._elites, self._kept = pool[order[:ELITES]], scores[order[:ELITES]]
        weights = math.log(half + 0.5) - np.log(np.arange(1, half + 1))
        weights /= weights.sum()
        effective = 1.0 / float((weights**2).sum())
        c_sigma = (effective + 2.0) / (n + effective + 5.0)
        d_sigma = 1.0 + 2.0 * max(0.0, math.sqrt((effective - 1.0) / (n + 1.0)) - 1.0) + c_sigma
        c_path = (4.0 + effective / n) / (n + 4.0 + 2.0 * effective / n)
        c_one = 2.0 / ((n + 1.3) ** 2 + effective)
        c_mu = 2.0 * (effective - 2.0 + 1.0 / effective) / ((n + 2.0) ** 2 + effective)
        c_mu = min(1.0 - c_one, c_mu)
        expected = math.sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n))
        step = weights @ chosen
        self.center = self.center.copy()
        self.center[self.index] += self.sigma * self.scale * step
        self._push = (1.0 - c_sigma) * self._push + math.sqrt(
            c_sigma * (2.0 - c_sigma) * effective
        ) * (self._inverse @ step)
        length = float(np.linalg.norm(self._push))
        self.rounds += 1
        steady = length / math.sqrt(1.0 - (1.0 - c_sigma) ** (2 * self.rounds))
        still = steady < (1.4 + 2.0 / (n + 1.0)) * expected
        self._path = (1.0 - c_path) * self._path
        if still:
            self._path += math.sqrt(c_path * (2.0 - c_path) * effective) * step
        rank_mu = (chosen * weights[:, None]).T @ chosen
        self.covariance = (
            (1.0 - c_one - c_mu) * self.covariance
            + c_one * np.outer(self._path, self._path)
            + c_mu * rank_mu
        )
        self.sigma *= math.exp(min(1.0, c_sigma / d_sigma * (length / expected - 1.0)))
        self.sigma = min(self.sigma, WIDEST)

    @property
    def collapsed(self) -> bool:
        """Whether its spread has shrunk to nothing."""
        deviation = self.sigma * np.sqrt(np.diag(self.covariance))
        return bool(deviation.max(initial=0.0) < COLLAPSED)


def broad(plan: Plan) -> Floats:
    """First spread of a niche, zero for fixed variables, shape [n]."""
    width = plan.upper() - plan.lower()
    usual = np.array([v.spread for v in plan.variables])
    usual = np.where(usual > 0.0, usual, WIDE * width)
    broad = np.clip(WIDE * width, np.minimum(usual, 0.5 * width), BROADEST * usual) * plan.free()
    return broad * min(1.0, MANY / max(int((broad > 0.0).sum()), 1))


def everywhere(plan: Plan, rng: np.random.Generator, count: int, center: Floats) -> Floats:
    """A stratified sample of the box; every third candidate of the wider surroundings of a point.

    Bounds may be far wider than what makes sense: the surroundings are 20 usual spreads to either
    side.

    Returns:
        Shape [count, n].
    """
    low, high, free = plan.lower(), plan.upper(), plan.free()
    n = len(low)
    reach = 20.0 * np.array([v.spread for v in plan.variables])
    near = np.arange(count) % 3 == 2
    unit = np.empty((count, n))
    for rows in (~near, near):
        k = int(rows.sum())
        if k:
            strata = np.stack([rng.permutation(k) for _ in range(n)], axis=1)
            unit[rows] = (strata + rng.random((k, n))) / k
    lower = np.where(near[:, None], np.maximum(low, center - reach), low)
    upper = np.where(near[:, None], np.minimum(high, center + reach), high)
    return np.where(free, lower + unit * (upper - lower), center)


def apart(plan: Plan, thetas: Floats, losses: Floats, count: int, taken: list[Floats]) -> list[int]:
    """Indices of the best candidates that lie apart from each other and from `taken`.

    Args:
        plan: Variables.
        thetas: Shape [K, n].
        losses: Shape [K].
        count: How many at most.
        taken: Places that are occupied, each of shape [n].
    """
    free = plan.free()
    width = np.maximum(plan.upper() - plan.lower(), 1e-12)
    # Within wide bounds usual spreads tell places apart.
    width = np.minimum(width, np.array([100.0 * max(v.spread, 1e-9) for v in plan.variables]))
    places, chosen = [t[free] / width[free] for t in taken], []
    for k in np.argsort(losses, kind="stable"):
        if len(chosen) == count:
            break
        place = thetas[k][free] / width[free]
        if all(float(np.sqrt(np.mean((place - p) ** 2))) >= APART for p in places):
            places.append(place)
            chosen.append(int(k))
    return chosen
