"""What the prompt has hit on a side is turned so, whoever moves."""

from __future__ import annotations

import math

import pytest

from esg.dynamics.choreography import choreograph
from esg.layout import Placement
from tests.dynamics.stories import cast


def places(prompt: str) -> dict[str, Placement]:
    (constellation,) = choreograph(cast(prompt)).hints.constellations
    return {p.node: p for p in constellation.placements}


def turn_deg(prompt: str, struck: str, by: str) -> float:
    """Yaw of what is struck, from that of what comes [deg]."""
    at = places(prompt)
    assert at[struck].yaw_deg is not None and at[by].yaw_deg is not None
    return math.remainder(at[struck].yaw_deg - at[by].yaw_deg, 360.0)


@pytest.mark.parametrize(
    ("prompt", "struck", "by", "turned"),
    [
        ("A motorcycle crashes into the side of a taxi.", "taxi_1", "motorcycle_1", (90, -90)),
        ("A car hits the left side of a van.", "van_1", "car_1", (90,)),
        ("A car hits the right side of a van.", "van_1", "car_1", (-90,)),
        ("A car crashes into the front of a bus.", "bus_1", "car_1", (180, -180)),
        ("A car rear-ends a bus.", "bus_1", "car_1", (0,)),
        ("A ball hits a man in the back.", "man_1", "ball_1", (0,)),
        ("A cart is pushed into the front of a cow.", "cow_1", "cart_1", (180, -180)),
        ("A truck T-bones a moving car.", "car_1", "truck_1", (90, -90)),
        ("A car drives along, and a truck hits its side.", "car_1", "truck_1", (90, -90)),
        ("A car drives along, and a truck hits it from behind.", "car_1", "truck_1", (0,)),
        ("A car drives along, and a truck hits it head-on.", "car_1", "truck_1", (180, -180)),
        ("A ball hits a cart, which rolls into the side of a van.", "van_1", "cart_1", (90, -90)),
    ],
)
def test_what_is_struck_is_turned_to_what_comes(
    prompt: str, struck: str, by: str, turned: tuple[float, ...]
) -> None:
    assert any(abs(turn_deg(prompt, struck, by) - t) < 1.0 for t in turned)


def test_who_is_hit_across_is_where_it_is_hit_then() -> None:
    """Both are on their way: the one that is struck starts beside the other one's path."""
    at = places("A car drives along, and a truck hits its side.")
    one, other = at["truck_1"], at["car_1"]
    yaw = math.radians(one.yaw_deg or 0.0)
    dx, dy = other.x_cm - one.x_cm, other.y_cm - one.y_cm
    aside = -math.sin(yaw) * dx + math.cos(yaw) * dy
    ahead = math.cos(yaw) * dx + math.sin(yaw) * dy
    assert abs(aside) > 300.0
    assert ahead > 300.0


def test_what_was_struck_comes_back_from_a_wall() -> None:
    """The next one lies off the wall, not in it."""
    at = places("A red ball hits a blue ball, which bounces off a wall and hits a green ball.")
    wall, green, blue = at["wall_1"], at["green_ball_1"], at["blue_ball_1"]
    facing = math.radians(wall.yaw_deg or 0.0)
    sides = [
        math.cos(facing) * (b.x_cm - wall.x_cm) + math.sin(facing) * (b.y_cm - wall.y_cm)
        for b in (green, blue)
    ]
    assert sides[0] * sides[1] > 0.0
    assert min(map(abs, sides)) > 20.0


def test_what_is_met_next_lies_beyond_what_was_met_before() -> None:
    at = places("A ball hits a green ball, which hits a pillow and then hits a blue ball.")
    pillow, blue = at["pillow_1"], at["blue_ball_1"]
    assert math.hypot(blue.x_cm - pillow.x_cm, blue.y_cm - pillow.y_cm) > 30.0
