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
        # what was sent off is what "it" is
        (
            "A girl rolls a hoop toward a bench, and it stops in front of the bench.",
            [("Stop", "hoop_1")],
        ),
        (
            "A man pushes a trolley toward a lift, and it hits a bin.",
            [("Collision", "man_1", "trolley_1"), ("Collision", "trolley_1", "bin_1")],
        ),
        (
            "The ball rolls to a striker, who shoots it into the goal.",
            [("EnterRegion", "ball_1")],
        ),
        # one that an adjective tells apart
        (
            "The wooden cube bumps the plastic one and knocks it over.",
            [
                ("Collision", "cube_1", "cube_2"),
                ("Topple", "cube_2"),
            ],
        ),
        (
            "A stone flies past one tin and hits another.",
            [("Miss", "stone_1", "tin_1"), ("Collision", "stone_1", "second_tin_1")],
        ),
        # nouns and verbs that a conjunction leaves out
        (
            "The left and the right cart hit a wall.",
            [("Collision", "left_cart_1", "wall_1"), ("Collision", "right_cart_1", "wall_1")],
        ),
        # some of a plural
        (
            "A cart hits two of the five bins.",
            [("Collision", "cart_1", "bin_1")],
        ),
        (
            "One of the three boys slides and takes the other two down.",
            [
                ("Collision", "boy_1", "boy_2"),
                ("Collision", "boy_1", "boy_3"),
                ("Topple", "boy_2"),
                ("Topple", "boy_3"),
            ],
        ),
        # verbs and what they act on
        ("A keeper deflects the puck with his stick.", [("Collision", "keeper_1", "puck_1")]),
        ("The runner dribbles past a guard.", [("Miss", "runner_1", "guard_1")]),
        ("A boy on a tricycle stops pedalling.", []),
        (
            "The second sledge hits the first, and the first slides into a tree.",
            [
                ("Collision", "second_sledge_1", "first_sledge_1"),
                ("Collision", "first_sledge_1", "tree_1"),
            ],
        ),
        (
            "Snow slides off the roof and buries a bench.",
            [("Fall", "snow_1"), ("Collision", "snow_1", "bench_1")],
        ),
        (
            "The seesaw tips over and a doll slides off.",
            [("Topple", "seesaw_1"), ("Fall", "doll_1")],
        ),
        ("A girl jumps off the pony.", [("Fall", "girl_1")]),
        (
            "A puck does not stop before the line but glides on and hits a shoe.",
            [("Collision", "puck_1", "shoe_1")],
        ),
        # "it" after a when-clause, after a blow, and one arrival after the other
        (
            "The jug trembles when a cat bumps into the counter, and then it falls off the shelf.",
            [("Collision", "cat_1", "counter_1"), ("Fall", "jug_1")],
        ),
        (
            "A keeper punches the ball against a post, and it bounces into the goal.",
            [
                ("Collision", "keeper_1", "ball_1"),
                ("Collision", "ball_1", "post_1"),
                ("EnterRegion", "ball_1"),
            ],
        ),
        (
            "A dog runs to a stick and carries it to a tree.",
            [("Reach", "dog_1", "stick_1"), ("Reach", "dog_1", "tree_1")],
        ),
        # what is passed to somebody arrives at nobody
        ("A boy kicks a ball and passes it to a girl.", []),
        # none of them does, and no support is left behind the net
        ("None of the four cups falls off the table.", []),
        (
            "The shuttlecock hits the net and drops on the other side.",
            [("Collision", "shuttlecock_1", "net_1")],
        ),
        (
            "A toboggan slides into a pile of snow.",
            [("Collision", "toboggan_1", "pile_of_snow_1")],
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


def test_measures_after_a_conjunction_and_each() -> None:
    doc = draft("A puck leaves the stick at 12 m/s and an angle of 25 degrees.")
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    assert any(e.params.elevation_deg == 25.0 and e.params.speed == 1200.0 for e in edges)
    doc = draft("Two bowls, each 20 cm in diameter, stand on a table.")
    bowls = [n for n in doc.spatial_relation_graph.nodes.values() if n.label == "bowl"]
    assert all(doc.asset_requirement[b.asset_id].dimensions_are_prescribed for b in bowls)


def test_a_slope_of_some_degrees_is_a_thing() -> None:
    doc = draft("A barrel rolls down a 10-degree slope.")
    assert any("slope" in name for name in doc.spatial_relation_graph.nodes)
