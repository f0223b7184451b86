"""Modifiers, occasions and places around what a prompt tells take no part in it."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.outcomes import UserError

_TOLD = {"Collision", "EnterRegion", "Fall", "Topple", "Stop", "HeadingReached", "Reach", "Miss"}


def events(prompt: str) -> list[tuple[Any, ...]]:
    """Point events of a verifier-clean draft: type and participants."""
    doc = draft(prompt)
    assert verify(doc) == ()
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    return [(n.event.value, *n.participants) for n in nodes if n.event.value in _TOLD]


@pytest.mark.parametrize(
    ("ball", "cone"),
    [
        ("brand new", "slightly damaged"),
        ("beautifully carved", "freshly painted"),
        ("wet and heavy", "badly parked"),
        ("very old, slightly dented", "once proud"),
        ("old and very dusty", "half eaten"),
    ],
)
def test_modifiers_of_several_words_are_no_verbs_and_no_things(ball: str, cone: str) -> None:
    """What a thing looks like does not change what it does."""
    told = events(f"A {ball} ball rolls down a hill and hits the {cone} cone.")
    assert told == [("Collision", "ball_1", "cone_1")]


@pytest.mark.parametrize(
    "prefix",
    [
        "At the farm, ",
        "Somewhere in a quiet town, ",
        "In an empty car park, ",
        "To everyone's surprise, ",
        "Despite the fog, ",
        "Night has fallen. ",
        "Half an hour later, ",
        "Two hours before closing time, ",
    ],
)
@pytest.mark.parametrize(
    ("story", "expected"),
    [
        ("a cat pounces on a ball of wool.", [("Collision", "cat_1", "ball_1")]),
        ("a car hits a wall.", [("Collision", "car_1", "wall_1")]),
        (
            "the first runner falls, and the second crashes into the hurdle.",
            [("Topple", "first_runner_1"), ("Collision", "second_runner_1", "hurdle_1")],
        ),
    ],
)
def test_where_and_when_is_nothing_that_anything_hits(
    prefix: str, story: str, expected: list[tuple[Any, ...]]
) -> None:
    text = story[0].upper() + story[1:] if prefix.endswith(". ") else story
    assert events(prefix + text) == expected


@pytest.mark.parametrize(
    "end", ["with a loud bang", "for fun", "by accident", "despite all efforts"]
)
def test_how_it_happens_is_no_thing(end: str) -> None:
    assert events(f"A ball rolls off a table and hits a chair {end}.") == [
        ("Fall", "ball_1"),
        ("Collision", "ball_1", "chair_1"),
    ]


def test_a_scene_of_hours_is_still_refused() -> None:
    """Only what lies before the scene may be longer than a scene."""
    with pytest.raises(UserError, match="longest scene"):
        draft("A car drives for 2 hours and hits a wall.")
    with pytest.raises(UserError, match="longest scene"):
        draft("A car starts. Two hours later it hits a wall.")
