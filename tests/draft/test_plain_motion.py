"""Readings that plain prompts of vehicles, animals and loads needed."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from tests.draft.told import events


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        # along what it touches
        (
            "A bus scrapes along a kiosk and hits a tree.",
            [("Collision", "bus_1", "kiosk_1"), ("Collision", "bus_1", "tree_1")],
        ),
        # the verb that is understood between two things
        (
            "The first keg nudges the second, and the second the third.",
            [
                ("Collision", "first_keg_1", "second_keg_1"),
                ("Collision", "second_keg_1", "third_keg_1"),
            ],
        ),
        # a verb in -s after "which" is no plural
        (
            "A van rolls into a gate, which swings open and hits a bin.",
            [
                ("Collision", "van_1", "gate_1"),
                ("Collision", "gate_1", "bin_1"),
            ],
        ),
        # what a plural does backwards
        ("Two vans back into each other.", [("Collision", "van_1", "van_2")]),
        # who goes on after ", which": what the relative clause is about
        (
            "A wolf chases a goat, which runs into a churn, upsetting it.",
            [("Collision", "goat_1", "churn_1"), ("Topple", "churn_1")],
        ),
        # openings are passed
        ("A bag drops through a hatch onto a cart.", [("Collision", "bag_1", "cart_1")]),
        (
            "A basketball drops through the hoop.",
            [("EnterRegion", "basketball_1")],
        ),
        # stumbling touches what it is over, and what it ends at
        (
            "A clown stumbles over a crate into a table.",
            [("Collision", "clown_1", "crate_1"), ("Collision", "clown_1", "table_1")],
        ),
        # a thing that was not understood is not replaced by another one
        (
            "A boat passes a barge, but its oar hits a pile.",
            [("Miss", "boat_1", "barge_1")],
        ),
        # parts of machines act for them
        (
            "A digger turns left and its bucket hits a fence.",
            [("HeadingReached", "digger_1"), ("Collision", "digger_1", "fence_1")],
        ),
        (
            "A truck brakes and a rock falls on the driver's cab.",
            [("Collision", "rock_1", "truck_1")],
        ),
        # loads leave the vehicle that was named
        (
            "A lorry stops and a barrel rolls off the back.",
            [("Stop", "lorry_1"), ("Fall", "barrel_1")],
        ),
        # all but the ones told of
        (
            "Three logs lie on a hill. The first log hits a goat, and the rest roll into a pond.",
            [
                ("Collision", "first_log_1", "goat_1"),
                ("EnterRegion", "log_2"),
                ("EnterRegion", "log_3"),
            ],
        ),
        # the first of its own kind
        (
            "Five ducks cross a road. A bus stops for them. A second bus runs into the first one.",
            [("Stop", "bus_1"), ("Collision", "second_bus_1", "bus_1")],
        ),
        # from which it falls
        (
            "A cart hits a shelf, from which a jar falls on a dog.",
            [
                ("Collision", "cart_1", "shelf_1"),
                ("Fall", "jar_1"),
                ("Collision", "jar_1", "dog_1"),
            ],
        ),
        ("A balloon sinks and comes down in a lake.", [("EnterRegion", "balloon_1")]),
        # the other of one
        (
            "One boat turns left, the other hits a pier.",
            [("HeadingReached", "boat_1"), ("Collision", "boat_2", "pier_1")],
        ),
        # what nobody does
        ("Nobody stops the cart, and it hits a wall.", [("Collision", "cart_1", "wall_1")]),
        # each of those that are passed
        (
            "A car passes a bus and a van.",
            [("Miss", "car_1", "bus_1"), ("Miss", "car_1", "van_1")],
        ),
        (
            "Two vans drive. A car overtakes both.",
            [("Miss", "car_1", "van_1"), ("Miss", "car_1", "van_2")],
        ),
        # who stops it runs after it
        ("A dog chases a cart and stops it.", [("Stop", "cart_1")]),
        # on its back
        (
            "Two boars collide, and the smaller one is thrown onto its back.",
            [("Collision", "boar_1", "boar_2"), ("Topple", "boar_1")],
        ),
        # told again, though the sentence has "again"
        (
            "A ball enters a bucket and bounces out again 9 s after entering it.",
            [("EnterRegion", "ball_1")],
        ),
        ("The diver lets go of the rope and hits a buoy.", [("Collision", "diver_1", "buoy_1")]),
        ("The door jams, and a dog hits a box.", [("Collision", "dog_1", "box_1")]),
        # the hive of the beehive
        (
            "A goat hits a beehive, and the hive falls over.",
            [("Collision", "goat_1", "beehive_1"), ("Topple", "beehive_1")],
        ),
        # against what it is crushed
        (
            "A cart crushes a basket against a wall.",
            [("Collision", "cart_1", "basket_1"), ("Collision", "basket_1", "wall_1")],
        ),
        # the middle of three
        (
            "Three carts stand in a row. A bus hits the middle one.",
            [("Collision", "bus_1", "middle_cart_1")],
        ),
        (
            "A sled hits a stump and tips over, throwing out a bag.",
            [("Collision", "sled_1", "stump_1"), ("Topple", "sled_1"), ("Fall", "bag_1")],
        ),
        # two of one kind, told apart by their whole name
        (
            "A sailing boat passes a fishing boat, and the sailing boat hits a wall.",
            [("Miss", "boat_1", "boat_2"), ("Collision", "boat_1", "wall_1")],
        ),
        # the second of what was called the first, not of the horses
        (
            "While the first coach changes horses, the second one hits a gate.",
            [("Collision", "second_coach_1", "gate_1")],
        ),
        # the one that braked for it
        (
            "Two vans drive. The first one brakes for a hen; the second one, which is near, hits it.",
            [("Collision", "second_van_1", "first_van_1")],
        ),
        # what has a part that does nothing
        (
            "A box falls off a plane, its parachute does not open, and it hits a hut.",
            [("Fall", "box_1"), ("Collision", "box_1", "hut_1")],
        ),
        (
            "The digger's arm knocks down a pole.",
            [("Collision", "digger_1", "pole_1"), ("Topple", "pole_1")],
        ),
        ("The ship's bow turns to the right.", [("HeadingReached", "ship_1")]),
        ("A bell swings to and fro and hits a lamp.", [("Collision", "bell_1", "lamp_1")]),
        ("A pony shies at a bag and hits a gate.", [("Collision", "pony_1", "gate_1")]),
        # who is made to fall, wherever he is
        (
            "A ferry bumps a pier, which makes a girl on the deck fall off her bicycle.",
            [("Collision", "ferry_1", "pier_1"), ("Fall", "girl_1")],
        ),
        # it falls down before it hits
        (
            "A cart bumps a shelf, a jar falls down and hits a cat.",
            [
                ("Collision", "cart_1", "shelf_1"),
                ("Fall", "jar_1"),
                ("Collision", "jar_1", "cat_1"),
            ],
        ),
    ],
)
def test_reading(prompt: str, expected: list[tuple[Any, ...]]) -> None:
    assert events(prompt) == expected


def test_slowing_to_a_stop_takes_its_time() -> None:
    doc = draft("The tram slows down from 8 m/s to a stop within 5 s.")
    assert doc.timeline_system is not None
    stop = [n for n in doc.timeline_system.sequence_graph.nodes if n.event.value == "Stop"]
    assert [c.quantity for c in stop[0].constraints] == ["time_to_stop"]
