"""What nothing in a draft stands for is owned up to, whatever its words are."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.draft.statements.phrases import carriers
from esg.graph.models import Predicate, Statement


def missing(prompt: str) -> list[Statement]:
    said = draft(prompt).statements or ()
    return [s for s in said if s.predicate is Predicate.NOT_REPRESENTED]


def words(prompt: str) -> list[str]:
    return [s.text for s in missing(prompt)]


ROWS = sorted({(row.example, tuple(p for p, r in carriers().items() if r is row))
               for row in carriers().values()})  # fmt: skip


@pytest.mark.parametrize(("example", "preps"), ROWS, ids=[example for example, _ in ROWS])
def test_a_preposition_is_carried_as_its_row_says(
    example: str, preps: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert words(example) == []
    nothing = {p: carriers()[p] for p in carriers() if p not in preps}
    none = frozenset({"none"})
    row = next(r for r in carriers().values() if r.example == example)
    empty = type(row)(none, none, none, holds=False, aims="")
    table = nothing | dict.fromkeys(preps, empty)
    monkeypatch.setattr("esg.draft.statements.phrases.carriers", lambda: table)
    assert len(words(example)) == 1


@pytest.mark.parametrize(
    ("prompt", "lost"),
    [
        ("A train passes under a bridge.", "under a bridge"),
        ("A dog runs behind a bench and stops next to it.", "behind a bench"),
        ("A horse gallops in the distance.", "in the distance"),
        ("A car drives around a corner.", "around a corner"),
        ("A drummer hits a cymbal with a stick.", "with a stick"),
        ("A squirrel walks to the top of a rock.", "to the top of a rock"),
        ("A dog walks around the yard.", "around the yard"),
    ],
)
def test_a_phrase_that_nothing_carries_is_owned_up_to(prompt: str, lost: str) -> None:
    assert lost in words(prompt)


@pytest.mark.parametrize(
    "prompt",
    [
        "A drone is floating in the air.",
        "A robot turns to the left.",
        "A ball lies in the front of an apple.",
        "A boy with a dog walks to a gate.",
        "The eight ball rolls into the side pocket.",
        "A ball rolls along a table and falls off the edge.",
        "A ball rolls across a table and hits a cup.",
        "A ball rolls past a cone and enters a tent.",
    ],
)
def test_what_something_carries_is_not(prompt: str) -> None:
    assert words(prompt) == []


def test_members_of_a_plural_that_stay_behind_are_named() -> None:
    (said,) = missing("Two sumo wrestlers push a crate.")
    assert said.object == ("sumo_wrestler_2",)
    assert words("Two dogs run.") == []
    assert words("A row of dominoes topples.") == []


def test_what_a_clause_is_about_has_a_part_in_the_scene() -> None:
    (said,) = missing("A person walks a dog in a park.")
    assert (said.text, said.object) == ("walks", ("person_1",))
    assert words("A man drives a car.") == []
    assert words("A dog chases its tail.") == ["its tail"]


@pytest.mark.parametrize(
    ("prompt", "lost"),
    [
        ("A curious sloth hangs from a branch.", ["curious"]),
        ("A ball lies beside a moving vehicle.", ["moving"]),
        ("A moving vehicle hits a wall.", []),
        ("A woman in a blue sari hits a post.", ["blue", "sari"]),
        ("A bag swings back and forth.", ["swings", "back and forth"]),
    ],
)
def test_qualities_and_words_taken_off_are_missed(prompt: str, lost: list[str]) -> None:
    assert words(prompt) == lost


@pytest.mark.parametrize(
    ("prompt", "lost"),
    [
        ("A boy dribbles a ball.", "dribbles"),
        ("A dog catches a ball.", "catches"),
        ("A car drifts along a road.", "drifts"),
        ("A girl tiptoes to a door.", "tiptoes"),
        ("A bell breaks on the floor.", "breaks"),
    ],
)
def test_a_verb_of_more_than_its_sense_shows_is_owned_up_to(prompt: str, lost: str) -> None:
    assert lost in words(prompt)


def test_each_of_several_like_words_is_missed() -> None:
    assert words("A ball lies on a table, oddly and quaintly.") == ["oddly", "quaintly"]


@pytest.mark.parametrize(
    ("shown", "not_shown", "lost"),
    [
        ("Two dogs sit in a row.", "Three balls roll in a line.", "in a line"),
        (
            "Two trucks drive in a column. The leading truck brakes and the following truck "
            "crashes into it.",
            "Two dogs run in a column.",
            "in a column",
        ),
        ("Two cars hit each other.", "Two dogs run straight at each other.", "each other"),
        (
            "A taxi follows a van at 10 m/s and hits it from behind.",
            "A ball rolls to a box from behind.",
            "from behind",
        ),
        ("A car makes a U-turn and drives back.", "A car stops and drives back.", "back"),
        ("A car brakes too late and hits a wall.", "A car brakes too late.", "late"),
        (
            "A ball rolls down a ramp and hits a cup at the bottom.",
            "A ball rolls along a floor and hits a cup at the bottom.",
            "at the bottom",
        ),
        ("A car hits a table by the street side.", "A car hits a bin beside the rink.",
         "beside the rink"),
        ("A bicycle stands in the middle of the road.", "A crate stands in the middle of the room.",
         "in the middle of the room"),
        ("A skater slides into the wall of the rink.", "A car hits a patch of ice.", "of ice"),
        ("A drone hovers above the ground.", "A lamp stands above the ground.", "above the ground"),
    ],
)  # fmt: skip
def test_it_is_owned_up_to_only_where_the_scene_lacks_it(
    shown: str, not_shown: str, lost: str
) -> None:
    assert words(shown) == []
    assert lost in words(not_shown)


@pytest.mark.parametrize(
    ("prompt", "lost"),
    [
        ("A rotating platform carries a rubber duck.", "rotating"),
        ("A hanging coat hits a box.", "hanging"),
        ("A swaying lamp hits a box.", "swaying"),
        ("A bin is rammed by a reversing van.", "reversing"),
        ("A ball hits a tilted table.", "tilted"),
    ],
)
def test_a_participle_that_nothing_shows_is_owned_up_to(prompt: str, lost: str) -> None:
    """Own up to what a participle before a noun tells, though the thing moves or stands."""
    assert lost in words(prompt)


@pytest.mark.parametrize(
    "prompt",
    [
        "A racing car hits a wall.",
        "A measuring tape hits a walking stick.",
        "A ball rolls into a swinging gate and knocks it open.",
        "A reversing van hits a bin.",
        "A ball rolls down an inclined plank.",
    ],
)
def test_a_participle_that_is_shown_or_only_names_is_not(prompt: str) -> None:
    """Leave alone what the scene shows, and what tells nothing of a motion."""
    assert words(prompt) == []


@pytest.mark.parametrize(
    "prompt",
    [
        "It takes the tram 6 seconds to stop after it brakes.",
        "The bus takes four seconds to stop.",
        "A crate twice as heavy as a 5 kg barrel hits the barrel.",
        "A car is parked near a tree.",
        "A cart stops right in front of a gate.",
    ],
)
def test_words_of_time_amount_and_rest_are_no_acts(prompt: str) -> None:
    assert words(prompt) == []
