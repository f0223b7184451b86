"""Who throws something and then "misses" or "hits": the thing thrown does; whom "she" means."""

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
            "A boy throws a ball at a can. He runs away and hits a wall.",
            [("Collision", "ball_1", "can_1"), ("Collision", "boy_1", "wall_1")],
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
