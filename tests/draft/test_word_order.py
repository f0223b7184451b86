"""Clauses that English turns round, leaves without a verb, or tells with a particle verb."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.draft.verbphrases import particle_sense
from esg.graph import verify
from esg.graph.models import NodeEvent

POINTS = {
    NodeEvent.COLLISION: "hit",
    NodeEvent.ENTER_REGION: "enter",
    NodeEvent.FALL: "fall",
    NodeEvent.TOPPLE: "topple",
    NodeEvent.STOP: "stop",
    NodeEvent.MISS: "miss",
    NodeEvent.REACH: "reach",
    NodeEvent.HEADING_REACHED: "turn",
}


def events(prompt: str) -> list[tuple[str, ...]]:
    """Point events of a draft: what happens, and to what."""
    doc = draft(prompt)
    assert not verify(doc)
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else []
    return [(POINTS[n.event], *n.participants) for n in nodes if n.event in POINTS]


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A cup stands on a shelf. Off the shelf rolls the cup.", ("fall", "cup_1")),
        ("Into the net flies a football.", ("enter", "football_1")),
        ("So hard does a trolley hit a vase that it falls.", ("hit", "trolley_1", "vase_1")),
        ("What knocks the lamp over is a football.", ("hit", "football_1", "lamp_1")),
    ],
)
def test_a_clause_turned_round_is_read_like_a_plain_one(
    prompt: str, expected: tuple[str, ...]
) -> None:
    assert expected in events(prompt)


def test_a_relative_clause_after_an_inversion_is_about_the_subject() -> None:
    assert ("hit", "dog_1", "vase_1") in events("Through the door comes a dog, which hits a vase.")


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("Taxi into lamp post.", [("hit", "taxi_1", "lamp_post_1")]),
        ("Egg off spoon.", [("fall", "egg_1")]),
    ],
)
def test_a_headline_has_the_verb_that_is_understood(
    prompt: str, expected: list[tuple[str, ...]]
) -> None:
    assert events(prompt) == expected


def test_a_list_of_things_before_a_direction_gets_no_verb() -> None:
    found = events("A man pushes a box and a crate into a wall.")
    assert ("hit", "crate_1", "wall_1") in found and len([e for e in found if "wall_1" in e]) == 2


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A boat fetches up against a pier.", [("hit", "boat_1", "pier_1")]),
        ("A van makes contact with a bollard.", [("hit", "van_1", "bollard_1")]),
        ("A jeep rolls onto its roof.", [("topple", "jeep_1")]),
        ("A tram shudders to a halt.", [("stop", "tram_1")]),
        ("A taxi pulls up at a hotel and stops.", [("stop", "taxi_1")]),
        ("A scooter bears right at a fountain.", [("turn", "scooter_1")]),
        ("A duck squeezes past a bin.", [("miss", "duck_1", "bin_1")]),
        ("A car drives up to a gate and stops there.", [("stop", "car_1")]),
    ],
)
def test_a_particle_verb_says_what_happens(prompt: str, expected: list[tuple[str, ...]]) -> None:
    assert events(prompt) == expected


def test_a_heading_is_no_object_and_no_verb() -> None:
    found = events("Curling: the blue stone strikes the yellow one.")
    assert found == [("hit", "blue_stone_1", "yellow_stone_1")]


def test_the_sense_of_a_particle_is_found_where_it_stands_apart() -> None:
    assert particle_sense("go", "down") == ("topple", {"down": "1"})
    assert particle_sense("go", "over") == ("topple", {})
    assert particle_sense("roll", "along") is None


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        (
            "A scooter, bumped by a taxi and then bumped again by a van, falls over.",
            [("hit", "taxi_1", "scooter_1"), ("hit", "van_1", "scooter_1"), ("topple", "scooter_1")],
        ),
        ("Hit by an apple, Isaac looks up.", [("hit", "apple_1", "isaac_1")]),
        ("A gnome is seen falling off a wall.", [("fall", "gnome_1")]),
        ("The tray he was carrying crashes onto a table.", [("hit", "tray_1", "table_1")]),
        ("A beaker falls off a bench, the beaker then landing in a sink.", [
            ("fall", "beaker_1"), ("enter", "beaker_1")
        ]),
        ("A robot gets wedged against a sofa.", [("hit", "robot_1", "sofa_1")]),
        ("A plank whacks a sawhorse over.", [("hit", "plank_1", "sawhorse_1"), ("topple", "sawhorse_1")]),
        ("Kevin lobs a snowball, catching a scarecrow in the chest.", [
            ("hit", "snowball_1", "scarecrow_1")
        ]),
    ],
)  # fmt: skip
def test_asides_leave_the_main_verb_its_subject(
    prompt: str, expected: list[tuple[str, ...]]
) -> None:
    assert events(prompt) == expected


def test_a_bare_colour_is_a_ball() -> None:
    found = events("Snooker: white into pink, pink into the middle pocket.")
    assert found == [("hit", "white_ball_1", "pink_ball_1"), ("enter", "pink_ball_1")]


def test_who_comes_off_falls() -> None:
    assert ("fall", "rider_1") in events("The horse bucks and the rider comes off.")


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        (
            "The impact of a hammer drives a ball into a log.",
            [("hit", "hammer_1", "ball_1"), ("hit", "ball_1", "log_1")],
        ),
        ("A nudge from the trolley sends a vase over.", [
            ("hit", "trolley_1", "vase_1"), ("topple", "vase_1")
        ]),
        ("A close-up of a domino tipping over.", [("topple", "domino_1")]),
        ("A red car brakes but cannot avoid a van.", [("hit", "red_car_1", "van_1")]),
        ("A cat bats a pen off a desk.", [("hit", "cat_1", "pen_1"), ("fall", "pen_1")]),
        ("A bookcase gets pulled over by a toddler.", [
            ("hit", "toddler_1", "bookcase_1"), ("topple", "bookcase_1")
        ]),
        ("Lorry versus bridge.", [("hit", "lorry_1", "bridge_1")]),
        ("A storm fells a poplar; poplar crushes a shed.", [
            ("topple", "poplar_1"), ("hit", "poplar_1", "shed_1")
        ]),
    ],
)  # fmt: skip
def test_a_noun_may_tell_what_happens(prompt: str, expected: list[tuple[str, ...]]) -> None:
    assert events(prompt) == expected


def test_a_report_leaves_out_the_subject() -> None:
    doc = draft("Truck, 9 m/s. Brakes at 3 s. Stops 2 s later.")
    assert doc.timeline_system is not None and not verify(doc)
    brake, stop = doc.timeline_system.sequence_graph.nodes[1:]
    assert brake.timestamp == 3.0 and stop.constraints[0].value == 2.0
    assert doc.timeline_system.sequence_graph.edges[0].params.speed == 900.0


def test_two_masses_of_two_things_are_one_each() -> None:
    for prompt in (
        "Two lorries, one of 7.5 t and one of 12 t, meet head-on.",
        "Two lorries of 7.5 t and 12 t collide.",
    ):
        doc = draft(prompt)
        masses = [
            a.expected_mass_kg for a in doc.asset_requirement.values() if a.mass_is_prescribed
        ]
        assert sorted(masses) == [7500.0, 12000.0]
        assert ("hit", "lorry_1", "lorry_2") in events(prompt)


def test_a_span_ends_with_an_event_that_has_no_time_of_its_own() -> None:
    doc = draft("A lift falls for 1.1 s, is caught by a hook and comes to rest 0.4 s later.")
    assert not verify(doc)


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("It was the bin that hit the go-kart.", [("hit", "bin_1", "go_kart_1")]),
        ("Not only does the stone miss the guard.", [("miss", "stone_1", "guard_1")]),
        ("A mallet comes down hard on a melon.", [("hit", "mallet_1", "melon_1")]),
    ],
)
def test_roundabout_ways_of_telling_a_hit(prompt: str, expected: list[tuple[str, ...]]) -> None:
    assert events(prompt) == expected
