"""Rollouts that end when they have told everything measure what whole ones do."""

from __future__ import annotations

import numpy as np
import pytest

from esg.dynamics import build_scene
from esg.dynamics.losses.assessment import Assessment
from esg.dynamics.losses.horizon import expected_end, looked_at_for, told_by
from esg.dynamics.losses.kinds import KINDS
from esg.dynamics.plan.planner import Plan, make_plan
from esg.dynamics.search.cloud import around, spreads
from esg.dynamics.search.panel import REFERENCE_DT_S, Panel
from esg.dynamics.search.simulate import ENSEMBLE, Simulator
from esg.engines import get_engine
from esg.graph.models import NodeEvent
from tests.dynamics import stories
from tests.dynamics.stage import lay_out

PARTS = ("completed", "time", "measured", "error")


def planned(story) -> Plan:
    doc = lay_out(story(), 1)
    return make_plan(doc, build_scene(doc), seed=0)


def ensemble(plan: Plan, until: float = np.inf) -> tuple[Assessment, int]:
    """All members in the surrogate, and how many rollouts that took."""
    simulator = Simulator(plan, get_engine("surrogate"), dt=REFERENCE_DT_S)
    thetas = np.repeat(plan.initial()[None], len(ENSEMBLE), axis=0)
    return simulator.assess(thetas, list(ENSEMBLE), until=until), simulator.evaluations


def same(one: Assessment, two: Assessment) -> None:
    for part in PARTS:
        for key, values in getattr(one, part).items():
            assert np.array_equal(values, getattr(two, part)[key], equal_nan=True), (part, key)


@pytest.mark.parametrize("story", stories.EVERY, ids=lambda s: s.__name__)
def test_the_end_of_a_rollout_tells_nothing_more(story) -> None:
    plan = planned(story)
    whole, _ = ensemble(plan)
    until = float(told_by(plan.story, whole).max())
    short, played = ensemble(plan, until)
    same(short, whole)
    # How near its middle something comes to rest in a container is a preference.
    assert short.total == pytest.approx(whole.total, abs=0.02)
    assert played == len(ENSEMBLE) or until > plan.duration


def test_what_has_not_told_everything_is_played_to_its_end() -> None:
    plan = planned(stories.three_balls)
    whole, _ = ensemble(plan)
    ends = np.sort(told_by(plan.story, whole))
    assert ends[0] < ends[-1] < plan.duration
    some, played = ensemble(plan, float(0.5 * (ends[0] + ends[-1])))
    assert len(ENSEMBLE) < played < 2 * len(ENSEMBLE)
    same(some, whole)
    none, played = ensemble(plan, 0.3)
    assert played == 2 * len(ENSEMBLE)
    same(none, whole)


def test_a_missing_event_and_what_may_be_touched_later_keep_the_whole_rollout() -> None:
    plan = planned(stories.three_balls)
    nodes = [n for n in plan.story.nodes.values() if np.isfinite(looked_at_for(n))]
    known = Assessment(
        np.zeros(2),
        {n.id: np.array([True, n is not nodes[-1]]) for n in nodes},
        {n.id: np.array([1.0, 1.0]) for n in nodes},
    )
    after = KINDS[NodeEvent.COLLISION.value].after_s
    assert told_by(plan.story, known).tolist() == [1.0 + after, np.inf]
    assert all(KINDS[e.value].after_s == np.inf for e in (NodeEvent.MISS, NodeEvent.REACH))


def test_the_search_plays_no_longer_than_it_has_to() -> None:
    """What the panel previews and looks at is what whole rollouts show, in less time."""
    plan = planned(stories.three_balls)
    assert expected_end(plan) < 0.7 * plan.duration
    thetas = around(plan, plan.initial(), spreads(plan), np.random.default_rng(0), 6)
    short, whole = (Panel(plan, "cpu", dt=REFERENCE_DT_S) for _ in range(2))
    whole._may_stop, whole._until = False, np.inf
    for part in (thetas[:1], thetas[1:]):
        one, two = short.preview(part), whole.preview(part)
        assert one.worst == pytest.approx(two.worst, abs=0.02)
        assert np.array_equal(one.good, two.good)
    assert np.isfinite(short._until) and short._until < 0.8 * plan.duration
    same(short.look(thetas), whole.look(thetas))
    assert short.explored < 1.4 * whole.explored


def test_what_waits_for_the_end_is_played_to_it() -> None:
    """Of a search in which most candidates miss something no rollout is cut short."""
    plan = planned(stories.three_balls)
    panel = Panel(plan, "cpu", dt=REFERENCE_DT_S)
    panel._expect(np.array([1.0, 1.1, np.inf, np.inf]))
    assert panel._until == np.inf
    panel._expect(np.array([1.0, 1.1, 1.2, 1.3, np.inf]))
    assert 1.3 < panel._until < 1.5
    assert looked_at_for(next(iter(plan.story.nodes.values()))) < 1.0
