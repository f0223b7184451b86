"""Jointed things in prompts: what is named moves, what it hangs on is added."""

from __future__ import annotations

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Joint
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
        "A ball rolls into a wall.",
        "A crane stands next to a box.",
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
