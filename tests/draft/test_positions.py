"""Members told by where they are, and what else is hit after a relative clause."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from esg.graph.models import Predicate
from tests.draft.told import events


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        (
            "Two vans drive in line. The rear van hits the one in front.",
            [("Collision", "rear_van_1", "front_van_1")],
        ),
        (
            "A tram stops and the one behind it runs into it.",
            [("Stop", "tram_1"), ("Collision", "rear_tram_1", "tram_1")],
        ),
        (
            "Three carts stand in a row. The one on the left rolls into the one in the middle.",
            [("Collision", "left_cart_1", "middle_cart_1")],
        ),
        (
            "Three crates stand in a row. The crate on the right slides into the middle one.",
            [("Collision", "right_crate_1", "middle_crate_1")],
        ),
        (
            "Four carts wait in a queue. A horse hits the one at the back, which is pushed into "
            "the one in front of it.",
            [("Collision", "horse_1", "rear_cart_1"), ("Collision", "rear_cart_1", "cart_3")],
        ),
        (
            "Of three trucks, the rear-most hits the middle one.",
            [("Collision", "rear_truck_1", "middle_truck_1")],
        ),
        (
            "Two cans stand on a wall. A stone hits the left one. A second stone hits the other.",
            [
                ("Collision", "stone_1", "left_can_1"),
                ("Collision", "second_stone_1", "can_2"),
            ],
        ),
        (
            "Five dominoes stand in a row. The one at the end is pushed and falls.",
            [("Topple", "last_domino_1")],
        ),
        (
            "A red car drives behind a blue car. The red car hits the one in front.",
            [("Collision", "red_car_1", "blue_car_1")],
        ),
        (
            "The box in the middle of the table is hit by a ball.",
            [("Collision", "ball_1", "box_1")],
        ),
    ],
)
def test_members_by_position(prompt: str, told: list[tuple[Any, ...]]) -> None:
    """Find the member that is in front, behind, in the middle, at an end or on a side."""
    assert events(prompt) == told


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        (
            "A girl runs out from behind a van and is hit by a scooter.",
            [("Collision", "scooter_1", "girl_1")],
        ),
        ("A van is hit from behind by a truck.", [("Collision", "truck_1", "van_1")]),
        (
            "A forklift rams a column of stacked barrels.",
            [("Collision", "forklift_1", "barrel_1")],
        ),
        (
            "A golf ball rolls past the hole and hits the flag lying on the green.",
            [("Miss", "golf_ball_1", "hole_1"), ("Collision", "golf_ball_1", "flag_1")],
        ),
    ],
)
def test_phrases_that_were_subjects_and_verbs(prompt: str, told: list[tuple[Any, ...]]) -> None:
    """Read "from behind a van", "stacked barrels" and "the green" as what they are."""
    assert events(prompt) == told


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        (
            "A car and a truck drive along a road, the truck in front. The truck brakes and the "
            "car hits it.",
            [("Collision", "car_1", "truck_1")],
        ),
        (
            "A delivery van and a cyclist move along a street, the van in front. The van stops and "
            "the cyclist runs into the back of the van.",
            [("Stop", "delivery_van_1"), ("Collision", "cyclist_1", "delivery_van_1")],
        ),
        (
            "A red ball and a blue ball roll along a lane, the red ball behind. The blue ball stops "
            "and the red ball hits it.",
            [("Stop", "blue_ball_1"), ("Collision", "red_ball_1", "blue_ball_1")],
        ),
    ],
)
def test_a_place_after_a_comma_is_of_one_of_those_just_told_of(
    prompt: str, told: list[tuple[str, ...]]
) -> None:
    assert events(prompt) == told
    assert "front" not in " ".join(draft(prompt).spatial_relation_graph.nodes)


def test_a_place_that_nothing_shows_is_owned_up_to() -> None:
    doc = draft("A car and a truck drive along a road, the truck in front.")
    lost = [s.text for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    assert lost == ["the truck in front"]


@pytest.mark.parametrize(
    ("prompt", "behind", "ahead"),
    [
        (
            "Two buses drive one behind the other. The front bus brakes and the rear bus hits it.",
            "rear_bus_1",
            "front_bus_1",
        ),
        (
            "Two boys walk one behind the other. The leading boy stops and the second bumps into"
            " him.",
            "rear_boy_1",
            "front_boy_1",
        ),
        ("Two cars stand one behind the other. The rear car rolls away.", "rear_car_1",
         "front_car_1"),
    ],
)  # fmt: skip
def test_one_behind_the_other_agrees_with_front_and_rear(prompt: str, behind: str, ahead: str):
    edges = draft(prompt).spatial_relation_graph.edges.binary_relations
    rows = [(e.from_, e.relation_type.value, e.to) for e in edges]
    assert (behind, "behind", ahead) in rows
    assert (ahead, "behind", behind) not in rows
