"""One clause, one way: who hovers, who goes around, who is out of sight, who sits behind whom."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.joints import PILLION, SEAT
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, Predicate


def edges(doc: EsgDocument, actor: str) -> list[EdgeEvent]:
    assert doc.timeline_system is not None
    return [e.event for e in doc.timeline_system.sequence_graph.edges if e.actor == actor]


def said(doc: EsgDocument, predicate: Predicate) -> list[tuple[str | None, str]]:
    return [(s.direction, s.when) for s in doc.statements or () if s.predicate is predicate]


@pytest.mark.parametrize(
    ("prompt", "actor"),
    [
        ("A black drone is floating in the air.", "black_drone_1"),
        ("A drone hovers above a table.", "drone_1"),
        ("A bee hovers near a flower.", "bee_1"),
    ],
)
def test_what_hovers_holds_its_height_and_goes_nowhere(prompt: str, actor: str) -> None:
    """State that it is in the air; its segment has no speed, and nothing asks that it moves."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    (edge,) = doc.timeline_system.sequence_graph.edges
    assert (edge.actor, edge.params.speed) == (actor, 0.0)
    assert said(doc, Predicate.AIRBORNE) and not said(doc, Predicate.MOVES)


def test_what_hovers_first_moves_on_after_that() -> None:
    """Hold the height until an event, and go on from there."""
    doc = draft("A drone hovers 3 m above the ground, then descends.")
    assert edges(doc, "drone_1") == [EdgeEvent.UNIFORM_MOTION] * 2
    assert said(doc, Predicate.MOVES)[0][0] == "down"


@pytest.mark.parametrize(
    ("prompt", "actor"),
    [
        ("A dog runs around a tree.", "dog_1"),
        ("A drone orbits a tower.", "drone_1"),
        ("A horse trots around a barrel and stops.", "horse_1"),
    ],
)
def test_around_something_is_a_bend(prompt: str, actor: str) -> None:
    """Turn by most of a circle; the way holds throughout."""
    doc = draft(prompt)
    assert EdgeEvent.TURN in edges(doc, actor)
    assert ("around", "throughout") in said(doc, Predicate.MOVES)


@pytest.mark.parametrize(
    "prompt", ["A boy walks around the park.", "A car drives around the corner."]
)
def test_around_a_place_is_no_bend(prompt: str) -> None:
    """Own up to what has no middle to go around."""
    doc = draft(prompt)
    assert all(EdgeEvent.TURN not in edges(doc, a) for a in ("boy_1", "car_1"))
    assert said(doc, Predicate.NOT_REPRESENTED)


@pytest.mark.parametrize(
    ("prompt", "gone", "does"),
    [
        ("A man drives a car past a bench.", "man_1", "car_1"),
        ("A man in a car drives past a bench.", "man_1", "car_1"),
        ("A driver in a red car brakes.", "driver_1", "red_car_1"),
    ],
)
def test_who_is_in_a_closed_vehicle_is_out_of_sight(prompt: str, gone: str, does: str) -> None:
    """Draw the vehicle only, say so, and let it do what the driver is told to do."""
    doc = draft(prompt)
    assert gone not in doc.spatial_relation_graph.nodes
    assert edges(doc, does)
    assert any("out of sight" in w for w in doc.coverage.warnings)
    assert not any("not understood" in w for w in doc.coverage.warnings)


@pytest.mark.parametrize(
    ("prompt", "seen"),
    [
        ("A woman drives her car into a wall, then she gets out.", "woman_1"),
        ("A woman drives a tractor across a field.", "woman_1"),
        ("A dog is driving a car.", "dog_1"),
        ("Two women in a van pass a bus.", "woman_1"),
    ],
)
def test_who_may_be_seen_is_drawn(prompt: str, seen: str) -> None:
    """Keep who gets out, who sits in the open, and who surprises."""
    assert seen in draft(prompt).spatial_relation_graph.nodes


def test_a_second_rider_sits_behind_the_first() -> None:
    """Give each of two a place of his own."""
    joints = draft("Two people are riding a motorcycle.").spatial_relation_graph.joints
    assert joints is not None
    assert [j.parent_mount for j in joints if j.kind == "fixed"] == [SEAT, PILLION]


def test_water_has_room_for_the_boats_on_it() -> None:
    """Widen water that something is under way on; leave a puddle beside the way."""
    boats = draft("Three boats are slowly moving on water.")
    small = draft("A ball rolls past a puddle.")
    (long, wide, _), (usual, _, _) = (
        next(
            r.expected_dimensions_cm
            for k, r in d.asset_requirement.items()
            if k.startswith("pool") and r.expected_dimensions_cm
        )
        for d in (boats, small)
    )
    assert long > 4 * 400 > usual
    assert wide > 3 * 150


def test_a_hop_is_told_to_its_end() -> None:
    """Measure the way of a leap until it has landed, not until it takes off."""
    doc = draft("A rabbit hops across a lawn.")
    assert doc.timeline_system is not None
    kinds = [n.event for n in doc.timeline_system.sequence_graph.nodes]
    assert NodeEvent.JUMP in kinds
    assert said(doc, Predicate.MOVES) == [("across", "throughout")]


def test_birds_that_walk_go_at_a_walk() -> None:
    """Take the pace from the verb, not from wings."""
    doc = draft("A duck walks into a pond.")
    assert doc.timeline_system is not None
    (edge,) = doc.timeline_system.sequence_graph.edges
    assert isinstance(edge.params.speed, tuple) and edge.params.speed[1] < 150.0


@pytest.mark.parametrize("prompt", ["A boat crosses a lake.", "A toy boat crosses a pond."])
def test_what_crosses_water_goes_over_more_than_half_of_it_and_stays_on_it(prompt: str) -> None:
    """Let it be at rest before the far bank, at a speed of its own."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    (edge,) = doc.timeline_system.sequence_graph.edges
    (wide,) = (
        min(r.expected_dimensions_cm[:2])
        for k, r in doc.asset_requirement.items()
        if k.startswith("pool") and r.expected_dimensions_cm
    )
    assert isinstance(edge.params.speed, tuple) and isinstance(edge.params.duration, tuple)
    assert 0.5 * wide < edge.params.duration[0] * edge.params.speed[1]
    assert edge.params.duration[1] * edge.params.speed[1] < 0.75 * wide


@pytest.mark.parametrize(
    ("prompt", "afloat"),
    [
        ("Five yellow ducks float on a pond.", 5),
        ("A swan floats on the lake.", 1),
        ("A red balloon floats on a pond.", 1),
        ("A bird floats in the air.", 0),
    ],
)
def test_what_floats_on_water_lies_on_it(prompt: str, afloat: int) -> None:
    """Lay on its water what is said to float on it, and keep nothing of it in the air."""
    doc = draft(prompt)
    held = [s.predicate for s in doc.statements or ()]
    assert held.count(Predicate.SUPPORTED_BY) == afloat
    assert (Predicate.AIRBORNE in held) == (afloat == 0)
    assert Predicate.NOT_REPRESENTED not in held


@pytest.mark.parametrize(
    ("prompt", "where"),
    [
        ("Three toy boats float in a bathtub.", "generic"),
        ("A toy truck hits a chair.", "room"),
        ("A truck hits a chair.", "street"),
    ],
)
def test_toys_are_on_no_street(prompt: str, where: str) -> None:
    """Take no street or lake from what is a toy."""
    assert draft(prompt).scene_definition.scene_parameters.environment == where


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball rolls past a candle on a table.",
        "A marble rolls past a cup on a desk.",
        "A puck slides past a glass on a bar counter.",
    ],
)
def test_who_is_past_a_thing_on_a_table_is_on_it_still(prompt: str) -> None:
    """It would roll off and fall, which nothing tells."""
    said = [s for s in draft(prompt).statements or () if s.predicate is Predicate.SUPPORTED_BY]
    assert [s.when for s in said] == ["throughout"]
