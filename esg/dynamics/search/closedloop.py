"""The closed loop: the verify engine's outcome error fed back as a shifted target, few rounds.

The reference and the verify engine measure the same theta a little differently. What the verify
engine measures too little is added to the target of the next search. Off unless asked for, and
always reported beside the open loop's figures.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from esg.dynamics.losses import Assessment
from esg.dynamics.losses.quantities import quantity_of
from esg.dynamics.plan import Plan
from esg.dynamics.search.panel import Found, rounded
from esg.dynamics.search.simulate import Simulator
from esg.engines.base import VERIFY_DT_S
from esg.engines.registry import get_engine
from esg.graph.models import ClosedLoop

VERIFY_ENGINE = "physx"
SATISFIED = 0.25
"""Largest error, in units of its tolerance, with which the loop ends."""

Search = Callable[[dict[str, float], int], Found]
"""Bias by constraint and number of the round -> the best theta under it."""


def close_loop(plan: Plan, found: Found, search: Search, rounds: int) -> tuple[Found, ClosedLoop]:
    """Searches again with shifted targets until the verify engine is satisfied.

    Args:
        plan: What is searched.
        found: The open loop's result.
        search: Runs the search once more.
        rounds: At most.

    Returns:
        The result the verify engine likes best (the open loop's if nothing is better), and the
        figures of both.
    """
    verify = Simulator(plan, get_engine(VERIFY_ENGINE), dt=VERIFY_DT_S)
    outcome = verify.assess(found.theta[None])
    best, best_score = found, score(outcome)
    first = last = figures(outcome)
    bias: dict[str, float] = {}
    done = 0
    current, seen = found, outcome
    while done < rounds and not satisfied(last):
        for name, value in seen.measured.items():
            shift = float(current.nominal.measured[name][0] - value[0])
            if np.isfinite(shift):
                bias[name] = shift
        done += 1
        current = search(bias, done)
        seen = verify.assess(current.theta[None])
        if score(seen) < best_score:
            best, best_score, last = current, score(seen), figures(seen)
    return best, ClosedLoop(
        engine=VERIFY_ENGINE, dt_s=VERIFY_DT_S, rounds=done, open=first, closed=last
    )


def score(outcome: Assessment) -> float:
    """Loss of one world without the guessed windows' and margins' small terms."""
    missing = sum(0.0 if v[0] else 1.0 for v in outcome.completed.values())
    return 100.0 * missing + max(_errors(outcome), default=0.0) + 0.01 * float(outcome.total[0])


def figures(outcome: Assessment) -> dict[str, float]:
    """Share of completed events and largest error in units of its tolerance."""
    done = [bool(v[0]) for v in outcome.completed.values()]
    return {
        "completed": rounded(float(np.mean(done)) if done else 1.0),
        "largest_error": rounded(max(_errors(outcome), default=0.0)),
    }


def satisfied(values: dict[str, float]) -> bool:
    """Whether nothing is left to correct."""
    return values["completed"] >= 1.0 and values["largest_error"] <= SATISFIED


def _errors(outcome: Assessment) -> list[float]:
    return [
        min(abs(float(np.nan_to_num(e[0], nan=1e3, posinf=1e3))) / quantity_of(n).tolerance, 1e3)
        for n, e in outcome.error.items()
    ]
