"""What a blow is to break is no heavier than the blow breaks it; what breaks at a wall gets there."""

from __future__ import annotations

import pytest

from esg.dynamics.casting.motion import NOT_YET, SURELY_BREAKS
from esg.dynamics.choreography.slopes import fastest_down, slope_of
from esg.dynamics.losses.breaking import SAFE_BLOW
from esg.dynamics.story.stagecraft import prop, support_of
from tests.dynamics.stories import cast


@pytest.mark.parametrize(
    ("prompt", "mover", "pane", "speed"),
    [
        ("A golf ball flies at 20 m/s into a window and the glass shatters.", "golf_ball_1",
         "window_1", 20.0),
        ("A tennis ball hits a mirror at 24 m/s and the mirror shatters.", "tennis_ball_1",
         "mirror_1", 24.0),
    ],
)  # fmt: skip
def test_a_stated_speed_breaks_what_it_hits(
    prompt: str, mover: str, pane: str, speed: float
) -> None:
    doc = cast(prompt)
    ball, glass = prop(doc, mover), prop(doc, pane)
    breaking = doc.spatial_relation_graph.nodes[pane].breaking
    assert breaking is not None
    blow = (1.0 + 0.5 * (ball.restitution + glass.restitution)) * ball.mass * speed
    assert blow > SAFE_BLOW * glass.mass * breaking.speed / 100.0


def test_what_a_stone_breaks_anyhow_keeps_its_mass() -> None:
    usual = cast("A stone rolls past a window.")
    assert prop(cast("A brick breaks a window."), "window_1").mass == pytest.approx(
        prop(usual, "window_1").mass
    )


def test_a_melon_gets_to_its_wall_whole_and_breaks_there() -> None:
    doc = cast("A watermelon rolls down a ramp and breaks at the wall.")
    melon, wall = prop(doc, "watermelon_1"), prop(doc, "wall_1")
    breaking = doc.spatial_relation_graph.nodes["watermelon_1"].breaking
    ramp = support_of(doc, "watermelon_1")
    slope = slope_of(doc, ramp or "")
    speed = fastest_down(doc, "watermelon_1")
    assert breaking is not None and slope is not None and speed is not None
    bears = breaking.speed / 100.0 / (1.0 + 0.5 * (melon.restitution + wall.restitution))
    sine = slope.steepness / (1.0 + slope.steepness**2) ** 0.5
    assert SURELY_BREAKS * bears < speed
    assert speed * sine < 1.1 * NOT_YET * bears


def test_a_broom_that_a_door_knocks_over_stands_and_one_that_a_ball_hits_lies() -> None:
    heights = [
        prop(cast(prompt), "broom_1").height
        for prompt in ("A door swings open and knocks a broom over.", "A ball hits a broom.")
    ]
    assert heights[0] > 1.0 > 10.0 * heights[1]
