"""What a scene shows of adjectives, participles, waits, holders and tools; the rest is owned up to."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EdgeEvent, EsgDocument, Predicate
from tests.draft.told import events, owned, stated


def size_of(doc: EsgDocument, node: str) -> tuple[float, float, float]:
    return doc.asset_requirement[
        doc.spatial_relation_graph.nodes[node].asset_id
    ].expected_dimensions_cm


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A cold spoon lies on a warm plate.", ["cold", "warm"]),
        ("A striped ball hits a dented bucket.", ["striped", "dented"]),
        ("A sneezing clown stands behind a wobbling box.", ["sneezing", "wobbling"]),
        ("A box lies on a moving conveyor belt.", ["moving"]),
        ("A square ball lies beside a tall sphere.", ["square", "tall"]),
        ("An overturned chair stands next to a cracked mirror.", ["cracked"]),
        ("The plane flies upside down over a tray.", ["upside down"]),
        ("A man is asleep on a sofa.", ["asleep"]),
        ("The stove is dirty.", ["dirty"]),
        ("A nurse who looks sad sits on a chair.", ["looks sad"]),
        ("A girl is thirsty.", ["thirsty"]),
        ("A crying baby sits in a chair.", ["crying"]),
    ],
)
def test_a_quality_that_nothing_shows_is_owned_up_to(prompt: str, words: list[str]) -> None:
    assert owned(draft(prompt)) == words


@pytest.mark.parametrize(
    "prompt",
    [
        "A measuring tape lies on a castle wall.",
        "A parked red van stands beside a dark green bin.",
        "A small wooden crate lies on a heavy steel plate.",
        "A running shoe lies next to a frying pan.",
        "A round ball hits a square box.",
        "A ball knocks over three pins. One of the fallen pins rolls to a wall.",
        "A tower is 3 m high and the box beside it is 1 m long.",
        "The box is large.",
    ],
)
def test_a_quality_that_is_shown_or_names_a_kind_is_not(prompt: str) -> None:
    qualities = {"measuring", "castle", "parked", "dark", "small", "heavy", "running", "frying",
                 "round", "square", "fallen", "high", "long", "large"}  # fmt: skip
    assert not qualities & {*owned(draft(prompt))}


def test_a_property_that_was_applied_is_no_unknown_word() -> None:
    doc = draft("The box is large.")
    assert not any("large" in warning for warning in doc.coverage.warnings)
    assert size_of(doc, "box_1")[0] > size_of(draft("The box is red."), "box_1")[0]


@pytest.mark.parametrize(
    ("prompt", "who"),
    [
        ("A rolling can hits a candle.", "can_1"),
        ("A bottle is hit by a rolling log.", "log_1"),
        ("A rolling coin bumps into a box.", "coin_1"),
    ],
)
def test_what_is_called_rolling_rolls(prompt: str, who: str) -> None:
    doc = draft(prompt)
    assert doc.timeline_system is not None
    legs = [e for e in doc.timeline_system.sequence_graph.edges if e.actor == who]
    assert legs[0].params.spin == "roll"
    assert [s.object for s in stated(doc, Predicate.ROLLS)] == [(who,)]


@pytest.mark.parametrize(
    ("prompt", "goes", "waits"),
    [
        ("A car waits for a truck to pass and then drives on.", "truck_1", "car_1"),
        ("A bus waits for a tram to pass, then turns left.", "tram_1", "bus_1"),
        ("A jeep waits for a lorry to overtake it and then drives on.", "lorry_1", "jeep_1"),
    ],
)
def test_who_is_waited_for_acts_and_who_waits_stands(prompt: str, goes: str, waits: str) -> None:
    doc = draft(prompt)
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    first = {e.actor: e for e in reversed(edges)}
    assert first[waits].params.speed == 0.0
    assert first[goes].params.speed != 0.0
    assert ("Miss", goes, waits) in events(prompt)


def test_who_rides_waits_with_what_he_rides() -> None:
    doc = draft(
        "A cyclist on a bike is waiting at the crossing while a tram passes from the right; "
        "as soon as it's gone, he rides straight on."
    )
    assert doc.timeline_system is not None
    edges = [e for e in doc.timeline_system.sequence_graph.edges if e.actor == "bike_1"]
    assert edges[0].params.speed == 0.0
    assert owned(doc) == []


@pytest.mark.parametrize(
    "prompt",
    [
        "A car drives to a gate, waits there and drives on.",
        "A van drives past a bridge and pauses.",
        "A taxi comes to a crossing. The taxi waits while a bus turns left.",
    ],
)
def test_who_waits_on_his_way_is_owned_up_to(prompt: str) -> None:
    assert {"waits", "pauses"} & {*owned(draft(prompt))}


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A drone picks up a parcel and sets it down on a table.", ["picks up", "sets"]),
        ("A robot picks up a box, drives 3 m and puts the box on a table.", ["picks up", "puts"]),
        ("A forklift lifts a pallet and drives to a truck.", ["lifts"]),
        ("An eagle grabs a fish from a rock and carries it to a nest.", ["grabs", "carries"]),
        ("A woman puts a bowl on a table and walks away.", []),
        ("A robot arm picks up a cup and puts it on a shelf.", ["picks up", "puts"]),
        ("Pick up the cup and put it on the plate.", []),
    ],
)
def test_what_is_carried_off_by_nobody_is_owned_up_to(prompt: str, words: list[str]) -> None:
    assert owned(draft(prompt)) == words


def test_what_is_set_beside_a_thing_is_put_there() -> None:
    doc = draft("A robot hits a box and then sets a vase beside the sink.")
    assert [s.text for s in stated(doc, Predicate.NOT_REPRESENTED)] == ["sets"]  # no arm holds it
    assert [s.text for s in stated(doc, Predicate.ENDS_NEAR)] == ["beside the sink"]


@pytest.mark.parametrize(
    ("prompt", "tool", "words"),
    [
        ("A robot wipes a table with a sponge.", "sponge_1", "with a sponge"),
        ("A woman sweeps a bench with a broom.", "broom_1", "with a broom"),
        ("A boy taps a table with a spoon.", "spoon_1", "with a spoon"),
    ],
)
def test_a_tool_is_no_part_of_what_is_acted_on(prompt: str, tool: str, words: str) -> None:
    doc = draft(prompt)
    region = doc.spatial_relation_graph.nodes[tool].semantic_region
    assert region == "ground_area_1"
    assert words in owned(doc)


def test_a_tool_of_a_verb_that_is_lost_is_owned_up_to() -> None:
    assert "With its suction cup" in owned(draft("With its suction cup, a robot picks a box."))
    assert "on the table" not in " ".join(owned(draft("A man hits a table with a vase on it.")))


@pytest.mark.parametrize(
    "prompt",
    [
        "The cylinder is stationary throughout. A cube slides past it.",
        "An old woman with a stick stands next to a bus.",
        "A house with a tree behind it.",
        "A clock hangs above a shelf, with a floor lamp to the right of the shelf.",
        "A crane picks up a beam from the lawn.",
    ],
)
def test_what_the_scene_has_is_not_owned_up_to(prompt: str) -> None:
    lost = " ".join(owned(draft(prompt)))
    assert not any(word in lost for word in ("throughout", "with", "from"))


def test_a_thing_in_hand_does_not_go_along() -> None:
    assert "with a red balloon" in owned(draft("A girl with a red balloon runs to the left."))


def test_a_ball_fits_the_cup_that_holds_or_covers_it() -> None:
    for prompt in ("A small ball lies in a cup.", "A cup stands over a small ball."):
        doc = draft(prompt)
        assert max(size_of(doc, "ball_1")) < min(size_of(doc, "cup_1")[:2])
    assert size_of(draft("A 10 cm ball lies in a cup."), "ball_1")[0] == 10.0
    stack = draft("A ball hits the middle crate of a stack of three crates.")
    sizes = {a.expected_dimensions_cm for a in stack.asset_requirement.values()
             if a.asset_category == "crate"}  # fmt: skip
    assert len(sizes) == 1


def test_a_floor_lamp_stands_as_high_as_one() -> None:
    assert size_of(draft("A floor lamp stands next to a sofa."), "floor_lamp_1")[2] > 120.0


def test_who_pulls_a_door_runs_into_it_and_says_so() -> None:
    doc = draft("A robot pulls a drawer open.")
    assert ("pulls", "it is run into, and not pulled") in [
        (s.text, s.note) for s in stated(doc, Predicate.NOT_REPRESENTED)
    ]
    assert doc.timeline_system is not None
    kinds = {e.event for e in doc.timeline_system.sequence_graph.edges}
    assert EdgeEvent.INERTIAL_CONNECTOR in kinds


@pytest.mark.parametrize(
    ("prompt", "word"),
    [
        ("A car drives down a tree-lined avenue.", "tree-lined"),
        ("A dog runs along a leaf-strewn path.", "leaf-strewn"),
        ("A cart rolls over a rock-strewn field.", "rock-strewn"),
    ],
)
def test_things_that_line_a_way_are_owned_up_to(prompt, word):
    told = [s for s in draft(prompt).statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    assert word in {s.text for s in told}


@pytest.mark.parametrize(
    ("prompt", "word"),
    [
        ("A car races down a dirt road.", "dirt"),
        ("A boy walks along a sandy forest trail.", "sandy"),
        ("A dog runs down an unpaved road.", "unpaved"),
        ("A car drives along a country road.", ""),
        ("A ball rolls over a muddy field.", ""),
    ],
)
def test_roads_that_are_not_of_asphalt_are_owned_up_to(prompt, word):
    told = [s for s in draft(prompt).statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    assert {s.text for s in told} == ({word} if word else set())
