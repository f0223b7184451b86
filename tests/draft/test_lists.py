"""Lists that end before a verb, counted members by colour, and lengths between things."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from tests.draft.told import events as read


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        (
            "A girl rides past a sandbox and a seesaw and hits the slide.",
            [("Miss", "girl_1", "sandbox_1"), ("Collision", "girl_1", "slide_1")],
        ),
        (
            "A dog runs between a table and a chair and bumps into a vase.",
            [("Collision", "dog_1", "vase_1")],
        ),
        (
            "A cat hits a vase and a lamp and then falls off the shelf.",
            [("Collision", "cat_1", "vase_1"), ("Collision", "cat_1", "lamp_1"), ("Fall", "cat_1")],
        ),
        (
            "A cart bumps a cone and a cone and a box fall over.",
            [("Collision", "cart_1", "cone_1"), ("Topple", "cone_2"), ("Topple", "box_1")],
        ),
        (
            "A ball rolls past a cup and a plate rolls off the table.",
            [("Miss", "ball_1", "cup_1"), ("Fall", "plate_1")],
        ),
    ],
)
def test_a_verb_after_a_list_goes_on_with_the_subject(
    prompt: str, expected: list[tuple[Any, ...]]
) -> None:
    """Let what passes a list of things do what follows, not the last thing of the list."""
    assert read(prompt) == expected


def test_coloured_balls_are_among_those_counted() -> None:
    """Take the white and the blue ball out of the four; keep them apart from "several"."""
    told = "balls lie on a pool table. The red ball hits the blue ball."

    def balls(prompt: str) -> int:
        return sum("ball" in n for n in draft(prompt).spatial_relation_graph.nodes)

    assert balls(f"Four billiard {told}") == 4
    assert balls(f"Several billiard {told}") == 6


@pytest.mark.parametrize(
    ("prompt", "target"),
    [
        ("A bus brakes and stops 5 m before a crosswalk.", "crosswalk_1"),
        ("A car brakes and stops 2 m short of the stop line.", "stop_line_1"),
    ],
)
def test_gaps_are_left_to_what_is_painted_on_the_road(prompt: str, target: str) -> None:
    """Measure a stop from a crosswalk or a line as from a gate."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    stop = doc.timeline_system.sequence_graph.nodes[-1]
    assert [c.to for c in stop.constraints if c.quantity == "distance"] == [target]


@pytest.mark.parametrize(
    ("prompt", "seconds"),
    [
        ("A car drives at 5 m/s into a wall 30 m ahead.", 6.0),
        ("Two cars are 20 m apart and drive toward each other at 5 m/s until they collide.", 2.0),
        ("A robot drives at 1.5 m/s and bumps into a pallet that lies 3 m in front of it.", 2.0),
    ],
)
def test_windows_follow_from_a_stated_way_and_speed(prompt: str, seconds: float) -> None:
    """Leave the time that the way takes, some of it on either side."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    hit = next(n for n in doc.timeline_system.sequence_graph.nodes if n.event.value == "Collision")
    assert hit.window is not None
    assert hit.window[0] < seconds - 0.1
    assert hit.window[1] > seconds + 0.1


def test_balls_apart_that_roll_are_apart_at_the_start() -> None:
    """Read "two balls 4 m apart roll" as a gap, not as the way of one of them."""
    doc = draft("Two balls 4 m apart roll toward each other and collide after 2 seconds.")
    edges = doc.spatial_relation_graph.edges.binary_relations
    assert [e.distance_cm for e in edges if e.distance_cm is not None] == [400.0]


@pytest.mark.parametrize(
    "prompt",
    [
        "Two karts drive toward each other at 4 m/s from a distance of 16 m and collide.",
        "A ball is thrown at a box from a distance of 16 m.",
    ],
)
def test_from_a_distance_is_a_gap_at_the_start(prompt: str) -> None:
    """Read "from a distance of 16 m" as neither a way nor a height."""
    doc = draft(prompt)
    edges = doc.spatial_relation_graph.edges.binary_relations
    assert [e.distance_cm for e in edges if e.distance_cm is not None] == [1600.0]
    assert doc.timeline_system is not None
    assert not any(n.constraints for n in doc.timeline_system.sequence_graph.nodes)


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        (
            "A bus hits a car that turns left in front of it.",
            [("HeadingReached", "car_1"), ("Collision", "bus_1", "car_1")],
        ),
        (
            "A car hits a ball that rolls into a box.",
            [("Collision", "car_1", "ball_1"), ("Collision", "ball_1", "box_1")],
        ),
    ],
)
def test_a_turn_told_behind_that_comes_before_its_hit(
    prompt: str, expected: list[tuple[Any, ...]]
) -> None:
    """Let who is hit turn first, but roll on only after the hit."""
    assert read(prompt) == expected


def test_floors_of_shops_and_halls_are_floors() -> None:
    """Stand on the shop floor, not on a shop."""
    doc = draft("A robot arm stands on the shop floor. A cart hits the robot arm.")
    assert list(doc.spatial_relation_graph.nodes) == ["ground_1", "robot_arm_1", "cart_1"]
