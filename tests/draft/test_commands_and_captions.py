"""Commands to a robot and captions of videos: what hands take, who is meant, and how it was filmed."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EdgeEvent, EsgDocument, Predicate, RegionType


def labels(doc: EsgDocument) -> list[str]:
    """What the prompt names and the scene has, with articles and numbers left out."""
    nodes = doc.spatial_relation_graph.nodes.values()
    return sorted({n.label.lower() for n in nodes if n.mentioned and not n.is_structural})


def events(doc: EsgDocument) -> list[str]:
    """Types of the point events that one could see."""
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    return [n.event.value for n in nodes if n.event.value not in ("SceneStart", "Trigger")]


def lost(doc: EsgDocument) -> list[str]:
    """The words that the draft owns up to."""
    said = doc.statements or ()
    return [s.text for s in said if s.predicate is Predicate.NOT_REPRESENTED]


@pytest.mark.parametrize(
    ("prompt", "things", "happens"),
    [
        ("Pick up the tomato sauce and put it in the basket.", ["basket", "tomato sauce"],
         ["PickedUp", "EnterRegion"]),
        ("A girl puts the butter on a plate.", ["butter", "girl", "plate"], ["Placed"]),
        ("Pick up the cup and put the bowl in the box.", ["bowl", "box", "cup"],
         ["PickedUp", "EnterRegion"]),
        ("Grasp the handle of the drawer.", ["drawer"], []),
        ("A person turns on the desk lamp.", ["desk lamp", "person"], []),
        ("A girl turns the radio off.", ["girl", "radio"], []),
        ("A man takes a walk along a road.", ["man"], []),
        ("A cup falls off a table and hits the floor.", ["cup", "table"], ["Fall"]),
    ],
)  # fmt: skip
def test_hands_take_what_is_packed_and_nothing_turns_that_is_switched(prompt, things, happens):
    doc = draft(prompt)
    assert verify(doc) == ()
    assert labels(doc) == things
    assert [e for e in events(doc) if e not in ("Open", "Close")] == happens


def test_what_is_poured_is_no_thing():
    assert "milk" not in labels(draft("A man pours milk into a glass."))


@pytest.mark.parametrize(
    ("prompt", "number"),
    [
        ("A couple walks along the beach.", 2),
        ("A young couple sits on a bench.", 2),
        ("Three couples sit on a bench.", 6),
        ("The family sits on a sofa.", 4),
        ("A crowd stands in the street.", 4),
    ],
)
def test_a_couple_a_family_and_a_crowd_are_persons(prompt, number):
    nodes = draft(prompt).spatial_relation_graph.nodes
    assert sum(name.startswith("person_") for name in nodes) == number


@pytest.mark.parametrize("prompt", ["A couple of balls hit a wall.", "A family car hits a tree."])
def test_a_couple_of_balls_and_a_family_car_are_no_persons(prompt):
    assert not any("person" in name for name in draft(prompt).spatial_relation_graph.nodes)


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("Lima, Peru - 3 May 2019: a dog runs.", ["dog"]),
        ("May, 2017 Oslo, Norway. A dog runs.", ["dog"]),
        ("4k video of a dog running.", ["dog"]),
        ("A view from a drone: a dog runs.", ["dog"]),
        ("Helmet cam of a dog running.", ["dog"]),
        ("A girl stands by a pole wearing a hat.", ["girl", "pole"]),
    ],
)
def test_where_and_how_it_was_filmed_and_what_is_worn_is_not_drawn(prompt, things):
    assert labels(draft(prompt)) == things


def test_a_boat_sails_on_the_water_and_a_participle_is_not_said_of_it():
    doc = draft("A boat sails on a river passing green trees.")
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions[graph.nodes["boat_1"].semantic_region or ""]
    assert region.parent_object == "river_1"
    assert region.region_type is RegionType.SUPPORT_SURFACE
    assert events(doc) == ["Miss"]


@pytest.mark.parametrize("verb", ["rolls", "slides"])
def test_who_rolls_or_slides_a_thing_stands_by_it(verb):
    doc = draft(f"A girl {verb} a ball into a box.")
    edges = doc.spatial_relation_graph.edges.binary_relations
    assert any({r.from_, r.to} == {"girl_1", "ball_1"} for r in edges)
    assert lost(doc) == []


def test_things_side_by_side_are_beside_each_other():
    doc = draft("A white car and a black car drive side by side.")
    edges = doc.spatial_relation_graph.edges.binary_relations
    assert [(r.relation_type.value, r.from_, r.to) for r in edges
            if r.relation_type.value == "adjacent"] == [("adjacent", "white_car_1", "black_car_1")]  # fmt: skip
    assert lost(doc) == []
    pair = draft("Two balls roll side by side and hit a wall.")
    assert {pair.spatial_relation_graph.nodes[f"ball_{k}"].group_pattern for k in (1, 2)} == {"row"}


@pytest.mark.parametrize(
    ("prompt", "says", "value"),
    [
        ("A car brakes hard.", Predicate.FASTER_THAN, 340.0),
        ("A truck brakes sharply and stops.", Predicate.FASTER_THAN, 340.0),
        ("A car brakes gently and stops.", Predicate.SLOWER_THAN, 170.0),
    ],
)
def test_how_hard_something_brakes_is_a_range_that_the_judge_measures(prompt, says, value):
    doc = draft(prompt)
    found = next(s for s in doc.statements or () if s.quantity == "deceleration")
    assert (found.predicate, found.value) == (says, value)
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    rate = next(e.params.acceleration for e in edges if e.event is EdgeEvent.BRAKE)
    assert isinstance(rate, tuple)
    assert rate[0] > value if says is Predicate.FASTER_THAN else rate[1] < value
    assert lost(doc) == []


def test_a_number_says_better_how_fast_what_accelerates_is_in_the_end():
    said = draft("A car accelerates.").statements or ()
    assert [(s.predicate, s.when) for s in said] == [(Predicate.FASTER_THAN, "end")]
    assert not draft("A car accelerates at 2 m/s^2.").statements


def test_back_after_a_hit_is_away_from_what_was_hit():
    said = draft("A ball hits a wall and rolls back.").statements or ()
    assert ("away_from", ("wall_1",)) in [(s.direction, s.target) for s in said]
    assert "back" in lost(draft("A dog runs back."))
