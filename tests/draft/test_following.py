"""What is told next happens next, and what nothing sets in motion is owned up to."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, NodeEvent, Predicate


def _wait(doc: EsgDocument, who: str) -> str:
    """The event that an actor stands still until, or ""."""
    assert verify(doc) == ()
    assert doc.timeline_system is not None
    graph = doc.timeline_system.sequence_graph
    first = next(e for e in graph.edges if e.actor == who)
    if first.params.speed != 0.0 or first.params.elevation_deg is not None:
        return ""
    trigger = next(n for n in graph.nodes if n.id == first.to)
    return next((c.since or "" for c in trigger.constraints if c.quantity == "time_since"), "")


@pytest.mark.parametrize(
    ("prompt", "who", "event"),
    [
        ("A bus stops at a kerb and a woman gets off.", "woman_1", "bus_1_stop"),
        ("A pear fell off the table. The dog ran after it.", "dog_1", "pear_1_fall"),
        ("A cow tips over a bucket and the farmer runs away.", "farmer_1", "bucket_1_topple"),
        (
            "A sledge hits a post and a lamp falls off the roof.",
            "lamp_1",
            "sledge_1_post_1_collision",
        ),
        (
            "A cook puts a jar on a shelf, turns around and bumps into a waiter.",
            "cook_1",
            "jar_1_shelf_1_placed",
        ),
    ],
)
def test_what_is_told_next_happens_next(prompt: str, who: str, event: str) -> None:
    """Let who sets off in the next clause wait for the event of the one before."""
    assert _wait(draft(prompt), who) == event


@pytest.mark.parametrize(
    ("prompt", "who"),
    [
        ("While a boy pushes a crate, a girl runs ahead.", "girl_1"),
        ("A crate falls off a truck and the car behind brakes.", "rear_car_1"),
        ("A vase falls off a table. A man is walking by.", "man_1"),
        ("A vase falls off a table. A man walks by.", "man_1"),
        ("One runner falls and the other runner runs on.", "runner_2"),
    ],
)
def test_what_goes_on_at_the_same_time_does_not_wait(prompt: str, who: str) -> None:
    """Tell no order of the background, and let nobody stand still who was on the move."""
    assert _wait(draft(prompt), who) == ""


@pytest.mark.parametrize(
    ("prompt", "words", "who"),
    [
        ("A waiter trips over a cable, and the cup on the tray falls.", "falls", {"cup_1"}),
        ("A maid pulls the tablecloth, and the plate slides off the table.", "slides", {"plate_1"}),
        ("A porter stumbles and the suitcase rolls into a bench.", "rolls", {"suitcase_1"}),
        (
            "A waitress carries a tray with two cups and bumps into a chair, and the cups fall.",
            "fall",
            {"cup_1", "cup_2"},
        ),
    ],
)
def test_what_nothing_sets_in_motion_is_owned_up_to(prompt: str, words: str, who: set[str]) -> None:
    """Say that it moves by itself, where an act of others is told before."""
    doc = draft(prompt)
    lost = [s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    alone = [s for s in lost if "by itself" in s.note]
    assert [(s.text, {*s.object}) for s in alone] == [(words, who)]


@pytest.mark.parametrize(
    "prompt",
    [
        "A boy takes the stone away, and the wagon on the slope rolls down the slope.",
        "A ball hits a vase, and the vase falls off the shelf.",
        "A vase stands on a shelf. It falls off.",
    ],
)
def test_what_has_a_cause_is_not_owned_up_to(prompt: str) -> None:
    """Leave alone what is hit, what is on a slope, and what no act was told before."""
    assert not [s for s in draft(prompt).statements or () if "by itself" in s.note]


def test_what_is_aimed_at_is_hit_before_it_falls() -> None:
    """Tell the landing of a throw before the fall that it leads to."""
    doc = draft("Two boys throw stones at a kite in a tree until it comes down.")
    assert doc.timeline_system is not None
    told = [n.event for n in doc.timeline_system.sequence_graph.nodes]
    assert told.index(NodeEvent.COLLISION) < told.index(NodeEvent.FALL)


@pytest.mark.parametrize(
    "prompt",
    [
        "A hen crosses the road with chicks following.",
        "A tractor rolls along a track, two dogs trailing behind.",
        "A truck drives down the street, a car following close behind.",
    ],
)
def test_who_follows_goes_behind_whom_the_clause_before_is_about(prompt: str) -> None:
    doc = draft(prompt)
    assert doc.timeline_system is not None
    ahead = doc.timeline_system.sequence_graph.edges[0].actor
    assert ahead == next(iter(n for n in doc.spatial_relation_graph.nodes if n != "ground_1"))
    pairs = doc.spatial_relation_graph.edges.binary_relations
    behind = {r.from_ for r in pairs if r.relation_type.value == "behind" and r.to == ahead}
    assert behind
    assert behind <= {e.actor for e in doc.timeline_system.sequence_graph.edges}


@pytest.mark.parametrize(
    ("prompt", "goes"),
    [
        ("A truck overtakes a cyclist.", ["truck_1", "cyclist_1"]),
        ("A motorcycle overtakes a tractor on a road.", ["motorcycle_1", "tractor_1"]),
        ("A boy outruns a dog.", ["boy_1", "dog_1"]),
        ("A truck overtakes a parked car.", ["truck_1"]),
        ("A truck passes a car.", ["truck_1"]),
    ],
)
def test_who_is_overtaken_goes_the_same_way(prompt, goes):
    timeline = draft(prompt).timeline_system
    assert {e.actor for e in timeline.sequence_graph.edges} == {*goes}
