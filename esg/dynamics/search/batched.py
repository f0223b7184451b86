"""Strategy `batched`: sample, explore in the surrogate, decide in the reference engine.

Thousands of rollouts of the fused surrogate cost what a few hundred of the reference engine do.
They choose, by worst case over the ensemble, the candidates that the reference engine then plays
under the same ensemble. Where the two disagree, a short cross-entropy search in the reference
engine goes on from there.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses.shapes import MISSED
from esg.dynamics.plan import Plan
from esg.dynamics.search.cloud import Cloud, around, spreads
from esg.dynamics.search.niches import Niche, apart, broad, everywhere
from esg.dynamics.search.panel import GOOD_LOSS, WORST_SHARE, Found, Panel, prior
from esg.dynamics.search.progress import least_gain, nearing, poor, stalled
from esg.dynamics.search.simulate import ENSEMBLE

Floats = NDArray[np.float64]

STARTS = 4
"""Candidates around the choreographed start that are judged before anything is searched."""
SURE = 0.05
"""Worst case of the choreographed start below which the others are not even played."""
POPULATION = 48
WORLDS = 32
FINALISTS = 4
SAMPLE, SAMPLES = 64, 3
"""Candidates from all of theta's box at a time and how often, where none near the start will do."""
NICHES, BROOD, IDLE = 2, 8, 8
"""Places that are searched at a time then, with so many candidates each; generations without
progress after which another place is tried."""
WIDE_BROOD = 24
"""Most candidates of a place where an engine plays many in the time of one."""
OTHERS = 3
"""Places apart that the reference engine plays where it disagrees with the surrogate."""
BROKEN = 1e6
"""Loss of a candidate that cannot be played."""
REFERENCE_SHARE = 0.4
"""Rounds of the reference engine as a share of the surrogate's."""
PIECE_ROLLOUTS = 3000
"""Rollouts of the reference engine times bodies where things come apart: one of a wall in 24 pieces
takes more than a second of a core, and rounds of them minutes."""
AGREED = 1.2
"""Worst cases that differ by less than this factor (or `GOOD_LOSS`) say the same of a theta."""


@dataclass(frozen=True)
class Explored:
    """What the surrogate found.

    Args:
        finalists: In order of their worst case, the best first, shape [K, n].
        worst: Of the best.
        stalled: Whether more rounds no longer improved it.
        pool: All that was played.
        good: Whether the surrogate finds nothing to object to the best.
        left: Starts that were not played because the first one is good enough, shape [K, n].
    """

    finalists: Floats
    worst: float
    stalled: bool
    pool: Pool | None = None
    good: bool = False
    left: Floats | None = None

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
    rollouts: int | None = None,
) -> tuple[Found, str]:
    """The most robust theta found, and why the search stopped.

    Args:
        plan: Variables with bounds and mask.
        panel: Engines.
        rng: Source of all draws.
        max_rounds: Batches of candidates in the surrogate; the reference engine gets 40% of that.
        barred: Events that physics rules out (`feasibility`) and what follows from them: nothing is
            searched where all others happen.
        rollouts: Most rollouts of the reference engine beside the first confirmation; None for as
            many as the rounds need.
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
    if explored.left is not None and explored.pool is not None:
        # The engines disagree on the choreographed theta: what of the others?
        explored = _start(explored.pool, explored.left)
        finalists = explored.finalists
        first = (finalists == best.theta).all(axis=1)
        finalists = np.concatenate([finalists[first], finalists[~first]])
    elif settled(best, explored):
        return best, "no progress"
    if len(finalists) > 1:
        best = _best_of(panel, best, finalists[1:])
        if best.good():
            return best, "robust"
        if settled(best, explored):
            return best, "no progress"
    some = bool(best.ensemble.all_completed().any())
    if not (some or explored.reached) and (explored.stalled or agree(best, explored)):
        # Neither engine brings the events about, and the last rounds came no nearer.
        return best, "out of reach"
    if some and explored.stalled and agree(best, explored):
        # Some members miss an event in both engines, whatever is tried.
        return best, "no progress"
    if explored.good and not best.ensemble.all_completed().all():
        best = _elsewhere(plan, panel, rng, explored, best)
        if best.good():
            return best, "robust"
    reached = explored.reached or best.worst < MISSED
    share = REFERENCE_SHARE if reached else 0.5 * REFERENCE_SHARE
    if np.isfinite(panel.decided):
        rollouts = min(int(panel.decided), rollouts or int(panel.decided))
    rounds, shown = _affordable(panel, max(1, round(share * max_rounds)), rollouts)
    if shown <= 0:
        return best, "budget spent"
    return _polish(plan, panel, rng, best, rounds, shown)


def with_pieces(bodies: int, whole: int, rollouts: int | None) -> int | None:
    """Most rollouts of the reference engine where things come apart there.

    Args:
        bodies: Of its scene, pieces among them.
        whole: Of the scene that is explored, in which nothing breaks.
        rollouts: Most of any scene; None for as many as the rounds need.
    """
    if bodies == whole:
        return rollouts
    most = PIECE_ROLLOUTS // bodies
    return most if rollouts is None else min(most, rollouts)


def _affordable(panel: Panel, rounds: int, rollouts: int | None) -> tuple[int, int]:
    """Rounds of the reference engine, and finalists of each, that a budget of rollouts allows."""
    if rollouts is None:
        return rounds, FINALISTS
    left = rollouts + len(ENSEMBLE) - panel.evaluations
    rounds = min(rounds, left // (WORLDS + FINALISTS * len(ENSEMBLE)))
    return (rounds, FINALISTS) if rounds > 0 else (1, (left - WORLDS) // len(ENSEMBLE))


def _best_of(panel: Panel, best: Found, others: Floats) -> Found:
    """The best of what was found and others, which are judged until one is good."""
    # One after the other, unless the engine plays all of them in the time of one.
    many = 1 if panel.breadth == 1 else len(others) + 1
    for k in range(0, len(others), many):
        best = min((best, panel.judge(others[k : k + many])), key=lambda f: f.worst)
        if best.good():
            return best
    return best


def _elsewhere(
    plan: Plan, panel: Panel, rng: np.random.Generator, explored: Explored, best: Found
) -> Found:
    """What the surrogate calls good apart from where the reference engine disagrees with it.

    Engines disagree where an event just about happens. A sample of the whole box shows other places
    where it does, and each costs one confirmation.
    """
    pool = explored.pool or Pool(panel)
    pool.look(everywhere(plan, rng, SAMPLE, plan.initial()))
    places = apart(plan, pool.seen, pool.losses, 2 * OTHERS, [best.theta])
    thetas = pool.seen[[k for k in places if pool.losses[k] < GOOD_LOSS]]
    if not len(thetas):
        return best
    shown = panel.preview(thetas)
    panel.note("sample", panel.explorer, SAMPLE, float(shown.worst.min()))
    for k in np.lexsort((shown.worst, ~shown.good))[:OTHERS]:
        if shown.good[k] and not best.good():
            best = min((best, panel.judge(thetas[k : k + 1])), key=lambda f: f.worst)
    return best


def settled(best: Found, explored: Explored) -> bool:
    """Whether a search in the reference engine has nothing to add.

    It is there for what the engines see differently. Where every event happens in all members,
    they agree on how well, and the surrogate could not do better, it would only cost time.
    """
    return explored.stalled and agree(best, explored) and bool(best.ensemble.all_completed().all())


def agree(best: Found, explored: Explored) -> bool:
    """Whether the reference engine sees no more than the surrogate that a search could mend."""
    return best.worst < max(AGREED * explored.worst, explored.worst + GOOD_LOSS)


def _explore(plan: Plan, panel: Panel, rng: np.random.Generator, max_rounds: int) -> Explored:
    """Searches in the surrogate, unless one of the first candidates is good.

    At first near the choreographed theta. Where that brings no event nearer, or all of them about
    but far from as asked, all of theta's box is sampled once and the most promising places of it
    are searched side by side.
    """
    scale = spreads(plan)
    pool = Pool(panel)
    starts = around(plan, plan.initial(), scale, rng, STARTS)
    # What plays many in the time of one need not wait for the first.
    begun = _start(pool, starts, 1 if panel.breadth == 1 else STARTS)
    if pool.good:
        return begun
    if not (broad(plan) > 0.0).any():
        return pool.explored(stalled=True)
    history, enough = [pool.best], poor(plan)
    gain = least_gain(plan)
    cloud = Cloud(plan, scale)
    for _ in range(max_rounds):
        thetas = cloud.draw(rng, POPULATION)
        losses = pool.look(thetas)
        elites = cloud.learn(thetas, losses, pool.thetas[0] if pool.best < MISSED else None)
        pool.consider(elites[:FINALISTS], cloud.kept[:FINALISTS])
        history.append(pool.best)
        panel.note("explore", panel.explorer, POPULATION, pool.best)
        ended = stalled(history, reached=pool.best < MISSED, gain=gain)
        if pool.good or (ended and pool.best < enough):
            return pool.explored(stalled=ended)
        if pool.spent:
            return pool.explored(stalled=True)
        if ended or not nearing(history, enough):
            break
    else:
        if pool.best < enough:
            return pool.explored(stalled=False)
    return _explore_widely(plan, pool, rng, max_rounds)


def _start(pool: Pool, starts: Floats, first: int = STARTS) -> Explored:
    """Plays starts under the ensemble, only the first of them if it leaves nothing to be wished.

    Args:
        pool: Where they are kept.
        starts: Shape [K, n].
        first: How many are played at once, the others only if they have to.
    """
    shown = pool.panel.preview(starts[:first])
    sure = len(starts) == STARTS and bool(shown.good[0]) and shown.worst[0] < SURE
    kept = slice(0, 1 if sure else first)
    pool.keep(starts[kept], shown.worst[kept], shown.good[kept])
    if not sure and len(starts) > first:
        pool.preview(starts[first:])
    pool.panel.note("start", pool.panel.explorer, 1 if sure else len(starts), pool.best)
    return replace(pool.explored(stalled=False), left=starts[1:] if sure else None)


def _explore_widely(plan: Plan, pool: Pool, rng: np.random.Generator, rounds: int) -> Explored:
    """Samples all of theta's box, then searches its best places side by side."""
    count, times = SAMPLE, SAMPLES
    if pool.panel.breadth >= SAMPLE:
        count, times = SAMPLE * SAMPLES, 1
    for _ in range(times):
        thetas = everywhere(plan, rng, count, plan.initial())
        losses = pool.look(thetas)
        order = np.argsort(losses, kind="stable")[:FINALISTS]
        pool.consider(thetas[order], losses[order])
        pool.panel.note("sample", pool.panel.explorer, count, pool.best)
        if pool.good or pool.spent:
            return pool.explored(stalled=pool.spent)
    scale = broad(plan)
    brood = min(max(BROOD, pool.panel.breadth // NICHES), WIDE_BROOD)
    niches: list[Niche] = []
    tried: list[Floats] = []
    history, ended = [pool.best], False
    for _ in range(rounds):
        played = len(pool.seen)
        while len(pool.seen) < played + POPULATION and not pool.good:
            niches = [n for n in niches if not (n.collapsed or n.idle >= IDLE)]
            for k in apart(plan, pool.seen, pool.losses, NICHES - len(niches), tried):
                niches.append(Niche(plan, pool.seen[k], float(pool.losses[k]), scale))
                tried.append(pool.seen[k])
            if not niches:
                return pool.explored(stalled=True)
            asked = [n.ask(rng, brood) for n in niches]
            losses = pool.look(np.concatenate(asked)).reshape(len(niches), brood)
            for niche, thetas, own in zip(niches, asked, losses, strict=True):
                niche.tell(own)
                order = np.argsort(own, kind="stable")[:2]
                pool.consider(thetas[order], own[order])
        history.append(pool.best)
        pool.panel.note("explore", pool.panel.explorer, len(pool.seen) - played, pool.best)
        ended = stalled(history, reached=pool.best < MISSED)
        if pool.good or ended or pool.spent:
            break
    return pool.explored(stalled=ended or pool.spent)


class Pool:
    """What the surrogate has played: all candidates' losses and the most robust of them.

    Attributes:
        thetas: The most robust ones, the good ones first, then the best, shape [K, n].
        value: Their worst cases; of one that misses an event its loss, shape [K].
        fine: Which of them are good (`Previewed`), shape [K].
        seen, losses: Every candidate of `look` and its loss, shapes [N, n] and [N].
    """

    def __init__(self, panel: Panel) -> None:
        self.panel = panel
        n = len(panel.plan.variables)
        self.thetas, self.value = np.zeros((0, n)), np.zeros(0)
        self.fine = np.zeros(0, bool)
        self.seen, self.losses = np.zeros((0, n)), np.zeros(0)
        self._happens: dict[bytes, bool] = {}

    @property
    def best(self) -> float:
        return float(self.value[0])

    @property
    def good(self) -> bool:
        """Whether a good one is among them."""
        return bool(self.fine[0])

    @property
    def spent(self) -> bool:
        """Whether what explores has played as much as it may."""
        return self.panel.explored >= self.panel.most

    def preview(self, thetas: Floats) -> None:
        """Plays candidates under the ensemble."""
        shown = self.panel.preview(thetas)
        self.keep(thetas, shown.worst, shown.good)

    def look(self, thetas: Floats) -> Floats:
        """Losses of the unperturbed scene, shape [K]."""
        assessed = self.panel.look(thetas)
        losses = assessed.total + prior(self.panel.plan, thetas)
        losses = np.nan_to_num(losses, nan=BROKEN, posinf=BROKEN)
        happens = assessed.all_completed()
        self._happens |= {t.tobytes(): bool(h) for t, h in zip(thetas, happens, strict=True)}
        self.seen = np.concatenate([self.seen, thetas])
        self.losses = np.concatenate([self.losses, losses])
        return losses

    def consider(self, thetas: Floats, losses: Floats) -> None:
        """Plays those under the ensemble that may be more robust than the best so far.

        No worst case is better than the unperturbed scene alone allows. What misses an event there
        is ranked by its loss.
        """
        missed = ~np.array([self._happens[t.tobytes()] for t in thetas], bool)
        if missed.any():
            self.keep(thetas[missed], losses[missed], np.zeros(int(missed.sum()), bool))
        worth = ~missed & (WORST_SHARE * losses < self.best)
        if worth.any():
            self.preview(thetas[worth])

    def keep(self, thetas: Floats, value: Floats, fine: NDArray[np.bool_]) -> None:
        """Adds candidates with their worst cases and whether they are good."""
        self.thetas = np.concatenate([self.thetas, thetas])
        self.value = np.concatenate([self.value, value])
        self.fine = np.concatenate([self.fine, fine])
        _, first = np.unique(self.thetas, axis=0, return_index=True)
        order = np.sort(first)
        order = order[np.lexsort((self.value[order], ~self.fine[order]))][: 2 * FINALISTS]
        self.thetas, self.value, self.fine = self.thetas[order], self.value[order], self.fine[order]

    def explored(self, *, stalled: bool) -> Explored:
        return Explored(self.thetas[:FINALISTS], self.best, stalled, self, self.good)


def _polish(
    plan: Plan,
    panel: Panel,
    rng: np.random.Generator,
    best: Found,
    max_rounds: int,
    shown: int = FINALISTS,
) -> tuple[Found, str]:
    """Cross-entropy search in the reference engine around the best theta so far.

    Args:
        plan: Variables.
        panel: Engines.
        rng: Source of the candidates.
        best: Where it starts.
        max_rounds: Rounds of candidates.
        shown: How many elites of a round are played under the ensemble.
    """
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
        found, look = panel.judge_while(elites[:shown], thetas[: 0 if last else WORLDS])
        best = min((best, found), key=lambda f: f.worst)
        history.append(best.worst)
        if best.good():
            return best, "robust"
        if stalled(history, reached=bool(best.nominal.all_completed().all())):
            return best, "no progress"
        if not last:
            losses = look()
    return best, "rounds spent"
