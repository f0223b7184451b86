"""Climbing: who goes along the surface of what, and what of it is owned up to."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument, Predicate


def courses(doc: EsgDocument) -> list[str]:
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    return [f"{e.actor} {e.params.climbs} {e.target}" for e in edges if e.params.climbs]


def said(doc: EsgDocument, says: str) -> list[tuple[str, str | None]]:
    found = (s for s in doc.statements or () if s.predicate is Predicate(says))
    return [(s.text, s.direction) for s in found]


@pytest.mark.parametrize(
    ("prompt", "course", "words"),
    [
        ("A boy climbs a ladder.", "boy_1 up ladder_1", ("climbs a ladder", "up")),
        ("A squirrel runs up the trunk of a tree.", "squirrel_1 up tree_1",
         ("runs up the trunk of a tree", "up")),
        ("A spider crawls up the wall.", "spider_1 up wall_1", ("crawls up the wall", "up")),
        ("A firefighter descends a ladder.", "firefighter_1 down ladder_1",
         ("descends a ladder", "down")),
        ("A child climbs down from a tree.", "child_1 down tree_1",
         ("climbs down from a tree", "down")),
        ("A woman runs down the stairs.", "woman_1 down stairs_1",
         ("runs down the stairs", "down")),
        ("A girl climbs over a fence.", "girl_1 over fence_1", ("climbs over a fence", "across")),
        ("A girl climbs onto a box.", "girl_1 onto box_1", ("climbs onto a box", "up")),
        ("A goat climbs a rock.", "goat_1 onto rock_1", ("climbs a rock", "up")),
        ("A man climbs the stairs.", "man_1 onto stairs_1", ("climbs the stairs", "up")),
        ("A monkey climbs a rope.", "monkey_1 up rope_1", ("climbs a rope", "up")),
        ("A girl climbs a hill.", "girl_1 up hill_1", ("climbs a hill", "up")),
    ],
)  # fmt: skip
def test_a_climb_is_a_guide_and_a_statement_of_its_words(prompt, course, words):
    doc = draft(prompt)
    assert courses(doc) == [course]
    assert said(doc, "climbs") == [words]
    assert not said(doc, "not_represented")


@pytest.mark.parametrize(
    "prompt",
    [
        "A boy climbs into a truck.",
        "A girl climbs on a horse.",
        "A man climbs out of a car.",
        "A boy climbs a ladder and walks away.",
        "A boy climbs a ladder next to a tree and falls onto a box.",
        "A man walks to a ladder and climbs it.",
        "The man climbs a ladder and takes down a picture from the wall.",
    ],
)
def test_what_is_no_climb_stays_owned_up_to(prompt):
    doc = draft(prompt)
    assert courses(doc) == []
    assert ("climbs", None) in said(doc, "not_represented")


@pytest.mark.parametrize("prompt", ["A boy wants to climb a tree.", "A cat does not climb a tree."])
def test_what_does_not_happen_is_not_climbed(prompt):
    assert draft(prompt).timeline_system is None


def test_ends_on_what_is_climbed_onto_unless_more_is_told():
    assert said(draft("A robot climbs onto a ledge."), "ends_on") == [("climbs onto a ledge", None)]
    more = draft("A goat climbs onto a table and knocks over a jug.")
    assert courses(more) == ["goat_1 onto table_1"]
    assert said(more, "ends_on") == []


@pytest.mark.parametrize(
    ("prompt", "word"),
    [
        ("A cat climbs carefully up a tree.", "carefully"),
        ("A boy climbs halfway up a tree.", "halfway"),
        ("A cat runs up a tree and down again.", "down"),
        ("A boy climbs a ladder to the top.", "to the top"),
        ("A girl climbs over a fence into a garden.", "into a garden"),
    ],
)
def test_words_beside_a_climb_are_owned_up_to(prompt, word):
    doc = draft(prompt)
    assert courses(doc)
    assert word in [text for text, _ in said(doc, "not_represented")]


def test_a_told_height_is_the_statements_value():
    doc = draft("A man climbs two metres up a pole.")
    assert [s.value for s in doc.statements or () if s.predicate is Predicate.CLIMBS] == [200.0]
    half = draft("A boy climbs halfway up a pole.")
    assert [s.value for s in half.statements or () if s.predicate is Predicate.CLIMBS] == [125.0]


@pytest.mark.parametrize(
    ("prompt", "pushed"),
    [
        ("A boy climbs a ladder and jumps down.", True),
        ("A bear climbs a tree and falls down.", False),
        ("A beetle climbs up a flower pot and falls off.", False),
    ],
)
def test_who_has_climbed_comes_down(prompt, pushed):
    doc = draft(prompt)
    assert doc.timeline_system is not None
    graph = doc.timeline_system.sequence_graph
    assert [n.event.value for n in graph.nodes][1:] == ["Trigger", "Fall"]
    assert (graph.edges[-1].params.speed is not None) is pushed
    assert not said(doc, "not_represented")


def test_counted_steps_are_one_flight():
    doc = draft("A man walks up three steps.")
    assert [n for n in doc.spatial_relation_graph.nodes if n.startswith("step")] == ["steps_1"]
    asset = doc.spatial_relation_graph.nodes["steps_1"].asset_id
    assert doc.asset_requirement[asset].expected_dimensions_cm[2] == 51.0
    paces = draft("Toddler walks three wobbly steps from the couch to his dad.")
    assert "steps_1" not in courses(paces)


@pytest.mark.parametrize(
    "prompt", ["A dog slides down the hillside.", "A boulder rolls down the mountainside."]
)
def test_a_hillside_is_a_slope_where_something_goes_down_it(prompt):
    doc = draft(prompt)
    ways = [s for s in doc.statements or () if s.predicate is Predicate.MOVES]
    assert [(s.direction, len(s.target)) for s in ways] == [("down", 1)]
    assert "ground_1" not in ways[0].target


def test_a_hillside_where_something_is_is_the_ground():
    doc = draft("A house stands on a hillside.")
    assert [*doc.spatial_relation_graph.nodes] == ["ground_1", "house_1"]


@pytest.mark.parametrize(
    "prompt",
    [
        "A car rolls down a hill into a garage.",
        "A cart rolls into a barn.",
        "A sledge slides into a cave.",
    ],
)
def test_into_an_open_building_is_no_hit_of_it(prompt):
    assert any(text.startswith("into") for text, _ in said(draft(prompt), "not_represented"))


def test_a_crash_into_a_garage_is_a_hit():
    assert not said(draft("A car crashes into a garage."), "not_represented")


def test_the_trunk_is_as_long_as_who_climbs_asks_for():
    def height(prompt: str) -> float:
        doc = draft(prompt)
        node = doc.spatial_relation_graph.nodes["tree_1"].asset_id
        return doc.asset_requirement[node].expected_dimensions_cm[2]

    assert height("A bear climbs a tree.") > height("A squirrel climbs a tree.")
