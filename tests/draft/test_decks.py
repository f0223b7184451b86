"""Scenes on a pier, a bridge or a stage: a flat surface, or a platform that things fall off."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, NodeEvent


def events(doc: EsgDocument) -> list[tuple[NodeEvent, tuple[str, ...]]]:
    assert not verify(doc) and doc.timeline_system is not None
    nodes = doc.timeline_system.sequence_graph.nodes
    return [(n.event, n.participants) for n in nodes if n.event is not NodeEvent.SCENE_START]


def carrier(doc: EsgDocument, name: str) -> str:
    region = doc.spatial_relation_graph.nodes[name].semantic_region
    assert region is not None
    return doc.spatial_relation_graph.semantic_regions[region].parent_object


@pytest.mark.parametrize(
    ("prompt", "deck", "hit"),
    [
        (
            "A forklift on the pier drives into a shipping container.",
            "pier_1",
            ("forklift_1", "shipping_container_1"),
        ),
        (
            "A van drives across the bridge and crashes into a motorcycle.",
            "bridge_1",
            ("van_1", "motorcycle_1"),
        ),
        (
            "A singer walks across the stage and bumps into a loudspeaker.",
            "stage_1",
            ("singer_1", "loudspeaker_1"),
        ),
        (
            "On the loading dock, a pallet jack hits a crate.",
            "loading_dock_1",
            ("pallet_jack_1", "crate_1"),
        ),
    ],
)
def test_what_nothing_falls_off_is_a_flat_surface(
    prompt: str, deck: str, hit: tuple[str, str]
) -> None:
    doc = draft(prompt)
    assert events(doc) == [(NodeEvent.COLLISION, hit)]
    nodes = doc.spatial_relation_graph.nodes
    assert nodes[deck].is_structural
    assert all(carrier(doc, n) == "ground_1" for n in hit)
    length, width, height = doc.asset_requirement[nodes[deck].asset_id].expected_dimensions_cm
    assert length >= 1500.0 and width >= 600.0 and height <= 2.0
    assert "road_1" not in nodes


def test_a_stated_length_is_kept() -> None:
    doc = draft("A forklift drives over a 30 m long pier and hits a container on the pier.")
    asset = doc.asset_requirement[doc.spatial_relation_graph.nodes["pier_1"].asset_id]
    assert asset.dimensions_are_prescribed
    assert asset.expected_dimensions_cm[0] == pytest.approx(3000.0)


def test_who_drives_off_the_end_falls_from_it() -> None:
    doc = draft("A car drives off the end of the quay and falls into the water.")
    assert events(doc) == [
        (NodeEvent.FALL, ("car_1",)),
        (NodeEvent.ENTER_REGION, ("car_1",)),
    ]
    assert carrier(doc, "car_1") == "quay_1"


@pytest.mark.parametrize(
    ("prompt", "deck"),
    [
        ("A bird flies over the bridge and hits a kite.", "bridge_1"),
        ("A car drives under the bridge and hits a wall.", "bridge_1"),
        ("A ball is thrown at a man on the roof.", "roof_1"),
        ("A boat hits the pier.", "pier_1"),
    ],
)
def test_elsewhere_it_keeps_its_height(prompt: str, deck: str) -> None:
    doc = draft(prompt)
    assert not verify(doc)
    assert not doc.spatial_relation_graph.nodes[deck].is_structural
