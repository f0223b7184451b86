"""Ropes, hitches and springs of a prompt are joints; what they hold hangs, is towed, or comes down."""

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Joint, Predicate


def joints(doc: EsgDocument) -> list[Joint]:
    return list(doc.spatial_relation_graph.joints or ())


def told(doc: EsgDocument) -> list[tuple[str, ...]]:
    assert doc.timeline_system is not None
    nodes = doc.timeline_system.sequence_graph.nodes
    return [(n.event.value, *n.participants) for n in nodes if n.event.value != "SceneStart"]


def lost(doc: EsgDocument) -> list[str]:
    said = doc.statements or ()
    return [s.text for s in said if s.predicate is Predicate.NOT_REPRESENTED]


@pytest.mark.parametrize(
    ("prompt", "kind", "child", "parent"),
    [
        ("A pickup truck tows a trailer down the road.", "hinge", "trailer_1", "pickup_truck_1"),
        ("A trailer is towed by a tractor across a field.", "hinge", "trailer_1", "tractor_1"),
        ("A tractor pulls a log along the ground with a rope.", "rope", "log_1", "tractor_1"),
        ("A jeep tows a van along the street with a rope.", "rope", "van_1", "jeep_1"),
        ("A boy drags a sled across the snow by a string.", "rope", "sled_1", "boy_1"),
        ("A toy car on a string is pulled by a girl.", "rope", "toy_car_1", "girl_1"),
    ],
)
def test_what_is_towed_is_joined_behind(prompt: str, kind: str, child: str, parent: str) -> None:
    doc = draft(prompt)
    (joint,) = joints(doc)
    assert (joint.kind, joint.child, joint.parent) == (kind, child, parent)
    assert (joint.parent_mount, joint.child_mount) == ("rear", "front")
    assert joint.break_impulse is None
    assert not any(n.startswith(("rope", "string")) for n in doc.spatial_relation_graph.nodes)
    said = [s for s in doc.statements or () if s.predicate is Predicate.ATTACHED_TO]
    assert [(s.object, s.target) for s in said] == [((child,), (parent,))]
    assert not lost(doc)
    assert not verify(doc)


def test_a_train_is_joined_one_behind_the_other() -> None:
    doc = draft("A locomotive pulls three wagons along the track.")
    assert [(j.child, j.parent) for j in joints(doc)] == [
        ("wagon_1", "locomotive_1"),
        ("wagon_2", "wagon_1"),
        ("wagon_3", "wagon_2"),
    ]


@pytest.mark.parametrize(
    "prompt",
    [
        "A man pulls a suitcase.",
        "The lowest of three stacked boxes is pulled out by a robot.",
        "A boy climbs a rope.",
    ],
)
def test_not_every_pull_is_a_tow(prompt: str) -> None:
    assert not joints(draft(prompt))


def test_a_rope_that_tows_snaps_as_who_tows_speeds_up() -> None:
    doc = draft(
        "A pickup truck tows a trailer with a rope. After a while the rope snaps and the trailer"
        " rolls to a stop."
    )
    (joint,) = joints(doc)
    assert joint.break_impulse == pytest.approx(800 * 3.0 / 60.0, rel=1e-3)
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    speeds_up = next(e for e in edges if e.event.value == "AcceleratedMotion")
    rolls_on = next(e for e in edges if e.actor == "trailer_1")
    assert speeds_up.actor == "pickup_truck_1"
    assert rolls_on.event.value == "InertialConnector" and rolls_on.from_ == speeds_up.from_
    assert not lost(doc)
    assert not verify(doc)


@pytest.mark.parametrize(
    ("prompt", "child", "parent", "event"),
    [
        (
            "The rope snaps and the hanging lantern crashes onto the table.",
            "lantern_1", "ceiling_1", ("Collision", "lantern_1", "table_1"),
        ),
        (
            "The chandelier's rope breaks. It crashes onto the table underneath.",
            "chandelier_1", "ceiling_1", ("Collision", "chandelier_1", "table_1"),
        ),
        (
            "The rope of a hanging flower pot snaps, and the pot falls to the ground.",
            "flower_pot_1", "pot_gallows_1", ("Fall", "flower_pot_1"),
        ),
        (
            "A crate hangs from a crane by a rope. The rope snaps and the crate lands on a van.",
            "crate_1", "crane_1", ("Collision", "crate_1", "van_1"),
        ),
    ],
)  # fmt: skip
def test_what_hangs_comes_down_when_its_rope_snaps(
    prompt: str, child: str, parent: str, event: tuple[str, ...]
) -> None:
    doc = draft(prompt)
    (joint,) = joints(doc)
    assert (joint.child, joint.parent, joint.position) == (child, parent, 0.0)
    assert joint.break_impulse is not None and joint.break_impulse < 0.5
    assert told(doc) == [event]
    assert "rope_1" not in doc.spatial_relation_graph.nodes
    assert not lost(doc)
    assert not verify(doc)


@pytest.mark.parametrize(
    ("prompt", "kind", "child"),
    [
        ("A ball on a rope swings into a box.", "rope", "ball_1"),
        ("A bucket dangling on a cord is hit by a stone and swings.", "rope", "bucket_1"),
        ("A snowball hits a lantern on a chain, and the lantern sways.", "ball", "lantern_1"),
        ("A weight hanging from a spring bounces up and down.", "spring", "weight_1"),
        ("A heavy ball bobs up and down on a spring.", "spring", "ball_1"),
    ],
)
def test_what_is_on_a_rope_or_a_spring_hangs(prompt: str, kind: str, child: str) -> None:
    doc = draft(prompt)
    (joint,) = joints(doc)
    assert (joint.kind, joint.child) == (kind, child)
    assert not verify(doc)


def test_a_spring_bears_what_hangs_on_it() -> None:
    doc = draft("A 3 kg ball bobs up and down on a spring.")
    (joint,) = joints(doc)
    assert joint.stiffness == pytest.approx(3.0 * 9.81 / 0.15, rel=1e-3)
    assert told(doc) == [("Swing", "ball_1")]


def test_a_pendulum_is_as_long_as_its_rod() -> None:
    doc = draft("A pendulum bob on a 1 m rod is released at 40 degrees and hits a crate.")
    assert [j.position for j in joints(doc)] == [40.0]
    nodes = doc.spatial_relation_graph.nodes
    assert "rod_1" not in nodes
    asset = doc.asset_requirement[nodes["pendulum_bob_1"].asset_id]
    assert asset.expected_dimensions_cm[2] == pytest.approx(100.0)


@pytest.mark.parametrize(
    ("prompt", "part", "lower"),
    [
        ("A pendulum swings into a domino.", "pendulum_portal_1", 90.0),
        ("A swing flies forward and hits a bucket.", "swing_posts_1", 220.0),
        ("A sliding suitcase runs into a turnstile and turns it.", "turnstile_post_1", 82.0),
    ],
)
def test_what_swings_or_turns_is_low_enough_for_what_it_meets(
    prompt: str, part: str, lower: float
) -> None:
    doc = draft(prompt)
    asset = doc.asset_requirement[doc.spatial_relation_graph.nodes[part].asset_id]
    assert asset.expected_dimensions_cm[2] < lower and asset.dimensions_are_prescribed


@pytest.mark.parametrize(
    ("prompt", "degrees"),
    [
        ("A man walks through a turnstile and turns it.", 90.0),
        ("A cart rolls into a turnstile, and the turnstile rotates a half turn.", 180.0),
        ("The merry-go-round makes two full turns.", 720.0),
        ("The turntable makes one full turn.", 360.0),
        ("A windmill makes half a turn.", 180.0),
        ("A merry-go-round makes one complete turn.", 360.0),
    ],
)
def test_what_turns_on_an_axle_turns_so_far(prompt: str, degrees: float) -> None:
    doc = draft(prompt)
    assert doc.timeline_system is not None
    (spin,) = [n for n in doc.timeline_system.sequence_graph.nodes if n.event.value == "Spin"]
    assert spin.turn_degrees == degrees
    assert not verify(doc)


def test_a_drawer_of_a_dresser_slides_out_into_what_stands_before_it() -> None:
    doc = draft("The top drawer of a dresser slides out and hits a vase.")
    (joint,) = joints(doc)
    assert (joint.kind, joint.parent) == ("slider", "dresser_1")
    assert told(doc) == [("Open", "drawer_1"), ("Collision", "drawer_1", "vase_1")]
    assert doc.timeline_system is not None
    drawn = [e.event.value for e in doc.timeline_system.sequence_graph.edges]
    assert drawn == ["Drive", "Drive"]


@pytest.mark.parametrize(
    ("prompt", "link"),
    [
        ("A tractor pulls a hay trailer. The hitch comes loose.", "hitch"),
        ("A truck tows a caravan. The coupling breaks and the caravan rolls on.", "coupling"),
        ("A jeep pulls a trailer up a hill. The hitch detaches.", "hitch"),
    ],
)
def test_a_hitch_that_gives_way_is_the_joint(prompt: str, link: str) -> None:
    """Break the joint, which ties alone hold then: a limit of its angle may not break."""
    doc = draft(prompt)
    assert not [n for n in doc.spatial_relation_graph.nodes if n.startswith(link)]
    joints = doc.spatial_relation_graph.joints or ()
    assert len(joints) == 1
    joint = joints[0]
    assert joint.break_impulse is not None and joint.kind == "hinge"
    assert joint.lower is None and joint.upper is None


@pytest.mark.parametrize("drawn", ["pulled up", "pulled back", "raised"])
def test_what_hangs_is_drawn_back_however_it_is_pulled(drawn: str) -> None:
    doc = draft(f"The first ball of a Newton's cradle is {drawn} and released.")
    assert doc.timeline_system is not None
    kinds = {n.event.value for n in doc.timeline_system.sequence_graph.nodes}
    assert "Topple" not in kinds
