"""What breaks in one candidate is detected, stays in that candidate and is reported."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.dynamics.gradient.descent import descend_from
from esg.dynamics.losses.assessment import Assessment
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import Plan, make_plan
from esg.dynamics.search.baselines import minimize
from esg.dynamics.search.panel import REFERENCE_DT_S, Panel
from esg.dynamics.search.simulate import Simulator
from esg.dynamics.strategies import optimize
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene
from esg.graph.models import EsgDocument, Pose
from tests.dynamics import stories
from tests.dynamics.stage import lay_out
from tests.engines.lab import ball, box

BROKEN = 1e6


def _plan(doc: EsgDocument) -> Plan:
    return make_plan(doc, build_scene(doc), seed=0)


@pytest.mark.parametrize("engine", ["newton", "surrogate", "physx"])
def test_a_theta_that_is_no_number_stays_alone(engine: str) -> None:
    """Its loss is large and finite, nothing counts as completed, its neighbours' are unchanged."""
    plan = _plan(lay_out(stories.three_balls()))
    sound = plan.initial()
    broken = sound.copy()
    broken[int(np.argmax(plan.free()))] = np.nan
    simulator = Simulator(plan, get_engine(engine), dt=REFERENCE_DT_S)
    alone = simulator.assess(sound[None])
    both = simulator.assess(np.stack([sound, broken, sound]))
    assert both.total[1] == BROKEN
    assert not any(done[1] for done in both.completed.values())
    assert both.total[[0, 2]] == pytest.approx(np.repeat(alone.total, 2), abs=1e-9)


@pytest.mark.parametrize("engine", ["newton", "surrogate", "physx"])
def test_a_world_that_diverges_stays_alone(engine: str) -> None:
    """A launch faster than the limit of 500 m/s is a broken world, not a fast one."""
    plan = _plan(lay_out(stories.three_balls()))
    at = next(i for i, v in enumerate(plan.variables) if v.name.endswith("/speed"))
    thetas = np.tile(plan.initial(), (2, 1))
    thetas[1, at] = 5000.0
    found = Simulator(plan, get_engine(engine), dt=REFERENCE_DT_S).assess(thetas)
    assert found.total[1] == BROKEN and found.total[0] < BROKEN
    assert found.all_completed().tolist() == [bool(found.all_completed()[0]), False]


def test_searches_pass_over_broken_candidates() -> None:
    """A baseline whose every second rollout breaks ends with the best of the others."""
    plan = _plan(lay_out(stories.three_balls()))
    panel = Panel(plan, "cpu", dt=REFERENCE_DT_S)
    played: list[np.ndarray] = []

    def assess(thetas: np.ndarray, members: object = None) -> Assessment:
        played.extend(thetas)
        losses = np.abs(thetas - 1.3 * plan.initial()).sum(axis=1)
        losses[1::2] = BROKEN
        return Assessment(losses)

    panel.reference.assess = assess  # type: ignore[method-assign]
    best = minimize(plan, panel, np.random.default_rng(0), "cem", 64)
    sound = [t for k, t in enumerate(played) if k % 2 == 0]
    assert any(np.array_equal(best, t) for t in sound)


def test_a_gradient_that_is_no_number_moves_nothing() -> None:
    """NaN and infinite entries are replaced by zero; theta stays within its bounds."""
    plan = _plan(lay_out(stories.three_balls()))
    panel = Panel(plan, "cpu", dt=REFERENCE_DT_S)

    def assess(thetas: np.ndarray, members: object = None) -> Assessment:
        losses = np.full(len(thetas), np.nan)
        losses[0] = 5.0
        return Assessment(losses)

    panel.reference.assess = assess  # type: ignore[method-assign]
    found = descend_from(plan, panel, plan.initial(), "newton", 3)
    assert found.loss == 5.0
    assert np.array_equal(found.theta, plan.initial())


@pytest.mark.parametrize("engine", ["newton", "surrogate", "physx", "rapier"])
@pytest.mark.parametrize("speed", [15.0, 40.0])
def test_a_fast_ball_does_not_pass_a_thin_wall(engine: str, speed: float) -> None:
    """At 240 Hz it moves up to 17 cm a step; the wall is 2 cm thick."""
    wall = replace(box("wall", (0.01, 1.0, 1.0), 100.0, (2.0, 0.0, 1.0)), static=True)
    scene = SimScene("thin", (ball("a", 0.05, 0.4, (0.0, 0.0, 0.5)), wall))
    program = Program((SetVelocity("a", 0.0, (speed, 0.0, 0.0)),), 0.4)
    rollout = get_engine(engine).rollout(
        scene, batch_programs([program], scene.names), dt=REFERENCE_DT_S
    )
    assert rollout.valid.all()
    assert rollout.position[0, :, 0, 0].max() < 2.0
    log = rollout.contacts
    assert ((log.a == 0) & (log.b == 1)).any(), "the hit is logged"


def test_a_start_inside_another_body_is_no_completed_collision() -> None:
    """Bodies that overlap from the beginning touch, but nobody hit anybody."""
    doc = lay_out(stories.car_hits_jeep_at_3s())
    assert doc.layout_result is not None
    poses = dict(doc.layout_result.poses)
    names = [n for n in poses if n != "ground_1"]
    poses[names[0]] = Pose(position_cm=poses[names[1]].position_cm, yaw_deg=poses[names[1]].yaw_deg)
    doc = doc.model_copy(
        update={"layout_result": doc.layout_result.model_copy(update={"poses": poses})}
    )
    result = optimize(doc, max_rounds=1).dynamics_result
    assert result is not None
    assert result.outcome != "solved" and result.reason
    assert np.isfinite(result.loss)


def test_an_empty_feasible_set_ends_as_nearest_feasible() -> None:
    """What gave way is named, with what was asked and what was achieved."""
    result = optimize(lay_out(stories.impossible_transfer()), max_rounds=2).dynamics_result
    assert result is not None and result.outcome == "nearest_feasible"
    (gave,) = result.relaxed
    assert (gave.event, gave.quantity) == ("e", "speed_after")
    assert gave.achieved < 0.2 * gave.requested and "instead of" in result.reason
    assert min(result.margins.values()) < 0.0


def test_bounds_without_room_leave_the_value_where_it_is() -> None:
    """Variables whose bounds are one value are masked, also if all of them are."""
    plan = _plan(lay_out(stories.three_balls()))
    shut = tuple(replace(v, lower=v.initial, upper=v.initial, fixed=True) for v in plan.variables)
    plan = replace(plan, variables=shut)
    panel = Panel(plan, "cpu", dt=REFERENCE_DT_S)
    found = descend_from(plan, panel, plan.initial(), "newton", 2)
    assert np.array_equal(found.theta, plan.initial())
    for method in ("random", "cem", "cma"):
        best = minimize(plan, panel, np.random.default_rng(0), method, 8)
        assert np.array_equal(best, plan.initial())
