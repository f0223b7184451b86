"""Who judges candidates during the search: the surrogate explores, the reference engine decides.

The surrogate knows no joints: of a scene with joints the reference engine explores, too.

Both play the same ensemble of perturbations. The surrogate adds two members that the reference
engine would have to be built anew for: half the step, and round sides replaced by facets.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses import Assessment
from esg.dynamics.losses.horizon import expected_end, told_by
from esg.dynamics.plan import Plan
from esg.dynamics.search.simulate import ENSEMBLE, Simulator
from esg.dynamics.story.proxies import faceted
from esg.engines.base import SURROGATE, Engine
from esg.engines.breaking import unbroken
from esg.engines.registry import get_engine
from esg.graph.models import SearchStep

Floats = NDArray[np.float64]

NO_BUDGET = (math.inf, math.inf)
REFERENCE_DT_S = 1.0 / 240.0
COARSE = 2.0
"""Steps of the reference engine where it explores, as a multiple of those where it decides."""
GOOD_LOSS = 0.35
"""Worst-case loss at which the search stops: all events happen, residuals are small."""
CENTRED_LOSS = 0.15
SAME_LOSS = 0.05
"""What holding bystanders still may change."""
SPARE_S = 0.15
"""By how much later the reference engine may see events before it has to play on."""
MANY, NEARLY_ALL = 0.8, 0.9
"""The surrogate plays no longer than this share of the last candidates needed, if at least so many
of them told everything."""
EXPLORED_S, DECIDED_S = 30_000.0, 15_000.0
"""Where a scene has joints, Newton plays at most so many seconds of one collision shape while it
explores, and while it decides: rollouts times their length times the shapes of all bodies. On two
cores that takes a search about a minute. What our suites find is found by 22,000."""
WORST_SHARE = 0.7
"""Weight of the worst member of the ensemble; the rest goes to the mean."""


@dataclass(frozen=True)
class Found:
    """A theta and how it fared in the reference engine.

    Args:
        theta: Shape [n].
        worst: Worst-case loss (see `robust_value`).
        nominal: Of the unperturbed scene, one world.
        ensemble: Of all members.
    """

    theta: Floats
    worst: float
    nominal: Assessment
    ensemble: Assessment

    def good(self) -> bool:
        """A small worst case; or everything holds in all members and the nominal is centred.

        Guessed windows add to the worst case, ever more in a long chain: they tell which of two is
        better, and are no reason to go on.
        """
        both = robust_value(np.stack([self.ensemble.total, self.ensemble.asked()]))
        asked = self.worst - float(both[0] - both[1])
        return asked < GOOD_LOSS or bool(_holds(self.ensemble, 1)[0])


@dataclass(frozen=True)
class Previewed:
    """How K candidates fared in the surrogate.

    Args:
        worst: Worst-case losses, shape [K].
        good: Whether each is as `Found.good` asks, with half the step and other proxies too [K].
    """

    worst: Floats
    good: NDArray[np.bool_]


class Panel:
    """The engines of a search and the record of what they were asked.

    Args:
        plan: What is searched.
        device: Where the engines run.
        dt: Step of both engines [s].
        engines: Name and device -> engine.

    Attributes:
        explorer: Name of the engine that explores.
        breadth: Candidates that it plays in about the time of one.
        most, decided: Rollouts after which exploring, and deciding, ends; infinite without joints.
    """

    def __init__(
        self,
        plan: Plan,
        device: str,
        *,
        dt: float,
        engines: Callable[[str, str], Engine] = get_engine,
    ) -> None:
        self.explorer = "newton" if plan.scene.joints else SURROGATE
        engine = engines(self.explorer, device)
        self.plan, self.device = plan, device
        self.reference = Simulator(plan, engines("newton", device), dt=dt, hold=True)
        step = dt if self.explorer == SURROGATE else COARSE * dt
        # Nothing breaks while it explores: a blow that is hard enough tells when it would.
        known = replace(plan, scene=unbroken(plan.scene))
        self.surrogate = Simulator(known, engine, dt=step)
        self.breadth: int = getattr(engine, "breadth", 1)
        self._others: list[Simulator] = []
        if self.explorer == SURROGATE:
            self._others.append(Simulator(known, engine, dt=0.5 * dt))
            scene = faceted(known.scene)
            if scene is not known.scene:
                self._others.append(Simulator(replace(plan, scene=scene), engine, dt=dt))
        # An engine that is shared by many searches may play several rollouts at once.
        self._together: Callable[[list[Callable[[], Any]]], list[Any]] | None
        self._together = getattr(engine, "together", None)
        self.most, self.decided = _budgets(known) if self.explorer != SURROGATE else NO_BUDGET
        self.steps: list[SearchStep] = []
        self._told: dict[bytes, float] = {}
        # What plays many worlds in the time of one would wait for two passes instead of one.
        self._may_stop = self.breadth == 1
        self._until = expected_end(plan) + SPARE_S if self._may_stop else math.inf

    def rebias(self, bias: dict[str, float]) -> None:
        """Shifts the targets of all engines (`losses.assessment`)."""
        for simulator in (self.reference, self.surrogate, *self._others):
            simulator.bias = dict(bias)

    @property
    def evaluations(self) -> int:
        """Rollouts of the reference engine."""
        return self.reference.evaluations

    @property
    def explored(self) -> int:
        """Rollouts of what explores."""
        return self.surrogate.evaluations + sum(s.evaluations for s in self._others)

    def note(self, phase: str, engine: str, candidates: int, best: float) -> None:
        """Adds a line to the record of the search."""
        self.steps.append(
            SearchStep(phase=phase, engine=engine, candidates=candidates, best=rounded(best))
        )

    def preview(self, thetas: Floats) -> Previewed:
        """How candidates fare in the surrogate under the ensemble and in its other two forms."""
        calls: list[Callable[[], tuple[Assessment, Floats]]] = [
            partial(_table, self.surrogate, thetas, self._until),
            *(partial(_column, s, thetas, self._until) for s in self._others),
        ]
        played = self._together(calls) if self._together else [call() for call in calls]
        told = told_by(self.plan.story, played[0][0]).reshape(len(thetas), -1).max(axis=1)
        self._expect(told)
        self._told |= {t.tobytes(): float(end) for t, end in zip(thetas, told, strict=True)}
        known = prior(self.plan, thetas)
        worst = robust_value(np.concatenate([table for _, table in played], axis=1)) + known
        asked = [a.asked().reshape(len(thetas), -1) for a, _ in played]
        small = robust_value(np.concatenate(asked, axis=1)) + known < GOOD_LOSS
        holds = _holds(played[0][0], len(thetas))
        for other, _ in played[1:]:
            holds &= other.all_completed() & other.within_tolerance()
        return Previewed(worst, holds | small)

    def look(self, thetas: Floats) -> Assessment:
        """The unperturbed scene in the surrogate."""
        found = self.surrogate.assess(thetas, until=self._until)
        self._expect(told_by(self.plan.story, found))
        return found

    def _expect(self, told: Floats) -> None:
        """Sets how long the next candidates are played, by when the last ones had told all."""
        if self._may_stop:
            known = told[np.isfinite(told)]
            enough = len(known) >= MANY * len(told)
            self._until = float(np.quantile(known, NEARLY_ALL)) + SPARE_S if enough else math.inf

    def judge(self, thetas: Floats, phase: str = "confirm") -> Found:
        """Plays thetas under the ensemble in the reference engine and keeps the most robust."""
        until = max(self._told.get(t.tobytes(), math.inf) for t in thetas) + SPARE_S
        assessed, table = _table(self.reference, thetas, until)
        value = robust_value(table) + prior(self.plan, thetas)
        k = int(np.argmin(value))
        ensemble = assessed.worlds(slice(k * len(ENSEMBLE), (k + 1) * len(ENSEMBLE)))
        self.note(phase, "newton", len(thetas), float(value[k]))
        return Found(thetas[k], float(value[k]), ensemble.worlds(slice(0, 1)), ensemble)

    def whole(self, found: Found) -> Found | None:
        """What was found, played with all bodies that can move; None if that is something else.

        During the search bodies that no event is about are held still (`bystanders`).
        """
        if not self.reference.holds:
            return found
        until = float(told_by(self.plan.story, found.nominal)[0]) + SPARE_S
        nominal = self.reference.assess(found.theta[None], whole=True, until=until)
        self.note("whole", "newton", 1, float(nominal.total[0]))
        held = found.nominal
        same = all(np.array_equal(nominal.completed[k], held.completed[k]) for k in held.completed)
        if same and abs(float(nominal.total[0] - held.total[0])) < SAME_LOSS:
            return replace(found, nominal=nominal)
        self.reference.release()
        return None

    def judge_while(self, thetas: Floats, candidates: Floats) -> tuple[Found, Callable[[], Floats]]:
        """Judges thetas, and may play the next candidates at the same time.

        Returns:
            What `judge` found, and what gives the candidates' losses in the reference engine,
            shape [K]. They are played when it is called, except by an engine shared by many
            searches, whose passes take as long with them as without; either way they count as
            evaluations from that call on.
        """

        def look() -> Floats:
            return self.reference.assess(candidates).total

        together = self._together
        if together is None or not len(candidates):
            return self.judge(thetas, "polish"), look
        found, losses = together([lambda: self.judge(thetas, "polish"), look])
        self.reference.evaluations -= len(candidates)

        def known() -> Floats:
            self.reference.evaluations += len(candidates)
            return losses

        return found, known


def _budgets(plan: Plan) -> tuple[float, float]:
    """Rollouts that Newton plays of a scene with joints while it explores, and while it decides."""
    shapes = sum(len(b.shapes) for b in plan.scene.bodies)
    each = max(shapes, 1) * plan.duration
    return EXPLORED_S / each, DECIDED_S / each


def _holds(assessed: Assessment, count: int) -> NDArray[np.bool_]:
    """Whether everything holds in all members of `count` ensembles, the nominal centred [count].

    The perturbations themselves move a prescribed speed or time, so that some worst cases cannot
    become small.
    """
    members = len(ENSEMBLE)
    happens = assessed.all_completed() & assessed.within_tolerance(perturbed=True)
    centred = assessed.within_tolerance() & (assessed.asked() < CENTRED_LOSS)
    return happens.reshape(count, members).all(axis=1) & centred[::members]


def _column(
    simulator: Simulator, thetas: Floats, until: float = math.inf
) -> tuple[Assessment, Floats]:
    """The unperturbed scene: the assessment and losses, shape [K, 1]."""
    assessed = simulator.assess(thetas, until=until)
    return assessed, assessed.total[:, None]


def _table(
    simulator: Simulator, thetas: Floats, until: float = math.inf
) -> tuple[Assessment, Floats]:
    """All members of the ensemble for each theta: the assessment and losses [K, members]."""
    members = [m for _ in thetas for m in ENSEMBLE]
    assessed = simulator.assess(np.repeat(thetas, len(ENSEMBLE), axis=0), members, until=until)
    return assessed, assessed.total.reshape(len(thetas), len(ENSEMBLE))


def robust_value(losses: Floats) -> Floats:
    """Worst case and mean over the members, [K, members] -> [K]."""
    return WORST_SHARE * losses.max(axis=1) + (1.0 - WORST_SHARE) * losses.mean(axis=1)


def prior(plan: Plan, thetas: Floats) -> Floats:
    """Normalized l2 distance from the initial theta (paper, L_p), at a small weight.

    It says which of two equals to take; a right theta far off is not called bad for it.
    """
    spread = np.array([max(v.spread, 1e-9) for v in plan.variables])
    deviation = np.where(plan.free(), (thetas - plan.initial()) / (6.0 * spread), 0.0)
    return 0.01 * (deviation**2 / (1.0 + deviation**2)).sum(axis=1)


def rounded(value: float) -> float:
    """A finite number with nine decimals, as documents store it."""
    return float(np.round(np.nan_to_num(value, nan=0.0, posinf=1e9, neginf=-1e9), 9))
