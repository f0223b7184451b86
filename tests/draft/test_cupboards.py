"""What comes out of cupboards, what trapdoors let through, what springs throw back, and rows."""

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, RelationType
from tests.draft.test_joint_words import lost, told


def region_of(doc: EsgDocument, node: str) -> tuple[str, str]:
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions[str(graph.nodes[node].semantic_region)]
    return region.parent_object, region.region_type.value


@pytest.mark.parametrize(
    ("prompt", "thing", "host"),
    [
        ("The fridge door swings open and a milk bottle falls out.", "milk_bottle_1", "fridge_1"),
        ("A woman opens the cupboard and a plate falls out.", "plate_1", "cupboard_1"),
        (
            "A bottle is in the fridge. A man opens the fridge, and it falls out.",
            "bottle_1",
            "fridge_1",
        ),
        ("A cup stands in the cupboard. A man opens the cupboard.", "cup_1", "cupboard_1"),
        ("The oven door opens and a pan slides out.", "pan_1", "oven_1"),
        ("The locker door swings open and a ball rolls out of the locker.", "ball_1", "locker_1"),
    ],
)
def test_it_starts_behind_the_door(prompt: str, thing: str, host: str) -> None:
    doc = draft(prompt)
    assert not verify(doc.model_dump(mode="json", by_alias=True, exclude_none=True))
    assert region_of(doc, thing) == (host, "STORAGE")
    asset = doc.spatial_relation_graph.nodes[host].asset_id
    assert doc.asset_requirement[asset].asset_category.endswith("body"), "it is hollow"


def test_what_falls_out_waits_for_the_door() -> None:
    doc = draft("The fridge door swings open and a milk bottle falls out.")
    names = [event[0] for event in told(doc)]
    assert names == ["Open", "Trigger", "Fall"]


def test_without_a_door_nothing_is_shut_in() -> None:
    doc = draft("A bottle stands in the fridge. A ball rolls into a chair.")
    assert region_of(doc, "bottle_1")[0] == "ground_1"


@pytest.mark.parametrize("who", ["A pendulum", "A wrecking ball"])
@pytest.mark.parametrize("row", ["standing in a row", "in a row", "that stand in a line"])
def test_each_of_a_row_falls_on_the_next_by_what_swings_into_it(who: str, row: str) -> None:
    doc = draft(f"{who} knocks over three bottles {row}.")
    swung = next(
        n for n in doc.spatial_relation_graph.nodes if n.endswith(("pendulum_1", "ball_1"))
    )
    hits = [(swung, "bottle_1"), ("bottle_1", "bottle_2"), ("bottle_2", "bottle_3")]
    falls = [("Topple", f"bottle_{k}") for k in (1, 2, 3)]
    assert told(doc) == [*(("Collision", *pair) for pair in hits), *falls]
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    since = {e.to: e.from_ for e in edges if e.to.endswith("topple")}
    assert since["bottle_1_topple"] == f"{swung}_bottle_1_collision", "not after the last hit"


def test_what_does_not_swing_meets_all_of_a_row() -> None:
    doc = draft("A car knocks over three barrels standing in a row.")
    assert ("Collision", "car_1", "barrel_2") in told(doc)


@pytest.mark.parametrize(
    "prompt",
    [
        "A toy car runs into a spring bumper and bounces back.",
        "A ball rolls into a spring and is thrown back.",
        "A block slides into a spring, and the spring throws it back.",
        "A cart rolls against a spring buffer and is pushed back.",
    ],
)
def test_a_spring_throws_back_what_runs_into_it(prompt: str) -> None:
    doc = draft(prompt)
    assert [event[0] for event in told(doc)] == ["Collision"], "no motion of its own"
    assert not lost(doc)
    (joint,) = doc.spatial_relation_graph.joints or ()
    mover, plate = told(doc)[0][1:]
    assert joint.kind == "slider" and joint.child == plate and (joint.stiffness or 0.0) > 0.0
    assets = doc.asset_requirement
    masses = [
        assets[doc.spatial_relation_graph.nodes[n].asset_id].expected_mass_kg
        for n in (plate, mover)
    ]
    assert masses[0] < 0.5 * masses[1]


def test_a_spring_that_nothing_hits_is_no_bumper() -> None:
    doc = draft("A spring lies on a table. A ball rolls past it.")
    assert not doc.spatial_relation_graph.joints


@pytest.mark.parametrize(
    "prompt",
    [
        "A crate stands on a trapdoor. The trapdoor opens and the crate falls through.",
        "A trapdoor opens under a crate, which falls through.",
        "The trapdoor opens and a crate drops through the trapdoor.",
    ],
)
def test_a_trapdoor_carries_what_falls_through(prompt: str) -> None:
    doc = draft(prompt)
    assert not verify(doc.model_dump(mode="json", by_alias=True, exclude_none=True))
    assert told(doc) == [("Open", "trapdoor_1"), ("Fall", "crate_1")]
    assert region_of(doc, "crate_1") == ("trapdoor_1", "SUPPORT_SURFACE")
    assert doc.timeline_system is not None
    assert doc.timeline_system.actors["crate_1"].role.value == "passive", "it is let go"


def test_what_it_lands_on_is_below_the_trapdoor() -> None:
    doc = draft("A trapdoor opens under a barrel, which falls through and lands on a mattress.")
    relations = doc.spatial_relation_graph.edges.binary_relations
    below = [(r.from_, r.to) for r in relations if r.relation_type is RelationType.UNDER]
    assert ("mattress_1", "trapdoor_1") in below


@pytest.mark.parametrize("ride", ["carousel", "merry-go-round"])
def test_the_horses_of_a_carousel_turn_with_it(ride: str) -> None:
    doc = draft(f"A {ride} with four wooden horses turns around once.")
    host = told(doc)[0][1]
    graph, assets = doc.spatial_relation_graph, doc.asset_requirement
    horses = [n for n in graph.nodes if n.startswith("horse")]
    assert len(horses) == 4
    assert {region_of(doc, n) for n in horses} == {(host, "SUPPORT_SURFACE")}
    held = {j.child for j in graph.joints or () if j.kind == "fixed"}
    assert held == {*horses}
    lengths = [
        max(assets[graph.nodes[n].asset_id].expected_dimensions_cm) for n in (horses[0], host)
    ]
    assert 2.5 * lengths[0] < lengths[1]


@pytest.mark.parametrize("row", ["One chain snaps", "The chain snaps"])
def test_a_sign_whose_chain_snaps_swings_between_no_limits(row: str) -> None:
    """Newton makes what gives way of ties, which know no limits."""
    doc = draft(f"A sign hangs on two chains. {row} and the sign drops.")
    (joint,) = doc.spatial_relation_graph.joints or ()
    assert joint.break_impulse is not None and joint.lower is joint.upper is None


@pytest.mark.parametrize(
    "prompt",
    [
        "A sign hangs on two chains. One chain snaps, and the sign hangs from the other.",
        "Because one of its two chains snaps, a sign drops but stays hanging from the other chain.",
    ],
)
def test_what_stays_on_one_of_two_chains_is_owned_up_to(prompt: str) -> None:
    doc = draft(prompt)
    assert {"hangs", "hanging"} & {*lost(doc)}
    assert not [n for n in doc.spatial_relation_graph.nodes if n.startswith("chain")]


def test_a_drawer_that_slides_out_is_in_nothing() -> None:
    doc = draft("By itself a dresser drawer slides out until it bumps against a flask.")
    assert told(doc)[0][0] == "Open"
    assert region_of(doc, "drawer_1")[1] != "STORAGE"
