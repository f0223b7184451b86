"""Sizes, spans and distances in the words people use for them."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.draft.text.quantities import find_amounts
from esg.graph import verify
from esg.graph.models import EsgDocument, NodeEvent


def dimensions(doc: EsgDocument, node: str) -> tuple[float, float, float]:
    asset = doc.asset_requirement[doc.spatial_relation_graph.nodes[node].asset_id]
    return asset.expected_dimensions_cm


def distances(doc: EsgDocument) -> list[tuple[str, str, object]]:
    edges = doc.spatial_relation_graph.edges.binary_relations
    return [(r.from_, r.to, r.distance_cm) for r in edges if r.distance_cm is not None]


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("a second and a half", "time", 1.5),
        ("two and a half metres tall", "length", 250.0),
        ("2 and a half seconds", "time", 2.5),
        ("at least 6 m/s but not more than 8, the", "speed", (600.0, 800.0)),
        ("between t=1 and t=2 the", "time", (1.0, 2.0)),
        ("a quarter turn to the right", "angle", 90.0),
        ("a 500 ml bottle", "volume", 0.5),
        ("at a 45 degree angle with", "angle", 45.0),
        ("20 x 30 x 40 cm", "length", 40.0),
    ],
)
def test_reads_amounts_in_words(text: str, dimension: str, value: object) -> None:
    (amount,) = find_amounts(text)
    assert amount.dimension == dimension
    assert amount.value == pytest.approx(value)


@pytest.mark.parametrize(
    ("prompt", "node", "expected"),
    [
        ("A 20 x 30 x 40 cm crate falls off a shelf.", "crate_1", (20.0, 30.0, 40.0)),
        ("A table measuring 2 m by 1 m holds a vase.", "table_1", (200.0, 100.0, 75.0)),
        ("A crate (20 kg, 60 cm on each side) slides.", "crate_1", (60.0, 60.0, 60.0)),
        ("A marble, 1.6 cm across, rolls.", "marble_1", (1.6, 1.6, 1.6)),
        ("A cube with an edge length of 10 cm slides.", "cube_1", (10.0, 10.0, 10.0)),
        ("A wall 30 cm thick and 2 m high is hit by a car.", "wall_1", (30.0, 400.0, 200.0)),
        ("A dog jumps over a 1.2 m fence.", "fence_1", (250.0, 10.0, 120.0)),
    ],
)
def test_a_length_is_the_side_its_words_say(
    prompt: str, node: str, expected: tuple[float, float, float]
) -> None:
    doc = draft(prompt)
    assert dimensions(doc, node) == pytest.approx(expected)
    assert not [w for w in doc.coverage.warnings if "quantity" in w]
    assert not verify(doc)


def test_a_ramp_is_as_steep_as_stated() -> None:
    length, _, height = dimensions(draft("A ball rolls down a 45-degree ramp."), "ramp_1")
    assert height == pytest.approx(length, rel=1e-3)


def test_volumes_size_vessels_and_are_no_counts() -> None:
    doc = draft("Three 2-litre bottles are knocked over by a ball.")
    bottles = [n for n in doc.spatial_relation_graph.nodes if n.startswith("bottle")]
    assert len(bottles) == 3
    assert dimensions(doc, bottles[0])[2] > 30.0


@pytest.mark.parametrize(
    ("prompt", "pair", "distance_cm"),
    [
        ("Half a metre separates two bottles; a ball hits one.", ("bottle_1", "bottle_2"), 50.0),
        ("Jogger at 3 m/s. Bollard 12 m ahead. He hits it.", ("jogger_1", "bollard_1"), 1200.0),
        ("Eleven metres lie between a ball and a boy.", ("ball_1", "boy_1"), 1100.0),
        ("Two crates, 1 m apart, are dropped.", ("crate_1", "crate_2"), 100.0),
    ],
)
def test_distances_without_a_verb_of_motion(
    prompt: str, pair: tuple[str, str], distance_cm: float
) -> None:
    doc = draft(prompt)
    assert (*pair, distance_cm) in distances(doc)
    assert doc.timeline_system is None or not any(
        c.quantity == "height" for c in doc.timeline_system.sequence_graph.nodes[0].constraints
    )


def test_speeds_of_fragments_and_whose() -> None:
    for prompt, actor in (
        ("Jogger at 3 m/s. He hits a bollard.", "jogger_1"),
        ("A car whose speed is 3 m/s hits a bus whose mass is 12 tons.", "car_1"),
        ("A puck is given a speed of 3 m/s and hits a cone.", "puck_1"),
    ):
        timeline = draft(prompt).timeline_system
        assert timeline is not None
        (edge,) = timeline.sequence_graph.edges
        assert (edge.actor, edge.params.speed, edge.speed_is_prescribed) == (actor, 300.0, True)


def test_each_of_two_has_its_own_speed() -> None:
    timeline = draft("Two trolleys, one at 1 m/s and the other at 3 m/s, collide.").timeline_system
    assert timeline is not None
    assert [e.params.speed for e in timeline.sequence_graph.edges] == [100.0, 300.0]


def test_members_are_counted_from_an_end() -> None:
    left = draft("Five crates stand in a row. A ball hits the second crate from the left.")
    right = draft("Five crates stand in a row. A ball hits the second crate from the right.")
    order = [list(d.spatial_relation_graph.nodes) for d in (left, right)]
    assert order[0].index("second_crate_1") - order[0].index("crate_1") == 1
    assert order[1].index("second_last_crate_1") - order[1].index("crate_1") == 3


def test_the_middle_of_a_stack() -> None:
    doc = draft("There is a stack of three crates. A ball hits the middle crate.")
    assert list(doc.spatial_relation_graph.nodes)[1:4] == ["crate_1", "middle_crate_1", "crate_3"]


def test_a_number_without_a_unit_is_reported() -> None:
    doc = draft("A car going 60 hits a wall.")
    assert any('"60" has no unit' in w for w in doc.coverage.warnings)
    assert doc.timeline_system is not None
    events = {n.event for n in doc.timeline_system.sequence_graph.nodes}
    assert NodeEvent.COLLISION in events


def test_only_a_golf_ball_makes_a_cup_a_hole() -> None:
    doc = draft("A golf ball hits a mug, and an orange rolls into a cup.")
    asset = doc.asset_requirement[doc.spatial_relation_graph.nodes["cup_1"].asset_id]
    assert asset.asset_category == "cup"


def test_wheels_under_a_chair_are_no_objects() -> None:
    doc = draft("An armchair on wheels is pushed into a wall.")
    assert not [n for n in doc.spatial_relation_graph.nodes if "wheel" in n]


def events(prompt: str) -> list[tuple[str, ...]]:
    timeline = draft(prompt).timeline_system
    nodes = timeline.sequence_graph.nodes if timeline is not None else ()
    return [(n.event.value, *n.participants) for n in nodes if n.event is not NodeEvent.SCENE_START]


def test_what_leans_stands_on_its_end_beside_the_wall_and_topples() -> None:
    prompt = "A broom leans on a wall. A boy bumps into the broom, which falls onto a bucket."
    doc = draft(prompt)
    length, _, height = dimensions(doc, "broom_1")
    assert height > 2.0 * length
    assert doc.spatial_relation_graph.nodes["broom_1"].semantic_region == "ground_area_1"
    assert ("Topple", "broom_1") in events(prompt)
    assert ("Fall", "broom_1") not in events(prompt)


def test_what_hangs_on_a_wall_can_fall() -> None:
    assert ("Collision", "picture_1", "sofa_1") in events(
        "A picture hanging on the wall falls onto the sofa."
    )


@pytest.mark.parametrize(
    ("prompt", "masses"),
    [
        ("The red ball weighs 5 g, the green ball 8 g. They collide.", [0.005, 0.008]),
        ("The sphere's radius is 12 cm and its mass 4 kg; it rolls into a post.", [4.0]),
        ("A bowling ball - 7 kg, 22 cm in diameter - strikes ten pins.", [7.0]),
        ("A 2 m long, 30 kg heavy log rolls down a slope.", [30.0]),
    ],
)
def test_masses_in_lists_and_gaps(prompt: str, masses: list[float]) -> None:
    doc = draft(prompt)
    stated = [a.expected_mass_kg for a in doc.asset_requirement.values() if a.mass_is_prescribed]
    assert stated == pytest.approx(masses)
    assert not [w for w in doc.coverage.warnings if "quantity" in w]


def test_what_it_is_compared_with_does_not_act() -> None:
    prompt = "A crate twice as heavy as a 5 kg barrel is pushed into the barrel by a forklift."
    assert ("Collision", "crate_1", "barrel_1") in events(prompt)
    assert ("Collision", "forklift_1", "barrel_1") not in events(prompt)


def test_the_top_one_of_a_stack_named_before_it() -> None:
    found = events("Of four stacked tins, the top one is hit by a rubber ball.")
    assert found == [("Collision", "rubber_ball_1", "top_tin_1")]


def test_a_ring_that_no_ball_goes_for_is_no_hoop() -> None:
    assert events("The copper ring slides into the silver ring.")[0][0] == "Collision"


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("6 feet 2 inches tall", 187.96),
        ("three-quarters of a metre tall", 75.0),
        ("two tenths of a second after", 0.2),
    ],
)
def test_reads_amounts_in_parts(text: str, value: float) -> None:
    (amount,) = find_amounts(text)
    assert amount.value == pytest.approx(value)


def test_the_mass_of_a_load_is_not_the_carriers() -> None:
    doc = draft("A van of 2.3 tonnes loaded with 400 kg of bricks hits a hedge.")
    stated = {
        n: doc.asset_requirement[v.asset_id].expected_mass_kg
        for n, v in doc.spatial_relation_graph.nodes.items()
        if doc.asset_requirement[v.asset_id].mass_is_prescribed
    }
    assert stated["van_1"] == 2300.0
    assert sum(v for n, v in stated.items() if n.startswith("brick")) == pytest.approx(400.0)


def test_another_one_is_one_more_of_the_same() -> None:
    found = events("A curling stone at 1.8 m/s hits another one, which then moves off at 1.5 m/s.")
    assert found == [("Collision", "curling_stone_1", "curling_stone_2")]


def test_plurals_after_a_are_verbs() -> None:
    doc = draft("A heavy oak door swings shut and knocks over a lamp.")
    assert "door_1" in doc.spatial_relation_graph.nodes


def test_the_blue_one_of_three_is_a_member() -> None:
    prompt = "The blue one of three balls rolls into the red one."
    assert events(prompt) == [("Collision", "blue_ball_1", "red_ball_1")]


def test_the_corner_of_a_room_is_no_street_corner() -> None:
    doc = draft("In the corner of the workshop stands a drum. A trolley bumps into it.")
    assert not [n for n in doc.spatial_relation_graph.nodes if n.startswith("corner")]


@pytest.mark.parametrize(
    ("prompt", "thing", "reference", "side"),
    [
        ("A domino as tall as a chair falls onto a box.", "domino_1", "chair", 2),
        ("A wall as high as a house is hit by a truck.", "wall_1", "house", 2),
        ("A log as long as a car rolls into a fence.", "log_1", "car", 0),
    ],
)
def test_a_side_is_compared_and_the_reference_is_not_drawn(
    prompt: str, thing: str, reference: str, side: int
) -> None:
    doc = draft(prompt)
    nodes = doc.spatial_relation_graph.nodes
    required = doc.asset_requirement[nodes[thing].asset_id]
    other = draft(f"A ball hits a {reference}.")
    wanted = other.asset_requirement[
        other.spatial_relation_graph.nodes[f"{reference}_1"].asset_id
    ].expected_dimensions_cm
    assert required.expected_dimensions_cm[side] == pytest.approx(wanted[side], rel=0.01)
    assert required.dimensions_are_prescribed
    assert f"{reference}_1" not in nodes


@pytest.mark.parametrize("words", ["as big as", "the size of", "as large as"])
def test_a_size_keeps_the_shape_of_what_has_it(words: str) -> None:
    doc = draft(f"A ball {words} a car rolls into a wall.")
    nodes = doc.spatial_relation_graph.nodes
    size = doc.asset_requirement[nodes["ball_1"].asset_id].expected_dimensions_cm
    assert size[0] == size[1] == size[2] == pytest.approx((450 * 180 * 145) ** (1 / 3), rel=0.01)
    assert not {"car_1", "road_1"} & nodes.keys()


def test_a_reference_that_is_in_the_scene_stays() -> None:
    doc = draft("A car hits a ball as big as the car.")
    assert "car_1" in doc.spatial_relation_graph.nodes
