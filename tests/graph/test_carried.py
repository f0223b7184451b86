"""Passive bodies that a hit of something else moves: what they rest on, or a mate of their plural."""

from __future__ import annotations

from esg.graph import verify
from tests.graph.builders import Json, carried, node


def codes(raw: Json) -> list[str]:
    return [v.code for v in verify(raw)]


def test_a_hit_of_its_support_moves_a_body() -> None:
    """Accept a topple after a hit of what the body stands on."""
    assert codes(carried()) == []


def test_a_hit_of_something_else_does_not() -> None:
    """Report the connector of a body that stands beside what is hit."""
    raw = carried()
    raw["spatial_relation_graph"]["nodes"]["trashbin_1"] = node("bin")
    relations = raw["spatial_relation_graph"]["edges"]["binary_relations"]
    relations[0] = {**relations[0], "relation_type": "near"}
    relations.append({**relations[2], "from": "trashbin_1"})
    del raw["spatial_relation_graph"]["semantic_regions"]["table_top"]
    assert codes(raw) == ["CONNECTOR_UPSTREAM"]


def test_a_hit_of_a_mate_moves_a_member_of_a_plural() -> None:
    """Accept a member's topple after a hit of another member, not after that of a third thing."""
    raw = carried()
    nodes = raw["spatial_relation_graph"]["nodes"]
    for name in ("trashbin_1", "trashbin_2"):
        nodes[name] = node("bin", group="bins", group_pattern="row")
    relations = raw["spatial_relation_graph"]["edges"]["binary_relations"]
    relations[0] = {**relations[0], "relation_type": "near"}
    relations += [{**relations[2], "from": f"trashbin_{k}"} for k in (1, 2)]
    del raw["spatial_relation_graph"]["semantic_regions"]["table_top"]
    assert "CONNECTOR_UPSTREAM" in codes(raw)
    system = raw["timeline_system"]
    system["actors"]["trashbin_2"] = system["actors"].pop("picnic_table_1")
    system["sequence_graph"]["nodes"][1]["participants"] = ["car_1", "trashbin_2"]
    system["sequence_graph"]["edges"][0]["target"] = "trashbin_2"
    assert codes(raw) == []
