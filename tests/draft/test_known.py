"""Readings of what comes true, gets in the way, is named behind a preposition, and traffic lights."""

from __future__ import annotations

from typing import Any

import pytest

from tests.draft.told import events


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        # what is about to happen and does
        ("A truck is about to hit a deer, and it does.", [("Collision", "truck_1", "deer_1")]),
        ("The trolley nearly hits a bin, and then it does.", [("Collision", "trolley_1", "bin_1")]),
        ("The dog is about to run into a pram, which it then does.", [("Collision", "dog_1", "pram_1")]),
        ("A tram is about to hit a car, but it does not.", []),
        # by what it got in the way of
        ("A dog gets in the way of a bicycle and is hit.", [("Collision", "bicycle_1", "dog_1")]),
        ("A cat walks into the path of a tram and is struck.", [("Collision", "tram_1", "cat_1")]),
        ("A hen steps in front of a tractor and gets hit.", [("Collision", "tractor_1", "hen_1")]),
        (
            "A boy runs in front of a bike and is knocked over.",
            [("Collision", "bike_1", "boy_1"), ("Topple", "boy_1")],
        ),
        # "which it hits": not itself
        ("In front of a car stands a barrel, which it hits.", [("Collision", "car_1", "barrel_1")]),
        ("Behind a truck stands a post, which it backs into.", [("Collision", "truck_1", "post_1")]),
        ("Ahead of the boat lies a buoy, which it bumps into.", [("Collision", "boat_1", "buoy_1")]),
        (
            "There is a fence behind a van, which the van reverses into.",
            [("Collision", "van_1", "fence_1")],
        ),
        # lights that turn green neither turn nor drive
        (
            "When the lights turn green the truck sets off and rams a bollard.",
            [("Collision", "truck_1", "bollard_1")],
        ),
        (
            "The light turns red; a van brakes and stops.",
            [("Stop", "van_1")],
        ),
    ],
)  # fmt: skip
def test_known(prompt: str, expected: list[tuple[Any, ...]]) -> None:
    assert events(prompt) == expected


def test_starts_at_the_light() -> None:
    from esg.draft import draft

    doc = draft("The light changes to green and the van starts.")
    assert "traffic_light_1" in doc.spatial_relation_graph.nodes
    assert doc.timeline_system is not None
    assert {e.actor for e in doc.timeline_system.sequence_graph.edges} == {"van_1"}


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        (
            "Two vans drive toward each other. After the crash, one of them turns over.",
            [("Collision", "van_1", "van_2"), ("Topple", "van_1")],
        ),
        (
            "Two vans drive toward each other and crash. After the crash, one of them turns over.",
            [("Collision", "van_1", "van_2"), ("Topple", "van_1")],
        ),
    ],
)
def test_a_crash_told_only_by_its_noun(prompt: str, told: list[tuple[str, ...]]) -> None:
    """Let what comes toward each other meet "after the crash", once."""
    assert events(prompt) == told
