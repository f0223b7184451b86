"""Landings, throws over something, bridges, paces and what is taken off something."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, Predicate
from tests.draft.told import stated


def _speeds(doc: EsgDocument) -> list[tuple[float, float]]:
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    return [e.params.speed for e in edges if isinstance(e.params.speed, tuple)]


def _placed(prompt: str) -> list[tuple[str, ...]]:
    system = draft(prompt).timeline_system
    assert system is not None
    return [n.participants for n in system.sequence_graph.nodes if n.event is NodeEvent.PLACED]


@pytest.mark.parametrize(
    ("prompt", "who"),
    [
        ("An apple rolls off the counter and lands on the floor.", "apple_1"),
        ("A ball is thrown over a wall and lands on the grass.", "ball_1"),
        ("A frisbee flies over a hedge and lands on the lawn.", "frisbee_1"),
    ],
)
def test_what_lands_on_the_ground_stays_there(prompt: str, who: str) -> None:
    (end,) = stated(draft(prompt), Predicate.ENDS_ON)
    assert (end.object, end.target, end.when) == ((who,), ("ground_1",), "end")


def test_what_goes_on_after_landing_does_not_end_there() -> None:
    """A ball that rolls on into a wall is not said to end on the floor."""
    doc = draft("A ball falls from a table, lands on the floor and rolls into a wall.")
    assert not stated(doc, Predicate.ENDS_ON)


@pytest.mark.parametrize(
    "prompt",
    [
        "A stone is thrown over a car.",
        "A ball is thrown over a wall.",
        "An arrow flies over a hut.",
    ],
)
def test_what_is_thrown_over_something_goes_across_it(prompt: str) -> None:
    (way,) = stated(draft(prompt), Predicate.MOVES)
    assert way.direction == "across"


def test_what_is_thrown_is_in_the_air_at_first() -> None:
    (flies,) = stated(draft("An arrow flies over a fence."), Predicate.AIRBORNE)
    assert flies.when == "start"


@pytest.mark.parametrize("thing", ["bridge", "viaduct", "overpass"])
def test_a_bridge_is_crossed_from_end_to_end(thing: str) -> None:
    found = stated(draft(f"A dog runs across a {thing}."), Predicate.MOVES)
    assert {s.direction for s in found} == {"across", "along"}


def test_a_road_is_crossed_from_side_to_side() -> None:
    found = stated(draft("A dog runs across a road."), Predicate.MOVES)
    assert {s.direction for s in found} == {"across"}


@pytest.mark.parametrize(
    "prompt",
    [
        "A cup is picked up and set on a bed.",
        "A kettle is lifted off a stove and set down on a bed.",
        "A pan is picked up and then set on a bed.",
    ],
)
def test_what_is_picked_up_is_set_on_something(prompt: str) -> None:
    (placed,) = _placed(prompt)
    assert placed[1] == "bed_1"


def test_what_is_taken_off_a_shelf_was_on_it() -> None:
    doc = draft("A mug is taken off the shelf and placed next to a kettle.")
    node = doc.spatial_relation_graph.nodes["mug_1"]
    assert node.semantic_region == "shelf_1_surface"
    assert doc.timeline_system is not None
    kinds = [n.event for n in doc.timeline_system.sequence_graph.nodes]
    assert kinds[1:] == [NodeEvent.PICKED_UP, NodeEvent.PLACED]


def test_creeping_is_slower_than_slow_and_racing_is_fast() -> None:
    """A car creeps at a walk, drives slowly at up to 20 km/h, races at 40 km/h or more."""
    creeps, slow, fast = (
        _speeds(draft(f"A car {how} toward a wall."))[0]
        for how in ("creeps", "slowly drives", "races")
    )
    assert creeps[1] < slow[1] < fast[0]
    assert creeps[1] <= 220.0 and slow[1] <= 560.0 and fast[0] >= 1100.0


def test_two_words_of_pace_leave_a_speed_that_counts_as_motion() -> None:
    (speed,) = _speeds(draft("A toy tractor creeps toward a gate and gently nudges it."))
    assert 20.0 < speed[0] < speed[1] < 50.0


@pytest.mark.parametrize(
    "prompt",
    ["A duckling follows a duck.", "A dog chases a cat.", "A bus follows a cyclist."],
)
def test_who_follows_goes_as_fast(prompt: str) -> None:
    doc = draft(prompt)
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    assert len({e.params.speed for e in edges if e.event is EdgeEvent.UNIFORM_MOTION}) == 1


def test_who_stops_next_to_something_is_nearer_than_before_it() -> None:
    gaps = []
    for where in ("next to", "in front of"):
        system = draft(f"A puck slides over the ice and stops {where} a bucket.").timeline_system
        assert system is not None
        gaps += [c.value for n in system.sequence_graph.nodes for c in n.constraints]
    assert gaps == [(10.0, 45.0), (20.0, 120.0)]
