"""What stands at an end, an edge, a corner or a side of a top."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Predicate


def _at(doc: EsgDocument) -> list[tuple[tuple[str, ...], tuple[str, ...], str | None]]:
    told = [s for s in doc.statements or () if s.predicate is Predicate.AT_PART]
    return [(s.object, s.target, s.noun) for s in told]


def _lost(doc: EsgDocument) -> list[str]:
    said = doc.statements or ()
    return [s.text for s in said if s.predicate is Predicate.NOT_REPRESENTED]


@pytest.mark.parametrize(
    ("prompt", "part"),
    [
        ("A cup sits at one end of a table.", "end"),
        ("A book lies on the corner of a desk.", "corner"),
        ("An apple is in the corner of a tray.", "corner"),
        ("A coin lies near the edge of a desk.", "edge"),
        ("A cup stands on the left side of a table.", "left side"),
        ("A mug is at the left end of a shelf.", "left end"),
        ("A plate is placed at the right edge of the table.", "right edge"),
        ("A box stands in the back left corner of a table.", "back left corner"),
    ],
)
def test_a_part_of_a_top_is_a_region_and_a_statement(prompt: str, part: str) -> None:
    doc = draft(prompt)
    ((who, (host,), said),) = _at(doc)
    assert said == part
    assert not _lost(doc)
    assert not verify(doc)
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions[graph.nodes[who[0]].semantic_region or ""]
    assert (region.parent_object, region.part) == (host, part)


def test_the_other_end_is_not_that_of_the_first() -> None:
    doc = draft("A cup stands at one end of a table. A jug stands at the other end of the table.")
    assert _at(doc) == [
        (("cup_1",), ("table_1",), "end"),
        (("jug_1",), ("table_1", "cup_1"), "other end"),
    ]


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A lamp stands in the corner of a room while a ball rolls.", "in the corner of a room"),
        ("A chair stands at the end of a hallway.", "at the end of a hallway"),
        ("A ball rolls from one end of a bench to the other.", "from one end of a bench to the other"),
        ("A cup stands at the far end of a table.", "at the far end of a table"),
    ],
)  # fmt: skip
def test_ends_that_nothing_sees_to_are_owned_up_to(prompt: str, words: str) -> None:
    assert words in _lost(draft(prompt))
