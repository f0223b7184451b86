"""Readings that rounds of plain prompts of home, sport and play showed missing."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from tests.draft.told import events


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        # "before the wall" is a place, where no subject of its own follows
        (
            "A taxi stops before the gate and turns right.",
            [("Stop", "taxi_1"), ("HeadingReached", "taxi_1")],
        ),
        (
            "A sledge turns left just before the hut but hits a post.",
            [("HeadingReached", "sledge_1"), ("Collision", "sledge_1", "post_1")],
        ),
        # what rolls off a piece of furniture after a bump stood on it
        (
            "As a dog bumps the table, two plums roll off.",
            [("Collision", "dog_1", "table_1"), ("Fall", "plum_1"), ("Fall", "plum_2")],
        ),
        # a number that names one of a set
        (
            "A bowling ball strikes the five pin, and the five pin slides into a chair.",
            [("Collision", "bowling_ball_1", "pin_5"), ("Collision", "pin_5", "chair_1")],
        ),
        # parts of furniture and of things that are not known
        (
            "A phone slides from the arm of an armchair and lands on a drum.",
            [("Fall", "phone_1"), ("Collision", "phone_1", "drum_1")],
        ),
        (
            "A stone lands on the roof of the gazebo.",
            [("Collision", "stone_1", "gazebo_1")],
        ),
        # a hole that is run over is not entered
        (
            "A golf ball runs over the hole and hits a rake.",
            [("Collision", "golf_ball_1", "rake_1")],
        ),
        # what is taken along falls, too
        (
            "A vase falls off the windowsill, taking a candle with it.",
            [("Fall", "vase_1"), ("Fall", "candle_1")],
        ),
        # members told apart by their kind, and an arrival "there"
        (
            "Two vehicles drive toward the same gate. The truck gets there first; the bus stops.",
            [("Reach", "truck_1", "gate_1"), ("Stop", "bus_1")],
        ),
        # "no one" does nothing
        (
            "No one scores: a ball rolls past the right post.",
            [("Miss", "ball_1", "right_post_1")],
        ),
        # air moves a thing, not the fan
        (
            "A coin rolls toward the edge of the table, stops, and is blown off by a fan.",
            [("Stop", "coin_1"), ("Fall", "coin_1")],
        ),
        # a conveyor moves what it carries
        (
            "A conveyor carries a parcel past a guard.",
            [("Miss", "parcel_1", "guard_1")],
        ),
        # what has been stacked is a tower
        (
            "Three cubes are stacked. A ball hits the whole tower.",
            [("Collision", "ball_1", "cube_1")],
        ),
    ],
)
def test_plain_sentences(prompt: str, expected: list[tuple[Any, ...]]) -> None:
    assert events(prompt) == expected


def test_a_skater_glides_at_the_stated_speed() -> None:
    doc = draft("A skater glides at 5 m/s, jumps over a log and brakes.")
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    assert any(e.speed_is_prescribed and e.params.speed == 500.0 for e in edges)


def test_hovering_takes_its_time() -> None:
    doc = draft("A drone rises, hovers for 4 seconds and turns right.")
    assert doc.timeline_system is not None
    spans = [c.value for n in doc.timeline_system.sequence_graph.nodes for c in n.constraints]
    stamps = [n.timestamp for n in doc.timeline_system.sequence_graph.nodes]
    assert 4.0 in [*spans, *stamps]
