"""Members of rows, and what a blow on one of them does to the others."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import NodeEvent, SequenceGraph


def told(prompt: str) -> tuple[SequenceGraph, dict[str, str | None]]:
    """Timeline, and every object with the arrangement of its plural."""
    doc = draft(prompt)
    assert not verify(doc) and doc.timeline_system is not None
    things = {k: v.group_pattern for k, v in doc.spatial_relation_graph.nodes.items()}
    return doc.timeline_system.sequence_graph, things


def points(graph: SequenceGraph, kind: NodeEvent) -> list[tuple[str, ...]]:
    return [n.participants for n in graph.nodes if n.event is kind]


@pytest.mark.parametrize(
    ("prompt", "struck", "members"),
    [
        ("A toy car hits the first domino in a row of six.", "first_domino_1", 6),
        ("A marble rolls into the first book in a line of six books.", "first_book_1", 6),
        ("A stone hits the last bottle of a row of six bottles.", "last_bottle_1", 6),
        ("A ball hits the first in a row of four bottles.", "first_bottle_1", 4),
        ("The third can in a row of five is hit by a stone.", "third_can_1", 5),
    ],
)
def test_a_member_is_told_by_its_row(prompt: str, struck: str, members: int) -> None:
    graph, things = told(prompt)
    ((_, target),) = points(graph, NodeEvent.COLLISION)
    assert target == struck
    assert sum(pattern == "row" for pattern in things.values()) == members


def test_each_member_knocks_over_the_next_from_the_first_on() -> None:
    graph, _ = told(
        "A finger pushes the first of seven dominoes, and each domino knocks over the next."
    )
    assert points(graph, NodeEvent.COLLISION) == [
        ("finger_1", "first_domino_1"),
        ("first_domino_1", "domino_2"),
    ]


def test_the_rest_is_no_object() -> None:
    _, things = told("A ball knocks down two pins and misses the rest.")
    assert not any("rest" in name for name in things)


@pytest.mark.parametrize(
    ("prompt", "met"),
    [
        ("The first ball of a Newton's cradle hits its neighbour.", "ball_2"),
        (
            "Five dominoes stand in a row. The first domino topples and knocks over its neighbor.",
            "domino_2",
        ),
        ("Three carts stand in a line. The last cart rolls into its neighbour.", "cart_2"),
    ],
)
def test_a_neighbour_is_the_next_of_its_row(prompt: str, met: str) -> None:
    doc = draft(prompt)
    assert doc.timeline_system is not None
    hits = [n for n in doc.timeline_system.sequence_graph.nodes if n.event.value == "Collision"]
    assert met in hits[0].participants
    assert not [n for n in doc.spatial_relation_graph.nodes if "neighbo" in n]


def test_the_neighbour_of_a_person_is_another_one() -> None:
    assert "neighbor_1" in draft("A man bumps into his neighbor.").spatial_relation_graph.nodes
