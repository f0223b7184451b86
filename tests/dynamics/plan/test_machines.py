"""Machines of the table of jointed things move on their joints in PhysX, from a plain prompt."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.dynamics import start_hints
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.engines import get_engine
from esg.engines.joints import joint_poses, joint_state
from esg.engines.program import batch_programs
from esg.layout import solve
from tests.dynamics.stories import cast


def way_of(prompt: str, child: str) -> np.ndarray:
    """Positions of a joint over the first guess of a prompt, played in PhysX [deg or cm]."""
    doc = cast(prompt)
    doc = solve(doc, seed=0, hints=start_hints(doc, seed=0))
    plan = make_plan(doc, build_scene(doc), seed=0)
    program = plan.compile(plan.initial())
    played = get_engine("physx").rollout(
        plan.scene, batch_programs([program], plan.scene.names), record_every=4
    )
    joint = next(j for j in plan.scene.joints if j.child == child)
    assert joint.parent is not None
    ends = (plan.scene.index(joint.child), plan.scene.index(joint.parent))
    poses = (played.position.astype(float), played.quaternion.astype(float))
    there, held = ((poses[0][0, :, i], poses[1][0, :, i]) for i in ends)
    position = np.asarray(joint_state(joint, there, held).position, float)
    if joint.kind == "slider":
        return 100.0 * position
    return np.degrees(np.unwrap(position, period=2.0 * math.pi))


@pytest.mark.parametrize(
    ("prompt", "child", "start", "end", "slack"),
    [
        ("The laptop closes.", "laptop_lid_1", 105.0, 0.0, 3.0),
        ("A drawbridge lowers.", "drawbridge_1", 80.0, 0.0, 3.0),
        ("A drawbridge is raised.", "drawbridge_1", 0.0, 75.0, 1.0),
        ("A laptop that lies shut is opened.", "laptop_lid_1", 0.0, 75.0, 1.0),
        ("A lever is pulled.", "lever_1", 0.0, 40.0, 6.0),
        ("A spring launcher is released.", "spring_launcher_1", -30.0, 0.0, 5.0),
        (
            "A crate stands on a trapdoor. The trapdoor opens and the crate falls through.",
            "trapdoor_1",
            0.0,
            90.0,
            10.0,
        ),
    ],
)
def test_it_goes_to_the_other_end(
    prompt: str, child: str, start: float, end: float, slack: float
) -> None:
    way = way_of(prompt, child)
    assert way[0] == pytest.approx(start, abs=1.0)
    assert abs(way[-1]) == pytest.approx(end, abs=slack)


@pytest.mark.parametrize(
    ("prompt", "child"),
    [
        ("A toy car runs into a spring bumper and bounces back.", "spring_bumper_1"),
        ("A block slides into a spring and is thrown back.", "spring_1"),
    ],
)
def test_a_bumper_is_squeezed_and_comes_back(prompt: str, child: str) -> None:
    way = way_of(prompt, child)
    assert way.min() < 0.2 * -16.0 * 0.3, "a fifth of the way of the smallest one"
    assert way[-1] == pytest.approx(0.0, abs=0.5)


@pytest.mark.parametrize(
    ("prompt", "child"),
    [
        ("The ceiling fan turns.", "ceiling_fan_1"),
        ("A Ferris wheel turns.", "ferris_rotor_1"),
        ("A garden wagon rolls into a crate.", "hinged_wheel_3"),
    ],
)
def test_it_turns_all_the_way_round(prompt: str, child: str) -> None:
    way = way_of(prompt, child)
    assert abs(way[-1] - way[0]) > 330.0


@pytest.mark.parametrize(
    ("prompt", "child", "drawn"),
    [
        ("The pendulum of a grandfather clock swings back and forth.", "pendulum_1", 13.0),
        ("A trebuchet swings.", "trebuchet_arm_1", -120.0),
    ],
)
def test_it_swings_through_its_lowest_point(prompt: str, child: str, drawn: float) -> None:
    way = way_of(prompt, child)
    assert way[0] == pytest.approx(drawn, abs=1.0)
    beyond = -(np.sign(drawn) * way).min()
    assert beyond > 0.3 * min(abs(drawn), 60.0)


def test_a_balance_goes_down_where_something_drops() -> None:
    way = way_of("A golf ball drops onto one end of a balance scale.", "balance_scale_1")
    assert way[0] == pytest.approx(9.0, abs=1.0)
    assert way.min() < -5.0


def test_a_wagon_stands_on_its_wheels_and_is_re_aimed_with_them() -> None:
    doc = cast("A garden wagon rolls into a crate.")
    doc = solve(doc, seed=0, hints=start_hints(doc, seed=0))
    plan = make_plan(doc, build_scene(doc), seed=0)
    assert doc.layout_result is not None
    poses = doc.layout_result.poses
    wheels = [n for n in plan.scene.names if n.startswith("hinged_wheel")]
    assert len(wheels) == 4
    assert all(0.0 <= poses[n].position_cm[2] < 0.1 for n in ("wagon_1", *wheels))
    theta = plan.initial()
    theta[[v.name for v in plan.variables].index("wagon_1/aim")] = 0.05
    starts = plan.starts(theta)
    moved = tuple(
        replace(b, position=tuple(starts[b.name][0]), quaternion=tuple(starts[b.name][1]))
        if b.name in starts
        else b
        for b in plan.scene.bodies
    )
    scene = replace(plan.scene, bodies=moved)
    gaps = [joint_state(j, *joint_poses(scene, j)).gap for j in scene.joints]
    assert max(float(g) for g in gaps) < 1e-6
