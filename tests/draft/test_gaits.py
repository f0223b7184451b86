"""Legs go at the speeds of their length and gait, and have the time for their way."""

import math

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument, Predicate, TimelineEdge
from esg.units import GRAVITY_MPS2


def going(doc: EsgDocument) -> TimelineEdge:
    assert doc.timeline_system is not None
    return doc.timeline_system.sequence_graph.edges[0]


def hips(doc: EsgDocument) -> float:
    """sqrt(g h) of who goes first [cm/s]."""
    node = doc.spatial_relation_graph.nodes[going(doc).actor]
    height = doc.asset_requirement[node.asset_id].expected_dimensions_cm[2]
    return 100.0 * math.sqrt(GRAVITY_MPS2 * 0.005 * height)


@pytest.mark.parametrize(
    ("prompt", "least", "most"),
    [
        ("A cat walks to a bowl.", 0.3, 0.75),
        ("An elephant walks to a tree.", 0.3, 0.75),
        ("A man walks to a door.", 0.3, 0.75),
        ("A horse trots past a fence.", 0.7, 1.5),
        ("A brown bear is running.", 1.0, 3.0),
        ("A person is running.", 1.0, 3.0),
        ("A hedgehog crosses a road.", 0.3, 2.0),
    ],
)
def test_a_gait_is_a_range_of_froude_numbers(prompt: str, least: float, most: float) -> None:
    doc = draft(prompt)
    speed = going(doc).params.speed
    assert isinstance(speed, tuple)
    assert speed == pytest.approx((least * hips(doc), most * hips(doc)), abs=0.2)


@pytest.mark.parametrize("prompt", ["A car runs into a wall.", "A shark swims past a rock."])
def test_what_has_no_legs_has_no_gait(prompt: str) -> None:
    doc = draft(prompt)
    speed = going(doc).params.speed
    assert isinstance(speed, tuple) and speed[1] >= 800.0
    told = {s.predicate for s in doc.statements or ()}
    assert not told & {Predicate.FASTER_THAN, Predicate.SLOWER_THAN}


def test_a_stated_speed_wins() -> None:
    assert going(draft("A cat walks at 2 m/s.")).params.speed == 200.0


@pytest.mark.parametrize(
    ("prompt", "says", "word"),
    [
        ("A dog runs past a tree.", Predicate.FASTER_THAN, "runs"),
        ("Four greyhounds run out.", Predicate.FASTER_THAN, "run"),
        ("A small cat walks to the right.", Predicate.SLOWER_THAN, "walks"),
    ],
)
def test_walking_and_running_are_measured(prompt: str, says: Predicate, word: str) -> None:
    assert (says, word) in {(s.predicate, s.text) for s in draft(prompt).statements or ()}


@pytest.mark.parametrize(
    "prompt",
    ["A man walks across the road.", "A hedgehog crosses a road.", "A cat walks across a street."],
)
def test_who_crosses_a_road_has_the_time(prompt: str) -> None:
    edge = going(draft(prompt))
    assert isinstance(edge.params.duration, tuple) and isinstance(edge.params.speed, tuple)
    assert edge.params.duration[1] * edge.params.speed[1] > 800.0  # the road's width [cm]


@pytest.mark.parametrize(
    ("prompt", "who", "host"),
    [
        ("A bird is perched on a fence, then it flies off to the tree.", "bird_1", "fence_1"),
        ("A drone sits on a table, then it flies to a tree.", "drone_1", "table_1"),
        ("An owl sits on a branch and then flies to a barn.", "owl_1", "branch_1"),
    ],
)
def test_what_flies_off_something_was_on_it(prompt: str, who: str, host: str) -> None:
    said = [s for s in draft(prompt).statements or () if s.predicate is Predicate.SUPPORTED_BY]
    assert [(s.object, s.target, s.when) for s in said] == [((who,), (host,), "start")]
