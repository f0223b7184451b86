"""Headings in front of a colon, and where a scene takes place."""

from __future__ import annotations

import pytest

from esg.draft import draft
from tests.draft.told import events


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
