"""Events that a prompt does not tell: words read wrongly, parts, passing by, what falls into what."""

from __future__ import annotations

from functools import partial
from typing import Any

import pytest

from esg.draft import draft
from esg.graph import verify
from tests.draft import told

events = partial(told.events, regions=True)


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        (
            "A robot picks up speed, skrimps a shelf, and runs into a cart.",
            [("Collision", "robot_1", "cart_1")],
        ),
        (
            "The paper bag rips, and two oranges roll down a ramp. The first one hits a chair.",
            [("Collision", "first_orange_1", "chair_1")],
        ),
        ("A drone flies toward the space station and stops.", [("Stop", "drone_1")]),
        (
            "A boat drifts past two oarsmen and hits a rock.",
            [("Miss", "boat_1", "oarsman_1"), ("Collision", "boat_1", "rock_1")],
        ),
    ],
)
def test_unknown_words_take_no_part(prompt: str, expected: list[tuple[Any, ...]]) -> None:
    """An unknown verb is no object, and what qualifies a noun is no noun of its own."""
    assert events(prompt) == expected


def test_a_part_hits_as_its_whole() -> None:
    """ "Its wheel hits": the whole does; a part that comes off acts on its own."""
    told = events("A tractor drives across the field, its front wheel hits a stone, and it stops.")
    assert told[0] == ("Collision", "tractor_1", "stone_1")
    alone = events("A wheel comes off a tractor and hits a stone.")
    assert ("Collision", "wheel_1", "stone_1") in alone


def test_passing_and_touching_is_no_miss() -> None:
    assert events("A jogger runs past a scooter and brushes it.") == [
        ("Collision", "jogger_1", "scooter_1")
    ]
    assert ("Miss", "jogger_1", "scooter_1") in events(
        "A jogger runs past a scooter and bumps into a bin."
    )


def test_what_is_sent_to_somebody_and_hits_something_else_does_not_arrive() -> None:
    told = events("A boy rolls a melon to a girl. The melon hits a stone and stops.")
    assert told == [("Collision", "melon_1", "stone_1"), ("Stop", "melon_1")]
    assert events("A boy walks to a girl and trips over a stone.")[0][0] == "Reach"


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("A wrench falls into a wheelbarrow.", "EnterRegion"),
        ("A bolt drops into a tray.", "EnterRegion"),
        ("A crate falls off the belt into a container.", "EnterRegion"),
        ("A barrel rolls into a wheelbarrow.", "Collision"),
        ("A bolt drops onto a tray.", "Collision"),
        ("A ball runs into the gutter.", "EnterRegion"),
    ],
)
def test_open_things_take_up_what_falls_into_them(prompt: str, kind: str) -> None:
    assert events(prompt)[-1][0] == kind


def test_who_falls_onto_a_thing_hits_it_and_no_more() -> None:
    assert events("A clown slips on a unicycle and falls onto a drum.")[-1][0] == "Collision"
    assert "Topple" not in [e[0] for e in events("A clown walks away and falls onto a drum.")]


def test_the_next_one_is_of_the_kind_of_the_one_before() -> None:
    told = events("One ball runs into the gutter, the next one knocks down a pin.")
    assert ("Collision", "ball_2", "pin_1") in told


def test_back_in_is_where_it_came_from() -> None:
    told = events("A dolphin leaps out of the water, flies through a hoop and dives back in.")
    assert [e[-1] for e in told] == ["hoop_1/inside", "water_1/inside"]


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        (
            "A glass that was on a tray hit a guest.",
            [("Collision", "glass_1", "guest_1")],
        ),
        (
            "A stool that was bumped by a toddler fell against a lamp.",
            [
                ("Collision", "toddler_1", "stool_1"),
                ("Topple", "stool_1"),
                ("Collision", "stool_1", "lamp_1"),
            ],
        ),
        (
            "A stone struck the windscreen of a car parked outside.",
            [("Collision", "stone_1", "car_1")],
        ),
        (
            "Three balls rolled at a can: the first missed, the second hit it.",
            [("Miss", "first_ball_1", "can_1"), ("Collision", "second_ball_1", "can_1")],
        ),
    ],
)
def test_past_tense_main_verbs(prompt: str, expected: list[tuple[Any, ...]]) -> None:
    """A past form after a relative clause, an ordinal or with an object is what happens."""
    assert events(prompt) == expected


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A boat turns around before it reaches the pier.", ["HeadingReached"]),
        ("A police boat follows a boat and blocks its way.", []),
        ("A taxi pulls up at a hotel and stops.", ["Stop"]),
        ("A hedgehog rolls itself into a ball.", []),
        ("A stone pushes another stone out of the house.", ["Collision"]),
        ("The cup slips out of his hand and hits a stool.", ["Fall", "Collision"]),
        ("A pendulum swings to the right and strikes a ball.", ["Collision"]),
        ("A log gets past the first bridge and hits the second bridge.", ["Miss", "Collision"]),
    ],
)
def test_what_does_not_happen_is_not_drafted(prompt: str, expected: list[str]) -> None:
    assert [e[0] for e in events(prompt)] == expected


def test_who_is_hit() -> None:
    """Gear is its wearer, and a possessed thing is not the subject."""
    assert events("A puck hits the goalkeeper's pad.") == [("Collision", "puck_1", "goalkeeper_1")]
    assert events("A police boat overtakes the smuggler's boat.")[0][0] == "Miss"


def test_a_start_above_what_scenes_hold_is_a_warning() -> None:
    doc = draft("A stone is dropped from 300 m onto a car.")
    assert verify(doc) == ()
    assert any("300 m" in w for w in doc.coverage.warnings)


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A car brakes, releases the brakes and turns right.", [("HeadingReached", "car_1")]),
        (
            "A horse pulls a cart. A wheel of the cart hits a rock.",
            [("Collision", "cart_1", "rock_1")],
        ),
        (
            "A plane lands on the runway, overshoots it and hits a fence.",
            [("Collision", "plane_1", "fence_1")],
        ),
        ("A boy is nearly hit by a motorbike.", [("Miss", "motorbike_1", "boy_1")]),
        (
            "A van cuts in front of a car. The car brakes and avoids a collision.",
            [("Miss", "car_1", "van_1")],
        ),
        (
            "Three cars drive in a row. The second hits the first, and the third swerves right.",
            [("Collision", "second_car_1", "first_car_1"), ("HeadingReached", "third_car_1")],
        ),
    ],
)
def test_the_right_things_take_part(prompt: str, expected: list[tuple[Any, ...]]) -> None:
    assert events(prompt) == expected


def test_both_are_the_two_that_act_alike() -> None:
    doc = draft("A red car overtakes a truck, a blue car overtakes it, and both brake.")
    assert doc.timeline_system is not None
    braking = [e for e in doc.timeline_system.sequence_graph.edges if e.event.value == "Brake"]
    assert {e.actor for e in braking} == {"red_car_1", "blue_car_1"}


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A car hits a traffic barrel after 2 seconds.", ("Collision", "traffic_barrel_1")),
        ("A chocolate bar falls off the shelf.", ("Fall", "chocolate_bar_1")),
    ],
)
def test_a_noun_that_is_also_a_verb_or_a_place_is_the_thing(
    prompt: str, expected: tuple[str, str]
) -> None:
    """After "a traffic" a bare verb cannot follow; a bar that falls is no room."""
    system = draft(prompt).timeline_system
    assert system is not None
    events = [(n.event.value, p) for n in system.sequence_graph.nodes for p in n.participants]
    assert expected in events, events


def test_what_lies_on_its_side_has_not_been_knocked_over() -> None:
    assert events("A ball hits a bottle lying on its side.") == [
        ("Collision", "ball_1", "bottle_1"),
    ]
    assert ("Topple", "car_1") in events("The car ends up lying on its side.")
