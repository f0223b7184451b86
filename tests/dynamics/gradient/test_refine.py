"""Searches on simple proxies and their refinement by signed distance fields."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.dynamics.gradient.refine import Staged, proxy_plan, refine, refined_bodies
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import Plan, make_plan
from esg.dynamics.search.panel import REFERENCE_DT_S
from esg.dynamics.search.simulate import Simulator
from esg.dynamics.story.proxies import coarse, simple_document
from esg.dynamics.strategies import optimize
from esg.engines.registry import get_engine
from esg.graph.models import Pose
from esg.outcomes import UserError
from tests.dynamics import stories
from tests.dynamics.stage import lay_out


def test_balls_and_hollow_bodies_keep_their_shapes() -> None:
    """A sphere is exact already; walls and openings are smaller than a cell."""
    for story, names in (
        (stories.car_bin_table, ("car_1", "bin_1", "table_1")),
        (stories.three_balls, ()),
        (stories.scores_goal, ()),
    ):
        doc = lay_out(story())
        scene = build_scene(doc)
        assert refined_bodies(scene, make_plan(doc, scene).story) == names


def test_simple_proxies_reach_choreography_and_layout() -> None:
    """A bounding sphere is as long and as wide as the body is at its longest."""
    doc = stories.car_bin_table()
    known = simple_document(doc, "sphere").asset_configurations
    assert known["car_1"].dimensions_cm == (450.0, 450.0, 450.0)
    assert [p.kind.value for p in known["bin_1"].proxies] == ["sphere"]
    boxes = simple_document(doc).asset_configurations
    assert boxes["car_1"].dimensions_cm == doc.asset_configurations["car_1"].dimensions_cm
    assert [p.kind.value for p in boxes["car_1"].proxies] == ["box"]
    assert boxes["ground_1"] == doc.asset_configurations["ground_1"]


def test_coarse_scenes_have_one_primitive_a_body_and_keep_balls() -> None:
    """Bodies stand on the ground as before, whatever their primitive."""
    scene = build_scene(lay_out(stories.car_bin_table()))
    for kind in ("box", "sphere"):
        for body in coarse(scene, kind).bodies:
            assert len(body.shapes) <= 1
            for shape in body.shapes:
                low = body.position[2] + shape.position[2] - shape.size[2]
                assert low == pytest.approx(0.0, abs=1e-9)
    balls = build_scene(lay_out(stories.three_balls()))
    assert coarse(balls, "sphere") == balls


@pytest.mark.parametrize("collision", ["proxy", "sdf"])
def test_the_result_says_how_it_was_searched(collision: str) -> None:
    """Provenance names the model; the record shows the stages; the true parts judge."""
    doc = optimize(lay_out(stories.car_bin_table()), collision=collision, max_rounds=2)
    result = doc.dynamics_result
    assert result is not None and result.engine == "newton"
    assert doc.provenance[-1].config == {"strategy": "batched", "collision": collision}
    assert result.stopped == ("refined" if collision == "sdf" else "proxies only")
    engines = {s.engine for s in result.steps if s.phase.startswith("refine")}
    assert engines == ({"surrogate-sdf"} if collision == "sdf" else set())
    assert (result.steps[-1].phase, result.steps[-1].engine) == ("confirm", "newton")
    assert result.outcome == "solved"


def test_default_documents_do_not_mention_a_collision_model() -> None:
    doc = optimize(lay_out(stories.three_balls()), max_rounds=1)
    assert doc.provenance[-1].config == {"strategy": "batched"}


def test_wrong_choices_name_the_right_ones() -> None:
    doc = lay_out(stories.three_balls())
    with pytest.raises(UserError, match="exact, proxy, sdf"):
        optimize(doc, collision="hull")
    with pytest.raises(UserError, match="closed loop"):
        optimize(doc, collision="sdf", rounds_closed=1)


def test_balls_alone_need_no_refinement() -> None:
    """Nothing is searched a second time where proxies are exact."""
    doc = lay_out(stories.three_balls())
    plan = proxy_plan(doc, build_scene(doc), seed=0)
    found = Staged(plan, plan.initial(), [], 0, 0)
    assert refine(doc, found, _never, strategy="batched", device="cpu") is found


@pytest.mark.slow
def test_refinement_finds_a_hit_off_the_centre() -> None:
    """From a hit that sends the bin past a table off its line to one that does not."""
    doc = _table_aside(33.0)
    scene = build_scene(doc)
    plan = proxy_plan(doc, scene, seed=0)
    wide = [
        replace(v, lower=-1.2, upper=1.2, spread=0.3, initial=-0.8)
        if v.name.endswith("/lateral")
        else v
        for v in plan.variables
    ]
    plan = replace(plan, variables=tuple(wide), scene=scene)
    warm = Staged(plan, plan.initial(), [], 0, 0)
    found = refine(doc, warm, _never, strategy="fd", device="cpu")
    assert found.refined == ("car_1", "bin_1", "table_1")
    # With the true parts, in an engine that had no say.
    true = Simulator(found.plan, get_engine("physx"), dt=REFERENCE_DT_S)
    before, after = (true.assess(t[None]) for t in (warm.theta, found.theta))
    assert before.completed["e1"][0] and not before.completed["e2"][0]
    assert after.all_completed()[0]


def _never(plan: Plan, panel: object) -> np.ndarray:
    raise AssertionError("no further search was asked for")


def _table_aside(angle_deg: float):
    doc = lay_out(stories.car_bin_table())
    poses = dict(doc.layout_result.poses)
    (hx, hy, _), (x, y, z) = poses["bin_1"].position_cm, poses["table_1"].position_cm
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    dx, dy = x - hx, y - hy
    poses["table_1"] = Pose(
        position_cm=(hx + c * dx - s * dy, hy + s * dx + c * dy, z),
        yaw_deg=poses["table_1"].yaw_deg + angle_deg,
    )
    return doc.model_copy(
        update={"layout_result": doc.layout_result.model_copy(update={"poses": poses})}
    )
