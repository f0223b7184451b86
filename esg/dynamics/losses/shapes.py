"""How much an error costs: the shapes of the event losses, for arrays and single numbers alike.

None of them is flat anywhere but at zero. What is far from happening still differs from what is
farther, so that a search that starts anywhere can tell the better of two candidates.
"""

from __future__ import annotations

from collections.abc import Callable
import math

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

MISSED = 10.0
"""Loss of an event that did not happen, before its distance is added."""
UNMET = 60.0
"""Loss of a quantity whose event did not happen: more than any error of one that did."""
STEEP = 50.0
"""An error costs as told by `bowl` up to here, and rises ever slower to `UNMET` from there on."""
FAR, FARTHEST, FAR_RANGE = 20.0, 25.0, 16.0
"""A miss costs its squared distance (in scales) up to here, then rises ever slower to that; it is
half way after so many scales more."""
UNBRAKED = 20.0
"""Loss of a brake that takes nothing of the speed, or sets in long after it should have."""


def bowl(x: Floats) -> Floats:
    """Quadratic near zero, linear further out, then ever flatter, less than `UNMET`."""
    x = np.abs(x)
    loss = np.where(x < 3.0, x * x, 6.0 * x - 9.0)
    room = UNMET - STEEP
    return np.where(loss < STEEP, loss, UNMET - room * room / (room + np.maximum(loss - STEEP, 0)))


def distance_loss(far: Floats) -> Floats:
    """What an event that did not happen costs beside `MISSED`, from its squared distance."""
    beyond = np.maximum(np.sqrt(np.maximum(far, 0.0)) - math.sqrt(FAR), 0.0) / FAR_RANGE
    return np.where(far < FAR, far, FARTHEST - (FARTHEST - FAR) / (1.0 + beyond))


def unbraked(excess: Floats) -> Floats:
    """Quadratic up to 9, then ever slower to `UNBRAKED`, shape [W]."""
    beyond = np.maximum(excess - 3.0, 0.0) / 15.0
    return np.where(excess < 3.0, excess**2, UNBRAKED - (UNBRAKED - 9.0) / (1.0 + beyond))


# -- single numbers, for residuals with derivatives ------------------------------------------------

Shape = Callable[[float], float]


def squared(scale: float) -> Shape:
    return lambda x: (x / scale) ** 2


def outside(low: float, high: float, scale: float) -> Shape:
    """Zero within an interval."""
    return lambda x: _bowl((max(x - high, 0.0) - max(low - x, 0.0)) / scale)


def inside(low: float, high: float, scale: float) -> Shape:
    """Zero well within an interval: a value on its edge does not survive another engine."""
    inner = 0.15 * (high - low)
    return lambda x: _bowl((max(x - (high - inner), 0.0) + max(low + inner - x, 0.0)) / scale)


def barrier(low: float, high: float) -> Shape:
    """The paper's smooth barrier of a guessed window, at a small weight."""
    width, beta = max(high - low, 0.5), 4.0

    def value(x: float) -> float:
        miss = np.logaddexp(0.0, beta * (low - x)) + np.logaddexp(0.0, beta * (x - high))
        return float(0.02 * (miss / (beta * width)) ** 2)

    return value


def _bowl(x: float) -> float:
    return float(bowl(np.asarray(x)))
