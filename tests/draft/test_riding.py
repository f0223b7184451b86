"""Who rides: on what he rides and joined to it, or one body that shows both."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.joints import FOOT, SEAT
from esg.graph.models import EsgDocument, NodeEvent, Predicate


def clean(prompt: str) -> EsgDocument:
    doc = draft(prompt)
    assert verify(doc) == ()
    return doc


def support_of(doc: EsgDocument, node: str) -> str:
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions.get(graph.nodes[node].semantic_region or "")
    return "" if region is None else region.parent_object


@pytest.mark.parametrize(
    ("prompt", "rider", "mount"),
    [
        ("A girl rides a skateboard along the sidewalk.", "girl_1", "skateboard_1"),
        ("A man is riding a horse along the beach.", "man_1", "horse_1"),
        ("A monkey rides a bicycle.", "monkey_1", "bicycle_1"),
        ("A man on a motorcycle crashes into a wall.", "man_1", "motorcycle_1"),
        ("A boy riding a scooter crashes into a bench.", "boy_1", "scooter_1"),
    ],
)
def test_a_rider_is_on_what_he_rides_and_held_there(prompt: str, rider: str, mount: str) -> None:
    doc = clean(prompt)
    assert support_of(doc, rider) == mount
    joints = doc.spatial_relation_graph.joints
    assert joints is not None and len(joints) == 1
    joint = joints[0]
    assert (joint.kind, joint.child, joint.parent) == ("fixed", rider, mount)
    assert (joint.child_mount, joint.parent_mount) == (FOOT, SEAT)
    assert joint.break_impulse
    assert all(
        {r.from_, r.to} != {rider, mount} for r in doc.spatial_relation_graph.edges.binary_relations
    )
    assert doc.timeline_system is not None
    assert {e.actor for e in doc.timeline_system.sequence_graph.edges} == {mount}


def test_several_ride_one_sled_down() -> None:
    doc = clean("Two children ride a sled down the hill.")
    assert support_of(doc, "sled_1") == "hill_1"
    assert {support_of(doc, f"child_{n}") for n in (1, 2)} == {"sled_1"}
    assert len(doc.spatial_relation_graph.joints or ()) == 2


def test_what_is_told_of_a_rider_is_done_by_what_he_rides() -> None:
    doc = clean("A girl on a skateboard passes a bench on the sidewalk.")
    assert doc.timeline_system is not None
    (passed,) = (n for n in doc.timeline_system.sequence_graph.nodes if n.event is NodeEvent.MISS)
    assert passed.participants == ("skateboard_1", "bench_1")


def test_who_falls_off_is_not_held() -> None:
    doc = clean("A cyclist falls off his bicycle.")
    assert support_of(doc, "cyclist_1") == "bicycle_1"
    assert doc.spatial_relation_graph.joints is None


@pytest.mark.parametrize(
    ("prompt", "node", "builder"),
    [
        ("A skateboarder rolls down a ramp.", "skateboarder_1", "skateboarder on a skateboard"),
        ("A cyclist hits a parked car.", "cyclist_1", "cyclist on a bicycle"),
        ("A jockey gallops across the field.", "jockey_1", "rider on a horse"),
        ("A biker brakes and hits a dog.", "biker_1", "motorcyclist on a motorcycle"),
        ("A surfer rides along the shore.", "surfer_1", "surfer on a surfboard"),
    ],
)
def test_nouns_of_riders_bring_what_is_ridden(prompt: str, node: str, builder: str) -> None:
    doc = clean(prompt)
    asked = doc.asset_requirement[doc.spatial_relation_graph.nodes[node].asset_id]
    assert builder in asked.asset_description
    assert doc.spatial_relation_graph.joints is None


def test_a_cyclist_on_a_bicycle_of_his_own_has_no_second_one() -> None:
    doc = clean("A cyclist on a red bicycle hits a cone.")
    asked = doc.asset_requirement[doc.spatial_relation_graph.nodes["cyclist_1"].asset_id]
    assert "on a bicycle" not in asked.asset_description
    assert support_of(doc, "cyclist_1") == "red_bicycle_1"


def test_along_a_pavement_is_on_it() -> None:
    doc = clean("A girl rides a skateboard along the sidewalk.")
    assert not [
        r
        for r in doc.spatial_relation_graph.edges.binary_relations
        if "sidewalk_1" in (r.from_, r.to) and r.relation_type.value == "near"
    ]


def test_a_bicycle_in_a_park_needs_no_road() -> None:
    doc = clean("A man rides a bicycle through the park.")
    assert not any(n.startswith("road") for n in doc.spatial_relation_graph.nodes)
    ways = [s for s in doc.statements or () if s.predicate is Predicate.MOVES]
    assert [(s.direction, s.target) for s in ways] == [("across", ("ground_1",))]
    toy = clean("A child rides a tricycle into a sandbox.")
    assert not any(n.startswith("road") for n in toy.spatial_relation_graph.nodes)
    on_a_road = clean("A man rides a bicycle and hits a cone.")
    assert any(n.startswith("road") for n in on_a_road.spatial_relation_graph.nodes)


@pytest.mark.parametrize(
    ("prompt", "node", "category"),
    [
        ("A driver swerves around obstacles in a high-speed chase.", "driver_1", "car"),
        ("A motorist brakes and hits a deer.", "motorist_1", "car"),
        ("A truck driver brakes and hits a wall.", "truck_driver_1", "truck"),
        ("A driver gets out of his car and walks to a bench.", "driver_1", "person"),
        ("A bus driver stands beside a bench.", "bus_driver_1", "person"),
        ("A rider gallops across the field.", "rider_1", "horse_rider"),
        ("A rider brakes and hits a wall.", "rider_1", "motorcyclist"),
        ("The donkey throws its rider.", "rider_1", "person"),
    ],
)
def test_nobody_drives_on_foot(prompt: str, node: str, category: str) -> None:
    doc = clean(prompt)
    name = node if node in doc.spatial_relation_graph.nodes else "driver_1"
    asked = doc.asset_requirement[doc.spatial_relation_graph.nodes[name].asset_id]
    assert asked.asset_category == category


@pytest.mark.parametrize(
    ("prompt", "rider", "bearer", "at"),
    [
        ("A clown stands on a turntable that spins.", "clown_1", "turntable_1", None),
        ("Two children stand on a merry-go-round that turns.", "child_2", "merry_go_round_1", None),
        ("A girl sits on a swing. The swing swings.", "girl_1", "swing_1", SEAT),
        ("A tractor pulls a trailer. A goat stands on the trailer.", "goat_1", "trailer_1", None),
    ],
)
def test_who_is_on_what_moves_keeps_hold_of_it(
    prompt: str, rider: str, bearer: str, at: str | None
) -> None:
    doc = clean(prompt)
    held = [j for j in doc.spatial_relation_graph.joints or () if j.child == rider]
    assert [(j.kind, j.parent, j.parent_mount) for j in held] == [("fixed", bearer, at)]
    stays = [s for s in doc.statements or () if s.predicate is Predicate.SUPPORTED_BY]
    assert any(s.object == (rider,) and s.target == (bearer,) for s in stays)


def test_what_stands_on_what_moves_is_measured_to_stay_and_to_stay_upright() -> None:
    doc = clean("A cart with a statue standing on it rolls down the street.")
    said = {(s.predicate, s.object) for s in doc.statements or ()}
    assert (Predicate.SUPPORTED_BY, ("statue_1",)) in said
    assert (Predicate.STAYS_UPRIGHT, ("statue_1",)) in said


def test_of_what_is_told_to_fall_off_nothing_is_asked_but_that() -> None:
    doc = clean("A skateboard with a helmet lying on it rolls into the curb, and the helmet slides "
                "off onto the sidewalk.")  # fmt: skip
    assert not any(s.predicate is Predicate.SUPPORTED_BY for s in doc.statements or ())


def test_what_lies_on_what_is_stopped_comes_off_by_that() -> None:
    doc = clean("A cart with a box on it hits a wall and the box slides off.")
    assert doc.timeline_system is not None
    own = [e for e in doc.timeline_system.sequence_graph.edges if e.actor == "box_1"]
    assert [e.event.value for e in own] == ["InertialConnector"]


@pytest.mark.parametrize(
    ("prompt", "carried"),
    [
        ("A man on a horse and a boy on a bike ride along a fence.",
         {"man_1": "horse_1", "boy_1": "bike_1"}),
        ("A dog in a basket and a cat on a cushion watch a ball roll past.",
         {"dog_1": "basket_1", "cat_1": "cushion_1"}),
        ("A girl in a boat and a boy on a raft float down a river.",
         {"girl_1": "boat_1", "boy_1": "raft_1"}),
        ("A woman in a car and a woman on a motorcycle race down the road.",
         {"woman_2": "motorcycle_1"}),
    ],
)  # fmt: skip
def test_each_of_two_has_a_place_of_their_own(prompt: str, carried: dict[str, str]) -> None:
    """The boat was on the raft, and a car on the motorcycle."""
    graph = clean(prompt).spatial_relation_graph
    places = {name: r.parent_object for name, r in graph.semantic_regions.items()}
    on = {n: places.get(node.semantic_region or "") for n, node in graph.nodes.items()}
    assert {name: on[name] for name in carried} == carried
    assert not {on.get(place) for place in carried.values()} & {*carried.values()}


@pytest.mark.parametrize(
    "prompt",
    [
        "A child slides down a snowy hill on a sledge.",
        "A boy rolls down a ramp on a skateboard.",
        "A man goes along a road on a horse.",
    ],
)
def test_no_way_stands_on_what_goes_along_it(prompt: str) -> None:
    """The hill stood on the sledge; who slides is on it, or that is owned up to."""
    graph = clean(prompt).spatial_relation_graph
    places = {name: r.parent_object for name, r in graph.semantic_regions.items()}
    on = {n: places.get(node.semantic_region or "") for n, node in graph.nodes.items()}
    assert {on.get(n) for n in ("hill_1", "ramp_1", "road_1")} <= {None, "ground_1"}
