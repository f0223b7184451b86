"""Modifiers, occasions and places around what a prompt tells take no part in it."""

from __future__ import annotations

import re
from typing import Any

import pytest

from benchmarks.drafting import load
from esg.draft import draft
from esg.outcomes import UserError
from tests.draft.told import events


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


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        (
            "A boy throws a snowball at a girl. She ducks, and it hits a wall.",
            [("Miss", "snowball_1", "girl_1"), ("Collision", "snowball_1", "wall_1")],
        ),
        (
            "A bull charges at a matador, who jumps out of the way.",
            [("Miss", "bull_1", "matador_1")],
        ),
        (
            "A boy throws a snowball at a girl, who tries to dodge.",
            [("Collision", "snowball_1", "girl_1")],
        ),
        (
            "A forklift should have turned left. It drives on and hits a shelf.",
            [("Collision", "forklift_1", "shelf_1")],
        ),
        (
            "If he had looked up, the waiter would have avoided the chair. Instead he hits it.",
            [("Collision", "waiter_1", "chair_1")],
        ),
        (
            "A boat hits a dinghy and sinks it.",
            [("Collision", "boat_1", "dinghy_1")],
        ),
        (
            "A snail overtakes a tortoise that has fallen asleep.",
            [("Miss", "snail_1", "tortoise_1")],
        ),
        (
            "A trailer comes loose from a pickup. It hits a hedge.",
            [("Collision", "trailer_1", "hedge_1")],
        ),
        (
            "Two sledges glide down a hill and both slide into a hay bale.",
            [("Collision", "sledge_1", "hay_bale_1"), ("Collision", "sledge_2", "hay_bale_1")],
        ),
        (
            "Unlike the red balloon, the blue one hits a fan.",
            [("Collision", "blue_balloon_1", "fan_1")],
        ),
    ],
)
def test_what_is_dodged_or_did_not_happen_is_no_hit(
    prompt: str, expected: list[tuple[Any, ...]]
) -> None:
    assert events(prompt) == expected


_PLAIN = [r for r in load("dev", ("single", "chain", "multi_phase")) if len(r["events"]) > 1][::5]


@pytest.mark.parametrize("row", _PLAIN, ids=lambda row: row["id"])
def test_what_a_thing_looks_like_and_where_it_is_change_no_event(row: dict[str, Any]) -> None:
    """The events of a story are the same with modifiers before its nouns and a setting."""
    plain = events(row["prompt"])
    nouns = "|".join(re.escape(o["phrase"].split()[-1]) for o in row["objects"])
    dressed = re.sub(rf"\b([Aa]n?|[Tt]he) ({nouns})\b", r"\1 badly dented \2", row["prompt"])
    dressed = re.sub(r"\b([Aa])n badly", r"\1 badly", dressed)
    assert events(dressed) == plain
    assert events(f"The sun is setting. {row['prompt']} The spectators cheer.") == plain


def test_a_scene_of_hours_is_still_refused() -> None:
    """Only what lies before the scene may be longer than a scene."""
    with pytest.raises(UserError, match="longest scene"):
        draft("A car drives for 2 hours and hits a wall.")
    with pytest.raises(UserError, match="longest scene"):
        draft("A car starts. Two hours later it hits a wall.")


@pytest.mark.parametrize(
    "prompt", ["A ball rolls 1e400 m and stops.", "A ball moves at 1e308 m 18 km/h and slows down."]
)
def test_a_length_that_no_number_holds_is_refused(prompt: str) -> None:
    """Refuse it in words: it is infinite in centimetres, and no constraint takes that."""
    with pytest.raises(UserError, match="number can hold"):
        draft(prompt)


def test_a_turn_that_takes_no_time_has_usual_rates() -> None:
    """Draft it: an angle over next to nothing is infinite."""
    doc = draft("A car turns right by 90 degrees in 1e-320 s.")
    assert doc.timeline_system is not None
    rates = [e.params.turn_rate_deg_s for e in doc.timeline_system.sequence_graph.edges]
    assert (20.0, 120.0) in rates
