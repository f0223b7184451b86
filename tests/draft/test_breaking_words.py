"""What breaks: which words say so, of what, and what stays whole."""

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Predicate
from esg.lexicon.breakables import breakables


def told(doc: EsgDocument) -> list[tuple[str, ...]]:
    if doc.timeline_system is None:
        return []
    nodes = doc.timeline_system.sequence_graph.nodes
    return [(n.event.value, *n.participants) for n in nodes if n.event.value != "SceneStart"]


def lost(doc: EsgDocument) -> list[str]:
    said = doc.statements or ()
    return [s.text for s in said if s.predicate is Predicate.NOT_REPRESENTED]


@pytest.mark.parametrize(
    ("prompt", "events"),
    [
        (
            "A glass falls off a table and shatters on the floor.",
            [("Fall", "glass_1"), ("Break", "glass_1")],
        ),
        ("A ball smashes a window.", [("Collision", "ball_1", "window_1"), ("Break", "window_1")]),
        ("A vase tips over and breaks.", [("Topple", "vase_1"), ("Break", "vase_1")]),
        (
            "A hammer hits a watermelon and it breaks apart.",
            [("Collision", "hammer_1", "watermelon_1"), ("Break", "watermelon_1")],
        ),
        (
            "A car crashes through a brick wall.",
            [("Collision", "car_1", "brick_wall_1"), ("Break", "brick_wall_1")],
        ),
        (
            "A bowling ball rolls into a vase, which breaks into pieces.",
            [("Collision", "bowling_ball_1", "vase_1"), ("Break", "vase_1")],
        ),
        (
            "A window is smashed by a rock.",
            [("Collision", "rock_1", "window_1"), ("Break", "window_1")],
        ),
        (
            "A boy throws a ball and breaks a window.",
            [("Collision", "ball_1", "window_1"), ("Break", "window_1")],
        ),
        (
            "A truck demolishes a brick wall.",
            [("Collision", "truck_1", "brick_wall_1"), ("Break", "brick_wall_1")],
        ),
        ("A plate breaks on the floor.", [("Fall", "plate_1"), ("Break", "plate_1")]),
        (
            "A cat knocks a vase off a shelf and it shatters into pieces.",
            [("Collision", "cat_1", "vase_1"), ("Fall", "vase_1"), ("Break", "vase_1")],
        ),
    ],
)
def test_what_breaks_is_told(prompt: str, events: list[tuple[str, ...]]) -> None:
    doc = draft(prompt)
    assert told(doc) == events
    assert verify(doc) == ()
    assert lost(doc) == []
    broken = {p for kind, *who in events if kind == "Break" for p in who}
    nodes = doc.spatial_relation_graph.nodes
    assert {name for name, node in nodes.items() if node.breaking is not None} == broken


@pytest.mark.parametrize(
    "prompt",
    [
        "A car breaks down.",
        "A rope breaks.",
        "A steel ball breaks.",
        "A plastic bottle falls off a table and breaks.",
    ],
)
def test_what_cannot_break_is_owned_up_to(prompt: str) -> None:
    doc = draft(prompt)
    assert not any(kind == "Break" for kind, *_ in told(doc))
    assert lost(doc) != []
    assert all(n.breaking is None for n in doc.spatial_relation_graph.nodes.values())


@pytest.mark.parametrize(
    "prompt",
    [
        "A glass falls off a table.",
        "A ball hits a window.",
        "A car crashes into a brick wall.",
        "A ball hits a vase, which does not break.",
    ],
)
def test_what_is_not_said_to_break_stays_whole(prompt: str) -> None:
    nodes = draft(prompt).spatial_relation_graph.nodes
    assert all(n.breaking is None for n in nodes.values())


def test_every_row_has_figures_and_a_source() -> None:
    for row in set(breakables().values()):
        assert row.source
        assert row.pieces == 0 or (row.pieces >= 3 and row.at_mps > 0.0), row.nouns


@pytest.mark.parametrize(
    ("prompt", "broken"),
    [
        ("A golf ball flies into the window of a shed and the glass shatters.", "window_1"),
        ("A stone hits the window and shatters the glass.", "window_1"),
        ("A hammer falls on a mirror and the glass cracks in two.", "mirror_1"),
        ("A rock falls on a glass table. The glass breaks.", "table_1"),
    ],
)
def test_the_glass_is_that_of_what_was_hit(prompt: str, broken: str) -> None:
    """Break what is of glass, and draw no drinking glass beside it."""
    doc = draft(prompt)
    assert ("Break", broken) in told(doc)
    assert not [name for name in doc.spatial_relation_graph.nodes if name.startswith("glass")]


@pytest.mark.parametrize(
    "prompt",
    [
        "A glass stands beside a window. A ball hits the glass.",
        "A ball rolls past a window and knocks the glass of water off a table.",
    ],
)
def test_a_drinking_glass_is_none_of_a_window(prompt: str) -> None:
    assert "glass_1" in doc_nodes(prompt)


def doc_nodes(prompt: str) -> set[str]:
    return {*draft(prompt).spatial_relation_graph.nodes}
