"""What of a recording shines and sways, told from the time alone: no engine knows of either."""

from __future__ import annotations

from collections.abc import Mapping
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Body, Shine, Sway

Floats = NDArray[np.float64]

TURN_S = 0.6
"""What changes at no event of the scene does so this long after its start [s]."""
LIT_SHARE = 0.5
"""Of the time of a flash, in which it shines."""
STEADY = 0.3
"""What bends in the wind leans by this share of its largest angle, and swings by the rest."""


def turns_at(shine: Shine, events: Mapping[str, float | None]) -> float:
    """When a light changes [s]; never if its event did not happen."""
    if not shine.event:
        return TURN_S
    at = events.get(shine.event)
    return math.inf if at is None else at


def shining(shine: Shine, time: Floats, events: Mapping[str, float | None]) -> NDArray[np.bool_]:
    """Whether a light shines at times [s], shape [T].

    Args:
        shine: The light.
        time: [s], shape [T].
        events: Times of the events [s], None for those that did not happen.
    """
    time = np.asarray(time, float)
    on = np.where(time < turns_at(shine, events), shine.before, shine.after)
    if shine.period_s > 0.0:
        on = on & (np.mod(time + 1e-9, shine.period_s) < LIT_SHARE * shine.period_s)
    return on.astype(bool)


def phase_of(body: Body) -> float:
    """Of what sways [rad], another for each body, the same in every run."""
    return 2.399963 * sum(body.name.encode())


def bent_by(sway: Sway, time: Floats, phase: float) -> Floats:
    """By what angle it is bent at times [rad], shape [T]; of what waves, along its length."""
    turn = 2.0 * math.pi * np.asarray(time, float) / sway.period_s + phase
    steady = STEADY if sway.how == "bends" else 0.0
    return math.radians(sway.degrees) * (steady + (1.0 - steady) * np.sin(turn))
