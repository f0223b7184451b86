"""Jointed things in prompts: what is named moves, what it hangs on is added."""

from __future__ import annotations

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Joint, Predicate
from esg.lexicon.articulations import articulations


def joints(doc: EsgDocument) -> tuple[Joint, ...]:
    return doc.spatial_relation_graph.joints or ()


@pytest.mark.parametrize(
    ("prompt", "child", "parent", "kind"),
    [
        ("A ball rolls into a door.", "door_1", "door_frame_1", "hinge"),
        ("A tractor hits a gate.", "gate_1", "gate_posts_1", "hinge"),
        ("A wrecking ball hits a stack of boxes.", "wrecking_ball_1", "wrecking_crane_1", "rope"),
        ("A pendulum stands on a table.", "pendulum_1", "pendulum_portal_1", "hinge"),
        ("A ball hits a seesaw.", "seesaw_1", "seesaw_stand_1", "hinge"),
        ("A ball rolls into a swing.", "swing_1", "swing_posts_1", "hinge"),
        ("A ball hits a punching bag.", "punching_bag_1", "bag_stand_1", "ball"),
        ("A box slides into a drawer.", "drawer_1", "drawer_chest_1", "slider"),
        ("A man walks into a turnstile.", "turnstile_1", "turnstile_post_1", "hinge"),
        ("A ball hits a cupboard door.", "door_1", "cupboard_1", "hinge"),
        ("A ball hits a fridge door.", "door_1", "fridge_1", "hinge"),
        ("A ball hits an oven door.", "door_1", "oven_1", "hinge"),
        ("A ball hits a window shutter.", "shutter_1", "shutter_wall_1", "hinge"),
        ("A snowball hits a hanging sign.", "sign_1", "sign_gallows_1", "hinge"),
        ("A hammer hits a church bell.", "bell_1", "bell_gallows_1", "hinge"),
        ("A ball hits a hanging lamp.", "lamp_1", "lamp_gallows_1", "ball"),
        ("A ball hits a hanging flower pot.", "flower_pot_1", "pot_gallows_1", "ball"),
        ("A man hits a tetherball.", "tetherball_1", "tether_pole_1", "rope"),
        ("A ball hits a merry-go-round.", "merry_go_round_1", "roundabout_foot_1", "hinge"),
        ("A ball hits a windmill blade.", "blade_1", "windmill_1", "hinge"),
        ("A car hits a boom gate.", "gate_1", "boom_post_1", "hinge"),
        ("A ball hits a revolving door.", "door_1", "revolving_drum_1", "hinge"),
        ("A ball hits a ceiling fan.", "ceiling_fan_1", "piece_of_ceiling_1", "hinge"),
        ("A ball rolls onto a drawbridge.", "drawbridge_1", "gatehouse_1", "hinge"),
        ("A ball hits a lever.", "lever_1", "lever_foot_1", "hinge"),
        ("A coin drops onto a balance scale.", "balance_scale_1", "balance_stand_1", "hinge"),
        ("A box hits a spring launcher.", "spring_launcher_1", "launcher_rail_1", "slider"),
    ],
)
def test_what_a_thing_hangs_on_is_added(prompt: str, child: str, parent: str, kind: str) -> None:
    doc = draft(prompt)
    assert [(j.child, j.parent, j.kind) for j in joints(doc)] == [(child, parent, kind)]
    nodes = doc.spatial_relation_graph.nodes
    assert nodes[child].mentioned and not nodes[child].is_static
    assert nodes[parent].is_static and not nodes[parent].mentioned
    assert f"added: {nodes[child].label} is joined to it" in (
        doc.scene_definition.expanded_description
    )
    assert verify(resolve(doc)) == ()  # the mounts are there


def test_a_cradle_has_five_balls() -> None:
    doc = draft("A Newton's cradle stands on a desk.")
    told = joints(doc)
    assert [j.parent_mount for j in told] == [f"pivot {n}" for n in range(1, 6)]
    assert {j.parent for j in told} == {"newton_s_cradle_1"}
    assert verify(resolve(doc)) == ()


def test_what_is_told_to_be_open_starts_open() -> None:
    door = articulations()["door"]
    assert joints(draft("A ball rolls past an open door."))[0].position == door.opened
    assert joints(draft("A ball rolls past a door."))[0].position == 0.0


def test_what_the_prompt_has_to_hang_on_is_taken() -> None:
    doc = draft("A wrecking ball hangs near a crane and hits a wall.")
    assert [(j.child, j.parent) for j in joints(doc)] == [("wrecking_ball_1", "crane_1")]
    assert doc.asset_requirement[
        doc.spatial_relation_graph.nodes["crane_1"].asset_id
    ].asset_category
    assert not any(n.startswith("wrecking_crane") for n in doc.spatial_relation_graph.nodes)


@pytest.mark.parametrize(
    "prompt",
    [
        "A cyclist crashes into the open door of a parked car.",
        "A ball hits a car door.",
        "A ball hits a garage door.",
        "A ball hits a sign.",
        "A ball rolls into a wall.",
        "A crane stands next to a box.",
        "A ball hits a laptop.",  # it stands open, and nothing turns its lid
        "A laptop falls off a desk.",
        "A grandfather clock falls over.",
    ],
)
def test_parts_of_other_things_and_all_else_have_no_joints(prompt: str) -> None:
    assert draft(prompt).spatial_relation_graph.joints is None


def test_sizes_of_both_parts_go_together() -> None:
    doc = draft("A ball rolls into a giant door.")
    leaf, frame = (
        doc.asset_requirement[doc.spatial_relation_graph.nodes[n].asset_id].expected_dimensions_cm
        for n in ("door_1", "door_frame_1")
    )
    assert frame[1] / leaf[1] == pytest.approx(93 / 80, rel=1e-3)
    assert leaf[2] == pytest.approx(2 * 198)


@pytest.mark.parametrize(
    ("prompt", "child", "parent"),
    [
        ("A ball hits a chest.", "chest_lid_1", "chest_1"),
        ("A ball hits a windmill.", "mill_sails_1", "windmill_1"),
        ("A ball hits a catapult.", "catapult_arm_1", "catapult_1"),
        ("A ball hits a trebuchet.", "trebuchet_arm_1", "trebuchet_1"),
        ("A ball hits a Ferris wheel.", "ferris_rotor_1", "ferris_wheel_1"),
        ("A ball hits a closed laptop.", "laptop_lid_1", "laptop_1"),
    ],
)
def test_what_carries_its_moving_part_keeps_its_name(prompt: str, child: str, parent: str) -> None:
    doc = draft(prompt)
    assert [(j.child, j.parent) for j in joints(doc)] == [(child, parent)]
    assert doc.timeline_system is not None and parent in doc.timeline_system.actors
    assert verify(resolve(doc)) == ()


def test_the_part_that_turns_does_what_is_told_of_the_whole() -> None:
    doc = draft("The lid of a wooden chest falls shut.")
    assert joints(doc)[0].position == articulations()["chest"].opened
    assert doc.timeline_system is not None
    assert set(doc.timeline_system.actors) == {"chest_lid_1"}
    assert verify(resolve(doc)) == ()


def test_only_the_first_ball_of_a_cradle_is_let_go() -> None:
    told = joints(draft("A Newton's cradle swings back and forth."))
    assert [j.position for j in told] == [35.0, 0.0, 0.0, 0.0, 0.0]


def test_the_door_of_a_thing_in_the_prompt_hangs_on_that_thing() -> None:
    doc = draft("A soccer ball hits the open door of a locker.")
    assert [(j.child, j.parent, j.position) for j in joints(doc)] == [("door_1", "locker_1", 90.0)]


@pytest.mark.parametrize(
    ("prompt", "child", "parent"),
    [
        ("A crate hangs from a crane.", "crate_1", "crane_1"),
        ("A bucket hangs from a hook and a ball hits it.", "bucket_1", "hook_1"),
        ("A pinata hangs from a tree branch.", "pinata_1", "tree_branch_1"),
        ("A crate hanging from a crane swings.", "crate_1", "crane_1"),
    ],
)
def test_what_hangs_from_something_needs_no_rope_in_the_prompt(
    prompt: str, child: str, parent: str
) -> None:
    assert [(j.child, j.parent, j.kind) for j in joints(draft(prompt))] == [(child, parent, "rope")]


def test_who_hangs_from_something_holds_on_to_it_without_a_rope() -> None:
    assert joints(draft("A monkey hangs from a branch.")) == ()


@pytest.mark.parametrize(
    "prompt",
    [
        "A crate hangs from a crane by a rope. A gull flies against the rope.",
        "A crate hangs from a crane by a chain. A boy hits the chain.",
    ],
)
def test_nothing_touches_a_rope_and_the_draft_says_so(prompt: str) -> None:
    doc = draft(prompt)
    assert verify(resolve(doc)) == ()
    assert doc.timeline_system is None
    told = [s.text for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    assert told and told[0] in prompt


def test_what_hangs_below_a_ceiling_is_held_there() -> None:
    doc = draft("A lamp hanging from the ceiling is hit by a tennis ball.")
    (joint,) = joints(doc)
    assert (joint.child, joint.kind, joint.parent) == ("lamp_1", "ball", "ceiling_1")
    assert joint.parent_mount is None
    assert not doc.spatial_relation_graph.nodes["lamp_1"].is_static
    assert verify(resolve(doc)) == ()


def test_smaller_things_resist_less() -> None:
    """Half the size: 1/16 of the friction, 1/32 of the damping, and the same limits."""
    whole, half = (joints(draft(f"A ball hits a {w}seesaw."))[0] for w in ("", "tiny "))
    assert half.friction == pytest.approx((whole.friction or 0) / 16)
    assert half.damping == pytest.approx((whole.damping or 0) / 32)
    assert (half.lower, half.upper) == (whole.lower, whole.upper)
    rope, short = (joints(draft(f"A {w}wrecking ball hits a wall."))[0] for w in ("", "tiny "))
    assert short.upper == pytest.approx((rope.upper or 0) / 2)
    assert short.position == rope.position


@pytest.mark.parametrize(
    ("prompt", "thrown"),
    [
        ("A snowball hits a hanging sign.", True),
        ("A ball hits a hanging lamp.", True),
        ("A ball hits a punching bag.", True),
        ("A ball rolls into a punching bag.", False),
        ("A ball hits a door.", False),
        ("A ball hits a gate.", False),
    ],
)
def test_what_hangs_out_of_reach_is_thrown_at(prompt: str, thrown: bool) -> None:
    doc = draft(prompt)
    assert doc.timeline_system is not None
    edge = doc.timeline_system.sequence_graph.edges[0]
    assert (edge.params.spin == "none") is thrown


@pytest.mark.parametrize("prompt", [
    "In a Newton's cradle, the first ball is lifted and released.",
    "A Newton's cradle with five steel balls clicks back and forth.",
])  # fmt: skip
def test_the_balls_of_a_cradle_are_hardened_steel_whatever_they_are_called(prompt: str) -> None:
    doc = draft(prompt)
    nodes = doc.spatial_relation_graph.nodes
    balls = {n.asset_id for k, n in nodes.items() if "ball" in k}
    assert balls and {doc.asset_requirement[a].material for a in balls} == {None}


@pytest.mark.parametrize(
    ("prompt", "child", "parent"),
    [
        ("The door of a locker closes.", "door_1", "locker_1"),
        ("The drawbridge of a castle comes down.", "drawbridge_1", "castle_1"),
        ("The pendulum of a grandfather clock swings.", "pendulum_1", "grandfather_clock_1"),
    ],
)
def test_what_a_joint_holds_together_is_represented(prompt: str, child: str, parent: str) -> None:
    doc = draft(prompt)
    assert [(j.child, j.parent) for j in joints(doc)] == [(child, parent)]
    assert not [s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]


def test_what_a_drawer_is_part_of_is_not_in_it() -> None:
    doc = draft("A drawer of a cabinet slides open and pushes a ball off a chair.")
    nodes = doc.spatial_relation_graph.nodes
    assert nodes["cabinet_1"].semantic_region == nodes["drawer_1"].semantic_region


@pytest.mark.parametrize(
    ("prompt", "mount"),
    [
        ("Two identical lanterns hang from a beam.", "hook"),
        ("Three lanterns hang from a beam.", "hook"),
        ("Two church bells hang from a wooden beam.", "bar"),
    ],
)
def test_things_hang_side_by_side_from_one_beam(prompt: str, mount: str) -> None:
    """Give each its own place on a beam on two posts that is wide enough for all."""
    doc = draft(prompt)
    hung = joints(doc)
    (beam,) = {j.parent for j in hung}
    places = [j.parent_mount for j in hung]
    assert places == [f"{mount} {k} of {len(hung)}" for k in range(1, len(hung) + 1)]
    asset = doc.asset_requirement[doc.spatial_relation_graph.nodes[str(beam)].asset_id]
    assert asset.asset_category == "beam_on_posts"
    drawn = resolve(doc).asset_configurations[doc.spatial_relation_graph.nodes[str(beam)].asset_id]
    across = {m.name: m.position_cm[1] for m in drawn.mounts or ()}
    first, second = (across[str(p)] for p in places[:2])
    assert second - first > 44.0


@pytest.mark.parametrize("host", ["branch", "bracket"])
def test_what_hangs_from_no_beam_hangs_from_an_arm(host: str) -> None:
    """Keep the arm of a post for what is no beam, and one place on it."""
    (joint,) = joints(draft(f"A lantern hangs from a {host}."))
    assert joint.parent_mount == "hook"


@pytest.mark.parametrize(
    "prompt",
    [
        "Two balls roll side by side; the left one hits the wall first.",
        "Two cars drive toward a barrier and the red one hits it first.",
        "Two marbles roll across the floor. The larger one hits the block first.",
    ],
)
def test_who_does_not_hit_first_hits_later(prompt: str) -> None:
    """Let the other one of two hit the same thing later, and say so."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    hits = [n for n in doc.timeline_system.sequence_graph.nodes if n.event.value == "Collision"]
    assert [n.participants[1] for n in hits] == [hits[0].participants[1]] * 2
    assert hits[0].participants[0] != hits[1].participants[0]
    (order,) = [s for s in doc.statements or () if s.predicate is Predicate.BEFORE]
    assert order.object == (hits[0].id, hits[1].id)
