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
        now, met = self._read(state.gone | set(batch), touched)
        lost = sum(state.now[k].points - now[k].points for k in touched)
        crashed = any(now[k].crashed and not state.now[k].crashed for k in touched)
        alone = sum(max(0.0, self.effects[k].lost) for k in batch if k in self.effects)
        after = state.now | now
        over = self._over(after)
        if not crashed and lost <= alone + SLACK and not over:
            state.gone |= set(batch)
            state.now = after
            state.cost[batch[0]] = lost
            for k, numbers in met.items():  # without the batch other units count
                for n in numbers:
                    have = self.bench.reached.setdefault(n, [])
                    if k not in have:
                        have.append(k)
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
        return self._read(gone, cases)[0]

    def _read(
        self, gone: set[int], cases: list[int]
    ) -> tuple[dict[int, Outcome], dict[int, set[int]]]:
        """Outcomes of cases without some units, and the units that then count in each."""
        parts = [cases[k :: 4 * self.jobs] for k in range(4 * self.jobs)]
        bench = self.bench

        def work(part: list[int]) -> list[tuple[int, Outcome, set[int]]]:
            out: list[tuple[int, Outcome, set[int]]] = []
            with bench.without(gone):
                for k in part:
                    with bench.build.recorded() as met:
                        out.append((k, bench.outcome(k, bench.before[k]), met))
            return out

        jobs = self.jobs if len(cases) > 40 else 1
        found = [r for part in in_parallel(work, [p for p in parts if p], jobs) for r in part]
        return {k: outcome for k, outcome, _ in found}, {k: met for k, _, met in found}

    def mend(self) -> list[int]:
        """Puts units back until no deciding case crashes that did not; returns them."""
        back: list[int] = []
        bench, state = self.bench, self.state
        while True:
            now, met = self._read(state.gone, self.deciding)
            state.now = now
            broken = [k for k in self.deciding if now[k].crashed and not bench.before[k].crashed]
            if not broken:
                return back
            case = broken[0]
            for number in sorted(met[case] & state.gone):
                with bench.without(state.gone - {number}):
                    if not bench.outcome(case).crashed:
                        found = {number}
                        break
            else:
                found = met[case] & state.gone or set(state.gone)
            state.gone -= found
            back += sorted(found)

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
