"""Who overtakes drives past somebody that drives, and may be run into by them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.dynamics import build_scene, optimize, start_hints
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.choreography.telling import _tell, choreograph
from esg.dynamics.story.story import read_story
from esg.engines.program import batch_programs, program_from_json
from esg.engines.registry import get_engine
from esg.graph.models import EsgDocument
from esg.layout import solve
from esg.metrics import expectations_from_timeline, judge
from tests.dynamics.stories import cast

CUT_IN = (
    "A car overtakes a slower truck and then brakes in front of it. The truck cannot stop in time "
    "and rear-ends the car."
)


def _laid_out(prompt: str, seed: int = 0) -> EsgDocument:
    doc = cast(prompt, seed)
    return solve(doc, seed=seed, hints=start_hints(doc, seed=seed))


def _replayed(doc: EsgDocument):
    scene = build_scene(doc)
    assert doc.dynamics_result is not None
    program = program_from_json(doc.dynamics_result.program)
    rollout = get_engine("physx").rollout(scene, batch_programs([program], scene.names))
    return scene, rollout, judge(scene, program, rollout, expectations_from_timeline(doc, scene))


@pytest.mark.parametrize("seed", [0, 3])
def test_who_overtakes_and_brakes_is_hit_from_behind(seed: int) -> None:
    """It starts behind, passes without a touch, comes before the other and is hit at its back."""
    doc = optimize(_laid_out(CUT_IN, seed), seed=seed)
    scene, rollout, verdict = _replayed(doc)
    assert verdict.completed == verdict.n_events == 4
    car, truck = scene.index("car_1"), scene.index("truck_1")
    way = rollout.linear_velocity[0, 10, truck].astype(float)
    way /= np.linalg.norm(way)
    ahead = (rollout.position[0, :, car] - rollout.position[0, :, truck]).astype(float) @ way
    hit = next(e.time_s for e in verdict.events if e.id == "truck_1_car_1_collision")
    passed = next(e.time_s for e in verdict.events if e.id.endswith("overtakes"))
    assert hit is not None and passed is not None and passed < hit
    assert ahead[0] < -1.0
    at_hit = ahead[int(np.searchsorted(rollout.time, hit))]
    lengths = scene.body("car_1").half_extents[0] + scene.body("truck_1").half_extents[0]
    assert at_hit > 0.85 * lengths, "from behind, not from the side"


def test_who_is_overtaken_drives_all_the_while() -> None:
    """Its stated speed is kept; what overtakes is as much faster as passing it takes."""
    doc = cast("A car overtakes a truck driving at 8 m/s and then turns right.")
    found = choreograph(doc, seed=0)
    assert found.nominal["truck_1_drive/speed"] == pytest.approx(8.0)
    assert found.nominal["car_1_drive/speed"] > 10.0
    places = {p.node: p for c in found.hints.constellations for p in c.placements}
    assert places["car_1"].x_cm < places["truck_1"].x_cm, "it starts behind"


@pytest.mark.slow
def test_who_is_slower_overtakes_nobody() -> None:
    """Both speeds are stated: the events are told as not reached, and nothing breaks."""
    prompt = "A car driving at 5 m/s overtakes a truck driving at 12 m/s and then turns right."
    doc = optimize(_laid_out(prompt))
    assert doc.dynamics_result is not None


def test_touching_before_passing_is_no_overtaking() -> None:
    """The judge counts an overtaking only if the two have not touched by then."""
    doc = optimize(_laid_out(CUT_IN))
    scene = build_scene(doc)
    assert doc.dynamics_result is not None
    program = program_from_json(doc.dynamics_result.program)
    suite = expectations_from_timeline(doc, scene)
    # Still behind: the truck never leaves, the car never gets ahead of anything that moves.
    slow = type(program)(
        tuple(p for p in program.primitives if p.body != "car_1"), program.duration
    )
    rollout = get_engine("physx").rollout(scene, batch_programs([slow], scene.names))
    verdict = judge(scene, slow, rollout, suite)
    passing = next(e for e in verdict.events if e.id.endswith("overtakes"))
    assert not passing.completed and "does not get ahead" in passing.reason


def test_where_it_cuts_in_is_where_it_has_passed_whatever_came_before() -> None:
    """A first stretch does not move the two apart at the place of passing."""
    doc = cast(CUT_IN)
    stage = Stage(doc, read_story(doc), {"car_1", "truck_1"}, np.random.default_rng(0))
    told = []
    for first in (0.0, 12.0):
        stage = Stage(doc, read_story(doc), {"car_1", "truck_1"}, np.random.default_rng(0))
        if first:
            stage.tracks["car_1"].straight(first, 1.0, 12.0)
            stage.tracks["car_1"].time = 0.0
        _tell(stage)
        car, truck = stage.tracks["car_1"], stage.overtaken["truck_1"]
        told.append((stage.places["truck_1"], truck[2], car.time))
    (x0, y0, _), (passed0, _), _ = told[0][0], told[0][1], told[0][2]
    (x1, y1, _), (passed1, _), _ = told[1][0], told[1][1], told[1][2]
    assert passed1 - passed0 == pytest.approx(12.0, abs=1e-6)
    assert math.hypot(x1 - x0 - 12.0, y1 - y0) == pytest.approx(0.0, abs=1e-6)
