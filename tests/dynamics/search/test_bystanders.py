"""Bodies held still during the search: who they are, and that nothing changes by it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.dynamics import build_scene
from esg.dynamics.losses.gap import bounding_radius, surface_gap
from esg.dynamics.losses.measures import gap_over_time
from esg.dynamics.losses.recording import Recording
from esg.dynamics.plan.planner import Plan, make_plan
from esg.dynamics.search import bystanders
from esg.dynamics.search.panel import REFERENCE_DT_S, Panel
from esg.dynamics.search.simulate import ENSEMBLE, Simulator
from esg.dynamics.strategies import optimize
from esg.engines import get_engine
from esg.engines.program import batch_programs
from esg.engines.scene import Body, Shape
from esg.thresholds import NEAR_M
from tests.dynamics import stories
from tests.dynamics.stage import lay_out

UNIT = ((0.2, 0.0, 0.0), (0.0, 0.2, 0.0), (0.0, 0.0, 0.2))
RACK = tuple(
    Shape("box", (0.05, 0.05, 0.05), (0.2 * i, 0.2 * j, 0.0))
    for i in range(-2, 3)
    for j in range(4)
)


def rack(name: str, x: float, y: float, z: float = 0.05) -> Body:
    return Body(name, False, 4.0, UNIT, RACK, (x, y, z), half_extents=(0.45, 0.45, 0.05))


def beside(plan: Plan, *more: Body) -> Plan:
    return replace(plan, scene=plan.scene.with_bodies((*plan.scene.bodies, *more)))


@pytest.fixture(scope="module")
def plan() -> Plan:
    doc = lay_out(stories.three_balls(), 1)
    return make_plan(doc, build_scene(doc), seed=0)


def _held(plan: Plan) -> list[str]:
    return [n for n, s in zip(plan.scene.names, bystanders.bystanders(plan), strict=True) if s]


def _far(plan: Plan) -> tuple[float, float]:
    """A place that nothing comes near."""
    return max(b.position[0] for b in plan.scene.bodies) + 30.0, 0.0


def test_only_what_rests_apart_from_the_story_is_held(plan: Plan) -> None:
    """What hangs in the air is not, nor what it falls on, nor what stands by a ball."""
    x, y = _far(plan)
    assert _held(plan) == []
    assert _held(beside(plan, rack("aside", x, y))) == ["aside"]
    hanging = rack("hanging", x + 5.0, y, 0.8)
    assert _held(beside(plan, rack("aside", x, y), hanging)) == ["aside"]
    ball = plan.scene.bodies[plan.scene.index(next(iter(plan.story.phases)))]
    near = rack("near", ball.position[0], ball.position[1] + ball.half_extents[1] + 0.08)
    assert _held(beside(plan, rack("aside", x, y), near)) == ["aside"]
    assert _held(beside(plan, replace(rack("aside", x, y), shapes=RACK[:4]))) == [], "too little"


def _assessed(plan: Plan, *, hold: bool):
    simulator = Simulator(plan, get_engine("newton"), dt=REFERENCE_DT_S, hold=hold)
    thetas = np.repeat(plan.initial()[None], len(ENSEMBLE), axis=0)
    found = simulator.assess(thetas, list(ENSEMBLE))
    return found, simulator


def test_worlds_without_a_touch_are_the_same(plan: Plan) -> None:
    """All losses, times and events of the ensemble, with a rack held and with it free."""
    scene = beside(plan, rack("aside", *_far(plan)))
    free, _ = _assessed(scene, hold=False)
    held, simulator = _assessed(scene, hold=True)
    assert simulator.holds and simulator.evaluations == len(ENSEMBLE)
    assert held.total == pytest.approx(free.total, abs=1e-4)
    for name in free.completed:
        assert np.array_equal(free.completed[name], held.completed[name])
        assert held.time[name] == pytest.approx(free.time[name], abs=1e-6, nan_ok=True)


def test_touched_worlds_are_played_with_everything_free(plan: Plan) -> None:
    """A rack in the way of the balls is touched: those worlds count twice, and are exact."""
    rollout = get_engine("newton").rollout(
        plan.scene, batch_programs([plan.compile(plan.initial())], plan.scene.names),
        dt=REFERENCE_DT_S,
    )  # fmt: skip
    balls = [i for i, b in enumerate(plan.scene.bodies) if b.collides]
    path = rollout.position[0][:, balls].astype(float)
    k = int(np.linalg.norm(path[-1] - path[0, 0], axis=-1).argmax())
    ahead = path[-1, k, :2] - path[0, k, :2]
    x, y = path[-1, k, :2] + 0.4 * ahead / np.linalg.norm(ahead)
    scene = beside(plan, rack("in the way", x, y))
    assert _held(scene) == ["in the way"]
    free, _ = _assessed(scene, hold=False)
    held, simulator = _assessed(scene, hold=True)
    assert simulator.evaluations > len(ENSEMBLE)
    assert held.total == pytest.approx(free.total, abs=1e-3)


def test_a_search_ends_with_the_whole_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    """One more rollout, noted; where it says something else, the search is done with all bodies."""
    doc = lay_out(stories.three_balls(), 1)
    monkeypatch.setattr(bystanders, "WORTH_SHAPES", 0)
    calls: list[bool] = []
    true = bystanders.bystanders

    def some(plan: Plan):
        calls.append(True)
        still = true(plan)
        return still

    monkeypatch.setattr("esg.dynamics.search.simulate.bystanders", some)
    result = optimize(doc, seed=0, max_rounds=2).dynamics_result
    assert result is not None and calls
    scene = build_scene(doc)
    plan = make_plan(doc, scene, seed=0)
    panel = Panel(beside(plan, rack("aside", *_far(plan))), "cpu", dt=REFERENCE_DT_S)
    found = panel.judge(plan.initial()[None])
    before = panel.evaluations
    whole = panel.whole(found)
    assert whole is not None and panel.evaluations == before + 1
    assert panel.steps[-1].phase == "whole"
    wrong = replace(found, nominal=replace(found.nominal, total=found.nominal.total + 1.0))
    assert panel.whole(wrong) is None and not panel.reference.holds


def test_near_gaps_are_exact_where_they_matter(plan: Plan) -> None:
    """The smallest gap of every world, its frame, and all gaps within reach."""
    rollout = get_engine("surrogate").rollout(
        plan.scene, batch_programs([plan.compile(plan.initial())] * 2, plan.scene.names),
        dt=REFERENCE_DT_S, record_every=4,
    )  # fmt: skip
    rec = Recording(plan.scene, plan.story, rollout, [{}, {}])
    moving = [i for i, b in enumerate(plan.scene.bodies) if b.collides]
    a, b = moving[:1], moving[1:]
    exact, quick = gap_over_time(rec, a, b), gap_over_time(rec, a, b, near_only=True)
    assert np.array_equal(exact.argmin(axis=1), quick.argmin(axis=1))
    assert quick.min(axis=1) == pytest.approx(exact.min(axis=1), abs=1e-12)
    assert np.array_equal(exact <= NEAR_M, quick <= NEAR_M)
    assert (quick <= exact + 1e-9).all() and (quick < exact - 1e-6).any()


def test_bounding_spheres_hold_what_gaps_measure() -> None:
    """Two turned racks are never closer than their spheres say."""
    one, two = rack("a", 0.0, 0.0), rack("b", 0.0, 0.0)
    rng = np.random.default_rng(0)
    p, q = rng.normal(size=(50, 3)), rng.normal(size=(50, 4))
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    gap = surface_gap(one, two, np.zeros((50, 3)), q, p, q[::-1])
    least = np.linalg.norm(p, axis=1) - bounding_radius(one) - bounding_radius(two)
    assert (least <= gap + 1e-9).all()
