"""How plurals stand, what carries them, and what hangs: tables, racks, queues, ceilings, holes."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import (
    EsgDocument,
    MultiRelationType,
    Node,
    NodeEvent,
    RegionType,
    RelationType,
)


def clean(prompt: str) -> EsgDocument:
    doc = draft(prompt)
    assert verify(doc) == ()
    return doc


def members(doc: EsgDocument) -> dict[str, Node]:
    return {k: n for k, n in doc.spatial_relation_graph.nodes.items() if n.group is not None}


def host(doc: EsgDocument, node: str) -> str | None:
    graph = doc.spatial_relation_graph
    return graph.semantic_regions[graph.nodes[node].semantic_region or ""].parent_object


@pytest.mark.parametrize(
    ("prompt", "count", "on_table"),
    [
        ("Five candles stand in a circle on a table.", 5, True),
        ("Six chairs stand around a table.", 6, False),
        ("Six knights stand around a round table.", 6, False),
    ],
)
def test_around_a_table(prompt: str, count: int, on_table: bool) -> None:
    """Set the table along its edge; put seats and people on the floor around it."""
    doc = clean(prompt)
    (ring,) = doc.spatial_relation_graph.edges.multi_relations
    assert ring.relation_type is MultiRelationType.SURROUND
    assert set(ring.subjects) == set(members(doc)) and len(ring.subjects) == count
    (table,) = ring.targets
    assert {host(doc, m) for m in ring.subjects} == {table if on_table else "ground_1"}


@pytest.mark.parametrize(
    ("prompt", "count", "pattern"),
    [
        ("Fifteen billiard balls are racked on the table.", 15, "rack"),
        ("Fifteen billiard balls stand in a triangle on a pool table.", 15, "rack"),
        ("The cue ball breaks fifteen billiard balls racked on the table.", 15, "rack"),
        ("Ten pins standing in a triangle.", 10, "pins"),
        ("A bowling ball rolls into ten pins standing in a triangle.", 10, "pins"),
        ("Six boxes stand in a column.", 6, "column"),
        ("Six crates are piled on a pallet.", 6, "stack"),
        ("Five cars queue on a road.", 5, "queue"),
        ("A queue of five cars waits in a lane.", 5, "queue"),
        ("A heavy ball swings into a stack of six bricks.", 6, "stack"),
        ("A ball rolls into a row of four bottles and knocks the first one over.", 4, "row"),
        ("A ball hits a pile of five boxes.", 5, "stack"),
        ("A ball crashes into a tower of six blocks.", 6, "stack"),
        ("A ball hits a pyramid of six cans.", 6, "stack"),
        (
            "A row of ten dominoes stands on a table; the first one is tipped over and hits "
            "the next.",
            10,
            "row",
        ),
    ],
)
def test_patterns(prompt: str, count: int, pattern: str) -> None:
    """Keep the arrangement of the whole plural, and make no object of its name."""
    doc = clean(prompt)
    found = members(doc)
    assert {n.group_pattern for n in found.values()} == {pattern}
    assert len(found) == count
    assert not [w for w in doc.coverage.warnings if "lexicon" in w or "not understood" in w]


@pytest.mark.parametrize("where", ["in a lane", "on a road"])
def test_a_queue_waits_on_its_lane(where: str) -> None:
    """Stand what waits on the road there; where the road is, the motion of others decides."""
    doc = clean(f"A queue of five cars waits {where}.")
    road = next(n for n in doc.spatial_relation_graph.nodes if n.startswith(("lane", "road")))
    assert {host(doc, n) for n in members(doc)} == {road}
    moving = clean("A truck crashes into a car that waits on a road.")
    assert (host(moving, "car_1"), host(moving, "truck_1")) == ("road_1", "ground_1")


def test_what_hangs_from_the_ceiling() -> None:
    """Fix a lamp below a structural ceiling; let one that falls move."""
    doc = clean("A lamp hangs from the ceiling.")
    graph = doc.spatial_relation_graph
    assert graph.nodes["ceiling_1"].is_structural and graph.nodes["lamp_1"].is_static
    assert not doc.asset_requirement[graph.nodes["lamp_1"].asset_id].is_movable
    region = graph.semantic_regions[graph.nodes["lamp_1"].semantic_region or ""]
    assert region.region_type is RegionType.ATTACHED_HORIZONTAL
    kinds = {(r.from_, r.relation_type, r.to) for r in graph.edges.binary_relations}
    assert ("lamp_1", RelationType.ATTACHED_HORIZONTAL, "ceiling_1") in kinds
    falling = clean("A chandelier hangs from the ceiling and falls onto the table.")
    assert not falling.spatial_relation_graph.nodes["chandelier_1"].is_static
    assert falling.timeline_system is not None


@pytest.mark.parametrize(
    ("prompt", "thing", "hung"),
    [
        ("A picture on the wall.", "picture_1", True),
        ("A mirror on the wall.", "mirror_1", True),
        ("A clock hangs on the wall.", "clock_1", True),
        ("A cat sits on the wall.", "cat_1", False),
    ],
)
def test_on_the_wall(prompt: str, thing: str, hung: bool) -> None:
    """Hang what belongs on a wall's face; the rest is on top of it."""
    doc = clean(prompt)
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions[graph.nodes[thing].semantic_region or ""]
    assert (region.region_type is RegionType.ATTACHED_VERTICAL) is hung
    assert graph.nodes[thing].is_static is hung


def test_a_golf_hole_is_no_goal() -> None:
    """Let a golf ball roll into something small without a rim."""
    doc = clean("A golf ball rolls into the hole.")
    required = doc.asset_requirement[doc.spatial_relation_graph.nodes["hole_1"].asset_id]
    assert required.asset_category == "tunnel" and max(required.expected_dimensions_cm) <= 30.0
    assert doc.timeline_system is not None
    events = [n.event for n in doc.timeline_system.sequence_graph.nodes]
    assert NodeEvent.ENTER_REGION in events
    launch = doc.timeline_system.sequence_graph.edges[0]
    assert launch.params.spin == "roll"


@pytest.mark.parametrize(
    "prompt",
    [
        "The red ball hits the cushion 1 s later on a billiard table.",
        "A red ball rolls at 2 m/s on a billiard table. The red ball hits the cushion 1 s later.",
    ],
)
def test_a_cushion_is_part_of_the_table(prompt: str) -> None:
    """Play on the table with a billiard ball, and make no pillow of its cushion."""
    doc = clean(prompt)
    nodes = doc.spatial_relation_graph.nodes
    ball = doc.asset_requirement[nodes["red_ball_1"].asset_id]
    assert ball.asset_category == "billiard_ball"
    assert host(doc, "red_ball_1") == "billiard_table_1"
    assert not [n for n in nodes if "cushion" in n or "pillow" in n]


def _told(doc: EsgDocument) -> list[tuple[str, ...]]:
    assert doc.timeline_system is not None
    return [(n.event.value, *n.participants) for n in doc.timeline_system.sequence_graph.nodes[1:]]


@pytest.mark.parametrize(
    ("prompt", "index"),
    [
        ("A stone hits the top crate of a stack.", -1),
        ("A stack of three crates stands on a lawn. A stone hits the top crate.", -1),
        ("A stack of three crates stands on a lawn. A stone hits the lowest one.", 0),
        ("A stone hits the lowest of three stacked crates.", 0),
        ("Three crates are stacked. A stone hits the topmost crate.", -1),
        ("Three crates are stacked. A stone hits the crate on top.", -1),
    ],
)
def test_levels_of_a_stack(prompt: str, index: int) -> None:
    """Take the last member for the top of a stack and the first for its bottom."""
    doc = draft(prompt)
    assert verify(doc) == ()
    members = [n for n, v in doc.spatial_relation_graph.nodes.items() if v.group]
    assert len(members) == 3
    name = "top_crate_1" if index else "bottom_crate_1"
    assert members[index] == name
    assert _told(doc) == [("Collision", "stone_1", name)]


@pytest.mark.parametrize(
    ("thing", "spin"), [("coin", "roll"), ("barrel", "roll"), ("crate", "slide")]
)
def test_round_rims_roll(thing: str, spin: str) -> None:
    """Roll what is a cylinder, slide what has corners."""
    doc = draft(f"A {thing} rolls into a wall.")
    assert doc.timeline_system is not None
    assert doc.timeline_system.sequence_graph.edges[0].params.spin == spin
