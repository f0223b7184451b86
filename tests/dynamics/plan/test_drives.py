"""What moves on joints is planned by them: opened, closed, let go, and met where it swings."""

import math

import numpy as np
import pytest

from esg.dynamics.plan.drives import driven, goal_of, held_at
from esg.dynamics.story.story import Phase
from esg.dynamics.story.suspension import quarter_period
from esg.engines.joints import joint_between
from esg.engines.program import GuideAlong, HoldSpin
from esg.engines.scene import Body, Shape, SimScene
from esg.graph.models import TimelineEdge, TimelineNode

UNIT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
LEAF = Body("leaf", False, 20.0, UNIT, (Shape("box", (0.4, 0.02, 1.0)),), (0.4, 0.0, 1.0))


def hinged(**more) -> SimScene:
    from dataclasses import replace

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
    assert math.degrees(goal_of(joint, told, math.radians(here))) == pytest.approx(degrees)


def test_a_hinge_turns_about_its_axis_and_a_slider_moves_along_it():
    scene = hinged()
    turn = driven(scene, scene.joints[0], 0.5, 0.0, math.radians(90.0), 1.5)
    assert isinstance(turn, HoldSpin)
    assert turn.spin == pytest.approx((0.0, 0.0, math.radians(60.0)))
    assert (turn.start, turn.end) == (0.5, 2.0)
    rail = joint_between("s", "slider", LEAF, None, at=LEAF.position, axis=(0.0, 1.0, 0.0))
    slide = driven(SimScene("s", (LEAF,), joints=(rail,)), rail, 0.0, 0.0, 0.3, 1.0)
    assert isinstance(slide, GuideAlong)
    assert np.subtract(slide.at(1.0), slide.at(0.0)) == pytest.approx([0.0, 0.3, 0.0])


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
