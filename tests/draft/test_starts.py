"""Where things are at the start: on heads and horses, on roofs and ladders, one on another."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Predicate


def _under(doc: EsgDocument, node: str) -> str:
    """What a thing is on."""
    assert verify(doc) == ()
    graph = doc.spatial_relation_graph
    return graph.semantic_regions[graph.nodes[node].semantic_region or ""].parent_object


@pytest.mark.parametrize(
    ("prompt", "thing", "host"),
    [
        ("The wind blows a scarf off a girl's neck.", "scarf_1", "girl_1"),
        ("A gust blows the sombrero off a boy's head.", "sombrero_1", "boy_1"),
        ("A princess is thrown off her horse.", "princess_1", "horse_1"),
        ("A camel throws its rider over a wall.", "rider_1", "camel_1"),
        ("A helicopter takes off from the roof of a hotel.", "helicopter_1", "hotel_1"),
        ("A brush lies on the top rung of a ladder.", "brush_1", "ladder_1"),
        ("A tin stands on the third step of a ladder and falls off.", "tin_1", "ladder_1"),
    ],
)
def test_what_leaves_a_thing_was_on_it(prompt: str, thing: str, host: str) -> None:
    """Start it on the head, the horse, the roof or the rung that the words name."""
    assert _under(draft(prompt), thing) == host


def test_the_step_of_a_ladder_is_no_step_of_its_own() -> None:
    """Draw the ladder alone."""
    nodes = draft("A pot stands on the top step of a ladder.").spatial_relation_graph.nodes
    assert {n for n, x in nodes.items() if x.mentioned and n != "ground_1"} == {
        "pot_1",
        "ladder_1",
    }


@pytest.mark.parametrize(
    "prompt",
    [
        "Three tyres lie on top of each other.",
        "Two pallets stand one on top of the other beside a wall.",
        "Four trunks are on top of one another on a cart.",
    ],
)
def test_one_on_top_of_the_other_is_a_stack(prompt: str) -> None:
    """Stack the members of the plural, and own up to nothing of it."""
    doc = draft(prompt)
    patterns = {n.group_pattern for n in doc.spatial_relation_graph.nodes.values() if n.group}
    assert patterns == {"stack"}
    lost = [s.text for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    assert not [text for text in lost if "other" in text or "top" in text]


def test_those_of_a_plural_share_the_support_of_one() -> None:
    """Put all vases on the shelf where one of them is pushed."""
    doc = draft("A parrot on a shelf knocks over two of the four vases.")
    assert {_under(doc, f"vase_{k}") for k in (1, 2, 3, 4)} == {"shelf_1"}
    assert doc.timeline_system is not None
    told = doc.timeline_system.sequence_graph.nodes
    fallen = {n.participants[0] for n in told if n.event.value == "Topple"}
    assert fallen == {"vase_1", "vase_2"}


@pytest.mark.parametrize(
    ("prompt", "fallen"),
    [
        ("A cart carries five melons and two of them fall off.", {"melon_1", "melon_2"}),
        (
            "A van with six barrels brakes and three of them fall off.",
            {"barrel_1", "barrel_2", "barrel_3"},
        ),
    ],
)
def test_two_of_them_are_two(prompt: str, fallen: set[str]) -> None:
    """Tell the fall of every one that the number counts."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    told = doc.timeline_system.sequence_graph.nodes
    assert {n.participants[0] for n in told if n.event.value == "Fall"} == fallen


@pytest.mark.parametrize(
    ("prompt", "words", "stand_by"),
    [
        ("A canoe glides past the two buoys.", "past", {"buoy_2"}),
        ("A lorry ploughs into three sheds.", "into", {"shed_2", "shed_3"}),
        ("Six kegs stand in a triangle; a ball hits the front keg and three of them fall over.",
         "fall over", {"keg_2", "keg_3"}),
    ],
)  # fmt: skip
def test_members_that_stand_by_are_owned_up_to(prompt: str, words: str, stand_by: set[str]) -> None:
    """Say that only some of those that are counted take part."""
    lost = [s for s in draft(prompt).statements or () if s.note == "only some of them do"]
    assert [(s.text, {*s.object}) for s in lost] == [(words, stand_by)]


def test_a_pair_of_slippers_is_met_as_one() -> None:
    """Own up to no second slipper."""
    doc = draft("A suitcase slides off the bed onto a pair of slippers.")
    assert not [s for s in doc.statements or () if s.note == "only some of them do"]
