"""What opens, closes, swings and is let go: events of joints, and what brings them about."""

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Predicate


def told(doc: EsgDocument) -> list[tuple[str, ...]]:
    assert doc.timeline_system is not None
    nodes = doc.timeline_system.sequence_graph.nodes
    return [(n.event.value, *n.participants) for n in nodes if n.event.value != "SceneStart"]


def segments(doc: EsgDocument) -> dict[str, str]:
    assert doc.timeline_system is not None
    return {e.actor: e.event.value for e in doc.timeline_system.sequence_graph.edges}


def lost(doc: EsgDocument) -> list[str]:
    said = doc.statements or ()
    return [s.text for s in said if s.predicate is Predicate.NOT_REPRESENTED]


@pytest.mark.parametrize(
    ("prompt", "events", "moved"),
    [
        ("A wooden door swings open.", [("Open", "door_1")], {"door_1": "Drive"}),
        ("The gate slowly opens.", [("Open", "gate_1")], {"gate_1": "Drive"}),
        ("An open door slams shut.", [("Close", "door_1")], {"door_1": "Drive"}),
        ("The drawer slides open.", [("Open", "drawer_1")], {"drawer_1": "Drive"}),
        (
            "A ball pushes the door open.",
            [("Collision", "ball_1", "door_1"), ("Open", "door_1")],
            {"ball_1": "Toward", "door_1": "InertialConnector"},
        ),
        (
            "A cart rolls into a gate and knocks it open.",
            [("Collision", "cart_1", "gate_1"), ("Open", "gate_1")],
            {"cart_1": "UniformMotion", "gate_1": "InertialConnector"},
        ),
        (
            "The gate is pushed open by a truck.",
            [("Collision", "truck_1", "gate_1"), ("Open", "gate_1")],
            {"truck_1": "UniformMotion", "gate_1": "InertialConnector"},
        ),
        ("A pendulum swings.", [("Swing", "pendulum_1")], {"pendulum_1": "Release"}),
        (
            "A wrecking ball swings into a car.",
            [("Collision", "wrecking_ball_1", "car_1")],
            {"wrecking_ball_1": "Release"},
        ),
        (
            "The crane's wrecking ball smashes into a van.",
            [("Collision", "wrecking_ball_1", "van_1")],
            {"wrecking_ball_1": "Release"},
        ),
        (
            "A football hits a punching bag and makes it sway.",
            [("Collision", "football_1", "punching_bag_1"), ("Swing", "punching_bag_1")],
            {"football_1": "Toward", "punching_bag_1": "InertialConnector"},
        ),
    ],
)
def test_it_is_told_by_its_joint(prompt, events, moved):
    doc = draft(prompt)
    assert told(doc) == events
    assert segments(doc) == moved
    assert not verify(doc)


def start_of(doc: EsgDocument) -> float:
    (joint,) = doc.spatial_relation_graph.joints or ()
    return joint.position


@pytest.mark.parametrize(
    ("prompt", "degrees"),
    [
        ("A pendulum is released at 40 degrees and hits a crate.", 40.0),
        ("A pendulum is released and hits a crate.", 50.0),
        ("A ball hits a pendulum.", 0.0),
        ("A ball rolls into an open door.", 80.0),
        ("A ball rolls into a half-open door.", 40.0),
        ("The door closes.", 80.0),
        ("The door opens.", 0.0),
    ],
)
def test_a_joint_starts_where_its_events_need_it(prompt, degrees):
    assert start_of(draft(prompt)) == degrees


def test_back_and_forth_is_more_than_once():
    doc = draft("A pendulum swings back and forth.")
    assert doc.timeline_system is not None
    assert doc.timeline_system.sequence_graph.nodes[-1].times == 3
    assert lost(doc) == []
    again = draft("The pendulum swings five times.")
    assert again.timeline_system is not None
    assert again.timeline_system.sequence_graph.nodes[-1].times == 5


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A man opens the door.", ["opens"]),
        ("A man opens his umbrella.", ["opens"]),
        ("A crane swings.", ["swings"]),
        ("A parachute opens.", ["opens"]),
    ],
)
def test_what_no_joint_shows_is_owned_up_to(prompt, words):
    assert lost(draft(prompt)) == words
