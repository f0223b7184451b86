"""Words that were lost without a word: held now, or owned up to."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import Predicate
from tests.draft.told import drawn, owned, stated


@pytest.mark.parametrize(
    ("prompt", "who"),
    [
        ("A ball hits a bottle, which does not tip over.", ("bottle_1",)),
        ("The stroller rolls over a kerb and must not tip over.", ("stroller_1",)),
        ("A ball rolls into two cones. None of the two cones falls over.", ("cone_1", "cone_2")),
    ],
)
def test_what_does_not_tip_over_stays_upright(prompt: str, who: tuple[str, ...]) -> None:
    (said,) = stated(draft(prompt), Predicate.STAYS_UPRIGHT)
    assert said.object == who


def test_what_tips_over_later_is_not_said_to_stay_upright() -> None:
    doc = draft("A ball hits a vase, which does not tip over. Then a dog knocks over the vase.")
    assert not stated(doc, Predicate.STAYS_UPRIGHT)


@pytest.mark.parametrize(
    ("prompt", "noun"),
    [
        ("A skateboard rolls down the ramp without a rider and strikes a hydrant.", "rider"),
        ("The lorry comes down the hill without a driver.", "driver"),
        ("A table without a lamp is hit by a ball.", "lamp"),
    ],
)
def test_what_something_is_without_is_not_drawn_and_stated_absent(prompt: str, noun: str) -> None:
    doc = draft(prompt)
    (said,) = stated(doc, Predicate.ABSENT)
    assert said.noun == noun and said.text == f"without a {noun}"
    assert not any(noun in name for name in drawn(doc)) and not owned(doc)


def test_a_part_that_is_missing_is_owned_up_to() -> None:
    doc = draft("A car without wheels is hit by a ball.")
    assert owned(doc) == ["without wheels"] and not stated(doc, Predicate.ABSENT)


@pytest.mark.parametrize(
    ("prompt", "word"),
    [
        ("A block slides down a frictionless incline.", "frictionless"),
        ("A boy throws a deflated football against a door.", "deflated"),
        ("A phone falls at an angle onto a table.", "at an angle"),
    ],
)
def test_qualities_and_sides_that_nothing_shows_are_owned_up_to(prompt: str, word: str) -> None:
    assert owned(draft(prompt)) == [word]


def test_light_is_a_weight_where_it_describes_a_thing() -> None:
    assert owned(draft("A light ball hits a heavy ball.")) == []
    (rain,) = draft("A light rain falls while a car hits a wall.").statements or ()
    assert (rain.predicate.value, rain.noun) == ("weather", "light rain")


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("A ball hits the drum stand on the stage.", {"ball_1", "drum_stand_1", "stage_1"}),
        ("A ball hits a phone stand on a desk.", {"ball_1", "phone_stand_1", "desk_1"}),
        ("A ball hits a shoe rack.", {"ball_1", "shoe_rack_1"}),
        ("A drum stands on the stage.", {"drum_1", "stage_1"}),
    ],
)
def test_compounds_of_stands_and_racks_are_one_thing(prompt: str, things: set[str]) -> None:
    assert drawn(draft(prompt)) == things


def test_what_hangs_above_a_table_and_not_who_meets_it_is_above_it() -> None:
    doc = draft("A red balloon drifts into a ceiling fan above the dining table.")
    assert not stated(doc, Predicate.ABOVE)
    (over,) = stated(draft("A drone flies to a place above a chair."), Predicate.ABOVE)
    assert over.object == ("drone_1",)


def test_who_is_passed_is_somebody_else() -> None:
    doc = draft("A woman sits on a bench. A cyclist passes behind her.")
    assert owned(doc) == ["behind her"]
    thrown = draft("A man throws a ball behind him.")
    assert ("ball_1", "man_1") in {
        (r.from_, r.to) for r in thrown.spatial_relation_graph.edges.binary_relations
    }


def test_a_rope_may_be_thrown_twice_and_is_nobody() -> None:
    told = "The throws a rope to the dock. The rope lands in the water, so he pulls it back and"
    doc = draft(f"{told} throws it again.")
    assert {"person_1", "rope_1"} <= {*doc.spatial_relation_graph.nodes}
    assert "pulls" in owned(doc)
