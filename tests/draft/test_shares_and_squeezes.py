"""Shares of a speed, things caught between two others, balls that go in off something, makes of cars."""

from __future__ import annotations

import pytest

from esg.assets.library.proposal import is_toy
from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, NodeEvent, TimelineEdge


def drafted(prompt: str) -> EsgDocument:
    doc = draft(prompt)
    assert not verify(doc)
    return doc


def points(doc: EsgDocument) -> list[tuple[str, ...]]:
    assert doc.timeline_system is not None
    graph = doc.timeline_system.sequence_graph
    skip = (NodeEvent.SCENE_START, NodeEvent.TRIGGER)
    return [(n.event.value, *n.participants) for n in graph.nodes if n.event not in skip]


def drives(doc: EsgDocument, actor: str) -> list[TimelineEdge]:
    assert doc.timeline_system is not None
    return [e for e in doc.timeline_system.sequence_graph.edges if e.actor == actor]


@pytest.mark.parametrize(
    ("prompt", "mover", "body", "other"),
    [
    ],
)  # fmt: skip
def test_what_is_caught_between_two_things_is_hit_and_hits(
    prompt: str, mover: str, body: str, other: str
) -> None:
    assert points(drafted(prompt)) == [("Collision", mover, body), ("Collision", body, other)]


def test_a_tunnel_stands_there_and_is_no_arrival_where_one_drives_through() -> None:
    doc = drafted("A train drives through a tunnel and hits a cow.")
    assert "tunnel_1" in doc.spatial_relation_graph.nodes
    assert points(doc) == [("Collision", "train_1", "cow_1")]


def test_splitting_things_is_hitting_them() -> None:
    doc = drafted("The cue ball splits the pair of red balls.")
    assert points(doc) == [("Collision", "cue_ball_1", "red_ball_1")]


def test_models_of_cars_and_fashion_models_are_full_sized() -> None:
    for prompt, name, side in (
        ("A Model T hits a wall.", "model_t_1", 0),
        ("A fashion model walks into a chair.", "fashion_model_1", 2),
    ):
        doc = drafted(prompt)
        key = doc.spatial_relation_graph.nodes[name].asset_id
        assert doc.asset_requirement[key].expected_dimensions_cm[side] > 150.0
        assert not is_toy(doc.asset_requirement[key])
    doc = drafted("A model airplane hits a tree.")
    key = doc.spatial_relation_graph.nodes["airplane_1"].asset_id
    assert is_toy(doc.asset_requirement[key])
