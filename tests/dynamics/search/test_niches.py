"""The search itself, on losses whose landscape is known: no engine is asked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
import math
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from esg.dynamics.losses.assessment import Assessment
from esg.dynamics.losses.shapes import FARTHEST, UNBRAKED, UNMET, bowl, distance_loss, unbraked
from esg.dynamics.plan.planner import Plan
from esg.dynamics.plan.variables import Variable
from esg.dynamics.search.batched import (
    MISSED,
    PIECE_ROLLOUTS,
    SAMPLE,
    SAMPLES,
    STARTS,
    SURE,
    WORLDS,
    search,
)
from esg.dynamics.search.niches import Niche, apart, broad, everywhere
from esg.dynamics.search.panel import GOOD_LOSS, Found, Previewed
from esg.dynamics.search.progress import POOR, poor
from esg.dynamics.search.simulate import ENSEMBLE
from esg.dynamics.strategies import run_strategy
from esg.engines.breaking import unbroken
from esg.engines.breaking.pieces import broken
from esg.engines.scene import Body, Shape, SimScene

Floats = np.ndarray
MEMBERS = len(ENSEMBLE)
UNIT = ((0.02, 0.0, 0.0), (0.0, 0.02, 0.0), (0.0, 0.0, 0.02))
POT = Body("pot", False, 2.0, UNIT, (Shape("box", (0.1, 0.1, 0.1)),), (0.0, 0.0, 0.1))
BROKEN = 1e6


def variable(
    low: float, high: float, initial: float, spread: float, *, fixed: bool = False
) -> Variable:
    return Variable("x", low, high, initial, initial, spread, fixed, "m")


def plan_of(*variables: Variable, events: int = 1) -> Plan:
    story = cast(Any, SimpleNamespace(outcomes=(None,) * events))
    none = cast(Any, None)
    return Plan(variables, none, story, none, none, duration=1.0)


class Field:
    """Stands for both engines: a loss of theta, the same in all members of the ensemble.

    Args:
        plan: Variables.
        surrogate: Losses of thetas [K, n], shape [K].
        newton: The reference engine's; the surrogate's if None.
    """

    def __init__(
        self,
        plan: Plan,
        surrogate: Callable[[Floats], Floats],
        newton: Callable[[Floats], Floats] | None = None,
    ) -> None:
        self.plan, self.loss, self.newton = plan, surrogate, newton or surrogate
        self.evaluations = self.explored = 0
        self.played = np.zeros((0, len(plan.variables)))
        self.phases: list[str] = []
        self.breadth = 1
        self.explorer = "surrogate"
        self.passes = 0
        self.most = self.decided = math.inf

    def look(self, thetas: Floats) -> Assessment:
        self.played = np.concatenate([self.played, thetas])
        self.passes += 1
        self.explored += len(thetas)
        losses = self.loss(thetas)
        return Assessment(losses, {"e": losses < MISSED})

    def preview(self, thetas: Floats) -> Previewed:
        self.explored += MEMBERS * len(thetas)
        losses = self.loss(thetas)
        return Previewed(losses, losses < GOOD_LOSS)

    def judge(self, thetas: Floats, phase: str = "confirm") -> Found:
        self.evaluations += MEMBERS * len(thetas)
        losses = self.newton(thetas)
        k = int(np.argmin(losses))
        ensemble = Assessment(
            np.repeat(losses[k], MEMBERS), {"e": np.repeat(losses[k] < MISSED, MEMBERS)}
        )
        return Found(thetas[k], float(losses[k]), ensemble.worlds(slice(0, 1)), ensemble)

    @property
    def reference(self) -> Any:
        field = self

        class Reference:
            def assess(self, thetas: Floats) -> Assessment:
                field.evaluations += len(thetas)
                return Assessment(field.newton(thetas))

        return Reference()

    def judge_while(self, thetas: Floats, candidates: Floats) -> Any:
        return self.judge(thetas), lambda: self.reference.assess(candidates).total

    def note(self, phase: str, *_: object) -> None:
        self.phases.append(phase)


def found_in(field: Field, seed: int = 0, **options: Any) -> tuple[Found, str]:
    best, why = search(
        field.plan, cast(Any, field), np.random.default_rng(seed), 12, frozenset(), **options
    )
    assert (best.theta >= field.plan.lower()).all() and (best.theta <= field.plan.upper()).all()
    assert np.isfinite(field.played).all()
    return best, why


def miss(distance: Floats) -> Floats:
    """The loss of an event that happens within a tenth of `distance`'s unit."""
    return np.where(distance < 0.1, distance, MISSED + distance_loss((distance / 0.3) ** 2))


def narrow(*target: float) -> Callable[[Floats], Floats]:
    return lambda thetas: miss(np.linalg.norm(thetas - np.array(target), axis=1))


@pytest.mark.parametrize("seed", range(3))
def test_a_start_far_from_any_event_is_overcome(seed: int) -> None:
    """Forty spreads away, where no candidate near the start sees anything."""
    plan = plan_of(variable(0, 10, 0.5, 0.1), variable(0, 10, 9.5, 0.1), variable(0, 10, 9, 0.1))
    field = Field(plan, narrow(7.0, 3.0, 4.0))
    best, why = found_in(field, seed)
    assert why == "robust" and best.worst < GOOD_LOSS
    assert field.evaluations == MEMBERS, "one confirmation"


def test_an_engine_that_plays_many_at_once_is_asked_less_often() -> None:
    """A pass of a GPU takes as long as its longest world, however many there are."""
    plan = plan_of(*(variable(1, 20, start, 0.2) for start in (2.0, 19.0, 3.0, 18.0)))

    def loss(thetas: Floats) -> Floats:
        a, b, c, d = thetas.T
        return miss(np.abs(a * b - 60.0) / 10.0 + np.abs(c * d - 90.0) / 10.0)

    narrow_, wide = Field(plan, loss), Field(plan, loss)
    wide.breadth = 64
    for field in (narrow_, wide):
        assert found_in(field)[0].good()
    assert wide.passes < 0.6 * narrow_.passes


def test_a_start_that_leaves_nothing_to_be_wished_is_confirmed_alone() -> None:
    """Other starts are played only where the first one is not sure, or all of them at once."""
    plan = plan_of(variable(0, 10, 5.0, 0.01), variable(0, 10, 5.0, 0.01))

    def loss(thetas: Floats, offset: float = 0.0) -> Floats:
        return offset + np.linalg.norm(thetas - 5.0, axis=1)

    sure = Field(plan, loss)
    best, why = found_in(sure)
    assert why == "robust" and (best.theta == 5.0).all()
    assert (sure.explored, sure.evaluations) == (MEMBERS, MEMBERS)
    unsure = Field(plan, lambda thetas: loss(thetas, 2.0 * SURE))
    assert found_in(unsure)[1] == "robust"
    assert (unsure.explored, unsure.evaluations) == (STARTS * MEMBERS, MEMBERS)
    wide = Field(plan, loss)
    wide.breadth = 64
    assert (found_in(wide)[0].theta == 5.0).all()
    assert (wide.explored, wide.evaluations) == (STARTS * MEMBERS, MEMBERS)


def test_where_the_engines_disagree_on_it_the_others_are_confirmed_one_by_one() -> None:
    plan = plan_of(variable(0, 10, 5.0, 0.01), variable(0, 10, 5.0, 0.01))

    def surrogate(thetas: Floats) -> Floats:
        return np.linalg.norm(thetas - 5.0, axis=1)

    def newton(thetas: Floats) -> Floats:
        return np.where((thetas == 5.0).all(axis=1), MISSED + 1.0, surrogate(thetas))

    field = Field(plan, surrogate, newton)
    best, why = found_in(field)
    assert why == "robust" and not (best.theta == 5.0).all()
    assert field.explored == STARTS * MEMBERS, "the others were played then"
    assert field.evaluations == 2 * MEMBERS, "the next one is good, the rest need not be played"


def test_what_depends_on_a_combination_of_variables_is_found() -> None:
    """Only products of two variables count, as where a turn ends depends on speed times time."""
    plan = plan_of(*(variable(1, 20, start, 0.2) for start in (2.0, 19.0, 3.0, 18.0)))

    def loss(thetas: Floats) -> Floats:
        a, b, c, d = thetas.T
        return miss(np.abs(a * b - 60.0) / 10.0 + np.abs(c * d - 90.0) / 10.0)

    assert found_in(Field(plan, loss))[0].good()


def test_the_basin_of_the_start_does_not_hold_the_search() -> None:
    """Around the start the loss has a minimum that misses the event; another place has it."""
    plan = plan_of(variable(0, 10, 2.0, 0.3), variable(0, 10, 2.0, 0.3))

    def loss(thetas: Floats) -> Floats:
        trap = 11.0 + np.linalg.norm(thetas - 2.0, axis=1)
        return np.minimum(trap, narrow(8.0, 8.0)(thetas))

    best, _ = found_in(Field(plan, loss))
    assert best.good() and best.theta == pytest.approx([8.0, 8.0], abs=0.2)


def test_what_many_events_cost_together_is_no_reason_to_look_further_afield() -> None:
    """Eight events at 0.4 each are as well met as one at 0.4 is; one at 3.2 is not."""
    far = [variable(0, 10, 5.0, 0.01), variable(0, 10, 5.0, 0.01)]

    def loss(thetas: Floats) -> Floats:
        return 3.2 + np.linalg.norm(thetas - 5.0, axis=1)

    many, one = Field(plan_of(*far, events=8), loss), Field(plan_of(*far), loss)
    for field in (many, one):
        found_in(field)
    assert "sample" not in many.phases and "sample" in one.phases
    assert many.explored < 0.7 * one.explored
    assert poor(plan_of(*far, events=2)) == poor(plan_of(*far)) == POOR
    assert poor(plan_of(*far, events=1000)) < MISSED


def test_where_newton_disagrees_another_place_is_tried_before_it_polishes() -> None:
    """The surrogate sees an event in two places, Newton in one of them."""
    plan = plan_of(variable(0, 10, 2.0, 0.01), variable(0, 10, 2.0, 0.01))

    def both(thetas: Floats) -> Floats:
        other = np.linalg.norm(thetas - 7.0, axis=1)
        return np.minimum(narrow(2.0, 2.0)(thetas), np.where(other < 1.5, 0.1 * other, 30.0))

    def newton(thetas: Floats) -> Floats:
        return np.where(np.linalg.norm(thetas - 2.0, axis=1) < 1.0, 30.0, both(thetas))

    field = Field(plan, both, newton)
    best, why = found_in(field)
    assert why == "robust" and best.theta == pytest.approx([7.0, 7.0], abs=1.5)
    assert field.evaluations <= MEMBERS * (4 + 3), "no candidates in the reference engine"


@pytest.mark.parametrize("budget", [8, 40, 96])
def test_a_budget_of_the_reference_engine_is_kept(budget: int) -> None:
    """The first confirmation comes on top, as with every method."""
    plan = plan_of(variable(0, 10, 5.0, 0.1), variable(0, 10, 5.0, 0.1))
    field = Field(plan, narrow(5.0, 5.0), lambda thetas: np.full(len(thetas), 30.0))
    found_in(field, rollouts=budget)
    assert field.evaluations <= max(budget, MEMBERS * 4) + MEMBERS


@pytest.mark.parametrize("pieces", [24, 12])
def test_the_bound_of_what_comes_apart_is_met_and_kept(pieces: int) -> None:
    """Newton sees something else than the surrogate, so that rounds of it would go on."""
    block = replace(POT, name="wall", break_impulse=4.0)
    whole, parts = broken(block, pieces)
    rest = [replace(POT, name=f"pot_{k}", position=(2.0 + k, 0.0, 0.1)) for k in range(3)]
    scene = SimScene("s", (whole, *rest, *parts))
    seen: dict[str, tuple[int, str]] = {}
    for name, known in (("apart", scene), ("whole", unbroken(scene))):
        plan = plan_of(variable(0, 10, 5.0, 0.1), variable(0, 10, 5.0, 0.1))
        field = Field(
            replace(plan, scene=known),
            narrow(5.0, 5.0),
            lambda thetas: 20.0 + np.linalg.norm(thetas - 9.0, axis=1),
        )
        judge = cast(Any, field)
        _, why = run_strategy(field.plan, judge, np.random.default_rng(0), "batched", max_rounds=40)
        seen[name] = field.evaluations, why
    bound = PIECE_ROLLOUTS // len(scene.bodies)
    (few, why), (many, _) = seen["apart"], seen["whole"]
    assert bound - WORLDS < few <= bound + MEMBERS, "as many as the bound allows, and no more"
    assert many > bound + MEMBERS, "or no bound was met"
    assert why in ("rounds spent", "budget spent")


@pytest.mark.parametrize("most", [40, 100, 400])
def test_what_explores_slowly_stops_when_it_has_played_enough(most: int) -> None:
    """Rounds would go on for long: each comes a little nearer, and none is good."""
    plan = plan_of(variable(0, 10, 5.0, 0.1), variable(0, 10, 5.0, 0.1))
    seen: dict[float, int] = {}
    for bound in (float(most), math.inf):
        field = Field(plan, lambda thetas: 20.0 + np.linalg.norm(thetas - 9.0, axis=1))
        field.most = bound
        found_in(field)
        seen[bound] = field.explored
    assert most <= seen[float(most)] <= most + SAMPLE + MEMBERS * 4, "one batch more at most"
    assert seen[math.inf] > most + SAMPLE + MEMBERS * 4, "or no bound was met"


@pytest.mark.parametrize("decided", [24, 90, 200])
def test_what_decides_slowly_stops_when_it_has_played_enough(decided: int) -> None:
    """Newton sees nothing of what the surrogate calls good."""
    plan = plan_of(variable(0, 10, 5.0, 0.1), variable(0, 10, 5.0, 0.1))
    seen: dict[float, int] = {}
    for bound in (float(decided), math.inf):
        field = Field(
            plan, narrow(5.0, 5.0), lambda thetas: 20.0 + np.linalg.norm(thetas - 9.0, axis=1)
        )
        field.decided = bound
        found_in(field)
        seen[bound] = field.evaluations
    assert seen[float(decided)] <= max(decided, MEMBERS * 7) + MEMBERS
    assert seen[math.inf] > seen[float(decided)], "or no bound was met"


def test_an_event_nobody_ever_sees_is_given_up_after_a_sample_of_everything() -> None:
    """Out of reach is said only of what no place of the box came near."""
    plan = plan_of(variable(0, 10, 5.0, 0.1), variable(0, 10, 5.0, 0.1))
    field = Field(plan, lambda thetas: np.full(len(thetas), 35.0))
    best, why = found_in(field)
    assert why == "out of reach" and best.worst == 35.0
    width = np.ptp(field.played, axis=0)
    assert field.phases.count("sample") == SAMPLES and (width > 9.5).all()
    assert field.evaluations == MEMBERS * 4


@pytest.mark.parametrize("broken", [BROKEN, np.nan, np.inf])
def test_if_every_candidate_breaks_the_search_ends(broken: float) -> None:
    """No number of theirs gets into a candidate."""
    plan = plan_of(variable(0, 10, 5.0, 0.1), variable(-1, 1, 0.0, 0.1))
    field = Field(plan, lambda thetas: np.full(len(thetas), broken), lambda t: np.full(len(t), 1e6))
    best, _ = found_in(field)
    assert best.worst == BROKEN


def test_broken_candidates_hide_no_good_one() -> None:
    """Half of the box cannot be played."""
    plan = plan_of(variable(0, 10, 1.0, 0.2), variable(0, 10, 1.0, 0.2))

    def loss(thetas: Floats) -> Floats:
        return np.where(thetas[:, 0] < 5.0, np.nan, narrow(8.0, 3.0)(thetas))

    field = Field(plan, loss)

    def preview(thetas: Floats) -> Previewed:
        losses = np.nan_to_num(loss(thetas), nan=BROKEN)
        return Previewed(losses, losses < GOOD_LOSS)

    field.preview = preview  # type: ignore[method-assign]
    assert found_in(field)[0].good()


def test_one_variable() -> None:
    plan = plan_of(variable(0, 1000, 10.0, 1.0))
    assert found_in(Field(plan, lambda t: miss(np.abs(t[:, 0] - 830.0) / 10.0)))[0].good()


@pytest.mark.parametrize("shut", [(3.0, 3.0, True), (3.0, 3.0, False), (0.0, 9.0, True)])
def test_without_a_free_variable_nothing_is_searched(shut: tuple[float, float, bool]) -> None:
    """Bounds without room, whether they are marked as fixed or not, and values that are masked."""
    low, high, fixed = shut
    field = Field(plan_of(variable(low, high, 3.0, 0.5, fixed=fixed)), narrow(8.0))
    best, _ = found_in(field)
    assert best.theta == pytest.approx([3.0])
    assert field.explored == MEMBERS * STARTS and (field.played == 3.0).all()


def test_a_variable_without_room_among_others_stays() -> None:
    """An interval of zero width that is not marked as fixed divides nothing by zero."""
    plan = plan_of(variable(0, 10, 1.0, 0.1), variable(4.0, 4.0, 4.0, 0.1))
    best, _ = found_in(Field(plan, narrow(8.0, 4.0)))
    assert best.good() and best.theta[1] == 4.0


def test_a_variable_without_a_spread_is_searched_all_the_same() -> None:
    plan = plan_of(variable(0, 10, 1.0, 0.0), variable(0, 10, 1.0, 0.1))
    assert found_in(Field(plan, narrow(8.0, 3.0)))[0].good()


@pytest.mark.parametrize("target", [3.0, 15.0, -12.0])
def test_bounds_of_a_million_do_not_dilute_the_search(target: float) -> None:
    """What makes sense is within some spreads; the sample is not all spent on the rest."""
    plan = plan_of(*(variable(-1e6, 1e6, 0.0, 1.0) for _ in range(3)))
    assert found_in(Field(plan, narrow(target, 0.0, 0.3 * target)))[0].good()


def test_forty_variables() -> None:
    """Not every optimum is found in twelve rounds, but the search gets nearer and ends in time."""
    rng = np.random.default_rng(0)
    plan = plan_of(*(variable(0, 10, 5.0 + 0.1 * k % 3, 0.2) for k in range(40)))
    target = plan.initial() + rng.uniform(-0.6, 0.6, 40)
    field = Field(plan, narrow(*target))
    best, _ = found_in(field)
    start = float(narrow(*target)(plan.initial()[None])[0])
    assert best.worst < start - 1.0
    assert field.explored < 4000


def test_same_seed_same_search() -> None:
    plan = plan_of(variable(0, 10, 0.5, 0.1), variable(0, 10, 9.5, 0.1))
    one, two = (Field(plan, narrow(7.0, 3.0)) for _ in range(2))
    assert np.array_equal(found_in(one, 4)[0].theta, found_in(two, 4)[0].theta)
    assert np.array_equal(one.played, two.played)


def test_a_niche_learns_which_way_a_valley_runs() -> None:
    """A thousand times as steep across as along: a round cloud would take forever."""
    plan = plan_of(variable(-5, 5, 3.0, 0.5), variable(-5, 5, -3.0, 0.5))
    rng = np.random.default_rng(1)
    niche = Niche(plan, plan.initial(), np.inf, broad(plan))
    for _ in range(40):
        x, y = niche.ask(rng, 16).T
        niche.tell(30.0 * (x - y) ** 2 + 0.03 * (x + y - 4.0) ** 2)
    assert niche.center == pytest.approx([2.0, 2.0], abs=0.05)


def test_everywhere_is_stratified_and_keeps_what_is_fixed() -> None:
    plan = plan_of(variable(0, 60, 1.0, 0.1), variable(2, 9, 4.0, 0.1, fixed=True))
    sample = everywhere(plan, np.random.default_rng(0), SAMPLE, plan.initial())
    assert (sample[:, 1] == 4.0).all()
    wide = np.sort(sample[np.arange(SAMPLE) % 3 != 2, 0])
    assert np.diff(wide).max() < 60 * 2.0 / len(wide)
    assert (sample[2::3, 0] <= 3.0).all(), "every third within 20 spreads of the start"


def test_places_lie_apart() -> None:
    plan = plan_of(variable(0, 1, 0.5, 0.1), variable(0, 1, 0.5, 0.1))
    thetas = np.array([[0.5, 0.5], [0.51, 0.5], [0.9, 0.9], [0.1, 0.1]])
    order = apart(plan, thetas, np.array([1.0, 0.5, 2.0, 3.0]), 3, [])
    assert order == [1, 2, 3]
    assert apart(plan, thetas, np.arange(4.0), 3, [thetas[2]]) == [0, 3]


@pytest.mark.parametrize(("shape", "most"), [(bowl, UNMET), (distance_loss, FARTHEST),
                                             (unbraked, UNBRAKED)])  # fmt: skip
def test_no_loss_is_flat_far_from_the_event(shape: Callable[[Floats], Floats], most: float) -> None:
    """Ten times too far costs more than nine times, and never as much as the next worse thing."""
    x = np.concatenate([np.linspace(0, 40, 2001), np.geomspace(40.1, 1e4, 500)])
    loss = shape(x)
    assert (np.diff(loss) > 0).all() and (np.abs(np.diff(loss)) < 1.0).all()
    assert loss[0] == 0.0 and loss[-1] < most and shape(np.array([np.inf]))[0] == most
