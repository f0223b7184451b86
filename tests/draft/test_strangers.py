"""Readings that prompts of other hands needed: persons, reports, titles, similes, falls."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument

POINTS = {"Collision", "EnterRegion", "Fall", "Topple", "Stop", "HeadingReached", "Reach", "Miss"}


def read(prompt: str) -> tuple[EsgDocument, list[tuple[Any, ...]]]:
    """The verified draft and its point events."""
    doc = draft(prompt)
    assert verify(doc) == ()
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    return doc, [(n.event.value, *n.participants) for n in nodes if n.event.value in POINTS]


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        # who runs on after "before", "after"
        (
            "A dog bumps a jug that sways before tumbling to the floor.",
            [("Collision", "dog_1", "jug_1"), ("Fall", "jug_1")],
        ),
        # persons and drivers
        (
            "A wainwright stands by the road. A cart hits him.",
            [("Collision", "cart_1", "wainwright_1")],
        ),
        ("A goat trots along and a dog overtakes him.", [("Miss", "dog_1", "goat_1")]),
        ("The lorry slows down and he stops at a gate.", [("Stop", "lorry_1")]),
        # reports and titles
        (
            "Claimant states that a crate fell on his wagon, slid off and hit a gate.",
            [
                ("Collision", "crate_1", "wagon_1"),
                ("Fall", "crate_1"),
                ("Collision", "crate_1", "gate_1"),
            ],
        ),
        ("Sorting task: a ball rolls into a box.", [("Collision", "ball_1", "box_1")]),
        # names by number
        (
            "Truck number one waits, truck number two hits truck number one.",
            [("Collision", "truck_two", "truck_one")],
        ),
        # the other one does
        (
            "Two mopeds race. One of them stops and the other hits a bench.",
            [("Stop", "moped_1"), ("Collision", "moped_2", "bench_1")],
        ),
        # parts on their own
        (
            "A tin is intercepted by a mobile base. It bounces off it and misses a vase.",
            [("Collision", "mobile_base_1", "tin_1"), ("Miss", "tin_1", "vase_1")],
        ),
        # dodging says no side
        ("A boy dodges a puddle.", [("Miss", "boy_1", "puddle_1")]),
        (
            "A boy dodges a puddle to the right.",
            [("HeadingReached", "boy_1"), ("Miss", "boy_1", "puddle_1")],
        ),
        # what is taken out, thrown off, comes off
        (
            "A ball flattens a skittle.",
            [("Collision", "ball_1", "skittle_1"), ("Topple", "skittle_1")],
        ),
        ("The donkey throws its rider.", [("Fall", "rider_1")]),
        (
            "The puck comes off the referee's leg and slides into a box.",
            [("Collision", "puck_1", "referee_1"), ("Collision", "puck_1", "box_1")],
        ),
        (
            "The parcel comes off the shelf and hits a cat.",
            [("Fall", "parcel_1"), ("Collision", "parcel_1", "cat_1")],
        ),
        # what comes down to the ground stood on what was hit
        (
            "A forklift bumps a shelf; a jar wobbles and then crashes to the ground.",
            [("Collision", "forklift_1", "shelf_1"), ("Fall", "jar_1")],
        ),
        # what hangs does not topple
        (
            "The chandelier plunges onto the piano.",
            [("Collision", "chandelier_1", "piano_1")],
        ),
        # not itself
        (
            "A curling stone hits the guard stone and stops.",
            [("Collision", "curling_stone_1", "guard_stone_1"), ("Stop", "curling_stone_1")],
        ),
        # a compound with a verb's spelling
        (
            "An airport shuttle brakes and rams a bollard.",
            [("Collision", "shuttle_1", "bollard_1")],
        ),
        # telegrams
        (
            "van stops at crosswalk, bike behind hits cone",
            [("Stop", "van_1"), ("Collision", "bike_1", "cone_1")],
        ),
        # participles with a subject of their own
        (
            "Three lemons roll down a ramp, the last one hitting a cat.",
            [("Collision", "last_lemon_1", "cat_1")],
        ),
        (
            "A brick strikes the jar, the jar falling from the table.",
            [("Collision", "brick_1", "jar_1"), ("Fall", "jar_1")],
        ),
        (
            "The lorry brakes, its trailer slamming into a wall.",
            [("Collision", "trailer_1", "wall_1")],
        ),
        # her, his car
        (
            "A girl stands still. A dog runs into her.",
            [("Collision", "dog_1", "girl_1")],
        ),
        # who does what
        (
            "A car changing lanes knocks a moped over.",
            [("Collision", "car_1", "moped_1"), ("Topple", "moped_1")],
        ),
        (
            "A boy throws a ball, the receiver leaps, and the ball hits him.",
            [("Collision", "ball_1", "receiver_1")],
        ),
        # guns, what breaks through, what splashes onto
        ("A cannon fires at a wall.", [("Collision", "cannonball_1", "wall_1")]),
        ("The boulder breaks through a fence.", [("Collision", "boulder_1", "fence_1")]),
        (
            "A paint pot rolls off a ledge and splashes onto a parked car.",
            [("Fall", "pot_1"), ("Collision", "pot_1", "car_1")],
        ),
        # tilting is not toppling
        (
            "The tray tilts and a spoon slides off it.",
            [("Fall", "spoon_1")],
        ),
        # whose: of the noun before
        (
            "A barrel slams into a van, whose mirror breaks off.",
            [("Collision", "barrel_1", "van_1"), ("Fall", "mirror_1")],
        ),
        (
            "A lorry whose wheel came off hits a wall.",
            [("Collision", "lorry_1", "wall_1"), ("Fall", "wheel_1")],
        ),
        (
            "A truck whose driver is asleep rams a gate.",
            [("Collision", "truck_1", "gate_1")],
        ),
        # of which, neither ... nor
        (
            "A cow bumps two barrels, one of which rolls into a goat.",
            [("Collision", "cow_1", "barrel_1"), ("Collision", "barrel_1", "goat_1")],
        ),
        (
            "Neither the tram nor the taxi stops, so they collide.",
            [("Collision", "tram_1", "taxi_1")],
        ),
        # this one, it that was slid
        (
            "The green ball hits the red ball and this one rolls into the hole.",
            [("Collision", "green_ball_1", "red_ball_1"), ("EnterRegion", "red_ball_1")],
        ),
        (
            "She slides the mug down the counter, and it knocks a jar off the end.",
            [("Collision", "mug_1", "jar_1"), ("Fall", "jar_1")],
        ),
        # the one on it, the top one
        (
            "A forklift hits a stack of pallets, knocking the top pallet off.",
            [("Collision", "forklift_1", "top_pallet_1"), ("Fall", "top_pallet_1")],
        ),
        # nouns spelled like verbs, abstract words before a noun
        (
            "A coconut hits a shield.",
            [("Collision", "coconut_1", "shield_1")],
        ),
        (
            "A weather vane falls onto a car.",
            [("Collision", "vane_1", "car_1")],
        ),
        # the next one of what was dodged
        (
            "The drone dodges one balloon but collides with the next.",
            [("Miss", "drone_1", "balloon_1"), ("Collision", "drone_1", "balloon_2")],
        ),
        ("The ball comes back off the post.", [("Collision", "ball_1", "post_1")]),
        ("The cap blows off and lands on a dog.", [("Collision", "cap_1", "dog_1")]),
        # it: not a way, not a part of the clause after the main one
        (
            "A jar is on the shelf. A cat walks along the wall and brushes against it.",
            [("Collision", "cat_1", "jar_1")],
        ),
        (
            "A barrel rolls off a cart after the cart hits a stone. It rolls into a fence.",
            [
                ("Collision", "cart_1", "stone_1"),
                ("Fall", "barrel_1"),
                ("Collision", "barrel_1", "fence_1"),
            ],
        ),
        # what is kicked up is thrown, what was meant does not happen
        (
            "A pebble kicked up by a passing lorry strikes a coach.",
            [("Collision", "pebble_1", "coach_1")],
        ),
        (
            "A tyre was meant to stop at the hedge. It hits a van.",
            [("Collision", "tyre_1", "van_1")],
        ),
        # a relative clause between a subject and its verb
        (
            "The first car stops at the crossing, and the second car, which follows it, hits it.",
            [("Stop", "first_car_1"), ("Collision", "second_car_1", "first_car_1")],
        ),
        # the next one is another one
        (
            "A domino falls and hits the next domino, which knocks over a cup.",
            [
                ("Topple", "domino_1"),
                ("Collision", "domino_1", "domino_2"),
                ("Collision", "domino_2", "cup_1"),
                ("Topple", "cup_1"),
            ],
        ),
        # who rides falls off, who walks falls over
        ("A horse jumps over a fence and throws off the rider.", [("Fall", "rider_1")]),
        # what is caught was thrown
        (
            "A man kicks a ball against a wall, catches it and throws it into a basket.",
            [
                ("Collision", "ball_1", "wall_1"),
                ("Collision", "man_1", "ball_1"),
                ("EnterRegion", "ball_1"),
            ],
        ),
        # over the net, an elbow
        (
            "The ball clips the net, drops over and bounces twice.",
            [("Collision", "ball_1", "net_1")],
        ),
        (
            "An elbow catches a box. It goes over the edge and lands on a can.",
            [("Collision", "elbow_1", "box_1"), ("Fall", "box_1"), ("Collision", "box_1", "can_1")],
        ),
        # the smaller and the larger one; a stack lands once
        (
            "Two boats sail along; the smaller one turns right, but the larger one scrapes it.",
            [("HeadingReached", "boat_1"), ("Collision", "boat_2", "boat_1")],
        ),
        (
            "A stack of books falls off the desk and lands on a dog.",
            [("Fall", "book_1"), ("Collision", "book_1", "dog_1")],
        ),
        (
            "While a truck is unloading, a crate slides down the ramp and hits a worker.",
            [("Collision", "crate_1", "worker_1")],
        ),
    ],
)
def test_the_right_things_meet(prompt: str, expected: list[tuple[Any, ...]]) -> None:
    """Read each event between the things that the prompt means."""
    _, found = read(prompt)
    assert found == expected


def test_a_neighbour_of_a_thing_is_another_one() -> None:
    """Let "its neighbour" be a second domino, and "as well" no well."""
    doc, found = read("A domino tips and strikes its neighbour, which topples as well.")
    assert len(doc.spatial_relation_graph.nodes) == 3
    assert [e[0] for e in found] == ["Topple", "Collision", "Topple"]
    assert found[1][2] == found[2][1] != found[0][1]


def test_a_simile_draws_nothing() -> None:
    """Read "like dominoes" as the manner of a fall; keep what is named in its own right."""
    doc, _ = read("A row of scooters topples like dominoes after a van backs into the first one.")
    assert not any("domino" in name for name in doc.spatial_relation_graph.nodes)
    doc, _ = read("Something like a brick falls onto a car.")
    assert any("brick" in name for name in doc.spatial_relation_graph.nodes)


def test_a_tower_that_is_hit_falls() -> None:
    """Let "it falls down" after a throw at a tower be about the tower."""
    _, found = read("There is a tower of cups. A girl throws a sock at it and it falls down.")
    assert found == [("Collision", "sock_1", "cup_1"), ("Topple", "cup_1")]


def test_a_stack_named_after_its_noun_is_several_things() -> None:
    """Let "the book pile" be books, one of which is hit."""
    doc, found = read("A ball rolls into the book pile.")
    assert sum(name.startswith("book") for name in doc.spatial_relation_graph.nodes) == 3
    assert found == [("Collision", "ball_1", "book_1")]
    doc, found = read("A kart hits a tire stack 3 seconds after the start.")
    assert sum(name.startswith("tire") for name in doc.spatial_relation_graph.nodes) == 3
    assert found == [("Collision", "kart_1", "tire_1")]
    hit = doc.timeline_system.sequence_graph.nodes[-1]
    assert hit.time_is_prescribed
    assert hit.timestamp == 3.0
