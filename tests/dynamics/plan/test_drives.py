"""What moves on joints is planned by them: opened, closed, let go, and met where it swings."""

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.dynamics.plan.drives import drawn_to, driven, held_at, let_go, reach_of
from esg.dynamics.story.driving import goal_of
from esg.dynamics.story.story import Phase
from esg.dynamics.story.suspension import quarter_period
from esg.engines import get_engine
from esg.engines.joints import joint_between, joint_state
from esg.engines.program import DriveJoint, GuideAlong, HoldSpin, Program, batch_programs
from esg.engines.scene import Body, Shape, SimScene
from esg.graph.models import TimelineEdge, TimelineNode

UNIT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
LEAF = Body("leaf", False, 20.0, UNIT, (Shape("box", (0.4, 0.02, 1.0)),), (0.4, 0.0, 1.0))


def hinged(**more) -> SimScene:
    joint = joint_between("h", "hinge", LEAF, None, at=(0.0, 0.0, 1.0), axis=(0.0, 0.0, 1.0))
    return SimScene("s", (LEAF,), joints=(replace(joint, **more),))


def phase(event: str, degrees: float | None = None, **params) -> Phase:
    start = TimelineNode(id="a", event="SceneStart", timestamp=0)
    end = TimelineNode(
        id="b", event=event, participants=("leaf",), window=(0.0, 9.0), turn_degrees=degrees
    )
    raw = {"id": "e", "from": "a", "to": "b", "event": "Drive", "actor": "leaf", "params": params}
    return Phase(TimelineEdge.model_validate(raw), start, end)


@pytest.mark.parametrize(
    ("told", "limits", "here", "degrees"),
    [
        (phase("Open"), (0.0, 110.0), 0.0, 75.0),
        (phase("Open"), (0.0, 60.0), 0.0, 60.0),
        (phase("Open"), (-110.0, 0.0), 0.0, -75.0),
        (phase("Open", degrees=70.0), (0.0, 110.0), 0.0, 98.0),
        (phase("Open", opening=45.0), (0.0, 110.0), 0.0, 45.0),
        (phase("Close"), (0.0, 110.0), 80.0, 0.0),
    ],
)
def test_it_is_driven_as_far_as_is_asked(told, limits, here, degrees):
    lower, upper = map(math.radians, limits)
    joint = hinged(lower=lower, upper=upper).joints[0]
    assert math.degrees(goal_of(reach_of(joint), told, math.radians(here))) == pytest.approx(
        degrees
    )


def test_a_hinge_turns_about_its_axis_and_a_slider_moves_along_it():
    scene = hinged()
    (turn,) = driven(scene, scene.joints[0], 0.5, 0.0, math.radians(90.0), 1.5)
    assert isinstance(turn, HoldSpin)
    assert turn.spin == pytest.approx((0.0, 0.0, math.radians(60.0)))
    assert (turn.start, turn.end) == (0.5, 2.0)
    rail = joint_between("s", "slider", LEAF, None, at=LEAF.position, axis=(0.0, 1.0, 0.0))
    (slide,) = driven(SimScene("s", (LEAF,), joints=(rail,)), rail, 0.0, 0.0, 0.3, 1.0)
    assert isinstance(slide, GuideAlong)
    assert np.subtract(slide.at(1.0), slide.at(0.0)) == pytest.approx([0.0, 0.3, 0.0])


def lid(**more) -> SimScene:
    """A lid of 0.5 kg that lies level on a hinge about -Y and is opened upwards from there."""
    from dataclasses import replace

    inertia = ((0.0017, 0.0, 0.0), (0.0, 0.0017, 0.0), (0.0, 0.0, 0.0033))
    leaf = Body("lid", False, 0.5, inertia, (Shape("box", (0.1, 0.1, 0.005)),), (0.1, 0.0, 0.5))
    joint = joint_between("h", "hinge", leaf, None, at=(0.0, 0.0, 0.5), axis=(0.0, -1.0, 0.0))
    return SimScene("s", (leaf,), joints=(replace(joint, **more),))


@pytest.mark.parametrize("engine", ["newton", "physx", "rapier"])
def test_what_gravity_holds_down_is_lifted_and_held(engine: str) -> None:
    """A spin of 0.4 rad/s loses more than that to gravity in every step."""
    scene = lid(lower=0.0, upper=2.0, friction=0.2)
    joint, goal = scene.joints[0], math.radians(75.0)
    for lasts in (1.0, 3.5):
        program = Program(driven(scene, joint, 0.2, 0.0, goal, lasts), 6.0)
        rollout = get_engine(engine).rollout(scene, batch_programs([program], scene.names))
        pose = rollout.position[0, :, 0], rollout.quaternion[0, :, 0]
        angle = joint_state(joint, pose, None).position
        assert angle[-1] == pytest.approx(goal, abs=math.radians(4.0))
        assert float(angle.max()) < goal + math.radians(3.0)


def test_a_lid_falls_by_itself_and_a_motor_rests_where_friction_holds() -> None:
    """0.49 N m hold 0.5 kg level at 0.1 m, 0.13 N m at 75 degrees."""
    up = math.radians(75.0)
    for friction, count in ((0.05, 1), (0.2, 2)):
        scene = lid(lower=0.0, upper=2.0, friction=friction)
        lifts = driven(scene, scene.joints[0], 0.5, 0.0, up, 2.0)
        assert len(lifts) == count
        assert isinstance(lifts[0], DriveJoint)
        assert (lifts[0].position, lifts[0].speed) == (up, pytest.approx(up / 2.0))
        assert lifts[0].limit == pytest.approx(friction + 4.0 * 0.4905)
        assert all(isinstance(p, DriveJoint) and p.lets_go for p in lifts[1:])
    down = driven(scene, scene.joints[0], 0.5, up, 0.0, 2.0)
    assert [type(p) for p in down] == [HoldSpin]


def test_what_has_lifted_lets_go_for_what_comes_next() -> None:
    first = [DriveJoint("h", 0.0, 1.0, 1.3), DriveJoint("h", 2.5)]
    assert let_go(list(first), 2.0) == [first[0], DriveJoint("h", 2.0)]
    spin = HoldSpin("lid", 0.0, 1.0, 1.0)
    assert let_go([spin], 2.0) == [spin]


def test_what_is_let_go_later_is_held_until_then():
    held = held_at(LEAF, 2.0)
    assert isinstance(held, GuideAlong)
    assert (held.end, held.at(1.0)) == (2.0, LEAF.position)


@pytest.mark.parametrize(("degrees", "longer"), [(1.0, 1.0), (60.0, 1.0732), (90.0, 1.1803)])
def test_quarter_of_a_period_by_the_elliptic_integral(degrees, longer):
    """Of 1 m: a quarter of 2 pi sqrt(l / g), longer by the amplitude's factor (tables)."""
    small = 0.5 * math.pi * math.sqrt(1.0 / 9.81)
    assert quarter_period(1.0, 9.81, math.radians(degrees)) == pytest.approx(
        small * longer, rel=1e-4
    )


@pytest.mark.parametrize("blown", [40.0, 95.0, -70.0])
def test_a_leaf_is_swung_back_from_wherever_a_blow_has_left_it(blown: float) -> None:
    limit = math.radians(100.0)
    leaf = replace(LEAF, position=(0.4, 0.0, 1.1))  # clear of the ground
    made = joint_between("h", "hinge", leaf, None, at=(0.0, 0.0, 1.1), axis=(0.0, 0.0, 1.0))
    joint = replace(made, lower=-limit, upper=limit, friction=1.5, damping=1.0)
    scene = SimScene("s", (leaf,), joints=(joint,))
    blow, back = math.radians(blown) / 0.5, 1.0
    hit = HoldSpin("leaf", 0.0, 0.5, blow, (0.0, 0.0, 1.0))
    program = Program((hit, *drawn_to(scene, joint, back, 0.0, 1.5)), 4.0)
    rollout = get_engine("physx").rollout(scene, batch_programs([program], scene.names))
    pose = rollout.position[0, :, 0], rollout.quaternion[0, :, 0]
    angle = np.degrees(joint_state(joint, pose, None).position)
    assert float(np.abs(angle).max()) > 0.5 * abs(blown)
    assert abs(float(angle[-1])) < 2.0
