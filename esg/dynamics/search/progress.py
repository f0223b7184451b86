"""When rounds of candidates still come nearer, and when a search gives up on what is missing."""

from __future__ import annotations

from esg.dynamics.losses.shapes import MISSED
from esg.dynamics.plan import Plan

LEAST_GAIN = 0.02
"""What rounds have to gain where all events happen: absolutely, more for each event but two, and as
a share of the worst case."""
FAR_GAIN = 0.05
"""What rounds have to gain while an event is missed."""
NEARER, POOR = 1.0, 2.0
"""A round that misses an event has to come nearer by this much, or the search looks further
afield; it also does where events happen with this worst case or more and rounds do not help. The
worst case is a sum over the events: `poor`."""
EVENTS = 2
"""Events to which `POOR` applies; of more, each may add as much."""
PATIENCE = 3
"""Rounds without progress after which a search gives up on what is still missing."""


def poor(plan: Plan) -> float:
    """Worst case from which on a search looks further afield; below what a missed event costs."""
    events = len(plan.story.outcomes)
    return min(POOR * max(1.0, events / EVENTS), 0.9 * MISSED)


def least_gain(plan: Plan) -> float:
    """What some rounds have to gain once all events happen."""
    return LEAST_GAIN * max(1, len(plan.story.outcomes) - 1)


def nearing(history: list[float], enough: float) -> bool:
    """Whether the last round came nearer, or hardly anything is missing any more."""
    gained = history[-2] - history[-1]
    return history[-1] <= enough or gained >= min(NEARER, 0.1 * history[-2])


def stalled(history: list[float], *, reached: bool, gain: float = LEAST_GAIN) -> bool:
    """The last rounds gained nothing; twice as many are granted while an event is missing."""
    patience = PATIENCE if reached else 2 * PATIENCE
    if len(history) < patience + 2:
        return False
    earlier, now = min(history[:-patience]), min(history)
    # Far from an event losses differ little: there any gain is one.
    return earlier - now < (max(gain, LEAST_GAIN * earlier) if reached else FAR_GAIN)
