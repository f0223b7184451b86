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
            "A door swings open and knocks over a vase.",
            [("Open", "door_1"), ("Collision", "door_1", "vase_1"), ("Topple", "vase_1")],
            {"door_1": "Drive", "vase_1": "InertialConnector"},
        ),
        (
            "The gate swings shut and hits the bucket.",
            [("Collision", "gate_1", "bucket_1"), ("Close", "gate_1")],
            {"gate_1": "Drive"},
        ),
        (
            "The swinging boom knocks the lamp over.",
            [("Collision", "swinging_boom_1", "lamp_1"), ("Topple", "lamp_1")],
            {"swinging_boom_1": "Drive", "lamp_1": "InertialConnector"},
        ),
        (
            "A ball hits the open door and it slams shut.",
            [("Collision", "ball_1", "door_1"), ("Close", "door_1")],
            {"ball_1": "Toward", "door_1": "InertialConnector"},
        ),
        (
            "The lid of a treasure chest stands open. A coconut falls on the lid and it slams shut.",
            [("Collision", "coconut_1", "chest_lid_1"), ("Close", "chest_lid_1")],
            {"coconut_1": "Toward", "chest_lid_1": "InertialConnector"},
        ),
        (
            "The first ball of a Newton's cradle is released and the last ball pops out.",
            [("Collision", "first_ball_1", "ball_2"), ("Open", "last_ball_1")],
            {"first_ball_1": "Release", "last_ball_1": "InertialConnector"},
        ),
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
        ("The boom gate goes up.", [("Open", "gate_1")], {"gate_1": "Drive"}),
        ("The boom barrier is raised.", [("Open", "barrier_1")], {"barrier_1": "Drive"}),
        ("The toll barrier comes down.", [("Close", "barrier_1")], {"barrier_1": "Drive"}),
        ("The lid of the chest is lifted.", [("Open", "chest_lid_1")], {"chest_lid_1": "Drive"}),
        ("A drawbridge lowers.", [("Close", "drawbridge_1")], {"drawbridge_1": "Drive"}),
        ("A boom barrier lowers.", [("Close", "barrier_1")], {"barrier_1": "Drive"}),
        ("The lever is pulled.", [("Open", "lever_1")], {"lever_1": "Drive"}),
        ("The ceiling fan turns.", [("Spin", "ceiling_fan_1")], {"ceiling_fan_1": "Drive"}),
        ("A Ferris wheel turns.", [("Spin", "ferris_rotor_1")], {"ferris_rotor_1": "Drive"}),
        ("A trebuchet swings.", [("Swing", "trebuchet_arm_1")], {"trebuchet_arm_1": "Release"}),
        (
            "A spring launcher is released and hits a ball.",
            [("Collision", "spring_launcher_1", "ball_1")],
            {"spring_launcher_1": "Release"},
        ),
        (
            "A ball rolls into a laptop lid and closes it.",
            [("Collision", "ball_1", "laptop_lid_1"), ("Close", "laptop_lid_1")],
            {"ball_1": "Toward", "laptop_lid_1": "InertialConnector"},
        ),
        (
            "A fridge door stands open. A ball hits it.",
            [("Collision", "ball_1", "door_1")],
            {"ball_1": "Toward"},
        ),
        (
            "In a Newton's cradle the first ball is let go and hits the second ball, and the last "
            "ball swings out.",
            [("Collision", "first_ball_1", "second_ball_1"), ("Open", "last_ball_1")],
            {"first_ball_1": "Release", "last_ball_1": "InertialConnector"},
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
        ("The laptop closes.", 105.0),
        ("A laptop is opened.", 0.0),
        ("A ball hits a closed laptop.", 0.0),
        ("A drawbridge lowers.", 80.0),
        ("A trebuchet is released.", -120.0),
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
        ("A parachute opens.", ["A parachute", "opens"]),
    ],
)
def test_what_no_joint_shows_is_owned_up_to(prompt, words):
    assert lost(draft(prompt)) == words


@pytest.mark.parametrize(
    ("prompt", "drawn", "events"),
    [
        (
            "In a Newton's cradle, the first ball is lifted and released; the last ball swings out.",
            {"first_ball_1": 35.0},
            [("Collision", "first_ball_1", "ball_2"), ("Open", "last_ball_1")],
        ),
        (
            "The last ball of a Newton's cradle is released, and the first ball swings out.",
            {"last_ball_1": -35.0},
            [("Collision", "last_ball_1", "ball_4"), ("Open", "first_ball_1")],
        ),
        (
            "In a Newton's cradle the first ball swings down and hits the second one.",
            {"first_ball_1": 35.0},
            [("Collision", "first_ball_1", "second_ball_1")],
        ),
        (
            "A Newton's cradle with five steel balls clicks back and forth.",
            {"steel_ball_1": 35.0},
            [("Swing", "steel_ball_1")],
        ),
    ],
)
def test_the_balls_of_a_cradle_go_by_their_number(prompt, drawn, events):
    doc = draft(prompt)
    assert not verify(doc)
    joints = doc.spatial_relation_graph.joints or ()
    assert len({j.child for j in joints}) == len(joints) == 5
    assert {j.child: j.position for j in joints if j.position} == drawn
    assert told(doc) == events


def test_a_ball_beside_a_cradle_is_none_of_its_own():
    doc = draft("A ball rolls into a Newton's cradle. The ball stops.")
    assert "ball_1" not in {j.child for j in doc.spatial_relation_graph.joints or ()}


@pytest.mark.parametrize(
    ("prompt", "start"),
    [
        ("A crate drops onto one end of a seesaw.", 12.0),
        ("A stone lands on the raised end of a seesaw.", 12.0),
        ("A seesaw tips to the other side when a stone lands on its raised end.", 12.0),
        ("A crate drops onto one end of a seesaw and launches a ball from the other end.", 20.0),
        ("A crate drops onto a seesaw.", 0.0),
    ],
)
def test_a_seesaw_that_is_landed_on_at_one_end_starts_tipped(prompt, start):
    doc = draft(prompt)
    assert not verify(doc)
    assert ("Collision", "seesaw_1") in [(e, a[-1]) for e, *a in told(doc)]
    board = next(j for j in doc.spatial_relation_graph.joints or () if j.child == "seesaw_1")
    assert board.position == start


def test_what_a_seesaw_launches_sits_on_its_low_end_until_the_jolt():
    doc = draft("A crate drops onto one end of a seesaw and launches a ball from the other end.")
    seat = next(j for j in doc.spatial_relation_graph.joints or () if j.child == "ball_1")
    assert (seat.kind, seat.parent, seat.parent_mount) == ("fixed", "seesaw_1", "front end")
    assert seat.break_impulse
    assert "ball_1" not in segments(doc)  # nothing throws it


@pytest.mark.parametrize(
    ("prompt", "child", "falls"),
    [
        ("The rope of a hanging flower pot snaps, and the pot falls down.", "flower_pot_1", True),
        (
            "A wrecking ball's chain snaps and the ball drops to the ground.",
            "wrecking_ball_1",
            True,
        ),
        ("A wrecking ball swings into a car.", "wrecking_ball_1", False),
    ],
)
def test_what_hangs_and_falls_is_held_by_nothing(prompt, child, falls):
    held = next(j for j in draft(prompt).spatial_relation_graph.joints or () if j.child == child)
    assert (held.break_impulse is not None) is falls


def test_what_stands_open_is_open_at_the_start() -> None:
    for prompt in ("The door stands open until a ball hits it.", "A fridge door stands open."):
        (joint,) = draft(prompt).spatial_relation_graph.joints or ()
        assert joint.position is not None and joint.position >= 80.0


@pytest.mark.parametrize(
    ("prompt", "event"),
    [
        ("A laptop that lies shut is opened.", "Open"),
        ("The door stands shut until a ball hits it.", "Collision"),
        ("The lid of a treasure chest lies closed until it is opened.", "Open"),
        ("A fridge door stays closed when a ball hits it.", "Collision"),
    ],
)
def test_what_lies_or_stands_shut_is_shut_at_the_start(prompt: str, event: str) -> None:
    doc = draft(prompt)
    (joint,) = doc.spatial_relation_graph.joints or ()
    assert joint.position == 0.0
    told = [n.event.value for n in doc.timeline_system.sequence_graph.nodes]
    assert told == ["SceneStart", event]
    assert not doc.statements


@pytest.mark.parametrize("words", ["from side to side", "back and forth", "to and fro"])
def test_how_something_swings_is_told_by_its_swings(words: str) -> None:
    doc = draft(f"The pendulum of a grandfather clock swings {words}.")
    swing = next(n for n in doc.timeline_system.sequence_graph.nodes if n.event.value == "Swing")
    assert swing.times == 3
    assert not doc.statements


@pytest.mark.parametrize(
    ("side", "way"), [("from the left", "-X"), ("from the right", "+X"), ("", "+Y")]
)
def test_what_is_to_swing_faces_along_a_blow_out_of_a_stated_side(side: str, way: str) -> None:
    doc = draft(f"A hammer strikes a church bell {side}, then it sways.")
    faces = {r.from_: r.cardinal for r in doc.spatial_relation_graph.edges.binary_relations}
    assert faces["bell_1"] == way
    assert Predicate.STRUCK_ON not in {s.predicate for s in doc.statements or ()}


@pytest.mark.parametrize(
    ("prompt", "event", "door", "whole"),
    [
        ("A man closes the fridge.", "Close", "fridge_door_1", "fridge_1"),
        ("close the microwave", "Close", "microwave_door_1", "microwave_1"),
        ("The oven opens.", "Open", "oven_door_1", "oven_1"),
        ("A girl pushes the cupboard shut.", "Close", "cupboard_door_1", "cupboard_1"),
        ("A person is opening a book.", "Open", "book_cover_1", "book_1"),
        ("A woman opens a box.", "Open", "box_lid_1", "box_1"),
    ],
)
def test_what_has_a_door_opens_and_closes_by_it(
    prompt: str, event: str, door: str, whole: str
) -> None:
    """The thing that is named stays there, and its door turns on it."""
    doc = draft(prompt)
    assert verify(doc) == ()
    assert told(doc) == [(event, door)] and segments(doc) == {door: "Drive"}
    joint = next(j for j in doc.spatial_relation_graph.joints or () if j.child == door)
    assert joint.parent == whole
    assert (joint.position > 0.0) is (event == "Close")


@pytest.mark.parametrize(
    ("prompt", "part", "whole"),
    [
        ("A ball rolls past the box lid.", "box_lid_1", "box_1"),
        ("A marble rolls past the lid of a box.", "box_lid_1", "box_1"),
        ("A tennis ball hits the lid of a cardboard box.", "box_lid_1", "cardboard_box_1"),
        ("A ball rolls past the fridge door.", "door_1", "fridge_1"),
    ],
)
def test_a_part_that_has_a_row_is_what_is_met(prompt: str, part: str, whole: str) -> None:
    """The thing that has it is what it is joined to, and takes part in nothing."""
    doc = draft(prompt)
    assert verify(doc) == ()
    ((_, *bodies),) = [e for e in told(doc) if len(e) > 2]
    assert part in bodies and whole not in bodies
    (joint,) = doc.spatial_relation_graph.joints or ()
    assert (joint.child, joint.parent) == (part, whole)


def test_what_lies_on_the_cover_of_a_book_opens_none() -> None:
    """What `wholes.csv` lists is a place on the thing."""
    assert not draft("A mouse sits on the cover of a book.").spatial_relation_graph.joints


@pytest.mark.parametrize(
    "prompt",
    [
        "A weight is dropped into the left pan of a balance scale.",
        "An orange falls onto one pan of a balance scale.",
        "The pans of a balance scale are empty. An apple drops into the left pan.",
        "A balance scale stands on the ground. A coin drops into the right pan.",
    ],
)
def test_the_pans_of_a_balance_are_ends_of_its_beam(prompt: str) -> None:
    """No frying pan is drawn, and what lands comes down beside the column."""
    doc = draft(prompt)
    assert verify(doc) == ()
    graph = doc.spatial_relation_graph
    assert not [n for n in graph.nodes if "pan" in n]
    (joint,) = graph.joints or ()
    assert 0.0 < joint.position < 1.0, "level to the eye, and it is known which end is meant"
    (landed,) = [e for e in told(doc) if e[0] == "Collision"]
    assert landed[2] == "balance_scale_1"


def test_a_frying_pan_is_no_part_of_a_balance() -> None:
    doc = draft("A ball rolls past a balance scale and hits a frying pan.")
    assert any("pan" in n for n in doc.spatial_relation_graph.nodes)


def test_what_is_hit_while_it_is_closed_has_no_door_of_its_own() -> None:
    """Nothing tells of a door: a box and a fridge are as closed as ever."""
    for prompt in ("A ball rolls into a fridge.", "A book falls on a box."):
        assert not draft(prompt).spatial_relation_graph.joints


def test_one_door_opens_and_closes_again() -> None:
    doc = draft("A man opens the fridge. Then he closes the fridge.")
    assert told(doc) == [("Open", "fridge_door_1"), ("Close", "fridge_door_1")]
