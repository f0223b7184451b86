"""Strategy `batched`: sample, explore in the surrogate, decide in the reference engine.

Thousands of rollouts of the fused surrogate cost what a few hundred of the reference engine do.
They choose, by worst case over the ensemble, the candidates that the reference engine then plays
under the same ensemble. Where the two disagree, a short cross-entropy search in the reference
engine goes on from there.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses import MISSED
from esg.dynamics.panel import GOOD_LOSS, Found, Panel, prior
from esg.dynamics.plan import Plan

Floats = NDArray[np.float64]

STARTS = 4
"""Candidates around the choreographed start that are judged before anything is searched."""
POPULATION = 48
WORLDS = 32
ELITES = 6
FINALISTS = 4
PATIENCE = 3
"""Rounds without progress after which a search gives up on what is still missing."""
REFERENCE_SHARE = 0.4
"""Rounds of the reference engine as a share of the surrogate's."""
AGREED = 1.2
"""Worst cases that differ by less than this factor (or `GOOD_LOSS`) say the same of a theta."""


@dataclass(frozen=True)
class Explored:
    """What the surrogate found.

    Args:
        finalists: In order of their worst case, the best first, shape [K, n].
        worst: Of the best.
        stalled: Whether more rounds no longer improved it.
    """

    finalists: Floats
    worst: float
    stalled: bool

    @property
    def reached(self) -> bool:
        """Whether the best of them is as good as nothing could be that misses an event."""
        return self.worst < MISSED


def search(
    plan: Plan,
    panel: Panel,
    rng: np.random.Generator,
    max_rounds: int,
    barred: frozenset[str] = frozenset(),
) -> tuple[Found, str]:
    """The most robust theta found, and why the search stopped.

    Args:
        plan: Variables with bounds and mask.
        panel: Engines.
        rng: Source of all draws.
        max_rounds: Batches of candidates in the surrogate; the reference engine gets 40% of that.
        barred: Events that physics rules out (`feasibility`) and what follows from them: nothing is
            searched where all others happen.
    """
    if barred:
        first = panel.judge(plan.initial()[None])
        if all(first.nominal.completed[k][0] for k in first.nominal.completed if k not in barred):
            return first, "ruled out"
    explored = _explore(plan, panel, rng, max_rounds)
    finalists = explored.finalists
    best = panel.judge(finalists[:1])
    if best.good():
        return best, "robust"
    if settled(best, explored):
        return best, "no progress"
    if len(finalists) > 1:
        other = panel.judge(finalists[1:])
        best = min((best, other), key=lambda f: f.worst)
        if best.good():
            return best, "robust"
        if settled(best, explored):
            return best, "no progress"
    if explored.stalled and not explored.reached and not best.ensemble.all_completed().any():
        # Neither engine brings the events about, and the last rounds came no nearer.
        return best, "out of reach"
    reached = explored.reached or best.worst < MISSED
    share = REFERENCE_SHARE if reached else 0.5 * REFERENCE_SHARE
    return _polish(plan, panel, rng, best, max(1, round(share * max_rounds)))


def settled(best: Found, explored: Explored) -> bool:
    """Whether a search in the reference engine has nothing to add.

    It is there for what the engines see differently. Where every event happens in all members,
    they agree on how well, and the surrogate could not do better, it would only cost time.
    """
    agreed = best.worst < max(AGREED * explored.worst, explored.worst + GOOD_LOSS)
    return explored.stalled and agreed and bool(best.ensemble.all_completed().all())


def _explore(plan: Plan, panel: Panel, rng: np.random.Generator, max_rounds: int) -> Explored:
    """Searches in the surrogate, unless one of the first candidates is good."""
    scale = spreads(plan)
    first = around(plan, plan.initial(), scale, rng, STARTS)
    worst = panel.preview(first)
    order = np.argsort(worst, kind="stable")
    pool, value = first[order], worst[order]
    panel.note("start", "surrogate", len(first), float(value[0]))
    if value[0] < GOOD_LOSS:
        return Explored(pool[:FINALISTS], float(value[0]), False)
    cloud = Cloud(plan, scale)
    history = [float(value[0])]
    ended = False
    for _ in range(max_rounds):
        thetas = cloud.draw(rng, POPULATION)
        losses = panel.surrogate.assess(thetas).total + prior(plan, thetas)
        elites = cloud.learn(thetas, losses, pool[0] if value[0] < MISSED else None)
        chosen = elites[:FINALISTS]
        pool = np.concatenate([pool, chosen])
        value = np.concatenate([value, panel.preview(chosen)])
        order = np.argsort(value, kind="stable")[: 2 * FINALISTS]
        pool, value = pool[order], value[order]
        history.append(float(value[0]))
        panel.note("explore", "surrogate", POPULATION, history[-1])
        ended = stalled(history, reached=value[0] < MISSED)
        if value[0] < GOOD_LOSS or ended:
            break
    return Explored(pool[:FINALISTS], float(value[0]), ended)


def _polish(
    plan: Plan, panel: Panel, rng: np.random.Generator, best: Found, max_rounds: int
) -> tuple[Found, str]:
    """Cross-entropy search in the reference engine around the best theta so far."""
    cloud = Cloud(plan, spreads(plan), center=best.theta)
    history = [best.worst]
    thetas = cloud.draw(rng, WORLDS)
    losses = panel.reference.assess(thetas).total
    for k in range(max_rounds):
        anchor = best.theta if best.worst < MISSED else None
        elites = cloud.learn(thetas, losses + prior(plan, thetas), anchor)
        last = k == max_rounds - 1
        # The next candidates do not depend on how these fare under the ensemble.
        thetas = cloud.draw(rng, WORLDS)
        found, look = panel.judge_while(elites[:FINALISTS], thetas[: 0 if last else WORLDS])
        best = min((best, found), key=lambda f: f.worst)
        history.append(best.worst)
        if best.good():
            return best, "robust"
        if stalled(history, reached=bool(best.nominal.all_completed().all())):
            return best, "no progress"
        if not last:
            losses = look()
    return best, "rounds spent"


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


def stalled(history: list[float], *, reached: bool) -> bool:
    """The last rounds gained nothing; twice as many are granted while an event is missing."""
    patience = PATIENCE if reached else 2 * PATIENCE
    if len(history) < patience + 2:
        return False
    earlier, now = min(history[:-patience]), min(history)
    return earlier - now < max(0.02, 0.02 * earlier)
