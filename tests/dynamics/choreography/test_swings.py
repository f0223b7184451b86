"""Bats, clubs and stones that send something on."""

from __future__ import annotations

import math

import pytest

from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.story.stagecraft import prop
from esg.dynamics.story.suspension import suspension
from esg.graph.models import EsgDocument
from esg.layout.problem.hints import Placement
from esg.thresholds import MIN_EVENT_GAP_S
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast

BAT = "A baseball bat knocks a baseball into a tin can."


def places(doc: EsgDocument) -> dict[str, Placement]:
    told = choreograph(doc).hints.constellations
    return {p.node: p for c in told for p in c.placements}


def test_a_bat_comes_broadside_and_level() -> None:
    doc = cast(BAT)
    spots = places(doc)
    bat, ball = spots["baseball_bat_1"], spots["baseball_1"]
    way = math.atan2(ball.y_cm - bat.y_cm, ball.x_cm - bat.x_cm)
    assert abs(math.cos(math.radians(bat.yaw_deg or 0.0) - way)) < 0.01
    lasts = choreograph(doc).nominal["baseball_bat_1_flight/flight_time"]
    middle = (bat.z_cm or 0.0) + 50.0 * prop(doc, "baseball_bat_1").height
    drop = 50.0 * GRAVITY_MPS2 * lasts**2
    assert middle - drop == pytest.approx(50.0 * prop(doc, "baseball_1").height, abs=5.0)
    assert lasts < 0.25


def test_a_bat_that_only_hits_something_comes_as_it_is() -> None:
    assert places(cast("A baseball bat is thrown at a wall."))["baseball_bat_1"].yaw_deg == 0.0


def test_a_swing_into_an_opening_is_gentle() -> None:
    def speed(prompt: str) -> float:
        nominal = choreograph(cast(prompt)).nominal
        return next(v for k, v in nominal.items() if k.endswith("flight/speed"))

    into = speed("A golf club hits a golf ball and the ball rolls into a hole.")
    assert into < 0.6 * speed("A golf club hits a golf ball and the ball hits a wall.")


@pytest.mark.parametrize(
    ("prompt", "hung", "met", "beyond"),
    [
        ("A wrecking ball swings into a brick wall.", "wrecking_ball_1", "brick_wall_1", True),
        ("A wrecking ball swings into a soda can.", "wrecking_ball_1", "soda_can_1", False),
    ],
)
def test_what_swings_meets_what_is_tall_beyond_its_lowest_point(
    prompt: str, hung: str, met: str, beyond: bool
) -> None:
    doc = cast(prompt)
    found = suspension(doc, hung)
    assert found is not None
    spots = places(doc)
    there, wall = spots[hung], prop(doc, met)
    way = math.hypot(spots[met].x_cm - there.x_cm, spots[met].y_cm - there.y_cm) / 100.0
    free = way - 0.5 * prop(doc, hung).length - 0.5 * min(wall.length, wall.width)
    late = (free - found.way) / found.speed
    assert (late > MIN_EVENT_GAP_S) is beyond
