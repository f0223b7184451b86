"""What throwers hit, whom "she" and what "it" mean."""

from __future__ import annotations

from typing import Any

import pytest

from tests.draft.told import events


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        (
            "A girl throws a dart at a balloon. She misses.",
            [("Miss", "dart_1", "balloon_1")],
        ),
        (
            "A man throws a ball at a lamp on a cupboard. He hits it and it falls off.",
            [("Collision", "ball_1", "lamp_1"), ("Fall", "lamp_1")],
        ),
        (
            "A girl throws a snowball at a postbox. She misses it and hits a taxi.",
            [("Miss", "snowball_1", "postbox_1"), ("Collision", "snowball_1", "taxi_1")],
        ),
        (
            "A boy throws a ball at a can but misses. He throws a second ball and hits it.",
            [("Miss", "ball_1", "can_1"), ("Collision", "second_ball_1", "can_1")],
        ),
        (
            "A catapult hurls a stone at a box and hits it.",
            [("Collision", "stone_1", "box_1")],
        ),
        (
            "A cannon fires a ball at a wall and hits it.",
            [("Collision", "ball_1", "wall_1")],
        ),
        (
            "A robot arm throws a can at a bin. It misses it.",
            [("Miss", "can_1", "bin_1")],
        ),
    ],
)
def test_what_the_thrower_misses_or_hits(prompt: str, told: list[tuple[Any, ...]]) -> None:
    """Let the thing thrown hit or miss, and the thrower what he does himself."""
    assert events(prompt) == told


@pytest.mark.parametrize(
    ("prompt", "who"),
    [
        ("A man passes a woman. She falls over.", "woman_1"),
        ("A man passes a woman. He falls over.", "man_1"),
        ("A waitress walks past a boy. He falls over.", "boy_1"),
        ("A fireman walks past a girl. He falls over.", "fireman_1"),
    ],
)
def test_he_and_she(prompt: str, who: str) -> None:
    """Take the last person of the pronoun's gender."""
    assert ("Topple", who) in events(prompt)


@pytest.mark.parametrize("verb", ["hits", "strikes", "bumps"])
def test_it_is_not_the_place(verb: str) -> None:
    """Hit the bottle that stands on the wall, not the wall, when "it" is told."""
    told = events(f"A boy throws a stone at a bottle on a wall. The stone {verb} it.")
    assert told == [("Collision", "stone_1", "bottle_1")]


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        (
            "A waiter slides a glass across the bar; it hits a bottle.",
            [("Collision", "glass_1", "bottle_1")],
        ),
        (
            "A tower of cups stands on a table. A toy train turns left and knocks it down.",
            [
                ("HeadingReached", "toy_train_1"),
                ("Collision", "toy_train_1", "cup_1"),
                ("Topple", "cup_1"),
            ],
        ),
        (
            "The bear rolls a barrel into the lake, and the barrel bumps a canoe.",
            [("EnterRegion", "barrel_1"), ("Collision", "barrel_1", "canoe_1")],
        ),
        (
            "A vase stands on a shelf. A ball rolls over and knocks it down.",
            [("Collision", "ball_1", "vase_1"), ("Topple", "vase_1")],
        ),
    ],
)
def test_it_after_what_is_set_going(prompt: str, told: list[tuple[Any, ...]]) -> None:
    """Mean what was set going, or what stands there, not what carries it."""
    assert events(prompt) == told


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("A cart reaches the exit after 5 s.", [("Reach", "cart_1", "exit_1")]),
        ("A runner reaches the finish line.", [("Reach", "runner_1", "finish_line_1")]),
        ("A robot spins around by 180 degrees.", [("HeadingReached", "robot_1")]),
        ("A man carries a ladder at 1 m/s into a lamp.", [("Collision", "man_1", "lamp_1")]),
    ],
)
def test_small_words_that_were_lost(prompt: str, told: list[tuple[Any, ...]]) -> None:
    """Draw exits, finish lines, pirouettes and who carries something at a speed."""
    assert events(prompt) == told
