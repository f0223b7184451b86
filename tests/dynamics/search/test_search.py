"""Every kind of event is made to happen, and what cannot happen is said so."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.dynamics.search.batched import Explored, search, settled, with_pieces
from esg.dynamics.search.panel import GOOD_LOSS, REFERENCE_DT_S, Panel
from esg.dynamics.search.simulate import Simulator
from esg.dynamics.strategies import optimize
from esg.engines.program import batch_programs, program_from_json
from esg.engines.registry import get_engine
from esg.graph.models import EsgDocument, EventConstraint
from esg.outcomes import UserError
from tests.dynamics import stories
from tests.dynamics.stage import lay_out


def _solve(doc: EsgDocument, seed: int = 0):
    plan = make_plan(doc, build_scene(doc), seed=seed)
    panel = Panel(plan, "cpu", dt=REFERENCE_DT_S)
    found, stopped = search(plan, panel, np.random.default_rng(seed), 8)
    assert stopped and panel.steps
    return plan, panel, found


@pytest.mark.parametrize("story", stories.EVERY, ids=lambda s: s.__name__)
def test_search_makes_every_event_happen(story) -> None:
    """All events complete under the whole ensemble and prescribed quantities are met."""
    _, _, found = _solve(lay_out(story(), 1), 1)
    assert found.ensemble.all_completed().all(), found.ensemble.completed
    assert found.ensemble.within_tolerance().all(), found.ensemble.error


def test_search_gets_as_near_as_physics_allows() -> None:
    """Momentum bounds what a light ball can pass on: (1 + e) m_a / (m_a + m_b) v."""
    _, _, found = _solve(lay_out(stories.impossible_transfer()))
    speed = found.nominal.measured["e/speed_after/heavy"][0]
    bound = (1 + 0.7) * 0.45 / (0.45 + 9.0) * 3.0
    assert found.nominal.all_completed().all()
    assert 0.7 * bound < speed <= 1.02 * bound


def test_what_the_surrogate_could_not_improve_is_not_polished_where_newton_agrees() -> None:
    """A search in the reference engine begins only where it sees something else."""
    plan, panel, found = _solve(lay_out(stories.impossible_transfer()))
    explored = Explored(found.theta[None], found.worst, True)
    assert settled(found, explored)
    assert not settled(found, replace(explored, stalled=False)), "more rounds may still help"
    assert not settled(found, replace(explored, worst=0.5 * found.worst)), "Newton disagrees"
    missed = replace(found, ensemble=panel.reference.assess(plan.lower()[None]))
    assert not missed.ensemble.all_completed().all() and not settled(missed, explored)
    assert [s.phase for s in panel.steps][-1] == "confirm" and found.worst > GOOD_LOSS


def test_the_heuristic_alone_misses_the_prescribed_time() -> None:
    """Without the search the middle of the draft's speed interval decides when they meet."""
    doc = lay_out(stories.car_hits_jeep_at_3s())
    plan = make_plan(doc, build_scene(doc), seed=0)
    simulator = Simulator(plan, get_engine("physx"), dt=REFERENCE_DT_S)
    assessed = simulator.assess(plan.heuristic()[None])
    assert assessed.all_completed().all() and not assessed.within_tolerance().any()


def test_fixed_values_stay_fixed() -> None:
    """A prescribed speed is masked out of the search."""
    plan, _, found = _solve(lay_out(stories.car_brakes_to_stop()))
    values = {v.name: t for v, t in zip(plan.variables, found.theta, strict=True)}
    assert values["drive/speed"] == 10.0
    assert np.all(found.theta >= plan.lower()) and np.all(found.theta <= plan.upper())


def test_same_speed_cars_share_one_variable() -> None:
    """ "Two cars at the same speed" have one speed, whatever the search does."""
    doc = lay_out(stories.rear_end())
    plan = make_plan(doc, build_scene(doc), seed=0)
    names = [v.name for v in plan.variables]
    assert "d1/speed" in names and "d2/speed" not in names
    speeds = {
        p.body: p.speed for p in plan.compile(plan.initial()).primitives if hasattr(p, "speed")
    }
    assert speeds["front"] == speeds["rear"]


def test_reference_engine_solves_a_chain_and_physx_agrees() -> None:
    """theta found in Newton plays the same story in PhysX, which did not see it."""
    doc = optimize(lay_out(stories.car_bin_table()), seed=0)
    result = doc.dynamics_result
    assert result is not None and result.outcome == "solved" and result.engine == "newton"
    scene = build_scene(doc)
    program = program_from_json(result.program)
    rollout = get_engine("physx").rollout(scene, batch_programs([program], scene.names))
    index = scene.names.index
    log = rollout.contacts
    hits = [
        log.time[(log.a == min(p)) & (log.b == max(p))]
        for p in ((index("car_1"), index("bin_1")), (index("bin_1"), index("table_1")))
    ]
    assert len(hits[0]) and len(hits[1]) and hits[1][0] > hits[0][0] + 0.1


def test_same_seed_same_bytes() -> None:
    """The stage is deterministic."""
    doc = lay_out(stories.three_balls())
    assert optimize(doc, seed=3) == optimize(doc, seed=3)


def test_unknown_strategy_names_the_known_ones() -> None:
    """A wrong --strategy is the user's mistake."""
    with pytest.raises(UserError, match="batched"):
        optimize(lay_out(stories.three_balls()), strategy="magic")


def test_static_scene_needs_no_search() -> None:
    """A scene without a timeline gets an empty program."""
    doc = stories.three_balls().model_copy(update={"timeline_system": None})
    from esg.graph.models import LayoutResult, Pose

    poses = {n: Pose(position_cm=(60.0 * i, 0, 0)) for i, n in enumerate(doc.asset_configurations)}
    doc = doc.model_copy(update={"layout_result": LayoutResult(poses=poses, energy=0.0)})
    result = optimize(doc).dynamics_result
    assert result is not None and result.outcome == "solved"
    assert result.program["primitives"] == []


def test_what_holds_under_every_perturbation_is_not_explored_any_further() -> None:
    """Friction moves the time to stop: no theta has a small worst case, and none is looked for."""
    story = stories.car_brakes_to_stop()
    system = story.timeline_system
    assert system is not None
    exact = EventConstraint(quantity="time_to_stop", object="car_1", value=2.5)
    graph = system.sequence_graph
    nodes = tuple(
        n.model_copy(update={"constraints": (exact,)}) if n.id == "e2" else n for n in graph.nodes
    )
    graph = graph.model_copy(update={"nodes": nodes})
    system = system.model_copy(update={"sequence_graph": graph})
    story = story.model_copy(update={"timeline_system": system})
    plan, panel, found = _solve(lay_out(story))
    assert found.worst > GOOD_LOSS, "or this would test nothing"
    assert found.good() and abs(found.nominal.measured["e2/time_to_stop/car_1"][0] - 2.5) < 0.1
    assert {s.phase for s in panel.steps} == {"start", "confirm"}
    shown = panel.preview(found.theta[None])
    assert shown.good.all() and (shown.worst > GOOD_LOSS).all()
    far = found.theta.copy()
    far[[v.name for v in plan.variables].index("brake/braking")] *= 1.5
    assert not panel.preview(far[None]).good.any()


@pytest.mark.parametrize(
    ("bodies", "whole", "asked", "most"),
    [(4, 4, None, None), (4, 4, 500, 500), (28, 4, None, 107), (28, 4, 50, 50), (16, 4, None, 187)],
)
def test_rollouts_of_many_pieces_are_few(bodies, whole, asked, most) -> None:
    assert with_pieces(bodies, whole, asked) == most
