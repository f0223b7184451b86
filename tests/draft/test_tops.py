"""What moves about on a table, a shelf or a stage is on it, and stays there."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.dynamics.story.stagecraft import stays_on
from esg.graph.models import EsgDocument, Predicate


def _host(doc: EsgDocument, name: str) -> str | None:
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions.get(graph.nodes[name].semantic_region or "")
    return None if region is None else region.parent_object


def _kept(doc: EsgDocument) -> dict[str, tuple[str, str]]:
    """By mover, on what it is said to be, and when."""
    said = (s for s in doc.statements or () if s.predicate is Predicate.SUPPORTED_BY)
    return {i: (s.target[0], s.when) for s in said for i in s.object}


@pytest.mark.parametrize(
    ("prompt", "mover", "host"),
    [
        ("A toy car drives past a vase on a table.", "toy_car_1", "table_1"),
        ("A ball rolls past a candle that stands on a table.", "ball_1", "table_1"),
        ("A lamp stands on a desk. A toy car drives around the lamp.", "toy_car_1", "desk_1"),
        ("A mug is on the counter. A spoon slides past it.", "spoon_1", "counter_1"),
        ("On a desk, a marble rolls past a stapler.", "marble_1", "desk_1"),
        ("The turtle crawls over the table past the salt shaker.", "turtle_1", "table_1"),
        ("A toy car pushes a block across a desk.", "block_1", "desk_1"),
    ],
)
def test_who_passes_what_stands_on_a_table_stays_on_it(prompt: str, mover: str, host: str) -> None:
    """It drove off the table, or past it on the floor, solved."""
    doc = draft(prompt)
    assert _host(doc, mover) == host
    assert _kept(doc)[mover] in ((host, "throughout"), (host, "end"))


@pytest.mark.parametrize(
    ("prompt", "thing", "host"),
    [
        ("A toy boat slides along a shelf past a globe.", "globe_1", "shelf_1"),
        ("On top of a cabinet, a ball rolls toward a vase.", "vase_1", "cabinet_1"),
        ("A puck slides across a tabletop and stops next to a glass.", "glass_1", "tabletop_1"),
    ],
)
def test_what_is_passed_on_a_table_stands_there(prompt: str, thing: str, host: str) -> None:
    """It stood on the floor beside."""
    assert _host(draft(prompt), thing) == host


@pytest.mark.parametrize(
    ("prompt", "mover"),
    [
        ("A man walks past a vase on a table.", "man_1"),
        ("A ball rolls across the floor past a lamp on a table.", "ball_1"),
        ("An orange rolls off a cart and past a crate.", "crate_1"),
        ("A car drives past a statue on a platform.", "car_1"),
    ],
)
def test_who_is_on_the_floor_stays_there(prompt: str, mover: str) -> None:
    """No person, no car, and nothing that is told to be on the floor gets up on a table."""
    assert _host(draft(prompt), mover) == "ground_1"


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball rolls across a table and falls off the edge.",
        "A marble rolls off a shelf into a bucket.",
        "A cat jumps from a chair onto a table.",
    ],
)
def test_what_is_told_to_leave_may(prompt: str) -> None:
    """It is no longer on what it has left."""
    assert all(when != "throughout" for _, when in _kept(draft(prompt)).values())


@pytest.mark.parametrize(
    ("prompt", "mover"),
    [
        ("A ball rolls across a table, hits a mug and knocks it off the table.", "ball_1"),
        (
            "An orange rolls along a shelf into a vase, and the vase falls off the shelf.",
            "orange_1",
        ),
        ("A puck slides across a desk and pushes a cup off it.", "puck_1"),
    ],
)
def test_what_knocks_something_off_a_table_may_follow_it(prompt: str, mover: str) -> None:
    """Made slow enough to stay on the table, a ball does not get the mug off it."""
    doc = draft(prompt)
    said = [s for s in doc.statements or () if s.predicate is Predicate.SUPPORTED_BY]
    assert any(mover in s.object for s in said)
    assert all(s.when not in ("throughout", "end") for s in said if mover in s.object)
    assert stays_on(doc, mover) is None


@pytest.mark.parametrize(
    "prompt",
    [
        "A toy train drives around a lamp on a table.",
        "A wind-up mouse drives in circles on a table.",
        "A toy car drives past a vase on a table.",
    ],
)
def test_what_goes_about_on_a_table_is_slow(prompt: str) -> None:
    """At 3 m/s it would be over the edge in half a second."""
    system = draft(prompt).timeline_system
    assert system is not None
    speeds = [e.params.speed for e in system.sequence_graph.edges]
    assert all(isinstance(v, tuple) and v[1] <= 60.0 for v in speeds)


@pytest.mark.parametrize(
    "prompt",
    ["A dancer walks across a stage.", "A man walks along a pier.", "A dog runs on a dock."],
)
def test_nobody_creeps_over_a_stage(prompt: str) -> None:
    """It is as large as its scene asks for, whatever a pedestal of that name measures."""
    system = draft(prompt).timeline_system
    assert system is not None
    speed = system.sequence_graph.edges[0].params.speed
    assert isinstance(speed, tuple) and speed[1] > 60.0


@pytest.mark.parametrize(
    "prompt",
    [
        "A robot rolls to the edge of a stage and stops.",
        "A cup slides along a counter and stops at the edge.",
        "A beetle crawls to the edge of a desk.",
    ],
)
def test_ends_at_an_edge_are_owned_up_to(prompt: str) -> None:
    """It stops somewhere on it."""
    lost = [s for s in draft(prompt).statements or ()
            if s.predicate is Predicate.NOT_REPRESENTED]  # fmt: skip
    assert any("edge" in s.text for s in lost)


@pytest.mark.parametrize("prompt", ["A beetle crawls along a shelf.", "An ant walks past a crumb.",
                                    "A ladybug walks across a leaf."])  # fmt: skip
def test_small_animals_are_seen_to_go(prompt: str) -> None:
    """Their own gait is slower than what counts as motion."""
    system = draft(prompt).timeline_system
    assert system is not None
    speed = system.sequence_graph.edges[0].params.speed
    assert isinstance(speed, tuple) and speed[1] >= 20.0
