"""On which side something is hit is stated of the hit, and what has no such side is owned up to."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.draft.statements.struck import examples
from esg.graph import verify
from esg.graph.models import Predicate, Statement


def stated(prompt: str) -> list[Statement]:
    """All statements of a draft that the verifier has nothing against."""
    doc = draft(prompt)
    assert verify(doc) == ()
    return list(doc.statements or ())


def sides(prompt: str) -> list[tuple[str, str, str]]:
    """What is struck by what, and where."""
    told = [s for s in stated(prompt) if s.predicate is Predicate.STRUCK_ON]
    return [(s.object[0], s.target[0], str(s.side)) for s in told]


@pytest.mark.parametrize(("example", "side"), examples(), ids=[e for e, _ in examples()])
def test_a_row_states_the_side_of_its_example(example: str, side: str) -> None:
    assert side in [found for *_, found in sides(example)]
    assert not [s for s in stated(example) if s.predicate is Predicate.NOT_REPRESENTED]


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("The rear of a van is struck by a motorcycle.", [("van_1", "motorcycle_1", "rear")]),
        ("A car waits. A van hits its rear bumper.", [("car_1", "van_1", "rear")]),
        ("A van skids and its rear hits a wall.", [("van_1", "wall_1", "rear")]),
        ("A man is hit in the back by a ball.", [("man_1", "ball_1", "rear")]),
        ("A ball hits a man in the back.", [("man_1", "ball_1", "rear")]),
        ("A car hits a tree with its rear.", [("car_1", "tree_1", "rear")]),
        ("Two cars collide head-on.", [("car_1", "car_2", "front"), ("car_2", "car_1", "front")]),
        ("A car crashes head-on into a wall.", [("car_1", "wall_1", "front")]),
        ("A cow is hit from behind by a cart.", [("cow_1", "cart_1", "rear")]),
        ("A crate slides into the side of a box.", [("box_1", "crate_1", "any_side")]),
        ("A truck rams a bus broadside.", [("bus_1", "truck_1", "side")]),
        ("A truck does not hit the side of a car. It hits a wall.", []),
        ("A car parks at the side of a road.", []),
        ("A car hits a wall.", []),
    ],
)
def test_who_is_struck_where(prompt: str, told: list[tuple[str, str, str]]) -> None:
    assert sides(prompt) == told


@pytest.mark.parametrize(
    ("prompt", "note"),
    [
        ("A ball hits the front of a barrel.", "barrel has no front of its own"),
        ("A ball strikes the left side of a box.", "box has no left of its own"),
    ],
)
def test_a_side_that_a_thing_does_not_have_is_owned_up_to(prompt: str, note: str) -> None:
    assert sides(prompt) == []
    assert note in [s.note for s in stated(prompt)]


def test_what_is_hit_from_the_left_is_hit_by_what_goes_to_the_right() -> None:
    """The words of the viewer and those of the thing are both kept."""
    told = stated("A car hits a van from the left.")
    assert [(s.object, s.direction) for s in told if s.direction] == [(("car_1",), "right")]
    assert sides("A car hits a van from the left.") == [("van_1", "car_1", "left")]
    doc = draft("A car hits a van from the left.")
    assert doc.timeline_system is not None
    assert doc.timeline_system.sequence_graph.edges[0].params.heading_deg == 180.0


def test_what_is_backed_into_does_not_back() -> None:
    told = stated("A car reverses into the front of a van.")
    assert [s.object for s in told if s.direction == "backward"] == [("car_1",)]
    assert sides("A car reverses into the front of a van.") == [("van_1", "car_1", "front")]
