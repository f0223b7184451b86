"""Which units go together: in batches, cheapest first, until a budget of points is spent."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from benchmarks.pruning.effect import Bench, Effect, Outcome, in_parallel

BATCH = 48
"""Units that are first tried together."""
SLACK = 1.0
"""Points that a batch may cost beyond what its units cost one by one."""


@dataclass
class State:
    """What has been left out so far.

    Args:
        gone: Numbers of the units.
        now: Outcome of every deciding case without them, by its number.
        cost: Points that each accepted batch cost, by its first unit.
        refused: Units that stay because they cost more together with others than alone.
    """

    gone: set[int]
    now: dict[int, Outcome]
    cost: dict[int, float] = field(default_factory=dict)
    refused: list[int] = field(default_factory=list)


class Choice:
    """Chooses units to leave out for good.

    Args:
        bench: Cases, read once.
        effects: What leaving out each unit alone does.
        jobs: Processes.
        within: Largest drop of a corpus's figures [points of percentage], by corpus.
    """

    def __init__(
        self, bench: Bench, effects: dict[int, Effect], jobs: int, within: dict[str, float]
    ) -> None:
        self.bench, self.effects, self.jobs, self.within = bench, effects, jobs, within
        self.deciding = [k for k, c in enumerate(bench.cases) if c.decides]
        self.state = State(set(), {k: bench.before[k] for k in self.deciding})
        self.first = self._figures(self.state.now)

    def run(self, numbers: Iterable[int]) -> State:
        """Leaves out what it can of some units, given in the order to try them."""
        numbers = list(numbers)
        for at in range(0, len(numbers), BATCH):
            if not self._try(numbers[at : at + BATCH]):
                break
        return self.state

    def _try(self, batch: list[int]) -> bool:
        """Leaves a batch out, or halves of it; False once the budget is spent."""
        state = self.state
        batch = [k for k in batch if k not in state.gone]
        if not batch:
            return True
        touched = self._touched(batch)
        now = self.outcomes(state.gone | set(batch), touched)
        lost = sum(state.now[k].points - now[k].points for k in touched)
        crashed = any(now[k].crashed and not state.now[k].crashed for k in touched)
        alone = sum(max(0.0, self.effects[k].lost) for k in batch if k in self.effects)
        after = state.now | now
        over = self._over(after)
        if not crashed and lost <= alone + SLACK and not over:
            state.gone |= set(batch)
            state.now = after
            state.cost[batch[0]] = lost
            return True
        if len(batch) == 1:
            state.refused += batch
            return not over or crashed or lost > 0
        half = len(batch) // 2
        return self._try(batch[:half]) and self._try(batch[half:])

    def _touched(self, batch: list[int]) -> list[int]:
        cases = {k for n in batch for k in self.bench.reached.get(n, ())}
        return sorted(cases & self.state.now.keys())

    def outcomes(self, gone: set[int], cases: list[int]) -> dict[int, Outcome]:
        """Outcomes of cases without some units."""
        parts = [cases[k :: 4 * self.jobs] for k in range(4 * self.jobs)]
        parts = [p for p in parts if p]

        def work(part: list[int]) -> list[tuple[int, Outcome]]:
            with self.bench.build.without(gone):
                return [(k, self.bench.outcome(k, self.bench.before[k])) for k in part]

        found = in_parallel(work, parts, self.jobs if len(cases) > 40 else 1)
        return {k: outcome for part in found for k, outcome in part}

    def _figures(self, now: dict[int, Outcome]) -> dict[str, list[float]]:
        """Sums of the counts by corpus."""
        out: dict[str, list[float]] = {}
        for k, outcome in now.items():
            have = out.setdefault(self.bench.cases[k].corpus, [0.0] * len(outcome.counts))
            for n, value in enumerate(outcome.counts):
                have[n] += value
        return out

    def _over(self, now: dict[int, Outcome]) -> bool:
        drops = self.bench.subject.drops(self.first, self._figures(now))
        return any(drops.get(name, 0.0) > most for name, most in self.within.items())
