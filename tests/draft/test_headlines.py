"""Headlines without a verb, headings in front of a colon, and where a scene takes place."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from esg.draft.grammar.rewrites.headlines import spelled_out
from tests.draft.told import events


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("van crash on a bridge", [("Collision", "van_1", "van_2")]),
        ("a rear-end collision: two trucks, 30 mph", [("Collision", "truck_1", "truck_2")]),
        ("head-on collision of two trams", [("Collision", "tram_1", "tram_2")]),
        (
            "domino effect with six books on a table",
            [("Topple", "book_1")],
        ),
        (
            "Bowling strike!!",
            [("Collision", "bowling_ball_1", "bowling_pin_1"), ("Topple", "bowling_pin_1")],
        ),
        ("bus crash into a wall", [("Collision", "bus_1", "wall_1")]),
        ("Bus crash at an intersection", [("Collision", "bus_1", "bus_2")]),
        ("ferry collision", [("Collision", "ferry_1", "ferry_2")]),
    ],
)
def test_headlines_tell_their_event(prompt: str, told: list[tuple[Any, ...]]) -> None:
    """Draw the event that a headline names."""
    assert events(prompt) == told


@pytest.mark.parametrize(
    "prompt",
    [
        "A car crashes into a wall.",
        "The collision of two cars makes a lamp fall.",
        "A van crash makes a sign fall over.",
        "Two cars collide.",
        "A test crash.",
        "Domino effect with 12 s",
    ],
)
def test_sentences_stay_as_they_are(prompt: str) -> None:
    """Leave what has a verb, or names nothing that drives, alone."""
    assert spelled_out(prompt) == prompt


@pytest.mark.parametrize(
    ("prompt", "absent"),
    [
        ("Shopping cart race: two carts roll down a hill and collide.", "shopping"),
        ("Drone delivery gone wrong: the drone clips a chimney.", "delivery"),
        ("Pool trick shot: the cue ball hits the red ball.", "pool"),
        ("Two trams collide in a depot.", "depot"),
        ("A plane lands at the airport and hits a truck.", "airport"),
    ],
)
def test_headings_and_scenes_are_no_things(prompt: str, absent: str) -> None:
    """Draw neither what a heading names nor where it all takes place."""
    doc = draft(prompt)
    assert not [n for n in doc.spatial_relation_graph.nodes if absent in n]
    assert not doc.coverage.warnings


def test_what_comes_before_a_colon_may_be_a_thing() -> None:
    """Keep things that the sentence after the colon goes on about."""
    assert events("Two cars: one brakes, the other hits it.") == [("Collision", "car_2", "car_1")]


def test_a_tower_of_blocks_is_several_and_a_pile_of_snow_is_one() -> None:
    """Draw the members of what is stacked, and one heap of a substance."""
    assert events("A toy car hits a tower of blocks and the top block falls down.") == [
        ("Collision", "toy_car_1", "top_block_1"),
        ("Fall", "top_block_1"),
    ]
    assert events("A truck drives into a pile of snow.") == [
        ("Collision", "truck_1", "pile_of_snow_1")
    ]
