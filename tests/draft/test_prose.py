"""Strangers' prose: appositions, words that stand for nouns, data sheets, quantities in words."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.draft.text.quantities import find_amounts
from esg.graph import verify
from esg.graph.models import EsgDocument, NodeEvent


def drafted(prompt: str) -> EsgDocument:
    doc = draft(prompt)
    assert not verify(doc), prompt
    return doc


def story(prompt: str) -> list[str]:
    """Point events as short strings, triggers left out."""
    timeline = drafted(prompt).timeline_system
    skip = (NodeEvent.SCENE_START, NodeEvent.TRIGGER)
    nodes = timeline.sequence_graph.nodes if timeline is not None else ()
    return [f"{n.event.value} {' '.join(n.participants)}" for n in nodes if n.event not in skip]


def speeds(prompt: str) -> dict[str, object]:
    """Prescribed speeds [cm/s] by actor."""
    timeline = drafted(prompt).timeline_system
    assert timeline is not None
    edges = timeline.sequence_graph.edges
    return {e.actor: e.params.speed for e in edges if e.speed_is_prescribed}


def gaps(prompt: str) -> list[tuple[set[str], object]]:
    """Distances at the start [cm] by the things they are between."""
    edges = drafted(prompt).spatial_relation_graph.edges.binary_relations
    return [({r.from_, r.to}, r.distance_cm) for r in edges if r.distance_cm is not None]


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A barrel, a blue one, hits a gate.", ["Collision blue_barrel_1 gate_1"]),
        ("Bruno, a dog, runs into a fence.", ["Collision bruno_1 fence_1"]),
        ("A rolling barrel hits a standing one.", ["Collision barrel_1 barrel_2"]),
        ("A domino falls over and so does a second one.",
         ["Topple domino_1", "Topple second_domino_1"]),
        ("Two trains approach each other and neither train brakes; they collide.",
         ["Collision train_1 train_2"]),
        ("The robot drives left and then right.",
         ["HeadingReached robot_1", "HeadingReached robot_1"]),
        ("The tram's bell rings. There's a cart on the track, and the tram hits it.",
         ["Collision tram_1 cart_1"]),
        ("A cart that is rolling hits a box.", ["Collision cart_1 box_1"]),
        ("A collision between a sledge and a tree.", ["Collision sledge_1 tree_1"]),
        ("Impact of a drone on a mast.", ["Collision drone_1 mast_1"]),
        ("Body A is a rubber ball. Body B is a brick. A strikes B.", ["Collision ball_a brick_b"]),
        ("A hailstone falls on the windscreen.", ["Collision hailstone_1 windscreen_1"]),
        ("The dog gives the cart a shove.", ["Collision dog_1 cart_1"]),
        ("A tin gets a knock from a trolley.", ["Collision trolley_1 tin_1"]),
        ("What the puck does is hit the post.", ["Collision puck_1 post_1"]),
        ("The ball leaves the pin standing.", ["Miss ball_1 pin_1"]),
        ("A bicycle knocks over two cones.",
         ["Collision bicycle_1 cone_1", "Collision bicycle_1 cone_2", "Topple cone_1",
          "Topple cone_2"]),
        ("Car versus wall: a car drives into a wall.", ["Collision car_1 wall_1"]),
        ("The vase that the cat knocked off the shelf hits a stool.",
         ["Collision cat_1 vase_1", "Fall vase_1", "Collision vase_1 stool_1"]),
        ("An iron slides off the table onto a shoe.", ["Fall iron_1", "Collision iron_1 shoe_1"]),
        ("The van brakes and stands still 2 s later.", ["Stop van_1"]),
        ("A cart rolls on, and the first thing it hits is a bollard.",
         ["Collision cart_1 bollard_1"]),
        ("The tower is brought down by a ball.", ["Collision ball_1 tower_1", "Topple tower_1"]),
        ("The van it rams is parked. A bus drives up.", []),
        ("Two trams head for each other and meet.", ["Collision tram_1 tram_2"]),
        ("A boy runs past one bench and bumps into the next.",
         ["Miss boy_1 bench_1", "Collision boy_1 bench_2"]),
    ],
)  # fmt: skip
def test_reads_what_stands_for_something_else(prompt: str, expected: list[str]) -> None:
    """Appositions name one thing, "one" a further one, and nouns of events what happens."""
    got = story(prompt)
    assert [g.replace("rubber_", "") for g in got] == expected


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A ball, a box and a cone stand on a table, and the ball hits the cone.",
         ["Collision ball_1 cone_1"]),
        ("A dog, a cat and a horse run; the dog hits the cat.", ["Collision dog_1 cat_1"]),
        ("The impact of the hammer sends the nail into the board.",
         ["Collision hammer_1 nail_1", "Collision nail_1 board_1"]),
    ],
)  # fmt: skip
def test_lists_are_no_appositions(prompt: str, expected: list[str]) -> None:
    assert story(prompt) == expected


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("The tram does 36 km/h and hits a bollard.", {"tram_1": 1000.0}),
        ("Two karts collide, one at 3 and the other at 4 m/s.", {"kart_1": 300.0, "kart_2": 400.0}),
        ("A bus drives at 8 m/s and a tram at 5 m/s, and the bus hits the tram.",
         {"bus_1": 800.0, "tram_1": 500.0}),
        ("Two carts roll; the rear one drives at 4 m/s, the front one at 2, until they touch.",
         {"rear_cart_1": 400.0, "front_cart_1": 200.0}),
    ],
)  # fmt: skip
def test_reads_speeds_told_for_each(prompt: str, expected: dict[str, float]) -> None:
    assert speeds(prompt) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("prompt", "pair", "cm"),
    [
        ("There's a cart about a metre and a half from a post; it rolls into it.",
         {"cart_1", "post_1"}, 150.0),
        ("The gap between the two vans is 12 m; they collide.", {"van_1", "van_2"}, 1200.0),
        ("Two skittles stand 20 cm from each other and a ball hits one.",
         {"skittle_1", "skittle_2"}, 20.0),
        ("Speed: 2 m/s. Distance: 5 m. A cart rolls into a crate.", {"cart_1", "crate_1"}, 500.0),
    ],
)  # fmt: skip
def test_reads_gaps_between_things(prompt: str, pair: set[str], cm: float) -> None:
    assert (pair, cm) in gaps(prompt)


@pytest.mark.parametrize(
    ("prompt", "kind", "seconds"),
    [
        ("A van closes the gap to a bus in 2 s and hits it.", NodeEvent.COLLISION, 2.0),
        ("A pram rolls off and, a good three seconds on, thumps into a post.",
         NodeEvent.COLLISION, 3.0),
        ("Two karts drive at each other; four seconds pass and they collide.",
         NodeEvent.COLLISION, 4.0),
        ("A table carries a robot that falls off it after 2 s.", NodeEvent.FALL, 2.0),
        ("The first domino topples at 1 s, the second at 3 s.", NodeEvent.TOPPLE, 3.0),
    ],
)  # fmt: skip
def test_reads_times_told_apart_from_their_verb(
    prompt: str, kind: NodeEvent, seconds: float
) -> None:
    timeline = drafted(prompt).timeline_system
    assert timeline is not None
    last = [n for n in timeline.sequence_graph.nodes if n.event is kind][-1]
    assert last.time_is_prescribed and last.timestamp == pytest.approx(seconds)


def test_a_way_is_no_gap() -> None:
    """What rolls 3 m away from a box has not started there."""
    assert gaps("A ball rolls 3 m from the box and stops.") == []


@pytest.mark.parametrize(
    ("text", "dimension", "value", "bound"),
    [
        ("at walking pace", "speed", (100.0, 180.0), None),
        ("from chest height", "length", 130.0, None),
        ("through a right angle", "angle", 90.0, None),
        ("1 1/2 m", "length", 150.0, None),
        ("2/3 of a second", "time", 2.0 / 3.0, None),
        ("3ish seconds", "time", 3.0, None),
        ("3 or so seconds", "time", 3.0, None),
        ("5..6 m/s", "speed", (500.0, 600.0), None),
        ("1 000 kg", "mass", 1000.0, None),
        ("12 hundred kg", "mass", 1200.0, None),
        ("5 m/s plus or minus 0.5", "speed", (450.0, 550.0), None),
        ("5 m/s (± 10%)", "speed", (450.0, 550.0), None),
        ("just under 3 s", "time", 3.0, None),
        ("not over 3 m/s", "speed", 300.0, "max"),
        ("2 kg or more", "mass", 2.0, "min"),
        ("3 s at most", "time", 3.0, "max"),
        ("2+ kg", "mass", 2.0, "min"),
        ("a kilo and a half falls", "mass", 1.5, None),
        ("at the 2-second mark", "time", 2.0, None),
        ("over the course of four seconds", "time", 4.0, None),
        ("spins at 60 rpm", "other", 60.0, None),
    ],
)
def test_quantities_in_words(
    text: str, dimension: str, value: float | tuple[float, float], bound: str | None
) -> None:
    """One quantity each, in document units (cm, kg, s, degrees, cm/s)."""
    (found,) = find_amounts(f"it {text} .")
    assert (found.dimension, found.bound) == (dimension, bound)
    assert found.value == pytest.approx(value)


def test_what_has_no_place_is_a_warning() -> None:
    """A rate of turning is understood as a quantity and reported as lost."""
    coverage = draft("A wheel spinning at 60 rpm hits a kerb.").coverage
    assert coverage is not None
    assert any("60 rpm" in w for w in coverage.warnings)


def test_a_domino_that_tips_stands_where_the_others_do() -> None:
    doc = drafted("A domino tips over and knocks down a row of four dominoes on a desk.")
    nodes = doc.spatial_relation_graph.nodes
    regions = {n.semantic_region for name, n in nodes.items() if name.startswith("domino")}
    assert len(nodes) == 7 and regions == {nodes["domino_2"].semantic_region} != {None}


def test_streams_do_not_act() -> None:
    assert story("A jeep fords a stream, which glides past a buoy.") == []


def test_an_event_that_a_sheet_leaves_open_is_no_line_of_it() -> None:
    assert story("Ball: 2 kg, 3 m/s. Box: 3 kg. Event: . The ball hits the box.") == [
        "Collision ball_1 box_1"
    ]


@pytest.mark.slow
def test_a_noun_phrase_may_be_thousands_of_words_long() -> None:
    assert story("A " + "very " * 2500 + "red ball hits a box.") == ["Collision red_ball_1 box_1"]
