"""Gradient strategies, baselines and the closed loop."""

from __future__ import annotations

import numpy as np
import pytest

from esg.dynamics.gradient.descent import descend, needs_differences
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.dynamics.search.panel import REFERENCE_DT_S, Panel
from esg.dynamics.story.story import read_story
from esg.dynamics.strategies import optimize
from esg.graph.models import EsgDocument
from tests.dynamics import stories
from tests.dynamics.stage import lay_out


def _panel(doc: EsgDocument) -> tuple[object, Panel]:
    plan = make_plan(doc, build_scene(doc), seed=0)
    return plan, Panel(plan, "cpu", dt=REFERENCE_DT_S)


@pytest.mark.parametrize("strategy", ["fd", "ad", "hybrid"])
def test_descent_meets_a_prescribed_time(strategy: str) -> None:
    """Adam starts from the coarse sample and ends in tolerance in the reference engine."""
    plan, panel = _panel(lay_out(stories.throw_hits_table_at_1s()))
    found = descend(plan, panel, np.random.default_rng(0), strategy, 12)
    assessed = panel.reference.assess(found.theta[None])
    assert assessed.all_completed().all() and assessed.within_tolerance().all()
    best = [s.best for s in panel.steps if s.phase == "descend"]
    assert best == sorted(best, reverse=True)


@pytest.mark.parametrize("strategy", ["ad", "fd"])
def test_a_strategy_asks_only_its_engine(strategy: str) -> None:
    """`ad` never plays the reference engine before the end, `fd` never the surrogate."""
    plan, panel = _panel(lay_out(stories.car_hits_jeep_at_3s()))
    descend(plan, panel, np.random.default_rng(0), strategy, 2)
    asked = {s.engine for s in panel.steps}
    assert asked == {"surrogate" if strategy == "ad" else "newton"}
    assert (panel.evaluations == 0) == (strategy == "ad")


def test_switch_is_read_from_the_dependency_graph() -> None:
    """A passive body that goes on to hit something needs differences; a direct hit does not."""
    assert needs_differences(read_story(lay_out(stories.car_bin_table())))
    assert not needs_differences(read_story(lay_out(stories.car_hits_jeep_at_3s())))


@pytest.mark.parametrize("method", ["random", "cem", "cma"])
def test_baselines_spend_their_budget_and_no_more(method: str) -> None:
    """Equal budgets are equal: the final judgement by the ensemble comes on top."""
    doc = lay_out(stories.throw_hits_table_at_1s())
    result = optimize(doc, strategy=method, rollouts=48).dynamics_result
    assert result is not None and result.stopped == "budget spent"
    assert result.explored == 0
    assert 40 <= sum(s.candidates for s in result.steps if s.phase == "sample") <= 48


def test_closed_loop_reports_both_figures() -> None:
    """The open loop's figures stay beside the closed loop's, which are no worse."""
    doc = lay_out(stories.car_hits_jeep_at_3s())
    result = optimize(doc, rounds_closed=2).dynamics_result
    assert result is not None and result.closed_loop is not None
    loop = result.closed_loop
    assert loop.engine == "physx" and loop.rounds <= 2
    assert loop.closed["completed"] >= loop.open["completed"]
    assert loop.closed["largest_error"] <= loop.open["largest_error"] + 1e-9


def test_bias_moves_the_target() -> None:
    """What an engine measures too much is added to the time that is asked of it."""
    plan, panel = _panel(lay_out(stories.car_hits_jeep_at_3s()))
    theta = plan.initial()[None]
    name = next(n for n in panel.surrogate.assess(theta).error if "/time/" in n)
    before = panel.surrogate.assess(theta).error[name][0]
    panel.rebias({name: 0.5})
    assert panel.surrogate.assess(theta).error[name][0] == pytest.approx(before - 0.5, abs=1e-6)
