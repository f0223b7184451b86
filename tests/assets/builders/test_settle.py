"""The whole library stands still on a plane, and balls drop into billiard pockets."""

from __future__ import annotations

import numpy as np
import pytest

from esg.assets.library.catalogue import entries_by_name
from esg.assets.stage import configure
from esg.dynamics.plan.build import make_body
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene
from esg.graph.models import Node, Pose
from tests.assets.worlds import EMPTY, faults, requirement, settle, solid_entries


@pytest.mark.slow
def test_library_settles_in_physx() -> None:
    entries = solid_entries()
    assert faults(settle("physx", entries), entries) == []


@pytest.mark.slow
@pytest.mark.parametrize("part", range(6))
def test_library_settles_in_newton(part: int) -> None:
    entries = solid_entries()[part::6]
    assert faults(settle("newton", entries), entries) == []


@pytest.mark.parametrize("speed", [0.8, 2.0, 4.0])
def test_ball_rolled_at_a_pocket_stays_in_it(speed: float) -> None:
    names = entries_by_name()
    table = configure("t", requirement(names["billiard_table"]))
    ball = configure("b", requirement(names["billiard_ball"], linear_damping=0.1))
    bed = next(s for s in table.support_surfaces if s.name == "bed").center_cm[2]
    radius = ball.dimensions_cm[2] / 200
    fixed = make_body(
        EMPTY, "t", Node(asset_id="t"), table, Pose(position_cm=(0, 0, 0)), active=False
    )
    for region in table.regions:
        goal = np.array(region.center_cm)
        start = np.array([0.3 * goal[0] if goal[0] else 25.0, 0.1 * goal[1]])
        d = (goal[:2] - start) / np.linalg.norm(goal[:2] - start)
        pose = Pose(position_cm=(float(start[0]), float(start[1]), bed))
        moving = make_body(EMPTY, "b", Node(asset_id="b"), ball, pose, active=True)
        scene = SimScene(scene_id="pool", bodies=(fixed, moving))
        launch = SetVelocity(
            "b", 0.0, (d[0] * speed, d[1] * speed, 0.0),
            (-d[1] * speed / radius, d[0] * speed / radius, 0.0),
        )  # fmt: skip
        batch = batch_programs([Program((launch,), 3.0)], scene.names)
        end = get_engine("physx").rollout(scene, batch, record_every=24).position[0, -1, 1] * 100
        assert (np.abs(end - goal) <= np.array(region.half_extents_cm) + 1e-3).all(), region.name


@pytest.mark.parametrize("speed", [0.6, 1.0, 1.6])
def test_ball_rolled_at_a_golf_hole_stays_in_it(speed: float) -> None:
    names = entries_by_name()
    hole = configure("h", requirement(names["golf_hole"]))
    ball = configure("b", requirement(names["golf_ball"], linear_damping=0.1))
    fixed = make_body(
        EMPTY,
        "h",
        Node(asset_id="h", is_static=True),
        hole,
        Pose(position_cm=(0, 0, 0)),
        active=False,
    )
    start = Pose(position_cm=(60, 2, 0))
    moving = make_body(EMPTY, "b", Node(asset_id="b"), ball, start, active=True)
    scene = SimScene(scene_id="putt", bodies=(fixed, moving))
    launch = SetVelocity("b", 0.0, (-speed, 0.0, 0.0), (0.0, -speed / moving.roll_radius, 0.0))
    batch = batch_programs([Program((launch,), 4.0)], scene.names)
    end = get_engine("physx").rollout(scene, batch, record_every=24).position[0, -1, 1] * 100
    (region,) = hole.regions
    inside = np.abs(end - np.array(region.center_cm)) <= np.array(region.half_extents_cm)
    assert inside.all(), end
