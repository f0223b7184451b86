"""The paper's ten scenes and paraphrases: objects, events, constraints."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, Role

SUITE = Path(__file__).resolve().parents[2] / "data" / "suites" / "paper.yaml"
PROMPTS = {
    s["id"]: s["prompt"] for s in yaml.safe_load(SUITE.read_text(encoding="utf-8"))["scenes"]
}


def events(doc: EsgDocument) -> list[tuple[str, tuple[str, ...]]]:
    """Point events after the start, triggers left out."""
    assert doc.timeline_system is not None
    nodes = doc.timeline_system.sequence_graph.nodes
    return [
        (n.event.value, n.participants)
        for n in nodes
        if n.event not in (NodeEvent.SCENE_START, NodeEvent.TRIGGER)
    ]


def edge(doc: EsgDocument, event: EdgeEvent, actor: str):
    """The segments of one kind and actor."""
    assert doc.timeline_system is not None
    return [
        e for e in doc.timeline_system.sequence_graph.edges if e.event is event and e.actor == actor
    ]


def point(doc: EsgDocument, event: NodeEvent):
    """The point events of one kind."""
    assert doc.timeline_system is not None
    return [n for n in doc.timeline_system.sequence_graph.nodes if n.event is event]


@pytest.mark.parametrize("name", sorted(PROMPTS))
def test_verifier_accepts(name: str) -> None:
    """Every paper prompt drafts to a document without violations."""
    doc = draft(PROMPTS[name])
    assert not verify(doc)
    assert not [w for w in doc.coverage.warnings if "quantity" in w or "verb" in w]


def test_s1_pins_are_a_group_of_ten_on_a_lane() -> None:
    doc = draft(PROMPTS["S1"])
    pins = [n for n in doc.spatial_relation_graph.nodes.values() if n.group_pattern == "pins"]
    assert len(pins) == 10 and len({p.group for p in pins}) == 1
    assert any(a.asset_category == "bowling_lane" for a in doc.asset_requirement.values())
    assert events(doc) == [("Collision", ("bowling_ball_1", "bowling_pin_1"))]


def test_s3_absolute_time() -> None:
    doc = draft(PROMPTS["S3"])
    hit = point(doc, NodeEvent.COLLISION)[0]
    assert hit.timestamp == 3.0 and hit.time_is_prescribed


def test_s4_mass_throw_and_bottles() -> None:
    doc = draft(PROMPTS["S4"])
    ball = doc.asset_requirement[doc.spatial_relation_graph.nodes["basketball_1"].asset_id]
    assert ball.expected_mass_kg == 10.0 and ball.mass_is_prescribed
    assert edge(doc, EdgeEvent.TOWARD, "basketball_1")[0].params.elevation_deg is not None
    bottles = [n for n in doc.spatial_relation_graph.nodes.values() if n.group == "bottles"]
    assert len(bottles) == 6
    regions = {b.semantic_region for b in bottles}
    assert [doc.spatial_relation_graph.semantic_regions[r].parent_object for r in regions if r] == [
        "picnic_table_1"
    ]


def test_s5_pocket_of_the_table() -> None:
    doc = draft(PROMPTS["S5"])
    enter = point(doc, NodeEvent.ENTER_REGION)[0]
    assert enter.region == "billiard_table_1/bottom left pocket"
    nodes = doc.spatial_relation_graph.nodes
    assert sum(1 for n in nodes.values() if n.group == "billiards") == 4
    assert edge(doc, EdgeEvent.INERTIAL_CONNECTOR, enter.participants[0])


def test_s7_speed_after() -> None:
    doc = draft(PROMPTS["S7"])
    first, second = point(doc, NodeEvent.COLLISION)
    constraint = first.constraints[0]
    assert (constraint.quantity, constraint.object, constraint.value) == (
        "speed_after",
        "ball_b",
        200.0,
    )
    assert second.participants == ("ball_b", "ball_c")
    assert len([n for n in doc.spatial_relation_graph.nodes if n.startswith("ball")]) == 3


def test_s8_brake_to_stop() -> None:
    doc = draft(PROMPTS["S8"])
    drive = edge(doc, EdgeEvent.UNIFORM_MOTION, "black_car_1")[0]
    assert drive.params.speed == 1000.0 and drive.speed_is_prescribed
    stop = point(doc, NodeEvent.STOP)[0]
    assert stop.constraints[0].quantity == "time_to_stop" and stop.constraints[0].value == (
        2.0,
        3.0,
    )
    brake = edge(doc, EdgeEvent.BRAKE, "black_car_1")[0]
    assert brake.to == stop.id and brake.params.damping is not None


def test_s9_turn_brake_hit() -> None:
    doc = draft(PROMPTS["S9"])
    turn = point(doc, NodeEvent.HEADING_REACHED)[0]
    assert (turn.turn_direction, turn.turn_degrees) == ("left", 90.0)
    assert [e for e, _ in events(doc)] == ["HeadingReached", "Collision"]
    assert edge(doc, EdgeEvent.BRAKE, "car_1")[0].to == point(doc, NodeEvent.COLLISION)[0].id


def test_s10_two_cars_in_file() -> None:
    doc = draft(PROMPTS["S10"])
    hit = point(doc, NodeEvent.COLLISION)[0]
    assert hit.participants == ("rear_car_1", "front_car_1")
    since = hit.constraints[0]
    assert since.quantity == "time_since" and since.value == 1.0
    assert doc.timeline_system is not None
    trigger = next(n for n in doc.timeline_system.sequence_graph.nodes if n.id == since.since)
    assert trigger.participants == ("front_car_1",)
    for name in ("front_car_1", "rear_car_1"):
        drive = edge(doc, EdgeEvent.UNIFORM_MOTION, name)[0]
        assert drive.params.speed == (500.0, 1000.0) and drive.speed_is_prescribed


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        (
            "The pins are struck by a bowling ball that rolls at them.",
            [("Collision", ("bowling_ball_1", "pin_1"))],
        ),
        (
            "a van drive to a bus and crash into it after 2 seconds",
            [("Collision", ("van_1", "bus_1"))],
        ),
        (
            "A truck smashes into a barrel, making the barrel crash into a wooden bench.",
            [("Collision", ("truck_1", "barrel_1")), ("Collision", ("barrel_1", "wooden_bench_1"))],
        ),
        (
            "With the cue ball, the red ball is hit and goes straight into the top right pocket.",
            [("Collision", ("cue_ball_1", "red_ball_1")), ("EnterRegion", ("red_ball_1",))],
        ),
        (
            "A robot rolls forward, turns right by 45 degrees and bumps into a crate.",
            [("HeadingReached", ("robot_1",)), ("Collision", ("robot_1", "crate_1"))],
        ),
    ],
)
def test_paraphrases(prompt: str, expected: list[tuple[str, tuple[str, ...]]]) -> None:
    """Other verbs, objects and sentence shapes give the same kind of story."""
    doc = draft(prompt)
    assert not verify(doc)
    assert events(doc) == expected


def test_only_suppresses_context_but_not_support() -> None:
    """ "no other objects" drops the road; a billiard table is still needed under billiard balls."""
    with_road = draft("A car hits a bin.")
    without = draft("A car hits a bin, no other objects.")
    assert "road_1" in with_road.spatial_relation_graph.nodes
    assert "road_1" not in without.spatial_relation_graph.nodes
    assert not without.scene_definition.scene_parameters.allow_supplementary
    pool = draft("Only a cue ball and an eight ball: the cue ball hits the eight ball.")
    assert any(a.asset_category == "billiard_table" for a in pool.asset_requirement.values())


def test_roles() -> None:
    """What is hit is passive; what drives is active along its heading."""
    doc = draft(PROMPTS["S6"])
    assert doc.timeline_system is not None
    actors = doc.timeline_system.actors
    assert actors["car_1"].role is Role.ACTIVE
    assert actors["trashbin_1"].role is Role.PASSIVE
