"""Readings that plain chains and phases needed: who goes on, who is pushed, told once."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from esg.graph import verify

POINTS = {"Collision", "EnterRegion", "Fall", "Topple", "Stop", "HeadingReached", "Reach", "Miss"}


def read(prompt: str) -> list[tuple[Any, ...]]:
    """The point events of the verified draft."""
    doc = draft(prompt)
    assert verify(doc) == ()
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    return [(n.event.value, *n.participants) for n in nodes if n.event.value in POINTS]


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        # "it" after the same subject has acted on something that can move
        (
            "A pram waits. A jeep hits a cart and pushes it into the pram.",
            [("Collision", "jeep_1", "cart_1"), ("Collision", "cart_1", "pram_1")],
        ),
        (
            "A jug stands on a table. A dog jumps on the table and knocks it over.",
            [
                ("Collision", "dog_1", "table_1"),
                ("Collision", "dog_1", "jug_1"),
                ("Topple", "jug_1"),
            ],
        ),
        # "before it": what hits goes on
        (
            "A snooker ball hits a red ball before it drops into a pocket.",
            [("Collision", "snooker_ball_1", "red_ball_1"), ("EnterRegion", "snooker_ball_1")],
        ),
        # who "they" are that meet
        (
            "A jeep speeds up to overtake a tractor, but a taxi comes and they collide.",
            [("Collision", "jeep_1", "taxi_1")],
        ),
        # told once
        (
            "A scooter falls against a row of scooters, and all the scooters fall over.",
            [
                ("Topple", "scooter_1"),
                ("Collision", "scooter_1", "scooter_2"),
                ("Topple", "scooter_2"),
            ],
        ),
        # what only vehicles suffer is not said of an animal
        (
            "A tram brakes for a hen that is crossing the road and is rear-ended by a van.",
            [("Collision", "van_1", "tram_1")],
        ),
        # a landing after a jump is no fall
        ("A goat jumps over a fence and lands on the grass.", []),
        ("A cat jumps off a shelf and lands on the floor.", [("Fall", "cat_1")]),
        # thrown, picked up, sent to somebody
        (
            "A basketball rolls off a bench and a player picks it up and throws it through a hoop.",
            [("Fall", "basketball_1"), ("EnterRegion", "basketball_1")],
        ),
        ("A girl throws a ball to a dog, which catches it.", [("Collision", "dog_1", "ball_1")]),
        (
            "A ball rolls down the left ramp and a cube slides down the right ramp, and they collide.",
            [("Collision", "ball_1", "cube_1")],
        ),
        (
            "A pair of scissors falls from a table and misses a cat.",
            [("Fall", "scissors_1"), ("Miss", "scissors_1", "cat_1")],
        ),
        (
            "A jeep tows a trailer. The trailer comes off and rolls into a fence.",
            [("Collision", "trailer_1", "fence_1")],
        ),
        (
            "The ball is passed from one player to another.",
            [("Reach", "ball_1", "second_player_1")],
        ),
        # what stopped, who is forced
        (
            "A van stops in front of a school, and a car that follows it hits it from behind.",
            [("Stop", "van_1"), ("Collision", "car_1", "van_1")],
        ),
        # bends, lids, roofs, chimneys
        (
            "A hammer falls off a bench and lands in a toolbox.",
            [("Fall", "hammer_1"), ("EnterRegion", "hammer_1")],
        ),
        ("A stone lands on the roof of a shed.", [("Collision", "stone_1", "shed_1")]),
        (
            "A chimney falls onto a car.",
            [("Topple", "chimney_1"), ("Collision", "chimney_1", "car_1")],
        ),
    ],
)
def test_plain_sentences(prompt: str, expected: list[tuple[Any, ...]]) -> None:
    """Draft what is told, between the right two things, and nothing else."""
    assert read(prompt) == expected


def test_who_waits_until_something_has_happened_goes_on() -> None:
    """Give what follows "until ... has passed" to the subject of the main clause."""
    doc = draft("A red cart waits until a green cart has passed and then follows it at 1 m/s.")
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    assert [e.params.speed for e in edges if e.actor == "red_cart_1"] == [0.0, 100.0]


@pytest.mark.parametrize(
    ("prompt", "who", "event"),
    [
        ("A car hits a cone and then a dog runs across a road.", "dog_1", "Collision"),
        ("When a ball hits a box, a dog runs away.", "dog_1", "Collision"),
        ("A man runs off once a crate hits a wall.", "man_1", "Collision"),
        ("A car hits a cone before a dog runs off.", "dog_1", "Collision"),
        ("A woman places a bowl on a table and walks away.", "woman_1", "Placed"),
        ("A dog waits until a car passes, then crosses the road.", "dog_1", "Miss"),
    ],
)
def test_who_comes_after_somebody_elses_event_stands_until_then(
    prompt: str, who: str, event: str
) -> None:
    """Let an actor whose motion is told after what others do set off after it."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    graph = doc.timeline_system.sequence_graph
    first, second = [e for e in graph.edges if e.actor == who]
    at = {n.id: n for n in graph.nodes}
    seen = next(n for n in graph.nodes if n.event.value == event)
    assert (first.params.speed, second.from_) == (0.0, first.to)
    assert at[first.to].window is not None and seen.window is not None
    assert at[first.to].window[0] > seen.window[1]


@pytest.mark.parametrize(
    "prompt",
    ["A ball rolls by and a dog runs away.", "A dog runs away while a ball hits a box."],
)
def test_who_is_not_said_to_come_after_sets_off_at_once(prompt: str) -> None:
    """Leave open what comes first where nothing says it."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    assert len([e for e in edges if e.actor == "dog_1"]) == 1


def test_running_into_the_street_is_a_motion() -> None:
    """Let a child run into the street, which nothing hits."""
    doc = draft("A child runs into the street.")
    assert doc.timeline_system is not None
    assert any(e.actor == "child_1" for e in doc.timeline_system.sequence_graph.edges)
    assert read("A child runs into the street.") == []
