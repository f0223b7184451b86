"""What tips over onto the next thing: it stands on its end, and that is met late in its fall."""

from __future__ import annotations

import math

import pytest

from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.story.kinematics import half_along
from esg.dynamics.story.stagecraft import prop
from esg.graph.models import EsgDocument, ForceDirection
from esg.layout.problem.hints import Placement
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast


def places(doc: EsgDocument) -> dict[str, Placement]:
    told = choreograph(doc).hints.constellations
    return {p.node: p for c in told for p in c.placements}


def clear(doc: EsgDocument, a: str, b: str) -> float:
    """Free way between two along X [m]."""
    spots = places(doc)
    halves = 0.0
    for name in (a, b):
        body = prop(doc, name)
        halves += half_along(body.length, body.width, math.radians(spots[name].yaw_deg or 0.0))
    return 0.01 * abs(spots[a].x_cm - spots[b].x_cm) - halves


@pytest.mark.parametrize("noun", ["plank", "book", "surfboard"])
def test_a_board_that_topples_stands_on_its_end(noun: str) -> None:
    size = cast(f"A {noun} topples over.").asset_configurations[f"{noun}_01"].dimensions_cm
    assert max(size) == size[2] > 1.4 * sorted(size)[1]


def test_a_board_that_is_only_hit_lies_as_it_did() -> None:
    length, _, height = cast("A ball hits a plank.").asset_configurations["plank_01"].dimensions_cm
    assert height < length


@pytest.mark.parametrize(
    ("prompt", "a", "b"),
    [
        ("A plank leaning against a wall falls onto a toolbox.", "plank_1", "toolbox_1"),
        ("A tree falls on a car.", "tree_1", "car_1"),
        ("A book topples over and hits a cup.", "book_1", "cup_1"),
    ],
)
def test_what_falls_over_meets_the_next_thing_beyond_half_of_its_fall(
    prompt: str, a: str, b: str
) -> None:
    doc = cast(prompt)
    gap, height, low = clear(doc, a, b), prop(doc, a).height, prop(doc, b).height
    assert math.atan2(gap, low) > math.radians(50.0)
    assert gap < 0.9 * height


def test_what_is_sent_ahead_is_down_before_it_arrives() -> None:
    doc = cast("A car knocks over a road sign, and the sign hits a trash can.")
    sign = prop(doc, "road_sign_1")
    assert clear(doc, "road_sign_1", "trash_can_1") > 8.0 * math.sqrt(sign.height / GRAVITY_MPS2)


def test_a_tall_thing_that_shall_fall_ahead_is_not_kicked_at_its_foot() -> None:
    doc = cast("A ball hits a plank leaning against a wall and the plank falls on a vase.")
    assert doc.timeline_system is not None
    assert doc.timeline_system.actors["ball_1"].force_direction is ForceDirection.ANY_3D
